// SPDX-License-Identifier: MIT
#include "detent/query/kernel/box_witness.hpp"

#include <algorithm>
#include <cstdlib>

#include "detent/query/closest_points/bodies.hpp"
#include "detent/query/kernel/box_common_point.hpp"
#include "detent/query/kernel/convex_body.hpp"
#include "oracle/space.hpp"
#include "query/kernel/turns.hpp"
#include "support/catch.hpp"
#include "support/random_vec.hpp"

namespace detent::test {
namespace {

/// One of the rotations by multiples of a quarter turn.
template <Scalar S>
Rotation<S, 3> quarter_turn(Random& random) {
  const auto angle = [&] {
    return Angle<S>::from_raw(static_cast<std::uint32_t>(random.below(4) << 30));
  };
  const auto x = angle(), y = angle();
  return Rotation<S, 3>::from_euler(x, y, angle());
}

template <Scalar S>
S random_length(Random& random, int bits) {
  const auto most = (std::int64_t{1} << bits) - 1;
  return S::from_raw(static_cast<typename S::raw_type>(random.one_in(8) ? 0
                                                       : random.coin()
                                                           ? random.between(most / 4, most)
                                                           : std::abs(random.wide(bits))));
}

struct Rates {
  HitRate apart, sure_points, sure_distances, sure_common;
};

template <Scalar S>
void compare(const Obb<S, 3>& a, const Obb<S, 3>& b, Rates& rates) {
  using Length = detail::Length<S>;
  const auto body_a = detail::body_of(a), body_b = detail::body_of(b);
  const detail::ClosestPoints<S, false, std::remove_cvref_t<decltype(body_a)>,
                              std::remove_cvref_t<decltype(body_b)>>
      search(body_a, body_b, S(0), S(0));
  const auto exact = search.find();
  const auto distance = sqrt_floor<Length>(detail::squared_distance_between(body_a, body_b));
  const bool are_apart = !detail::bodies_overlap(body_a, body_b);
  rates.apart.count(are_apart);

  const auto points = detail::BoxWitness<S>(a, b).closest_points();
  const auto length = detail::BoxWitness<S>(a, b).distance_floor();
  const auto common = detail::common_point_by_words(a, b);
  if (are_apart) {
    rates.sure_points.count(points.is_sure);
    rates.sure_distances.count(length.is_sure);
    REQUIRE_FALSE(common.is_sure);
    if (points.is_sure) REQUIRE(points.value == exact);
    if (length.is_sure) REQUIRE(length.value == distance);
  } else {
    rates.sure_common.count(common.is_sure);
    REQUIRE_FALSE(points.is_sure);
    if (length.is_sure) REQUIRE(length.value == 0);
    if (common.is_sure) REQUIRE(std::pair{common.value, common.value} == exact);
  }
}

/// Boxes with lengths below 2^bits steps, and rotations by `turn(random)`.
template <Scalar S, class Turn>
void compare_some(int bits, int asked, const Turn& turn, Rates& rates) {
  repeat(bits, asked, [&](Random& random) {
    const auto box = [&](const Rotation<S, 3>& rotation) {
      const auto half = make_vec<3>([&](int) { return random_length<S>(random, bits - 2); });
      const auto reach = std::int64_t{1} << (random.one_in(8) ? bits : std::max(bits - 4, 1));
      const auto center = random_vec<S, 3>(random, -reach, reach - 1);
      return Obb<S, 3>{center, half, rotation};
    };
    const auto rotation = turn(random);
    const auto a = box(rotation);
    auto b = box(random.coin() ? turn(random) : rotation);
    compare(a, b, rates);
    // Tilted a little, and sheared.
    const auto tilted =
        compose(random_turn<S>(random, static_cast<int>(random.below(24))), rotation);
    b.rotation = tilted;
    compare(a, b, rates);
    b.rotation = Rotation<S, 3>::from_axes({tilted.axis(0), rotation.axis(1), tilted.axis(2)});
    compare(a, b, rates);
    b.rotation = Rotation<S, 3>::from_axes({tilted.axis(0), tilted.axis(1), tilted.axis(1)});
    compare(b, a, rates);
  });
}

TEMPLATE_TEST_CASE("box witness: what it is sure of is exact", "[query]", DETENT_FILTER_SCALARS) {
  using S = TestType;
  const auto any = [](Random& random) { return random_turn<S>(random, 32); };
  const auto quarter = [](Random& random) { return quarter_turn<S>(random); };
  Rates rates, aligned, coarse, large;
  compare_some<S>(20, 400, any, rates);
  compare_some<S>(20, 100, quarter, aligned);
  compare_some<S>(8, 200, any, coarse);
  compare_some<S>(3, 200, quarter, coarse);
  compare_some<S>(S::bits, 300, any, large);
  compare_some<S>(S::bits, 100, quarter, large);
  for (const auto* some : {&rates, &aligned, &coarse, &large}) {
    INFO(some->apart << "; sure: points " << some->sure_points << ", distances "
                     << some->sure_distances << ", common " << some->sure_common);
    CHECK(some->apart.percent() >= 20);
    CHECK(some->apart.percent() <= 80);
    CHECK(some->sure_points.percent() >= 10);
    CHECK(some->sure_points.percent() <= 90);
    CHECK(some->sure_distances.percent() >= 10);
    CHECK(some->sure_common.percent() >= 25);
  }
}

TEST_CASE("box witness: it decides pairs in general position", "[query]") {
  Random random(0x0b2b);
  Rates rates;
  for (int i = 0; i < 500; ++i) {
    const auto box = [&] {
      const auto center = random_vec<q16_16, 3>(random, -(3 << 16), 3 << 16);
      const auto half = random_vec<q16_16, 3>(random, 1 << 14, 3 << 16);
      return Obb<q16_16, 3>{center, half, random_turn<q16_16>(random, 32)};
    };
    const auto a = box();
    compare(a, box(), rates);
  }
  INFO(rates.apart << "; sure: points " << rates.sure_points << ", distances "
                   << rates.sure_distances << ", common " << rates.sure_common);
  CHECK(rates.apart.is_balanced());
  CHECK(rates.sure_points.percent() >= 95);  // some rotations are nearly the same
  CHECK(rates.sure_distances.percent() >= 95);
  CHECK(rates.sure_common.percent() >= 98);
}

}  // namespace
}  // namespace detent::test
