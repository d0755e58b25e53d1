// SPDX-License-Identifier: MIT
#include "detent/query/raycast/hull.hpp"

#include "query/hulls.hpp"

namespace detent::test {
namespace {

constexpr auto corners = diamond<q16_16, 3>();
constexpr Ray<q16_16, 3> through{at<q16_16, 3>(1, 1, -9), toward<q16_16, 3>(0, 0, 1), q16_16(100)};
static_assert(raycast(through, ConvexHull{corners}) == q16_16(7));
static_assert(raycast_hit(through, ConvexHull{corners})->normal == toward<q16_16, 3>(1, 1, -1));
static_assert(raycast_interval(through, ConvexHull{corners}) ==
              Interval<q16_16>{q16_16(7), q16_16(11)});
static_assert(noexcept(raycast(through, ConvexHull{corners})));

template <Scalar S, int N, std::size_t Count>
std::optional<Interval<S>> met(const Ray<S, N>& ray, const Points<S, N, Count>& points) {
  return in_every_order(points, [&](const auto& hull) {
    (void)distance(ray, hull);
    return raycast_interval(ray, hull);
  });
}
template <Scalar S, int N, std::size_t Count>
Direction<S, N> normal(const Ray<S, N>& ray, const Points<S, N, Count>& points) {
  return raycast_hit(ray, ConvexHull<S, N>{points}).value().normal;
}

TEMPLATE_TEST_CASE("ray against hull: hit, miss, touch, inside start", "[raycast]",
                   DETENT_EVERY_SPACE) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  const auto solid = diamond<S, N>();
  const auto ray = [](double x, double y, double dx, double dy) {
    return Ray<S, N>{at<S, N>(x, y), toward<S, N>(dx, dy), num<S>(100)};
  };
  const auto interval = [](double enter, double exit) {
    return Interval<S>{num<S>(enter), num<S>(exit)};
  };
  CHECK(met(ray(-10, 1, 1, 0), solid) == interval(7, 13));
  CHECK(met(ray(-10, 0, 1, 0), solid) == interval(6, 14));
  CHECK(met(ray(-10, 4, 1, 0), solid) == interval(10, 10));
  CHECK_FALSE(met(ray(-10, 4.5, 1, 0), solid));
  CHECK_FALSE(met(ray(10, 1, 1, 0), solid));
  CHECK(met(ray(1, 1, 1, 0), solid) == interval(0, 2));
  CHECK(met(ray(4, 0, 1, 0), solid) == interval(0, 0));
  CHECK(met(ray(-4, 0, 1, 0), solid) == interval(0, 8));
  CHECK(normal(ray(1, 1, 1, 0), solid) == -toward<S, N>(1));
  CHECK(normal(ray(4, 0, -1, 0), solid) == toward<S, N>(1));

  auto cut = ray(-10, 1, 1, 0);
  cut.max_distance = num<S>(7);
  CHECK(met(cut, solid) == interval(7, 7));
  cut.max_distance = num<S>(6.5);
  CHECK_FALSE(met(cut, solid));
  cut = ray(1, 1, 1, 0);
  cut.max_distance = num<S>(0);
  CHECK(met(cut, solid) == interval(0, 0));
  cut.max_distance = num<S>(-1);
  CHECK_FALSE(met(cut, solid));
}

TEMPLATE_TEST_CASE("ray against hull: the normal belongs to a face through which the ray can enter",
                   "[raycast]", DETENT_EVERY_SPACE) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  const auto solid = diamond<S, N>();
  // The face, an edge in 3D, a corner, a grazed corner.
  for (const auto& start :
       {at<S, N>(-10, 1, 1), at<S, N>(-10, 1), at<S, N>(-10), at<S, N>(-10, 4)}) {
    const auto found = normal(Ray<S, N>{start, toward<S, N>(1)}, solid);
    CHECK(found[0] < 0);
    for (int i = 0; i < N; ++i) {
      CHECK((found[i] == found[0] || found[i] == -found[0]));
      if (start[i] > 0) CHECK(found[i] > 0);
    }
  }
}

TEMPLATE_TEST_CASE("ray against hull: flat, a segment, a point or empty", "[raycast]",
                   DETENT_EVERY_SPACE) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  const auto sheet = flat<S, N>();
  const Points<S, N, 3> line{at<S, N>(-4), at<S, N>(1), at<S, N>(4)};
  const Points<S, N, 1> dot{at<S, N>(1)};
  const auto along = [](double x, double y) {
    return Ray<S, N>{at<S, N>(x, y), toward<S, N>(1), num<S>(100)};
  };
  const auto interval = [](double enter, double exit) {
    return Interval<S>{num<S>(enter), num<S>(exit)};
  };
  Ray<S, N> down{at<S, N>(1), -Direction<S, N>::along(N - 1), num<S>(100)};
  down.origin[N - 1] = num<S>(5);
  CHECK(met(down, sheet) == interval(5, 5));
  CHECK(normal(down, sheet) == -down.direction);
  auto slanted = down;
  slanted.origin.x = num<S>(-4);
  slanted.direction = aimed(slanted.origin, at<S, N>(2));
  CHECK(normal(slanted, sheet) == Direction<S, N>::along(N - 1));
  CHECK(met(along(-10, 0), sheet) == interval(6, 14));
  CHECK(normal(along(-10, 0), sheet) == -toward<S, N>(1));
  CHECK(met(along(0, 0), sheet) == interval(0, 4));
  slanted.direction = toward<S, N>(1);
  CHECK_FALSE(met(slanted, sheet));

  CHECK(met(down, line) == interval(5, 5));
  CHECK(normal(down, line) == -down.direction);
  CHECK(met(along(-10, 0), line) == interval(6, 14));
  CHECK_FALSE(met(along(-10, 0.5), line));
  CHECK(met(down, dot) == interval(5, 5));
  CHECK(met(along(-10, 0), dot) == interval(11, 11));
  CHECK(normal(along(-10, 0), dot) == -toward<S, N>(1));
  CHECK_FALSE(met(along(2, 0), dot));
  CHECK(misses(down, ConvexHull<S, N>{}));
}

TEMPLATE_TEST_CASE("ray against hull: one raw unit decides, at the ends of the domain too",
                   "[raycast]", DETENT_FIXED_SPACES) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  const Ray<S, N> slanted{{}, three_four_fifths<S, N>(), S::max()};
  const auto target = at<S, N>(6, 8);
  auto beside = target;
  beside.x = moved(beside.x, 1);
  CHECK(met(slanted, Points<S, N, 1>{target}));
  CHECK_FALSE(met(slanted, Points<S, N, 1>{beside}));
  CHECK(met(slanted, Points<S, N, 2>{target, beside}));
  auto far = beside;
  far.x = moved(far.x, 1);
  CHECK_FALSE(met(slanted, Points<S, N, 2>{beside, far}));

  const auto [low, side, high] = half_domain<S, N>();
  const Ray<S, N> long_ray{low, toward<S, N>(1), S::max()};
  CHECK_FALSE(met(long_ray, Points<S, N, 1>{side}));
  CHECK(met(long_ray, Points<S, N, 3>{low, side, high}) == Interval<S>{S(0), S::max()});
  const Ray<S, N> middle{Vec<S, N>(), toward<S, N>(1), S::max()};
  CHECK(met(middle, Points<S, N, 3>{low, side, high}) == Interval<S>{S(0), S::max()});
  CHECK_FALSE(met(Ray<S, N>{side, toward<S, N>(-1), S::max()}, Points<S, N, 2>{low, high}));
}

}  // namespace
}  // namespace detent::test
