// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "c/hulls.hpp"
#include "c/scenes.hpp"
#include "detent/math/projection.hpp"
#include "detent/shape/camera.hpp"

// Cameras, and queries of their frusta.
namespace detent::c {

template <int N>
struct Cameras;

template <>
struct Cameras<3> {
  static detent_status look_at(const detent_vec3* eye, const detent_vec3* target,
                               const detent_vec3* up, detent_transform3* pose) {
    if (eye == nullptr || target == nullptr || up == nullptr || pose == nullptr) {
      return DETENT_BAD_ARGUMENT;
    }
    const auto found =
        detent::look_at(Input<3>::vec(*eye), Input<3>::vec(*target), Input<3>::vec(*up));
    if (found) *pose = Output<3>::transform(*found);
    return yes_or_no(found.has_value());
  }
  static detent_status frustum(const detent_camera3* camera, detent_frustum3* frustum) {
    return with_camera(camera, frustum, [](const Camera<S>& own) {
      detent_frustum3 result;
      const Frustum<S> seen(own);
      for (std::size_t i = 0; i < 8; ++i) result.corners[i] = Output<3>::vec(seen.corners()[i]);
      return result;
    });
  }
  static detent_status pick_ray(const detent_camera3* camera, std::int32_t width,
                                std::int32_t height, std::int32_t column, std::int32_t row,
                                detent_ray3* ray) {
    return with_camera(camera, ray, [&](const Camera<S>& own) -> detent_ray3 {
      const auto found = detent::pick_ray(own, Viewport{width, height}, column, row);
      return {Output<3>::vec(found.origin), Output<3>::direction(found.direction),
              found.max_distance.raw()};
    });
  }
  static detent_status project(const detent_camera3* camera, std::int32_t width,
                               std::int32_t height, const detent_vec3* point,
                               detent_screen_point3* seen) {
    if (point == nullptr) return DETENT_BAD_ARGUMENT;
    bool is_seen = false;
    const auto status =
        with_camera(camera, seen, [&](const Camera<S>& own) -> detent_screen_point3 {
          const auto found = detent::project(own, Viewport{width, height}, Input<3>::vec(*point));
          is_seen = found.has_value();
          if (!found) return *seen;
          return {found->x.raw(), found->y.raw(), found->depth.raw()};
        });
    return status == DETENT_OK ? yes_or_no(is_seen) : status;
  }
  static detent_status unproject(const detent_camera3* camera, std::int32_t width,
                                 std::int32_t height, std::int32_t column, std::int32_t row,
                                 std::int32_t depth, detent_vec3* point) {
    return with_camera(camera, point, [&](const Camera<S>& own) {
      return Output<3>::vec(
          detent::unproject(own, Viewport{width, height}, column, row, Input<3>::number(depth)));
    });
  }

