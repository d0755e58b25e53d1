// SPDX-License-Identifier: MIT
#include "detent/query/kernel/posed.hpp"

#include <array>

#include "math/frames.hpp"
#include "number/big_integer.hpp"
#include "oracle/space.hpp"
#include "support/catch.hpp"

namespace detent::test {
namespace {

TEMPLATE_TEST_CASE("posed bodies: the extreme corner along an axis, at any distance", "[kernel]",
                   DETENT_FIXED_SPACES) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  using P = detail::Posed<S>;
  using Corners = std::array<Vec<P, N>, 4>;
  Random random(0x905e);
  INFO(random);
  int wrong = 0, near_first = 0, far_from_first = 0;
  for (int i = 0; i < 4000; ++i) {
    const int bits = random.one_in(4) ? P::bits - 1 : 1 + i % (P::bits - 1);
    const int size = random.coin() ? bits : 1 + static_cast<int>(random.below(bits));
    const auto draw = [&](int length) {
      return make_vec<N>([&](int) { return fixed_from<P>(BigInteger(random.edgy(length))); });
    };
    const auto middle = draw(bits);
    Corners corners;
    bool is_far = false;
    for (auto& corner : corners) {
      corner = narrow<P::bits>(make_vec<N>([&, offset = draw(size)](int k) {
        return fixed_from<P>(big_raw(middle[k]) + big_raw(offset[k]));
      }));
      is_far = is_far || !fits<31>(corner - corners[0]);
    }
    (is_far ? far_from_first : near_first) += 1;
    const detail::PosedBody<P, N, Corners> body(corners);
    const auto axis = random_rotation<S, N>(random).axis(0);
    const auto along = [&](const auto& corner) {
      BigInteger sum = 0;
      for (int k = 0; k < N; ++k) sum += big_raw(axis[k]) * big_raw(corner[k]);
      return sum;
    };
    // The first of several that reach equally far.
    auto least = corners[0], most = corners[0];
    for (const auto& corner : corners) {
      if (along(corner) < along(least)) least = corner;
      if (along(corner) > along(most)) most = corner;
    }
    const auto from = draw(bits);
    wrong += body.extreme(axis, from, false) == least ? 0 : 1;
    wrong += body.extreme(axis, from, true) == most ? 0 : 1;
  }
  CHECK(wrong == 0);
  CHECK(near_first > 1000);
  if (P::bits > 31) CHECK(far_from_first > 50);
}

TEMPLATE_TEST_CASE("local corners: those of the greatest boxes fit", "[kernel]",
                   DETENT_FIXED_SPACES) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  // All edges along the same axis, so that they add up.
  std::array<Direction<S, N>, static_cast<std::size_t>(N)> axes;
  for (const auto& axis : {Direction<S, N>::along(0), -Direction<S, N>::along(0)}) {
    axes.fill(axis);
    for (const S& side : {S::lowest(), (S::max)()}) {
      for (const S& extent : {S::lowest(), (S::max)()}) {
        const Obb<S, N> box{make_vec<N>([&](int) { return side; }),
                            make_vec<N>([&](int) { return extent; }),
                            Rotation<S, N>::from_axes(axes)};
        const auto corners = detail::local_corners(box);
        for (std::size_t k = 0; k < corners.size(); ++k) {
          BigInteger sum = big_raw(side) * power_of_two(direction_component<S>::frac);
          for (int i = 0; i < N; ++i) {
            sum += ((k >> i & 1) != 0 ? 1 : -1) * big_raw(extent) * big_raw(axis[0]);
          }
          REQUIRE(big_raw(corners[k][0]) == sum);
        }
      }
    }
  }
}

}  // namespace
}  // namespace detent::test
