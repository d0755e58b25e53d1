// SPDX-License-Identifier: MIT
#include "detent/dynamics/hull.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <string>
#include <vector>

#include "detent/dynamics/fields.hpp"
#include "detent/dynamics/snapshot.hpp"
#include "detent/scene/sync_test.hpp"
#include "dynamics/stage.hpp"
#include "dynamics/step_alike.hpp"
#include "support/catch.hpp"
#include "support/random.hpp"
#include "support/seal.hpp"

namespace detent::test {
namespace {

template <Scalar S>
std::vector<Vec<S, 3>> cube_points(double half) {
  std::vector<Vec<S, 3>> points;
  for (int c = 0; c < 8; ++c) {
    points.push_back(make_vec<3>([&](int i) { return num<S>((c >> i & 1) != 0 ? -half : half); }));
  }
  return points;
}

template <class S>
using Hulls = World<S, 3, Obb, Capsule, BodyHull>;

TEMPLATE_TEST_CASE("solid hull: a cube has 6 faces and 12 edges, whatever points are inside", "",
                   q16_16, q24_8, q8_8, double) {
  using S = TestType;
  auto points = cube_points<S>(0.5);
  points.push_back({});
  points.push_back({num<S>(0.5), num<S>(0.25), num<S>(0)});     // on a face
  points.push_back({num<S>(-0.5), num<S>(0.5), num<S>(0.25)});  // on an edge
  points.push_back(points[0]);
  const auto solid = solid_hull(3, ConvexHull<S, 3>{points});
  REQUIRE(solid);
  const auto faces = solid->faces();
  CHECK(faces.points.size() == 8);
  CHECK(faces.edges.size() == 12);
  REQUIRE(faces.faces.size() == 6);
  for (const auto& face : faces.faces) {
    CHECK(face.count == 4);
    CHECK(abs(face.normal.x) + abs(face.normal.y) + abs(face.normal.z) == 1);
    for (const auto& p : faces.points) CHECK(faces.height(face, p) <= 0);
  }
  CHECK(solid->center() == std::remove_cvref_t<decltype(solid->center())>());
  CHECK(solid->id() == 3);
}

TEST_CASE("solid hull: too many points, or points without volume, are rejected") {
  using S = q16_16;
  auto points = cube_points<S>(0.5);
  points.resize(33, points[0]);
  CHECK_FALSE(solid_hull(1, ConvexHull<S, 3>{points}));
  points.pop_back();
  CHECK(solid_hull(1, ConvexHull<S, 3>{points}));
  const std::array flat{Vec<S, 3>{}, Vec<S, 3>{S(1), S(0), S(0)}, Vec<S, 3>{S(0), S(1), S(0)},
                        Vec<S, 3>{S(1), S(1), S(0)}};
  CHECK_FALSE(solid_hull(1, ConvexHull{flat}));
  CHECK_FALSE(solid_hull(1, ConvexHull<S, 3>{}));
  const std::array line{Vec<S, 2>{}, Vec<S, 2>{S(1), S(1)}, Vec<S, 2>{S(2), S(2)}};
  CHECK_FALSE(solid_hull(1, ConvexHull{line}));
}

TEST_CASE("solid hull: faces form a closed polyhedron that contains all points") {
  using S = q16_16;
  Random random(30);
  for (int round = 0; round < 200; ++round) {
    std::vector<Vec<S, 3>> points;
    const auto count = static_cast<std::size_t>(random.between(5, 32));
    // On a coarse grid many points share faces.
    const auto grid = random.coin() ? 2 : 1000;
    while (points.size() < count) {
      points.push_back(make_vec<3>(
          [&](int) { return num<S>(static_cast<double>(random.between(-grid, grid)) / grid); }));
    }
    const auto solid = solid_hull(1, ConvexHull<S, 3>{points});
    if (!solid) continue;
    const auto hull = solid->faces();
    REQUIRE(hull.points.size() + hull.faces.size() == hull.edges.size() + 2);
    REQUIRE(hull.sides.size() == 2 * hull.edges.size());
    for (std::size_t f = 0; f < hull.faces.size(); ++f) {
      const auto& face = hull.faces[f];
      REQUIRE(face.count >= 3);
      for (const auto& p : hull.points) {
        REQUIRE(static_cast<double>(hull.height(face, p)) < std::ldexp(1, -21));
      }
      for (std::size_t k = 0; k < face.count; ++k) {
        const auto& corner = hull.corner(face, k);
        REQUIRE(std::abs(static_cast<double>(hull.height(face, corner))) < std::ldexp(1, -21));
        // The side's normal points away from all corners of the face.
        for (std::size_t l = 0; l < face.count; ++l) {
          REQUIRE(static_cast<double>(hull.beyond(face, k, hull.corner(face, l))) <
                  std::ldexp(1, -21));
        }
        // The edge to the next corner has this face on its left.
        const auto from = hull.corners[face.first + k];
        const auto to = hull.corners[face.first + (k + 1) % face.count];
        const auto edge = std::find_if(hull.edges.begin(), hull.edges.end(), [&](const auto& e) {
          return (e.from == from && e.to == to) || (e.from == to && e.to == from);
        });
        REQUIRE(edge != hull.edges.end());
        REQUIRE(std::size_t{edge->from == from ? edge->left : edge->right} == f);
      }
    }
  }
}

/// Crates and wedges above a floor.
template <Scalar S>
struct Pile {
  std::vector<Vec<S, 3>> crate_points = cube_points<S>(0.4);
  std::vector<Vec<S, 3>> wedge_points{{},
                                      {num<S>(1), num<S>(0), num<S>(0)},
                                      {num<S>(0), num<S>(0.6), num<S>(0)},
                                      {num<S>(0), num<S>(0), num<S>(0.8)},
                                      {num<S>(1), num<S>(0), num<S>(0.8)},
                                      {num<S>(0), num<S>(0.6), num<S>(0.8)}};
  std::vector<SolidHull<S, 3>> solids{*solid_hull(1, ConvexHull<S, 3>{crate_points}),
                                      *solid_hull(2, ConvexHull<S, 3>{wedge_points})};

