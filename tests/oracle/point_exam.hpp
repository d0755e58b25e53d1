// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstdint>
#include <sstream>
#include <string>

#include "detent/query/closest_point.hpp"
#include "detent/query/contains.hpp"
#include "detent/query/distance.hpp"
#include "detent/query/on.hpp"
#include "oracle/describe.hpp"
#include "oracle/draw.hpp"
#include "oracle/point.hpp"
#include "oracle/rounding.hpp"
#include "oracle/seeds.hpp"
#include "oracle/space.hpp"
#include "support/catch.hpp"

namespace detent::oracle {

/// `x`, the square of a length of scalar S, in squares of raw units.
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

/// Puts points and shapes to the library and to the oracle, and keeps the first few disagreements.
template <Scalar S, int N>
class PointExam {
 public:
  explicit PointExam(std::uint64_t seed) : draw(seed) {}

  Draw<S, N> draw;

  /// `count` cases that `generate` draws as a pair of shape and point; of these, at least `low` and
  /// at most `high` percent must be inside or on the shape.
  template <class Generate>
  void family(const char* name, long count, int low, int high, Generate generate) {
    test::HitRate rate;
    for (long i = 0; i < count; ++i) {
      const auto [shape, point] = generate();
      const auto truth = nearest(shape, point);
      rate.count(truth && within(*truth, 0));
      ++asked_;
      const auto found = mistakes(shape, point, truth);
      if (found.empty() || ++wrong_ > 5) continue;
      first_mistakes_ << name << ": " << describe(shape) << "; point " << describe(point) << "\n"
                      << found;
    }
    INFO(draw.random << ", " << name << ": " << rate);
    CHECK(rate.percent() >= low);
    CHECK(rate.percent() <= high);
  }

  void finish() {
    INFO(draw.random << ", " << asked_ << " cases\n" << first_mistakes_.str());
    CHECK(wrong_ == 0);
  }

 private:
  static bool within(const Nearest<N>& truth, const Integer& tolerance) {
    const Integer reach = truth.radius + tolerance;
    return truth.core.squared.over <= reach * reach * truth.core.squared.under;
  }

  template <class Shape>
  std::string mistakes(const Shape& shape, const Vec<S, N>& point,
                       const std::optional<Nearest<N>>& truth) {
    std::ostringstream out;
    const bool inside = truth && within(*truth, 0);
    if (contains(shape, point) != inside) out << "  contains: expected " << inside << "\n";
    if constexpr (requires { on(shape, point); }) {
      if (on(shape, point) != inside) out << "  on: expected " << inside << "\n";
    }

    const S given = distance(shape, point);
    if (!is_distance(raw(given), truth)) out << "  distance: got " << given.raw() << "\n";
    const auto near = static_cast<std::int64_t>(given.raw()) + draw.random.between(-1, 1);
    for (const S tolerance : {Draw<S, N>::scalar(near), Draw<S, N>::scalar(draw.extreme())}) {
      const bool expected = truth && tolerance >= 0 && within(*truth, raw(tolerance));
      if (on(shape, point, tolerance) != expected) {
        out << "  on with tolerance " << tolerance.raw() << ": expected " << expected << "\n";
      }
    }
    if constexpr (requires { squared_distance(shape, point); }) {
      const auto squared = squared_distance(shape, point);
      if (truth && !(in_raw_units<S>(squared) == truth->core.squared)) {
        out << "  squared_distance: expected " << truth->core.squared.over << " / "
            << truth->core.squared.under << "\n";
      }
      const Integer limit = whole(S::max().raw());
      if (!truth && !(Moment{limit * limit, 1} < in_raw_units<S>(squared))) {
        out << "  squared_distance: an empty shape is near\n";
      }
    }

    const auto closest = closest_point(shape, point);
    if (!is_closest(closest, point, truth, inside)) {
      out << "  closest_point: got " << describe(closest) << "\n";
    }
    return out.str();
  }

  /// Whether given = floor(max(0, sqrt(squared) - radius)), clamped.
  static bool is_distance(const Integer& given, const std::optional<Nearest<N>>& truth) {
    const Integer limit = whole(S::max().raw());
    if (!truth) return given == limit;
    if (given < 0) return false;
    const Integer reach = truth->radius + given;
    const auto& [over, under] = truth->core.squared;
    if (given > 0 && over < reach * reach * under) return false;
    return given == limit || over < (reach + 1) * (reach + 1) * under;
  }

  static bool is_closest(const Vec<S, N>& given, const Vec<S, N>& point,
                         const std::optional<Nearest<N>>& truth, bool inside) {
    if (!truth || (inside && truth->keeps_inside)) return given == point;
    const auto closest = raw(given), p = raw(point);
    const auto& core = truth->core;
    const Integer low = whole(S::lowest().raw()), high = whole(S::max().raw());
    Vector<N> v;
    for (std::size_t i = 0; i < v.size(); ++i) v[i] = p[i] * core.under - core.over[i];
    for (std::size_t i = 0; i < v.size(); ++i) {
      if (!truth->radius.is_zero()) {
        if (!is_rounded<N>(closest[i], core, i, truth->radius, v)) return false;
      } else {
        const Integer exact = nearest_quotient(core.over[i], core.under);
        if (closest[i] != std::clamp(exact, low, high)) return false;
      }
    }
    return true;
  }

  long asked_ = 0;
  long wrong_ = 0;
  std::ostringstream first_mistakes_;
};

/// How many cases an ordinary run asks in each space.
inline constexpr long point_cases = 50'000;

}  // namespace detent::oracle
