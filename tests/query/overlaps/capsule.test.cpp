// SPDX-License-Identifier: MIT
#include "query/overlaps/helpers.hpp"

namespace detent::test {
namespace {

static_assert(overlaps(Capsule<q16_16, 3>{{}, {}, q16_16(1)}, Aabb<q16_16, 3>{}));
static_assert(!overlaps(Capsule<q16_16, 2>{{}, {}, q16_16(-1)}, Aabb<q16_16, 2>{}));

/// Its surface contains (12, 5), (5, 6) and (-4, 1).
template <Scalar S, int N>
const Capsule<S, N> pill{at<S, N>(1, 1), at<S, N>(9, 1), num<S>(5)};

template <Scalar S, int N>
Capsule<S, N> empty_pill() {
  return {pill<S, N>.a, pill<S, N>.b, num<S>(-1)};
}

TEMPLATE_TEST_CASE("overlaps, aabb and capsule: corner, face, through, inside", "[overlaps]",
                   DETENT_EVERY_SPACE) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  using Box = Aabb<S, N>;
  const auto& capsule = pill<S, N>;
  CHECK(meet(Box{at<S, N>(12, 5), at<S, N>(20, 20)}, capsule));
  CHECK_FALSE(meet(Box{at<S, N>(12.5, 5), at<S, N>(20, 20)}, capsule));
  CHECK(meet(Box{at<S, N>(3, -9, -1), at<S, N>(4, -4, 1)}, capsule));
  CHECK_FALSE(meet(Box{at<S, N>(3, -9, -1), at<S, N>(4, -4.5, 1)}, capsule));
  CHECK(meet(Box{at<S, N>(4, -50, -50), at<S, N>(5, 50, 50)}, capsule));
  CHECK(meet(Box{at<S, N>(-50, -50, -50), at<S, N>(50, 50, 50)}, capsule));
  CHECK(meet(Box{at<S, N>(4, 1), at<S, N>(5, 2)}, capsule));
  CHECK(meet(Box{at<S, N>(5, 6), at<S, N>(5, 6)}, capsule));
  CHECK_FALSE(meet(Box{at<S, N>(5, 6.5), at<S, N>(5, 6.5)}, capsule));
  // Past a corner, where neither end is closest.
  const Box corner{at<S, N>(8, -8, -1), at<S, N>(16, 0, 1)};
  CHECK(meet(corner, Capsule<S, N>{{}, at<S, N>(12, 12), num<S>(6)}));
  CHECK_FALSE(meet(corner, Capsule<S, N>{{}, at<S, N>(12, 12), num<S>(5)}));
  CHECK(meet(corner, Capsule<S, N>{{}, at<S, N>(16, 0), num<S>(0)}));
  CHECK_FALSE(overlaps(Box{at<S, N>(5, 1), at<S, N>(4, 1)}, capsule));
  CHECK_FALSE(meet(Box{{}, at<S, N>(9, 9)}, empty_pill<S, N>()));
}

TEMPLATE_TEST_CASE("overlaps, obb and capsule: the slabs within the radius, in their frame",
                   "[overlaps]", DETENT_EVERY_SPACE) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  const auto& capsule = pill<S, N>;
  Obb<S, N> box{at<S, N>(16, 7), at<S, N>(4, 2), {}};
  CHECK(meet(box, capsule));
  box.half_extents = at<S, N>(3.5, 2);
  CHECK_FALSE(meet(box, capsule));
  CHECK(meet(Obb<S, N>{at<S, N>(5, 10), at<S, N>(1, 4), {}}, capsule));
  CHECK_FALSE(meet(Obb<S, N>{at<S, N>(5, 10), at<S, N>(1, 3.5), {}}, capsule));
  CHECK(meet(Obb<S, N>{at<S, N>(5, 1), {}, {}}, capsule));
  CHECK(meet(Obb<S, N>{at<S, N>(0, 0), filled<S, N>(num<S>(50)), {}}, capsule));
  CHECK_FALSE(meet(Obb<S, N>{at<S, N>(5, 1), at<S, N>(-1, 9, 9), {}}, capsule));
  CHECK_FALSE(meet(Obb<S, N>{at<S, N>(5, 1), at<S, N>(9, 9, 9), {}}, empty_pill<S, N>()));
}

