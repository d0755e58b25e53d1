// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "detent/dynamics/snapshot.hpp"
#include "verify/draw/bodies.hpp"
#include "verify/questions/cases.hpp"

// Worlds of bodies: their states after about a second, and after restoring a snapshot.

namespace detent::verify {

/// A world of a few bodies, and its history.
template <Scalar S, int N, std::size_t Count>
struct WorldCase {
  static constexpr int dimension = N;
  static constexpr std::size_t size = Count;

  WorldSettings<S, N> settings{};
  std::array<DrawnBody<S, N>, Count> bodies{};
};
template <class D, Scalar S, int N, std::size_t Count>
constexpr void append(D& digest, const WorldCase<S, N, Count>& c) noexcept {
  digest.add(c.settings.gravity, c.bodies);
}

/// The final pose and motion of a body.
template <Scalar S, int N>
struct Moved {
  Transform<S, N> frame{};
  Vec<S, N> velocity{};
  detail::Axial<S, N> spin{};

  [[nodiscard]] friend constexpr bool operator==(const Moved&, const Moved&) noexcept = default;
};
template <class D, Scalar S, int N>
constexpr void append(D& digest, const Moved<S, N>& moved) noexcept {
  digest.add(moved.frame, moved.velocity);
  for (const auto& w : moved.spin) digest.add(w);
}

/// The bodies after the last tick, the events of all ticks, and the digest of the states after every
/// tick: all bits of bodies, contacts and joints.
template <Scalar S, int N, std::size_t Count>
struct Played {
  std::array<Moved<S, N>, Count> bodies{};
  std::uint32_t began = 0, ended = 0;
  std::uint64_t states = 0;

  [[nodiscard]] friend constexpr bool operator==(const Played&, const Played&) noexcept = default;
};
template <class D, Scalar S, int N, std::size_t Count>
constexpr void append(D& digest, const Played<S, N, Count>& played) noexcept {
  digest.add(played.bodies, played.began, played.ended, played.states);
}

/// A snapshot of a world, restored after more ticks. The digests are those of the world when the
/// snapshot was taken, some ticks later, after restoring it, and as many ticks after that.
struct Replayed {
  std::uint32_t byte_count = 0;
  std::uint64_t bytes = 0;  // their digest
  std::uint8_t restored = 0;
  std::uint64_t saved = 0, later = 0, loaded = 0, again = 0;

  [[nodiscard]] friend constexpr bool operator==(const Replayed&,
                                                 const Replayed&) noexcept = default;
};
template <class D>
constexpr void append(D& digest, const Replayed& replayed) noexcept {
  digest.add(replayed.byte_count, replayed.bytes, replayed.restored, replayed.saved, replayed.later,
             replayed.loaded, replayed.again);
}

/// Groups of worlds run few questions, of many ticks each.
struct WorldGroup : InDimensions<2, 3> {
  static constexpr std::uint32_t share = 3000;
  static constexpr int ticks = 48;

 protected:
  /// Adds a ball, a capsule or a box.
  template <class World, Scalar S, int N>
  static constexpr std::optional<BodyId> add_plain(World& world,
                                                   const DrawnBody<S, N>& b) noexcept {
    switch (b.form) {
      case Form::ball:
        if constexpr (requires { world.add(Sphere<S, N>{}); }) {
          return world.add(Sphere<S, N>{b.center, b.radius}, b.options);
        }
        break;
      case Form::capsule:
        if constexpr (requires { world.add(Capsule<S, N>{}); }) {
          return world.add(Capsule<S, N>{nearest_to<S>(b.center - b.half),
                                         nearest_to<S>(b.center + b.half), b.radius},
                           b.options);
        }
        break;
      case Form::aligned:
        if constexpr (requires { world.add(Aabb<S, N>{}); }) {
          return world.add(
              Aabb<S, N>{nearest_to<S>(b.center - b.half), nearest_to<S>(b.center + b.half)},
              b.options);
        }
        break;
      default:
        return world.add(Obb<S, N>{b.center, b.half, b.rotation}, b.options);
    }
    return std::nullopt;
  }

  template <Scalar S, int N, std::size_t Count, class World>
  DETENT_VERIFY_NOINLINE static constexpr auto play(World& world) noexcept {
    Played<S, N, Count> result;
    Digest states;
    for (int tick = 0; tick < ticks; ++tick) {
      world.step();
      states.add(world);
      for (std::size_t i = 0; i < world.event_count(); ++i) {
        ++(world.event(i).begins ? result.began : result.ended);
      }
    }
    for (std::size_t i = 0; i < Count; ++i) {
      const BodyId id{static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(i + 1)};
      result.bodies[i] = {world.frame(id), world.velocity(id), world.angular_velocity(id)};
    }
    result.states = states.value();
    return result;
  }

