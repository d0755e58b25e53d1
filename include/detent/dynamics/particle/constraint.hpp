// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <compare>
#include <cstddef>
#include <cstdint>

#include "detent/dynamics/joint/law.hpp"
#include "detent/dynamics/particle/settings.hpp"

namespace detent {

/// The index of a particle of a `ParticleSystem`, from 0 in the order of addition.
using ParticleIndex = std::uint32_t;

/// Keeps the distance of two particles at `length`.
///
/// With a frequency it is a spring that oscillates at this frequency between these two particles
/// alone: extended position-based dynamics with the compliance 1 / ((2 pi frequency)^2 m), where m
/// is the reduced mass. Without one it is rigid. A tether only limits their distance from above.
template <Scalar S>
struct DistanceConstraint {
  ParticleIndex a = 0, b = 0;
  S length{};
  S frequency{};
  bool is_tether = false;

  [[nodiscard]] friend constexpr bool operator==(const DistanceConstraint&,
                                                 const DistanceConstraint&) noexcept = default;
};

namespace detail {

/// A constraint with a < b, and the share of its error that each particle corrects.
template <Scalar S>
struct ConstraintRecord {
  DistanceConstraint<S> constraint;
  typename Formats<S>::Ratio share_a{}, share_b{};
};

template <Scalar S>
[[nodiscard]] constexpr std::strong_ordering order(const DistanceConstraint<S>& x,
                                                   const DistanceConstraint<S>& y) noexcept {
  return x.a != y.a ? x.a <=> y.a : x.b <=> y.b;
}

/// Computes the shares: those of the inverse masses, times the stiffness of the constraint.
template <Scalar S, int N>
constexpr void derive(ConstraintRecord<S>& record, const ParticleRecord<S, N>& a,
                      const ParticleRecord<S, N>& b, int rate) noexcept {
  using Ratio = typename Formats<S>::Ratio;
  const auto& frequency = record.constraint.frequency;
  const auto stiff = frequency > 0 ? spring_softness<S>(frequency, S(0), rate).rigid : Ratio(1);
  if (a.is_held() || b.is_held()) {
    record.share_a = a.is_held() ? Ratio{} : stiff;
    record.share_b = b.is_held() ? Ratio{} : stiff;
  } else {
    const auto sum = a.mass + b.mass;
    record.share_a = quotient_nearest<Ratio>(b.mass * stiff, sum);
    record.share_b = quotient_nearest<Ratio>(a.mass * stiff, sum);
  }
}

template <Number To, Number T, int N>
[[nodiscard]] constexpr Vec<To, N> saturated(const Vec<T, N>& v) noexcept {
  return make_vec<N>([&](int i) { return saturate_to<To>(v[i]); });
}

/// Moves two particles, about to be at `a` and `b`, to the distance of their constraint.
///
/// source: Mueller et al., Position Based Dynamics (2007), 3.3; with one pass in each substep, the
///         compliance of Macklin et al., XPBD (2016), is in the shares
template <Scalar S, int N>
constexpr void project(const ConstraintRecord<S>& record, Vec<typename Formats<S>::Place, N>& a,
                       Vec<typename Formats<S>::Place, N>& b) noexcept {
  using F = Formats<S>;
  using Reach = typename F::Reach;
  using Ratio = typename F::Ratio;
  const auto d = saturated<Reach>(b - a);
  const auto length = sqrt_floor<Reach>(squared_length(d));
  const auto error = saturate_to<Reach>(length - record.constraint.length);
  if (record.constraint.is_tether && !(error > 0)) return;
  std::array<Ratio, std::size_t{N}> first_axis{};
  first_axis[0] = Ratio(1);
  const auto along = from_array(unit_vector<Ratio>(to_array(d)).value_or(first_axis));
  const auto by_a = nearest_to<Reach>(record.share_a * error);
  const auto by_b = nearest_to<Reach>(record.share_b * error);
  for (int i = 0; i < N; ++i) {
    a[i] = saturate_to<typename F::Place>(a[i] + nearest_to<Reach>(by_a * along[i]));
    b[i] = saturate_to<typename F::Place>(b[i] - nearest_to<Reach>(by_b * along[i]));
  }
}

}  // namespace detail

}  // namespace detent
