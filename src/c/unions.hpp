// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstdint>

#include "c/hulls.hpp"
#include "c/single.hpp"

// Queries of the union of several shapes, as C++ has for a `Compound`: single shapes go through the
// functions of the interface, and only hulls are queried here. Also queries of rays as shapes.
namespace detent::c {

template <int N>
struct Unions {
  using T = Types<N>;
  using Shape = typename T::Shape;

  static detent_status raycast(const detent_context* context, const typename T::Ray* ray,
                               const Shape* shapes, std::uint32_t count, typename T::Hit* hit) {
    if (ray == nullptr) return DETENT_BAD_ARGUMENT;
    Input<N> in;
    const auto along = in.ray(*ray);
    if (!in.is_valid()) return DETENT_NOT_UNIT;
    const auto status = check_shapes<N>(context, shapes, count);
    if (status != DETENT_OK) return status;
    detent_status result = DETENT_NO;
    typename T::Hit first{};
    for (std::uint32_t i = 0; i < count; ++i) {
      typename T::Hit found{};
      const auto is_hit = [&](const ConvexHull<S, N>& hull) -> detent_status {
        const auto own = detent::raycast_hit(along, hull);
        if (!own) return DETENT_NO;
        found = Output<N>::hit(*own);
        return DETENT_OK;
      };
      if (answer(context, shapes[i], is_hit, Single<N>::raycast, ray, &shapes[i], &found) !=
          DETENT_OK) {
        continue;
      }
      if (result == DETENT_NO || found.distance < first.distance) first = found;
      result = DETENT_OK;
    }
    if (result == DETENT_OK && hit != nullptr) *hit = first;
    return result;
  }

  static detent_status contains(const detent_context* context, const Shape* shapes,
                                std::uint32_t count, const typename T::Vec* point) {
    if (point == nullptr) return DETENT_BAD_ARGUMENT;
    const auto status = check_shapes<N>(context, shapes, count);
    if (status != DETENT_OK) return status;
    const auto holds = [&](const ConvexHull<S, N>& hull) {
      return yes_or_no(detent::contains(hull, Input<N>::vec(*point)));
    };
    return yes_or_no(std::any_of(shapes, shapes + count, [&](const Shape& shape) {
      return answer(context, shape, holds, Single<N>::contains, &shape, point) == DETENT_OK;
    }));
  }

  static detent_status overlaps(const detent_context* context, const Shape* a,
                                std::uint32_t a_count, const Shape* b, std::uint32_t b_count) {
    const auto status = check_lists<N>(context, a, a_count, b, b_count);
    if (status != DETENT_OK) return status;
    const auto meet = [](const ConvexHull<S, N>& hull, const auto& other) {
      return yes_or_no(detent::overlaps(hull, other));
    };
    return yes_or_no(std::any_of(a, a + a_count, [&](const Shape& one) {
      return std::any_of(b, b + b_count, [&](const Shape& other) {
        return answer_pair(context, one, other, meet, Single<N>::overlaps, &one, &other) ==
               DETENT_OK;
      });
    }));
  }

  static detent_status closest_point(const detent_context* context, const Shape* shapes,
                                     std::uint32_t count, const typename T::Vec* point,
                                     typename T::Vec* closest) {
    if (point == nullptr || closest == nullptr) return DETENT_BAD_ARGUMENT;
    const auto status = check_shapes<N>(context, shapes, count);
    if (status != DETENT_OK) return status;
    const Shape* nearest = nullptr;
    std::int32_t least = 0;
    for (std::uint32_t i = 0; i < count; ++i) {
      const auto distance = distance_of(context, shapes[i], *point);
      if (nearest != nullptr && distance >= least) continue;
      nearest = &shapes[i];
      least = distance;
    }
    if (nearest == nullptr) {
      *closest = *point;
      return DETENT_OK;
    }
    const auto write = [&](const ConvexHull<S, N>& hull) -> detent_status {
      *closest = Output<N>::vec(detent::closest_point(hull, Input<N>::vec(*point)));
      return DETENT_OK;
    };
    return answer(context, *nearest, write, Single<N>::closest_point, nearest, point, closest);
  }

  static detent_status distance_to_point(const detent_context* context, const Shape* shapes,
                                         std::uint32_t count, const typename T::Vec* point,
                                         std::int32_t* distance) {
    if (point == nullptr || distance == nullptr) return DETENT_BAD_ARGUMENT;
    const auto status = check_shapes<N>(context, shapes, count);
    if (status != DETENT_OK) return status;
    *distance = INT32_MAX;
    for (std::uint32_t i = 0; i < count; ++i) {
      *distance = (std::min)(*distance, distance_of(context, shapes[i], *point));
    }
    return DETENT_OK;
  }

