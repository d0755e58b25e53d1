// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

#include "detent/number/require_cxx20.hpp"

namespace detent {

namespace detail {

/// The fields of a shape, for digests, snapshots and differences: its `name`, the `names` of the
/// fields, and `of(shape, f)`, which returns f(field, ...) in their order. Each shape's header
/// specializes it; that of a round shape adds its core.
template <class Shape>
struct ShapeFields {};

template <class Shape>
concept ListsFields = requires {
  ShapeFields<Shape>::names;
};

/// A round shape: all points within `radius` of its `core(shape)`, a point or a segment; none if the
/// radius is negative.
template <class Shape>
concept Round = requires(const Shape& shape) {
  ShapeFields<Shape>::core(shape);
};

/// A shape with `f(field)` for each field.
template <ListsFields Shape, class F>
[[nodiscard]] constexpr Shape with_fields(const Shape& shape, const F& f) noexcept {
  return ShapeFields<Shape>::of(shape, [&](const auto&... fields) { return Shape{f(fields)...}; });
}

}  // namespace detail

/// Appends to a digest: the fields in order.
template <class D, detail::ListsFields Shape>
constexpr void append(D& digest, const Shape& shape) noexcept {
  detail::ShapeFields<Shape>::of(shape, [&](const auto&... fields) { digest.add(fields...); });
}

}  // namespace detent
