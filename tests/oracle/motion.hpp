// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

// An independent implementation of moving bodies: poses by the definition of their motion,
// distances as the least of all pairs of features. It uses doubles of raw units, whose errors are
// below 2^-12 of a unit, and includes nothing of the library.

namespace detent::oracle::motion {

using Point = std::array<double, 3>;

inline Point minus(const Point& a, const Point& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
inline Point along(const Point& a, const Point& v, double t) {
  return {a[0] + v[0] * t, a[1] + v[1] * t, a[2] + v[2] * t};
}
inline double dot(const Point& a, const Point& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
inline Point cross(const Point& a, const Point& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline double length(const Point& a) { return std::sqrt(dot(a, a)); }

/// All points within `radius` of the hull of `corners`, in a frame that moves from `start` to `end`
/// and turns along a line from the quaternion `from` to `to` (x, y, z, w; of any length). Flat bodies
/// have z = 0.
struct Body {
  std::vector<Point> corners;
  double radius = 0;
  Point start{}, end{};
  std::array<double, 4> from{0, 0, 0, 1}, to{0, 0, 0, 1};

  [[nodiscard]] std::vector<Point> at(double t) const {
    std::array<double, 4> q{};
    for (std::size_t i = 0; i < 4; ++i) q[i] = (1 - t) * from[i] + t * to[i];
    const Point u{q[0], q[1], q[2]};
    const double squared = dot(u, u) + q[3] * q[3];
    std::vector<Point> result;
    for (const auto& corner : corners) {
      // c + 2 (w u x c + u x (u x c)) / |q|^2
      const Point uc = cross(u, corner), uuc = cross(u, uc);
      auto p = along(along(corner, uc, 2 * q[3] / squared), uuc, 2 / squared);
      for (std::size_t i = 0; i < 3; ++i) p[i] += (1 - t) * start[i] + t * end[i];
      result.push_back(p);
    }
    return result;
  }

  /// The radius of its core about the origin of its frame.
  [[nodiscard]] double reach() const {
    double most = 0;
    for (const auto& corner : corners) most = std::max(most, length(corner));
    return most;
  }
};

/// The shortest vector offered, with a direction that is more accurate than its own coordinates.
struct Shortest {
  Point direction{};
  double length = std::numeric_limits<double>::infinity();

  void offer(const Point& v, const Point& exact_direction) {
    const double l = motion::length(v);
    if (!(l < length)) return;
    length = l;
    const double sign = dot(v, exact_direction) < 0 ? -1 : 1;
    direction = along({}, exact_direction, sign / motion::length(exact_direction));
  }
};

/// From a point to a segment, or the reverse if `sign` is -1.
inline void offer_point(Shortest& best, const Point& p, const Point& a, const Point& b,
                        double sign) {
  const Point u = minus(b, a);
  const double squared = dot(u, u);
  const double s = squared > 0 ? dot(minus(a, p), u) / -squared : 0;
  const double clamped = std::min(1.0, std::max(0.0, s));
  const Point v = along({}, minus(along(a, u, clamped), p), sign);
  // Inside the segment it is perpendicular to it.
  const bool is_inside = s == clamped && squared > 0;
  best.offer(v, is_inside ? along(v, u, -dot(v, u) / squared) : v);
}

/// From segment a b to segment c d: from each end, and inside, if their lines come closest there.
inline void offer_segments(Shortest& best, const Point& a, const Point& b, const Point& c,
                           const Point& d) {
  offer_point(best, a, c, d, 1);
  offer_point(best, b, c, d, 1);
  offer_point(best, c, a, b, -1);
  offer_point(best, d, a, b, -1);
  const Point u = minus(b, a), v = minus(d, c), w = minus(c, a);
  const double uu = dot(u, u), vv = dot(v, v), uv = dot(u, v);
  const double area = uu * vv - uv * uv;
  if (!(area > 1e-14 * uu * vv)) return;
  const double s = (dot(w, u) * vv - dot(w, v) * uv) / area;
  const double t = (dot(w, u) * uv - dot(w, v) * uu) / area;
  if (s < 0 || s > 1 || t < 0 || t > 1) return;
  best.offer(minus(along(c, v, t), along(a, u, s)), cross(u, v));
}

/// From the inside of a triangle to a point, if it is closest there, or the reverse if `sign` is
/// -1.
inline void offer_face(Shortest& best, const Point& p, const Point& a, const Point& b,
                       const Point& c, double sign) {
  const Point n = cross(minus(b, a), minus(c, a));
  const double squared = dot(n, n);
  if (!(squared > 0)) return;
  const double height = dot(minus(p, a), n) / squared;
  const Point foot = along(p, n, -height);
  const auto side = [&](const Point& from, const Point& to) {
    return dot(cross(minus(to, from), minus(foot, from)), n);
  };
  if (side(a, b) < 0 || side(b, c) < 0 || side(c, a) < 0) return;
  best.offer(along({}, n, sign * height), n);
}

/// The distance of the hulls of two lists of points, 0 if they overlap.
inline double distance(const std::vector<Point>& a, const std::vector<Point>& b) {
  Shortest best;  // from a to b
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t j = i; j < a.size(); ++j) {
      if (i == j && a.size() > 1) continue;
      for (std::size_t k = 0; k < b.size(); ++k) {
        for (std::size_t l = k; l < b.size(); ++l) {
          if (k == l && b.size() > 1) continue;
          offer_segments(best, a[i], a[j], b[k], b[l]);
        }
      }
    }
  }
  const auto faces = [&](const std::vector<Point>& of, const std::vector<Point>& to, double sign) {
    for (std::size_t i = 0; i < of.size(); ++i) {
      for (std::size_t j = i + 1; j < of.size(); ++j) {
        for (std::size_t k = j + 1; k < of.size(); ++k) {
          for (const auto& p : to) offer_face(best, p, of[i], of[j], of[k], sign);
        }
      }
    }
  };
  faces(a, b, 1);
  faces(b, a, -1);
  if (!(best.length > 1e-3)) return 0;
  // They are apart only if that direction separates them, by that distance.
  double most_a = -std::numeric_limits<double>::infinity(), least_b = -most_a;
  for (const auto& p : a) most_a = std::max(most_a, dot(minus(p, a[0]), best.direction));
  for (const auto& p : b) least_b = std::min(least_b, dot(minus(p, a[0]), best.direction));
  return std::max(least_b - most_a, 0.0);
}

/// The distance of two bodies at time t; 0 or less if they touch.
inline double gap(const Body& a, const Body& b, double t) {
  return distance(a.at(t), b.at(t)) - a.radius - b.radius;
}

}  // namespace detent::oracle::motion
