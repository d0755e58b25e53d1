// SPDX-License-Identifier: MIT
#include "polygon.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <numbers>
#include <numeric>

#include "support/catch.hpp"

using detent::cli::PolygonCutter;
using Vertices = std::vector<PolygonCutter::Vertex>;
using Triangles = std::vector<PolygonCutter::Triangle>;

namespace {

/// Triangulates the polygon with these vertices, within this much work.
Triangles cut(const Vertices& vertices, std::int64_t work = PolygonCutter::most_work) {
  std::vector<std::uint32_t> corners(vertices.size());
  std::iota(corners.begin(), corners.end(), 0u);
  Triangles triangles;
  REQUIRE(PolygonCutter(vertices, work).cut(corners, triangles));
  REQUIRE(triangles.size() == vertices.size() - 2);
  return triangles;
}

/// Maps a point of the xy plane to an oblique plane.
PolygonCutter::Vertex askew(double x, double y) { return {100 + x, 200 + 2 * y, 300 + x - y}; }
constexpr double askew_area = 3;  // the length of the normal, (1, 0, 1) x (0, 2, -1) = (-2, 1, 2)

std::array<double, 3> area_of(const Vertices& vertices, const PolygonCutter::Triangle& triangle) {
  std::array<double, 3> area{};
  const auto &a = vertices[triangle[0]], &b = vertices[triangle[1]], &c = vertices[triangle[2]];
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    area[i] = ((b[j] - a[j]) * (c[k] - a[k]) - (b[k] - a[k]) * (c[j] - a[j])) / 2;
  }
  return area;
}

/// The areas of the triangles add up to the polygon's, so they cover it exactly once.
void check_cover(const Vertices& vertices, double area,
                 std::int64_t work = PolygonCutter::most_work) {
  const auto triangles = cut(vertices, work);
  double sum = 0;
  for (const auto& triangle : triangles) {
    const auto part = area_of(vertices, triangle);
    sum += std::hypot(part[0], part[1], part[2]);
  }
  CHECK(std::abs(sum - area) < 1e-9 * area);
}

double unit(detent::test::Random& random) {
  return static_cast<double>(random.below(1u << 30)) / (1u << 30);
}

Vertices around(std::size_t count, const std::function<double(std::size_t)>& radius) {
  Vertices vertices;
  for (std::size_t i = 0; i < count; ++i) {
    const double angle = 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(count);
    vertices.push_back(askew(radius(i) * std::cos(angle), radius(i) * std::sin(angle)));
  }
  return vertices;
}

double area_around(std::size_t count, const std::function<double(std::size_t)>& radius) {
  double sum = 0;
  for (std::size_t i = 0; i < count; ++i) sum += radius(i) * radius((i + 1) % count);
  return sum * std::sin(2 * std::numbers::pi / static_cast<double>(count)) / 2 * askew_area;
}

}  // namespace

TEST_CASE("polygon: a convex one is a fan, and four corners are split along the shorter diagonal") {
  CHECK(cut({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}) == Triangles{{0, 1, 2}});
  CHECK(cut({{0, 0, 0}, {4, 0, 0}, {3, 1, 0}, {0, 1, 0}}) == Triangles{{0, 1, 2}, {0, 2, 3}});
  CHECK(cut({{0, 0, 0}, {3, 0, 0}, {4, 1, 0}, {0, 1, 0}}) == Triangles{{0, 1, 3}, {1, 2, 3}});
  CHECK(cut({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}) == Triangles{{0, 1, 3}, {1, 2, 3}});
  CHECK(cut({{9, 9, 9}, {11, 9, 9}, {11, 11, 9}, {10, 12, 9}, {9, 11, 9}}) ==
        Triangles{{0, 1, 2}, {0, 2, 3}, {0, 3, 4}});
}

TEST_CASE("polygon: the triangles cover it in any position and winding") {
  const Vertices shapes[] = {
      {{0, 0, 0}, {8, 1, 0}, {0, 2, 0}, {7, 1, 0}},                        // an arrowhead
      {{1, 1, 0}, {0, 0, 0}, {4, 0, 0}, {3, 1, 0}, {2, 4, 0}, {2, 1, 0}},  // corners on an edge
      {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {3, 4, 0}, {3, 1, 0}, {1, 1, 0}, {1, 4, 0}, {0, 4, 0}},
  };
  const double areas[] = {1, 4.5, 10};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t first = 0; first < shapes[i].size(); ++first) {
      for (const bool is_reversed : {false, true}) {
        Vertices vertices;
        for (const auto& [x, y, z] : shapes[i]) vertices.push_back(askew(x, y));
        std::rotate(vertices.begin(), vertices.begin() + static_cast<std::ptrdiff_t>(first),
                    vertices.end());
        if (is_reversed) std::reverse(vertices.begin(), vertices.end());
        INFO("shape " << i << ", first corner " << first << (is_reversed ? ", reversed" : ""));
        check_cover(vertices, areas[i] * askew_area);
      }
    }
  }
}

TEST_CASE("polygon: the triangles cover ragged polygons") {
  detent::test::Random random(0x4a66);
  for (int round = 0; round < 300; ++round) {
    std::vector<double> radii(5 + random.below(100));
    for (double& radius : radii) radius = 0.1 + unit(random);
    const auto radius = [&](std::size_t i) { return radii[i]; };
    INFO("seed 0x4a66, round " << round);
    check_cover(around(radii.size(), radius), area_around(radii.size(), radius));
  }
}

TEST_CASE("polygon: 120,000 corners take at most 500 corner visits each") {
  constexpr std::size_t count = 120'000;
  detent::test::Random random(0x9019);
  std::vector<double> coast(count);
  for (double& radius : coast) radius = 1 + 0.001 * unit(random);
  const std::function<double(std::size_t)> radii[] = {
      [](std::size_t) { return 1.0; },
      [](std::size_t i) { return i % 2 == 0 ? 1.0 : 2.0; },
      [&](std::size_t i) { return coast[i]; },
  };
  for (const auto& radius : radii) {
    check_cover(around(count, radius), area_around(count, radius), 500 * std::int64_t{count});
  }
}

TEST_CASE("polygon: a self-intersecting one, or one without area, gives as many triangles") {
  detent::test::Random random(0xc705);
  Vertices vertices(2000);
  for (auto& vertex : vertices) vertex = {unit(random), unit(random), unit(random)};
  cut(vertices);
  cut(Vertices(7, {1, 2, 3}));
  cut({{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {5, 5, 5}, {-1, -1, -1}});
  cut({{0, 0, 0}, {1e308, 0, 0}, {1e308, 1e308, 0}, {9e307, 1e307, 0}, {-1e308, 1e308, 0}});
  cut({{0, 0, 0}, {4e-324, 0, 0}, {4e-324, 4e-324, 0}, {0, 4e-324, 8e-324}, {4e-324, 8e-324, 0}});
}

TEST_CASE("polygon: excessive work is refused") {
  const auto radius = [](std::size_t i) { return i % 2 == 0 ? 1.0 : 2.0; };
  const auto star = around(1000, radius);
  std::vector<std::uint32_t> corners(star.size());
  std::iota(corners.begin(), corners.end(), 0u);
  Triangles triangles;
  CHECK_FALSE(PolygonCutter(star, 1000).cut(corners, triangles));
}
