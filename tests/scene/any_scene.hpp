// SPDX-License-Identifier: MIT
#pragma once

#include <variant>

#include "detent/scene/scene.hpp"
#include "support/shapes.hpp"

namespace detent::test {

template <Scalar S, int N>
struct SceneOf {
  template <class... Shapes>
  using type = BasicScene<Growing, S, N, Shapes...>;
};

/// A growing scene of all kinds of shapes, and of `More`.
template <Scalar S, int N, class... More>
using AnyScene =
    typename support::SceneShapes<S, N>::template in<SceneOf<S, N>::template type, More...>;

/// One of its shapes.
template <Scalar S, int N, class... More>
using AnyShape = typename support::SceneShapes<S, N>::template in<std::variant, More...>;

/// The shapes with which scenes are queried.
template <Scalar S, int N>
using QueryShapes = typename support::AllShapes<S, N>::template without<Plane<S, N>, Triangle<S, N>,
                                                                        ConvexHull<S, N>>;

}  // namespace detent::test
