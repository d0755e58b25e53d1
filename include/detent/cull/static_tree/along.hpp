// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <type_traits>

#include "detent/cull/lanes.hpp"
#include "detent/cull/prefetch.hpp"
#include "detent/cull/quantized_box.hpp"
#include "detent/cull/slabs.hpp"
#include "detent/cull/static_tree/parts.hpp"
#include "detent/cull/walk.hpp"
#include "detent/shape/ray.hpp"

namespace detent {

namespace detail {

/// A ray, or a moving box, prepared for tests against the boxes of a tree.
template <Scalar S, int N>
class StaticRay {
  using Node = StaticNode<S, N>;

 public:
  using Time = typename Ticks<S>::Time;
  using Times = std::array<Time, Node::width>;

  constexpr StaticRay(const Ray<S, N>& ray, const Aabb<S, N>& bounds) noexcept
      : StaticRay(ray, Ticks<S>(reach(ray, bounds), ray.max_distance)) {}
  /// For the moving contents of `box`, which is not empty.
  constexpr StaticRay(const QuantizedBox<S, N>& box, const Direction<S, N>& direction,
                      const S& max_distance, const Aabb<S, N>& bounds) noexcept
      : ticks_(reach(box, bounds), max_distance) {
    for (std::size_t i = 0; i < N; ++i) {
      slabs_[i] = RaySlab<S>(Grid<S>::plane(box.low[i]), Grid<S>::plane(box.high[i]),
                             direction[static_cast<int>(i)], ticks_);
    }
  }

  /// A distance along the ray in ticks, clamped to the range that matters.
  [[nodiscard]] constexpr Time time(const S& distance) const noexcept {
    return ticks_.time(distance);
  }

  /// Which children's boxes the ray may enter before `limit`, a bit for each, and lower bounds on
  /// the distances at which it does.
  [[nodiscard]] constexpr std::uint32_t meets(const Node& node, Time limit,
                                              Times& enter) const noexcept {
    const std::uint32_t children = (std::uint32_t{1} << node.children) - 1;
    if (std::is_constant_evaluated()) {
      return meets<ArrayLanes<Time>>(node, limit, enter) & children;
    }
    return meets<Lanes<Time>>(node, limit, enter) & children;
  }

  /// The same with one type of lanes, for all eight children.
  template <class Lanes>
  [[nodiscard]] constexpr std::uint32_t meets(const Node& node, Time limit,
                                              Times& enter) const noexcept {
    Lanes in(Time{}), out(limit);
    for (std::size_t i = 0; i < N; ++i) {
      const auto planes = slabs_[i].on_grid(node.grids[i]);
      in.raise(planes.template enter<Lanes>(node.sides[near_side_[i]]));
      out.lower(planes.template leave<Lanes>(node.sides[near_side_[i] ^ 1]));
    }
    in.store(enter);
    return in.up_to(out);
  }

  /// A lower bound on the distance at which the ray enters a box, if it may before `limit`.
  [[nodiscard]] constexpr std::optional<Time> meets(const Aabb<S, N>& box,
                                                    const Time& limit) const noexcept {
    typename RaySlab<S>::Time enter{}, leave = limit;
    for (std::size_t i = 0; i < N; ++i) {
      const int axis = static_cast<int>(i);
      const auto& slab = slabs_[i];
      enter = (std::max)(enter, slab.enter(slab.is_backward() ? box.max[axis] : box.min[axis]));
      leave = (std::min)(leave, slab.leave(slab.is_backward() ? box.min[axis] : box.max[axis]));
    }
    return enter <= leave ? std::optional(static_cast<Time>(enter)) : std::nullopt;
  }

 private:
  using Reach = typename Ticks<S>::Reach;

  constexpr StaticRay(const Ray<S, N>& ray, const Ticks<S>& ticks) noexcept
      : ticks_(ticks), slabs_(make_slabs(ray, ticks)) {
    for (std::size_t i = 0; i < N; ++i) near_side_[i] = 2 * i + (slabs_[i].is_backward() ? 1 : 0);
  }

