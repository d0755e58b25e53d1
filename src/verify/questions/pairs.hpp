// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <type_traits>

#include "detent/query/closest_points.hpp"
#include "detent/query/contact.hpp"
#include "detent/query/distance.hpp"
#include "detent/query/intersects.hpp"
#include "detent/query/overlaps.hpp"
#include "verify/questions/cases.hpp"
#include "verify/questions/kinds.hpp"

namespace detent::verify {

/// Two shapes; for `intersects` a segment comes first.
template <Scalar S, int N, class First, class Second>
struct PairCase {
  First a;
  Second b;

  constexpr auto fields(const auto& f) const noexcept { return f(a, b); }
};

/// In these dimensions, or in both: each takes seconds or tens of seconds to compile.
template <int... Dimensions>
struct PairGroup : InDimensions<Dimensions...> {};
template <>
struct PairGroup<> : InDimensions<2, 3> {};
template <class First, class Second, int... Dimensions>
struct PairDraw : PairGroup<Dimensions...> {
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

/// Runs one question in twelve: pairs of polytopes take long to judge.
template <class First, class Second>
struct Distances : PairDraw<First, Second> {
  static constexpr RowName name{"distance/", First::name, "_", Second::name};
  static constexpr std::array<std::string_view, 1> names{name.view()};
  static constexpr std::uint32_t share = 12;

  template <int Row, class Case>
  [[nodiscard]] static constexpr auto answer(const Case& c) noexcept {
    return distance(as_shape(c.a), as_shape(c.b));
  }
};

/// The points as an array: first that of a, then that of b.
template <class First, class Second, int... Dimensions>
struct ClosestPoints : PairDraw<First, Second, Dimensions...> {
  static constexpr RowName name{"closest_points/", First::name, "_", Second::name};
  static constexpr std::array<std::string_view, 1> names{name.view()};
  static constexpr std::uint32_t share = 24;

  template <int Row, class Case>
  [[nodiscard]] static constexpr auto answer(const Case& c) noexcept {
    const auto [a, b] = closest_points(as_shape(c.a), as_shape(c.b));
    return std::array{a, b};
  }
};

template <class First, class Second, int... Dimensions>
struct Contacts : PairDraw<First, Second, Dimensions...> {
  static constexpr RowName name{"contact/", First::name, "_", Second::name};
  static constexpr std::array<std::string_view, 1> names{name.view()};
  static constexpr std::uint32_t share = 24;

  template <int Row, class Case>
  [[nodiscard]] static constexpr auto answer(const Case& c) noexcept {
    return contact(as_shape(c.a), as_shape(c.b));
  }
};

template <class Kind>
struct Intersects : PairDraw<verify::Kind<Segment>, Kind> {
  static constexpr RowName name{"intersects/", Kind::name};
  static constexpr std::array<std::string_view, 1> names{name.view()};

  template <int Row, class Case>
  [[nodiscard]] static constexpr bool answer(const Case& c) noexcept {
    return intersects(c.a, as_shape(c.b));
  }
};

}  // namespace detent::verify
