// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace detent::cli {

/// Cuts polygons in space into triangles, n - 2 for n corners.
///
/// A convex polygon becomes the fan around its first corner, except that one with four corners is
/// cut along its shorter diagonal. From any other polygon, seen along its normal, ears are cut off
/// one by one. If there is no ear, as in a self-intersecting polygon, some corner is cut off
/// anyway.
///
/// source: ear clipping, Meisters, Polygons Have Ears; only the neighbours of a cut ear are checked
///         again; normal by Newell's sums
class PolygonCutter {
 public:
  using Vertex = std::array<double, 3>;
  using Triangle = std::array<std::uint32_t, 3>;

  /// How many corners may be tested for ears: a few seconds' worth.
  static constexpr std::int64_t most_work = std::int64_t{1} << 30;

  explicit PolygonCutter(std::span<const Vertex> vertices, std::int64_t work = most_work)
      : vertices_(vertices), work_left_(work) {}

  /// Appends the triangles of the polygon with these vertices, at least three. Returns false, with
  /// some triangles missing, when all polygons together have used up `most_work`.
  [[nodiscard]] bool cut(std::span<const std::uint32_t> corners, std::vector<Triangle>& triangles);

 private:
  struct Point {
    double u = 0;
    double v = 0;
    friend bool operator==(const Point&, const Point&) = default;
  };

  static double turn(const Point& a, const Point& b, const Point& c);
  void project(std::span<const std::uint32_t> corners);
  [[nodiscard]] bool is_reflex(std::size_t corner) const;
  void find_reflex_corners();
  void fill_grid();
  void clear_reflex(std::size_t corner);
  [[nodiscard]] std::size_t cell_of(double value, double low, double high) const;
  [[nodiscard]] bool is_ear(std::size_t corner);
  void remove(std::size_t corner);
  void look_at(std::size_t corner);

  std::span<const Vertex> vertices_;
  std::int64_t work_left_;

  // Of the current polygon, by corner.
  std::vector<Point> points_;
  std::vector<std::size_t> previous_, next_;
  std::vector<bool> reflex_, ear_, queued_;
  std::vector<std::size_t> queue_;  // ears, some of them outdated

  // The reflex corners in the cells of a grid: only they can lie in an ear. Their number now, and
  // when the grid was filled.
  std::size_t reflex_count_ = 0;
  std::size_t filled_count_ = 0;
  Point low_, high_;
  std::size_t side_ = 0;
  std::vector<std::vector<std::size_t>> cells_;
};

}  // namespace detent::cli
