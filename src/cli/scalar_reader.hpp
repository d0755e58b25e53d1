// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <string>
#include <type_traits>
#include <utility>

#include "numbers.hpp"
#include "scene.hpp"

namespace detent::cli {

/// Converts the numbers of a file to a scalar, each rounded once; throws InputError when one is out
/// of the scalar's range.
template <Scalar S>
class ScalarReader {
 protected:
  explicit ScalarReader(std::string file) : file_(std::move(file)) {}

  /// The type for vectors of which only the direction matters, scaled by a power of ten so that at
  /// least 17 of their digits fit.
  using Component = std::conditional_t<is_fixed<S>, Fixed<62, 31>, S>;
  /// A full turn in degrees is out of range for the smallest scalar.
  using Degrees = std::conditional_t<is_fixed<S>, q16_16, S>;

  [[noreturn]] void fail(Place place, const std::string& what) const {
    throw InputError(file_, place, what);
  }

  [[noreturn]] void fail_range(const Decimal& value, Place place, const std::string& name,
                               const std::string& remedy) const {
    std::string text = value.text();
    if (text.size() > 24) text.replace(24, std::string::npos, "...");
    fail(place, name + " = " + text + " is out of range for " + remedy);
  }

  S scalar(const Decimal& value, Place place, const std::string& name) const {
    if (const auto result = value.to<S>()) return *result;
    fail_range(value, place, name,
               std::string(scalar_name<S>) + " (" + range_of<S>() +
                   "); use a smaller number or a wider scalar");
  }

  S length(const Literal& number, const std::string& name) const {
    return scalar(number.value, number.place, name);
  }

  Vec<S, 3> lengths(const Point& point, const std::string& name) const {
    return {length(point[0], name), length(point[1], name), length(point[2], name)};
  }

  static Vec<Component, 3> vector(const Point& point) {
    constexpr int whole_digits = 9;  // 10^9 < 2^31
    int magnitude = -3 * Decimal::max_length;
    for (const Literal& number : point) {
      if (!number.value.is_zero()) magnitude = std::max(magnitude, number.value.magnitude());
    }
    const auto component = [&](std::size_t i) {
      return point[i].value.scaled(whole_digits - magnitude).template to<Component>().value();
    };
    return {component(0), component(1), component(2)};
  }

  /// The vector is not zero: the reader has checked that.
  static Direction<S, 3> direction(const Point& point) {
    return detent::direction_of<S>(vector(point)).value();
  }

  Angle<S> angle(const Literal& degrees, const std::string& name) const {
    const auto value = degrees.value.to<Degrees>();
    if (!value) {
      fail_range(degrees.value, degrees.place, name,
                 "degrees (" + range_of<Degrees>() + "); subtract whole turns of 360");
    }
    return Angle<S>::from_raw(Angle<Degrees>::from_degrees(*value).raw());
  }

  Rotation<S, 3> rotation(const Turn& turn) const {
    if (const auto* const axis_angle = std::get_if<AxisAngle>(&turn)) {
      return Rotation<S, 3>::from_axis_angle(direction(axis_angle->axis),
                                             angle(axis_angle->angle, "angle"));
    }
    if (const auto* const euler = std::get_if<EulerAngles>(&turn)) {
      return Rotation<S, 3>::from_euler(angle(euler->angles[0], "euler"),
                                        angle(euler->angles[1], "euler"),
                                        angle(euler->angles[2], "euler"));
    }
    return {};
  }

  std::string file_;
};

}  // namespace detent::cli