  void put(Hulls<S>& world, std::uint32_t index) const {
    BodyOptions<S, 3> options;
    if (index == 0) {
      options.motion = BodyMotion::fixed;
      REQUIRE(world.put({0, 1}, Obb<S, 3>{{S(0), S(-1), S(0)}, {S(20), S(1), S(20)}, {}}, options));
      return;
    }
    const auto rotation =
        Rotation<S, 3>::from_axis_angle(Direction<S, 3>::along(static_cast<int>(index % 3)),
                                        Angle<S>::from_radians(num<S>(0.4 * index)));
    const Vec<S, 3> at{num<S>(0.3 * (index % 3)), num<S>(0.8 * index), num<S>(0.2 * (index % 2))};
    REQUIRE(world.put({index, 1}, BodyHull<S, 3>{&solids[index % 2], at, rotation}, options));
  }
  Hulls<S> world(std::uint32_t count) const {
    Hulls<S> result;
    for (std::uint32_t i = 0; i < count; ++i) put(result, i);
    return result;
  }
};

TEST_CASE("hull body: its position is its center of mass") {
  using S = q16_16;
  const Pile<S> pile;
  Hulls<S> world;
  const auto id = world.add(BodyHull<S, 3>{&pile.solids[1], {S(5), S(6), S(7)}, {}});
  REQUIRE(id);
  const auto p = world.position(*id);
  CHECK(std::abs(static_cast<double>(p.x) - 5 - 1.0 / 3) < 1e-4);
  CHECK(std::abs(static_cast<double>(p.y) - 6 - 0.2) < 1e-4);
  CHECK(std::abs(static_cast<double>(p.z) - 7 - 0.4) < 1e-4);
}

TEMPLATE_TEST_CASE("hull body: a pile comes to rest and stays at rest", "", q16_16, double) {
  using S = TestType;
  const Pile<S> pile;
  auto world = pile.world(9);
  for (int t = 0; t < 600; ++t) world.step();
  const auto before = digest(world);
  for (std::uint32_t i = 1; i < 9; ++i) {
    CHECK(world.is_asleep({i, 1}));
    const double y = static_cast<double>(world.position({i, 1}).y);
    CHECK((y > 0.15 && y < 8));
  }
  for (int t = 0; t < 200; ++t) world.step();
  CHECK(digest(world) == before);
}

TEST_CASE("hull body: a heap of 40 comes to rest, and has not moved 10,000 ticks later",
          "[.demand]") {
  using S = q16_16;
  const Pile<S> pile;
  auto world = pile.world(41);
  for (int t = 0; t < 2400; ++t) world.step();
  const auto before = digest(world);
  for (std::uint32_t i = 1; i < 41; ++i) CHECK(world.is_asleep({i, 1}));
  for (int t = 0; t < 10000; ++t) world.step();
  CHECK(digest(world) == before);
}

TEST_CASE("hull body: a different hull is named as a difference") {
  using S = q16_16;
  const Pile<S> pile;
  Hulls<S> world, other;
  REQUIRE(world.put({4, 2}, BodyHull<S, 3>{&pile.solids[0], {}, {}}));
  auto points = pile.crate_points;
  points[0].z = num<S>(0.40001);
  const auto solid = solid_hull(1, ConvexHull<S, 3>{points});
  REQUIRE(other.put({4, 2}, BodyHull<S, 3>{&*solid, {}, {}}));
  CHECK_FALSE(diff(world, world));
  std::vector<std::string> names;
  (void)diff(
      world, other, [&](const FieldDifference& found) { names.emplace_back(found.field.view()); },
      16);
  const std::string name = "body 4:2 (solid hull) digest of its points";
  CHECK(std::count(names.begin(), names.end(), name) == 1);
}

TEST_CASE("hull body: bits do not depend on the order of additions") {
  using S = q16_16;
  const Pile<S> pile;
  auto forward = pile.world(7);
  Hulls<S> backward;
  for (std::uint32_t i = 7; i-- > 0;) pile.put(backward, i);
  step_alike(forward, backward, 200);
}

TEST_CASE("hull body: a snapshot is restored with its hulls, and refused without them") {
  using S = q16_16;
  const Pile<S> pile, twin;
  auto world = pile.world(7);
  for (int t = 0; t < 90; ++t) world.step();
  const auto bytes = snapshot(world);
  Hulls<S> fresh;
  pile.put(fresh, 0);
  const auto before = digest(fresh);
  CHECK(restore(fresh, bytes) == Restored::unknown_asset);
  CHECK(restore(fresh, bytes, std::span(pile.solids).first(1)) == Restored::unknown_asset);
  const std::vector<SolidHull<S, 3>> others{pile.solids[0],
                                            *solid_hull(2, ConvexHull<S, 3>{pile.crate_points})};
  CHECK(restore(fresh, bytes, others) == Restored::other_asset);
  CHECK(digest(fresh) == before);
  REQUIRE(restore(fresh, bytes, twin.solids) == Restored::yes);
  CHECK(snapshot(fresh) == bytes);
  step_alike(world, fresh, 200);
  // A hull that is not centered on its center of mass cannot belong to a body.
  for (std::size_t i = 0; i + 8 < bytes.size(); ++i) {
    auto changed = bytes;
    changed[i] = static_cast<std::byte>(static_cast<unsigned char>(changed[i]) ^ 1u);
    seal(changed);
    Hulls<S> target;
    pile.put(target, 0);
    if (restore(target, changed, pile.solids) == Restored::yes) {
      REQUIRE(snapshot(target) == changed);
      const auto& bodies = detail::WorldAccess::bodies(target);
      for (std::size_t k = 1; k < bodies.size(); ++k) {
        const auto* hull = bodies[k].shape.template get<BodyHull<S, 3>>();
        REQUIRE((hull == nullptr || *hull == BodyHull<S, 3>{hull->asset, {}, {}}));
      }
      target.step();
    }
  }
}

}  // namespace
}  // namespace detent::test
