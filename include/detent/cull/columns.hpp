// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

#include "detent/cull/quantized.hpp"
#include "detent/cull/walk.hpp"
#include "detent/math/direction.hpp"
#include "detent/shape/aabb.hpp"
#include "detent/shape/segment.hpp"

// Conservative culling of many boxes and rays, quantized to columns of small numbers. Compilers
// vectorize the loop over them. The remaining candidates are tested exactly, and nothing that meets
// is culled, so culling changes no result.

// Compilers limit inlining in a large source, and do not vectorize a loop with calls.
#if defined(__GNUC__)
#define DETENT_INLINE_CALLS __attribute__((flatten))
#else
#define DETENT_INLINE_CALLS
#endif

namespace detent::detail {

/// The number of shapes or rays in a block of columns.
inline constexpr std::size_t batch_lanes = 64;

template <class T, int N>
using Columns = std::array<std::array<T, batch_lanes>, static_cast<std::size_t>(N)>;

/// The quantized bounding box of a shape, from center - extent to center + extent.
template <Scalar S, int N>
struct LaneBox {
  Vec<quantized<S>, N> center, extent;

  /// A box that meets nothing, and a box for a shape that may be anywhere.
  [[nodiscard]] static constexpr LaneBox nowhere() noexcept {
    return {{}, make_vec<N>([](int) { return narrow_negative(quantized_limit<S>); })};
  }
  [[nodiscard]] static constexpr LaneBox anywhere() noexcept {
    return {{}, make_vec<N>([](int) { return quantized_limit<S>; })};
  }
};

/// A quantized part of a ray, in the box from middle - reach to middle + reach; `slope` is half the
/// direction.
template <Scalar S, int N>
struct LaneRay {
  Vec<quantized<S>, N> middle, reach;
  Vec<quantized_slope<S>, N> slope;

  /// A ray that meets nothing.
  [[nodiscard]] static constexpr LaneRay nowhere() noexcept {
    return {{}, LaneBox<S, N>::nowhere().extent, {}};
  }
};

template <Scalar S, int N>
struct BoxColumns {
  Columns<quantized<S>, N> center{}, extent{};

  constexpr void set(std::size_t l, const LaneBox<S, N>& box) noexcept {
    for (int i = 0; i < N; ++i) {
      center[static_cast<std::size_t>(i)][l] = box.center[i];
      extent[static_cast<std::size_t>(i)][l] = box.extent[i];
    }
  }
  [[nodiscard]] constexpr bool is_anywhere(std::size_t l) const noexcept {
    return extent[0][l] == quantized_limit<S>;
  }
};

template <Scalar S, int N>
struct RayColumns {
  Columns<quantized<S>, N> middle{}, reach{};
  Columns<quantized_slope<S>, N> slope{};

  constexpr void set(std::size_t l, const LaneRay<S, N>& ray) noexcept {
    for (int i = 0; i < N; ++i) {
      middle[static_cast<std::size_t>(i)][l] = ray.middle[i];
      reach[static_cast<std::size_t>(i)][l] = ray.reach[i];
      slope[static_cast<std::size_t>(i)][l] = ray.slope[i];
    }
  }
};

/// One box or ray in every lane. (clang multiplies 16 bits by 16 only if it loads both factors as
/// 16 bits from memory.)
template <class Block, class Item>
[[nodiscard]] constexpr Block repeated(const Item& item) noexcept {
  Block block;
  for (std::size_t l = 0; l < batch_lanes; ++l) block.set(l, item);
  return block;
}

/// Whether the ray of lane l certainly misses the box of lane l: an axis of the box separates them,
/// or an axis perpendicular to such an axis and the ray.
///
/// `slack` covers the rounding of a product's factors and of the product. In steps, |w| and the
/// extent each err by 3 along the ray's slope (at most 3 * 0.71 together), the slopes by 2^-16 (0.5
/// for each of two products, 0.25 for extents), and the four products by 1 each: 7.5 in all.
///
/// source: separating axes, Ericson, Real-Time Collision Detection, 5.3.3
template <Scalar S, int N>
[[nodiscard]] constexpr bool is_apart(const BoxColumns<S, N>& box, const RayColumns<S, N>& ray,
                                      std::size_t l, const quantized<S>& slack) noexcept {
  constexpr int bits = bits_of<quantized<S>>;
  constexpr std::size_t size = N;
  std::array<quantized<S>, size> w{}, extent{};
  std::array<quantized_slope<S>, size> slope{};
  bool result = false;
  for (std::size_t i = 0; i < size; ++i) {
    w[i] = narrow_difference<bits>(box.center[i][l], ray.middle[i][l]);
    extent[i] = box.extent[i][l];
    slope[i] = ray.slope[i][l];
    result |= narrow_difference<bits>(quantized_abs(w[i]), ray.reach[i][l]) > extent[i];
  }
  for (std::size_t i = N == 2 ? 2 : 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    const auto across = narrow_difference<bits>(quantized_product(w[j], slope[k]),
                                                quantized_product(w[k], slope[j]));
    const auto reach = narrow_sum<bits>(quantized_product(extent[j], quantized_abs(slope[k])),
                                        quantized_product(extent[k], quantized_abs(slope[j])));
    result |= quantized_abs(across) > narrow_sum<bits>(reach, slack);
  }
  return result;
}

/// The region in which boxes and rays are culled, and the grid to which they are quantized.
template <Scalar S, int N>
class BatchGrid {
 public:
  explicit constexpr BatchGrid(const Aabb<S, N>& box) noexcept : box_(box) {
    if (is_empty(box)) return;
    auto size = box.max[0] - box.min[0];
    auto reach = abs(box.max[0]);
    for (int i = 0; i < N; ++i) {
      size = (std::max)(size, box.max[i] - box.min[i]);
      reach = (std::max)({reach, abs(box.min[i]), abs(box.max[i])});
      center_[i] = floor_to<S>(half(box.min[i] + box.max[i]));
    }
    shift_ = quantized_shift(size);
    step_ = quantized_steps(1, reach);
    margin_ = quantized_steps(4, reach);
    slack_ = quantized_steps(8, reach);
  }

