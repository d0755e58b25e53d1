// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include "detent/scene/mover/result.hpp"
#include "detent/scene/mover/run.hpp"

namespace detent {

namespace detail {

// Compilers show the line with the name.
// clang-format off
template <class World>
concept HoldsObjects = requires(const World& world, const ObjectId& id) { world.frame_of(id); };  // detent: a Mover moves through a Scene; follow(scene, world) fills one with bodies
// clang-format on

}  // namespace detail

/// A character: a capsule, sphere or axis-aligned box that walks, slides along walls, climbs steps
/// and is carried by the ground it stands on. The object is the whole state; a world stores it and
/// the velocity.
///
///     Mover<q16_16, 3, Capsule> player{{feet, head, radius}};
///     velocity.y -= gravity;
///     const auto result = player.move(scene, velocity, settings, not_itself);
///     velocity = clip_velocity(velocity, result);
///                                                             (tests/examples/character.cpp)
template <Scalar S, int N, template <class, int> class Shape>
struct Mover {
  Shape<S, N> shape;  // where it is, in the world
  Ground<S, N> ground{};

  /// Moves by `by`, the desired motion of a frame, gravity included, as far as the objects of a
  /// scene that pass `filter` allow:
  ///
  /// 1. the frame of the object that it stands on carries it along, rigidly (an object without a
  ///    frame does not, even if it moves: give platforms a frame);
  /// 2. it is pushed out of what it overlaps, by contacts (of meshes and terrain those of `contacts`,
  ///    without bumps at inner edges), in at most four steps, each at most four times as long as the
  ///    greatest of their depths;
  /// 3. standing on ground, it walks: the horizontal part of `by` leads along walls, up slopes that
  ///    are not too steep and over steps, then down to ground within `snap_distance`, or it falls;
  /// 4. in the air, it flies and slides along obstacles, and stands on the ground where it lands. A
  ///    motion upward that leads away from its ground by more than an eighth of the skin leaves the
  ///    ground, as a jump does; so does `ground = {}`.
  ///
  /// It stays a skin away from the surfaces it moves along, except in narrower gaps.
  ///
  /// units:  world units
  /// domain: every input; an empty shape passes everything; a move that would leave the range of the
  ///         scalar ends, and one longer than a quarter of that range may end early
  /// result: it never passes through an object on its way, however thin the object and fast the
  ///         move, and ends overlapping nothing except what it overlapped at the start; a mesh or a
  ///         terrain is one object. At most 32 casts, twice as many if it starts inside something
  ///         (tests/scene/mover.test.cpp, tests/scene/mover_property.test.cpp)
  /// source: cast and clip, Quake, PM_SlideMove; planes, b2SolvePlanes of Box2D 3.1; steps and
  ///         ground as CharacterVirtual of Jolt Physics
  template <detail::HoldsObjects World, ObjectFilter Filter = Everything>
  constexpr MoveResult<S, N> move(const World& world, const Vec<S, N>& by,
                                  const MoverSettings<S, N>& settings = {},
                                  const Filter& filter = {}) {
    return detail::MoverRun<S, N, World, Shape<S, N>, Filter>(world, filter, settings, shape)
        .run(*this, by);
  }

  [[nodiscard]] friend constexpr bool operator==(const Mover&, const Mover&) noexcept = default;
};

// Until version 17, clang deduces nothing for aggregates by itself.
template <Scalar S, int N, template <class, int> class Shape>
Mover(Shape<S, N>) -> Mover<S, N, Shape>;

/// Appends to a digest: shape, then ground.
template <class D, Scalar S, int N, template <class, int> class Shape>
constexpr void append(D& digest, const Mover<S, N, Shape>& mover) noexcept {
  digest.add(mover.shape, mover.ground);
}
/// Its fields in a `Desync`: see fields.hpp.
template <Scalar S, int N, template <class, int> class Shape, class F>
constexpr void for_each_field(const Mover<S, N, Shape>& mover, const F& f) {
  f("shape", mover.shape);
  f("ground", mover.ground);
}

/// The part of `velocity` that does not lead into the touched surfaces: the closest vector to it.
///
/// result: 0 where no velocity is left. A slope turns part of the velocity upward: if the game sets
///         the horizontal velocity in every frame, it must cap the vertical one, or the character
///         climbs every slope                 (tests/scene/mover.test.cpp, docs/motion.md)
template <Scalar S, int N>
[[nodiscard]] constexpr Vec<S, N> clip_velocity(const Vec<S, N>& velocity,
                                                const MoveResult<S, N>& result) noexcept {
  detail::HalfSpaces<S, N> spaces;
  for (std::size_t i = 0; i < result.count; ++i) spaces.add(result.touched[i].normal, S(0));
  // Of rounding a point on a plane.
  const S slack = is_fixed<S> ? next_up(S(0))
                              : quotient_nearest<S>(length(velocity), detail::as_operand<S>(1024));
  return spaces.closest(velocity, slack).value_or(Vec<S, N>{});
}

}  // namespace detent
