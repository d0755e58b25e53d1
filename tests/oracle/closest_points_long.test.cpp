// SPDX-License-Identifier: MIT
#include "oracle/closest_points_exam.hpp"

namespace detent::oracle {
namespace {

TEMPLATE_TEST_CASE("closest points, q24_8: every coordinate is the exact one rounded once",
                   "[oracle]", (test::Space<q24_8, 3>)) {
  examine_polytope_points<typename TestType::scalar, TestType::dimension>(0xc10b, 60);
}

}  // namespace
}  // namespace detent::oracle
