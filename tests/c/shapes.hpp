// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <tuple>
#include <type_traits>
#include <utility>

#include "c/convert.hpp"
#include "support/catch.hpp"
#include "verify/draw/shapes.hpp"

// The shapes of `verify` as C structures.

namespace detent {

/// A shape as the library's type and as C's, whose segments have no functions of their own.
template <int N, class Shape>
typename c::Types<N>::Shape in_c(const Shape& shape) {
  typename c::Types<N>::Shape result{};
  if constexpr (std::is_same_v<Shape, Segment<q16_16, N>>) {
    result.kind = DETENT_SEGMENT;
    result.as.segment = {c::Output<N>::vec(shape.start), c::Output<N>::vec(shape.end)};
  } else {
    c::Output<N>::shape(result, shape);
  }
  return result;
}
template <int N>
typename c::Types<N>::Ray in_c(const Ray<q16_16, N>& ray) {
  return {c::Output<N>::vec(ray.origin), c::Output<N>::direction(ray.direction),
          ray.max_distance.raw()};
}

/// A shape of each kind, near each other.
template <int N>
struct Draw {
  verify::ShapeScene<q16_16, N> scene;

  auto all() {
    // One draw per statement, because the order within a statement is up to the compiler.
    const auto sphere = scene.sphere();
    const auto aabb = scene.aabb();
    const auto obb = scene.obb();
    const auto plane = scene.plane();
    const auto triangle = scene.triangle();
    const auto capsule = scene.capsule();
    const auto segment = scene.segment();
    return std::tuple{sphere, aabb, obb, plane, triangle, capsule, segment};
  }
  /// Two of each kind, the second ones turned.
  auto two_of_all() {
    const auto first = all();
    scene.turn();
    return std::pair{first, all()};
  }
};

/// Calls f.operator()<I, J>(a, b) for every shape I of one tuple and every shape J of another.
template <class... Shapes, class F>
void for_each_pair(const std::tuple<Shapes...>& first, const std::tuple<Shapes...>& second,
                   const F& f) {
  constexpr std::size_t count = sizeof...(Shapes);
  [&]<std::size_t... K>(std::index_sequence<K...>) {
    (f.template operator()<K / count, K % count>(std::get<K / count>(first),
                                                 std::get<K % count>(second)),
     ...);
  }
  (std::make_index_sequence<count * count>());
}

/// Counts how many answers were yes.
struct Share {
  int yes = 0, all = 0;
  void add(bool is_yes) {
    yes += is_yes ? 1 : 0;
    ++all;
  }
  /// Both answers are frequent.
  void check() const {
    CAPTURE(yes, all);
    CHECK(yes * 10 > all);
    CHECK(yes * 10 < 9 * all);
  }
};

}  // namespace detent
