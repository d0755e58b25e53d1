// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "accuracy/first_hit.hpp"
#include "accuracy/stage.hpp"
#include "accuracy/survey.hpp"
#include "numbers.hpp"

namespace detent::accuracy {

/// The spacing of a scalar's numbers near `x`.
template <Scalar S>
double spacing_near(double x) {
  if constexpr (is_fixed<S>) {
    return std::ldexp(1, -S::frac);
  } else {
    return std::ldexp(1, std::ilogb(x) - (std::is_same_v<S, float> ? 23 : 52));
  }
}

/// Whether a rung fits the scalar's range, and its shapes are no smaller than the scalar's grid.
template <Scalar S>
bool fits(const Rung& rung) {
  return world_of<S>(rung.frac) >= std::min(rung.reach(), std::ldexp(1, 31 - rung.frac) - 1);
}
template <Scalar S>
bool resolves(const Rung& rung) {
  const double spacing = spacing_near<S>(rung.reach());
  if (rung.angle > 0) {
    if (is_fixed<S> && rung.angle < std::ldexp(1, -numbers<S>.direction_bits)) return false;
    if (rung.angle * rung.length < spacing / 256) return false;
  }
  return rung.size >= spacing;
}

/// How an answer compares with the exact one.
struct Judgement {
  bool is_hit = false;  // by the exact result
  bool is_wrong = false;
  bool is_off = false;            // for a `Fixed`: not the exact one, rounded
  std::optional<double> error{};  // in units of 2^-16; nothing if either is a miss
};

/// Counts right and wrong results.
template <Scalar S>
class Tally {
 public:
  Tally(Inputs inputs, std::string scalar) {
    cell_.inputs = inputs;
    cell_.scalar = std::move(scalar);
  }

  /// A distance, or nothing for a miss.
  void count(const Distance& right, const std::optional<S>& answer) {
    if constexpr (!is_fixed<S>) {
      if (answer && !std::isfinite(*answer)) {
        count(right.has_value(), !right.has_value());
        return;
      }
    }
    count(right.has_value(), answer.has_value());
    if (right && answer) measure(*right, *answer);
  }
  /// A distance, for which a hit is one greater than 0.
  void count(const Steps& right, const S& answer) {
    Steps rounded = right;
    if constexpr (is_fixed<S>) rounded = floor_steps(right);
    ++cell_.questions;
    if (right > 0) ++cell_.hits;
    if ((rounded > 0) != (answer > 0)) ++cell_.wrong;
    if (rounded > 0 && answer > 0 && std::isfinite(static_cast<double>(answer))) {
      measure(right, answer);
    }
  }
  /// A depth, or nothing for shapes that are apart.
  template <int N>
  void count(const Depth& right, const std::optional<Contact<S, N>>& answer) {
    bool is_finite = true;
    if constexpr (!is_fixed<S>) is_finite = !answer || std::isfinite(answer->depth);
    count(right.steps.has_value(), is_finite ? answer.has_value() : !right.steps.has_value());
    if (!right.steps || !answer || !is_finite) return;
    if constexpr (is_fixed<S>) {
      const Steps most = Steps(static_cast<std::int64_t>(S::max().raw()));
      constexpr auto finer = static_cast<unsigned>(distance_frac - S::frac);
      const Steps rounded = floor_steps(*right.steps + ((Steps(1) << finer) - 1));
      if (rounded > most) {  // clamped to the range
        if (answer->depth != S::max()) ++cell_.off;
        return;
      }
      if (cell_.inputs == Inputs::own && rounded != raw_of(answer->depth)) ++cell_.off;
    }
    errors_.push_back(error_of(*right.steps, answer->depth));
  }
  /// A result that is compared by its exact one.
  template <class Truth, class Answer>
  requires requires(const Truth& right, const Answer& answer) { right.judge(answer, Inputs()); }
  void count(const Truth& right, const Answer& answer) {
    const Judgement judgement = right.judge(answer, cell_.inputs);
    ++cell_.questions;
    if (judgement.is_hit) ++cell_.hits;
    if (judgement.is_wrong) ++cell_.wrong;
    if (judgement.is_off) ++cell_.off;
    if (judgement.error) errors_.push_back(*judgement.error);
  }
  void count(bool right, bool answer) {
    ++cell_.questions;
    if (right) ++cell_.hits;
    if (right != answer) ++cell_.wrong;
  }

