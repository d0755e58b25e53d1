// SPDX-License-Identifier: MIT
//
// A moving shape finds in a scene of any history what a loop over its objects finds: the same
// objects at the same distances, in the same order, under every filter, and the same first hit.

#include <algorithm>
#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "decode.hpp"
#include "detent/scene/scene.hpp"
#include "spaces.hpp"

namespace detent::fuzz {
namespace {

void require_same(bool same, const char* query) {
  require(same, [&] { return std::string(query) + " is not that of the objects"; });
}

template <Scalar S, int N>
using World = Scene<S, N, Sphere, Aabb, Triangle, Plane>;

/// Adds, removes and changes objects without rebuilding the trees.
template <Scalar S, int N>
void populate(World<S, N>& world, Source& source, Decoder<S, N>& decoder) {
  std::vector<ObjectId> ids;
  for (auto steps = source.below(24); steps > 0; --steps) {
    const auto kind = source.below(8);
    if (kind == 7) {
      world.optimize();
      continue;
    }
    if (kind == 6 && !ids.empty()) {
      world.remove(ids[source.below(ids.size())]);
      continue;
    }
    const Traits traits{.layers = 1u << source.below(3),
                        .motion = source.below(4) == 0 ? Motion::fixed : Motion::moving};
    with_one_of<Sphere<S, N>, Aabb<S, N>, Triangle<S, N>, Plane<S, N>>(
        source, [&]<class Shape>(std::type_identity<Shape>) {
          const auto shape = decoder.template shape<Shape>();
          if (kind == 5 && !ids.empty() && world.replace(ids[source.below(ids.size())], shape)) {
            return;
          }
          if (const auto id = world.add(shape, traits)) ids.push_back(*id);
        });
  }
}

template <class Moving, Scalar S, int N>
void check(const World<S, N>& world, const Cast<Moving>& way, std::uint32_t layers) {
  using Hit = ObjectHit<S, N>;
  const InLayers filter{layers};
  std::vector<Hit> expected;
  world.for_each([&](const ObjectInfo& object, const auto& target) {
    if (!filter(object)) return;
    const auto hit = cast(way.shape, way.direction, way.max_distance, target);
    if (hit) expected.push_back({hit->distance, object.id, hit->point, hit->normal, {}});
  });
  std::sort(expected.begin(), expected.end());
  const bool is_hit = !expected.empty();
  const auto first = is_hit ? std::optional(expected.front()) : std::nullopt;
  require_same(world.any(way, filter) == is_hit, "any");
  require_same(world.nearest_hit(way, filter) == first, "nearest_hit");
  const auto nearest = world.nearest(way, filter);
  require_same(nearest.has_value() == is_hit, "nearest");
  require_same(!nearest || (nearest->distance == first->distance && nearest->id == first->id),
               "nearest");
  require_same(world.all_hits(way, filter) == expected, "all_hits");
  std::array<Found<S>, 2> room;
  const auto count = world.all(way, std::span(room), filter);
  require_same(count == expected.size(), "all");
  for (std::size_t i = 0; i < room.size() && i < count; ++i) {
    require_same(room[i].distance == expected[i].distance && room[i].id == expected[i].id, "all");
  }
}

}  // namespace

void property(Bytes input) {
  Source source(input);
  in_a_space(source, [&]<Scalar S, int N>(Space<S, N>) {
    with_one_of<Sphere<S, N>, Aabb<S, N>>(source, [&]<class Moving>(std::type_identity<Moving>) {
      Decoder<S, N> decoder(source);
      World<S, N> world;
      populate(world, source, decoder);
      const auto layers = static_cast<std::uint32_t>(source.below(8));
      Cast way{decoder.template shape<Moving>(), decoder.direction(), decoder.number()};
      check(world, way, layers);
      // Up to the first of them, and slightly less.
      const auto nearest = world.nearest(way);
      if (!nearest) return;
      way.max_distance = nearest->distance;
      check(world, way, ~0u);
      if (nearest->distance <= 0) return;
      way.max_distance = nearest_to<S>(nearest->distance - next_up(S(0)));
      require_same(!world.any(way), "any");
    });
  });
}

}  // namespace detent::fuzz
