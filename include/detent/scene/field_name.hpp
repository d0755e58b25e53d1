// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "detent/number/require_cxx20.hpp"

namespace detent {

/// The path of a field in a world, such as `velocity[3].x`. Uses no heap, so a name is cut off
/// after `capacity` characters.
class FieldName {
 public:
  static constexpr std::size_t capacity = 119;

  constexpr FieldName() noexcept = default;
  /// The name in a string literal.
  template <std::size_t Size>
  explicit constexpr FieldName(const char (&literal)[Size]) noexcept {
    add(literal);
  }

  /// Appends text, truncated to `capacity` characters in all.
  template <std::size_t Size>
  constexpr FieldName& add(const char (&literal)[Size]) noexcept {
    return add(std::string_view(literal, Size - 1));
  }
  constexpr FieldName& add(std::string_view text) noexcept {
    for (const char c : text) {
      if (size_ < capacity) text_[size_++] = c;
    }
    return *this;
  }
  /// Appends a number in decimal.
  constexpr FieldName& add_number(std::uint64_t number) noexcept {
    if (number >= 10) add_number(number / 10);
    const char digit = static_cast<char>('0' + number % 10);
    return add(std::string_view(&digit, 1));
  }

  /// Appends the name of a part, after a dot unless it begins with a space or bracket.
  constexpr FieldName& add_part(std::string_view part) noexcept {
    if (part.empty()) return *this;
    const bool is_separated = part.front() == ' ' || part.front() == '[';
    if (size_ == 0 && part.front() == ' ') part.remove_prefix(1);
    if (size_ == 0) return add(part);
    return is_separated ? add(part) : add(".").add(part);
  }
  /// Keeps the first `size` characters.
  constexpr void cut(std::size_t size) noexcept {
    while (size_ > size) text_[--size_] = 0;
  }

  [[nodiscard]] constexpr std::size_t size() const noexcept { return size_; }
  [[nodiscard]] constexpr std::string_view view() const noexcept { return {text_.data(), size_}; }
  [[nodiscard]] constexpr const char* c_str() const noexcept { return text_.data(); }
  [[nodiscard]] constexpr operator std::string_view() const noexcept { return view(); }

  [[nodiscard]] friend constexpr bool operator==(const FieldName& a, const FieldName& b) noexcept {
    return a.view() == b.view();
  }

 private:
  std::array<char, capacity + 1> text_{};  // ends in 0
  std::size_t size_ = 0;
};

namespace detail {

/// The name of a part of a field: a string literal, a string view or a path.
class PartName {
 public:
  template <std::size_t Size>
  constexpr PartName(const char (&literal)[Size]) noexcept : text_(literal, Size - 1) {}
  constexpr PartName(std::string_view text) noexcept : text_(text) {}
  constexpr PartName(const FieldName& name) noexcept : text_(name.view()) {}

  [[nodiscard]] constexpr std::string_view view() const noexcept { return text_; }

 private:
  std::string_view text_;
};

}  // namespace detail

}  // namespace detent
