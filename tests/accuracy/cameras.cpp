// SPDX-License-Identifier: MIT
#include "accuracy/catalogue.hpp"
#include "accuracy/pair.hpp"
#include "detent/shape/camera.hpp"

namespace detent::accuracy {
namespace {

/// A camera whose lens has the slopes 1 and 1, so the point at screen coordinates x, y and depth d is
/// eye + d (x right + y up - back).
template <Scalar S>
struct Eye {
  Vec<S, 3> position;
  Rotation<S, 3> frame;

  [[nodiscard]] Camera<S> camera() const {
    return {{position, frame}, *Lens<S>::perspective(Angle<S>::turn(1, 4), S(1), S(1), S(100))};
  }
};
template <class F, Scalar S>
auto changed(const F& f, const Eye<S>& eye) {
  return Eye<decltype(f(S()))>{changed(f, eye.position), changed(f, eye.frame)};
}

Rotation<Carrier, 3> frame_of(const Stage& stage) {
  return Rotation<Carrier, 3>::from_axes({stage.axis(0), stage.axis(1), stage.axis(2)});
}
/// A scene at the length of a rung from the world's origin, along `ahead`.
void move_away(Stage& stage, const Rung& rung, const Place& ahead) {
  if (rung.ladder != Ladder::distance) return;
  stage.center = plus(stage.center, ahead, std::ldexp(rung.length, rung.frac));
}

using Vector = oracle::Vector<3>;

Vector exact_of(const Vec<Carrier, 3>& v) { return {v.x.raw(), v.y.raw(), v.z.raw()}; }
Vector exact_of(const CarriedDirection& d) { return {d[0].raw(), d[1].raw(), d[2].raw()}; }
/// x * 2^bits.
Steps finer(const Steps& x, int bits) { return x * (Steps(1) << static_cast<unsigned>(bits)); }
double real(const Steps& x) { return static_cast<double>(x); }

/// The screen coordinates and the depth of a point: right / depth, up / depth, and
/// 2^direction_frac depth / whole, in steps of 2^-frac.
struct ScreenTruth {
  Steps right, up, depth, whole;
  int frac;

  [[nodiscard]] bool is_seen() const { return depth > 0; }

  template <Scalar S>
  Judgement judge(const std::optional<ScreenPoint<S, S>>& answer, Inputs inputs) const {
    Judgement result{is_seen(), answer.has_value() != is_seen()};
    if (!answer || !is_seen()) return result;
    const auto x = static_cast<double>(answer->x), y = static_cast<double>(answer->y);
    if (!std::isfinite(x) || !std::isfinite(y)) {
      result.is_wrong = true;
      return result;
    }
    result.error = std::max(error_of(x, right), error_of(y, up));
    if constexpr (is_fixed<S>) {
      const int longer = std::max(0, S::frac - frac), shorter = std::max(0, frac - S::frac);
      result.is_off =
          inputs == Inputs::own &&
          !(is_nearest(answer->x, right, depth) && is_nearest(answer->y, up, depth) &&
            is_nearest_raw<S>(answer->depth.raw(), finer(depth, longer + direction_frac),
                              finer(whole, shorter)));
    }
    return result;
  }

 private:
  /// In units of 2^-16.
  [[nodiscard]] double error_of(double given, const Steps& numerator) const {
    constexpr int bits = 80;
    const Steps error = Exact::of(given).steps(bits) * depth - finer(numerator, bits);
    return std::ldexp(std::abs(real(error)) / real(depth), 16 - bits);
  }
  template <Scalar S>
  static bool is_nearest(const S& given, const Steps& n, const Steps& d) {
    return is_nearest_raw<S>(given.raw(), finer(n, S::frac), d);
  }
  /// Whether `given` is n / d > 0, rounded to nearest and clamped.
  template <Scalar S>
  static bool is_nearest_raw(std::int64_t given, const Steps& n, const Steps& d) {
    const Steps twice = 2 * n, low = (2 * Steps(given) - 1) * d, high = (2 * Steps(given) + 1) * d;
    const bool is_least = given <= -S::max().raw(), is_most = given == S::max().raw();
    const bool is_even = given % 2 == 0;
    return (is_least || twice > low || (is_even && twice == low)) &&
           (is_most || twice < high || (is_even && twice == high));
  }
};

/// Where a camera sees a point. A hit is a point in front of it.
struct Project : WithoutBaseline {
  template <Scalar S>
  struct Asked {
    Eye<S> eye;
    Vec<S, 3> point;
  };
  using Question = Asked<Carrier>;
  using Truth = ScreenTruth;

