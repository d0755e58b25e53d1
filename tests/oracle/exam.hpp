// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <sstream>

#include "oracle/draw.hpp"
#include "oracle/oracle_test.hpp"

namespace detent::oracle {

/// Runs random cases through the library and the oracle, and keeps the first few disagreements.
/// `Kind` is the class derived from it, whose run(name, case) runs one and returns whether it hits.
template <class Kind, Scalar S, int N>
class Exam {
 public:
  explicit Exam(std::uint64_t seed) : draw(seed) {}

  Draw<S, N> draw;

  /// Runs `count` cases from `generate`, of which `low` to `high` percent must hit.
  template <class Generate>
  void family(const char* name, long count, int low, int high, Generate generate) {
    test::HitRate rate;
    for (long i = 0; i < count; ++i) rate.count(static_cast<Kind&>(*this).run(name, generate()));
    INFO(draw.random << ", " << name << ": " << rate);
    CHECK(rate.percent() >= low);
    CHECK(rate.percent() <= high);
    rates_ << "  " << name << ": " << rate << "\n";
  }

  /// Requires that there was no disagreement and that at least `least` cases were run.
  void finish(long least) {
    INFO(draw.random << ", " << asked_ << " cases\n" << rates_.str() << first_mistakes_.str());
    CHECK(asked_ >= least);
    CHECK(wrong_ == 0);
  }

 protected:
  /// Counts a case; `describe(stream)` tells of one that is not right.
  template <class Describe>
  void count_case(bool is_right, const Describe& describe) {
    ++asked_;
    if (!is_right && ++wrong_ <= 5) describe(first_mistakes_);
  }

 private:
  long asked_ = 0;
  long wrong_ = 0;
  std::ostringstream rates_;
  std::ostringstream first_mistakes_;
};

}  // namespace detent::oracle
