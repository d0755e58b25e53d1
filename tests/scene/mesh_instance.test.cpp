// SPDX-License-Identifier: MIT
#include "detent/scene/mesh/instance.hpp"

#include <deque>
#include <variant>
#include <vector>

#include "detent/scene/mesh/owned.hpp"
#include "scene/placed_histories.hpp"

namespace detent::test {
namespace {

using S = q16_16;
using Placed = PlacedMesh<S>;

/// Meshes of few triangles, and their triangles in the order drawn.
struct Meshes {
  using World = Scene<S, 3, Sphere, Plane, MeshInstance>;
  using Local = std::variant<Sphere<S, 3>, Plane<S, 3>, Placed>;
  using Shown = std::variant<Sphere<S, 3>, Plane<S, 3>, TriangleLoop<S>>;

  std::deque<std::vector<Triangle<S, 3>>> lists;
  std::deque<OwnedMesh<S>> owned;
  std::vector<MeshAsset<S>> assets;

  explicit Meshes(Historian<S, 3>& history) {
    for (std::uint32_t id = 0; id < 4; ++id) {
      lists.emplace_back(history.random().below(14));
      for (auto& triangle : lists.back()) triangle = history.draw<Triangle<S, 3>>();
      owned.emplace_back(std::span<const Triangle<S, 3>>(lists.back()));
      assets.emplace_back(id, owned.back().view());
    }
  }

  Local draw(Historian<S, 3>& history) const {
    auto& random = history.random();
    switch (random.below(12)) {
      case 0:
        return history.draw<Plane<S, 3>>();
      case 1:
      case 2:
      case 3:
        return history.draw<Sphere<S, 3>>();
      default:
        if (random.one_in(20)) return Placed();
        return Placed{&assets[random.below(assets.size())], draw_transform(history)};
    }
  }
  template <class Shape>
  Shown shown(const Shape& shape) const {
    if constexpr (std::is_same_v<Shape, Placed>) {
      return loop_of(shape, lists);
    } else {
      return shape;
    }
  }
  const auto& list_of(const Placed&) const { return assets; }
  Restored restore(World& scene, std::span<const std::byte> bytes) const {
    return detent::restore(scene, bytes, assets);
  }
};

}  // namespace

TEST_CASE("mesh instance: results equal those of a list of placed triangles, after any history") {
  check_balance([](HitRate& rate) { live<Meshes>(3, 16, 60, 6, rate); });
}

TEST_CASE("mesh instance: long histories", "[.demand]") {
  check_balance([](HitRate& rate) {
    for (const auto seed : oracle::demanded_seeds()) live<Meshes>(seed, 24, 200, 12, rate);
  });
}

}  // namespace detent::test
