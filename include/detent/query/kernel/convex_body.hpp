// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <type_traits>

#include "detent/query/kernel/support.hpp"
#include "detent/shape/aabb.hpp"
#include "detent/shape/obb.hpp"
#include "detent/shape/segment.hpp"
#include "detent/shape/triangle.hpp"

namespace detent::detail {

/// On each axis, the end of a box that is extreme along v: the upper, the lower, or, if v is
/// perpendicular, both. Calls f with every choice of ends: an array, true for the upper one.
template <int N, class AlongV, class F>
constexpr void for_each_extreme_end(const AlongV& along, bool farthest, const F& f) noexcept {
  std::array<bool, static_cast<std::size_t>(N)> is_upper{};
  for (int choice = 0; choice < 1 << N; ++choice) {
    bool is_new = true;
    for (int i = 0; i < N; ++i) {
      const bool bit = (choice >> i & 1) != 0;
      const auto here = along(i);
      is_upper[static_cast<std::size_t>(i)] = here == 0 ? bit : (here > 0) == farthest;
      is_new = is_new && (here == 0 || !bit);
    }
    if (is_new) f(is_upper);
  }
}

/// The corners of a box, corner(sides) for all choices of sides: bit i is set on the upper side of
/// axis i.
template <int N, class Corner>
[[nodiscard]] constexpr auto corners_by_sides(const Corner& corner) noexcept {
  std::array<decltype(corner(0)), std::size_t{1} << N> corners{};
  for (std::size_t sides = 0; sides < corners.size(); ++sides) corners[sides] = corner(sides);
  return corners;
}

/// A positive number with few bits on the grid of T.
template <Number T>
[[nodiscard]] constexpr auto least_of() noexcept {
  if constexpr (is_fixed<T>) {
    return Fixed<1, T::frac>::from_raw(1);
  } else {
    return T(1);
  }
}

/// Whether a body is a box: `span(i)` leads from one end to the other on axis i, `doubled_middle()`
/// is twice the middle, and `corner(sides)` is as in `corners_by_sides`.
template <class Body>
concept IsBoxBody = requires(const Body& body) {
  body.doubled_middle();
  body.span(0);
};

/// A nonempty box, from `low` to `high`, as a convex body for GJK.
template <Number S, int N>
class AabbBody {
 public:
  static constexpr int dimension = N;

  constexpr AabbBody(const Vec<S, N>& low, const Vec<S, N>& high) noexcept
      : low_(low), high_(high) {}
  template <class Box>
  explicit constexpr AabbBody(const Box& box) noexcept : low_(box.min), high_(box.max) {}

  [[nodiscard]] constexpr auto corners() const noexcept {
    return corners_by_sides<N>([this](std::size_t sides) { return corner(sides); });
  }
  [[nodiscard]] constexpr Vec<S, N> corner(std::size_t sides) const noexcept {
    return make_vec<N>([&](int i) { return (sides >> i & 1) != 0 ? high_[i] : low_[i]; });
  }
  [[nodiscard]] constexpr const Vec<S, N>& some() const noexcept { return low_; }
  [[nodiscard]] constexpr const Vec<S, N>& low() const noexcept { return low_; }
  [[nodiscard]] constexpr const Vec<S, N>& high() const noexcept { return high_; }

  [[nodiscard]] constexpr auto doubled_middle() const noexcept { return low_ + high_; }
  [[nodiscard]] constexpr auto span(int i) const noexcept {
    Vec<decltype(S() - S()), N> result{};
    result[i] = high_[i] - low_[i];
    return result;
  }

  static constexpr bool has_few_edges() noexcept { return true; }
  using Edge = Vec<decltype(least_of<S>()), N>;
  template <class F>
  static constexpr void for_each_edge(const F& f) noexcept {
    for (int i = 0; i < N; ++i) {
      Edge edge{};
      edge[i] = least_of<S>();
      f(edge);
    }
  }

  template <int, Number V, Number T>
  [[nodiscard]] constexpr Vec<S, N> extreme(const Vec<V, N>& v, const Vec<T, N>&,
                                            bool farthest) const noexcept {
    return make_vec<N>([&](int i) { return (v[i] > 0) == farthest ? high_[i] : low_[i]; });
  }

