// SPDX-License-Identifier: MIT
#include "workers.hpp"

#include <atomic>
#include <stdexcept>
#include <vector>

#include "support/catch.hpp"

using detent::cli::for_each_index;

TEST_CASE("workers: every index is processed once, with any number of threads") {
  for (const int threads : {0, 1, 3, 50}) {
    std::vector<int> seen(1000, 0);
    for_each_index({threads, ""}, 1000, [&](int i) { ++seen[static_cast<std::size_t>(i)]; });
    CHECK(seen == std::vector<int>(1000, 1));
  }
}

TEST_CASE("workers: an exception reaches the caller and stops the other workers") {
  for (const int threads : {1, 4}) {
    std::atomic<int> done{0};
    const auto work = [&](int i) {
      if (i == 10) throw std::runtime_error("ten");
      ++done;
    };
    CHECK_THROWS_WITH(for_each_index({threads, ""}, 100'000'000, work), "ten");
    CHECK(done < 100'000'000 - 1);
  }
}
