// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>

#include "oracle/integer.hpp"

namespace detent::oracle {

/// A half-space along a moving point: inside while `start + slope * t <= 0`.
struct HalfSpace {
  Integer start;
  Integer slope;

  [[nodiscard]] bool holds(const Moment& t) const { return start * t.under + slope * t.over <= 0; }
  [[nodiscard]] bool is_crossed() const { return !slope.is_zero(); }
  [[nodiscard]] Moment crossing() const { return Moment::fraction(-start, slope); }
  [[nodiscard]] bool entered_at(const Moment& t) const {
    return slope < 0 && start * t.under + slope * t.over == 0;
  }
};

struct Span {
  Moment enter;
  Moment exit;
};

/// The times in [0, max] inside all half-spaces. The ends of that interval are ends of the ray or
/// crossings, so each of these is tested by the definition. No intervals are intersected.
[[nodiscard]] std::optional<Span> span(std::span<const HalfSpace> spaces, const Integer& max);

[[nodiscard]] bool inside_at_start(std::span<const HalfSpace> spaces);

}  // namespace detent::oracle
