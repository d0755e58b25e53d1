// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>

#include "detent/math/components.hpp"
#include "detent/number/filter/filtered.hpp"
#include "detent/number/fraction.hpp"

namespace detent::detail {

/// Up to N + 1 points, none on the line or in the plane of the others; the newest is last.
template <Number T, int N>
struct Simplex {
  std::array<Vec<T, N>, static_cast<std::size_t>(N + 1)> corners{};
  int count = 0;

  [[nodiscard]] constexpr const Vec<T, N>& operator[](int i) const noexcept {
    return corners[static_cast<std::size_t>(i)];
  }
  [[nodiscard]] constexpr const Vec<T, N>& newest() const noexcept { return (*this)[count - 1]; }
  constexpr void add(const Vec<T, N>& corner) noexcept {
    corners[static_cast<std::size_t>(count++)] = corner;
  }
};

template <Number T, int N, class... Corners>
[[nodiscard]] constexpr Simplex<T, N> simplex_of(const Vec<T, N>& first,
                                                 const Corners&... rest) noexcept {
  Simplex<T, N> simplex;
  simplex.add(first);
  (simplex.add(rest), ...);
  return simplex;
}

/// The edges from the newest corner of a simplex to the others.
template <Number T, int N>
struct Fan {
  explicit constexpr Fan(const Simplex<T, N>& simplex) noexcept : from(simplex.newest()) {
    for (int i = 0; i + 1 < simplex.count; ++i) at(i) = simplex[i] - from;
    if constexpr (keeps_products) {
      for (std::size_t i = 0; i + 1 < static_cast<std::size_t>(simplex.count); ++i) {
        behind[i] = dot(edges[i], from);
      }
    }
  }
  /// To be called before `sign_beside`.
  constexpr void multiply(int count) noexcept {
    if constexpr (keeps_products) {
      for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
        for (std::size_t j = 0; j <= i; ++j) {
          products[i][j] = products[j][i] = dot(edges[i], edges[j]);
        }
      }
    }
  }

  using Edge = decltype(Vec<T, N>() - Vec<T, N>());
  using Behind = decltype(dot(Edge(), Vec<T, N>()));
  using Product = decltype(dot(Edge(), Edge()));
  static constexpr auto size = static_cast<std::size_t>(N);
  static constexpr bool keeps_products = N == 3 && has_filters;
  [[nodiscard]] constexpr Edge& at(int i) noexcept { return edges[static_cast<std::size_t>(i)]; }
  [[nodiscard]] constexpr const Edge& operator[](int i) const noexcept {
    return edges[static_cast<std::size_t>(i)];
  }

  /// Whether edge i leads closer to the origin.
  [[nodiscard]] constexpr bool leads_closer(int i) const noexcept {
    if constexpr (keeps_products) {
      return behind[static_cast<std::size_t>(i)] < 0;
    } else {
      return dot((*this)[i], from) < 0;
    }
  }
  /// The sign of v . edge j, where v is the perpendicular from the origin to the line along edge i:
  /// v |edge i|^2 = from |edge i|^2 - edge i (from . edge i).
  [[nodiscard]] constexpr int sign_beside(int i, int j) const noexcept {
    const auto& e = (*this)[i];
    const auto& other = (*this)[j];
    if constexpr (N == 2) {
      const auto height = cross(e, from);
      const auto turn = cross(e, other);
      return ((height > 0) - (height < 0)) * ((turn > 0) - (turn < 0));
    } else if constexpr (keeps_products) {
      const auto k = static_cast<std::size_t>(i), l = static_cast<std::size_t>(j);
      const auto ahead = behind[l] * products[k][k];
      const auto aside = behind[k] * products[k][l];
      return (ahead > aside) - (ahead < aside);
    } else {
      const auto ahead = dot(other, from) * squared_length(e);
      const auto aside = dot(e, from) * dot(e, other);
      return (ahead > aside) - (ahead < aside);
    }
  }

  Vec<T, N> from;
  std::array<Edge, size> edges{};
  // The products edge . from and edge . edge, unless computing each of them once takes more code.
  std::array<Behind, keeps_products ? size : 0> behind{};
  std::array<std::array<Product, size>, keeps_products ? size : 0> products{};
};

/// Returns choose(i...) for the indices of the corners of the feature of `simplex` whose relative
/// interior contains the point closest to the origin, or `all()` for all corners. The newest corner
/// must be one of them, and is last. A full simplex that contains the origin is that feature itself.
///
/// The closest point is then also the closest in the cone of all `newest + t_i edge_i`, t_i >= 0.
/// It is the projection of the origin onto the span of the edges with t_i > 0 (by the signs of
/// Cramer's rule), and no other edge leads from it towards the origin. Exactly one choice of edges
/// satisfies this.
///
/// source: Ericson, Real-Time Collision Detection, 9.5.2; the conditions of Karush, Kuhn and Tucker
template <Number T, int N, class Choose, class All>
[[nodiscard]] constexpr auto with_nearest(const Simplex<T, N>& simplex, const Choose& choose,
                                          const All& all) noexcept {
  const int edges = simplex.count - 1;
  Fan<T, N> fan(simplex);

  std::array<bool, static_cast<std::size_t>(N)> ahead{};
  bool is_corner = true;
  for (int i = 0; i < edges; ++i) {
    const bool leads_closer = fan.leads_closer(i);
    ahead[static_cast<std::size_t>(i)] = leads_closer;
    is_corner = is_corner && !leads_closer;
  }
  if (is_corner) return choose(edges);
  if (edges == 1) return all();

  fan.multiply(edges);
  for (int i = 0; i < edges; ++i) {
    bool is_edge = ahead[static_cast<std::size_t>(i)];
    for (int j = 0; j < edges && is_edge; ++j) is_edge = i == j || fan.sign_beside(i, j) >= 0;
    if (is_edge) return choose(i, edges);
  }
  if (edges == 2) return all();

  if constexpr (N == 3) {
    for (int k = 0; k < 3; ++k) {
      const int i = (k + 1) % 3, j = (k + 2) % 3;
      const auto normal = cross(fan[i], fan[j]);
      const auto height = dot(normal, fan.from);
      const auto depth = dot(normal, fan[k]);
      if ((height > 0 && depth < 0) || (height < 0 && depth > 0)) continue;
      if (fan.sign_beside(i, j) < 0 && fan.sign_beside(j, i) < 0) return choose(i, j, 3);
    }
  }
  return all();
}

