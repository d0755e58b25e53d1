// SPDX-License-Identifier: MIT
#include "detent/query/kernel/side_filter.hpp"

#include "detent/query/kernel/least_push.hpp"
#include "support/catch.hpp"
#include "support/random.hpp"

namespace detent::test {
namespace {

using Edge = Fixed<62, 0>;

Vec<Edge, 3> draw(Random& random, int bits) {
  return make_vec<3>([&](int) { return Edge::from_raw(random.wide(bits)); });
}

template <class Normal, class V>
int exact_sign(const Normal& normal, const V& v) {
  const auto along = dot(normal, v);
  return (along > 0) - (along < 0);
}

TEST_CASE("side_filter: the sign of a product, exactly", "[kernel]") {
  Random random(0x51de);
  int wrong = 0, zeros = 0;
  for (int i = 0; i < 20'000; ++i) {
    const int bits = 1 + i % 62;
    const auto e = draw(random, bits), f = draw(random, bits);
    const auto normal = cross(e, f);
    const detail::SideFilter side(normal);
    // In the plane, a step off it, and anywhere.
    auto v = random.coin() ? e : f;
    if (random.coin()) v[static_cast<int>(random.below(3))] = Edge::from_raw(random.wide(62));
    if (random.one_in(3)) {
      for (int k = 0; k < 3; ++k) v[k] = Edge::from_raw(v[k].raw() / 2 + random.between(-1, 1));
    }
    const int sign = exact_sign(normal, v);
    wrong += side.sign(v) == sign ? 0 : 1;
    zeros += sign == 0 ? 1 : 0;
  }
  CHECK(wrong == 0);
  CHECK(zeros > 2'000);
}

TEST_CASE("side_filter: what the leading bits drop may decide", "[kernel]") {
  // The leading bits of the product are 0, or have the wrong sign.
  const auto top = std::int64_t{1} << 61;
  const auto vec = [](std::int64_t x, std::int64_t y, std::int64_t z) {
    return Vec{Edge::from_raw(x), Edge::from_raw(y), Edge::from_raw(z)};
  };
  int wrong = 0;
  for (std::int64_t d = -4; d <= 4; ++d) {
    const auto normal = cross(vec(top, 0, 1), vec(d, top, 3));
    const detail::SideFilter side(normal);
    for (std::int64_t x = -4; x <= 4; ++x) {
      for (const auto& v : {vec(top, x, 1), vec(x, top, 3), vec(top - 1, top - x, d)}) {
        wrong += side.sign(v) == exact_sign(normal, v) ? 0 : 1;
      }
    }
  }
  CHECK(wrong == 0);
}

TEST_CASE("least_push: a depth is rounded up exactly, on a step and next to one", "[kernel]") {
  using Depth = detail::Depth<q16_16>;
  Random random(0x51df);
  int wrong = 0, on_step = 0;
  for (int i = 0; i < 20'000; ++i) {
    // A normal of the length 7 s, and a height of a whole number of steps, or one off.
    const std::int64_t s = 1 + static_cast<std::int64_t>(random.next() % (1 << 20));
    const std::int64_t depth = random.between(0, std::int64_t{1} << random.between(1, 26));
    const std::int64_t off = depth == 0 || random.coin() ? 0 : random.between(-1, 1);
    const auto raw = [](std::int64_t x) { return Fixed<61, 16>::from_raw(x); };
    const Vec normal{raw(2 * s), raw(-3 * s), raw(6 * s)};
    const auto height = Fixed<62, 32>::from_raw(7 * s * depth + off);
    const auto exact = depth + (off > 0 ? 1 : 0);
    const auto found = detail::depth_of_height<q16_16>(q16_16(0), height, normal);
    const auto same = detail::depth_of_height<q16_16>(q16_16(0), height, squared_length(normal));
    wrong += found == Depth::from_raw(static_cast<Depth::raw_type>(exact)) ? 0 : 1;
    wrong += found == same ? 0 : 1;
    on_step += off == 0 ? 1 : 0;
  }
  CHECK(wrong == 0);
  CHECK(on_step > 10'000);
}

}  // namespace
}  // namespace detent::test
