// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <string_view>

#include "detent/number/text.hpp"
#include "verify/draw/numbers.hpp"
#include "verify/questions/cases.hpp"

namespace detent::verify {

/// A small number on the grid of a product of two or four numbers.
template <Number S, int Factors>
struct crumb_of {
  using type = S;
};
template <int Bits, int Frac, int Factors>
struct crumb_of<Fixed<Bits, Frac>, Factors> {
  using type = Fixed<4, Frac * Factors>;
};

template <Scalar S, int N>
struct RootCase {
  S a, b;
  typename crumb_of<S, 2>::type beside_square;
  typename crumb_of<S, 4>::type beside_fourth_power;

  static constexpr std::array<std::string_view, 4> field_names{"a", "b", "added to a b",
                                                               "added to (a b)^2"};
  constexpr auto fields(const auto& f) const noexcept {
    return f(a, b, beside_square, beside_fourth_power);
  }
};

/// Roots of 64 and of 128 bits, half of them at or next to squares.
struct Roots : InDimensions<1> {
  static constexpr std::array<std::string_view, 2> names{"sqrt_floor", "sqrt_floor/wide"};
  template <Scalar S, int N>
  static constexpr auto draw(Random& random) noexcept {
    Numbers<S> numbers(random);
    using Square = typename crumb_of<S, 2>::type;
    using Fourth = typename crumb_of<S, 4>::type;
    const S a = numbers.any();
    const S b = random.coin() ? a : numbers.any();
    const auto near = static_cast<typename Square::raw_type>(random.between(-2, 2));
    return RootCase<S, N>{a, b, Square::from_raw(near), Fourth::from_raw(near)};
  }
  template <int Row, Scalar S, int N>
  [[nodiscard]] static constexpr auto answer(const RootCase<S, N>& c) noexcept {
    if constexpr (Row == 0) {
      return sqrt_floor<S>(c.a * c.b + c.beside_square);
    } else {
      const auto product = c.a * c.b;
      return sqrt_floor<decltype(c.a * c.b)>(product * product + c.beside_fourth_power);
    }
  }
};

template <Scalar S, int N>
struct QuotientCase {
  S a, b, c, d;

  static constexpr std::array<std::string_view, 4> field_names{"a", "b", "c", "d"};
  constexpr auto fields(const auto& f) const noexcept { return f(a, b, c, d); }
};

/// Quotients of numbers, and of products of three by products of two; division by 0 included.
struct Quotients : InDimensions<1> {
  static constexpr std::array<std::string_view, 4> names{
      "quotient_floor", "quotient_floor/wide", "quotient_nearest", "quotient_nearest/wide"};
  template <Scalar S, int N>
  static constexpr auto draw(Random& random) noexcept {
    Numbers<S> numbers(random);
    return QuotientCase<S, N>{numbers.any(), numbers.any(), numbers.any(), numbers.any()};
  }
  template <int Row, Scalar S, int N>
  [[nodiscard]] static constexpr auto answer(const QuotientCase<S, N>& c) noexcept {
    if constexpr (Row == 0) {
      return quotient_floor<S>(c.a, c.b);
    } else if constexpr (Row == 1) {
      return quotient_floor<S>(c.a * c.b * c.c, c.d * c.c);
    } else if constexpr (Row == 2) {
      return quotient_nearest<S>(c.a, c.b);
    } else {
      return quotient_nearest<S>(c.a * c.b * c.c, c.d * c.a);
    }
  }
};

struct Text {
  static constexpr int capacity = 40;
  std::array<char, capacity> characters{};
  int length = 0;

  constexpr void add(char c) noexcept {
    if (length < capacity) characters[static_cast<std::size_t>(length++)] = c;
  }
  [[nodiscard]] constexpr std::string_view view() const noexcept {
    return {characters.data(), static_cast<std::size_t>(length)};
  }
};
/// Adds characters as ASCII bytes, after their count: the sign of `char` depends on the machine,
/// the byte does not.
template <class D>
constexpr void append(D& digest, const Text& text) noexcept {
  digest.add(static_cast<std::uint8_t>(text.length));
  for (const char c : text.view()) digest.add(static_cast<std::uint8_t>(c));
}

template <Scalar S, int N>
struct TextCase {
  Text text;
  S number;

  constexpr auto fields(const auto& f) const noexcept { return f(text, number); }
};

/// Decimals in every notation, malformed and out of range ones included; and numbers to print.
struct Texts : InDimensions<1> {
  static constexpr std::array<std::string_view, 2> names{"parse", "to_chars"};
  template <Scalar S, int N>
  static constexpr auto draw(Random& random) noexcept {
    Numbers<S> numbers(random);
    Text text;
    const auto digits = [&](std::int64_t most) {
      const auto count = random.between(0, most);
      const auto kind = random.below(8);
      for (std::int64_t i = 0; i < count; ++i) {
        text.add(static_cast<char>('0' + (kind == 0   ? 9
                                          : kind == 1 ? 0
                                                      : static_cast<int>(random.below(10)))));
      }
    };
    const auto sign = random.below(8);
    if (sign < 4) text.add(sign == 0 ? '+' : '-');
    digits((S::bits - S::frac) * 3 / 10 + 1);
    if (!random.one_in(8)) {
      text.add('.');
      digits(S::frac + 2);
    }
    if (random.one_in(8)) {
      text.add(random.coin() ? 'e' : 'E');
      if (random.coin()) text.add(random.coin() ? '-' : '+');
      text.add(static_cast<char>('0' + static_cast<int>(random.below(10))));
    }
    if (random.one_in(16)) text.add("+-.e x0"[random.below(7)]);
    return TextCase<S, N>{text, numbers.any()};
  }
  template <int Row, Scalar S, int N>
  [[nodiscard]] static constexpr auto answer(const TextCase<S, N>& c) noexcept {
    if constexpr (Row == 0) {
      return S::parse(c.text.view());
    } else {
      Text text;
      char* const first = text.characters.data();
      text.length = static_cast<int>(to_chars(first, first + Text::capacity, c.number) - first);
      return text;
    }
  }
};

}  // namespace detent::verify