  template <std::size_t Room, class World, class Assets>
  DETENT_VERIFY_NOINLINE static constexpr Replayed replay(World& world,
                                                          const Assets& assets) noexcept {
    const auto run = [&](int count) {
      for (int tick = 0; tick < count; ++tick) world.step();
      return digest(world);
    };
    Replayed result;
    std::array<std::byte, Room> room{};
    result.saved = run(ticks / 2);
    result.byte_count = static_cast<std::uint32_t>(snapshot(world, room));
    const auto bytes = std::span<const std::byte>(room).first(result.byte_count);
    Digest all;
    all.add_bytes(bytes);
    result.bytes = all.value();
    result.later = run(ticks / 4);
    result.restored = static_cast<std::uint8_t>(assets(world, bytes));
    result.loaded = digest(world);
    result.again = run(ticks / 4);
    return result;
  }

  /// The history of a world in the first row, its snapshots in the second.
  template <int Row, Scalar S, int N, std::size_t Count, class World, class Restore>
  [[nodiscard]] static constexpr auto answer_row(World& world, const Restore& restore) noexcept {
    if constexpr (Row == 0) {
      return play<S, N, Count>(world);
    } else {
      return replay<8192>(world, restore);
    }
  }
};

/// A floor and walls, and balls, capsules and boxes that fall between them.
struct Piles : WorldGroup {
  static constexpr std::array<std::string_view, 1> names{"world/pile"};
  static constexpr std::size_t falling = 5;
  template <int N>
  static constexpr std::size_t size = 1 + 2 * (N - 1) + falling;

  template <Scalar S, int N>
  static constexpr auto draw(Random& random) noexcept {
    using Stage = BodyStage<S, N>;
    Stage stage(random);
    WorldCase<S, N, size<N>> c;
    c.settings.gravity = stage.around(8);
    c.settings.gravity.y = S(-20);
    std::size_t next = 0;
    const auto add_fixed = [&](const Vec<S, N>& center, const Vec<S, N>& half) {
      auto& body = c.bodies[next++];
      body.form = Form::aligned;
      body.center = center;
      body.half = half;
      body.options = fixed_options<S, N>();
    };
    add_fixed(Stage::flat(0, -8, 0), Stage::flat(32, 8, 32));
    add_fixed(Stage::flat(-28, 64, 0), Stage::flat(8, 64, 32));
    add_fixed(Stage::flat(28, 64, 0), Stage::flat(8, 64, 32));
    if constexpr (N == 3) {
      add_fixed(Stage::flat(0, 64, -28), Stage::flat(32, 64, 8));
      add_fixed(Stage::flat(0, 64, 28), Stage::flat(32, 64, 8));
    }
    for (int i = 0; next < c.bodies.size(); ++i) {
      auto& body = c.bodies[next++];
      constexpr std::array forms{Form::ball, Form::capsule, Form::box};
      body.form = forms[static_cast<std::size_t>(random.below(3))];
      body.center = stage.around(8);
      body.center.y = stage.between_eighths(8 + 14 * i, 9 + 14 * i);
      body.half = body.form == Form::capsule ? stage.around(3) : stage.sizes(2, 4);
      body.radius = stage.between_eighths(2, 4);
      body.rotation = stage.turn();
      body.options = stage.options();
      body.options.velocity.y = stage.between_eighths(-56, -40);
      body.options.is_fast = random.one_in(8);
      if (random.one_in(8)) body.options.locked = AxisLock::turn;
      if (random.one_in(8)) body.options.gravity_scale = stage.between_eighths(4, 12);
    }
    return c;
  }

  /// The world of a case.
  template <Scalar S, int N>
  struct Living {
    BoundedWorld<Bounded<size<N>>, S, N, Sphere, Capsule, Aabb, Obb> world;

    explicit constexpr Living(const WorldCase<S, N, size<N>>& c) noexcept : world(c.settings) {
      for (const auto& body : c.bodies) add_plain(world, body);
    }
  };

  template <int Row, Scalar S, int N, std::size_t Count>
  [[nodiscard]] static constexpr auto answer(const WorldCase<S, N, Count>& c) noexcept {
    Living<S, N> living(c);
    return play<S, N, Count>(living.world);
  }
};

/// A row of boxes without gravity, each joined to the next by a different kind of joint.
template <Scalar S, int N>
struct JointsCase : WorldCase<S, N, 7> {
  DistanceJoint<S, N> rod{};
  BallJoint<S, N> ball{};
  HingeJoint<S, N> hinge{};
  WeldJoint<S, N> weld{};
  SliderJoint<S, N> slider{};
  WheelJoint<S, N> wheel{};

