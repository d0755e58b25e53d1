// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>

#include "c/hulls.hpp"
#include "detent/query/cast.hpp"

// A moving shape against a shape. `cast_at`, which takes long to compile, is in src/c/casts/, a
// source for each moving shape.
namespace detent::c {

/// `detent::cast`, of a capsule, OBB or hull at a capsule, OBB, plane or hull.
template <class Moving, class Target, int N>
std::optional<CastHit<S, N>> cast_at(const Moving& moving, const Direction<S, N>& direction,
                                     S max_distance, const Target& target);

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
    Found found;
    const auto status = at(*shape, along, Input<N>::number(max_distance), *target, found);
    return status == DETENT_OK ? write(found, hit) : status;
  }

  static detent_status cast_of_shapes(const detent_context* context, const typename T::Shape* shape,
                                      const typename T::Direction* direction,
                                      std::int32_t max_distance, const typename T::Shape* targets,
                                      std::uint32_t count, typename T::Hit* hit) {
    if (shape == nullptr || direction == nullptr) return DETENT_BAD_ARGUMENT;
    Input<N> in;
    const auto along = in.direction(*direction);
    if (!in.is_valid()) return DETENT_NOT_UNIT;
    auto status = check_lists<N>(context, shape, 1, targets, count);
    if (status != DETENT_OK) return status;
    if (shape->kind == DETENT_PLANE) return DETENT_NO_QUERY;
    const S length = Input<N>::number(max_distance);
    Found first;
    for (std::uint32_t i = 0; i < count; ++i) {
      Found found;
      if (shape->kind != DETENT_HULL && targets[i].kind != DETENT_HULL) {
        status = at(*shape, along, length, targets[i], found);
      } else {
        status = with_hull_or_points<N>(context, *shape, [&](const auto& moving) {
          return with_hull_or_points<N>(context, targets[i], [&](const auto& other) {
            return between(moving, along, length, other, found);
          });
        });
      }
      if (status != DETENT_OK) return status;
      if (found && (!first || found->distance < first->distance)) first = found;
    }
    return write(first, hit);
  }

 private:
  using Found = std::optional<CastHit<S, N>>;

  template <class Moving, class Target>
  static detent_status between(const Moving& moving, const Direction<S, N>& along, S length,
                               const Target& target, Found& found) {
    if constexpr (std::is_same_v<Moving, Plane<S, N>>) {
      return DETENT_NO_QUERY;
    } else {
      found = cast_at(moving, along, length, target);
      return DETENT_OK;
    }
  }
  static detent_status at(const typename T::Shape& shape, const Direction<S, N>& along, S length,
                          const typename T::Shape& target, Found& found) {
    if (shape.kind == DETENT_AABB && target.kind == DETENT_AABB) {
      // With two AABBs the normal is that of the lowest axis, which their corners do not determine.
      found = detent::cast(Input<N>().aabb(shape), along, length, Input<N>().aabb(target));
      return DETENT_OK;
    }
    return with_points<N>(shape, [&](const auto& moving) {
      return with_points<N>(
          target, [&](const auto& other) { return between(moving, along, length, other, found); });
    });
  }
  static detent_status write(const Found& found, typename T::Hit* hit) {
    if (found && hit != nullptr) *hit = Output<N>::hit(*found);
    return yes_or_no(found.has_value());
  }
};

}  // namespace detent::c
