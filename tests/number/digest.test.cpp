// SPDX-License-Identifier: MIT
#include "detent/number/digest.hpp"

#include <xxhash.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "number/big_integer.hpp"
#include "support/catch.hpp"

using namespace detent;
using namespace detent::test;

namespace other {

// An aggregate of another namespace, defined before digest.hpp is included.
struct Pair {
  q16_16 first;
  std::optional<bool> second;
};

template <class D>
constexpr void append(D& digest, const Pair& pair) noexcept {
  digest.add(pair.first, pair.second);
}

struct Opaque {};
enum class Id : std::uint16_t {};

}  // namespace other

namespace {

constexpr std::uint64_t digest_of_text(std::string_view text, std::uint64_t seed = 0) {
  Digest running(seed);
  for (const char c : text) running.add(static_cast<std::uint8_t>(c));
  return running.value();
}

// Published values of XXH64; other inputs are compared with the reference implementation below.
static_assert(Digest().value() == 0xef46db3751d8e999u);
static_assert(std::array<Digest, 2>{}[1].value() == Digest().value());
static_assert(!std::is_convertible_v<std::uint64_t, Digest>);
static_assert(digest_of_text("a") == 0xd24ec4f1a98c6e5bu);
static_assert(digest_of_text("abc") == 0x44bc2cf5ad770999u);

template <class... Bytes>
constexpr std::uint64_t digest_of_bytes(Bytes... bytes) {
  Digest running;
  running.add(static_cast<std::uint8_t>(bytes)...);
  return running.value();
}

static_assert(digest(std::uint8_t{0x12}) == digest_of_bytes(0x12));
static_assert(digest(std::uint16_t{0x1234}) == digest_of_bytes(0x34, 0x12));
static_assert(digest(std::int32_t{-2}) == digest_of_bytes(0xfe, 0xff, 0xff, 0xff));
static_assert(digest(std::uint64_t{0x123456789abcdef0u}) ==
              digest_of_bytes(0xf0, 0xde, 0xbc, 0x9a, 0x78, 0x56, 0x34, 0x12));
static_assert(digest(true) == digest_of_bytes(1) && digest(false) == digest_of_bytes(0));
static_assert(digest(1.0f) == digest_of_bytes(0, 0, 0x80, 0x3f));
static_assert(digest(-0.0) == digest_of_bytes(0, 0, 0, 0, 0, 0, 0, 0x80));
static_assert(digest(q16_16(1)) == digest_of_bytes(0, 0, 1, 0));
static_assert(digest(q14_16(-1)) == digest_of_bytes(0, 0, 0xff, 0xff));
static_assert(digest(q8_8(1)) == digest_of_bytes(0, 1));
static_assert(digest(Fixed<40, 32>(1)) == digest_of_bytes(0, 0, 0, 0, 1, 0, 0, 0));
static_assert(digest(std::optional<bool>()) == digest_of_bytes(0));
static_assert(digest(std::optional(q8_8(1))) == digest_of_bytes(1, 0, 1));
static_assert(digest(std::array{q8_8(1), q8_8(2)}) == digest_of_bytes(0, 1, 0, 2));
static_assert(digest(std::array<std::optional<std::uint8_t>, 2>{std::nullopt, 7}) ==
              digest_of_bytes(0, 1, 7));
static_assert(digest(other::Pair{q16_16(1), true}) == digest_of_bytes(0, 0, 1, 0, 1, 1));
static_assert(digest(std::optional(other::Pair{})) == digest_of_bytes(1, 0, 0, 0, 0, 0));
static_assert(digest(other::Id{0x102}) == digest_of_bytes(2, 1));
static_assert(Digestible<other::Pair> && !Digestible<other::Opaque> && !Digestible<const char*>);

// 127 bits are two words, 200 are four: the same bytes with either 128-bit integer.
static_assert(digest(Fixed<127, 0>(-2)) ==
              digest(std::array{~std::uint64_t{1}, ~std::uint64_t{0}}));
static_assert(digest(Fixed<200, 64>(3)) == digest(std::array<std::uint64_t, 4>{0, 3, 0, 0}));

std::vector<std::byte> random_bytes(Random& random, std::size_t length) {
  std::vector<std::byte> bytes(length);
  for (auto& byte : bytes) byte = static_cast<std::byte>(random.next());
  return bytes;
}

}  // namespace

TEST_CASE("digest: is XXH64 for every length and seed", "[number]") {
  Random random(0xd16e57);
  INFO(random);
  for (std::size_t length = 0; length < 2'000; ++length) {
    const auto bytes = random_bytes(random, length);
    const std::uint64_t seed = random.coin() ? 0 : random.next();
    Digest running(seed);
    running.add_bytes(bytes);
    INFO("length " << length << ", seed " << seed);
    REQUIRE(running.value() == XXH64(bytes.data(), length, seed));
  }
}

TEST_CASE("digest: does not depend on how the bytes were split", "[number]") {
  Random random(0xd16e58);
  INFO(random);
  for (int i = 0; i < 20'000; ++i) {
    const auto bytes = random_bytes(random, random.below(300));
    Digest running;
    std::size_t at = 0;
    while (at < bytes.size()) {
      // A number of one of the four widths, or some bytes.
      const auto left = bytes.size() - at;
      std::size_t count = std::size_t{1} << random.below(4);
      if (random.one_in(5) || count > left) {
        count = random.below(left + 1);
        running.add_bytes(std::span(bytes).subspan(at, count));
      } else {
        std::uint64_t word = 0;
        for (std::size_t k = count; k-- > 0;) {
          word = (word << 8) | std::to_integer<std::uint64_t>(bytes[at + k]);
        }
        switch (count) {
          case 1:
            running.add(static_cast<std::uint8_t>(word));
            break;
          case 2:
            running.add(static_cast<std::int16_t>(word));
            break;
          case 4:
            running.add(static_cast<std::uint32_t>(word));
            break;
          default:
            running.add(static_cast<std::int64_t>(word));
            break;
        }
      }
      at += count;
      if (random.one_in(3)) {  // reading the value does not change the state
        REQUIRE(running.value() == XXH64(bytes.data(), at, 0));
      }
    }
    REQUIRE(running.value() == XXH64(bytes.data(), bytes.size(), 0));
  }
}

TEMPLATE_TEST_CASE("digest: a Fixed is the little-endian bytes of its container", "[number]", q8_8,
                   q14_16, q16_16, q24_8, (Fixed<63, 30>), (Fixed<100, 40>), (Fixed<127, 0>),
                   (Fixed<200, 90>), (Fixed<300, 0>)) {
  Random random(0xd16e59);
  INFO(random);
  for (int i = 0; i < 2'000; ++i) {
    const auto x = random_fixed<TestType>(random);
    BigInteger pattern = big_raw(x);
    if (pattern < 0) pattern += power_of_two(8 * static_cast<int>(sizeof(TestType)));
    std::vector<unsigned char> bytes(sizeof(TestType));
    for (auto& byte : bytes) {
      byte = static_cast<unsigned char>(pattern & 0xff);
      pattern >>= 8;
    }
    INFO(big_raw(x));
    REQUIRE(digest(x) == XXH64(bytes.data(), bytes.size(), 0));
  }
}
