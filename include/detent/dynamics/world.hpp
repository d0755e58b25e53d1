// SPDX-License-Identifier: MIT
#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <type_traits>
#include <utility>

#include "detent/cull/list.hpp"
#include "detent/dynamics/in_world.hpp"
#include "detent/dynamics/joint/table.hpp"
#include "detent/dynamics/kick.hpp"
#include "detent/dynamics/tick.hpp"
#include "detent/dynamics/world_contact.hpp"
#include "detent/math/transform.hpp"
#include "detent/number/assert.hpp"

namespace detent {

namespace detail {

struct WorldAccess;

template <class T>
concept IsBodyShape = requires(const T& shape) {
  detail::local_form(shape);
};

// Compilers show the line with the name.
// clang-format off
template <class... Parts>
concept NamesBodies = !(IsJoint<Parts> && ...);  // detent: name the bodies' shapes: World<q16_16, 3, Sphere, BallJoint>
// clang-format on

}  // namespace detail

/// A pair of bodies that began or stopped touching in the last step, in order of their indices; for
/// compounds a pair of parts. Sensors have such events, too, and both at once for a fast body that
/// passed them within the step; the removal of a body has none.
struct TouchEvent {
  BodyId a, b;
  bool begins;
  std::uint32_t part_a = 0, part_b = 0;  // the number of the part; 0 for other bodies

  [[nodiscard]] friend constexpr bool operator==(const TouchEvent&,
                                                 const TouchEvent&) noexcept = default;
};

/// Bodies that fall, collide and come to rest. Write `World<q16_16, 3, Sphere, Obb>`, or
/// `BoundedWorld<Bounded<64>, q16_16, 3, Sphere>` for one that never allocates. Joints are named with
/// the shapes, `World<q16_16, 3, Sphere, BallJoint, HingeJoint>`; others cost nothing.
///
/// A step depends only on the bodies, the joints, their ids and their contacts, not on the order in
/// which bodies were added and removed, or on whether the world was restored from a snapshot.
/// docs/dynamics.md defines every number of a step and where it is rounded.
///
/// units:  lengths in world units, times in seconds, angles in radians
/// domain: scalars with up to 31 bits
/// exact:  as docs/dynamics.md says                     (tests/dynamics/world.test.cpp)
template <class Storage, Scalar S, int N, class... Parts>
requires detail::NamesBodies<Parts...>
class BasicWorld {
  using Types = detail::WorldTypes<Storage, S, N, Parts...>;
  using Tick = detail::Tick<Types>;
  using ContactParts = detail::ContactParts<Types>;
  using F = detail::Formats<S>;
  using Body = typename Types::Body;

  static_assert(((detail::IsBodyShape<Parts> || detail::IsJoint<Parts>)&&...),
                "detent: these are no bodies: docs/dynamics.md lists those that are; for a Plane "
                "use a large Obb, for a ConvexHull a BodyHull");

 public:
  static constexpr int dimension = N;
  using Options = BodyOptions<S, N>;
  using Settings = WorldSettings<S, N>;
  using Contacts = typename Types::Contacts;
  static constexpr std::size_t capacity = Storage::capacity;
  static constexpr std::size_t contact_capacity = Types::contacts_room;
  static constexpr std::size_t joint_capacity = Types::Group::room;
  static constexpr bool has_joints = joint_capacity != 0;

  constexpr BasicWorld() noexcept : BasicWorld(Settings()) {}
  explicit constexpr BasicWorld(const Settings& settings) noexcept
      : settings_(detail::with_valid_rate(settings)), pace_(detail::pace_of(settings_)) {}

  constexpr BasicWorld(const BasicWorld&) = default;
  /// Takes time proportional to the contents: the unused capacity of a bounded world is not copied.
  constexpr BasicWorld& operator=(const BasicWorld& other) {
    assign(other);
    return *this;
  }
  /// Leaves the other world as if nothing had ever been added to it.
  constexpr BasicWorld(BasicWorld&& other) noexcept : BasicWorld(other.settings_) {
    *this = std::move(other);
  }
  constexpr BasicWorld& operator=(BasicWorld&& other) noexcept {
    if (this == &other) return *this;
    assign(std::move(other));
    if constexpr (requires { Storage::is_growing; })
      tick_ = std::move(other.tick_);  // keeps its memory
    other.clear();
    return *this;
  }
  constexpr ~BasicWorld() = default;

  [[nodiscard]] constexpr const Settings& settings() const noexcept { return settings_; }
  [[nodiscard]] constexpr std::size_t size() const noexcept { return size_; }

  /// Adds a body at the position of the shape. Its position is the shape's center; a box's frame is
  /// its own, other shapes start along the world's axes. Nothing if the world is full, or for a
  /// compound with a part of a type that the world does not name.
  template <detail::Among<Parts...> Shape>
  requires(!detail::IsJoint<Shape>) constexpr std::optional<BodyId> add(
      const Shape& shape, const Options& options = {}) {
    while (first_free_ < bodies_.size() && bodies_[first_free_].generation != 0) ++first_free_;
    const BodyId id{first_free_, next_};
    return put(id, shape, options) ? std::optional(id) : std::nullopt;
  }

