// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>

#include "detent/dynamics/mass/properties.hpp"
#include "detent/shape/compound.hpp"

namespace detent::detail {

template <class T>
inline constexpr int dimension_of_part = 0;
template <template <class, int> class Shape, class S, int N>
inline constexpr int dimension_of_part<Shape<S, N>> = N;
template <class... Shapes>
inline constexpr int dimension_of_part<Compound<Shapes...>> =
    (std::max)({0, dimension_of_part<Shapes>...});

/// The dimension of a compound of these shapes.
template <class... Shapes>
inline constexpr int dimension_of_parts = (std::max)({2, dimension_of_part<Shapes>...});

/// The properties of the parts that `for_each` passes to its argument.
template <Scalar S, int N, class ForEach>
[[nodiscard]] constexpr MassProperties<S, N> sum_of(const ForEach& for_each) noexcept {
  using Formats = MassFormats<S>;
  using Mass = typename Formats::Mass;
  using Center = typename Formats::Center;
  using Gyration = typename Formats::Gyration;
  using Part = MassProperties<S, N>;
  constexpr int count_bits = 20;
  constexpr int mass_bits = bits_of<Mass> + count_bits;
  constexpr int moment_bits = mass_bits + bits_of<Center> + 1;
  // Each sum of products is narrowed to the bits that this many parts can need.
  auto mass = narrow<mass_bits>(Mass() + Mass());
  auto moment = narrow<moment_bits>(mass * Vec<Center, N>());
  for_each([&](const Part& part) {
    mass = narrow<mass_bits>(mass + part.mass);
    moment = narrow<moment_bits>(moment + part.mass * part.center);
  });
  if (mass <= 0) return {};
  const auto center = quotient_nearest<Center>(moment, mass);
  constexpr int spread_bits = mass_bits + bits_of<Gyration> + 8;
  const auto zero = narrow<spread_bits>(mass * Gyration());
  const auto sum_entry = [&](const auto& entry) {
    auto sum = zero;
    for_each([&](const Part& part) {
      sum = narrow<spread_bits>(sum + part.mass * entry(part, part.center - center));
    });
    return quotient_nearest<Gyration>(sum, mass);
  };
  Tensor<Gyration, N> gyration;
  if constexpr (N == 2) {
    gyration = sum_entry(
        [](const Part& part, const auto& d) { return part.gyration + squared_length(d); });
  } else {
    for (int i = 0; i < 3; ++i) {
      const int j = (i + 1) % 3, k = (i + 2) % 3;
      gyration.diagonal[i] = sum_entry([&](const Part& part, const auto& d) {
        return part.gyration.diagonal[i] + (square(d[j]) + square(d[k]));
      });
      gyration.mixed[i] = sum_entry(
          [&](const Part& part, const auto& d) { return part.gyration.mixed[i] - d[j] * d[k]; });
    }
  }
  return {nearest_to<Mass>(mass), center, gyration,
          inverse_tensor<typename Formats::InverseGyration>(gyration)};
}

}  // namespace detent::detail
