// SPDX-License-Identifier: MIT
#include "exact_group.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace detent::cli {
namespace {

using Doubles = std::array<double, 3>;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double trusted = 1 << 30;         // nothing is culled beyond this distance
constexpr double margin = 1.0 / (1 << 10);  // on each side of a box

/// Three numbers of a list, starting at index 3 * `place`.
Doubles approximate(const std::vector<Exact>& numbers, std::size_t place) {
  return {numbers[3 * place].approximate(), numbers[3 * place + 1].approximate(),
          numbers[3 * place + 2].approximate()};
}

double dot(const Doubles& a, const Doubles& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

bool is_trusted(const Doubles& point) {
  return std::all_of(point.begin(), point.end(), [](double x) { return std::abs(x) < trusted; });
}

}  // namespace

/// The errors that the margin of a box covers. Coordinates below 2^30 and their differences are off
/// by less than 2^-20, and so are times along directions about one unit long; components of a cross
/// product by less than 2^-20 of what the margin adds to the other side. Comparisons with infinity
/// or NaN cull nothing.
struct ExactGroup::Probe {
  explicit Probe(const ExactShape& ray)
      : origin(approximate(ray.lengths, 0)),
        direction(approximate(ray.directions, 0)),
        squared_length(dot(direction, direction)),
        limit(ray.lengths[3].approximate()),
        is_usable(is_trusted(origin)) {}

  Doubles to_middle(const Box& box) const {
    Doubles way{};
    for (std::size_t i = 0; i < 3; ++i) way[i] = (box.low[i] + box.high[i]) / 2 - origin[i];
    return way;
  }

  /// False if the ray misses the box, starts beyond it or ends before it.
  bool may_meet(const Box& box) const {
    if (!is_usable) return true;
    const Doubles way = to_middle(box);
    Doubles half{};
    double reach = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      half[i] = (box.high[i] - box.low[i]) / 2;
      reach += half[i] * std::abs(direction[i]);
    }
    const double middle = dot(way, direction);
    if (middle + reach < 0 || middle - reach > limit * squared_length) return false;
    // The separating axes of a line and a box: cross products of the line and an edge.
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3;
      const std::size_t k = (i + 2) % 3;
      const double apart = std::abs(way[j] * direction[k] - way[k] * direction[j]);
      if (apart > half[j] * std::abs(direction[k]) + half[k] * std::abs(direction[j])) return false;
    }
    return true;
  }

  Doubles origin;
  Doubles direction;
  double squared_length;
  double limit;
  bool is_usable;
  std::optional<Integer> best{};
};

ExactGroup::Box ExactGroup::box_around(const ExactShape& shape) {
  std::vector<Doubles> points;
  double radius = margin;
  using Form = ExactShape::Form;
  if (shape.form == Form::ball) {
    points = {approximate(shape.lengths, 0)};
    radius += std::abs(shape.lengths[3].approximate());
  } else if (shape.form == Form::turned_box) {
    points = {approximate(shape.lengths, 0)};
    // Axes are within 1e-3 of unit length in every scalar.
    const Doubles half = approximate(shape.lengths, 1);
    radius += 1.01 * std::sqrt(dot(half, half));
  } else if (shape.form == Form::box || shape.form == Form::face) {
    for (std::size_t i = 0; 3 * i < shape.lengths.size(); ++i) {
      points.push_back(approximate(shape.lengths, i));
    }
  }

  Box result{{infinity, infinity, infinity}, {-infinity, -infinity, -infinity}};
  for (const Doubles& point : points) {
    for (std::size_t i = 0; i < 3; ++i) {
      result.low[i] = std::min(result.low[i], point[i] - radius);
      result.high[i] = std::max(result.high[i], point[i] + radius);
    }
  }
  if (points.empty() || !is_trusted(result.low) || !is_trusted(result.high)) {
    return {{-infinity, -infinity, -infinity}, {infinity, infinity, infinity}};
  }
  return result;
}

ExactGroup::ExactGroup(std::vector<ExactShape> shapes) : shapes_(std::move(shapes)) {
  std::vector<std::pair<Box, std::size_t>> items;
  for (const ExactShape& shape : shapes_) items.emplace_back(box_around(shape), items.size());
  if (!items.empty()) build(items, 0, items.size());
}

/// Splits [begin, end) in half along the longest side of its box until one shape is left.
void ExactGroup::build(std::vector<std::pair<Box, std::size_t>>& items, std::size_t begin,
                       std::size_t end) {
  Box whole = items[begin].first;
  for (std::size_t i = begin + 1; i < end; ++i) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      whole.low[axis] = std::min(whole.low[axis], items[i].first.low[axis]);
      whole.high[axis] = std::max(whole.high[axis], items[i].first.high[axis]);
    }
  }
  const std::size_t place = nodes_.size();
  nodes_.push_back({whole, items[begin].second, 0});
  if (end - begin == 1) return;

  std::size_t longest = 0;
  for (std::size_t axis = 1; axis < 3; ++axis) {
    if (whole.high[axis] - whole.low[axis] > whole.high[longest] - whole.low[longest]) {
      longest = axis;
    }
  }
  const std::size_t middle = begin + (end - begin) / 2;
  const auto at = [&](std::size_t i) { return items.begin() + static_cast<std::ptrdiff_t>(i); };
  std::nth_element(at(begin), at(middle), at(end), [&](const auto& a, const auto& b) {
    return a.first.low[longest] < b.first.low[longest];
  });
  build(items, begin, middle);
  nodes_[place].second = nodes_.size();
  build(items, middle, end);
}

std::optional<Integer> ExactGroup::first_hit(const ExactShape& ray) const {
  Probe probe(ray);
  if (!nodes_.empty()) search(0, ray, probe);
  return probe.best;
}

void ExactGroup::search(std::size_t node, const ExactShape& ray, Probe& probe) const {
  const auto& [box, shape, second] = nodes_[node];
  if (!probe.may_meet(box)) return;
  if (second == 0) {
    const auto hit = cli::first_hit(ray, shapes_[shape]);
    if (!hit || (probe.best && *probe.best <= *hit)) return;
    probe.best = *hit;
    probe.limit = std::ldexp(static_cast<double>(*hit), -distance_frac);
    return;
  }
  const auto distance = [&](std::size_t child) {
    return dot(probe.to_middle(nodes_[child].box), probe.direction);
  };
  std::size_t near = node + 1;
  std::size_t far = second;
  if (distance(far) < distance(near)) std::swap(near, far);
  search(near, ray, probe);
  search(far, ray, probe);
}

}  // namespace detent::cli
