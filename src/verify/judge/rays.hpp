// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "oracle/answer.hpp"
#include "oracle/crossing_round.hpp"
#include "verify/judge/exact.hpp"

namespace detent::verify::judge {

template <Scalar S, int N, class Shape>
bool is_hidden(const RayCase<S, N, Shape>&) {
  return false;
}
template <Scalar S, int N, class Shape>
requires requires(const Ray<S, N>& ray, const Shape& shape) { oracle::meets_front(ray, shape); }
bool is_hidden(const RayCase<S, N, Shape>& c) {
  return c.facing == Facing::front && !oracle::meets_front(c.ray, c.shape);
}

template <int N>
bool allows(const oracle::Normal<N>& normal, const oracle::Raw<N>& given) {
  if (const auto* sphere = dynamic_cast<const oracle::SphereNormal<N>*>(&normal)) {
    return sphere->within(given, normal_margin, 1000);
  }
  return normal.allows(given);
}

/// The correct normal next to a wrong one, for the report.
template <Scalar S, int N>
std::string normal_words(const oracle::Normal<N>& normal, const oracle::Raw<N>& given) {
  constexpr int reach = 4, side = 2 * reach + 1;
  int count = 1;
  for (int i = 0; i < N; ++i) count *= side;
  for (int code = 0; code < count; ++code) {
    auto candidate = given;
    int rest = code;
    for (auto& component : candidate) {
      component += rest % side - reach;
      rest /= side;
    }
    if (!allows(normal, candidate)) continue;
    Vec<direction_component<S>, N> v;
    for (int i = 0; i < N; ++i) {
      v[i] = clamped<direction_component<S>>(candidate[static_cast<std::size_t>(i)]);
    }
    return words(v);
  }
  return normal.text();
}

template <int Row, Scalar S, int N, class Shape, class Answer>
std::optional<Wrong> judge(const RayCase<S, N, Shape>& c, const Answer& got) {
  const auto shape = in_raw_units<S>(c.shape);
  const auto expected = oracle::expected_raycast(in_raw_units<S>(c.ray), as_shape(shape));
  if (!expected.hit || is_hidden(c)) return compare(Answer(), got);
  const auto& hit = *expected.hit;
  const S enter = clamped<S>(hit.enter);
  if constexpr (Row == 0) {
    return compare(Answer(enter), got);
  } else if constexpr (Row == 1) {
    Vec<S, N> point;
    for (int i = 0; i < N; ++i) point[i] = clamped<S>(hit.point[static_cast<std::size_t>(i)]);
    if (got && got->distance == enter && got->point == point &&
        allows(*hit.normal, oracle::raw(got->normal))) {
      return std::nullopt;
    }
    return Wrong{
        "distance " + words(enter) + ", point " + words(point) + ", normal " +
            (got ? normal_words<S>(*hit.normal, oracle::raw(got->normal)) : hit.normal->text()),
        words(got)};
  } else {
    return compare(Answer(Interval<S>{enter, clamped<S>(hit.exit)}), got);
  }
}

}  // namespace detent::verify::judge
