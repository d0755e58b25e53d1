// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <string_view>
#include <type_traits>

#include "detent/number/fixed.hpp"

// The predefined scalars, for `verify`, the tool, tests, properties and benchmarks.

/// `USE(name)` for each predefined fixed-point scalar, separated by commas.
#define DETENT_EACH_FIXED_SCALAR(USE) USE(q16_16), USE(q14_16), USE(q24_8), USE(q8_8)

#define DETENT_SCALAR_NAME(name) #name
#define DETENT_SCALAR_TYPE(name) detent::name

namespace detent::support {

template <class... S>
struct ScalarList {
  static constexpr std::size_t size = sizeof...(S);

  template <class T>
  static constexpr std::size_t index_of() {
    std::size_t index = 0;
    static_cast<void>(((std::is_same_v<S, T> || (++index, false)) || ...));
    return index;
  }
};
using FixedScalars = ScalarList<DETENT_EACH_FIXED_SCALAR(DETENT_SCALAR_TYPE)>;
using AllScalars = ScalarList<DETENT_EACH_FIXED_SCALAR(DETENT_SCALAR_TYPE), float, double>;

inline constexpr std::array<std::string_view, AllScalars::size> scalar_names{
    DETENT_EACH_FIXED_SCALAR(DETENT_SCALAR_NAME), "float", "double"};

template <class S>
inline constexpr std::size_t scalar_index = AllScalars::index_of<S>();
template <class S>
inline constexpr std::string_view scalar_name = scalar_names[scalar_index<S>];

/// Calls `visit(S())` for every scalar of a list, in its order.
template <class... S, class Visit>
constexpr void for_each_scalar(ScalarList<S...>, Visit&& visit) {
  (visit(S()), ...);
}

}  // namespace detent::support
