// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>

#include "detent/math/sweep.hpp"
#include "detent/math/width.hpp"
#include "detent/query/kernel/length.hpp"
#include "detent/shape/aabb.hpp"
#include "detent/shape/hull.hpp"
#include "detent/shape/obb.hpp"
#include "detent/shape/segment.hpp"
#include "detent/shape/triangle.hpp"

// Polytopes as corners in the frame of a body, and posed in the world.

namespace detent::detail {

// local_corners(core): its corners in the frame of the body.

template <Scalar S, int N>
[[nodiscard]] constexpr auto local_corners(const Vec<S, N>& point) noexcept {
  return std::array{point};
}
template <Scalar S, int N>
[[nodiscard]] constexpr auto local_corners(const Segment<S, N>& segment) noexcept {
  return std::array{segment.start, segment.end};
}
template <Scalar S, int N>
[[nodiscard]] constexpr auto local_corners(const Triangle<S, N>& triangle) noexcept {
  return std::array{triangle.a, triangle.b, triangle.c};
}
template <Scalar S, int N>
[[nodiscard]] constexpr auto local_corners(const Aabb<S, N>& box) noexcept {
  std::array<Vec<S, N>, std::size_t{1} << N> corners;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    corners[k] = make_vec<N>([&](int i) { return (k >> i & 1) != 0 ? box.max[i] : box.min[i]; });
  }
  return corners;
}
/// An oriented box is the one that its edges span. With b bits, a component is at least -4 * 2^b
/// and below 4 * 2^b, because that of the center is below 2^b.
template <Scalar S, int N>
[[nodiscard]] constexpr auto local_corners(const Obb<S, N>& box) noexcept {
  using Component = direction_component<S>;
  constexpr int bits = bits_of<S> + bits_of<Component> + 1;
  using Sum = decltype(narrow_product<bits>(S(), Component()));
  std::array<Vec<Sum, N>, std::size_t{1} << N> corners;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    corners[k] = make_vec<N>([&](int j) {
      Sum sum = box.center[j];
      for (int i = 0; i < N; ++i) {
        const auto edge = narrow_product<bits>(box.half_extents[i], box.rotation.axis(i)[j]);
        sum = (k >> i & 1) != 0 ? narrow_sum<bits>(sum, edge) : narrow_difference<bits>(sum, edge);
      }
      return sum;
    });
  }
  return corners;
}
template <Scalar S, int N>
[[nodiscard]] constexpr std::span<const Vec<S, N>> local_corners(
    const ConvexHull<S, N>& hull) noexcept {
  return hull.points;
}

/// A coordinate of a posed corner, below 6 * 2^b in numbers of b bits: a corner of an oriented box
/// is at most sqrt(3) * 2^b + 3 * 2^b from its origin, which is posed within the range.
template <Scalar S>
using Posed = decltype(Length<S>() + Length<S>());

/// The pose of a frame: its origin, exactly, and the rows of its rotation's matrix.
template <Scalar S, int N>
class Pose {
 public:
  using Component = direction_component<S>;

  constexpr Pose(const Sweep<S, N>& sweep, const Rotation<S, N>& rotation,
                 const Component& t) noexcept
      : origin_(origin_at(sweep, t)) {
    for (int j = 0; j < N; ++j) {
      rows_[static_cast<std::size_t>(j)] = make_vec<N>([&](int i) { return rotation.axis(i)[j]; });
    }
  }

  /// The corner posed, each coordinate rounded to nearest.
  template <Number T>
  [[nodiscard]] constexpr Vec<Posed<S>, N> operator()(const Vec<T, N>& corner) const noexcept {
    // |row . corner| <= sqrt(3) 2^b, or 2 sqrt(3) 2^b of 4 * 2^b; the origin adds 2^b.
    constexpr int bits = result_bits(bits_of<T> + bits_of<Component> + 1);
    return make_vec<N>([&](int j) {
      const auto turned = narrow_dot<bits>(rows_[static_cast<std::size_t>(j)], corner);
      return nearest_to<Posed<S>>(narrow_sum<bits>(origin_[j], turned));
    });
  }

 private:
  /// Lies between two points of the range, so within the range.
  static constexpr auto origin_at(const Sweep<S, N>& sweep, const Component& t) noexcept {
    return narrow<bits_of<S> + bits_of<Component>>(sweep.start + (sweep.end - sweep.start) * t);
  }

  std::remove_cvref_t<decltype(origin_at(Sweep<S, N>(), Component()))> origin_;
  std::array<Vec<Component, N>, static_cast<std::size_t>(N)> rows_;
};

/// The corners of a hull, posed on access.
template <Scalar S, int N>
class PosedPoints {
 public:
  constexpr PosedPoints(std::span<const Vec<S, N>> points, const Pose<S, N>& pose) noexcept
      : points_(points), pose_(pose) {}

  [[nodiscard]] constexpr std::size_t size() const noexcept { return points_.size(); }
  [[nodiscard]] constexpr Vec<Posed<S>, N> operator[](std::size_t i) const noexcept {
    return pose_(points_[i]);
  }

 private:
  std::span<const Vec<S, N>> points_;
  Pose<S, N> pose_;
};

template <Scalar S, int N>
[[nodiscard]] constexpr auto posed(std::span<const Vec<S, N>> points,
                                   const Pose<S, N>& pose) noexcept {
  return PosedPoints<S, N>(points, pose);
}
template <Number T, Scalar S, int N, std::size_t Count>
[[nodiscard]] constexpr auto posed(const std::array<Vec<T, N>, Count>& corners,
                                   const Pose<S, N>& pose) noexcept {
  std::array<Vec<Posed<S>, N>, Count> result;
  for (std::size_t i = 0; i < Count; ++i) result[i] = pose(corners[i]);
  return result;
}

