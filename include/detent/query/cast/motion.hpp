// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include "detent/query/kernel/convex_body.hpp"
#include "detent/query/kernel/core.hpp"
#include "detent/query/kernel/point_obb.hpp"

// A core that moves along a direction and another one at rest, as convex bodies. To points and
// segments, an oriented box is its slabs, in its frame; to others it is the box that its edges
// span.

namespace detent::detail {

/// Turns vectors of a frame back into the world: the gradient of dot(v, x') for the position x' in
/// the frame.
template <Scalar S, int N>
struct FromFrame {
  Rotation<S, N> rotation;

  template <Number V>
  [[nodiscard]] constexpr auto operator()(const Vec<V, N>& v) const noexcept {
    return from_frame(rotation, v);
  }
};

struct SameFrame {
  template <Number V, int N>
  [[nodiscard]] constexpr const Vec<V, N>& operator()(const Vec<V, N>& v) const noexcept {
    return v;
  }
};

template <class T>
inline constexpr bool is_thin = is_kind<T, Vec> || is_kind<T, Segment>;

template <Scalar S, int N>
[[nodiscard]] constexpr auto body_in_frame(const Obb<S, N>& box, const Vec<S, N>& point) noexcept {
  return HullBody(std::array{in_frame(box, point - box.center)});
}
template <Scalar S, int N>
[[nodiscard]] constexpr auto body_in_frame(const Obb<S, N>& box,
                                           const Segment<S, N>& segment) noexcept {
  return HullBody(std::array{in_frame(box, segment.start - box.center),
                             in_frame(box, segment.end - box.center)});
}
template <Scalar S, int N>
[[nodiscard]] constexpr auto slab_body(const Obb<S, N>& box) noexcept {
  return AabbBody(-box.half_extents, Vec(narrow_negative(-box.half_extents)));
}
template <Scalar S, int N>
[[nodiscard]] constexpr auto way_in_frame(const Obb<S, N>& box,
                                          const Direction<S, N>& direction) noexcept {
  return make_vec<N>([&](int i) { return dot(box.rotation.axis(i), direction); });
}

template <Scalar S, int N>
[[nodiscard]] constexpr auto body_of(const Vec<S, N>& point) noexcept {
  return HullBody(std::array{point});
}

/// Returns f(body_a, body_b, way, to_world) for cores with points.
template <class A, class B, Scalar S, int N, class F>
[[nodiscard]] constexpr auto with_motion(const A& a, const B& b, const Direction<S, N>& direction,
                                         const F& f) noexcept {
  if constexpr (is_thin<A> && is_kind<B, Obb>) {
    return f(body_in_frame(b, a), slab_body(b), way_in_frame(b, direction),
             FromFrame<S, N>{b.rotation});
  } else if constexpr (is_kind<A, Obb> && is_thin<B>) {
    return f(slab_body(a), body_in_frame(a, b), way_in_frame(a, direction),
             FromFrame<S, N>{a.rotation});
  } else {
    return f(body_of(a), body_of(b), direction, SameFrame());
  }
}

}  // namespace detent::detail
