// SPDX-License-Identifier: MIT
//
// The bounds passed to `narrow` are tight: each geometric bound has an input that reaches at least
// half of it. The functions also run with those inputs, so that their assertions hold. Bounds that
// follow from a type, such as those of sums and negations, are tested with the type;
// `budget.test.cpp` covers rays, planes and spheres.

#include "detent/math/angle_between.hpp"
#include "detent/math/inverse.hpp"
#include "detent/math/project.hpp"
#include "detent/math/quat.hpp"
#include "detent/math/transform.hpp"
#include "detent/query/closest_point.hpp"
#include "detent/query/intersects.hpp"
#include "detent/query/kernel/line_filter.hpp"
#include "detent/query/kernel/within_segment.hpp"
#include "detent/query/on.hpp"
#include "detent/query/raycast.hpp"
#include "detent/query/raycast/capsule.hpp"
#include "detent/query/raycast/hull.hpp"
#include "oracle/space.hpp"
#include "support/catch.hpp"

namespace {

using namespace detent;

/// Whether `x` exceeds half of its type's range of magnitudes.
template <int B, int F>
constexpr bool fills(const Fixed<B, F>& x) {
  return bit_length(x.raw()) >= B;
}
template <int Times, class T>
constexpr auto times(const T& x) {
  return Fixed<4, 0>::from_raw(Times) * x;
}
template <class T, class Bound>
constexpr bool is_half_of(const T& x, const Bound& bound) {
  const auto magnitude = abs(x);
  return magnitude + magnitude >= bound;
}

template <Scalar S>
constexpr S low = S::lowest();
template <Scalar S>
constexpr S high = S::max();
/// The type of a difference of coordinates, and its greatest value.
template <Scalar S>
using Offset = decltype(S() - S());
template <Scalar S>
constexpr Offset<S> far = low<S> - high<S>;

/// (0, 1, -1) and (2, -1, -1), normalised.
template <Scalar S>
const Direction<S, 3> diagonal = *normalize(Vec<S, 3>{S(0), S(1), S(-1)});
template <Scalar S>
const Direction<S, 3> third = *normalize(Vec<S, 3>{S(2), S(-1), S(-1)});

#define DETENT_FIXED_TYPES q16_16, q8_8

TEMPLATE_TEST_CASE("proofs: Hadamard's bound is reached by determinants", "", DETENT_FIXED_TYPES) {
  using S = TestType;
  constexpr S l = low<S>, h = high<S>;
  CHECK(is_half_of(determinant(Mat<S, 2, 2>{{Vec{l, l}, Vec{h, l}}}), times<2>(l * l)));
  // 4 out of 3 sqrt(3), times the cube of a component.
  const auto three = determinant(Mat<S, 3, 3>{{Vec{l, l, l}, Vec{l, h, l}, Vec{l, l, h}}});
  CHECK(is_half_of(three, times<6>(l * l * h)));
  if constexpr (S::bits < 31) {
    const Mat<S, 4, 4> four{{Vec{l, l, l, l}, Vec{l, h, l, h}, Vec{l, l, h, h}, Vec{l, h, h, l}}};
    CHECK(bit_length(determinant(four).raw()) >= 4 * S::bits + 4);
  }
}

TEMPLATE_TEST_CASE("proofs: areas, quaternions and projections reach their bounds", "",
                   DETENT_FIXED_TYPES) {
  using S = TestType;
  constexpr S l = low<S>, h = high<S>;
  const Vec<S, 3> u{l, l, l}, v{l, l, h};
  constexpr int area_bits = 4 * bits_of<S> + 4;
  CHECK(is_half_of(detail::squared_area<area_bits>(u, v), squared_length(u) * squared_length(v)));
  CHECK(angle_between(u, v) != Angle<S>());

  const Vec<S, 4> q{l, l, l, l};
  CHECK(fills(narrow_dot<2 * bits_of<S> + 2>(q, q)));
  CHECK(fills(detail::quaternion_columns<2 * bits_of<S> + 2>(q)[0].y));
  const Quat<S> unit;
  CHECK(fills(dot(unit, unit)));
  const auto column = detail::quaternion_columns<detail::cosine_bits<S>>(unit.vec())[0];
  // 1 out of sqrt(3), squared.
  CHECK(is_half_of(times<2>(square(column.x * l)), times<3>(square(squared_length(unit) * l))));
  CHECK(rotate(unit, u) == u);

  // 3 out of 3 sqrt(3), and 2 out of 2 sqrt(3).
  CHECK(is_half_of(times<2>(dot(u, u) * l), times<11>(l * l * h)));
  CHECK(project(u, u) == u);
  CHECK(reject(u, u) == Vec<S, 3>{});
  const auto axis = Direction<S, 3>::along(0);
  const Transform<S, 3> turned{{}, Rotation<S, 3>::from_axes({axis, axis, axis})};
  CHECK(is_half_of(times<2>(l), times<4>(h)));
  CHECK(reflect(u, axis) == Vec<S, 3>{h, l, l});  // clamped from -l
  CHECK(transform_point(turned, u).x == l);       // clamped from 3 l
}

TEMPLATE_TEST_CASE("proofs: a line with two offsets uses the bits of its bound", "",
                   DETENT_FIXED_TYPES) {
  using S = TestType;
  constexpr auto m = far<S>;
  const Vec<Offset<S>, 3> w{m, m, m}, e{m, m, narrow_negative(m)};
  constexpr int along = detail::along_bits<S, Offset<S>>;
  const auto moment = cross(diagonal<S>, w);
  CHECK(fills(moment.x));
  CHECK(fills(narrow_dot<bits_of<Offset<S>> + along + 1>(e, cross(third<S>, w))));
  CHECK(fills(detail::narrow_square<2 * along>(moment)));

  // For three corners of the world: 2 sqrt(3) out of the 3 |w| |e| of free vectors, halved.
  constexpr S l = low<S>, h = high<S>;
  const Vec<S, 3> a{l, l, l}, b{h, h, l}, c{l, h, h};
  const auto across = *normalize(Vec<S, 3>{S(1), S(-1), S(1)});
  const detail::RayTriangle<S> meeting({a, across}, {a, b, c});
  CHECK(is_half_of(meeting.det, times<3>(m * m)));
  CHECK(raycast(Ray<S, 3>{a, across}, Triangle<S, 3>{a, b, c}) == S(0));
  const std::array points{a, b, c};
  CHECK(raycast(Ray<S, 3>{a, across}, ConvexHull<S, 3>{points}) == S(0));
}

TEMPLATE_TEST_CASE("proofs: corners seen along a line, and their winding about it", "",
                   DETENT_FIXED_TYPES) {
  using S = TestType;
  constexpr S l = low<S>, h = high<S>;
  const auto along = [](S x, S y, S z) { return *normalize(Vec<S, 3>{x, y, z}); };
  const Ray<S, 3> level{{l, l, l}, along(S(1), S(0), S(-1)), h};
  CHECK(fills(detail::LineFilter<S>(level).seen({h, h, h}).x));
  const detail::LineFilter<S> line({{l, l, l}, along(S(3), S(-3), S(7)), h});
  CHECK(fills(line.turn(line.seen({h, h, l}), line.seen({l, h, h}))));
}

TEMPLATE_TEST_CASE("proofs: a point next to an edge is as far as the lengths allow", "",
                   DETENT_FIXED_TYPES) {
  using S = TestType;
  constexpr auto m = far<S>;
  const Vec<Offset<S>, 3> w{m, m, m}, e{m, m, narrow_negative(m)};
  const auto over = detail::squared_distance_from_edge(e, w).numerator;
  CHECK(is_half_of(over, squared_length(e) * squared_length(w)));
  CHECK_FALSE(detail::within_edge(e, w, high<S>));

  // An excess equal to the tolerance.
  const Obb<S, 3> point{};
  CHECK(on(point, Vec<S, 3>{high<S>, S(0), S(0)}, high<S>));
  const auto excess = detail::excess(point, Vec<S, 3>{high<S>, S(0), S(0)});
  CHECK(fills(narrow<bits_of<S> + bits_of<direction_component<S>> - 1>(excess.x)));
}

TEMPLATE_TEST_CASE("proofs: a point next to a capsule makes the largest triangle of the world", "",
                   DETENT_FIXED_TYPES) {
  using S = TestType;
  constexpr S l = low<S>, h = high<S>;
  const Vec<S, 3> point{h, l, h}, a{l, l, l}, b{h, h, l};
  CHECK(fills(detail::narrow_square<4 * bits_of<Offset<S>> + 2>(cross(point - a, b - a))));
  CHECK(closest_point(Capsule<S, 3>{a, b, S(0)}, point) == Vec<S, 3>{S(0), S(0), l});

  const Vec<S, 2> corner{l, h}, low_end{l, l}, high_end{h, h};
  const auto area =
      detail::narrow_square<4 * bits_of<Offset<S>>>(cross(corner - low_end, high_end - low_end));
  CHECK(is_half_of(area, square(square(Offset<S>(far<S>)))));
}

TEMPLATE_TEST_CASE("proofs: a line that grazes a wide capsule uses the bits of its normal", "",
                   DETENT_FIXED_TYPES) {
  using S = TestType;
  constexpr S l = low<S>, h = high<S>;
  const Capsule<S, 3> capsule{{l, l, l}, {h, h, h}, h};
  // Off the axis by the radius minus about a hundredth of it.
  const auto beside = nearest_to<S>(h * third<S>[0]), below = nearest_to<S>(h * third<S>[1]);
  const auto back = S::from_raw(static_cast<typename S::raw_type>(h.raw() / 2));
  const S step = S::from_raw(static_cast<typename S::raw_type>(h.raw() / 128));
  const Vec<S, 3> origin{nearest_to<S>(beside - step), nearest_to<S>(below - back),
                         nearest_to<S>(below + back)};
  const auto hit = raycast_hit(Ray<S, 3>{origin, diagonal<S>}, capsule);
  REQUIRE(hit);
  CHECK(dot(hit->normal, third<S>) > 0);
  // |m . k| k out of radius |k|^2, in one component: sqrt(2 / 3).
  const auto e = capsule.b - capsule.a;
  const auto k = cross(diagonal<S>, e);
  const auto m = origin - capsule.a;
  CHECK(is_half_of(dot(m, k) * k.x, capsule.radius * squared_length(k)));
}

}  // namespace
