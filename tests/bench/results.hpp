// SPDX-License-Identifier: MIT
#pragma once

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <map>
#include <string>
#include <vector>

#include "bench/suite.hpp"

namespace detent::bench {

/// Nanoseconds per query, or their ratios, one per turn.
class Times {
 public:
  Times() = default;
  /// The times of turns as multiples of the same turns of `base`.
  Times(const Times& times, const Times& base) {
    const std::size_t count = std::min(times.values_.size(), base.values_.size());
    for (std::size_t i = 0; i < count; ++i) add(times.values_[i] / base.values_[i]);
  }

  void add(double value) { values_.push_back(value); }
  [[nodiscard]] bool empty() const { return values_.empty(); }
  [[nodiscard]] double low() const { return quantile(1); }
  [[nodiscard]] double median() const { return quantile(2); }
  [[nodiscard]] double high() const { return quantile(3); }

 private:
  /// The k-th quartile, interpolated.
  [[nodiscard]] double quantile(std::size_t k) const {
    auto sorted = values_;
    std::sort(sorted.begin(), sorted.end());
    const std::size_t position = k * (sorted.size() - 1);
    const double low = sorted[position / 4];
    const double high = sorted[std::min(position / 4 + 1, sorted.size() - 1)];
    return low + (high - low) * static_cast<double>(position % 4) / 4;
  }

  std::vector<double> values_;
};

/// All results of a run.
struct Results {
  struct Machine {
    std::string processor;
    std::string compiler;
    std::string date;
  };
  struct Ratio {
    double median;
    double spread;  // half the interquartile range
  };

  Machine machine;
  std::uint64_t seed = 0;
  std::vector<Record> records;
  std::map<std::string, Times> times;  // by benchmark_name()

  [[nodiscard]] const Times* find(const std::string& query, const std::string& scalar,
                                  Manner manner) const {
    const auto found = times.find(benchmark_name(query, scalar, manner));
    return found == times.end() || found->second.empty() ? nullptr : &found->second;
  }
  /// The time of a scalar as a multiple of float's, turn by turn.
  [[nodiscard]] Ratio ratio(const Times& time, const Times& base) const {
    const Times multiples(time, base);
    return {multiples.median(), (multiples.high() - multiples.low()) / 2};
  }
};

void write_tables(std::FILE* out, const Results& results);
/// docs/data/speed.csv.
void write_csv(std::FILE* out, const Results& results);
void write_plot(std::FILE* out, const Results& results);

}  // namespace detent::bench
