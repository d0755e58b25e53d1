// SPDX-License-Identifier: MIT
//
// A program with a single query. Needs the macros HEADER, OPERATION, FIRST and SECOND (shapes),
// SCALAR.

#include HEADER

#include <optional>

using namespace detent;

static bool report(bool answer, SCALAR&) { return answer; }
static bool report(const std::optional<SCALAR>& answer, SCALAR& distance) {
  if (answer) distance = *answer;
  return answer.has_value();
}

extern "C" bool ask(const FIRST<SCALAR, 3>& a, const SECOND<SCALAR, 3>& b, SCALAR& distance) {
  return report(OPERATION(a, b), distance);
}
