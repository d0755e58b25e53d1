// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <sstream>
#include <string>

#include "oracle/draw.hpp"
#include "oracle/oracle_test.hpp"
#include "oracle/point_answer.hpp"

namespace detent::oracle {

/// Runs points and shapes through the library and the oracle, and keeps the first few
/// disagreements.
template <Scalar S, int N>
class PointExam {
 public:
  explicit PointExam(std::uint64_t seed) : draw(seed) {}

  Draw<S, N> draw;

  /// Runs `count` cases, each a shape and a point from `generate`; of these, `low` to `high`
  /// percent must be inside or on the shape.
  template <class Generate>
  void family(const char* name, long count, int low, int high, Generate generate) {
    test::HitRate rate;
    for (long i = 0; i < count; ++i) {
      const auto [shape, point] = generate();
      const auto truth = nearest(shape, point);
      rate.count(is_within(truth, 0));
      ++asked_;
      const auto found = mistakes(shape, point, truth);
      if (found.empty() || ++wrong_ > 5) continue;
      first_mistakes_ << name << ": " << describe(shape) << "; point " << describe(point) << "\n"
                      << found;
    }
    INFO(draw.random << ", " << name << ": " << rate);
    CHECK(rate.percent() >= low);
    CHECK(rate.percent() <= high);
  }

  void finish() {
    INFO(draw.random << ", " << asked_ << " cases\n" << first_mistakes_.str());
    CHECK(wrong_ == 0);
  }

 private:
  template <class Shape>
  std::string mistakes(const Shape& shape, const Vec<S, N>& point,
                       const std::optional<Nearest<N>>& truth) {
    const auto near = static_cast<std::int64_t>(distance(shape, point).raw());
    return point_mistakes(shape, point, truth,
                          std::array{Draw<S, N>::scalar(near + draw.random.between(-1, 1)),
                                     Draw<S, N>::scalar(draw.extreme())});
  }

  long asked_ = 0;
  long wrong_ = 0;
  std::ostringstream first_mistakes_;
};

/// The cases of an ordinary run in each space.
inline constexpr long point_cases = 50'000;

}  // namespace detent::oracle
