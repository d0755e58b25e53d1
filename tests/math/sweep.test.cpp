// SPDX-License-Identifier: MIT
#include "detent/math/sweep.hpp"

#include <array>
#include <cmath>

#include "detent/math/slerp.hpp"
#include "math/frames.hpp"
#include "oracle/space.hpp"
#include "support/catch.hpp"

namespace detent::test {
namespace {

using Vec3 = Vec<q16_16, 3>;
using Rotation3 = Rotation<q16_16, 3>;
using Time = direction_component<q16_16>;

constexpr Rotation3 quarter =
    *Rotation3::from_quaternion(q16_16(0), q16_16(0), q16_16(1), q16_16(1));
constexpr Sweep<q16_16, 3> swing{
    {q16_16(2), q16_16(0), q16_16(0)}, {q16_16(4), q16_16(-6), q16_16(0)}, {}, quarter};

static_assert(transform_at(swing, Time(0)) == Transform<q16_16, 3>{swing.start, {}});
static_assert(transform_at(swing, Time(1)) == Transform<q16_16, 3>{swing.end, quarter});
static_assert(transform_at(swing, Time(-1)) == transform_at(swing, Time(0)));
static_assert(transform_at(swing, Time::from_raw(Time(1).raw() + 1)) ==
              transform_at(swing, Time(1)));
static_assert(transform_at(swing, quotient_nearest<Time>(1, 2)).translation ==
              Vec3{q16_16(3), q16_16(-3), q16_16(0)});
static_assert(Sweep{Vec3{}, Vec3{}}.end_rotation == Rotation3());

TEMPLATE_TEST_CASE("sweep: rotates by the interpolated quaternion of its ends", "",
                   DETENT_FIXED_SPACES) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  using C = direction_component<S>;
  Random random(0x53e9);
  INFO(random);
  for (int i = 0; i < 2000; ++i) {
    const Sweep<S, N> sweep{{}, {}, random_rotation<S, N>(random), random_rotation<S, N>(random)};
    const C t = C::from_raw(static_cast<typename C::raw_type>(random.between(0, C(1).raw())));
    const auto rotation = transform_at(sweep, t).rotation;
    if constexpr (N == 3) {
      const auto p = Quat<S>::from_rotation(sweep.start_rotation);
      const auto q = Quat<S>::from_rotation(sweep.end_rotation);
      std::array<long double, 4> blend{};
      long double squared = 0;
      const long double way = dot(p, q) < 0 ? -1 : 1, at = static_cast<double>(t);
      for (int k = 0; k < 4; ++k) {
        auto& x = blend[static_cast<std::size_t>(k)];
        x = (1 - at) * static_cast<double>(p.vec()[k]) + at * way * static_cast<double>(q.vec()[k]);
        squared += x * x;
      }
      const auto [x, y, z, w] = blend;
      const std::array<long double, 3> first{1 - 2 * (y * y + z * z) / squared,
                                             2 * (x * y + w * z) / squared,
                                             2 * (x * z - w * y) / squared};
      for (int j = 0; j < 3; ++j) {
        const auto off =
            static_cast<double>(rotation.axis(0)[j]) - first[static_cast<std::size_t>(j)];
        REQUIRE(std::abs(off) < 4 * std::ldexp(1.0L, -C::frac));
      }
    } else {
      // On the shorter arc between the two directions: within half their angle of their sum.
      const auto u = sweep.start_rotation.axis(0), v = sweep.end_rotation.axis(0);
      const auto w = rotation.axis(0);
      const double turn = static_cast<double>(cross(u.vec(), v.vec()));
      const double first = static_cast<double>(cross(u.vec(), w.vec()));
      const double rest = static_cast<double>(cross(w.vec(), v.vec()));
      const double unit = std::ldexp(4.0, -C::frac);
      REQUIRE((turn > unit ? first > -unit && rest > -unit : true));
      REQUIRE((turn < -unit ? first < unit && rest < unit : true));
    }
  }
}

TEMPLATE_TEST_CASE("sweep: no point deviates from uniform motion by more than the bend", "",
                   DETENT_FIXED_SPACES) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  using C = direction_component<S>;
  Random random(0xbe4d);
  INFO(random);
  double closest = 0;
  for (int i = 0; i < 3000; ++i) {
    const Sweep<S, N> sweep{{}, {}, random_rotation<S, N>(random), random_rotation<S, N>(random)};
    const detail::Turn<S, N> turn(sweep);
    const auto bend = static_cast<double>(turn.bend());
    REQUIRE((bend >= 0 && bend < 2.01));
    const auto low = random.between(0, C(1).raw()), high = random.between(low, C(1).raw());
    const auto time = [](std::int64_t raw) {
      return C::from_raw(static_cast<typename C::raw_type>(raw));
    };
    const auto a = turn.at(time(low)), b = turn.at(time(high)),
               middle = turn.at(time((low + high) / 2));
    const double d = std::ldexp(static_cast<double>(high - low), -C::frac);
    double squared = 0;
    for (int j = 0; j < N; ++j) {
      const double even =
          (static_cast<double>(a.axis(0)[j]) + static_cast<double>(b.axis(0)[j])) / 2;
      squared += std::pow(static_cast<double>(middle.axis(0)[j]) - even, 2);
    }
    const double strays = std::sqrt(squared), unit = std::ldexp(1.0, -C::frac);
    REQUIRE(strays <= bend * d * d + 8 * unit);
    if (d > 0.1) closest = std::max(closest, (strays - 8 * unit) / (bend * d * d));
  }
  CHECK(closest > 0.5);
}

}  // namespace
}  // namespace detent::test
