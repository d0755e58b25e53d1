// SPDX-License-Identifier: MIT
#include "detent/number/angle.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <type_traits>

#include "number/best_fraction.hpp"
#include "number/real.hpp"
#include "number/sine_table.hpp"
#include "support/catch.hpp"

using namespace detent;
using namespace detent::test;

namespace {

using q2_30 = Fixed<31, 30>;
using A = Angle<q16_16>;

constexpr std::int32_t least = std::numeric_limits<std::int32_t>::min();
constexpr std::int32_t greatest = std::numeric_limits<std::int32_t>::max();
constexpr std::uint32_t half_turn = 0x80000000u;

static_assert(std::is_trivially_copyable_v<A> && sizeof(A) == 4);
static_assert(sizeof(Angle<double>) == sizeof(double));
static_assert(A().raw() == 0 && A::turn(1, 4).raw() == 0x40000000u);
static_assert(A::turn(3, 4) + A::turn(1, 2) == A::turn(1, 4) && -A::turn(1, 2) == A::turn(1, 2));

// A third of a turn is not a binary angle; this is the nearest one.
static_assert(A::turn(1, 3).raw() == 0x55555555u && A::turn(-1, 3).raw() == 0xaaaaaaabu);
static_assert(A::turn(2, -3) == A::turn(1, 3) && A::turn(least, -1) == A());
static_assert(A::turn(least, greatest) == A::turn(-1, greatest));
static_assert(A::turn(greatest, least).raw() == 2, "-(1 - 2^-31) turn");

static_assert(A::from_degrees(q16_16(90)) == A::turn(1, 4));
static_assert(A::from_degrees(q16_16(-180)) == A::turn(1, 2));
static_assert(A::turn(1, 2).degrees() == 180 && A::turn(3, 4).degrees() == -90);
static_assert(Angle<q8_8>::turn(1, 2).degrees() == q8_8::max(), "q8_8 ends at 128");
static_assert(A::turn(1, 2).radians().raw() == 205887 && A::turn(3, 4).radians().raw() == -102944);

static_assert(sin(A()) == 0 && sin(A::turn(1, 4)) == 1 && sin(A::turn(1, 2)) == 0);
static_assert(sin(A::turn(3, 4)) == -1 && cos(A()) == 1 && cos(A::turn(1, 4)) == 0);
static_assert(cos(A::turn(1, 2)) == -1 && cos(A::turn(3, 4)) == 0);
static_assert(sin<q2_30>(A::turn(1, 12)).raw() == 1 << 29, "30 degrees: one half");
static_assert(cos<q2_30>(A::turn(1, 3)).raw() == -(1 << 29));
static_assert(sin<q2_30>(A::turn(1, 8)).raw() == 759250125 && cos(A::turn(1, 8)).raw() == 46341);
static_assert(sin<Fixed<40, 8>>(A::turn(1, 4)) == 1, "destinations may be wider than a scalar");
static_assert(sin<Fixed<16, 16>>(A::turn(1, 4)) == Fixed<16, 16>::max(), "and are clamped");
static_assert(std::is_same_v<decltype(sin(Angle<q8_8>())), q8_8>);
static_assert(std::is_same_v<decltype(cos<q2_30>(Angle<q8_8>())), q2_30>);

static_assert(atan2(q16_16(0), q16_16(0)) == A());
static_assert(atan2(q16_16(0), q16_16(-1)).raw() == half_turn);
static_assert(atan2(q16_16(-1), q16_16(1)) == A::turn(-1, 8));
static_assert(atan2(q8_8::lowest(), q8_8::lowest()) == Angle<q8_8>::turn(-3, 8));
static_assert(binary_angle(3, 4) == 439875013 && binary_angle(1, greatest) == 0);
// The vector closest to a tie: 61810632.50000000000000000025.
static_assert(binary_angle(26232283, 289312344) == 61810633);

/// The result of MPFR.
std::uint32_t exact_binary_angle(std::int32_t y, std::int32_t x) {
  const Real turns = atan2(Real(y), Real(x)) / (2 * pi());
  return static_cast<std::uint32_t>(nearest_integer(ldexp(turns, 32)));
}

/// A sine or cosine from the table, rounded to `frac` bits.
std::int64_t rounded(Word128 magnitude, int frac) {
  return static_cast<std::int64_t>(((magnitude >> (126 - frac)) + 1) >> 1);
}

}  // namespace

