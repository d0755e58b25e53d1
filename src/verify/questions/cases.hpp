// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <string_view>

#include "detent/number/angle.hpp"
#include "detent/number/digest.hpp"

// The case of a question lists its fields: fields(f) returns f(field, ...) in their order, from
// which its digest follows. Most have `field_names` too, from which their text and their conversion
// to floating point follow.

namespace detent::verify {

/// Angles are added to digests as plain numbers.
template <Scalar S>
[[nodiscard]] constexpr auto as_field(const Angle<S>& angle) noexcept {
  return angle.raw();
}
template <class T>
[[nodiscard]] constexpr const T& as_field(const T& field) noexcept {
  return field;
}

struct IgnoreFields {
  constexpr void operator()(const auto&...) const noexcept {}
};

template <class D, class Case>
requires requires(const Case& c) { c.fields(IgnoreFields()); }
constexpr void append(D& digest, const Case& c) noexcept {
  c.fields([&](const auto&... fields) { digest.add(as_field(fields)...); });
}

/// A group that runs in these dimensions; one of numbers runs in one.
template <int... Dimensions>
struct InDimensions {
  template <int N>
  static constexpr bool asks = ((N == Dimensions) || ...);
};

}  // namespace detent::verify
