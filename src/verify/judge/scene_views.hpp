// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <vector>

#include "verify/judge/rotations.hpp"
#include "verify/judge/scenes.hpp"
#include "verify/judge/views.hpp"

namespace detent::verify::judge {

/// The view from this pose; nothing if there is no such lens.
template <Scalar S, int N>
std::optional<View<S>> view_of(const OrbitCase<S, N>& c, const Transform<S, N>& pose) {
  ViewCase<S, N> view{};
  view.pose = pose;
  view.narrows = true;
  view.fov = c.fov;
  view.width = c.aspect;
  view.near_distance = c.near_distance;
  view.far_distance = c.far_distance;
  return view_of(view);
}

/// The position of the camera after its target has moved with it, given its axes.
template <Scalar S>
Vec<S, 3> orbit_position(const OrbitCase<S, 3>& c, const std::array<oracle::Vector<3>, 3>& axes) {
  constexpr int axis_frac = direction_component<S>::frac;
  const auto zoomed =
      clamped<S>(oracle::nearest_even(oracle::raw(c.distance) * oracle::raw(c.factor), S::frac));
  const auto distance = std::max(std::min(zoomed, c.max_distance), c.min_distance);
  const auto moved = [](const Vec<S, 3>& from, const oracle::Vector<3>& by) {
    Vec<S, 3> result;
    for (std::size_t i = 0; i < 3; ++i) {
      const Integer sum = scaled(oracle::raw(from[static_cast<int>(i)]), axis_frac) + by[i];
      result[static_cast<int>(i)] = clamped<S>(oracle::nearest_even(sum, axis_frac));
    }
    return result;
  };
  oracle::Vector<3> pan, back;
  for (std::size_t i = 0; i < 3; ++i) {
    pan[i] = oracle::raw(c.right) * axes[0][i] + oracle::raw(c.up) * axes[1][i];
    back[i] = oracle::raw(distance) * axes[2][i];
  }
  return moved(moved(c.target, pan), back);
}

/// The axes are judged within the bound of a rotation from Euler angles, the position exactly for
/// these axes.
template <Scalar S>
std::optional<Wrong> judge_orbit(const OrbitCase<S, 3>& c, const Transform<S, 3>& got) {
  const auto steepest =
      static_cast<std::int64_t>(nearest_quotient((Integer(1) << 32u) * 11, Integer(45)));
  const auto pitch =
      std::clamp(signed_units(c.pitch) + signed_units(c.pitch_step), -steepest, steepest);
  const EulerCase<S, 3> angles{Angle<S>::from_raw(static_cast<std::uint32_t>(-pitch)),
                               Angle<S>::from_raw(c.yaw.raw() + c.yaw_step.raw()), Angle<S>()};
  if (auto wrong = judge<0>(angles, axes_of(got.rotation))) return wrong;
  std::array<oracle::Vector<3>, 3> axes;
  for (int i = 0; i < 3; ++i) {
    axes[static_cast<std::size_t>(i)] = oracle::widen(raw_of(got.rotation.axis(i).vec()));
  }
  return compare(Transform<S, 3>{orbit_position(c, axes), got.rotation, S(1)}, got);
}

/// The frustum is that of the camera's pose, which has a row of its own.
template <int Row, Scalar S, int N, class Answer>
std::optional<Wrong> judge(const OrbitCase<S, N>& c, const Answer& got) {
  const auto camera = c.camera();
  const auto view = view_of(c, camera ? camera->pose : Transform<S, N>());
  if constexpr (Row == 0) {
    if (!view || !got) return compare(view.has_value(), got.has_value());
    return judge_orbit(c, *got);
  } else {
    std::vector<Found<S>> all;
    if (view) {
      const auto corners = view->corners();
      const auto solid = oracle::exact(ConvexHull<S, N>{corners});
      Vec<S, N> middle;
      for (int i = 0; i < N; ++i) {
        Integer sum = 0;
        for (std::size_t k = 0; k < 4; ++k) sum += oracle::raw(corners[k][i]);
        middle[i] = clamped<S>(oracle::nearest_even(sum, 2));
      }
      all = all_with(PlainScene<S, N>(c.history), c.mask,
                     [&](const auto& shape) { return distance_if_met(solid, middle, shape); });
    }
    return compare_results(all, got);
  }
}

}  // namespace detent::verify::judge
