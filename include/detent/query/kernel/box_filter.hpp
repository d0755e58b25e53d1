// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <type_traits>

#include "detent/math/orthonormal.hpp"
#include "detent/number/filter/filtered.hpp"
#include "detent/query/kernel/box.hpp"
#include "detent/shape/aabb.hpp"
#include "detent/shape/obb.hpp"

namespace detent::detail {

/// The cosine of the angle between two axes, truncated to 28 bits so that products with 32-bit
/// coordinates fit 64.
using ShortCosine = Fixed<29, 28>;

/// The axes of a rotation as the edges of a box, without the normals of its faces.
template <Scalar S, int N>
class AxisFrame {
 public:
  explicit constexpr AxisFrame(const Rotation<S, N>& rotation) noexcept : rotation_(rotation) {}

  [[nodiscard]] constexpr const Rotation<S, N>& rotation() const noexcept { return rotation_; }
  [[nodiscard]] constexpr const auto& edge(int i) const noexcept { return rotation_.axis(i); }
  template <Number T>
  [[nodiscard]] constexpr auto along(int i, const Vec<T, N>& v) const noexcept {
    return dot(edge(i), v);
  }

 private:
  const Rotation<S, N>& rotation_;
};

/// Whether every two axes are perpendicular within 2^-26.
constexpr bool is_square(const WorldFrame&) noexcept { return true; }
template <Scalar S, int N>
constexpr bool is_square(const AxisFrame<S, N>& frame) noexcept {
  return are_perpendicular<26>(frame.rotation());
}

/// The error of slacks for half extents with the sum `sum`: 2^-18 of that, plus 8 steps.
template <Number Sum>
[[nodiscard]] constexpr auto box_error(const Sum& sum) noexcept {
  return narrow<34>(scale_down<34>(sum, 18) + Fixed<34, Sum::frac>::from_raw(8));
}

/// The least f(i) over N axes i. `f` takes i as a constant, so that compilers unroll the loop.
template <int N, class F>
[[nodiscard]] constexpr auto least_of(const F& f) noexcept {
  const auto x = f(std::integral_constant<int, 0>()), y = f(std::integral_constant<int, 1>());
  if constexpr (N == 2) {
    return (std::min)(x, y);
  } else {
    return (std::min)((std::min)(x, y), f(std::integral_constant<int, 2>()));
  }
}

/// Filter in 64 bits: whether two boxes overlap; `apart` leads from one center to the other. Each
/// length may be too small by up to half a step (docs/filters.md, lemma 5).
///
/// source: separating axes by cosines, Ericson, Real-Time Collision Detection, 4.4.1
template <class Frame, Scalar S, Number H, Number T, int N>
[[nodiscard]] constexpr Filtered decide_boxes_overlap(const Frame& a, const Vec<H, N>& half_a,
                                                      const AxisFrame<S, N>& b,
                                                      const Vec<H, N>& half_b,
                                                      const Vec<T, N>& apart) noexcept {
  constexpr auto size = static_cast<std::size_t>(N);
  if (!is_square(a)) return Filtered::unsure;
  using Place = Fixed<34, T::frac>;
  using Slack = Fixed<63, T::frac + ShortCosine::frac>;
  constexpr int bits = 62;  // of all sums of two or three products: they are below 2^61
  auto sum = narrow<36>(half_a[0] + half_b[0]);
  for (int i = 1; i < N; ++i) sum = narrow<36>(sum + half_a[i] + half_b[i]);
  const Slack error = box_error(sum);
  const auto separates = [&](const Slack& least) {
    return decide(Approximate{least, error}) == Filtered::no;
  };
  const auto slack = [](const auto& reach, const auto& place) -> Slack {
    return narrow_difference<63>(reach, abs(place));
  };

  std::array<Vec<ShortCosine, N>, size> cosines, lengths;  // [j][i]: edge j of b, edge i of a
  Vec<Place, N> along_a;
  for (int j = 0; j < N; ++j) {
    const auto k = static_cast<std::size_t>(j);
    cosines[k] =
        make_vec<N>([&](int i) { return narrow_floor<ShortCosine>(a.along(i, b.edge(j).vec())); });
    lengths[k] = make_vec<N>([&](int i) { return abs(cosines[k][i]); });
  }
  const auto faces_a = least_of<N>([&](auto i) {
    const auto row = make_vec<N>([&](int j) { return lengths[static_cast<std::size_t>(j)][i]; });
    along_a[i] = narrow_floor<Place>(a.along(i, apart));
    return slack(narrow_sum<bits>(half_a[i], narrow_dot<bits>(half_b, row)), along_a[i]);
  });
  if (separates(faces_a)) return Filtered::no;  // whatever the axes of b are
  if (!is_square(b)) return Filtered::unsure;
  const auto faces_b = least_of<N>([&](auto j) {
    const auto along_b = narrow_floor<Place>(b.along(j, apart));
    return slack(narrow_sum<bits>(half_b[j], narrow_dot<bits>(half_a, lengths[j])), along_b);
  });
  if (separates(faces_b)) return Filtered::no;
  auto least = (std::min)(faces_a, faces_b);
  if constexpr (N == 3) {
    const auto edges = least_of<3>([&](auto j) {
      return least_of<3>([&](auto i) {
        constexpr int i1 = (i + 1) % 3, i2 = (i + 2) % 3, j1 = (j + 1) % 3, j2 = (j + 2) % 3;
        const auto reach_a =
            narrow_dot<bits>(Vec{half_a[i1], half_a[i2]}, Vec{lengths[j][i2], lengths[j][i1]});
        const auto reach_b =
            narrow_dot<bits>(Vec{half_b[j1], half_b[j2]}, Vec{lengths[j2][i], lengths[j1][i]});
        const auto place =
            narrow_cross<bits>(Vec{cosines[j][i1], cosines[j][i2]}, Vec{along_a[i1], along_a[i2]});
        const bool is_parallel = lengths[j][i1] + lengths[j][i2] <= ShortCosine::from_raw(8);
        return is_parallel ? error : slack(narrow_sum<bits>(reach_a, reach_b), place);
      });
    });
    least = (std::min)(least, edges);
  }
  return decide(Approximate{least, error});
}

template <Scalar S, int N>
[[nodiscard]] constexpr Filtered decide_boxes_overlap(const Obb<S, N>& a,
                                                      const Obb<S, N>& b) noexcept {
  return decide_boxes_overlap(AxisFrame(a.rotation), a.half_extents, AxisFrame(b.rotation),
                              b.half_extents, b.center - a.center);
}
template <Scalar S, int N>
[[nodiscard]] constexpr Filtered decide_boxes_overlap(const Aabb<S, N>& a,
                                                      const Obb<S, N>& b) noexcept {
  // Doubled, so that both centers are on the grid, and halved.
  const auto halved = [](const auto& v) {
    return make_vec<N>([&](int i) { return scale_down<bits_of<S> + 1>(v[i], 1); });
  };
  return decide_boxes_overlap(WorldFrame(), halved(a.max - a.min), AxisFrame(b.rotation),
                              halved(b.half_extents + b.half_extents),
                              halved(b.center + b.center - (a.min + a.max)));
}
template <Scalar S, int N>
[[nodiscard]] constexpr Filtered decide_boxes_overlap(const Obb<S, N>& a,
                                                      const Aabb<S, N>& b) noexcept {
  return decide_boxes_overlap(b, a);
}

}  // namespace detent::detail
