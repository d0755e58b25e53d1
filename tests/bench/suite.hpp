// SPDX-License-Identifier: MIT
#pragma once

#include <benchmark/benchmark.h>

#include <algorithm>
#include <bit>
#include <chrono>
#include <cmath>
#include <cstring>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "bench/accuracy.hpp"
#include "bench/queries.hpp"
#include "support/scalars.hpp"

namespace detent::bench {

template <class S>
inline const std::string scalar_name{support::scalar_name<S>};

/// Double in hardware: the baseline of operations without a counterpart in float.
inline const std::string hardware = "double in hardware";

/// The order in which queries run.
enum class Manner {
  shuffled,  // independent queries, hits and misses mixed in an order that changes every pass
  sorted,    // independent queries, hits first, so that the processor predicts every branch
  chained,   // shuffled, and the position of each input depends on the previous result
};
inline constexpr Manner manners[] = {Manner::shuffled, Manner::sorted, Manner::chained};
inline std::string name_of(Manner manner) {
  return manner == Manner::shuffled ? "shuffled" : manner == Manner::sorted ? "sorted" : "chained";
}

inline std::string benchmark_name(const std::string& query, const std::string& scalar,
                                  Manner manner) {
  return query + '|' + scalar + '|' + name_of(manner);
}

/// The data of one query in one scalar, except its times.
struct Record {
  std::string query;
  std::string scalar;
  std::size_t hits;
  std::size_t expected;  // hits of the exact results
  bool is_exact;         // must have the expected number
  Accuracy accuracy;
};

/// The low bits of a result, on which the next query of a chain depends.
template <class Answer>
std::uint32_t bits_of_answer(const Answer& answer) {
  std::uint32_t bits = 0;
  std::memcpy(&bits, &answer, std::min(sizeof bits, sizeof answer));
  return bits;
}

/// Zero, unknown to the compiler.
inline volatile std::uint32_t always_zero = 0;

/// Makes some passes over all inputs. Returns nanoseconds per query.
using Turn = std::function<double()>;

/// Calls `pass` once to warm up, then twice for timing.
template <class Pass>
double take_turn(const Pass& pass) {
  constexpr int passes = 2;
  using Clock = std::chrono::steady_clock;
  pass();
  const auto start = Clock::now();
  for (int i = 0; i < passes; ++i) pass();
  const std::chrono::duration<double, std::nano> time = Clock::now() - start;
  return time.count() / (passes * question_count);
}

/// Turns of `ask(questions[i])` over all inputs in the given order.
template <class Question, class Ask>
Turn turn_of(std::shared_ptr<const std::vector<Question>> questions, const Ask& ask,
             Manner manner) {
  static_assert((question_count & (question_count - 1)) == 0);
  constexpr std::uint32_t mask = question_count - 1;
  // An odd stride visits every input once. A new stride per pass keeps the branch predictor from
  // learning the results.
  std::uint32_t stride = 1, first = 0;
  return [questions, ask, manner, stride, first]() mutable {
    return take_turn([&] {
      if (manner != Manner::sorted) stride = (stride * 1664525 + 1013904223) | 1;
      // Copied to locals, because captured variables are not in registers.
      const Question* const from = questions->data();
      const std::uint32_t step = stride, zero = always_zero;
      std::uint32_t at = first;
      if (manner == Manner::chained) {
        for (std::uint32_t i = 0; i < question_count; ++i) {
          const auto answer = ask(from[at & mask]);
          at += step + (bits_of_answer(answer) & zero);
        }
      } else {
        for (std::uint32_t i = 0; i < question_count; ++i, at += step) {
          auto answer = ask(from[at & mask]);
          benchmark::DoNotOptimize(answer);
        }
      }
      first = at;
    });
  };
}

/// The turns of all contestants in one query. They alternate, so that whatever slows the machine
/// down slows all of them.
struct Row {
  std::string query;
  Manner manner;
  std::vector<std::pair<std::string, Turn>> turns;  // of a scalar, or of another library
};

/// The queries of a run and their data.
class Suite {
 public:
  explicit Suite(std::uint64_t seed) : seed_(seed) {}

  [[nodiscard]] std::uint64_t seed() const { return seed_; }
  [[nodiscard]] const std::vector<Record>& records() const { return records_; }
  [[nodiscard]] const std::vector<Row>& rows() const { return rows_; }

  /// Adds `query` in every scalar.
  template <class Q>
  void operator()(const Q& query) {
    add_scalars(query, support::ScalarList<float, double, q16_16, q14_16, q24_8, q8_8>());
  }
  /// Adds `query` only in the most interesting scalars, because it takes long to compile.
  template <class Q>
  void add_pair(const Q& query) {
    add_scalars(query, support::ScalarList<float, double, q16_16, q8_8>());
  }

