// SPDX-License-Identifier: MIT
#include "detent/dynamics/relative.hpp"

#include <algorithm>
#include <cmath>

#include "dynamics/manifold/rational.hpp"
#include "oracle/exact.hpp"

namespace detent::test {
namespace {

using oracle::Integer;

Integer power(int exponent) { return Integer(1) << static_cast<unsigned>(exponent); }

template <Scalar S, int N>
detail::Support<S, N> draw_support(Random& random, std::int64_t reach) {
  detail::RelativePose<S, N> turned;
  std::array<double, 4> q{};
  for (int i = 0; i < 4; ++i) {
    const bool is_used = N == 3 || i == 0 || i == 3;
    q[static_cast<std::size_t>(i)] =
        is_used ? static_cast<double>(random.between(-4096, 4096)) + 0.5 : 0;
  }
  turn(turned, q);
  detail::Support<S, N> support;
  support.axes = turned.axes;
  support.place = make_vec<N>([&](int) {
    using Place = typename detail::Formats<S>::Place;
    return random.number<Place>(-reach, reach);
  });
  return support;
}

/// How far a point q of b is from its exact position along axis i of a, and the bound of
/// docs/contacts_of_bodies.md, both in steps of 2^-72 of the scalar's grid.
struct Shift {
  Integer error, bound;
};
template <Scalar S, int N>
Shift shift_of(const detail::Support<S, N>& a, const detail::Support<S, N>& b,
               const detail::RelativePose<S, N>& pose, const Vec<lever<S>, N>& q, int i) {
  const auto whole = [](const auto& x) { return Integer(static_cast<std::int64_t>(x.raw())); };
  Integer exact = 0, found = whole(pose.translation[i]) * power(66), length = 0;
  for (int k = 0; k < N; ++k) {
    Integer there = (whole(b.place[k]) - whole(a.place[k])) * power(30);
    for (int j = 0; j < N; ++j) {
      there += whole(b.axes[static_cast<std::size_t>(j)][k]) * whole(q[j]) * 64;
    }
    exact += whole(a.axes[static_cast<std::size_t>(i)][k]) * there;
  }
  for (int j = 0; j < N; ++j) {
    found += whole(pose.axes[static_cast<std::size_t>(j)][i]) * whole(q[j]) * power(36);
    length += abs(whole(q[j]));
  }
  const Integer millionths = N == 2 ? 1'207'107 : 1'366'026;  // (1 + sqrt(N)) / 2
  return {abs(exact - found), millionths * power(66) / 1'000'000 + length * power(35)};
}

/// Moves the place of b by less than a step of a lever, so that the rounding of the offset shifts it
/// along axis i of a by as much as it can.
template <Scalar S, int N>
void round_badly(const detail::Support<S, N>& a, detail::Support<S, N>& b, int i) {
  for (int k = 0; k < N; ++k) {
    using Place = typename detail::Formats<S>::Place;
    const auto down = a.axes[static_cast<std::size_t>(i)][k] > 0 ? 31 : 33;
    const auto step = (b.place[k].raw() - a.place[k].raw()) & ~typename Place::raw_type{63};
    b.place[k] = Place::assume_raw(a.place[k].raw() + step + down);
  }
}

template <Scalar S, int N>
void compare_poses(std::uint64_t seed, int count) {
  Random random(seed);
  CAPTURE(random.seed());
  constexpr std::int64_t longest = lever<S>::max().raw();
  // The offset must fit a lever, and the places move by less than a step of it.
  constexpr std::int64_t farthest = detail::Formats<S>::Place::max().raw() - 64;
  double most = 0, most_of_short = 0;
  for (int round = 0; round < count; ++round) {
    const auto reach = std::min(farthest, longest * 8) >> random.between(0, 20);
    const auto a = draw_support<S, N>(random, reach);
    auto b = draw_support<S, N>(random, reach);
    const int i = static_cast<int>(random.below(N));
    if (!random.one_in(4)) round_badly(a, b, i);
    const auto pose = detail::relative_pose(a, b, detail::offset_between(a, b));
    const bool is_short = random.one_in(3);
    const std::int64_t size = is_short ? 0 : longest >> random.between(0, 1);
    const auto q = make_vec<N>([&](int j) {
      // Outward where the axis was rounded outward.
      Integer exact = 0;
      for (int k = 0; k < N; ++k) {
        exact += Integer(std::int64_t{a.axes[static_cast<std::size_t>(i)][k].raw()}) *
                 std::int64_t{b.axes[static_cast<std::size_t>(j)][k].raw()};
      }
      const Integer found =
          Integer(std::int64_t{pose.axes[static_cast<std::size_t>(j)][i].raw()}) * power(30);
      const bool is_lower = found < exact;
      return lever<S>::assume_raw(
          static_cast<typename lever<S>::raw_type>(is_lower ? -size : size));
    });
    // Both signs, because that of the translation's error is not known.
    for (const auto& point : {q, Vec<lever<S>, N>(make_vec<N>(
                                     [&](int j) { return lever<S>::assume_raw(-q[j].raw()); }))}) {
      const auto shift = shift_of(a, b, pose, point, i);
      REQUIRE(shift.error <= shift.bound);
      const double share = static_cast<double>(Integer(shift.error * 1000 / shift.bound)) / 1000;
      (is_short ? most_of_short : most) = std::max(is_short ? most_of_short : most, share);
    }
  }
  // The bound is not generous: less than nine tenths of it would be too little.
  CAPTURE(most, most_of_short);
  CHECK(most >= 0.9);
  CHECK(most_of_short >= 0.9);
}

TEMPLATE_TEST_CASE("relative pose: every point is within its bound, which is nearly reached", "",
                   q16_16, q8_8) {
  compare_poses<TestType, 3>(0x905e, 20'000);
  compare_poses<TestType, 2>(0x905e, 5000);
}

}  // namespace
}  // namespace detent::test
