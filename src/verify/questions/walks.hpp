// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "detent/scene/mover.hpp"
#include "detent/scene/scene.hpp"
#include "verify/draw/numbers.hpp"
#include "verify/questions/cases.hpp"

// Characters at a fixed location.

namespace detent::verify {

/// Ground, two steps, a wall, and a lift in a frame: all of one shape type, to compile faster.
template <Scalar S, int N>
struct Place {
  static constexpr std::int64_t unit = std::int64_t{1} << S::frac;

  static constexpr Aabb<S, N> ground() noexcept { return box({{-64, -8}}, {{64, 0}}, 64); }
  static constexpr Aabb<S, N> step() noexcept { return box({{16, 0}}, {{32, 1}}, 20); }
  static constexpr Aabb<S, N> next_step() noexcept { return box({{20, 0}}, {{32, 2}}, 12); }
  static constexpr Aabb<S, N> wall() noexcept { return box({{-28, 0}}, {{-24, 12}}, 24); }
  static constexpr Aabb<S, N> lift() noexcept { return box({{-8, -1}}, {{8, 1}}, 8); }

 private:
  /// A box between corners in quarters of a unit, in the plane of x and y; `deep` to both sides of
  /// it.
  static constexpr Aabb<S, N> box(const Raw<2>& low, const Raw<2>& high,
                                  std::int64_t deep) noexcept {
    return {quarters(low, -deep), quarters(high, deep)};
  }
  static constexpr Vec<S, N> quarters(const Raw<2>& at, std::int64_t deep) noexcept {
    Raw<N> raw;
    for (int i = 0; i < N; ++i) raw[i] = (i < 2 ? at[i] : deep) * (unit / 4);
    return Numbers<S>::vec(raw);
  }
};

template <Scalar S, int N>
using BoxScene = BoundedScene<Bounded<5, 1>, S, N, Aabb>;

/// A capsule that moves a few times, each time after the lift has moved.
template <Scalar S, int N>
struct WalkCase {
  static constexpr std::size_t moves = 3;

  Capsule<S, N> start;
  S step_height, snap_distance;
  std::array<Vec<S, N>, moves> lift, by;

  [[nodiscard]] constexpr MoverSettings<S, N> settings() const noexcept {
    MoverSettings<S, N> result;
    result.step_height = step_height;
    result.snap_distance = snap_distance;
    return result;
  }

  constexpr auto fields(const auto& f) const noexcept {
    return f(start, step_height, snap_distance, lift, by);
  }
};

/// The character after a move, and the move's result.
template <Scalar S, int N>
struct Walked {
  Mover<S, N, Capsule> mover{};
  MoveResult<S, N> result{};
};
template <class D, Scalar S, int N>
constexpr void append(D& digest, const Walked<S, N>& walked) noexcept {
  digest.add(walked.mover, walked.result);
}

struct Walks : InDimensions<3> {
  static constexpr std::array<std::string_view, 1> names{"mover/move"};
  static constexpr std::uint32_t share = 48;

  template <Scalar S, int N>
  static constexpr auto draw(Random& random) noexcept {
    Numbers<S> numbers(random);
    constexpr auto unit = Place<S, N>::unit;
    const auto around = [&](std::int64_t reach) {
      Raw<N> raw;
      for (int i = 0; i < N; ++i) raw[i] = random.between(-reach, reach);
      return raw;
    };
    WalkCase<S, N> c{};
    auto feet = around(12 * unit);
    const auto radius = random.between(unit / 4, unit / 2);
    // On the ground, or in the air.
    feet[1] = radius + (random.coin() ? random.between(0, unit / 8) : random.between(0, 5 * unit));
    auto head = feet;
    if (random.one_in(4)) {
      head += around(unit);
    } else {
      head[1] += unit;
    }
    c.start = {numbers.vec(feet), numbers.vec(head), numbers.scalar(radius)};
    if (random.one_in(16)) {
      const auto any = numbers.template any_point<N>();
      c.start = {numbers.vec(any), numbers.vec(head), numbers.any()};
    }
    const MoverSettings<S, N> settings;
    c.step_height = random.coin() ? settings.step_height : numbers.scalar(0);
    c.snap_distance = random.coin() ? settings.snap_distance : numbers.scalar(0);
    Raw<N> lift;
    lift[1] = random.between(unit / 2, 2 * unit);
    const auto reach = random.one_in(8) ? 16 * unit : random.coin() ? unit : unit / 4;
    for (std::size_t i = 0; i < c.moves; ++i) {
      lift += around(unit / 8);
      c.lift[i] = numbers.vec(lift);
      auto by = around(reach);
      if (random.coin()) by[1] = -unit / 8;
      c.by[i] = numbers.vec(by);
    }
    return c;
  }

  template <int Row, Scalar S, int N>
  [[nodiscard]] static constexpr auto answer(const WalkCase<S, N>& c) noexcept {
    using Here = Place<S, N>;
    BoxScene<S, N> world;
    world.add(Here::ground(), Traits{.motion = Motion::fixed});
    world.add(Here::step());
    world.add(Here::next_step());
    world.add(Here::wall());
    const auto frame = world.add_frame(Transform<S, N>()).value_or(FrameId{});
    world.add(Here::lift(), Traits{.frame = frame});
    Mover<S, N, Capsule> mover{c.start};
    std::array<Walked<S, N>, WalkCase<S, N>::moves> walked{};
    for (std::size_t i = 0; i < c.moves; ++i) {
      world.move_frame(frame, Transform<S, N>{.translation = c.lift[i]});
      walked[i].result = mover.move(world, c.by[i], c.settings());
      walked[i].mover = mover;
    }
    return walked;
  }
};

/// The same in the plane.
struct FlatWalks : Walks {
  static constexpr std::array<std::string_view, 1> names{"mover/move/2d"};
  template <int N>
  static constexpr bool asks = N == 2;
};

}  // namespace detent::verify
