// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>

#include "detent.h"
#include "detent/query/query.hpp"

// Converts raw integers of the C interface to numbers, vectors and shapes, and back.
namespace detent::c {

using S = q16_16;

/// The structures of a dimension.
template <int N>
struct Types;
#define DETENT_C_TYPES(N)                             \
  template <>                                         \
  struct Types<N> {                                   \
    using Vec = detent_vec##N;                        \
    using Direction = detent_direction##N;            \
    using Rotation = detent_rotation##N;              \
    using Transform = detent_transform##N;            \
    using Ray = detent_ray##N;                        \
    using Shape = detent_shape##N;                    \
    using Hit = detent_hit##N;                        \
    using ObjectHit = detent_object_hit##N;           \
    using Manifold = detent_manifold##N;              \
    using Sweep = detent_sweep##N;                    \
    using Settings = detent_world##N##_settings;      \
    using BodyOptions = detent_body##N##_options;     \
    using Body = detent_body##N;                      \
    using WorldContact = detent_world##N##_contact;   \
    using Joint = detent_joint##N;                    \
    using Part = detent_part##N;                      \
    using Mover = detent_mover##N;                    \
    using MoverSettings = detent_mover##N##_settings; \
    using Move = detent_move##N;                      \
  };
DETENT_C_TYPES(2)
DETENT_C_TYPES(3)
#undef DETENT_C_TYPES

/// Reads C structures; `is_valid` says whether all directions were unit vectors.
template <int N>
class Input {
  using T = Types<N>;

 public:
  [[nodiscard]] bool is_valid() const noexcept { return is_valid_; }

  static S number(std::int32_t raw) noexcept { return S::from_raw(raw); }
  static Vec<S, N> vec(const typename T::Vec& v) noexcept {
    if constexpr (N == 2) {
      return {number(v.x), number(v.y)};
    } else {
      return {number(v.x), number(v.y), number(v.z)};
    }
  }
  /// Inlined: otherwise a direction returned in registers is stored in words of another size than
  /// it is loaded in, which stalls.
  [[gnu::always_inline]] Direction<S, N> direction(const typename T::Direction& d) noexcept {
    const auto read = [&] {
      if constexpr (N == 2) {
        return Direction<S, N>::from_raw({d.x, d.y});
      } else {
        return Direction<S, N>::from_raw({d.x, d.y, d.z});
      }
    }();
    is_valid_ = is_valid_ && read.has_value();
    return read.value_or(Direction<S, N>());
  }
  Rotation<S, N> rotation(const typename T::Rotation& rotation) noexcept {
    std::array<Direction<S, N>, std::size_t{N}> axes;
    for (std::size_t i = 0; i < std::size_t{N}; ++i) axes[i] = direction(rotation.axis[i]);
    return Rotation<S, N>::from_axes(axes);
  }
  Transform<S, N> transform(const typename T::Transform& transform) noexcept {
    return {vec(transform.translation), rotation(transform.rotation), number(transform.scale)};
  }
  Ray<S, N> ray(const typename T::Ray& ray) noexcept {
    return {vec(ray.origin), direction(ray.direction), number(ray.max_distance)};
  }
  Sphere<S, N> sphere(const typename T::Shape& shape) noexcept {
    return {vec(shape.as.sphere.center), number(shape.as.sphere.radius)};
  }
  Aabb<S, N> aabb(const typename T::Shape& shape) noexcept {
    return {vec(shape.as.aabb.min), vec(shape.as.aabb.max)};
  }
  Obb<S, N> obb(const typename T::Shape& shape) noexcept {
    return {vec(shape.as.obb.center), vec(shape.as.obb.half_extents),
            rotation(shape.as.obb.rotation)};
  }
  Plane<S, N> plane(const typename T::Shape& shape) noexcept {
    return {direction(shape.as.plane.normal), number(shape.as.plane.offset)};
  }
  Triangle<S, N> triangle(const typename T::Shape& shape) noexcept {
    return {vec(shape.as.triangle.a), vec(shape.as.triangle.b), vec(shape.as.triangle.c)};
  }
  Capsule<S, N> capsule(const typename T::Shape& shape) noexcept {
    return {vec(shape.as.capsule.a), vec(shape.as.capsule.b), number(shape.as.capsule.radius)};
  }
  Segment<S, N> segment(const typename T::Shape& shape) noexcept {
    return {vec(shape.as.segment.start), vec(shape.as.segment.end)};
  }

