// SPDX-License-Identifier: MIT
#pragma once

// Catch2 3 split its single header; everything else that tests use kept its name.
#if __has_include(<catch2/catch_all.hpp>)
#include <catch2/catch_all.hpp>
#else
#include <catch2/catch.hpp>
#endif

#include <ostream>

#include "support/random.hpp"

namespace detent::test {

/// `INFO(random)` adds the seed to every failure message of the scope.
inline std::ostream& operator<<(std::ostream& out, const Random& random) {
  return out << "seed " << random.seed();
}

/// Counts how often a random test saw each result, so that it cannot pass on one-sided inputs.
/// Write `CHECK(rate.is_balanced())` at the end of the sweep.
class HitRate {
 public:
  void count(bool hit) {
    hits_ += hit ? 1 : 0;
    ++total_;
  }

  [[nodiscard]] int percent() const {
    return total_ == 0 ? 0 : static_cast<int>(100 * hits_ / total_);
  }
  [[nodiscard]] bool is_balanced() const { return percent() >= 30 && percent() <= 70; }

  friend std::ostream& operator<<(std::ostream& out, const HitRate& rate) {
    return out << rate.hits_ << " hits in " << rate.total_;
  }

 private:
  long long hits_ = 0;
  long long total_ = 0;
};

}  // namespace detent::test
