// SPDX-License-Identifier: MIT
#include <cstdlib>

#include "query/overlaps/helpers.hpp"

namespace detent::test {
namespace {

static_assert(overlaps(Triangle<q16_16, 3>{}, Triangle<q16_16, 3>{}));
static_assert(overlaps(Triangle<q16_16, 2>{}, Aabb<q16_16, 2>{}));

template <Scalar S, int N>
const auto wedge = right_triangle<S, N>();

TEMPLATE_TEST_CASE("overlaps, aabb and triangle: corner, edge, face, inside, collapsed, empty",
                   "[overlaps]", DETENT_EVERY_SPACE) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  using Box = Aabb<S, N>;
  const auto& triangle = wedge<S, N>;
  CHECK(meet(Box{at<S, N>(1, 1), at<S, N>(2, 2)}, triangle));
  CHECK(meet(Box{at<S, N>(8, 0), at<S, N>(9, 9)}, triangle));
  CHECK_FALSE(meet(Box{at<S, N>(8.5, 0), at<S, N>(9, 9)}, triangle));
  CHECK(meet(Box{at<S, N>(4, 4), at<S, N>(9, 9)}, triangle));
  CHECK_FALSE(meet(Box{at<S, N>(4, 4.5), at<S, N>(9, 9)}, triangle));
  CHECK(meet(Box{at<S, N>(-50, -50, -50), at<S, N>(50, 50, 50)}, triangle));
  CHECK(meet(Box{at<S, N>(1, 1, 0), at<S, N>(2, 2, 5)}, triangle));
  CHECK(meet(Box{at<S, N>(1, 1, 0.5), at<S, N>(2, 2, 5)}, triangle) == (N == 2));
  CHECK(meet(Box{at<S, N>(2, 2), at<S, N>(2, 2)}, triangle));
  CHECK_FALSE(overlaps(Box{at<S, N>(2, 1), at<S, N>(1, 2)}, triangle));
  // Collinear, and one point.
  const Triangle<S, N> line{at<S, N>(0, 0), at<S, N>(8, 8), at<S, N>(4, 4)};
  CHECK(meet(Box{at<S, N>(2, -1), at<S, N>(9, 2)}, line));
  CHECK_FALSE(meet(Box{at<S, N>(2.5, -1), at<S, N>(9, 2)}, line));
  CHECK(meet(Box{at<S, N>(2, -1), at<S, N>(9, 2)}, Triangle<S, N>{line.a, line.a, line.b}));
  const Triangle<S, N> point{line.c, line.c, line.c};
  CHECK(meet(Box{at<S, N>(4, 4), at<S, N>(5, 5)}, point));
  CHECK_FALSE(meet(Box{at<S, N>(4.5, 4), at<S, N>(5, 5)}, point));
}

TEMPLATE_TEST_CASE("overlaps, obb and triangle: corner, edge, face, inside, collapsed, empty",
                   "[overlaps]", DETENT_EVERY_SPACE) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  using Box = Obb<S, N>;
  const auto& triangle = wedge<S, N>;
  const auto unit = filled<S, N>(num<S>(1));
  CHECK(meet(Box{at<S, N>(2, 2), unit, {}}, triangle));
  CHECK(meet(Box{at<S, N>(9, 1), unit, {}}, triangle));
  CHECK_FALSE(meet(Box{at<S, N>(9.5, 1), unit, {}}, triangle));
  CHECK(meet(Box{at<S, N>(5, 5), unit, {}}, triangle));
  CHECK_FALSE(meet(Box{at<S, N>(5, 5.5), unit, {}}, triangle));
  CHECK(meet(Box{{}, filled<S, N>(num<S>(50)), {}}, triangle));
  CHECK(meet(Box{at<S, N>(2, 2, 1.5), unit, {}}, triangle) == (N == 2));
  CHECK(meet(Box{at<S, N>(2, 2), {}, {}}, triangle));
  CHECK_FALSE(meet(Box{at<S, N>(2, 2), at<S, N>(-1, 1, 1), {}}, triangle));
  const std::array<Direction<S, N>, static_cast<std::size_t>(N)> axes;
  const Box line{at<S, N>(9, 0), at<S, N>(0.5, 0.5), Rotation<S, N>::from_axes(axes)};
  CHECK(meet(line, triangle));
  CHECK_FALSE(meet(Box{at<S, N>(9.5, 0), line.half_extents, line.rotation}, triangle));
  CHECK_FALSE(meet(Box{at<S, N>(8.5, 1), line.half_extents, line.rotation}, triangle));
  const Triangle<S, N> behind{at<S, N>(10.5, 0), at<S, N>(12, 0), at<S, N>(11, 0)};
  CHECK_FALSE(meet(line, behind));
  CHECK(meet(line, Triangle<S, N>{at<S, N>(10, 0), behind.b, behind.c}));
  CHECK(meet(Box{at<S, N>(5.25, 4), unit, heading<S, N>(1, 1)}, triangle));
  CHECK_FALSE(meet(Box{at<S, N>(5.5, 4), unit, heading<S, N>(1, 1)}, triangle));
}