  Cell cell() {
    if (errors_.empty()) return cell_;
    const auto middle = errors_.begin() + static_cast<std::ptrdiff_t>(errors_.size() / 2);
    std::nth_element(errors_.begin(), middle, errors_.end());
    cell_.median = *middle;
    cell_.largest = *std::max_element(middle, errors_.end());
    return cell_;
  }

 private:
  static Steps floor_steps(const Steps& right) {
    return right >> static_cast<unsigned>(distance_frac - S::frac);
  }
  static std::int64_t raw_of(const S& x) { return x.raw(); }
  /// In units of 2^-16.
  static double error_of(const Steps& right, const S& answer) {
    const auto given = static_cast<double>(answer);
    constexpr int finer = 80;  // in steps of 2^-80, below the error of a double
    const Steps error = Exact::of(given).steps(finer) - (right << (finer - distance_frac));
    return std::ldexp(std::abs(static_cast<double>(error)), 16 - finer);
  }
  void measure(const Steps& right, const S& answer) {
    errors_.push_back(error_of(right, answer));
    if constexpr (is_fixed<S>) {
      if (cell_.inputs == Inputs::asked) return;
      if (floor_steps(right) != raw_of(answer)) ++cell_.off;
    }
  }

  Cell cell_;
  std::vector<double> errors_;
};

/// The largest coordinate or length of a test case, in steps of its grid.
template <class Kind>
double most_of(const typename Kind::Question& question) {
  std::int64_t most = 0;
  Kind::change(Extent{most}, question);
  return static_cast<double>(most);
}

template <class Kind>
using Questions = std::vector<std::pair<typename Kind::Question, typename Kind::Truth>>;

/// Test cases of one rung, in numbers that the scalar can represent, with their exact results.
template <class Kind>
Questions<Kind> questions(const Numbers& numbers, const Rung& rung, long count,
                          std::uint64_t seed) {
  constexpr int patience = 20000;
  constexpr double last = 2147483392;  // the greatest float below 2^31
  test::Random random(seed);
  Questions<Kind> all;
  const double limit = std::min(std::ldexp(numbers.world(rung.frac), rung.frac), last);
  for (long i = 0; i < count; ++i) {
    const bool wants_hit = i % 2 == 0;
    for (int tries = 0;; ++tries) {
      auto question = Kind::draw(random, numbers, rung);
      if (most_of<Kind>(question) > limit && tries < patience) continue;
      question = Kind::change(Snapped{numbers, rung.frac}, question);
      auto truth = Kind::truth(question, rung.frac);
      if (Kind::is_hit(truth) != wants_hit && tries < patience) continue;
      all.emplace_back(std::move(question), std::move(truth));
      break;
    }
  }
  return all;
}

template <class Kind, Scalar S>
Cell answered(const Questions<Kind>& all, const Rung& rung, Inputs inputs) {
  Tally<S> tally(inputs, std::string(cli::scalar_name<S>));
  for (const auto& [question, truth] : all) {
    if (most_of<Kind>(question) > std::ldexp(world_of<S>(rung.frac), rung.frac)) continue;
    tally.count(truth, Kind::answer(Kind::change(Rounded<S>{rung.frac}, question)));
  }
  return tally.cell();
}

/// The rung adapted to a scalar: the range of q8_8 is too small for the angle ladder.
template <Scalar S>
Rung rung_for(Rung rung) {
  if (rung.ladder == Ladder::angle && !fits<S>(rung)) {
    rung.size = 14;
    rung.length = 60;
  }
  return rung;
}

/// Adds the scalars that have their own grid; `asked` are the test cases shared by all.
template <class Kind, Scalar S>
void add_cells(std::vector<Cell>& cells, const Questions<Kind>& asked, const Rung& given,
               long count, std::uint64_t seed) {
  const Rung rung = rung_for<S>(given);
  if (fits<S>(rung) && resolves<S>(rung)) {
    const auto own = questions<Kind>(numbers<S>, rung, count, seed);
    cells.push_back(answered<Kind, S>(own, rung, Inputs::own));
    Kind::template add_baseline<S>(cells, own, rung, Inputs::own);
  }
  if (fits<S>(given)) {
    cells.push_back(answered<Kind, S>(asked, given, Inputs::asked));
    Kind::template add_baseline<S>(cells, asked, given, Inputs::asked);
  }
}

template <class Kind>
std::vector<Cell> ask_all(const Rung& rung, long count, std::uint64_t seed) {
  std::vector<Cell> cells;
  if (rung.frac == q16_16::frac) {
    const auto all = questions<Kind>(numbers<q16_16>, rung, count, seed);
    cells.push_back(answered<Kind, q16_16>(all, rung, Inputs::own));
    if (fits<q14_16>(rung)) cells.push_back(answered<Kind, q14_16>(all, rung, Inputs::own));
    cells.push_back(answered<Kind, double>(all, rung, Inputs::own));
    add_cells<Kind, q24_8>(cells, all, rung, count, seed);
    add_cells<Kind, q8_8>(cells, all, rung, count, seed);
    add_cells<Kind, float>(cells, all, rung, count, seed);
  } else {
    const auto all = questions<Kind>(numbers<q24_8>, rung, count, seed);
    cells.push_back(answered<Kind, q24_8>(all, rung, Inputs::own));
    cells.push_back(answered<Kind, double>(all, rung, Inputs::own));
    add_cells<Kind, float>(cells, all, rung, count, seed);
  }
  return cells;
}

/// A sphere has no axes, so angles do not apply to it.
template <class Shape>
inline constexpr bool has_axes = !std::is_same_v<Shape, Sphere<Carrier, 3>>;
template <class Shape>
inline constexpr bool is_aligned = std::is_same_v<Shape, Aabb<Carrier, 3>>;

/// Whether a shape has no extent along the second axis of its stage.
template <class Shape, int N>
inline constexpr bool is_thin = form<Shape> == Form::endless ||
                                (N == 3 && form<Shape> == Form::surface);
template <Scalar S, int N>
inline constexpr bool is_thin<Segment<S, 3>, N> = true;

struct NoBaseline {
  template <class S, class All>
  static void add(std::vector<Cell>&, const All&, const Rung&, Inputs) {}
};

template <class Shape, Scalar S>
struct RayQuestion {
  Ray<S, 3> ray;
  typename Shape::template In<S> shape;
};

template <Scalar S>
Vec<S, 2> xy(const Vec<S, 3>& v) {
  return {v.x, v.y};
}
template <Scalar S>
Direction<S, 2> xy(const Direction<S, 3>& d) {
  return Direction<S, 2>::assume_unit({d[0], d[1]});
}

template <Scalar S>
S xy(const S& number) {
  return number;
}
template <Scalar S>
Rotation<S, 2> xy(const Rotation<S, 3>& rotation) {
  return Rotation<S, 2>::from_axes({xy(rotation.axis(0)), xy(rotation.axis(1))});
}

/// The 2D form of a 3D shape or ray with z = 0. The library is tested on the 2D form; the exact
/// results come from the 3D form, which has the same points in the plane z = 0.
template <support::Mappable Shape>
auto planar(const Shape& shape) {
  return support::mapped(shape, [](const auto& field) { return xy(field); });
}
template <Scalar S>
Points<S, 2> planar(const Points<S, 3>& hull) {
  Points<S, 2> result;
  for (std::size_t i = 0; i < hull.points.size(); ++i) result.points[i] = xy(hull.points[i]);
  return result;
}
template <int N, class Shape>
auto in_dimension(const Shape& shape) {
  if constexpr (N == 2) {
    return planar(shape);
  } else {
    return shape;
  }
}

template <class Shape, class Baseline = NoBaseline, int N = 3>
struct Raycast {
  using Question = RayQuestion<Shape, Carrier>;
  using Truth = Distance;

