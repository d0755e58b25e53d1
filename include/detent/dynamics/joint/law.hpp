// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstdint>

#include "detent/dynamics/solve.hpp"
#include "detent/number/pi.hpp"

namespace detent::detail {

/// The target of a row of a joint.
enum class Law : std::uint8_t {
  none,
  equal,   // gap 0
  spring,  // a soft `equal`
  limit,   // gap at least 0: it only pushes
  motor,   // rate `target`
};

/// A row of a joint, for a push or a turn, except for its direction.
///
/// `Rate` is Speed or Spin, `Total` the type of the row's impulse.
template <Scalar S, class Rate, class Total>
struct Terms {
  Law law = Law::none;
  bool is_capped = false;
  Softness<S> soft{};  // of `equal`, `spring` and `limit`
  Rate target{};
  Total most{};  // the greatest magnitude of the impulse, if it is capped
};

/// A spring of w h = pi / 2 and damping ratio 2: see `contact_softness`.
template <Scalar S>
inline constexpr Softness<S> joint_softness = softness<S>(963621081, 271712043);

/// The softness of a spring: with w its angle per substep, z its damping ratio and
/// p = w (2 z + w), rigid = p / (1 + p), loss = 1 / (1 + p) and pull = w^2 / (1 + p), each rounded
/// to nearest once.
template <Scalar S>
[[nodiscard]] constexpr Softness<S> spring_softness(const S& frequency, const S& damping_ratio,
                                                    int rate) noexcept {
  using Ratio = typename Formats<S>::Ratio;
  if (frequency <= 0) return {};
  const auto angle = quotient_nearest<Ratio>(times_pi(frequency + frequency), as_operand<S>(rate));
  const auto damping = damping_ratio < 0 ? S(0) : damping_ratio;
  const auto p = angle * (damping + damping + angle);
  const auto whole = S(1) + p;
  return {quotient_nearest<Ratio>(p, whole), quotient_nearest<Ratio>(angle * angle, whole),
          quotient_nearest<Ratio>(S(1), whole)};
}

/// The impulse of a row after one more solve, and the impulse before it, `total`.
///
/// rigid rate + pull gap <= 2^61 fits 62 bits, as does m t + loss total <= 2^60 + 2^61.
template <Pass P, Scalar S, class Rate, class Total>
[[nodiscard]] constexpr Total next_total(const Terms<S, Rate, Total>& terms,
                                         const typename Formats<S>::Ratio& mass, const Rate& rate,
                                         const Rate& gap, const Total& total) noexcept {
  const auto stopping = [&](const auto& excess) {
    return nearest_to<Total>(narrow_negative(narrow<62>(mass * excess)));
  };
  Total change;
  if (terms.law == Law::motor) {
    change = stopping(rate - terms.target);
  } else if (terms.law == Law::limit && gap > 0) {
    change = stopping(rate + gap);
  } else if (P == Pass::biased || terms.law == Law::spring) {
    const auto& soft = terms.soft;
    const auto wanted =
        nearest_to<Rate>(narrow<62>(narrow<62>(soft.rigid * rate) + narrow<62>(soft.pull * gap)));
    change = nearest_to<Total>(
        narrow_negative(narrow<62>(narrow<62>(mass * wanted) + narrow<62>(soft.loss * total))));
  } else {
    change = stopping(rate);
  }
  auto sum = saturate_to<Total>(total + change);
  if (terms.law == Law::limit && sum < 0) sum = Total{};
  if (terms.is_capped) sum = (std::clamp)(sum, narrow_negative(terms.most), terms.most);
  return sum;
}

}  // namespace detent::detail
