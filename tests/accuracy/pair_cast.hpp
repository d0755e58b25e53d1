// SPDX-License-Identifier: MIT
#pragma once

#include <limits>
#include <optional>

#include "accuracy/asking.hpp"
#include "detent/query/cast.hpp"

namespace detent::accuracy {

template <class A, class B, Scalar S>
struct CastQuestion {
  typename A::template In<S> shape;
  Direction<S, 3> direction;
  S max_distance;
  typename B::template In<S> target;
};

/// A moving shape against a solid one, judged by the distance.
template <class A, class B, int N = 3>
struct Casting : WithoutBaseline {
  using Question = CastQuestion<A, B, Carrier>;
  using Truth = Distance;

  template <class F, class S>
  static auto change(const F& f, const CastQuestion<A, B, S>& q) {
    return CastQuestion<A, B, decltype(f(S()))>{changed(f, q.shape), f(q.direction),
                                                f(q.max_distance), changed(f, q.target)};
  }
  static Question draw(test::Random& random, const Numbers& numbers, const Rung& rung) {
    using Moving = decltype(Question::shape);
    using Target = decltype(Question::target);
    Stage stage(random, numbers, rung, is_aligned<Moving> || is_aligned<Target>, N == 2);
    const auto way = draw_ray(stage, rung, Form::solid, 2);
    Question question;
    question.direction = way.direction;
    question.max_distance = way.max_distance;
    accuracy::draw(stage, question.target);
    for (int i = 0; i < 3; ++i) stage.center[static_cast<std::size_t>(i)] = way.origin[i].raw();
    rung.angle < 0 ? stage.turn() : stage.tilt(rung.angle);
    accuracy::draw(stage, question.shape);
    return question;
  }
  static Truth truth(const Question& q, int frac) {
    const auto guess = answer(change(Rounded<double>{frac}, q));
    return first_touch(in_dimension<N>(q.shape), in_plane(q.direction), q.max_distance,
                       in_dimension<N>(q.target), frac,
                       guess ? *guess : std::numeric_limits<double>::infinity());
  }
  static bool is_hit(const Truth& truth) { return truth.has_value(); }
  template <class S>
  static std::optional<S> answer(const CastQuestion<A, B, S>& q) {
    const auto shape = in_dimension<N>(q.shape);
    const auto target = in_dimension<N>(q.target);
    const auto hit = cast(as_shape(shape), in_plane(q.direction), q.max_distance, as_shape(target));
    return hit ? std::optional(hit->distance) : std::nullopt;
  }

 private:
  template <Scalar S>
  static auto in_plane(const Direction<S, 3>& direction) {
    if constexpr (N == 2) {
      return xy(direction);
    } else {
      return direction;
    }
  }
};

}  // namespace detent::accuracy
