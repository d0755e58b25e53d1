// SPDX-License-Identifier: MIT
#pragma once

#include <type_traits>

#include "detent/dynamics/terrain.hpp"
#include "detent/math/quat.hpp"
#include "detent/number/min_max.hpp"
#include "detent/shape/aabb.hpp"
#include "detent/shape/capsule.hpp"
#include "detent/shape/obb.hpp"
#include "detent/shape/sphere.hpp"

namespace detent::detail {

/// A shape in the frame of its body, and that frame in the world: its origin is the center, rounded
/// down to the scalar's grid, or the center of mass.
template <Scalar S, int N, class Shape, class Center = S>
struct Local {
  Shape shape{};
  Vec<Center, N> center{};
  Vec<typename Formats<S>::Ratio, BodyState<S, N>::orientation_size> orientation{};
};

/// The orientation of no rotation.
template <Scalar S, int N>
[[nodiscard]] constexpr auto upright() noexcept {
  Vec<typename Formats<S>::Ratio, BodyState<S, N>::orientation_size> q{};
  q[N == 2 ? 0 : 3] = typename Formats<S>::Ratio(1);
  return q;
}

/// The orientation of a rotation: its first axis in 2D, its quaternion in 3D, normalised.
template <Scalar S, int N>
[[nodiscard]] constexpr auto orientation_of(const Rotation<S, N>& rotation) noexcept {
  using Ratio = typename Formats<S>::Ratio;
  const auto unit = [](const auto& q) {
    return from_array(unit_vector<Ratio>(to_array(q)).value_or(to_array(upright<S, N>())));
  };
  if constexpr (N == 2) {
    return unit(rotation.axis(0).vec());
  } else {
    return unit(Quat<S>::from_rotation(rotation).vec());
  }
}

template <Scalar S, int N>
[[nodiscard]] constexpr Local<S, N, Sphere<S, N>> local_form(const Sphere<S, N>& ball) noexcept {
  return {{Vec<S, N>(), ball.radius}, ball.center, upright<S, N>()};
}
template <Scalar S, int N>
[[nodiscard]] constexpr Local<S, N, Obb<S, N>> local_form(const Obb<S, N>& box) noexcept {
  return {
      {Vec<S, N>(), box.half_extents, Rotation<S, N>()}, box.center, orientation_of(box.rotation)};
}
template <Scalar S, int N>
[[nodiscard]] constexpr Local<S, N, Aabb<S, N>> local_form(const Aabb<S, N>& box) noexcept {
  const auto center =
      make_vec<N>([&](int i) { return floor_to<S>(half(box.min[i] + box.max[i])); });
  return {{make_vec<N>([&](int i) { return saturate_to<S>(box.min[i] - center[i]); }),
           make_vec<N>([&](int i) { return saturate_to<S>(box.max[i] - center[i]); })},
          center,
          upright<S, N>()};
}
template <Scalar S, int N>
[[nodiscard]] constexpr Local<S, N, Capsule<S, N>> local_form(
    const Capsule<S, N>& capsule) noexcept {
  const auto center =
      make_vec<N>([&](int i) { return floor_to<S>(half(capsule.a[i] + capsule.b[i])); });
  return {{make_vec<N>([&](int i) { return saturate_to<S>(capsule.a[i] - center[i]); }),
           make_vec<N>([&](int i) { return saturate_to<S>(capsule.b[i] - center[i]); }),
           capsule.radius},
          center,
          upright<S, N>()};
}

/// A point of a body's frame, rotated, then translated; each coordinate rounded once.
template <Scalar S, int N, Number C>
[[nodiscard]] constexpr Vec<typename Formats<S>::Place, N> placed_center(
    const Vec<S, N>& translation, const Rotation<S, N>& rotation,
    const Vec<C, N>& center) noexcept {
  using Ratio = typename Formats<S>::Ratio;
  return make_vec<N>([&](int k) {
    const auto row = make_vec<N>([&](int i) { return Ratio(rotation.axis(i)[k]); });
    return nearest_to<typename Formats<S>::Place>(translation[k] + dot(row, center));
  });
}

/// A hull or compound in the frame of its body, relative to its center of mass.
template <Scalar S, int N, class Body>
[[nodiscard]] constexpr auto centered_form(const Body& body) noexcept {
  Body shape;
  shape.asset = body.asset;
  const auto center =
      body.asset ? body.asset->center() : std::remove_cvref_t<decltype(body.asset->center())>{};
  return Local<S, N, Body, typename Formats<S>::Place>{
      shape, placed_center(body.translation, body.rotation, center), orientation_of(body.rotation)};
}
template <Scalar S, int N>
[[nodiscard]] constexpr auto local_form(const BodyHull<S, N>& body) noexcept {
  return centered_form<S, N>(body);
}

/// A surface in the frame of its body, which is its asset's frame.
template <Scalar S, int N>
[[nodiscard]] constexpr Local<S, N, BodyMesh<S, N>> local_form(
    const BodyMesh<S, N>& body) noexcept {
  BodyMesh<S, N> shape;
  shape.asset = body.asset;
  return {shape, body.translation, orientation_of(body.rotation)};
}
template <Scalar S, int N>
[[nodiscard]] constexpr Local<S, N, BodyHeightField<S, N>> local_form(
    const BodyHeightField<S, N>& body) noexcept {
  BodyHeightField<S, N> shape;
  shape.asset = body.asset;
  return {shape, body.translation, upright<S, N>()};
}

/// Half the sides of a box about the origin of the body's frame, and a radius to add on all sides;
/// together they contain the shape.
template <Scalar S, int N>
struct BodyExtent {
  Vec<S, N> half_extents{};
  S radius{};
};

template <Scalar S, int N>
[[nodiscard]] constexpr BodyExtent<S, N> extent_of(const Sphere<S, N>& ball) noexcept {
  return {Vec<S, N>(), ball.radius};
}
template <Scalar S, int N>
[[nodiscard]] constexpr BodyExtent<S, N> extent_of(const Obb<S, N>& box) noexcept {
  return {box.half_extents, S(0)};
}
template <Scalar S, int N>
[[nodiscard]] constexpr BodyExtent<S, N> extent_of(const Aabb<S, N>& box) noexcept {
  return {
      make_vec<N>([&](int i) { return saturate_to<S>((max)(abs(box.min[i]), abs(box.max[i]))); }),
      S(0)};
}
template <Scalar S, int N>
[[nodiscard]] constexpr BodyExtent<S, N> extent_of(const Capsule<S, N>& capsule) noexcept {
  return {make_vec<N>(
              [&](int i) { return saturate_to<S>((max)(abs(capsule.a[i]), abs(capsule.b[i]))); }),
          capsule.radius};
}

template <Scalar S, int N>
[[nodiscard]] constexpr BodyExtent<S, N> extent_of(const BodyHull<S, N>& body) noexcept {
  BodyExtent<S, N> extent;
  for (const auto& p : faces_of(body).points) {
    extent.half_extents = make_vec<N>([&](int i) {
      return (max)(extent.half_extents[i], saturate_to<S>(ceil_to<S>(abs(p[i]))));
    });
  }
  return extent;
}

/// The extent of the box around a surface; 0 without triangles.
template <class Body>
requires is_surface_body<Body>
[[nodiscard]] constexpr auto extent_of(const Body& body) noexcept {
  using Extent = decltype(extent_of(bounding_box(surface_of(body))));
  if (body.asset == nullptr) return Extent{};
  const auto box = bounding_box(surface_of(body));
  return is_empty(box) ? Extent{} : extent_of(box);
}

/// The bounds of a body along the world's axes.
template <Scalar S, int N>
struct BodyBox {
  using Bound = typename Formats<S>::Bound;
  Vec<Bound, N> least{}, most{};
};

/// Contains the shape and twice `margin` around it: enough for the manifolds of two shapes within
/// `margin`, and more than all roundings.
template <Scalar S, int N>
[[nodiscard]] constexpr BodyBox<S, N> bounds_of(const Vec<typename Formats<S>::Place, N>& place,
                                                const Axes<S, N>& axes,
                                                const BodyExtent<S, N>& reach,
                                                const S& margin) noexcept {
  using Bound = typename Formats<S>::Bound;
  BodyBox<S, N> bounds;
  for (int k = 0; k < N; ++k) {
    // At most 3 * 2^Bits steps of the scalar, and |place| as much: less than 8 times 2^Bits.
    auto extent = nearest_to<Bound>(reach.radius + (margin + margin));
    for (int i = 0; i < N; ++i) {
      extent = nearest_to<Bound>(extent +
                                 abs(axes[static_cast<std::size_t>(i)][k]) * reach.half_extents[i]);
    }
    bounds.least[k] = nearest_to<Bound>(place[k] - extent);
    bounds.most[k] = nearest_to<Bound>(place[k] + extent);
  }
  return bounds;
}

}  // namespace detent::detail
