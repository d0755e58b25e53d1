// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>

#include "detent/math/transform.hpp"
#include "detent/number/words.hpp"
#include "detent/shape/fields.hpp"

namespace detent::detail {

/// Takes values apart into the words that a digest would read; `To::put(word)` gets each.
template <class To>
class WordSink {
 public:
  template <class... Values>
  constexpr void add(const Values&... values) noexcept {
    (add_one(values), ...);
  }

 private:
  template <class T>
  constexpr void add_one(const T& value) noexcept {
    auto& to = static_cast<To&>(*this);
    if constexpr (requires { typename Word<T>; }) {
      to.put(to_word(value));
    } else {
      append(to, value);
    }
  }
};

/// Writes the bytes that a digest would read, while there is room, and counts all of them.
class Writer : public WordSink<Writer> {
 public:
  Writer() noexcept = default;
  explicit constexpr Writer(std::span<std::byte> room) noexcept : room_(room) {}

  [[nodiscard]] constexpr std::size_t size() const noexcept { return size_; }

  template <class W>
  constexpr void put(W word) noexcept {
    const auto end = size_ + sizeof(W);
    if (end <= room_.size()) store_word(room_.data() + size_, word);
    size_ = end;
  }

 private:
  std::span<std::byte> room_;
  std::size_t size_ = 0;
};

/// Counts the bytes that `Writer` would write.
class ByteCounter : public WordSink<ByteCounter> {
 public:
  [[nodiscard]] constexpr std::size_t size() const noexcept { return size_; }

  template <class W>
  constexpr void put(W) noexcept {
    size_ += sizeof(W);
  }

 private:
  std::size_t size_ = 0;
};

/// Writes what `Writer` would without bounds checks.
class Storer : public WordSink<Storer> {
 public:
  explicit constexpr Storer(std::byte* to) noexcept : to_(to) {}

  template <class W>
  constexpr void put(W word) noexcept {
    store_word(to_, word);
    to_ += sizeof(W);
  }

 private:
  std::byte* to_;
};

/// The number of bytes that `Writer` writes for a value.
template <class T>
inline constexpr std::size_t byte_count = [] {
  ByteCounter count;
  count.add(T());
  return count.size();
}();

/// Loads values without bounds checks. Bytes that encode no value set `is_wrong`, and loading
/// continues with an arbitrary valid value.
class Loader {
 public:
  explicit constexpr Loader(const std::byte* from) noexcept : from_(from) {}

  [[nodiscard]] constexpr bool is_wrong() const noexcept { return is_wrong_; }

  template <class T>
  [[nodiscard]] constexpr T number() noexcept {
    const auto word = load_word<Word<T>>(from_);
    from_ += sizeof(Word<T>);
    const T value = from_word<T>(word);
    if constexpr (is_fixed<T>) is_wrong_ |= to_word(value) != word;
    return value;
  }
  template <class T>
  requires requires { typename Word<T>; }
  constexpr void load(T& value) noexcept { value = number<T>(); }

  template <Number S, int N>
  constexpr void load(Vec<S, N>& v) noexcept {
    for (int i = 0; i < N; ++i) v[i] = number<S>();
  }
  template <Scalar S, int N>
  constexpr void load(Direction<S, N>& direction) noexcept {
    std::array<typename Direction<S, N>::Raw, static_cast<std::size_t>(N)> raw{};
    for (auto& component : raw) component = number<typename Direction<S, N>::Raw>();
    const auto read = Direction<S, N>::from_raw(raw);
    is_wrong_ |= !read;
    direction = read.value_or(direction);
  }
  template <Scalar S, int N>
  constexpr void load(Rotation<S, N>& rotation) noexcept {
    std::array<Direction<S, N>, static_cast<std::size_t>(N)> axes;
    for (auto& axis : axes) load(axis);
    rotation = Rotation<S, N>::from_axes(axes);
  }
  template <Scalar S, int N>
  constexpr void load(Transform<S, N>& transform) noexcept {
    load(transform.translation);
    load(transform.rotation);
    load(transform.scale);
  }
  template <ListsFields Shape>
  constexpr void load(Shape& shape) noexcept {
    ShapeFields<Shape>::of(shape, [&](auto&... fields) { (load(fields), ...); });
  }

 private:
  const std::byte* from_;
  bool is_wrong_ = false;
};

/// Reads values one after another. Fails past the end of the bytes and on bytes that encode no
/// value.
class Reader {
 public:
  explicit constexpr Reader(std::span<const std::byte> bytes) noexcept : bytes_(bytes) {}

  [[nodiscard]] constexpr std::size_t left() const noexcept { return bytes_.size() - position_; }
  [[nodiscard]] constexpr bool has_failed() const noexcept { return has_failed_; }

  template <class... Values>
  constexpr void get(Values&... values) noexcept {
    constexpr auto size = (byte_count<Values> + ...);
    if (left() < size) {
      has_failed_ = true;
      return;
    }
    Loader in(bytes_.data() + position_);
    (in.load(values), ...);
    has_failed_ |= in.is_wrong();
    position_ += size;
  }
  template <class T>
  [[nodiscard]] constexpr T number() noexcept {
    T value{};
    get(value);
    return value;
  }

 private:
  std::span<const std::byte> bytes_;
  std::size_t position_ = 0;
  bool has_failed_ = false;
};

}  // namespace detent::detail
