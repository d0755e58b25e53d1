// SPDX-License-Identifier: MIT
//
// Restoring a changed snapshot of a world gives a world with exactly this snapshot, which steps like
// any other world that restores it; or it fails and leaves the world unchanged. The first byte
// chooses the world; each change is a few bytes: where, how, and with what. The length and the
// checksum are then corrected, to reach the rest of the decoder.

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "detent/dynamics/dynamics.hpp"
#include "property.hpp"
#include "source.hpp"
#include "support/seal.hpp"

namespace detent::fuzz {
namespace {

using S = q16_16;
using Vec3 = Vec<S, 3>;
using Bodies = World<S, 3, Sphere, Obb, BodyHull, BodyCompound, BodyMesh, BallJoint, ConeJoint,
                     HingeJoint, WheelJoint>;
using Snapshot = std::vector<std::byte>;

/// A point in quarters of a unit.
Vec3 at(int x, int y, int z) {
  const auto quarters = [](int n) { return S::assume_raw(n * 16384); };
  return {quarters(x), quarters(y), quarters(z)};
}
S quarters(int n) { return at(n, 0, 0).x; }

/// What the bodies refer to: a hull, a compound and a mesh, each with id 1.
struct Assets {
  std::array<Vec3, 4> corners{at(0, 0, 0), at(3, 0, 0), at(0, 3, 0), at(0, 0, 3)};
  std::array<SolidHull<S, 3>, 1> hulls{*solid_hull(1, ConvexHull{std::span(corners)})};
  std::array<BodyPart<S, 3>, 3> parts{
      BodyPart(Obb<S, 3>{{}, at(2, 1, 1), {}}),
      BodyPart(Sphere<S, 3>{at(3, 0, 0), quarters(1)}, {.rolling_resistance = quarters(1)}),
      BodyPart(BodyHull<S, 3>{hulls.data(), at(-2, 1, 0), {}})};
  std::array<SolidCompound<S, 3>, 1> compounds{*solid_compound(1, parts)};
  std::array<MeshTriangle<S>, 2> triangles{
      MeshTriangle<S>{{at(-80, 0, -80), at(-80, 0, 80), at(80, 0, -80)}, 0},
      MeshTriangle<S>{{at(80, 0, -80), at(-80, 0, 80), at(80, 0, 80)}, 1}};
  std::array<MeshNode<S>, 2> nodes;
  std::array<MeshAsset<S>, 1> meshes{MeshAsset<S>(1, *build_mesh<S>(triangles, nodes))};
};
const Assets& assets() {
  static const Assets all;
  return all;
}

WorldSettings<S, 3> settings(bool holds) {
  WorldSettings<S, 3> settings;
  settings.sleep_speed = quarters(1);
  settings.hold_distance = quarters(holds ? 1 : 0);
  return settings;
}

/// What a snapshot does not store: the ground.
Bodies level(bool holds) {
  Bodies world(settings(holds));
  BodyOptions<S, 3> fixed;
  fixed.motion = BodyMotion::fixed;
  world.add(BodyMesh<S, 3>{assets().meshes.data(), {}, {}}, fixed);
  world.add(Obb<S, 3>{at(0, -8, 0), at(80, 4, 80), {}}, fixed);
  return world;
}

/// Bodies of every kind on the ground, some with joints, some pushed, after a few ticks.
Bodies busy(bool holds, bool has_cones) {
  Bodies world = level(holds);
  std::vector<BodyId> ids;
  for (int i = 0; i < 10; ++i) {
    BodyOptions<S, 3> options;
    options.user = static_cast<std::uint64_t>(i / 3);
    options.rolling_resistance = quarters(i % 2);
    options.is_fast = i == 3;
    options.is_sensor = i == 6;
    options.locked = i == 7 ? AxisLock::turn : std::uint8_t{0};
    if (i == 8) options.motion = BodyMotion::kinematic;
    const auto place = at(3 * (i % 3), 2 + 3 * (i / 2), i);
    const auto id =
        i % 4 == 0   ? world.add(Sphere<S, 3>{place, quarters(2)}, options)
        : i % 4 == 1 ? world.add(Obb<S, 3>{place, at(2, 1, 2), {}}, options)
        : i % 4 == 2 ? world.add(BodyHull<S, 3>{assets().hulls.data(), place, {}}, options)
                     : world.add(BodyCompound<S, 3>{assets().compounds.data(), place, {}}, options);
    ids.push_back(id.value_or(no_object));
  }
  const auto join = [&](auto joint, std::size_t a, std::size_t b) {
    joint.a = ids[a];
    joint.b = ids[b];
    joint.anchor_a = at(2, 0, 0);
    joint.anchor_b = at(-2, 0, 0);
    world.add(joint);
  };
  if (has_cones) {
    ConeJoint<S, 3> cone;
    cone.cone_angle = quarters(1);
    join(cone, 0, 1);
    cone.has_limits = true;
    cone.upper = quarters(2);
    join(cone, 2, 3);
  } else {
    join(BallJoint<S, 3>(), 0, 1);
    HingeJoint<S, 3> hinge;
    hinge.has_limits = true;
    hinge.upper = quarters(2);
    join(hinge, 2, 3);
  }
  WheelJoint<S, 3> wheel;
  wheel.frequency = quarters(8);
  wheel.motor_torque = quarters(4);
  join(wheel, 4, 5);
  for (int t = 0; t < 25; ++t) world.step();
  world.apply_force(ids[1], at(4, 0, 0));
  return world;
}

Snapshot bytes_of(const Bodies& world) {
  const auto bytes = snapshot(world);
  return {bytes.begin(), bytes.end()};
}

Restored restore_all(Bodies& world, const Snapshot& bytes) {
  return restore(world, bytes, std::span(assets().hulls), std::span(assets().compounds),
                 std::span(assets().meshes));
}

/// Makes one change. Numbers that are stored in four bytes become extreme ones.
void change(Snapshot& bytes, Source& source) {
  constexpr std::array<std::uint32_t, 8> words{0,           1,           0x7fffffffu, 0x80000000u,
                                               0x80000001u, 0xffffffffu, 0x40000000u, 0x00010000u};
  const auto where = static_cast<std::ptrdiff_t>(source.word(2) % bytes.size());
  const auto at = bytes.begin() + where;
  const auto how = source.byte();
  const auto left = bytes.end() - at;
  if (how < 96) {
    *at ^= static_cast<std::byte>(source.byte());
  } else if (how < 224) {
    if (left >= 4) detail::store_word(&*at, words[source.below(words.size())]);
  } else if (how < 232) {
    bytes.erase(at, at + (std::min)(left, std::ptrdiff_t{1 + how % 8}));
  } else if (how < 240) {
    bytes.insert(at, static_cast<std::size_t>(1 + how % 8), static_cast<std::byte>(source.byte()));
  } else if (left >= 8) {
    const auto from = source.word(2) % (bytes.size() - 7);
    std::copy_n(Snapshot(bytes).begin() + static_cast<std::ptrdiff_t>(from), 8, at);
  }
}

/// Sets the right length and checksum.
void seal(Snapshot& bytes) {
  constexpr std::size_t length_at = 44;
  bytes.resize(
      (std::max)(bytes.size(), detail::WorldHeader::size + detail::WorldHeader::checksum_size));
  detail::store_word(bytes.data() + length_at, std::uint64_t{bytes.size()});
  test::seal(bytes);
}

int restored = 0, refused = 0;

void require_both() {
  require(restored > 5 && refused > 5, [] {
    return std::to_string(restored) + " of the corpus restored, " + std::to_string(refused) +
           " refused";
  });
}

[[maybe_unused]] const bool is_set = (after_corpus = require_both, true);

}  // namespace

void property(Bytes input) {
  static const std::array worlds{busy(false, false), busy(true, false), busy(false, true),
                                 busy(true, true)};
  static const std::array snapshots{bytes_of(worlds[0]), bytes_of(worlds[1]), bytes_of(worlds[2]),
                                    bytes_of(worlds[3])};
  Source source(input);
  const auto which = source.below(4);
  auto bytes = snapshots[which];
  while (!source.rest().empty() && bytes.size() > 8) change(bytes, source);
  seal(bytes);

  auto world = worlds[which];
  if (restore_all(world, bytes) != Restored::yes) {
    ++refused;
    require(bytes_of(world) == snapshots[which],
            [] { return std::string("refused, and changed the world"); });
    return;
  }
  ++restored;
  require(bytes_of(world) == bytes, [] { return std::string("restored, and has other bytes"); });
  auto fresh = level(which % 2 == 1);
  require(restore_all(fresh, bytes) == Restored::yes, [] { return std::string("only once"); });
  for (int t = 0; t < 3; ++t) {
    world.step();
    fresh.step();
    require(digest(world) == digest(fresh),
            [] { return std::string("a fresh world steps otherwise"); });
  }
}

}  // namespace detent::fuzz
