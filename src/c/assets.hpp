// SPDX-License-Identifier: MIT
#pragma once

#include "c/context.hpp"

namespace detent::c {

/// `detent_hull2_create` and `detent_hull3_create`.
template <int N>
detent_status make_hull(detent_context* context, std::uint32_t id,
                        const typename Types<N>::Vec* points, std::uint32_t count,
                        detent_handle* hull);

/// `detent_solid2_create` and `detent_solid3_create`.
template <int N>
detent_status make_solid(detent_context* context, std::uint32_t id,
                         const typename Types<N>::Vec* points, std::uint32_t count,
                         detent_handle* solid);

/// `detent_compound2_create` and `detent_compound3_create`.
template <int N>
detent_status make_compound(detent_context* context, std::uint32_t id,
                            const typename Types<N>::Part* parts, std::uint32_t count,
                            detent_handle* compound);

template <int N>
struct Hulls {
  static detent_status create(detent_context* context, std::uint32_t id,
                              const typename Types<N>::Vec* points, std::uint32_t count,
                              detent_handle* hull) {
    return make_hull<N>(context, id, points, count, hull);
  }
};

template <int N>
struct Solids {
  static detent_status create(detent_context* context, std::uint32_t id,
                              const typename Types<N>::Vec* points, std::uint32_t count,
                              detent_handle* solid) {
    return make_solid<N>(context, id, points, count, solid);
  }
};

template <int N>
struct Compounds {
  static detent_status defaults(typename Types<N>::Part* part) {
    if (part == nullptr) return DETENT_BAD_ARGUMENT;
    const PartOptions<S> own;
    *part = {};
    part->shape.kind = DETENT_SPHERE;
    part->density = own.density.raw();
    part->friction = own.friction.raw();
    part->restitution = own.restitution.raw();
    part->rolling_resistance = own.rolling_resistance.raw();
    part->is_sensor = own.is_sensor ? 1 : 0;
    return DETENT_OK;
  }
  static detent_status create(detent_context* context, std::uint32_t id,
                              const typename Types<N>::Part* parts, std::uint32_t count,
                              detent_handle* compound) {
    return make_compound<N>(context, id, parts, count, compound);
  }
};

}  // namespace detent::c
