// SPDX-License-Identifier: MIT
#include "detent/math/vec.hpp"

#include <type_traits>

#include "detent/number/digest.hpp"
#include "number/big_integer.hpp"
#include "support/catch.hpp"

using namespace detent;
using namespace detent::test;

namespace {

using V2 = Vec<q16_16, 2>;
using V3 = Vec<q16_16, 3>;
constexpr q16_16 least = q16_16::lowest();

static_assert(std::is_aggregate_v<V3> && sizeof(V3) == 12 && sizeof(Vec<q8_8, 2>) == 4);
static_assert(V3{}.z == 0);
static_assert(std::is_same_v<decltype(Vec{q16_16(), q16_16()}), V2>);
static_assert(std::is_same_v<decltype((V3() - V3()).x), Fixed<32, 16>>);
static_assert(std::is_same_v<decltype(dot(V3(), V3())), Fixed<64, 32>>);
static_assert(std::is_same_v<decltype(dot(V3() - V3(), V3() - V3())), Fixed<66, 32>>);

static_assert(V3{least, least, least} - V3{q16_16::max(), q16_16(), least} ==
              Vec<Fixed<32, 16>, 3>{least - q16_16::max(), least - q16_16(), least - least});
static_assert(squared_length(V3{least, least, least}) == 3 * (std::int64_t{1} << 30));
static_assert(squared_length(V2{least, least}) == std::int64_t{1} << 31);
static_assert(cross(V2{least, q16_16(1)}, V2{q16_16(-1), least}) == (1 << 30) + 1);
static_assert(cross(V3{q16_16(1), q16_16(), q16_16()}, V3{q16_16(), q16_16(1), q16_16()}).z == 1);
static_assert(-V2{least, q16_16(1)} == Vec<Fixed<32, 16>, 2>{-least, -q16_16(1)});
static_assert(V2{q16_16(3), q16_16(-4)} * q16_16(2) == q16_16(2) * V2{q16_16(3), q16_16(-4)});
static_assert(length(V2{q16_16(3), q16_16(-4)}) == 5);
static_assert(length(V2{q16_16(1), q16_16(1)}).raw() == 92681, "rounded down");
static_assert(length(V3{least, least, least}) == q16_16::max(), "clamped");

// Differences of 32-bit scalars, as in distance(a, b), give the scalar; others their own type.
static_assert(std::is_same_v<decltype(length(V3() - V3())), q16_16>);
static_assert(length(V3{q16_16(3)} - V3{q16_16(), q16_16(4)}) == 5);
static_assert(length(V2{least} - V2{q16_16::max()}) == q16_16::max(), "clamped");
static_assert(length<Fixed<33, 16>>(V2{least} - V2{q16_16::max()}) == q16_16::max() - least);
static_assert(length<q24_8>(V2{q16_16(3), q16_16(4)}) == 5);
static_assert(std::is_same_v<decltype(length(V2() * q16_16())), Fixed<62, 32>>);
static_assert(length(V2{q16_16(3), q16_16(4)} * q16_16(2)) == 10);

// Built-in integers; a quotient's name says how it rounds.
static_assert(2 * V2{q16_16(3), least} == Vec<Fixed<62, 16>, 2>{q16_16(6), least * 2} &&
              V2{q16_16(3), least} * 2 == 2 * V2{q16_16(3), least});
static_assert(2 * Vec<float, 2>{1, 2} == Vec<float, 2>{2, 4});
static_assert(quotient_nearest<q16_16>(V2{q16_16(3), q16_16(-1)}, 2) ==
                  V2{q16_16::from_double(1.5), q16_16::from_double(-0.5)} &&
              quotient_floor<Fixed<31, 0>>(V2{q16_16(3), q16_16(-1)}, q16_16(2)) ==
                  Vec<Fixed<31, 0>, 2>{Fixed<31, 0>(1), Fixed<31, 0>(-1)} &&
              half(V2{q16_16(3), q16_16(1)}).x == q16_16::from_double(1.5));
template <class A, class B>
concept HasProduct = requires(A a, B b) {
  a* b;
};
template <class A, class B>
concept HasQuotient = requires(A a, B b) {
  a / b;
};
static_assert(!HasProduct<V3, V3> && !HasQuotient<V3, q16_16> && !HasQuotient<V3, int> &&
              HasProduct<V3, int> && HasProduct<q8_8, V3>);

static_assert([] {
  V2 v{q16_16(1), q16_16(2)};
  v *= 3;
  v *= q16_16(2);
  return v;
}() == V2{q16_16(6), q16_16(12)});

static_assert([] {
  V2 v{q16_16(1), q16_16(2)};
  v += V2{q16_16(5), q16_16(-5)};
  v -= V2{q16_16(1), q16_16(1)};
  v *= q16_16::from_double(0.5);
  return v;
}() == V2{q16_16::from_double(2.5), q16_16(-2)});

TEMPLATE_TEST_CASE("dot and cross: exact over the whole domain", "", q16_16, q14_16, q24_8, q8_8) {
  Random random(20261123);
  int wrong = 0;
  for (int i = 0; i < 20'000; ++i) {
    const auto draw = [&] {
      return TestType::from_raw(
          static_cast<typename TestType::raw_type>(random.edgy(TestType::bits)));
    };
    const Vec<TestType, 3> a{draw(), draw(), draw()}, b{draw(), draw(), draw()};
    BigInteger sum = 0;
    for (int j = 0; j < 3; ++j) sum += big_raw(a[j]) * big_raw(b[j]);
    if (big_raw(dot(a, b)) != sum) ++wrong;
    const auto c = cross(a, b);
    for (int j = 0; j < 3; ++j) {
      const int k = (j + 1) % 3, l = (j + 2) % 3;
      if (big_raw(c[j]) != big_raw(a[k]) * big_raw(b[l]) - big_raw(a[l]) * big_raw(b[k])) ++wrong;
    }
  }
  INFO("seed " << random.seed());
  CHECK(wrong == 0);
}

TEMPLATE_TEST_CASE("length: the length of a difference is the distance", "", q16_16, q24_8) {
  using V = Vec<TestType, 3>;
  Random random(20261122);
  INFO(random);
  const auto draw = [&] {
    return TestType::from_raw(
        static_cast<typename TestType::raw_type>(random.edgy(TestType::bits)));
  };
  for (int i = 0; i < 5'000; ++i) {
    const V a{draw(), draw(), draw()}, b{draw(), draw(), draw()};
    REQUIRE(length(a - b) == distance(a, b));
    REQUIRE(nearest_to<TestType>(length<Fixed<33, TestType::frac>>(a - b)) == distance(a, b));
  }
}

TEST_CASE("digest: a vector is its components, in order") {
  const V2 v{q16_16(1), q16_16(-2)};
  Digest parts;
  parts.add(v.x, v.y);
  CHECK(digest(v) == parts.value());
  CHECK(digest(v) != digest(V2{v.y, v.x}));
}

}  // namespace
