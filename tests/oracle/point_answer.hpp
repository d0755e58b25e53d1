// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "detent/query/closest_point.hpp"
#include "detent/query/contains.hpp"
#include "detent/query/distance.hpp"
#include "detent/query/on.hpp"
#include "oracle/describe.hpp"
#include "oracle/exact.hpp"

namespace detent::oracle {

/// `x`, the square of a length of scalar S, in squared raw units.
template <Scalar S, int B, int F>
Moment in_raw_units(const Fixed<B, F>& x) {
  return {whole(x.raw()), Integer(1) << static_cast<unsigned>(F - 2 * S::frac)};
}
template <Scalar S, class Over, class Under>
Moment in_raw_units(const Fraction<Over, Under>& x) {
  constexpr int shift = Over::frac - Under::frac - 2 * S::frac;
  static_assert(shift >= 0);
  return {whole(x.numerator.raw()), whole(x.denominator.raw()) << static_cast<unsigned>(shift)};
}

/// Empty when all of the library's point queries are right for the point and the shape, otherwise a
/// line per wrong result. `on` is tested with each tolerance.
template <class Shape, Scalar S, int N, class Tolerances>
std::string point_mistakes(const Shape& shape, const Vec<S, N>& point,
                           const std::optional<Nearest<N>>& truth, const Tolerances& tolerances) {
  std::string out;  // no stream: it takes longer than all the queries
  const bool inside = is_within(truth, 0);
  if (contains(shape, point) != inside) out += "  contains\n";
  if constexpr (requires { on(shape, point); }) {
    if (on(shape, point) != inside) out += "  on\n";
  }
  for (const S& tolerance : tolerances) {
    const bool expected = is_within(truth, raw(tolerance));
    if (on(shape, point, tolerance) != expected) {
      out += "  on with tolerance " + std::to_string(tolerance.raw()) + "\n";
    }
  }
  const S given = distance(shape, point);
  if (!is_distance(raw(given), truth, raw(S::max())))
    out += "  distance: got " + std::to_string(given.raw()) + "\n";
  if constexpr (requires { squared_distance(shape, point); }) {
    const auto squared = squared_distance(shape, point);
    if (truth && !(in_raw_units<S>(squared) == truth->core.squared)) {
      out += "  squared_distance: expected " + truth->core.squared.over.str() + " / " +
             truth->core.squared.under.str() + "\n";
    }
    const Integer limit = raw(S::max());
    if (!truth && !(Moment{limit * limit, 1} < in_raw_units<S>(squared))) {
      out += "  squared_distance: an empty shape is near\n";
    }
  }
  const auto closest = closest_point(shape, point);
  if (!is_closest<N>(raw(closest), raw(point), truth, raw(S::lowest()), raw(S::max()))) {
    out += "  closest_point: got " + describe(closest) + "\n";
  }
  return out;
}

}  // namespace detent::oracle
