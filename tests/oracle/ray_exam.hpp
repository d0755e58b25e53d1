// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <utility>

#include "oracle/ask.hpp"
#include "oracle/describe.hpp"
#include "oracle/exam.hpp"

namespace detent::oracle {

using test::Space;

/// Runs random queries of rays in the library and in the oracle.
template <Scalar S, int N>
class RayExam : public Exam<RayExam<S, N>, S, N> {
 public:
  using Exam<RayExam<S, N>, S, N>::Exam, Exam<RayExam<S, N>, S, N>::draw;

  /// Runs a ray and a shape, and mostly the same case with the ray cut at the hit.
  template <class Shape>
  bool run(const char* name, std::pair<Ray<S, N>, Shape> drawn) {
    auto& [ray, shape] = drawn;
    const auto expected = expected_raycast(ray, shape);
    compare(name, ray, shape, expected);
    if (!expected.hit || draw.random.coin()) return expected.hit.has_value();
    const auto end = draw.random.coin() ? expected.hit->enter : expected.hit->exit;
    ray.max_distance = Draw<S, N>::scalar(end + draw.random.between(-1, 1));
    compare(name, ray, shape, expected_raycast(ray, shape));
    return true;
  }

 private:
  template <class Shape>
  void compare(const char* name, const Ray<S, N>& ray, const Shape& shape,
               const Expected<N>& expected) {
    auto found = mistakes(expected, ask(ray, shape));
    if constexpr (requires { detent::raycast(ray, shape, Facing::front); }) {
      const auto front = meets_front(ray, shape) ? expected : Expected<N>{};
      found += mistakes(front, ask(ray, shape, Facing::front));
    }
    this->count_case(found.empty(), [&](auto& out) {
      out << name << ": " << describe(ray) << "; " << describe(shape) << "\n" << found;
    });
  }
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

/// The two test cases of an oracle test whose cases the source draws for a RayExam.
#define DETENT_RAY_TEST(subject, seed, count, more) \
  DETENT_EXAMINE(RayExam)                           \
  DETENT_ORACLE_TEST(subject, seed, count, more)
