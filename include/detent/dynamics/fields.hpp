// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <iterator>
#include <string_view>

#include "detent/dynamics/joint/bytes.hpp"
#include "detent/dynamics/world.hpp"
#include "detent/scene/fields.hpp"
#include "detent/scene/object.hpp"
#include "detent/scene/shape_tag.hpp"

// The fields of a world, so that `diff`, `SyncTest` and `Session` can name differences.

namespace detent {

namespace detail {

inline constexpr std::string_view names_of_bodies[] = {"solid hull", "mesh", "height field",
                                                       "compound"};
/// The name of a shape in a world; names of shapes that only bodies have follow those of scenes.
template <class Shape>
inline constexpr std::string_view body_shape_name =
    shape_tag<Shape> < std::size(shape_names)
        ? shape_names[shape_tag<Shape>]
        : names_of_bodies[shape_tag<Shape> - std::size(shape_names)];

/// A body, as a field of its world.
template <class Body>
struct BodyField {
  const Body& body;
  BodyId id;

  [[nodiscard]] constexpr ObjectInfo info() const noexcept {
    return {id, body.layers, body.user,
            body.motion == BodyMotion::fixed ? Motion::fixed : Motion::moving};
  }
};
template <class Body>
BodyField(const Body&, BodyId) -> BodyField<Body>;

/// Motion comes first, so that a desync names it.
template <class Body, class F>
constexpr void for_each_field(const BodyField<Body>& field, const F& f) {
  const Body& body = field.body;
  body.shape.visit([&]<class Shape>(const Shape& shape) {
    const auto with_type = [&](const PartName& name, const auto& part) {
      f(FieldName(" (").add(body_shape_name<Shape>).add(") ").add(name.view()), part);
    };
    f("", true);  // it exists
    f(" type", shape_tag<Shape>);
    with_type("place", body.state.place);
    with_type("orientation", to_array(body.state.orientation));
    with_type("velocity", body.state.velocity);
    with_type("spin", body.state.spin);
    with_type("push", body.push);
    with_type("twist", body.twist);
    with_type("drift", body.drift);
    with_type("anchor", to_array(body.anchor));
    with_type("sleeps", body.sleeps);
    with_type("quiet", body.quiet);
    with_type("motion", body.motion);
    with_type("layers", body.layers);
    with_type("collides_with", body.collides_with);
    with_type("user", body.user);
    with_type("density", body.density);
    with_type("friction", body.friction);
    with_type("restitution", body.restitution);
    with_type("rolling_resistance", body.rolling_resistance);
    with_type("linear_damping", body.linear_damping);
    with_type("angular_damping", body.angular_damping);
    with_type("gravity_scale", body.gravity_scale);
    with_type("locked", body.locked);
    with_type("is_sensor", body.is_sensor);
    with_type("is_fast", body.is_fast);
    if constexpr (HasFields<Shape>) {
      for_each_field(shape, with_type);
    } else {
      with_type("shape", shape);
    }
  });
}

/// A contact, as a field of its world. It belongs to the body with the lower index.
template <class Contact>
struct ContactField {
  const Contact& contact;
  ObjectInfo first;

  [[nodiscard]] constexpr ObjectInfo info() const noexcept { return first; }
};
template <class Contact>
ContactField(const Contact&, ObjectInfo) -> ContactField<Contact>;

template <class Contact, class F>
constexpr void for_each_field(const ContactField<Contact>& field, const F& f) {
  const Contact& contact = field.contact;
  f("", true);  // it exists
  f(" touches", contact.touches);
  f(" points", contact.count);
  for (std::size_t i = 0; i < contact.count; ++i) {
    f(FieldName(" point ").add_number(i).add(" feature"), contact.feature[i]);
    f(FieldName(" point ").add_number(i).add(" pressure"), contact.pressure[i]);
  }
  f(" friction", contact.friction);
  if constexpr (requires { contact.rolling; }) f(" rolling", contact.rolling);
}

/// A joint, as a field of its world. It belongs to its first body.
template <class Record>
struct JointField {
  const Record& record;
  ObjectInfo first;

  [[nodiscard]] constexpr ObjectInfo info() const noexcept { return first; }
};
template <class Record>
JointField(const Record&, ObjectInfo) -> JointField<Record>;

template <class Record, class F>
constexpr void for_each_field(const JointField<Record>& field, const F& f) {
  const Record& record = field.record;
  f("", true);  // it exists
  f(" push", record.push);
  f(" turn", record.turn);
  record.joint.visit([&]<class Joint>(const Joint& joint) {
    f(" type", joint_tag<Joint>);
    f(" a", joint.a.index);
    f(" b", joint.b.index);
    f(" collide", joint.collide);
    f(" has_limits", has_limits(joint));
    const auto named = [&](const char* name, const auto& x) { f(FieldName(" ").add(name), x); };
    for_each_number(joint, named);
    for_each_spring_number(joint, named);
  });
}

template <class Tag>
constexpr FieldName& add_id(FieldName& name, const Id<Tag>& id) noexcept {
  return name.add(" ").add_number(id.index).add(":").add_number(id.generation);
}

}  // namespace detail

/// Gravity, the bodies, contacts and joints of a world, such as `body 3:17 (sphere) velocity.y` or
/// `contact 3:17 4:2 point 0 pressure`, with the raw numbers of docs/dynamics.md.
///
/// (tests/dynamics/fields.test.cpp)
template <class Storage, Scalar S, int N, class... Shapes, class F>
constexpr void for_each_field(const BasicWorld<Storage, S, N, Shapes...>& world, const F& f) {
  f(" gravity", world.settings().gravity);
  const auto& bodies = detail::WorldAccess::bodies(world);
  const auto field_of = [&](std::size_t i) {
    return detail::BodyField{bodies[i],
                             BodyId{static_cast<std::uint32_t>(i), bodies[i].generation}};
  };
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    if (bodies[i].generation == 0) continue;
    FieldName name(" body");
    f(detail::add_id(name, field_of(i).id), field_of(i));
  }
  const auto& contacts = detail::WorldAccess::contacts(world);
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    const auto a = field_of(contacts[i].a).info();
    FieldName name(" contact");
    const auto with_part = [&](const auto& body, std::uint32_t part) {
      if (detail::part_count(body) != 0) name.add(" part ").add_number(part);
    };
    const auto &first = bodies[contacts[i].a], &second = bodies[contacts[i].b];
    const bool are_two = detail::part_count(first) != 0 && detail::part_count(second) != 0;
    detail::add_id(name, a.id);
    with_part(first, contacts[i].member);
    detail::add_id(name, field_of(contacts[i].b).id);
    with_part(second, are_two ? contacts[i].part : contacts[i].member);
    if (contacts[i].part != 0 && !are_two) name.add(" part ").add_number(contacts[i].part);
    f(name, detail::ContactField{contacts[i], a});
  }
  if constexpr (BasicWorld<Storage, S, N, Shapes...>::has_joints) {
    const auto& joints = detail::WorldAccess::joints(world).list;
    for (std::size_t i = 0; i < joints.size(); ++i) {
      if (joints[i].generation == 0) continue;
      FieldName name(" joint");
      detail::add_id(name, JointId{static_cast<std::uint32_t>(i), joints[i].generation});
      f(name, detail::JointField{joints[i], field_of(joints[i].bodies().a).info()});
    }
  }
}

}  // namespace detent

#include "detent/dynamics/snapshot.hpp"
