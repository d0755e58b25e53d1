// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

#include "detent/query/overlaps/frustum.hpp"
#include "detent/shape/orbit_camera.hpp"
#include "verify/questions/scenes.hpp"

// What a camera that orbits a scene sees of it.

namespace detent::verify {

template <Scalar S, int N>
struct OrbitCase {
  History<S, N> history;
  std::uint32_t mask = 0;
  Angle<S> fov;
  S aspect, near_distance, far_distance;
  // Before the camera moves.
  Vec<S, N> target;
  S distance;
  Angle<S> yaw, pitch;
  S min_distance, max_distance;
  // How it moves.
  Angle<S> yaw_step, pitch_step;
  S factor, right, up;

  [[nodiscard]] constexpr std::optional<Camera<S>> camera() const noexcept {
    const auto lens = Lens<S>::perspective(fov, aspect, near_distance, far_distance);
    if (!lens) return std::nullopt;
    OrbitCamera<S> orbit{*lens, target, distance, yaw, pitch, {min_distance, max_distance}};
    orbit.rotate(yaw_step, pitch_step);
    orbit.zoom(factor);
    orbit.pan(right, up);
    return orbit.camera();
  }

  constexpr auto fields(const auto& f) const noexcept {
    return f(history, mask, fov, aspect, near_distance, far_distance, target, distance, yaw, pitch,
             min_distance, max_distance, yaw_step, pitch_step, factor, right, up);
  }
};

/// The pose of the camera, and the objects in its frustum, in some layers. Runs one question in
/// forty.
struct SceneViews : InDimensions<3> {
  static constexpr std::array<std::string_view, 4> names{"camera/orbit", "scene/nearest/frustum",
                                                         "scene/any/frustum", "scene/all/frustum"};
  static constexpr std::uint32_t share = 40;

  template <Scalar S, int N>
  static constexpr auto draw(Random& random) noexcept {
    HistoryScene<S, N> scene(random);
    constexpr auto one = std::int64_t{1} << S::frac;
    OrbitCase<S, N> c;
    c.history = scene.history();
    c.mask = static_cast<std::uint32_t>(random.below(8));
    c.fov = Angle<S>::from_raw(
        static_cast<std::uint32_t>(random.between(1 << 24, (std::int64_t{1} << 31) - 1)));
    c.aspect = scene.scalar(random.between(one / 4, 4 * one));
    c.near_distance = scene.length(0, 4);
    c.far_distance = scene.length(1, 64);
    scene.look_around();
    c.target = scene.spot();
    c.distance = scene.length(0, 32);
    c.yaw = scene.angle();
    c.pitch = scene.angle();
    c.min_distance = scene.length(0, 8);
    c.max_distance = scene.length(4, 64);
    c.yaw_step = scene.angle();
    c.pitch_step = scene.angle();
    c.factor = scene.scalar(random.between(one / 4, 2 * one));
    c.right = scene.length(-4, 4);
    c.up = scene.length(-4, 4);
    return c;
  }
  template <int Row, Scalar S, int N>
  [[nodiscard]] static constexpr auto answer(const OrbitCase<S, N>& c) noexcept {
    const auto camera = c.camera();
    if constexpr (Row == 0) {
      return camera ? std::optional(camera->pose) : std::nullopt;
    } else {
      const LivingScene<S, N> living(c.history);
      const auto& scene = living.scene;
      const InLayers filter{c.mask};
      if constexpr (Row == 1) {
        return camera ? scene.nearest(Frustum{*camera}, filter) : std::nullopt;
      } else if constexpr (Row == 2) {
        return camera && scene.any(Frustum{*camera}, filter);
      } else {
        if (!camera) return Listed<Found<S>, 4>();
        return list_all<Found<S>, 4>(scene, Frustum{*camera}, filter);
      }
    }
  }
};

}  // namespace detent::verify
