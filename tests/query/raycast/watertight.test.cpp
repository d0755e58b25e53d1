// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <map>
#include <vector>

#include "oracle/draw.hpp"
#include "oracle/space.hpp"
#include "query/raycast/helpers.hpp"

namespace detent::test {
namespace {

// Meshes need watertight raycasts against triangles: no ray passes where triangles meet. Exact
// results guarantee that. These tests cast the rays that rounding would let through.

using oracle::cross;
using oracle::difference;
using oracle::dot;
using oracle::Integer;
using oracle::Raw;
using oracle::widen;

template <Scalar S>
using Draw = oracle::Draw<S, 3>;

/// Six times the volume of the tetrahedron a b c d, positive if d is on the left of a b c.
Integer volume(const Raw<3>& a, const Raw<3>& b, const Raw<3>& c, const Raw<3>& d) {
  return dot(cross(difference(widen(b), widen(a)), difference(widen(c), widen(a))),
             difference(widen(d), widen(a)));
}

template <Scalar S>
Triangle<S, 3> triangle(const Raw<3>& a, const Raw<3>& b, const Raw<3>& c) {
  return {Draw<S>::vec(a), Draw<S>::vec(b), Draw<S>::vec(c)};
}

TEMPLATE_TEST_CASE("ray against triangles: no ray escapes from a tetrahedron", "[raycast]",
                   DETENT_FIXED_SCALARS) {
  using S = TestType;
  Draw<S> draw(0x7e74);
  auto& random = draw.random;
  INFO(random);
  long escaped = 0;
  long asked = 0;
  long sharp = 0;
  while (asked < 50'000) {
    const auto scale = std::int64_t{1} << random.between(3, S::bits - 2);
    std::array<Raw<3>, 4> corners{draw.point(scale), draw.point(scale), draw.point(scale),
                                  draw.point(scale)};
    if (volume(corners[0], corners[1], corners[2], corners[3]) < 0) {
      std::swap(corners[0], corners[1]);
    }
    Raw<3> inside{};
    for (const auto& corner : corners) inside = Draw<S>::plus(inside, corner);
    for (auto& component : inside) component /= 4;
    const std::array<std::array<std::size_t, 3>, 4> faces{
        {{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {2, 3, 0}}};
    bool encloses = true;
    for (const auto& [i, j, k] : faces) {
      encloses = encloses && volume(corners[i], corners[j], corners[k], inside) > 0;
    }
    if (!encloses) continue;

    for (int n = 0; n < 20; ++n) {
      // At a corner, at a point of an edge, or anywhere.
      const auto& a = corners[random.below(4)];
      const auto& b = corners[random.below(4)];
      Raw<3> target = a;
      const auto part = random.between(0, 64);
      for (std::size_t i = 0; i < 3; ++i) target[i] += (b[i] - a[i]) * part / 64;
      const auto direction = random.one_in(4) ? draw.any_direction() : draw.towards(inside, target);
      const Ray<S, 3> ray{Draw<S>::vec(inside), direction};
      int hits = 0;
      for (const auto& [i, j, k] : faces) {
        hits += raycast(ray, triangle<S>(corners[i], corners[j], corners[k])).has_value() ? 1 : 0;
      }
      ++asked;
      escaped += hits == 0 ? 1 : 0;
      sharp += hits > 1 ? 1 : 0;
    }
  }
  CHECK(escaped == 0);
  // Some rays hit two faces at once, so edges were tested.
  INFO(sharp << " rays met an edge");
  CHECK(sharp > 0);
}

TEMPLATE_TEST_CASE("ray against triangles: none slips between two that share an edge", "[raycast]",
                   DETENT_FIXED_SCALARS) {
  using S = TestType;
  Draw<S> draw(0xed6e);
  auto& random = draw.random;
  INFO(random);
  long slipped = 0;
  long asked = 0;
  HitRate first;
  while (asked < 50'000) {
    const auto scale = std::int64_t{1} << random.between(6, S::bits - 3);
    const auto a = draw.point(scale);
    const auto b = draw.point(scale);
    const auto c = draw.point(scale);
    const auto d = draw.point(scale);
    // From in front of both triangles through the middle half of the edge, off by one or two raw
    // units because of the grid.
    Raw<3> middle = a;
    const auto part = random.between(16, 48);
    for (std::size_t i = 0; i < 3; ++i) middle[i] += (b[i] - a[i]) * part / 64;
    const auto direction = random.one_in(4) ? draw.axis_direction() : draw.any_direction();
    const auto origin = Draw<S>::moved(middle, direction, -4 * scale);
    const Ray<S, 3> ray{Draw<S>::vec(origin), direction};

    // Seen along the ray, c and d are at least 16 raw units to either side of the edge and within
    // its ends, and the edge is at least 16 units long, so the ray is well inside the union of
    // both.
    const auto along = widen(oracle::raw(direction));
    const auto seen = [&](const Raw<3>& from, const Raw<3>& to) {
      return cross(along, difference(widen(to), widen(from)));
    };
    const auto edge = seen(a, b);
    const Integer square = dot(edge, edge);
    const auto side_c = dot(edge, difference(widen(c), widen(a)));
    const auto side_d = dot(edge, difference(widen(d), widen(a)));
    if (square < 256 * dot(along, along) || side_c.sign() * side_d.sign() >= 0) continue;
    if (side_c * side_c < 256 * square || side_d * side_d < 256 * square) continue;
    const auto beside = [&](const Raw<3>& p) {
      const Integer place = dot(edge, seen(a, p));
      return place >= 0 && place <= square;
    };
    if (!beside(c) || !beside(d)) continue;

    const bool hits_c = raycast(ray, triangle<S>(a, b, c)).has_value();
    const bool hits_d = raycast(ray, triangle<S>(b, a, d)).has_value();
    ++asked;
    first.count(hits_c);
    slipped += !hits_c && !hits_d ? 1 : 0;
  }
  CHECK(slipped == 0);
  INFO(first);
  CHECK(first.is_balanced());
}

TEMPLATE_TEST_CASE(
    "ray against triangles: a ray at a shared edge or corner hits all triangles around it",
    "[raycast]", DETENT_FIXED_SCALARS) {
  using S = TestType;
  Draw<S> draw(0xfa4);
  auto& random = draw.random;
  INFO(random);
  long missed = 0;
  for (int n = 0; n < 50'000; ++n) {
    // Exactly through the common corner, or a point of the common edge: the ray is along an axis of
    // an integer frame.
    const auto& frame = draw.frame();
    const auto scale = std::int64_t{1} << random.between(3, S::bits - 3);
    const auto corner = draw.point(scale);
    const auto steps = scale / frame.norm;
    const auto origin = Draw<S>::plus(corner, frame.axes[0], -random.between(0, steps));
    const Ray<S, 3> ray{Draw<S>::vec(origin), Draw<S>::stretched(frame.axes[0], frame.norm)};
    auto previous = draw.point(scale);
    for (int i = 0; i < 5; ++i) {
      const auto next = draw.point(scale);
      missed += raycast(ray, triangle<S>(corner, previous, next)).has_value() ? 0 : 1;
      previous = next;
      const auto edge = draw.point(scale / 8);
      const auto a = Draw<S>::plus(corner, edge, random.between(0, 7));
      const auto b = Draw<S>::plus(corner, edge, -random.between(0, 7));
      missed += raycast(ray, triangle<S>(a, b, next)).has_value() ? 0 : 1;
    }
  }
  CHECK(missed == 0);
}

/// A closed mesh: an octahedron with each face divided in four and perturbed corners. Corners are
/// multiples of 64 raw units from the center, so that edges contain grid points.
struct ClosedMesh {
  std::vector<Raw<3>> corners;
  std::vector<std::array<std::size_t, 3>> faces;
};

template <Scalar S>
ClosedMesh closed_mesh(Draw<S>& draw) {
  const auto scale = draw.random.between(1, std::int64_t{1} << (S::bits - 10));
  ClosedMesh mesh;
  std::map<Raw<3>, std::size_t> index;  // of a corner of the regular mesh
  const auto corner = [&](const Raw<3>& regular) {
    const auto [found, is_new] = index.try_emplace(regular, mesh.corners.size());
    if (is_new) {
      Raw<3> shaken = regular;
      for (auto& component : shaken) {
        component = 64 * (4 * scale * component + draw.random.between(-scale, scale));
      }
      mesh.corners.push_back(shaken);
    }
    return found->second;
  };
  for (unsigned octant = 0; octant < 8; ++octant) {
    const auto sign = [&](unsigned axis) { return (octant >> axis & 1u) != 0 ? 1 : -1; };
    const std::array<std::size_t, 3> outer{corner({2 * sign(0), 0, 0}), corner({0, 2 * sign(1), 0}),
                                           corner({0, 0, 2 * sign(2)})};
    const std::array<std::size_t, 3> inner{corner({0, sign(1), sign(2)}),
                                           corner({sign(0), 0, sign(2)}),
                                           corner({sign(0), sign(1), 0})};
    mesh.faces.push_back(inner);
    mesh.faces.push_back({outer[0], inner[1], inner[2]});
    mesh.faces.push_back({inner[0], outer[1], inner[2]});
    mesh.faces.push_back({inner[0], inner[1], outer[2]});
  }
  return mesh;
}

/// Casts `count` rays exactly through corners and points of edges of closed meshes, from inside and
/// outside. Returns how many reach their target without a hit.
template <Scalar S>
long lost_rays(std::uint64_t seed, long count) {
  Draw<S> draw(seed);
  auto& random = draw.random;
  long lost = 0;
  for (long asked = 0; asked < count;) {
    const auto mesh = closed_mesh(draw);
    std::vector<Triangle<S, 3>> triangles;
    for (const auto& [i, j, k] : mesh.faces) {
      triangles.push_back(triangle<S>(mesh.corners[i], mesh.corners[j], mesh.corners[k]));
    }
    for (int n = 0; n < 1'000; ++n, ++asked) {
      const auto& face = mesh.faces[random.below(mesh.faces.size())];
      const auto side = random.below(3);
      const auto& a = mesh.corners[face[side]];
      const auto& b = mesh.corners[face[(side + 1) % 3]];
      const auto part = random.coin() ? 0 : random.between(1, 63);
      Raw<3> target = a;
      for (std::size_t i = 0; i < 3; ++i) target[i] += (b[i] - a[i]) / 64 * part;
      const auto& frame = draw.frame();
      const auto steps = random.between(1, (std::int64_t{1} << (S::bits - 2)) / frame.norm);
      const auto origin = Draw<S>::plus(target, frame.axes[0], -steps);
      // A stored direction is at most 2^-29 (2^-13) too short to reach it.
      const Ray<S, 3> ray{Draw<S>::vec(origin), Draw<S>::stretched(frame.axes[0], frame.norm),
                          Draw<S>::scalar(steps * frame.norm + steps * frame.norm / 4096 + 4)};
      const bool is_hit = std::any_of(triangles.begin(), triangles.end(),
                                      [&](const auto& t) { return raycast(ray, t).has_value(); });
      lost += is_hit ? 0 : 1;
    }
  }
  return lost;
}

TEMPLATE_TEST_CASE("ray against a closed mesh: no ray at its edges and corners is lost",
                   "[raycast]", DETENT_FIXED_SCALARS) {
  CHECK(lost_rays<TestType>(0xc105ed, 20'000) == 0);
}

TEMPLATE_TEST_CASE("ray against a closed mesh: none of ten million rays is lost",
                   "[raycast][.demand]", DETENT_FIXED_SCALARS) {
  CHECK(lost_rays<TestType>(0xc105ed + 1, 2'500'000) == 0);
}

}  // namespace
}  // namespace detent::test
