// SPDX-License-Identifier: MIT
#pragma once

#include "oracle/seeds.hpp"
#include "oracle/space.hpp"
#include "support/catch.hpp"

/// Defines examine<S, N>(seed, cases) for DETENT_ORACLE_TEST: an `Exam<S, N>` of the cases that the
/// source's draw_cases(exam, draw, random, cases) draws.
#define DETENT_EXAMINE(Exam)                              \
  template <Scalar S, int N>                              \
  void examine(std::uint64_t seed, long count) {          \
    Exam<S, N> exam(seed);                                \
    draw_cases(exam, exam.draw, exam.draw.random, count); \
    exam.finish(count);                                   \
  }

/// Two test cases that compare every answer of a query with the oracle's, by the function template
/// examine<S, N>(seed, cases) of the source: `count` cases from one seed, and on demand `more`
/// cases from each of demanded_seeds(). The counts may name TestType, the space.
#define DETENT_ORACLE_TEST(subject, seed, count, more)                                             \
  TEMPLATE_TEST_CASE(subject ": every answer is the exact one", "[oracle]", DETENT_FIXED_SPACES) { \
    examine<typename TestType::scalar, TestType::dimension>(seed, count);                          \
  }                                                                                                \
  TEMPLATE_TEST_CASE(subject ": many more answers are exact", "[oracle][.demand]",                 \
                     DETENT_FIXED_SPACES) {                                                        \
    for (const auto demanded : demanded_seeds()) {                                                 \
      examine<typename TestType::scalar, TestType::dimension>(demanded, more);                     \
    }                                                                                              \
  }