  static detent_status distance(const detent_context* context, const Shape* a,
                                std::uint32_t a_count, const Shape* b, std::uint32_t b_count,
                                std::int32_t* distance) {
    if (distance == nullptr) return DETENT_BAD_ARGUMENT;
    const auto status = check_lists<N>(context, a, a_count, b, b_count);
    if (status != DETENT_OK) return status;
    std::int32_t least = INT32_MAX;
    for (std::uint32_t i = 0; i < a_count; ++i) {
      for (std::uint32_t k = 0; k < b_count; ++k) {
        std::int32_t between = INT32_MAX;
        const auto write = [&](const ConvexHull<S, N>& hull, const auto& other) -> detent_status {
          between = detent::distance(hull, other).raw();
          return DETENT_OK;
        };
        answer_pair(context, a[i], b[k], write, Single<N>::distance, &a[i], &b[k], &between);
        least = (std::min)(least, between);
      }
    }
    *distance = least;
    return DETENT_OK;
  }

 private:
  /// of_hull(hull) if the shape is one, otherwise call(arguments...).
  template <class F, class... Parameters, class... Arguments>
  static detent_status answer(const detent_context* context, const Shape& shape, const F& of_hull,
                              detent_status (*call)(Parameters...), Arguments... arguments) {
    if (shape.kind == DETENT_HULL) return with_hull<N>(context, shape, of_hull);
    return call(arguments...);
  }
  /// of_hull(hull, other) if either is a hull, otherwise call(arguments...). For queries that are
  /// symmetric in their shapes and depend only on the points of the shapes.
  template <class F, class... Parameters, class... Arguments>
  static detent_status answer_pair(const detent_context* context, const Shape& a, const Shape& b,
                                   const F& of_hull, detent_status (*call)(Parameters...),
                                   Arguments... arguments) {
    if (a.kind != DETENT_HULL && b.kind == DETENT_HULL) {
      return answer_pair(context, b, a, of_hull, call, arguments...);
    }
    const auto with_other = [&](const ConvexHull<S, N>& hull) {
      const auto pair = [&](const auto& other) { return of_hull(hull, other); };
      return with_hull_or_points<N>(context, b, pair);
    };
    return answer(context, a, with_other, call, arguments...);
  }
  static std::int32_t distance_of(const detent_context* context, const Shape& shape,
                                  const typename T::Vec& point) {
    std::int32_t result = INT32_MAX;
    const auto write = [&](const ConvexHull<S, N>& hull) -> detent_status {
      result = detent::distance(hull, Input<N>::vec(point)).raw();
      return DETENT_OK;
    };
    answer(context, shape, write, Single<N>::distance_to_point, &shape, &point, &result);
    return result;
  }
};

template <int N>
struct Rays {
  using T = Types<N>;

  static detent_status contains(const typename T::Ray* ray, const typename T::Vec* point) {
    return of(ray, point, [](const Ray<S, N>& along, const Vec<S, N>& at) {
      return yes_or_no(detent::contains(along, at));
    });
  }
  static detent_status closest_point(const typename T::Ray* ray, const typename T::Vec* point,
                                     typename T::Vec* closest) {
    if (closest == nullptr) return DETENT_BAD_ARGUMENT;
    return of(ray, point, [&](const Ray<S, N>& along, const Vec<S, N>& at) -> detent_status {
      *closest = Output<N>::vec(detent::closest_point(along, at));
      return DETENT_OK;
    });
  }
  static detent_status distance_to_point(const typename T::Ray* ray, const typename T::Vec* point,
                                         std::int32_t* distance) {
    if (distance == nullptr) return DETENT_BAD_ARGUMENT;
    return of(ray, point, [&](const Ray<S, N>& along, const Vec<S, N>& at) -> detent_status {
      *distance = detent::distance(along, at).raw();
      return DETENT_OK;
    });
  }

 private:
  template <class F>
  static detent_status of(const typename T::Ray* ray, const typename T::Vec* point, const F& f) {
    if (ray == nullptr || point == nullptr) return DETENT_BAD_ARGUMENT;
    Input<N> in;
    const auto along = in.ray(*ray);
    return in.is_valid() ? f(along, Input<N>::vec(*point)) : DETENT_NOT_UNIT;
  }
};

}  // namespace detent::c
