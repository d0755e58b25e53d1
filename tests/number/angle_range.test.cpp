// SPDX-License-Identifier: MIT
#include "detent/number/angle_range.hpp"

#include "support/catch.hpp"

using namespace detent;

TEST_CASE("sum_within: neither wraps nor leaves the limits") {
  using A = Angle<q16_16>;
  const A low = A::turn(-1, 5), high = A::turn(1, 6), none;
  CHECK(sum_within(A::turn(1, 8), A::turn(1, 64), low, high) == A::turn(9, 64));
  CHECK(sum_within(A::turn(1, 8), A::turn(1, 8), low, high) == high);
  CHECK(sum_within(A::turn(1, 8), A::turn(1, 2), low, high) == high);
  CHECK(sum_within(A::turn(-1, 8), A::turn(-49, 100), low, high) == low);
  CHECK(sum_within(none, none, A::turn(1, 4), A::turn(1, 3)) == A::turn(1, 4));
  CHECK(sum_within(none, none, high, low) == high);
  CHECK(sum_within(A::turn(1, 2), A::turn(1, 2), A::turn(-49, 100), A::turn(1, 2)) ==
        A::turn(1, 2));
  using F = Angle<float>;
  CHECK(sum_within(F::turn(1, 3), F::turn(1, 3), F::turn(-1, 4), F::turn(1, 4)) == F::turn(1, 4));
  CHECK(sum_within(F(), F::turn(-1, 8), F::turn(-1, 4), F::turn(1, 4)) == F::turn(-1, 8));
}