 private:
  bool is_valid_ = true;
};

/// Writes C structures.
template <int N>
struct Output {
  using T = Types<N>;

  static typename T::Vec vec(const Vec<S, N>& v) noexcept {
    if constexpr (N == 2) {
      return {v.x.raw(), v.y.raw()};
    } else {
      return {v.x.raw(), v.y.raw(), v.z.raw()};
    }
  }
  static typename T::Direction direction(const Direction<S, N>& d) noexcept {
    if constexpr (N == 2) {
      return {d[0].raw(), d[1].raw()};
    } else {
      return {d[0].raw(), d[1].raw(), d[2].raw()};
    }
  }
  /// A hit of a ray or a cast.
  static typename T::Hit hit(const auto& found) noexcept {
    return {found.distance.raw(), vec(found.point), direction(found.normal)};
  }
  static typename T::Rotation rotation(const Rotation<S, N>& rotation) noexcept {
    typename T::Rotation result;
    for (int i = 0; i < N; ++i) result.axis[i] = direction(rotation.axis(i));
    return result;
  }
  static typename T::Transform transform(const Transform<S, N>& transform) noexcept {
    return {vec(transform.translation), rotation(transform.rotation), transform.scale.raw()};
  }
  static void shape(typename T::Shape& out, const Sphere<S, N>& sphere) noexcept {
    out.kind = DETENT_SPHERE;
    out.as.sphere = {vec(sphere.center), sphere.radius.raw()};
  }
  static void shape(typename T::Shape& out, const Aabb<S, N>& box) noexcept {
    out.kind = DETENT_AABB;
    out.as.aabb = {vec(box.min), vec(box.max)};
  }
  static void shape(typename T::Shape& out, const Obb<S, N>& box) noexcept {
    out.kind = DETENT_OBB;
    out.as.obb = {vec(box.center), vec(box.half_extents), rotation(box.rotation)};
  }
  static void shape(typename T::Shape& out, const Plane<S, N>& plane) noexcept {
    out.kind = DETENT_PLANE;
    out.as.plane = {direction(plane.normal), plane.offset.raw()};
  }
  static void shape(typename T::Shape& out, const Triangle<S, N>& triangle) noexcept {
    out.kind = DETENT_TRIANGLE;
    out.as.triangle = {vec(triangle.a), vec(triangle.b), vec(triangle.c)};
  }
  static void shape(typename T::Shape& out, const Capsule<S, N>& capsule) noexcept {
    out.kind = DETENT_CAPSULE;
    out.as.capsule = {vec(capsule.a), vec(capsule.b), capsule.radius.raw()};
  }
};

/// F(N, KIND, Shape, name) for each kind of shape that scenes hold by value: its constant in C, its
/// type, and its name in C and in `Input`.
#define DETENT_C_SCENE_SHAPES(F, N)  \
  F(N, SPHERE, Sphere, sphere)       \
  F(N, AABB, Aabb, aabb)             \
  F(N, OBB, Obb, obb)                \
  F(N, PLANE, Plane, plane)          \
  F(N, TRIANGLE, Triangle, triangle) \
  F(N, CAPSULE, Capsule, capsule)
/// The same for each kind that a single query takes.
#define DETENT_C_SHAPES(F, N) DETENT_C_SCENE_SHAPES(F, N) F(N, SEGMENT, Segment, segment)

/// The status of a query that shapes of this kind do not have.
[[nodiscard]] constexpr detent_status no_query(std::uint32_t kind) noexcept {
  return kind >= DETENT_SPHERE && kind <= DETENT_COMPOUND ? DETENT_NO_QUERY : DETENT_BAD_ARGUMENT;
}

/// Calls f(shape) for one of the kinds that a single query takes, and returns its result.
template <int N, class F>
detent_status with_shape(const typename Types<N>::Shape& shape, const F& f) {
  Input<N> in;
  const auto call = [&](const auto& read) -> detent_status {
    return in.is_valid() ? f(read) : DETENT_NOT_UNIT;
  };
#define DETENT_C_CASE(N, KIND, Shape, name) \
  case DETENT_##KIND:                       \
    return call(in.name(shape));
  switch (shape.kind) {
    DETENT_C_SHAPES(DETENT_C_CASE, N)
    default:
      return no_query(shape.kind);
  }
#undef DETENT_C_CASE
}

[[nodiscard]] constexpr detent_status yes_or_no(bool yes) noexcept {
  return yes ? DETENT_OK : DETENT_NO;
}

}  // namespace detent::c
