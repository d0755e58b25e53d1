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

/// The times of one benchmark's repetitions, in nanoseconds a question.
class Times {
 public:
  void add(double nanoseconds) {
    values_.insert(std::upper_bound(values_.begin(), values_.end(), nanoseconds), nanoseconds);
  }
  [[nodiscard]] bool empty() const { return values_.empty(); }
  [[nodiscard]] double low() const { return quantile(1); }
  [[nodiscard]] double median() const { return quantile(2); }
  [[nodiscard]] double high() const { return quantile(3); }

 private:
  /// The k-th quartile, interpolated.
  [[nodiscard]] double quantile(std::size_t k) const {
    const std::size_t position = k * (values_.size() - 1);
    const double low = values_[position / 4];
    const double high = values_[std::min(position / 4 + 1, values_.size() - 1)];
    return low + (high - low) * static_cast<double>(position % 4) / 4;
  }

  std::vector<double> values_;
};

/// Everything that a run found out.
struct Results {
  struct Machine {
    std::string processor;
    std::string compiler;
    std::string date;
  };
  struct Ratio {
    double median;
    double spread;  // the quartiles of the two times divided farthest, half their distance
  };

  Machine machine;
  std::uint64_t seed = 0;
  std::size_t repetitions = 0;
  std::vector<Record> records;
  std::map<std::string, Times> times;  // by benchmark_name()

  [[nodiscard]] const Times* find(const std::string& query, const std::string& scalar,
                                  Manner manner) const {
    const auto found = times.find(benchmark_name(query, scalar, manner));
    return found == times.end() || found->second.empty() ? nullptr : &found->second;
  }
  /// The time of a scalar as a multiple of float's.
  [[nodiscard]] Ratio ratio(const Times& time, const Times& base) const {
    return {time.median() / base.median(),
            (time.high() / base.low() - time.low() / base.high()) / 2};
  }
};

void write_tables(std::FILE* out, const Results& results);
void write_json(std::FILE* out, const Results& results);
void write_plot(std::FILE* out, const Results& results);

}  // namespace detent::bench
