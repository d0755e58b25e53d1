// SPDX-License-Identifier: MIT
#include "detent/query/kernel/box_hull_witness.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <span>
#include <type_traits>

#include "detent/query/closest_points.hpp"
#include "detent/query/kernel/gjk.hpp"
#include "oracle/space.hpp"
#include "query/kernel/turns.hpp"
#include "support/catch.hpp"
#include "support/random_vec.hpp"

namespace detent::test {
namespace {

struct Rates {
  HitRate apart, sure_apart, sure_overlap, sure_common;
};

template <Scalar S, class Shape>
void compare(const Obb<S, 3>& box, const Shape& shape, Rates& rates) {
  const auto body_a = detail::body_of(box);
  const auto body_b = detail::body_of(shape);
  const detail::ClosestPoints<S, false, std::remove_cvref_t<decltype(body_a)>,
                              std::remove_cvref_t<decltype(body_b)>>
      search(body_a, body_b, S(0), S(0));
  const auto exact = search.find_exactly();
  const bool are_apart = !detail::bodies_overlap(body_a, body_b);
  rates.apart.count(are_apart);
  detail::BoxHullWitness<S> witness(box, detail::hull_corners(shape));
  const auto found = witness.find();
  if (found == Filtered::yes) REQUIRE_FALSE(are_apart);
  const auto points = found == Filtered::no ? witness.closest_points()
                                            : Decided<std::pair<Vec<S, 3>, Vec<S, 3>>>{{}, false};
  if (points.is_sure) {
    REQUIRE(are_apart);
    REQUIRE(points.value == exact);
  }
  if (are_apart) {
    rates.sure_apart.count(points.is_sure);
  } else {
    rates.sure_overlap.count(found == Filtered::yes);
  }
  REQUIRE(closest_points(box, shape) == exact);
  const detail::ClosestPoints<S, false, std::remove_cvref_t<decltype(body_b)>,
                              std::remove_cvref_t<decltype(body_a)>>
      swapped(body_b, body_a, S(0), S(0));
  REQUIRE(closest_points(shape, box) == swapped.find_exactly());
  if constexpr (std::is_same_v<Shape, Triangle<S, 3>>) {
    if (found != Filtered::yes) return;
    const auto enter_box = [&] {
      return detail::first_entry<S>(body_b, body_a, detail::Sides(body_a));
    };
    for (const bool is_box_first : {true, false}) {
      const auto common = witness.common_point_of_triangle(is_box_first, enter_box);
      rates.sure_common.count(common.is_sure);
      if (!common.is_sure) continue;
      REQUIRE(common.value == (is_box_first ? exact : swapped.find_exactly()).first);
    }
  }
}

/// A box, a triangle and hulls with lengths below 2^bits steps; some are in one plane, in one line, or
/// one point, and some corners are twice in a list.
template <Scalar S, class Turn>
void compare_some(int bits, int asked, const Turn& turn, Rates& rates) {
  repeat(bits, asked, [&](Random& random) {
    const auto vector = [&](int length) {
      const auto reach = std::int64_t{1} << std::max(length, 1);
      return random_vec<S, 3>(random, -reach, reach - 1);
    };
    const auto extent = [&](int) {
      return random.one_in(8) ? S(0)
                              : random.number<S>(0, (std::int64_t{1} << std::max(bits - 2, 1)) - 1);
    };
    const auto rotation = turn(random);
    const Obb<S, 3> box{vector(bits - 4), make_vec<3>(extent), rotation};
    const auto middle = vector(bits - 4);
    const int size = bits - (random.one_in(4) ? 8 : 3);
    std::array<Vec<S, 3>, 18> points;
    for (auto& point : points) point = nearest_to<S>(middle + vector(size));
    // Corners along the axes of the box, so that edges and faces are parallel.
    if (random.one_in(3)) {
      for (auto& point : points) {
        const auto axis = rotation.axis(static_cast<int>(random.below(3)));
        point = nearest_to<S>(
            middle + axis.vec() * random.number<S>(0, std::int64_t{1} << std::max(size, 1)));
      }
    }
    if (random.one_in(4)) points[2] = points[random.below(2)];
    if (random.one_in(8)) points.fill(points[0]);
    compare(box, Triangle<S, 3>{points[0], points[1], points[2]}, rates);
    const auto count = std::array{1u, 2u, 5u, 8u, 16u, 18u}[random.below(6)];
    compare(box, ConvexHull<S, 3>{std::span<const Vec<S, 3>>(points.data(), count)}, rates);
  });
}

TEMPLATE_TEST_CASE("box and hull witness: what it is sure of is exact", "[query]",
                   DETENT_FILTER_SCALARS) {
  using S = TestType;
  const auto any = [](Random& random) { return random_turn<S>(random, 32); };
  const auto aligned = [](Random& random) {
    return random_turn<S>(random, static_cast<int>(random.below(8)));
  };
  Rates rates, short_ones, long_ones;
  compare_some<S>(20, 400, any, rates);
  compare_some<S>(27, 200, any, rates);
  compare_some<S>(20, 200, aligned, rates);
  compare_some<S>(4, 200, any, short_ones);
  compare_some<S>(8, 200, aligned, short_ones);
  compare_some<S>(S::bits, 200, any, long_ones);
  for (const auto* some : {&rates, &short_ones, &long_ones}) {
    INFO(some->apart << "; sure: apart " << some->sure_apart << ", overlap " << some->sure_overlap);
    CHECK(some->apart.percent() >= 20);
    CHECK(some->apart.percent() <= 95);
    CHECK(some->sure_apart.percent() < 100);
  }
  INFO(rates.sure_apart << ", overlap " << rates.sure_overlap);
  CHECK(rates.sure_apart.percent() >= 60);
  CHECK(rates.sure_overlap.percent() >= 50);
}

TEST_CASE("box and hull witness: it decides pairs in general position", "[query]") {
  using S = q16_16;
  Random random(0xb0b);
  Rates rates;
  for (int i = 0; i < 500; ++i) {
    const auto near = [&] { return random_vec<S, 3>(random, -(3 << 16), 3 << 16); };
    const Obb<S, 3> box{near(), random_vec<S, 3>(random, 1 << 15, 6 << 16),
                        random_turn<S>(random, 32)};
    const auto middle = near();
    std::array<Vec<S, 3>, 12> points;
    for (auto& point : points) point = nearest_to<S>(middle + near());
    compare(box, Triangle<S, 3>{points[0], points[1], points[2]}, rates);
    for (auto& point : points) point = nearest_to<S>(point + middle + middle);
    compare(box, ConvexHull<S, 3>{std::span<const Vec<S, 3>>(points)}, rates);
  }
  INFO(rates.apart << "; sure: apart " << rates.sure_apart << ", overlap " << rates.sure_overlap);
  CHECK(rates.apart.percent() >= 20);
  CHECK(rates.sure_apart.percent() >= 99);
  CHECK(rates.sure_overlap.percent() >= 99);
  INFO("common " << rates.sure_common);
  CHECK(rates.sure_common.percent() >= 95);
}

}  // namespace
}  // namespace detent::test