  /// Calls f(joint) for each joint, in order.
  template <class F>
  constexpr void for_each_joint(const F& f) const {
    f(rod);
    f(ball);
    f(hinge);
    f(weld);
    f(slider);
    f(wheel);
  }
};

/// A row of boxes without gravity, each joined to the next by a cone.
template <Scalar S, int N>
struct ConesCase : WorldCase<S, N, 5> {
  std::array<ConeJoint<S, N>, 4> cones{};

  template <class F>
  constexpr void for_each_joint(const F& f) const {
    for (const auto& cone : cones) f(cone);
  }
};

/// Whether cases draw the spring of a joint. The corpus has none of hinges and welds.
template <class Joint>
inline constexpr bool draws_spring = requires(const Joint& joint) {
  joint.frequency;
}
&&!detent::detail::has_optional_spring<Joint>;

template <class Case>
concept HasJoints = requires(const Case& c) {
  c.for_each_joint(IgnoreFields());
};

template <class D, HasJoints Case>
constexpr void append(D& digest, const Case& c) noexcept {
  digest.add(c.settings.gravity, c.bodies);
  c.for_each_joint([&]<class Joint>(const Joint& joint) {
    digest.add(joint.collide, joint.break_force);
    if constexpr (requires { joint.frame_a; }) digest.add(joint.frame_a);
    if constexpr (requires { joint.cone_angle; }) digest.add(joint.cone_angle);
    if constexpr (requires { joint.least; }) digest.add(joint.least, joint.most);
    if constexpr (draws_spring<Joint>) digest.add(joint.frequency, joint.damping_ratio);
    if constexpr (requires { joint.max_force; }) digest.add(joint.max_force);
    if constexpr (requires { joint.lower; }) {
      digest.add(joint.has_limits, joint.lower, joint.upper);
    }
    if constexpr (requires { joint.motor_speed; }) digest.add(joint.motor_speed);
  });
}

/// Draws rows of joined boxes.
struct JointGroup : WorldGroup {
 protected:
  /// The world of a case.
  template <class World>
  struct Joined {
    World world;

    template <HasJoints Case>
    explicit constexpr Joined(const Case& c) noexcept : world(c.settings) {
      for (const auto& body : c.bodies) add_plain(world, body);
      c.for_each_joint([&](const auto& joint) { world.add(joint); });
    }
  };

  template <int Row, class Living, template <Scalar, int> class Case, Scalar S, int N>
  [[nodiscard]] static constexpr auto answer_joined(const Case<S, N>& c) noexcept {
    Living living(c);
    return answer_row<Row, S, N, Case<S, N>::size>(
        living.world,
        [](auto& world, std::span<const std::byte> bytes) { return restore(world, bytes); });
  }

  template <Scalar S, int N, std::size_t Count>
  static constexpr void draw_boxes(BodyStage<S, N>& stage,
                                   std::array<DrawnBody<S, N>, Count>& bodies) noexcept {
    for (std::size_t i = 0; i < Count; ++i) {
      auto& body = bodies[i];
      body.center = BodyStage<S, N>::flat(12 * static_cast<std::int64_t>(i) - 36, 0, 0);
      body.half = stage.sizes(2, 5);
      body.options = stage.options();
      body.options.linear_damping = body.options.angular_damping = S(0);
    }
  }
  /// Joins the box with index `first` to the next one.
  template <Scalar S, int N, class Joint>
  static constexpr void draw_joint(BodyStage<S, N>& stage, std::uint32_t first,
                                   Joint& joint) noexcept {
    auto& random = stage.random;
    joint.a = {first, first + 1};
    joint.b = {first + 1, first + 2};
    joint.anchor_a = BodyStage<S, N>::flat(6, 0, 0);
    joint.anchor_b = BodyStage<S, N>::flat(-6, 0, 0);
    joint.collide = random.one_in(4);
    if constexpr (requires { joint.frame_a; }) {
      joint.frame_a = joint.frame_b = random.coin() ? stage.turn() : Rotation<S, N>();
    }
    if constexpr (requires { joint.has_limits; }) {
      joint.has_limits = random.coin();
      joint.lower = stage.between_eighths(-6, 0);
      joint.upper = stage.between_eighths(0, 6);
    }
    if constexpr (requires { joint.motor_speed; }) {
      if (random.coin()) joint.motor_speed = stage.between_eighths(-24, 24);
    }
    if constexpr (requires { joint.motor_torque; }) joint.motor_torque = S(8);
    if constexpr (requires { joint.motor_force; }) joint.motor_force = S(8);
    if constexpr (draws_spring<Joint>) {
      if (random.coin()) joint.frequency = stage.between_eighths(8, 40);
      joint.damping_ratio = stage.between_eighths(0, 8);
    }
  }
};

struct Linkages : JointGroup {
  static constexpr std::array<std::string_view, 2> names{"world/joints", "world/joints/snapshot"};

