// SPDX-License-Identifier: MIT
#include <array>
#include <span>

#include "detent/math/rotation.hpp"
#include "oracle/contact_exam.hpp"

namespace detent::oracle {
namespace {

TEMPLATE_TEST_CASE("contact: depth and normal of every two shapes are the exact ones, rounded once",
                   "[oracle]", (test::Space<q16_16, 3>), (test::Space<q16_16, 2>)) {
  examine_contacts<typename TestType::scalar, TestType::dimension>(0xc0117ac7, 60);
}

TEST_CASE("contact: of flat shapes in planes along the axes, which other shapes see edge-on",
          "[oracle]") {
  using S = q16_16;
  ContactExam<S, 3> exam(0xed6e);
  test::Random random(0xed6e);
  const auto number = [&] { return S::from_raw(static_cast<int>(random.between(-6, 6) << 14)); };
  for (int i = 0; i < 1500; ++i) {
    const auto flat_across = [&](int axis, S place) {
      return [&, axis, place] {
        return make_vec<3>([&](int k) { return k == axis ? place : number(); });
      };
    };
    const int axis = static_cast<int>(random.below(3));
    const auto corner = flat_across(axis, number());
    const auto other = flat_across(static_cast<int>(random.below(3)), number());
    const std::array corners{corner(), corner(), corner(), corner(), corner()};
    const ConvexHull<S, 3> hull{std::span<const Vec<S, 3>>(corners)};
    const Triangle<S, 3> triangle{corner(), corner(), corner()};
    const Triangle<S, 3> second{other(), other(), other()};
    const Vec<S, 3> low{number(), number(), number()};
    const Aabb<S, 3> box{low, make_vec<3>([&](int k) { return nearest_to<S>(low[k] + 1); })};
    const Plane<S, 3> plane{Direction<S, 3>::along((axis + 1) % 3), number()};
    REQUIRE(exam.is_right(triangle, second));
    REQUIRE(exam.is_right(hull, second));
    REQUIRE(exam.is_right(triangle, box));
    REQUIRE(exam.is_right(hull, box));
    REQUIRE(exam.is_right(hull, plane));
  }
  CHECK(exam.met() > 2000);
}

/// Thin bars in any direction, and points about them.
struct Bars {
  using S = q16_16;
  test::Random random{0xba5};

