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
    const auto add = [&](std::int64_t n, int bits) {
      code |= low_bits(n, bits) << at;
      at += bits;
    };
    for (int i = 0; i < N; ++i) {
      const std::int64_t x = body.state.place[i].raw();
      add(((x - body.drift[i].raw()) >> grid) - shifted_nearest(x, grid), step_bits);
    }
    for (int i = 0; i < parts; ++i) {
      add(std::int64_t{body.anchor[i].raw()} - anchored<S>(body.state.orientation[i]).raw(),
          turn_bits);
    }
    for (int i = 0; i < N; ++i) {
      word_[static_cast<std::size_t>(i)] =
          low_bits(body.state.place[i].raw(), place_bits) | code << place_bits;
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
      const auto x = with_sign(word, place_bits);
      body.state.place[i] = Place::from_raw(static_cast<typename Place::raw_type>(x));
      if (body.state.place[i].raw() != x) return false;
      code |= word >> place_bits << code_bits * i;
    }
    const auto take = [&](int bits) {
      const auto n = with_sign(code, bits);
      code >>= bits;
      return n;
    };
    for (int i = 0; i < N; ++i) {
      const std::int64_t x = body.state.place[i].raw();
      const auto drift = x - ((shifted_nearest(x, grid) + take(step_bits)) << grid);
      if (drift < Speed::lowest().raw() || drift > (Speed::max)().raw()) return false;
      body.drift[i] = Speed::assume_raw(static_cast<typename Speed::raw_type>(drift));
    }
    for (int i = 0; i < parts; ++i) {
      const auto n = anchored<S>(body.state.orientation[i]).raw() + take(turn_bits);
      body.anchor[i] = Anchor::assume_raw(static_cast<typename Anchor::raw_type>(n));
    }
    return code == 0 && body.is_held();
  }

 private:
  [[nodiscard]] static constexpr std::uint64_t low_bits(std::int64_t n, int bits) noexcept {
    return static_cast<std::uint64_t>(n) & ((std::uint64_t{1} << bits) - 1);
  }
  /// The signed number in the lowest bits.
  [[nodiscard]] static constexpr std::int64_t with_sign(std::uint64_t word, int bits) noexcept {
    return static_cast<std::int64_t>(word << (64 - bits)) >> (64 - bits);
  }

  std::array<std::uint64_t, std::size_t{N}> word_{};
};

}  // namespace detent::detail
