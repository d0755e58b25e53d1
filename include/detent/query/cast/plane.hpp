// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <type_traits>

#include "detent/number/filter/leading.hpp"
#include "detent/number/filter/ratio.hpp"
#include "detent/number/next_up.hpp"
#include "detent/query/cast/touch.hpp"
#include "detent/query/kernel/point_plane.hpp"
#include "detent/query/kernel/rounded_point.hpp"
#include "detent/shape/plane.hpp"

namespace detent::detail {

/// The time (h - r |n|) / s of the first touch below, rounded down, or nothing if it is past
/// `limit`; in words.
///
/// |n|^2 = 1 + e with |e| <= 2^-28, so |n| is 1 + e / 2 less at most 2^-59. With that, h - r |n| is
/// off by less than 8 steps of 2^-30 S; if s >= 2^-12, the quotient is off by less than 2^10 of its
/// steps of 2^-25 S, and the division adds 8 of them.
template <Scalar S, Number Height, Number Squared, Number Speed>
[[nodiscard]] constexpr Decided<std::optional<S>> decide_time_to_plane(const Height& height,
                                                                       const S& radius,
                                                                       const Squared& squared,
                                                                       const Speed& speed,
                                                                       const S& limit) noexcept {
  using Over = Fixed<63, S::frac + 30>;
  const auto from = floor_to<Over>(height);
  const auto reach = radius + floor_to<Over>(radius * half(squared - Squared(1)));
  const auto over = from - reach;
  using Least = Fixed<2, 12>;
  if (!fits<62>(from) || over < Over::assume_raw(8) || speed < Least::assume_raw(1)) {
    return {{}, false};
  }
  const ShortQuotient<S> quotient(narrow<63>(over), speed);
  if (!quotient.is_short) return {{}, false};
  const auto floor = decide_floor<S>(Approximate{quotient.value, Steps<1 << 11>()});
  if (!floor.is_sure) return {{}, false};
  if (floor.value < limit) return {floor.value, true};
  return {{}, true};
}

/// The first touch of a shape that moves along `direction` with a plane: that of the corner of its
/// core closest to the plane.
///
/// With its height h over the plane, times the length of the normal n, and s = -n . d, it first
/// touches where (h - s t)^2 = r^2 n^2.
template <bool WithNormal, class A, Scalar S, int N>
[[nodiscard]] constexpr std::optional<Touch<S, N>> first_touch(const A& a,
                                                               const Direction<S, N>& direction,
                                                               const S& limit,
                                                               const Plane<S, N>& plane) noexcept {
  if (limit < 0 || !has_points(a)) return std::nullopt;
  const auto body = body_of(core_of(a));
  const auto [lowest, highest] = heights_above(plane, body);
  const bool is_above = lowest > 0;
  using Height = std::remove_cvref_t<decltype(lowest)>;
  const Height height = is_above      ? lowest
                        : highest < 0 ? Height(narrow_negative(highest))
                                      : Height();
  if (!(height > 0)) return Touch<S, N>{S(0), std::nullopt};
  const auto radius = radius_of(a);
  const auto nn = squared_length(plane.normal);
  const auto along = dot(plane.normal, direction);
  const auto speed = is_above ? along : narrow_negative(along);  // negative if it falls
  if constexpr (filter_pays<S>) {
    const auto decided = decide_time_to_plane(height, S(radius), nn, narrow_negative(speed), limit);
    if (decided.is_sure) {
      if (!decided.value) return std::nullopt;
      const S& distance = *decided.value;
      Touch<S, N> touch{distance, is_above ? plane.normal : -plane.normal};
      if constexpr (WithNormal) {
        // A motion changes neither which corner is closest nor the order of corners.
        const auto rest = height + speed * distance;
        using Rest = std::remove_cvref_t<decltype(rest)>;
        const auto foot = decide_foot<S>(
            least_extreme(body, plane.normal.vec(), !is_above) + direction.vec() * distance,
            plane.normal, is_above ? rest : Rest(narrow_negative(rest)));
        if (foot.is_sure) touch.point = foot.value;
      }
      return touch;
    }
  }
  const auto beyond = square(height) - square(radius) * nn;
  if (beyond <= 0) return Touch<S, N>{S(0), std::nullopt};
  if (!(speed < 0)) return std::nullopt;
  // Whether the body reaches the plane by t, or not before t.
  const auto left = [&](const S& t) { return height + speed * t; };
  const auto distance = [&]() -> std::optional<S> {
    if constexpr (is_fixed<S>) {
      const auto sign_at = [&](const S& t) {
        const auto rest = left(t);
        return rest < 0
                   ? -1
                   : (square(rest) > square(radius) * nn) - (square(rest) < square(radius) * nn);
      };
      if (sign_at(limit) > 0) return std::nullopt;
      const Leading rr = Leading(radius) * Leading(radius) * Leading(nn);
      const Leading reach = Leading(height) + sqrt(rr);
      const S below = floor_below<S>(Leading(beyond) / reach / Leading(narrow_negative(speed)));
      if (below == limit) return below;
      const S above = next_raw(below);
      return sign_at(above) >= 0 ? above : below;
    } else {
      const S t = (height - radius * sqrt_floor<S>(nn)) / -speed;
      if (t > limit) return std::nullopt;
      return t;
    }
  }();
  if (!distance) return std::nullopt;
  return Touch<S, N>{*distance, is_above ? plane.normal : -plane.normal};
}
}  // namespace detent::detail
