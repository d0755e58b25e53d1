// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <utility>

#include "accuracy/asking.hpp"
#include "detent/query/closest_points.hpp"
#include "oracle/closest_pair.hpp"

namespace detent::accuracy {

/// The exact closest points of two shapes, and how far given ones are from them.
///
/// Several pairs can be equally close, and rounding selects one of them: `float` may return another
/// pair than the documented one and be right. So the error of a pair is the greatest of three
/// lengths, which are 0 for every closest pair: how far each point is from its shape, and the
/// difference of the distance between the points from that of the shapes. A fixed scalar must
/// return the documented pair, rounded to nearest.
template <class A, class B, int N>
struct ClosestTruth {
  PairQuestion<A, B, Carrier> question;
  int frac;
  Steps distance;  // in steps of 2^-48, rounded down

  template <Scalar S>
  Judgement judge(const std::pair<Vec<S, N>, Vec<S, N>>& answer, Inputs inputs) const {
    Judgement result{distance > 0};
    if (!is_finite(answer.first) || !is_finite(answer.second)) {
      result.is_wrong = true;
      return result;
    }
    const bool are_apart = answer.first != answer.second;
    // The points of shapes that nearly touch can be rounded to one.
    result.is_wrong = are_apart ? distance == 0 : distance > one_step(answer.first);
    if constexpr (is_fixed<S>) result.is_off = inputs == Inputs::own && !is_rounded_pair(answer);
    if (result.is_hit && are_apart) result.error = error_of(answer);
    return result;
  }

  // The documented pair, once it is needed: it takes long.
  mutable std::optional<std::optional<oracle::ExactPair<N>>> pair{};

 private:
  template <Scalar S>
  static bool is_finite(const Vec<S, N>& point) {
    bool result = true;
    for (int i = 0; i < N; ++i) result = result && std::isfinite(static_cast<double>(point[i]));
    return result;
  }
  /// The length of a vector whose components are the spacing of the scalar's numbers at `point`.
  template <Scalar S>
  static Steps one_step(const Vec<S, N>& point) {
    double most = std::ldexp(1, -distance_frac);
    for (int i = 0; i < N; ++i) most = std::max(most, std::abs(static_cast<double>(point[i])));
    return Exact::of(spacing_near<S>(most) * std::sqrt(N)).steps(distance_frac);
  }

  template <Scalar S>
  bool is_rounded_pair(const std::pair<Vec<S, N>, Vec<S, N>>& answer) const {
    if (!pair) {
      const auto a = in_dimension<N>(question.a);
      const auto b = in_dimension<N>(question.b);
      pair = oracle::closest_pair<Carrier, N>(as_shape(a), as_shape(b));
    }
    if (!*pair) return false;
    const auto in_raw_units = [&](oracle::Exact<N> exact) {
      const auto power = [](int exponent) {
        return oracle::Rational(Steps(1) << static_cast<unsigned>(exponent));
      };
      const auto times = power(S::frac) / power(frac);
      for (auto& x : exact.point) x *= times;
      exact.radius *= times;
      return exact;
    };
    return oracle::is_rounded(in_raw_units((*pair)->first), answer.first) &&
           oracle::is_rounded(in_raw_units((*pair)->second), answer.second);
  }

  /// In units of 2^-16.
  template <Scalar S>
  double error_of(const std::pair<Vec<S, N>, Vec<S, N>>& answer) const {
    const auto in_steps_of_48 = [](const Vec<S, N>& point) {
      oracle::Vector<N> result;
      for (int i = 0; i < N; ++i) {
        result[static_cast<std::size_t>(i)] =
            Exact::of(static_cast<double>(point[i])).steps(distance_frac);
      }
      return result;
    };
    const auto p = in_steps_of_48(answer.first), q = in_steps_of_48(answer.second);
    const auto from = [&](const oracle::Vector<N>& point, const auto& shape) {
      // As a hull: the oracle then takes an OBB by its corners, as `closest_points` of two OBBs does,
      // not by the slabs of its axes, which are not exactly perpendicular.
      return *oracle::distance_floor(oracle::Solid<N>(oracle::Cloud<N>{{point}}),
                                     in_steps(in_dimension<N>(shape), frac));
    };
    const auto between = oracle::difference(q, p);
    const Steps length = sqrt(oracle::dot(between, between));
    const Steps most =
        std::max({Steps(abs(Steps(length - distance))), from(p, question.a), from(q, question.b)});
    return std::ldexp(static_cast<double>(most), 16 - distance_frac);
  }
};

/// The closest points of two shapes. A hit is a pair that is apart.
template <class A, class B, int N = 3>
struct Closest : Overlap<A, B, N> {
  using Question = typename Overlap<A, B, N>::Question;
  using Truth = ClosestTruth<A, B, N>;

  static Truth truth(const Question& q, int frac) {
    return {q, frac, distance_of(in_dimension<N>(q.a), in_dimension<N>(q.b), frac)};
  }
  static bool is_hit(const Truth& truth) { return truth.distance > 0; }
  template <class S>
  static std::pair<Vec<S, N>, Vec<S, N>> answer(const PairQuestion<A, B, S>& q) {
    const auto a = in_dimension<N>(q.a);
    const auto b = in_dimension<N>(q.b);
    return closest_points(as_shape(a), as_shape(b));
  }
};

}  // namespace detent::accuracy
