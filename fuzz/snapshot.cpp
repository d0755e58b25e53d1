// SPDX-License-Identifier: MIT
//
// Restoring a snapshot of any bytes gives a scene with exactly this snapshot, which behaves like a
// fresh scene; or it fails and leaves the scene unchanged. The input's length and checksum are
// first corrected, unless its first byte is odd, to reach the rest of the decoder. Its third bit
// adds meshes to the scene, or hulls and height fields if its fourth bit is also set.

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

#include "detent/scene/height_field.hpp"
#include "detent/scene/hull.hpp"
#include "detent/scene/mesh.hpp"
#include "detent/scene/snapshot.hpp"
#include "property.hpp"
#include "support/seal.hpp"

namespace detent::fuzz {
namespace {

using Toys = BoundedScene<Bounded<24, 6>, q16_16, 3, Sphere, Obb>;
using Rocks = BoundedScene<Bounded<24, 6>, q16_16, 3, Sphere, Obb, MeshInstance>;
using Props = BoundedScene<Bounded<24, 6>, q16_16, 3, Sphere, Obb, HullInstance, FieldInstance>;
using Vec3 = Vec<q16_16, 3>;

Vec3 at(int x, int y, int z) { return {q16_16(x), q16_16(y), q16_16(z)}; }

/// Two meshes of one triangle, which have ids 1 and 2.
std::span<const MeshAsset<q16_16>> meshes() {
  static std::array<MeshTriangle<q16_16>, 2> parts{
      MeshTriangle<q16_16>{{at(0, 0, 0), at(4, 0, 0), at(0, 4, 0)}, 0},
      MeshTriangle<q16_16>{{at(-5, 0, 0), at(5, 0, 0), at(0, 0, 5)}, 0}};
  static std::array<MeshNode<q16_16>, 2> nodes;
  static const auto one = [](std::uint32_t i) {
    return MeshAsset<q16_16>(
        i + 1, *build_mesh<q16_16>(std::span(parts).subspan(i, 1), std::span(nodes).subspan(i, 1)));
  };
  static const std::array all{one(0), one(1)};
  return all;
}

/// Two hulls and two height fields, which have ids 1 and 2.
std::span<const HullAsset<q16_16, 3>> hulls() {
  static const std::array corners{at(0, 0, 0), at(4, 0, 0), at(0, 4, 0), at(0, 0, 4)};
  static const std::array all{*hull_asset(1, ConvexHull{std::span(corners)}),
                              *hull_asset(2, ConvexHull{std::span(corners).first(2)})};
  return all;
}
std::span<const FieldAsset<q16_16>> fields() {
  static const std::array<q16_16, 6> heights{q16_16(0), q16_16(1), q16_16(2)};
  static const std::array all{
      FieldAsset(1, *height_field<q16_16>({q16_16(-4), q16_16(-4)}, q16_16(4), 3, 2, heights)),
      FieldAsset(2, *height_field<q16_16>({q16_16(-4), q16_16(-4)}, q16_16(4), 2, 3, heights))};
  return all;
}

template <class Scene>
Scene with_fixed_part() {
  Scene scene;
  scene.add_as({0, 2}, Sphere{at(0, 0, 0), q16_16(1)}, {.user = 7, .motion = Motion::fixed});
  if constexpr (std::is_same_v<Scene, Rocks>) {
    scene.add_as({1, 3}, PlacedMesh{&meshes()[1]}, {.motion = Motion::fixed});
  }
  if constexpr (std::is_same_v<Scene, Props>) {
    scene.add_as({1, 3}, PlacedField{&fields()[1]}, {.motion = Motion::fixed});
  }
  return scene;
}

template <class Scene>
Scene toys() {
  Scene scene;
  const auto frame = *scene.add_frame({.translation = at(1, 2, 3)});
  scene.add(Sphere{at(0, 0, 0), q16_16(1)}, {.user = 7, .motion = Motion::fixed});
  if constexpr (std::is_same_v<Scene, Rocks>) {
    scene.add(PlacedMesh{&meshes()[1]}, {.motion = Motion::fixed});
    scene.add(PlacedMesh{&meshes()[0], {.translation = at(0, 0, 1)}});
    scene.add(PlacedMesh{&meshes()[1]}, {.frame = frame});
  }
  if constexpr (std::is_same_v<Scene, Props>) {
    scene.add(PlacedField{&fields()[1]}, {.motion = Motion::fixed});
    scene.add(PlacedHull{&hulls()[0], {.translation = at(0, 0, 1)}});
    scene.add(PlacedHull{&hulls()[1]}, {.frame = frame});
    scene.add(PlacedField{&fields()[0]}, {.frame = frame});
  }
  for (int i = 1; i < 12; ++i) scene.add(Sphere{at(i, 2 * i, 0), q16_16(i)});
  scene.add(Obb<q16_16, 3>{at(0, 0, 0), at(1, 1, 1), {}}, {.frame = frame});
  return scene;
}

template <class Scene>
std::vector<std::byte> bytes_of(const Scene& scene) {
  std::vector<std::byte> bytes(snapshot(scene, std::span<std::byte>()));
  snapshot(scene, bytes);
  return bytes;
}

/// Sets the right length and checksum.
void seal(std::vector<std::byte>& bytes) {
  constexpr std::size_t length_at = 36;
  if (bytes.size() < detail::SnapshotHeader::size + detail::SnapshotHeader::checksum_size) return;
  detail::store_word(bytes.data() + length_at, std::uint64_t{bytes.size()});
  test::seal(bytes);
}

template <class Scene>
std::vector<Overlap> overlaps_of(const Scene& scene) {
  std::vector<Overlap> list(scene.overlaps(std::span<Overlap>()));
  static_cast<void>(scene.overlaps(std::span(list)));
  return list;
}

template <class Scene>
void check(const std::vector<std::byte>& bytes) {
  Scene scene = toys<Scene>();
  const auto before = bytes_of(scene);
  const auto overlaps = overlaps_of(scene);
  if (restore(scene, bytes, meshes(), hulls(), fields()) != Restored::yes) {
    require(bytes_of(scene) == before && overlaps_of(scene) == overlaps,
            [] { return std::string("refused, and changed the scene"); });
    return;
  }
  require(bytes_of(scene) == bytes, [] { return std::string("restored, and has other bytes"); });
  Scene fresh = with_fixed_part<Scene>();
  require(restore(fresh, bytes, meshes(), hulls(), fields()) == Restored::yes,
          [] { return std::string("only once"); });
  require(overlaps_of(fresh) == overlaps_of(scene) && digest(fresh) == digest(scene),
          [] { return std::string("a fresh scene answers otherwise"); });
}

}  // namespace

void property(Bytes input) {
  if (input.empty()) return;
  const auto rest = std::as_bytes(input.subspan(1));
  std::vector<std::byte> bytes(rest.begin(), rest.end());
  if (input[0] % 2 == 0) seal(bytes);
  switch (input[0] / 4 % 4) {
    case 1:
      return check<Rocks>(bytes);
    case 3:
      return check<Props>(bytes);
    default:
      return check<Toys>(bytes);
  }
}

}  // namespace detent::fuzz
