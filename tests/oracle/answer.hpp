// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <sstream>
#include <string>
#include <utility>

#include "oracle/crossing.hpp"
#include "oracle/exact.hpp"

namespace detent::oracle {

template <std::size_t N>
std::string text(const std::array<std::int64_t, N>& a) {
  std::ostringstream out;
  for (std::size_t i = 0; i < N; ++i) out << (i == 0 ? "{" : ", ") << a[i];
  out << "}";
  return out.str();
}

/// The exact results of all three raycasts, rounded as the contract says.
template <int N>
struct Expected {
  struct Hit {
    std::int64_t enter;
    std::int64_t exit;
    Raw<N> point;
    NormalPointer<N> normal;
  };
  std::optional<Hit> hit;
};

/// The library's results, in raw numbers.
template <int N>
struct Given {
  struct Hit {
    std::int64_t distance;
    Raw<N> point;
    Raw<N> normal;
  };
  std::optional<std::int64_t> distance;
  std::optional<Hit> hit;
  std::optional<std::pair<std::int64_t, std::int64_t>> interval;
};

/// `origin + distance * direction`, rounded to nearest even and clamped to the scalar's range.
template <Scalar S, int N>
Raw<N> point_at(const Ray<S, N>& ray, const Integer& distance) {
  const auto line = exact(ray);
  const Integer lowest = raw(S::lowest()), highest = raw(S::max());
  Raw<N> point{};
  for (std::size_t i = 0; i < point.size(); ++i) {
    const Integer along = line.origin[i] * line.one + distance * line.direction[i];
    point[i] =
        static_cast<std::int64_t>(std::clamp(nearest_quotient(along, line.one), lowest, highest));
  }
  return point;
}

template <Scalar S, int N, Readable Shape>
Expected<N> expected_raycast(const Ray<S, N>& ray, const Shape& shape) {
  const auto found = crossing(exact(ray), exact(shape));
  if (!found) return {};
  return {typename Expected<N>::Hit{static_cast<std::int64_t>(found->enter),
                                    static_cast<std::int64_t>(found->exit),
                                    point_at(ray, found->enter), found->normal}};
}

/// Whether the ray runs against the normal, as Facing::front requires.
template <Scalar S, int N>
bool meets_front(const Ray<S, N>& ray, const Plane<S, N>& plane) {
  return dot(widen(raw(plane.normal)), widen(raw(ray.direction))) < 0;
}
/// By Cramer's rule, to avoid reusing the cross product.
template <Scalar S>
bool meets_front(const Ray<S, 3>& ray, const Triangle<S, 3>& triangle) {
  const auto a = raw(triangle.a), d = widen(raw(ray.direction));
  const auto u = difference(raw(triangle.b), a), v = difference(raw(triangle.c), a);
  Integer determinant = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    determinant += u[i] * v[j] * d[k] - u[i] * v[k] * d[j];
  }
  return determinant < 0;
}

/// Empty when `given` is right, otherwise a line per wrong result.
template <int N>
std::string mistakes(const Expected<N>& expected, const Given<N>& given) {
  std::string out;  // no stream: it takes longer than the queries of a small world
  const auto& exact = expected.hit;
  if (given.distance.has_value() != exact.has_value() ||
      (exact && *given.distance != exact->enter)) {
    out += "  raycast: expected " + (exact ? std::to_string(exact->enter) : "a miss") + ", got " +
           (given.distance ? std::to_string(*given.distance) : "a miss") + "\n";
  }
  if (given.interval.has_value() != exact.has_value() ||
      (exact && *given.interval != std::pair{exact->enter, exact->exit})) {
    const auto interval = [](std::int64_t enter, std::int64_t exit) {
      return std::to_string(enter) + " to " + std::to_string(exit);
    };
    out += "  raycast_interval: expected " +
           (exact ? interval(exact->enter, exact->exit) : "a miss") + ", got " +
           (given.interval ? interval(given.interval->first, given.interval->second) : "a miss") +
           "\n";
  }
  if (given.hit.has_value() != exact.has_value()) {
    out += std::string("  raycast_hit: expected a ") + (exact ? "hit\n" : "miss\n");
  } else if (exact) {
    if (given.hit->distance != exact->enter) {
      out += "  raycast_hit: expected distance " + std::to_string(exact->enter) + ", got " +
             std::to_string(given.hit->distance) + "\n";
    }
    if (given.hit->point != exact->point) {
      out += "  raycast_hit: expected point " + text(exact->point) + ", got " +
             text(given.hit->point) + "\n";
    }
    if (!exact->normal->allows(given.hit->normal)) {
      out += "  raycast_hit: expected normal " + exact->normal->text() + ", got " +
             text(given.hit->normal) + "\n";
    }
  }
  return out;
}

}  // namespace detent::oracle
