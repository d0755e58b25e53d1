// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <sstream>
#include <string>
#include <type_traits>

#include "detent/query/time_of_impact.hpp"
#include "detent/shape/shape.hpp"
#include "oracle/motion.hpp"
#include "support/shapes.hpp"

namespace detent::oracle {

template <Scalar S, Number T, int N>
motion::Point raw_point(const Vec<T, N>& v) {
  motion::Point p{};
  for (int i = 0; i < N; ++i) {
    p[static_cast<std::size_t>(i)] = static_cast<double>(v[i]) * std::ldexp(1.0, S::frac);
  }
  return p;
}

/// Points, and a radius around them.
template <support::OfPoints Shape>
void add_corners(motion::Body& body, const Shape& shape) {
  support::visit_fields(shape, [&]<class Field>(const Field& field) {
    if constexpr (support::is_point<Field>) {
      body.corners.push_back(raw_point<std::remove_cvref_t<decltype(field.x)>>(field));
    } else {
      body.radius = field.raw();
    }
  });
}
template <Scalar S, int N>
void add_corners(motion::Body& body, const ConvexHull<S, N>& hull) {
  for (const auto& point : hull.points) body.corners.push_back(raw_point<S>(point));
}
template <Scalar S, int N>
void add_corners(motion::Body& body, const Aabb<S, N>& box) {
  const auto low = raw_point<S>(box.min), high = raw_point<S>(box.max);
  for (std::size_t k = 0; k < std::size_t{1} << N; ++k) {
    motion::Point corner = low;
    for (std::size_t i = 0; i < N; ++i) corner[i] = (k >> i & 1) != 0 ? high[i] : low[i];
    body.corners.push_back(corner);
  }
}
template <Scalar S, int N>
void add_corners(motion::Body& body, const Obb<S, N>& box) {
  const auto extents = raw_point<S>(box.half_extents);
  for (std::size_t k = 0; k < std::size_t{1} << N; ++k) {
    auto corner = raw_point<S>(box.center);
    for (std::size_t i = 0; i < N; ++i) {
      const auto& axis = box.rotation.axis(static_cast<int>(i)).vec();
      const double side = (k >> i & 1) != 0 ? extents[i] : -extents[i];
      for (int j = 0; j < N; ++j) {
        corner[static_cast<std::size_t>(j)] += side * static_cast<double>(axis[j]);
      }
    }
    body.corners.push_back(corner);
  }
}

/// The quaternion of a rotation; in 2D of the rotation about the z axis, with half its angle.
template <Scalar S, int N>
std::array<double, 4> quaternion(const Rotation<S, N>& rotation) {
  Rotation<S, 3> space;
  if constexpr (N == 3) {
    space = rotation;
  } else {
    const auto lifted = [&](int i) {
      return Direction<S, 3>::assume_unit(
          {rotation.axis(i)[0], rotation.axis(i)[1], direction_component<S>(0)});
    };
    space = Rotation<S, 3>::from_axes({lifted(0), lifted(1), Direction<S, 3>::along(2)});
  }
  const auto q = Quat<S>::from_rotation(space);
  return {static_cast<double>(q.x()), static_cast<double>(q.y()), static_cast<double>(q.z()),
          static_cast<double>(q.w())};
}

/// `shape` moved by `sweep`, in raw units.
template <class Shape, Scalar S, int N>
motion::Body moving(const Shape& shape, const Sweep<S, N>& sweep) {
  motion::Body body;
  add_corners(body, shape);
  body.start = raw_point<S>(sweep.start);
  body.end = raw_point<S>(sweep.end);
  body.from = quaternion(sweep.start_rotation);
  body.to = quaternion(sweep.end_rotation);
  // Which way is shorter is decided exactly: near half a turn, doubles would cancel.
  std::int64_t side = 0;
  const auto raw = [](double x) {
    return static_cast<std::int64_t>(std::ldexp(x, direction_component<S>::frac));
  };
  for (std::size_t i = 0; i < 4; ++i) side += raw(body.from[i]) * raw(body.to[i]);
  if (side < 0) {
    for (auto& x : body.to) x = -x;
  }
  return body;
}

/// The upper bound of the distance at a hit, in raw units: see `time_of_impact`.
template <Scalar S>
double stated_distance(const motion::Body& a, const motion::Body& b, const S& target) {
  const double unit = std::ldexp(1.0, -direction_component<S>::frac);
  // A frame turns by at most 4 radians in the time from 0 to 1.
  const auto way = [&](const motion::Body& body) {
    return motion::length(motion::minus(body.end, body.start)) + 4 * body.reach();
  };
  const double rounding = 10 + 32 * unit * (a.reach() + b.reach());
  return std::max(static_cast<double>(target.raw()), rounding + unit * (way(a) + way(b)));
}

/// Describes what is wrong with the result for two bodies; empty if nothing is. They must be apart
/// at every sampled time before that of the impact, or at every sampled time if there is none, and
/// as close as stated at the impact.
template <Scalar S>
std::optional<std::string> fault_of(const std::optional<Impact<S>>& impact, const motion::Body& a,
                                    const motion::Body& b, const S& target, int samples) {
  const auto problem = [&](const char* what, double t, double gap) {
    std::ostringstream text;
    text.precision(12);
    text << what << " at " << t << ", gap " << gap;
    if (impact) {
      text << ", impact at " << static_cast<double>(impact->time) << " within "
           << impact->distance.raw();
    }
    return text.str();
  };
  const double unit = std::ldexp(1.0, -direction_component<S>::frac);
  const double end = impact ? static_cast<double>(impact->time) : 1;
  if (end > 0) {
    for (int k = 0; k < samples + 3; ++k) {
      const double t = k < samples ? end * (k + 0.5) / samples : end - unit * (k - samples) / 2;
      if (t < 0) continue;
      const double gap = motion::gap(a, b, t);
      if (!(gap > 0)) return problem("touch before the impact", t, gap);
    }
  }
  if (!impact) return std::nullopt;
  if (impact->time < 0 || impact->time > 1) return problem("no such time", end, 0);
  const double gap = std::max(motion::gap(a, b, end), 0.0);
  const double within = impact->distance.raw();
  const bool is_clamped = impact->distance == S::max();
  if (gap > within + 1e-2 && !is_clamped) return problem("farther than the distance", end, gap);
  // The rounding of poses counts twice.
  const double loose = 8 + 8 * unit * (a.reach() + b.reach());
  if (within > gap + loose) return problem("closer than the distance", end, gap);
  if (impact->is_hit && within > std::ceil(stated_distance(a, b, target))) {
    return problem("farther than stated", end, gap);
  }
  return std::nullopt;
}

}  // namespace detent::oracle
