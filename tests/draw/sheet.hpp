// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cmath>
#include <vector>

#include "detent/draw/draw.hpp"
#include "query/raycast/helpers.hpp"
#include "support/random.hpp"

// Shared by the drawing tests: a sink that keeps everything and measures in double.

namespace detent::test {

template <Scalar S, int N>
struct Sheet {
  struct Line {
    Vec<S, N> a, b;
    Colour colour;
  };
  struct Face {
    Vec<S, N> a, b, c;
    Colour colour;
  };
  std::vector<Line> lines;
  std::vector<Face> faces;

  void line(const Vec<S, N>& a, const Vec<S, N>& b, const Colour& colour) {
    lines.push_back({a, b, colour});
  }
  void triangle(const Vec<S, N>& a, const Vec<S, N>& b, const Vec<S, N>& c, const Colour& colour) {
    faces.push_back({a, b, c, colour});
  }

  [[nodiscard]] bool is_blank() const { return lines.empty() && faces.empty(); }
  [[nodiscard]] std::vector<Vec<S, N>> points() const {
    std::vector<Vec<S, N>> all;
    for (const auto& line : lines) all.insert(all.end(), {line.a, line.b});
    for (const auto& face : faces) all.insert(all.end(), {face.a, face.b, face.c});
    return all;
  }
};

/// Only counts, in constant expressions too.
template <Scalar S, int N>
struct Counts {
  int lines = 0, faces = 0;

  constexpr void line(const Vec<S, N>&, const Vec<S, N>&, const Colour&) { ++lines; }
  constexpr void triangle(const Vec<S, N>&, const Vec<S, N>&, const Vec<S, N>&, const Colour&) {
    ++faces;
  }
};

/// A sink for lines only, as in 2D.
template <Scalar S>
struct Lines {
  int count = 0;
  constexpr void line(const Vec<S, 2>&, const Vec<S, 2>&, const Colour&) { ++count; }
};

inline constexpr Colour ink{1, 2, 3};

template <Scalar S, int N>
Sheet<S, N> drawn(const auto& shape) {
  Sheet<S, N> sheet;
  draw(sheet, shape, ink);
  return sheet;
}
template <Scalar S>
Sheet<S, 3> drawn_solid(const auto& shape) {
  Sheet<S, 3> sheet;
  draw_solid(sheet, shape, ink);
  return sheet;
}

using Double3 = std::array<double, 3>;

/// A point or direction in doubles, which represent every scalar exactly.
template <class T, int N>
Double3 in_double(const Vec<T, N>& v) {
  Double3 result{};
  for (int i = 0; i < N; ++i) result[static_cast<std::size_t>(i)] = static_cast<double>(v[i]);
  return result;
}
inline Double3 minus(const Double3& a, const Double3& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
inline double inner(const Double3& a, const Double3& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
inline double norm(const Double3& a) { return std::sqrt(inner(a, a)); }

/// Half a unit of the scalar on each axis, and `part` of 2^-29 (2^-13) of a length; the table of
/// circles is as exact as that for `double` too.
template <Scalar S>
double slack(double length, double coordinate, double part = 2) {
  if constexpr (is_fixed<S>) {
    const double step = std::ldexp(1.0, -S::frac);
    return 0.87 * step + part * std::ldexp(length, 1 - direction_component<S>::frac);
  } else {
    const double epsilon = std::ldexp(1.0, std::same_as<S, float> ? -22 : -50);
    return epsilon * (coordinate + 4 * length) + part * std::ldexp(length, -29);
  }
}

/// A number of any size that leaves a quarter of the range around it.
template <Scalar S>
S any_number(Random& random) {
  if constexpr (is_fixed<S>) {
    const auto reach = std::int64_t{1} << random.between(3, S::bits - 3);
    return random.number<S>(-reach, reach);
  } else {
    return static_cast<S>(std::ldexp(static_cast<double>(random.between(-65536, 65536)),
                                     static_cast<int>(random.between(-12, 0))));
  }
}
template <Scalar S>
S any_length(Random& random) {
  const S number = any_number<S>(random);
  return number < 0 ? nearest_to<S>(-number) : number;
}
template <Scalar S, int N>
Vec<S, N> any_point(Random& random) {
  return make_vec<N>([&](int) { return any_number<S>(random); });
}
template <Scalar S, int N>
Direction<S, N> any_direction(Random& random) {
  while (true) {
    if (const auto direction = direction_of<S>(any_point<S, N>(random))) return *direction;
  }
}

}  // namespace detent::test
