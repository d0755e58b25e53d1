// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <optional>

#include "detent/query/raycast/hit.hpp"
#include "detent/shape/compound.hpp"

namespace detent {

/// Distance along `ray` at which it first touches a part of `compound`, or nothing. Also include
/// the headers of its parts' own raycasts.
///
/// units:  lengths in world units
/// domain: every input; a compound without parts is never hit
/// exact:  hit or miss exact; distance rounded down, error in [0, 1) ULP
///         (tests/query/compound.test.cpp)
template <Scalar S, int N, class... Shapes>
[[nodiscard]] constexpr std::optional<S> raycast(const Ray<S, N>& ray,
                                                 const Compound<Shapes...>& compound) noexcept {
  std::optional<S> first;
  for_each_part(compound, [&](const auto& part) {
    const auto distance = raycast(ray, part);
    if (distance && (!first || *distance < *first)) first = distance;
  });
  return first;
}

/// Distance, point and normal where `ray` first touches a part of `compound`, or nothing.
///
/// result: of parts whose distances round down to the same number, the first counts
template <Scalar S, int N, class... Shapes>
[[nodiscard]] constexpr std::optional<RayHit<S, N>> raycast_hit(
    const Ray<S, N>& ray, const Compound<Shapes...>& compound) noexcept {
  std::optional<RayHit<S, N>> first;
  for_each_part(compound, [&](const auto& part) {
    const auto hit = raycast_hit(ray, part);
    if (hit && (!first || hit->distance < first->distance)) first = hit;
  });
  return first;
}

/// Distances at which `ray` first enters and last leaves parts of `compound`, or nothing. Gaps
/// between the parts are ignored.
///
/// exact:  both rounded down, error in [0, 1) ULP        (tests/query/compound.test.cpp)
template <Scalar S, int N, class... Shapes>
[[nodiscard]] constexpr std::optional<Interval<S>> raycast_interval(
    const Ray<S, N>& ray, const Compound<Shapes...>& compound) noexcept {
  std::optional<Interval<S>> whole;
  for_each_part(compound, [&](const auto& part) {
    const auto interval = raycast_interval(ray, part);
    if (!interval) return;
    whole = whole ? Interval<S>{(std::min)(whole->enter, interval->enter),
                                (std::max)(whole->exit, interval->exit)}
                  : *interval;
  });
  return whole;
}

}  // namespace detent
