// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>

#include "detent/number/words.hpp"
#include "detent/shape/moved.hpp"

namespace detent::detail {

/// Writes what a digest would take, to memory that is known to be large enough; or counts it only.
class Writer {
 public:
  Writer() noexcept = default;
  explicit constexpr Writer(std::byte* to) noexcept : to_(to) {}

  template <class... Values>
  constexpr void add(const Values&... values) noexcept {
    (add_one(values), ...);
  }
  [[nodiscard]] constexpr std::size_t size() const noexcept { return size_; }

 private:
  template <class T>
  constexpr void add_one(const T& value) noexcept {
    if constexpr (requires { typename Word<T>; }) {
      if (to_ != nullptr) store_word(to_ + size_, to_word(value));
      size_ += sizeof(Word<T>);
    } else {
      append(*this, value);
    }
  }

  std::byte* to_ = nullptr;
  std::size_t size_ = 0;
};

/// Reads such bytes. Past their end, and where they are not those of any value, it fails and goes
/// on with some value.
class Reader {
 public:
  explicit constexpr Reader(std::span<const std::byte> bytes) noexcept : bytes_(bytes) {}

  [[nodiscard]] constexpr std::size_t position() const noexcept { return position_; }
  [[nodiscard]] constexpr std::size_t left() const noexcept { return bytes_.size() - position_; }
  [[nodiscard]] constexpr bool has_failed() const noexcept { return has_failed_; }

  template <class T>
  [[nodiscard]] constexpr T number() noexcept {
    if (left() < sizeof(Word<T>)) {
      has_failed_ = true;
      return T();
    }
    const auto word = load_word<Word<T>>(bytes_.data() + position_);
    position_ += sizeof(Word<T>);
    const T value = from_word<T>(word);
    if constexpr (is_fixed<T>) has_failed_ |= to_word(value) != word;
    return value;
  }

  template <Number S, int N>
  constexpr void get(Vec<S, N>& v) noexcept {
    for (int i = 0; i < N; ++i) v[i] = number<S>();
  }
  template <Scalar S>
  constexpr void get(S& x) noexcept {
    x = number<S>();
  }
  template <Scalar S, int N>
  constexpr void get(Direction<S, N>& direction) noexcept {
    std::array<typename Direction<S, N>::Raw, static_cast<std::size_t>(N)> raw{};
    for (auto& component : raw) component = number<typename Direction<S, N>::Raw>();
    const auto read = Direction<S, N>::from_raw(raw);
    has_failed_ |= !read;
    direction = read.value_or(direction);
  }
  template <Scalar S, int N>
  constexpr void get(Rotation<S, N>& rotation) noexcept {
    std::array<Direction<S, N>, static_cast<std::size_t>(N)> axes;
    for (auto& axis : axes) get(axis);
    rotation = Rotation<S, N>::from_axes(axes);
  }
  template <Scalar S, int N>
  constexpr void get(Transform<S, N>& transform) noexcept {
    get(transform.translation);
    get(transform.rotation);
    get(transform.scale);
  }
  template <Scalar S, int N>
  constexpr void get(Sphere<S, N>& sphere) noexcept {
    get(sphere.center);
    get(sphere.radius);
  }
  template <Scalar S, int N>
  constexpr void get(Aabb<S, N>& box) noexcept {
    get(box.min);
    get(box.max);
  }
  template <Scalar S, int N>
  constexpr void get(Obb<S, N>& box) noexcept {
    get(box.center);
    get(box.half_extents);
    get(box.rotation);
  }
  template <Scalar S, int N>
  constexpr void get(Plane<S, N>& plane) noexcept {
    get(plane.normal);
    get(plane.offset);
  }
  template <Scalar S, int N>
  constexpr void get(Triangle<S, N>& triangle) noexcept {
    get(triangle.a);
    get(triangle.b);
    get(triangle.c);
  }
  template <Scalar S, int N>
  constexpr void get(Capsule<S, N>& capsule) noexcept {
    get(capsule.a);
    get(capsule.b);
    get(capsule.radius);
  }

 private:
  std::span<const std::byte> bytes_;
  std::size_t position_ = 0;
  bool has_failed_ = false;
};

}  // namespace detent::detail