  [[nodiscard]] static constexpr Reach reach(const Ray<S, N>& ray,
                                             const Aabb<S, N>& bounds) noexcept {
    Reach sum{};
    for (int i = 0; i < N; ++i) {
      const Reach least(abs(bounds.min[i] - ray.origin[i]));
      const Reach greatest(abs(bounds.max[i] - ray.origin[i]));
      sum = narrow_sum<bits_of<Reach>>(sum, (std::max)(least, greatest));  // at most 3 2^32
    }
    return sum;
  }

  /// At most 3 2^33.
  [[nodiscard]] static constexpr Reach reach(const QuantizedBox<S, N>& box,
                                             const Aabb<S, N>& bounds) noexcept {
    const auto side = [](const auto& x) {
      if constexpr (is_fixed<S>) {
        return Reach::from_raw(Grid<S>::plane(x));
      } else {
        return Reach(x);
      }
    };
    Reach sum{};
    for (int i = 0; i < N; ++i) {
      const auto axis = static_cast<std::size_t>(i);
      const auto ahead = abs(bounds.max[i] - side(box.low[axis]));
      const auto behind = abs(side(box.high[axis]) - bounds.min[i]);
      sum = narrow_sum<bits_of<Reach>>(sum, narrow<bits_of<Reach>>((std::max)(ahead, behind)));
    }
    return sum;
  }

  [[nodiscard]] static constexpr std::array<RaySlab<S>, std::size_t{N}> make_slabs(
      const Ray<S, N>& ray, const Ticks<S>& ticks) noexcept {
    const auto slab = [&](int i) { return RaySlab<S>(ray.origin[i], ray.direction[i], ticks); };
    if constexpr (N == 2) {
      return {slab(0), slab(1)};
    } else {
      return {slab(0), slab(1), slab(2)};
    }
  }

  Ticks<S> ticks_;
  std::array<RaySlab<S>, std::size_t{N}> slabs_;
  std::array<std::size_t, std::size_t{N}> near_side_{};
};

/// A static tree as traversed by a ray.
template <Scalar S, int N, class Item>
struct TreeAlong : StaticParts<typename Ticks<S>::Time, S, N> {
  using Base = StaticParts<typename Ticks<S>::Time, S, N>;
  using Key = typename Base::Key;
  using Node = StaticNode<S, N>;

  std::span<const Item> items;
  const StaticRay<S, N>& ray;
  Key last;

  [[nodiscard]] constexpr std::uint32_t meets(const Node& node,
                                              std::array<Key, Node::width>& keys) const noexcept {
    return ray.meets(node, last, keys);
  }
  [[nodiscard]] constexpr StaticPart child(const Node& node, std::size_t k) const noexcept {
    const auto part = Base::child(node, k);
    const void* at = part.is_leaf() ? static_cast<const void*>(&items[part.first])
                                    : &this->tree.nodes[part.first];
    prefetch(at, sizeof(Node));  // the size of a node, also for items
    return part;
  }
  [[nodiscard]] constexpr bool reaches(const Key& enter) const noexcept { return enter <= last; }
};

}  // namespace detail

/// Visits the items whose boxes `ray` may touch, roughly nearest first: calls visit(part, limit) for
/// parts of the tree's list of items. `limit` is a distance along the ray.
template <Scalar S, int N, class Item, class Visit>
constexpr Walk visit_along(const StaticTree<S, N>& tree, std::span<const Item> items,
                           const Ray<S, N>& ray, const Visit& visit) noexcept {
  if (tree.nodes.empty() || ray.max_distance < 0) return Walk::go_on;
  const detail::StaticRay<S, N> prepared(ray, tree.bounds);
  S limit = ray.max_distance;
  detail::TreeAlong<S, N, Item> along{{tree}, items, prepared, prepared.time(limit)};
  return detail::visit_nearest_first(
      detail::whole_tree, along, [&](const detail::StaticPart& leaf) {
        const Walk walk = visit(items.subspan(leaf.first, leaf.count), limit);
        along.last = prepared.time(limit);
        return walk;
      });
}

}  // namespace detent
