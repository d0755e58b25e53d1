// SPDX-License-Identifier: MIT
#include "oracle/ray_exam.hpp"

namespace detent::oracle {
namespace {

constexpr std::int64_t unit = 65536;
constexpr std::int64_t one = std::int64_t{1} << 30;
using D = Draw<q16_16, 3>;

/// The result that the comparison accepts, for an exact or correctly rounded normal.
Given<3> right(const Expected<3>& expected, const Raw<3>& normal) {
  const auto& hit = expected.hit.value();
  return {hit.enter, Given<3>::Hit{hit.enter, hit.point, normal}, std::pair{hit.enter, hit.exit}};
}

/// Changes every number of a right result by one raw unit, and removes every part of it: the
/// comparison must notice each change.
void reject_all_but(const Expected<3>& expected, const Given<3>& given, std::int64_t normal_step) {
  CHECK(mistakes(expected, given).empty());
  for (const std::int64_t step : {-1, 1}) {
    auto wrong = given;
    *wrong.distance += step;
    CHECK_FALSE(mistakes(expected, wrong).empty());
    wrong = given;
    wrong.hit->distance += step;
    CHECK_FALSE(mistakes(expected, wrong).empty());
    wrong = given;
    wrong.interval = std::pair{expected.hit->enter + step, expected.hit->exit};
    CHECK_FALSE(mistakes(expected, wrong).empty());
    wrong = given;
    wrong.interval = std::pair{expected.hit->enter, expected.hit->exit + step};
    CHECK_FALSE(mistakes(expected, wrong).empty());
    for (std::size_t i = 0; i < 3; ++i) {
      wrong = given;
      wrong.hit->point[i] += step;
      CHECK_FALSE(mistakes(expected, wrong).empty());
      wrong = given;
      wrong.hit->normal[i] += step * normal_step;
      CHECK_FALSE(mistakes(expected, wrong).empty());
    }
  }
  auto wrong = given;
  wrong.distance.reset();
  CHECK_FALSE(mistakes(expected, wrong).empty());
  wrong = given;
  wrong.hit.reset();
  CHECK_FALSE(mistakes(expected, wrong).empty());
  wrong = given;
  wrong.interval.reset();
  CHECK_FALSE(mistakes(expected, wrong).empty());
  wrong = given;
  wrong.hit->normal = negated(wrong.hit->normal);
  CHECK_FALSE(mistakes(expected, wrong).empty());
  CHECK_FALSE(mistakes(expected, {}).empty());
}

Ray<q16_16, 3> upwards(std::int64_t x, std::int64_t y, std::int64_t z) {
  return {D::vec({x, y, z}), D::direction({0, 0, one}), q16_16::max()};
}

TEST_CASE("oracle: it rejects any answer that is off by one raw unit", "[oracle]") {
  SECTION("box, with a stored normal") {
    const Aabb<q16_16, 3> box{D::vec({-7, -7, 100}), D::vec({7, 7, 200})};
    const auto expected = expected_raycast(upwards(1, 2, -3), box);
    REQUIRE(expected.hit.has_value());
    CHECK(expected.hit->enter == 103);
    CHECK(expected.hit->exit == 203);
    CHECK(expected.hit->point == Raw<3>{1, 2, 100});
    reject_all_but(expected, right(expected, {0, 0, -one}), 1);
  }
  SECTION("triangle, with a normalised normal") {
    // The normal is along (1, 2, 2) / 3 and faces down.
    const Triangle<q16_16, 3> triangle{D::vec({200, 0, 0}), D::vec({0, 100, 0}),
                                       D::vec({0, 0, 100})};
    const auto expected = expected_raycast(upwards(10, 20, 0), triangle);
    REQUIRE(expected.hit.has_value());
    CHECK(expected.hit->enter == 75);
    CHECK(expected.hit->exit == 75);
    const std::int64_t third = (one + 1) / 3;  // 2^30 / 3 is 357913941.33
    reject_all_but(expected, right(expected, {-third, -2 * third - 1, -2 * third - 1}), 1);
  }
  SECTION("sphere, whose normal may be one unit off but not two") {
    const Sphere<q16_16, 3> sphere{D::vec({3 * unit, 0, 10 * unit}), D::scalar(5 * unit)};
    const auto expected = expected_raycast(upwards(0, 0, 0), sphere);
    REQUIRE(expected.hit.has_value());
    CHECK(expected.hit->enter == 6 * unit);
    CHECK(expected.hit->exit == 14 * unit);
    // 3/5 and 4/5 of 2^30 end in .4 and .2.
    const auto given = right(expected, {-644245094, 0, -858993459});
    reject_all_but(expected, given, 2);
    auto near = given;
    near.hit->normal[0] -= 1;
    CHECK(mistakes(expected, near).empty());
    near.hit->normal[0] += 2;
    CHECK_FALSE(mistakes(expected, near).empty());
  }
  SECTION("plane, met at a fraction") {
    // z falls by nearly 2/3 raw unit per unit of x: the height 50 is used up after 75 of x.
    const Plane<q16_16, 3> plane{D::direction({715827883, 715827883, 357913941}), D::scalar(100)};
    const auto expected = expected_raycast(upwards(0, 0, 0), plane);
    REQUIRE(expected.hit.has_value());
    CHECK(expected.hit->enter == 300);
    reject_all_but(expected, right(expected, {-715827883, -715827883, -357913941}), 1);
  }
  SECTION("miss") {
    const Sphere<q16_16, 3> sphere{D::vec({49152, 0, 10000 * unit}), D::scalar(32768)};
    const auto expected = expected_raycast(upwards(0, 0, 0), sphere);
    CHECK_FALSE(expected.hit.has_value());
    CHECK(mistakes(expected, {}).empty());
    CHECK_FALSE(mistakes(expected, {0, {}, {}}).empty());
    CHECK_FALSE(mistakes(expected, {{}, Given<3>::Hit{}, {}}).empty());
    CHECK_FALSE(mistakes(expected, {{}, {}, std::pair{0, 0}}).empty());
  }
}

TEST_CASE("oracle: touching and missing are one raw unit apart", "[oracle]") {
  const auto hits = [](const auto& ray, const auto& shape) {
    return expected_raycast(ray, shape).hit.has_value();
  };
  const Sphere<q16_16, 3> sphere{D::vec({300, 400, 10000}), D::scalar(500)};
  CHECK(hits(upwards(0, 0, 0), sphere));
  CHECK_FALSE(hits(upwards(-1, 0, 0), sphere));
  CHECK(expected_raycast(upwards(0, 0, 0), sphere).hit->enter == 10000);

  const Aabb<q16_16, 3> box{D::vec({-5, -5, 10}), D::vec({5, 5, 20})};
  CHECK(hits(upwards(5, -5, 0), box));
  CHECK_FALSE(hits(upwards(6, -5, 0), box));

  // Exactly along (3, 0, 4) / 5, past the corner at (5, 5, 20).
  const auto slanted = D::stretched({3, 0, 4}, 5);
  CHECK(hits(Ray<q16_16, 3>{D::vec({2, 5, 16}), slanted, q16_16::max()}, box));
  CHECK(hits(Ray<q16_16, 3>{D::vec({5 - 300, 5, 10 - 400}), slanted, q16_16::max()}, box));
  CHECK_FALSE(hits(Ray<q16_16, 3>{D::vec({6 - 300, 5, 10 - 400}), slanted, q16_16::max()}, box));

  const Triangle<q16_16, 3> triangle{D::vec({0, 0, 9}), D::vec({6, 0, 9}), D::vec({0, 6, 9})};
  CHECK(hits(upwards(3, 3, 0), triangle));
  CHECK_FALSE(hits(upwards(3, 4, 0), triangle));
  CHECK_FALSE(hits(upwards(-1, 0, 0), triangle));

  const Triangle<q16_16, 3> segment{D::vec({2, 0, 9}), D::vec({-2, 0, 9}), D::vec({1, 0, 9})};
  CHECK(hits(upwards(-2, 0, 0), segment));
  CHECK_FALSE(hits(upwards(-3, 0, 0), segment));
  CHECK_FALSE(hits(upwards(0, 1, 0), segment));
}

TEST_CASE("oracle: the ray's length is counted to the raw unit", "[oracle]") {
  const Aabb<q16_16, 3> box{D::vec({-5, -5, 10}), D::vec({5, 5, 20})};
  auto ray = upwards(0, 0, 0);
  const auto exit_at = [&](std::int64_t max) {
    ray.max_distance = D::scalar(max);
    const auto expected = expected_raycast(ray, box);
    return expected.hit ? expected.hit->exit : -1;
  };
  CHECK(exit_at(-1) == -1);
  CHECK(exit_at(9) == -1);
  CHECK(exit_at(10) == 10);
  CHECK(exit_at(15) == 15);
  CHECK(exit_at(21) == 20);
}

TEST_CASE("oracle: exact frames are exactly orthogonal directions", "[oracle]") {
  for (const auto& frame : exact_frames<q16_16, 3>()) {
    for (std::size_t i = 0; i < 3; ++i) {
      const auto axis = widen(frame.axes[i]);
      REQUIRE(dot(axis, axis) == Integer(frame.norm) * frame.norm);
      REQUIRE(dot(axis, widen(frame.axes[(i + 1) % 3])) == 0);
      const auto direction = widen(raw(D::stretched(frame.axes[i], frame.norm)));
      REQUIRE(is_zero(cross(axis, direction)));
    }
  }
  CHECK(exact_frames<q16_16, 3>().size() > 100);
  CHECK(exact_frames<q16_16, 2>().size() > 100);
  CHECK(exact_frames<q8_8, 3>().size() > 100);
  CHECK(exact_frames<q8_8, 2>().size() > 10);
}

}  // namespace
}  // namespace detent::oracle
