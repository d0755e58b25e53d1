// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>

#include "oracle/exam.hpp"
#include "oracle/point_answer.hpp"

namespace detent::oracle {

/// Runs points and shapes through the library and the oracle.
template <Scalar S, int N>
class PointExam : public Exam<PointExam<S, N>, S, N> {
 public:
  using Exam<PointExam<S, N>, S, N>::Exam, Exam<PointExam<S, N>, S, N>::draw;

  /// Runs a shape and a point, which hits inside or on the shape.
  template <class Shape>
  bool run(const char* name, const std::pair<Shape, Vec<S, N>>& drawn) {
    const auto& [shape, point] = drawn;
    const auto truth = nearest(shape, point);
    const auto found = mistakes(shape, point, truth);
    this->count_case(found.empty(), [&, &shape = shape, &point = point](auto& out) {
      out << name << ": " << describe(shape) << "; point " << describe(point) << "\n" << found;
    });
    return is_within(truth, 0);
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
};

/// The cases of an ordinary run in each space.
inline constexpr long point_cases = 50'000;

}  // namespace detent::oracle

/// The two test cases of an oracle test whose cases the source draws for a PointExam.
#define DETENT_POINT_TEST(subject, seed, count, more) \
  DETENT_EXAMINE(PointExam)                           \
  DETENT_ORACLE_TEST(subject, seed, count, more)
