// SPDX-License-Identifier: MIT
#include "print.hpp"

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>

#include "error.hpp"

namespace detent::cli {

void print(const std::string& text) {
  errno = 0;
  if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size() || std::fflush(stdout) != 0) {
    throw InputError(
        "standard output", {},
        std::string("cannot be written: ") + std::strerror(errno) + "; redirect it elsewhere");
  }
}

std::string hexadecimal(std::uint64_t value) {
  std::array<char, 24> buffer{};
  std::snprintf(buffer.data(), buffer.size(), "0x%016llx", static_cast<unsigned long long>(value));
  return buffer.data();
}

std::string rounded(double value, int decimals) {
  std::array<char, 400> buffer{};
  std::snprintf(buffer.data(), buffer.size(), "%.*f", decimals, value);
  return buffer.data();
}

}  // namespace detent::cli
