// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <variant>

#include "accuracy/question.hpp"
#include "exact.hpp"
#include "oracle/apart.hpp"
#include "oracle/exact.hpp"
#include "oracle/push.hpp"
#include "oracle/travel.hpp"

// The exact results, computed by the oracle.

namespace detent::accuracy {

using cli::distance_frac;
using cli::Exact;
using Steps = oracle::Integer;

/// The exact distance in steps of 2^-48, rounded down; nothing for a miss.
using Distance = std::optional<Steps>;

inline cli::ExactShape exact(const Points<Carrier, 3>& hull) {
  cli::ExactShape shape{cli::ExactShape::Form::cloud};
  for (const auto& point : hull.points) shape.add(point);
  return shape;
}

/// The first point where a ray hits a shape in the carrier, whose lengths are in steps of 2^-frac.
template <class Shape>
Distance first_hit(const Ray<Carrier, 3>& ray, const Shape& shape, int frac) {
  using cli::exact;
  auto exact_ray = exact(ray), exact_shape = exact(shape);
  for (auto* const lengths : {&exact_ray.lengths, &exact_shape.lengths}) {
    for (auto& length : *lengths) length.exponent = -frac;
  }
  return cli::first_hit(exact_ray, exact_shape);
}

/// Whether two shapes in the carrier overlap.
template <class A, class B>
bool meet(const A& a, const B& b) {
  return oracle::meet(as_shape(a), as_shape(b));
}

/// Converts a shape in the carrier, whose lengths are in steps of 2^-frac, to steps of 2^-48.
template <class Shape>
auto in_steps(const Shape& shape, int frac) {
  auto solid = oracle::exact(as_shape(shape));
  const Steps times = Steps(1) << static_cast<unsigned>(distance_frac - frac);
  const auto scale = [&](auto&... points) {
    const auto scale_one = [&](auto& point) {
      for (auto& component : point) component *= times;
    };
    (scale_one(points), ...);
  };
  std::visit(
      [&]<class Form>(Form& form) {
        if constexpr (requires { form.radius; }) form.radius *= times;
        if constexpr (requires { form.half; }) {
          scale(form.center, form.half);
        } else if constexpr (requires { form.center; }) {
          scale(form.center);
        } else if constexpr (requires { form.low; }) {
          scale(form.low, form.high);
        } else if constexpr (requires { form.offset; }) {
          form.offset *= times;
        } else if constexpr (requires { form.start; }) {
          scale(form.start, form.end);
        } else if constexpr (requires { form.core; }) {
          scale(form.core.start, form.core.end);
        } else if constexpr (requires { form.corners; }) {
          for (auto& corner : form.corners) scale(corner);
        } else {
          for (auto& point : form.points) scale(point);
        }
      },
      solid);
  return solid;
}

/// The distance between two shapes that are not empty, in steps of 2^-48, rounded down.
template <class A, class B>
Steps distance_of(const A& a, const B& b, int frac) {
  return *oracle::distance_floor(in_steps(a, frac), in_steps(b, frac));
}

/// The first distance at which a moving shape touches a target, both in the carrier, in steps of
/// 2^-48, rounded down; nothing for none up to `max_distance`. `guess` only saves time.
template <class A, class B, int N>
Distance first_touch(const A& shape, const Direction<Carrier, N>& direction, Carrier max_distance,
                     const B& target, int frac, double guess) {
  const oracle::Travel<N> travel{oracle::exact(as_shape(shape)), oracle::exact(as_shape(target)),
                                 oracle::widen(oracle::raw(direction)), oracle::one_of<Carrier>()};
  const auto finer = static_cast<unsigned>(distance_frac - frac);
  const auto touches_by = [&](const Steps& time, const Steps& under) {
    return *oracle::clearance(travel, 0, time, under) <= 0;
  };
  const Steps one = Steps(1) << finer, last = oracle::raw(max_distance) * one;
  if (!touches_by(last, one)) return std::nullopt;
  if (touches_by(0, 1)) return Steps(0);
  // Whether it touches just before `time`: by a 2^20th of a step.
  constexpr unsigned parts = 20;
  const auto is_early = [&](const Steps& time) {
    return touches_by((time << parts) - 1, one << parts);
  };
  // The result is the last step before which it does not touch: at least `low`, below `high`.
  Steps low = 0, high = last + 1;
  if (std::isfinite(guess)) {
    Steps width = 1;
    const Steps start = std::clamp<Steps>(Exact::of(guess).steps(distance_frac), 1, last);
    const bool is_after = is_early(start);
    (is_after ? high : low) = start;
    while (high - low > width) {
      const Steps next = is_after ? Steps(high - width) : Steps(low + width);
      const bool is_next_early = is_early(next);
      (is_next_early ? high : low) = next;
      if (is_next_early != is_after) break;
      width *= 4;
    }
  }
  while (high - low > 1) {
    const Steps middle = (low + high) >> 1;
    (is_early(middle) ? high : low) = middle;
  }
  return low;
}

/// The depth of two shapes in steps of 2^-48, rounded up; nothing if they share no point.
struct Depth {
  std::optional<Steps> steps;
};
template <class A, class B>
Depth depth_of(const A& a, const B& b, int frac) {
  const auto push = oracle::least_push(in_steps(a, frac), in_steps(b, frac));
  return {push ? std::optional(push->depth) : std::nullopt};
}

}  // namespace detent::accuracy
