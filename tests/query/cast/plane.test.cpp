// SPDX-License-Identifier: MIT
// A shape that meets a plane with several corners at once.
#include <algorithm>
#include <array>
#include <span>
#include <vector>

#include "detent/query/cast.hpp"
#include "query/raycast/helpers.hpp"

namespace detent::test {
namespace {

/// Checks that a shape meets the plane as its least nearest corner does alone.
template <Scalar S, int N, class Shape>
void meets_with_least_corner(const Shape& shape, std::vector<Vec<S, N>> corners,
                             const Plane<S, N>& plane, const Direction<S, N>& along) {
  const auto distance = [&](const Vec<S, N>& corner) {
    return abs(dot(plane.normal, corner) - plane.offset);
  };
  const auto is_before = [](const Vec<S, N>& a, const Vec<S, N>& b) {
    int i = 0;
    while (i < N - 1 && a[i] == b[i]) ++i;
    return a[i] < b[i];
  };
  std::sort(corners.begin(), corners.end(), [&](const auto& a, const auto& b) {
    return distance(a) < distance(b) || (distance(a) == distance(b) && is_before(a, b));
  });
  REQUIRE(distance(corners[0]) == distance(corners[1]));
  const S far = num<S>(20);
  const auto alone = cast(Sphere<S, N>{corners[0], S(0)}, along, far, plane);
  const auto hit = cast(shape, along, far, plane);
  CAPTURE(corners[0], corners[1], plane.normal, plane.offset, along);
  REQUIRE(alone);
  REQUIRE(hit);
  CHECK(hit->distance == alone->distance);
  CHECK(hit->point == alone->point);
  CHECK(hit->normal == alone->normal);
}

/// Planes below and above the shapes of this file, each with a direction that leads to it. Along an
/// axis a corner lands exactly on the plane.
template <Scalar S, int N, class F>
void for_each_axis_plane(const F& f) {
  for (int axis = 0; axis < N; ++axis) {
    const auto up = Direction<S, N>::along(axis);
    Vec<S, N> slanted = filled<S, N>(num<S>(0.5));
    slanted[axis] = num<S>(2);
    const auto aslant = *normalize(slanted);
    f(Plane<S, N>{up, num<S>(-6)}, -up);
    f(Plane<S, N>{up, num<S>(6)}, up);
    f(Plane<S, N>{-up, num<S>(6)}, -aslant);
    f(Plane<S, N>{-up, num<S>(-6)}, aslant);
  }
}

/// The corners of a cube around `center`.
template <Scalar S, int N>
std::vector<Vec<S, N>> corners_of_cube(const Vec<S, N>& center, const S& half_extent) {
  std::vector<Vec<S, N>> corners;
  for (int k = 0; k < 1 << N; ++k) {
    corners.push_back(make_vec<N>([&](int i) {
      return nearest_to<S>((k >> i & 1) != 0 ? center[i] + half_extent : center[i] - half_extent);
    }));
  }
  return corners;
}

/// All turns by a multiple of 90 degrees about one axis.
template <Scalar S, int N>
std::vector<Rotation<S, N>> right_turns() {
  std::vector<Rotation<S, N>> turns;
  for (int quarter = 0; quarter < 4; ++quarter) {
    const auto angle = Angle<S>::turn(quarter, 4);
    if constexpr (N == 2) {
      turns.push_back(Rotation<S, 2>::from_angle(angle));
    } else {
      for (int axis = 0; axis < 3; ++axis) {
        turns.push_back(Rotation<S, 3>::from_axis_angle(Direction<S, 3>::along(axis), angle));
      }
    }
  }
  return turns;
}

}  // namespace

TEMPLATE_TEST_CASE("cast: of several corners that meet a plane, boxes return the least", "[cast]",
                   (Space<q16_16, 2>), (Space<q16_16, 3>), (Space<q8_8, 3>)) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  const auto half = S(1);
  const auto cube = corners_of_cube<S, N>({}, half);
  for_each_axis_plane<S, N>([&](const Plane<S, N>& plane, const Direction<S, N>& along) {
    const Aabb<S, N> box{filled<S, N>(S(-1)), filled<S, N>(half)};
    meets_with_least_corner(box, cube, plane, along);
    for (const auto& turn : right_turns<S, N>()) {
      meets_with_least_corner(Obb<S, N>{{}, filled<S, N>(half), turn}, cube, plane, along);
    }
  });
}

