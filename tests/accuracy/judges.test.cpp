// SPDX-License-Identifier: MIT
#include <cmath>
#include <limits>

#include "accuracy/pair_cast.hpp"
#include "accuracy/pair_points.hpp"
#include "support/catch.hpp"

namespace detent::accuracy {
namespace {

using Number = Carrier;

Vec<Number, 3> at(int x, int y, int z) { return {Number(x), Number(y), Number(z)}; }
Sphere<Number, 3> ball(int x, int y, int z) { return {at(x, y, z), Number(1)}; }

Steps steps(double x) { return Exact::of(x).steps(distance_frac); }

}  // namespace

TEST_CASE("accuracy: closest points are judged by distances, in fixed point also by coordinates") {
  using Kind = Closest<kind::Sphere, kind::Aabb>;
  using Points = std::pair<Vec<Number, 3>, Vec<Number, 3>>;
  const Kind::Question question{ball(0, 0, 0), {at(3, -1, -1), at(5, 1, 1)}};
  const auto truth = Kind::truth(question, Number::frac);
  REQUIRE(truth.distance == steps(2));
  const auto judge = [&](const Points& answer, Inputs inputs = Inputs::own) {
    return truth.judge(answer, inputs);
  };

  const auto right = judge(Kind::answer(question));
  CHECK(right.is_hit);
  CHECK_FALSE(right.is_wrong);
  CHECK_FALSE(right.is_off);
  CHECK(right.error == 0.0);

  const Vec beyond{Number::from_raw(65537), Number(0), Number(0)};
  const auto off = judge({beyond, at(3, 0, 0)});
  CHECK_FALSE(off.is_wrong);
  CHECK(off.is_off);
  CHECK(off.error == 1.0);
  CHECK_FALSE(judge({beyond, at(3, 0, 0)}, Inputs::asked).is_off);

  // As far from each other as the shapes, but not on them.
  const auto beside = judge({at(1, 2, 0), at(3, 2, 0)});
  CHECK_FALSE(beside.is_wrong);
  CHECK(beside.is_off);
  CHECK(*beside.error == Approx((std::sqrt(5.0) - 1) * 65536));
  // On the shapes, but too far from each other.
  CHECK(*judge({at(-1, 0, 0), at(3, 0, 0)}).error == Approx(2 * 65536));

  const auto together = judge({at(1, 0, 0), at(1, 0, 0)});
  CHECK(together.is_wrong);
  CHECK_FALSE(together.error.has_value());
  const float nan = std::numeric_limits<float>::quiet_NaN();
  CHECK(truth.judge(std::pair{Vec{1.0f, 0.0f, 0.0f}, Vec{3.0f, nan, 0.0f}}, Inputs::own).is_wrong);
  CHECK_FALSE(
      truth.judge(std::pair{Vec{1.0f, 0.0f, 0.0f}, Vec{3.0f, 0.0f, 0.0f}}, Inputs::own).is_wrong);
}

TEST_CASE("accuracy: points of shapes that nearly touch may be rounded to one") {
  using Kind = Closest<kind::Sphere, kind::Aabb>;
  // The numbers of float at 2^14 are 2^-9 apart.
  const auto judged = [](int gap, float x) {
    const Vec corner{Number::from_raw((16384 << 16) - gap), Number(1), Number(1)};
    const Kind::Question question{ball(16385, 0, 0), {at(16300, -1, -1), corner}};
    return Kind::truth(question, Number::frac)
        .judge(std::pair{Vec{x, 0.0f, 0.0f}, Vec{x, 0.0f, 0.0f}}, Inputs::own);
  };
  CHECK(judged(1, 16384).is_hit);
  CHECK_FALSE(judged(1, 16384).is_wrong);
  CHECK(judged(1024, 16384).is_wrong);
}

TEST_CASE("accuracy: shapes that overlap have one closest point") {
  using Kind = Closest<kind::Sphere, kind::Aabb>;
  const Kind::Question question{ball(3, 0, 0), {at(3, -1, -1), at(5, 1, 1)}};
  const auto truth = Kind::truth(question, Number::frac);
  CHECK_FALSE(Kind::is_hit(truth));
  CHECK_FALSE(truth.judge(Kind::answer(question), Inputs::own).is_off);
  const auto apart = truth.judge(
      std::pair{at(3, 0, 0), Vec{Number(3), Number::from_raw(1), Number(0)}}, Inputs::own);
  CHECK(apart.is_wrong);
  CHECK(apart.is_off);
}

TEST_CASE("accuracy: the first touch is exact, wherever the search for it starts") {
  const auto sphere = ball(0, 0, 0);
  const Aabb<Number, 3> box{at(3, -1, -1), at(5, 1, 1)};
  const auto ahead = Direction<Number, 3>::along(0);
  const auto touch = [&](const Sphere<Number, 3>& moving, Number max_distance, double guess) {
    return first_touch(moving, ahead, max_distance, box, Number::frac, guess);
  };
  for (const double guess : {2.0, 1.75, 0.0, -3.0, 100.0, std::nextafter(2.0, 3.0),
                             std::numeric_limits<double>::infinity()}) {
    INFO(guess);
    CHECK(touch(sphere, Number(10), guess) == steps(2));
    CHECK(touch(sphere, Number(2), guess) == steps(2));
    CHECK_FALSE(touch(sphere, Number::from_raw(2 * 65536 - 1), guess).has_value());
    // Beside the face it touches the edge between y = 1 and a corner: 3 - sqrt(1 - 1 / 4).
    const Sphere<Number, 3> aside{{Number(0), Number::from_raw(3 * 32768), Number(0)}, Number(1)};
    const auto found = touch(aside, Number(10), guess);
    REQUIRE(found.has_value());
    CHECK(*found <= steps(3 - std::sqrt(0.75)) + 1);
    CHECK(*found >= steps(3 - std::sqrt(0.75)) - 1);
  }
  CHECK(touch(ball(4, 0, 0), Number(10), 1) == steps(0));
  CHECK_FALSE(touch(ball(0, 3, 0), Number(10), 1).has_value());
}

}  // namespace detent::accuracy
