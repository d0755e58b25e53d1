// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include "detent/shape/camera.hpp"
#include "detent/shape/obb.hpp"
#include "number/big_integer.hpp"

/// The frustum of a camera without any rounding: the convex set with the exact corners. It decides
/// by separating axes, in integers of any length, where the library searches with GJK and rounds
/// the corners.
namespace detent::oracle {

using BigPoint = std::array<test::BigInteger, 3>;

/// A convex polytope with planar faces, its coordinates times 2^scale.
struct Polytope {
  std::vector<BigPoint> corners, normals, edges;
  int scale = 0;
};

inline BigPoint cross(const BigPoint& a, const BigPoint& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline BigPoint minus(const BigPoint& a, const BigPoint& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

/// The box that its edges span.
template <Scalar S>
Polytope polytope(const Obb<S, 3>& box) {
  Polytope result;
  result.scale = S::frac + direction_component<S>::frac;
  const auto one = test::power_of_two(direction_component<S>::frac);
  BigPoint center;
  for (int j = 0; j < 3; ++j) {
    center[static_cast<std::size_t>(j)] = test::big_raw(box.center[j]) * one;
  }
  for (int i = 0; i < 3; ++i) {
    BigPoint edge;
    for (int j = 0; j < 3; ++j) {
      edge[static_cast<std::size_t>(j)] = test::big_raw(box.rotation.axis(i)[j]);
    }
    result.edges.push_back(edge);
  }
  for (std::size_t i = 0; i < 3; ++i) {
    result.normals.push_back(cross(result.edges[(i + 1) % 3], result.edges[(i + 2) % 3]));
  }
  for (unsigned signs = 0; signs < 8; ++signs) {
    auto corner = center;
    for (unsigned i = 0; i < 3; ++i) {
      const auto half = test::big_raw(box.half_extents[static_cast<int>(i)]);
      for (std::size_t j = 0; j < 3; ++j) {
        if ((signs >> i & 1) != 0) {
          corner[j] += half * result.edges[i][j];
        } else {
          corner[j] -= half * result.edges[i][j];
        }
      }
    }
    result.corners.push_back(corner);
  }
  return result;
}
template <Scalar S>
Polytope polytope(const Aabb<S, 3>& box) {
  Polytope result;
  result.scale = S::frac;
  for (std::size_t i = 0; i < 3; ++i) {
    BigPoint axis{0, 0, 0};
    axis[i] = 1;
    result.edges.push_back(axis);
    result.normals.push_back(axis);
  }
  for (unsigned signs = 0; signs < 8; ++signs) {
    BigPoint corner;
    for (unsigned i = 0; i < 3; ++i) {
      const auto j = static_cast<int>(i);
      corner[i] = test::big_raw((signs >> i & 1) != 0 ? box.max[j] : box.min[j]);
    }
    result.corners.push_back(corner);
  }
  return result;
}

/// The frustum of a camera whose axes do not lie in a plane.
template <Scalar S>
Polytope polytope(const Camera<S>& camera) {
  Polytope result;
  constexpr int slope_frac = Lens<S>::Slope::frac;
  constexpr int axis_frac = direction_component<S>::frac;
  result.scale = S::frac + slope_frac + axis_frac;
  const auto one = test::power_of_two(slope_frac);
  for (unsigned i = 0; i < 8; ++i) {
    const auto depth =
        test::big_raw((i & 4) != 0 ? camera.lens.far_distance() : camera.lens.near_distance());
    BigPoint corner;
    for (int j = 0; j < 3; ++j) {
      auto& x = corner[static_cast<std::size_t>(j)];
      x = test::big_raw(camera.pose.translation[j]) * test::power_of_two(slope_frac + axis_frac) -
          depth * one * test::big_raw(camera.pose.rotation.axis(2)[j]);
      for (int k = 0; k < 2; ++k) {
        const test::BigInteger half = test::big_raw(camera.lens.slope(k)) * depth +
                                      test::big_raw(camera.lens.extent(k)) * one;
        const test::BigInteger along = half * test::big_raw(camera.pose.rotation.axis(k)[j]);
        x += (i >> k & 1) != 0 ? along : test::BigInteger(-along);
      }
    }
    result.corners.push_back(corner);
  }
  const auto edge = [&](std::size_t from, std::size_t to) {
    return minus(result.corners[to], result.corners[from]);
  };
  // Sides, then far, which is parallel to near.
  for (const auto& [a, b, c] :
       {std::array<std::size_t, 3>{1, 3, 5}, {0, 2, 4}, {2, 3, 6}, {0, 1, 4}, {4, 5, 6}}) {
    result.normals.push_back(cross(edge(a, b), edge(a, c)));
  }
  result.edges = {edge(0, 1), edge(0, 2), edge(0, 4), edge(1, 5), edge(2, 6), edge(3, 7)};
  return result;
}

/// Whether two polytopes share a point: no axis separates them.
inline bool meet(const Polytope& a, const Polytope& b) {
  const auto scaled = [](const Polytope& of, int scale) {
    auto corners = of.corners;
    for (auto& corner : corners) {
      for (auto& x : corner) x <<= static_cast<unsigned>(scale - of.scale);
    }
    return corners;
  };
  const int scale = std::max(a.scale, b.scale);
  const auto first = scaled(a, scale), second = scaled(b, scale);
  const auto separates = [&](const BigPoint& axis) {
    const auto reach = [&](const std::vector<BigPoint>& corners) {
      std::array<test::BigInteger, 2> ends;
      for (std::size_t i = 0; i < corners.size(); ++i) {
        const auto& c = corners[i];
        const test::BigInteger at = axis[0] * c[0] + axis[1] * c[1] + axis[2] * c[2];
        if (i == 0 || at < ends[0]) ends[0] = at;
        if (i == 0 || at > ends[1]) ends[1] = at;
      }
      return ends;
    };
    const auto x = reach(first), y = reach(second);
    return x[1] < y[0] || y[1] < x[0];
  };
  for (const auto& axis : a.normals) {
    if (separates(axis)) return false;
  }
  for (const auto& axis : b.normals) {
    if (separates(axis)) return false;
  }
  for (const auto& u : a.edges) {
    for (const auto& v : b.edges) {
      if (separates(cross(u, v))) return false;
    }
  }
  return true;
}

}  // namespace detent::oracle
