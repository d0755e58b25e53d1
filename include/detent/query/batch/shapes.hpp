// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <span>

#include "detent/query/batch/bounds.hpp"

namespace detent {

/// The number of blocks for the columns of `count` shapes or rays.
[[nodiscard]] constexpr std::size_t batch_blocks(std::size_t count) noexcept {
  return (count + detail::batch_lanes - 1) / detail::batch_lanes;
}

/// Many shapes of one type, for rays that hit few of them.
///
/// It refers to the caller's shapes and stores their bounding boxes as columns of 16-bit numbers,
/// in blocks that the caller provides; shapes that do not fit the blocks are not culled. A query
/// uses the columns to cull most shapes, eight or more at a time, and tests the others one by one,
/// so its results are those of a loop over all shapes.
///
/// domain: every shape except compounds; planes, boxes with skewed axes and shapes that reach an
///         end of the scalar's range are never culled
template <class Shape>
class ShapeBatch;

/// For shapes of one scalar and dimension.
template <template <Scalar, int> class Shape, Scalar S, int N>
class ShapeBatch<Shape<S, N>> {
 public:
  using Block = detail::BoxColumns<S, N>;

  /// A batch of `shapes`, with columns in `blocks`: see `batch_blocks`.
  constexpr ShapeBatch(std::span<const Shape<S, N>> shapes, std::span<Block> blocks) noexcept
      : shapes_(shapes), blocks_(blocks.first((std::min)(blocks.size(), batch_blocks(size())))) {
    auto around = detail::no_box<Aabb<S, N>>;
    for (const auto& shape : shapes) {
      const auto bounds = detail::ray_bounds(shape);
      if (bounds) around = bounding_box(around, *bounds);
    }
    grid_ = detail::BatchGrid<S, N>(around);
    for (std::size_t i = 0; i < blocks_.size() * detail::batch_lanes; ++i) {
      auto box = detail::LaneBox<S, N>::nowhere();
      if (i < size()) {
        const auto bounds = detail::ray_bounds(shapes[i]);
        box = bounds ? grid_.quantize(*bounds) : detail::LaneBox<S, N>::anywhere();
      }
      blocks[i / detail::batch_lanes].set(i % detail::batch_lanes, box);
    }
  }

  [[nodiscard]] constexpr std::size_t size() const noexcept { return shapes_.size(); }
  [[nodiscard]] constexpr const Shape<S, N>& operator[](std::size_t i) const noexcept {
    return shapes_[i];
  }

  /// Visits every shape that `ray` may touch within its max_distance, in ascending order: calls
  /// visit(i, limit), which returns whether to go on and may lower the limit (cull/walk.hpp).
  template <class Visit>
  constexpr Walk visit_candidates(Ray<S, N> ray, const Visit& visit) const noexcept {
    detail::RayColumns<S, N> rays;
    const auto look = [&] {
      const auto quantized_ray = detail::quantized_part(ray, grid_);
      if (quantized_ray) rays = detail::repeated<detail::RayColumns<S, N>>(*quantized_ray);
      return quantized_ray.has_value();
    };
    bool is_in_region = look();
    detail::Candidates candidates;
    for (std::size_t b = 0; b < blocks_.size(); ++b) {
      const auto& block = blocks_[b];
      if (is_in_region) {
        const auto slack = grid_.slack();
        candidates.assign([&](std::size_t l) { return !is_apart(block, rays, l, slack); });
      } else {
        candidates.assign([&](std::size_t l) { return block.is_anywhere(l); });
      }
      const S reach = ray.max_distance;
      const Walk walk = candidates.walk(
          [&](std::size_t l) { return visit(b * detail::batch_lanes + l, ray.max_distance); });
      if (walk == Walk::stop) return Walk::stop;
      if (ray.max_distance != reach) is_in_region = look();
    }
    for (std::size_t i = blocks_.size() * detail::batch_lanes; i < size(); ++i) {
      if (visit(i, ray.max_distance) == Walk::stop) return Walk::stop;
    }
    return Walk::go_on;
  }

 private:
  std::span<const Shape<S, N>> shapes_;
  std::span<const Block> blocks_;
  detail::BatchGrid<S, N> grid_{detail::no_box<Aabb<S, N>>};
};

/// The first hit of a ray in a batch.
template <Scalar S>
struct BatchHit {
  std::size_t index = 0;
  S distance{};

  [[nodiscard]] friend constexpr bool operator==(const BatchHit&,
                                                 const BatchHit&) noexcept = default;
};

/// The shape that `ray` touches first, or nothing; ties go to the first shape.
///
/// units:  lengths in world units; direction is unit length
/// domain: every input
/// result: the least distance that `raycast` returns for any shape; `options` are passed to it
/// exact:  like `raycast`                                              (tests/query/batch.test.cpp)
template <Scalar S, int N, class Shape, class... Options>
[[nodiscard]] constexpr std::optional<BatchHit<S>> raycast_first(
    const Ray<S, N>& ray, const ShapeBatch<Shape>& batch, const Options&... options) noexcept {
  std::optional<BatchHit<S>> first;
  batch.visit_candidates(ray, [&](std::size_t i, S& limit) {
    const auto distance = raycast(ray, batch[i], options...);
    if (distance && (!first || *distance < first->distance)) {
      first = BatchHit<S>{i, *distance};
      limit = *distance;
    }
    return stop_if(first && first->distance == 0);
  });
  return first;
}

/// Whether `ray` touches any shape of a batch.
template <Scalar S, int N, class Shape, class... Options>
[[nodiscard]] constexpr bool raycast_any(const Ray<S, N>& ray, const ShapeBatch<Shape>& batch,
                                         const Options&... options) noexcept {
  bool any = false;
  batch.visit_candidates(ray, [&](std::size_t i, S&) {
    any = raycast(ray, batch[i], options...).has_value();
    return stop_if(any);
  });
  return any;
}

/// Writes the result of `raycast` for each shape of a batch, as many as fit `answers`.
template <Scalar S, int N, class Shape, class... Options>
constexpr void raycast_each(const Ray<S, N>& ray, const ShapeBatch<Shape>& batch,
                            std::span<std::optional<S>> answers,
                            const Options&... options) noexcept {
  for (auto& answer : answers) answer.reset();
  batch.visit_candidates(ray, [&](std::size_t i, S&) {
    if (i >= answers.size()) return Walk::stop;
    answers[i] = raycast(ray, batch[i], options...);
    return Walk::go_on;
  });
}

}  // namespace detent
