// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <type_traits>
#include <variant>

#include "detent/number/require_cxx20.hpp"

namespace detent::detail {

/// The index of `T` in a list of types; their number if it is not there.
template <class T, class... Ts>
inline constexpr std::size_t place_in = [] {
  std::size_t place = 0;
  static_cast<void>(((std::is_same_v<T, Ts> ? false : (++place, true)) && ...));
  return place;
}();

template <class T, class... Ts>
concept Among = place_in<T, Ts...> < sizeof...(Ts);

/// A shape of one of several types. For a single type it is that shape: no tag, no branch.
template <class... Shapes>
class OneOf {
 public:
  constexpr OneOf() noexcept = default;
  template <Among<Shapes...> Shape>
  explicit constexpr OneOf(const Shape& shape) noexcept : shape_(shape) {}

  /// The index of the shape's type in the list.
  [[nodiscard]] constexpr std::size_t kind() const noexcept { return shape_.index(); }

  /// The shape, or nullptr when it has another type.
  template <class Shape>
  [[nodiscard]] constexpr const Shape* get() const noexcept {
    return std::get_if<Shape>(&shape_);
  }

  /// Calls f(shape) with the shape in its own type.
  template <class F>
  constexpr decltype(auto) visit(F&& f) const noexcept {
    return visit_from<0>(f);
  }

  [[nodiscard]] friend constexpr bool operator==(const OneOf& a, const OneOf& b) noexcept {
    return a.visit([&](const auto& shape) {
      const auto* other = b.template get<std::remove_cvref_t<decltype(shape)>>();
      return other != nullptr && shape == *other;
    });
  }

 private:
  template <std::size_t Int, class F>
  constexpr decltype(auto) visit_from(F& f) const noexcept {
    if constexpr (Int + 1 == sizeof...(Shapes)) {
      return f(*std::get_if<Int>(&shape_));
    } else {
      if (shape_.index() == Int) return f(*std::get_if<Int>(&shape_));
      return visit_from<Int + 1>(f);
    }
  }

  std::variant<Shapes...> shape_;
};

template <class Only>
class OneOf<Only> {
 public:
  constexpr OneOf() noexcept = default;
  explicit constexpr OneOf(const Only& shape) noexcept : shape_(shape) {}

  [[nodiscard]] static constexpr std::size_t kind() noexcept { return 0; }
  template <class Shape>
  [[nodiscard]] constexpr const Shape* get() const noexcept {
    return &shape_;
  }
  template <class F>
  constexpr decltype(auto) visit(F&& f) const noexcept {
    return f(shape_);
  }
  [[nodiscard]] friend constexpr bool operator==(const OneOf&, const OneOf&) noexcept = default;

 private:
  Only shape_{};
};

}  // namespace detent::detail