  template <class F, class S>
  static auto change(const F& f, const Asked<S>& q) {
    return Asked<decltype(f(S()))>{changed(f, q.eye), changed(f, q.point)};
  }
  static Question draw(test::Random& random, const Numbers& numbers, const Rung& rung) {
    Stage stage(random, numbers, rung, false, false);
    const double length = std::ldexp(rung.length, rung.frac);
    const Place back = components(stage.axis(2));
    const double ahead = random.coin() ? -1 : 1;
    move_away(stage, rung, plus({}, back, ahead));
    Place point = stage.center;
    for (int i = 0; i < 2; ++i) {
      point = plus(point, components(stage.axis(static_cast<std::size_t>(i))),
                   length * stage.uniform(-0.9, 0.9));
    }
    return {{Stage::rounded(plus(stage.center, back, -ahead * length)), frame_of(stage)},
            Stage::rounded(point)};
  }
  static Truth truth(const Question& q, int frac) {
    const auto a = exact_of(q.eye.frame.axis(0)), b = exact_of(q.eye.frame.axis(1)),
               c = exact_of(q.eye.frame.axis(2));
    const auto offset = oracle::difference(exact_of(q.point), exact_of(q.eye.position));
    return {oracle::dot(offset, oracle::cross(b, c)), oracle::dot(a, oracle::cross(offset, c)),
            -oracle::dot(a, oracle::cross(b, offset)), oracle::dot(a, oracle::cross(b, c)), frac};
  }
  static bool is_hit(const Truth& truth) { return truth.is_seen(); }
  template <class S>
  static std::optional<ScreenPoint<S, S>> answer(const Asked<S>& q) {
    return project(q.eye.camera(), q.point);
  }
};

/// The ray of a pixel, and a ball that it may hit.
struct PickTruth {
  Vector along;    // of any length
  Vector to_ball;  // from the eye, in steps of 2^-frac
  Steps radius;
  int frac;

  [[nodiscard]] bool is_hit_by(const Vector& direction) const {
    const auto beside = oracle::cross(to_ball, direction);
    return oracle::dot(to_ball, to_ball) <= radius * radius ||
           (oracle::dot(to_ball, direction) > 0 &&
            oracle::dot(beside, beside) <= radius * radius * oracle::dot(direction, direction));
  }

  /// How far the ray passes from the point that it should meet, at the distance of the ball.
  template <Scalar S>
  Judgement judge(const Ray<S, 3>& ray, Inputs inputs) const {
    Judgement result{is_hit_by(along)};
    Vector given;
    for (int i = 0; i < 3; ++i) {
      const auto component = static_cast<double>(ray.direction[i]);
      if (!std::isfinite(component)) {
        result.is_wrong = true;
        return result;
      }
      given[static_cast<std::size_t>(i)] = Exact::of(component).steps(direction_frac + 50);
    }
    bool is_right = false;
    if constexpr (is_fixed<S>) {
      is_right = is_nearest_unit(ray.direction);
      result.is_off = inputs == Inputs::own && !is_right;
    }
    result.is_wrong = !is_right && is_hit_by(given) != result.is_hit;
    const auto turned = oracle::cross(along, given);
    const double sine =
        std::sqrt(real(oracle::dot(turned, turned)) / real(oracle::dot(along, along)) /
                  real(oracle::dot(given, given)));
    if (result.is_hit) {
      result.error = std::ldexp(sine * std::sqrt(real(oracle::dot(to_ball, to_ball))), 16 - frac);
    }
    return result;
  }

