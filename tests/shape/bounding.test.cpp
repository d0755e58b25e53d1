// SPDX-License-Identifier: MIT
#include "detent/shape/bounding_sphere.hpp"

#include <algorithm>
#include <array>
#include <vector>

#include "oracle/draw.hpp"
#include "oracle/space.hpp"
#include "query/raycast/helpers.hpp"

namespace detent::test {
namespace {

TEMPLATE_TEST_CASE("bounding_box: simple shapes have the obvious boxes", "[bounding]",
                   DETENT_EVERY_SPACE) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  const std::array points{at<S, N>(3, -1), at<S, N>(-2, 4), at<S, N>(0, 0)};
  CHECK(bounding_box<S, N>(points) == Aabb{at<S, N>(-2, -1), at<S, N>(3, 4)});
  CHECK(bounding_box(Triangle{points[0], points[1], points[2]}) == bounding_box<S, N>(points));
  CHECK(bounding_box(ConvexHull{points}) == bounding_box<S, N>(points));
  CHECK(bounding_sphere(ConvexHull{points}) == bounding_sphere<S, N>(points));
  CHECK(bounding_box(Segment{points[0], points[2]}) == Aabb{at<S, N>(0, -1), at<S, N>(3, 0)});
  const auto two = filled<S, N>(num<S>(2));
  CHECK(bounding_box(Sphere{Vec<S, N>(), num<S>(2)}) == Aabb{nearest_to<S>(-two), two});
  CHECK(bounding_box(Obb<S, N>{Vec<S, N>(), two, {}}) == Aabb{nearest_to<S>(-two), two});
  const auto capsule = bounding_box(Capsule{at<S, N>(1, 5), at<S, N>(3, 0), num<S>(2)});
  CHECK((capsule.min.x == num<S>(-1) && capsule.max.x == num<S>(5)));
  CHECK((capsule.min.y == num<S>(-2) && capsule.max.y == num<S>(7)));
}

TEMPLATE_TEST_CASE("bounding_box, bounding_sphere: of empty shapes are empty", "[bounding]",
                   DETENT_EVERY_SPACE) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  const Aabb inverted{at<S, N>(0, 1), at<S, N>(1, 0)};
  const Obb<S, N> none{at<S, N>(0, 1), at<S, N>(-1, 1), {}};
  CHECK(is_empty(bounding_box<S, N>(std::span<const Vec<S, N>>())));
  CHECK(is_empty(bounding_box(inverted)));
  CHECK(is_empty(bounding_box(none)));
  CHECK(is_empty(bounding_box(Sphere{at<S, N>(1), num<S>(-1)})));
  CHECK(is_empty(bounding_box(Compound<Sphere<S, N>>())));
  CHECK(bounding_box(bounding_box(inverted), Aabb{at<S, N>(1), at<S, N>(2)}) ==
        Aabb{at<S, N>(1), at<S, N>(2)});
  CHECK(bounding_sphere<S, N>(std::span<const Vec<S, N>>()).radius < 0);
  CHECK(bounding_sphere(inverted).radius < 0);
  CHECK(bounding_sphere(none).radius < 0);
  CHECK(bounding_sphere(Capsule{at<S, N>(1), at<S, N>(2), num<S>(-1)}).radius < 0);
  CHECK(bounding_sphere(Compound<Aabb<S, N>>()).radius < 0);
}

TEMPLATE_TEST_CASE("bounding_box: clamps at the ends of the scalar", "[bounding]",
                   DETENT_FIXED_SPACES) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  const auto low = filled<S, N>(S::lowest()), high = filled<S, N>(S::max());
  CHECK(bounding_box(Sphere{Vec<S, N>(), S::max()}).max == high);
  CHECK(bounding_box(Sphere{low, S::max()}).min == low);
  CHECK(bounding_box(Obb<S, N>{high, high, {}}).max == high);
  CHECK(bounding_box(Aabb{low, high}) == Aabb{low, high});
  CHECK(bounding_sphere(Aabb{low, high}).radius == S::max());
}

/// Points whose hull is the shape, in steps of 1 / `one` raw unit.
template <int N>
struct Outline {
  std::vector<oracle::Vector<N>> points;
  oracle::Integer one;
};

template <Scalar S, int N>
Outline<N> outline(const Triangle<S, N>& t) {
  return {{oracle::raw(t.a), oracle::raw(t.b), oracle::raw(t.c)}, 1};
}
template <Scalar S, int N>
Outline<N> outline(const Obb<S, N>& box) {
  const oracle::Integer one = oracle::Integer(1) << direction_component<S>::frac;
  Outline<N> result{{}, one};
  const auto center = oracle::raw(box.center), half = oracle::raw(box.half_extents);
  for (unsigned signs = 0; signs < 1u << N; ++signs) {
    oracle::Vector<N> corner;
    for (std::size_t j = 0; j < N; ++j) corner[j] = center[j] * one;
    for (std::size_t i = 0; i < N; ++i) {
      const auto axis = oracle::widen(oracle::raw(box.rotation.axis(static_cast<int>(i))));
      for (std::size_t j = 0; j < N; ++j) {
        corner[j] += ((signs >> i & 1u) != 0 ? half[i] : -half[i]) * axis[j];
      }
    }
    result.points.push_back(corner);
  }
  return result;
}

