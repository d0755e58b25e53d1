// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <thread>
#include <vector>

namespace detent::test {

/// A pool of threads, including the caller's, that runs the calls of a step: `world.step(pool)`.
///
/// It never waits for a thread that has not taken a call. On a busy machine such a thread may
/// arrive late, and then finds nothing to do.
class Pool {
 public:
  explicit Pool(std::size_t threads) {
    for (std::size_t i = 1; i < threads; ++i) {
      workers_.emplace_back([this] { work(); });
    }
  }
  Pool(const Pool&) = delete;
  Pool& operator=(const Pool&) = delete;
  ~Pool() {
    ends_.store(true);
    open(0);
    for (auto& worker : workers_) worker.join();
  }

  /// Calls f(i) once for each i below `count` < 2^20, on all threads, and returns after the last.
  template <class F>
  void operator()(std::size_t count, const F& f) {
    call_ = [](const void* context, std::size_t i) { (*static_cast<const F*>(context))(i); };
    context_ = &f;
    left_.store(count, std::memory_order_relaxed);
    open(count);
    while (take()) {
    }
    while (left_.load(std::memory_order_acquire) != 0) std::this_thread::yield();
  }

 private:
  // One word, so that a call is taken only in its own round: round, calls, and calls not taken yet.
  static constexpr int bits = 20;
  static constexpr std::uint64_t mask = (std::uint64_t{1} << bits) - 1;

  void open(std::size_t count) {
    const auto round = (round_.load(std::memory_order_relaxed) >> 2 * bits) + 1;
    round_.store(round << 2 * bits | count << bits | count, std::memory_order_release);
    round_.notify_all();
  }
  bool take() {
    auto round = round_.load(std::memory_order_acquire);
    do {
      if ((round & mask) == 0) return false;
    } while (!round_.compare_exchange_weak(round, round - 1, std::memory_order_acq_rel));
    call_(context_, (round >> bits & mask) - (round & mask));
    left_.fetch_sub(1, std::memory_order_release);
    return true;
  }
  /// Looks for calls for a while, because most pauses within a step are short, then sleeps.
  void work() {
    while (!ends_.load()) {
      bool has_taken = false;
      for (int i = 0; i < 2000 && !has_taken; ++i) has_taken = take();
      if (has_taken) continue;
      const auto round = round_.load(std::memory_order_acquire);
      if ((round & mask) == 0 && !ends_.load()) round_.wait(round);
    }
  }

  std::vector<std::thread> workers_;
  void (*call_)(const void*, std::size_t) = nullptr;
  const void* context_ = nullptr;
  std::atomic<std::uint64_t> round_ = 0;
  std::atomic<std::size_t> left_ = 0;
  std::atomic<bool> ends_ = false;
};

}  // namespace detent::test
