// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "detent/number/angle.hpp"
#include "detent/scene/fields.hpp"
#include "detent/scene/object.hpp"

namespace detent {

/// How a character moves.
template <Scalar S, int N>
struct MoverSettings {
  Direction<S, N> up = Direction<S, N>::along(1);
  /// The distance that the character keeps from surfaces; at least 32 ULP, one for each cast of the
  /// longest move and as many to spare.
  S skin = quotient_nearest<S>(S(1), detail::as_operand<S>(64));
  /// The highest step that it climbs, by up to a skin more; 0 for none. A round foot of radius r also
  /// rolls over edges up to r (1 - cos max_slope) high.
  S step_height = quotient_nearest<S>(S(1), detail::as_operand<S>(3));
  /// How far down it follows the ground, along slopes and steps; at least two skins.
  S snap_distance = quotient_nearest<S>(S(1), detail::as_operand<S>(3));
  /// The steepest slope that it stands on and walks up.
  Angle<S> max_slope = Angle<S>::turn(50, 360);
};

/// The ground that a character stands on.
template <Scalar S, int N>
struct Ground {
  bool is_grounded = false;
  ObjectId object{};
  Direction<S, N> normal{};
  FrameId frame{};    // the frame of the object, which carries the character
  Vec<S, N> local{};  // the point under the character, in the frame
  Vec<S, N> point{};  // the same in the world, at the last move

  [[nodiscard]] friend constexpr bool operator==(const Ground&, const Ground&) noexcept = default;
};

/// Appends to a digest: the fields in order.
template <class D, Scalar S, int N>
constexpr void append(D& digest, const Ground<S, N>& ground) noexcept {
  digest.add(ground.is_grounded, ground.object, ground.normal, ground.frame, ground.local,
             ground.point);
}
/// Its fields in a `Desync`: see fields.hpp.
template <Scalar S, int N, class F>
constexpr void for_each_field(const Ground<S, N>& ground, const F& f) {
  f("is_grounded", ground.is_grounded);
  f("object", ground.object);
  f("normal", ground.normal);
  f("frame", ground.frame);
  f("local", ground.local);
  f("point", ground.point);
}

/// An object that a character touched during a move: within its skin, or in its way.
template <Scalar S, int N>
struct MoverTouch {
  ObjectId object;
  Vec<S, N> point;
  Direction<S, N> normal;  // away from the object

  [[nodiscard]] friend constexpr bool operator==(const MoverTouch&,
                                                 const MoverTouch&) noexcept = default;
};

/// The result of a move. `touched` has the first contacts, one for each object and normal.
template <Scalar S, int N>
struct MoveResult {
  Vec<S, N> moved;    // in total
  Vec<S, N> carried;  // part of it: by the ground that it stood on, as velocity times a frame
  Vec<S, N> pushed;   // part of it: out of objects that it overlapped or was too close to
  std::array<MoverTouch<S, N>, 8> touched{};
  std::size_t count = 0;
  bool is_stuck = false;  // it overlaps an object and cannot be pushed out

  [[nodiscard]] friend constexpr bool operator==(const MoveResult&,
                                                 const MoveResult&) noexcept = default;
};

/// Appends to a digest: the fields in order.
template <class D, Scalar S, int N>
constexpr void append(D& digest, const MoverTouch<S, N>& touch) noexcept {
  digest.add(touch.object, touch.point, touch.normal);
}
/// Appends to a digest: the three motions, the touches and their number, and whether it is stuck.
template <class D, Scalar S, int N>
constexpr void append(D& digest, const MoveResult<S, N>& result) noexcept {
  digest.add(result.moved, result.carried, result.pushed, static_cast<std::uint32_t>(result.count));
  for (std::size_t i = 0; i < result.count; ++i) digest.add(result.touched[i]);
  digest.add(result.is_stuck);
}

}  // namespace detent
