// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <type_traits>

#include "detent/query/cast/pair.hpp"
#include "detent/shape/compound.hpp"

namespace detent {

namespace detail {

/// Like `cast`, but only the distance.
template <class A, Scalar S, int N, class... Shapes>
[[nodiscard]] constexpr std::optional<S> cast_distance(
    const A& shape, const Direction<S, N>& direction, const std::type_identity_t<S>& max_distance,
    const Compound<Shapes...>& compound) noexcept {
  std::optional<S> first;
  for_each_part(compound, [&](const auto& part) {
    const auto distance = cast_distance(shape, direction, max_distance, part);
    if (distance && (!first || *distance < *first)) first = distance;
  });
  return first;
}

}  // namespace detail

/// Where `shape`, moving along `direction` by at most `max_distance`, first touches a part of
/// `compound`, or nothing.
///
/// units:  lengths in world units
/// domain: every input; a compound without parts is never hit
/// result: of parts whose distances round down to the same number, the first counts
/// exact:  hit or miss exact; distance rounded down, error in [0, 1) ULP
///         (tests/query/cast/compound.test.cpp)
template <class A, Scalar S, int N, class... Shapes>
[[nodiscard]] constexpr std::optional<CastHit<S, N>> cast(
    const A& shape, const Direction<S, N>& direction, const std::type_identity_t<S>& max_distance,
    const Compound<Shapes...>& compound) noexcept {
  std::optional<CastHit<S, N>> first;
  for_each_part(compound, [&](const auto& part) {
    const auto hit = cast(shape, direction, max_distance, part);
    if (hit && (!first || hit->distance < first->distance)) first = hit;
  });
  return first;
}

}  // namespace detent