  template <class F, class S>
  static auto change(const F& f, const RayQuestion<Shape, S>& q) {
    return RayQuestion<Shape, decltype(f(S()))>{changed(f, q.ray), changed(f, q.shape)};
  }
  static Question draw(test::Random& random, const Numbers& numbers, const Rung& rung) {
    using Drawn = decltype(Question::shape);
    Stage stage(random, numbers, rung, is_aligned<Drawn>, N == 2);
    Question question;
    constexpr bool is_filled = N == 2 && form<Drawn> == Form::surface;
    question.ray = draw_ray(stage, rung, is_filled ? Form::solid : form<Drawn>);
    accuracy::draw(stage, question.shape);
    return question;
  }
  static Truth truth(const Question& q, int frac) { return first_hit(q.ray, q.shape, frac); }
  static bool is_hit(const Truth& truth) { return truth.has_value(); }
  template <class S>
  static std::optional<S> answer(const RayQuestion<Shape, S>& q) {
    const auto shape = in_dimension<N>(q.shape);
    return raycast(in_dimension<N>(q.ray), as_shape(shape));
  }
  template <class S, class All>
  static void add_baseline(std::vector<Cell>& cells, const All& all, const Rung& rung,
                           Inputs inputs) {
    Baseline::template add<S>(cells, all, rung, inputs);
  }
};

template <class A, class B, Scalar S>
struct PairQuestion {
  typename A::template In<S> a;
  typename B::template In<S> b;
};

/// A kind of question with no other formula to compare with.
struct WithoutBaseline {
  template <class S, class All>
  static void add_baseline(std::vector<Cell>&, const All&, const Rung&, Inputs) {}
};

template <class A, class B, int N = 3>
struct Overlap : WithoutBaseline {
  using Question = PairQuestion<A, B, Carrier>;
  using Truth = bool;
  using DrawnA = decltype(Question::a);
  using DrawnB = decltype(Question::b);

