// SPDX-License-Identifier: MIT
#include "query/overlaps/helpers.hpp"

namespace detent::test {
namespace {

static_assert(overlaps(Plane<q16_16, 3>{}, Plane<q16_16, 3>{}));
static_assert(!overlaps(Plane<q16_16, 2>{}, Plane<q16_16, 2>{{}, q16_16(1)}));

TEMPLATE_TEST_CASE("overlaps, aabb and plane: through, face, corner, flat, empty", "[overlaps]",
                   DETENT_EVERY_SPACE) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  const Aabb<S, N> box{at<S, N>(-4, -2, -1), at<S, N>(4, 2, 1)};
  const auto x = Direction<S, N>::along(0);
  CHECK(meet(box, Plane<S, N>{x, num<S>(0)}));
  CHECK(meet(box, Plane<S, N>{x, num<S>(4)}));
  CHECK(meet(box, Plane<S, N>{-x, num<S>(4)}));
  CHECK_FALSE(meet(box, Plane<S, N>{x, num<S>(4.5)}));
  CHECK_FALSE(meet(box, Plane<S, N>{x, num<S>(-4.5)}));
  const auto slanted = toward<S, N>(1, -1);  // the corner (4, -2) is at 4.24
  CHECK(meet(box, Plane<S, N>{slanted, num<S>(4)}));
  CHECK_FALSE(meet(box, Plane<S, N>{slanted, num<S>(4.5)}));
  CHECK(meet(Aabb<S, N>{at<S, N>(3, 1), at<S, N>(3, 1)}, Plane<S, N>{x, num<S>(3)}));
  CHECK_FALSE(meet(Aabb<S, N>{at<S, N>(3, 1), at<S, N>(3, 1)}, Plane<S, N>{x, num<S>(2)}));
  CHECK_FALSE(overlaps(Aabb<S, N>{at<S, N>(1, 1), at<S, N>(-1, 1)}, Plane<S, N>{x, num<S>(0)}));
}

TEMPLATE_TEST_CASE("overlaps, obb and plane: through, face, corner, flat, empty", "[overlaps]",
                   DETENT_EVERY_SPACE) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  const auto x = Direction<S, N>::along(0);
  const Obb<S, N> box{at<S, N>(1, 1), at<S, N>(3, 2, 1), {}};
  CHECK(meet(box, Plane<S, N>{x, num<S>(1)}));
  CHECK(meet(box, Plane<S, N>{x, num<S>(4)}));
  CHECK(meet(box, Plane<S, N>{-x, num<S>(2)}));
  CHECK_FALSE(meet(box, Plane<S, N>{x, num<S>(4.5)}));
  const auto slanted = toward<S, N>(1, 1);  // from -2.12 to 4.95
  CHECK(meet(box, Plane<S, N>{slanted, num<S>(4.5)}));
  CHECK_FALSE(meet(box, Plane<S, N>{slanted, num<S>(5)}));
  CHECK(meet(box, Plane<S, N>{slanted, num<S>(-2)}));
  CHECK_FALSE(meet(box, Plane<S, N>{slanted, num<S>(-2.25)}));
  CHECK(meet(Obb<S, N>{at<S, N>(1, 1), {}, {}}, Plane<S, N>{x, num<S>(1)}));
  CHECK_FALSE(meet(Obb<S, N>{at<S, N>(1, 1), {}, {}}, Plane<S, N>{x, num<S>(2)}));
  CHECK_FALSE(meet(Obb<S, N>{{}, at<S, N>(9, -1, 9), {}}, Plane<S, N>{x, num<S>(0)}));
}

TEMPLATE_TEST_CASE("overlaps, planes: only parallel ones can miss", "[overlaps]",
                   DETENT_EVERY_SPACE) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  const auto x = Direction<S, N>::along(0), slanted = toward<S, N>(1, 2);
  const auto three = num<S>(3), four = num<S>(4), behind = num<S>(-3);
  CHECK(meet(Plane<S, N>{x, three}, Plane<S, N>{slanted, four}));
  CHECK(meet(Plane<S, N>{slanted, three}, Plane<S, N>{slanted, three}));
  CHECK_FALSE(meet(Plane<S, N>{slanted, three}, Plane<S, N>{slanted, four}));
  CHECK(meet(Plane<S, N>{slanted, three}, Plane<S, N>{-slanted, behind}));
  CHECK_FALSE(meet(Plane<S, N>{slanted, three}, Plane<S, N>{-slanted, three}));
}

TEMPLATE_TEST_CASE("overlaps, plane and triangle: through, corner, within, collapsed", "[overlaps]",
                   DETENT_EVERY_SPACE) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  const Triangle<S, N> triangle{at<S, N>(0, 0), at<S, N>(8, 0), at<S, N>(2, 4)};
  const auto x = Direction<S, N>::along(0), y = Direction<S, N>::along(1);
  CHECK(meet(Plane<S, N>{x, num<S>(5)}, triangle));
  CHECK(meet(Plane<S, N>{x, num<S>(8)}, triangle));
  CHECK_FALSE(meet(Plane<S, N>{x, num<S>(8.5)}, triangle));
  CHECK(meet(Plane<S, N>{-x, num<S>(0)}, triangle));
  CHECK_FALSE(meet(Plane<S, N>{-x, num<S>(0.5)}, triangle));
  CHECK(meet(Plane<S, N>{y, num<S>(0)}, triangle));
  CHECK(meet(Plane<S, N>{Direction<S, N>::along(N - 1), num<S>(0)}, triangle));
  const Triangle<S, N> point{triangle.c, triangle.c, triangle.c};
  CHECK(meet(Plane<S, N>{y, num<S>(4)}, point));
  CHECK_FALSE(meet(Plane<S, N>{y, num<S>(3)}, point));
}

TEMPLATE_TEST_CASE("overlaps, plane: one raw unit decides, at the ends of the domain too",
                   "[overlaps]", DETENT_FIXED_SPACES) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  const auto x = Direction<S, N>::along(0);
  const auto low = filled<S, N>(S::lowest()), high = filled<S, N>(S::max());
  const auto beside = filled<S, N>(moved(S::max(), -1));
  const Plane<S, N> last{x, S::max()};
  CHECK(meet(Aabb<S, N>{low, high}, last));
  CHECK_FALSE(meet(Aabb<S, N>{low, beside}, last));
  CHECK(meet(Obb<S, N>{{}, high, {}}, last));
  CHECK_FALSE(meet(Obb<S, N>{{}, beside, {}}, last));
  CHECK(meet(last, Triangle<S, N>{low, beside, high}));
  CHECK_FALSE(meet(last, Triangle<S, N>{low, beside, low}));
  CHECK_FALSE(meet(last, Plane<S, N>{x, S::lowest()}));
  CHECK_FALSE(meet(last, Plane<S, N>{-x, S::lowest()}));
  // Normals of slightly different length, with offsets in the same ratio.
  using Component = typename Direction<S, N>::Component;
  const auto one = Component(1), shorter = moved(one, -1);
  auto normal = x.vec();
  normal.x = shorter;
  const auto offset = S::from_raw(one.raw()), as_short = S::from_raw(shorter.raw());
  if (offset.raw() != one.raw()) return;
  const Plane<S, N> a{x, offset}, b{Direction<S, N>::assume_unit(normal), as_short};
  CHECK(meet(a, b));
  CHECK_FALSE(meet(a, Plane<S, N>{b.normal, offset}));
  CHECK(meet(Plane<S, N>{x, S(0)}, Plane<S, N>{-b.normal, S(0)}));
}

}  // namespace
}  // namespace detent::test
