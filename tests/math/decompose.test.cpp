// SPDX-License-Identifier: MIT
#include "detent/math/decompose.hpp"

#include <algorithm>
#include <cstdint>

#include "math/frames.hpp"

using namespace detent;
using namespace detent::test;

namespace {

using S = q16_16;
using D = Direction<S, 3>;
using R = Rotation<S, 3>;
using T = Transform<S, 3>;
constexpr auto v3 = [](int x, int y, int z) { return Vec<S, 3>{S(x), S(y), S(z)}; };
constexpr R quarter = R::from_axis_angle(D::along(2), Angle<S>::turn(1, 4));
constexpr T placed{v3(10, -20, 30), quarter, S(2)};
constexpr auto matrix = nearest_to<S>(to_mat(placed));

static_assert(matrix == Mat<S, 4, 4>{{{{S(0), S(-2), S(0), S(10)},
                                       {S(2), S(0), S(0), S(-20)},
                                       {S(0), S(0), S(2), S(30)},
                                       {S(0), S(0), S(0), S(1)}}}});
static_assert(to_mat(quarter).column(0) == D::along(1).vec());
static_assert(decompose(matrix) == placed && decompose(identity<S, 4>()) == T());
static_assert(decompose(identity<S, 3>()) == Transform<S, 2>());
constexpr auto changed = [](int row, int column, S to) {
  auto m = matrix;
  m(row, column) = to;
  return decompose(m).has_value();
};
static_assert(!changed(3, 3, S(2)) && !changed(3, 0, S(1)) && !changed(0, 1, S(0)), "not a motion");
static_assert(!changed(0, 1, S(2)) == false, "a mirror in space has a negative scale");
static_assert(!changed(2, 2, S(3)) && !changed(2, 0, S(1)), "stretched, sheared");
static_assert(changed(2, 0, S::from_raw(4)) && !changed(2, 0, S::from_raw(5)));

static_assert(orthogonalize(quarter) == quarter);
constexpr D slanted = *normalize(v3(1, 1, 0));
static_assert(orthogonalize(R::from_axes({D::along(0), slanted, D::along(2)})) == R());
static_assert(orthogonalize(R::from_axes({D::along(0), slanted, -slanted})) == std::nullopt);
static_assert(orthogonalize(R::from_axes({D::along(0), D::along(1), -D::along(2)}))->axis(2) ==
                  -D::along(2),
              "left-handed stays left-handed");

}  // namespace

TEMPLATE_TEST_CASE("orthogonalize: the Gram-Schmidt vectors, each correctly rounded", "",
                   DETENT_FIXED_SPACES) {
  using Sc = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  using Exact = std::array<BigRational, N>;
  Random random(110);
  int wrong = 0;
  for (int k = 0; k < 1'000; ++k) {
    const auto frame = random_frame<Sc, N>(random);
    const auto found = orthogonalize(frame);
    std::array<Exact, N> steps;
    bool dependent = false;
    for (std::size_t i = 0; i < N && !dependent; ++i) {
      const auto& axis = frame.axis(static_cast<int>(i));
      for (std::size_t j = 0; j < N; ++j) steps[i][j] = big_raw(axis[static_cast<int>(j)]);
      const Exact own = steps[i];
      for (std::size_t l = 0; l < i; ++l) {
        BigRational along = 0, squared = 0;
        for (std::size_t j = 0; j < N; ++j) {
          along += own[j] * steps[l][j];
          squared += steps[l][j] * steps[l][j];
        }
        for (std::size_t j = 0; j < N; ++j) steps[i][j] -= along / squared * steps[l][j];
      }
      dependent = std::all_of(steps[i].begin(), steps[i].end(), [](auto& x) { return x == 0; });
    }
    if (found.has_value() == dependent) ++wrong;
    if (dependent || !found) continue;
    for (std::size_t i = 0; i < N; ++i) {
      BigInteger scale = 1;
      for (const auto& component : steps[i]) scale *= denominator(component);
      std::array<BigInteger, N> whole;
      for (std::size_t j = 0; j < N; ++j) whole[j] = numerator(BigRational(steps[i][j] * scale));
      if (!is_direction_of(found->axis(static_cast<int>(i)), whole)) ++wrong;
    }
  }
  INFO(random);
  CHECK(wrong == 0);
}

TEMPLATE_TEST_CASE("decompose: recovers a motion from its rounded matrix within 4 units", "",
                   DETENT_FIXED_SPACES) {
  using Sc = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  Random random(111);
  int wrong = 0;
  std::int64_t worst = 0;
  for (int k = 0; k < 3'000; ++k) {
    Transform<Sc, N> t{random_vec<Sc, N>(random), random_rotation<Sc, N>(random),
                       random_vec<Sc, 2>(random).x};
    if (N == 2 && t.scale < 0) t.scale = Sc(1);  // in 2D a negative scale is half a turn
    if (abs(t.scale) < Sc::from_raw(16)) continue;
    const auto m = nearest_to<Sc>(to_mat(t));
    const auto found = decompose(m);
    if (!found || found->translation != t.translation) {
      ++wrong;
      continue;
    }
    const auto again = nearest_to<Sc>(to_mat(*found));
    for (int i = 0; i < N; ++i) {
      for (int j = 0; j < N; ++j) {
        worst = std::max(worst, std::abs(std::int64_t{again(i, j).raw()} - m(i, j).raw()));
      }
    }
    // A matrix with a column of clearly different length is not a similarity.
    auto stretched = m;
    stretched(0, 0) = nearest_to<Sc>(m(0, 0) + Sc::from_raw(m(0, 0) < 0 ? 40 : -40));
    if (abs(t.scale) > Sc::from_raw(200) && decompose(stretched)) ++wrong;
  }
  INFO(random);
  CAPTURE(worst);
  CHECK(wrong == 0);
  CHECK(worst <= 4);
  if (N == 3 && Sc::bits == 31) CHECK(worst >= 2);
}

TEMPLATE_TEST_CASE("decompose: float and double have the same interface", "", float, double) {
  using F = TestType;
  const Transform<F, 3> t{
      {1, 2, 3},
      Rotation<F, 3>::from_euler(Angle<F>::turn(1, 7), Angle<F>::turn(1, 9), Angle<F>::turn(1, 5)),
      F(1.5)};
  const auto found = decompose(nearest_to<F>(to_mat(t)));
  REQUIRE(found);
  CHECK(found->scale == Approx(1.5));
  CHECK(found->rotation.axis(1)[2] == Approx(t.rotation.axis(1)[2]));
  auto sheared = nearest_to<F>(to_mat(t));
  sheared(0, 0) += F(0.25);
  CHECK(!decompose(sheared));
}
