// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>

#include "detent/query/kernel/support.hpp"
#include "detent/shape/aabb.hpp"
#include "detent/shape/obb.hpp"
#include "detent/shape/segment.hpp"
#include "detent/shape/triangle.hpp"

namespace detent::detail {

/// A nonempty box as a convex body for GJK.
template <Scalar S, int N>
class AabbBody {
 public:
  static constexpr int dimension = N;

  explicit constexpr AabbBody(const Aabb<S, N>& box) noexcept : box_(box) {}

  [[nodiscard]] constexpr const Vec<S, N>& some() const noexcept { return box_.min; }
  [[nodiscard]] constexpr const Vec<S, N>& low() const noexcept { return box_.min; }
  [[nodiscard]] constexpr const Vec<S, N>& high() const noexcept { return box_.max; }

  template <int, Number V, Number T>
  [[nodiscard]] constexpr Vec<S, N> extreme(const Vec<V, N>& v, const Vec<T, N>&,
                                            bool farthest) const noexcept {
    return make_vec<N>([&](int i) { return (v[i] > 0) == farthest ? box_.max[i] : box_.min[i]; });
  }

 private:
  Aabb<S, N> box_;
};

/// The body {center + sum s_i edges[i] : |s_i| <= 1}; `senses[i]` points the same way as edges[i].
///
/// The center is below 2^b and a component of an edge at most 2^b in numbers of b bits, so the
/// components of a corner are below 2^(b + 2).
template <Number E, Number V, int N>
class SpannedBody {
 public:
  static constexpr int dimension = N;
  template <class T>
  using Each = std::array<Vec<T, N>, static_cast<std::size_t>(N)>;

  template <Scalar S>
  constexpr SpannedBody(const Vec<S, N>& center, const Each<E>& edges,
                        const Each<V>& senses) noexcept
      : center_(make_vec<N>([&](int j) { return narrow_sum<bits>(center[j], E(0)); })),
        edges_(edges),
        senses_(senses) {}

  [[nodiscard]] constexpr auto some() const noexcept {
    return corner([](int, int) { return true; });
  }
  [[nodiscard]] constexpr auto low() const noexcept {
    return corner([this](int i, int j) { return edge(i)[j] < 0; });
  }
  [[nodiscard]] constexpr auto high() const noexcept {
    return corner([this](int i, int j) { return edge(i)[j] > 0; });
  }

  template <int, Number D, class From>
  [[nodiscard]] constexpr auto extreme(const Vec<D, N>& v, const From&,
                                       bool farthest) const noexcept {
    std::array<bool, static_cast<std::size_t>(N)> is_added{};
    for (std::size_t i = 0; i < is_added.size(); ++i) {
      is_added[i] = (dot(v, senses_[i]) > 0) == farthest;
    }
    return corner([&](int i, int) { return is_added[static_cast<std::size_t>(i)]; });
  }

 private:
  static constexpr int bits = bits_of<E> + 2;
  using Corner = decltype(narrow_sum<bits>(E(), E()));

  [[nodiscard]] constexpr const Vec<E, N>& edge(int i) const noexcept {
    return edges_[static_cast<std::size_t>(i)];
  }
  /// In component j: the center, plus each edge i with is_added(i, j), minus the others.
  template <class IsAdded>
  [[nodiscard]] constexpr auto corner(const IsAdded& is_added) const noexcept {
    auto result = center_;
    for (int j = 0; j < N; ++j) {
      for (int i = 0; i < N; ++i) {
        result[j] = is_added(i, j) ? narrow_sum<bits>(result[j], edge(i)[j])
                                   : narrow_difference<bits>(result[j], edge(i)[j]);
      }
    }
    return result;
  }

  Vec<Corner, N> center_;
  Each<E> edges_;
  Each<V> senses_;
};

/// A nonempty oriented box as the body that its edges, half_extents[i] axis(i), span.
template <Scalar S, int N>
[[nodiscard]] constexpr auto edge_body(const Obb<S, N>& box) noexcept {
  using Component = direction_component<S>;
  constexpr int bits = bits_of<S> + bits_of<Component> - 1;  // no component exceeds 1
  using Edge = decltype(narrow_product<bits>(S(), Component()));
  using Body = SpannedBody<Edge, Component, N>;
  typename Body::template Each<Edge> edges;
  typename Body::template Each<Component> senses;
  for (int i = 0; i < N; ++i) {
    const auto k = static_cast<std::size_t>(i);
    senses[k] = box.rotation.axis(i).vec();
    edges[k] =
        make_vec<N>([&](int j) { return narrow_product<bits>(box.half_extents[i], senses[k][j]); });
  }
  return Body(box.center, edges, senses);
}

// body_of(shape): a nonempty polytope as a convex body for GJK (see support.hpp). An oriented box
// is what its edges span.

template <Scalar S, int N>
[[nodiscard]] constexpr auto body_of(const Segment<S, N>& segment) noexcept {
  return HullBody(std::array{segment.start, segment.end});
}
template <Scalar S, int N>
[[nodiscard]] constexpr auto body_of(const Triangle<S, N>& triangle) noexcept {
  return HullBody(std::array{triangle.a, triangle.b, triangle.c});
}
template <Scalar S, int N>
[[nodiscard]] constexpr auto body_of(const Aabb<S, N>& box) noexcept {
  return AabbBody(box);
}
template <Scalar S, int N>
[[nodiscard]] constexpr auto body_of(const Obb<S, N>& box) noexcept {
  return edge_body(box);
}
template <Scalar S, int N>
[[nodiscard]] constexpr auto body_of(const ConvexHull<S, N>& hull) noexcept {
  return HullBody(hull);
}

}  // namespace detent::detail
