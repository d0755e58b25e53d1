// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "detent/dynamics/particle/system.hpp"

namespace detent {

/// The material of a rope or a cloth. Frequencies are those of `DistanceConstraint`s: 0 is rigid,
/// and a negative one means no such constraints.
template <Scalar S, int N>
struct FabricOptions {
  ParticleOptions<S, N> particle{};  // of each particle
  S stretch = S(0);                  // frequency between neighbours
  S shear = S(0);                    // across the squares of a cloth
  S bend = S(-1);                    // between every second particle
  bool has_tethers = false;          // from a rope's first particle to all others
};

/// Particles of a system in a row.
struct Rope {
  ParticleIndex first = 0;
  std::uint32_t count = 0;

  [[nodiscard]] constexpr ParticleIndex operator[](std::uint32_t i) const noexcept {
    return first + i;
  }
  [[nodiscard]] constexpr ParticleIndex last() const noexcept { return first + count - 1; }
};

/// Particles of a system in rows and columns.
struct Cloth {
  ParticleIndex first = 0;
  std::uint32_t columns = 0, rows = 0;

  /// The particle in a column and a row, counted from the corner.
  [[nodiscard]] constexpr ParticleIndex at(std::uint32_t column, std::uint32_t row) const noexcept {
    return first + row * columns + column;
  }
};

namespace detail {

/// Adds particles and constraints to a system that has room for them.
template <class System, Scalar S>
constexpr void tie(System& system, ParticleIndex a, ParticleIndex b, const S& length,
                   const S& frequency, bool is_tether = false) {
  if (frequency < 0) return;
  DistanceConstraint<S> constraint;
  constraint.a = a;
  constraint.b = b;
  constraint.length = length;
  constraint.frequency = frequency;
  constraint.is_tether = is_tether;
  (void)system.add(constraint);
}

template <class System>
[[nodiscard]] constexpr bool has_room(const System& system, std::size_t particles,
                                      std::size_t constraints) noexcept {
  return particles <= System::capacity - system.size() &&
         constraints <= System::constraint_capacity - system.constraint_count();
}

}  // namespace detail

/// Adds `count` evenly spaced particles from one point to another, constrained in a row. Nothing if
/// the system has no room or count < 2.
///
/// exact:  positions rounded to nearest; the length of each part is the whole length, rounded down,
///         divided by count - 1 and rounded to nearest (tests/dynamics/particle/cloth.test.cpp)
template <class Storage, Scalar S, int N>
[[nodiscard]] constexpr std::optional<Rope> add_rope(BasicParticleSystem<Storage, S, N>& system,
                                                     const Vec<S, N>& from, const Vec<S, N>& to,
                                                     std::uint32_t count,
                                                     const FabricOptions<S, N>& options = {}) {
  if (count < 2 || !detail::has_room(system, count, std::size_t{3} * count)) return std::nullopt;
  const Rope rope{static_cast<ParticleIndex>(system.size()), count};
  const auto parts = detail::as_operand<S>(count - 1);
  const auto along = [&](std::uint32_t i) {
    return make_vec<N>([&](int k) {
      const auto past = quotient_nearest<S>((to[k] - from[k]) * detail::as_operand<S>(i), parts);
      return saturate_to<S>(from[k] + past);
    });
  };
  const S whole = sqrt_floor<S>(squared_length(to - from));
  const auto length_of = [&](std::uint32_t n) {
    return quotient_nearest<S>(whole * detail::as_operand<S>(n), parts);
  };
  for (std::uint32_t i = 0; i < count; ++i) (void)system.add(along(i), options.particle);
  for (std::uint32_t i = 1; i < count; ++i) {
    detail::tie(system, rope[i - 1], rope[i], length_of(1), options.stretch);
    if (i > 1) detail::tie(system, rope[i - 2], rope[i], length_of(2), options.bend);
    if (options.has_tethers) detail::tie(system, rope.first, rope[i], length_of(i), S(0), true);
  }
  return rope;
}

/// Adds columns times rows particles, from `corner` in steps of `right` and `down`, constrained as
/// cloth: neighbours by stretch, the diagonals of each square by shear, every second particle of a
/// row or column by bend. Nothing if the system has no room.
///
/// exact:  positions as long as they are in range; lengths rounded down
///                                                 (tests/dynamics/particle/cloth.test.cpp)
/// source: structural, shear and flexion springs, Provot (1995)
template <class Storage, Scalar S, int N>
[[nodiscard]] constexpr std::optional<Cloth> add_cloth(BasicParticleSystem<Storage, S, N>& system,
                                                       const Vec<S, N>& corner,
                                                       const Vec<S, N>& right,
                                                       const Vec<S, N>& down, std::uint32_t columns,
                                                       std::uint32_t rows,
                                                       const FabricOptions<S, N>& options = {}) {
  constexpr auto most = static_cast<std::uint32_t>(BasicParticleSystem<Storage, S, N>::capacity);
  if (columns == 0 || rows == 0 || columns > most || rows > most / columns) return std::nullopt;
  const auto count = std::size_t{columns} * rows;
  if (!detail::has_room(system, count, 6 * count)) return std::nullopt;
  const Cloth cloth{static_cast<ParticleIndex>(system.size()), columns, rows};
  const auto length_of = [](const auto& v) { return sqrt_floor<S>(squared_length(v)); };
  const S across = length_of(right), along = length_of(down);
  const S across2 = length_of(right + right), along2 = length_of(down + down);
  const S falling = length_of(right + down), rising = length_of(right - down);
  for (std::uint32_t y = 0; y < rows; ++y) {
    for (std::uint32_t x = 0; x < columns; ++x) {
      const auto position = make_vec<N>([&](int k) {
        return saturate_to<S>(corner[k] + right[k] * detail::as_operand<S>(x) +
                              down[k] * detail::as_operand<S>(y));
      });
      (void)system.add(position, options.particle);
    }
  }
  for (std::uint32_t y = 0; y < rows; ++y) {
    for (std::uint32_t x = 0; x < columns; ++x) {
      const auto at = cloth.at(x, y);
      const auto tie_to = [&](std::uint32_t column, std::uint32_t row, const S& length,
                              const S& frequency) {
        if (column >= columns || row >= rows) return;  // also before the first column
        detail::tie(system, at, cloth.at(column, row), length, frequency);
      };
      tie_to(x + 1, y, across, options.stretch);
      tie_to(x + 2, y, across2, options.bend);
      tie_to(x - 1, y + 1, rising, options.shear);
      tie_to(x, y + 1, along, options.stretch);
      tie_to(x + 1, y + 1, falling, options.shear);
      tie_to(x, y + 2, along2, options.bend);
    }
  }
  return cloth;
}

}  // namespace detent