  // Deleted: compilers show the line with the name.
  // clang-format off
  template <class Other>
  requires(!detail::Among<Other, Parts...>)
  std::optional<BodyId> add(const Other&, const Options& = {}) = delete;  // detent: name this type in that of the world: World<S, N, Sphere, HingeJoint, ...>
  // clang-format on

  /// Adds a body with an id chosen by the caller, such as that of a removed body. False if the
  /// index is in use or beyond the world's capacity, for a generation that is not in [1, 0xfffffffe],
  /// or for a compound as above. `add` then continues with the next generation: after the last one
  /// it adds nothing.
  template <detail::Among<Parts...> Shape>
  requires(!detail::IsJoint<Shape>) constexpr bool put(const BodyId& id, const Shape& shape,
                                                       const Options& options = {}) {
    if (id.generation == 0 || id.generation > last_generation || id.index >= capacity) return false;
    if (id.index < bodies_.size() && bodies_[id.index].generation != 0) return false;
    if constexpr (detail::is_compound_body<Shape>) {
      if (shape.asset != nullptr && !detail::has_only<Parts...>(*shape.asset)) return false;
    }
    if (id.index >= bodies_.size()) bodies_.resize(id.index + std::size_t{1});
    const auto local = detail::local_form(shape);
    Body& body = bodies_[id.index];
    body = Body();
    body.generation = id.generation;
    body.motion = options.motion;
    body.layers = options.layers;
    body.collides_with = options.collides_with;
    body.user = options.user;
    body.gravity_scale = options.gravity_scale;
    body.locked = options.locked;
    body.is_sensor = options.is_sensor;
    body.is_fast = options.is_fast;
    body.density = options.density;
    body.friction = options.friction;
    body.restitution = options.restitution;
    body.rolling_resistance = options.rolling_resistance;
    body.linear_damping = options.linear_damping;
    body.angular_damping = options.angular_damping;
    body.shape = decltype(body.shape)(local.shape);
    body.state.place = make_vec<N>([&](int i) { return typename F::Place(local.center[i]); });
    body.state.orientation = local.orientation;
    if (options.motion != BodyMotion::fixed) {
      body.state.velocity = per_substep(options.velocity);
      body.state.spin = per_substep(options.angular_velocity);
    }
    detail::derive(body, pace_.rate);
    is_still_ = false;
    next_ = (std::max)(next_, id.generation + 1);
    ++size_;
    return true;
  }

  /// Removes a body and its joints, and wakes the bodies that it touched or was joined to. False if
  /// no body has this id.
  constexpr bool remove(const BodyId& id) {
    if (find(id) == nullptr) return false;
    std::size_t kept = 0;
    for (std::size_t i = 0; i < contacts_.size(); ++i) {
      const auto pair = detail::pair_of(contacts_[i]);
      if (pair.has(id.index)) {
        rouse(pair);
      } else {
        contacts_[kept++] = contacts_[i];
      }
    }
    contacts_.resize(kept);
    joints_.take_all_of(id.index, [&](const detail::BodyPair& pair) { rouse(pair); });
    bodies_[id.index] = Body();
    first_free_ = (std::min)(first_free_, id.index);
    --size_;
    return true;
  }

  /// One tick: all substeps. If all bodies sleep or are fixed, it takes no time.
  constexpr void step() { step_on(detail::OneThread()); }
  /// The same on the caller's threads: `threads(count, f)` calls f(i) once for each i below
  /// `count`, on any threads in any order, and returns after all calls have. Contacts and the
  /// motion of bodies run in parallel; joints stay on this thread, as does the search for the
  /// contacts of a `BoundedWorld`.
  ///
  /// exact:  the bits of `step()`                         (tests/dynamics/threads.test.cpp)
  template <Threads T>
  constexpr void step(T&& threads) {
    step_on(detail::ManyThreads<std::remove_reference_t<T>>{threads});
  }

  // Deleted: compilers show the line with the name.
  // clang-format off
  template <class T, class... Rest>
  requires(!Threads<T>)
  void step(const T&, const Rest&...) = delete;  // detent: write step(): WorldSettings has ticks_per_second and substeps
  // clang-format on

