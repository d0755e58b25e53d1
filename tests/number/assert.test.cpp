// SPDX-License-Identifier: MIT
#include "detent/number/assert.hpp"

#include "support/catch.hpp"

namespace {

TEST_CASE("assert: assertions are on in tests", "[number]") {
  STATIC_REQUIRE(DETENT_ASSERTIONS == 1);
}

TEST_CASE("assert: the condition is evaluated once", "[number]") {
  int evaluated = 0;
  DETENT_ASSERT(++evaluated == 1);
  CHECK(evaluated == 1);
}

}  // namespace
