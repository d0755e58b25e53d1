// SPDX-License-Identifier: MIT
#include "detent/query/contains/hull.hpp"

#include "detent/query/on.hpp"
#include "query/hulls.hpp"

namespace detent::test {
namespace {

constexpr auto corners = diamond<q16_16, 3>();
static_assert(contains(ConvexHull{corners}, at<q16_16, 3>(1, 1, 2)));
static_assert(!contains(ConvexHull{corners}, at<q16_16, 3>(1, 1, 2.5)));
static_assert(noexcept(contains(ConvexHull{corners}, corners[0])));

template <Scalar S, int N, std::size_t Count>
bool holds(const Points<S, N, Count>& points, const Vec<S, N>& point) {
  return in_every_order(points, [&](const auto& hull) {
    CHECK(on(hull, point) == contains(hull, point));
    CHECK(on(hull, point, S(0)) == contains(hull, point));
    return contains(hull, point);
  });
}

TEMPLATE_TEST_CASE("contains, hull: its inside, faces, edges and corners", "[contains]",
                   DETENT_EVERY_SPACE) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  const auto solid = diamond<S, N>();
  CHECK(holds(solid, Vec<S, N>()));
  CHECK(holds(solid, at<S, N>(1, 1, 1)));
  CHECK(holds(solid, at<S, N>(1, 2, 1)));
  CHECK(holds(solid, at<S, N>(-2, 2)));
  CHECK(holds(solid, at<S, N>(0, -4)));
  CHECK_FALSE(holds(solid, at<S, N>(2, 2.5)));
  CHECK_FALSE(holds(solid, at<S, N>(-3, -3, -3)));
  CHECK_FALSE(holds(solid, at<S, N>(5, 0)));
  CHECK(on(ConvexHull{solid}, at<S, N>(8, 3), num<S>(5)));
  CHECK_FALSE(on(ConvexHull{solid}, at<S, N>(8, 3), num<S>(4.5)));
}

TEMPLATE_TEST_CASE("contains, hull: flat, a segment, a point or empty", "[contains]",
                   DETENT_EVERY_SPACE) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  const auto sheet = flat<S, N>();
  auto beside = at<S, N>(1);
  CHECK(holds(sheet, beside));
  CHECK(holds(sheet, sheet[0]));
  beside[N - 1] = num<S>(0.5);
  CHECK_FALSE(holds(sheet, beside));
  CHECK_FALSE(holds(sheet, at<S, N>(4.5)));
  const Points<S, N, 3> line{at<S, N>(1, 1), at<S, N>(7, 4), at<S, N>(3, 2)};
  CHECK(holds(line, at<S, N>(5, 3)));
  CHECK_FALSE(holds(line, at<S, N>(9, 5)));
  CHECK_FALSE(holds(line, at<S, N>(5, 3.5)));
  CHECK(holds(Points<S, N, 1>{line[1]}, line[1]));
  CHECK_FALSE(holds(Points<S, N, 1>{line[1]}, line[0]));
  CHECK_FALSE(contains(ConvexHull<S, N>{}, Vec<S, N>()));
  CHECK_FALSE(on(ConvexHull<S, N>{}, Vec<S, N>(), num<S>(100)));
}

TEMPLATE_TEST_CASE("contains, hull: one raw unit decides, at the ends of the domain too",
                   "[contains]", DETENT_FIXED_SPACES) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  const auto half = half_domain<S, N>();
  CHECK(holds(half, half[0]));
  CHECK(holds(half, filled<S, N>(S(0))));
  auto beside = Vec<S, N>();
  beside.x = moved(S(0), 1);
  CHECK(holds(half, beside));
  beside.x = moved(S(0), -1);
  CHECK_FALSE(holds(half, beside));
}

}  // namespace
}  // namespace detent::test
