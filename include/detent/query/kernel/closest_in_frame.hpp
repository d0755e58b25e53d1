// SPDX-License-Identifier: MIT
#pragma once

#include <type_traits>
#include <utility>

#include "detent/query/kernel/point_obb.hpp"
#include "detent/query/kernel/rounded_point.hpp"
#include "detent/query/kernel/segment_in_frame.hpp"
#include "detent/query/kernel/within_slabs.hpp"
#include "detent/shape/segment.hpp"

// An oriented box and a point or a segment, in the frame of the box, which is its slabs. A point of
// the box with coordinates x in its frame is center + sum x[i] axis(i) in the world.

namespace detent::detail {

/// The closest points of a box and a sphere around `center`.
template <Scalar S, int N>
[[nodiscard]] constexpr std::pair<Vec<S, N>, Vec<S, N>> closest_points_in_frame(
    const Obb<S, N>& box, const Vec<S, N>& center, const S& radius) noexcept {
  const auto find = [&](const auto& place) -> std::pair<Vec<S, N>, Vec<S, N>> {
    const auto clamped =
        make_vec<N>([&](int i) { return clamp_to(place[i], box.half_extents[i]); });
    if (clamped == place) return {center, center};
    const auto on_box = nearest_to<S>(box.center + from_frame(box, clamped));
    // No longer than the components of `place`.
    using Place = std::remove_cvref_t<decltype(place.x)>;
    const auto to_box = narrow<bits_of<Place>>(clamped - place);
    if (is_within(to_box, radius)) return {on_box, on_box};
    return {on_box, rounded_beyond(center, radius, from_frame(box, to_box))};
  };
  constexpr int bits = bits_of<S> + bits_of<direction_component<S>>;  // in range: 62 of 31 and 31
  return by_width<(bits > 62 ? 62 : bits)>(find, in_frame(box, center - box.center));
}

/// The t in [0, 1] for which t d is closest to the box from `low` to `high`: the first such t, or
/// the last one, as a fraction.
///
/// If some points t d are inside all slabs that d is not parallel to, those are closest. Otherwise
/// there is one closest point: an end, or where the excesses g + t speed on the axes outside their
/// slabs are least (see nearest_of_slabs).
template <Number T, Number D, int N>
[[nodiscard]] constexpr auto closest_time(const Vec<T, N>& low, const Vec<T, N>& high,
                                          const Vec<D, N>& d, bool first) noexcept {
  using Long = std::remove_cvref_t<decltype(dot(low, d) + dot(d, d))>;
  using Time = Fraction<Long, Long>;
  Time enter{Long(0), Long(1)}, leave{Long(1), Long(1)};
  for (int i = 0; i < N; ++i) {
    if (d[i] == 0) continue;
    const bool rises = d[i] > 0;
    const Long whole(square(d[i]));
    const Time in{Long((rises ? low[i] : high[i]) * d[i]), whole};
    const Time out{Long((rises ? high[i] : low[i]) * d[i]), whole};
    if (enter < in) enter = in;
    if (out < leave) leave = out;
  }
  if (!(leave < enter)) return first ? enter : leave;
  return nearest_of_slabs(low, high, d, [&](const auto& g, const auto&... speed) {
    if constexpr (sizeof...(speed) == 0) {
      const bool is_start = dot(d, excess(Vec<T, N>(), low, high)) >= 0;
      return Time{Long(is_start ? 0 : 1), Long(1)};
    } else {
      return Time{narrow<bits_of<Long>>(-dot(g, speed...)), Long(squared_length(speed...))};
    }
  });
}

/// The closest points of a box and a capsule around `axis`; ties go to the least point of the axis,
/// or to where it first enters the box.
template <Scalar S, int N>
[[nodiscard]] constexpr std::pair<Vec<S, N>, Vec<S, N>> find_closest_points_in_frame(
    const Obb<S, N>& box, const Segment<S, N>& axis, const S& radius) noexcept {
  const auto center = in_frame(box, box.center - axis.start);
  const auto along = axis.end - axis.start;
  const auto d = in_frame(box, along);
  const auto low = center - box.half_extents, high = center + box.half_extents;
  const auto gap = squared_distance_from_slabs(low, high, d);
  const bool meets = gap.numerator == 0;
  const auto t = closest_time(low, high, d, meets || !is_before(axis.end, axis.start));
  const auto& whole = t.denominator;
  const RationalPoint on_axis{axis.start * whole + along * t.numerator, whole};
  if (meets) {
    const auto point = rounded<S>(on_axis);
    return {point, point};
  }
  const auto offset = d * t.numerator - center * whole;
  using Offset = std::remove_cvref_t<decltype(offset.x)>;
  const auto clamped = make_vec<N>([&](int i) {
    const Offset extent(box.half_extents[i] * whole);
    return offset[i] > extent ? extent : offset[i] < -extent ? narrow_negative(extent) : offset[i];
  });
  const auto on_box =
      rounded<S>(RationalPoint{box.center * whole + from_frame(box, clamped), whole});
  if (gap <= square(radius)) return {on_box, on_box};
  return {on_box, nearly_rounded_beyond(on_axis, radius, from_frame(box, clamped - offset))};
}
/// The same, by a filter where it pays.
template <Scalar S, int N>
[[nodiscard]] constexpr std::pair<Vec<S, N>, Vec<S, N>> closest_points_in_frame(
    const Obb<S, N>& box, const Segment<S, N>& axis, const S& radius) noexcept {
  if constexpr (has_segment_in_frame<Obb<S, N>>) {
    const auto points = SegmentInFrame<S, N>(box, axis).closest_points(radius);
    if (points.is_sure) return points.value;
  }
  return find_closest_points_in_frame(box, axis, radius);
}

}  // namespace detent::detail
