// SPDX-License-Identifier: MIT
#include "detent/math/transform.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <type_traits>

#include "detent/number/digest.hpp"
#include "math/frames.hpp"

using namespace detent;
using namespace detent::test;

namespace {

using S = q16_16;
using T = Transform<S, 3>;
using R = Rotation<S, 3>;
using V = Vec<S, 3>;
using D = Direction<S, 3>;
using A = Angle<S>;
constexpr S low = S::lowest(), high = S::max();
constexpr auto v3 = [](int x, int y, int z) { return V{S(x), S(y), S(z)}; };
constexpr R quarter = R::from_axis_angle(D::along(2), A::turn(1, 4));
constexpr T placed{v3(10, 0, 0), quarter, S(2)};

static_assert(std::is_aggregate_v<T> && sizeof(T) == 52 && T().scale == 1);
static_assert(transform_point(T(), v3(1, 2, 3)) == v3(1, 2, 3));
static_assert(transform_point(placed, v3(1, 2, 3)) == v3(6, 2, 6));
static_assert(transform_vector(placed, v3(1, 2, 3)) == v3(-4, 2, 6));
static_assert(transform_direction(placed, D::along(0)) == D::along(1));
static_assert(inverse_transform_point(placed, v3(6, 2, 6)) == v3(1, 2, 3));
static_assert(inverse_transform_vector(placed, v3(-4, 2, 6)) == v3(1, 2, 3));
static_assert(inverse_transform_direction(placed, D::along(1)) == D::along(0));
static_assert(compose(placed, *inverse(placed)) == T() && compose(*inverse(placed), placed) == T());
static_assert(compose(placed, placed).scale == 4 && compose(placed, T()) == placed);
static_assert(compose(quarter, inverse(quarter)) == R());
static_assert(transform_point(T{{high, low, high}, R(), high}, V{high, low, low}) ==
                  V{high, low, low},
              "clamped");
static_assert(transform_point(T{{low, low, low}, R(), S(1)}, V{high, high, high}) ==
                  V{S::from_raw(-1), S::from_raw(-1), S::from_raw(-1)},
              "no intermediate is clamped");

// A negative scale mirrors, directions included; a scale of 0 has no inverse.
constexpr T mirror{V{}, R(), S(-1)}, flat{v3(1, 2, 3), R(), S()};
static_assert(transform_point(mirror, v3(1, -2, 3)) == v3(-1, 2, -3));
static_assert(transform_direction(mirror, D::along(0)) == -D::along(0));
static_assert(transform_point(flat, v3(7, 8, 9)) == v3(1, 2, 3) && !inverse(flat));
static_assert(inverse_transform_point(flat, v3(2, 2, 0)) == V{high, S(), low});
static_assert(transform_direction(flat, D::along(0)) == D::along(0));

constexpr R collapsed = R::from_axes({D::along(0), -D::along(0), D::along(0)});
static_assert(rotate(collapsed, *normalize(v3(1, 1, 0))) == *normalize(v3(1, 1, 0)),
              "nothing is left");
static_assert(inverse(collapsed).axis(1) == D::along(1));

}  // namespace

TEMPLATE_TEST_CASE("transform: points and vectors are exact sums, rounded once, in both directions",
                   "", DETENT_FIXED_SPACES) {
  using Sc = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  Random random(100);
  int wrong = 0;
  for (int k = 0; k < 1'500; ++k) {
    const Transform<Sc, N> t{random_vec<Sc, N>(random), random_frame<Sc, N>(random),
                             random_fixed<Sc>(random)};
    const auto p = random_vec<Sc, N>(random);
    const auto to_point = transform_point(t, p), to_vector = transform_vector(t, p);
    const auto from_point = inverse_transform_point(t, p),
               from_vector = inverse_transform_vector(t, p);
    const BigRational scale = rational(t.scale);
    const auto is = [&](Sc found, const BigRational& exact) {
      return big_raw(found) == clamped<Sc>(nearest_of(on_grid<Sc>(exact)));
    };
    for (int j = 0; j < N; ++j) {
      BigRational sum = 0, back = 0, offset = 0;
      for (int i = 0; i < N; ++i) {
        sum += rational(t.rotation.axis(i)[j]) * rational(p[i]) * scale;
        back += rational(t.rotation.axis(j)[i]) * rational(p[i]);
        offset += rational(t.rotation.axis(j)[i]) * rational(t.translation[i]);
      }
      if (!is(to_vector[j], sum) || !is(to_point[j], rational(t.translation[j]) + sum)) ++wrong;
      if (scale == 0) continue;
      if (!is(from_vector[j], back / scale)) ++wrong;
      if (!is(from_point[j], (back - offset) / scale)) ++wrong;
      if (!is(inverse(t)->translation[j], -offset / scale)) ++wrong;
    }
    if (scale != 0 && !is(inverse(t)->scale, 1 / scale)) ++wrong;
  }
  INFO(random);
  CHECK(wrong == 0);
}