TEMPLATE_TEST_CASE("overlaps, plane and capsule: between its ends or within the radius of one",
                   "[overlaps]", DETENT_EVERY_SPACE) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  const auto& capsule = pill<S, N>;
  const auto x = Direction<S, N>::along(0), y = Direction<S, N>::along(1);
  CHECK(meet(Plane<S, N>{x, num<S>(5)}, capsule));
  CHECK(meet(Plane<S, N>{x, num<S>(14)}, capsule));
  CHECK_FALSE(meet(Plane<S, N>{x, num<S>(14.5)}, capsule));
  CHECK(meet(Plane<S, N>{y, num<S>(6)}, capsule));
  CHECK_FALSE(meet(Plane<S, N>{y, num<S>(6.5)}, capsule));
  CHECK_FALSE(meet(Plane<S, N>{-y, num<S>(4.5)}, capsule));
  CHECK(meet(Plane<S, N>{x, num<S>(5)}, Capsule<S, N>{capsule.a, capsule.b, num<S>(0)}));
  CHECK(meet(Plane<S, N>{x, num<S>(9)}, Capsule<S, N>{capsule.a, capsule.b, num<S>(0)}));
  CHECK_FALSE(meet(Plane<S, N>{x, num<S>(9.5)}, Capsule<S, N>{capsule.a, capsule.b, num<S>(0)}));
  CHECK_FALSE(meet(Plane<S, N>{x, num<S>(5)}, empty_pill<S, N>()));
}

TEMPLATE_TEST_CASE("overlaps, triangle and capsule: pierced, edge, face, collapsed", "[overlaps]",
                   DETENT_EVERY_SPACE) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  using Corners = Triangle<S, N>;
  const auto& capsule = pill<S, N>;
  CHECK(meet(Corners{at<S, N>(5, -50, -50), at<S, N>(5, 50, -50), at<S, N>(5, 0, 50)}, capsule));
  CHECK(meet(Corners{at<S, N>(3, 6), at<S, N>(7, 6), at<S, N>(5, 20)}, capsule));
  CHECK_FALSE(meet(Corners{at<S, N>(3, 6.5), at<S, N>(7, 6.5), at<S, N>(5, 20)}, capsule));
  CHECK(meet(Corners{at<S, N>(12, 5), at<S, N>(20, 5), at<S, N>(20, 20)}, capsule));
  const auto above = [](double z) {
    return Corners{at<S, N>(-60, -60, z), at<S, N>(60, -60, z), at<S, N>(0, 90, z)};
  };
  CHECK(meet(above(5), capsule));
  CHECK(meet(above(5.5), capsule) == (N == 2));
  CHECK(meet(above(0), Capsule<S, N>{capsule.a, capsule.a, num<S>(0)}));
  CHECK_FALSE(meet(above(0), empty_pill<S, N>()));
  CHECK(meet(Corners{at<S, N>(5, 6), at<S, N>(5, 8), at<S, N>(5, 20)}, capsule));
  CHECK_FALSE(meet(Corners{at<S, N>(5, 6.5), at<S, N>(5, 8), at<S, N>(5, 20)}, capsule));
  CHECK(meet(Corners{at<S, N>(5, 6), at<S, N>(5, 6), at<S, N>(5, 6)}, capsule));
}

