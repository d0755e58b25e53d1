// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>

#include "detent/dynamics/mass/properties.hpp"
#include "detent/number/min_max.hpp"
#include "detent/shape/hull.hpp"

namespace detent::detail {

/// The points of a hull on a grid, on which its boundary points are determined exactly: unchanged
/// or, for `float` and `double`, scaled to 31 bits.
template <Scalar S, int N>
class HullGrid {
 public:
  explicit constexpr HullGrid(std::span<const Vec<S, N>> points) noexcept : points_(points) {
    if constexpr (!is_fixed<S>) {
      for (const auto& p : points) {
        for (int i = 0; i < N; ++i) scale_ = (max)(scale_, abs(p[i]));
      }
      scale_ = scale_ > 0 ? S(16384) / scale_ : S(1);
    }
  }

  [[nodiscard]] constexpr std::size_t size() const noexcept { return points_.size(); }

  [[nodiscard]] constexpr auto operator[](std::size_t i) const noexcept {
    if constexpr (is_fixed<S>) {
      return points_[i];
    } else {
      return make_vec<N>([&](int k) { return q16_16::from_double(points_[i][k] * scale_); });
    }
  }

  /// Whether a point with a lower index is equal to point `i`.
  [[nodiscard]] constexpr bool repeats(std::size_t i) const noexcept {
    for (std::size_t j = 0; j < i; ++j) {
      if ((*this)[j] == (*this)[i]) return true;
    }
    return false;
  }