TEST_CASE("sine table: agrees with MPFR within 2^-120") {
  Random random(20);
  const auto& table = SineTable::instance();
  double worst = 0;
  for (int i = 0; i < 10'000; ++i) {
    const auto angle = static_cast<std::uint32_t>(random.below(1u << 30));
    const auto [sine, cosine] = table(angle);
    const auto off = [](Word128 word, const Real& exact) {
      return ulps(ldexp(Real(BigInteger(word)), -127), exact, 120);
    };
    worst =
        std::max({worst, off(sine, sin(radians_of(angle))), off(cosine, cos(radians_of(angle)))});
  }
  INFO(random);
  CHECK(worst < 1);
}

TEST_CASE("sine and cosine: correctly rounded to 8, 16 and 30 fractional bits") {
  Random random(21);
  const auto& table = SineTable::instance();
  std::uint64_t angles = 0, wrong = 0;
  const auto check = [&](std::uint32_t angle) {
    const auto [sine, cosine] = table(angle % (1u << 30));
    const A a = A::from_raw(angle);
    const auto right = [&, sine = sine, cosine = cosine]<class T>(T) {
      std::int64_t s = rounded(sine, T::frac), c = rounded(cosine, T::frac);
      for (std::uint32_t quarter = angle >> 30; quarter > 0; --quarter) {
        const std::int64_t old = s;
        s = c;
        c = -old;
      }
      return sin<T>(a).raw() == s && cos<T>(a).raw() == c;
    };
    if (!right(q8_8()) || !right(q16_16()) || !right(q2_30())) ++wrong;
    ++angles;
  };
  // One in 4096, different in every row of 4096, and the neighbourhood of the quarters.
  for (std::uint64_t row = 0; row < 1u << 20; ++row) {
    for (int k = 0; k < 4; ++k) check(static_cast<std::uint32_t>((row << 12) + random.below(4096)));
  }
  for (std::uint32_t quarter = 0; quarter < 4; ++quarter) {
    for (std::uint32_t near = 0; near < 20'000; ++near) check((quarter << 30) - 10'000 + near);
  }
  INFO(random);
  CHECK(angles > 4'000'000);
  CHECK(wrong == 0);
}

TEST_CASE("sine: within 2 * 2^-62 of the exact one for any phase, with sine odd and cosine even") {
  Random random(22);
  double worst = 0;
  std::uint64_t asymmetric = 0;
  for (int i = 0; i < 100'000; ++i) {
    const std::uint64_t phase =
        random.one_in(4) ? std::uint64_t{1} << random.below(64) : random.next();
    const Real exact = sin(ldexp(Real(phase), -63) * pi());
    worst = std::max(worst, ulps(ldexp(Real(sine_q62(phase)), -62), exact, 62));
    if (sine_q62(0 - phase) != -sine_q62(phase)) ++asymmetric;
    if (cosine_q62(0 - phase) != cosine_q62(phase)) ++asymmetric;
    if (sine_q62(phase + (std::uint64_t{1} << 63)) != -sine_q62(phase)) ++asymmetric;
  }
  INFO(random);
  CHECK(worst < 2);
  CHECK(worst > 0.8);
  CHECK(asymmetric == 0);
}

TEST_CASE("arc tangent: the table equals MPFR's results, rounded") {
  for (int i = 0; i <= 32; ++i) {
    const Real turns = atan(Real(i) / 32) / (2 * pi());
    CHECK(detail::arc_tangents[static_cast<std::size_t>(i)] ==
          static_cast<std::uint64_t>(static_cast<BigInteger>(ldexp(turns, 64) + Real(0.5))));
  }
}

TEST_CASE("arc tangent: correctly rounded for short and long, steep and flat vectors") {
  Random random(23);
  std::uint64_t wrong = 0;
  double worst_phase = 0;
  const auto draw = [&random] {
    return static_cast<std::int32_t>(random.coin() ? random.edgy(31) : random.wide(31));
  };
  for (int i = 0; i < 100'000; ++i) {
    std::int32_t x = draw(), y = draw();
    if (random.one_in(8)) y = static_cast<std::int32_t>(std::int64_t{x} + random.between(-2, 2));
    if (x == 0 && y == 0) continue;
    const std::uint32_t angle = binary_angle(y, x);
    if (angle != exact_binary_angle(y, x)) ++wrong;
    // Including the diagonal of INT_MIN: -2^31 has no positive counterpart.
    if (y != least && binary_angle(-y, x) != 0 - angle) ++wrong;
    const auto along = static_cast<std::uint64_t>(std::abs(std::int64_t{x}));
    const auto up = static_cast<std::uint64_t>(std::abs(std::int64_t{y}));
    const std::uint64_t a = std::max(along, up), b = std::min(along, up);
    const Real turns = atan2(Real(b), Real(a)) / (2 * pi());
    worst_phase =
        std::max(worst_phase, ulps(ldexp(Real(detail::octant_phase(b, a)), -64), turns, 64));
  }
  INFO(random);
  CHECK(wrong == 0);
  CHECK(worst_phase < 2.5);
  CHECK(worst_phase > 2);
}

