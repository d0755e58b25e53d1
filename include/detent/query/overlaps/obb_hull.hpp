// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>

#include "detent/query/distance/gjk.hpp"
#include "detent/shape/obb.hpp"

namespace detent {

namespace detail {

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
        return is_added(i, j) ? narrow<bits_of<S>>(half) : narrow_negative(half);
      });
      const auto row = make_vec<N>([&](int i) { return box_.rotation.axis(i)[j]; });
      return narrow_sum<bits>(box_.center[j], narrow_dot<bits>(row, reach));
    });
  }

  Obb<S, N> box_;
};

}  // namespace detail

/// Whether `box` and `hull` have a point in common.
///
/// The box is what its edges span, {center + sum s_i half_extents[i] axis(i) : |s_i| <= 1}, with the
/// axes exactly as stored.
///
/// domain: every input; an empty box or hull overlaps nothing
/// exact:  yes or no exact; touching counts                         (tests/oracle/obb_hull.test.cpp)
template <Scalar S, int N>
[[nodiscard]] constexpr bool overlaps(const Obb<S, N>& box, const ConvexHull<S, N>& hull) noexcept {
  if (is_empty(box) || is_empty(hull)) return false;
  return detail::bodies_overlap(detail::ObbBody(box), detail::HullBody(hull));
}
template <Scalar S, int N>
[[nodiscard]] constexpr bool overlaps(const ConvexHull<S, N>& hull, const Obb<S, N>& box) noexcept {
  return overlaps(box, hull);
}

}  // namespace detent
