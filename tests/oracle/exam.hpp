// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <sstream>
#include <utility>

#include "oracle/ask.hpp"
#include "oracle/describe.hpp"
#include "oracle/draw.hpp"
#include "oracle/oracle_test.hpp"

namespace detent::oracle {

using test::Space;

/// Runs random queries in the library and in the oracle, and keeps the first few disagreements.
template <Scalar S, int N>
class Exam {
 public:
  explicit Exam(std::uint64_t seed) : draw(seed) {}

  Draw<S, N> draw;

  /// Runs `count` cases, each a ray and a shape from `generate`, most followed by the same case
  /// with the ray cut at the hit. `low` to `high` percent of the cases as drawn must hit.
  template <class Generate>
  void family(const char* name, long count, int low, int high, Generate generate) {
    test::HitRate rate;
    for (long i = 0; i < count; ++i) {
      auto [ray, shape] = generate();
      const auto expected = expected_raycast(ray, shape);
      rate.count(expected.hit.has_value());
      compare(name, ray, shape, expected);
      if (!expected.hit || draw.random.coin()) continue;
      const auto& hit = *expected.hit;
      const auto end = draw.random.coin() ? hit.enter : hit.exit;
      ray.max_distance = Draw<S, N>::scalar(end + draw.random.between(-1, 1));
      compare(name, ray, shape, expected_raycast(ray, shape));
    }
    INFO(draw.random << ", " << name << ": " << rate);
    CHECK(rate.percent() >= low);
    CHECK(rate.percent() <= high);
    summary_ << "  " << name << ": " << rate << "\n";
  }

  /// Requires that there was no disagreement and that at least `least` queries were run.
  void finish(long least) {
    INFO(draw.random << "\n" << summary_.str() << first_mistakes_.str());
    CHECK(asked_ >= least);
    CHECK(wrong_ == 0);
  }

 private:
  template <class Shape>
  void compare(const char* name, const Ray<S, N>& ray, const Shape& shape,
               const Expected<N>& expected) {
    ++asked_;
    auto found = mistakes(expected, ask(ray, shape));
    if constexpr (requires { detent::raycast(ray, shape, Facing::front); }) {
      const auto front = meets_front(ray, shape) ? expected : Expected<N>{};
      found += mistakes(front, ask(ray, shape, Facing::front));
    }
    if (found.empty() || ++wrong_ > 5) return;
    first_mistakes_ << name << ": " << describe(ray) << "; " << describe(shape) << "\n" << found;
  }

  long asked_ = 0;
  long wrong_ = 0;
  std::ostringstream summary_;
  std::ostringstream first_mistakes_;
};

#if defined(__has_feature)
#if __has_feature(address_sanitizer)
#define DETENT_SANITIZED 1
#endif
#endif
#ifndef DETENT_SANITIZED
#define DETENT_SANITIZED 0
#endif

/// The cases of an ordinary run: a million in the most used space, fewer elsewhere, and a tenth
/// under sanitizers, where a case takes tens of times as long.
template <class Space>
inline constexpr long cases = DETENT_SANITIZED ? 20'000 : 200'000;
template <>
inline constexpr long cases<Space<q16_16, 3>> = DETENT_SANITIZED ? 100'000 : 1'000'000;

}  // namespace detent::oracle