  /// Adds `query` in some scalars.
  template <class Q, class Scalars>
  void add_scalars(const Q& query, Scalars scalars) {
    const auto ordinary_questions = draw_questions(query, seed_, ordinary);
    const auto small_questions = draw_questions(query, seed_, small);
    const auto golden = seed_ == default_seed ? query.golden : std::nullopt;
    const auto add_scalar = [&]<class S>(S) {
      constexpr bool is_small = scale_for<S>.reach == small.reach;
      const auto& drawn = is_small ? small_questions : ordinary_questions;
      auto questions = as_questions<S>(query, drawn);
      const auto hit_count = count_hits<S>(query, questions);
      const auto exact = as_questions<q16_16>(query, drawn);
      const auto expected = !golden    ? count_hits<q16_16>(query, exact)
                            : is_small ? golden->small
                                       : golden->ordinary;
      records_.push_back({std::string(query.name), scalar_name<S>, hit_count, expected, is_fixed<S>,
                          accuracy_of<S>(query, drawn)});
      add(
          std::string(query.name), scalar_name<S>, std::move(questions),
          [query](const auto& question) { return query.template operator()<S>(question); },
          [query](const auto& question) { return hits<S>(query, question); });
    };
    support::for_each_scalar(scalars, add_scalar);
  }

  /// Adds a function of ours or of another library under the names of a query and a scalar.
  void add_record(const Record& record) { records_.push_back(record); }
  template <class Question, class Ask, class IsHit>
  void add(const std::string& query, const std::string& scalar, std::vector<Question> questions,
           const Ask& ask, const IsHit& is_hit) {
    auto sorted = std::make_shared<std::vector<Question>>(questions);
    std::stable_partition(sorted->begin(), sorted->end(), is_hit);
    const auto shuffled = std::make_shared<const std::vector<Question>>(std::move(questions));
    for (const Manner manner : manners) {
      const std::shared_ptr<const std::vector<Question>> chosen =
          manner == Manner::sorted ? sorted : shuffled;
      add_turn(query, scalar, manner, turn_of<Question>(chosen, ask, manner));
    }
  }
  void add_turn(const std::string& query, const std::string& scalar, Manner manner, Turn turn) {
    auto row = std::find_if(rows_.begin(), rows_.end(), [&](const Row& known) {
      return known.query == query && known.manner == manner;
    });
    if (row == rows_.end()) row = rows_.insert(rows_.end(), {query, manner, {}});
    row->turns.emplace_back(scalar, std::move(turn));
  }

 private:
  std::uint64_t seed_;
  std::vector<Record> records_;
  std::vector<Row> rows_;
};

// Each in its own source file, because every query takes long to compile, and the compiler's
// inlining is limited in a large source.
/// What another library's answer means next to the exact one.
struct Judged {
  bool should_hit, does_hit;
  double error;  // if both hit
  bool counts = true;
};

/// Times `ask` of another library, and compares it with exact results: judge(exact, ask(question))
/// is a `Judged`.
template <class Q, class Question, class Ask, class Judge, class IsHit>
void add_other(Suite& suite, const Q& query, const std::string& library,
               const std::vector<typename Q::template Question<double>>& drawn,
               const std::vector<Question>& questions, const Ask& ask, const Judge& judge,
               const IsHit& is_hit) {
  Accuracy accuracy;
  std::size_t hit_count = 0, expected = 0;
  for (std::size_t i = 0; i < questions.size(); ++i) {
    const auto exact = query.template operator()<q16_16>(
        std::pair{as<q16_16>(drawn[i].first), as<q16_16>(drawn[i].second)});
    const Judged judged = judge(exact, ask(questions[i]));
    if (!judged.counts) continue;
    ++accuracy.asked;
    accuracy.wrong += judged.should_hit != judged.does_hit ? 1u : 0u;
    hit_count += judged.does_hit ? 1u : 0u;
    expected += judged.should_hit ? 1u : 0u;
    if (judged.should_hit && judged.does_hit) {
      accuracy.error = std::max(accuracy.error, judged.error);
    }
  }
  suite.add_record({std::string(query.name), library, hit_count, expected, false, accuracy});
  suite.add(std::string(query.name), library, questions, ask,
            [ask, is_hit](const Question& question) { return is_hit(ask(question)); });
}

void add_raycasts(Suite& suite);
void add_raycast_hits(Suite& suite);
void add_contains(Suite& suite);
void add_closest_points(Suite& suite);
void add_distances(Suite& suite);
void add_sphere_overlaps(Suite& suite);
void add_box_overlaps(Suite& suite);
void add_other_overlaps(Suite& suite);
void add_intersects(Suite& suite);
void add_hulls(Suite& suite);
void add_planar(Suite& suite);
void add_cameras(Suite& suite);
void add_batches(Suite& suite);
void add_baselines(Suite& suite);
void add_engines(Suite& suite);
void add_peers(Suite& suite);

}  // namespace detent::bench
