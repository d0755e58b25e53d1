// SPDX-License-Identifier: MIT
#include "exact.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

#include "oracle/crossing.hpp"

namespace detent::cli {
namespace {

using Vector = oracle::Vector<3>;

/// Raises `frac` until all numbers are whole in units of 2^-frac.
void refine(int& frac, const std::vector<Exact>& numbers) {
  for (const Exact& x : numbers) {
    if (!x.mantissa.is_zero()) frac = std::max(frac, -x.exponent);
  }
}

/// Reads a shape on one grid for lengths and one for directions.
struct Reader {
  const ExactShape& shape;
  int length_frac;
  int direction_frac;

  [[nodiscard]] Integer length(std::size_t i) const { return shape.lengths[i].steps(length_frac); }
  [[nodiscard]] Vector point(std::size_t i) const {
    return {length(3 * i), length(3 * i + 1), length(3 * i + 2)};
  }
  [[nodiscard]] Vector direction(std::size_t i) const {
    Vector result;
    for (std::size_t k = 0; k < 3; ++k) {
      result[k] = shape.directions[3 * i + k].steps(direction_frac);
    }
    return result;
  }
  [[nodiscard]] Integer one() const { return Integer(1) << static_cast<unsigned>(direction_frac); }

  [[nodiscard]] oracle::Line<3> line() const { return {point(0), direction(0), one(), length(3)}; }
  [[nodiscard]] oracle::Solid<3> solid() const {
    using Form = ExactShape::Form;
    switch (shape.form) {
      case Form::ball:
        return oracle::Ball<3>{point(0), length(3)};
      case Form::box:
        return oracle::Box<3>{point(0), point(1)};
      case Form::turned_box:
        return oracle::TurnedBox<3>{
            point(0), point(1), {direction(0), direction(1), direction(2)}, one()};
      case Form::wall:
        return oracle::Wall<3>{direction(0), length(0), one()};
      case Form::face:
        return oracle::Face<3>{{point(0), point(1), point(2)}};
      case Form::pill:
        return oracle::Pill<3>{{point(0), point(1)}, length(6)};
      default:
        break;
    }
    oracle::Cloud<3> cloud;
    for (std::size_t i = 0; 3 * i < shape.lengths.size(); ++i) cloud.points.push_back(point(i));
    return cloud;
  }
};

}  // namespace

Exact Exact::of(double value) {
  if (value == 0) return {};
  int exponent = 0;
  const auto mantissa = static_cast<std::int64_t>(std::ldexp(std::frexp(value, &exponent), 53));
  const int zeros = std::countr_zero(static_cast<std::uint64_t>(mantissa));
  return {Integer(mantissa / (std::int64_t{1} << zeros)), exponent - 53 + zeros};
}

double Exact::approximate() const { return std::ldexp(static_cast<double>(mantissa), exponent); }

Integer Exact::steps(int frac) const {
  const int shift = exponent + frac;
  if (shift >= 0) return mantissa * (Integer(1) << static_cast<unsigned>(shift));
  return oracle::floor_quotient(mantissa, Integer(1) << static_cast<unsigned>(-shift));
}

std::optional<Integer> first_hit(const ExactShape& ray, const ExactShape& shape) {
  int length_frac = distance_frac, direction_frac = 0;
  refine(length_frac, ray.lengths);
  refine(length_frac, shape.lengths);
  refine(direction_frac, ray.directions);
  refine(direction_frac, shape.directions);
  const auto found = oracle::crossing(Reader{ray, length_frac, direction_frac}.line(),
                                      Reader{shape, length_frac, direction_frac}.solid());
  if (!found) return std::nullopt;
  return found->enter >> static_cast<unsigned>(length_frac - distance_frac);
}

}  // namespace detent::cli
