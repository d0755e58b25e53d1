// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "detent/dynamics/hold.hpp"
#include "detent/scene/bytes.hpp"

// The place of a held body in a snapshot, with the pose at which it is held.
//
// Each coordinate has a word of 8 bytes: the coordinate (bits 0 to 43) and 20 bits of a code. The
// code has, lowest bits first, for each coordinate of the place where the body is held the number
// of grid steps from that next to its own place (11 bits), then for each component of the held
// orientation the same for its own orientation (6 bits in 3D, 7 in 2D). All are signed.
//
// Worlds of floating-point numbers store place, drift and held orientation.

namespace detent::detail {

template <Scalar S, int N>
class HeldPlace {
 public:
  constexpr HeldPlace() noexcept = default;
  template <class Shape>
  constexpr HeldPlace(const BodyRecord<S, N, Shape>& body, int) noexcept
      : place_(body.state.place), drift_(body.drift), anchor_(body.anchor) {}

  template <class D>
  constexpr void add_to(D& out) const noexcept {
    out.add(place_, drift_, anchor_);
  }
  constexpr void get_from(Reader& in) noexcept { in.get(place_, drift_, anchor_); }

  /// Sets the place of a body, and where it is held; false if these bytes say that it is not held.
  template <class Shape>
  [[nodiscard]] constexpr bool set(BodyRecord<S, N, Shape>& body, int) const noexcept {
    body.state.place = place_;
    body.drift = drift_;
    body.anchor = anchor_;
    return body.is_held();
  }

 private:
  Vec<S, N> place_{}, drift_{};
  Vec<S, BodyState<S, N>::orientation_size> anchor_{};
};

template <int Bits, int Frac, int N>
class HeldPlace<Fixed<Bits, Frac>, N> {
  using S = Fixed<Bits, Frac>;
  using F = Formats<S>;
  using Place = typename F::Place;
  using Speed = typename F::Speed;
  using Anchor = typename F::Anchor;

  static constexpr int place_bits = 44, code_bits = 64 - place_bits;
  static constexpr int step_bits = 11, turn_bits = N == 2 ? 7 : 6;
  static constexpr int parts = BodyState<S, N>::orientation_size;
  static_assert(Place::bits < place_bits && Place::frac == Speed::frac);
  static_assert(N * step_bits + parts * turn_bits <= N * code_bits);

 public:
  constexpr HeldPlace() noexcept = default;
  /// Of a held body of a world whose held places are multiples of 2^grid steps.
  template <class Shape>
  constexpr HeldPlace(const BodyRecord<S, N, Shape>& body, int grid) noexcept {
    std::uint64_t code = 0;
    int at = 0;
    const auto add = [&](const auto& n, int bits) {
      code |= low_bits(n, bits) << at;
      at += bits;
    };
    for (int i = 0; i < N; ++i) {
      const auto& x = body.state.place[i];
      add(steps_nearest(x - body.drift[i], grid) - steps_nearest(x, grid), step_bits);
    }
    for (int i = 0; i < parts; ++i) {
      add(body.anchor[i] - anchored<S>(body.state.orientation[i]), turn_bits);
    }
    for (int i = 0; i < N; ++i) {
      word_[static_cast<std::size_t>(i)] =
          low_bits(body.state.place[i], place_bits) | code << place_bits;
      code >>= code_bits;
    }
  }

  template <class D>
  constexpr void add_to(D& out) const noexcept {
    for (const auto& word : word_) out.add(word);
  }
  constexpr void get_from(Reader& in) noexcept {
    for (auto& word : word_) in.get(word);
  }

  /// Sets the place of a body with this orientation, and where it is held; false if no body has
  /// these bytes.
  template <class Shape>
  [[nodiscard]] constexpr bool set(BodyRecord<S, N, Shape>& body, int grid) const noexcept {
    std::uint64_t code = 0;
    for (int i = 0; i < N; ++i) {
      const auto word = word_[static_cast<std::size_t>(i)];
      auto& x = body.state.place[i];
      x = from_low_bits<Place>(word, place_bits);
      if (low_bits(x, place_bits) != (word & ((std::uint64_t{1} << place_bits) - 1))) return false;
      code |= word >> place_bits << code_bits * i;
    }
    const auto take = [&]<class T>(T, int bits) {
      const auto n = from_low_bits<T>(code, bits);
      code >>= bits;
      return n;
    };
    for (int i = 0; i < N; ++i) {
      const auto& x = body.state.place[i];
      const auto steps = steps_nearest(x, grid) + take(Fixed<step_bits - 1, 0>(), step_bits);
      const auto drift = x - of_steps<Fixed<Place::bits + 3, Place::frac>>(steps, grid);
      if (drift < Speed::lowest() || drift > (Speed::max)()) return false;
      body.drift[i] = saturate_to<Speed>(drift);
    }
    for (int i = 0; i < parts; ++i) {
      using Turn = Fixed<turn_bits - 1, Anchor::frac>;
      body.anchor[i] =
          saturate_to<Anchor>(anchored<S>(body.state.orientation[i]) + take(Turn(), turn_bits));
    }
    return code == 0 && body.is_held();
  }

 private:
  std::array<std::uint64_t, std::size_t{N}> word_{};
};

}  // namespace detent::detail
