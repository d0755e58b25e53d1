// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <type_traits>
#include <utility>

#include "oracle/describe.hpp"
#include "oracle/draw_shape.hpp"
#include "oracle/exam.hpp"

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

/// Runs pairs of shapes through the library, in both orders, and through the oracle.
template <Scalar S, int N>
class PairExam : public Exam<PairExam<S, N>, S, N> {
 public:
  using Exam<PairExam<S, N>, S, N>::Exam;

  /// Runs two shapes, which hit where they overlap.
  template <class A, class B>
  bool run(const char* name, const std::pair<A, B>& drawn) {
    const auto& [a, b] = drawn;
    const bool expected = meet(a, b);
    bool is_right = ask(a, b) == expected;
    if constexpr (is_symmetric<A, B>) is_right = is_right && ask(b, a) == expected;
    this->count_case(is_right, [&, &a = a, &b = b](auto& out) {
      out << name << ": " << describe(a) << "; " << describe(b) << "; expected " << expected
          << "\n";
    });
    return expected;
  }
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

/// Lines through a common point.
template <Scalar S, int N>
class Pencil {
 public:
  explicit Pencil(Draw<S, N>& draw)
      : draw_(draw),
        reach_(std::min(draw.scale(), draw.limit / 16)),
        common_(draw.point(draw.limit / 4)) {}

  Raw<N> way() const { return draw_.point(reach_); }
  /// `from` to `to` times `way` from the common point; off the line by a raw unit now and then.
  Vec<S, N> point(const Raw<N>& way, std::int64_t from, std::int64_t to) const {
    const auto exact = draw_.plus(common_, way, draw_.random.between(from, to));
    return draw_.vec(draw_.random.one_in(8) ? draw_.near(exact, 1) : exact);
  }

 private:
  Draw<S, N>& draw_;
  std::int64_t reach_;
  Raw<N> common_;
};

/// Runs `count` random queries of every kind on pairs of the shapes A and B; `more(exam, draw,
/// random)` adds further families.
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
  more(exam, exam.draw, exam.draw.random);
  exam.finish(count);
}
/// Calls examine(a, b) for `count` random pairs, of which a tenth must be apart. It returns whether
/// they are, or nothing after a failure, which ends the loop.
template <class A, class B, Scalar S, int N, class Examine>
void examine_apart(Draw<S, N>& draw, Kind kind, long count, const Examine& examine) {
  long apart = 0;
  for (long i = 0; i < count; ++i) {
    const auto setting = any_setting(draw, kind, 150);
    const auto a = draw_shape<A>(draw, setting);
    const auto b = draw_shape<B>(draw, setting);
    const std::optional<bool> is_apart = examine(a, b);
    if (!is_apart) return;
    apart += *is_apart ? 1 : 0;
  }
  INFO(draw.random);
  CHECK(apart >= (std::is_same_v<A, Plane<S, N>> && std::is_same_v<A, B> ? 1 : count / 10));
}

template <class A, class B>
void examine_pair(std::uint64_t seed, long count, Aim aim = {}) {
  examine_pair<A, B>(seed, count, aim, [](auto&...) {});
}

}  // namespace detent::oracle
