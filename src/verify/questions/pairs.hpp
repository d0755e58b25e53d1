// SPDX-License-Identifier: MIT
#pragma once

#include <type_traits>

#include "detent/query/intersects.hpp"
#include "detent/query/overlaps.hpp"
#include "verify/questions/kinds.hpp"

namespace detent::verify {

/// Two shapes; for `intersects` a segment comes first.
template <Scalar S, int N, class First, class Second>
struct PairCase {
  First a;
  Second b;
};
template <class D, Scalar S, int N, class First, class Second>
constexpr void append(D& digest, const PairCase<S, N, First, Second>& c) noexcept {
  digest.add(c.a, c.b);
}

struct PairGroup {
  template <int N>
  static constexpr bool asks = N >= 2;
};
template <class First, class Second>
struct PairDraw : PairGroup {
  template <Scalar S, int N>
  static constexpr auto draw(Random& random) noexcept {
    ShapeScene<S, N> scene(random);
    const auto a = First::draw(scene);
    scene.turn();
    const auto b = Second::draw(scene);
    return PairCase<S, N, std::remove_const_t<decltype(a)>, std::remove_const_t<decltype(b)>>{a, b};
  }
};

template <class First, class Second>
struct Overlaps : PairDraw<First, Second> {
  static constexpr RowName name{"overlaps/", First::name, "_", Second::name};
  static constexpr std::array<std::string_view, 1> names{name.view()};

  template <int Row, class Case>
  [[nodiscard]] static constexpr bool answer(const Case& c) noexcept {
    return overlaps(as_shape(c.a), as_shape(c.b));
  }
};

template <class Kind>
struct Intersects : PairDraw<SegmentKind, Kind> {
  static constexpr RowName name{"intersects/", Kind::name};
  static constexpr std::array<std::string_view, 1> names{name.view()};

  template <int Row, class Case>
  [[nodiscard]] static constexpr bool answer(const Case& c) noexcept {
    return intersects(c.a, as_shape(c.b));
  }
};

}  // namespace detent::verify
