// SPDX-License-Identifier: MIT
#include "detent/math/direction.hpp"

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <type_traits>
#include <utility>

#include "number/big_integer.hpp"
#include "support/catch.hpp"

using namespace detent;
using namespace detent::test;

namespace {

using D = Direction<q16_16, 3>;
using V = Vec<q16_16, 3>;
constexpr std::int32_t one = std::int32_t{1} << 30;

static_assert(sizeof(D) == 12 && sizeof(Direction<q8_8, 2>) == 4);
static_assert(!normalize(V{}));
static_assert(normalize(V{q16_16(7), q16_16(), q16_16()}) == D::along(0));
static_assert(normalize(V{q16_16::from_raw(1), q16_16(), q16_16()}) == D::along(0));
static_assert(normalize(V{q16_16(), q16_16::lowest(), q16_16()}) == -D::along(1));
static_assert(normalize(V{q16_16(3), q16_16(), q16_16(-4)})->vec().z.raw() == -858993459);

static_assert(D::from_raw({one, 0, 0}) == D::along(0));
static_assert(D::from_raw({-one, 0, 0}) == -D::along(0));
static_assert(!D::from_raw({one + 1, 0, 0}), "no component exceeds 1");
static_assert(D::from_raw({one - 2, 0, 0}), "shorter by 2^-29");
static_assert(!D::from_raw({one - 3, 0, 0}));
static_assert(!D::from_raw({0, 0, 0}));
static_assert(!D::from_raw({std::numeric_limits<std::int32_t>::min(), 0, 0}));
static_assert(Direction<q8_8, 2>::from_raw({16384, 0}));
static_assert(!Direction<q8_8, 2>::from_raw({16384, 257}), "longer by more than 2^-13");
static_assert(Direction<q8_8, 2>::from_raw({16384, 256}));
static_assert(!Direction<q8_8, 2>::from_raw({16381, 0}));

// Cauchy-Schwarz: products with a direction need fewer bits than their terms would.
using Offset = Vec<Fixed<32, 16>, 3>;
static_assert(std::is_same_v<decltype(dot(Offset(), D())), Fixed<63, 46>>);
static_assert(std::is_same_v<decltype(dot(D(), D())), Fixed<61, 60>>);
static_assert(std::is_same_v<decltype(cross(D(), Offset()).x), Fixed<63, 46>>);
static_assert(std::is_same_v<decltype(cross(Offset(), D()).x), Fixed<63, 46>>);
static_assert(std::is_same_v<decltype(cross(D(), D()).x), Fixed<61, 60>>);

/// Whether `component` is 2^frac * coordinate / sqrt(squared) rounded to nearest; ties do not
/// occur.
bool is_nearest(const BigInteger& component, const BigInteger& coordinate,
                const BigInteger& squared, int frac) {
  if (component * coordinate < 0) return false;
  const BigInteger doubled = 2 * abs(component);
  const BigInteger exact = 4 * coordinate * coordinate * power_of_two(2 * frac);
  return (doubled == 0 || exact > (doubled - 1) * (doubled - 1) * squared) &&
         exact < (doubled + 1) * (doubled + 1) * squared;
}

template <Scalar S, int N, class T>
bool is_rounded(const Vec<T, N>& v) {
  const auto direction = direction_of<S>(v);
  BigInteger squared = 0;
  for (int i = 0; i < N; ++i) squared += big_raw(v[i]) * big_raw(v[i]);
  if (!direction) return squared == 0;
  for (int i = 0; i < N; ++i) {
    if (!is_nearest(big_raw((*direction)[i]), big_raw(v[i]), squared,
                    direction_component<S>::frac)) {
      return false;
    }
  }
  // The invariant that queries rely on: raw bits are checked for it.
  using Raw = typename Direction<S, N>::Raw;
  std::array<Raw, N> raw;
  for (int i = 0; i < N; ++i) raw[static_cast<std::size_t>(i)] = (*direction)[i].raw();
  return Direction<S, N>::from_raw(raw) == direction;
}

TEMPLATE_TEST_CASE("normalize: every component is the exact one rounded to nearest", "", q16_16,
                   q14_16, q24_8, q8_8) {
  Random random(20261121);
  int wrong = 0;
  for (int i = 0; i < 60'000; ++i) {
    const auto draw = [&] {
      return TestType::from_raw(
          static_cast<typename TestType::raw_type>(random.edgy(TestType::bits)));
    };
    if (!is_rounded<TestType>(Vec<TestType, 2>{draw(), draw()})) ++wrong;
    if (!is_rounded<TestType>(Vec<TestType, 3>{draw(), draw(), draw()})) ++wrong;
  }
  INFO("seed " << random.seed());
  CHECK(wrong == 0);
}

// A difference has the direction type of its scalars, even where a scalar could not represent it.
template <class S>
using V3 = Vec<S, 3>;
static_assert(std::is_same_v<decltype(normalize(V3<q16_16>() - V3<q16_16>())),
                             std::optional<Direction<q16_16, 3>>>);
static_assert(std::is_same_v<decltype(normalize<q14_16>(V3<q14_16>() - V3<q14_16>())),
                             std::optional<Direction<q14_16, 3>>>);
static_assert(normalize(V3<q16_16>{q16_16::max()} - V3<q16_16>{q16_16::lowest()}) ==
              Direction<q16_16, 3>::along(0));

// A distance along a direction is exact; meaningless operations are rejected.
constexpr auto diagonal = *normalize(V3<q16_16>{q16_16(1), q16_16(2), q16_16(-2)});
static_assert(diagonal * q16_16(3) == diagonal.vec() * q16_16(3) &&
              q16_16(3) * diagonal == diagonal * q16_16(3) &&
              (2 * diagonal).y == diagonal[1] + diagonal[1] && diagonal * 2 == 2 * diagonal);
static_assert(std::is_same_v<decltype((diagonal * q16_16()).x), Fixed<62, 46>>);
template <class A, class B>
concept HasProduct = requires(A a, B b) {
  a* b;
};
template <class A, class B>
concept HasSum = requires(A a, B b) {
  a + b;
  a - b;
};
using Unit = Direction<q16_16, 3>;
static_assert(!HasProduct<Unit, Unit> && !HasProduct<Unit, V3<q16_16>> &&
              !HasProduct<V3<q16_16>, Unit> && !HasSum<Unit, Unit> && !HasSum<V3<q16_16>, Unit>);

TEMPLATE_TEST_CASE("direction: cross products are those of the vectors, in any order", "", q16_16,
                   q8_8) {
  using S = TestType;
  Random random(47);
  const auto draw = [&]<int N>(std::integral_constant<int, N>) {
    while (true) {
      const auto v = make_vec<N>([&](int) { return random_fixed<S>(random); });
      if (const auto d = normalize(v)) return std::pair(v, *d);
    }
  };
  const auto are_equal = [](const auto& a, const auto& b) {
    return a.x == b.x && a.y == b.y && a.z == b.z;
  };
  for (int i = 0; i < 1'000; ++i) {
    INFO(random);
    const auto [v, d] = draw(std::integral_constant<int, 3>());
    const auto e = draw(std::integral_constant<int, 3>()).second;
    REQUIRE(are_equal(cross(d, e), cross(d.vec(), e.vec())));
    REQUIRE(are_equal(cross(v, e), cross(v, e.vec())));
    REQUIRE(are_equal(cross(e, v), cross(e.vec(), v)));
    const auto [w, f] = draw(std::integral_constant<int, 2>());
    const auto g = draw(std::integral_constant<int, 2>()).second;
    REQUIRE(cross(f, g) == cross(f.vec(), g.vec()));
    REQUIRE(cross(w, g) == cross(w, g.vec()));
  }
}

TEST_CASE("direction_of: cross products of the longest edges are rounded to nearest") {
  Random random(20261122);
  int wrong = 0;
  for (int i = 0; i < 60'000; ++i) {
    const auto draw = [&] { return Fixed<32, 16>::from_raw(random.edgy(32)); };
    const auto normal = cross(Offset{draw(), draw(), draw()}, Offset{draw(), draw(), draw()});
    if (!is_rounded<q16_16>(normal)) ++wrong;
  }
  INFO("seed " << random.seed());
  CHECK(wrong == 0);
}

TEST_CASE("unit_vector: the exact path agrees with the filter") {
  Random random(20261125);
  int wrong = 0;
  for (int i = 0; i < 2'000; ++i) {
    std::array<Fixed<63, 32>, 3> v;
    for (auto& c : v) c = Fixed<63, 32>::from_raw(random.edgy(62));
    const auto unit = unit_vector<Fixed<31, 30>>(v);
    if (!unit) continue;
    std::array<Int128, 3> magnitudes;
    for (std::size_t k = 0; k < 3; ++k) magnitudes[k] = integer_cast<Int128>(abs(v[k]).raw());
    for (std::size_t k = 0; k < 3; ++k) {
      const auto rounded = static_cast<std::uint64_t>(std::int64_t{abs((*unit)[k]).raw()});
      if (detail::is_above_half<63, 30>(magnitudes, k, rounded)) ++wrong;
      if (rounded > 0 && !detail::is_above_half<63, 30>(magnitudes, k, rounded - 1)) ++wrong;
    }
  }
  CHECK(wrong == 0);
}

TEMPLATE_TEST_CASE("unit_vector: four components have no ties either", "", q16_16, q8_8) {
  using Component = direction_component<TestType>;
  Random random(20261124);
  int wrong = 0;
  for (int i = 0; i < 60'000; ++i) {
    // Small vectors and ones of equal components: only there could a length be a multiple of 4.
    std::array<Fixed<64, 32>, 4> v;
    const int bits = random.coin() ? 3 : 62;
    for (auto& c : v) c = Fixed<64, 32>::from_raw(random.edgy(bits));
    const auto unit = unit_vector<Component>(v);
    BigInteger squared = 0;
    for (const auto& c : v) squared += big_raw(c) * big_raw(c);
    if (unit.has_value() != (squared != 0)) ++wrong;
    if (!unit) continue;
    if (!is_unit(*unit)) ++wrong;
    for (std::size_t k = 0; k < 4; ++k) {
      if (!is_nearest(big_raw((*unit)[k]), big_raw(v[k]), squared, Component::frac)) ++wrong;
    }
  }
  INFO("seed " << random.seed());
  CHECK(wrong == 0);
}

TEMPLATE_TEST_CASE("normalize: float and double give the textbook quotient", "", float, double) {
  const auto d = normalize(Vec<TestType, 3>{3, 0, -4});
  REQUIRE(d);
  CHECK((*d)[0] == TestType(3) / TestType(5));
  CHECK((*d)[2] == TestType(-4) / TestType(5));
  CHECK(!normalize(Vec<TestType, 3>{}));
}

}  // namespace
