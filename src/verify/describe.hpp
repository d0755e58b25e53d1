// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "verify/questions.hpp"

// Cases and results as text: every number as its raw bits and as its exact decimal.

namespace detent::verify {

/// The fields of a case: names and values.
using Fields = std::vector<std::pair<std::string, std::string>>;

template <int Bits, int Frac>
std::string words(const Fixed<Bits, Frac>& x) {
  return std::to_string(x.raw()) + " (" + to_string(x) + ")";
}
template <Scalar S>
std::string words(Angle<S> angle) {
  return std::to_string(angle.raw()) + " (" +
         to_string(Fixed<32, 32>::from_raw(static_cast<std::int64_t>(angle.raw()))) + " turns)";
}
inline std::string words(std::uint32_t bits) { return std::to_string(bits); }
inline std::string words(bool answer) { return answer ? "yes" : "no"; }
template <Number T, int N>
std::string words(const Vec<T, N>& v) {
  std::string raw, decimal;
  for (int i = 0; i < N; ++i) {
    raw += (i == 0 ? "" : ", ") + std::to_string(v[i].raw());
    decimal += (i == 0 ? "" : ", ") + to_string(v[i]);
  }
  return "{" + raw + "} (" + decimal + ")";
}
template <Scalar S, int N>
std::string words(const Direction<S, N>& direction) {
  return words(direction.vec());
}
template <Scalar S, int N>
std::string words(const RayHit<S, N>& hit) {
  return "distance " + words(hit.distance) + ", point " + words(hit.point) + ", normal " +
         words(hit.normal);
}
template <Scalar S>
std::string words(const Interval<S>& interval) {
  return words(interval.enter) + " to " + words(interval.exit);
}
template <Number T, int R, int C>
std::string words(const Mat<T, R, C>& m) {
  std::string text;
  for (int i = 0; i < R; ++i) text += (i == 0 ? "" : ", ") + words(m.row(i));
  return text;
}
template <Scalar S>
std::string words(const Quat<S>& q) {
  return words(q.vec());
}
template <Scalar S, int N>
std::string words(const Transform<S, N>& transform) {
  std::string text = "translation " + words(transform.translation);
  for (int i = 0; i < N; ++i) text += ", axis " + words(transform.rotation.axis(i));
  return text + ", scale " + words(transform.scale);
}
template <Scalar S, int N>
std::string words(const Aabb<S, N>& box) {
  return words(box.min) + " to " + words(box.max);
}
template <Scalar S, int N>
std::string words(const Sphere<S, N>& sphere) {
  return words(sphere.center) + ", radius " + words(sphere.radius);
}
template <Number T, Scalar S>
std::string words(const ScreenPoint<T, S>& point) {
  return "x " + words(point.x) + ", y " + words(point.y) + ", depth " + words(point.depth);
}
template <Scalar S, int N>
std::string words(const Contact<S, N>& contact) {
  std::string text = "depth " + words(contact.depth) + ", normal " + words(contact.normal);
  for (std::size_t i = 0; i < contact.count; ++i) {
    const auto& point = contact.points[i];
    text += ", point " + words(point.point) + " of depth " + words(point.depth) + ", feature " +
            words(point.feature);
  }
  return text;
}
template <Scalar S, int N>
std::string words(const CastHit<S, N>& hit) {
  return words(RayHit<S, N>{hit.distance, hit.point, hit.normal});
}
template <Scalar S>
std::string words(const Impact<S>& impact) {
  return "time " + words(impact.time) + ", distance " + words(impact.distance) +
         (impact.is_hit ? "" : ", not finished");
}
template <Scalar S, int N>
std::string words(const Ray<S, N>& ray) {
  return "origin " + words(ray.origin) + ", direction " + words(ray.direction) + ", max_distance " +
         words(ray.max_distance);
}
template <Scalar S>
std::string words(const MeshHit<S>& hit) {
  return "triangle " + std::to_string(hit.index) + " at " + words(hit.distance);
}
template <Scalar S>
std::string words(const MeshNearest<S>& nearest) {
  return "triangle " + std::to_string(nearest.index) + " at " + words(nearest.distance) +
         ", point " + words(nearest.point);
}
/// The notation of `detent diff`.
inline std::string words(const ObjectId& id) {
  return std::to_string(id.index) + ":" + std::to_string(id.generation);
}
template <Scalar S>
std::string words(const Found<S>& found) {
  return "object " + words(found.id) + " at " + words(found.distance);
}
inline std::string words(const Overlap& overlap) {
  return words(overlap.first) + " and " + words(overlap.second);
}
template <class T, std::size_t Size>
std::string words(const std::array<T, Size>& values) {
  std::string text;
  for (const T& value : values) text += (text.empty() ? "" : ", ") + words(value);
  return text;
}
inline std::string words(const Text& text) { return '"' + std::string(text.view()) + '"'; }
template <class T>
std::string words(const std::optional<T>& value) {
  return value ? words(*value) : "nothing";
}

template <Scalar S, int N>
void add_fields(Fields& fields, const Rotation<S, N>& rotation) {
  for (int i = 0; i < N; ++i) {
    fields.emplace_back("axis " + std::to_string(i), words(rotation.axis(i)));
  }
}
template <detent::detail::ListsFields Shape>
void add_fields(Fields& fields, const Shape& shape) {
  using Own = detent::detail::ShapeFields<Shape>;
  const auto add = [&]<class Field>(std::string_view name, const Field& field) {
    if constexpr (requires { add_fields(fields, field); }) {
      add_fields(fields, field);
    } else {
      fields.emplace_back(std::string(Own::name) + " " + std::string(name), words(field));
    }
  };
  const std::string_view* name = Own::names;
  Own::of(shape, [&](const auto&... parts) { (add(*name++, parts), ...); });
}

template <Scalar S, int N>
void add_fields(Fields& fields, const HullPoints<S, N>& hull) {
  fields.emplace_back("hull points", std::to_string(hull.count));
  for (int i = 0; i < hull.count; ++i) {
    fields.emplace_back("hull point " + std::to_string(i),
                        words(hull.points[static_cast<std::size_t>(i)]));
  }
}

template <class Shape>
void add_fields(Fields& fields, const Cast<Shape>& moving) {
  add_fields(fields, moving.shape);
  fields.emplace_back("direction", words(moving.direction));
  fields.emplace_back("max_distance", words(moving.max_distance));
}

template <Scalar S, int N>
void add_fields(Fields& fields, const Sweep<S, N>& sweep) {
  fields.emplace_back("sweep start", words(sweep.start));
  fields.emplace_back("sweep end", words(sweep.end));
  add_fields(fields, sweep.start_rotation);
  add_fields(fields, sweep.end_rotation);
}

/// The fields of a case with these names. A field without a name is described by its own fields.
template <class Case, std::size_t Count>
Fields named_fields(const Case& c, const std::array<std::string_view, Count>& names) {
  Fields fields;
  const auto add = [&]<class Field>(std::string_view name, const Field& field) {
    if constexpr (requires { words(field); }) {
      if (!name.empty()) fields.emplace_back(name, words(field));
    }
    if constexpr (requires { add_fields(fields, field); }) {
      if (name.empty()) add_fields(fields, field);
    }
  };
  c.fields([&](const auto&... values) {
    static_assert(sizeof...(values) == Count);
    const auto* name = names.data();
    (add(*name++, values), ...);
  });
  return fields;
}
template <class Case>
requires requires { Case::field_names; }
Fields fields_of(const Case& c) { return named_fields(c, Case::field_names); }

template <Scalar S, int N, class Shape>
Fields fields_of(const RayCase<S, N, Shape>& c) {
  Fields fields;
  add_fields(fields, c.ray);
  add_fields(fields, c.shape);
  if (c.facing == Facing::front) fields.emplace_back("facing", "front");
  return fields;
}
template <Scalar S, int N, class Shape>
Fields fields_of(const PointCase<S, N, Shape>& c) {
  Fields fields;
  add_fields(fields, c.shape);
  fields.emplace_back("point", words(c.point));
  fields.emplace_back("tolerance", words(c.tolerance));
  return fields;
}
/// For two shapes of one kind, the field names of the second start with "other".
template <Scalar S, int N, class First, class Second>
Fields fields_of(const PairCase<S, N, First, Second>& c) {
  Fields fields, second;
  add_fields(fields, c.a);
  add_fields(second, c.b);
  const bool is_same = fields.front().first == second.front().first;
  for (auto& [name, value] : second) {
    fields.emplace_back((is_same ? "other " : "") + name, std::move(value));
  }
  return fields;
}
/// Both shapes, with the target's field names after "target".
template <Scalar S, int N, class First, class Second>
Fields fields_of(const CastCase<S, N, First, Second>& c) {
  Fields fields, second;
  add_fields(fields, c.shape);
  fields.emplace_back("direction", words(c.direction));
  fields.emplace_back("max_distance", words(c.max_distance));
  add_fields(second, c.target);
  for (auto& [name, value] : second) fields.emplace_back("target " + name, std::move(value));
  return fields;
}
template <Scalar S, int N, class First, class Second>
Fields fields_of(const ImpactCase<S, N, First, Second>& c) {
  return named_fields(c, std::array<std::string_view, 4>{"", "", "", ""});
}
template <Scalar S, int N>
Fields fields_of(const CrossingCase<S, N>& c) {
  Fields fields;
  for (const auto& plane : c.planes) add_fields(fields, plane);
  return fields;
}
template <Scalar S, int N>
Fields fields_of(const TextCase<S, N>& c) {
  return {{"text", words(c.text)}, {"number", words(c.number)}};
}

}  // namespace detent::verify
