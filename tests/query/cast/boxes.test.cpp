// SPDX-License-Identifier: MIT
#include "query/cast/shapes.hpp"

namespace detent::test {
namespace {

TEMPLATE_TEST_CASE("cast: a box against every kind of shape", "[cast]", (Space<q16_16, 3>)) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  visit_boxes<S, N>(-3, [](const auto& shape) { check_casts<S, N>(shape); });
}

}  // namespace
}  // namespace detent::test
