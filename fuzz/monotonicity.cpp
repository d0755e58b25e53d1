// SPDX-License-Identifier: MIT
//
// A shape that grows still contains, is hit by and overlaps what it did before. No distance to it
// increases, from a point or along a ray. A longer ray hits the same at the same distance.

#include "decode.hpp"
#include "detent/query/contains.hpp"
#include "detent/query/distance.hpp"
#include "detent/query/intersects.hpp"
#include "detent/query/overlaps.hpp"
#include "detent/query/raycast.hpp"
#include "oracle/describe.hpp"
#include "spaces.hpp"

namespace detent::fuzz {
namespace {

/// `length` increased by a number of raw units, clamped to its type.
template <Scalar S>
S longer(S length, Source& source) {
  const std::int64_t more = source.below(2) == 0 ? source.byte() : source.bits(S::bits);
  return oracle::Draw<S, 2>::scalar(length.raw() + std::abs(more));
}

template <class Shape>
requires requires(Shape shape) { shape.radius; }
Shape grown(Shape shape, Source& source) {
  shape.radius = longer(shape.radius, source);
  return shape;
}
template <Scalar S, int N>
Aabb<S, N> grown(const Aabb<S, N>& box, Source& source) {
  auto result = box;
  for (int i = 0; i < N; ++i) result.max[i] = longer(box.max[i], source);
  return result;
}
template <Scalar S, int N>
Obb<S, N> grown(const Obb<S, N>& box, Source& source) {
  auto result = box;
  for (int i = 0; i < N; ++i) result.half_extents[i] = longer(box.half_extents[i], source);
  return result;
}

template <class Shape, Scalar S, int N>
void check(Source& source) {
  Decoder<S, N> decoder(source);
  const auto shape = decoder.template shape<Shape>();
  const auto ray = decoder.template shape<Ray<S, N>>();
  const auto segment = decoder.template shape<Segment<S, N>>();
  const auto sphere = decoder.template shape<Sphere<S, N>>();
  const auto triangle = decoder.template shape<Triangle<S, N>>();
  const auto point = decoder.point();
  const auto larger = grown(shape, source);
  const auto because = [&](const char* query) {
    return [&, query] {
      return std::string(query) + ": " + oracle::describe(shape) + " grown to " +
             oracle::describe(larger) + "; " + oracle::describe(ray) + "; " +
             oracle::describe(segment) + "; " + oracle::describe(sphere) + "; " +
             oracle::describe(triangle) + "; point " + oracle::describe(point);
    };
  };

  require(contains(larger, point) || !contains(shape, point), because("contains"));
  require(distance(larger, point) <= distance(shape, point), because("distance"));
  require(intersects(segment, larger) || !intersects(segment, shape), because("intersects"));
  require(overlaps(larger, sphere) || !overlaps(shape, sphere), because("overlaps a sphere"));
  require(overlaps(larger, triangle) || !overlaps(shape, triangle), because("overlaps a triangle"));
  require(overlaps(grown(sphere, source), shape) || !overlaps(sphere, shape),
          because("overlaps a grown sphere"));
  if constexpr (requires { raycast(ray, shape); }) {
    if (const auto hit = raycast_interval(ray, shape)) {
      const auto larger_hit = raycast_interval(ray, larger);
      require(larger_hit.has_value(), because("raycast"));
      require(larger_hit->enter <= hit->enter, because("raycast distance"));
      require(larger_hit->exit >= hit->exit, because("raycast exit"));
      auto further = ray;
      further.max_distance = longer(ray.max_distance, source);
      const auto further_hit = raycast_interval(further, shape);
      require(further_hit.has_value(), because("further raycast"));
      require(further_hit->enter == hit->enter, because("further raycast distance"));
      require(further_hit->exit >= hit->exit, because("further raycast exit"));
    }
  }
}

}  // namespace

void property(Bytes input) {
  Source source(input);
  in_a_space(source, [&]<Scalar S, int N>(Space<S, N>) {
    using Solids =
        typename support::SceneShapes<S, N>::template without<Plane<S, N>, Triangle<S, N>>;
    with_one_of(Solids(), source,
                [&]<class Shape>(std::type_identity<Shape>) { check<Shape, S, N>(source); });
  });
}

}  // namespace detent::fuzz