  /// Adds a joint of two bodies, and wakes them. Nothing if the world has no room, or if a body
  /// does not exist.
  template <detail::Among<Parts...> Joint>
  requires detail::IsJoint<Joint>
  constexpr std::optional<JointId> add(const Joint& joint) {
    const auto id = joints_.vacant();
    return put(id, joint) ? std::optional(id) : std::nullopt;
  }
  /// Adds a joint with an id chosen by the caller. False if the index is in use or beyond the
  /// world's capacity, or if a body does not exist.
  template <detail::Among<Parts...> Joint>
  requires detail::IsJoint<Joint>
  constexpr bool put(const JointId& id, const Joint& joint) {
    if (!can_join(joint) || !joints_.put(id, joint)) return false;
    rouse(joints_.list[id.index].bodies());
    return true;
  }
  /// Replaces a joint by another one of the same kind, such as one with a different motor, and
  /// wakes its bodies. It keeps its impulses. False if the joint or a body does not exist.
  template <detail::Among<Parts...> Joint>
  requires detail::IsJoint<Joint>
  constexpr bool change(const JointId& id, const Joint& joint) {
    if (find_joint<Joint>(id) == nullptr || !can_join(joint)) return false;
    auto& record = joints_.list[id.index];
    rouse(record.bodies());
    record.joint = decltype(record.joint)(joint);
    rouse(record.bodies());
    return true;
  }
  /// Removes a joint and wakes its bodies. False if no joint has this id.
  constexpr bool remove(const JointId& id) requires(has_joints) {
    if (joints_.find(id) == nullptr) return false;
    rouse(joints_.take(id.index));
    return true;
  }
  [[nodiscard]] constexpr bool contains(const JointId& id) const noexcept requires(has_joints) {
    return joints_.find(id) != nullptr;
  }
  /// The joint as it was added or last changed, or nullptr if no joint of this kind has this id.
  template <detail::Among<Parts...> Joint>
  requires detail::IsJoint<Joint>
  [[nodiscard]] constexpr const Joint* find_joint(const JointId& id) const noexcept {
    const auto* record = joints_.find(id);
    return record == nullptr ? nullptr : record->joint.template get<Joint>();
  }
  [[nodiscard]] constexpr std::size_t joint_count() const noexcept requires(has_joints) {
    return joints_.size;
  }
  /// Calls f(id, joint), or f(id) if f takes only a `JointId`, for each joint in order of index.
  template <class F>
  constexpr void for_each_joint(const F& f) const requires(has_joints) {
    for (std::size_t i = 0; i < joints_.list.size(); ++i) {
      const auto& record = joints_.list[i];
      if (record.generation == 0) continue;
      const JointId id{static_cast<std::uint32_t>(i), record.generation};
      if constexpr (std::invocable<const F&, const JointId&>) {
        f(id);
      } else {
        record.joint.visit([&](const auto& joint) { f(id, joint); });
      }
    }
  }
  /// The force of a joint on its body b, the opposite of that on a: the sum of its pushes in the
  /// last substep that solved it, along their directions now. A joint breaks when this is longer than
  /// its `break_force`. Zero if no joint has this id, and before the first step.
  ///
  /// units:  force in units of mass times units per second squared
  /// exact:  each component rounded and clamped, as docs/joints.md says
  ///                                                       (tests/dynamics/joint/force.test.cpp)
  [[nodiscard]] constexpr Vec<S, N> joint_force(const JointId& id) const noexcept
      requires(has_joints) {
    const auto* record = joints_.find(id);
    if (record == nullptr) return {};
    const auto load = Types::Group::load_of(*record, bodies_, pace_.rate);
    return make_vec<N>([&](int k) { return thrust_of(*record, load[k]); });
  }
  /// The torque of a joint on its body b, the opposite of that on a, by its motor, limits and the
  /// rows that align frames, along their axes now; its pushes at the anchors do not count. Otherwise
  /// like `joint_force`.
  ///
  /// units:  torque in units of mass times units squared per second squared
  /// exact:  each component rounded and clamped, as docs/joints.md says
  ///                                                       (tests/dynamics/joint/force.test.cpp)
  [[nodiscard]] constexpr detail::Axial<S, N> joint_torque(const JointId& id) const noexcept
      requires(has_joints) {
    detail::Axial<S, N> torque{};
    const auto* record = joints_.find(id);
    if (record == nullptr) return torque;
    const auto twist = Types::Group::twist_of(*record, bodies_, pace_.rate);
    for (std::size_t k = 0; k < torque.size(); ++k) torque[k] = thrust_of(*record, twist[k]);
    return torque;
  }

  /// The joints that broke in the last step and were removed, in order of their indices.
  [[nodiscard]] constexpr std::size_t broken_count() const noexcept requires(has_joints) {
    return joints_.broken.size();
  }
  [[nodiscard]] constexpr JointId broken(std::size_t i) const noexcept requires(has_joints) {
    return joints_.broken[i];
  }

  /// A point given in the world, in the frame of a body, rounded to nearest: an anchor of a joint.
  [[nodiscard]] constexpr Vec<S, N> local_point(const BodyId& id,
                                                const Vec<S, N>& point) const noexcept {
    const Body* body = find(id);
    if (body == nullptr) return point;
    const auto axes = detail::axes_of<S, N>(body->state.orientation);
    const auto from = make_vec<N>([&](int i) { return point[i] - body->state.place[i]; });
    return make_vec<N>(
        [&](int i) { return saturate_to<S>(dot(axes[static_cast<std::size_t>(i)], from)); });
  }
  /// Axes given in the world, in the frame of a body, rounded to nearest: a frame of a joint.
  [[nodiscard]] constexpr Rotation<S, N> local_frame(const BodyId& id,
                                                     const Rotation<S, N>& frame) const noexcept {
    return compose(inverse(rotation(id)), frame);
  }

