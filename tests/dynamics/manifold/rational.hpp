// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "dynamics/exact.hpp"
#include "dynamics/manifold/helpers.hpp"

// Exact points, and poses drawn in double.

namespace detent::test {

using Point = std::vector<Rational>;

inline Rational dot(const Point& a, const Point& b) {
  Rational sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}

/// Turns a pose by a quaternion of any length.
template <Scalar S, int N>
void turn(detail::RelativePose<S, N>& pose, std::array<double, 4> q) {
  double norm = 0;
  for (const double x : q) norm += x * x;
  for (double& x : q) x /= std::sqrt(norm);
  const auto [w, x, y, z] = q;
  const double m[3][3] = {{1 - 2 * (y * y + z * z), 2 * (x * y + w * z), 2 * (x * z - w * y)},
                          {2 * (x * y - w * z), 1 - 2 * (x * x + z * z), 2 * (y * z + w * x)},
                          {2 * (x * z + w * y), 2 * (y * z - w * x), 1 - 2 * (x * x + y * y)}};
  for (int i = 0; i < N; ++i) {
    for (int j = 0; j < N; ++j) {
      pose.axes[static_cast<std::size_t>(i)][j] = ratio<S>::from_double(m[i][j]);
    }
  }
}

}  // namespace detent::test
