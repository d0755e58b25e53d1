// SPDX-License-Identifier: MIT
#include "polygon.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace detent::cli {
namespace {

using Vertex = PolygonCutter::Vertex;

double squared_distance(const Vertex& a, const Vertex& b) {
  double sum = 0;
  for (std::size_t i = 0; i < 3; ++i) sum += (b[i] - a[i]) * (b[i] - a[i]);
  return sum;
}

}  // namespace

/// Positive when a, b, c turn left.
double PolygonCutter::turn(const Point& a, const Point& b, const Point& c) {
  return (b.u - a.u) * (c.v - b.v) - (b.v - a.v) * (c.u - b.u);
}

/// Sets `points_` to the corners as seen from the side on which they run counterclockwise, scaled
/// so that no product overflows.
void PolygonCutter::project(std::span<const std::uint32_t> corners) {
  double scale = 0;
  for (const auto corner : corners) {
    for (const double coordinate : vertices_[corner]) {
      scale = std::max(scale, std::abs(coordinate));
    }
  }
  if (scale == 0) scale = 1;
  const Vertex& origin = vertices_[corners.front()];
  const auto relative = [&](std::size_t i) {
    Vertex result{};
    for (std::size_t k = 0; k < 3; ++k) {
      result[k] = vertices_[corners[i]][k] / scale - origin[k] / scale;
    }
    return result;
  };
  Vertex normal{};
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vertex a = relative(i), b = relative(i + 1 < corners.size() ? i + 1 : 0);
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t u = (k + 1) % 3, v = (k + 2) % 3;
      normal[k] += (a[u] - b[u]) * (a[v] + b[v]);
    }
  }
  std::size_t axis = 0;
  for (const std::size_t k : {1u, 2u}) {
    if (std::abs(normal[k]) > std::abs(normal[axis])) axis = k;
  }
  std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
  if (normal[axis] < 0) std::swap(u, v);
  points_.resize(corners.size());
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vertex point = relative(i);
    points_[i] = {point[u], point[v]};
  }
}

bool PolygonCutter::is_reflex(std::size_t corner) const {
  return turn(points_[previous_[corner]], points_[corner], points_[next_[corner]]) < 0;
}

std::size_t PolygonCutter::cell_of(double value, double low, double high) const {
  if (!(value > low)) return 0;
  const double cell = (value - low) / (high - low) * static_cast<double>(side_);
  return cell < static_cast<double>(side_ - 1) ? static_cast<std::size_t>(cell) : side_ - 1;
}

void PolygonCutter::find_reflex_corners() {
  reflex_.assign(points_.size(), false);
  reflex_count_ = 0;
  for (std::size_t i = 0; i < points_.size(); ++i) {
    if (!is_reflex(i)) continue;
    reflex_[i] = true;
    ++reflex_count_;
  }
}

/// About one cell for each reflex corner.
void PolygonCutter::fill_grid() {
  bool is_first = true;
  for (std::size_t i = 0; i < points_.size(); ++i) {
    if (!reflex_[i]) continue;
    const Point& p = points_[i];
    low_ = is_first ? p : Point{std::min(low_.u, p.u), std::min(low_.v, p.v)};
    high_ = is_first ? p : Point{std::max(high_.u, p.u), std::max(high_.v, p.v)};
    is_first = false;
  }
  filled_count_ = reflex_count_;
  side_ = static_cast<std::size_t>(std::sqrt(static_cast<double>(reflex_count_)));
  cells_.assign(side_ * side_, {});
  for (std::size_t i = 0; i < points_.size(); ++i) {
    if (!reflex_[i]) continue;
    const Point& p = points_[i];
    cells_[cell_of(p.v, low_.v, high_.v) * side_ + cell_of(p.u, low_.u, high_.u)].push_back(i);
  }
}

void PolygonCutter::clear_reflex(std::size_t corner) {
  if (!reflex_[corner]) return;
  reflex_[corner] = false;
  --reflex_count_;
}

