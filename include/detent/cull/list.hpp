// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>

#include "detent/number/assert.hpp"
#if __STDC_HOSTED__
#include <vector>
#endif

namespace detent {

namespace detail {

/// A list with room for `Capacity` elements inside itself.
template <class T, std::size_t Capacity>
class FixedList {
 public:
  [[nodiscard]] constexpr std::size_t size() const noexcept { return size_; }
  [[nodiscard]] constexpr T& operator[](std::size_t i) noexcept { return elements_[i]; }
  [[nodiscard]] constexpr const T& operator[](std::size_t i) const noexcept { return elements_[i]; }
  [[nodiscard]] constexpr T& back() noexcept { return elements_[size_ - 1]; }
  [[nodiscard]] constexpr const T* data() const noexcept { return elements_.data(); }

  constexpr void push_back(const T& value) noexcept {
    DETENT_ASSERT(size_ < Capacity);
    elements_[size_++] = value;
  }
  constexpr void pop_back() noexcept { --size_; }
  constexpr void clear() noexcept { size_ = 0; }
  /// New elements are T().
  constexpr void resize(std::size_t size) noexcept {
    for (; size_ < size; ++size_) elements_[size_] = T();
    size_ = size;
  }
  constexpr void reserve(std::size_t /*size*/) noexcept {}

 private:
  std::array<T, Capacity> elements_{};
  std::size_t size_ = 0;
};

/// A list of capacity 0: its elements are never accessed.
template <class T>
class FixedList<T, 0> {
 public:
  [[nodiscard]] constexpr std::size_t size() const noexcept { return 0; }
  [[nodiscard]] constexpr T& operator[](std::size_t) const noexcept { return none(); }
  [[nodiscard]] constexpr T& back() const noexcept { return none(); }
  [[nodiscard]] constexpr const T* data() const noexcept { return nullptr; }
  constexpr void push_back(const T&) const noexcept { DETENT_ASSERT(size() != 0); }
  constexpr void pop_back() const noexcept {}
  constexpr void clear() const noexcept {}
  constexpr void resize(std::size_t) const noexcept {}
  constexpr void reserve(std::size_t) const noexcept {}

 private:
  /// Never called. Marked unreachable, because compilers would warn of an element out of bounds.
  [[noreturn]] static constexpr T& none() noexcept {
#if defined(_MSC_VER) && !defined(__clang__)
    __assume(false);
#else
    __builtin_unreachable();
#endif
  }
};

}  // namespace detail

#if __STDC_HOSTED__
/// Storage of a scene or world that allocates as it grows.
struct Growing {
  static constexpr bool is_growing = true;
  /// The most objects, frames and contacts, even if a snapshot claims more.
  static constexpr std::size_t capacity = std::size_t{1} << 20;
  static constexpr std::size_t frame_capacity = capacity;
  static constexpr std::size_t contact_capacity = 8 * capacity;
  template <class T, std::size_t>
  using List = std::vector<T>;
};
#endif

/// Storage of a scene or world that holds its memory inside itself and never allocates: for so many
/// objects or bodies, frames of a scene, and contacts of a world.
template <std::size_t Capacity, std::size_t FrameCapacity = 0,
          std::size_t ContactCapacity = 8 * Capacity>
struct Bounded {
  static constexpr std::size_t capacity = Capacity;
  static constexpr std::size_t frame_capacity = FrameCapacity;
  static constexpr std::size_t contact_capacity = ContactCapacity;
  template <class T, std::size_t Count>
  using List = detail::FixedList<T, Count>;
};

}  // namespace detent
