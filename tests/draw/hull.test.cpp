// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <map>
#include <numeric>
#include <set>
#include <vector>

#include "draw/sheet.hpp"
#include "support/catch.hpp"

// The edges and sides of hulls, compared with those found by another method in integers: the planes
// through three points with no point in front, and in each the polygon by a monotone chain.

namespace detent::test {
namespace {

using Point = std::array<std::int64_t, 3>;
using Edge = std::pair<Point, Point>;

Point operator-(const Point& a, const Point& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
Point cross(const Point& a, const Point& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
std::int64_t dot(const Point& a, const Point& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

Edge edge(const Point& a, const Point& b) { return std::minmax(a, b); }

/// The corners of the hull of coplanar points, without those within edges, by two coordinates.
///
/// source: Andrew, Another Efficient Algorithm for Convex Hulls in Two Dimensions, 1979
std::vector<Point> polygon(std::vector<Point> points, std::size_t u, std::size_t v) {
  std::sort(points.begin(), points.end(), [&](const Point& a, const Point& b) {
    return std::pair(a[u], a[v]) < std::pair(b[u], b[v]);
  });
  points.erase(std::unique(points.begin(), points.end()), points.end());
  if (points.size() < 3) return points;
  std::vector<Point> chain;
  const auto add_all = [&](auto begin, auto end) {
    const std::size_t base = chain.size();
    for (auto at = begin; at != end; ++at) {
      while (chain.size() >= base + 2) {
        const auto &a = chain[chain.size() - 2], &b = chain.back();
        if ((b[u] - a[u]) * ((*at)[v] - a[v]) - (b[v] - a[v]) * ((*at)[u] - a[u]) > 0) break;
        chain.pop_back();
      }
      chain.push_back(*at);
    }
    chain.pop_back();
  };
  add_all(points.begin(), points.end());
  add_all(points.rbegin(), points.rend());
  return chain;
}

void add_edges(const std::vector<Point>& corners, std::set<Edge>& edges) {
  for (std::size_t i = 0; i < corners.size() && corners.size() > 1; ++i) {
    edges.insert(edge(corners[i], corners[(i + 1) % corners.size()]));
  }
}

/// A side: its outward normal with coprime components, and twice its area projected along its
/// greatest axis.
struct Sides {
  std::set<Edge> edges;
  std::map<std::pair<Point, std::int64_t>, std::int64_t> areas;
};

/// The plane of a normal of any length through a point, and the axis along which it is projected.
std::pair<Point, std::int64_t> plane_of(Point normal, const Point& through) {
  const auto common = std::gcd(std::gcd(normal[0], normal[1]), normal[2]);
  for (auto& component : normal) component /= common;
  return {normal, dot(normal, through)};
}
std::size_t greatest_axis(const Point& normal) {
  std::size_t greatest = 0;
  for (std::size_t i = 1; i < 3; ++i) {
    if (std::abs(normal[i]) > std::abs(normal[greatest])) greatest = i;
  }
  return greatest;
}

Sides sides_of(const std::vector<Point>& points) {
  Sides sides;
  std::set<std::pair<Point, std::int64_t>> seen;
  for (const auto& a : points) {
    for (const auto& b : points) {
      for (const auto& c : points) {
        const auto normal = cross(b - a, c - a);
        if (normal == Point{}) continue;
        const auto plane = plane_of(normal, a);
        if (!seen.insert(plane).second) continue;
        std::vector<Point> on;
        bool is_side = true;
        for (const auto& p : points) {
          const auto height = dot(plane.first, p) - plane.second;
          is_side &= height <= 0;
          if (height == 0) on.push_back(p);
        }
        if (!is_side) continue;
        const auto axis = greatest_axis(normal), u = (axis + 1) % 3, v = (axis + 2) % 3;
        const auto corners = polygon(on, u, v);
        add_edges(corners, sides.edges);
        auto& area = sides.areas[plane];
        for (std::size_t i = 0; i < corners.size(); ++i) {
          const auto &p = corners[i], &q = corners[(i + 1) % corners.size()];
          area += p[u] * q[v] - p[v] * q[u];
        }
        area = std::abs(area);
      }
    }
  }
  if (seen.empty())
    add_edges({*std::min_element(points.begin(), points.end()),
               *std::max_element(points.begin(), points.end())},
              sides.edges);
  return sides;
}

template <Scalar S, int N>
Point whole(const Vec<S, N>& v) {
  Point result{};
  for (int i = 0; i < N; ++i) {
    result[static_cast<std::size_t>(i)] = static_cast<std::int64_t>(static_cast<double>(v[i]));
  }
  return result;
}

/// A few points on a small lattice: often coplanar, collinear, equal or inside.
template <Scalar S, int N>
std::vector<Vec<S, N>> lattice_points(Random& random) {
  std::vector<Vec<S, N>> points(static_cast<std::size_t>(random.between(1, 14)));
  const auto reach = random.between(1, 5);
  const bool is_flat = random.one_in(6);
  const auto small = [&](auto most) { return static_cast<double>(random.between(-most, most)); };
  for (auto& point : points) {
    const double x = small(reach), y = random.one_in(9) ? x : small(reach);
    point = at<S, N>(x, y, is_flat ? x - 2 * y + 1 : small(reach));
  }
  return points;
}

TEMPLATE_TEST_CASE("draw: every edge of a hull once, and nothing else", "[draw]",
                   DETENT_EVERY_SPACE) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  Random random(1);
  std::size_t flat = 0, solid = 0;
  for (int i = 0; i < 400; ++i) {
    const auto points = lattice_points<S, N>(random);
    std::vector<Point> all;
    for (const auto& point : points) all.push_back(whole(point));
    std::set<Edge> expected;
    if constexpr (N == 2) {
      add_edges(polygon(all, 0, 1), expected);
    } else {
      const auto sides = sides_of(all);
      expected = sides.edges;
      (sides.areas.size() > 2 ? solid : flat) += 1;
    }
    const std::set<Point> different(all.begin(), all.end());
    if (different.size() == 1) expected.clear();

    const auto sheet = drawn<S, N>(ConvexHull<S, N>{points});
    std::set<Edge> edges;
    for (const auto& line : sheet.lines) edges.insert(edge(whole(line.a), whole(line.b)));
    REQUIRE(edges == expected);
    REQUIRE(edges.size() == sheet.lines.size());
  }
  if constexpr (N == 3) {
    CHECK(flat > 60);
    CHECK(solid > 200);
  }
}

TEMPLATE_TEST_CASE("draw_solid: triangles cover each side of a hull once, facing outward", "[draw]",
                   DETENT_EVERY_SCALAR) {
  using S = TestType;
  Random random(2);
  for (int i = 0; i < 300; ++i) {
    const auto points = lattice_points<S, 3>(random);
    std::vector<Point> all;
    for (const auto& point : points) all.push_back(whole(point));
    const auto expected = sides_of(all).areas;
    decltype(Sides::areas) areas;
    for (const auto& face : drawn_solid<S>(ConvexHull<S, 3>{points}).faces) {
      const auto a = whole(face.a), b = whole(face.b), c = whole(face.c);
      const auto normal = cross(b - a, c - a);
      REQUIRE(normal != Point{});
      areas[plane_of(normal, a)] += std::abs(normal[greatest_axis(normal)]);
    }
    REQUIRE(areas == expected);
  }
}

TEMPLATE_TEST_CASE("draw: hulls that fill the scalar's range, and frusta", "[draw]",
                   DETENT_FIXED_SCALARS) {
  using S = TestType;
  std::array<Vec<S, 3>, 8> corners;
  for (std::size_t i = 0; i < 8; ++i) {
    corners[i] = make_vec<3>([&](int k) { return (i >> k & 1) != 0 ? S::max() : S::lowest(); });
  }
  const auto cube = drawn<S, 3>(ConvexHull{corners});
  CHECK(cube.lines.size() == 12);
  for (const auto& line : cube.lines) {
    int ways = 0;
    for (int k = 0; k < 3; ++k) ways += line.a[k] != line.b[k];
    CHECK(ways == 1);
  }
  CHECK(drawn_solid<S>(ConvexHull{corners}).faces.size() == 12);
  const Frustum<S> frustum(corners);
  CHECK(drawn<S, 3>(frustum).lines.size() == 12);
  CHECK(drawn_solid<S>(frustum).faces.size() == 12);
}

}  // namespace
}  // namespace detent::test
