// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "oracle/hull_round.hpp"
#include "oracle/linear.hpp"
#include "oracle/near_segment.hpp"
#include "oracle/segment_box.hpp"
#include "verify/judge/exact.hpp"

namespace detent::verify::judge {

template <class T>
concept Ball = requires(T shape) {
  shape.center;
  shape.radius;
};
template <class T>
concept Pill = requires(T shape) {
  shape.a;
  shape.radius;
};
template <class T>
concept Flat = requires(T shape) {
  shape.normal;
};
template <class T>
concept Stick = requires(T shape) {
  shape.start;
};
template <class T>
concept Cloud = requires(T shape) {
  shape.points;
};
template <class T>
concept Turned = requires(T shape) {
  shape.half_extents;
};
template <class T>
concept Upright = requires(T shape) {
  shape.min;
};
template <class T>
concept Box = Turned<T> || Upright<T>;

/// Whether two shapes share a point. Round shapes are tested as a distance from a core. A box
/// against them or a segment is a set of slabs; otherwise it is the hull of its corners.
template <class First, class Second>
bool do_meet(const First& a, const Second& b) {
  if constexpr (Cloud<Second> && (Ball<First> || Pill<First> || Flat<First>)) {
    return oracle::meet(a, b);
  } else if constexpr (Ball<First>) {
    const auto near = oracle::nearest(b, a.center);
    if (a.radius < 0 || !near) return false;
    const Integer reach = oracle::raw(a.radius) + near->radius;
    return near->core.squared.over <= reach * reach * near->core.squared.under;
  } else if constexpr (Ball<Second>) {
    return do_meet(b, a);
  } else if constexpr (Pill<First>) {
    return a.radius >= 0 && b.radius >= 0 &&
           oracle::near_segment(Segment{a.a, a.b}, Segment{b.a, b.b},
                                oracle::raw(a.radius) + oracle::raw(b.radius));
  } else if constexpr (Pill<Second>) {
    return b.radius >= 0 && oracle::near_segment(a, Segment{b.a, b.b}, oracle::raw(b.radius));
  } else if constexpr (Flat<First> && Flat<Second>) {
    return oracle::meet(a, b);
  } else if constexpr (Flat<First>) {
    return oracle::meet(a, oracle::hull_of(b));
  } else if constexpr (Flat<Second>) {
    return oracle::meet(b, oracle::hull_of(a));
  } else if constexpr (Stick<First> && Box<Second>) {
    return oracle::meets(a, b);
  } else {
    return oracle::meet(oracle::hull_of(a), oracle::hull_of(b));
  }
}

template <int Row, Scalar S, int N, class First, class Second>
std::optional<Wrong> judge(const PairCase<S, N, First, Second>& c, bool got) {
  const auto a = in_raw_units<S>(c.a);
  const auto b = in_raw_units<S>(c.b);
  return compare(do_meet(as_shape(a), as_shape(b)), got);
}

}  // namespace detent::verify::judge
