// SPDX-License-Identifier: MIT
#include "detent/shape/shape.hpp"

#include <type_traits>

#include "detent/number/digest.hpp"
#include "support/catch.hpp"

using namespace detent;

namespace {

using V = Vec<q16_16, 3>;
using D = Direction<q16_16, 3>;
constexpr V origin{};
constexpr V corner{q16_16(1), q16_16(2), q16_16(3)};

// Plain data: a game can send or save it as is.
template <class Shape>
constexpr bool is_plain = std::is_aggregate_v<Shape>&& std::is_trivially_copyable_v<Shape>;
static_assert(is_plain<Sphere<q16_16, 3>> && sizeof(Sphere<q16_16, 3>) == 16);
static_assert(is_plain<Aabb<q16_16, 3>> && sizeof(Aabb<q16_16, 3>) == 24);
static_assert(is_plain<Obb<q16_16, 3>> && sizeof(Obb<q16_16, 3>) == 60);
static_assert(is_plain<Plane<q16_16, 3>> && sizeof(Plane<q16_16, 3>) == 16);
static_assert(is_plain<Triangle<q8_8, 2>> && sizeof(Triangle<q8_8, 2>) == 12);
static_assert(is_plain<Segment<float, 2>> && is_plain<Ray<double, 3>>);
static_assert(is_plain<Capsule<q14_16, 3>>);

// Scalar and dimension are deduced from the fields.
static_assert(std::is_same_v<decltype(Sphere{origin, q16_16(1)}), Sphere<q16_16, 3>>);
static_assert(std::is_same_v<decltype(Aabb{origin, corner}), Aabb<q16_16, 3>>);
static_assert(std::is_same_v<decltype(Plane{D(), q16_16(1)}), Plane<q16_16, 3>>);
static_assert(std::is_same_v<decltype(Ray{origin, D()}), Ray<q16_16, 3>>);
static_assert(Ray{origin, D()}.max_distance == q16_16::max());

static_assert(!is_empty(Aabb{origin, corner}) && !is_empty(Aabb{corner, corner}));
static_assert(is_empty(Aabb{corner, origin}));

static_assert(point_at(Ray{corner, D::along(1)}, q16_16(5)) == V{q16_16(1), q16_16(7), q16_16(3)});
static_assert(point_at(Ray{corner, -D::along(2)}, q16_16::max()).z == q16_16(3) - q16_16::max());
static_assert(point_at(Ray{corner, D::along(0)}, q16_16::max()).x == q16_16::max(), "clamped");

TEST_CASE("digest: a shape is its fields, in order") {
  const auto is_sum_of = [](const auto& shape, const auto&... fields) {
    Digest parts;
    parts.add(fields...);
    return digest(shape) == parts.value();
  };
  CHECK(is_sum_of(Sphere{corner, q16_16(4)}, corner, q16_16(4)));
  CHECK(is_sum_of(Aabb{origin, corner}, origin, corner));
  CHECK(is_sum_of(Obb{origin, corner, Rotation<q16_16, 3>()}, origin, corner, D::along(0),
                  D::along(1), D::along(2)));
  CHECK(is_sum_of(Plane{D(), q16_16(4)}, D(), q16_16(4)));
  CHECK(is_sum_of(Triangle{origin, corner, origin}, origin, corner, origin));
  CHECK(is_sum_of(Segment{origin, corner}, origin, corner));
  CHECK(is_sum_of(Capsule{origin, corner, q16_16(4)}, origin, corner, q16_16(4)));
  CHECK(is_sum_of(Ray{origin, D(), q16_16(4)}, origin, D(), q16_16(4)));
}

}  // namespace
