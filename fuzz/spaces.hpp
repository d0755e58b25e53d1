// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <type_traits>

#include "detent/shape/shape.hpp"
#include "oracle/space.hpp"
#include "source.hpp"
#include "support/shapes.hpp"

namespace detent::fuzz {

using test::Space;

/// Calls `ask(Space<S, N>())` for a fixed scalar and a dimension chosen by a byte: among all of
/// them with the fuzzing engine, otherwise among the widest and the narrowest, which compile
/// quickly.
template <class Ask>
void in_a_space(Source& source, const Ask& ask) {
  const auto choice = source.below(2 * support::FixedScalars::size);
#if DETENT_FUZZ_EVERY_SPACE
  support::for_each_scalar(support::FixedScalars(), [&]<Scalar S>(S) {
    if (choice / 2 != support::scalar_index<S>) return;
    choice % 2 == 0 ? ask(Space<S, 3>()) : ask(Space<S, 2>());
  });
#else
  choice % 2 == 0 ? ask(Space<q16_16, 3>()) : ask(Space<q8_8, 2>());
#endif
}

/// Calls `check(std::type_identity<Shape>())` for one of the shapes, chosen by a byte.
template <class... Shapes, class Check>
void with_one_of(Source& source, const Check& check) {
  const auto choice = source.below(sizeof...(Shapes));
  std::size_t i = 0;
  ((i++ == choice ? check(std::type_identity<Shapes>()) : void()), ...);
}

template <class... Shapes, class Check>
void with_one_of(support::ShapeList<Shapes...>, Source& source, const Check& check) {
  with_one_of<Shapes...>(source, check);
}

/// The same for one of the shapes that scenes hold, or of `More`.
template <Scalar S, int N, class... More, class Check>
void with_one_shape(Source& source, const Check& check) {
  using Shapes = typename support::SceneShapes<S, N>::template and_also<More...>;
  with_one_of(Shapes(), source, check);
}

}  // namespace detent::fuzz
