// SPDX-License-Identifier: MIT
#include "detent/query/contact/spheres.hpp"

#include "detent/query/contact.hpp"
#include "support/catch.hpp"
#include "support/random.hpp"

namespace detent::test {
namespace {

/// Compares with capsules without length, which the general search finds.
template <Scalar S, int N>
void compare_spheres(std::int64_t reach) {
  Random random(static_cast<std::uint64_t>(reach));
  HitRate hits;
  int touching = 0;
  const auto number = [&](std::int64_t low, std::int64_t high) {
    return random.number<S>(low, high);
  };
  for (int i = 0; i < 1500; ++i) {
    const auto sphere = [&] {
      const auto center = make_vec<N>([&](int) { return number(-reach / 2, reach / 2); });
      return Sphere<S, N>{center, random.one_in(8) ? S(0) : number(0, reach / 2)};
    };
    auto a = sphere(), b = sphere();
    // Often the same center, or exactly touching along an axis.
    if (random.one_in(8)) b.center = a.center;
    if (random.one_in(4)) {
      b.center = a.center;
      b.center[1] = nearest_to<S>(b.center[1] + a.radius + b.radius);
    }
    const auto found = contact(a, b);
    const auto general = contact(Capsule<S, N>{a.center, a.center, a.radius},
                                 Capsule<S, N>{b.center, b.center, b.radius});
    INFO(random << ", pair " << i);
    REQUIRE(found == general);
    hits.count(found.has_value());
    touching += found && found->depth == S(0);
  }
  INFO(hits << ", " << touching << " touching");
  CHECK(hits.percent() >= 30);
  CHECK(hits.percent() <= 95);
  CHECK(touching > 50);
}

template <Scalar S, int N>
void compare_sizes() {
  const auto most = static_cast<std::int64_t>(S::max().raw());
  for (const std::int64_t reach : {std::int64_t{9}, std::int64_t{40}, most / 64, most}) {
    compare_spheres<S, N>(reach);
  }
}

TEST_CASE("contact of two spheres: the same as of capsules without length", "[query]") {
  compare_sizes<q16_16, 3>();
  compare_sizes<q16_16, 2>();
  compare_sizes<q24_8, 3>();
  compare_sizes<q14_16, 3>();
  compare_sizes<q8_8, 3>();
}

}  // namespace
}  // namespace detent::test
