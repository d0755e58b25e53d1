// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>

#include "verify/judge/casts.hpp"
#include "verify/judge/meshes.hpp"
#include "verify/judge/pairs.hpp"

// Targets are judged part by part, exactly: no tree, no grid.

namespace detent::verify::judge {

/// Calls visit(part) for every part of a target, in order.
template <class Surface, class Visit>
requires requires(const Surface& surface) { triangles_of(surface); }
void visit_parts(const Surface& surface, const Visit& visit) {
  for (const auto& triangle : triangles_of(surface)) visit(triangle);
}
template <Scalar S, int N, class Visit>
void visit_parts(const CompoundParts<S, N>& parts, const Visit& visit) {
  for (std::size_t i = 0; i < parts.sphere_count; ++i) visit(parts.spheres[i]);
  for (std::size_t i = 0; i < parts.triangle_count; ++i) visit(parts.triangles[i]);
}

/// Judges by the part with the least distance_of(part), of equal ones the first: the result of
/// judge_part(part), or of judge_none() if no part has a distance.
template <Scalar S, class Target, class DistanceOf, class JudgePart, class JudgeNone>
std::optional<Wrong> judge_first(const Target& target, const DistanceOf& distance_of,
                                 const JudgePart& judge_part, const JudgeNone& judge_none) {
  std::optional<S> least;
  std::size_t count = 0, first = 0;
  visit_parts(target, [&](const auto& part) {
    const std::size_t index = count++;
    const std::optional<S> distance = distance_of(part);
    if (!distance || (least && *least <= *distance)) return;
    least = distance;
    first = index;
  });
  if (!least) return judge_none();
  std::optional<Wrong> wrong;
  count = 0;
  visit_parts(target, [&](const auto& part) {
    if (count++ == first) wrong = judge_part(part);
  });
  return wrong;
}

/// The distance of two shapes, clamped.
template <Scalar S, class First, class Second>
S distance_between(const First& a, const Second& b) {
  const auto exact = oracle::distance_floor(in_raw_units<S>(a), in_raw_units<S>(b));
  return exact ? clamped<S>(*exact) : largest<S>;
}

template <int Row, Scalar S, int N, class Target, class Answer>
std::optional<Wrong> judge(const TargetCase<S, N, Target, Sphere<S, N>>& c, const Answer& got) {
  const auto distance_of = [&](const auto& part) {
    return std::optional(distance_between<S>(part, c.shape));
  };
  if constexpr (Row == 0) {
    return judge_first<S>(
        c.target, distance_of, [&](const auto& part) { return compare(*distance_of(part), got); },
        [&] { return compare(largest<S>, got); });
  } else {
    return judge_first<S>(
        c.target, distance_of,
        [&]<class Part>(const Part& part) {
          return judge<0>(PairCase<S, N, Part, Sphere<S, N>>{part, c.shape}, got);
        },
        [&] { return compare(Answer(), got); });
  }
}

template <int Row, Scalar S, int N, class Target, class Shape, class Answer>
std::optional<Wrong> judge(const TargetCastCase<S, N, Target, Shape>& c, const Answer& got) {
  return judge_first<S>(
      c.target,
      [&](const auto& part) {
        return distance_along(oracle::travel_of(as_shape(c.shape), c.direction, part),
                              c.max_distance);
      },
      [&]<class Part>(const Part& part) {
        return judge<0>(CastCase<S, N, Shape, Part>{c.shape, c.direction, c.max_distance, part},
                        got);
      },
      [&] { return compare(Answer(), got); });
}

/// Whether a contact pushes a hull out of a triangle along the triangle's normal, by the least
/// number of units. The points are not judged.
template <Scalar S>
bool is_face_contact(const Contact<S, 3>& found, const Triangle<S, 3>& triangle,
                     const HullPoints<S, 3>& hull) {
  const auto a = oracle::raw(triangle.a);
  auto normal = oracle::cross(oracle::difference(oracle::raw(triangle.b), a),
                              oracle::difference(oracle::raw(triangle.c), a));
  if (oracle::is_zero(normal)) return false;
  const auto given = oracle::widen(raw_of(found.normal.vec()));
  if (oracle::dot(given, normal) < 0) normal = oracle::negated(normal);
  if (!oracle::is_unit_along(found.normal, normal)) return false;
  std::optional<Integer> height;
  for (std::size_t i = 0; i < hull.count; ++i) {
    const Integer h = oracle::dot(normal, oracle::difference(a, oracle::raw(hull.points[i])));
    if (!height || h > *height) height = h;
  }
  const Integer depth = oracle::raw(found.depth), squared = oracle::dot(normal, normal);
  const Integer less = depth - 1;
  const bool is_enough = depth * depth * squared >= *height * *height;
  const bool is_least = depth == 0 || less * less * squared < *height * *height;
  return *height >= 0 && (found.depth == largest<S> || is_enough) && is_least;
}

/// Which triangles at inner edges have contacts depends on rounded normals. The judge checks that
/// there is a contact if and only if there is an overlap, and that each is one of its triangle: the
/// exact one, or that along the triangle's normal.
template <int Row, Scalar S, int N, class Target>
std::optional<Wrong> judge(const TargetCase<S, N, Target, HullPoints<S, N>>& c,
                           const MeshContacts<S>& got) {
  const auto triangles = triangles_of(c.target);
  std::size_t met = 0;
  for (const auto& triangle : triangles) met += oracle::meet(triangle, as_shape(c.shape)) ? 1u : 0u;
  const auto wrong = [&](const std::string& expected) { return Wrong{expected, words(got)}; };
  if ((got.count > 0) != (met > 0) || got.count > met) {
    return wrong("contacts of " + std::to_string(met) + " overlapping triangles");
  }
  std::optional<std::uint32_t> last;
  for (const auto& [contact, index] : got.kept()) {
    if (index >= triangles.size() || (last && index <= *last)) return wrong("sorted triangles");
    last = index;
    const auto& triangle = triangles[index];
    if (!oracle::meet(triangle, as_shape(c.shape))) return wrong("overlapping triangles");
    if (is_face_contact(contact, triangle, c.shape)) continue;
    auto other = judge<0>(PairCase<S, N, Triangle<S, N>, HullPoints<S, N>>{triangle, c.shape},
                          std::optional(contact));
    if (other) return other;
  }
  return std::nullopt;
}

}  // namespace detent::verify::judge