/// Whether the triangle of the corner and its neighbours contains no other corner.
bool PolygonCutter::is_ear(std::size_t corner) {
  const Point &a = points_[previous_[corner]], &b = points_[corner], &c = points_[next_[corner]];
  const double area = turn(a, b, c);
  if (!(area > 0)) return area == 0;  // a corner on a straight edge can always be cut
  const Point low{std::min({a.u, b.u, c.u}), std::min({a.v, b.v, c.v})};
  const Point high{std::max({a.u, b.u, c.u}), std::max({a.v, b.v, c.v})};
  if (reflex_count_ == 0) return true;
  if (reflex_count_ < filled_count_ / 4)
    fill_grid();  // ears grow, but visit no more cells than before
  if (low.u > high_.u || high.u < low_.u || low.v > high_.v || high.v < low_.v) return true;
  // Row by row, from the first to the last column that the triangle reaches in the row, plus a
  // margin for rounding, so that no corner is in a cell that is skipped.
  const double height = (high_.v - low_.v) / static_cast<double>(side_);
  const double slack = (high_.u - low_.u) / static_cast<double>(side_) / 8;
  const std::size_t last_row = cell_of(high.v, low_.v, high_.v);
  for (std::size_t row = cell_of(low.v, low_.v, high_.v); row <= last_row; ++row) {
    const double bottom = low_.v + height * (static_cast<double>(row) - 0.125);
    const double top = bottom + height * 1.25;
    double first = high.u, last = low.u;
    for (const auto& [p, q] : {std::pair(a, b), std::pair(b, c), std::pair(c, a)}) {
      if (std::max(p.v, q.v) < bottom || std::min(p.v, q.v) > top) continue;
      for (const double v : {std::clamp(p.v, bottom, top), std::clamp(q.v, bottom, top)}) {
        const double u = p.v == q.v ? p.u : p.u + (q.u - p.u) * ((v - p.v) / (q.v - p.v));
        first = std::min({first, u, p.v == q.v ? q.u : u});
        last = std::max({last, u, p.v == q.v ? q.u : u});
      }
    }
    const std::size_t last_column = cell_of(last + slack, low_.u, high_.u);
    for (std::size_t column = cell_of(first - slack, low_.u, high_.u); column <= last_column;
         ++column) {
      auto& cell = cells_[row * side_ + column];
      std::erase_if(cell, [&](std::size_t i) { return !reflex_[i]; });
      work_left_ -= static_cast<std::int64_t>(cell.size()) + 1;
      for (const std::size_t i : cell) {
        const Point& p = points_[i];
        const bool is_inside = turn(a, b, p) >= 0 && turn(b, c, p) >= 0 && turn(c, a, p) >= 0;
        if (is_inside && p != a && p != b && p != c) return false;
      }
    }
  }
  return true;
}

void PolygonCutter::remove(std::size_t corner) {
  const std::size_t before = previous_[corner], after = next_[corner];
  next_[before] = after;
  previous_[after] = before;
  clear_reflex(corner);
  // Cutting an ear never makes a neighbour reflex.
  if (!is_reflex(before)) clear_reflex(before);
  if (!is_reflex(after)) clear_reflex(after);
}

/// Queues the corner if it is an ear.
void PolygonCutter::look_at(std::size_t corner) {
  ear_[corner] = is_ear(corner);
  if (!ear_[corner] || queued_[corner]) return;
  queued_[corner] = true;
  queue_.push_back(corner);
}

bool PolygonCutter::cut(std::span<const std::uint32_t> corners, std::vector<Triangle>& triangles) {
  const std::size_t count = corners.size();
  const auto append = [&](std::size_t a, std::size_t b, std::size_t c) {
    triangles.push_back({corners[a], corners[b], corners[c]});
  };
  if (count == 3) {
    append(0, 1, 2);
    return true;
  }
  project(corners);
  previous_.resize(count);
  next_.resize(count);
  std::iota(next_.begin(), next_.end(), std::size_t{1});
  std::iota(previous_.begin() + 1, previous_.end(), std::size_t{0});
  next_.back() = 0;
  previous_.front() = count - 1;
  find_reflex_corners();
  if (reflex_count_ == 0) {
    const auto length = [&](std::size_t a, std::size_t b) {
      return squared_distance(vertices_[corners[a]], vertices_[corners[b]]);
    };
    if (count == 4 && !(length(0, 2) < length(1, 3))) {
      append(0, 1, 3);
      append(1, 2, 3);
    } else {
      for (std::size_t i = 2; i < count; ++i) append(0, i - 1, i);
    }
    return true;
  }
  fill_grid();
  ear_.assign(count, false);
  queued_.assign(count, false);
  queue_.clear();
  for (std::size_t i = 0; i < count; ++i) look_at(i);
  std::size_t any = 0;
  for (std::size_t left = count, head = 0; left > 2;) {
    if (work_left_ < 0) return false;
    std::size_t corner = any;
    if (head < queue_.size()) {
      corner = queue_[head++];
      queued_[corner] = false;
      if (!ear_[corner]) continue;
    }
    const std::size_t before = previous_[corner], after = next_[corner];
    append(before, corner, after);
    remove(corner);
    ear_[corner] = false;
    look_at(before);
    look_at(after);
    any = after;
    --left;
  }
  return true;
}

}  // namespace detent::cli