  /// Whether there is a body with this id.
  [[nodiscard]] constexpr bool contains(const BodyId& id) const noexcept {
    return find(id) != nullptr;
  }
  /// The properties of a body; nothing without such a body.
  [[nodiscard]] constexpr std::optional<BodyInfo> info(const BodyId& id) const noexcept {
    const Body* body = find(id);
    return body == nullptr ? std::nullopt : std::optional(detail::info_of(*body, id.index));
  }
  /// Calls f(info, shape) with the shape of a body in the world, or with that of each part of a
  /// compound; f(info) once if f takes only a `BodyInfo`. False without such a body.
  ///
  /// result: a `Sphere`, `Capsule` or `Obb`, at `position(id)` and along `rotation(id)`; an `Obb`
  ///         for an `Aabb`, which turns, too; `PlacedHull` and `PlacedMesh`, by `frame(id)`;
  ///         `PlacedField`, moved to `position(id)`
  /// exact:  each number of those poses rounded to nearest and clamped; parts by their own poses
  ///         (docs/dynamics.md, tests/dynamics/in_world.test.cpp)
  template <class F>
  constexpr bool visit(const BodyId& id, const F& f) const {
    const Body* body = find(id);
    if (body != nullptr) visit(*body, id.index, f);
    return body != nullptr;
  }
  /// Calls f(info, shape), or f(info), as `visit` does, for each body in order of index.
  template <class F>
  constexpr void for_each(const F& f) const {
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
      if (bodies_[i].generation != 0) visit(bodies_[i], static_cast<std::uint32_t>(i), f);
    }
  }

  /// The center of the body, rounded to nearest and clamped; the origin without such a body.
  [[nodiscard]] constexpr Vec<S, N> position(const BodyId& id) const noexcept {
    const Body* body = find(id);
    if (body == nullptr) return {};
    return detail::rounded<S, N>(body->state.place);
  }
  /// The axes of the body's frame, rounded to nearest; no rotation without such a body.
  [[nodiscard]] constexpr Rotation<S, N> rotation(const BodyId& id) const noexcept {
    const Body* body = find(id);
    if (body == nullptr) return {};
    return detail::rounded<S, N>(detail::axes_of<S, N>(body->state.orientation));
  }
  /// The pose of the body's frame: `placed(world.pose(id), shape)` is its shape in the world.
  [[nodiscard]] constexpr Transform<S, N> pose(const BodyId& id) const noexcept {
    return {position(id), rotation(id), S(1)};
  }
  /// The frame in which a hull's points or a compound's parts were given, its translation rounded
  /// to nearest and clamped: `placed(world.frame(id), box)` is a part in the world. For other
  /// shapes it is the pose.
  [[nodiscard]] constexpr Transform<S, N> frame(const BodyId& id) const noexcept {
    const Body* body = find(id);
    if (body == nullptr) return {};
    const detail::Standing<S, N> at{body->state.place,
                                    detail::axes_of<S, N>(body->state.orientation)};
    return body->shape.visit([&](const auto& shape) {
      if constexpr (requires { shape.asset->center(); }) {
        if (shape.asset != nullptr) return detail::frame_about(at, shape.asset->center());
      }
      return detail::rounded(at);
    });
  }
  /// The velocity in units per second, rounded to nearest and clamped; 0 without such a body.
  [[nodiscard]] constexpr Vec<S, N> velocity(const BodyId& id) const noexcept {
    const Body* body = find(id);
    if (body == nullptr) return {};
    return make_vec<N>([&](int i) { return per_second(body->state.velocity[i]); });
  }
  /// The angular velocity in radians per second, rounded to nearest and clamped; 0 without such a
  /// body.
  [[nodiscard]] constexpr detail::Axial<S, N> angular_velocity(const BodyId& id) const noexcept {
    detail::Axial<S, N> result{};
    const Body* body = find(id);
    if (body == nullptr) return result;
    for (std::size_t i = 0; i < result.size(); ++i) result[i] = per_second(body->state.spin[i]);
    return result;
  }
  /// The mass: density times area or volume, of compounds that of all parts. Rounded to nearest and
  /// clamped; 0 without such a body, and for bodies that are not dynamic.
  [[nodiscard]] constexpr S mass(const BodyId& id) const noexcept {
    const Body* body = find(id);
    return body == nullptr || !body->can_move() ? S(0) : saturate_to<S>(body->mass);
  }
  /// Whether the body sleeps; false without such a body. Setting its velocity, an impulse, a force or
  /// a torque wakes it.
  [[nodiscard]] constexpr bool is_asleep(const BodyId& id) const noexcept {
    const Body* body = find(id);
    return body != nullptr && body->sleeps;
  }

  /// Puts the center of a body elsewhere at once, through anything in between, and wakes it and the
  /// bodies that it touched or is joined to. It keeps its joints, velocity and orientation; its
  /// contacts lose their impulses. False if no body has this id.
  ///
  /// Snapshots taken before a fixed body was moved cannot be restored afterwards.
  ///
  /// exact:  `position` then returns the same              (tests/dynamics/teleport.test.cpp)
  constexpr bool set_position(const BodyId& id, const Vec<S, N>& position) noexcept {
    Body* body = find(id);
    if (body == nullptr) return false;
    body->state.place = make_vec<N>([&](int i) { return typename F::Place(position[i]); });
    disturb(id.index);
    return true;
  }
  /// Turns a body about its center at once; otherwise like `set_position`. Height fields stay
  /// upright.
  ///
  /// exact:  its orientation is that of an `Obb` added with this rotation
  constexpr bool set_rotation(const BodyId& id, const Rotation<S, N>& rotation) noexcept {
    Body* body = find(id);
    if (body == nullptr) return false;
    body->shape.visit([&]<class Shape>(const Shape&) {
      if constexpr (!detail::is_solid_below<Shape>) {
        body->state.orientation = detail::orientation_of(rotation);
      }
    });
    disturb(id.index);
    return true;
  }
  /// Sets the gravity of the world from the next step on, and wakes all bodies. It is part of the
  /// state: of digests, snapshots and copies.
  ///
  /// units:  units per second squared
  constexpr void set_gravity(const Vec<S, N>& gravity) noexcept {
    take_gravity(gravity);
    for (std::size_t i = 0; i < bodies_.size(); ++i) rouse(bodies_[i]);
  }

