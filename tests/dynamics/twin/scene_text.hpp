// SPDX-License-Identifier: MIT
#pragma once

#include <cstdlib>
#include <iostream>
#include <string>

#include "detent/math/vec.hpp"
#include "detent/number/decimal.hpp"
#include "detent/number/fixed.hpp"

// Reads the numbers of scene files for the programs that play them.

namespace detent::test {

using S = q16_16;

[[noreturn]] inline void fail(const std::string& what) {
  std::cerr << "scene file: " << what << "\n";
  std::exit(2);
}

inline S number(std::istream& in) {
  std::string text;
  in >> text;
  const auto value = S::parse(text);
  if (!value) fail("not a number: " + text);
  return *value;
}

template <int N>
Vec<S, N> vector(std::istream& in) {
  Vec<S, N> v{};
  for (int i = 0; i < N; ++i) v[i] = number(in);
  return v;
}

}  // namespace detent::test
