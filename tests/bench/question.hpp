// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "bench/draw.hpp"
#include "bench/golden.hpp"

namespace detent::bench {

inline constexpr std::uint64_t default_seed = 20260101;
inline constexpr std::size_t question_count = 4096;

/// A query with its name, the types of its two shapes, as templates on the scalar, and its golden
/// counts of hits, if it has some.
template <template <class, int> class A, template <class, int> class B, int N, class Ask>
struct Query {
  static constexpr int dimension = N;
  std::string_view name;
  Ask ask;
  std::optional<Golden> golden;

  template <class S>
  using First = A<S, N>;
  template <class S>
  using Second = B<S, N>;
  template <class S>
  using Question = std::pair<First<S>, Second<S>>;

  template <class S>
  auto operator()(const Question<S>& question) const {
    return ask(question.first, question.second);
  }
};

template <template <class, int> class A, template <class, int> class B, int N = 3, class Ask>
constexpr Query<A, B, N, Ask> query(std::string_view name, const Ask& ask) {
  return {name, ask, {}};
}
template <template <class, int> class A, template <class, int> class B, int N = 3, class Ask>
constexpr Query<A, B, N, Ask> query(std::string_view name, const Ask& ask, const Golden& golden) {
  return {name, ask, golden};
}

inline bool is_hit(bool answer) { return answer; }
template <class T>
bool is_hit(const std::optional<T>& answer) {
  return answer.has_value();
}
/// A camera sees along a ray at every pixel.
template <Scalar S, int N>
bool is_hit(const Ray<S, N>&) {
  return true;
}
/// Distances and closest points have no misses: a hit is a distance > 0.
template <Scalar S>
bool is_hit(const S& distance) {
  return distance > 0;
}
template <Scalar S, int N>
bool is_hit(const std::pair<Vec<S, N>, Vec<S, N>>& closest) {
  return closest.first != closest.second;
}

/// Whether the result for `question` is a hit.
template <class S, class Q>
bool hits(const Q& query, const typename Q::template Question<S>& question) {
  const auto answer = query.template operator()<S>(question);
  if constexpr (std::is_same_v<std::remove_cvref_t<decltype(answer)>, Vec<S, Q::dimension>>) {
    return answer != question.second;
  } else {
    return is_hit(answer);
  }
}

/// Calls `visit` with every index below Count.
template <int Count, class Visit>
void for_each_index(const Visit& visit) {
  [&]<int... Index>(std::integer_sequence<int, Index...>) {
    (visit.template operator()<Index>(), ...);
  }
  (std::make_integer_sequence<int, Count>());
}

/// Whether `query` misses for some inputs.
template <class Q>
inline constexpr bool can_miss =
    !std::is_same_v<decltype(std::declval<const Q&>().template operator()<double>(
                        std::declval<typename Q::template Question<double>>())),
                    Ray<double, 3>>;

/// The inputs for `query`, in double. About half of them are hits in double, except where shapes
/// without volume make hits improbable.
template <class Q>
std::vector<typename Q::template Question<double>> draw_questions(const Q& query,
                                                                  std::uint64_t seed, Scale scale) {
  constexpr int patience = 64;
  Artist<Q::dimension> artist(seed, scale);
  std::vector<typename Q::template Question<double>> questions(question_count);
  for (auto& question : questions) {
    const bool wanted = artist.coin();
    for (int i = 0; i < patience; ++i) {
      artist.next_scene();
      artist.draw(question.first);
      artist.draw(question.second);
      if (!can_miss<Q> || hits<double>(query, question) == wanted) break;
    }
  }
  return questions;
}

template <class S, class Q>
auto as_questions(const Q&, const std::vector<typename Q::template Question<double>>& drawn) {
  std::vector<typename Q::template Question<S>> questions;
  questions.reserve(drawn.size());
  for (const auto& [a, b] : drawn) questions.emplace_back(as<S>(a), as<S>(b));
  return questions;
}

/// q8_8 has room only for small scenes.
template <class S>
inline constexpr Scale scale_for = bits_of<S> == 15 ? small : ordinary;

template <class S, class Q>
std::size_t count_hits(const Q& query,
                       const std::vector<typename Q::template Question<S>>& questions) {
  std::size_t count = 0;
  for (const auto& question : questions) count += hits<S>(query, question) ? 1u : 0u;
  return count;
}

}  // namespace detent::bench