  template <Scalar S, int N>
  static constexpr auto draw(Random& random) noexcept {
    BodyStage<S, N> stage(random);
    JointsCase<S, N> c;
    c.settings.gravity = {};
    draw_boxes(stage, c.bodies);
    std::uint32_t next = 0;
    const auto join = [&](auto& joint) { draw_joint(stage, next++, joint); };
    join(c.rod);
    c.rod.least = stage.between_eighths(0, 2);
    c.rod.most = random.coin() ? c.rod.least : stage.between_eighths(2, 6);
    if (random.one_in(4)) c.rod.break_force = S(16);
    join(c.ball);
    if (c.ball.frequency != 0) c.ball.max_force = S(32);
    join(c.hinge);
    join(c.weld);
    join(c.slider);
    join(c.wheel);
    return c;
  }

  template <Scalar S, int N>
  using Living = Joined<BoundedWorld<Bounded<7>, S, N, Obb, DistanceJoint, BallJoint, HingeJoint,
                                     WeldJoint, SliderJoint, WheelJoint>>;

  template <int Row, Scalar S, int N>
  [[nodiscard]] static constexpr auto answer(const JointsCase<S, N>& c) noexcept {
    return answer_joined<Row, Living<S, N>>(c);
  }
};

struct Cones : JointGroup {
  static constexpr std::array<std::string_view, 2> names{"world/cones", "world/cones/snapshot"};
  template <int N>
  static constexpr bool asks = N == 3;

  template <Scalar S, int N>
  static constexpr auto draw(Random& random) noexcept {
    BodyStage<S, N> stage(random);
    ConesCase<S, N> c;
    c.settings.gravity = {};
    draw_boxes(stage, c.bodies);
    std::uint32_t next = 0;
    for (auto& cone : c.cones) {
      draw_joint(stage, next++, cone);
      if (!random.one_in(4)) cone.cone_angle = stage.between_eighths(1, 8);
    }
    return c;
  }

  template <Scalar S, int N>
  using Living = Joined<BoundedWorld<Bounded<5>, S, N, Obb, ConeJoint>>;

  template <int Row, Scalar S, int N>
  [[nodiscard]] static constexpr auto answer(const ConesCase<S, N>& c) noexcept {
    return answer_joined<Row, Living<S, N>>(c);
  }
};

/// Hulls and hammers that fall onto a slope: hammers are compounds of a box, a ball and a hull.
template <Scalar S, int N>
struct SolidsCase : WorldCase<S, N, 6> {
  std::array<HullPoints<S, N>, 2> hulls{};
  std::array<DrawnBody<S, N>, 3> parts{};
};
template <class D, Scalar S, int N>
constexpr void append(D& digest, const SolidsCase<S, N>& c) noexcept {
  append(digest, static_cast<const WorldCase<S, N, 6>&>(c));
  digest.add(c.hulls, c.parts);
}

struct Solids : WorldGroup {
  static constexpr std::array<std::string_view, 2> names{"world/solids", "world/solids/snapshot"};

