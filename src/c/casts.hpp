// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>

#include "c/points.hpp"
#include "detent/query/cast.hpp"

// A moving shape against a shape. What takes long to compile is `cast_against`, for each moving shape
// in a source of its own, in src/c/casts/.
namespace detent::c {

template <int N, class Moving>
detent_status cast_against(const Moving& moving, const Direction<S, N>& direction, S max_distance,
                           const typename Types<N>::Shape& target,
                           std::optional<CastHit<S, N>>& hit);

#ifdef DETENT_C_CASTS_OF
template <int N, class Moving>
detent_status cast_against(const Moving& moving, const Direction<S, N>& direction, S max_distance,
                           const typename Types<N>::Shape& target,
                           std::optional<CastHit<S, N>>& hit) {
  return with_points<N>(target, [&](const auto& other) -> detent_status {
    hit = detent::cast(moving, direction, max_distance, other);
    return DETENT_OK;
  });
}
#define DETENT_C_CASTS(N)                                                                        \
  template detent_status cast_against<N>(const DETENT_C_CASTS_OF<S, N>&, const Direction<S, N>&, \
                                         S, const Types<N>::Shape&,                              \
                                         std::optional<CastHit<S, N>>&);
#endif

template <int N>
struct Casts {
  using T = Types<N>;

  static detent_status cast(const typename T::Shape* shape, const typename T::Direction* direction,
                            std::int32_t max_distance, const typename T::Shape* target,
                            typename T::Hit* hit) {
    if (shape == nullptr || direction == nullptr || target == nullptr) return DETENT_BAD_ARGUMENT;
    Input<N> in;
    const auto along = in.direction(*direction);
    if (!in.is_valid()) return DETENT_NOT_UNIT;
    const S length = Input<N>::number(max_distance);
    std::optional<CastHit<S, N>> found;
    const auto status = [&]() -> detent_status {
      if (shape->kind == DETENT_AABB && target->kind == DETENT_AABB) {
        // Of two of them the normal is that of the lowest axis, which their corners do not say.
        found = detent::cast(in.aabb(*shape), along, length, in.aabb(*target));
        return DETENT_OK;
      }
      return with_points<N>(*shape, [&](const auto& moving) -> detent_status {
        if constexpr (std::is_same_v<std::remove_cvref_t<decltype(moving)>, Plane<S, N>>) {
          return DETENT_NO_QUERY;
        } else {
          return cast_against<N>(moving, along, length, *target, found);
        }
      });
    }();
    if (status != DETENT_OK || !found) return status == DETENT_OK ? DETENT_NO : status;
    if (hit != nullptr) {
      *hit = {found->distance.raw(), Output<N>::vec(found->point),
              Output<N>::direction(found->normal)};
    }
    return DETENT_OK;
  }
};

}  // namespace detent::c
