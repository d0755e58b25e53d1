// SPDX-License-Identifier: MIT
#include "accuracy/catalogue.hpp"
#include "accuracy/pair.hpp"
#include "detent/scene/mover.hpp"
#include "detent/scene/scene.hpp"

namespace detent::accuracy {
namespace {

constexpr int moves = 10;

/// A character on a floor among tilted boxes, and how far it wants to walk in each move.
template <Scalar S>
struct Walk {
  Vec<S, 3> home;  // the middle of the floor
  Aabb<S, 3> floor;
  std::array<Obb<S, 3>, 3> boxes;
  Capsule<S, 3> body;
  Vec<S, 3> by;
};

/// The walk with its home at the world's origin.
Walk<double> at_origin(Walk<double> walk) {
  walk.floor = {walk.floor.min - walk.home, walk.floor.max - walk.home};
  for (auto& box : walk.boxes) box.center -= walk.home;
  walk.body.a -= walk.home;
  walk.body.b -= walk.home;
  walk.home = {};
  return walk;
}

template <Scalar S>
using World = Scene<S, 3, Aabb, Obb>;

/// `step` along every axis, to a side that a bit of `sides` gives.
Vec<double, 3> to_sides(double step, int sides) {
  return make_vec<3>([&](int i) { return (sides >> i & 1) != 0 ? step : -step; });
}

/// A world in which the casts of a move are those of a coarse `Fixed`: each of a shape that is a
/// step thinner than the one before (detail::Stepper), and up to a step off along every axis.
struct Coarse : World<double> {
  Coarse(double of, int first) : step(of), corner(first) {}

  template <class Filter>
  auto nearest_hit(Cast<Capsule<double, 3>> way, const Filter& filter) const {
    const auto off = to_sides(step, corner + 3 * casts);
    way.shape.a += off;
    way.shape.b += off;
    way.shape.radius -= casts++ * step;
    return World<double>::nearest_hit(way, filter);
  }
  template <class Filter>
  auto nearest_hit(const Ray<double, 3>& ray, const Filter& filter) const {
    return World<double>::nearest_hit(ray, filter);
  }

  double step;
  int corner;
  mutable int casts = 0;  // in this move
};

/// Where the character's feet are after the moves in a world that is empty at first;
/// disturb(i, mover, world) is called before move i.
template <Scalar S, class In, class Disturb>
Vec<S, 3> end_of(const Walk<S>& walk, In world, const Disturb& disturb) {
  world.add(walk.floor, {.motion = Motion::fixed});
  for (const auto& box : walk.boxes) world.add(box, {.motion = Motion::fixed});
  Mover<S, 3, Capsule> mover{walk.body};
  MoverSettings<S, 3> settings;
  // Numbers of every scalar; the skin is the least one of q8_8.
  settings.skin = quotient_nearest<S>(S(1), S(8));
  settings.step_height = settings.snap_distance = quotient_nearest<S>(S(3), S(8));
  for (int i = 0; i < moves; ++i) {
    disturb(i, mover, world);
    mover.move(world, walk.by, settings);
  }
  return mover.shape.a;
}
template <Scalar S>
Vec<S, 3> end_of(const Walk<S>& walk) {
  return end_of(walk, World<S>(), [](int, const auto&, const auto&) {});
}

/// How far roundings may move a character in a walk: 8 steps of its scalar, and at least 1/256.
double tolerance(double step) { return std::max(std::ldexp(1, -8), 8 * step); }
/// By how many times more the end of a walk may differ; an answer is wrong if it is off by twice that.
constexpr double amplification = 4;

/// The step of the numbers of a question, or of the grid on which it is drawn if that is coarser.
double step_of(const Numbers& numbers, int frac) {
  Carrier::raw_type step = 1;
  while (numbers.nearest(Carrier::from_raw(step), frac).raw() != step) step *= 2;
  return std::ldexp(static_cast<double>(step), -frac);
}

double length(const Vec<double, 3>& v) { return std::sqrt(dot(v, v)); }

/// Whether another start, other positions before every move or coarser casts lead to another end,
/// such as the other side of a box. The start differs by up to `by` along each axis, the eighth
/// cast of a move is thinner by as much.
bool is_sensitive(const Walk<double>& walk, double by) {
  using Walker = Mover<double, 3, Capsule>;
  const auto end = end_of(walk);
  const auto is_other = [&](const Vec<double, 3>& other) {
    return length(other - end) > amplification * by;
  };
  const auto moved = [&](double step, bool every_move, int corner) {
    return end_of(walk, World<double>(), [&](int move, Walker& mover, const auto&) {
      if (move > 0 && !every_move) return;
      const auto off = to_sides(step, corner + 3 * move);
      mover.shape.a += off;
      mover.shape.b += off;
    });
  };
  const auto coarse = [&](double step, int corner) {
    return end_of(walk, Coarse(step, corner),
                  [](int, const Walker&, Coarse& world) { world.casts = 0; });
  };
  for (int corner = 0; corner < 8; ++corner) {
    if (is_other(moved(by, false, corner)) || is_other(moved(by / 16, false, corner)) ||
        is_other(moved(by / 4, true, corner)) || is_other(coarse(by / 8, corner))) {
      return true;
    }
  }
  return false;
}

/// Where a character ends. The reference is the same walk near the world's origin in double, whose
/// roundings are a billionth of those of q16_16 there. A hit is a walk that the boxes change.
struct WalkTruth {
  Vec<double, 3> end, home;
  bool is_changed;

