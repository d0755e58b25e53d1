// SPDX-License-Identifier: MIT
#include "detent/dynamics/terrain.hpp"

#include <algorithm>
#include <array>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "detent/dynamics/fields.hpp"
#include "detent/dynamics/snapshot.hpp"
#include "detent/scene/height_field/height_field.hpp"
#include "detent/scene/mesh/owned.hpp"
#include "detent/scene/sync_test.hpp"
#include "dynamics/draw.hpp"
#include "dynamics/terrain.hpp"
#include "support/catch.hpp"
#include "support/seal.hpp"

namespace detent::test {
namespace {

const auto hills = [](double x, double z) {
  const auto wave = [](double t) {
    const double u = t - static_cast<int>(t);
    return u * (1 - u);
  };
  return 1.5 * wave((x + 50) / 3) * wave((z + 50) / 4);
};

double hundredths(Random& random, int least, int most) {
  return static_cast<int>(random.between(least, most)) * 0.01;
}

/// A body near a surface, as the solver sees it.
template <class Body, class Solid>
auto contacts_of(const Body& body, const Solid& solid,
                 const detail::RelativePose<q16_16, 3>& pose) {
  std::vector<detail::FacetContact<q16_16>> list;
  detail::FacetContacts<decltype(list), q16_16> contacts(list, 10000);
  contacts.find(body, solid, pose, detail::extent_of(solid), num<q16_16>(0.02),
                nearest_to<typename detail::Formats<q16_16>::Gap>(num<q16_16>(0.02)));
  std::erase_if(list, [](const auto& contact) { return contact.manifold.count == 0; });
  return list;
}

detail::RelativePose<q16_16, 3> pose_at(const Vec<q16_16, 3>& p, Random& random) {
  detail::RelativePose<q16_16, 3> pose;
  const auto turn = [&] { return Angle<q16_16>::turn(static_cast<int>(random.below(1000)), 1000); };
  const auto rotation = Rotation<q16_16, 3>::from_euler(turn(), turn(), turn());
  for (int i = 0; i < 3; ++i) {
    pose.translation[i] = nearest_to<typename detail::Formats<q16_16>::Lever>(p[i]);
    for (int k = 0; k < 3; ++k) {
      pose.axes[static_cast<std::size_t>(k)][i] =
          nearest_to<typename detail::Formats<q16_16>::Ratio>(rotation.axis(k)[i]);
    }
  }
  return pose;
}

TEST_CASE("terrain: over a plane of triangles all normals are the plane's") {
  using S = q16_16;
  Random random(71);
  CAPTURE(random.seed());
  const std::vector<Vec<S, 3>> wedge{point<S>(-0.5, -0.3, -0.4), point<S>(0.5, -0.3, -0.4),
                                     point<S>(0, -0.3, 0.6), point<S>(0, 0.5, 0)};
  const auto solid = solid_hull(1, ConvexHull<S, 3>{wedge});
  REQUIRE(solid);
  const double slope = GENERATE(0.0, 0.5);
  const int cells = GENERATE(8, 32);
  const Owned<S> ground(square<S>(cells, 4, [&](double x, double) { return slope * x; }));
  const BodyMesh<S, 3> body{&ground.asset, {}, {}};
  const auto normal = detail::facet_of(ground.mesh.view().triangles[0].triangle)->normal();
  std::size_t found = 0;
  const auto exam = [&](const auto& shape, double height) {
    const double x = hundredths(random, -200, 200), z = hundredths(random, -200, 200);
    const auto pose = pose_at(point<S>(x, slope * x + height, z), random);
    for (const auto& contact : contacts_of(body, shape, pose)) {
      REQUIRE(contact.manifold.normal == normal);
      ++found;
    }
  };
  for (int round = 0; round < 150; ++round) {
    const double height = hundredths(random, 5, 70);
    exam(Sphere<S, 3>{{}, num<S>(0.4)}, height);
    exam(Capsule<S, 3>{point<S>(-0.3, 0, 0), point<S>(0.3, 0, 0), num<S>(0.3)}, height);
    exam(Obb<S, 3>{{}, point<S>(0.4, 0.3, 0.5), {}}, height);
    exam(BodyHull<S, 3>{&*solid, {}, {}}, height);
  }
  CHECK(found > 600);
}

TEST_CASE("terrain: a first contact does not inherit impulses from other bodies' contacts") {
  const Owned<q16_16> plane(square<q16_16>(1, 8, [](double, double) { return 0.0; }));
  const auto run = [&](bool has_neighbour) {
    Ground<q16_16> world;
    REQUIRE(world.add(BodyMesh<q16_16, 3>{&plane.asset, {}, {}}, fixed<q16_16>()));
    BodyOptions<q16_16, 3> options;
    options.velocity = point<q16_16>(1, 0, 0.5);
    options.restitution = num<q16_16>(0.5);
    const auto ball =
        *world.add(Sphere<q16_16, 3>{point<q16_16>(-4, 0.6, -4), num<q16_16>(0.5)}, options);
    options.velocity = point<q16_16>(3, 0, -2);
    if (has_neighbour) {
      REQUIRE(world.add(Sphere<q16_16, 3>{point<q16_16>(-6, 0.5, -4), num<q16_16>(0.5)}, options));
    }
    std::vector<std::uint64_t> states;
    for (int t = 0; t < 60; ++t) {
      world.step();
      states.push_back(digest_of(world, ball));
    }
    return states;
  };
  CHECK(run(true) == run(false));
}

TEST_CASE("terrain: a body on a plane of triangles is as deep as on one face") {
  using S = q16_16;
  Random random(72);
  CAPTURE(random.seed());
  const Owned<S> ground(square<S>(12, 6, level));
  const BodyMesh<S, 3> body{&ground.asset, {}, {}};
  const auto margin = num<S>(0.02);
  for (int round = 0; round < 300; ++round) {
    const auto p = point<S>(hundredths(random, -200, 200), hundredths(random, 20, 70),
                            hundredths(random, -200, 200));
    const auto pose = pose_at(p, random);
    const auto exam = [&](const auto& shape, const auto& lowest) {
      const auto contacts = contacts_of(body, shape, pose);
      CHECK(contacts.empty() == (lowest > margin));
      if (contacts.empty()) return;
      auto least = contacts[0].manifold.points[0].separation;
      for (const auto& contact : contacts) {
        for (int i = 0; i < contact.manifold.count; ++i) {
          const auto& at = contact.manifold.points[static_cast<std::size_t>(i)];
          least = (std::min)(least, at.separation);
        }
      }
      CHECK(abs(least - lowest) <= num<S>(0.001));
    };
    exam(Sphere<S, 3>{{}, num<S>(0.4)}, p.y - num<S>(0.4));
    const Obb<S, 3> box{{}, point<S>(0.4, 0.3, 0.5), {}};
    using Lever = typename detail::Formats<S>::Lever;
    auto depth = Lever();
    for (int i = 0; i < 3; ++i) {
      depth = nearest_to<Lever>(depth + abs(pose.axes[static_cast<std::size_t>(i)].y) *
                                            box.half_extents[i]);
    }
    exam(box, p.y - depth);
  }
}

TEST_CASE("terrain: bodies locked in a plane slide over the vertices of a strip at full speed") {
  using S = q16_16;
  const auto run = [](int segments, const auto& shape, bool has_friction) {
    std::vector<Triangle<S, 3>> strip;
    for (int i = 0; i < segments; ++i) {
      const double from = 28.0 * i / segments - 14, to = 28.0 * (i + 1) / segments - 14;
      strip.push_back({point<S>(from, 0, -2), point<S>(from, 0, 2), point<S>(to, 0, -2)});
      strip.push_back({point<S>(to, 0, -2), point<S>(from, 0, 2), point<S>(to, 0, 2)});
    }
    const Owned<S> ground(strip);
    Ground<S> world;
    REQUIRE(world.add(BodyMesh<S, 3>{&ground.asset, {}, {}}, fixed<S>()));
    BodyOptions<S, 3> options;
    options.locked = AxisLock::z | AxisLock::turn_x | AxisLock::turn_y;
    options.velocity = point<S>(5, 0, 0);
    if (has_friction) {
      options.angular_velocity[2] = S(-10);
    } else {
      options.friction = {};
    }
    const auto id = *world.add(shape, options);
    double least = 5, fastest_rise = 0;
    for (int t = 0; t < 200; ++t) {
      world.step();
      const auto v = world.velocity(id);
      least = (std::min)(least, static_cast<double>(v.x));
      fastest_rise = (std::max)(fastest_rise, static_cast<double>(abs(v.y)));
      REQUIRE(world.position(id).z == S(0));
      REQUIRE(world.rotation(id).axis(2) == Rotation<S, 3>().axis(2));
    }
    CAPTURE(segments, has_friction, least, fastest_rise);
    CHECK(static_cast<double>(world.position(id).x) > 6.6);
    CHECK(least > 4.999);
    CHECK(fastest_rise < 0.001);
  };
  for (const int segments : {1, 40, 67}) {
    run(segments, Obb<S, 3>{point<S>(-10, 0.5, 0), point<S>(0.5, 0.5, 0.5), {}}, false);
    run(segments, Capsule<S, 3>{point<S>(-10.5, 0.3, 0), point<S>(-9.5, 0.3, 0), num<S>(0.3)},
        false);
    run(segments, Sphere<S, 3>{point<S>(-10, 0.5, 0), num<S>(0.5)}, true);
  }
}

TEST_CASE("terrain: edges and corners push only where no neighbour rises from them") {
  using S = q16_16;
  Random random(73);
  const auto pose = [&](double x, double y) {
    auto result = pose_at(point<S>(x, y, 0.3), random);
    result.axes = detail::axes_of<S, 3>(detail::upright<S, 3>());
    return result;
  };
  const auto roof = [](double x, double) { return x < 0 ? x : -x; };
  const auto gutter = [](double x, double) { return x < 0 ? -x : x; };
  const Owned<S> ridge(square<S>(8, 4, roof)), valley(square<S>(8, 4, gutter));
  const Sphere<S, 3> ball{{}, num<S>(0.5)};
  const auto on_ridge = contacts_of(BodyMesh<S, 3>{&ridge.asset, {}, {}}, ball, pose(0.1, 0.45));
  REQUIRE(on_ridge.size() == 1);
  CHECK(abs(on_ridge[0].manifold.normal.x) < num<S>(0.25));
  CHECK(on_ridge[0].manifold.normal.x > num<S>(0.2));
  CHECK(on_ridge[0].manifold.normal.y > num<S>(0.97));
  const auto in_valley = contacts_of(BodyMesh<S, 3>{&valley.asset, {}, {}}, ball, pose(0, 0.7));
  REQUIRE(in_valley.size() == 2);
  CHECK(in_valley[0].manifold.normal.x == -in_valley[1].manifold.normal.x);
  // A box across the ridge rests on the ridge's edge.
  const Obb<S, 3> box{{}, point<S>(0.3, 0.2, 0.1), {}};
  for (const auto& contact :
       contacts_of(BodyMesh<S, 3>{&ridge.asset, {}, {}}, box, pose(0, 0.19))) {
    CHECK(contact.manifold.normal == detail::unit_axis<typename detail::Formats<S>::Ratio, 3>(1));
  }
  // Past the plane's outer edge a ball leaves over that edge; from behind it passes.
  const Owned<S> plate(square<S>(8, 4, level));
  const BodyMesh<S, 3> body{&plate.asset, {}, {}};
  const auto outside = contacts_of(body, ball, pose(4.3, 0.3));
  REQUIRE(outside.size() == 1);
  CHECK(abs(outside[0].manifold.normal.x - outside[0].manifold.normal.y) < num<S>(0.01));
  CHECK(contacts_of(body, ball, pose(0, -0.1)).empty());
}

/// Bodies of all kinds over a mesh of hills, and over a height field to its right.
struct Landscape {
  using S = q16_16;
  Owned<S> mesh{square<S>(16, 8, hills)};
  std::vector<S> heights;
  std::vector<Vec<S, 3>> points{point<S>(-0.4, -0.3, -0.4), point<S>(0.4, -0.3, -0.4),
                                point<S>(0, -0.3, 0.5), point<S>(0, 0.5, 0)};
  SolidHull<S, 3> solid = *solid_hull(9, ConvexHull<S, 3>{points});
  std::vector<FieldAsset<S>> fields;

