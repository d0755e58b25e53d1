// SPDX-License-Identifier: MIT
#include "detent/query/cast.hpp"
#include "oracle/space.hpp"
#include "query/raycast/helpers.hpp"
#include "support/random.hpp"

namespace detent::test {
namespace {

TEST_CASE("cast: the distance of a box to a triangle is rounded down", "[cast]") {
  using S = q16_16;
  const Aabb<S, 3> box{at<S, 3>(-1, -1, -1), at<S, 3>(0, 0, 0)};
  // The corner (0, 0, 0) meets x + y + z = 1 at x = y = z = 1 / 3.
  const Triangle<S, 3> triangle{at<S, 3>(1, 0, 0), at<S, 3>(0, 1, 0), at<S, 3>(0, 0, 1)};
  const auto hit = cast(box, toward<S, 3>(1, 1, 1), num<S>(9), triangle);
  REQUIRE(hit);
  CHECK(hit->distance == S::from_raw(37837));  // 65536 / sqrt(3) = 37837.2
  CHECK(hit->normal == toward<S, 3>(-1, -1, -1));
}

TEST_CASE("cast: a corner that lands exactly on a plane is the closest one", "[cast]") {
  using S = q16_16;
  const auto down = toward<S, 3>(0, 0, -1);
  const Triangle<S, 3> roof{at<S, 3>(1, 2, 3), at<S, 3>(5, 4, 6), at<S, 3>(-4, 7, 8)};
  CHECK(cast(roof, down, num<S>(9), Plane<S, 3>{-down, S(0)}) ==
        CastHit<S, 3>{num<S>(3), at<S, 3>(1, 2, 0), -down});
  CHECK(cast(roof, -down, num<S>(9), Plane<S, 3>{-down, num<S>(9)}) ==
        CastHit<S, 3>{num<S>(1), at<S, 3>(-4, 7, 9), down});
}

TEST_CASE("cast: among several closest points of the target, the least is returned", "[cast]") {
  using S = q16_16;
  const Aabb<S, 3> floor{at<S, 3>(-9, -9, -1), at<S, 3>(9, 9, 0)};
  const auto down = toward<S, 3>(0, 0, -1);
  // The upper and lower sides are parallel; where the boxes touch exactly, they share an area.
  const Aabb<S, 3> box{at<S, 3>(1, 2, 3), at<S, 3>(4, 5, 6)};
  const auto landed = cast(box, down, num<S>(9), floor);
  REQUIRE(landed);
  CHECK(*landed == CastHit<S, 3>{num<S>(3), at<S, 3>(1, 2, 0), -down});
  const Obb<S, 3> turned{at<S, 3>(0, 0, 3), at<S, 3>(1, 1, 1), Rotation<S, 3>()};
  CHECK(cast(turned, down, num<S>(9), Plane<S, 3>{-down, S(0)})->point == at<S, 3>(-1, -1, 0));
  const Capsule<S, 3> lying{at<S, 3>(2, 1, 5), at<S, 3>(-1, 1, 5), num<S>(1)};
  CHECK(cast(lying, down, num<S>(9), floor) == CastHit<S, 3>{num<S>(4), at<S, 3>(-1, 1, 0), -down});
  const Obb<S, 3> base{at<S, 3>(0, 0, -1), at<S, 3>(9, 9, 1), Rotation<S, 3>()};
  CHECK(cast(lying, down, num<S>(9), base) == CastHit<S, 3>{num<S>(4), at<S, 3>(-1, 1, 0), -down});
  CHECK(cast(base, -down, num<S>(9), lying) == CastHit<S, 3>{num<S>(4), at<S, 3>(-1, 1, 4), down});
}

template <Scalar S, int N>
Aabb<S, N> draw_box(Random& random, int size) {
  const auto corner = [&] {
    return make_vec<N>([&](int) {
      return S::assume_raw(static_cast<typename S::raw_type>(random.between(-size, size)));
    });
  };
  const Vec<S, N> a = corner(), b = corner();
  return {make_vec<N>([&](int i) { return (std::min)(a[i], b[i]); }),
          make_vec<N>([&](int i) { return (std::max)(a[i], b[i]); })};
}

TEMPLATE_TEST_CASE("cast: the closest point of two boxes is the one that the search finds",
                   "[cast]", DETENT_FIXED_SPACES) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  Random random(11);
  const Direction<S, N> directions[] = {toward<S, N>(1, 0), toward<S, N>(0, -1),
                                        toward<S, N>(3, -4), toward<S, N>(-5, 12)};
  int apart = 0, searched = 0;
  for (int round = 0; round < 1000; ++round) {
    // Small boxes often share a face, an edge or a corner.
    const int size = random.coin() ? 4 : (S::max)().raw() / 2;
    const auto a = draw_box<S, N>(random, size), b = draw_box<S, N>(random, size);
    const auto distance = S::assume_raw(static_cast<typename S::raw_type>(random.between(0, size)));
    const auto offset = directions[random.between(0, 3)].vec() * distance;
    const auto found = detail::closest_point_of_boxes(a, b, offset);
    const auto moved = detail::moved_body(detail::body_of(a), offset);
    const auto exact = detail::closest_point_of_body(moved, detail::body_of(b), S(0));
    CAPTURE(a, b, offset);
    if (found) CHECK(*found == exact);
    apart += found && !detail::bodies_overlap(moved, detail::body_of(b)) ? 1 : 0;
    searched += found ? 0 : 1;
  }
  CHECK(apart > 100);
  CHECK(searched > 3);
}

template <Scalar S>
S draw_number(Random& random, int bits) {
  const auto most = std::int64_t{1} << bits;
  return S::assume_raw(static_cast<typename S::raw_type>(random.between(-most, most - 1)));
}
template <Scalar S>
Vec<S, 3> draw_point(Random& random, int bits) {
  return make_vec<3>([&](int) { return draw_number<S>(random, bits); });
}

TEMPLATE_TEST_CASE("cast: times to planes and feet on them, by words, are the exact ones", "[cast]",
                   DETENT_FILTER_SCALARS) {
  using S = TestType;
  Random random(12);
  int sure = 0, past = 0;
  for (int round = 0; round < 20'000; ++round) {
    const int bits = static_cast<int>(random.between(2, bits_of<S> - 1));
    const auto normal = direction_of<S>(draw_point<S>(random, 4 + bits / 2));
    const auto fall = direction_of<S>(draw_point<S>(random, 3));
    if (!normal || !fall) continue;
    const auto squared = squared_length(*normal);
    const auto p = draw_point<S>(random, bits);
    const auto height = dot(*normal, p) - draw_number<S>(random, bits);
    const auto foot = detail::decide_foot(p, *normal, height);
    CAPTURE(p, *normal, height);
    if (foot.is_sure) {
      const detail::RationalPoint exact{p * squared - normal->vec() * height, squared};
      CHECK(foot.value == detail::rounded<S>(exact));
    }

    const auto speed = narrow_negative(dot(*normal, *fall));
    const S radius = random.coin() ? S(0) : nearest_to<S>(abs(draw_number<S>(random, bits)));
    const S limit = random.coin() ? (S::max)() : nearest_to<S>(abs(draw_number<S>(random, bits)));
    const auto check = [&](const auto& from) {
      const auto time = detail::decide_time_to_plane(from, radius, squared, speed, limit);
      if (!time.is_sure) return;
      ++sure;
      CAPTURE(from, radius, speed, limit, time.value);
      // Whether the ball is apart from the plane, falling, after t.
      const auto is_apart = [&](const auto& t) {
        const auto left = from - speed * t;
        return left > 0 && square(left) > square(radius) * squared;
      };
      CHECK(is_apart(S(0)));
      if (time.value) {
        CHECK(*time.value < limit);
        CHECK(is_apart(*time.value));
        CHECK_FALSE(is_apart(*time.value + S::assume_raw(1)));
      } else {
        CHECK(is_apart(limit));
        ++past;
      }
    };
    check(height);
    // Next to a time on the grid.
    using Little = Fixed<20, S::frac + 30>;
    const auto t = nearest_to<S>(abs(draw_number<S>(random, bits)));
    check(speed * t + radius + radius * half(squared - decltype(squared)(1)) +
          Little::assume_raw(static_cast<typename Little::raw_type>(random.between(-5000, 5000))));
  }
  CHECK(sure > 3000);
  CHECK(past > 100);
}

}  // namespace
}  // namespace detent::test