  template <Scalar S>
  Judgement judge(const Vec<S, 3>& answer, Inputs) const {
    const double off = length(
        make_vec<3>([&](int i) { return static_cast<double>(answer[i]) - home[i] - end[i]; }));
    double step = 0;
    if constexpr (is_fixed<S>) step = std::ldexp(1, -S::frac);
    Judgement result{is_changed, !(off <= 2 * amplification * tolerance(step))};
    if (std::isfinite(off)) result.error = std::ldexp(off, 16);
    return result;
  }
};

struct Character : WithoutBaseline {
  using Question = Walk<Carrier>;
  using Truth = WalkTruth;

  template <class F, class S>
  static auto change(const F& f, const Walk<S>& walk) {
    Walk<decltype(f(S()))> result{changed(f, walk.home),
                                  changed(f, walk.floor),
                                  {},
                                  changed(f, walk.body),
                                  changed(f, walk.by)};
    for (std::size_t i = 0; i < walk.boxes.size(); ++i) {
      result.boxes[i] = changed(f, walk.boxes[i]);
    }
    return result;
  }
  static Question draw(test::Random& random, const Numbers& numbers, const Rung& rung) {
    const double by = tolerance(step_of(numbers, rung.frac));
    for (;;) {
      auto walk = change(Snapped{numbers, rung.frac}, draw_any(random, numbers, rung));
      if (!is_sensitive(at_origin(change(Rounded<double>{rung.frac}, walk)), by)) return walk;
    }
  }
  static Truth truth(const Question& q, int frac) {
    const auto walk = change(Rounded<double>{frac}, q);
    auto free = at_origin(walk);
    const auto end = end_of(free);
    for (auto& box : free.boxes) box.center.y -= 100;
    const auto off = end - end_of(free);
    return {end, walk.home, dot(off, off) > 1.0 / 256};
  }
  static bool is_hit(const Truth& truth) { return truth.is_changed; }
  template <class S>
  static Vec<S, 3> answer(const Walk<S>& walk) {
    return end_of(walk);
  }

 private:
  static Question draw_any(test::Random& random, const Numbers& numbers, const Rung& rung) {
    Stage stage(random, numbers, rung, false, false);
    const Place home = stage.center;
    const double unit = std::ldexp(1, rung.frac);
    const auto at = [&](double x, double y, double z) {
      return Stage::rounded({home[0] + x * unit, home[1] + y * unit, home[2] + z * unit});
    };
    const auto number = [&](double x) { return Stage::number(x * unit); };
    Question walk;
    walk.home = at(0, 0, 0);
    walk.floor = {at(-12, -2, -12), at(12, 0, 12)};
    for (auto& box : walk.boxes) {
      stage.turn();
      accuracy::draw(stage, box);
      box.center = at(stage.uniform(-4, 4), stage.uniform(-1, 1), stage.uniform(-4, 4));
    }
    const double height = stage.uniform(1.75, 2.25);
    walk.body = {at(0, height, 0), at(0, height + 1, 0), number(0.375)};
    const auto move = [&](double low, double high) { return number(stage.uniform(low, high)); };
    walk.by.x = move(-0.5, 0.5);
    walk.by.y = move(-0.3, -0.2);
    walk.by.z = move(-0.5, 0.5);
    return walk;
  }
};

}  // namespace

void add_movers(std::vector<Query>& queries) {
  queries.push_back({"mover", "mover/capsule", 32,
                     [](const Rung& rung) { return rung.ladder == Ladder::place; },
                     ask_all<Character>});
}

}  // namespace detent::accuracy