  Landscape() {
    for (int j = 0; j <= 16; ++j) {
      for (int i = 0; i <= 16; ++i) heights.push_back(num<S>(hills(i + 8, j - 8)));
    }
    fields.emplace_back(2, *height_field<S>({S(8), S(-8)}, S(1), 17, 17, heights));
  }
  template <class World>
  void add_ground(World& world) const {
    (void)world.put({0, 1}, BodyMesh<S, 3>{&mesh.asset, {}, {}}, fixed<S>());
    (void)world.put({40, 2}, BodyHeightField<S, 3>{&fields[0], {}}, fixed<S>());
  }
  template <class World>
  void fill(World& world) const {
    add_ground(world);
    for (int i = 0; i < 20; ++i) {
      const auto p = point<S>(-6 + 1.4 * i, 1.2 + 0.1 * (i % 3), (i % 5) - 2.0);
      const auto end = point<S>(-5.7 + 1.4 * i, 1.4 + 0.1 * (i % 3), (i % 5) - 1.9);
      BodyOptions<S, 3> options;
      options.velocity = point<S>(i % 3 - 1.0, 0, 1.5);
      options.restitution = num<S>(i == 3 ? 0.5 : 0);
      options.is_sensor = i == 7;
      const auto index = static_cast<std::uint32_t>(i + 1);
      const BodyId id{index, 3 + index};
      switch (i % 4) {
        case 0:
          (void)world.put(id, Sphere<S, 3>{p, num<S>(0.35)}, options);
          break;
        case 1:
          (void)world.put(id, Obb<S, 3>{p, point<S>(0.3, 0.2, 0.4), {}}, options);
          break;
        case 2:
          (void)world.put(id, Capsule<S, 3>{p, end, num<S>(0.2)}, options);
          break;
        default:
          (void)world.put(id, BodyHull<S, 3>{&solid, p, {}}, options);
      }
    }
  }
  [[nodiscard]] Restored restored(Ground<S>& world, std::span<const std::byte> bytes) const {
    return restore(world, bytes, std::span(&mesh.asset, 1), fields, std::span(&solid, 1));
  }
};

TEST_CASE("terrain: nothing falls through, and bits continue from snapshots") {
  const Landscape land;
  Ground<q16_16> world;
  land.fill(world);
  using Storage = Bounded<48>;
  auto bounded = std::make_unique<BoundedWorld<Storage, q16_16, 3, Sphere, Capsule, Aabb, Obb,
                                               BodyHull, BodyMesh, BodyHeightField>>();
  land.fill(*bounded);
  Ground<q16_16> other;
  std::size_t most = 0;
  for (int t = 0; t < 240; ++t) {
    if (t % 60 == 30) {
      other = Ground<q16_16>();
      land.add_ground(other);
      const auto bytes = snapshot(world);
      REQUIRE(land.restored(other, bytes) == Restored::yes);
      REQUIRE(snapshot(other) == bytes);
    }
    world.step();
    if (t < 60) {
      bounded->step();
      REQUIRE(digest(*bounded) == digest(world));
    }
    if (t < 30) continue;
    other.step();
    REQUIRE(digest(world) == digest(other));
    most = (std::max)(most, detail::WorldAccess::contacts(world).size());
  }
  CHECK(most > 25);
  for (std::uint32_t i = 1; i <= 20; ++i) {
    if (i == 8) continue;  // the sensor
    const auto p = world.position({i, 3 + i});
    CAPTURE(i);
    const bool is_on = p.x > -8 && p.x < 24 && p.z > -8 && p.z < 8;
    CHECK((p.y > 0 || !is_on));
  }
  CHECK(world.position({8, 11}).y < -10);
}

TEST_CASE("terrain: wrong assets and hostile bytes leave the world unchanged") {
  using S = q16_16;
  const Landscape land;
  Ground<S> world;
  BodyOptions<S, 3> tray;
  tray.motion = BodyMotion::kinematic;
  (void)world.put({0, 1}, BodyMesh<S, 3>{&land.mesh.asset, {}, {}}, tray);
  (void)world.put({1, 1}, Obb<S, 3>{point<S>(0.2, 1, 0.1), point<S>(0.5, 0.3, 0.5), {}});
  (void)world.put({2, 1}, Obb<S, 3>{point<S>(0.2, 1.7, 0.1), point<S>(0.5, 0.3, 0.5), {}});
  for (int t = 0; t < 60; ++t) world.step();
  const auto bytes = snapshot(world);
  Ground<S> fresh;
  CHECK(restore(fresh, bytes) == Restored::unknown_asset);
  const Owned<S> flat(square<S>(4, 8, level));
  CHECK(restore(fresh, bytes, std::span(&flat.asset, 1)) == Restored::other_asset);
  CHECK(fresh.size() == 0);
  REQUIRE(land.restored(fresh, bytes) == Restored::yes);
  CHECK(snapshot(fresh) == bytes);
  Random random(74);
  int read = 0;
  for (int round = 0; round < 400; ++round) {
    auto changed = bytes;
    const auto at = random.below(changed.size() - 72) + 64;
    changed[at] ^= static_cast<std::byte>(1u << random.below(8));
    seal(changed);
    Ground<S> victim;
    if (land.restored(victim, changed) != Restored::yes) continue;
    ++read;
    CHECK(snapshot(victim) == changed);
    victim.step();
  }
  CHECK(read > 100);
  // A triangle index for a pair without a surface.
  auto odd = world;
  auto& contacts = detail::WorldAccess::contacts(odd);
  REQUIRE(contacts.size() > 1);
  REQUIRE(contacts[contacts.size() - 1].a == 1);
  contacts[contacts.size() - 1].part = 5;
  CHECK(land.restored(fresh, snapshot(odd)) == Restored::corrupted);
}

TEST_CASE("terrain: differences name the triangle") {
  using S = q16_16;
  const Owned<S> flat(square<S>(4, 4, level));
  Ground<S> world;
  (void)world.put({0, 1}, BodyMesh<S, 3>{&flat.asset, {}, {}}, fixed<S>());
  (void)world.put({1, 2}, Sphere<S, 3>{point<S>(0.9, 0.5, 0.3), num<S>(0.5)});
  world.step();
  auto other = world;
  auto& contacts = detail::WorldAccess::contacts(other);
  REQUIRE(contacts.size() == 1);
  REQUIRE(contacts[0].part != 0);
  contacts[0].pressure[0] = {};
  const auto found = diff(world, other);
  REQUIRE(found);
  CHECK(std::string(found->field.view()) ==
        "contact 0:1 1:2 part " + std::to_string(contacts[0].part) + " point 0 pressure");
  CHECK(digest(world) != digest(other));
}

TEST_CASE("terrain: no triangles, equal or huge indices, and distant triangles do no harm") {
  using S = q16_16;
  Random random(75);
  CAPTURE(random.seed());
  std::size_t contacts = 0;
  for (int round = 0; round < 60; ++round) {
    std::vector<MeshTriangle<S>> triangles;
    for (int i = 0; i < 60; ++i) {
      const Numbers<S, 3> number{random, random.one_in(4)};
      triangles.push_back({{number.point(), number.point(), number.point()},
                           random.one_in(10) ? ~0u : static_cast<std::uint32_t>(random.below(40))});
    }
    std::vector<MeshNode<S>> nodes(tree_capacity(triangles.size()));
    const MeshAsset<S> asset(1, *build_mesh<S>(triangles, nodes));
    World<S, 3, Capsule, Obb, BodyMesh> world;
    world.add(BodyMesh<S, 3>{nullptr, {}, {}}, fixed<S>());
    world.add(BodyMesh<S, 3>{&asset, Numbers<S, 3>{random, random.one_in(3)}.point(), {}});
    for (int i = 0; i < 8; ++i) {
      const Numbers<S, 3> number{random, random.one_in(4)};
      BodyOptions<S, 3> options;
      options.velocity = number.point();
      if (random.coin()) {
        world.add(Capsule<S, 3>{number.point(), number.point(), number()}, options);
      } else {
        world.add(Obb<S, 3>{number.point(), number.point(), {}}, options);
      }
    }
    for (int t = 0; t < 4; ++t) world.step();
    const auto& list = detail::WorldAccess::contacts(world);
    contacts += list.size();
    for (std::size_t i = 1; i < list.size(); ++i) {
      const auto key = [&](std::size_t k) {
        return std::array{list[k].a, list[k].b, list[k].part};
      };
      REQUIRE(key(i - 1) < key(i));
    }
    for (const auto& contact : list) REQUIRE(contact.part < BodyMesh<S, 3>::part_limit);
  }
  CHECK(contacts > 200);
}

}  // namespace
}  // namespace detent::test
