// SPDX-License-Identifier: MIT
#include "detent/query/contact/segment_box.hpp"

#include <cstddef>

#include "detent/query/contact.hpp"
#include "oracle/space.hpp"
#include "query/kernel/boxes_and_segments.hpp"
#include "support/catch.hpp"

namespace detent::test {
namespace {

struct Rates {
  HitRate hits, sure, sure_inside;
};

template <Scalar S>
void compare(const Obb<S, 3>& box, const Segment<S, 3>& segment, const S& radius, Rates& rates) {
  const auto exact = detail::find_segment_box_push(box, segment, radius);
  const auto found = detail::SegmentBoxFilter<S>(box, segment, radius).find();
  rates.hits.count(exact.has_value());
  rates.sure.count(found.is_sure);
  if (exact && exact->depth > radius) rates.sure_inside.count(found.is_sure);
  if (found.is_sure) {
    REQUIRE(found.value.has_value() == exact.has_value());
    if (exact) {
      CHECK(found.value->away == exact->away);
      CHECK(found.value->depth == exact->depth);
      CHECK(found.value->upper == exact->upper);
      CHECK(found.value->free == exact->free);
    }
  }
  for (const bool box_is_a : {true, false}) {
    REQUIRE(detail::contact_in_frame(box, segment, radius, box_is_a) ==
            detail::contact_of_push(box, segment, radius, box_is_a, exact));
  }
}

/// The same box as a hull of its corners in the same order, which takes the general search.
template <Scalar S>
void compare(const Aabb<S, 3>& box, const Capsule<S, 3>& capsule, Rates& rates) {
  const auto corners = detail::AabbBody(box).corners();
  const ConvexHull<S, 3> hull{corners};
  const auto found = contact(box, capsule);
  rates.hits.count(found.has_value());
  const auto push = detail::SegmentBoxFilter<S>(box, Segment{capsule.a, capsule.b}, capsule.radius);
  rates.sure.count(push.find().is_sure);
  for (const bool box_is_a : {true, false}) {
    const auto of_box = box_is_a ? contact(box, capsule) : contact(capsule, box);
    const auto of_hull = box_is_a ? contact(hull, capsule) : contact(capsule, hull);
    REQUIRE(of_box.has_value() == of_hull.has_value());
    if (!of_box) continue;
    REQUIRE(of_box->depth == of_hull->depth);
    REQUIRE(of_box->normal == of_hull->normal);
    REQUIRE(of_box->count == of_hull->count);
    for (std::size_t k = 0; k < of_box->count; ++k) {
      REQUIRE(of_box->points[k] == of_hull->points[k]);
    }
  }
}

template <Scalar S>
void compare_some(int bits, int asked, Turning turning, Rates& oriented, Rates& aligned) {
  draw_boxes_and_segments<S>(bits, asked, [&](BoxesAndSegments<S> draw) {
    const auto box = draw.box(turning);
    compare(box, draw.segment(box), draw.radius(), oriented);
    const auto along_axes = draw.aligned_box();
    const auto [a, b] = draw.segment(along_axes);
    compare(along_axes, Capsule<S, 3>{a, b, draw.radius()}, aligned);
  });
}

TEMPLATE_TEST_CASE("contact of a capsule and a box: the filter is exact", "[query]",
                   DETENT_FILTER_SCALARS) {
  using S = TestType;
  for (const auto turning : {Turning::any, Turning::none, Turning::little, Turning::skew}) {
    for (const int bits : {3, 12, 22, S::bits - 3}) {
      Rates oriented, aligned;
      compare_some<S>(bits, 300, turning, oriented, aligned);
      INFO(bits << ": hits " << oriented.hits << ", " << aligned.hits << "; sure " << oriented.sure
                << ", inside " << oriented.sure_inside << ", aligned " << aligned.sure);
      CHECK(oriented.hits.is_balanced());
      CHECK(oriented.sure.percent() >= 50);
      CHECK(oriented.sure_inside.percent() >= 10);
      CHECK(oriented.sure_inside.percent() <= 90);
      CHECK(aligned.sure.percent() >= 50);
    }
    Rates large, large_aligned;
    compare_some<S>(S::bits, 200, turning, large, large_aligned);
    CHECK(large.sure.percent() < 100);
  }
}

TEST_CASE("contact of a capsule and a box: q8_8 takes the exact path", "[query]") {
  Random random(8);
  for (int i = 0; i < 500; ++i) {
    BoxesAndSegments<q8_8> draw(random, 13);
    const auto box = draw.box(Turning::any);
    const auto segment = draw.segment(box);
    const auto radius = draw.radius();
    REQUIRE(detail::contact_in_frame(box, segment, radius, true) ==
            detail::contact_of_push(box, segment, radius, true,
                                    detail::find_segment_box_push(box, segment, radius)));
  }
}

}  // namespace
}  // namespace detent::test