  /// Sets the velocity of a body, and wakes it. Ignored for fixed bodies.
  constexpr void set_velocity(const BodyId& id, const Vec<S, N>& velocity) noexcept {
    Body* body = find(id);
    if (body == nullptr || body->motion == BodyMotion::fixed) return;
    body->state.velocity = per_substep(velocity);
    rouse(*body);
  }
  constexpr void set_angular_velocity(const BodyId& id,
                                      const detail::Axial<S, N>& velocity) noexcept {
    Body* body = find(id);
    if (body == nullptr || body->motion == BodyMotion::fixed) return;
    body->state.spin = per_substep(velocity);
    rouse(*body);
  }

  /// Sets the layers of a body and those it collides with, and wakes it and the bodies it touched.
  /// Contacts begin and end in the next step. False if no body has this id.
  ///
  /// What these functions set is part of snapshots; snapshots taken before a fixed body was changed
  /// cannot be restored afterwards.
  constexpr bool set_filter(const BodyId& id, std::uint32_t layers,
                            std::uint32_t collides_with) noexcept {
    return set(id, [&](Body& body) {
      body.layers = layers;
      body.collides_with = collides_with;
    });
  }
  /// Sets the friction of a body from the next step on; otherwise like `set_filter`. Compounds use
  /// that of their parts.
  constexpr bool set_friction(const BodyId& id, const S& friction) noexcept {
    return set(id, [&](Body& body) { body.friction = friction; });
  }
  /// Sets the restitution of a body; otherwise like `set_friction`.
  constexpr bool set_restitution(const BodyId& id, const S& restitution) noexcept {
    return set(id, [&](Body& body) { body.restitution = restitution; });
  }
  /// Makes a body a sensor or solid; otherwise like `set_filter`. Parts of compounds that are
  /// sensors stay sensors.
  constexpr bool set_sensor(const BodyId& id, bool is_sensor) noexcept {
    return set(id, [&](Body& body) { body.is_sensor = is_sensor; });
  }
  /// Sets the share of the world's gravity that a body feels; otherwise like `set_filter`.
  constexpr bool set_gravity_scale(const BodyId& id, const S& scale) noexcept {
    return set(id, [&](Body& body) { body.gravity_scale = scale; });
  }
  /// Sets the damping of a body's velocity and of its spin; otherwise like `set_filter`.
  constexpr bool set_damping(const BodyId& id, const S& linear, const S& angular) noexcept {
    return set(id, [&](Body& body) {
      body.linear_damping = linear;
      body.angular_damping = angular;
      detail::derive_kept(body, pace_.rate);
    });
  }
  /// Sets the locked axes of a body, bits of `AxisLock`; otherwise like `set_filter`.
  constexpr bool set_locked(const BodyId& id, std::uint8_t locked) noexcept {
    return set(id, [&](Body& body) { body.locked = locked; });
  }
  /// Makes a body fast or not; otherwise like `set_filter`.
  constexpr bool set_fast(const BodyId& id, bool is_fast) noexcept {
    return set(id, [&](Body& body) { body.is_fast = is_fast; });
  }
  /// Sets the user word of a body, which no step reads, and wakes nothing. False if no body has
  /// this id.
  constexpr bool set_user(const BodyId& id, std::uint64_t user) noexcept {
    Body* body = find(id);
    if (body == nullptr) return false;
    body->user = user;
    return true;
  }