  template <Scalar S, int N>
  static constexpr auto draw(Random& random) noexcept {
    using Stage = BodyStage<S, N>;
    Stage stage(random);
    SolidsCase<S, N> c;
    c.settings.gravity.y = S(-20);
    for (auto& hull : c.hulls) hull = draw_hull<S, N>(stage);
    for (std::size_t i = 0; i < c.parts.size(); ++i) {
      constexpr std::array forms{Form::box, Form::ball, Form::hull};
      auto& part = c.parts[i];
      part.form = forms[i];
      part.center = stage.around(4);
      part.half = stage.sizes(2, 6);
      part.radius = stage.between_eighths(2, 4);
      part.rotation = stage.turn();
      part.options.density = stage.between_eighths(4, 32);
      part.options.friction = stage.between_eighths(0, 8);
    }
    auto& floor = c.bodies[0];
    floor.center = Stage::flat(0, -16, 0);
    floor.half = Stage::flat(160, 16, 160);
    floor.options = fixed_options<S, N>();
    Frame<N> slope{{}, 0};  // up to one in five
    const auto sine = random.between(-200, 200), cosine = std::int64_t{1000};
    Raw<N> along, across;
    along[0] = cosine;
    along[1] = sine;
    across[0] = -sine;
    across[1] = cosine;
    slope.axes[0] = unit(along, Stage::one);
    slope.axes[1] = unit(across, Stage::one);
    if constexpr (N == 3) slope.axes[2][2] = Stage::one;
    floor.rotation = Stage::rotation(slope);
    for (std::size_t i = 1; i < c.bodies.size(); ++i) {
      auto& body = c.bodies[i];
      body.form = i % 2 == 1 ? Form::hull : Form::compound;
      body.asset = static_cast<std::uint8_t>(i / 2 % 2);
      body.center = stage.around(4);
      body.center.y = stage.between_eighths(16 * static_cast<std::int64_t>(i),
                                            16 * static_cast<std::int64_t>(i) + 2);
      body.rotation = stage.turn();
      body.options = stage.options();
      body.options.velocity.y = stage.between_eighths(-56, -40);
    }
    return c;
  }

  /// The world of a case, and its assets.
  template <Scalar S, int N>
  struct Living {
    std::array<SolidHull<S, N>, 2> hulls{};
    std::array<BodyPart<S, N>, 3> parts;
    SolidCompound<S, N> hammer{};
    BoundedWorld<Bounded<6>, S, N, Sphere, Obb, BodyHull, BodyCompound> world;

    explicit constexpr Living(const SolidsCase<S, N>& c) noexcept
        : hulls{solid(c, 0), solid(c, 1)},
          parts{part(c.parts[0]), part(c.parts[1]), part(c.parts[2])},
          hammer(solid_compound(3, parts).value_or(SolidCompound<S, N>())),
          world(c.settings) {
      for (const auto& body : c.bodies) {
        if (body.form == Form::hull) {
          world.add(BodyHull<S, N>{&hulls[body.asset], body.center, body.rotation}, body.options);
        } else if (body.form == Form::compound) {
          world.add(BodyCompound<S, N>{&hammer, body.center, body.rotation}, body.options);
        } else {
          add_plain(world, body);
        }
      }
    }
    Living(const Living&) = delete;
    Living& operator=(const Living&) = delete;

   private:
    static constexpr SolidHull<S, N> solid(const SolidsCase<S, N>& c, std::size_t i) noexcept {
      return solid_hull(static_cast<std::uint32_t>(i + 1), as_shape(c.hulls[i]))
          .value_or(SolidHull<S, N>());
    }
    constexpr BodyPart<S, N> part(const DrawnBody<S, N>& drawn) const noexcept {
      PartOptions<S> options;
      options.density = drawn.options.density;
      options.friction = drawn.options.friction;
      if (drawn.form == Form::ball) {
        return BodyPart(Sphere<S, N>{drawn.center, drawn.radius}, options);
      } else if (drawn.form == Form::hull) {
        return BodyPart(BodyHull<S, N>{&hulls[0], drawn.center, drawn.rotation}, options);
      } else {
        return BodyPart(Obb<S, N>{drawn.center, drawn.half, drawn.rotation}, options);
      }
    }
  };

  template <int Row, Scalar S, int N>
  [[nodiscard]] static constexpr auto answer(const SolidsCase<S, N>& c) noexcept {
    Living<S, N> living(c);
    return answer_row<Row, S, N, 6>(
        living.world, [&](auto& world, std::span<const std::byte> bytes) {
          return restore(world, bytes, std::span<const SolidHull<S, N>>(living.hulls),
                         std::span<const SolidCompound<S, N>>(&living.hammer, 1));
        });
  }

 private:
  /// A simplex about the origin, and some points near it.
  template <Scalar S, int N>
  static constexpr HullPoints<S, N> draw_hull(BodyStage<S, N>& stage) noexcept {
    HullPoints<S, N> hull;
    const auto add = [&](const Vec<S, N>& point) { hull.points[hull.count++] = point; };
    for (int corner = 0; corner <= N; ++corner) {
      auto point = stage.around(1);
      for (int i = 0; i < N; ++i) {
        const auto far = BodyStage<S, N>::eighths(i == corner - 1 ? 5 : corner == 0 ? -4 : -1);
        point[i] = BodyStage<S, N>::scalar(far + point[i].raw());
      }
      add(point);
    }
    for (auto more = stage.random.between(0, 3); more > 0; --more) add(stage.around(5));
    return hull;
  }
};

}  // namespace detent::verify
