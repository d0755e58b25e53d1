// SPDX-License-Identifier: MIT
#include "detent/number/quadratic.hpp"

#include "detent/query/raycast/sphere.hpp"
#include "support/catch.hpp"

using namespace detent;
using namespace detent::test;

TEMPLATE_TEST_CASE("Quadratic: the first root is the same digit by digit", "[number]", q16_16,
                   q14_16, q24_8, q8_8) {
  using S = TestType;
  using Raw = typename S::raw_type;
  Random random(0x40ad);
  INFO(random);
  const auto draw = [&](int bits) { return S::from_raw(static_cast<Raw>(random.edgy(bits))); };
  const auto draw_vec = [&](int bits) { return Vec<S, 3>{draw(bits), draw(bits), draw(bits)}; };
  int roots = 0;
  for (int i = 0; i < 40'000; ++i) {
    const int bits = static_cast<int>(random.between(2, S::bits));
    const auto center = draw_vec(bits), origin = draw_vec(bits), beside = draw_vec(bits / 2);
    const auto aim = (center - origin) + beside;
    const auto direction = direction_of<S>(aim);
    if (!direction) continue;
    // Spheres through the target nearly touch most rays.
    auto radius = random.coin() ? length(beside) : draw(bits);
    if (random.coin()) radius = nearest_to<S>(radius + S::from_raw(1));
    const detail::RaySphere<S, 3> meeting(Ray<S, 3>{origin, *direction}, {center, radius});
    const auto quadratic = meeting.quadratic();
    if (radius < 0 || meeting.c <= 0 || meeting.b >= 0 || !quadratic.has_roots()) continue;
    const auto root = quadratic.template first_root<S>(S::max());
    ++roots;
    for (const S limit : {S::max(), root.value_or(S(0)), draw(bits)}) {
      if (limit < 0) continue;
      if (quadratic.template first_root<S>(limit) !=
          quadratic.template first_root_by_digits<S>(limit)) {
        FAIL("center " << center.x.raw() << ", case " << i << ", limit " << limit.raw());
      }
    }
  }
  CHECK(roots > 10'000);
}