TEST_CASE("arc tangent: correctly rounded for every vector with components up to 40") {
  std::uint64_t wrong = 0;
  for (std::int32_t y = -40; y <= 40; ++y) {
    for (std::int32_t x = -40; x <= 40; ++x) {
      if ((x != 0 || y != 0) && binary_angle(y, x) != exact_binary_angle(y, x)) ++wrong;
    }
  }
  CHECK(wrong == 0);
}

TEST_CASE("arc tangent: correctly rounded next to the nearest ties of a ray") {
  Random random(24);
  std::uint64_t wrong = 0;
  HitRate fine;  // how often the phase alone does not decide
  for (int i = 0; i < 20'000; ++i) {
    const auto whole = static_cast<std::uint32_t>(random.below(1u << 29));
    const NearTie tie = nearest_tie(whole);
    const std::uint32_t expected = tie.above ? whole + 1 : whole;
    const std::uint64_t fraction = detail::octant_phase(tie.b, tie.a) & 0xffffffffu;
    fine.count(fraction - (half_turn - 4) <= 8);
    // In the third quarter, where -2^31 can be a component.
    const auto x = static_cast<std::int32_t>(-static_cast<std::int64_t>(tie.a));
    const auto y = static_cast<std::int32_t>(-static_cast<std::int64_t>(tie.b));
    if (binary_angle(y, x) != half_turn + expected) ++wrong;
    if (i % 100 == 0 && exact_binary_angle(y, x) != half_turn + expected) ++wrong;
  }
  INFO(random);
  INFO(fine);
  CHECK(wrong == 0);
  CHECK(fine.percent() >= 30);
}

TEST_CASE("arc tangent: exact along the axes and the diagonals") {
  for (const std::int32_t r : {1, 2, 3, 255, 65536, 1 << 30, greatest}) {
    CHECK(binary_angle(0, r) == 0);
    CHECK(binary_angle(r, r) == 0x20000000u);
    CHECK(binary_angle(r, 0) == 0x40000000u);
    CHECK(binary_angle(r, -r) == 0x60000000u);
    CHECK(binary_angle(0, -r) == half_turn);
    CHECK(binary_angle(-r, -r) == 0xa0000000u);
    CHECK(binary_angle(-r, 0) == 0xc0000000u);
    CHECK(binary_angle(-r, r) == 0xe0000000u);
  }
  CHECK(binary_angle(0, least) == half_turn);
  CHECK(binary_angle(least, 0) == 0xc0000000u);
  CHECK(binary_angle(least, least) == 0xa0000000u);
  // So flat that the nearest binary angle is on the axis.
  CHECK(binary_angle(-1, least) == half_turn);
  CHECK(binary_angle(1, least) == half_turn);
}

namespace {

/// The least distance of n * x from an integer for 1 <= n <= 2^32.
Real least_distance_to_integers(const Real& x) {
  Real whole = floor(x), rest = x - whole;
  BigInteger before = 0, q = 1;
  Real best = std::min(rest, Real(1 - rest));
  while (rest > 0) {
    const Real inverse = 1 / rest;
    const BigInteger digit = static_cast<BigInteger>(floor(inverse));
    rest = inverse - floor(inverse);
    const BigInteger next = digit * q + before;
    if (next > power_of_two(32)) break;
    before = q;
    q = next;
    const Real multiple = Real(q) * x;
    best = std::min(best, Real(abs(multiple - floor(multiple + Real(0.5)))));
  }
  return best;
}

}  // namespace

// A product n x is halfway between two integers when 2n x is an odd integer. So half the least
// distance of the multiples up to 2n from integers exceeds the allowed error of a product with the
// constant.
TEST_CASE("angle: constants have the bits that their roundings need") {
  const Real off = abs(real(detail::two_pi) - 2 * pi());
  const Real inverse_off = abs(real(detail::turns_per_radian) - 1 / (2 * pi()));
  for (int frac = 0; frac <= 31; ++frac) {
    CAPTURE(frac);
    const Real to_radians = ldexp(2 * pi(), frac - 32),
               to_binary = ldexp(1 / (2 * pi()), 32 - frac);
    CHECK(ldexp(off, frac - 32 + 31) < least_distance_to_integers(to_radians) / 2);
    CHECK(ldexp(inverse_off, 32 - frac + 31) < least_distance_to_integers(to_binary) / 2);
  }
}

