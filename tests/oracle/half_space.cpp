// SPDX-License-Identifier: MIT
#include "oracle/half_space.hpp"

namespace detent::oracle {

std::optional<Span> span(std::span<const HalfSpace> spaces, const Integer& max) {
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

bool inside_at_start(std::span<const HalfSpace> spaces) {
  for (const auto& space : spaces) {
    if (space.start > 0) return false;
  }
  return true;
}

}  // namespace detent::oracle
