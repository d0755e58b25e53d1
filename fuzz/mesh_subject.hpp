// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "decode.hpp"
#include "detent/scene/mesh.hpp"
#include "detent/scene/mesh/owned.hpp"
#include "scene/surface_loop.hpp"

namespace detent::fuzz {

inline void require_same(bool same, const char* query) {
  require(same, [&] { return std::string(query) + " is not that of the triangles"; });
}

/// A mesh and the loop over its triangles.
template <Scalar S>
struct Subject {
  OwnedMesh<S> owned;
  MeshAsset<S> asset;
  PlacedMesh<S> mesh;
  test::TriangleLoop<S> loop;

  Subject(Source& source, Decoder<S, 3>& decoder) {
    std::vector<Triangle<S, 3>> triangles(source.below(16));
    for (auto& triangle : triangles) decoder.read(triangle);
    owned = OwnedMesh<S>{std::span<const Triangle<S, 3>>(triangles)};
    asset = MeshAsset<S>(1, owned.view());
    mesh.asset = &asset;
    const auto motion = source.below(4);
    if (motion >= 1) mesh.transform.translation = decoder.point();
    if (motion >= 2) mesh.transform.rotation = decoder.rotation();
    if (motion == 3) mesh.transform.scale = source.below(2) == 0 ? S(-1) : decoder.number();
    for (const auto& part : triangles) loop.triangles.push_back(placed(mesh.transform, part));
  }
  Subject(const Subject&) = delete;  // the mesh points to its asset
  Subject& operator=(const Subject&) = delete;
};

}  // namespace detent::fuzz
