// SPDX-License-Identifier: MIT
//
// Each query of the C interface gives the bits of its C++ counterpart, on the cases of `verify`.

#include <array>
#include <tuple>

#include "calls.hpp"
#include "detent/scene/scene.hpp"
#include "shapes.hpp"

namespace detent {
namespace {

using S = q16_16;
using c::Output;
using test_c::Calls;

template <class A, class B>
bool meet(const A& a, const B& b) {
  if constexpr (requires { a.start; }) {
    return detail::separately<detail::job::Intersects>(a, b);
  } else if constexpr (requires { b.start; }) {
    return detail::separately<detail::job::Intersects>(b, a);
  } else {
    return detail::separately<detail::job::Overlaps>(a, b);
  }
}

template <int N, class Shape>
void check_shape(const Shape& shape, const Vec<S, N>& point, const Ray<S, N>& ray, Share& hits,
                 Share& held) {
  using C = Calls<N>;
  const auto target = in_c<N>(shape);
  const auto along = in_c<N>(ray);
  const auto at = Output<N>::vec(point);

  typename c::Types<N>::Hit hit{};
  const auto expected = raycast_hit(ray, shape);
  REQUIRE(C::raycast(&along, &target, &hit) == c::yes_or_no(expected.has_value()));
  REQUIRE(C::raycast(&along, &target, nullptr) == c::yes_or_no(expected.has_value()));
  std::int32_t distance = -2;
  REQUIRE(C::raycast_many(&along, 1, &target, &distance) == DETENT_OK);
  REQUIRE(distance == (expected ? expected->distance.raw() : -1));
  if (expected) {
    c::Input<N> in;
    REQUIRE(hit.distance == expected->distance.raw());
    REQUIRE(in.vec(hit.point) == expected->point);
    REQUIRE(in.direction(hit.normal) == expected->normal);
  }
  hits.add(expected.has_value());

  const bool holds = detail::separately<detail::job::Contains>(shape, point);
  REQUIRE(C::contains(&target, &at) == c::yes_or_no(holds));
  held.add(holds);
  typename c::Types<N>::Vec closest{};
  REQUIRE(C::closest_point(&target, &at, &closest) == DETENT_OK);
  REQUIRE(c::Input<N>::vec(closest) == closest_point(shape, point));
  REQUIRE(C::distance_to_point(&target, &at, &distance) == DETENT_OK);
  REQUIRE(distance == detail::separately<detail::job::Distance>(shape, point).raw());
}

template <int N, class A, class B>
void check_pair(const A& a, const B& b, Share& meetings) {
  using C = Calls<N>;
  const auto one = in_c<N>(a);
  const auto other = in_c<N>(b);
  const bool do_meet = meet(a, b);
  REQUIRE(C::overlaps(&one, &other) == c::yes_or_no(do_meet));
  meetings.add(do_meet);
  std::int32_t between = -2;
  REQUIRE(C::distance(&one, &other, &between) == DETENT_OK);
  REQUIRE(between == distance(a, b).raw());
}

template <int N>
void check_dimension(std::uint64_t seed, int count) {
  verify::Random random(seed);
  Share hits, held, meetings;
  for (int i = 0; i < count; ++i) {
    CAPTURE(N, seed, i);
    Draw<N> draw{verify::ShapeScene<S, N>(random)};
    const auto two = draw.two_of_all();
    const auto ray = draw.scene.aimed_ray();
    const auto point = draw.scene.spot();
    std::apply(
        [&](const auto&... a) {
          (check_shape<N>(a, point, ray, hits, held), ...);
          const auto with_all = [&](const auto& one) {
            std::apply([&](const auto&... b) { (check_pair<N>(one, b, meetings), ...); },
                       two.second);
          };
          (with_all(a), ...);
        },
        two.first);
  }
  for (const auto& share : {hits, held, meetings}) share.check();
}

TEST_CASE("C queries: the bits are those of C++, in 2D") { check_dimension<2>(20, 800); }
TEST_CASE("C queries: the bits are those of C++, in 3D") { check_dimension<3>(30, 800); }

TEST_CASE("C queries: directions that are not unit vectors and unknown kinds are errors") {
  detent_shape3 plane{};
  plane.kind = DETENT_PLANE;
  detent_vec3 point{};
  CHECK(detent_contains3(&plane, &point) == DETENT_NOT_UNIT);
  plane.as.plane.normal.x = 1 << 30;
  CHECK(detent_contains3(&plane, &point) == DETENT_OK);
  for (const unsigned kind : {0u, 13u, 77u, 0xffffffffu}) {
    plane.kind = kind;
    CHECK(detent_contains3(&plane, &point) == DETENT_BAD_ARGUMENT);
  }
  for (const unsigned kind :
       {DETENT_POINT, DETENT_HULL, DETENT_MESH, DETENT_HEIGHT_FIELD, DETENT_COMPOUND}) {
    plane.kind = kind;
    CHECK(detent_contains3(&plane, &point) == DETENT_NO_QUERY);
  }
}

}  // namespace
}  // namespace detent
