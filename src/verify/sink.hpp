// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <bit>
#include <cmath>
#include <concepts>
#include <cstdint>
#include <optional>
#include <type_traits>
#include <utility>

#include "detent/number/digest.hpp"

namespace detent::verify {

/// Takes the same bytes as `Digest` and passes them to `put(word, count)`, `count` bytes from the
/// lowest on. Every NaN is written as one pattern, because the pattern of a NaN is not a result.
template <class Put>
class Sink {
 public:
  Sink() = default;
  explicit Sink(Put put) : put_(std::move(put)) {}

  template <class... Values>
  void add(const Values&... values) {
    (append(*this, values), ...);
  }
  void put(std::uint64_t word, int count) { put_(word, count); }
  [[nodiscard]] const Put& taken() const { return put_; }

 private:
  Put put_{};
};

/// For a sink whose bytes become a digest.
struct IntoDigest {
  Digest digest{};
  void operator()(std::uint64_t word, int count) { digest.add_low_bytes(word, count); }
};

template <class Put, std::integral I>
void append(Sink<Put>& sink, I value) {
  if constexpr (std::same_as<I, bool>) {
    sink.put(value ? 1 : 0, 1);
  } else {
    sink.put(static_cast<std::make_unsigned_t<I>>(value), sizeof(I));
  }
}
template <class Put>
void append(Sink<Put>& sink, float value) {
  sink.put(std::isnan(value) ? 0x7fc00000u : std::bit_cast<std::uint32_t>(value), 4);
}
template <class Put, int Bits, int Frac>
void append(Sink<Put>& sink, const Fixed<Bits, Frac>& value) {
  static_assert(Bits <= 63);
  append(sink, value.raw());
}
template <class Put, class T>
void append(Sink<Put>& sink, const std::optional<T>& value) {
  sink.add(value.has_value());
  if (value) sink.add(*value);
}
template <class Put, class T, std::size_t Size>
void append(Sink<Put>& sink, const std::array<T, Size>& values) {
  for (const T& value : values) sink.add(value);
}

}  // namespace detent::verify
