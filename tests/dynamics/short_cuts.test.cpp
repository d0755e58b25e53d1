// SPDX-License-Identifier: MIT
// The solver's fast arithmetic equals its specification: the exact sum or quotient, rounded once.
// Many inputs are near ties or at the ends of ranges.

#include <array>

#include "support/catch.hpp"

#include "detent/dynamics/joint/row.hpp"
#include "dynamics/stage.hpp"
#include "support/random.hpp"

namespace detent {
namespace {

using F = detail::Formats<q16_16>;

/// A number of T, often near the ends or 0, or with many trailing zeros.
template <class T>
T draw(test::Random& random, int bits = T::bits) {
  auto raw = random.between(-(std::int64_t{1} << bits) + 1, (std::int64_t{1} << bits) - 1);
  const auto zeros = random.between(0, bits);
  if (random.coin()) raw = raw >> zeros << zeros;
  if (random.coin()) raw >>= random.between(0, bits);
  raw += random.between(-1, 1);
  const auto end = (std::int64_t{1} << bits) - 1;
  raw = raw > end ? end : raw < -end ? -end : raw;
  return T::assume_raw(static_cast<typename T::raw_type>(raw));
}

template <class T, class Short, class Long>
void check_dots(test::Random& random) {
  for (int k = 0; k < 20000; ++k) {
    const auto a = make_vec<3>([&](int) { return draw<Short>(random, 30); });
    auto b = make_vec<3>([&](int) { return draw<Long>(random); });
    if (random.coin()) b.y = b.z = Long();
    REQUIRE(detail::nearest_dot<T>(a, b) == nearest_to<T>(dot(a, b)));
  }
}

/// A push along axis I of the world, against the one along its unit vector.
template <int I>
void check_axis(test::Random& random) {
  using S = q16_16;
  const auto three = [&](auto number) {
    using T = decltype(number);
    return std::array<T, 3>{draw<T>(random), draw<T>(random), draw<T>(random)};
  };
  Vec<F::Ratio, 3> axis{};
  axis[I] = F::Ratio(1);
  for (int k = 0; k < 20000; ++k) {
    detail::Spread<F::Gyration, 3> spread{};
    for (auto& x : spread) x = draw<F::Gyration>(random, random.coin() ? 52 : 36);
    detail::Row<S, 3> row, wanted;
    const auto arm = from_array(three(F::Arm()));
    wanted.moment_a = detail::moment<S, 3>(arm, axis);
    wanted.response_a = detail::response<S, 3>(spread, wanted.moment_a);
    const auto gives = detail::turn_about_axis<I, S>(arm, spread, row.moment_a, row.response_a);
    REQUIRE(gives == detail::give<S, 3>(wanted.moment_a, wanted.response_a));
    REQUIRE(row.moment_a == wanted.moment_a);
    REQUIRE(row.response_a == wanted.response_a);
    row.moment_b = detail::moment<S, 3>(from_array(three(F::Arm())), axis);
    row.response_b = three(F::Response());

    detail::Moving<S, 3> a, b;
    for (auto* body : {&a, &b}) {
      body->velocity = from_array(three(F::Speed()));
      body->spin = three(F::Spin());
    }
    REQUIRE(detail::rate_along_axis<I, S>(row, a, b) ==
            detail::rate_along<S, 3>(axis, row, a.velocity, a.spin, b.velocity, b.spin));
    detail::Thrust<S, 3> thrust{axis, {}, {}};
    thrust.on_a[I] = draw<F::Ratio>(random, 30);
    thrust.on_b[I] = draw<F::Ratio>(random, 30);
    const auto impulse = draw<F::Impulse>(random);
    auto other_a = a, other_b = b;
    detail::apply(thrust, row, impulse, a, b);
    detail::apply_along_axis<I, S>(thrust, row, impulse, other_a, other_b);
    REQUIRE(a.velocity == other_a.velocity);
    REQUIRE(b.velocity == other_b.velocity);
    REQUIRE(a.spin == other_a.spin);
    REQUIRE(b.spin == other_b.spin);
  }
}

}  // namespace

TEST_CASE("sums of long products are rounded once") {
  test::Random random(1);
  check_dots<F::FineSpin, F::Ratio, F::FineSpin>(random);
  check_dots<F::Spin, F::Ratio, F::FineSpin>(random);
  check_dots<F::Gyration, F::Ratio, F::Gyration>(random);
  check_dots<F::Response, F::Moment, F::Gyration>(random);
}

TEST_CASE("sums right next to a tie are rounded by all their bits") {
  using Long = F::FineSpin;
  // 2^-30 * (2^29 + 2^22) and less or more by one step of the product: ties of 2^-44 and next to
  const Vec<F::Ratio, 3> a{F::Ratio::assume_raw(1), F::Ratio::assume_raw(1),
                           F::Ratio::assume_raw(-1)};
  for (std::int64_t whole = -5; whole <= 5; ++whole) {
    for (std::int64_t rest = -2; rest <= 2; ++rest) {
      const auto tie = (whole << 30) + (std::int64_t{1} << 29) + rest;
      const Vec<Long, 3> b{Long::assume_raw(tie), Long::assume_raw(3), Long::assume_raw(3)};
      REQUIRE(detail::nearest_dot<Long>(a, b) == nearest_to<Long>(dot(a, b)));
    }
  }
}

TEST_CASE("quotients by numbers near 1 are rounded once") {
  using T = Fixed<62, 60>;
  test::Random random(2);
  const std::int64_t one = std::int64_t{1} << 60, half = std::int64_t{1} << 29;
  for (int k = 0; k < 200000; ++k) {
    const auto e =
        random.between(-(std::int64_t{1} << 33), std::int64_t{1} << 33) >> random.between(0, 33);
    const T d = T::assume_raw(one + e);
    // A quotient within a few steps of 2^-60 of a tie.
    const auto step = random.between(-(std::int64_t{1} << 30), (std::int64_t{1} << 30) - 1);
    const auto close = (step << 30) + half + random.between(-100, 100);
    auto n = close + ((close >> 30) * e >> 30);
    n = n > one + e ? one + e : n < -one - e ? -one - e : n;
    const T numerator = T::assume_raw(random.coin() ? n : random.between(-one - e, one + e));
    REQUIRE(detail::quotient_of_near_one<F::Ratio>(numerator, d) ==
            quotient_nearest<F::Ratio>(numerator, d));
  }
}

TEST_CASE("quotients of long numbers are rounded once") {
  using T = F::TurnShare;
  using Whole = Fixed<53, F::Gyration::frac>;
  test::Random random(5);
  for (int k = 0; k < 100000; ++k) {
    auto d = draw<Whole>(random, static_cast<int>(random.between(2, 53)));
    auto n = draw<F::Gyration>(random);
    if (random.coin()) {  // a tie, or next to one
      const auto m = random.between(1, (1 << 20) - 1),
                 odd = 2 * random.between(-(1 << 30), 1 << 30) + 1;
      d = Whole::assume_raw(m << (T::frac + 1));
      n = F::Gyration::assume_raw(m * odd + random.between(-1, 1));
    }
    if (d <= 0) continue;
    REQUIRE(detail::quotient_of_long<T>(n, d) == quotient_nearest<T>(n, d));
  }
}

TEST_CASE("impulses are rounded and clamped per component") {
  test::Random random(3);
  for (int k = 0; k < 50000; ++k) {
    const auto share = make_vec<3>([&](int) { return draw<F::Response>(random); });
    const auto impulse = draw<F::Impulse>(random);
    const auto before = make_vec<3>([&](int) { return draw<F::Spin>(random); });
    auto up = before, down = before;
    detail::push_each<1, 3, F::Spin>(share, impulse, up);
    detail::push_each<-1, 3, F::Spin>(share, impulse, down);
    for (int i = 0; i < 3; ++i) {
      const auto part = nearest_to<F::Spin>(share[i] * impulse);
      REQUIRE(up[i] == saturate_to<F::Spin>(before[i] + part));
      REQUIRE(down[i] == saturate_to<F::Spin>(before[i] - part));
    }
  }
}

TEST_CASE("pushes of joints along an axis of the world equal those along its unit vector") {
  test::Random random(6);
  check_axis<0>(random);
  check_axis<1>(random);
  check_axis<2>(random);
}

TEST_CASE("turns of joints are rounded and clamped per component") {
  test::Random random(7);
  for (int k = 0; k < 50000; ++k) {
    detail::TurnRow<q16_16, 3> row;
    detail::Moving<q16_16, 3> a, b;
    for (std::size_t i = 0; i < 3; ++i) {
      row.on_a[i] = draw<F::TurnShare>(random);
      row.on_b[i] = draw<F::TurnShare>(random);
      a.spin[i] = draw<F::Spin>(random);
      b.spin[i] = draw<F::Spin>(random);
    }
    const auto turn = random.one_in(8) ? F::Turn() : draw<F::Turn>(random);
    const auto from_a = a.spin, from_b = b.spin;
    detail::apply(row, turn, a, b);
    for (std::size_t i = 0; i < 3; ++i) {
      const auto part_a = nearest_to<F::Spin>(row.on_a[i] * turn),
                 part_b = nearest_to<F::Spin>(row.on_b[i] * turn);
      REQUIRE(a.spin[i] == saturate_to<F::Spin>(from_a[i] - part_a));
      REQUIRE(b.spin[i] == saturate_to<F::Spin>(from_b[i] + part_b));
    }
  }
}

TEST_CASE("a strip sweep finds exactly the pairs whose bounds overlap") {
  using Entry = detail::SweepEntry<q16_16, 3>;
  test::Random random(4);
  std::vector<Entry> members;  // as a world keeps them from step to step
  for (const int count : {1, 2, 63, 64, 2500, 200}) {
    std::vector<Entry> entries;
    for (int i = 0; i < count; ++i) {
      Entry entry;
      entry.body = static_cast<std::uint32_t>(i);
      const int large = i % 50 == 0 ? 20 : 1;
      for (int axis = 0; axis < 3; ++axis) {
        const auto least = random.between(-40, 40), size = random.between(0, 4 * large);
        entry.bounds.least[axis] = F::Bound(static_cast<int>(least));
        entry.bounds.most[axis] = F::Bound(static_cast<int>(least + size));
      }
      entries.push_back(entry);
    }
    std::vector<detail::BodyPair> wanted, found, found_in_copies;
    for (const auto& a : entries) {
      for (const auto& b : entries) {
        bool overlap = a.body < b.body;
        for (int axis = 0; axis < 3; ++axis) {
          overlap = overlap && a.bounds.least[axis] <= b.bounds.most[axis] &&
                    b.bounds.least[axis] <= a.bounds.most[axis];
        }
        if (overlap) wanted.push_back({a.body, b.body});
      }
    }
    std::vector<std::uint32_t> lane;
    auto sorted = entries, room = entries;
    detail::order_entries(sorted);
    detail::order_entries(entries, room, lane);
    for (std::size_t i = 0; i < entries.size(); ++i) REQUIRE(entries[i].body == sorted[i].body);
    detail::sweep(entries.data(), entries.size(), lane,
                  [&](const detail::BodyPair& pair) { found.push_back(pair); });
    detail::sweep(entries.data(), entries.size(), members, lane,
                  [&](const detail::BodyPair& pair) { found_in_copies.push_back(pair); });
    std::sort(found.begin(), found.end());
    REQUIRE(found == wanted);
    std::sort(found_in_copies.begin(), found_in_copies.end());
    REQUIRE(found_in_copies == wanted);
  }
}

TEST_CASE("counted pairs are in order of their bodies") {
  test::Random random(11);
  for (const std::uint32_t count : {1u, 2u, 40u, 700u}) {
    std::vector<detail::BodyPair> pairs, room;
    for (int i = 0; i < 2000; ++i) {
      const auto a = static_cast<std::uint32_t>(random.below(count));
      pairs.push_back({a, static_cast<std::uint32_t>(random.below(count))});
    }
    auto wanted = pairs;
    std::sort(wanted.begin(), wanted.end());
    std::vector<std::uint32_t> ends;
    detail::order_pairs(pairs, room, ends, count);
    REQUIRE(pairs == wanted);
  }
}

template <Scalar S>
void check_shares_of_steps() {
  using Foot = typename detail::ContactFormats<S>::Foot;
  using Step = Fixed<32, detail::Formats<S>::Lever::frac>;
  using Whole = Fixed<62, 40>;
  test::Random random(21);
  int unsure = 0;
  for (int i = 0; i < 200000; ++i) {
    const auto word = [&](int bits) {
      return static_cast<std::int64_t>(random.between(1, std::int64_t{1} << (bits - 1)));
    };
    std::int64_t under = 1 + word(2 + static_cast<int>(random.below(60)));
    std::int64_t step = word(1 + static_cast<int>(random.below(32)));
    std::int64_t over = 1 + static_cast<std::int64_t>(random.between(0, under - 2));
    if (i % 2 == 0) {  // 2^8 step over / under is at, or next to, half a step
      under = std::int64_t{1} << (10 + random.below(30));
      step |= 1;
      over = (under >> 9) * (2 * static_cast<std::int64_t>(random.between(0, 255)) + 1);
      over += static_cast<std::int64_t>(random.between(-1, 1));
      if (over <= 0 || over >= under) continue;
      ++unsure;
    }
    if (random.coin()) step = -step;
    const auto ratio = make_ratio_below_one(Whole::assume_raw(over), Whole::assume_raw(under));
    const auto x = Step::assume_raw(step);
    REQUIRE(detail::share_of_step<Foot>(x, ratio) ==
            quotient_nearest<Foot>(x * ratio.over, ratio.under));
  }
  CHECK(unsure > 50000);
}

TEST_CASE("shares of steps are their quotients, rounded once, at midpoints too") {
  check_shares_of_steps<q16_16>();
  check_shares_of_steps<q24_8>();
  check_shares_of_steps<q8_8>();
}

TEST_CASE("a base plus a rounded number is the rounded sum, at ties and ends of the range too") {
  using Lever = F::Lever;
  using Long = Fixed<62, Lever::frac + 30>;
  test::Random random(31);
  constexpr std::int64_t half = std::int64_t{1} << 29;
  for (int i = 0; i < 200000; ++i) {
    const auto base = Lever::assume_raw(static_cast<std::int32_t>(
        random.between(-(std::int64_t{1} << 31), (std::int64_t{1} << 31) - 1)));
    auto raw =
        static_cast<std::int64_t>(random.between(-(std::int64_t{1} << 62), std::int64_t{1} << 62));
    if (i % 2 == 0) {
      raw = static_cast<std::int64_t>(random.between(-5, 5)) * 2 * half + half +
            static_cast<std::int64_t>(random.between(-1, 1));
    }
    const auto x = Long::assume_raw(raw);
    REQUIRE(detail::plus_nearest(base, x) == nearest_to<Lever>(base + x));
  }
}

TEST_CASE("balls and capsules whose centers are apart have no manifold") {
  using Lever = F::Lever;
  test::Random random(41);
  const auto margin = nearest_to<F::Gap>(q16_16::from_raw(1311));
  int apart = 0, together = 0, close = 0;
  for (int i = 0; i < 40000; ++i) {
    const auto number = [&](int most) {
      return q16_16::from_raw(static_cast<std::int32_t>(random.between(-most, most)));
    };
    const auto capsule = [&] {
      Capsule<q16_16, 3> result;
      for (int k = 0; k < 3; ++k) {
        result.a[k] = random.coin() ? number(40000) : q16_16(0);
        result.b[k] = saturate_to<q16_16>(-result.a[k]);
      }
      result.radius = nearest_to<q16_16>(abs(number(30000)));
      return result;
    };
    const auto a = capsule(), b = capsule();
    const auto reach_a = detail::extent_of(a), reach_b = detail::extent_of(b);
    // Along the axis of the coordinate in which the reach is the capsule's own.
    Vec<Lever, 3> offset;
    auto reach = a.radius + b.radius + margin;
    Fixed<40, 22> sum(reach);
    for (int k = 0; k < 3; ++k) {
      sum = narrow<40>(sum + (reach_a.half_extents[k] + reach_b.half_extents[k]));
    }
    const int axis = static_cast<int>(random.below(3));
    const auto beyond =
        random.coin() ? random.between(-(1 << 22), 1 << 22) : random.between(900, 1100);
    offset[axis] = Lever::assume_raw(static_cast<std::int32_t>(sum.raw() + beyond));
    detail::RelativePose<q16_16, 3> pose;
    for (int k = 0; k < 3; ++k) {
      pose.axes[static_cast<std::size_t>(k)] = detail::unit_axis<F::Ratio, 3>(k);
    }
    pose.translation = offset;
    const bool are_apart = detail::centers_are_apart(reach_a, reach_b, offset, margin);
    const bool touch = detail::manifold(a, b, pose, margin).count != 0;
    REQUIRE_FALSE((are_apart && touch));
    ++(are_apart ? apart : together);
    close += touch ? 1 : 0;
  }
  CHECK(apart > 8000);
  CHECK(together > 8000);
  CHECK(close > 100);
}

}  // namespace detent