TEMPLATE_TEST_CASE("overlaps, capsules: their segments within the sum of the radii", "[overlaps]",
                   DETENT_EVERY_SPACE) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  using Pill = Capsule<S, N>;
  const auto& capsule = pill<S, N>;
  CHECK(meet(capsule, Pill{at<S, N>(1, 11), at<S, N>(9, 11), num<S>(5)}));
  CHECK_FALSE(meet(capsule, Pill{at<S, N>(1, 11.5), at<S, N>(9, 11.5), num<S>(5)}));
  CHECK(meet(capsule, Pill{at<S, N>(15, 9), at<S, N>(20, 20), num<S>(5)}));
  CHECK_FALSE(meet(capsule, Pill{at<S, N>(15.5, 9), at<S, N>(20, 20), num<S>(5)}));
  CHECK(meet(capsule, Pill{at<S, N>(5, -9, 10), at<S, N>(5, 11, 10), num<S>(5)}));
  CHECK(meet(capsule, Pill{at<S, N>(5, -9, 10.5), at<S, N>(5, 11, 10.5), num<S>(5)}) == (N == 2));
  CHECK(meet(capsule, Pill{at<S, N>(4, 1), at<S, N>(5, 1), num<S>(1)}));
  const Pill thin{capsule.a, capsule.b, num<S>(0)};
  CHECK(meet(thin, Pill{at<S, N>(5, -9), at<S, N>(5, 11), num<S>(0)}));
  CHECK(meet(thin, Pill{at<S, N>(9, 1), at<S, N>(20, 1), num<S>(0)}));
  CHECK_FALSE(meet(thin, Pill{at<S, N>(9.5, 1), at<S, N>(20, 1), num<S>(0)}));
  CHECK(meet(Pill{capsule.a, capsule.a, num<S>(0)}, Pill{capsule.a, capsule.a, num<S>(0)}));
  CHECK_FALSE(meet(capsule, empty_pill<S, N>()));
}

TEMPLATE_TEST_CASE("intersects, segment and capsule: through, along, inside, no length",
                   "[intersects]", DETENT_EVERY_SPACE) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  using Line = Segment<S, N>;
  const auto& capsule = pill<S, N>;
  CHECK(meet(Line{at<S, N>(5, -20), at<S, N>(5, 20)}, capsule));
  CHECK(meet(Line{at<S, N>(5, 6), at<S, N>(5, 20)}, capsule));
  CHECK_FALSE(meet(Line{at<S, N>(5, 6.5), at<S, N>(5, 20)}, capsule));
  CHECK(meet(Line{at<S, N>(-20, 6), at<S, N>(20, 6)}, capsule));
  CHECK_FALSE(meet(Line{at<S, N>(-20, 6.5), at<S, N>(20, 6.5)}, capsule));
  CHECK(meet(Line{at<S, N>(2, 1), at<S, N>(3, 1)}, capsule));
  CHECK(meet(Line{at<S, N>(12, 5), at<S, N>(12, 5)}, capsule));
  CHECK_FALSE(meet(Line{at<S, N>(12, 5.5), at<S, N>(12, 5.5)}, capsule));
  CHECK_FALSE(meet(Line{at<S, N>(2, 1), at<S, N>(3, 1)}, empty_pill<S, N>()));
}

TEMPLATE_TEST_CASE("overlaps, capsule: one raw unit decides, at the ends of the domain too",
                   "[overlaps]", DETENT_FIXED_SPACES) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  const auto low = S::lowest(), high = S::max();
  const Capsule<S, N> diagonal{filled<S, N>(low), filled<S, N>(high), S(0)};
  CHECK(meet(diagonal, diagonal));
  auto corner = filled<S, N>(low);
  corner.x = high;
  // Two opposite edges of the world, one raw unit farther apart than twice the radius.
  auto beam = Capsule<S, N>{filled<S, N>(low), corner, high};
  auto opposite = Capsule<S, N>{filled<S, N>(high), filled<S, N>(high), high};
  for (int i = 2; i < N; ++i) opposite.a[i] = opposite.b[i] = low;
  CHECK_FALSE(meet(beam, opposite));
  opposite.a.y = opposite.b.y = moved(high, -1);
  CHECK(meet(beam, opposite));
  CHECK(meet(Aabb<S, N>{filled<S, N>(low), filled<S, N>(high)}, diagonal));
  CHECK(meet(Plane<S, N>{Direction<S, N>::along(0), high}, diagonal));
  CHECK(meet(Segment<S, N>{filled<S, N>(high), corner}, diagonal));

  // The box as stored: its first axis is too long, so it is thinner, by less than a raw unit.
  const Capsule<S, N> capsule{at<S, N>(-1, 7), at<S, N>(7, 1), num<S>(5)};
  Obb<S, N> box{at<S, N>(9, 12), filled<S, N>(num<S>(50)), three_four_fifths_frame<S, N>()};
  box.half_extents.x = num<S>(5);
  CHECK_FALSE(overlaps(box, capsule));
  box.half_extents.x = moved(num<S>(5), 1);
  CHECK(overlaps(box, capsule));
}

}  // namespace
}  // namespace detent::test
