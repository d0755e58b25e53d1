// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "verify/describe.hpp"

// Surfaces, scenes, worlds and their results, as text.

namespace detent::verify {

inline std::string digits(std::uint64_t digest) {
  std::string text;
  for (int bit = 60; bit >= 0; bit -= 4) text += "0123456789abcdef"[digest >> bit & 15];
  return text;
}

template <class T, std::size_t Room>
std::string words(const Listed<T, Room>& list) {
  std::string text = std::to_string(list.count);
  for (const T& item : list.kept())
    text += (&item == list.first.data() ? ": " : ", ") + words(item);
  return text;
}
inline std::string words(const Outcome& outcome) {
  return "steps done " + digits(outcome.happened) + ", objects " + std::to_string(outcome.size) +
         ", digest " + digits(outcome.digest);
}
template <Scalar S>
std::string words(const Rollback<S>& rollback) {
  return std::to_string(rollback.byte_count) + " bytes with digest " + digits(rollback.bytes) +
         "; " + std::string(describe(static_cast<Restored>(rollback.restored))) + ", digest " +
         digits(rollback.digest) + ", next id " + words(rollback.next) + ", nearest " +
         words(rollback.nearest);
}

inline std::string words(const Events& events) {
  return std::to_string(events.began) + " began, " + std::to_string(events.stayed) + " stayed, " +
         std::to_string(events.ended) + " ended, digest " + digits(events.lists.value());
}
template <Scalar S, int N>
std::string words(const Walked<S, N>& walked) {
  const auto& [mover, result] = walked;
  std::string text = "to " + words(mover.shape.a) + ", " + words(mover.shape.b);
  text += mover.ground.is_grounded ? " on object " + words(mover.ground.object) + " with normal " +
                                         words(mover.ground.normal)
                                   : std::string(" in the air");
  text += ", carried by " + words(result.carried) + ", pushed by " + words(result.pushed);
  for (std::size_t i = 0; i < result.count; ++i) {
    const auto& touch = result.touched[i];
    text += ", touches " + words(touch.object) + " at " + words(touch.point) + " with normal " +
            words(touch.normal);
  }
  return text + (result.is_stuck ? ", stuck" : "");
}

template <Scalar S, int N>
Fields fields_of(const WalkCase<S, N>& c) {
  Fields fields;
  add_fields(fields, c.start);
  fields.emplace_back("step_height", words(c.step_height));
  fields.emplace_back("snap_distance", words(c.snap_distance));
  for (std::size_t i = 0; i < c.moves; ++i) {
    fields.emplace_back("lift before move " + std::to_string(i), words(c.lift[i]));
    fields.emplace_back("move " + std::to_string(i), words(c.by[i]));
  }
  return fields;
}
template <class Shape, std::size_t Extent>
void add_numbered(Fields& fields, std::span<const Shape, Extent> shapes) {
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    Fields own;
    add_fields(own, shapes[i]);
    for (auto& [name, value] : own) {
      fields.emplace_back(std::to_string(i) + ": " + name, std::move(value));
    }
  }
}
template <Scalar S>
void add_fields(Fields& fields, const MeshTriangles<S>& mesh) {
  add_numbered(fields, std::span(mesh.triangles).first(mesh.count));
}
template <Scalar S>
void add_fields(Fields& fields, const FieldSamples<S>& field) {
  fields.emplace_back("field corner", words(field.corner));
  fields.emplace_back("field cell", words(field.cell));
  for (std::size_t row = 0; row < field.rows; ++row) {
    std::string heights;
    for (std::size_t column = 0; column < field.columns; ++column) {
      heights += (column == 0 ? "" : ", ") + words(field.heights[row * field.columns + column]);
    }
    fields.emplace_back("heights, row " + std::to_string(row), heights);
  }
}
template <Scalar S, int N>
void add_fields(Fields& fields, const CompoundParts<S, N>& parts) {
  add_numbered(fields, std::span(parts.spheres).first(parts.sphere_count));
  add_numbered(fields, std::span(parts.triangles).first(parts.triangle_count));
}
template <Scalar S>
std::string words(const MeshContacts<S>& list) {
  std::string text = std::to_string(list.count);
  for (const auto& item : list.kept()) {
    text += "; triangle " + std::to_string(item.triangle) + ", " + words(item.contact);
  }
  return text;
}

