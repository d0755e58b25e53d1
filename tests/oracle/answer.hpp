// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <sstream>
#include <string>
#include <utility>

#include "oracle/exact.hpp"

namespace detent::oracle {

template <std::size_t N>
std::string text(const std::array<std::int64_t, N>& a) {
  std::ostringstream out;
  for (std::size_t i = 0; i < N; ++i) out << (i == 0 ? "{" : ", ") << a[i];
  out << "}";
  return out.str();
}

/// The set of right normals.
template <int N>
struct Normal {
  virtual ~Normal() = default;
  [[nodiscard]] virtual bool allows(const Raw<N>& given) const = 0;
  [[nodiscard]] virtual std::string text() const = 0;
};

/// A normal that is one of the stored directions.
template <int N>
struct StoredNormal final : Normal<N> {
  Raw<N> direction;

  explicit StoredNormal(const Raw<N>& exact) : direction(exact) {}
  [[nodiscard]] bool allows(const Raw<N>& given) const override { return given == direction; }
  [[nodiscard]] std::string text() const override { return oracle::text(direction); }
};

/// A normal along an integer vector: every component rounded to nearest. There are no ties: a tie
/// would need a vector of even length whose components have no common factor, which squares modulo
/// 4 rule out.
template <int N>
struct NormalizedNormal final : Normal<N> {
  Vector<N> along;
  int shift;

  NormalizedNormal(Vector<N> exact, int frac) : along(std::move(exact)), shift(frac) {}
  [[nodiscard]] bool allows(const Raw<N>& given) const override {
    const Integer length_squared = dot(along, along);
    for (std::size_t i = 0; i < given.size(); ++i) {
      const int sign = along[i].sign();
      const Integer magnitude = sign < 0 ? Integer(-given[i]) : Integer(given[i]);
      if (magnitude < 0 || (sign == 0 && magnitude != 0)) return false;
      const Integer twice = (along[i] * along[i]) << static_cast<unsigned>(2 * shift + 2);
      const Integer above = 2 * magnitude + 1;
      const Integer below = 2 * magnitude - 1;
      if (twice > above * above * length_squared) return false;
      if (magnitude > 0 && twice < below * below * length_squared) return false;
    }
    return true;
  }
  [[nodiscard]] std::string text() const override {
    std::string out = "along";
    for (const auto& component : along) out += " " + component.str();
    return out;
  }
};

template <int N>
using NormalPointer = std::shared_ptr<const Normal<N>>;

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
template <int N>
Raw<N> point_at(const Line<N>& line, std::int64_t distance) {
  Raw<N> point{};
  for (std::size_t i = 0; i < point.size(); ++i) {
    const Integer exact = line.origin[i] * line.one + distance * line.direction[i];
    const auto nearest = static_cast<std::int64_t>(nearest_even(exact, line.shift));
    point[i] = nearest < line.lowest    ? line.lowest
               : nearest > line.highest ? line.highest
                                        : nearest;
  }
  return point;
}

template <int N>
Expected<N> hit(const Line<N>& line, std::int64_t enter, std::int64_t exit,
                NormalPointer<N> normal) {
  return {typename Expected<N>::Hit{enter, exit, point_at(line, enter), std::move(normal)}};
}

template <int N>
NormalPointer<N> stored(const Raw<N>& direction) {
  return std::make_shared<StoredNormal<N>>(direction);
}
template <int N>
NormalPointer<N> normalized(Vector<N> along, const Line<N>& line) {
  return std::make_shared<NormalizedNormal<N>>(std::move(along), line.shift);
}
/// The normal when a ray starts inside a solid, or hits a shape without an inside.
template <int N>
NormalPointer<N> against(const Line<N>& line) {
  return stored<N>(negated(line.raw_direction));
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
