// SPDX-License-Identifier: MIT
#include <array>

#include "draw/sheet.hpp"
#include "oracle/space.hpp"
#include "support/catch.hpp"

namespace detent::test {
namespace {

TEMPLATE_TEST_CASE("draw: points are crosses, and hits and contacts have normals", "[draw]",
                   DETENT_EVERY_SPACE) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  const auto point = at<S, N>(3, 4, 5);
  const auto up = Direction<S, N>::along(1);
  Sheet<S, N> cross;
  draw(cross, point, ink, num<S>(0.25));
  REQUIRE(cross.lines.size() == N);
  for (int i = 0; i < N; ++i) {
    auto low = point, high = point;
    low[i] -= num<S>(0.25);
    high[i] += num<S>(0.25);
    CHECK(cross.lines[static_cast<std::size_t>(i)].a == low);
    CHECK(cross.lines[static_cast<std::size_t>(i)].b == high);
  }
  const auto has_normal = [&](const Sheet<S, N>& sheet, std::size_t count) {
    REQUIRE(sheet.lines.size() == count * (N + 1));
    for (std::size_t i = N; i < sheet.lines.size(); i += N + 1) {
      CHECK(sheet.lines[i].a == point);
      CHECK(sheet.lines[i].b == at<S, N>(3, 5, 5));
    }
  };
  Sheet<S, N> ray, moving, contacts;
  draw(ray, RayHit<S, N>{num<S>(1), point, up}, ink, num<S>(0.25));
  has_normal(ray, 1);
  draw(moving, CastHit<S, N>{num<S>(1), point, up}, ink, num<S>(0.25));
  has_normal(moving, 1);
  Contact<S, N> contact{up, num<S>(1)};
  draw(contacts, contact, ink, num<S>(0.25));
  CHECK(contacts.is_blank());
  contact.points[0].point = contact.points[1].point = point;
  contact.count = 2;
  draw(contacts, contact, ink, num<S>(0.25));
  has_normal(contacts, 2);
}

TEMPLATE_TEST_CASE("draw_sweep: draws a shape at its start and end, and its path", "[draw]",
                   DETENT_EVERY_SPACE) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  const auto along = toward<S, N>(1);
  const auto check = [&](const auto& shape, const Vec<S, N>& middle) {
    const auto start = drawn<S, N>(shape);
    const auto count = start.lines.size();
    Sheet<S, N> sheet;
    draw_sweep(sheet, shape, along, num<S>(7), ink);
    REQUIRE(sheet.lines.size() == 2 * count + 1);
    for (std::size_t i = 0; i < count; ++i) {
      CHECK(sheet.lines[i].a == start.lines[i].a);
      CHECK(sheet.lines[count + i].a == nearest_to<S>(start.lines[i].a + at<S, N>(7)));
      CHECK(sheet.lines[count + i].b == nearest_to<S>(start.lines[i].b + at<S, N>(7)));
    }
    CHECK(sheet.lines.back().a == middle);
    CHECK(sheet.lines.back().b == nearest_to<S>(middle + at<S, N>(7)));
  };
  check(Sphere{at<S, N>(1, 2, 3), num<S>(1)}, at<S, N>(1, 2, 3));
  check(Aabb{at<S, N>(1, 2, 3), at<S, N>(3, 4, 5)}, at<S, N>(2, 3, 4));
  const std::array corners{at<S, N>(0), at<S, N>(2), at<S, N>(0, 2)};
  check(ConvexHull<S, N>{corners}, at<S, N>(1, 1));
  Sheet<S, N> none;
  draw_sweep(none, Sphere{at<S, N>(1), num<S>(-1)}, along, num<S>(7), ink);
  CHECK(none.is_blank());
}

static_assert([] {
  Lines<q16_16> lines;
  Contact<q16_16, 2> contact;
  contact.count = 2;
  draw(lines, Sphere<q16_16, 2>{{}, q16_16(1)}, ink);
  draw(lines, contact, ink, q16_16(1));
  draw_sweep(lines, Aabb<q16_16, 2>{}, Direction<q16_16, 2>(), q16_16(1), ink);
  return lines.count;
}() == 32 + 6 + 9);

}  // namespace
}  // namespace detent::test