 private:
  /// Whether each component is that of `along` / |along|, rounded to nearest.
  template <Scalar S>
  bool is_nearest_unit(const Direction<S, 3>& unit) const {
    constexpr int bits = direction_component<S>::frac;
    const Steps squared = oracle::dot(along, along);
    for (std::size_t i = 0; i < 3; ++i) {
      const std::int64_t raw = unit[static_cast<int>(i)].raw();
      if (raw != 0 && (raw < 0) != (along[i] < 0)) return false;
      const Steps size = std::abs(raw), low = 2 * size - 1, high = 2 * size + 1;
      const Steps twice = finer(along[i] * along[i], 2 * bits + 2);
      if (size > 0 && twice < low * low * squared) return false;
      if (twice > high * high * squared) return false;
    }
    return true;
  }
};

/// The ray under the mouse. A hit is one that meets a ball. For a `Fixed`, the ray with the exact
/// direction, rounded to nearest, is right, even if the rounding decides.
struct Pick : WithoutBaseline {
  template <Scalar S>
  struct Asked {
    Eye<S> eye;
    S x, y;
    Sphere<S, 3> ball;
  };
  using Question = Asked<Carrier>;
  using Truth = PickTruth;

  template <class F, class S>
  static auto change(const F& f, const Asked<S>& q) {
    return Asked<decltype(f(S()))>{changed(f, q.eye), f(q.x), f(q.y), changed(f, q.ball)};
  }
  static Question draw(test::Random& random, const Numbers& numbers, const Rung& rung) {
    Stage stage(random, numbers, rung, false, false);
    const auto coordinate = [&] {
      return numbers.nearest(Stage::number(std::ldexp(stage.uniform(-1, 1), rung.frac)), rung.frac);
    };
    const auto x = coordinate(), y = coordinate();
    const Place right = components(stage.axis(0)), up = components(stage.axis(1)),
                back = components(stage.axis(2));
    const Place ahead = unit(plus(
        plus(plus({}, right, std::ldexp(x.raw(), -rung.frac)), up, std::ldexp(y.raw(), -rung.frac)),
        back, -1));
    move_away(stage, rung, ahead);
    const auto target = stage.at(stage.local({1.4, 1.4, 1.4}));
    Question question{
        {Stage::rounded(plus(target, ahead, -std::ldexp(rung.length, rung.frac))), frame_of(stage)},
        x,
        y,
        {}};
    accuracy::draw(stage, question.ball);
    return question;
  }
  static Truth truth(const Question& q, int frac) {
    const auto right = exact_of(q.eye.frame.axis(0)), up = exact_of(q.eye.frame.axis(1)),
               back = exact_of(q.eye.frame.axis(2));
    Truth truth{{},
                oracle::difference(exact_of(q.ball.center), exact_of(q.eye.position)),
                q.ball.radius.raw(),
                frac};
    for (std::size_t i = 0; i < 3; ++i) {
      truth.along[i] = q.x.raw() * right[i] + q.y.raw() * up[i] - finer(back[i], frac);
    }
    return truth;
  }
  static bool is_hit(const Truth& truth) { return truth.is_hit_by(truth.along); }
  template <class S>
  static Ray<S, 3> answer(const Asked<S>& q) {
    return pick_ray(q.eye.camera(), q.x, q.y);
  }
};

}  // namespace

void add_cameras(std::vector<Query>& queries) {
  const auto is_apart = [](const Rung& rung) {
    return rung.angle < 0 && !(rung.ladder == Ladder::distance && rung.length < 1);
  };
  queries.push_back({"pick_ray", "pick_ray/sphere", 4, is_apart, ask_all<Pick>});
  queries.push_back(
      {"project", "project/point", 4,
       [is_apart](const Rung& rung) { return is_apart(rung) && rung.ladder != Ladder::size; },
       ask_all<Project>});
}

}  // namespace detent::accuracy
