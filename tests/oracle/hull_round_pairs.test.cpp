// SPDX-License-Identifier: MIT
#include "detent/query/overlaps/capsule_hull.hpp"
#include "detent/query/overlaps/plane_hull.hpp"
#include "detent/query/overlaps/sphere_hull.hpp"
// What draws, describes and solves hulls comes before the exam, which looks it up.
#include "oracle/hull.hpp"
//
#include "oracle/pair_exam.hpp"

namespace detent::oracle {
namespace {

template <Scalar S, int N>
bool meet(const Sphere<S, N>& sphere, const ConvexHull<S, N>& hull) {
  if (sphere.radius < 0 || hull.points.empty()) return false;
  const Integer square = raw(sphere.radius) * raw(sphere.radius);
  return !(Moment{square, 1} < nearest(hull, sphere.center)->core.squared);
}

/// Whether some weights of the points, none negative, make their heights over the plane 0.
template <Scalar S, int N>
bool meet(const Plane<S, N>& plane, const ConvexHull<S, N>& hull) {
  const Integer one = Integer(1) << static_cast<unsigned>(direction_component<S>::frac);
  const auto normal = widen(raw(plane.normal));
  Simplex weights(2, hull.points.size());
  for (std::size_t i = 0; i < hull.points.size(); ++i) {
    weights.at(0, i) = dot(normal, raw(hull.points[i])) - raw(plane.offset) * one;
    weights.at(1, i) = 1;
  }
  weights.right(1) = 1;
  return weights.is_feasible();
}

/// The square of the distance between the lines a + s u and b + t v, where they are closest between
/// the ends of both segments: s and t solve the normal equations by Cramer's rule.
template <int N>
std::optional<Moment> between_inner_points(const Vector<N>& a, const Vector<N>& u,
                                           const Vector<N>& b, const Vector<N>& v) {
  const auto w = difference(b, a);
  const Integer uu = dot(u, u), uv = dot(u, v), vv = dot(v, v), uw = dot(u, w), vw = dot(v, w);
  const Integer whole = uu * vv - uv * uv;
  const Integer s = vv * uw - uv * vw, t = uv * uw - uu * vw;
  if (whole.is_zero() || s < 0 || s > whole || t < 0 || t > whole) return {};
  Vector<N> apart;
  for (std::size_t i = 0; i < apart.size(); ++i) apart[i] = w[i] * whole + v[i] * t - u[i] * s;
  return Moment{dot(apart, w), whole};  // w less u and v, to which it is perpendicular
}

/// The distance of two sets that are apart is that of an end of the axis from the hull, of the axis
/// from a point, or of the axis from a segment of two.
template <Scalar S, int N>
bool meet(const Capsule<S, N>& capsule, const ConvexHull<S, N>& hull) {
  if (capsule.radius < 0 || hull.points.empty()) return false;
  if (meet(hull_of(Segment<S, N>{capsule.a, capsule.b}), hull_of(hull))) return true;
  const auto points = hull_of(hull).over;
  const auto a = raw(capsule.a), u = difference(raw(capsule.b), a);
  auto least =
      std::min(nearest(hull, capsule.a)->core.squared, nearest(hull, capsule.b)->core.squared);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto to_point = nearest(Segment<S, N>{capsule.a, capsule.b}, hull.points[i]);
    least = std::min(least, to_point->core.squared);
    for (std::size_t j = 0; j < i; ++j) {
      const auto across =
          between_inner_points<N>(a, u, points[i], difference(points[j], points[i]));
      if (across) least = std::min(least, *across);
    }
  }
  return !(Moment{raw(capsule.radius) * raw(capsule.radius), 1} < least);
}

template <Scalar S, int N>
void examine(std::uint64_t seed, long count) {
  using Hull = ConvexHull<S, N>;
  const auto truth = [](const auto& a, const auto& b) { return meet(a, b); };
  examine_pair<Sphere<S, N>, Hull>(seed, count, truth, Aim{N == 2 ? 75 : 55, 30, 70});
  examine_pair<Plane<S, N>, Hull>(seed + 1, count, truth, Aim{70, 30, 70});
  examine_pair<Capsule<S, N>, Hull>(seed + 2, count / 2, truth, Aim{N == 2 ? 75 : 55, 30, 70});
}

TEMPLATE_TEST_CASE("hull and sphere, plane, capsule: overlapping is decided exactly", "[oracle]",
                   DETENT_FIXED_SPACES) {
  examine<typename TestType::scalar, TestType::dimension>(0x4115, pair_cases / 10);
}

TEMPLATE_TEST_CASE("hull and sphere, plane, capsule: many more decisions are exact",
                   "[oracle][.demand]", DETENT_FIXED_SPACES) {
  for (const auto seed : demanded_seeds()) {
    examine<typename TestType::scalar, TestType::dimension>(seed, pair_cases / 10);
  }
}

}  // namespace
}  // namespace detent::oracle
