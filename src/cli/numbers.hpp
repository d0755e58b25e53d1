// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <charconv>
#include <cmath>
#include <concepts>
#include <string>
#include <string_view>

#include "detent/detent.hpp"
#include "support/scalars.hpp"

// What the tool needs of a scalar beyond arithmetic: a name, a range, text.

namespace detent::cli {

using support::scalar_name;
using support::scalar_names;

/// The exact decimal of a `Fixed`; for a float the shortest decimal that reads back as the same
/// value.
template <Number T>
[[nodiscard]] std::string text_of(const T& value) {
  if constexpr (is_fixed<T>) {
    return to_string(value);
  } else {
    if (!std::isfinite(value)) return "null";  // JSON has no such number
    std::array<char, 32> buffer{};
    const auto result = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
    return {buffer.data(), result.ptr};
  }
}

/// "-32768 to 32767.9999847412109375"
template <Scalar S>
[[nodiscard]] std::string range_of() {
  if constexpr (is_fixed<S>) {
    return to_string(S::lowest()) + " to " + to_string(S::max());
  } else {
    return text_of(-largest<S>) + " to " + text_of(largest<S>);
  }
}

}  // namespace detent::cli
