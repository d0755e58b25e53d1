// SPDX-License-Identifier: MIT
#pragma once

#include <type_traits>

#include "detent/dynamics/manifold/formats.hpp"
#include "detent/shape/aabb.hpp"
#include "detent/shape/obb.hpp"

namespace detent::detail {

/// The bits of |row| |v|: rows of a pose are unit vectors within 2^-28, and |v| is at most sqrt(3)
/// times its greatest coordinate.
template <Number T>
inline constexpr int turned_bits = bits_of<T> + 31;

/// `v` of the frame of b in the frame of a, exactly.
template <Scalar S, Number T, int N>
[[nodiscard]] constexpr auto turned(const RelativePose<S, N>& pose, const Vec<T, N>& v) noexcept {
  return make_vec<N>([&](int c) {
    const auto row = make_vec<N>([&](int j) { return pose.axes[static_cast<std::size_t>(j)][c]; });
    return narrow_dot<turned_bits<T>>(row, v);
  });
}

/// `v` of the frame of a in the frame of b, exactly for orthonormal axes.
template <Scalar S, Number T, int N>
[[nodiscard]] constexpr auto turned_back(const RelativePose<S, N>& pose,
                                         const Vec<T, N>& v) noexcept {
  return make_vec<N>(
      [&](int j) { return narrow_dot<turned_bits<T>>(pose.axes[static_cast<std::size_t>(j)], v); });
}

/// base + x rounded to nearest, for a base on the grid of T: in 64 bits if x fits 62, because only
/// ties depend on the base, by whether it is odd.
template <class T, Number X>
[[nodiscard]] constexpr T plus_nearest(const T& base, const X& x) noexcept {
  if constexpr (!is_fixed<T>) {
    return nearest_to<T>(base + x);
  } else if constexpr (bits_of<X> > 62 || bits_of<T> > 61 || X::frac <= T::frac) {
    return nearest_to<T>(base + x);
  } else {
    using Raw = typename X::raw_type;
    constexpr int shift = X::frac - T::frac;
    const Raw start = base.raw();
    const Raw odd = (start + (x.raw() >> shift)) & 1;
    return clamp_raw<T>(start + ((x.raw() + ((Raw(1) << (shift - 1)) - 1) + odd) >> shift));
  }
}

/// A point of b in the frame of a, each coordinate rounded once to T.
template <class T, Scalar S, Number P, int N>
[[nodiscard]] constexpr Vec<T, N> placed_point(const RelativePose<S, N>& pose,
                                               const Vec<P, N>& p) noexcept {
  const auto there = turned(pose, p);
  if constexpr (std::is_same_v<T, typename Formats<S>::Lever>) {
    return make_vec<N>([&](int i) { return plus_nearest<T>(pose.translation[i], there[i]); });
  } else {
    return nearest_to<T>(pose.translation + there);
  }
}

/// A box in the frame of its body.
template <Scalar S, int N>
struct BoxCore {
  using Ratio = typename Formats<S>::Ratio;
  using Lever = typename Formats<S>::Lever;