TEMPLATE_TEST_CASE("transform: frames and directions are correctly rounded directions", "",
                   DETENT_FIXED_SPACES) {
  using Sc = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  Random random(101);
  int wrong = 0;
  for (int k = 0; k < 1'500; ++k) {
    const auto outer = random_frame<Sc, N>(random), inner = random_frame<Sc, N>(random);
    const auto product = compose(outer, inner), back = inverse(outer);
    for (int i = 0; i < N; ++i) {
      std::array<BigInteger, N> column, row, local;
      for (int j = 0; j < N; ++j) {
        auto& sum = column[static_cast<std::size_t>(j)];
        auto& dual = local[static_cast<std::size_t>(j)];
        for (int l = 0; l < N; ++l) {
          sum += big_raw(outer.axis(l)[j]) * big_raw(inner.axis(i)[l]);
          dual += big_raw(outer.axis(j)[l]) * big_raw(inner.axis(i)[l]);
        }
        row[static_cast<std::size_t>(j)] = big_raw(outer.axis(j)[i]);
      }
      if (!is_direction_of(product.axis(i), column)) ++wrong;
      if (!is_direction_of(back.axis(i), row)) ++wrong;
      if (!is_direction_of(inverse_rotate(outer, inner.axis(i)), local)) ++wrong;
    }
    const Transform<Sc, N> t{{}, outer, random_fixed<Sc>(random)};
    const auto d = inner.axis(0), along = t.scale < 0 ? -d : d;
    if (transform_direction(t, d) != rotate(outer, along)) ++wrong;
    if (inverse_transform_direction(t, d) != inverse_rotate(outer, along)) ++wrong;
  }
  INFO(random);
  CHECK(wrong == 0);
}

TEMPLATE_TEST_CASE("transform: a point moves by less than 8 units in a round trip", "",
                   DETENT_FIXED_SPACES) {
  using Sc = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  Random random(102);
  std::int64_t worst = 0;
  for (int k = 0; k < 20'000; ++k) {
    const Transform<Sc, N> t{{}, random_rotation<Sc, N>(random), Sc(1)};
    const auto limit = std::int64_t{Sc::max().raw()} * 4 / 7;  // stays in range when rotated
    const auto p = make_vec<N>([&](int) {
      return Sc::from_raw(static_cast<typename Sc::raw_type>(random.between(-limit, limit)));
    });
    const auto back = inverse_transform_point(t, transform_point(t, p));
    for (int i = 0; i < N; ++i) {
      worst = std::max(worst, std::abs(std::int64_t{back[i].raw()} - p[i].raw()));
    }
  }
  INFO(random);
  CAPTURE(worst);
  CHECK(worst < 8);
}

TEST_CASE("transform: some point moves by 4 units in a round trip") {
  const auto rotation = R::from_axes({*D::from_raw({-1073593798, 17733059, -1844206}),
                                      *D::from_raw({17826980, 1069273977, -96212605}),
                                      *D::from_raw({247561, -96229959, -1069420983})});
  const T t{{}, rotation, S(1)};
  const V p{S::from_raw(1227133415), S::from_raw(-1227133116), S::from_raw(1227133126)};
  const V back = inverse_transform_point(t, transform_point(t, p));
  const auto moved = std::array{back.x - p.x, back.y - p.y, back.z - p.z};
  CHECK(std::any_of(moved.begin(), moved.end(), [](auto d) { return abs(d) >= S::from_raw(4); }));
}

TEMPLATE_TEST_CASE("transform: a parent and a child compose, also in float and double", "", float,
                   double) {
  using F = TestType;
  using M = Transform<F, 2>;
  const auto quarter_turn = Rotation<F, 2>::from_angle(Angle<F>::turn(1, 4));
  const M parent{{10, 0}, quarter_turn, 2}, child{{1, 0}, Rotation<F, 2>(), 3};
  const auto p = transform_point(compose(parent, child), Vec<F, 2>{1, 1});
  const auto q = transform_point(parent, transform_point(child, Vec<F, 2>{1, 1}));
  CHECK(p.x == Approx(q.x));
  CHECK(p.y == Approx(q.y));
  CHECK(inverse_transform_point(parent, transform_point(parent, Vec<F, 2>{3, 4})).x == Approx(3));
  CHECK(inverse(parent)->scale == F(0.5));
}

TEST_CASE("digest: a motion is its translation, rotation and scale") {
  Digest parts;
  parts.add(placed.translation, placed.rotation, placed.scale);
  CHECK(digest(placed) == parts.value());
}