/// Empty if both bounds contain every point and a smaller bound on the grid would not.
template <Scalar S, int N, class Shape>
std::string mistakes(const Shape& shape) {
  using oracle::Integer;
  const auto [points, one] = outline(shape);
  const auto box = bounding_box(shape);
  const auto sphere = bounding_sphere(shape);
  const auto center = oracle::raw(sphere.center);
  const Integer lowest = oracle::raw(S::lowest()), greatest = oracle::raw(S::max());
  Integer farthest = 0;
  for (const auto& point : points) {
    Integer squared = 0;
    for (std::size_t j = 0; j < N; ++j) {
      const Integer apart = point[j] - center[j] * one;
      squared += apart * apart;
    }
    farthest = std::max(farthest, squared);
  }
  const Integer radius = oracle::raw(sphere.radius) * one;
  if (radius < greatest * one && radius * radius < farthest) return "the sphere leaves a point out";
  if (radius > 0 && (radius - one) * (radius - one) >= farthest) return "the sphere is too large";
  for (std::size_t j = 0; j < N; ++j) {
    Integer least = points.front()[j], most = least;
    for (const auto& point : points) {
      least = std::min(least, point[j]);
      most = std::max(most, point[j]);
    }
    const auto axis = static_cast<int>(j);
    const Integer low = oracle::floor_quotient(least, one);
    const Integer high = -oracle::floor_quotient(-most, one);
    if (oracle::raw(box.min[axis]) != std::clamp(low, lowest, greatest)) return "min";
    if (oracle::raw(box.max[axis]) != std::clamp(high, lowest, greatest)) return "max";
  }
  return {};
}

TEMPLATE_TEST_CASE("bounding_box, bounding_sphere: contain every corner tightly",
                   "[bounding][oracle]", DETENT_FIXED_SPACES) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  oracle::Draw<S, N> draw(0xb0d5);
  INFO(draw.random);
  for (int i = 0; i < 5'000; ++i) {
    const auto point = [&, scale = draw.scale()] {
      return draw.vec(draw.random.one_in(4) ? draw.extreme_point() : draw.point(scale));
    };
    const Triangle<S, N> triangle{point(), point(), point()};
    auto half_extents = point();
    for (int j = 0; j < N; ++j) {
      if (half_extents[j] < 0) half_extents[j] = nearest_to<S>(-half_extents[j]);
    }
    const Obb<S, N> box{point(), half_extents,
                        draw.random.one_in(4) ? draw.skewed() : draw.rotation()};
    const auto wrong = mistakes<S, N>(triangle) + mistakes<S, N>(box);
    if (!wrong.empty()) FAIL("case " << i << ": " << wrong);
  }
}

TEMPLATE_TEST_CASE("bounding_sphere: contains round shapes and boxes completely", "[bounding]",
                   DETENT_FIXED_SPACES) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  const Capsule<S, N> capsule{at<S, N>(1, 1), at<S, N>(4, 5), num<S>(2)};
  CHECK(bounding_sphere(capsule) == Sphere{at<S, N>(2.5, 3), num<S>(4.5)});
  const Sphere<S, N> ball{at<S, N>(9, 3), num<S>(1)};
  CHECK(bounding_sphere(ball) == ball);
  CHECK(bounding_sphere(Aabb{at<S, N>(0, 0), at<S, N>(6, 8)}) == Sphere{at<S, N>(3, 4), num<S>(5)});

  // The center is rounded to even, so one end may be farther from it than the other.
  const auto raw = [](std::int64_t x) { return filled<S, N>(oracle::Draw<S, N>::scalar(x)); };
  for (std::int64_t low = 0; low < 2; ++low) {
    const auto odd = bounding_sphere(Aabb<S, N>{raw(low), raw(low + 1)});
    CHECK(squared_distance(odd.center, raw(low)) <= square(odd.radius));
    CHECK(squared_distance(odd.center, raw(low + 1)) <= square(odd.radius));
  }

  const std::array capsules{capsule};
  const std::array balls{ball};
  const auto both = bounding_sphere(Compound{capsules, balls});
  CHECK(bounding_box(Compound{capsules, balls}).max.x == num<S>(10));
  for (const auto& part : {bounding_sphere(capsule), ball}) {
    CHECK(distance(part.center, both.center) + part.radius <= both.radius);
  }
}

}  // namespace
}  // namespace detent::test
