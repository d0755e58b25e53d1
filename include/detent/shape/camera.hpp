// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <type_traits>

#include "detent/math/lens.hpp"
#include "detent/shape/camera_filter.hpp"
#include "detent/shape/frustum.hpp"
#include "detent/shape/ray.hpp"
#include "detent/shape/viewport.hpp"

// Cameras, in 3D only: world to screen and back, and the ray under the mouse.
//
// Screen coordinates x and y are in [-1, 1], from left to right and from bottom to top, for any
// image size. With a `Viewport` they are pixels, counted from the top left. The depth of a point is
// its distance in front of the camera along the line of sight, in world units, not along the ray
// and not the nonlinear depth of a depth buffer.

namespace detent {

/// A lens in the world. The pose is that of `look_at`: x to the right, y up, looking along -z; its
/// scale is ignored.
///
/// With the axes exactly as stored, the point at screen coordinates x, y and depth d is
///   position + x w axis(0) + y h axis(1) - d axis(2),
/// where w and h are half the width and height that the lens sees at d. `unproject` is this point,
/// `project` the exact inverse, `pick_ray` the line of these points for one x and y, and `Frustum`
/// has the eight points at x = +-1, y = +-1, d = near or far.
template <Scalar S>
struct Camera {
  Transform<S, 3> pose;
  Lens<S> lens;

  [[nodiscard]] friend constexpr bool operator==(const Camera&, const Camera&) noexcept = default;
};

template <Scalar S>
Camera(Transform<S, 3>, Lens<S>) -> Camera<S>;

/// Appends to a digest: the pose, then the lens.
template <class D, Scalar S>
constexpr void append(D& digest, const Camera<S>& camera) noexcept {
  digest.add(camera.pose, camera.lens);
}

/// A point of the screen and its depth.
template <Number T, Scalar S>
struct ScreenPoint {
  T x, y;
  S depth;