  static constexpr bool has_angle =
      has_axes<DrawnA> && has_axes<DrawnB> && !(is_aligned<DrawnA> && is_aligned<DrawnB>);

  template <class F, class S>
  static auto change(const F& f, const PairQuestion<A, B, S>& q) {
    return PairQuestion<A, B, decltype(f(S()))>{changed(f, q.a), changed(f, q.b)};
  }
  static Question draw(test::Random& random, const Numbers& numbers, const Rung& rung) {
    Stage stage(random, numbers, rung, is_aligned<DrawnA> || is_aligned<DrawnB>, N == 2);
    Question question;
    // The lattice contains a plane through the world's origin, so that its offset is exact.
    const double far = stage.on_lattice() || random.coin() ? 1.34 : 4;
    constexpr bool are_thin = is_thin<DrawnA, N> && is_thin<DrawnB, N>;
    const double apart = rung.angle > 0 && are_thin ? far * rung.angle : far;
    const auto moved = stage.local({far, apart, far});
    accuracy::draw(stage, question.a);
    stage.center = stage.at(moved);
    rung.angle < 0 ? stage.turn() : stage.tilt(rung.angle);
    accuracy::draw(stage, question.b);
    return question;
  }
  static Truth truth(const Question& q, int) { return meet(q.a, q.b); }
  static bool is_hit(Truth truth) { return truth; }
  template <class S>
  static bool answer(const PairQuestion<A, B, S>& q) {
    const auto a = in_dimension<N>(q.a);
    const auto b = in_dimension<N>(q.b);
    if constexpr (std::is_same_v<A, kind::Segment>) {
      return intersects(a, as_shape(b));
    } else {
      return overlaps(as_shape(a), as_shape(b));
    }
  }
};

/// The distance between two shapes.
template <class A, class B, int N = 3>
struct Apart : Overlap<A, B, N> {
  using Question = typename Overlap<A, B, N>::Question;
  using Truth = Steps;

  static Truth truth(const Question& q, int frac) {
    return distance_of(in_dimension<N>(q.a), in_dimension<N>(q.b), frac);
  }
  static bool is_hit(const Truth& truth) { return truth > 0; }
  template <class S>
  static S answer(const PairQuestion<A, B, S>& q) {
    const auto a = in_dimension<N>(q.a);
    const auto b = in_dimension<N>(q.b);
    return distance(as_shape(a), as_shape(b));
  }
};

/// The contact of two shapes, judged by its depth.
template <class A, class B, int N = 3>
struct Touching : Overlap<A, B, N> {
  using Question = typename Overlap<A, B, N>::Question;
  using Truth = Depth;

  static Truth truth(const Question& q, int frac) {
    return depth_of(in_dimension<N>(q.a), in_dimension<N>(q.b), frac);
  }
  static bool is_hit(const Truth& truth) { return truth.steps.has_value(); }
  template <class S>
  static std::optional<Contact<S, N>> answer(const PairQuestion<A, B, S>& q) {
    const auto a = in_dimension<N>(q.a);
    const auto b = in_dimension<N>(q.b);
    return contact(as_shape(a), as_shape(b));
  }
};

}  // namespace detent::accuracy
