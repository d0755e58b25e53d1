// SPDX-License-Identifier: MIT
#include "detent/shape/frustum.hpp"

#include <array>
#include <cstddef>
#include <utility>

#include "detent/query/closest_point/frustum.hpp"
#include "detent/query/contains/frustum.hpp"
#include "detent/query/distance/frustum.hpp"
#include "detent/query/intersects/frustum.hpp"
#include "detent/query/on.hpp"
#include "detent/query/overlaps/frustum.hpp"
#include "detent/query/raycast/frustum.hpp"
#include "oracle/frustum.hpp"
#include "oracle/pair_exam.hpp"
#include "oracle/space.hpp"

namespace detent::oracle {
namespace {

template <class Shape, Scalar S>
void examine_overlaps(std::uint64_t seed, long count, int aim) {
  PairExam<S, 3> exam(seed);
  const auto family = [&](const char* name, Kind kind, int percent, int low, int high) {
    exam.family(name, count * percent / 100, low, high, [&] {
      const auto setting = draw_setting(exam.draw, kind, aim);
      const auto shape = draw_shape<Shape>(exam.draw, setting);
      Artist<S, 3> artist(exam.draw, setting);
      return std::pair{shape, draw_frustum(artist)};
    });
  };
  family("random", Kind::general, 40, 30, 70);
  family("lattice", Kind::lattice, 25, 5, 95);
  family("tiny", Kind::tiny, 10, 5, 95);
  family("extreme", Kind::extreme, 15, 1, 99);
  family("degenerate", Kind::degenerate, 10, 1, 95);
  exam.finish(count);
}

template <Scalar S>
void examine(std::uint64_t seed, long count) {
  examine_overlaps<Aabb<S, 3>, S>(seed, count, 80);
  examine_overlaps<Obb<S, 3>, S>(seed + 1, count, 95);
  examine_overlaps<Triangle<S, 3>, S>(seed + 2, count, 35);
  examine_overlaps<ConvexHull<S, 3>, S>(seed + 3, count, 65);
  examine_overlaps<Segment<S, 3>, S>(seed + 4, count, 20);
  examine_overlaps<Sphere<S, 3>, S>(seed + 5, count, 75);
  examine_overlaps<Capsule<S, 3>, S>(seed + 6, count, 90);
  examine_overlaps<Plane<S, 3>, S>(seed + 7, count, 70);
}

TEMPLATE_TEST_CASE("frustum and shapes: overlapping is decided exactly", "[oracle]",
                   DETENT_FIXED_SCALARS) {
  examine<TestType>(0x4120, pair_cases / 20);
}

TEMPLATE_TEST_CASE("frustum and shapes: many more decisions are exact", "[oracle][.demand]",
                   DETENT_FIXED_SCALARS) {
  for (const auto seed : demanded_seeds()) examine<TestType>(seed, pair_cases / 10);
}

TEMPLATE_TEST_CASE("frustum, points and rays: every answer is that of the hull of the corners",
                   "[oracle]", DETENT_FIXED_SCALARS) {
  using S = TestType;
  Draw<S, 3> draw(0x4130);
  auto& random = draw.random;
  test::HitRate inside, hit;
  int wrong = 0;
  for (int k = 0; k < 3'000; ++k) {
    const auto kind = std::array{Kind::general, Kind::general, Kind::lattice, Kind::tiny,
                                 Kind::extreme}[random.below(5)];
    const auto setting = draw_setting(draw, kind, 40);
    Artist<S, 3> artist(draw, setting);
    const auto frustum = draw_frustum(artist);
    const auto hull = frustum.hull();
    const auto& corners = frustum.corners();
    const auto& from = corners[random.below(8)];
    const auto& to = corners[random.below(8)];
    const auto point = random.coin() ? nearest_to<S>(half(from + to))
                                     : Draw<S, 3>::vec(draw.near(artist.point(), setting.size / 8));
    const bool is_inside = is_within(nearest(hull, point), 0);
    inside.count(is_inside);
    if (contains(frustum, point) != is_inside) ++wrong;
    if (on(frustum, point) != is_inside) ++wrong;
    const auto reach = Draw<S, 3>::scalar(random.between(0, setting.size));
    if (on(frustum, point, reach) != (squared_distance(hull, point) <= square(reach))) ++wrong;
    if (distance(frustum, point) != distance(hull, point)) ++wrong;
    if (closest_point(frustum, point) != closest_point(hull, point)) ++wrong;
    if (on(frustum, point) != is_inside) ++wrong;
    const auto away = distance(hull, point);
    if (away < largest<S> && !on(frustum, point, nearest_to<S>(away + S::from_raw(1)))) ++wrong;
    if (away > 0 && on(frustum, point, nearest_to<S>(away - S::from_raw(1)))) ++wrong;

    const auto direction = random.one_in(3) ? draw.axis_direction() : draw.any_direction();
    const auto back = Draw<S, 3>::scalar(random.between(0, 4 * setting.size));
    const Ray<S, 3> ray{nearest_to<S>(point - back * direction.vec()), direction,
                        Draw<S, 3>::scalar(random.between(0, 8 * setting.size))};
    const auto truth = raycast_interval(ray, hull);
    hit.count(truth.has_value());
    if (raycast_interval(ray, frustum) != truth) ++wrong;
    if (raycast(ray, frustum) != raycast(ray, hull)) ++wrong;
    if (raycast_hit(ray, frustum) != raycast_hit(ray, hull)) ++wrong;
  }
  INFO(random << ", inside " << inside << ", hit " << hit);
  CHECK(wrong == 0);
  CHECK(inside.percent() >= 30);
  CHECK(inside.percent() <= 70);
  CHECK(hit.percent() >= 30);
  CHECK(hit.percent() <= 70);
}

}  // namespace
}  // namespace detent::oracle