 private:
  /// Writes f(camera) to `out`.
  template <class Out, class F>
  static detent_status with_camera(const detent_camera3* camera, Out* out, const F& f) {
    if (camera == nullptr || out == nullptr || camera->has_perspective > 1) {
      return DETENT_BAD_ARGUMENT;
    }
    Input<3> in;
    const auto pose = in.transform(camera->pose);
    if (!in.is_valid()) return DETENT_NOT_UNIT;
    const S low = Input<3>::number(camera->near_distance);
    const S high = Input<3>::number(camera->far_distance);
    const auto lens = camera->has_perspective == 1
                          ? Lens<S>::perspective(Angle<S>::from_raw(camera->fov),
                                                 Input<3>::number(camera->aspect), low, high)
                          : Lens<S>::orthographic(Input<3>::number(camera->half_width),
                                                  Input<3>::number(camera->half_height), low, high);
    if (!lens) return DETENT_BAD_ARGUMENT;
    *out = f(Camera<S>{pose, *lens});
    return DETENT_OK;
  }
};

template <int N>
struct Frusta;

template <>
struct Frusta<3> {
  static detent_status raycast(const detent_ray3* ray, const detent_frustum3* frustum,
                               detent_hit3* hit) {
    if (ray == nullptr || frustum == nullptr) return DETENT_BAD_ARGUMENT;
    Input<3> in;
    const auto along = in.ray(*ray);
    if (!in.is_valid()) return DETENT_NOT_UNIT;
    const auto found = detent::raycast_hit(along, own(*frustum));
    if (found && hit != nullptr) *hit = Output<3>::hit(*found);
    return yes_or_no(found.has_value());
  }
  static detent_status contains(const detent_frustum3* frustum, const detent_vec3* point) {
    if (frustum == nullptr || point == nullptr) return DETENT_BAD_ARGUMENT;
    return yes_or_no(detent::contains(own(*frustum), Input<3>::vec(*point)));
  }
  static detent_status overlaps(const detent_context* context, const detent_frustum3* frustum,
                                const detent_shape3* shapes, std::uint32_t count) {
    if (frustum == nullptr) return DETENT_BAD_ARGUMENT;
    const auto status = check_shapes<3>(context, shapes, count);
    if (status != DETENT_OK) return status;
    const auto region = own(*frustum);
    const auto meets = [&](const auto& shape) { return yes_or_no(detail::meets(region, shape)); };
    const auto meets_any = [&](const auto& shape) {
      if constexpr (detail::IsSegment<std::remove_cvref_t<decltype(shape)>>) {
        return yes_or_no(detail::meets(shape, region));
      } else {
        return meets(shape);
      }
    };
    return yes_or_no(std::any_of(shapes, shapes + count, [&](const detent_shape3& shape) {
      return (shape.kind == DETENT_HULL ? with_hull<3>(context, shape, meets)
                                        : with_shape<3>(shape, meets_any)) == DETENT_OK;
    }));
  }
  static detent_status overlaps_frustum(const detent_frustum3* a, const detent_frustum3* b) {
    if (a == nullptr || b == nullptr) return DETENT_BAD_ARGUMENT;
    return yes_or_no(detent::overlaps(own(*a), own(*b)));
  }
  static detent_status closest_point(const detent_frustum3* frustum, const detent_vec3* point,
                                     detent_vec3* closest) {
    if (frustum == nullptr || point == nullptr || closest == nullptr) return DETENT_BAD_ARGUMENT;
    *closest = Output<3>::vec(detent::closest_point(own(*frustum), Input<3>::vec(*point)));
    return DETENT_OK;
  }
  static detent_status distance_to_point(const detent_frustum3* frustum, const detent_vec3* point,
                                         std::int32_t* distance) {
    if (frustum == nullptr || point == nullptr || distance == nullptr) return DETENT_BAD_ARGUMENT;
    *distance = detent::distance(own(*frustum), Input<3>::vec(*point)).raw();
    return DETENT_OK;
  }

  static detent_status scene_nearest(const detent_context* context, detent_handle scene,
                                     const detent_frustum3* frustum, std::uint32_t layers,
                                     detent_found* found) {
    return about(context, scene, frustum, [&](const Scene& object, const Frustum<S>& region) {
      const auto first = object.nearest(region, InLayers{layers});
      if (first && found != nullptr) *found = Scenes<3>::found_of(*first);
      return yes_or_no(first.has_value());
    });
  }
  static detent_status scene_any(const detent_context* context, detent_handle scene,
                                 const detent_frustum3* frustum, std::uint32_t layers) {
    return about(context, scene, frustum, [&](const Scene& object, const Frustum<S>& region) {
      return yes_or_no(object.any(region, InLayers{layers}));
    });
  }
  static detent_status scene_all(const detent_context* context, detent_handle scene,
                                 const detent_frustum3* frustum, std::uint32_t layers,
                                 detent_found* found, std::uint32_t room, std::uint32_t* count) {
    return about(context, scene, frustum, [&](const Scene& object, const Frustum<S>& region) {
      return write_list<Found<S>>(
          found, room, count, [&](auto list) { return object.all(region, list, InLayers{layers}); },
          Scenes<3>::found_of);
    });
  }

 private:
  using Scene = Scenes<3>::Scene;

  static Frustum<S> own(const detent_frustum3& frustum) noexcept {
    Frustum<S>::Corners corners;
    for (std::size_t i = 0; i < 8; ++i) corners[i] = Input<3>::vec(frustum.corners[i]);
    return Frustum<S>(corners);
  }
  /// f(scene, frustum)
  template <class F>
  static detent_status about(const detent_context* context, detent_handle scene,
                             const detent_frustum3* frustum, const F& f) {
    return read_object<Scene>(
        context, Scenes<3>::kind, scene, [&](const Context&, const Scene& object) -> detent_status {
          return frustum == nullptr ? DETENT_BAD_ARGUMENT : f(object, own(*frustum));
        });
  }
};

}  // namespace detent::c
