// SPDX-License-Identifier: MIT
#include "math/frames.hpp"
#include "query/overlaps/hulls.hpp"

namespace detent::test {
namespace {

TEMPLATE_TEST_CASE("overlaps, box and hull: hit, miss, touch, flat, empty", "[overlaps]",
                   DETENT_EVERY_SPACE) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  const auto point = [](double x, double y) { return at<S, N>(x, y); };
  const auto solid = diamond<S, N>();
  CHECK(meets(Aabb<S, N>{point(2, 2), point(9, 9)}, solid));
  CHECK_FALSE(meets(Aabb<S, N>{point(2, 2.5), point(9, 9)}, solid));
  CHECK(meets(Aabb<S, N>{point(-9, 0), point(9, 0)}, solid));

  CHECK(meets(Obb<S, N>{point(5, 5), at<S, N>(3, 3, 3), {}}, solid));
  CHECK_FALSE(meets(Obb<S, N>{point(5, 5), at<S, N>(3, 2.5, 3), {}}, solid));

  const Points<S, N, 3> line{at<S, N>(-2), at<S, N>(3), at<S, N>(0)};
  CHECK(meets(Aabb<S, N>{at<S, N>(0), at<S, N>(1)}, line));
  CHECK_FALSE(meets(Aabb<S, N>{at<S, N>(0, 1), at<S, N>(1, 1)}, line));
  CHECK(meets(Obb<S, N>{at<S, N>(4), at<S, N>(1, 2), {}}, line));
  CHECK_FALSE(meets(Obb<S, N>{at<S, N>(4.5), at<S, N>(1, 2), {}}, line));

  const ConvexHull<S, N> none;
  CHECK_FALSE(overlaps(Aabb<S, N>{}, none));
  CHECK_FALSE(overlaps(Obb<S, N>{}, none));
  CHECK_FALSE(overlaps(Aabb<S, N>{at<S, N>(1), at<S, N>(0)}, ConvexHull<S, N>{solid}));
  CHECK_FALSE(meets(Obb<S, N>{{}, at<S, N>(1, -1, 1), {}}, solid));
}

TEMPLATE_TEST_CASE("overlaps, box and hull: one raw unit decides, at the ends of the domain too",
                   "[overlaps]", DETENT_FIXED_SPACES) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  const auto half = half_domain<S, N>();
  const auto on = Vec<S, N>(), beside = in_steps<S, N>(-1, 0);
  CHECK(meets(Aabb<S, N>{on, on}, half));
  CHECK_FALSE(meets(Aabb<S, N>{beside, beside}, half));
  CHECK(meets(Obb<S, N>{on, {}, {}}, half));
  CHECK_FALSE(meets(Obb<S, N>{beside, {}, {}}, half));
  CHECK(meets(Obb<S, N>{half.front(), half.back(), {}}, half));
  // A segment through (3, 4) as a box, with a corner on it and next to it.
  const Obb<S, N> line{{}, at<S, N>(10), three_four_fifths_frame<S, N>()};
  auto corner = at<S, N>(3, 4);
  CHECK(meets(line, Points<S, N, 2>{corner, at<S, N>(9, 4)}));
  corner.x = moved(corner.x, 1);
  CHECK_FALSE(meets(line, Points<S, N, 2>{corner, at<S, N>(9, 4)}));
}

TEMPLATE_TEST_CASE("overlaps, box and hull: rounded edges decide only what they are sure of",
                   "[overlaps]", DETENT_FIXED_SPACES) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;

  Random random(0x0bb41);
  int near = 0, unsure = 0, apart = 0;
  for (int round = 0; round < 2'000; ++round) {
    const std::int64_t reach = std::int64_t{1} << random.between(2, S::bits - 4);
    Points<S, N, 4> points;
    for (auto& point : points) point = random_near(random, Vec<S, N>(), reach);
    const detail::HullBody hull(ConvexHull<S, N>{points});
    Obb<S, N> box{{}, {}, random_rotation<S, N>(random)};
    for (int i = 0; i < N; ++i)
      box.half_extents[i] = moved(S(0), static_cast<int>(random.between(0, reach)));
    // The last overlapping position on the way out of the hull.
    const auto way = random_near(random, Vec<S, N>(), reach);
    std::int64_t inside = 0, outside = 8 * 64;
    while (outside - inside > 1) {
      const auto middle = (inside + outside) / 2;
      box.center = make_vec<N>(
          [&](int i) { return moved(S(0), static_cast<int>(way[i].raw() * middle / 64)); });
      const bool meet = detail::bodies_overlap(detail::edge_body(box), hull);
      const auto filtered = detail::decide_overlap(box, hull);
      REQUIRE(filtered != (meet ? Filtered::no : Filtered::yes));
      ++(filtered == Filtered::yes ? near : filtered == Filtered::no ? apart : unsure);
      (meet ? inside : outside) = middle;
    }
  }
  CHECK(near > 2'000);
  CHECK(apart > 2'000);
  CHECK(unsure > 40);
}

}  // namespace
}  // namespace detent::test
