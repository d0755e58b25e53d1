// SPDX-License-Identifier: MIT
//
// A mesh of any triangles at any transform gives the same results as a loop over its transformed
// triangles.

#include <optional>

#include "mesh_subject.hpp"
#include "spaces.hpp"

namespace detent::fuzz {
namespace {

template <class Shape, Scalar S>
void check_shape(const Subject<S>& subject, Decoder<S, 3>& decoder) {
  const auto shape = decoder.template shape<Shape>();
  const bool expected = overlaps(subject.loop, shape);
  require_same(overlaps(subject.mesh, shape) == expected, "overlaps");
  require_same(overlaps(shape, subject.mesh) == expected, "overlaps");
}

template <Scalar S>
void check_ray(const Subject<S>& subject, Decoder<S, 3>& decoder) {
  const auto ray = decoder.template shape<Ray<S, 3>>();
  const auto& triangles = subject.loop.triangles;
  std::optional<MeshHit<S>> expected;
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const auto distance = raycast(ray, triangles[i]);
    if (distance && (!expected || *distance < expected->distance)) {
      expected = MeshHit<S>{*distance, static_cast<std::uint32_t>(i)};
    }
  }
  require_same(raycast_nearest(ray, subject.mesh) == expected, "raycast_nearest");
  require_same(raycast_any(ray, subject.mesh) == expected.has_value(), "raycast_any");
}

template <Scalar S>
void check_point(const Subject<S>& subject, Decoder<S, 3>& decoder) {
  const auto point = decoder.point();
  require_same(contains(subject.mesh, point) == contains(subject.loop, point), "contains");
  require_same(distance(subject.mesh, point) == distance(subject.loop, point), "distance");
  const auto other = decoder.point();
  const Segment segment{point, other};
  require_same(intersects(segment, subject.mesh) == intersects(segment, subject.loop),
               "intersects");
}

template <Scalar S>
void check(Source& source) {
  using Shapes = typename support::SceneShapes<S, 3>::template and_also<ConvexHull<S, 3>>;
  const auto question = source.below(Shapes::size + 4);
  Decoder<S, 3> decoder(source);
  const Subject<S> subject(source, decoder);
  if (question < Shapes::size) {
    return Shapes::at(question,
                      [&]<class Shape>(const Shape&) { check_shape<Shape>(subject, decoder); });
  }
  switch (question - Shapes::size) {
    case 0: {
      const Subject<S> other(source, decoder);
      const bool expected = overlaps(subject.loop, other.loop);
      require_same(overlaps(subject.mesh, other.mesh) == expected, "overlaps of meshes");
      return require_same(overlaps(other.mesh, subject.mesh) == expected, "overlaps of meshes");
    }
    case 1:
      return check_point(subject, decoder);
    default:
      return check_ray(subject, decoder);
  }
}

}  // namespace

void property(Bytes input) {
  Source source(input);
  in_a_space(source, [&]<Scalar S, int N>(Space<S, N>) { check<S>(source); });
}

}  // namespace detent::fuzz
