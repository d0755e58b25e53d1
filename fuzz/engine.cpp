// SPDX-License-Identifier: MIT
#include <cstddef>

#include "property.hpp"

/// libFuzzer's entry point; an escaping exception ends the process, and the input is kept.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  detent::fuzz::property({data, size});
  return 0;
}
