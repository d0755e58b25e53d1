// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <span>

#include "detent/query/batch/shapes.hpp"

namespace detent {

/// Many rays, for shapes that few of them hit.
///
/// It refers to the caller's rays and stores their parts within a box, `frame`, as columns of
/// 16-bit numbers, in blocks that the caller provides. A query with a shape in the frame uses the
/// columns to cull most rays, eight or more at a time, and casts the others one by one, so its
/// results are those of a loop over all rays. With other shapes it casts every ray.
///
/// domain: every shape except compounds
template <Scalar S, int N>
class RayBatch {
 public:
  using Block = detail::RayColumns<S, N>;

  /// A batch of `rays` that start in or near `frame`, with columns in `blocks`.
  constexpr RayBatch(std::span<const Ray<S, N>> rays, const Aabb<S, N>& frame,
                     std::span<Block> blocks) noexcept
      : rays_(rays),
        blocks_(blocks.first((std::min)(blocks.size(), batch_blocks(size())))),
        grid_(frame) {
    for (std::size_t i = 0; i < blocks_.size() * detail::batch_lanes; ++i) {
      auto ray = detail::LaneRay<S, N>::nowhere();
      if (i < size()) ray = detail::quantized_part(rays[i], grid_).value_or(ray);
      blocks[i / detail::batch_lanes].set(i % detail::batch_lanes, ray);
    }
  }

  [[nodiscard]] constexpr std::size_t size() const noexcept { return rays_.size(); }
  [[nodiscard]] constexpr const Ray<S, N>& operator[](std::size_t i) const noexcept {
    return rays_[i];
  }

  /// Visits every ray that may touch `shape`, in ascending order: calls visit(i), which returns
  /// whether to go on (cull/walk.hpp).
  template <class Shape, class Visit>
  constexpr Walk visit_candidates(const Shape& shape, const Visit& visit) const noexcept {
    std::size_t asked = 0;
    const auto bounds = detail::ray_bounds(shape);
    if (bounds && grid_.holds(*bounds)) {
      const auto boxes = detail::repeated<detail::BoxColumns<S, N>>(grid_.quantize(*bounds));
      const auto slack = grid_.slack();
      detail::Candidates candidates;
      for (std::size_t b = 0; b < blocks_.size(); ++b, asked += detail::batch_lanes) {
        const auto& block = blocks_[b];
        candidates.assign([&](std::size_t l) { return !is_apart(boxes, block, l, slack); });
        const Walk walk = candidates.walk([&](std::size_t l) { return visit(asked + l); });
        if (walk == Walk::stop) return Walk::stop;
      }
    }
    for (std::size_t i = asked; i < size(); ++i) {
      if (visit(i) == Walk::stop) return Walk::stop;
    }
    return Walk::go_on;
  }

 private:
  std::span<const Ray<S, N>> rays_;
  std::span<const Block> blocks_;
  detail::BatchGrid<S, N> grid_;
};

/// Whether any ray of a batch touches `shape`.
///
/// domain: every input
/// exact:  like `raycast`, which gets the `options`                    (tests/query/batch.test.cpp)
template <Scalar S, int N, class Shape, class... Options>
[[nodiscard]] constexpr bool raycast_any(const RayBatch<S, N>& batch, const Shape& shape,
                                         const Options&... options) noexcept {
  bool any = false;
  batch.visit_candidates(shape, [&](std::size_t i) {
    any = raycast(batch[i], shape, options...).has_value();
    return stop_if(any);
  });
  return any;
}

/// Writes the result of `raycast` for each ray of a batch, as many as fit `answers`.
template <Scalar S, int N, class Shape, class... Options>
constexpr void raycast_each(const RayBatch<S, N>& batch, const Shape& shape,
                            std::span<std::optional<S>> answers,
                            const Options&... options) noexcept {
  for (auto& answer : answers) answer.reset();
  batch.visit_candidates(shape, [&](std::size_t i) {
    if (i >= answers.size()) return Walk::stop;
    answers[i] = raycast(batch[i], shape, options...);
    return Walk::go_on;
  });
}

}  // namespace detent
