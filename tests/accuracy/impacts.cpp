// SPDX-License-Identifier: MIT
#include "accuracy/catalogue.hpp"
#include "accuracy/pair.hpp"
#include "detent/query/time_of_impact.hpp"

namespace detent::accuracy {
namespace {

/// A ball that moves from its center to `end`, in the time from 0 to 1.
template <Scalar S>
struct Flying {
  Sphere<S, 3> ball;
  Vec<S, 3> end;
};

using Vector = oracle::Vector<3>;

/// When two flying balls touch: their centers are apart by offset + t velocity, in steps of 2^-frac.
struct ImpactTruth {
  Vector offset, velocity;
  Steps reach;  // the sum of the radii
  int frac;

  [[nodiscard]] bool touch() const { return come_within(reach); }

  /// In fixed point, balls that pass within the documented distance may touch. An answer is wrong
  /// if it reports others, or misses balls that touch.
  template <Scalar S>
  Judgement judge(const std::optional<Impact<S>>& answer, Inputs inputs) const {
    Judgement result{touch()};
    const bool ends_early = answer && !answer->is_hit;
    if (ends_early || answer.has_value() != result.is_hit) {
      result.is_wrong = ends_early || !answer || !come_within(reach + allowed<S>());
      return result;
    }
    if (!answer) return result;
    const auto time = static_cast<double>(answer->time);
    if (!std::isfinite(time)) {
      result.is_wrong = true;
      return result;
    }
    const double gap = gap_at(time);
    result.error = std::ldexp(std::abs(gap), 16 - frac);
    if constexpr (is_fixed<S>) {
      const bool is_early = time > 0 && gap < 0;
      result.is_off =
          inputs == Inputs::own && (is_early || gap > static_cast<double>(allowed<S>()));
    }
    if (time == 0 && gap <= 0) result.error = 0;
    return result;
  }

 private:
  /// The greatest documented distance at the time of an impact, in steps: 10 units, and how far the
  /// balls travel in one unit of time. That of `float` is measured by the units of q16_16.
  template <Scalar S>
  [[nodiscard]] Steps allowed() const {
    const int unit = frac - fraction_bits<S>();
    const double travel = std::sqrt(static_cast<double>(oracle::dot(velocity, velocity)));
    const int time_bits = is_fixed<S> ? numbers<S>.direction_bits : direction_frac;
    return Steps(static_cast<std::int64_t>(
        std::ceil(std::ldexp(10, unit) + std::ldexp(travel, -time_bits))));
  }
  template <Scalar S>
  static constexpr int fraction_bits() {
    if constexpr (is_fixed<S>) {
      return S::frac;
    } else {
      return 16;
    }
  }

  /// Whether |offset + t velocity| <= distance for a t in [0, 1]: at an end, or at the least value
  /// between, where t = -(offset velocity) / velocity^2.
  [[nodiscard]] bool come_within(const Steps& distance) const {
    const Steps limit = distance * distance, vv = oracle::dot(velocity, velocity),
                pv = oracle::dot(offset, velocity);
    if (oracle::dot(offset, offset) <= limit) return true;
    Vector end = offset;
    for (std::size_t i = 0; i < 3; ++i) end[i] += velocity[i];
    if (oracle::dot(end, end) <= limit) return true;
    return pv < 0 && -pv < vv && oracle::dot(offset, offset) * vv - pv * pv <= limit * vv;
  }
  /// The distance between the balls at a time, in steps; negative if they overlap.
  [[nodiscard]] double gap_at(double time) const {
    constexpr int bits = 60;
    const Steps one = Steps(1) << static_cast<unsigned>(bits);
    const Steps t = Exact::of(time).steps(bits);
    Vector at = offset;
    for (std::size_t i = 0; i < 3; ++i) at[i] = offset[i] * one + velocity[i] * t;
    const Steps distance = sqrt(oracle::dot(at, at)) - reach * one;
    return std::ldexp(static_cast<double>(distance), -bits);
  }
};

struct Impacts : WithoutBaseline {
  template <Scalar S>
  struct Asked {
    Flying<S> a, b;
  };
  using Question = Asked<Carrier>;
  using Truth = ImpactTruth;

  template <class F, class S>
  static auto change(const F& f, const Asked<S>& q) {
    const auto flying = [&](const Flying<S>& body) {
      return Flying<decltype(f(S()))>{changed(f, body.ball), changed(f, body.end)};
    };
    return Asked<decltype(f(S()))>{flying(q.a), flying(q.b)};
  }
  /// The first ball flies to the second one, and up to three sizes past it.
  static Question draw(test::Random& random, const Numbers& numbers, const Rung& rung) {
    Stage stage(random, numbers, rung, false, false);
    const auto way = draw_ray(stage, rung, Form::solid, 2);
    Question question;
    draw_ball(stage, question.a, {});
    draw_ball(stage, question.b, stage.local({0.5, 0.5, 0.5}));
    const double length = std::ldexp(rung.length + rung.size * stage.uniform(0, 3), rung.frac);
    question.a.ball.center = way.origin;
    Place start;
    for (std::size_t i = 0; i < 3; ++i) start[i] = way.origin[static_cast<int>(i)].raw();
    question.a.end = Stage::rounded(plus(start, components(way.direction), length));
    return question;
  }
  static Truth truth(const Question& q, int frac) {
    Truth truth{{}, {}, Steps(q.a.ball.radius.raw()) + q.b.ball.radius.raw(), frac};
    for (int i = 0; i < 3; ++i) {
      const auto from = Steps(q.b.ball.center[i].raw()) - q.a.ball.center[i].raw();
      const auto to = Steps(q.b.end[i].raw()) - q.a.end[i].raw();
      truth.offset[static_cast<std::size_t>(i)] = from;
      truth.velocity[static_cast<std::size_t>(i)] = to - from;
    }
    return truth;
  }
  static bool is_hit(const Truth& truth) { return truth.touch(); }
  template <class S>
  static std::optional<Impact<S>> answer(const Asked<S>& q) {
    const auto ball = [](const Flying<S>& body) { return Sphere<S, 3>{{}, body.ball.radius}; };
    const auto sweep = [](const Flying<S>& body) {
      return Sweep<S, 3>{body.ball.center, body.end};
    };
    return time_of_impact(ball(q.a), sweep(q.a), ball(q.b), sweep(q.b));
  }

 private:
  static void draw_ball(Stage& stage, Flying<Carrier>& body, const Place& by) {
    accuracy::draw(stage, body.ball);
    body.end = stage.corner(by);
  }
};

}  // namespace

void add_impacts(std::vector<Query>& queries) {
  queries.push_back({"time_of_impact", "time_of_impact/sphere_sphere", 4,
                     [](const Rung& rung) { return rung.angle < 0; }, ask_all<Impacts>});
}

}  // namespace detent::accuracy
