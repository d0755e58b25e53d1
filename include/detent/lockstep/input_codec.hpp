// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <bit>
#include <concepts>
#include <cstddef>
#include <span>
#include <type_traits>

#include "detent/lockstep/bits.hpp"
#include "detent/number/words.hpp"

namespace detent {

/// The bytes of an input in packets and replays: the same on every machine, always `size` of them.
///
///     static constexpr std::size_t size;
///     static constexpr void write(const Input& input, std::byte* to) noexcept;
///     static constexpr Input read(const std::byte* from) noexcept;   // any bytes are an input
///
/// Numbers, enums, `Fixed`, bool, arrays of these and structs of single bytes have a codec. For a
/// struct of your own, list its fields:
///
///     template <>
///     struct detent::InputCodec<Pad> : detent::FieldCodec<&Pad::x, &Pad::z, &Pad::jump> {};
///
/// A peer may send any bytes, so any value of each field, including unnamed values of an enum.
/// Unlisted fields keep their values in `Input{}`.
///
/// (tests/lockstep/packet.test.cpp)
template <class Input>
struct InputCodec {
  static_assert(sizeof(Input) == 1 || alignof(Input) == 1,
                "say how this input is stored: specialise detent::InputCodec, for example by "
                "detent::FieldCodec<&Pad::x, &Pad::z>");
  static_assert(std::is_trivially_copyable_v<Input> &&
                    std::has_unique_object_representations_v<Input>,
                "an input without detent::InputCodec is a struct of integers of one byte");
  static constexpr std::size_t size = sizeof(Input);
  /// Stores an input in `size` bytes.
  static constexpr void write(const Input& input, std::byte* to) noexcept {
    const auto bytes = std::bit_cast<std::array<std::byte, size>>(input);
    for (std::size_t i = 0; i < size; ++i) to[i] = bytes[i];
  }
  [[nodiscard]] static constexpr Input read(const std::byte* from) noexcept {
    std::array<std::byte, size> bytes{};
    for (std::size_t i = 0; i < size; ++i) bytes[i] = from[i];
    return std::bit_cast<Input>(bytes);
  }
};

template <>
struct InputCodec<bool> {
  static constexpr std::size_t size = 1;
  /// Stores an input in `size` bytes.
  static constexpr void write(bool input, std::byte* to) noexcept {
    *to = static_cast<std::byte>(input);
  }
  [[nodiscard]] static constexpr bool read(const std::byte* from) noexcept {
    return *from != std::byte{0};
  }
};

template <class Number>
requires requires { typename detail::Word<Number>; }
struct InputCodec<Number> {
  static constexpr std::size_t size = sizeof(detail::Word<Number>);
  /// Stores an input in `size` bytes.
  static constexpr void write(const Number& input, std::byte* to) noexcept {
    detail::store_word(to, detail::to_word(input));
  }
  [[nodiscard]] static constexpr Number read(const std::byte* from) noexcept {
    return detail::from_word<Number>(detail::load_word<detail::Word<Number>>(from));
  }
};

template <class T, std::size_t Count>
struct InputCodec<std::array<T, Count>> {
  static constexpr std::size_t size = Count * InputCodec<T>::size;
  /// Stores an input in `size` bytes.
  static constexpr void write(const std::array<T, Count>& input, std::byte* to) noexcept {
    for (std::size_t i = 0; i < Count; ++i) {
      InputCodec<T>::write(input[i], to + i * InputCodec<T>::size);
    }
  }
  [[nodiscard]] static constexpr std::array<T, Count> read(const std::byte* from) noexcept {
    std::array<T, Count> input{};
    for (std::size_t i = 0; i < Count; ++i) {
      input[i] = InputCodec<T>::read(from + i * InputCodec<T>::size);
    }
    return input;
  }
};

namespace detail {

template <class>
struct member_of;
template <class Struct, class Field>
struct member_of<Field Struct::*> {
  using object = Struct;
  using field = Field;
};

}  // namespace detail

/// A codec of a struct that stores these fields one after another.
template <auto First, auto... Members>
struct FieldCodec {
  using Input = typename detail::member_of<decltype(First)>::object;
  template <class Pointer>
  using Codec = InputCodec<typename detail::member_of<Pointer>::field>;

  static constexpr std::size_t size =
      (Codec<decltype(First)>::size + ... + Codec<decltype(Members)>::size);

  /// Stores an input in `size` bytes.
  static constexpr void write(const Input& input, std::byte* to) noexcept {
    const auto one = [&](auto member) {
      Codec<decltype(member)>::write(input.*member, to);
      // cppcheck-suppress uselessAssignmentPtrArg  // false positive: the next call uses it
      to += Codec<decltype(member)>::size;
    };
    (one(First), ..., one(Members));
  }
  [[nodiscard]] static constexpr Input read(const std::byte* from) noexcept {
    Input input{};
    const auto one = [&](auto member) {
      input.*member = Codec<decltype(member)>::read(from);
      // cppcheck-suppress uselessAssignmentPtrArg  // false positive: the next call uses it
      from += Codec<decltype(member)>::size;
    };
    (one(First), ..., one(Members));
    return input;
  }
};

namespace detail {

template <class Input>
using InputBytes = std::array<std::byte, InputCodec<Input>::size>;

template <class Input>
[[nodiscard]] constexpr InputBytes<Input> bytes_of(const Input& input) noexcept {
  InputBytes<Input> bytes{};
  InputCodec<Input>::write(input, bytes.data());
  return bytes;
}
/// The canonical bytes of the input that any bytes decode to: equal for equal inputs.
template <class Input>
[[nodiscard]] constexpr InputBytes<Input> canonical(const InputBytes<Input>& bytes) noexcept {
  return bytes_of<Input>(InputCodec<Input>::read(bytes.data()));
}

/// Appends one input after another: a bit if it is unchanged, otherwise its changed bytes.
template <std::size_t Size>
constexpr void pack(BitWriter& out, const std::array<std::byte, Size>& input,
                    const std::array<std::byte, Size>& before) noexcept {
  out.add_flag(input != before);
  if (input == before) return;
  for (std::size_t i = 0; i < Size; ++i) {
    out.add_flag(input[i] != before[i]);
    if (input[i] != before[i]) out.add(std::to_integer<std::uint64_t>(input[i]), 8);
  }
}
/// Advances `input` from the previous input to the next one. Fails on bits that `pack` does not
/// write.
template <std::size_t Size>
constexpr void unpack(BitReader& in, std::array<std::byte, Size>& input) noexcept {
  if (!in.flag()) return;
  bool has_changed = false;
  for (std::byte& byte : input) {
    if (!in.flag()) continue;
    byte = static_cast<std::byte>(in.number(8));
    has_changed = true;
  }
  if (!has_changed) in.fail();
}

}  // namespace detail

}  // namespace detent
