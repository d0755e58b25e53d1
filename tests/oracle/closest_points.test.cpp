// SPDX-License-Identifier: MIT
#include "oracle/closest_points_exam.hpp"

namespace detent::oracle {
namespace {

TEMPLATE_TEST_CASE("closest points: every coordinate is the exact one rounded once", "[oracle]",
                   (test::Space<q16_16, 3>)) {
  examine_polytope_points<typename TestType::scalar, TestType::dimension>(0xc105, 60);
}

}  // namespace
}  // namespace detent::oracle