  S between(std::int64_t low, std::int64_t high) {
    return S::from_raw(static_cast<int>(random.between(low, high)));
  }
  Obb<S, 3> draw(S thickness) {
    const auto angle = [&] {
      return Angle<S>::from_raw(static_cast<int>(random.between(-0x7fffffff, 0x7fffffff)));
    };
    const S half = between(1 << 8, 1 << random.between(9, 23));
    return {{}, {S(0), thickness, half}, Rotation<S, 3>::from_euler(angle(), angle(), angle())};
  }
  /// A point less than 6 steps from the one that is so far from another one along an axis.
  template <class Far>
  Vec<S, 3> near(const Vec<S, 3>& from, const Far& far, const Direction<S, 3>& axis) {
    return make_vec<3>(
        [&](int k) { return nearest_to<S>(from[k] + far * axis[k] + between(-3, 3)); });
  }
};

TEST_CASE("contact: of edges that are parallel but for the rounding of corners", "[oracle]") {
  using S = q16_16;
  ContactExam<S, 3> exam(0xba5);
  Bars bars;
  for (int i = 0; i < 1500; ++i) {
    const auto bar = bars.draw(S(0));
    const auto point = [&] {
      return bars.near({}, bar.half_extents.z * bars.between(-2 << 16, 2 << 16),
                       bar.rotation.axis(2));
    };
    const Capsule<S, 3> capsule{point(), point(), bars.between(4, 1 << 9)};
    const Triangle<S, 3> triangle{point(), point(), point()}, second{point(), point(), point()};
    REQUIRE(exam.is_right(bar, capsule));
    REQUIRE(exam.is_right(triangle, capsule));
    REQUIRE(exam.is_right(bar, triangle));
    REQUIRE(exam.is_right(triangle, second));
  }
  CHECK(exam.met() > 3200);
}

TEST_CASE("contact: of bars a few steps thick and what stands upright on them", "[oracle]") {
  using S = q16_16;
  ContactExam<S, 3> exam(0xba5);
  Bars bars;
  for (int i = 0; i < 3000; ++i) {
    const auto bar = bars.draw(bars.between(0, 2));
    const auto foot = bars.near({}, bar.half_extents.z, bar.rotation.axis(2));
    const auto height = bars.between(1 << 10, 1 << 23);
    const auto top = [&](int axis) { return bars.near(foot, height, bar.rotation.axis(axis)); };
    const Capsule<S, 3> capsule{foot, top(i % 2), bars.between(0, 1 << 23)};
    const Triangle<S, 3> triangle{foot, top(0), top(i % 3)};
    REQUIRE(exam.is_right(bar, capsule));
    REQUIRE(exam.is_right(bar, triangle));
  }
  CHECK(exam.met() > 3300);
}

template <int N>
Vec<q16_16, N> steps(const std::array<int, static_cast<std::size_t>(N)>& raw) {
  return make_vec<N>([&](int i) { return q16_16::from_raw(raw[static_cast<std::size_t>(i)]); });
}

TEST_CASE("contact: where the rounding of the normal decides which corners meet", "[oracle]") {
  using S = q16_16;
  ContactExam<S, 2> planar(0);
  ContactExam<S, 3> spatial(0);
  const auto unit = [](int x, int y, int z) {
    return Direction<S, 3>::from_raw({x, y, z}).value();
  };

  // An upright edge under the end of another one.
  const std::array edge{steps<2>({-170977404, 0}), steps<2>({-170977404, -33554428})};
  CHECK(planar.is_right(Capsule<S, 2>{steps<2>({-170977405, 33554429}),
                                      steps<2>({-238086260, 33554427}), S::from_raw(67108856)},
                        ConvexHull<S, 2>{edge}));
  const auto end = steps<2>({512765475, -499313375});
  CHECK(planar.is_right(Triangle<S, 2>{steps<2>({510719476, -498853024}), end, end},
                        Capsule<S, 2>{steps<2>({514811475, -499773725}),
                                      steps<2>({515271825, -497727725}), S::from_raw(2097150)}));

  // A capsule as good as parallel to the normal.
  const auto top = steps<3>({-345249, -189936099, -470486451});
  const std::array corners{
      steps<3>({818369, -190242988, -469028734}), steps<3>({-115083, -190549875, -469668083}), top,
      steps<3>({-882303, -192698091, -468376596}), steps<3>({-473119, -192391203, -468261513})};
  CHECK(spatial.is_right(
      Capsule<S, 3>{steps<3>({-1022960, -190575449, -468760206}),
                    steps<3>({-409184, -191163651, -469373982}), S::from_raw(524267)},
      ConvexHull<S, 3>{corners}));
  const Rotation thin = Rotation<S, 3>::from_axes({unit(357913941, -715827882, -715827882),
                                                   unit(715827882, -357913941, 715827882),
                                                   unit(-715827882, -715827882, 357913941)});
  CHECK(spatial.is_right(
      Obb<S, 3>{steps<3>({330283754, -5592403, 2796203}), steps<3>({0, 1, 8388607}), thin},
      Capsule<S, 3>{steps<3>({337274258, -2796202, -2796202}), steps<3>({335876157, 0, 0}),
                    S::from_raw(4194302)}));

  // A bar on the rim of a plate.
  const Rotation both = Rotation<S, 3>::from_axes({unit(-644245095, 0, 858993460),
                                                   unit(687194768, 644245095, 515396076),
                                                   unit(-515396076, 858993460, -386547057)});
  CHECK(spatial.is_right(
      Obb<S, 3>{steps<3>({-720, -160500025, -408963215}), steps<3>({0, 501, 0}), both},
      Obb<S, 3>{steps<3>({0, -160499975, -408962675}), steps<3>({0, 500, 500}), both}));
}

TEMPLATE_TEST_CASE("contact: depth and normal of many more pairs are exact", "[oracle][.demand]",
                   (test::Space<q16_16, 3>), (test::Space<q16_16, 2>)) {
  for (const auto seed : demanded_seeds()) {
    examine_contacts<typename TestType::scalar, TestType::dimension>(seed, 300);
  }
}

}  // namespace
}  // namespace detent::oracle