TEMPLATE_TEST_CASE("overlaps, triangles: edge, corner, inside, pierced, collapsed", "[overlaps]",
                   DETENT_EVERY_SPACE) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  using Corners = Triangle<S, N>;
  const auto& triangle = wedge<S, N>;
  CHECK(meet(triangle, triangle));
  CHECK(meet(triangle, Corners{at<S, N>(1, 1), at<S, N>(3, 1), at<S, N>(1, 3)}));
  CHECK(meet(triangle, Corners{at<S, N>(4, 4), at<S, N>(9, 4), at<S, N>(9, 9)}));
  CHECK_FALSE(meet(triangle, Corners{at<S, N>(4.5, 4), at<S, N>(9, 4), at<S, N>(9, 9)}));
  CHECK(meet(triangle, Corners{at<S, N>(8, 0), at<S, N>(9, -9), at<S, N>(9, 9)}));
  CHECK(meet(triangle, Corners{at<S, N>(3, -9), at<S, N>(4, -9), at<S, N>(3, 20)}));
  CHECK(meet(triangle, Corners{at<S, N>(2, 2, -1), at<S, N>(2, 2, 9), at<S, N>(30, 30, 9)}));
  CHECK(meet(triangle, Corners{at<S, N>(2, 2, 1), at<S, N>(2, 2, 9), at<S, N>(30, 30, 9)}) ==
        (N == 2));
  CHECK(meet(triangle, Corners{at<S, N>(2, 2), at<S, N>(3, 3), at<S, N>(30, 30)}));
  CHECK_FALSE(meet(triangle, Corners{at<S, N>(5, 5), at<S, N>(6, 6), at<S, N>(30, 30)}));
  const auto inside = at<S, N>(1, 2), outside = at<S, N>(5, 4);
  CHECK(meet(triangle, Corners{inside, inside, inside}));
  CHECK_FALSE(meet(triangle, Corners{outside, outside, outside}));
  CHECK(meet(Corners{inside, inside, inside}, Corners{inside, inside, inside}));
  CHECK_FALSE(meet(Corners{inside, inside, inside}, Corners{outside, outside, outside}));
  // Small and far apart: products of edges round to zero.
  const double s = 1.0 / 256;
  const auto small = [s](double x, double z) {
    return Corners{at<S, N>(x, 0, z), at<S, N>(x + s, 0, z), at<S, N>(x, s, z)};
  };
  CHECK_FALSE(meet(small(0, 0), small(5, 0)));
  CHECK(meet(small(0, 0), small(0, 5)) == (N == 2));
}

TEMPLATE_TEST_CASE("overlaps, triangle: one raw unit decides, at the ends of the domain too",
                   "[overlaps]", DETENT_FIXED_SPACES) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  const auto [low, side, high] = half_domain<S, N>();
  const Triangle<S, N> half{low, side, high};
  auto point = Vec<S, N>();
  point.x = moved(S(0), -1);
  for (const auto& p : {Vec<S, N>(), point}) {
    const bool inside = p == Vec<S, N>();
    CHECK(meet(Aabb<S, N>{p, p}, half) == inside);
    CHECK(meet(Obb<S, N>{p, {}, {}}, half) == inside);
    CHECK(meet(half, Triangle<S, N>{p, p, p}) == inside);
  }
  CHECK(meet(Aabb<S, N>{low, high}, half));
  CHECK(meet(Obb<S, N>{{}, high, {}}, half));
  CHECK(meet(Obb<S, N>{high, high, {}}, Triangle<S, N>{low, low, Vec<S, N>()}));
  CHECK_FALSE(meet(Obb<S, N>{high, high, {}}, Triangle<S, N>{low, low, filled<S, N>(point.x)}));
}

/// Random bits of every length, up to the type's full width.
template <Number T>
T random_number(Random& random) {
  using Raw = typename T::raw_type;
  const int above = static_cast<int>(random.below(static_cast<std::uint64_t>(T::bits - 61)));
  return T::from_raw(shift_left(integer_cast<Raw>(random.wide(62)), above));
}

TEST_CASE("overlaps, obb and triangle: narrow and wide integers give the same result",
          "[overlaps]") {
  using Half = Fixed<31, 16>;
  Random random(0x0bb7);
  HitRate rate;
  for (int i = 0; i < 4000; ++i) {
    const auto half = make_vec<3>(
        [&](int) { return Half::from_raw(static_cast<std::int32_t>(std::abs(random.wide(31)))); });
    const auto height = random_number<Fixed<94, 48>>(random);
    const auto along = make_vec<3>([&](int) { return random_number<Fixed<94, 62>>(random); });
    const Fixed<99, 48> wide_height(height);
    const auto wide_along = make_vec<3>([&](int k) { return Fixed<97, 62>(along[k]); });
    const bool answer = detail::is_beyond(height, along, half);
    INFO(random << ", case " << i);
    CHECK(detail::is_beyond(wide_height, wide_along, half) == answer);
    rate.count(answer);
  }
  INFO(rate);
  CHECK(rate.is_balanced());
}

}  // namespace
}  // namespace detent::test
