// SPDX-License-Identifier: MIT
#include "oracle/closest_points_exam.hpp"

namespace detent::oracle {
namespace {

TEMPLATE_TEST_CASE(
    "closest points of round shapes, short scalars: every coordinate is rounded once", "[oracle]",
    (test::Space<q8_8, 3>), (test::Space<q8_8, 2>)) {
  examine_round_points<typename TestType::scalar, TestType::dimension>(0xc10a, 60);
}

}  // namespace
}  // namespace detent::oracle
