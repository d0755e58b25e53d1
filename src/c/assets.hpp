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

}  // namespace detent::c
