// SPDX-License-Identifier: MIT
#include "detent/cull/tree/grouping.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "support/catch.hpp"
#include "support/random.hpp"

namespace detent::test {
namespace {

/// A box of the grid with sides of this many bits; sometimes unbounded on an axis.
template <int N>
detail::QuantizedBox<q16_16, N> draw_box(Random& random, int bits) {
  detail::QuantizedBox<q16_16, N> box;
  for (std::size_t axis = 0; axis < std::size_t{N}; ++axis) {
    const auto a = static_cast<std::int32_t>(random.wide(bits));
    const auto b = static_cast<std::int32_t>(random.wide(bits));
    box.low[axis] = random.one_in(16) ? -(1 << 30) : std::min(a, b);
    box.high[axis] = random.one_in(16) ? 1 << 30 : std::max(a, b);
  }
  return box;
}

TEMPLATE_TEST_CASE_SIG("grouping: a box goes where the area grows least", "", ((int N), N), 2, 3) {
  Random random(0x60e5);
  for (int i = 0; i < 5'000; ++i) {
    detail::TreeNode<q16_16, N> node;
    const int bits = std::array{3, 12, 30}[static_cast<std::size_t>(i % 3)];
    const auto box = draw_box<N>(random, bits);
    node.count = static_cast<std::uint16_t>(1 + random.below(8));
    std::size_t best = 0;
    std::uint64_t best_growth = 0, best_area = 0;
    for (std::size_t k = 0; k < node.count; ++k) {
      node.set(k, draw_box<N>(random, bits));
      const auto area = detail::half_area(node.box(k));
      const auto growth = detail::half_area(detail::hull_of(node.box(k), box)) - area;
      if (k == 0 || std::pair(growth, area) < std::pair(best_growth, best_area)) {
        best = k;
        best_growth = growth;
        best_area = area;
      }
    }
    REQUIRE(detail::best_place(node, box) == best);
  }
}

TEST_CASE("grouping: a list is partitioned at any position") {
  using Part = detail::CenteredPlace<q16_16, 3>;
  Random random(0x9a27);
  for (int i = 0; i < 3'000; ++i) {
    const auto count = static_cast<std::size_t>(1 + random.below(i % 10 == 0 ? 700 : 20));
    // Few different numbers, all different ones, and sorted ones.
    const int bits = std::array{1, 4, 31}[static_cast<std::size_t>(i % 3)];
    std::vector<Part> parts;
    for (std::uint32_t k = 0; k < count; ++k) {
      parts.push_back({{0, static_cast<std::int32_t>(random.wide(bits)), 0}, k});
    }
    const auto key = [](const Part& part) { return part.at[1]; };
    const auto is_less = [&](const Part& a, const Part& b) { return key(a) < key(b); };
    if (random.one_in(4)) std::sort(parts.begin(), parts.end(), is_less);
    if (random.one_in(8)) std::reverse(parts.begin(), parts.end());
    auto sorted = parts;
    std::stable_sort(sorted.begin(), sorted.end(), is_less);
    const auto place = static_cast<std::size_t>(random.below(count));
    auto parted = parts;
    detail::part_at(parted.data(), count, place, 1);
    REQUIRE(key(parted[place]) == key(sorted[place]));
    for (std::size_t k = 0; k < count; ++k) {
      const bool is_on_its_side =
          k < place ? key(parted[k]) <= key(parted[place]) : key(parted[k]) >= key(parted[place]);
      REQUIRE(is_on_its_side);
    }
    const auto by_place = [](const Part& a, const Part& b) { return a.place < b.place; };
    std::sort(parts.begin(), parts.end(), by_place);
    std::sort(parted.begin(), parted.end(), by_place);
    for (std::size_t k = 0; k < count; ++k) {
      REQUIRE(parted[k].place == k);
      REQUIRE(key(parted[k]) == key(parts[k]));
    }
  }
}

TEMPLATE_TEST_CASE("grouping: entries are cut where both sides have the least area", "", q16_16,
                   float) {
  using S = TestType;
  using Entry = detail::TreeEntry<S, 3>;
  using Coordinate = typename detail::Grid<S>::Coordinate;
  constexpr std::size_t count = 9, least = 3;
  Random random(0xc07);
  for (int i = 0; i < 2'000; ++i) {
    std::array<Entry, count> entries;
    for (std::uint32_t k = 0; k < count; ++k) {
      const auto box = draw_box<3>(random, i % 2 == 0 ? 3 : 20);
      for (std::size_t axis = 0; axis < 3; ++axis) {
        entries[k].box.low[axis] = static_cast<Coordinate>(box.low[axis]);
        entries[k].box.high[axis] = static_cast<Coordinate>(box.high[axis]);
      }
      entries[k].child = k;
    }
    const auto area_of = [](const auto& list, std::size_t first, std::size_t last) {
      auto box = list[first].box;
      for (std::size_t k = first + 1; k < last; ++k) box = detail::hull_of(box, list[k].box);
      return detail::half_area(box);
    };
    std::array<Entry, count> best{};
    std::size_t best_cut = 0;
    typename detail::Grid<S>::Area best_cost{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      auto sorted = entries;
      std::stable_sort(sorted.begin(), sorted.end(), detail::by_center(axis));
      for (std::size_t cut = least; cut <= count - least; ++cut) {
        const auto cost = area_of(sorted, 0, cut) + area_of(sorted, cut, count);
        if (best_cut != 0 && !(cost < best_cost)) continue;
        best = sorted;
        best_cut = cut;
        best_cost = cost;
      }
    }
    auto cut = entries;
    REQUIRE(detail::cut_in_two(cut, least) == best_cut);
    for (std::size_t k = 0; k < count; ++k) REQUIRE(cut[k].child == best[k].child);
  }
}

}  // namespace
}  // namespace detent::test
