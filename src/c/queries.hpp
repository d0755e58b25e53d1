// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "c/convert.hpp"
#include "detent/scene/scene.hpp"

// Queries of one shape or two. The exports call the functions of the same names.
namespace detent::c {

/// The order in which a distance takes its shapes: it is the same either way, and compiled once.
template <class T>
inline constexpr int rank = 0;
template <int N>
inline constexpr int rank<Aabb<S, N>> = 1;
template <int N>
inline constexpr int rank<Obb<S, N>> = 2;
template <int N>
inline constexpr int rank<Plane<S, N>> = 3;
template <int N>
inline constexpr int rank<Triangle<S, N>> = 4;
template <int N>
inline constexpr int rank<Capsule<S, N>> = 5;
template <int N>
inline constexpr int rank<Segment<S, N>> = 6;

template <class Shape>
inline constexpr bool is_segment = rank<Shape> == 6;

template <int N>
struct Queries {
  using T = Types<N>;

  static detent_status raycast(const typename T::Ray* ray, const typename T::Shape* shape,
                               typename T::Hit* hit) {
    if (ray == nullptr || shape == nullptr) return DETENT_BAD_ARGUMENT;
    Input<N> in;
    const auto along = in.ray(*ray);
    if (!in.is_valid()) return DETENT_NOT_UNIT;
    return with_shape<N>(*shape, [&](const auto& target) {
      if (hit == nullptr) return yes_or_no(detent::raycast(along, target).has_value());
      const auto found = detent::raycast_hit(along, target);
      if (!found) return detent_status{DETENT_NO};
      *hit = {found->distance.raw(), Output<N>::vec(found->point),
              Output<N>::direction(found->normal)};
      return detent_status{DETENT_OK};
    });
  }

  static detent_status raycast_many(const typename T::Ray* rays, std::uint32_t count,
                                    const typename T::Shape* shape, std::int32_t* distances) {
    if (shape == nullptr || (count != 0 && (rays == nullptr || distances == nullptr))) {
      return DETENT_BAD_ARGUMENT;
    }
    return with_shape<N>(*shape, [&](const auto& target) -> detent_status {
      for (std::uint32_t i = 0; i < count; ++i) {
        Input<N> in;
        const auto ray = in.ray(rays[i]);
        if (!in.is_valid()) return DETENT_NOT_UNIT;
        const auto distance = detent::raycast(ray, target);
        distances[i] = distance ? distance->raw() : -1;
      }
      return DETENT_OK;
    });
  }

  static detent_status contains(const typename T::Shape* shape, const typename T::Vec* point) {
    if (shape == nullptr || point == nullptr) return DETENT_BAD_ARGUMENT;
    const auto at = Input<N>::vec(*point);
    return with_shape<N>(*shape, [&](const auto& target) {
      return yes_or_no(detail::separately<detail::job::Contains>(target, at));
    });
  }

  static detent_status overlaps(const typename T::Shape* a, const typename T::Shape* b) {
    if (a == nullptr || b == nullptr) return DETENT_BAD_ARGUMENT;
    return with_shape<N>(*a, [&](const auto& one) {
      return with_shape<N>(*b, [&](const auto& other) {
        using A = std::remove_cvref_t<decltype(one)>;
        using B = std::remove_cvref_t<decltype(other)>;
        if constexpr (is_segment<A>) {
          return yes_or_no(detail::separately<detail::job::Intersects>(one, other));
        } else if constexpr (is_segment<B>) {
          return yes_or_no(detail::separately<detail::job::Intersects>(other, one));
        } else {
          return yes_or_no(detail::separately<detail::job::Overlaps>(one, other));
        }
      });
    });
  }

  static detent_status closest_point(const typename T::Shape* shape, const typename T::Vec* point,
                                     typename T::Vec* closest) {
    if (shape == nullptr || point == nullptr || closest == nullptr) return DETENT_BAD_ARGUMENT;
    const auto at = Input<N>::vec(*point);
    return with_shape<N>(*shape, [&](const auto& target) -> detent_status {
      *closest = Output<N>::vec(detent::closest_point(target, at));
      return DETENT_OK;
    });
  }

  static detent_status distance_to_point(const typename T::Shape* shape,
                                         const typename T::Vec* point, std::int32_t* distance) {
    if (shape == nullptr || point == nullptr || distance == nullptr) return DETENT_BAD_ARGUMENT;
    const auto at = Input<N>::vec(*point);
    return with_shape<N>(*shape, [&](const auto& target) -> detent_status {
      *distance = detail::separately<detail::job::Distance>(target, at).raw();
      return DETENT_OK;
    });
  }

  static detent_status distance(const typename T::Shape* a, const typename T::Shape* b,
                                std::int32_t* distance) {
    if (a == nullptr || b == nullptr || distance == nullptr) return DETENT_BAD_ARGUMENT;
    return with_shape<N>(*a, [&](const auto& one) {
      return with_shape<N>(*b, [&](const auto& other) -> detent_status {
        using A = std::remove_cvref_t<decltype(one)>;
        using B = std::remove_cvref_t<decltype(other)>;
        if constexpr (rank<A> <= rank<B>) {
          *distance = detent::distance(one, other).raw();
        } else {
          *distance = detent::distance(other, one).raw();
        }
        return DETENT_OK;
      });
    });
  }
};

}  // namespace detent::c
