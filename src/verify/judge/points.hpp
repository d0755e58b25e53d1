// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "verify/judge/exact.hpp"

namespace detent::verify::judge {

/// Coordinate i of the point at `radius` from the core in direction v: of its neighbouring integers
/// the one that is proved to be nearest.
template <int N>
Integer nearest_on_surface(const oracle::Nearest<N>& truth, const oracle::Vector<N>& v,
                           std::size_t i) {
  const auto& core = truth.core;
  const Real beyond = real(truth.radius) * real(v[i]) / sqrt(real(oracle::dot(v, v)));
  Integer about = nearest(real(core.over[i]) / real(core.under) + beyond);
  for (const Integer& x : {Integer(about - 1), Integer(about + 1)}) {
    if (oracle::is_rounded<N>(x, core, i, truth.radius, v)) return x;
  }
  return about;
}

template <int N>
oracle::Vector<N> nearest_point(const std::optional<oracle::Nearest<N>>& truth,
                                const oracle::Vector<N>& p) {
  if (!truth || (truth->keeps_inside && oracle::is_within(truth, 0))) return p;
  const auto& core = truth->core;
  oracle::Vector<N> v, result;
  for (std::size_t i = 0; i < v.size(); ++i) v[i] = p[i] * core.under - core.over[i];
  for (std::size_t i = 0; i < v.size(); ++i) {
    result[i] = truth->radius.is_zero() ? nearest_quotient(core.over[i], core.under)
                                        : nearest_on_surface<N>(*truth, v, i);
  }
  return result;
}

/// The distance, rounded down and clamped; the maximum for an empty shape.
template <Scalar S, int N>
S distance_to(const std::optional<oracle::Nearest<N>>& truth) {
  if (!truth) return S::max();
  const auto& [over, under] = truth->core.squared;
  const Integer beyond = sqrt(oracle::floor_quotient(over, under)) - truth->radius;
  return clamped<S>(beyond < 0 ? Integer(0) : beyond);
}

/// The weights in units of 2^-frac solve the normal equations by Cramer's rule, in 2D and in 3D.
template <Scalar S, int N>
std::optional<oracle::Vector<3>> weights(const Triangle<S, N>& triangle, const Vec<S, N>& point,
                                         int frac) {
  const auto a = oracle::raw(triangle.a);
  const auto u = oracle::difference(oracle::raw(triangle.b), a);
  const auto v = oracle::difference(oracle::raw(triangle.c), a);
  const auto w = oracle::difference(oracle::raw(point), a);
  const Integer uu = oracle::dot(u, u), uv = oracle::dot(u, v), vv = oracle::dot(v, v);
  const Integer uw = oracle::dot(u, w), vw = oracle::dot(v, w);
  const Integer total = uu * vv - uv * uv;
  if (total.is_zero()) return std::nullopt;
  const Integer of_b = vv * uw - uv * vw, of_c = uu * vw - uv * uw;
  const auto rounded = [&](const Integer& weight) {
    return nearest_quotient(scaled(weight, frac), total);
  };
  return oracle::Vector<3>{rounded(total - of_b - of_c), rounded(of_b), rounded(of_c)};
}

template <int Row, Scalar S, int N, class Shape, class Answer>
std::optional<Wrong> judge(const PointCase<S, N, Shape>& c, const Answer& got) {
  const auto shape = in_raw_units<S>(c.shape);
  const auto point = in_raw_units<S>(c.point);
  if constexpr (Row == barycentric_row) {
    using Component = direction_component<S>;
    const auto expected = weights(shape, point, Component::frac);
    return compare(expected ? Answer(clamped<Component>(*expected)) : Answer(), got);
  } else {
    const auto truth = oracle::nearest(as_shape(shape), point);
    if constexpr (Row == contains_row) {
      return compare(oracle::is_within(truth, 0), got);
    } else if constexpr (Row == on_row) {
      return compare(oracle::is_within(truth, oracle::raw(c.tolerance)), got);
    } else if constexpr (Row == closest_point_row) {
      return compare(clamped<S>(nearest_point<N>(truth, oracle::raw(c.point))), got);
    } else if constexpr (Row == distance_row) {
      return compare(distance_to<S>(truth), got);
    } else if (!truth) {
      return compare(Answer::max(), got);
    } else {
      const auto& [over, under] = truth->core.squared;
      return compare(clamped<Answer>(oracle::floor_quotient(over, under)), got);
    }
  }
}

}  // namespace detent::verify::judge
