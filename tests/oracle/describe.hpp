// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>

#include "detent/shape/frustum.hpp"
#include "detent/shape/hull.hpp"
#include "detent/shape/shape.hpp"
#include "oracle/answer.hpp"
#include "oracle/exact.hpp"
#include "support/shapes.hpp"

/// Shapes in raw numbers, for the messages of failed tests.
namespace detent::oracle {

template <Scalar S, int N>
std::string describe(const Vec<S, N>& v) {
  Raw<N> components{};
  for (int i = 0; i < N; ++i) components[static_cast<std::size_t>(i)] = v[i].raw();
  return text(components);
}
template <Scalar S>
std::string describe(const S& number) {
  return raw(number).str();
}
template <Scalar S, int N>
std::string describe(const Direction<S, N>& direction) {
  return text(raw(direction));
}
template <Scalar S, int N>
std::string describe(const Rotation<S, N>& rotation) {
  std::string out;
  for (int i = 0; i < N; ++i) out += (i == 0 ? "" : " ") + text(raw(rotation.axis(i)));
  return out;
}
/// "sphere {0, 0, 0} 1": the fields in their order.
template <support::Mappable Shape>
std::string describe(const Shape& shape) {
  std::string out(support::name_of(shape));
  support::visit_fields(shape, [&](const auto& field) { out += " " + describe(field); });
  return out;
}
template <Scalar S, int N>
std::string describe(const ConvexHull<S, N>& hull) {
  std::string out = "hull";
  for (const auto& point : hull.points) out += " " + describe(point);
  return out;
}
template <Scalar S>
std::string describe(const Frustum<S>& frustum) {
  return describe(frustum.hull());
}

}  // namespace detent::oracle
