// SPDX-License-Identifier: MIT
#include "oracle/closest_points_exam.hpp"

namespace detent::oracle {
namespace {

TEMPLATE_TEST_CASE("closest points, short scalars: every coordinate is the exact one rounded once",
                   "[oracle]", (test::Space<q8_8, 3>), (test::Space<q8_8, 2>)) {
  examine_polytope_points<typename TestType::scalar, TestType::dimension>(0xc109, 60);
}

}  // namespace
}  // namespace detent::oracle