  Vec<Lever, N> half;  // clamped to the range of Lever
  Vec<Lever, N> center;
  std::array<Vec<Ratio, N>, std::size_t{N}> axes;
  bool is_aligned = true;  // the axes are those of the frame
  bool is_empty = false;
};

template <Scalar S, int N>
[[nodiscard]] constexpr BoxCore<S, N> box_core(const Aabb<S, N>& box) noexcept {
  using Lever = typename Formats<S>::Lever;
  BoxCore<S, N> core;
  core.half = nearest_to<Lever>(half(box.max - box.min));
  core.center = nearest_to<Lever>(half(box.min + box.max));
  for (int i = 0; i < N; ++i) {
    core.axes[static_cast<std::size_t>(i)] = unit_axis<typename Formats<S>::Ratio, N>(i);
  }
  core.is_empty = is_empty(box);
  return core;
}

template <Scalar S, int N>
[[nodiscard]] constexpr BoxCore<S, N> box_core(const Obb<S, N>& box) noexcept {
  using Ratio = typename Formats<S>::Ratio;
  using Lever = typename Formats<S>::Lever;
  BoxCore<S, N> core;
  core.half = nearest_to<Lever>(box.half_extents);
  core.center = nearest_to<Lever>(box.center);
  for (int i = 0; i < N; ++i) {
    auto& axis = core.axes[static_cast<std::size_t>(i)];
    axis = make_vec<N>([&](int c) { return Ratio(box.rotation.axis(i)[c]); });
    core.is_aligned = core.is_aligned && axis == unit_axis<Ratio, N>(i);
  }
  core.is_empty = is_empty(box);
  return core;
}

/// The frame of the body itself.
template <Scalar S, int N>
[[nodiscard]] constexpr BoxCore<S, N> body_frame() noexcept {
  return box_core(Aabb<S, N>{});
}

/// The components of `v` along the axes of a box, exactly.
template <Scalar S, Number T, int N>
[[nodiscard]] constexpr auto in_axes(const BoxCore<S, N>& core, const Vec<T, N>& v) noexcept {
  return make_vec<N>([&](int i) { return dot(core.axes[static_cast<std::size_t>(i)], v); });
}

/// The pose of box b in the frame of box a: each number rounded once, from the exact product.
template <Scalar S, int N>
[[nodiscard]] constexpr RelativePose<S, N> between(const BoxCore<S, N>& a,
                                                   const RelativePose<S, N>& pose,
                                                   const BoxCore<S, N>& b) noexcept {
  using Ratio = typename Formats<S>::Ratio;
  using Lever = typename Formats<S>::Lever;
  if constexpr (has_filters) {  // as for all boxes that are bodies
    const Vec<Lever, N> origin{};
    if (a.is_aligned && b.is_aligned && a.center == origin && b.center == origin) return pose;
  }
  RelativePose<S, N> result;
  const auto offset = (pose.translation + turned(pose, b.center)) - a.center;
  result.translation =
      a.is_aligned ? nearest_to<Lever>(offset) : nearest_to<Lever>(in_axes(a, offset));
  if (a.is_aligned && b.is_aligned) {
    result.axes = pose.axes;
    return result;
  }
  for (std::size_t k = 0; k < N; ++k) {
    result.axes[k] = nearest_to<Ratio>(in_axes(a, turned(pose, b.axes[k])));
  }
  return result;
}

/// Moves the points of a manifold from the frame that `pose` is the pose of; each coordinate is
/// rounded once.
template <Scalar S, int N>
constexpr void move_points(const RelativePose<S, N>& pose, Manifold<S, N>& manifold) noexcept {
  for (int i = 0; i < manifold.count; ++i) {
    auto& p = manifold.points[static_cast<std::size_t>(i)].point;
    p = placed_point<typename Formats<S>::Lever>(pose, p);
  }
}

/// A manifold in the frame of box a, transformed to the frame of its body; rounded once more, which
/// changes nothing if the frames are the same.
template <Scalar S, int N>
[[nodiscard]] constexpr Manifold<S, N> moved_out(const BoxCore<S, N>& core,
                                                 Manifold<S, N> manifold) noexcept {
  using Ratio = typename Formats<S>::Ratio;
  using Lever = typename Formats<S>::Lever;
  if (core.is_aligned && core.center == Vec<Lever, N>{}) return manifold;
  RelativePose<S, N> pose;
  pose.axes = core.axes;
  pose.translation = core.center;
  manifold.normal = nearest_to<Ratio>(turned(pose, manifold.normal));
  move_points(pose, manifold);
  return manifold;
}

/// Transforms a manifold in the frame of b, with its normal from b to a, to the frame of a, from a
/// to b.
template <Scalar S, int N>
[[nodiscard]] constexpr Manifold<S, N> swapped(const RelativePose<S, N>& pose,
                                               Manifold<S, N> manifold) noexcept {
  using Ratio = typename Formats<S>::Ratio;
  manifold.normal = nearest_to<Ratio>(-turned(pose, manifold.normal));
  move_points(pose, manifold);
  return manifold;
}

}  // namespace detent::detail
