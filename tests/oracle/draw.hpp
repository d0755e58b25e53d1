// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <type_traits>
#include <vector>

#include "detent/math/rotation.hpp"
#include "oracle/exact.hpp"
#include "oracle/space.hpp"
#include "support/random.hpp"

namespace detent::oracle {

/// The integer axes of a frame: orthogonal, and each of length `norm`.
template <int N>
struct Frame {
  std::array<Raw<N>, static_cast<std::size_t>(N)> axes;
  std::int64_t norm;
};

/// The integer frames whose axes are exact as stored directions: `norm` must divide a length that a
/// direction may have. Integer quaternions give such frames, their norm being the sum of the four
/// squares; in 2D complex integers do.
///
/// They make tangents, shared edges and parallels exact instead of approximate.
template <Scalar S, int N>
std::vector<Frame<N>> exact_frames() {
  constexpr std::int64_t one = std::int64_t{1} << direction_component<S>::frac;
  std::vector<Frame<N>> frames;
  const auto offer = [&](const Frame<N>& frame) {
    const std::int64_t rest = one % frame.norm;
    if (rest > 1 && frame.norm - rest > 1) return;
    for (const auto& axis : frame.axes) {
      for (const auto component : axis) {
        if (rest != 0 && std::abs(component) == frame.norm) return;
      }
    }
    frames.push_back(frame);
  };
  constexpr int reach = N == 2 ? 64 : 4;
  if constexpr (N == 2) {
    for (std::int64_t x = -reach; x <= reach; ++x) {
      for (std::int64_t y = -reach; y <= reach; ++y) {
        const auto norm = x * x + y * y;
        if (norm == 0) continue;
        const std::int64_t u = x * x - y * y;
        const std::int64_t v = 2 * x * y;
        offer({{{{u, v}, {-v, u}}}, norm});
      }
    }
  } else {
    for (std::int64_t i = 0, side = 2 * reach + 1; i < side * side * side * side; ++i) {
      const std::int64_t w = i % side - reach;
      const std::int64_t x = i / side % side - reach;
      const std::int64_t y = i / side / side % side - reach;
      const std::int64_t z = i / side / side / side - reach;
      const auto norm = w * w + x * x + y * y + z * z;
      if (norm == 0) continue;
      offer({{{{w * w + x * x - y * y - z * z, 2 * (x * y + w * z), 2 * (x * z - w * y)},
               {2 * (x * y - w * z), w * w - x * x + y * y - z * z, 2 * (y * z + w * x)},
               {2 * (x * z + w * y), 2 * (y * z - w * x), w * w - x * x - y * y + z * z}}},
             norm});
    }
  }
  return frames;
}

/// Random inputs for the queries, all in raw numbers.
template <Scalar S, int N>
class Draw {
 public:
  static constexpr auto size = static_cast<std::size_t>(N);
  static constexpr int bits = S::bits;
  static constexpr std::int64_t one = std::int64_t{1} << direction_component<S>::frac;
  static constexpr std::int64_t limit = (std::int64_t{1} << bits) - 1;

  explicit Draw(std::uint64_t seed) : random(seed) {}

  test::Random random;

  static S scalar(std::int64_t raw) {
    return S::from_raw(static_cast<typename S::raw_type>(std::clamp(raw, -limit - 1, limit)));
  }
  static Vec<S, N> vec(const Raw<N>& raw) {
    Vec<S, N> result;
    for (std::size_t i = 0; i < size; ++i) result[static_cast<int>(i)] = scalar(raw[i]);
    return result;
  }
  static Ray<S, N> ray(const Raw<N>& origin, const Direction<S, N>& direction, S max_distance) {
    return {vec(origin), direction, max_distance};
  }
  /// From components that are known to form a direction.
  static Direction<S, N> direction(const Raw<N>& raw) {
    std::array<typename direction_component<S>::raw_type, size> components{};
    for (std::size_t i = 0; i < size; ++i) {
      components[i] = static_cast<typename direction_component<S>::raw_type>(raw[i]);
    }
    return Direction<S, N>::from_raw(components).value();
  }
  /// The direction nearest to that of `v`, which is not zero.
  static Direction<S, N> along(const std::array<double, size>& v) {
    double sum = 0;
    for (const double component : v) sum += component * component;
    Raw<N> raw{};
    for (std::size_t i = 0; i < size; ++i) {
      raw[i] = std::llround(v[i] / std::sqrt(sum) * static_cast<double>(one));
    }
    return direction(raw);
  }
  /// From one point towards another; any direction if they are equal.
  Direction<S, N> towards(const Raw<N>& from, const Raw<N>& to) {
    std::array<double, size> v{};
    for (std::size_t i = 0; i < size; ++i) v[i] = static_cast<double>(to[i] - from[i]);
    return from == to ? any_direction() : along(v);
  }

