// SPDX-License-Identifier: MIT
#include "workers.hpp"

#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cstdio>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

namespace detent::cli {
namespace {

/// A line on standard error that is redrawn in place and erased at the end.
class ProgressBar {
 public:
  ProgressBar(const std::string& label, int total) : label_(label), total_(total) {
    shown_ = !label.empty() && isatty(STDERR_FILENO) != 0;
  }
  ~ProgressBar() {
    if (shown_) std::fputs("\r\033[K", stderr);
  }
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  void advance() {
    if (!shown_) return;
    const std::lock_guard lock(mutex_);
    const int before = done_ * width / total_;
    const int filled = ++done_ * width / total_;
    if (filled == before) return;
    const std::string bar(static_cast<std::size_t>(filled), '#');
    std::fprintf(stderr, "\r%s [%-*s] %3d %%", label_.c_str(), width, bar.c_str(),
                 done_ * 100 / total_);
    std::fflush(stderr);
  }

 private:
  static constexpr int width = 40;

  std::string label_;
  int total_;
  int done_ = 0;
  bool shown_;
  std::mutex mutex_;
};

}  // namespace

void for_each_index(const Workers& workers, int count, const std::function<void(int)>& work) {
  ProgressBar bar(workers.label, count);
  std::atomic<int> next{0};
  std::mutex mutex;
  std::exception_ptr error;  // the first error stops all threads
  const auto run = [&] {
    try {
      for (int i = next++; i < count; i = next++) {
        work(i);
        bar.advance();
      }
    } catch (...) {
      const std::lock_guard lock(mutex);
      if (!error) error = std::current_exception();
      next = count;
    }
  };
  const int available = static_cast<int>(std::max(std::thread::hardware_concurrency(), 1u));
  const int threads = std::min(workers.threads > 0 ? workers.threads : available, count);
  {
    std::vector<std::jthread> helpers;
    try {
      for (int i = 1; i < threads; ++i) helpers.emplace_back(run);
    } catch (const std::system_error&) {
      // The system grants no more threads: those that exist do the work.
    }
    run();
  }
  if (error) std::rethrow_exception(error);
}

}  // namespace detent::cli
