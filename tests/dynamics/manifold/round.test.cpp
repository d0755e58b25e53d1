// SPDX-License-Identifier: MIT
#include "detent/dynamics/manifold/round.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "dynamics/manifold/helpers.hpp"
#include "support/random.hpp"

namespace detent::test {
namespace {

// The oracle computes in real numbers, in steps of a lever, with searches instead of formulas.
using Real = long double;
using Point = std::array<Real, 3>;

Point operator+(const Point& a, const Point& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
Point operator-(const Point& a, const Point& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
Point operator*(const Point& a, Real x) { return {a[0] * x, a[1] * x, a[2] * x}; }
Real dot(const Point& a, const Point& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Real length(const Point& a) { return std::sqrt(dot(a, a)); }

template <Number T, int N>
Point steps(const Vec<T, N>& v, int frac = 0) {
  Point result{};
  for (int i = 0; i < N; ++i) {
    result[static_cast<std::size_t>(i)] = std::ldexp(static_cast<Real>(v[i].raw()), -frac);
  }
  return result;
}

/// The least value of a convex function on [0, 1].
template <class F>
Real least(const F& f) {
  Real low = 0, high = 1;
  for (int i = 0; i < 150; ++i) {
    const Real a = low + (high - low) / 3, b = high - (high - low) / 3;
    (f(a) <= f(b) ? high : low) = f(a) <= f(b) ? b : a;
  }
  return f((low + high) / 2);
}

struct Segment {
  Point a, b;
  Point at(Real x) const { return a + (b - a) * x; }
  Real distance(const Point& p) const {
    const Real squared = dot(b - a, b - a);
    const Real x = squared > 0 ? std::clamp<Real>(dot(p - a, b - a) / squared, 0, 1) : 0;
    return length(p - at(x));
  }
  Real distance(const Segment& other) const {
    return least([&](Real x) { return other.distance(at(x)); });
  }
};

struct Box {
  Point half;
  int dimension;
  Real distance(const Point& p) const {
    Point d{};
    for (std::size_t i = 0; i < static_cast<std::size_t>(dimension); ++i) {
      d[i] = std::max<Real>(std::abs(p[i]) - half[i], 0);
    }
    return length(d);
  }
  Real distance(const Segment& s) const {
    return least([&](Real x) { return distance(s.at(x)); });
  }
};

template <Scalar S, int N>
struct Draw {
  Random random;
  Real size = 0;

  typename S::raw_type raw(double x) {
    const double limit = std::ldexp(1, S::bits) - 1;
    return static_cast<typename S::raw_type>(std::llround(std::clamp(x, -limit, limit)));
  }
  double unit() { return static_cast<double>(random.between(-10000, 10000)) / 10000; }
  /// Coordinates in steps of the scalar.
  Vec<S, N> point(double scale) {
    return make_vec<N>([&](int) { return S::from_raw(raw(scale * unit())); });
  }
  /// An upright or a rotated pose.
  detail::RelativePose<S, N> pose(double scale) {
    auto pose = shifted<S, N>(0, 0, 0);
    for (int i = 0; i < N; ++i) {
      pose.translation[i] =
          lever<S>::from_raw(static_cast<std::int32_t>(std::llround(scale * unit())));
    }
    if (random.coin()) return pose;
    const double angle = random.coin() ? 3.2 * unit() : 0.03 * unit();
    const int i = static_cast<int>(random.below(N)), j = (i + 1) % N;
    auto& first = pose.axes[static_cast<std::size_t>(i)];
    auto& second = pose.axes[static_cast<std::size_t>(j)];
    first[i] = second[j] = ratio<S>::from_double(std::cos(angle));
    first[j] = ratio<S>::from_double(std::sin(angle));
    second[i] = ratio<S>::from_double(-std::sin(angle));
    return pose;
  }
};

template <Scalar S, int N>
Point placed(const detail::RelativePose<S, N>& pose, const Vec<S, N>& p) {
  Point result = steps(pose.translation);
  for (int j = 0; j < N; ++j) {
    result = result + steps(pose.axes[static_cast<std::size_t>(j)], 30) *
                          static_cast<Real>(static_cast<std::int64_t>(p[j].raw()) * 64);
  }
  return result;
}

template <Scalar S, int N>
void check_capsules(std::uint64_t seed) {
  Draw<S, N> draw{Random(seed)};
  CAPTURE(draw.random.seed());
  int hits = 0, pairs = 0;
  const int cases = 2000;
  for (int i = 0; i < cases; ++i) {
    CAPTURE(i);
    const double sizes[] = {65536, 3277, 600000};
    const double size = std::min(sizes[draw.random.below(3)], std::ldexp(1, S::bits - 2));
    Capsule<S, N> a{draw.point(size), draw.point(size), S::from_raw(draw.raw(size / 3))};
    Capsule<S, N> b{draw.point(size), draw.point(size), S::from_raw(draw.raw(size / 4))};
    if (draw.random.one_in(3)) {  // side by side
      for (int k = 0; k < N; ++k) {
        b.b[k] = saturate_to<S>(b.a[k] + (a.b[k] - a.a[k]));
      }
    }
    if (draw.random.one_in(5)) a.b = a.a;
    if (draw.random.one_in(5)) b.b = b.a;
    const auto pose = draw.pose(64 * (N == 2 ? 1.1 : 0.5) * size);
    const auto margin = detail::Formats<S>::Gap::from_raw(static_cast<std::int32_t>(size));
    const auto m = manifold(a, b, pose, margin);
    const Segment first{steps(a.a) * 64, steps(a.b) * 64};
    const Segment second{placed(pose, b.a), placed(pose, b.b)};
    const Real ra = 64 * static_cast<Real>(a.radius.raw()),
               rb = 64 * static_cast<Real>(b.radius.raw());
    const Real apart = first.distance(second);
    const Real slack = 4;
    if (m.count == 0) {
      REQUIRE(apart - ra - rb > size - slack);
      continue;
    }
    REQUIRE(apart - ra - rb < size + slack);
    ++hits;
    const Point n = steps(m.normal, 30);
    REQUIRE(std::abs(length(n) - 1) < 1e-8L);
    for (int k = 0; k < m.count; ++k) {
      const auto& p = m.points[static_cast<std::size_t>(k)];
      const Real s = static_cast<Real>(p.separation.raw());
      const Point on_a = steps(p.point) - n * (ra + s / 2);
      REQUIRE(first.distance(on_a) < slack);
      if (m.count == 1) {
        REQUIRE(std::abs(s - (apart - ra - rb)) < slack);
        const bool crossing = apart < 2;  // any perpendicular direction
        if (!crossing) REQUIRE(second.distance(steps(p.point) + n * (rb + s / 2)) < slack);
      } else {
        // Parallel within 2^-5: the other end of the pair is off the normal by this much.
        const Real beside = length(second.b - second.a) / 32 + length(first.b - first.a) / 32;
        REQUIRE(second.distance(on_a + n * (ra + rb + s)) < slack + beside);
        REQUIRE(s > apart - ra - rb - beside - slack);
      }
    }
    if (m.count == 2) {
      ++pairs;
      REQUIRE(m.points[0].feature != m.points[1].feature);
    }
  }
  CHECK(hits > cases * 3 / 10);
  CHECK(hits < cases * 9 / 10);
  CHECK(pairs > cases / 60);
}

TEMPLATE_TEST_CASE("round manifold: separations equal the distances of the closest points",
                   "[manifold][oracle]", q16_16, q24_8, q8_8) {
  check_capsules<TestType, 2>(0xca51);
  check_capsules<TestType, 3>(0xca52);
}

template <Scalar S, int N>
void check_box_and_capsule(std::uint64_t seed) {
  Draw<S, N> draw{Random(seed)};
  CAPTURE(draw.random.seed());
  int hits = 0, pairs = 0, inside = 0;
  const int cases = 2000;
  constexpr Real tolerance = 2048, slack = 6;
  for (int i = 0; i < cases; ++i) {
    CAPTURE(i);
    const double sizes[] = {65536, 3277, 600000};
    const double size = std::min(sizes[draw.random.below(3)], std::ldexp(1, S::bits - 2));
    Obb<S, N> box{{}, draw.point(size), {}};
    for (int k = 0; k < N; ++k) box.half_extents[k] = nearest_to<S>(abs(box.half_extents[k]));
    Capsule<S, N> capsule{draw.point(size), draw.point(size), S::from_raw(draw.raw(size / 3))};
    if (draw.random.one_in(3)) {  // along an axis
      const int axis = static_cast<int>(draw.random.below(N));
      for (int k = 0; k < N; ++k) {
        if (k != axis) capsule.b[k] = capsule.a[k];
      }
    }
    if (draw.random.one_in(5)) capsule.b = capsule.a;
    if (capsule.radius < 0) capsule.radius = S::from_raw(0);
    const auto pose = draw.pose(64 * (N == 2 ? 1.5 : 1) * size);
    const auto margin = detail::Formats<S>::Gap::from_raw(static_cast<std::int32_t>(size));
    const auto m = manifold(box, capsule, pose, margin);
    const Box solid{steps(box.half_extents) * 64, N};
    const Segment segment{placed(pose, capsule.a), placed(pose, capsule.b)};
    const Real r = 64 * static_cast<Real>(capsule.radius.raw());
    const Real apart = solid.distance(segment);
    if (m.count == 0) {
      REQUIRE(apart - r > size - slack);
      continue;
    }
    ++hits;
    inside += apart < 1 ? 1 : 0;
    pairs += m.count == 2 ? 1 : 0;
    const Point n = steps(m.normal, 30);
    Real deepest = 1e30L;
    for (int k = 0; k < m.count; ++k) {
      const auto& p = m.points[static_cast<std::size_t>(k)];
      const Real s = static_cast<Real>(p.separation.raw());
      deepest = std::min(deepest, s);
      REQUIRE(segment.distance(steps(p.point) + n * (r + s / 2)) < slack);
      const Point on_box = steps(p.point) - n * (s / 2);
      REQUIRE(solid.distance(on_box) < 2 * tolerance + slack);
    }
    if (apart > 2) {
      // The face normal may replace that of closest points that are deeper by up to the tolerance.
      REQUIRE(deepest > apart - r - tolerance - slack);
      if (m.count == 1 && m.points[0].feature == 0) {
        REQUIRE(std::abs(deepest - (apart - r)) < slack);
      }
    } else {
      REQUIRE(deepest < -r + tolerance + slack);
      // No push along an axis of the box is shorter by more than the tolerance.
      for (std::size_t axis = 0; axis < static_cast<std::size_t>(N); ++axis) {
        const Real low = std::min(segment.a[axis], segment.b[axis]);
        const Real high = std::max(segment.a[axis], segment.b[axis]);
        const Real push = std::max(low, -high) - solid.half[axis];
        if (m.points[0].feature == 4) REQUIRE(deepest + r > push + tolerance - slack);
        if (m.points[0].feature >= 8) REQUIRE(deepest + r > push - slack);
      }
    }
    // Swapped, the result is the same within roundings.
    detail::RelativePose<S, N> inverse = pose;
    for (int j = 0; j < N; ++j) {
      for (int k = 0; k < N; ++k) {
        inverse.axes[static_cast<std::size_t>(j)][k] = pose.axes[static_cast<std::size_t>(k)][j];
      }
      inverse.translation[j] = nearest_to<lever<S>>(
          -detent::dot(pose.axes[static_cast<std::size_t>(j)], pose.translation));
    }
    const auto other = manifold(capsule, box, inverse, margin);
    if (other.count != m.count) continue;
    for (int k = 0; k < m.count; ++k) {
      const auto at = static_cast<std::size_t>(k);
      if (m.points[at].feature != other.points[at].feature) continue;
      const Real difference = static_cast<Real>(m.points[at].separation.raw()) -
                              static_cast<Real>(other.points[at].separation.raw());
      if (m.points[at].feature == 0) CHECK(std::abs(difference) < slack);
    }
  }
  CHECK(hits > cases * 3 / 10);
  CHECK(hits < cases * 9 / 10);
  CHECK(pairs > cases / 60);
  CHECK(inside > cases / 50);
}

TEMPLATE_TEST_CASE(
    "box manifold: separations of balls and capsules equal the distances of closest points",
    "[manifold][oracle]", q16_16, q24_8, q8_8) {
  check_box_and_capsule<TestType, 2>(0xb0ca);
  check_box_and_capsule<TestType, 3>(0xb0cb);
}

}  // namespace
}  // namespace detent::test
