// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>

#include "c/points.hpp"
#include "detent/query/cast.hpp"

// A moving shape against a shape. What takes long to compile is `cast_at`, for each moving shape in a
// source of its own, in src/c/casts/.
namespace detent::c {

/// `detent::cast`, of a capsule, OBB or hull at a capsule, OBB, plane or hull.
template <class Moving, class Target, int N>
std::optional<CastHit<S, N>> cast_at(const Moving& moving, const Direction<S, N>& direction,
                                     S max_distance, const Target& target);

#ifdef DETENT_C_CASTS_OF
template <class Moving, class Target, int N>
std::optional<CastHit<S, N>> cast_at(const Moving& moving, const Direction<S, N>& direction,
                                     S max_distance, const Target& target) {
  return detent::cast(moving, direction, max_distance, target);
}
#define DETENT_C_CAST_AT(N, Target)                                             \
  template std::optional<CastHit<S, N>> cast_at(const DETENT_C_CASTS_OF<S, N>&, \
                                                const Direction<S, N>&, S, const Target<S, N>&);
#define DETENT_C_CASTS(N)      \
  DETENT_C_CAST_AT(N, Capsule) \
  DETENT_C_CAST_AT(N, Obb)     \
  DETENT_C_CAST_AT(N, Plane)   \
  DETENT_C_CAST_AT(N, ConvexHull)
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
          return with_points<N>(*target, [&](const auto& other) -> detent_status {
            found = cast_at(moving, along, length, other);
            return DETENT_OK;
          });
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