 private:
  std::span<const Vec<S, N>> points_;
  S scale_{};
};

/// Whether q, on the line along `edge` from its start, is on the edge.
template <Number T, Number U, int N>
[[nodiscard]] constexpr bool is_between(const Vec<T, N>& edge, const Vec<U, N>& q) noexcept {
  const auto along = dot(edge, q);
  return along >= 0 && along <= squared_length(edge);
}

/// Calls visit(i, j) for every edge of the polygon, counter-clockwise.
template <Scalar S, class Visit>
constexpr void visit_boundary(const HullGrid<S, 2>& grid, const Visit& visit) noexcept {
  for (std::size_t i = 0; i < grid.size(); ++i) {
    if (grid.repeats(i)) continue;
    for (std::size_t j = 0; j < grid.size(); ++j) {
      if (grid[i] == grid[j] || grid.repeats(j)) continue;
      const auto edge = grid[j] - grid[i];
      const auto bounds = [&] {
        for (std::size_t k = 0; k < grid.size(); ++k) {
          const auto q = grid[k] - grid[i];
          const auto side = cross(edge, q);
          if (side < 0 || (side == 0 && !is_between(edge, q))) return false;
        }
        return true;
      };
      if (bounds()) visit(i, j);
    }
  }
}

/// Calls visit(i, j, k) for every edge from j to k of a facet of the polyhedron, counter-clockwise
/// seen from outside, where i is the facet's first point.
///
/// The facet left of the edge from j to k is found by turning a plane about the edge until no point
/// is beyond it, as in gift wrapping (Chand and Kapur, 1970).
template <Scalar S, class Visit>
constexpr void visit_facets(const HullGrid<S, 3>& grid, const Visit& visit) noexcept {
  for (std::size_t j = 0; j < grid.size(); ++j) {
    if (grid.repeats(j)) continue;
    for (std::size_t k = 0; k < grid.size(); ++k) {
      if (grid[j] == grid[k] || grid.repeats(k)) continue;
      const auto edge = grid[k] - grid[j];
      auto normal = decltype(cross(edge, edge)){};
      for (std::size_t i = 0; i < grid.size(); ++i) {
        const auto q = grid[i] - grid[j];
        if (normal == decltype(normal){} || dot(normal, q) > 0) normal = cross(edge, q);
      }
      std::size_t anchor = grid.size();
      const auto bounds = [&] {
        for (std::size_t i = 0; i < grid.size(); ++i) {
          const auto q = grid[i] - grid[j];
          const auto height = dot(normal, q);
          if (height > 0) return false;
          if (height < 0) continue;
          const auto side = dot(normal, cross(edge, q));
          if (side < 0 || (side == 0 && !is_between(edge, q))) return false;
          if (anchor == grid.size()) anchor = i;
        }
        return normal != decltype(normal){};
      };
      if (bounds()) visit(anchor, j, k);
    }
  }
}

/// Calls visit(i, j, k) for triangles that make the surface of the polyhedron, each
/// counter-clockwise seen from outside: every facet is a fan about its first point i.
template <Scalar S, class Visit>
constexpr void visit_boundary(const HullGrid<S, 3>& grid, const Visit& visit) noexcept {
  visit_facets(grid, [&](std::size_t anchor, std::size_t j, std::size_t k) {
    if (anchor != j && anchor != k) visit(anchor, j, k);
  });
}

/// Calls visit(i, j) for every edge of the hull: of a polygon counter-clockwise, of a polyhedron both
/// ways.
template <Scalar S, class Visit>
constexpr void visit_edges(const HullGrid<S, 2>& grid, const Visit& visit) noexcept {
  visit_boundary(grid, visit);
}
template <Scalar S, class Visit>
constexpr void visit_edges(const HullGrid<S, 3>& grid, const Visit& visit) noexcept {
  visit_facets(grid, [&](std::size_t, std::size_t j, std::size_t k) { visit(j, k); });
}

/// The polygon. Sums over its triangles with the apex at the first point: twice the area, 6 times
/// the first moments, 12 times the polar second moment. They never decrease, so the hull bounds
/// them: lengths below 2^(b + 1) raw units, b the bits of the scalar.
template <Scalar S>
[[nodiscard]] constexpr MassProperties<S, 2> solid_properties(const ConvexHull<S, 2>& hull,
                                                              const S& density) noexcept {
  using Formats = MassFormats<S>;
  constexpr int b = bits_of<S>;
  if (is_empty(hull)) return {};
  const auto& points = hull.points;
  const auto apex = points[0];
  const auto zero = apex - apex;
  auto content = narrow<2 * b + 4>(cross(zero, zero));
  auto first = narrow<3 * b + 8>(content * zero);
  auto second = narrow<4 * b + 10>(content * dot(zero, zero));
  visit_boundary(HullGrid<S, 2>(points), [&](std::size_t i, std::size_t j) {
    const auto u = points[i] - apex, v = points[j] - apex;
    const auto part = cross(u, v);
    content = narrow<2 * b + 4>(content + part);
    first = narrow<3 * b + 8>(first + part * (u + v));
    second = narrow<4 * b + 10>(second + part * (dot(u, u) + dot(u, v) + dot(v, v)));
  });
  if (content <= 0) return {};
  const auto thrice = content * as_operand<S>(3);
  const auto offset = make_vec<2>([&](int i) { return apex[i] * thrice + first[i]; });
  const auto spread = second * thrice - squared_length(first) * as_operand<S>(2);
  return properties_of<S, 2>(
      density, content, quotient_nearest<typename Formats::Center>(offset, thrice),
      quotient_nearest<typename Formats::Gyration>(spread, square(content) * as_operand<S>(18)));
}

/// The polyhedron. Sums over its tetrahedra with the apex at the first point: 6 times the volume, 24
/// times the first moments, 120 times the second moments. They never decrease, so the hull bounds
/// them: lengths below 2^(b + 1) raw units, b the bits of the scalar.
template <Scalar S>
[[nodiscard]] constexpr MassProperties<S, 3> solid_properties(const ConvexHull<S, 3>& hull,
                                                              const S& density) noexcept {
  using Formats = MassFormats<S>;
  using Gyration = typename Formats::Gyration;
  constexpr int b = bits_of<S>;
  if (is_empty(hull)) return {};
  const auto& points = hull.points;
  const auto apex = points[0];
  const auto zero = apex - apex;
  auto content = narrow<3 * b + 6>(dot(cross(zero, zero), zero));
  auto first = narrow<4 * b + 9>(content * zero);
  // The entries of the second moments as in `Symmetric`.
  const auto squares = [](const auto& u) {
    return make_vec<3>([&](int i) { return square(u[i]); });
  };
  const auto products = [](const auto& u) {
    return make_vec<3>([&](int i) { return u[(i + 1) % 3] * u[(i + 2) % 3]; });
  };
  auto second = narrow<5 * b + 13>(content * squares(zero));
  auto mixed = second;
  visit_boundary(HullGrid<S, 3>(points), [&](std::size_t i, std::size_t j, std::size_t k) {
    const auto u = points[i] - apex, v = points[j] - apex, w = points[k] - apex;
    const auto part = narrow<3 * b + 6>(dot(u, cross(v, w)));
    const auto sum = u + v + w;
    content = narrow<3 * b + 6>(content + part);
    first = narrow<4 * b + 9>(first + part * sum);
    const auto sum_of = [&](const auto& f) { return part * (f(u) + f(v) + f(w) + f(sum)); };
    second = narrow<5 * b + 13>(second + sum_of(squares));
    mixed = narrow<5 * b + 13>(mixed + sum_of(products));
  });
  if (content <= 0) return {};
  const auto four_times = content * as_operand<S>(4);
  const auto offset = make_vec<3>([&](int i) { return apex[i] * four_times + first[i]; });
  // 80 content^2 times the second moments about the center, divided by the volume.
  const auto spread = second * four_times - squares(first) * as_operand<S>(5);
  const auto tilt = mixed * four_times - products(first) * as_operand<S>(5);
  const auto unit = square(content) * as_operand<S>(80);
  const auto gyration = Symmetric<Gyration>{
      make_vec<3>([&](int i) {
        return quotient_nearest<Gyration>(spread[(i + 1) % 3] + spread[(i + 2) % 3], unit);
      }),
      make_vec<3>([&](int i) { return quotient_nearest<Gyration>(-tilt[i], unit); })};
  return properties_of<S, 3>(
      density, content, quotient_nearest<typename Formats::Center>(offset, four_times), gyration);
}

}  // namespace detent::detail
