// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>

namespace detent::cli {

/// Writes to standard output and checks that all of it was written.
void print(const std::string& text);

/// "0x0123456789abcdef"
[[nodiscard]] std::string hexadecimal(std::uint64_t value);

/// `value` with this many decimals, for tables.
[[nodiscard]] std::string rounded(double value, int decimals);

}  // namespace detent::cli