template <Scalar S, int N>
Fields fields_of(const MeshCase<S, N>& c) {
  return named_fields(c, std::array<std::string_view, 6>{"", "", "point", "", "", ""});
}
template <Scalar S, int N>
Fields fields_of(const FieldCase<S, N>& c) {
  return named_fields(c, std::array<std::string_view, 4>{"", "", "point", ""});
}

/// A step, followed by its shape if it has one.
template <Scalar S, int N>
void add_fields(Fields& fields, const Step<S, N>& step, std::size_t index) {
  const auto object = "object " + std::to_string(step.target);
  const auto frame = "frame " + std::to_string(step.target);
  const auto inside = step.frame == 0 ? "" : " in frame " + std::to_string(step.frame - 1);
  const auto say = [&](const std::string& text) {
    fields.emplace_back("step " + std::to_string(index), text);
  };
  const auto show = [&] { step.shape.visit([&](const auto& s) { add_fields(fields, s); }); };
  switch (step.deed) {
    case Deed::add:
      say(std::string("add") + (step.is_fixed ? " fixed" : "") + inside + ", layers " +
          std::to_string(step.layers) + ", user " + std::to_string(step.user));
      return show();
    case Deed::replace:
      say("replace " + object);
      return show();
    case Deed::remove:
      return say("remove " + object);
    case Deed::move:
      return say("move " + object + " by " + words(step.transform.translation));
    case Deed::set_layers:
      return say("layers of " + object + ": " + std::to_string(step.layers));
    case Deed::set_user:
      return say("user of " + object + ": " + std::to_string(step.user));
    case Deed::add_frame:
      return say("add frame" + inside + ", " + words(step.transform));
    case Deed::move_frame:
      return say("move " + frame + ": " + words(step.transform));
    default:
      return say("remove " + frame);
  }
}
template <Scalar S, int N>
void add_fields(Fields& fields, const History<S, N>& history) {
  for (std::size_t i = 0; i < history.count; ++i) {
    if (i == history.before) fields.emplace_back("snapshot", "taken here");
    add_fields(fields, history.steps[i], i);
  }
}
template <Scalar S, int N>
Fields fields_of(const SceneCase<S, N>& c) {
  return named_fields(c, std::array<std::string_view, 4>{"", "layers asked", "", "point"});
}
template <Scalar S, int N>
Fields fields_of(const SceneCastCase<S, N>& c) {
  Fields fields;
  add_numbered(fields, std::span(c.boxes));
  fields.emplace_back("layers", words(c.layers));
  fields.emplace_back("fixed, as bits", words(c.fixed));
  fields.emplace_back("layers asked", words(c.mask));
  add_fields(fields, c.moving);
  return fields;
}
template <Scalar S, int N>
Fields fields_of(const OrbitCase<S, N>& c) {
  return named_fields(c, std::array<std::string_view, 17>{
                             "", "layers asked", "fov", "aspect", "near_distance", "far_distance",
                             "target", "distance", "yaw", "pitch", "min_distance", "max_distance",
                             "rotate yaw", "rotate pitch", "zoom", "pan right", "pan up"});
}
template <Scalar S, int N>
Fields fields_of(const MeetingCase<S, N>& c) {
  return named_fields(c, std::array<std::string_view, 3>{"", "layers asked", ""});
}
template <Scalar S, int N>
Fields fields_of(const RecordCase<S, N>& c) {
  return named_fields(c, std::array<std::string_view, 3>{"", "point", ""});
}

template <Scalar S, int N>
Fields fields_of(const EventsCase<S, N>& c) {
  return named_fields(c, std::array<std::string_view, 1>{""});
}

template <Scalar S, int N>
std::string words(const Moved<S, N>& moved) {
  return words(moved.frame) + ", velocity " + words(moved.velocity) + ", spin " + words(moved.spin);
}
template <Scalar S, int N, std::size_t Count>
std::string words(const Played<S, N, Count>& played) {
  std::string text;
  for (std::size_t i = 0; i < Count; ++i) {
    text += "body " + std::to_string(i) + ": " + words(played.bodies[i]) + "; ";
  }
  return text + std::to_string(played.began) + " began to touch, " + std::to_string(played.ended) +
         " ended, digest of all ticks " + digits(played.states);
}
inline std::string words(const Replayed& replayed) {
  return std::to_string(replayed.byte_count) + " bytes with digest " + digits(replayed.bytes) +
         "; " + std::string(describe(static_cast<Restored>(replayed.restored))) +
         ", digests: saved " + digits(replayed.saved) + ", later " + digits(replayed.later) +
         ", loaded " + digits(replayed.loaded) + ", again " + digits(replayed.again);
}

