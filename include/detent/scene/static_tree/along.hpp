// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "detent/number/slab_times.hpp"
#include "detent/scene/static_tree/node.hpp"
#include "detent/scene/static_tree/prefetch.hpp"
#include "detent/scene/static_tree/stack.hpp"
#include "detent/shape/ray.hpp"

namespace detent {

namespace detail {

/// A ray prepared for the boxes of a tree.
template <Scalar S, int N>
class StaticRay {
  using Node = StaticNode<S, N>;
  using Slab = SlabTimes<S>;

 public:
  using Time = typename Slab::Time;
  using Times = std::array<Time, Node::width>;

  constexpr StaticRay(const Ray<S, N>& ray, const Aabb<S, N>& bounds) noexcept
      : StaticRay(ray, bounds, reach(ray, bounds)) {}

  /// Which children's boxes the ray may meet before `limit`, a bit for each, and at what distance
  /// at the earliest.
  [[nodiscard]] constexpr std::uint32_t meets(const Node& node, const Time& limit,
                                              Times& enter) const noexcept {
    std::array<typename Slab::OnGrid, N> planes;
    for (std::size_t i = 0; i < N; ++i) planes[i] = {slabs_[i], node.grids[i]};
    Times leave;
    for (std::size_t k = 0; k < Node::width; ++k) {
      Time in{}, out = limit;
      for (std::size_t i = 0; i < N; ++i) {
        const Time near = planes[i].enter(node.sides[near_side_[i]][k]);
        const Time far = planes[i].leave(node.sides[near_side_[i] ^ 1][k]);
        in = near > in ? near : in;
        out = far < out ? far : out;
      }
      enter[k] = in;
      leave[k] = out;
    }
    std::uint32_t met = 0;
    for (std::size_t k = 0; k < Node::width; ++k) {
      met |= enter[k] <= leave[k] ? std::uint32_t{1} << k : 0;
    }
    return met & ((std::uint32_t{1} << node.children) - 1);
  }

  /// At what distance at the earliest the ray meets a box, if it may before `limit`.
  [[nodiscard]] constexpr std::optional<Time> meets(const Aabb<S, N>& box,
                                                    const Time& limit) const noexcept {
    Time enter{}, leave = limit;
    for (std::size_t i = 0; i < N; ++i) {
      const int axis = static_cast<int>(i);
      const bool backward = near_side_[i] % 2 != 0;
      enter = std::max(enter, slabs_[i].enter(backward ? box.max[axis] : box.min[axis]));
      leave = std::min(leave, slabs_[i].leave(backward ? box.min[axis] : box.max[axis]));
    }
    return enter <= leave ? std::optional(enter) : std::nullopt;
  }

 private:
  using Reach = typename Slab::Reach;

  constexpr StaticRay(const Ray<S, N>& ray, const Aabb<S, N>& bounds, const Reach& reach) noexcept
      : slabs_(make_slabs(ray, bounds, Slab::longest(reach, ray.max_distance))) {
    for (std::size_t i = 0; i < N; ++i) {
      near_side_[i] = 2 * i + (ray.direction[static_cast<int>(i)] < 0 ? 1 : 0);
    }
  }

  [[nodiscard]] static constexpr Reach reach(const Ray<S, N>& ray,
                                             const Aabb<S, N>& bounds) noexcept {
    Reach sum{};
    for (int i = 0; i < N; ++i) {
      const auto side = Slab::reach(ray.origin[i], bounds.min[i], bounds.max[i]);
      sum = narrow_sum<bits_of<Reach>>(sum, side);  // at most 3 2^32
    }
    return sum;
  }

  [[nodiscard]] static constexpr std::array<Slab, N> make_slabs(const Ray<S, N>& ray,
                                                                const Aabb<S, N>& bounds,
                                                                const S& longest) noexcept {
    const auto slab = [&](int i) {
      return Slab(ray.origin[i], ray.direction[i], bounds.min[i], bounds.max[i], longest);
    };
    if constexpr (N == 2) {
      return {slab(0), slab(1)};
    } else {
      return {slab(0), slab(1), slab(2)};
    }
  }

  std::array<Slab, N> slabs_;
  std::array<std::size_t, N> near_side_{};
};

}  // namespace detail

/// Visits the items whose boxes `ray` may meet, about the nearest first: calls visit(part) for parts
/// of the list that the tree is over. It returns how far along the ray anything still matters, at
/// most as far as before; a negative distance ends the walk.
///
/// Every item whose box the ray meets no farther than that is visited; others may be.
template <Scalar S, int N, class Item, class Visit>
constexpr void visit_along(const StaticTree<S, N>& tree, std::span<const Item> items,
                           const Ray<S, N>& ray, const Visit& visit) noexcept {
  if (tree.nodes.empty() || ray.max_distance < 0) return;
  const detail::StaticRay<S, N> prepared(ray, tree.bounds);
  detail::StaticStack<typename SlabTimes<S>::Time> stack;
  auto limit = SlabTimes<S>::time(ray.max_distance);
  typename detail::StaticStack<typename SlabTimes<S>::Time>::Entry next{{}, 0, 0};
  while (true) {
    if (next.count != 0) {
      const S left = visit(items.subspan(next.first, next.count));
      if (left < 0) return;
      limit = SlabTimes<S>::time(left);
    } else {
      const auto& node = tree.nodes[next.first];
      typename detail::StaticRay<S, N>::Times enters;
      const std::size_t base = stack.size();
      for (auto met = prepared.meets(node, limit, enters); met != 0; met &= met - 1) {
        const auto child = static_cast<std::size_t>(std::countr_zero(met));
        const std::uint32_t at = node.first[child], size = node.count[child];
        if (size == 0) {
          detail::prefetch(&tree.nodes[at], 1);
        } else {
          detail::prefetch(&items[at], size);
        }
        stack.insert(base, {enters[child], at, size});
      }
    }
    do {
      if (stack.empty()) return;
      next = stack.pop();
    } while (next.near > limit);
  }
}

}  // namespace detent