  /// Changes velocity and spin at once, by an impulse at the point `at` of the world, and wakes the
  /// body. Ignored for bodies that are not dynamic or have no mass.
  ///
  /// units:  impulse in units of mass times units per second; `at` is clamped to 512 units from the
  ///         center along each axis
  /// exact:  each component of the changes rounded once   (docs/dynamics.md, tests/dynamics/push.test.cpp)
  constexpr void apply_impulse(const BodyId& id, const Vec<S, N>& impulse,
                               const Vec<S, N>& at) noexcept {
    Body* body = find_movable(id);
    if (body == nullptr) return;
    detail::add<S, N>(kick(*body, impulse, at, pace_.rate), body->state.velocity, body->state.spin);
    rouse(*body);
  }
  /// An impulse at the center: the spin does not change.
  constexpr void apply_impulse(const BodyId& id, const Vec<S, N>& impulse) noexcept {
    Body* body = find_movable(id);
    if (body == nullptr) return;
    detail::add<S, N>({detail::velocity_of<S, N>(*body, impulse, pace_.rate), {}},
                      body->state.velocity, body->state.spin);
    rouse(*body);
  }
  /// Applies a force at the point `at` of the world in each substep of the next step, and wakes the
  /// body. Forces and torques of one step add up; `at` and the body's orientation are the current
  /// ones.
  ///
  /// units:  force in units of mass times units per second squared
  /// exact:  each component of the changes per substep rounded once       (tests/dynamics/push.test.cpp)
  constexpr void apply_force(const BodyId& id, const Vec<S, N>& force,
                             const Vec<S, N>& at) noexcept {
    Body* body = find_movable(id);
    if (body == nullptr) return;
    detail::add<S, N>(kick(*body, force, at, pace_.rate * pace_.rate), body->push, body->twist);
    rouse(*body);
  }
  /// A force at the center: the spin does not change.
  constexpr void apply_force(const BodyId& id, const Vec<S, N>& force) noexcept {
    Body* body = find_movable(id);
    if (body == nullptr) return;
    detail::add<S, N>({detail::velocity_of<S, N>(*body, force, pace_.rate * pace_.rate), {}},
                      body->push, body->twist);
    rouse(*body);
  }
  /// Applies a torque in each substep of the next step, and wakes the body.
  ///
  /// units:  torque in units of mass times squared units per second squared; about the world's axes
  /// exact:  each component of the change per substep rounded once        (tests/dynamics/push.test.cpp)
  constexpr void apply_torque(const BodyId& id, const detail::Axial<S, N>& torque) noexcept {
    Body* body = find_movable(id);
    if (body == nullptr) return;
    detail::add<S, N>({{}, detail::spin_of<S, N>(*body, torque, pace_.rate * pace_.rate)},
                      body->push, body->twist);
    rouse(*body);
  }

  /// Calls f(touch) with a `TouchEvent` for each pair that touches: those that began to and have not
  /// stopped, in the order of events.
  template <class F>
  constexpr void for_each_touch(const F& f) const {
    for (std::size_t i = 0; i < contacts_.size();) {
      const auto key = ContactParts::touching(bodies_, contacts_[i]);
      if (touches(contacts_, i, key)) f(touch_of(key, true));
    }
  }
  /// Calls f(contact) with a `WorldContact` for each contact that touches, in the order of events and
  /// triangles; none of sensors. Its normal and points are computed from the current poses, as the
  /// next step would find them, so bodies that were put apart since the step have none.
  ///
  /// result: impulses of the last substep of the last step; 0 in contacts of bodies put elsewhere
  /// exact:  each number rounded once and clamped, as docs/dynamics.md says
  ///                                                   (tests/dynamics/world_contact.test.cpp)
  template <class F>
  constexpr void for_each_contact(const F& f) const {
    visit_contacts(nullptr, f);
  }
  /// The same for the contacts of one body; none if no body has this id.
  template <class F>
  constexpr void for_each_contact(const BodyId& id, const F& f) const {
    if (find(id) != nullptr) visit_contacts(&id, f);
  }
  /// Pairs that began or stopped touching in the last step.
  [[nodiscard]] constexpr std::size_t event_count() const noexcept { return events_.size(); }
  [[nodiscard]] constexpr const TouchEvent& event(std::size_t i) const noexcept {
    DETENT_ASSERT(i < events_.size());
    return events_[i];
  }

 private:
  friend struct detail::WorldAccess;
  static constexpr std::uint32_t last_generation = 0xfffffffeu;

  template <class Threads>
  constexpr void step_on(const Threads& threads) {
    events_.clear();
    if (is_still_) return;
    const bool stood_still = tick_.run(bodies_, contacts_, joints_.list, pace_, settings_.substeps,
                                       settings_.margin, threads);
    joints_.take_broken(tick_, [&](const detail::BodyPair& pair) { rouse(pair); });
    is_still_ = stood_still;
    note_events();
  }
  [[nodiscard]] constexpr const Body* find(const BodyId& id) const noexcept {
    if (id.generation == 0 || id.index >= bodies_.size()) return nullptr;
    const Body& body = bodies_[id.index];
    return body.generation == id.generation ? &body : nullptr;
  }
  /// The body with this id, to be modified, or nullptr.
  [[nodiscard]] constexpr Body* find(const BodyId& id) noexcept {
    is_still_ = false;
    const BasicWorld& self = *this;
    return const_cast<Body*>(self.find(id));
  }
  template <class F>
  static constexpr void visit(const Body& body, std::uint32_t index, const F& f) {
    if constexpr (std::invocable<const F&, const BodyInfo&>) {
      f(detail::info_of(body, index));
    } else {
      detail::visit_in_world<Parts...>(body, index, f);
    }
  }
  [[nodiscard]] constexpr BodyId id_of(std::uint32_t index) const noexcept {
    return {index, bodies_[index].generation};
  }

  [[nodiscard]] constexpr Body* find_movable(const BodyId& id) noexcept {
    Body* body = find(id);
    return body != nullptr && body->can_move() ? body : nullptr;
  }
  [[nodiscard]] static constexpr detail::Kick<S, N> kick(const Body& body, const Vec<S, N>& push,
                                                         const Vec<S, N>& at, int per) noexcept {
    const auto arm = make_vec<N>([&](int i) {
      return saturate_to<typename F::Lever>(typename F::Place(at[i]) - body.state.place[i]);
    });
    return {detail::velocity_of<S, N>(body, push, per),
            detail::spin_of<S, N>(body, detail::moment_of<S, N>(arm, push), per)};
  }

