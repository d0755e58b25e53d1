// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "oracle/inner_edges.hpp"
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

/// The oracle decides which triangles have contacts. The points of those along a triangle's normal
/// are not judged.
template <int Row, Scalar S, int N, class Target>
std::optional<Wrong> judge(const TargetCase<S, N, Target, HullPoints<S, N>>& c,
                           const MeshContacts<S>& got) {
  using Kind = oracle::TriangleContact::Kind;
  const auto triangles = triangles_of(c.target);
  std::vector<oracle::Face<3>> faces;
  for (const auto& triangle : triangles) {
    faces.push_back({{oracle::raw(triangle.a), oracle::raw(triangle.b), oracle::raw(triangle.c)}});
  }
  constexpr bool has_front = std::is_same_v<Target, FieldSamples<S>>;
  const auto truth = oracle::surface_contacts(faces, oracle::exact(as_shape(c.shape)), has_front,
                                              oracle::one_of<S>());
  std::vector<std::uint32_t> expected;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    if (truth[i].push) expected.push_back(static_cast<std::uint32_t>(i));
  }
  const auto wrong = [&](std::string text) { return Wrong{std::move(text), words(got)}; };
  const auto kept = got.kept();
  const bool are_right = std::equal(kept.begin(), kept.end(), expected.begin(),
                                    expected.begin() + std::min(kept.size(), expected.size()),
                                    [](const auto& a, auto index) { return a.triangle == index; });
  if (got.count != expected.size() || !are_right) {
    std::string text = std::to_string(expected.size()) + " contacts, of triangles";
    for (const auto index : expected) text += ' ' + std::to_string(index);
    return wrong(text);
  }
  for (const auto& [contact, index] : kept) {
    const auto& [kind, push] = truth[index];
    if (kind == Kind::least) {
      auto other =
          judge<0>(PairCase<S, N, Triangle<S, N>, HullPoints<S, N>>{triangles[index], c.shape},
                   std::optional(contact));
      if (other) return other;
    } else if (!oracle::is_contact<S, N>(contact, push)) {
      return wrong("depth " + push->depth.str() + " units along the normal of triangle " +
                   std::to_string(index));
    }
  }
  return std::nullopt;
}

}  // namespace detent::verify::judge
