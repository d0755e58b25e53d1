// SPDX-License-Identifier: MIT
#include "detent/number/filter/residue.hpp"

#include <cstdint>

#include "detent/math/vec.hpp"
#include "support/catch.hpp"
#include "support/random.hpp"

using namespace detent;
using namespace detent::test;

TEST_CASE("residue: a volume that is not 0 modulo 2^64 is not 0") {
  using V = Vec<Fixed<32, 16>, 3>;
  Random random(20261124);
  INFO(random);
  int wrong = 0, zeros = 0, unsure = 0;
  for (int i = 0; i < 40'000; ++i) {
    // A quarter are multiples of 2^22 steps, whose volumes are of 2^66.
    const std::int64_t step = i % 4 == 2 ? std::int64_t{1} << 22 : 1;
    const auto draw = [&] {
      return Fixed<32, 16>::assume_raw(random.edgy(step == 1 ? 31 : 9) * step);
    };
    const V a{draw(), draw(), draw()},
        b{draw(), draw(), draw()};  // every second c is in their plane
    const V c = i % 2 == 0 ? V{draw(), draw(), draw()} : narrow<32>(a + b);
    const bool is_zero = dot(a, cross(b, c)) == 0;
    const auto filtered = is_zero_volume(to_array(a), to_array(b), to_array(c));
    wrong += filtered == Filtered::yes || (is_zero && filtered == Filtered::no) ? 1 : 0;
    zeros += is_zero ? 1 : 0;
    unsure += !is_zero && filtered == Filtered::unsure ? 1 : 0;
  }
  CHECK(wrong == 0);
  CHECK(zeros >= 20'000);
  CHECK(unsure > 4'000);
  CHECK(unsure < 12'000);
}