  /// A sum of a joint's impulses as a force or torque.
  template <class Record, Number T>
  [[nodiscard]] constexpr S thrust_of(const Record& record, const T& sum) const noexcept {
    const auto pair = record.bodies();
    return detail::momentum_of<S>(bodies_[pair.a], bodies_[pair.b], sum, pace_.rate * pace_.rate);
  }
  constexpr void take_gravity(const Vec<S, N>& gravity) noexcept {
    settings_.gravity = gravity;
    pace_ = detail::pace_of(settings_);
  }

  constexpr void rouse(Body& body) noexcept {
    is_still_ = false;
    body.sleeps = false;
    body.quiet = 0;
  }
  constexpr void rouse(const detail::BodyPair& pair) noexcept {
    rouse(bodies_[pair.a]);
    rouse(bodies_[pair.b]);
  }
  template <class F>
  constexpr void for_each_contact_of(std::uint32_t index, const F& f) noexcept {
    for (std::size_t i = 0; i < contacts_.size(); ++i) {
      if (detail::pair_of(contacts_[i]).has(index)) f(contacts_[i]);
    }
  }
  /// Wakes a body and those that it touched.
  constexpr void rouse_touched(std::uint32_t index) noexcept {
    rouse(bodies_[index]);
    for_each_contact_of(index, [&](const auto& contact) { rouse(detail::pair_of(contact)); });
  }
  /// Wakes a body that was moved, and those that it touched or is joined to.
  constexpr void disturb(std::uint32_t index) noexcept {
    rouse_touched(index);
    bodies_[index].let_go();
    for_each_contact_of(index, [&](auto& contact) {
      contact.pressure = {};
      contact.friction = {};
      if constexpr (requires { contact.rolling; }) contact.rolling = {};
    });
    if constexpr (has_joints) {
      joints_.for_each_of(index, [&](const detail::BodyPair& pair) { rouse(pair); });
    }
  }
  /// Changes a property of a body by f(body), and wakes it and the bodies that it touched.
  template <class F>
  constexpr bool set(const BodyId& id, const F& f) noexcept {
    Body* body = find(id);
    if (body == nullptr) return false;
    f(*body);
    rouse_touched(id.index);
    return true;
  }
  /// Calls f with each contact that touches, of one body or of all.
  template <class F>
  constexpr void visit_contacts(const BodyId* only, const F& f) const {
    for (std::size_t i = 0, first = 0; i < contacts_.size(); first = i) {
      const auto pair = detail::pair_of(contacts_[i]);
      bool touches = false;
      for (; i < contacts_.size() && detail::pair_of(contacts_[i]) == pair; ++i) {
        touches = touches || contacts_[i].touches;
      }
      if (!touches || (only != nullptr && !pair.has(only->index))) continue;
      detail::PairContacts<Types>::visit_touching(
          bodies_, contacts_, first, settings_.margin, pace_.margin,
          [&](const auto& contact, const auto& at_a, const auto& manifold, const auto& offset) {
            const auto touch = touch_of(ContactParts::touching(bodies_, contact), true);
            WorldContact<S, N> view;
            view.a = touch.a;
            view.b = touch.b;
            view.part_a = touch.part_a;
            view.part_b = touch.part_b;
            view.triangle = ContactParts::triangle_of(bodies_, contact);
            detail::describe<S, N>(view, bodies_[pair.a], bodies_[pair.b], contact, at_a, manifold,
                                   offset, pace_.rate);
            f(view);
          });
    }
  }
  template <class Joint>
  [[nodiscard]] constexpr bool can_join(const Joint& joint) const noexcept {
    return joint.a.index != joint.b.index && contains(joint.a) && contains(joint.b);
  }

  [[nodiscard]] constexpr auto per_substep(const Vec<S, N>& v) const noexcept {
    return quotient_nearest<typename F::Speed>(v, detail::as_operand<S>(pace_.rate));
  }
  [[nodiscard]] constexpr auto per_substep(const detail::Axial<S, N>& w) const noexcept {
    detail::Axial<typename F::Spin, N> spin{};
    for (std::size_t i = 0; i < spin.size(); ++i) {
      spin[i] = quotient_nearest<typename F::Spin>(w[i], detail::as_operand<S>(pace_.rate));
    }
    return spin;
  }
  template <class T>
  [[nodiscard]] constexpr S per_second(const T& x) const noexcept {
    return saturate_to<S>(x * detail::as_operand<S>(pace_.rate));
  }

