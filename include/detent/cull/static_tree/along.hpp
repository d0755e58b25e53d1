// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <type_traits>
#include <utility>

#include "detent/cull/lanes.hpp"
#include "detent/cull/prefetch.hpp"
#include "detent/cull/slabs.hpp"
#include "detent/cull/static_tree/node.hpp"
#include "detent/cull/static_tree/stack.hpp"
#include "detent/shape/ray.hpp"

namespace detent {

namespace detail {

/// A ray prepared for tests against the boxes of a tree.
template <Scalar S, int N>
class StaticRay {
  using Node = StaticNode<S, N>;
  using Slab = SlabTimes<S>;

 public:
  using Time = typename Slab::Time;
  using Times = std::array<Time, Node::width>;

  constexpr StaticRay(const Ray<S, N>& ray, const Aabb<S, N>& bounds) noexcept
      : StaticRay(ray, bounds, typename Slab::Clock(reach(ray, bounds), ray.max_distance)) {}

  /// A distance along the ray in units of `Time`, clamped where it no longer matters.
  [[nodiscard]] constexpr Time time(const S& distance) const noexcept {
    return clock_.time(distance);
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

  /// A lower bound on the distance at which the ray enters a box, if it may before `limit`.
  [[nodiscard]] constexpr std::optional<Time> meets(const Aabb<S, N>& box,
                                                    const Time& limit) const noexcept {
    Time enter{}, leave = limit;
    for (std::size_t i = 0; i < N; ++i) {
      const int axis = static_cast<int>(i);
      const bool backward = near_side_[i] % 2 != 0;
      enter = (std::max)(enter, slabs_[i].enter(backward ? box.max[axis] : box.min[axis]));
      leave = (std::min)(leave, slabs_[i].leave(backward ? box.min[axis] : box.max[axis]));
    }
    return enter <= leave ? std::optional(enter) : std::nullopt;
  }

 private:
  using Clock = typename Slab::Clock;
  using Reach = typename Clock::Reach;

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

  constexpr StaticRay(const Ray<S, N>& ray, const Aabb<S, N>& bounds, const Clock& clock) noexcept
      : clock_(clock), slabs_(make_slabs(ray, bounds, clock)) {
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

  [[nodiscard]] static constexpr std::array<Slab, std::size_t{N}> make_slabs(
      const Ray<S, N>& ray, const Aabb<S, N>& bounds, const Clock& clock) noexcept {
    const auto slab = [&](int i) {
      return Slab(clock, ray.origin[i], ray.direction[i], bounds.min[i], bounds.max[i]);
    };
    if constexpr (N == 2) {
      return {slab(0), slab(1)};
    } else {
      return {slab(0), slab(1), slab(2)};
    }
  }

  Clock clock_;
  std::array<Slab, std::size_t{N}> slabs_;
  std::array<std::size_t, std::size_t{N}> near_side_{};
};

}  // namespace detail

/// Visits the items whose boxes `ray` may touch, roughly nearest first: calls visit(part) for parts
/// of the tree's list of items. visit returns the distance along the ray up to which anything still
/// matters, never more than before; a negative distance stops the traversal.
///
/// Every item whose box the ray touches within that distance is visited; others may be.
template <Scalar S, int N, class Item, class Visit>
constexpr void visit_along(const StaticTree<S, N>& tree, std::span<const Item> items,
                           const Ray<S, N>& ray, const Visit& visit) noexcept {
  if (tree.nodes.empty() || ray.max_distance < 0) return;
  const detail::StaticRay<S, N> prepared(ray, tree.bounds);
  using Stack = detail::StaticStack<typename SlabTimes<S>::Time>;
  Stack stack;
  typename Stack::Entry next{{}, 0, 0};
  auto limit = prepared.time(ray.max_distance);
  const auto prefetch = [&](const auto& entry) {  // for items, too, as many bytes as a node has
    const void* at =
        entry.count == 0 ? static_cast<const void*>(&tree.nodes[entry.first]) : &items[entry.first];
    detail::prefetch(at, sizeof(StaticNode<S, N>));
  };
  while (true) {
    if (next.count != 0) {
      const S left = visit(items.subspan(next.first, next.count));
      if (left < 0) return;
      limit = prepared.time(left);
    } else {
      const auto& node = tree.nodes[next.first];
      typename detail::StaticRay<S, N>::Times enters;
      auto met = prepared.meets(node, limit, enters);
      const auto take = [&]() -> typename Stack::Entry {
        const auto child = static_cast<std::size_t>(std::countr_zero(met));
        met &= met - 1;
        return {enters[child], node.first[child], node.count[child]};
      };
      if (met != 0) {  // the nearest child is next; the others wait
        next = take();
        const std::size_t base = stack.size();
        while (met != 0) {
          auto other = take();
          if (other.key < next.key) std::swap(next, other);
          prefetch(other);
          stack.insert(base, other);
        }
        prefetch(next);
        continue;
      }
    }
    do {
      if (stack.empty()) return;
      next = stack.pop();
    } while (next.key > limit);
  }
}

}  // namespace detent
