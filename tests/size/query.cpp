// SPDX-License-Identifier: MIT
//
// A program with a single query. Needs the macros HEADER, OPERATION, FIRST and SECOND (shapes) and
// SCALAR; also MOVES if the first shape moves.

#include HEADER

#include <optional>
#include <utility>

using namespace detent;

static bool report(bool answer, SCALAR&) { return answer; }
static bool report(const SCALAR& answer, SCALAR& distance) {
  distance = answer;
  return distance > 0;
}
template <class T>
static bool report(const std::pair<T, T>& answer, std::pair<T, T>& points) {
  points = answer;
  return points.first != points.second;
}
template <class T>
static bool report(const std::optional<T>& answer, T& found) {
  if (answer) found = *answer;
  return answer.has_value();
}

#if MOVES
using FirstShape = Cast<FIRST<SCALAR, 3>>;
#else
using FirstShape = FIRST<SCALAR, 3>;
#endif
using SecondShape = SECOND<SCALAR, 3>;

template <class>
struct OutputOf {
  using type = SCALAR;
};
template <class T>
struct OutputOf<std::pair<T, T>> {
  using type = std::pair<T, T>;
};
template <class T>
struct OutputOf<std::optional<T>> {
  using type = T;
};
using QueryAnswer = decltype(OPERATION(FirstShape(), SecondShape()));

extern "C" bool ask(const FirstShape& a, const SecondShape& b,
                    typename OutputOf<QueryAnswer>::type& found) {
  return report(OPERATION(a, b), found);
}
