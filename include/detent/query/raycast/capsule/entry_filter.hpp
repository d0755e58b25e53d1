// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "detent/math/width.hpp"
#include "detent/number/filter/short_quadratic.hpp"
#include "detent/query/raycast/capsule/part.hpp"

namespace detent::detail {

/// Where a ray enters a capsule. At an end, the sphere there gives the distance, if it is hit.
template <Scalar S>
struct CapsuleEntry {
  CapsulePart part;
  std::optional<S> distance{};
};

template <class Height>
inline constexpr auto height_error = Height::from_raw(1 << 18);

/// The part that a line crosses at the height `y` along the axis of squared length `ee`, where
/// `first` is the end at 0. Lengths are multiplied by that of the axis.
template <Number Y, Number E>
[[nodiscard]] constexpr Decided<CapsulePart> part_at_height(const Approximate<Y>& y,
                                                            const E& ee) noexcept {
  const Filtered first = decide(y);
  const Filtered last = decide(Approximate{narrow<63>(ee - y.value), y.error});
  if (first == Filtered::no) return {CapsulePart::first_end, true};
  if (last == Filtered::no) return {CapsulePart::last_end, true};
  return {CapsulePart::side, first == Filtered::yes && last == Filtered::yes};
}

/// Filter for the entry of a ray with the direction `d` into the capsule about the axis from 0 to
/// `e`, where `m` is the ray's origin and `limit` its end, in products of single words. Unsure if the
/// origin is in the cylinder about the axis, or close to it.
///
/// |(m + t d) x e|^2 = r^2 e^2 is a t^2 + 2 b t + c = 0 with a = d^2 e^2 - (d.e)^2,
/// b = e^2 (m.d) - (d.e) (m.e), c = e^2 (m^2 - r^2) - (m.e)^2. Scaling e^2 and m^2 by even powers of
/// two to 62 bits, and dot products by their roots, keeps all of these below 2^60 (Cauchy-Schwarz).
template <Scalar S, int N, Number L>
[[nodiscard]] constexpr Decided<CapsuleEntry<S>> decide_capsule_entry(const Direction<S, N>& d,
                                                                      const Vec<L, N>& m,
                                                                      const Vec<L, N>& e,
                                                                      const S& radius,
                                                                      const S& limit) noexcept {
  using Word = Fixed<63, 32>;  // whose high products are integers
  static_assert(L::bits == 29 && direction_component<S>::frac == 30);
  const auto word = [](const auto& x, int scale) {
    return Word::assume_raw(scale_up<63>(x, scale).raw());
  };
  constexpr Decided<CapsuleEntry<S>> unsure{{CapsulePart::none}, false};
  const auto ee = squared_length(e), mm = squared_length(m);
  const auto outside = mm - square(radius);
  if (ee == 0 || outside <= 0) return unsure;
  const auto de = dot(d, e), md = dot(m, d);
  const auto me = dot(m, e);
  const int e_scale = even_headroom<62>(ee), m_scale = even_headroom<62>(mm);
  const auto e2 = word(ee, e_scale);
  const auto along = word(de, e_scale / 2 + 1), ahead = word(md, m_scale / 2 + 1);
  const auto before = word(me, (e_scale + m_scale) / 2);
  const ShortQuadratic side(
      narrow<61>(high_product(e2, word(squared_length(d), 2)) - high_product(along, along)),
      narrow<61>(high_product(e2, ahead) - high_product(along, before)),
      narrow<61>(high_product(e2, word(outside, m_scale)) - high_product(before, before)));
  if (side.starts_outside() != Filtered::yes) return unsure;
  const Filtered meets = side.has_roots();
  if (meets == Filtered::no) return {{CapsulePart::none}, true};
  if (meets == Filtered::unsure) return unsure;
  auto [t, is_sure] = side.first_root();
  t.exponent += 31 - L::frac - m_scale / 2;
  const auto floor = decide_floor<S>(Approximate{t, side.error});
  if (!is_sure || !floor.is_sure) return unsure;
  if (floor.value >= limit) return {{CapsulePart::none}, true};
  // On a grid 2^31 times finer t is within 2^21 steps, and its product with d.e within 2^18.
  using FineDistance = Fixed<62, S::frac + 31>;
  const auto rise =
      high_product(FineDistance::assume_raw(t.template scaled<FineDistance::frac>()), de);
  using Height = Fixed<62, decltype(rise)::frac>;
  const Approximate y{narrow<62>(narrow_floor<Height>(me) + rise), height_error<Height>};
  const auto part = part_at_height(y, narrow_floor<Height>(ee));
  return {{part.value, part.value == CapsulePart::side ? std::optional(floor.value) : std::nullopt},
          part.is_sure};
}

}  // namespace detent::detail
