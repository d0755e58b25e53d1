// SPDX-License-Identifier: MIT
#include "detent/cull/walk.hpp"

#include <algorithm>
#include <vector>

#include "support/catch.hpp"
#include "support/random.hpp"

namespace detent::test {
namespace {

/// A tree of three levels with up to four children per node, whose leaves are numbers. A subtree's
/// distance is its least number.
struct Numbers {
  struct Part {
    int level, index;
    [[nodiscard]] constexpr bool is_leaf() const noexcept { return level == 0; }
  };
  using Key = int;
  static constexpr std::size_t most_children = 4, room = 3 * 3;
  static constexpr int leaves = 64;

  std::array<int, leaves> numbers{};
  int limit = 1'000;
  mutable int opened = 0;

  [[nodiscard]] int key(const Part& part) const {
    const int size = 1 << (2 * part.level);
    const auto first = numbers.begin() + part.index * size;
    return *std::min_element(first, first + size);
  }
  [[nodiscard]] Part node(const Part& part) const {
    ++opened;
    return part;
  }
  [[nodiscard]] std::uint32_t meets(const Part& part, std::array<Key, 4>& keys) const {
    std::uint32_t met = 0;
    for (std::size_t k = 0; k < 4; ++k) {
      keys[k] = key(child(part, k));
      if (reaches(keys[k])) met |= std::uint32_t{1} << k;
    }
    return met;
  }
  [[nodiscard]] Part child(const Part& part, std::size_t k) const {
    return {part.level - 1, 4 * part.index + static_cast<int>(k)};
  }
  [[nodiscard]] bool reaches(const Key& key) const { return key <= limit; }
};

Numbers drawn(Random& random) {
  Numbers tree;
  for (auto& x : tree.numbers) x = static_cast<int>(random.below(200));
  return tree;
}

TEST_CASE("walk: visits the nearest child next, and a shorter limit skips others", "[walk]") {
  Random random(0x3a1c);
  int pruned = 0;
  for (int i = 0; i < 500; ++i) {
    Numbers tree = drawn(random);
    std::vector<int> seen;
    const Walk walk = detail::visit_nearest_first({3, 0}, tree, [&](const Numbers::Part& leaf) {
      seen.push_back(tree.numbers[static_cast<std::size_t>(leaf.index)]);
      tree.limit = std::min(tree.limit, seen.back());
      return Walk::go_on;
    });
    REQUIRE(walk == Walk::go_on);
    // Nearest first by exact keys: the first leaf is the least, and later ones equal it.
    const int least = *std::min_element(tree.numbers.begin(), tree.numbers.end());
    REQUIRE(seen.size() ==
            static_cast<std::size_t>(std::count(tree.numbers.begin(), tree.numbers.end(), least)));
    REQUIRE(std::count(seen.begin(), seen.end(), least) == static_cast<int>(seen.size()));
    pruned += tree.opened < 1 + 4 + 16;
  }
  CHECK(pruned == 500);
}

TEST_CASE("walk: visits every leaf once, siblings in order, until stopped", "[walk]") {
  Random random(0x3a1d);
  for (int i = 0; i < 200; ++i) {
    const Numbers tree = drawn(random);
    std::vector<int> seen;
    const auto stop_after = static_cast<std::size_t>(random.below(80));
    const Walk walk = detail::visit_nearest_first({3, 0}, tree, [&](const Numbers::Part& leaf) {
      seen.push_back(leaf.index);
      return stop_if(seen.size() > stop_after);
    });
    const std::size_t count = std::min<std::size_t>(stop_after + 1, Numbers::leaves);
    REQUIRE(walk == stop_if(stop_after < Numbers::leaves));
    REQUIRE(seen.size() == count);
    for (std::size_t k = 1; k < count; ++k) {
      if (seen[k] / 4 != seen[k - 1] / 4) continue;
      const auto at = [&](std::size_t j) {
        return tree.numbers[static_cast<std::size_t>(seen[j])];
      };
      REQUIRE(at(k - 1) <= at(k));
    }
    std::sort(seen.begin(), seen.end());
    REQUIRE(std::adjacent_find(seen.begin(), seen.end()) == seen.end());
  }
}

}  // namespace
}  // namespace detent::test
