// SPDX-License-Identifier: MIT
// How can two overlapping shapes be separated? By the least translation; on a mesh, one per
// triangle.
#include <array>
#include <detent/detent.hpp>
#include <detent/scene/mesh/owned.hpp>
using namespace detent;

int main() {
  using Vec3 = Vec<q16_16, 3>;
  const auto at = [](int x, int y, int z) { return Vec3{q16_16(x), q16_16(y), q16_16(z)}; };
  const auto up = Direction<q16_16, 3>::along(1);
  // A crate has sunk 1 unit into the floor.
  const Aabb floor{at(-9, -8, -9), at(9, 0, 9)}, crate{at(0, -1, 0), at(4, 3, 4)};
  const auto found = contact(floor, crate);
  if (!found || found->normal != up || found->depth != 1) return 1;  // from floor to crate
  if (found->count != 4) return 2;                                   // at its corners
  if (overlaps(floor, translated(crate, separation(*found)))) return 3;

  // A ball that rolls over the inner edge of two triangles sees only their common plane.
  const std::array triangles{Triangle{at(-9, 0, -9), at(-9, 0, 9), at(9, 0, 9)},
                             Triangle{at(-9, 0, -9), at(9, 0, 9), at(9, 0, -9)}};
  const OwnedMesh<q16_16> mesh(triangles);
  std::array<MeshContact<q16_16>, 8> touched;
  const Sphere ball{at(1, 2, 0), q16_16(3)};
  const auto count = contacts(mesh.view(), ball, touched);
  for (std::size_t i = 0; i < count; ++i) {
    if (touched[i].contact.normal != up) return 4;
  }
  return count > 0 ? 0 : 5;
}
