// SPDX-License-Identifier: MIT
#pragma once

#include "c/context.hpp"

namespace detent::c {

/// Hulls and solids, which are made from points.
template <int N, class Asset>
struct PointAssets {
  static detent_status create(detent_context* context, std::uint32_t id,
                              const typename Types<N>::Vec* points, std::uint32_t count,
                              detent_handle* asset);
};
template <int N>
using Hulls = PointAssets<N, HullAsset<S, N>>;
template <int N>
using Solids = PointAssets<N, SolidHull<S, N>>;

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
                              detent_handle* compound);
};

}  // namespace detent::c
