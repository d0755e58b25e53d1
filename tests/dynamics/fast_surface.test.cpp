// SPDX-License-Identifier: MIT
#include <algorithm>
#include <optional>
#include <span>
#include <vector>

#include "detent/dynamics/dynamics.hpp"
#include "detent/scene/height_field/height_field.hpp"
#include "detent/scene/mesh/owned.hpp"
#include "dynamics/stage.hpp"
#include "support/catch.hpp"
#include "support/random.hpp"

namespace detent::test {
namespace {

using S = q16_16;
using Ground = World<S, 3, Sphere, BodyMesh, BodyHeightField>;

constexpr int samples = 9;  // per side, one unit apart

double real(Random& random, double low, double high) {
  return low + (high - low) * static_cast<double>(random.below(1 << 20)) / (1 << 20);
}

std::vector<S> hills(Random& random) {
  std::vector<S> heights;
  for (int i = 0; i < samples * samples; ++i) heights.push_back(num<S>(real(random, 0, 2)));
  return heights;
}

/// The height of `p` above a triangle of a surface, along y; nothing if it is not above one.
std::optional<double> height_over(const std::vector<Triangle<S, 3>>& triangles,
                                  const Vec<S, 3>& p) {
  const auto d = [](const auto& x) { return static_cast<double>(x); };
  const double x = d(p.x), z = d(p.z);
  for (const auto& [a, b, c] : triangles) {
    const double bx = d(b.x - a.x), bz = d(b.z - a.z), cx = d(c.x - a.x), cz = d(c.z - a.z);
    const double whole = bx * cz - bz * cx;
    const double u = ((x - d(a.x)) * cz - (z - d(a.z)) * cx) / whole;
    const double v = (bx * (z - d(a.z)) - bz * (x - d(a.x))) / whole;
    if (u < 0 || v < 0 || u + v > 1) continue;
    return d(p.y) - (d(a.y) + u * d(b.y - a.y) + v * d(c.y - a.y));
  }
  return std::nullopt;
}

/// Shoots at a surface of hills and returns how many balls passed through it. `met` counts those
/// that were ever closer than 0.1.
template <class Body>
int passed(Ground& world, const Body& body, const std::vector<Triangle<S, 3>>& triangles,
           Random& random, bool is_fast, int& met) {
  BodyOptions<S, 3> options;
  options.motion = BodyMotion::fixed;
  REQUIRE(world.add(body, options));
  options.motion = BodyMotion::dynamic;
  options.layers = 2;
  options.collides_with = 1;
  options.is_fast = is_fast;
  options.restitution = num<S>(0.5);
  std::vector<BodyId> balls;
  for (int i = 0; i < 40; ++i) {
    options.velocity = {num<S>(real(random, -200, 200)), num<S>(real(random, -500, -100)),
                        num<S>(real(random, -200, 200))};
    const Vec<S, 3> at{num<S>(real(random, 2, 6)), num<S>(real(random, 2.1, 8)),
                       num<S>(real(random, 2, 6))};
    balls.push_back(world.add(Sphere<S, 3>{at, num<S>(0.05)}, options).value());
  }
  std::vector<char> state(balls.size(), 'f');
  for (int t = 0; t < 12; ++t) {
    world.step();
    for (std::size_t i = 0; i < balls.size(); ++i) {
      const auto height = height_over(triangles, world.position(balls[i]));
      if (!height) state[i] = state[i] == 'p' ? 'p' : 'o';  // beyond the rim it may fall
      if (height && *height < 0.1) ++met;
      if (height && *height < 0 && state[i] == 'f') state[i] = 'p';
    }
  }
  return static_cast<int>(std::count(state.begin(), state.end(), 'p'));
}

}  // namespace

TEST_CASE("fast: none of hundreds of shots passes a mesh or height field") {
  Random random(20);
  int met = 0, slow = 0;
  for (int round = 0; round < 4; ++round) {
    const auto heights = hills(random);
    const auto field = height_field<S>({S(0), S(0)}, S(1), samples, samples, heights).value();
    std::vector<Triangle<S, 3>> triangles;
    visit_within(field, field.bounds, [&](std::span<const MeshTriangle<S>> parts) {
      for (const auto& part : parts) triangles.push_back(part.triangle);
      return Walk::go_on;
    });
    const OwnedMesh<S> mesh(triangles);
    const MeshAsset<S> mesh_asset(1, mesh.view());
    const FieldAsset<S> field_asset(2, field);
    WorldSettings<S, 3> settings;
    Ground one(settings), two(settings), three(settings);
    CHECK(passed(one, BodyMesh<S, 3>{&mesh_asset, {}, {}}, triangles, random, true, met) == 0);
    CHECK(passed(two, BodyHeightField<S, 3>{&field_asset, {}}, triangles, random, true, met) == 0);
    int ignored = 0;
    slow += passed(three, BodyMesh<S, 3>{&mesh_asset, {}, {}}, triangles, random, false, ignored);
  }
  CHECK(met > 300);
  CHECK(slow > 50);  // balls without the flag do pass
}

}  // namespace detent::test
