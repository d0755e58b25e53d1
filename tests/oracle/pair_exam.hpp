// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <sstream>
#include <type_traits>
#include <utility>

#include "oracle/describe.hpp"
#include "oracle/draw_shape.hpp"
#include "oracle/oracle_test.hpp"

namespace detent::oracle {

/// Whether two shapes overlap, by the library; segments have a separate query.
template <class A, class B>
bool ask(const A& a, const B& b) {
  return overlaps(a, b);
}
template <Scalar S, int N, class B>
bool ask(const Segment<S, N>& segment, const B& shape) {
  return intersects(segment, shape);
}

/// Whether the arguments may be swapped; a segment comes first.
template <class A, class B>
inline constexpr bool is_symmetric = true;
template <Scalar S, int N, class B>
inline constexpr bool is_symmetric<Segment<S, N>, B> = false;
template <Scalar S, int N>
inline constexpr bool is_symmetric<Segment<S, N>, Segment<S, N>> = true;

/// Runs pairs of shapes through the library, in both orders, and through the oracle, and keeps the
/// first few disagreements.
template <Scalar S, int N>
class PairExam {
 public:
  explicit PairExam(std::uint64_t seed) : draw(seed) {}

  Draw<S, N> draw;

  /// Runs `count` cases, each a pair of shapes from `generate`; of these, `low` to `high` percent
  /// must overlap.
  template <class Generate>
  void family(const char* name, long count, int low, int high, Generate generate) {
    test::HitRate rate;
    for (long i = 0; i < count; ++i) {
      const auto [a, b] = generate();
      const bool expected = meet(a, b);
      rate.count(expected);
      ++asked_;
      bool is_right = ask(a, b) == expected;
      if constexpr (is_symmetric<std::decay_t<decltype(a)>, std::decay_t<decltype(b)>>) {
        is_right = is_right && ask(b, a) == expected;
      }
      if (is_right || ++wrong_ > 5) continue;
      first_mistakes_ << name << ": " << describe(a) << "; " << describe(b) << "; expected "
                      << expected << "\n";
    }
    INFO(draw.random << ", " << name << ": " << rate);
    CHECK(rate.percent() >= low);
    CHECK(rate.percent() <= high);
  }

  void finish() {
    INFO(draw.random << ", " << asked_ << " cases, " << wrong_ << " wrong\n"
                     << first_mistakes_.str());
    CHECK(wrong_ == 0);
  }

 private:
  long asked_ = 0;
  long wrong_ = 0;
  std::ostringstream first_mistakes_;
};

/// The cases of an ordinary run in each space.
inline constexpr long pair_cases = 20'000;

/// The spread of centers, in percent of the shapes' size, at which about half of the random pairs
/// overlap; and the bounds on that rate, in percent.
struct Aim {
  int spread = 70;
  int low = 30;
  int high = 70;
};

/// The scalar and the dimension of a shape.
template <class Shape>
struct SpaceOf;
template <template <Scalar, int> class Shape, Scalar S, int N>
struct SpaceOf<Shape<S, N>> {
  using type = test::Space<S, N>;
};

/// Runs `count` random queries of every kind on pairs of the shapes A and B; `more(exam)` adds
/// further families.
template <class A, class B, class More>
void examine_pair(std::uint64_t seed, long count, Aim aim, const More& more) {
  using S = typename SpaceOf<A>::type::scalar;
  constexpr int N = SpaceOf<A>::type::dimension;
  PairExam<S, N> exam(seed);
  const auto family = [&](const char* name, Kind kind, int percent, int low, int high) {
    exam.family(name, count * percent / 100, low, high, [&] {
      const auto setting = draw_setting(exam.draw, kind, aim.spread);
      const auto a = draw_shape<A>(exam.draw, setting);
      const auto b = draw_shape<B>(exam.draw, setting);
      return std::pair{a, b};
    });
  };
  family("random", Kind::general, 40, aim.low, aim.high);
  family("lattice", Kind::lattice, 25, 1, 99);
  family("tiny", Kind::tiny, 10, 1, 99);
  family("extreme", Kind::extreme, 15, 0, 99);
  family("degenerate", Kind::degenerate, 10, 1, 99);
  more(exam);
  exam.finish();
}
template <class A, class B>
void examine_pair(std::uint64_t seed, long count, Aim aim = {}) {
  examine_pair<A, B>(seed, count, aim, [](auto&) {});
}

}  // namespace detent::oracle
