// SPDX-License-Identifier: MIT
//
// The sweeps that prove the claims of root.hpp: every Q16.16 root, and 64-bit roots at both ends of
// every interval on which they are constant. Half a minute on two cores.

#include <cstdint>

#include "detent/number/rounding.hpp"
#include "number/sweep.hpp"
#include "support/catch.hpp"

using namespace detent;
using namespace detent::test;

namespace {

struct Faults {
  std::uint64_t checked = 0;
  std::uint64_t wrong = 0;
  std::uint64_t example = 0;  // one of the wrong ones

  void count(std::uint64_t n, bool right) {
    ++checked;
    if (right) return;
    ++wrong;
    example = n;
  }

  Faults& operator+=(const Faults& other) {
    checked += other.checked;
    wrong += other.wrong;
    if (other.wrong != 0) example = other.example;
    return *this;
  }
};

}  // namespace

TEST_CASE("root: every Q16.16 root is the exact one rounded down", "[number][.demand]") {
  const auto faults = sweep_all<Faults>(
      "Q16.16 roots", std::uint64_t{1} << 31, [](Faults& state, std::uint64_t raw) {
        const q16_16 x = q16_16::from_raw(static_cast<std::int32_t>(raw));
        const auto root = static_cast<std::uint64_t>(sqrt_floor<q16_16>(x).raw());
        // sqrt(raw / 2^16) * 2^16 = sqrt(raw * 2^16)
        const std::uint64_t square = raw << 16;
        state.count(raw, root * root <= square && square < (root + 1) * (root + 1));
      });
  INFO("for example raw " << faults.example);
  CHECK(faults.wrong == 0);
  CHECK(faults.checked == std::uint64_t{1} << 31);
}

TEST_CASE("root: 64-bit roots change at every square and nowhere else", "[number][.demand]") {
  const auto faults = sweep_all<Faults>(
      "64-bit roots", std::uint64_t{1} << 32, [](Faults& state, std::uint64_t root) {
        const std::uint64_t square = root * root;
        state.count(square, square_root_floor(square) == root);
        state.count(square + root, square_root_floor(square + root) == root);
        state.count(square + 2 * root, square_root_floor(square + 2 * root) == root);
      });
  INFO("for example " << faults.example);
  CHECK(faults.wrong == 0);
  CHECK(faults.checked == 3 * (std::uint64_t{1} << 32));
}
