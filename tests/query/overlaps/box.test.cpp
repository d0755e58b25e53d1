// SPDX-License-Identifier: MIT
#include "query/overlaps/helpers.hpp"

namespace detent::test {
namespace {

static_assert(overlaps(Aabb<q16_16, 3>{}, Obb<q16_16, 3>{}));
static_assert(overlaps(Obb<q16_16, 2>{}, Obb<q16_16, 2>{}));

/// All axes along x: a segment whose half length is the sum of the half extents.
template <Scalar S, int N>
Rotation<S, N> along_x() {
  std::array<Direction<S, N>, static_cast<std::size_t>(N)> axes;
  axes[1] = -axes[1];
  return Rotation<S, N>::from_axes(axes);
}

TEMPLATE_TEST_CASE("overlaps, aabbs: inside, face, corner, flat, empty", "[overlaps]",
                   DETENT_EVERY_SPACE) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  using Box = Aabb<S, N>;
  const Box box{at<S, N>(-4, -2, -1), at<S, N>(4, 2, 1)};
  CHECK(meet(box, box));
  CHECK(meet(box, Box{at<S, N>(-1, -1), at<S, N>(1, 1)}));
  CHECK(meet(box, Box{at<S, N>(4, 0), at<S, N>(9, 1)}));
  CHECK_FALSE(meet(box, Box{at<S, N>(4.5, 0), at<S, N>(9, 1)}));
  CHECK(meet(box, Box{at<S, N>(4, 2, 1), at<S, N>(9, 9, 9)}));
  CHECK_FALSE(meet(box, Box{at<S, N>(4, 2.5, 1), at<S, N>(9, 9, 9)}));
  CHECK(meet(box, Box{at<S, N>(-9, 0), at<S, N>(9, 0)}));
  CHECK(meet(box, Box{at<S, N>(1, 1), at<S, N>(1, 1)}));
  CHECK_FALSE(meet(box, Box{at<S, N>(1, 3), at<S, N>(1, 3)}));
  CHECK_FALSE(overlaps(box, Box{at<S, N>(1, 1), at<S, N>(-1, 1)}));
  CHECK_FALSE(overlaps(Box{at<S, N>(1, 1), at<S, N>(1, -1)}, box));
}

TEMPLATE_TEST_CASE("overlaps, aabb and obb: face, corner, inside, flat, empty", "[overlaps]",
                   DETENT_EVERY_SPACE) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  using Box = Aabb<S, N>;
  const Obb<S, N> plain{at<S, N>(1, 1), at<S, N>(3, 2, 1), {}};
  CHECK(meet(Box{at<S, N>(4, 0), at<S, N>(9, 9)}, plain));
  CHECK_FALSE(meet(Box{at<S, N>(4.5, 0), at<S, N>(9, 9)}, plain));
  CHECK(meet(Box{at<S, N>(4, 3), at<S, N>(9, 9)}, plain));
  CHECK_FALSE(meet(Box{at<S, N>(4, 3.5), at<S, N>(9, 9)}, plain));
  CHECK(meet(Box{at<S, N>(1, 1), at<S, N>(1, 1)}, plain));
  CHECK(meet(Box{at<S, N>(-50, -50, -50), at<S, N>(50, 50, 50)}, plain));
  const Obb<S, N> turned_box{
      {}, filled<S, N>(num<S>(1)), frame<S, N>(toward<S, N>(1, 1), toward<S, N>(-1, 1))};
  CHECK(meet(Box{at<S, N>(1.25, -1), at<S, N>(9, 1)}, turned_box));
  CHECK_FALSE(meet(Box{at<S, N>(1.5, -1), at<S, N>(9, 1)}, turned_box));
  CHECK_FALSE(meet(Box{at<S, N>(1, 1), at<S, N>(9, 9)}, turned_box));
  CHECK(meet(Box{at<S, N>(0.5, 0.5), at<S, N>(9, 9)}, turned_box));
  const Obb<S, N> line{at<S, N>(1, 1), at<S, N>(1, 2, 4), along_x<S, N>()};
  const double end = N == 2 ? 4 : 8;
  CHECK(meet(Box{at<S, N>(end, 1), at<S, N>(9, 9)}, line));
  CHECK_FALSE(meet(Box{at<S, N>(end + 0.5, 1), at<S, N>(9, 9)}, line));
  CHECK_FALSE(meet(Box{at<S, N>(0, 1.5), at<S, N>(9, 9)}, line));
  CHECK_FALSE(overlaps(Box{at<S, N>(1, 1), at<S, N>(0, 1)}, plain));
  CHECK_FALSE(meet(Box{{}, at<S, N>(1, 1)}, Obb<S, N>{at<S, N>(1, 1), at<S, N>(3, -1, 1), {}}));
}