/// That feature.
template <Number T, int N>
[[nodiscard]] constexpr Simplex<T, N> nearest_feature(const Simplex<T, N>& simplex) noexcept {
  return with_nearest(
      simplex, [&](auto... indices) { return simplex_of(simplex[indices]...); },
      [&] { return simplex; });
}

/// Some corners of a simplex, by index, in order.
struct CornerChoice {
  std::array<int, 4> indices;
  int count;

  [[nodiscard]] constexpr int operator[](int i) const noexcept {
    return indices[static_cast<std::size_t>(i)];
  }
};

/// Its corners.
template <Number T, int N>
[[nodiscard]] constexpr CornerChoice nearest_corners(const Simplex<T, N>& simplex) noexcept {
  return with_nearest(
      simplex,
      [](auto... indices) {
        return CornerChoice{{indices...}, static_cast<int>(sizeof...(indices))};
      },
      [&] {
        return CornerChoice{{0, 1, 2, 3}, simplex.count};
      });
}

/// A vector perpendicular to a facet of N corners.
template <Number T>
[[nodiscard]] constexpr auto facet_normal(const Simplex<T, 2>& simplex) noexcept {
  const auto edge = simplex[1] - simplex[0];
  return Vec{edge.y, narrow_negative(edge.x)};
}
template <Number T>
[[nodiscard]] constexpr auto facet_normal(const Simplex<T, 3>& simplex) noexcept {
  return cross(simplex[1] - simplex[0], simplex[2] - simplex[0]);
}

/// Whether the point of a feature's span that is closest to the origin is in the feature's relative
/// interior.
template <Number T, int N>
[[nodiscard]] constexpr bool holds_foot(const Simplex<T, N>& feature) noexcept {
  if (feature.count == 2) {
    const auto edge = feature[0] - feature[1];
    return dot(edge, feature[1]) < 0 && dot(edge, feature[0]) > 0;
  }
  if constexpr (N == 3) {
    if (feature.count == 3) {
      const auto normal = facet_normal(feature);
      for (int i = 0; i < 3; ++i) {
        if (!(dot(normal, cross(feature[(i + 1) % 3], feature[(i + 2) % 3])) > 0)) return false;
      }
      return true;
    }
  }
  return feature.count == 1;
}

/// Returns f(v) for a vector v that points from the origin to the closest point of a feature of at
/// most N corners; v = 0 if the feature contains the origin.
template <Number T, int N, class F>
constexpr auto with_direction(const Simplex<T, N>& feature, const F& f) noexcept {
  const auto& corner = feature.newest();
  if (feature.count == 1) return f(corner);
  if constexpr (N == 3) {
    if (feature.count == 2) {
      const auto edge = feature[0] - corner;
      return f(corner * squared_length(edge) - edge * dot(edge, corner));
    }
  }
  auto normal = facet_normal(feature);
  const auto height = dot(normal, corner);
  for (int i = 0; i < N; ++i) {
    if (height == 0) normal[i] = decltype(normal.x)(0);
    if (height < 0) normal[i] = narrow_negative(normal[i]);
  }
  return f(normal);
}

/// The squared distance 0, in the type for points whose differences have components of type T.
template <Number T, int N>
[[nodiscard]] constexpr auto squared_distance_of_none() noexcept {
  using Normal = decltype(facet_normal(Simplex<T, N>()));
  using Height = decltype(dot(Normal(), Vec<T, N>()));
  using Under = decltype(squared_length(Normal()));
  return Fraction{Height() * Height(), Under(1)};
}

/// The squared distance from the origin to a feature, as a `Result` (a `Fraction`): |corner|^2,
/// |corner x edge|^2 / |edge|^2, (corner . normal)^2 / |normal|^2.
template <class Result, Number T, int N>
[[nodiscard]] constexpr Result squared_distance(const Simplex<T, N>& feature) noexcept {
  using Over = decltype(Result::numerator);
  using Under = decltype(Result::denominator);
  const auto& corner = feature.newest();
  if (feature.count == 1) return {Over(squared_length(corner)), Under(1)};
  if constexpr (N == 3) {
    if (feature.count == 2) {
      const auto edge = feature[0] - corner;
      return {Over(squared_length(cross(corner, edge))), Under(squared_length(edge))};
    }
  }
  const auto normal = facet_normal(feature);
  const auto height = dot(normal, corner);
  return {Over(height * height), Under(squared_length(normal))};
}

}  // namespace detent::detail