  /// The magnitude of the coordinates of one case: from a few raw units to half the world.
  std::int64_t scale() { return std::int64_t{1} << random.between(4, bits - 1); }
  Raw<N> point(std::int64_t reach) {
    Raw<N> result{};
    for (auto& component : result) component = random.between(-reach, reach);
    return result;
  }
  /// `base` moved by up to `reach` along every axis.
  Raw<N> near(Raw<N> base, std::int64_t reach) {
    for (auto& component : base) component += random.between(-reach, reach);
    return base;
  }
  /// Bits from the whole domain, including its ends and powers of two.
  std::int64_t extreme() { return random.edgy(bits); }
  Raw<N> extreme_point() {
    Raw<N> result{};
    for (auto& component : result) component = extreme();
    return result;
  }

  /// `length`, divided by a random power of two.
  std::int64_t shrunk(std::int64_t length) {
    return length >> random.below(static_cast<unsigned>(bits));
  }
  /// How many steps of length `step` fit into a shrunk `reach`; at least one.
  std::int64_t steps(std::int64_t reach, std::int64_t step = 1) {
    return std::max<std::int64_t>(1, shrunk(reach / step));
  }

  /// One of the coordinate axes, in either direction.
  Raw<N> unit() {
    Raw<N> result{};
    result[random.below(size)] = random.coin() ? 1 : -1;
    return result;
  }
  Direction<S, N> axis_direction() { return stretched(unit(), 1); }

  /// With a component that is a power of two, so that points are halfway between grid points.
  Direction<S, N> halving_direction() {
    const auto first = random.below(size);
    const auto second = (first + 1 + random.below(size - 1)) % size;
    std::array<double, size> v{};
    v[first] = std::ldexp(random.coin() ? 1 : -1, -static_cast<int>(random.between(1, 5)));
    v[second] = std::sqrt(1 - v[first] * v[first]);
    return along(v);
  }
  /// Roughly uniform, with small or zero components often enough.
  Direction<S, N> any_direction() {
    if (random.one_in(16)) return halving_direction();
    std::array<double, size> v{};
    bool zero = true;
    while (zero) {
      for (auto& component : v) {
        const int width = random.one_in(8) ? static_cast<int>(random.below(33)) : 32;
        component = static_cast<double>(
            random.between(-(std::int64_t{1} << width), std::int64_t{1} << width));
        if (random.one_in(16)) component = 0;
        zero = zero && component == 0;
      }
    }
    return random.one_in(4) ? disturbed(along(v)) : along(v);
  }
  /// A direction whose length is off by as much as allowed.
  Direction<S, N> disturbed(const Direction<S, N>& exact) {
    std::array<typename direction_component<S>::raw_type, size> components{};
    for (int i = 0; i < N; ++i) {
      components[static_cast<std::size_t>(i)] =
          static_cast<typename direction_component<S>::raw_type>(exact[i].raw() +
                                                                 random.between(-1, 1));
    }
    return Direction<S, N>::from_raw(components).value_or(exact);
  }

  const Frame<N>& frame() {
    static const auto frames = exact_frames<S, N>();
    return frames[random.below(frames.size())];
  }
  /// `axis` of an exact frame as the direction exactly parallel to it.
  static Direction<S, N> stretched(const Raw<N>& axis, std::int64_t norm) {
    Raw<N> raw = axis;
    for (auto& component : raw) component *= (one + norm / 2) / norm;
    return direction(raw);
  }

