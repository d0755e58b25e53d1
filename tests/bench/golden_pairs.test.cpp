// SPDX-License-Identifier: MIT
#include "bench/golden.hpp"
#include "bench/pairs.hpp"
#include "support/catch.hpp"

using namespace detent;
using namespace detent::bench;

namespace {

// The hit counts that the benchmarks of two solid shapes compare with, without the benchmarks.
const auto check = [](const auto& query) {
  const Golden* const golden = golden_for(query.name);
  INFO(query.name);
  REQUIRE(golden != nullptr);
  const auto drawn = draw_questions(query, default_seed, ordinary);
  CHECK(count_hits<q16_16>(query, as_questions<q16_16>(query, drawn)) == golden->ordinary);
};

}  // namespace

TEST_CASE("golden: distances of two shapes have their hit counts") {
  visit_round_distances(check);
  visit_flat_distances(check);
}
TEST_CASE("golden: closest points of two shapes have their hit counts") {
  visit_round_closest_points(check);
  visit_flat_closest_points(check);
  visit_hull_closest_points(check);
}
TEST_CASE("golden: contacts have their hit counts") {
  visit_round_contacts(check);
  visit_flat_contacts(check);
  visit_hull_contacts(check);
}
TEST_CASE("golden: casts have their hit counts") {
  visit_round_casts(check);
  visit_capsule_casts(check);
  visit_flat_casts(check);
}