  [[nodiscard]] friend constexpr bool operator==(const ScreenPoint&,
                                                 const ScreenPoint&) noexcept = default;
};

/// Appends to a digest: the fields in order.
template <class D, Number T, Scalar S>
constexpr void append(D& digest, const ScreenPoint<T, S>& point) noexcept {
  digest.add(point.x, point.y, point.depth);
}

namespace detail {

/// The vector from the eye to the point at depth `depth`, times the unit of the screen coordinates;
/// half_size(i) is half the width or height of the view there.
template <Scalar S, Number X, Number Unit, class F, Number D>
[[nodiscard]] constexpr auto seen(const Rotation<S, 3>& frame, const OnScreen<X, Unit>& at,
                                  const F& half_size, const D& depth) noexcept {
  return at.x * half_size(0) * frame.axis(0).vec() + at.y * half_size(1) * frame.axis(1).vec() -
         at.unit * depth * frame.axis(2).vec();
}
template <Scalar S, Number X, Number Unit>
[[nodiscard]] constexpr auto seen(const Camera<S>& camera, const OnScreen<X, Unit>& at,
                                  const S& depth) noexcept {
  const auto& lens = camera.lens;
  const auto half_size = [&](int i) { return lens.slope(i) * depth + lens.extent(i); };
  return seen(camera.pose.rotation, at, half_size, depth);
}

/// `pick_ray` without a filter.
template <Scalar S, Number X, Number Unit>
[[nodiscard]] constexpr Ray<S, 3> exact_pick_ray(const Camera<S>& camera,
                                                 const OnScreen<X, Unit>& at) noexcept {
  const auto& eye = camera.pose.translation;
  const auto& frame = camera.pose.rotation;
  const auto ahead = -frame.axis(2);
  if (camera.lens.has_perspective()) {
    const auto slope = [&](int i) { return camera.lens.slope(i); };
    return {eye, direction_of<S>(seen(frame, at, slope, one<S>)).value_or(ahead)};
  }
  const auto extent = [&](int i) { return camera.lens.extent(i); };
  const auto offset = seen(frame, at, extent, camera.lens.near_distance());
  if constexpr (std::is_same_v<Unit, std::remove_cv_t<decltype(one<S>)>>) {
    return {nearest_to<S>(eye + offset), ahead};
  } else {
    return {quotient_nearest<S>(eye * at.unit + offset, at.unit), ahead};
  }
}
/// The ray from the eye of `camera` in a direction found by a filter.
template <Scalar S>
[[nodiscard]] constexpr Ray<S, 3> ray_from_eye(
    const Camera<S>& camera,
    const decltype(UnitFilter<direction_component<S>>::value)& unit) noexcept {
  const auto c = [&](std::size_t i) { return narrow<bits_of<direction_component<S>>>(unit[i]); };
  return {camera.pose.translation, Direction<S, 3>::assume_unit({c(0), c(1), c(2)})};
}

/// `pick_ray` without its first filter.
template <Scalar S, Number X, Number Unit>
[[nodiscard]] constexpr Ray<S, 3> careful_pick_ray(const Camera<S>& camera,
                                                   const OnScreen<X, Unit>& at) noexcept {
  if constexpr (is_fixed<S> && has_filters) {
    if (camera.lens.has_perspective()) {
      const auto unit = decide_direction(camera.pose.rotation, camera.lens, at.x, at.y, at.unit);
      if (!unit.is_sure) [[unlikely]]
        return exact_pick_ray(camera, OnScreen{at.x, at.y, at.unit});
      return ray_from_eye(camera, unit.value);
    }
  }
  return exact_pick_ray(camera, at);
}
// By value, because GCC would keep numbers in memory for a reference.
template <Scalar S, Number X>
[[nodiscard]] DETENT_OUTLINE constexpr Ray<S, 3> careful_pick_ray(const Camera<S>& camera, X x,
                                                                  X y) noexcept {
  return careful_pick_ray(camera, OnScreen{x, y, one<S>});
}
template <Scalar S>
[[nodiscard]] DETENT_OUTLINE constexpr Ray<S, 3> careful_pick_ray(const Camera<S>& camera,
                                                                  Viewport viewport,
                                                                  std::int32_t column,
                                                                  std::int32_t row) noexcept {
  return careful_pick_ray(camera, on_screen<S>(viewport, column, row));
}

/// The determinants of Cramer's rule for the coordinates of a point in a camera's frame: right / whole,
/// up / whole, and the depth / whole, with whole >= 0.
template <Number T, Number W>
struct FrameCoordinates {
  T right, up, depth;
  W whole;
};

template <Scalar S>
[[nodiscard]] constexpr auto frame_coordinates(const Camera<S>& camera,
                                               const Vec<S, 3>& point) noexcept {
  const auto& frame = camera.pose.rotation;
  const auto volume = [&](const auto& v, int i) {
    return dot(v, cross(frame.axis((i + 1) % 3), frame.axis((i + 2) % 3).vec()));
  };
  const auto offset = point - camera.pose.translation;
  const auto right = volume(offset, 0), up = volume(offset, 1), depth = -volume(offset, 2);
  const auto whole = volume(frame.axis(0).vec(), 0);
  using Result = FrameCoordinates<decltype(-depth), decltype(-whole)>;
  if (whole < 0) return Result{-right, -up, -depth, -whole};
  return Result{right, up, depth, whole};
}

/// Calls f(right, half_width, up, half_height) with the screen coordinates as fractions, x = right /
/// half_width, unless the point is behind a camera with perspective.
template <class T, Scalar S, class F>
[[nodiscard]] constexpr std::optional<ScreenPoint<T, S>> exact_project(const Camera<S>& camera,
                                                                       const Vec<S, 3>& point,
                                                                       const F& f) noexcept {
  const auto at = frame_coordinates(camera, point);
  if (!(at.whole > 0)) return std::nullopt;
  if (camera.lens.has_perspective() && !(at.depth > 0)) return std::nullopt;
  const auto half_size = [&](int i) {
    return camera.lens.slope(i) * at.depth + camera.lens.extent(i) * at.whole;
  };
  const auto [x, y] = f(at.right, half_size(0), at.up, half_size(1));
  return ScreenPoint<T, S>{x, y, quotient_nearest<S>(at.depth, at.whole)};
}

/// The same, where the screen coordinates are middle.x + half_size.x x and middle.y +- half_size.y y
/// for x and y in [-1, 1].
template <class T, bool IsDown, Scalar S, Number Size, class F>
[[nodiscard]] constexpr std::optional<ScreenPoint<T, S>> project_by(const Camera<S>& camera,
                                                                    const Vec<S, 3>& point,
                                                                    const Vec<Size, 2>& half_size,
                                                                    const Vec<Size, 2>& middle,
                                                                    const F& f) noexcept {
  const auto exact = [&] { return exact_project<T>(camera, point, f); };
  if constexpr (filters_projection<T, S>) {
    if (!(half_size.x > 0 && half_size.y > 0)) [[unlikely]]
      return exact();
    const auto seen = decide_project<T, IsDown>(camera.pose.rotation, camera.lens,
                                                point - camera.pose.translation, half_size, middle);
    if (seen.is_seen == Filtered::no) return std::nullopt;
    if (seen.is_seen == Filtered::unsure) [[unlikely]]
      return exact();
    return ScreenPoint<T, S>{narrow<T::bits>(seen.x), narrow<T::bits>(seen.y),
                             narrow<S::bits>(seen.depth)};
  } else {
    return exact();
  }
}

}  // namespace detail

/// Where `camera` sees `point`: screen coordinates, in [-1, 1] inside the image, and depth.
/// Coordinates are scalars, or of a given type: `project<T>(camera, point)`.
///
/// domain: nothing for a point that is not in front of a perspective camera (depth 0 or less), and
///         if the pose's axes lie in a plane
/// result: also points nearer than near or farther than far
/// exact:  each number is the exact quotient rounded to nearest, ties to even, and clamped
///         (tests/shape/camera.test.cpp)
template <class To = void, Scalar S>
[[nodiscard]] constexpr auto project(const Camera<S>& camera, const Vec<S, 3>& point) noexcept {
  using T = detail::to_or_own<To, S>;
  using Size = std::remove_cv_t<decltype(detail::one<S>)>;
  return detail::project_by<T, false>(
      camera, point, Vec<Size, 2>{Size(1), Size(1)}, Vec<Size, 2>{},
      [](const auto& x, const auto& w, const auto& y, const auto& h) {
        return Vec<T, 2>{quotient_nearest<T>(x, w), quotient_nearest<T>(y, h)};
      });
}

/// The same in pixels: (0, 0) is the top left corner of the image, (0.5, 0.5) the middle of its
/// first pixel. If the scalar is too short, `project<q16_16>` holds any screen.
///
/// exact:  as above                                          (tests/shape/camera.test.cpp)
template <class To = void, Scalar S>
[[nodiscard]] constexpr auto project(const Camera<S>& camera, const Viewport& viewport,
                                     const Vec<S, 3>& point) noexcept {
  using T = detail::to_or_own<To, S>;
  const auto width = detail::pixel_count<S>(viewport.width);
  const auto height = detail::pixel_count<S>(viewport.height);
  const Vec middle{half(width), half(height)};
  return detail::project_by<T, true>(
      camera, point, middle, middle,
      [&](const auto& x, const auto& w, const auto& y, const auto& h) {
        return Vec<T, 2>{quotient_nearest<T>((w + x) * width, w + w),
                         quotient_nearest<T>((h - y) * height, h + h)};
      });
}

/// The point at screen coordinates `x` and `y`, of any number type, and `depth`.
///
/// domain: every x, y and depth, even outside the image and behind the camera
/// exact:  each coordinate is the exact one rounded to nearest, ties to even, and clamped
///         (tests/shape/camera.test.cpp)
template <Scalar S, Number X>
[[nodiscard]] constexpr Vec<S, 3> unproject(const Camera<S>& camera, const X& x, const X& y,
                                            const S& depth) noexcept {
  const auto offset = detail::seen(camera, detail::OnScreen{x, y, detail::one<S>}, depth);
  return nearest_to<S>(camera.pose.translation + offset);
}

/// The same for the middle of a pixel, or of the image if the viewport has no pixels.
template <Scalar S>
[[nodiscard]] constexpr Vec<S, 3> unproject(const Camera<S>& camera, const Viewport& viewport,
                                            std::int32_t column, std::int32_t row,
                                            const S& depth) noexcept {
  const auto at = detail::on_screen<S>(viewport, column, row);
  const auto offset = detail::seen(camera, at, depth);
  return quotient_nearest<S>(camera.pose.translation * at.unit + offset, at.unit);
}

/// The ray of the points that `camera` sees at screen coordinates `x` and `y`, of any number type:
/// from the eye, or without perspective from the near plane.
///
/// domain: every x and y, even outside the image; straight ahead if the pose's axes give no
///         direction
/// result: max_distance is the greatest scalar; objects nearer than the near plane are hit too
/// exact:  each component of the direction is the exact one rounded to nearest; the eye is exact, a
///         point of the near plane rounded as by `unproject`       (tests/shape/camera.test.cpp)
template <Scalar S, Number X>
[[nodiscard]] DETENT_INLINE_FILTER constexpr Ray<S, 3> pick_ray(const Camera<S>& camera, const X& x,
                                                                const X& y) noexcept {
  if constexpr (detail::has_guess<S, X>()) {
    if (!camera.lens.has_perspective()) return detail::careful_pick_ray(camera, x, y);
    const auto unit = detail::guess_direction(camera.pose.rotation, camera.lens, x, y);
    if (!unit.is_sure) [[unlikely]]
      return detail::careful_pick_ray(camera, x, y);
    return detail::ray_from_eye(camera, unit.value);
  } else {
    return detail::careful_pick_ray(camera, detail::OnScreen{x, y, detail::one<S>});
  }
}

/// The same for the middle of a pixel, or of the image if the viewport has no pixels.
template <Scalar S>
[[nodiscard]] constexpr Ray<S, 3> pick_ray(const Camera<S>& camera, const Viewport& viewport,
                                           std::int32_t column, std::int32_t row) noexcept {
  const auto at = detail::on_screen<S>(viewport, column, row);
  if constexpr (is_fixed<S> && has_filters && detail::has_long_registers) {
    const auto& lens = camera.lens;
    if (!lens.has_perspective()) return detail::careful_pick_ray(camera, viewport, column, row);
    const auto unit =
        detail::decide_direction<true>(camera.pose.rotation, lens, at.x, at.y, at.unit);
    if (!unit.is_sure) [[unlikely]]
      return detail::careful_pick_ray(camera, viewport, column, row);
    return detail::ray_from_eye(camera, unit.value);
  } else {
    return detail::careful_pick_ray(camera, at);
  }
}

namespace detail {

template <Scalar S>
[[nodiscard]] constexpr auto corners_of(const Camera<S>& camera) noexcept {
  const auto sign = [](bool is_positive) { return is_positive ? one<S> : narrow_negative(one<S>); };
  typename Frustum<S>::Corners corners;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const auto& depth = (i & 4) != 0 ? camera.lens.far_distance() : camera.lens.near_distance();
    corners[i] = unproject(camera, sign((i & 1) != 0), sign((i & 2) != 0), depth);
  }
  return corners;
}

}  // namespace detail

template <Scalar S>
constexpr Frustum<S>::Frustum(const Camera<S>& camera) noexcept
    : Frustum(detail::corners_of(camera)) {}

}  // namespace detent