  Rotation<S, N> rotation(const Frame<N>& frame) {
    std::array<Direction<S, N>, size> axes{stretched(frame.axes[0], frame.norm),
                                           stretched(frame.axes[1], frame.norm)};
    if constexpr (N == 3) axes[2] = stretched(frame.axes[2], frame.norm);
    return Rotation<S, N>::from_axes(axes);
  }
  /// Orthonormal to the last bit, from a random quaternion (or angle).
  Rotation<S, N> rotation() {
    std::array<double, 4> q{};
    double norm = 0;
    while (norm == 0) {
      for (auto& component : q) component = static_cast<double>(random.between(-4096, 4096));
      if (N == 2) q[2] = q[3] = 0;
      norm = q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3];
    }
    const auto [w, x, y, z] = q;
    if constexpr (N == 2) {
      const double u = w * w - x * x;
      const double v = 2 * w * x;
      return Rotation<S, N>::from_axes({along({u, v}), along({-v, u})});
    } else {
      return Rotation<S, N>::from_axes(
          {along({w * w + x * x - y * y - z * z, 2 * (x * y + w * z), 2 * (x * z - w * y)}),
           along({2 * (x * y - w * z), w * w - x * x + y * y - z * z, 2 * (y * z + w * x)}),
           along({2 * (x * z + w * y), 2 * (y * z - w * x), w * w - x * x - y * y + z * z})});
    }
  }
  /// Unrelated axes: still a box, as the intersection of its slabs.
  Rotation<S, N> skewed() {
    if constexpr (N == 2) {
      return Rotation<S, N>::from_axes({any_direction(), any_direction()});
    } else {
      return Rotation<S, N>::from_axes({any_direction(), any_direction(), any_direction()});
    }
  }

  /// The maximum, or sometimes a length that cuts the ray short, empties it, or leaves a point.
  S reach(std::int64_t typical) {
    if (!random.one_in(10)) return scalar(limit);
    switch (random.below(4)) {
      case 0:
        return scalar(0);
      case 1:
        return scalar(random.between(-3, 3));
      case 2:
        return scalar(extreme());
      default:
        return scalar(random.between(0, 4 * typical));
    }
  }

  /// `distance` raw units from `point` along `direction`, rounded to the grid.
  static Raw<N> moved(const Raw<N>& point, const Direction<S, N>& direction,
                      std::int64_t distance) {
    Raw<N> result{};
    for (std::size_t i = 0; i < size; ++i) {
      const auto component = static_cast<double>(direction[static_cast<int>(i)].raw());
      result[i] = point[i] + std::llround(component / static_cast<double>(one) *
                                          static_cast<double>(distance));
    }
    return result;
  }
  /// The offset, to the raw unit, of the plane through `point`.
  static std::int64_t offset_of(const Direction<S, N>& normal, const Raw<N>& point) {
    double sum = 0;
    for (std::size_t i = 0; i < size; ++i) {
      sum += static_cast<double>(normal[static_cast<int>(i)].raw()) / static_cast<double>(one) *
             static_cast<double>(point[i]);
    }
    return std::llround(sum);
  }
  static Raw<N> plus(const Raw<N>& a, const Raw<N>& b, std::int64_t times = 1) {
    Raw<N> result{};
    for (std::size_t i = 0; i < size; ++i) result[i] = a[i] + times * b[i];
    return result;
  }
};

/// The scalar and the dimension of a shape.
template <class Shape>
struct SpaceOf;
template <template <Scalar, int> class Shape, Scalar S, int N>
struct SpaceOf<Shape<S, N>> {
  using type = test::Space<S, N>;
};

/// A shape with these fields; points and lengths are raw numbers.
template <class Shape, class... Fields>
Shape from_raw(const Fields&... fields) {
  using Space = typename SpaceOf<Shape>::type;
  using D = Draw<typename Space::scalar, Space::dimension>;
  const auto stored = []<class Field>(const Field& field) {
    if constexpr (std::is_integral_v<Field>) {
      return D::scalar(field);
    } else if constexpr (std::is_same_v<Field, Raw<Space::dimension>>) {
      return D::vec(field);
    } else {
      return field;
    }
  };
  return {stored(fields)...};
}

}  // namespace detent::oracle
