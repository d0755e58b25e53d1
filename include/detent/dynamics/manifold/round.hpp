// SPDX-License-Identifier: MIT
#pragma once

#include <utility>

#include "detent/dynamics/manifold/pose.hpp"
#include "detent/math/width.hpp"
#include "detent/number/filter/ratio.hpp"
#include "detent/shape/fields.hpp"
#include "detent/shape/segment.hpp"

namespace detent::detail {

/// The core segment of a round shape, with ends on the grid of levers.
template <Scalar S, int N>
struct RoundCore {
  Vec<typename Formats<S>::Lever, N> a;
  Vec<typename Formats<S>::Lever, N> b;
  S radius;

  [[nodiscard]] constexpr bool is_empty() const noexcept { return radius < 0; }
};

/// `v` in levers, clamped: without a comparison for each coordinate if all of them fit.
template <class Lever, Scalar S, int N>
[[nodiscard]] constexpr Vec<Lever, N> in_levers(const Vec<S, N>& v) noexcept {
  if constexpr (is_fixed<S>) {
    constexpr int bits = bits_of<Lever> - 1 - (Lever::frac - S::frac);
    if (fits<bits>(v)) return make_vec<N>([&](int i) { return Lever(narrow<bits>(v[i])); });
  }
  return nearest_to<Lever>(v);
}

template <Scalar S, int N>
[[nodiscard]] constexpr RoundCore<S, N> round_core(const Vec<S, N>& center, S radius) noexcept {
  const auto end = in_levers<typename Formats<S>::Lever>(center);
  return {end, end, radius};
}
template <Scalar S, int N>
[[nodiscard]] constexpr RoundCore<S, N> round_core(const Segment<S, N>& axis, S radius) noexcept {
  using Lever = typename Formats<S>::Lever;
  return {in_levers<Lever>(axis.start), in_levers<Lever>(axis.end), radius};
}
template <Round Shape>
[[nodiscard]] constexpr auto round_core(const Shape& shape) noexcept {
  return round_core(ShapeFields<Shape>::core(shape), shape.radius);
}

/// The core of b's shape in the frame of a, each coordinate rounded once.
template <Scalar S, int N>
[[nodiscard]] constexpr RoundCore<S, N> placed_core(const RelativePose<S, N>& pose,
                                                    const RoundCore<S, N>& core) noexcept {
  using Lever = typename Formats<S>::Lever;
  const auto a = placed_point<Lever>(pose, core.a);
  return {a, core.a == core.b ? a : placed_point<Lever>(pose, core.b), core.radius};
}

/// The core of a's shape in the frame of b, each coordinate rounded once.
template <Scalar S, int N>
[[nodiscard]] constexpr RoundCore<S, N> lifted_core(const RelativePose<S, N>& pose,
                                                    const RoundCore<S, N>& core) noexcept {
  const auto lifted = [&](const auto& p) {
    return nearest_to<typename Formats<S>::Lever>(turned_back(pose, p - pose.translation));
  };
  const auto a = lifted(core.a);
  return {a, core.a == core.b ? a : lifted(core.b), core.radius};
}

/// step * ratio rounded to nearest on the grid of T and clamped, for a ratio in (0, 1).
///
/// A step has at most 33 bits, so that 2^7 steps of 2^-63 in the ratio, and one for the floor, are
/// less than 2^5 of 2^-20 steps of T.
template <class T, Number Step, class Ratio>
[[nodiscard]] constexpr T share_of_step(const Step& step, const Ratio& ratio) noexcept {
  const auto exact = [&] { return quotient_nearest<T>(step * ratio.over, ratio.under); };
  if constexpr (is_fixed<T> && has_filters) {
    using Moved = Fixed<62, T::frac + 20>;
    static_assert(Step::bits <= 33 && T::frac - Step::frac <= 8);
    const auto product = wrapping_multiply<Int128>(step.raw(), ratio.quotient.value.raw());
    const auto share = Moved::assume_raw(integer_cast<typename Moved::raw_type>(
        shift_right_floor(product, 63 - (Moved::frac - Step::frac))));
    return nearest_to<T>(
        or_exact(decide_nearest<Fixed<43, T::frac>>(Approximate{share, Steps<32>()}),
                 [&] { return Fixed<43, T::frac>(exact()); }));
  } else {
    return exact();
  }
}

/// from + step * over / under for 0 < over < under, the product rounded to nearest.
template <class Foot, Number P, Number Step, Number Over, Number Under, int N>
[[nodiscard]] constexpr Vec<Foot, N> point_at_share(const Vec<P, N>& from, const Vec<Step, N>& step,
                                                    const Over& over, const Under& under) noexcept {
  const auto at = [&](const auto& ratio) {
    return make_vec<N>(
        [&](int i) { return nearest_to<Foot>(from[i] + share_of_step<Foot>(step[i], ratio)); });
  };
  if constexpr (is_fixed<Foot> && has_filters) {
    constexpr int shift = Over::frac - Under::frac;
    return at(make_ratio_below_one(over, Fixed<Under::bits + shift, Over::frac>(under)));
  } else {
    return at(detent::Ratio<Over, Under>{over, under});
  }
}

/// The point of the segment that is closest to `p`, each coordinate rounded once.
template <Scalar S, Number P, int N>
[[nodiscard]] constexpr Vec<typename ContactFormats<S>::Foot, N> foot_on(
    const RoundCore<S, N>& core, const Vec<P, N>& p) noexcept {
  using Foot = typename ContactFormats<S>::Foot;
  const auto foot = [&](const auto& edge, const auto& offset) {
    const auto along = dot(offset, edge);
    if (along <= 0) return nearest_to<Foot>(core.a);
    const auto whole = squared_length(edge);
    if (along >= whole) return nearest_to<Foot>(core.b);
    return point_at_share<Foot>(core.a, edge, along, whole);
  };
  const auto edge = core.b - core.a;
  const auto offset = p - core.a;
  if constexpr (has_filters) {  // 4 units of q16_16, so that the products fit 64 bits
    if (fits<24>(edge) && fits<36>(offset)) return foot(at_most<24>(edge), at_most<36>(offset));
  }
  return foot(edge, offset);
}

/// Whether balls about points at this squared distance are surely more than the margin apart: their
/// distance, rounded to nearest, exceeds radii plus margin if it is at least half a step more.
template <Scalar S, Number Square>
[[nodiscard]] constexpr bool are_apart([[maybe_unused]] const Square& squared,
                                       [[maybe_unused]] const S& radius_a,
                                       [[maybe_unused]] const S& radius_b,
                                       const typename Formats<S>::Gap& margin) noexcept {
  using Gap = typename Formats<S>::Gap;
  if constexpr (is_fixed<S> && has_filters) {
    const auto reach = (radius_a + radius_b) + margin;
    const auto limit = reach + half(Gap::assume_raw(1));
    return margin < (Gap::max)() && (reach < 0 || squared >= square(limit));
  } else {
    return false;
  }
}

/// Two balls about a and a + d, at a distance that rounds to `length`. The normal of equal points is
/// the x axis.
template <Scalar S, Number P, Number D, int N>
[[nodiscard]] constexpr Manifold<S, N> balls_at_distance(
    const Vec<P, N>& a, const Vec<D, N>& d, const typename ContactFormats<S>::Length& length,
    const S& radius_a, const S& radius_b, const typename Formats<S>::Gap& margin) noexcept {
  using Lever = typename Formats<S>::Lever;
  using Gap = typename Formats<S>::Gap;
  const auto separation = nearest_to<Gap>(length - (radius_a + radius_b));
  if (separation > margin) return {};
  const auto normal = unit_or_x<typename Formats<S>::Ratio>(d);
  const auto between = [&](const auto& from, const auto& arm) {
    return one_point<S, N>(normal, nearest_to<Lever>(from + normal * arm), separation, 0, margin);
  };
  const auto arm = radius_a + half(separation);
  if constexpr (has_filters) {  // 64 units of q16_16, so that the sums fit 64 bits
    if (fits<29>(arm) && fits<36>(a)) return between(at_most<36>(a), at_most<29>(arm));
  }
  return between(a, arm);
}

/// Two balls about these points.
template <Scalar S, Number P, Number Q, int N>
[[nodiscard]] constexpr Manifold<S, N> balls_manifold(
    const Vec<P, N>& a, const Vec<Q, N>& b, const S& radius_a, const S& radius_b,
    const typename Formats<S>::Gap& margin) noexcept {
  const auto d = b - a;
  const auto squared = squared_length(d);
  if (are_apart(squared, radius_a, radius_b, margin)) return {};
  const auto length = sqrt_nearest<typename ContactFormats<S>::Length>(squared);
  return balls_at_distance(a, d, length, radius_a, radius_b, margin);
}

/// The closest points of two segments, in this order: the point of the first line that is closest
/// to the second, within the first segment; its foot on the second segment; if that is an end, the
/// foot of the end on the first. The first end of a if they are parallel.
template <Scalar S, int N>
[[nodiscard]] constexpr auto closest_feet(const RoundCore<S, N>& a,
                                          const RoundCore<S, N>& b) noexcept {
  using Foot = typename ContactFormats<S>::Foot;
  using Point = Vec<Foot, N>;
  const auto on_line = [&](const auto& d1, const auto& d2, const auto& r) {
    const auto aa = dot(d1, d1), ab = dot(d1, d2), bb = dot(d2, d2);
    const auto whole = aa * bb - ab * ab;
    const auto share = ab * dot(d2, r) - dot(d1, r) * bb;
    if (whole <= 0 || share <= 0) return nearest_to<Foot>(a.a);
    if (share >= whole) return nearest_to<Foot>(a.b);
    return point_at_share<Foot>(a.a, d1, share, whole);
  };
  // With 24 bits, which is 4 units of q16_16, all products fit 128.
  Point on_a = by_width<24>(on_line, a.b - a.a, b.b - b.a, a.a - b.a);
  const Point on_b = foot_on(b, on_a);
  if (on_b == nearest_to<Foot>(b.a)) {
    on_a = foot_on(a, b.a);
  } else if (on_b == nearest_to<Foot>(b.b)) {
    on_a = foot_on(a, b.b);
  }
  return std::pair{on_a, on_b};
}

/// A direction across both segments, towards b: along the cross product if it is not 0, otherwise
/// perpendicular to a's (or b's) segment and to the axis along which that is shortest.
template <Scalar S, int N>
[[nodiscard]] constexpr auto direction_across(const RoundCore<S, N>& a,
                                              const RoundCore<S, N>& b) noexcept {
  using Ratio = typename Formats<S>::Ratio;
  const auto d1 = a.b - a.a, d2 = b.b - b.a;
  const auto& d = squared_length(d1) > 0 ? d1 : d2;
  auto normal = unit_axis<Ratio, N>(0);
  if constexpr (N == 2) {
    normal = unit_or_x<Ratio>(Vec{narrow_negative(d.y), d.x});
  } else {
    const auto both = cross(d1, d2);
    if (squared_length(both) > 0) {
      normal = unit_or_x<Ratio>(both);
    } else {
      int least = 0;
      for (int i = 1; i < 3; ++i) {
        if (abs(d[i]) < abs(d[least])) least = i;
      }
      normal = unit_or_x<Ratio>(cross(unit_axis<Ratio, 3>(least), d));
    }
  }
  const auto towards = (b.a - a.a) + (b.b - a.b);
  return dot(normal, towards) < 0 ? narrow_negative(normal) : normal;
}

/// Two round shapes in one frame, with the normal of `direction_across` if the distance of their
/// segments rounds to 0: one point or, if they are parallel within 2^-5, one at each end of the
/// part where they face each other.
template <Scalar S, int N>
[[nodiscard]] constexpr Manifold<S, N> round_manifold(
    const RoundCore<S, N>& a, const RoundCore<S, N>& b,
    const typename Formats<S>::Gap& margin) noexcept {
  using Foot = typename ContactFormats<S>::Foot;
  using Gap = typename Formats<S>::Gap;
  using Lever = typename Formats<S>::Lever;
  if (a.is_empty() || b.is_empty()) return {};
  if (a.a == a.b && b.a == b.b) return balls_manifold(a.a, b.a, a.radius, b.radius, margin);
  if (b.a == b.b) return balls_manifold(foot_on(a, b.a), b.a, a.radius, b.radius, margin);
  if (a.a == a.b) return balls_manifold(a.a, foot_on(b, a.a), a.radius, b.radius, margin);

  const auto feet = closest_feet(a, b);
  const auto apart = feet.second - feet.first;
  const auto squared = squared_length(apart);
  if (are_apart(squared, a.radius, b.radius, margin)) return {};
  const auto length = sqrt_nearest<typename ContactFormats<S>::Length>(squared);
  auto single = balls_at_distance(feet.first, apart, length, a.radius, b.radius, margin);
  if (single.count == 0) return single;
  if (length <= 0) {
    single.normal = direction_across(a, b);
    single.points[0].point = nearest_to<Lever>(
        feet.first + single.normal * (a.radius + half(single.points[0].separation)));
  }
  const auto d1 = a.b - a.a;
  const auto are_askew = [](const auto& e1, const auto& e2) {
    const auto ab = dot(e1, e2);
    const auto whole = squared_length(e1) * squared_length(e2);
    if constexpr (is_fixed<S>) {
      return (whole - ab * ab) * Fixed<11, 0>(1024) >= whole;
    } else {
      return (whole - ab * ab) * as_operand<S>(1024) >= whole;
    }
  };
  if (by_width<24>(are_askew, d1, b.b - b.a)) return single;
  const auto aa = squared_length(d1);
  // b's ends along a, from 0 to aa.
  const auto first = dot(b.a - a.a, d1), last = dot(b.b - a.a, d1);
  const bool same_way = first <= last;
  const auto low = (min)(first, last), high = (max)(first, last);
  if (low >= aa || high <= 0) return single;
  const auto end_low = nearest_to<Foot>(same_way ? b.a : b.b);
  const auto end_high = nearest_to<Foot>(same_way ? b.b : b.a);
  Manifold<S, N> result;
  result.normal = single.normal;
  const auto add = [&](const auto& on_a, const auto& on_b, std::uint32_t feature) {
    const auto separation =
        nearest_to<Gap>(dot(result.normal, on_b - on_a) - (a.radius + b.radius));
    if (separation > margin) return;
    const auto p = nearest_to<Lever>(on_a + result.normal * (a.radius + half(separation)));
    result.points[static_cast<std::size_t>(result.count++)] = {p, separation, feature};
  };
  if (low > 0) {
    add(foot_on(a, end_low), end_low, 1);
  } else {
    add(nearest_to<Foot>(a.a), foot_on(b, a.a), 1);
  }
  if (high < aa) {
    add(foot_on(a, end_high), end_high, 2);
  } else {
    add(nearest_to<Foot>(a.b), foot_on(b, a.b), 2);
  }
  return result.count > 0 ? result : single;
}

}  // namespace detent::detail
