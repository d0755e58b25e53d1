// SPDX-License-Identifier: MIT
#include "detent/query/kernel/planar_search.hpp"

#include <vector>

#include "support/catch.hpp"
#include "support/random.hpp"

namespace detent::test {
namespace {

using detail::PlanarSearch;
using Place = PlanarSearch::Place;

/// Whether the origin is in the triangle of three differences, its edges included.
template <Number T>
bool encloses_origin(const Vec<T, 2>& p, const Vec<T, 2>& q, const Vec<T, 2>& r) {
  const auto x = cross(p, q), y = cross(q, r), z = cross(r, p);
  return (x >= 0 && y >= 0 && z >= 0) || (x <= 0 && y <= 0 && z <= 0);
}

/// Bodies with places within `reach`: what is found must be optimal among all differences.
void compare(std::int32_t reach, std::size_t most, std::uint64_t seed) {
  Random random(seed);
  HitRate apart, enclosed;
  for (int i = 0; i < 3000; ++i) {
    CAPTURE(reach, most, seed, i);
    const auto place = [&] {
      return make_vec<2>([&](int) {
        return Place::from_raw(static_cast<std::int32_t>(random.between(-reach, reach)));
      });
    };
    const auto shift = random.coin() ? place() : Vec<Place, 2>{};
    PlanarSearch search;
    std::vector<Vec<Place, 2>> a(1 + random.below(most)), b(1 + random.below(most));
    for (auto& corner : a) search.a.add(corner = narrow<29>(place() + shift));
    for (auto& corner : b) search.b.add(corner = place());
    const bool is_found = search.find(place());
    REQUIRE(search.count() >= 1);
    REQUIRE(search.count() <= 3);
    const auto corner = [&](std::size_t k) { return b[search.index_b(k)] - a[search.index_a(k)]; };
    const auto& v = search.across();
    apart.count(is_found);
    if (!is_found) {
      enclosed.count(search.count() == 3);
      if (search.count() == 3) REQUIRE(encloses_origin(corner(0), corner(1), corner(2)));
      continue;
    }
    REQUIRE(search.count() <= 2);
    const auto height = dot(v, corner(0));
    for (const auto& p : a) {
      for (const auto& q : b) REQUIRE(dot(v, q - p) >= height);
    }
    if (search.count() == 1) {
      REQUIRE(v == narrow<29>(corner(0)));
    } else {
      REQUIRE(dot(v, corner(1)) == height);
      const auto edge = corner(1) - corner(0);
      REQUIRE(dot(edge, corner(0)) <= 0);
      REQUIRE(dot(edge, corner(1)) >= 0);
    }
  }
  INFO(reach << ", " << most << ": apart " << apart << ", enclosed " << enclosed);
  CHECK(apart.percent() >= 10);
  CHECK(enclosed.percent() >= 95);
}

TEST_CASE("planar search: exact positions give the closest feature of their differences") {
  compare(1 << 25, 4, 1);
  compare(1 << 25, 16, 2);
  compare(20, 16, 3);
  compare(3, 8, 4);
  compare(1, 3, 5);
}

}  // namespace
}  // namespace detent::test