/// The position, shape and properties of a body, in the notation of tests/dynamics/twin.
template <Scalar S, int N>
std::string words(const DrawnBody<S, N>& body) {
  constexpr std::array names{"ball", "capsule", "box", "aligned", "hull", "compound"};
  std::string text = names[static_cast<std::size_t>(body.form)];
  text += " at " + words(body.center);
  if (body.form == Form::hull) text += " of hull " + std::to_string(body.asset);
  if (body.form == Form::ball || body.form == Form::capsule)
    text += ", radius " + words(body.radius);
  if (body.form != Form::ball && body.form < Form::hull) text += ", half " + words(body.half);
  for (int i = 0; i < N; ++i) text += ", axis " + words(body.rotation.axis(i));
  return text;
}
template <Scalar S, int N>
std::string words(const BodyOptions<S, N>& options) {
  std::string text = "density " + words(options.density) + ", friction " + words(options.friction);
  if (options.motion == BodyMotion::fixed) return "fixed, " + text;
  text += ", restitution " + words(options.restitution) + ", damping " +
          words(options.linear_damping) + " and " + words(options.angular_damping) + ", velocity " +
          words(options.velocity) + ", spin " + words(options.angular_velocity) +
          ", gravity scale " + words(options.gravity_scale);
  if (options.locked != 0) text += ", locked " + std::to_string(options.locked);
  return text + (options.is_fast ? ", fast" : "");
}
template <Scalar S, int N, std::size_t Count>
Fields fields_of_world(const WorldCase<S, N, Count>& c) {
  Fields fields{{"gravity", words(c.settings.gravity)}};
  for (std::size_t i = 0; i < Count; ++i) {
    fields.emplace_back("body " + std::to_string(i), words(c.bodies[i]));
    fields.emplace_back("options of body " + std::to_string(i), words(c.bodies[i].options));
  }
  return fields;
}
template <Scalar S, int N, std::size_t Count>
Fields fields_of(const WorldCase<S, N, Count>& c) {
  return fields_of_world(c);
}
template <Scalar S, int N>
Fields fields_of(const SolidsCase<S, N>& c) {
  auto fields = fields_of_world(c);
  for (const auto& hull : c.hulls) add_fields(fields, hull);
  for (std::size_t i = 0; i < c.parts.size(); ++i) {
    fields.emplace_back("part " + std::to_string(i) + " of the compound", words(c.parts[i]));
    fields.emplace_back("options of part " + std::to_string(i), words(c.parts[i].options));
  }
  return fields;
}
template <HasJoints Case>
Fields fields_of(const Case& c) {
  auto fields = fields_of_world(c);
  c.for_each_joint([&]<class Joint>(const Joint& joint) {
    const auto name = "joint " + std::to_string(joint.a.index);
    const auto say = [&](const char* what, const auto& value) {
      fields.emplace_back(name + ", " + what, words(value));
    };
    say("kind", std::uint32_t{::detent::detail::joint_tag<Joint>});
    say("collide", joint.collide);
    say("break force", joint.break_force);
    if constexpr (requires { joint.frame_a; }) {
      for (int i = 0; i < c.dimension; ++i) say("axis of the frame", joint.frame_a.axis(i));
    }
    if constexpr (requires { joint.cone_angle; }) say("cone angle", joint.cone_angle);
    if constexpr (requires { joint.least; }) {
      say("least", joint.least);
      say("most", joint.most);
    }
    if constexpr (draws_spring<Joint>) {
      say("frequency", joint.frequency);
      say("damping ratio", joint.damping_ratio);
    }
    if constexpr (requires { joint.max_force; }) say("max force", joint.max_force);
    if constexpr (requires { joint.lower; }) {
      say("has limits", joint.has_limits);
      say("lower", joint.lower);
      say("upper", joint.upper);
    }
    if constexpr (requires { joint.motor_speed; }) say("motor speed", joint.motor_speed);
  });
  return fields;
}

}  // namespace detent::verify