  [[nodiscard]] constexpr TouchEvent touch_of(const detail::ContactKey& key,
                                              bool begins) const noexcept {
    const auto [part_a, part_b] = ContactParts::indices(bodies_, key);
    return {id_of(key.pair.a), id_of(key.pair.b), begins, part_a, part_b};
  }
  /// Whether a pair touches in one of its contacts, which begin at k. Moves k behind them.
  template <class Contacts>
  [[nodiscard]] constexpr bool touches(const Contacts& contacts, std::size_t& k,
                                       const detail::ContactKey& key) const noexcept {
    bool any = false;
    for (; k < contacts.size() && ContactParts::touching(bodies_, contacts[k]) == key; ++k) {
      any = any || contacts[k].touches;
    }
    return any;
  }
  /// Updates the events. A pair touches if one of its contacts does; a pass begins and ends at once.
  constexpr void note_events() {
    const auto& before = tick_.contacts_before();
    const auto& passes = tick_.passes();
    std::size_t i = 0, j = 0, pass = 0;
    const auto at = [&](const auto& contacts, std::size_t k) {
      return k < contacts.size() ? ContactParts::touching(bodies_, contacts[k])
                                 : detail::ContactKey{{~0u, ~0u}};
    };
    while (i < before.size() || j < contacts_.size() || pass < passes.size()) {
      auto key = (std::min)(at(before, i), at(contacts_, j));
      if (pass < passes.size()) key = (std::min)(key, passes[pass]);
      const bool was = touches(before, i, key), is = touches(contacts_, j, key);
      if (was != is) events_.push_back(touch_of(key, is));
      if (pass < passes.size() && passes[pass] == key) {
        events_.push_back(touch_of(key, true));
        events_.push_back(touch_of(key, false));
        ++pass;
      }
    }
  }

  constexpr void clear() noexcept {
    bodies_.clear();
    contacts_.clear();
    joints_.clear();
    next_ = 1;
    first_free_ = 0;
    size_ = 0;
    events_.clear();
    is_still_ = false;
  }
  /// Copies or moves the state of another world.
  template <class World>
  constexpr void assign(World&& other) {
    settings_ = other.settings_;
    pace_ = other.pace_;
    assign_list(std::forward<World>(other).bodies_, bodies_);
    assign_list(std::forward<World>(other).contacts_, contacts_);
    joints_ = std::forward<World>(other).joints_;
    next_ = other.next_;
    first_free_ = other.first_free_;
    size_ = other.size_;
    assign_list(std::forward<World>(other).events_, events_);
    is_still_ = other.is_still_;
  }
  template <class From, class List>
  static constexpr void assign_list(From&& from, List& to) {
    if constexpr (requires { Storage::is_growing; }) {
      to = std::forward<From>(from);
    } else {
      to.resize(from.size());
      for (std::size_t i = 0; i < from.size(); ++i) to[i] = from[i];
    }
  }

  Settings settings_;
  detail::Pace<S, N> pace_;
  typename Types::Bodies bodies_;
  typename Types::Contacts contacts_;
  detail::JointTable<typename Types::Group> joints_;
  std::uint32_t next_ = 1;
  std::uint32_t first_free_ = 0;
  std::size_t size_ = 0;
  typename Storage::template List<TouchEvent, 2 * (Types::contacts_room + Types::passes_room)>
      events_;
  Tick tick_;
  // Neither the last step nor a call since then changed anything, so no further step will.
  bool is_still_ = false;
};

#if __STDC_HOSTED__
/// A world that allocates as it grows: `World<q16_16, 2, Sphere, Obb>`.
template <Scalar S, int N, template <Scalar, int> class... Shapes>
using World = BasicWorld<Growing, S, N, Shapes<S, N>...>;
#endif
/// A world stored inside the object: `BoundedWorld<Bounded<64>, q16_16, 2, Sphere, Obb>`.
template <class Storage, Scalar S, int N, template <Scalar, int> class... Shapes>
using BoundedWorld = BasicWorld<Storage, S, N, Shapes<S, N>...>;

namespace detail {

/// For snapshots and tests.
struct WorldAccess {
  template <class World>
  [[nodiscard]] static constexpr auto& bodies(World& world) noexcept {
    stir(world);
    return world.bodies_;
  }
  template <class World>
  [[nodiscard]] static constexpr auto& contacts(World& world) noexcept {
    stir(world);
    return world.contacts_;
  }
  template <class World>
  [[nodiscard]] static constexpr auto& joints(World& world) noexcept {
    stir(world);
    return world.joints_;
  }
  template <class World>
  [[nodiscard]] static constexpr std::uint32_t next(const World& world) noexcept {
    return world.next_;
  }
  template <class World>
  [[nodiscard]] static constexpr const auto& pace(const World& world) noexcept {
    return world.pace_;
  }
  template <class World>
  [[nodiscard]] static constexpr int rate(const World& world) noexcept {
    return world.pace_.rate;
  }
  template <class World, class Gravity, class Bodies, class Contacts, class Joints>
  static constexpr void assign(World& world, const Gravity& gravity, Bodies&& bodies,
                               Contacts&& contacts, Joints&& joints, std::uint32_t next,
                               std::size_t size) {
    world.take_gravity(gravity);
    world.bodies_ = std::forward<Bodies>(bodies);
    world.contacts_ = std::forward<Contacts>(contacts);
    world.joints_ = std::forward<Joints>(joints);
    world.next_ = next;
    world.first_free_ = 0;
    world.size_ = size;
    world.events_.clear();
    stir(world);
  }

 private:
  /// Marks the world as modified, so that the next step runs.
  template <class World>
  static constexpr void stir(World& world) noexcept {
    if constexpr (!std::is_const_v<World>) world.is_still_ = false;
  }
};

}  // namespace detail

}  // namespace detent
