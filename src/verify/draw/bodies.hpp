// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "detent/dynamics/settings.hpp"
#include "detent/math/rotation.hpp"
#include "verify/draw/shapes.hpp"

// Bodies of worlds: mostly half a unit to two units large, so that all scalars compute about the
// same.

namespace detent::verify {

/// The kind of a body or a part. Hulls and compounds are assets of the case.
enum class Form : std::uint8_t { ball, capsule, box, aligned, hull, compound };

template <Scalar S, int N>
struct DrawnBody {
  Form form = Form::box;
  Vec<S, N> center{};  // of a hull or a compound: the origin of its frame
  Vec<S, N> half{};    // half extents, or half the vector from end to end
  S radius{};
  Rotation<S, N> rotation{};
  std::uint8_t asset = 0;  // the number of the hull
  BodyOptions<S, N> options{};
};
template <class D, Scalar S, int N>
constexpr void append(D& digest, const DrawnBody<S, N>& body) noexcept {
  const auto& options = body.options;
  digest.add(static_cast<std::uint8_t>(body.form), body.center, body.half, body.radius,
             body.rotation, body.asset, static_cast<std::uint8_t>(options.motion), options.density,
             options.friction, options.restitution, options.linear_damping, options.angular_damping,
             options.velocity);
  for (const auto& w : options.angular_velocity) digest.add(w);
  digest.add(options.gravity_scale, options.locked, options.is_fast);
}

/// Draws bodies of one world.
template <Scalar S, int N>
class BodyStage : public Numbers<S> {
  using Base = Numbers<S>;

 public:
  using Base::random;
  static constexpr std::int64_t unit = std::int64_t{1} << S::frac;

  using Base::Base;

  /// Eighths of a unit.
  static constexpr std::int64_t eighths(std::int64_t count) noexcept { return count * unit / 8; }
  constexpr S between_eighths(std::int64_t low, std::int64_t high) noexcept {
    return Base::scalar(random.between(eighths(low), eighths(high)));
  }
  /// A vector with components of up to `reach` eighths.
  constexpr Vec<S, N> around(std::int64_t reach) noexcept {
    Vec<S, N> result;
    for (int i = 0; i < N; ++i) result[i] = between_eighths(-reach, reach);
    return result;
  }
  /// A vector with components between `low` and `high` eighths.
  constexpr Vec<S, N> sizes(std::int64_t low, std::int64_t high) noexcept {
    Vec<S, N> result;
    for (int i = 0; i < N; ++i) result[i] = between_eighths(low, high);
    return result;
  }
  /// A vector in the plane of x and y, and `deep` along z.
  static constexpr Vec<S, N> flat(std::int64_t x, std::int64_t y, std::int64_t deep) noexcept {
    Raw<N> raw;
    for (int i = 0; i < N; ++i) raw[i] = eighths(i == 0 ? x : i == 1 ? y : deep);
    return Base::vec(raw);
  }
  constexpr Rotation<S, N> turn() noexcept {
    return Base::rotation(Base::template turned_axes<N>());
  }

  /// The material and initial motion of a moving body.
  constexpr BodyOptions<S, N> options() noexcept {
    BodyOptions<S, N> result;
    result.density = between_eighths(4, 32);
    result.friction = between_eighths(0, 8);
    if (random.coin()) result.restitution = between_eighths(0, 6);
    if (random.one_in(4)) result.linear_damping = between_eighths(0, 4);
    if (random.one_in(4)) result.angular_damping = between_eighths(0, 4);
    result.velocity = around(16);
    for (auto& w : result.angular_velocity) w = between_eighths(-32, 32);
    return result;
  }
};

/// The material of a fixed body.
template <Scalar S, int N>
constexpr BodyOptions<S, N> fixed_options() noexcept {
  BodyOptions<S, N> result;
  result.motion = BodyMotion::fixed;
  return result;
}

}  // namespace detent::verify
