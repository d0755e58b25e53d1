// SPDX-License-Identifier: MIT
#include "detent/query/contact/boxes.hpp"

#include "detent/query/closest_points.hpp"
#include "detent/query/contact.hpp"
#include "detent/query/overlaps.hpp"
#include "support/catch.hpp"
#include "support/random.hpp"

namespace detent::test {
namespace {

using Box = Aabb<q16_16, 3>;

/// The same box as an oriented one, whose contacts clip faces in general.
Obb<q16_16, 3> oriented(const Box& box) {
  return {
      nearest_to<q16_16>(half(box.min + box.max)), nearest_to<q16_16>(half(box.max - box.min)), {}};
}

/// Boxes of even coordinates, most of which share planes, edges and corners.
Box draw(Random& random, std::int64_t reach) {
  Box box;
  for (int i = 0; i < 3; ++i) {
    const auto p = random.between(-reach, reach), q = random.between(-reach, reach);
    box.min[i] = q16_16::from_raw(static_cast<std::int32_t>(2 * std::min(p, q)));
    box.max[i] = q16_16::from_raw(static_cast<std::int32_t>(2 * std::max(p, q)));
  }
  return box;
}

TEST_CASE("contact of two AABBs: the same as of oriented boxes with the same corners", "[query]") {
  Random random(0xb0c5);
  HitRate hits;
  int direct = 0;
  for (int i = 0; i < 6000; ++i) {
    const std::int64_t reach = i % 3 == 0 ? 3 : i % 3 == 1 ? 8 : 1 << 20;
    const Box a = draw(random, reach), b = draw(random, reach);
    CAPTURE(i);
    const auto found = contact(a, b);
    REQUIRE(found.has_value() == overlaps(a, b));
    hits.count(found.has_value());
    REQUIRE(found == contact(oriented(a), oriented(b)));
    if (found) direct += detail::BoxesContact<q16_16>(a, b).find().has_value() ? 1 : 0;
  }
  INFO(hits);
  CHECK(hits.is_balanced());
  CHECK(direct > 1000);
}

}  // namespace
}  // namespace detent::test