/// The hull of at least one posed corner, as a convex body for GJK (see support.hpp).
template <Number P, int N, class Corners>
class PosedBody {
 public:
  static constexpr int dimension = N;

  explicit constexpr PosedBody(const Corners& corners) noexcept : corners_(corners) {}

  [[nodiscard]] constexpr Vec<P, N> some() const noexcept { return corners_[0]; }
  [[nodiscard]] constexpr Vec<P, N> low() const noexcept {
    return bound([](const P& x, const P& y) { return x < y; });
  }
  [[nodiscard]] constexpr Vec<P, N> high() const noexcept {
    return bound([](const P& x, const P& y) { return x > y; });
  }

  template <int Bits, Number V, Number T>
  [[nodiscard]] constexpr Vec<P, N> extreme(const Vec<V, N>& v, const Vec<T, N>& from,
                                            bool farthest) const noexcept {
    auto best = some();
    auto reached = dot(v, narrow<Bits>(best - from));
    for (std::size_t i = 1; i < corners_.size(); ++i) {
      const Vec<P, N> corner = corners_[i];
      const auto along = dot(v, narrow<Bits>(corner - from));
      if (farthest ? along > reached : along < reached) {
        best = corner;
        reached = along;
      }
    }
    return best;
  }
  /// The same along an axis.
  template <Scalar S, Number T>
  [[nodiscard]] constexpr Vec<P, N> extreme(const Direction<S, N>& axis, const Vec<T, N>& from,
                                            bool farthest) const noexcept {
    constexpr int bits = bits_of<P> + 1;
    const auto exact = [&] { return extreme<bits>(axis.vec(), from, farthest); };
    if constexpr (is_fixed<P> && has_filters) {
      // Relative to the first corner, those of most bodies need only one word.
      constexpr int short_bits = (std::min)(bits, 31);
      const Vec<P, N> first = some();
      std::size_t best = 0;
      auto reached = dot(axis, narrow<short_bits>(first - first));
      for (std::size_t i = 1; i < corners_.size(); ++i) {
        const auto step = corners_[i] - first;
        if (!fits<short_bits>(step)) return exact();
        const auto along = dot(axis, narrow<short_bits>(step));
        // Branchless: which corner is farther is unpredictable.
        const bool is_beyond = farthest ? along > reached : along < reached;
        best = is_beyond ? i : best;
        reached = is_beyond ? along : reached;
      }
      return corners_[best];
    } else {
      return exact();
    }
  }

 private:
  template <class Beyond>
  [[nodiscard]] constexpr Vec<P, N> bound(const Beyond& beyond) const noexcept {
    auto result = some();
    for (std::size_t k = 1; k < corners_.size(); ++k) {
      const Vec<P, N> corner = corners_[k];
      for (int i = 0; i < N; ++i) {
        if (beyond(corner[i], result[i])) result[i] = corner[i];
      }
    }
    return result;
  }

  Corners corners_;
};

/// A polytope, given in the frame of a body, that moves with it.
template <Scalar S, int N, class Corners>
class Swept {
 public:
  static constexpr int dimension = N;
  using Coordinate = S;
  using Time = direction_component<S>;

  constexpr Swept(const Corners& corners, const Sweep<S, N>& sweep) noexcept
      : corners_(corners),
        sweep_(sweep),
        turn_(sweep),
        start_(turn_.at(Time(0))),
        bend_(turn_.bend()),
        radius_(radius_about_origin(corners)) {}

  /// The body at time t, whose corners are within `error()` of the exact ones.
  [[nodiscard]] constexpr auto at(const Time& t) const noexcept {
    const Pose<S, N> pose(sweep_, turn_.is_still() || t == 0 ? start_ : turn_.at(t), t);
    const auto corners = posed(corners_, pose);
    return PosedBody<Posed<S>, N, std::remove_cvref_t<decltype(corners)>>(corners);
  }

  /// Rounding three coordinates moves a corner by at most sqrt(3) / 2 < 7 / 8 units; the rotation
  /// is off by less than 4 units of its own.
  [[nodiscard]] constexpr auto error() const noexcept {
    if constexpr (is_fixed<S>) {
      const auto turned = turn_.is_none() ? Posed<S>(0) : radius_;
      return finer<S, 3>::from_raw(7) + turned * Time::from_raw(4);
    } else {
      return S(0);
    }
  }

  /// Over a time d, corners deviate from uniform motion between their start and end by at most
  /// bend() d^2.
  [[nodiscard]] constexpr auto bend() const noexcept { return radius_ * bend_; }
  [[nodiscard]] constexpr auto straying(const Time& d) const noexcept { return bend() * square(d); }

 private:
  /// The distance of the farthest corner from the origin, rounded up.
  [[nodiscard]] static constexpr Posed<S> radius_about_origin(const Corners& corners) noexcept {
    using Squared = std::remove_cvref_t<decltype(squared_length(corners[0]))>;
    Squared most(0);
    for (const auto& corner : corners) {
      const auto squared =
          by_width<62>([](const auto& c) { return Squared(squared_length(c)); }, corner);
      if (squared > most) most = squared;
    }
    return sqrt_ceil<Posed<S>>(most);
  }

  Corners corners_;
  Sweep<S, N> sweep_;
  Turn<S, N> turn_;
  Rotation<S, N> start_;  // of the frame, at time 0
  decltype(turn_.bend()) bend_;
  Posed<S> radius_;
};
template <Scalar S, int N, class Corners>
Swept(const Corners&, const Sweep<S, N>&) -> Swept<S, N, Corners>;

}  // namespace detent::detail
