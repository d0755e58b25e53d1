// SPDX-License-Identifier: MIT
//
// The widths of the widest intermediates of the queries, from their types; and inputs that use more
// than half of a range passed to `narrow`.

#include "detent/query/distance.hpp"
#include "detent/query/raycast.hpp"
#include "support/catch.hpp"

namespace {

using namespace detent;

template <Scalar S>
using Offset = decltype(Vec<S, 3>() - Vec<S, 3>());
template <class T>
inline constexpr int bits = bits_of<std::remove_cvref_t<T>>;

template <Scalar S>
inline constexpr int along = bits<decltype(dot(Offset<S>(), Direction<S, 3>()))>;
template <Scalar S>
inline constexpr int squared = bits<decltype(squared_length(Offset<S>()))>;
template <Scalar S>
inline constexpr int quadratic =
    decltype(detail::RaySphere<S, 3>(Ray<S, 3>(), Sphere<S, 3>()).quadratic())::product_bits;
template <Scalar S>
inline constexpr int volume = detail::RayTriangle<S>::volume_bits;
template <Scalar S>
using Feature = decltype(squared_distance(Triangle<S, 3>(), Vec<S, 3>()));

static_assert(along<q16_16> == 63 && along<q14_16> == 61 && along<q8_8> == 31);
static_assert(squared<q16_16> == 66 && squared<q14_16> == 62 && squared<q8_8> == 34);
static_assert(quadratic<q16_16> == 126 && quadratic<q24_8> == 126 && quadratic<q8_8> == 62);
static_assert(volume<q16_16> == 96 && volume<q14_16> == 92 && volume<q8_8> == 48);
static_assert(bits<decltype(Feature<q16_16>::numerator)> <= 198);
static_assert(bits<decltype(Feature<q16_16>::denominator)> <= 132);
static_assert(bits<decltype(Feature<q8_8>::numerator)> <= 102);

// Opposite corners of the domain, and the direction between them.
template <Scalar S>
constexpr Vec<S, 3> low_corner{S::lowest(), S::lowest(), S::lowest()};
template <Scalar S>
constexpr Vec<S, 3> high_corner{S::max(), S::max(), S::max()};

/// Whether `x` exceeds half of its type's range of magnitudes.
template <int B, int F>
constexpr bool fills(const Fixed<B, F>& x) {
  return bit_length(x.raw()) >= B;
}

template <Scalar S>
constexpr bool ranges_are_used() {
  const auto diagonal = *normalize(high_corner<S>);
  const Vec<S, 3> m = low_corner<S>;
  const detail::RaySphere<S, 3> sphere({m, diagonal}, {high_corner<S>, S(0)});
  const detail::RayPlane<S, 3> plane(Ray<S, 3>{m, diagonal}, Plane<S, 3>{diagonal, S::max()});
  const Vec<S, 2> low{S::lowest(), S::lowest()}, high{S::max(), S::max()};
  const auto across = *normalize(Vec<S, 2>{S::max(), S::lowest()});
  const detail::PlanarLine<S> line{low, across.vec()};
  return fills(dot(m, diagonal)) && fills(sphere.b) && fills(sphere.c) && fills(plane.gap) &&
         fills(line.side(high)) && fills(dot(Direction<S, 3>(), Direction<S, 3>()));
}
static_assert(ranges_are_used<q16_16>());
static_assert(ranges_are_used<q14_16>());
static_assert(ranges_are_used<q24_8>());
static_assert(ranges_are_used<q8_8>());

TEST_CASE("budget: run-time values use the ranges promised to narrow") {
  CHECK(ranges_are_used<q16_16>());
  CHECK(ranges_are_used<q14_16>());
  CHECK(ranges_are_used<q24_8>());
  CHECK(ranges_are_used<q8_8>());
}

}  // namespace
