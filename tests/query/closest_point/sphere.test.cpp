// SPDX-License-Identifier: MIT
#include "detent/query/closest_point/sphere.hpp"

#include "number/big_integer.hpp"
#include "query/raycast/helpers.hpp"
#include "support/random.hpp"

namespace detent::test {
namespace {

/// Whether k is r d / |d| rounded to nearest: (2 |k| - 1) |d| <= 2 r |d_i| <= (2 |k| + 1) |d|, with
/// the same sign.
bool is_share(std::int64_t k, std::int64_t r, std::int64_t d_i, const BigInteger& squared) {
  if (k != 0 && (k < 0) != (d_i < 0)) return false;
  const BigInteger size = k < 0 ? -k : k, share = BigInteger(2) * r * d_i, square = share * share;
  const BigInteger low = 2 * size - 1, high = 2 * size + 1;
  return (size == 0 || low * low * squared <= square) && square <= high * high * squared;
}

TEMPLATE_TEST_CASE(
    "closest point, sphere: on the surface towards the point, or an inside point itself",
    "[closest_point]", DETENT_EVERY_SPACE) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  const Sphere<S, N> sphere{at<S, N>(1, 2), num<S>(5)};
  CHECK(closest_point(sphere, at<S, N>(11, 2)) == at<S, N>(6, 2));
  CHECK(closest_point(sphere, at<S, N>(1, -20)) == at<S, N>(1, -3));
  CHECK(closest_point(sphere, at<S, N>(2, 2)) == at<S, N>(2, 2));
  CHECK(closest_point(sphere, sphere.center) == sphere.center);
  CHECK(closest_point(sphere, at<S, N>(4, 6)) == at<S, N>(4, 6));
  CHECK(closest_point(Sphere<S, N>{sphere.center, num<S>(0)}, at<S, N>(7, 8)) == sphere.center);
  CHECK(closest_point(Sphere<S, N>{sphere.center, num<S>(-1)}, at<S, N>(7, 8)) == at<S, N>(7, 8));
}

TEMPLATE_TEST_CASE("closest point, sphere: rounded once", "[closest_point]", DETENT_FIXED_SPACES) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  const auto raw = in_steps<S, N>;
  const Sphere<S, N> sphere{Vec<S, N>(), moved(S(0), 25)};
  CHECK(closest_point(sphere, raw(300, 400)) == raw(15, 20));
  CHECK(closest_point(sphere, raw(-300, 400)) == raw(-15, 20));
  CHECK(closest_point(sphere, raw(7 * 16, -24 * 16)) == raw(7, -24));
  // (4.8, 1.4) and (3.2, 2.4): no ties occur, because the hypotenuse of a primitive Pythagorean
  // triple is odd.
  CHECK(closest_point(Sphere<S, N>{raw(0, 0), moved(S(0), 5)}, raw(24, 7)) == raw(5, 1));
  CHECK(closest_point(Sphere<S, N>{raw(0, 0), moved(S(0), 4)}, raw(100, 75)) == raw(3, 2));
  const auto far = filled<S, N>(S::max());
  const Sphere<S, N> all{filled<S, N>(S::lowest()), S::max()};
  const auto closest = closest_point(all, far);
  for (int i = 0; i < N; ++i) CHECK(closest[i] == closest[0]);
  CHECK(closest[0] > all.center[0]);
  CHECK(closest[0] < far[0]);
}

TEST_CASE("closest point, sphere: a step that ends just before the lowest number",
          "[closest_point]") {
  const auto check = [](auto scalar) {
    using S = decltype(scalar);
    const auto n = [](std::int32_t raw) { return S::from_raw(raw); };
    const std::int32_t lowest_raw = S::lowest().raw();
    const Sphere<S, 2> disc{{n(-10), n(-4)}, n(-10 - lowest_raw)};
    CHECK(closest_point(disc, {n(lowest_raw), n(1)}) == Vec<S, 2>{n(lowest_raw), n(1)});
    const Sphere<S, 3> ball{{n(-10), n(-4), n(0)}, disc.radius};
    CHECK(closest_point(ball, {n(lowest_raw), n(1), n(0)}) == Vec<S, 3>{n(lowest_raw), n(1), n(0)});
  };
  check(q16_16());
  check(q14_16());
  check(q24_8());
}

TEMPLATE_TEST_CASE("closest point, sphere: exact at the ends of the range", "[closest_point]",
                   DETENT_FIXED_SPACES) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  using Raw = typename S::raw_type;
  Random random(0xe2d5);
  INFO("seed " << random.seed());
  const std::int64_t least = S::lowest().raw(), most = S::max().raw();
  const auto component = [&] {
    const auto ends = random.below(3);
    return ends == 0   ? least + random.between(0, 9)
           : ends == 1 ? most - random.between(0, 9)
                       : random.between(-9, 9);
  };
  HitRate outside;
  int wrong = 0;
  for (int i = 0; i < 4'000; ++i) {
    std::array<std::int64_t, N> c{}, p{};
    for (auto& x : c) x = component();
    for (auto& x : p) x = component();
    // Close together on all axes except one, and about a radius apart on that one.
    const auto axis = random.below(N);
    for (std::size_t k = 0; k < N && random.one_in(2); ++k) {
      if (k != axis) p[k] = std::clamp(c[k] + random.between(-9, 9), least, most);
    }
    const auto apart = p[axis] < c[axis] ? c[axis] - p[axis] : p[axis] - c[axis];
    const auto r = std::clamp<std::int64_t>(apart - random.between(-1, 2), 0, most);
    Sphere<S, N> sphere;
    Vec<S, N> point;
    BigInteger squared = 0;
    for (std::size_t k = 0; k < N; ++k) {
      sphere.center[static_cast<int>(k)] = S::from_raw(static_cast<Raw>(c[k]));
      point[static_cast<int>(k)] = S::from_raw(static_cast<Raw>(p[k]));
      squared += BigInteger(p[k] - c[k]) * (p[k] - c[k]);
    }
    sphere.radius = S::from_raw(static_cast<Raw>(r));
    const auto closest = closest_point(sphere, point);
    const bool is_outside = squared > BigInteger(r) * r;
    outside.count(is_outside);
    for (std::size_t k = 0; k < N; ++k) {
      const std::int64_t x = closest[static_cast<int>(k)].raw();
      if (is_outside ? !is_share(x - c[k], r, p[k] - c[k], squared) : x != p[k]) ++wrong;
    }
  }
  INFO(outside);
  CHECK(wrong == 0);
  CHECK(outside.percent() >= 30);
}

}  // namespace
}  // namespace detent::test
