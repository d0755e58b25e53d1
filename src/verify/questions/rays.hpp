// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <string_view>
#include <type_traits>

#include "detent/query/raycast.hpp"
#include "verify/draw/rays.hpp"
#include "verify/questions/cases.hpp"
#include "verify/questions/kinds.hpp"

namespace detent::verify {

template <class D, Scalar S, int N, class Shape>
constexpr void append(D& digest, const RayCase<S, N, Shape>& c) noexcept {
  digest.add(c.ray, c.shape, c.facing == Facing::front);
}
/// A box has no facing, and the digest of its questions has never included one.
template <class D, Scalar S, int N>
constexpr void append(D& digest, const RayCase<S, N, Obb<S, N>>& c) noexcept {
  digest.add(c.ray, c.shape);
}

/// raycast, raycast_hit and raycast_interval against one kind of shape.
template <int Row, class Case>
[[nodiscard]] constexpr auto cast(const Case& c) noexcept {
  const auto& shape = as_shape(c.shape);
  constexpr bool has_sides = requires { raycast(c.ray, shape, c.facing); };
  if constexpr (Row == 0) {
    if constexpr (has_sides)
      return raycast(c.ray, shape, c.facing);
    else
      return raycast(c.ray, shape);
  } else if constexpr (Row == 1) {
    if constexpr (has_sides)
      return raycast_hit(c.ray, shape, c.facing);
    else
      return raycast_hit(c.ray, shape);
  } else {
    if constexpr (has_sides)
      return raycast_interval(c.ray, shape, c.facing);
    else
      return raycast_interval(c.ray, shape);
  }
}

template <class Kind>
struct RayGroup : InDimensions<2, 3> {
  static constexpr std::array<RowName, 3> all_names{RowName("raycast/", Kind::name),
                                                    RowName("raycast_hit/", Kind::name),
                                                    RowName("raycast_interval/", Kind::name)};
  static constexpr std::array<std::string_view, 3> names{all_names[0].view(), all_names[1].view(),
                                                         all_names[2].view()};
  template <int Row, class Case>
  [[nodiscard]] static constexpr auto answer(const Case& c) noexcept {
    return cast<Row>(c);
  }
};

/// Rays aimed at special places of the shape: edges, poles, tangents.
template <class Kind>
struct AimedRays : RayGroup<Kind> {
  template <Scalar S, int N>
  static constexpr auto draw(Random& random) noexcept {
    return RayScene<S, N>(random).draw(Type<typename Kind::template Of<S, N>>());
  }
};

/// Rays aimed anywhere near the shape.
template <class Kind>
struct RaysAgainst : RayGroup<Kind> {
  template <Scalar S, int N>
  static constexpr auto draw(Random& random) noexcept {
    ShapeScene<S, N> scene(random);
    const auto shape = Kind::draw(scene);
    return RayCase<S, N, std::remove_const_t<decltype(shape)>>{scene.aimed_ray(), shape};
  }
};

}  // namespace detent::verify
