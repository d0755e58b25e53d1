// SPDX-License-Identifier: MIT
//
// A shape that moves towards a mesh of any triangles, at any transform, first touches the same
// triangle as in a loop over them, at the same distance, point and normal.

#include <cstddef>
#include <cstdint>
#include <optional>

#include "detent/scene/mesh/cast.hpp"
#include "mesh_subject.hpp"
#include "spaces.hpp"

namespace detent::fuzz {
namespace {

template <Scalar S, class Shape>
void check_cast(const Subject<S>& subject, const Shape& shape, const Direction<S, 3>& direction,
                const S& most) {
  const auto& triangles = subject.loop.triangles;
  std::optional<MeshHit<S>> expected;
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const auto hit = cast(shape, direction, most, triangles[i]);
    if (hit && (!expected || hit->distance < expected->distance)) {
      expected = MeshHit<S>{hit->distance, static_cast<std::uint32_t>(i)};
    }
  }
  require_same(cast_nearest(shape, direction, most, subject.mesh) == expected, "cast_nearest");
  const auto hit = cast(shape, direction, most, subject.mesh);
  require_same(
      hit == (expected ? cast(shape, direction, most, triangles[expected->index]) : std::nullopt),
      "cast");
}

template <Scalar S>
void check(Source& source) {
  with_one_of(support::MovingShapes<S, 3>(), source, [&]<class Shape>(std::type_identity<Shape>) {
    Decoder<S, 3> decoder(source);
    // Before the mesh, which may use up the bytes.
    const auto shape = decoder.template shape<Shape>();
    const auto direction = decoder.direction();
    const S most = source.below(2) == 0 ? decoder.number() : largest<S>;
    check_cast(Subject<S>(source, decoder), shape, direction, most);
  });
}

}  // namespace

void property(Bytes input) {
  Source source(input);
  in_a_space(source, [&]<Scalar S, int N>(Space<S, N>) { check<S>(source); });
}

}  // namespace detent::fuzz