TEMPLATE_TEST_CASE("angle: converts to and from degrees and radians rounded to nearest", "", q16_16,
                   q14_16, q24_8, q8_8, (Fixed<31, 0>), (Fixed<31, 7>), (Fixed<31, 28>),
                   (Fixed<31, 30>)) {
  using S = TestType;
  using Binary = Angle<S>;
  Random random(25);
  std::uint64_t wrong = 0;
  for (int i = 0; i < 20'000; ++i) {
    const S x = random_fixed<S>(random);
    const BigInteger from_degrees = nearest_of(rational(x) * power_of_two(32) / 360);
    if (Binary::from_degrees(x).raw() !=
        static_cast<std::uint32_t>(static_cast<std::int32_t>(wrapped(from_degrees, 32)))) {
      ++wrong;
    }
    const auto from_radians =
        static_cast<BigInteger>(floor(ldexp(real(x), 32) / (2 * pi()) + Real(0.5)));
    if (Binary::from_radians(x).raw() !=
        static_cast<std::uint32_t>(static_cast<std::int32_t>(wrapped(from_radians, 32)))) {
      ++wrong;
    }

    const auto raw = random_integer<std::int32_t>(random);  // -2^31 is the half turn
    const Binary angle = Binary::from_raw(static_cast<std::uint32_t>(raw));
    const BigRational turns(raw == least ? -BigInteger(raw) : BigInteger(raw), power_of_two(32));
    const BigInteger degrees = nearest_of(on_grid<S>(turns * 360));
    if (big_raw(angle.degrees()) != clamped<S>(degrees)) ++wrong;
    const auto radians =
        static_cast<BigInteger>(floor(ldexp(radians_of(angle.raw()), S::frac) + Real(0.5)));
    if (big_raw(angle.radians()) != clamped<S>(radians)) ++wrong;
  }
  INFO(random);
  CHECK(wrong == 0);
}

TEST_CASE("angle: a fraction of a turn is rounded to nearest, ties to even") {
  Random random(26);
  std::uint64_t wrong = 0;
  for (int i = 0; i < 50'000; ++i) {
    const auto n = random_integer<std::int32_t>(random);
    auto d = random_integer<std::int32_t>(random);
    if (d == 0) d = 1;
    const BigInteger exact = nearest_of(BigRational(n) * power_of_two(32) / d);
    if (A::turn(n, d).raw() !=
        static_cast<std::uint32_t>(static_cast<std::int32_t>(wrapped(exact, 32)))) {
      ++wrong;
    }
  }
  INFO(random);
  CHECK(wrong == 0);
}

TEMPLATE_TEST_CASE("angle: every scalar has the same interface", "", q16_16, q14_16, q24_8, q8_8,
                   float, double) {
  using S = TestType;
  using Any = Angle<S>;
  // More than half a unit of the coarsest scalar.
  const auto close = [](const auto& a, double b) {
    return std::abs(static_cast<double>(a) - b) < 1.0 / 256;
  };
  CHECK(close(Any::turn(1, 4).degrees(), 90));
  CHECK(close(Any::turn(-1, 4).radians(), -1.5707963));
  CHECK(close(Any::from_degrees(S(60)).radians(), 1.0471976));
  CHECK(close(Any::from_radians(S(2)).degrees(), 114.591559));
  CHECK(close((Any::turn(1, 3) + Any::turn(1, 3)).degrees(), -120));
  CHECK(close((Any::turn(-1, 3) - Any::turn(1, 3)).degrees(), 120));
  CHECK(close((-Any::turn(1, 3)).degrees(), -120));
  CHECK(close(sin(Any::turn(1, 3)), 0.8660254));
  CHECK(close(cos(Any::turn(3, 8)), -0.7071068));
  CHECK(close(detent::atan2(S(3), S(-4)).radians(), 2.4980915));
  CHECK(close(detent::atan2(S(3), S(4)).degrees(), 36.8698976));
  auto angle = Any::turn(1, 8);
  angle += Any::turn(1, 8);
  angle -= Any::turn(1, 3);
  CHECK(close(angle.degrees(), -30));
  CHECK(Any() == Any::from_raw(0));
  const auto [sine, cosine] = sine_cosine(Any::turn(1, 3));
  CHECK(close(sine, 0.8660254));
  CHECK(close(cosine, -0.5));
}
