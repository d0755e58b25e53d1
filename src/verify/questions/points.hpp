// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <type_traits>
#include <utility>

#include "detent/query/barycentric.hpp"
#include "detent/query/closest_point.hpp"
#include "detent/query/contains.hpp"
#include "detent/query/distance.hpp"
#include "detent/query/on.hpp"
#include "verify/questions/cases.hpp"
#include "verify/questions/kinds.hpp"

namespace detent::verify {

/// A point, a shape and a tolerance.
template <Scalar S, int N, class ShapeType>
struct PointCase {
  using Shape = ShapeType;
  Shape shape;
  Vec<S, N> point;
  S tolerance{};

  constexpr auto fields(const auto& f) const noexcept { return f(shape, point, tolerance); }
};

/// A squared length for the digest: rounded down to the grid of a scalar's squares and clamped to
/// their range, so that it does not depend on how a fraction is represented.
template <Number S>
struct square_of {
  using type = S;
};
template <int Bits, int Frac>
struct square_of<Fixed<Bits, Frac>> {
  using type = Fixed<2 * Bits + 1, 2 * Frac>;
};
template <Scalar S, Number T>
[[nodiscard]] constexpr auto rounded_square(const T& x) noexcept {
  return floor_to<typename square_of<S>::type>(x);
}
template <Scalar S, Number Over, Number Under>
[[nodiscard]] constexpr auto rounded_square(const Fraction<Over, Under>& x) noexcept {
  return quotient_floor<typename square_of<S>::type>(x.numerator, x.denominator);
}

/// A group's rows are the first of these, as many as its kind of shape has.
enum PointRow {
  contains_row,
  on_row,
  closest_point_row,
  distance_row,
  squared_distance_row,
  barycentric_row
};

template <class Shape>
inline constexpr std::size_t point_rows = [] {
  std::size_t rows = squared_distance_row;
  if constexpr (requires(Shape shape) { squared_distance(shape, Vec<q16_16, 3>()); }) ++rows;
  if constexpr (requires(Shape shape) { barycentric(shape, Vec<q16_16, 3>()); }) ++rows;
  return rows;
}();

template <class Kind>
struct Points : InDimensions<2, 3> {
  static constexpr std::size_t rows = point_rows<
      std::remove_cvref_t<decltype(as_shape(Kind::draw(std::declval<ShapeScene<q16_16, 3>&>())))>>;
  static constexpr std::array<RowName, 6> all_names{
      RowName("contains/", Kind::name),         RowName("on/", Kind::name),
      RowName("closest_point/", Kind::name),    RowName("distance/", Kind::name),
      RowName("squared_distance/", Kind::name), RowName("barycentric/", Kind::name)};
  static constexpr auto names = [] {
    std::array<std::string_view, rows> views;
    for (std::size_t row = 0; row < rows; ++row) views[row] = all_names[row].view();
    return views;
  }();

  template <Scalar S, int N>
  static constexpr auto draw(Random& random) noexcept {
    ShapeScene<S, N> scene(random);
    const auto shape = Kind::draw(scene);
    using Shape = std::remove_const_t<decltype(shape)>;
    return PointCase<S, N, Shape>{shape, scene.spot(), scene.tolerance()};
  }

  template <int Row, Scalar S, int N, class Shape>
  [[nodiscard]] static constexpr auto answer(const PointCase<S, N, Shape>& c) noexcept {
    const auto& shape = as_shape(c.shape);
    if constexpr (Row == contains_row) {
      return contains(shape, c.point);
    } else if constexpr (Row == on_row) {
      return on(shape, c.point, c.tolerance);
    } else if constexpr (Row == closest_point_row) {
      return closest_point(shape, c.point);
    } else if constexpr (Row == distance_row) {
      return distance(shape, c.point);
    } else if constexpr (Row == squared_distance_row) {
      return rounded_square<S>(squared_distance(shape, c.point));
    } else {
      using Weights = std::optional<Vec<direction_component<S>, 3>>;
      const auto weights = barycentric(shape, c.point);
      return weights ? Weights(nearest_to<direction_component<S>>(*weights)) : Weights();
    }
  }
};

}  // namespace detent::verify
