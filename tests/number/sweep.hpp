// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <cstdio>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

namespace detent::test {

/// Calls sweep(state, i) for every i in [0, count), on all cores, each with its own State; returns
/// their sum. Prints progress to stderr.
template <class State, class Sweep>
State sweep_all(const std::string& what, std::uint64_t count, const Sweep& sweep) {
  constexpr std::uint64_t chunk = 1u << 20;
  std::atomic<std::uint64_t> next{0};
  std::mutex mutex;
  State total{};
  const auto work = [&] {
    State state{};
    while (true) {
      const std::uint64_t first = next.fetch_add(chunk);
      if (first >= count) break;
      for (std::uint64_t i = first; i < std::min(first + chunk, count); ++i) sweep(state, i);
      const std::lock_guard lock(mutex);
      if (100 * first / count == 100 * (first + chunk) / count) continue;
      std::fprintf(stderr, "\r%s: %3llu %%", what.c_str(),
                   static_cast<unsigned long long>(100 * (first + chunk) / count));
    }
    const std::lock_guard lock(mutex);
    total += state;
  };
  std::vector<std::thread> threads;
  for (unsigned i = 0; i < std::max(1u, std::thread::hardware_concurrency()); ++i) {
    threads.emplace_back(work);
  }
  for (auto& thread : threads) thread.join();
  std::fprintf(stderr, "\r%s: done \n", what.c_str());
  return total;
}

}  // namespace detent::test
