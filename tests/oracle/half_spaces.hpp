// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>

#include "oracle/answer.hpp"

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
inline std::optional<Span> span(std::span<const HalfSpace> spaces, const Integer& max) {
  if (max < 0) return {};
  std::optional<Span> found;
  const auto consider = [&](const Moment& t) {
    if (found && !(t < found->enter) && !(found->exit < t)) return;
    for (const auto& space : spaces) {
      if (!space.holds(t)) return;
    }
    if (!found) found = Span{t, t};
    if (t < found->enter) found->enter = t;
    if (found->exit < t) found->exit = t;
  };
  const Moment last{max, 1};
  consider(Moment{});
  consider(last);
  for (const auto& space : spaces) {
    if (!space.is_crossed()) continue;
    const Moment t = space.crossing();
    if (t.over >= 0 && !(last < t)) consider(t);
  }
  return found;
}

inline bool inside_at_start(std::span<const HalfSpace> spaces) {
  for (const auto& space : spaces) {
    if (space.start > 0) return false;
  }
  return true;
}

}  // namespace detent::oracle