TEMPLATE_TEST_CASE(
    "cast: of several corners that meet a plane, the order of corners does not matter", "[cast]",
    (Space<q16_16, 2>), (Space<q16_16, 3>), (Space<q8_8, 3>)) {
  using S = typename TestType::scalar;
  static constexpr int N = TestType::dimension;
  using Point = Vec<S, N>;
  for_each_axis_plane<S, N>([&](const Plane<S, N>& plane, const Direction<S, N>& along) {
    int axis = 0;
    while (plane.normal[axis] == 0) ++axis;
    // Two corners on the side of the plane, or three if an apex is opposite.
    const bool is_below = plane.offset * plane.normal[axis] < 0;
    std::vector<Point> base(N == 2 ? 2 : 3, filled<S, N>(S(0)));
    Point apex{};
    for (auto& corner : base) corner[axis] = S(is_below ? -1 : 1);
    apex[axis] = S(is_below ? 2 : -2);
    const int x = (axis + 1) % N, y = (axis + 2) % N;
    base[0][x] = S(1);
    base[1][x] = S(-1);
    if constexpr (N == 3) {
      base[1][y] = S(2);
      base[2][y] = S(-3);
    }
    std::vector<Point> hull = base;
    hull.push_back(apex);
    const auto by_value = [](const Point& a, const Point& b) {
      return std::lexicographical_compare(&a[0], &a[0] + N, &b[0], &b[0] + N);
    };
    std::sort(hull.begin(), hull.end(), by_value);
    do {
      meets_with_least_corner(ConvexHull<S, N>{std::span<const Point>(hull)}, base, plane, along);
    } while (std::next_permutation(hull.begin(), hull.end(), by_value));
    for (const bool is_swapped : {false, true}) {
      const auto& a = base[is_swapped ? 1 : 0];
      auto b = base[is_swapped ? 0 : 1];
      meets_with_least_corner(Segment<S, N>{a, b}, {a, b}, plane, along);
      meets_with_least_corner(Triangle<S, N>{a, apex, b}, {a, b}, plane, along);
      meets_with_least_corner(Triangle<S, N>{a, b, apex}, {a, b}, plane, along);
      meets_with_least_corner(Triangle<S, N>{apex, a, b}, {a, b}, plane, along);
    }
  });
}

TEMPLATE_TEST_CASE("cast: corners may be equally far from a plane that is not along an axis",
                   "[cast]", q16_16, q8_8) {
  using S = TestType;
  const auto n = toward<S, 3>(1, 1, 1);
  REQUIRE((n[0] == n[1] && n[1] == n[2]));
  const std::array<Vec<S, 3>, 3> ends{at<S, 3>(3, 0, 0), at<S, 3>(0, 3, 0), at<S, 3>(0, 0, 3)};
  std::array order{0, 1, 2};
  do {
    const auto& a = ends[static_cast<std::size_t>(order[0])];
    const auto& b = ends[static_cast<std::size_t>(order[1])];
    const auto& c = ends[static_cast<std::size_t>(order[2])];
    for (const auto& [plane, along] :
         {std::pair{Plane<S, 3>{n, num<S>(9)}, n}, std::pair{Plane<S, 3>{n, num<S>(-9)}, -n},
          std::pair{Plane<S, 3>{-n, num<S>(-9)}, toward<S, 3>(1, 0)}}) {
      meets_with_least_corner(Triangle<S, 3>{a, b, c}, {a, b, c}, plane, along);
      meets_with_least_corner(Segment<S, 3>{a, b}, {a, b}, plane, along);
    }
  } while (std::next_permutation(order.begin(), order.end()));
  // A cube that stands on an edge.
  const Plane<S, 3> slope{toward<S, 3>(1, 0, 1), num<S>(-8)};
  const Aabb<S, 3> box{filled<S, 3>(S(-1)), filled<S, 3>(S(1))};
  meets_with_least_corner(box, corners_of_cube<S, 3>({}, S(1)), slope, toward<S, 3>(0, 0, -1));
}

}  // namespace detent::test
