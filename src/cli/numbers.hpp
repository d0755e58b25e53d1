// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <charconv>
#include <cmath>
#include <concepts>
#include <string>
#include <string_view>

#include "detent/detent.hpp"

// What the tool needs of a scalar beyond arithmetic: a name, a range, text. Only this file
// distinguishes the scalars.

namespace detent::cli {

inline constexpr std::array<std::string_view, 6> scalar_names{"q16_16", "q14_16", "q24_8",
                                                              "q8_8",   "float",  "double"};

template <Scalar S>
inline constexpr std::string_view scalar_name;
template <>
inline constexpr std::string_view scalar_name<q16_16> = scalar_names[0];
template <>
inline constexpr std::string_view scalar_name<q14_16> = scalar_names[1];
template <>
inline constexpr std::string_view scalar_name<q24_8> = scalar_names[2];
template <>
inline constexpr std::string_view scalar_name<q8_8> = scalar_names[3];
template <>
inline constexpr std::string_view scalar_name<float> = scalar_names[4];
template <>
inline constexpr std::string_view scalar_name<double> = scalar_names[5];

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
