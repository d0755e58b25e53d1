// SPDX-License-Identifier: MIT
#pragma once

#include "detent/shape/aabb.hpp"
#include "detent/shape/hull.hpp"
#include "detent/shape/obb.hpp"

namespace detent::detail {

// Convex bodies as the search for their distance sees them: `some()` is one of the corners, all lie
// between `low()` and `high()`, and `extreme<Bits>(v, from, farthest)` is one that reaches as far
// along v as any, or else as little. A body that asks all of its corners measures them from a
// point `from`, and has the word that no component of a corner less `from` exceeds `Bits`.

/// A hull with at least one point.
template <Scalar S, int N>
class HullBody {
 public:
  static constexpr int dimension = N;

  explicit constexpr HullBody(const ConvexHull<S, N>& hull) noexcept : hull_(hull) {}

  [[nodiscard]] constexpr const Vec<S, N>& some() const noexcept { return hull_.points.front(); }
  [[nodiscard]] constexpr Vec<S, N> low() const noexcept {
    auto bound = some();
    for (const auto& point : hull_.points) {
      for (int i = 0; i < N; ++i) {
        if (point[i] < bound[i]) bound[i] = point[i];
      }
    }
    return bound;
  }
  [[nodiscard]] constexpr Vec<S, N> high() const noexcept {
    auto bound = some();
    for (const auto& point : hull_.points) {
      for (int i = 0; i < N; ++i) {
        if (point[i] > bound[i]) bound[i] = point[i];
      }
    }
    return bound;
  }

  template <int Bits, Number V, Number T>
  [[nodiscard]] constexpr const Vec<S, N>& extreme(const Vec<V, N>& v, const Vec<T, N>& from,
                                                   bool farthest) const noexcept {
    const auto along = [&](const Vec<S, N>& point) { return dot(v, narrow<Bits>(point - from)); };
    const Vec<S, N>* best = &hull_.points.front();
    auto reached = along(*best);
    for (const auto& point : hull_.points.subspan(1)) {
      const auto place = along(point);
      if (farthest ? place > reached : place < reached) {
        best = &point;
        reached = place;
      }
    }
    return *best;
  }

 private:
  ConvexHull<S, N> hull_;
};

/// A box that is not empty.
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

/// An oriented box that is not empty, read as its edges: center + sum s_i half_extents[i] axis(i).
template <Scalar S, int N>
class ObbBody {
 public:
  static constexpr int dimension = N;

  explicit constexpr ObbBody(const Obb<S, N>& box) noexcept : box_(box) {}

  [[nodiscard]] constexpr auto some() const noexcept {
    return corner([](int, int) { return true; });
  }
  [[nodiscard]] constexpr auto low() const noexcept {
    return corner([this](int i, int j) { return box_.rotation.axis(i)[j] < 0; });
  }
  [[nodiscard]] constexpr auto high() const noexcept {
    return corner([this](int i, int j) { return box_.rotation.axis(i)[j] > 0; });
  }

  template <int, Number V, class From>
  [[nodiscard]] constexpr auto extreme(const Vec<V, N>& v, const From&,
                                       bool farthest) const noexcept {
    std::array<bool, static_cast<std::size_t>(N)> is_added{};
    for (int i = 0; i < N; ++i) {
      is_added[static_cast<std::size_t>(i)] = (dot(v, box_.rotation.axis(i)) > 0) == farthest;
    }
    return corner([&](int i, int) { return is_added[static_cast<std::size_t>(i)]; });
  }

 private:
  /// Component j is the center's and half_extents[i] axis(i)[j], added where is_added(i, j) and
  /// subtracted elsewhere. No component of an axis exceeds 1, a raw 2^(b - 1) of b bits: with B
  /// bits of the others that is less than 2^(b - 1) (2^B + 3 2^B) = 2^(B + b + 1).
  template <class IsAdded>
  [[nodiscard]] constexpr auto corner(const IsAdded& is_added) const noexcept {
    constexpr int bits = bits_of<S> + bits_of<direction_component<S>> + 1;
    return make_vec<N>([&](int j) {
      const auto reach = make_vec<N>([&](int i) {
        const auto& half = box_.half_extents[i];
        return is_added(i, j) ? narrow<bits_of<S>>(half) : narrow<bits_of<S>>(-half);
      });
      const auto row = make_vec<N>([&](int i) { return box_.rotation.axis(i)[j]; });
      return narrow_sum<bits>(box_.center[j], narrow_dot<bits>(row, reach));
    });
  }

  Obb<S, N> box_;
};

}  // namespace detent::detail