  [[nodiscard]] constexpr const quantized<S>& slack() const noexcept { return slack_; }

  [[nodiscard]] constexpr const Aabb<S, N>& region() const noexcept { return box_; }
  [[nodiscard]] constexpr bool holds(const Aabb<S, N>& box) const noexcept {
    for (int i = 0; i < N; ++i) {
      if (box.min[i] < box_.min[i] || box.max[i] > box_.max[i]) return false;
    }
    return true;
  }

  /// A box in the region, or an empty one. Its extent is enlarged by the possible error of a ray's
  /// position: 1.5 at its start and 2.5 at its end, and 0.5 in their middle.
  [[nodiscard]] constexpr LaneBox<S, N> quantize(const Aabb<S, N>& box) const noexcept {
    if (is_empty(box)) return LaneBox<S, N>::nowhere();
    LaneBox<S, N> result;
    for (int i = 0; i < N; ++i) {
      const auto low = floor(box.min[i], i);
      const auto high = narrow_sum<bits>(floor(box.max[i], i), step_);
      const auto center = middle(low, high);
      const auto extent =
          (std::max)(narrow_difference<bits>(high, center), narrow_difference<bits>(center, low));
      result.center[i] = center;
      result.extent[i] = narrow_sum<bits>(extent, margin_);
    }
    return result;
  }

  /// A part of a ray with this direction, in the region.
  [[nodiscard]] constexpr LaneRay<S, N> quantize(const Segment<S, N>& part,
                                                 const Direction<S, N>& direction) const noexcept {
    LaneRay<S, N> result;
    for (int i = 0; i < N; ++i) {
      const auto from = floor(part.start[i], i), to = floor(part.end[i], i);
      result.middle[i] = middle(from, to);
      result.reach[i] = (std::max)(quantized_abs(narrow_difference<bits>(from, result.middle[i])),
                                   quantized_abs(narrow_difference<bits>(to, result.middle[i])));
      result.slope[i] = quantized_half<S>(direction[i]);
    }
    return result;
  }

 private:
  static constexpr int bits = bits_of<quantized<S>>;

  [[nodiscard]] constexpr quantized<S> floor(const S& x, int i) const noexcept {
    return quantized_floor<S>(x - center_[i], shift_);
  }
  [[nodiscard]] static constexpr quantized<S> middle(const quantized<S>& a,
                                                     const quantized<S>& b) noexcept {
    return floor_to<quantized<S>>(half(a + b));
  }

  Aabb<S, N> box_;
  Vec<S, N> center_;
  int shift_ = 0;
  quantized<S> step_{}, margin_{}, slack_{};
};

/// The lanes of a block that are not culled.
class Candidates {
 public:
  /// Keeps the lanes l for which keep(l) holds.
  template <class Keep>
  DETENT_INLINE_CALLS constexpr void assign(const Keep& keep) noexcept {
    for (std::size_t l = 0; l < batch_lanes; ++l) kept_[l] = keep(l);
  }

  /// Visits the lanes in order: calls visit(l).
  template <class Visit>
  constexpr Walk walk(const Visit& visit) const noexcept {
    for (std::size_t first = 0; first < batch_lanes; first += group) {
      std::array<bool, group> lanes{};
      for (std::size_t l = 0; l < group; ++l) lanes[l] = kept_[first + l];
      if (std::bit_cast<std::uint64_t>(lanes) == 0) continue;
      for (std::size_t l = 0; l < group; ++l) {
        if (lanes[l] && visit(first + l) == Walk::stop) return Walk::stop;
      }
    }
    return Walk::go_on;
  }

 private:
  static constexpr std::size_t group = sizeof(std::uint64_t);
  std::array<bool, batch_lanes> kept_{};
};

}  // namespace detent::detail

#undef DETENT_INLINE_CALLS
