// SPDX-License-Identifier: MIT
#pragma once

#include "detent/query/raycast.hpp"
#include "oracle/answer.hpp"

namespace detent::oracle {

/// The library's results for the three raycasts.
template <Scalar S, int N, class Shape, class... Facings>
Given<N> ask(const Ray<S, N>& ray, const Shape& shape, Facings... facing) {
  Given<N> given;
  if (const auto distance = detent::raycast(ray, shape, facing...)) {
    given.distance = distance->raw();
  }
  if (const auto hit = detent::raycast_hit(ray, shape, facing...)) {
    given.hit = typename Given<N>::Hit{hit->distance.raw(), {}, raw(hit->normal)};
    for (int i = 0; i < N; ++i) {
      given.hit->point[static_cast<std::size_t>(i)] = hit->point[i].raw();
    }
  }
  if (const auto interval = detent::raycast_interval(ray, shape, facing...)) {
    given.interval.emplace(interval->enter.raw(), interval->exit.raw());
  }
  return given;
}

}  // namespace detent::oracle
