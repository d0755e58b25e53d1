// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <iterator>
#include <string_view>
#include <type_traits>

#include "detent/math/transform.hpp"
#include "detent/number/digest.hpp"
#include "detent/scene/field_name.hpp"
#include "detent/shape/fields.hpp"

// The named parts of a value: for_each_field(value, f) calls f(name, part) for each part.

namespace detent {

/// Calls f(name, part) for each named part of a value, in the order of its fields.
template <Number T, int N, class F>
constexpr void for_each_field(const Vec<T, N>& v, const F& f) {
  for (int i = 0; i < N; ++i) f(std::string_view(&"xyz"[i], 1), v[i]);
}
template <Scalar S, int N, class F>
constexpr void for_each_field(const Direction<S, N>& direction, const F& f) {
  for_each_field(direction.vec(), f);
}
template <Scalar S, int N, class F>
constexpr void for_each_field(const Rotation<S, N>& rotation, const F& f) {
  for (int i = 0; i < N; ++i) {
    f(FieldName("axis ").add_number(static_cast<std::uint64_t>(i)), rotation.axis(i));
  }
}
template <Scalar S, int N, class F>
constexpr void for_each_field(const Transform<S, N>& transform, const F& f) {
  f("translation", transform.translation);
  for_each_field(transform.rotation, f);
  f("scale", transform.scale);
}

/// The parts of a shape: its fields, and the axes of a rotation one by one.
template <detail::ListsFields Shape, class F>
constexpr void for_each_field(const Shape& shape, const F& f) {
  using Fields = detail::ShapeFields<Shape>;
  const auto visit = [&]<class Field>(std::string_view name, const Field& field) {
    if constexpr (requires { field.axis(0); }) {
      for_each_field(field, f);
    } else {
      f(name, field);
    }
  };
  const std::string_view* name = Fields::names;
  Fields::of(shape, [&](const auto&... fields) { (visit(*name++, fields), ...); });
}

namespace detail {

struct AnyFieldVisitor {
  template <class T>
  constexpr void operator()(const PartName&, const T&) const noexcept {}
};

/// A type whose parts `for_each_field(value, f)` lists, found by argument-dependent lookup.
template <class T>
concept HasFields = requires(const T& value, const AnyFieldVisitor& f) {
  for_each_field(value, f);
};

/// An array, std::array, std::vector: elements in order, and their number.
template <class T>
concept IsList = requires(const T& list) {
  std::begin(list);
  std::end(list);
  std::size(list);
};

template <IsList T>
using Element = std::remove_cvref_t<decltype(*std::begin(std::declval<const T&>()))>;

template <class T>
inline constexpr bool is_field = HasFields<T> || Digestible<T>;
template <IsList T>
inline constexpr bool is_field<T> = HasFields<T> || is_field<Element<T>>;

/// A field of a world: a number, bool or enum, or another type that `append(digest, value)` adds to
/// a `Digest`; a type that lists its own parts by `for_each_field`, as vectors, rotations, shapes
/// and scenes do; or an array or list of these.
template <class T>
concept Field = is_field<T>;

}  // namespace detail

}  // namespace detent
