// SPDX-License-Identifier: MIT
//
// The portable wide integers agree with the compiler's 128-bit integer and, beyond its width, with
// Boost modulo the size.

#include <boost/multiprecision/cpp_int.hpp>

#include "detent/number/divide.hpp"
#include "detent/number/root.hpp"
#include "source.hpp"

namespace detent::fuzz {
namespace {

using Big = boost::multiprecision::cpp_int;

template <int Words>
Big exact(const Wide<Words>& x) {
  Big result = 0;
  for (int i = Words - 1; i >= 0; --i) result = (result << 64) + x.word(i);
  return x.is_negative() ? Big(result - (Big(1) << (64 * Words))) : result;
}

/// `x` modulo 2^(64 Words), of either sign.
template <int Words>
Wide<Words> reduced(Big x) {
  const Big one = Big(1) << (64 * Words);
  x %= one;
  if (x < 0) x += one;
  std::array<std::uint64_t, Words> words{};
  for (auto& word : words) {
    word = static_cast<std::uint64_t>(x & ~std::uint64_t{0});
    x >>= 64;
  }
  return Wide<Words>::from_words(words);
}

/// Words of zeros, of ones or of random bits, so that carries propagate far.
template <int Words>
Wide<Words> read(Source& source) {
  std::array<std::uint64_t, Words> words{};
  for (auto& word : words) {
    switch (source.below(4)) {
      case 0:
        word = 0;
        break;
      case 1:
        word = ~std::uint64_t{0};
        break;
      case 2:
        word = std::uint64_t{1} << source.below(64);
        break;
      default:
        word = source.word();
    }
  }
  return Wide<Words>::from_words(words);
}

void require_that(bool holds, const char* what) {
  require(holds, [&] { return std::string(what); });
}

template <int Words>
void check(Source& source) {
  const auto a = read<Words>(source), b = read<Words>(source);
  const Big x = exact(a), y = exact(b);
  const int count = static_cast<int>(source.word(2) % (std::uint64_t{64} * Words));
  require_that(a + b == reduced<Words>(x + y), "a + b");
  require_that(a - b == reduced<Words>(x - y), "a - b");
  require_that(-a == reduced<Words>(-x), "-a");
  require_that(a * b == reduced<Words>(x * y), "a * b");
  require_that(multiply<Words + 2>(a, b) == reduced<Words + 2>(x * y), "multiply");
  const auto word = static_cast<std::int64_t>(b.word(0));
  require_that(wrapping_multiply<Wide<Words + 2>>(a, word) == reduced<Words + 2>(x * word) &&
                   wrapping_multiply<Wide<Words + 2>>(word, a) == reduced<Words + 2>(x * word),
               "product with a word");
  require_that((a << count) == reduced<Words>(x << count), "a << count");
  const Big one = Big(1) << count;
  Big down = x / one;
  if (x < 0 && down * one != x) --down;
  require_that((a >> count) == reduced<Words>(down), "a >> count");
  require_that((a < b) == (x < y) && (a == b) == (x == y), "a < b");
  require_that(bit_length(a) == (x == 0 ? 0 : static_cast<int>(msb(x < 0 ? Big(-x) : x)) + 1),
               "bit_length");
  require_that(low_bits_are_zero(a, count) == (down * one == x), "low_bits_are_zero");
  // The smallest number divided by -1 is not representable; no caller divides by a negative number.
  if (y > 0) {
    const auto division = divide_floor(a, b);
    Big quotient = x / y;
    if (x < 0 && quotient * y != x) --quotient;
    require_that(division.quotient == reduced<Words>(quotient), "quotient");
    require_that(division.remainder == reduced<Words>(x - quotient * y), "remainder");
  }
}

void check_root(Source& source) {
  const auto a = read<2>(source);
  const Big x = (Big(a.word(1)) << 64) + a.word(0);
  require_that(square_root_floor(a.word(1), a.word(0)) == sqrt(x), "root");
}

#if DETENT_NATIVE_INT128
Int128 native(const Wide<2>& a) { return static_cast<Int128>(a); }

void check_native(Source& source) {
  const auto a = read<2>(source), b = read<2>(source);
  const auto x = native(a), y = native(b);
  const int count = static_cast<int>(source.below(128));
  require_that(native(a + b) == wrapping_add<Int128>(x, y), "native a + b");
  require_that(native(a - b) == wrapping_subtract<Int128>(x, y), "native a - b");
  require_that(native(a * b) == wrapping_multiply<Int128>(x, y), "native a * b");
  require_that(native(a << count) == shift_left(x, count), "native a << count");
  require_that(native(a >> count) == shift_right_floor(x, count), "native a >> count");
  require_that((a <=> b) == (x <=> y), "native a <=> b");
  require_that(bit_length(a) == bit_length(x) && sign_of(a) == sign_of(x), "native bit_length");
  const auto s = static_cast<std::int64_t>(a.word(0)), t = static_cast<std::int64_t>(b.word(0));
  require_that(native(wrapping_multiply<Wide<2>>(s, t)) == static_cast<Int128>(s) * t,
               "native product of words");
  const auto [low, high] = multiply_words_portable(a.word(0), b.word(0));
  const auto product = static_cast<UInt128>(a.word(0)) * b.word(0);
  require_that(low == static_cast<std::uint64_t>(product) &&
                   high == static_cast<std::uint64_t>(product >> 64),
               "multiply_words");
  if (y > 0) {
    const auto portable = divide_floor(a, b);
    const auto built_in = divide_floor(x, y);
    require_that(native(portable.quotient) == built_in.quotient, "native quotient");
    require_that(native(portable.remainder) == built_in.remainder, "native remainder");
  }
}
#else
void check_native(Source&) {}
#endif

}  // namespace

void property(Bytes input) {
  Source source(input);
  switch (source.below(5)) {
    case 0:
      return check<2>(source);
    case 1:
      return check<4>(source);
    case 2:
      return check<5>(source);
    case 3:
      return check_root(source);
    default:
      return check_native(source);
  }
}

}  // namespace detent::fuzz
