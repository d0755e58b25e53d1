// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "verify/judge/exact.hpp"

namespace detent::verify::judge {

/// The numbers of a camera in integers: slopes in Q3.28, axes and coordinates raw.
template <Scalar S>
struct View {
  std::array<Integer, 2> slopes{}, extents{};
  Integer near_raw, far_raw;
  oracle::Vector<3> eye;
  std::array<oracle::Vector<3>, 3> axes;

  static constexpr int slope_frac = 28;
  static constexpr int axis_frac = direction_component<S>::frac;
  /// The grid of the points that the camera sees.
  static constexpr int grid = S::frac + S::frac + slope_frac + axis_frac;

  /// The vector from the eye to the point at x, y (raw, in units of 2^-S::frac) and a depth, on the
  /// grid.
  [[nodiscard]] oracle::Vector<3> offset(const Integer& x, const Integer& y,
                                         const Integer& depth) const {
    oracle::Vector<3> result;
    for (std::size_t j = 0; j < 3; ++j) {
      Integer sum = scaled(-depth * axes[2][j], S::frac + slope_frac);
      const std::array<Integer, 2> at{x, y};
      for (std::size_t i = 0; i < 2; ++i) {
        const Integer half = slopes[i] * depth + scaled(extents[i], slope_frac);
        sum += at[i] * half * axes[i][j];
      }
      result[j] = sum;
    }
    return result;
  }
  [[nodiscard]] Vec<S, 3> point(const Integer& x, const Integer& y, const Integer& depth) const {
    const auto from_eye = offset(x, y, depth);
    Vec<S, 3> result;
    for (std::size_t j = 0; j < 3; ++j) {
      const Integer sum = scaled(eye[j], grid - S::frac) + from_eye[j];
      result[static_cast<int>(j)] = clamped<S>(oracle::nearest_even(sum, grid - S::frac));
    }
    return result;
  }
  [[nodiscard]] typename Frustum<S>::Corners corners() const {
    const Integer one = Integer(1) << static_cast<unsigned>(S::frac);
    typename Frustum<S>::Corners corners;
    for (std::size_t i = 0; i < 8; ++i) {
      corners[i] = point((i & 1) != 0 ? one : Integer(-one), (i & 2) != 0 ? one : Integer(-one),
                         (i & 4) != 0 ? far_raw : near_raw);
    }
    return corners;
  }
};

template <Scalar S, int N>
std::optional<View<S>> view_of(const ViewCase<S, N>& c) {
  View<S> view;
  const Integer width = oracle::raw(c.width), height = oracle::raw(c.height);
  view.near_raw = oracle::raw(c.near_distance);
  view.far_raw = oracle::raw(c.far_distance);
  if (view.near_raw >= view.far_raw || width <= 0) return {};
  if (c.narrows) {
    const bool sees = c.fov.raw() != 0 && c.fov.raw() < (std::uint32_t{1} << 31);
    if (!sees || view.near_raw <= 0) return {};
    const Real half_angle = radians(c.fov) / 2;
    const Real upright = sin(half_angle) / cos(half_angle) * steps(View<S>::slope_frac);
    const Integer most = (Integer(1) << 31u) - 1;
    if (upright > Real(2147483647)) return {};
    view.slopes[1] = nearest(upright);
    const Integer across = width * view.slopes[1];
    if (across > scaled(most, S::frac)) return {};
    view.slopes[0] = oracle::nearest_even(across, S::frac);
    if (view.slopes[0] <= 0 || view.slopes[1] <= 0) return {};
  } else {
    if (height <= 0) return {};
    view.extents = {width, height};
  }
  view.eye = oracle::widen(raw_of(c.pose.translation));
  for (int i = 0; i < 3; ++i) {
    view.axes[static_cast<std::size_t>(i)] = oracle::widen(raw_of(c.pose.rotation.axis(i).vec()));
  }
  return view;
}

/// Each component normalised and rounded; nothing for the zero vector.
template <Scalar S>
std::optional<Direction<S, 3>> direction_along(const oracle::Vector<3>& v) {
  if (oracle::is_zero(v)) return {};
  using Component = direction_component<S>;
  Real squared = 0;
  for (const auto& c : v) squared += real(c) * real(c);
  const Real factor = steps(Component::frac) / sqrt(squared);
  return Direction<S, 3>::assume_unit(make_vec<3>([&](int i) {
    return clamped<Component>(nearest(real(v[static_cast<std::size_t>(i)]) * factor));
  }));
}

template <int Row, Scalar S, int N, class Answer>
std::optional<Wrong> judge(const ViewCase<S, N>& c, const Answer& got) {
  const auto view = view_of(c);
  if (!view) return compare(Answer(), got);
  const Integer x = oracle::raw(c.x), y = oracle::raw(c.y), depth = oracle::raw(c.depth);
  if constexpr (Row == 0) {
    // point - eye = right * axis 0 + up * axis 1 - ahead * axis 2, by determinants.
    const auto& axes = view->axes;
    const auto from_eye = oracle::difference(oracle::widen(raw_of(c.point)), view->eye);
    const auto volume = [&](const oracle::Vector<3>& v, std::size_t i) {
      return oracle::dot(v, oracle::cross(axes[(i + 1) % 3], axes[(i + 2) % 3]));
    };
    const Integer whole = volume(axes[0], 0);  // finer than the others by axis_frac
    if (whole == 0) return compare(Answer(), got);
    const Integer sign = whole > 0 ? 1 : -1;
    const Integer ahead = -volume(from_eye, 2) * sign;
    if (c.narrows && ahead <= 0) return compare(Answer(), got);
    const auto across = [&](std::size_t i) {
      // The fraction volume / (slope * ahead + extent * whole), all times 2^(slope_frac).
      const Integer half = scaled(view->slopes[i] * ahead, View<S>::axis_frac) +
                           scaled(view->extents[i] * whole * sign, View<S>::slope_frac);
      const int shift = S::frac + View<S>::slope_frac + View<S>::axis_frac;
      return clamped<S>(nearest_quotient(scaled(volume(from_eye, i) * sign, shift), half));
    };
    const S far = clamped<S>(nearest_quotient(scaled(ahead, View<S>::axis_frac), whole * sign));
    return compare(Answer(ScreenPoint<S, S>{across(0), across(1), far}), got);
  } else if constexpr (Row == 1) {
    return compare(Answer(view->point(x, y, depth)), got);
  } else if constexpr (Row == 2) {
    const auto ahead = -c.pose.rotation.axis(2);
    if (!c.narrows) return compare(Answer({view->point(x, y, view->near_raw), ahead}), got);
    const auto direction = direction_along<S>(view->offset(x, y, Integer(1)));
    return compare(Answer({c.pose.translation, direction.value_or(ahead)}), got);
  } else {
    const auto corners = view->corners();
    if constexpr (Row == 3) {
      return compare(Answer(corners), got);
    } else {
      const auto exact_box = oracle::exact(c.box);
      return compare(oracle::meet(exact_box, oracle::exact(ConvexHull<S, 3>{corners})), got);
    }
  }
}

}  // namespace detent::verify::judge
