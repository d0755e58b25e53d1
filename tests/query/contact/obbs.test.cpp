// SPDX-License-Identifier: MIT
#include "detent/query/contact/obbs.hpp"

#include "detent/query/contact/pair.hpp"
#include "support/catch.hpp"
#include "support/random_vec.hpp"

namespace detent::test {
namespace {

struct Count {
  HitRate hits;
  int direct = 0, points = 0;
};

/// The contact by cosines is that of the boxes as any bodies, by the exact axes.
template <Scalar S>
void compare(const Obb<S, 3>& a, const Obb<S, 3>& b, Count& count) {
  const auto expected = detail::contact_of_bodies<S, 3>(a, b, S(0), S(0), detail::AnyAxis());
  count.hits.count(expected.has_value());
  REQUIRE(contact(a, b) == expected);
  const detail::AxisFilter<S> filter(a, b);
  const auto found = detail::ObbsContact<S>(a, b, filter).find();
  if (!found) return;
  REQUIRE(found == expected);
  ++count.direct;
  count.points += static_cast<int>(found->count);
}

/// Boxes within `reach` steps, some of them thin, left-handed or skewed by steps of the directions.
template <Scalar S>
void compare_many(std::int64_t reach, int asked, Count& count) {
  Random random(static_cast<std::uint64_t>(reach));
  const auto vector = [&](std::int64_t low, std::int64_t high) {
    return random_vec<S, 3>(random, low, high);
  };
  const auto rotation = [&] {
    const auto angle = [&] {
      return Angle<S>::from_raw(static_cast<std::uint32_t>(random.next()));
    };
    const auto x = angle(), y = angle();
    auto turned = Rotation<S, 3>::from_euler(x, y, angle());
    if (random.one_in(4)) {
      turned = Rotation<S, 3>::from_axes({turned.axis(1), turned.axis(0), turned.axis(2)});
    }
    return turned;
  };
  const auto extents = [&] {
    auto half = vector(reach / 8, reach);
    if (random.one_in(4)) half[random.coin() ? 0 : 2] = random.number<S>(0, 64);
    return half;
  };
  for (int i = 0; i < asked; ++i) {
    CAPTURE(reach, i);
    Obb<S, 3> a{vector(-reach, reach), extents(), rotation()};
    Obb<S, 3> b{vector(-reach, reach), extents(), rotation()};
    if (random.one_in(4)) {
      // A corner of b near an edge of a.
      const auto corner = [&](const Obb<S, 3>& box) {
        return nearest_to<S>(detail::body_of(box).corner(random.below(8)));
      };
      const auto shift = corner(a) - corner(b);
      b.center = nearest_to<S>(b.center + shift + vector(-4, 4));
      const int k = random.coin() ? 0 : 1;
      const auto along = a.rotation.axis(k) * random.number<S>(-reach, reach);
      b.center = nearest_to<S>(b.center + along);
    }
    compare<S>(a, b, count);
  }
}

TEST_CASE("contact of two OBBs: by cosines it is that of any two bodies", "[query]") {
  Count count;
  for (const std::int64_t reach : {64, 1 << 10, 1 << 13, 1 << 17, 1 << 22}) {
    compare_many<q16_16>(reach, 2000, count);
  }
  compare_many<q24_8>(1 << 18, 500, count);
  INFO(count.hits);
  CHECK(count.hits.is_balanced());
  CHECK(count.direct > 2000);
  CHECK(count.points > count.direct * 3 / 2);
}

TEST_CASE("contact of two OBBs: corners near the edges of the other's face", "[query]") {
  // The lowest corner of one cube is a little below the upper face of another, and passes its edge.
  Count count;
  const auto half = q16_16(1);
  const Obb<q16_16, 3> a{{}, {half, half, half}, {}};
  for (int degrees = 3; degrees < 45; degrees += 7) {
    const auto angle = [](int x) { return Angle<q16_16>::from_degrees(q16_16(x)); };
    const auto turn = Rotation<q16_16, 3>::from_euler(angle(degrees), angle(degrees), angle(2));
    Obb<q16_16, 3> b{{}, {half, half, half}, turn};
    auto lowest = nearest_to<q16_16>(detail::body_of(b).corner(0));
    for (std::size_t k = 1; k < 8; ++k) {
      const auto corner = nearest_to<q16_16>(detail::body_of(b).corner(k));
      if (corner.z < lowest.z) lowest = corner;
    }
    for (const int side : {-1, 1}) {
      for (int i = -60; i <= 60; ++i) {
        CAPTURE(degrees, side, i);
        const Vec target{q16_16(0), q16_16::from_raw(65536 * side + i), q16_16::from_raw(61440)};
        b.center = nearest_to<q16_16>(target - lowest);
        compare<q16_16>(a, b, count);
        compare<q16_16>(b, a, count);
      }
    }
  }
  CHECK(count.direct > 500);
}

}  // namespace
}  // namespace detent::test
