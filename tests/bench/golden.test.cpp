// SPDX-License-Identifier: MIT
#include "bench/golden.hpp"

#include "bench/queries.hpp"
#include "support/catch.hpp"

using namespace detent;
using namespace detent::bench;

namespace {

// The hit counts that the benchmarks compare with, without the benchmarks.
const auto check = [](const auto& query) {
  const Golden* const golden = golden_for(query.name);
  INFO(query.name);
  REQUIRE(golden != nullptr);
  const auto drawn = draw_questions(query, default_seed, ordinary);
  CHECK(count_hits<q16_16>(query, as_questions<q16_16>(query, drawn)) == golden->ordinary);
};

}  // namespace

TEST_CASE("golden: raycasts have their hit counts") {
  visit_raycasts(check);
  visit_raycast_hits(check);
}
TEST_CASE("golden: contains queries have their hit counts") { visit_contains(check); }
TEST_CASE("golden: closest points have their hit counts") { visit_closest_points(check); }
TEST_CASE("golden: distances of points have their hit counts") { visit_distances(check); }
TEST_CASE("golden: overlaps have their hit counts") {
  visit_sphere_overlaps(check);
  visit_box_overlaps(check);
  visit_other_overlaps(check);
}
TEST_CASE("golden: segments have their hit counts") { visit_intersects(check); }
TEST_CASE("golden: hulls have their hit counts") { visit_hulls(check); }
TEST_CASE("golden: 2D shapes have their hit counts") { visit_planar(check); }
