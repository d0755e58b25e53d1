// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "bench/question.hpp"

namespace detent::bench {

/// The errors of a scalar's results. Decisions are compared with those of q16_16, lengths with
/// those in double, if these are within a step of q16_16's. Inputs that the scalar cannot represent
/// (directions in float and q8_8) count too.
struct Accuracy {
  std::size_t asked = 0;
  std::size_t wrong = 0;        // hit instead of miss, or the reverse
  double error = 0;             // the largest error of a distance or coordinate, in units
  std::size_t close_asked = 0;  // for shapes one step of 1/256 from touching or separating
  std::size_t close_wrong = 0;
};

namespace detail {

template <Scalar S>
double value_of(const S& x) {
  return static_cast<double>(x);
}

/// The components of a result that are lengths.
template <class Visit>
void visit_lengths(bool, const Visit&) {}
template <Scalar S, class Visit>
void visit_lengths(const S& distance, const Visit& visit) {
  visit(value_of(distance));
}
template <Scalar S, int N, class Visit>
void visit_lengths(const Vec<S, N>& point, const Visit& visit) {
  for (int i = 0; i < N; ++i) visit(value_of(point[i]));
}
template <Scalar S, int N, class Visit>
void visit_lengths(const RayHit<S, N>& hit, const Visit& visit) {
  visit(value_of(hit.distance));
}
template <Scalar S, class Visit>
void visit_lengths(const Interval<S>& interval, const Visit& visit) {
  visit(value_of(interval.enter));
  visit(value_of(interval.exit));
}
template <Scalar S, int N, class Visit>
void visit_lengths(const std::pair<Vec<S, N>, Vec<S, N>>& closest, const Visit& visit) {
  visit_lengths(closest.first, visit);
  visit_lengths(closest.second, visit);
}
template <Scalar S, int N, class Visit>
void visit_lengths(const Contact<S, N>& contact, const Visit& visit) {
  visit(value_of(contact.depth));
}
template <Scalar S, int N, class Visit>
void visit_lengths(const CastHit<S, N>& hit, const Visit& visit) {
  visit(value_of(hit.distance));
}
/// Those of a direction, which have no unit.
template <Scalar S, int N, class Visit>
void visit_lengths(const Ray<S, N>& ray, const Visit& visit) {
  for (int i = 0; i < N; ++i) visit(static_cast<double>(ray.direction[i]));
}
/// Screen coordinates or pixels.
template <Number T, Scalar S, class Visit>
void visit_lengths(const ScreenPoint<T, S>& point, const Visit& visit) {
  visit(value_of(point.x));
  visit(value_of(point.y));
}
template <Scalar S, class Visit>
void visit_lengths(const Impact<S>&, const Visit&) {}
template <class T, class Visit>
void visit_lengths(const std::optional<T>& answer, const Visit& visit) {
  if (answer) visit_lengths(*answer, visit);
}

template <class Answer>
std::vector<double> lengths_of(const Answer& answer) {
  std::vector<double> lengths;
  visit_lengths(answer, [&](double x) { lengths.push_back(x); });
  return lengths;
}

/// Replaces rounded lengths by the more precise ones of double.
inline void refine(std::vector<double>& rounded, const std::vector<double>& finer) {
  for (std::size_t i = 0; i < rounded.size() && rounded.size() == finer.size(); ++i) {
    if (std::abs(finer[i] - rounded[i]) * 65536 <= 1) rounded[i] = finer[i];
  }
}

/// Whether a type of results decides something: distances, points and rays do not. Impacts do, but
/// may report shapes that only come close.
template <class Answer>
inline constexpr bool decides = requires(const Answer& answer) {
  is_hit(answer);
}
&&!Scalar<Answer>;
template <Scalar S, int N>
inline constexpr bool decides<Ray<S, N>> = false;
template <Scalar S>
inline constexpr bool decides<std::optional<Impact<S>>> = false;

template <class S, class Q>
bool is_wrong(const Q& query, const typename Q::template Question<double>& drawn) {
  using Answer =
      decltype(query.template operator()<S>(std::declval<typename Q::template Question<S>>()));
  if constexpr (decides<Answer>) {
    const auto question = std::pair{as<S>(drawn.first), as<S>(drawn.second)};
    const auto exact = std::pair{as<q16_16>(drawn.first), as<q16_16>(drawn.second)};
    return hits<S>(query, question) != hits<q16_16>(query, exact);
  } else {
    return false;
  }
}

/// Moves the second shape of a hit until it misses, and visits the last hit and the first miss,
/// which are one step apart.
template <class Q, class Visit>
void visit_close_calls(const Q& query, const typename Q::template Question<double>& hit, int axis,
                       const Visit& visit) {
  const auto moved = [&](int steps) {
    auto question = hit;
    Vec<double, Q::dimension> offset;
    offset[axis] = steps * grid_step;
    move(question.second, offset);
    return question;
  };
  const auto is_hit_at = [&](int steps) {
    const auto question = moved(steps);
    return hits<q16_16>(query, std::pair{as<q16_16>(question.first), as<q16_16>(question.second)});
  };
  if (!is_hit_at(0)) return;
  int low = 0, high = 1;
  while (is_hit_at(high)) {
    low = high;
    high *= 2;
    if (high > 256 * 256) return;
  }
  while (high - low > 1) {
    const int middle = (low + high) / 2;
    (is_hit_at(middle) ? low : high) = middle;
  }
  visit(moved(low));
  visit(moved(high));
}

}  // namespace detail

template <class S, class Q>
Accuracy accuracy_of(const Q& query,
                     const std::vector<typename Q::template Question<double>>& drawn) {
  Accuracy result;
  int axis = 0;
  for (const auto& question : drawn) {
    const auto exact = query.template operator()<q16_16>(
        std::pair{as<q16_16>(question.first), as<q16_16>(question.second)});
    const auto answer =
        query.template operator()<S>(std::pair{as<S>(question.first), as<S>(question.second)});
    ++result.asked;
    result.wrong += detail::is_wrong<S>(query, question) ? 1u : 0u;
    auto truth = detail::lengths_of(exact);
    detail::refine(truth, detail::lengths_of(query.template operator()<double>(question)));
    const auto given = detail::lengths_of(answer);
    if (truth.size() == given.size()) {
      for (std::size_t i = 0; i < truth.size(); ++i) {
        result.error = std::max(result.error, std::abs(given[i] - truth[i]));
      }
    }
    using Exact = std::remove_cvref_t<decltype(exact)>;
    if constexpr (detail::decides<Exact>) {
      if (++axis % 8 != 0) continue;  // enough of them
      detail::visit_close_calls(query, question, axis / 8 % Q::dimension, [&](const auto& close) {
        ++result.close_asked;
        result.close_wrong += detail::is_wrong<S>(query, close) ? 1u : 0u;
      });
    }
  }
  return result;
}

}  // namespace detent::bench
