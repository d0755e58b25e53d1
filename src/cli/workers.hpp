// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <string>

namespace detent::cli {

/// How work is spread over threads, and what the user sees of it.
struct Workers {
  int threads = 0;    // 0 for as many as the machine runs at once
  std::string label;  // shown beside a bar while standard error is a terminal; "" for none
};

/// Calls `work(i)` once for every i in [0, count), on several threads in no particular order.
/// The caller's `work` writes only to what belongs to i, so the threads cannot show in the result.
void for_each_index(const Workers& workers, int count, const std::function<void(int)>& work);

}  // namespace detent::cli
