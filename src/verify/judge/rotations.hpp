// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>

#include "oracle/answer.hpp"
#include "verify/judge/exact.hpp"

namespace detent::verify::judge {

template <int Row, Scalar S, int N, class Answer>
std::optional<Wrong> judge(const VectorCase<S, N>& c, const Answer& got) {
  const auto v = oracle::widen(raw_of(c.vector));
  const Integer squared = oracle::dot(v, v);
  if constexpr (Row == 0) {
    if (oracle::is_zero(v)) return compare(Answer(), got);
    using Component = direction_component<S>;
    const oracle::NormalizedNormal<N> exact(v, scaled(1, Component::frac));
    if (got && exact.allows(oracle::raw(*got))) return std::nullopt;
    Vec<Component, N> expected;
    for (int i = 0; i < N; ++i) {
      expected[i] = clamped<Component>(nearest(real(v[static_cast<std::size_t>(i)]) /
                                               sqrt(real(squared)) * steps(Component::frac)));
    }
    return Wrong{words(expected), words(got)};
  } else {
    return compare(clamped<S>(sqrt(squared)), got);
  }
}

/// Compares exact columns with the axes of a rotation.
template <Scalar S, int N>
std::optional<Wrong> judge_axes(const std::array<std::array<Real, N>, N>& exact,
                                const std::array<Direction<S, N>, N>& got) {
  using Component = direction_component<S>;
  bool right = true;
  std::array<Vec<Component, N>, N> expected;
  for (std::size_t k = 0; k < N; ++k) {
    for (int i = 0; i < N; ++i) {
      const Real in_steps = exact[k][static_cast<std::size_t>(i)] * steps(Component::frac);
      expected[k][i] = clamped<Component>(nearest(in_steps));
      const Real distance = abs(in_steps - Real(static_cast<std::int64_t>(got[k][i].raw())));
      right = right && distance <= rotation_margin();
    }
  }
  if (right) return std::nullopt;
  return Wrong{words(expected), words(got)};
}

template <int Row, Scalar S, int N, class Answer>
std::optional<Wrong> judge(const RotateCase<S, N>& c, const Answer& got) {
  constexpr int frac = direction_component<S>::frac;
  const auto v = oracle::widen(raw_of(c.vector));
  Answer expected;
  for (int i = 0; i < N; ++i) {
    oracle::Vector<N> factors;
    for (int k = 0; k < N; ++k) {
      const auto component = Row == 0 ? c.rotation.axis(k)[i] : c.rotation.axis(i)[k];
      factors[static_cast<std::size_t>(k)] = static_cast<std::int64_t>(component.raw());
    }
    expected[i] = clamped<S>(oracle::nearest_even(oracle::dot(factors, v), frac));
  }
  return compare(expected, got);
}

// Angles and rotations.

template <int Row, Scalar S, class Answer>
std::optional<Wrong> judge(const AngleCase<S, 1>& c, const Answer& got) {
  constexpr int frac = S::frac;
  const Integer number = static_cast<std::int64_t>(c.number.raw());
  const Integer whole_turn = Integer(1) << 32;
  if constexpr (Row == 0) {
    return compare(clamped<S>(nearest(sin(radians(c.angle)) * steps(frac))), got);
  } else if constexpr (Row == 1) {
    return compare(clamped<S>(nearest(cos(radians(c.angle)) * steps(frac))), got);
  } else if constexpr (Row == 2) {
    const Integer units = signed_units(c.angle);
    return compare(clamped<S>(nearest_quotient(scaled(units * 360, frac), whole_turn)), got);
  } else if constexpr (Row == 3) {
    const Real turns = Real(signed_units(c.angle)) / steps(32);
    return compare(clamped<S>(nearest(turns * two_pi() * steps(frac))), got);
  } else if constexpr (Row == 4) {
    const Integer degree = scaled(360, frac);
    return compare(wrapped(nearest_quotient(number * whole_turn, degree)), got);
  } else {
    return compare(wrapped(nearest(real(c.number) / two_pi() * steps(32))), got);
  }
}

template <int Row, Scalar S, class Answer>
std::optional<Wrong> judge(const AngleCase<S, 2>& c, const Answer& got) {
  const Real sine = sin(radians(c.angle)), cosine = cos(radians(c.angle));
  return judge_axes<S, 2>({{{cosine, sine}, {-sine, cosine}}}, got);
}

template <int Row, Scalar S, int N, class Answer>
std::optional<Wrong> judge(const BearingCase<S, N>& c, const Answer& got) {
  const bool is_origin = c.y.raw() == 0 && c.x.raw() == 0;
  const Real turns = is_origin ? Real(0) : Real(atan2(real(c.y), real(c.x)) / two_pi());
  return compare(wrapped(nearest(turns * steps(32))), got);
}

template <int Row, Scalar S, int N, class Answer>
std::optional<Wrong> judge(const TurnCase<S, N>& c, const Answer& got) {
  const Real x = real(c.axis[0]), y = real(c.axis[1]), z = real(c.axis[2]);
  const Real length = sqrt(x * x + y * y + z * z);
  const std::array<Real, 3> axis{x / length, y / length, z / length};
  const Real sine = sin(radians(c.angle)), cosine = cos(radians(c.angle));
  std::array<std::array<Real, 3>, 3> exact;
  for (std::size_t k = 0; k < 3; ++k) {
    // Rodrigues: the unit vector k, rotated.
    const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
    exact[k][k] = cosine + axis[k] * axis[k] * (1 - cosine);
    exact[k][i] = axis[j] * sine + axis[i] * axis[k] * (1 - cosine);
    exact[k][j] = -axis[i] * sine + axis[j] * axis[k] * (1 - cosine);
  }
  return judge_axes<S, 3>(exact, got);
}

template <int Row, Scalar S, int N, class Answer>
std::optional<Wrong> judge(const QuaternionCase<S, N>& c, const Answer& got) {
  using Component = direction_component<S>;
  const Integer x = oracle::raw(c.x), y = oracle::raw(c.y), z = oracle::raw(c.z),
                w = oracle::raw(c.w);
  const Integer xx = x * x, yy = y * y, zz = z * z, ww = w * w, norm = xx + yy + zz + ww;
  if (norm == 0) return compare(Answer(), got);
  const std::array<oracle::Vector<3>, 3> columns{
      {{ww + xx - yy - zz, 2 * (x * y + w * z), 2 * (x * z - w * y)},
       {2 * (x * y - w * z), ww - xx + yy - zz, 2 * (y * z + w * x)},
       {2 * (x * z + w * y), 2 * (y * z - w * x), ww - xx - yy + zz}}};
  bool right = got.has_value();
  std::array<Vec<Component, 3>, 3> expected;
  for (std::size_t k = 0; k < 3; ++k) {
    for (int i = 0; i < 3; ++i) {
      expected[k][i] = clamped<Component>(
          nearest_quotient(scaled(columns[k][static_cast<std::size_t>(i)], Component::frac), norm));
    }
    right = right && (*got)[k].vec() == expected[k];
  }
  if (right) return std::nullopt;
  return Wrong{words(expected), words(got)};
}

template <int Row, Scalar S, int N, class Answer>
std::optional<Wrong> judge(const EulerCase<S, N>& c, const Answer& got) {
  const Real sx = sin(radians(c.x)), cx = cos(radians(c.x));
  const Real sy = sin(radians(c.y)), cy = cos(radians(c.y));
  const Real sz = sin(radians(c.z)), cz = cos(radians(c.z));
  std::array<std::array<Real, 3>, 3> exact;
  for (std::size_t k = 0; k < 3; ++k) {
    std::array<Real, 3> v{k == 0 ? 1 : 0, k == 1 ? 1 : 0, k == 2 ? 1 : 0};
    v = {v[0], cx * v[1] - sx * v[2], sx * v[1] + cx * v[2]};
    v = {cy * v[0] + sy * v[2], v[1], cy * v[2] - sy * v[0]};
    exact[k] = {cz * v[0] - sz * v[1], sz * v[0] + cz * v[1], v[2]};
  }
  return judge_axes<S, 3>(exact, got);
}

}  // namespace detent::verify::judge
