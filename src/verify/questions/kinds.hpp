// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <string_view>

#include "verify/draw/shapes.hpp"

namespace detent::verify {

/// A kind of shape: the name used in row names, and how one is drawn. Clang 14 takes no `q16_16` in
/// the class instead of the default `Example`.
template <template <Scalar, int> class Shape, class Example = q16_16>
struct Kind {
  static constexpr std::string_view name = detail::ShapeFields<Shape<Example, 3>>::name;

  template <Scalar S, int N>
  using Of = Shape<S, N>;

  template <Scalar S, int N>
  static constexpr auto draw(ShapeScene<S, N>& scene) noexcept {
    return scene.draw(Type<Shape<S, N>>());
  }
};
/// The name of a row, concatenated from a few words at compile time.
class RowName {
 public:
  template <class... Words>
  explicit constexpr RowName(const Words&... words) noexcept {
    (add(words), ...);
  }
  [[nodiscard]] constexpr std::string_view view() const noexcept {
    return {characters_.data(), length_};
  }

 private:
  constexpr void add(std::string_view word) noexcept {
    for (const char c : word) characters_[length_++] = c;
  }

  std::array<char, 32> characters_{};
  std::size_t length_ = 0;
};

}  // namespace detent::verify