TEMPLATE_TEST_CASE("overlaps, obbs: face, corner, inside, far, flat, empty", "[overlaps]",
                   DETENT_EVERY_SPACE) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  using Box = Obb<S, N>;
  const auto unit = filled<S, N>(num<S>(1));
  const auto diamond = frame<S, N>(toward<S, N>(1, 1), toward<S, N>(-1, 1));
  const Box box{{}, unit, {}};
  CHECK(meet(box, Box{at<S, N>(2, 2), unit, {}}));
  CHECK_FALSE(meet(box, Box{at<S, N>(2.25, 0), unit, {}}));
  CHECK_FALSE(meet(box, Box{at<S, N>(1000, 0), unit, {}}));
  CHECK(meet(box, Box{at<S, N>(2.25, 0), unit, diamond}));
  CHECK_FALSE(meet(box, Box{at<S, N>(2.5, 0), unit, diamond}));
  CHECK_FALSE(meet(box, Box{at<S, N>(2, 2), unit, diamond}));
  CHECK(meet(box, Box{at<S, N>(0.5, 0), {}, diamond}));
  CHECK(meet(box, Box{{}, filled<S, N>(num<S>(9)), diamond}));
  CHECK_FALSE(meet(box, Box{{}, at<S, N>(1, -1, 1), {}}));
  // Both are segments on the x axis, 3 or 7 to either side of their centers.
  const auto line = [](double x, double y) {
    return Box{at<S, N>(x, y), at<S, N>(1, 2, 4), along_x<S, N>()};
  };
  const double length = N == 2 ? 6 : 14;
  CHECK(meet(line(0, 0), line(length, 0)));
  CHECK_FALSE(meet(line(0, 0), line(length + 0.5, 0)));
  CHECK_FALSE(meet(line(0, 0), line(0, 0.5)));
  CHECK(meet(line(1.5, 0.5), box));
  CHECK_FALSE(meet(line(1.5, 1.5), box));
}

TEMPLATE_TEST_CASE("overlaps, obbs: edge against edge", "[overlaps]", q16_16, q14_16, q24_8, q8_8,
                   float, double) {
  using S = TestType;
  // A roof over a valley: only the cross product of the two edges separates the boxes.
  const auto box = [](const Vec<S, 3>& center, const std::array<Direction<S, 3>, 3>& axes) {
    return Obb<S, 3>{center, filled<S, 3>(num<S>(1)), Rotation<S, 3>::from_axes(axes)};
  };
  const auto lower =
      box({}, {Direction<S, 3>::along(0), toward<S, 3>(0, 1, 1), toward<S, 3>(0, -1, 1)});
  const auto upper = [&](double z) {
    return box(at<S, 3>(0, 0, z),
               {toward<S, 3>(1, 0, 1), Direction<S, 3>::along(1), toward<S, 3>(-1, 0, 1)});
  };
  CHECK(meet(lower, upper(2.75)));
  CHECK_FALSE(meet(lower, upper(3)));
}

TEMPLATE_TEST_CASE("overlaps, boxes: one raw unit decides, at the ends of the domain too",
                   "[overlaps]", DETENT_FIXED_SPACES) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  const auto low = filled<S, N>(S::lowest()), high = filled<S, N>(S::max());
  const auto beside = filled<S, N>(moved(S::max(), -1));
  CHECK(meet(Aabb<S, N>{low, high}, Aabb<S, N>{high, high}));
  CHECK_FALSE(meet(Aabb<S, N>{low, beside}, Aabb<S, N>{high, high}));
  CHECK(meet(Aabb<S, N>{high, high}, Obb<S, N>{{}, high, {}}));
  CHECK_FALSE(meet(Aabb<S, N>{high, high}, Obb<S, N>{{}, beside, {}}));
  CHECK_FALSE(meet(Aabb<S, N>{low, low}, Obb<S, N>{{}, high, {}}));
  CHECK(meet(Obb<S, N>{low, high, {}}, Obb<S, N>{filled<S, N>(moved(S(0), -1)), {}, {}}));
  CHECK_FALSE(meet(Obb<S, N>{low, high, {}}, Obb<S, N>{{}, {}, {}}));
  // The segment through (3, 4), with a corner on it and next to it.
  const Obb<S, N> line{{}, at<S, N>(10), three_four_fifths_frame<S, N>()};
  auto corner = at<S, N>(3, 4);
  CHECK(meet(Aabb<S, N>{corner, at<S, N>(9, 4)}, line));
  CHECK(meet(Obb<S, N>{corner, {}, {}}, line));
  corner.x = moved(corner.x, 1);
  CHECK_FALSE(meet(Aabb<S, N>{corner, at<S, N>(9, 4)}, line));
  CHECK_FALSE(meet(Obb<S, N>{corner, {}, {}}, line));
}

}  // namespace
}  // namespace detent::test
