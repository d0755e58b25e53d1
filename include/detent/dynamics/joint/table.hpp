// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "detent/dynamics/joint/group.hpp"

namespace detent::detail {

/// The joints of a world, by index, and those that broke in the last step.
template <class Group>
struct JointTable {
  typename Group::List list{};
  std::uint32_t next = 1, first_free = 0;
  std::size_t size = 0;
  typename Group::Broken broken{};

  [[nodiscard]] constexpr const typename Group::Record* find(const JointId& id) const noexcept {
    if (id.generation == 0 || id.index >= list.size()) return nullptr;
    return list[id.index].generation == id.generation ? &list[id.index] : nullptr;
  }
  /// The id of the next joint.
  [[nodiscard]] constexpr JointId vacant() noexcept {
    while (first_free < list.size() && list[first_free].generation != 0) ++first_free;
    return {first_free, next};
  }
  template <class Joint>
  constexpr bool put(const JointId& id, const Joint& joint) {
    if (id.generation == 0 || id.generation > 0xfffffffeu || id.index >= Group::room) return false;
    if (id.index < list.size() && list[id.index].generation != 0) return false;
    if (id.index >= list.size()) list.resize(id.index + std::size_t{1});
    list[id.index] = {};
    list[id.index].generation = id.generation;
    list[id.index].joint = decltype(list[id.index].joint)(joint);
    next = (std::max)(next, id.generation + 1);
    ++size;
    return true;
  }
  constexpr void clear() noexcept {
    list.clear();
    next = 1;
    first_free = 0;
    size = 0;
    broken.clear();
  }
  /// Removes an existing joint and returns its bodies.
  constexpr BodyPair take(std::uint32_t index) {
    const auto pair = list[index].bodies();
    list[index] = {};
    first_free = (std::min)(first_free, index);
    --size;
    return pair;
  }
  /// Calls f(pair) with the bodies of each joint of a body.
  template <class F>
  constexpr void for_each_of(std::uint32_t body, const F& f) const {
    for (std::size_t i = 0; i < list.size(); ++i) {
      if (list[i].generation == 0) continue;
      const auto pair = list[i].bodies();
      if (body == pair.a || body == pair.b) f(pair);
    }
  }
  /// Removes the joints of a body; calls f(pair) with the bodies of each.
  template <class F>
  constexpr void take_all_of(std::uint32_t body, const F& f) {
    for (std::size_t i = 0; i < list.size(); ++i) {
      if (list[i].generation == 0) continue;
      const auto pair = list[i].bodies();
      if (pair.a == body || pair.b == body) f(take(static_cast<std::uint32_t>(i)));
    }
  }
  /// Removes the joints that broke in the last run of `tick`.
  template <class Tick, class F>
  constexpr void take_broken(const Tick& tick, const F& f) {
    broken.clear();
    tick.for_each_broken([&](std::uint32_t index) {
      broken.push_back({index, list[index].generation});
      f(take(index));
    });
  }
};

/// The table of a world without joint types.
template <class Storage, Scalar S, int N>
struct JointTable<JointGroup<Storage, S, N>> {
  typename JointGroup<Storage, S, N>::List list{};
  static constexpr std::uint32_t next = 1;

  static constexpr void clear() noexcept {}
  template <class F>
  static constexpr void take_all_of(std::uint32_t, const F&) noexcept {}
  template <class Tick, class F>
  static constexpr void take_broken(const Tick&, const F&) noexcept {}
};

}  // namespace detent::detail
