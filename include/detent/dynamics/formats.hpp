// SPDX-License-Identifier: MIT
#pragma once

#include "detent/math/vec.hpp"

namespace detent::detail {

/// The number types of a world, for each scalar; `float` and `double` use the scalar for all of
/// them.
///
/// Lengths are counted in steps of the scalar's grid, so every scalar runs the same integers: a
/// world of q24_8 is one of q16_16 with lengths 256 times as large.  (tests/dynamics/formats.test.cpp)
/// The ranges in brackets are those of q16_16.
template <Scalar S>
struct Formats {
  using Place = S;
  using Bound = S;
  using Speed = S;
  using Spin = S;
  using Impulse = S;
  using Ratio = S;
  using Anchor = S;
  using Lever = S;
  using Arm = S;
  using Moment = S;
  using Gap = S;
  using Response = S;
  using Gyration = S;
  using Sum = S;
  using Length = S;
  using Give = S;
  using Stretch = S;
  using FineSpin = S;
  using Reach = S;
  using Turn = S;
  using TurnShare = S;
  using Torque = S;
};

template <int Bits, int Frac>
struct Formats<Fixed<Bits, Frac>> {
  /// A coordinate of a body's center: the scalar's range on a grid 2^12 times finer.
  using Place = Fixed<Bits + 12, Frac + 12>;
  /// A bound of a box around a body.
  using Bound = Fixed<Bits + 15, Frac + 12>;
  /// A length per substep. [-4, 4), 960 units a second at 240 substeps
  using Speed = Fixed<30, Frac + 12>;
  /// An angle in radians per substep. [-4, 4)
  using Spin = Fixed<30, 28>;
  /// An impulse times the sum of the inverse masses: a length per substep. [-8, 8)
  using Impulse = Fixed<31, Frac + 12>;
  /// A component of a unit vector, or a share of a whole. [-2, 2)
  using Ratio = Fixed<31, 30>;
  /// A component of the orientation at which a body is held. [-2, 2)
  using Anchor = Fixed<13, 12>;
  /// A length between two bodies. [-512, 512)
  using Lever = Fixed<31, Frac + 6>;
  /// A lever about the center of a body that can move. [-128, 128)
  using Arm = Fixed<29, Frac + 6>;
  /// Such a lever times a unit vector.
  using Moment = Fixed<30, Frac + 6>;
  /// A distance between surfaces, negative where they overlap. [-512, 512)
  using Gap = Fixed<31, Frac + 6>;
  /// The change of spin by an impulse of 1: an inverse length. [-512, 512)
  using Response = Fixed<31, 38 - Frac>;
  /// The length of a vector of impulses.
  using Length = Fixed<33, Frac + 12>;
  /// An inverse squared radius of gyration. [0, 2^18), in steps of 2^-34
  using Gyration = Fixed<52, 66 - 2 * Frac>;
  /// A sum of products of moments and spins.
  using Sum = Fixed<62, Frac + 34>;
  /// A moment times a response: the contribution of turning to the inverse of an effective mass.
  using Give = Fixed<59, 30>;
  /// A ratio of two inertias. [-2^17, 2^17)
  using Stretch = Fixed<47, 30>;
  /// A spin, or an angular momentum, between two roundings. [-128, 128)
  using FineSpin = Fixed<51, 44>;
  /// A length between two points of joined bodies. [-512, 512)
  using Reach = Fixed<37, Frac + 12>;
  /// A change of the spin of b relative to a: an angular impulse. [-8, 8)
  using Turn = Fixed<31, 28>;
  /// The change of spin of one body by a turn of 1. [-128, 128)
  using TurnShare = Fixed<31, 24>;
  /// A torque over a mass: a squared length per squared substep.
  using Torque = Fixed<62, Frac + 32>;
};

}  // namespace detent::detail
