// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "detent/dynamics/record.hpp"
#include "detent/scene/height_field/placed.hpp"
#include "detent/scene/hull/asset.hpp"
#include "detent/scene/mesh/placed.hpp"
#include "detent/scene/object.hpp"
#include "detent/shape/moved.hpp"

namespace detent {

/// The properties of a body, or of a part of a compound.
struct BodyInfo {
  BodyId id;
  std::uint32_t part = 0;  // the number of the part; 0 for other bodies
  BodyMotion motion{};
  std::uint32_t layers = 0, collides_with = 0;
  std::uint64_t user = 0;
  bool is_sensor = false;  // the body, or this part
  bool is_asleep = false;

  /// For filters and colours of scenes, such as `InLayers`.
  [[nodiscard]] constexpr operator ObjectInfo() const noexcept {
    return {id, layers, user, motion == BodyMotion::fixed ? Motion::fixed : Motion::moving};
  }

  [[nodiscard]] friend constexpr bool operator==(const BodyInfo&,
                                                 const BodyInfo&) noexcept = default;
};

namespace detail {

template <Scalar S, int N>
[[nodiscard]] constexpr Vec<S, N> rounded(
    const Vec<typename Formats<S>::Place, N>& place) noexcept {
  return make_vec<N>([&](int i) { return saturate_to<S>(place[i]); });
}
template <Scalar S, int N>
[[nodiscard]] constexpr Rotation<S, N> rounded(const Axes<S, N>& axes) noexcept {
  std::array<Direction<S, N>, std::size_t{N}> directions;
  for (std::size_t i = 0; i < std::size_t{N}; ++i) {
    directions[i] = Direction<S, N>::assume_unit(nearest_to<direction_component<S>>(axes[i]));
  }
  return Rotation<S, N>::from_axes(directions);
}
template <Scalar S, int N>
[[nodiscard]] constexpr Transform<S, N> rounded(const Standing<S, N>& at) noexcept {
  return {rounded<S, N>(at.place), rounded<S, N>(at.axes), S(1)};
}
/// The frame whose point `center` is at the origin of a body's frame.
template <Scalar S, int N, Number C>
[[nodiscard]] constexpr Transform<S, N> frame_about(const Standing<S, N>& at,
                                                    const Vec<C, N>& center) noexcept {
  const auto origin = make_vec<N>([&](int k) {
    const auto row = make_vec<N>([&](int i) { return at.axes[static_cast<std::size_t>(i)][k]; });
    return saturate_to<S>(at.place[k] - dot(row, center));
  });
  return {origin, rounded<S, N>(at.axes), S(1)};
}

/// A shape from the frame of a body, in the world. Surfaces and hulls are in the form that scenes
/// hold.
template <Scalar S, int N, class Shape>
requires requires(const Transform<S, N>& pose, const Shape& shape) { placed(pose, shape); }
[[nodiscard]] constexpr Shape in_world(const Standing<S, N>& at, const Shape& shape) noexcept {
  return placed(rounded(at), shape);
}
template <Scalar S, int N>
[[nodiscard]] constexpr Sphere<S, N> in_world(const Standing<S, N>& at,
                                              const Sphere<S, N>& ball) noexcept {
  return {rounded<S, N>(at.place), ball.radius};
}
template <Scalar S, int N>
[[nodiscard]] constexpr Obb<S, N> in_world(const Standing<S, N>& at,
                                           const Obb<S, N>& box) noexcept {
  return {rounded<S, N>(at.place), box.half_extents, rounded<S, N>(at.axes)};
}
/// A body that is an aligned box turns like any other. Its center may lie between two steps of the
/// grid; the half extents then include the longer side.
template <Scalar S, int N>
[[nodiscard]] constexpr Obb<S, N> in_world(const Standing<S, N>& at,
                                           const Aabb<S, N>& box) noexcept {
  Obb<S, N> turned{{}, extent_of(box).half_extents, {}};
  if (is_empty(box)) turned.half_extents[0] = S(-1);
  return in_world(at, turned);
}
template <Scalar S, int N>
[[nodiscard]] constexpr PlacedHull<S, N> in_world(const Standing<S, N>& at,
                                                  const BodyHull<S, N>& body) noexcept {
  if (body.asset == nullptr) return {nullptr, rounded(at)};
  return {&body.asset->asset(), frame_about(at, body.asset->center())};
}
template <Scalar S>
[[nodiscard]] constexpr PlacedMesh<S> in_world(const Standing<S, 3>& at,
                                               const BodyMesh<S, 3>& body) noexcept {
  return {body.asset, rounded(at)};
}
template <Scalar S>
[[nodiscard]] constexpr PlacedField<S> in_world(const Standing<S, 3>& at,
                                                const BodyHeightField<S, 3>& body) noexcept {
  return {body.asset, rounded<S, 3>(at.place)};
}

/// Whether the axes of a body have no effect on its shape in the world.
template <class Shape>
inline constexpr bool ignores_axes = false;
template <Scalar S, int N>
inline constexpr bool ignores_axes<Sphere<S, N>> = true;
template <Scalar S, int N>
inline constexpr bool ignores_axes<BodyHeightField<S, N>> = true;

template <Scalar S, int N, class Shape>
[[nodiscard]] constexpr BodyInfo info_of(const BodyRecord<S, N, Shape>& body,
                                         std::uint32_t index) noexcept {
  return {{index, body.generation}, 0,         body.motion,    body.layers,
          body.collides_with,       body.user, body.is_sensor, body.sleeps};
}

/// Calls f(info, shape) with the shape of a body in the world, or with each part of a compound, in
/// order. `Parts` are the shapes that its world names.
template <class... Parts, Scalar S, int N, class Shape, class F>
constexpr void visit_in_world(const BodyRecord<S, N, Shape>& body, std::uint32_t index,
                              const F& f) {
  BodyInfo info = info_of(body, index);
  Standing<S, N> at{body.state.place, {}};
  body.shape.visit([&]<class Solid>(const Solid& solid) {
    if constexpr (!ignores_axes<Solid>) at.axes = axes_of<S, N>(body.state.orientation);
    if constexpr (is_compound_body<Solid>) {
      if (solid.asset == nullptr) return;
      for (const auto& part : solid.asset->parts()) {
        info.is_sensor = body.is_sensor || part.options().is_sensor;
        const auto there = part_at(at, pose_in(*solid.asset, part));
        part.shape().visit([&]<class Part>(const Part& shape) {
          if constexpr (Among<Part, Parts...>) f(info, in_world(there, shape));
        });
        ++info.part;
      }
    } else {
      f(info, in_world(at, solid));
    }
  });
}

}  // namespace detail

}  // namespace detent
