// SPDX-License-Identifier: MIT
#include "detent/shape/hull.hpp"

#include <type_traits>
#include <vector>

#include "detent/number/digest.hpp"
#include "support/catch.hpp"

using namespace detent;

namespace {

using V = Vec<q16_16, 3>;
using Hull = ConvexHull<q16_16, 3>;
constexpr std::array points{V{}, V{q16_16(1), q16_16(2), q16_16(3)}, V{q16_16(4)}};
constexpr V more_points[] = {V{}, V{q16_16(1)}};

static_assert(std::is_aggregate_v<Hull> && std::is_trivially_copyable_v<Hull>);
static_assert(std::is_same_v<decltype(ConvexHull{points}), Hull>);
static_assert(std::is_same_v<decltype(ConvexHull{more_points}), Hull>);
static_assert(std::is_same_v<decltype(ConvexHull{std::span(points)}), Hull>);
static_assert(std::is_same_v<decltype(ConvexHull{std::span<const V>(points)}), Hull>);
static_assert(std::is_same_v<decltype(ConvexHull{std::span<V>()}), Hull>);
static_assert(ConvexHull{more_points}.points.size() == 2);

static_assert(is_empty(Hull{}) && !is_empty(ConvexHull{points}));
static_assert(ConvexHull{points} == ConvexHull{points});
static_assert(!(ConvexHull{points} == ConvexHull{more_points}));
static_assert(Hull{} == Hull{std::span(points).first(0)});

TEST_CASE("hull: is a view of the caller's points in any container") {
  const std::vector<V> heap(points.begin(), points.end());
  CHECK(Hull{heap} == ConvexHull{points});
  CHECK(Hull{heap}.points.data() == heap.data());
}

TEST_CASE("digest: a hull is the number of its points, in 64 bits, and the points in order") {
  Digest parts;
  parts.add(std::uint64_t{3}, points[0], points[1], points[2]);
  CHECK(digest(ConvexHull{points}) == parts.value());
  Digest none;
  none.add(std::uint64_t{0});
  CHECK(digest(Hull{}) == none.value());
}

}  // namespace