  template <int, Number V, Number T, class F>
  constexpr void for_each_extreme(const Vec<V, N>& v, const Vec<T, N>&, bool farthest,
                                  const F& f) const noexcept {
    const auto along = [&](int i) { return v[i]; };
    for_each_extreme_end<N>(along, farthest, [&](const auto& is_upper) {
      f(make_vec<N>(
          [&](int i) { return is_upper[static_cast<std::size_t>(i)] ? high_[i] : low_[i]; }));
    });
  }

 private:
  Vec<S, N> low_, high_;
};
template <Scalar S, int N>
AabbBody(const Aabb<S, N>&) -> AabbBody<S, N>;
template <Number S, int N>
AabbBody(const Vec<S, N>&, const Vec<S, N>&) -> AabbBody<S, N>;

/// The body {center + sum s_i edges[i] : |s_i| <= 1}; `senses[i]` points the same way as edges[i].
///
/// With b bits, the center is below 2^b and a component of an edge at most 2^b, so the components
/// of a corner are below 2^(b + 2).
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

  [[nodiscard]] constexpr auto corners() const noexcept {
    return corners_by_sides<N>([this](std::size_t sides) { return corner(sides); });
  }
  [[nodiscard]] constexpr auto corner(std::size_t sides) const noexcept {
    return corner([&](int i, int) { return (sides >> i & 1) != 0; });
  }
  [[nodiscard]] constexpr auto some() const noexcept {
    return corner([](int, int) { return true; });
  }
  [[nodiscard]] constexpr auto low() const noexcept {
    return make_vec<N>([&](int j) { return narrow_difference<bits>(center_[j], reach(j)); });
  }
  [[nodiscard]] constexpr auto high() const noexcept {
    return make_vec<N>([&](int j) { return narrow_sum<bits>(center_[j], reach(j)); });
  }

  [[nodiscard]] constexpr auto doubled_middle() const noexcept { return center_ + center_; }
  [[nodiscard]] constexpr auto span(int i) const noexcept { return edge(i) + edge(i); }

  static constexpr bool has_few_edges() noexcept { return true; }
  using Edge = Vec<V, N>;
  template <class F>
  constexpr void for_each_edge(const F& f) const noexcept {
    for (const auto& sense : senses_) f(sense);
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

  template <int, Number D, class From, class F>
  constexpr void for_each_extreme(const Vec<D, N>& v, const From&, bool farthest,
                                  const F& f) const noexcept {
    const auto along =
        make_vec<N>([&](int i) { return dot(v, senses_[static_cast<std::size_t>(i)]); });
    for_each_extreme_end<N>(
        [&](int i) { return along[i]; }, farthest,
        [&](const auto& is_added) {
          f(corner([&](int i, int) { return is_added[static_cast<std::size_t>(i)]; }));
        });
  }

 private:
  static constexpr int bits = bits_of<E> + 2;
  using Corner = decltype(narrow_sum<bits>(E(), E()));

  [[nodiscard]] constexpr const Vec<E, N>& edge(int i) const noexcept {
    return edges_[static_cast<std::size_t>(i)];
  }
  /// How far component j of a corner is from that of the center at most.
  [[nodiscard]] constexpr auto reach(int j) const noexcept {
    auto sum = narrow<bits>(abs(edge(0)[j]) + abs(edge(1)[j]));
    if constexpr (N == 3) sum = narrow<bits>(sum + abs(edge(2)[j]));
    return sum;
  }
  /// In component j: the center, plus each edge i with is_added(i, j), minus the others.
  template <class IsAdded>
  requires std::is_invocable_v<const IsAdded&, int, int>
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

// body_of(shape): a point or a nonempty polytope as a convex body for GJK (see support.hpp). An
// oriented box is the one that its edges span.

template <Number S, int N>
[[nodiscard]] constexpr auto body_of(const Vec<S, N>& point) noexcept {
  return HullBody(std::array{point});
}
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
