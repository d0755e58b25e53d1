// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <string>

namespace detent::cli {

/// How work is spread over threads, and the progress display.
struct Workers {
  int threads = 0;    // 0 for as many as the machine has
  std::string label;  // next to a progress bar on a terminal; "" for no bar
};

/// Calls `work(i)` once for every i in [0, count), on several threads in no particular order.
/// `work` must write only to data of index i, so that threads cannot affect the result.
void for_each_index(const Workers& workers, int count, const std::function<void(int)>& work);

}  // namespace detent::cli
