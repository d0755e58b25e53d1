// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "verify/describe.hpp"

// Surfaces, scenes and their results, as text.

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
template <Scalar S, int N>
Fields fields_of(const MeshCase<S, N>& c) {
  Fields fields;
  for (std::size_t i = 0; i < c.mesh.count; ++i) {
    const auto& triangle = c.mesh.triangles[i];
    fields.emplace_back("triangle " + std::to_string(i),
                        words(triangle.a) + ", " + words(triangle.b) + ", " + words(triangle.c));
  }
  add_fields(fields, c.ray);
  fields.emplace_back("point", words(c.point));
  add_fields(fields, c.segment);
  add_fields(fields, c.sphere);
  add_fields(fields, c.obb);
  return fields;
}
template <Scalar S, int N>
Fields fields_of(const FieldCase<S, N>& c) {
  Fields fields{{"field corner", words(c.field.corner)}, {"field cell", words(c.field.cell)}};
  for (std::size_t row = 0; row < c.field.rows; ++row) {
    std::string heights;
    for (std::size_t column = 0; column < c.field.columns; ++column) {
      heights += (column == 0 ? "" : ", ") + words(c.field.heights[row * c.field.columns + column]);
    }
    fields.emplace_back("heights, row " + std::to_string(row), heights);
  }
  add_fields(fields, c.ray);
  fields.emplace_back("point", words(c.point));
  add_fields(fields, c.aabb);
  return fields;
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
  Fields fields;
  add_fields(fields, c.history);
  fields.emplace_back("layers asked", std::to_string(c.mask));
  add_fields(fields, c.ray);
  fields.emplace_back("point", words(c.point));
  return fields;
}
template <Scalar S, int N>
Fields fields_of(const MeetingCase<S, N>& c) {
  Fields fields;
  add_fields(fields, c.history);
  fields.emplace_back("layers asked", std::to_string(c.mask));
  add_fields(fields, c.sphere);
  return fields;
}
template <Scalar S, int N>
Fields fields_of(const RecordCase<S, N>& c) {
  Fields fields;
  add_fields(fields, c.history);
  fields.emplace_back("point", words(c.point));
  add_fields(fields, c.sphere);
  return fields;
}

template <Scalar S, int N>
Fields fields_of(const EventsCase<S, N>& c) {
  Fields fields;
  add_fields(fields, c.history);
  return fields;
}

}  // namespace detent::verify
