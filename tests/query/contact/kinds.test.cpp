// SPDX-License-Identifier: MIT
#include "detent/query/contact.hpp"
#include "detent/query/overlaps.hpp"
#include "detent/shape/moved.hpp"
#include "query/shapes_at.hpp"

namespace detent::test {
namespace {

TEMPLATE_TEST_CASE("contact: the least translation for every two kinds of shapes", "[contact]",
                   DETENT_EVERYDAY_SPACES) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  const auto right = toward<S, N>(1);
  const auto check = [](const auto& a, const auto& b, double depth, const auto& normal) {
    const auto found = contact(a, b);
    REQUIRE(found.has_value() == (depth >= 0));
    CHECK(overlaps(a, b) == found.has_value());
    if (!found) return;
    CHECK(found->normal == normal);
    CHECK(found->depth == num<S>(depth));
    // A hull is a view of points, which only its owner can move.
    if constexpr (is_fixed<S> && requires { translated(b, separation(*found)); }) {
      CHECK_FALSE(overlaps(a, translated(b, separation(*found))));
    }
  };
  visit_wide_shapes<S, N>(-3, [&](const auto& a) {
    for (const double overlap : {0.5, 0.0, -1.0}) {
      visit_wide_shapes<S, N>(-1 - overlap, [&](const auto& b) {
        check(a, b, overlap, right);
        check(b, a, overlap, -right);
      });
    }
  });
}

TEMPLATE_TEST_CASE("contact: a plane is left towards the nearer side", "[contact]",
                   DETENT_EVERYDAY_SPACES) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  const auto right = toward<S, N>(1);
  visit_wide_shapes<S, N>(4, [&](const auto& shape) {
    const auto check = [&](double offset, double depth, bool to_the_right) {
      const Plane<S, N> plane{right, num<S>(offset)};
      const auto found = contact(plane, shape), back = contact(shape, plane);
      REQUIRE(found);
      REQUIRE(back);
      CHECK(found->depth == num<S>(depth));
      CHECK(back->depth == num<S>(depth));
      CHECK(found->normal == (to_the_right ? right : -right));
      CHECK(back->normal == -found->normal);
    };
    check(3.25, 0.25, true);
    check(4, 1, true);
    check(4.75, 0.25, false);
    check(5, 0, false);
    CHECK(!contact(shape, Plane<S, N>{right, num<S>(2.5)}));
    CHECK(!contact(shape, Plane<S, N>{right, num<S>(5.5)}));
  });
}

TEMPLATE_TEST_CASE("contact: an empty shape touches nothing", "[contact]", DETENT_EVERYDAY_SPACES) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  visit_wide_shapes<S, N>(0, [&](const auto& shape) {
    CHECK(!contact(shape, Sphere<S, N>{at<S, N>(0), num<S>(-1)}));
    CHECK(!contact(Aabb<S, N>{at<S, N>(1), at<S, N>(-1)}, shape));
    CHECK(!contact(shape, ConvexHull<S, N>()));
  });
}

}  // namespace
}  // namespace detent::test
