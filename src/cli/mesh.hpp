// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <vector>

#include "detent/detent.hpp"

namespace detent::cli {

/// Triangles in blocks of neighbours, each block with its box, which is asked first.
///
/// A box contains its triangles exactly, and both answers are exact for a `Fixed`, so asking the
/// box never loses a hit there. With `float` it may, as everything may.
template <Scalar S>
class Mesh {
 public:
  struct Hit {
    S distance;
    std::size_t triangle;  // its number in the file
  };

  explicit Mesh(std::vector<Triangle<S, 3>> triangles) : triangles_(std::move(triangles)) {
    order_.resize(triangles_.size());
    for (std::size_t i = 0; i < order_.size(); ++i) order_[i] = i;
    split(0, order_.size());
  }

  [[nodiscard]] const std::vector<Triangle<S, 3>>& triangles() const { return triangles_; }

  /// The nearest triangle; of equally near ones the first in the file.
  [[nodiscard]] std::optional<Hit> nearest(Ray<S, 3> ray) const {
    std::optional<Hit> best;
    for (const Block& block : blocks_) {
      if (!raycast(ray, block.box)) continue;
      for (std::size_t i = block.begin; i < block.end; ++i) {
        const auto distance = raycast(ray, triangles_[order_[i]]);
        if (!distance) continue;
        const bool nearer = !best || *distance < best->distance ||
                            (*distance == best->distance && order_[i] < best->triangle);
        if (!nearer) continue;
        best = Hit{*distance, order_[i]};
        ray.max_distance = *distance;
      }
    }
    return best;
  }

  [[nodiscard]] bool is_hit(const Ray<S, 3>& ray) const {
    for (const Block& block : blocks_) {
      if (!raycast(ray, block.box)) continue;
      for (std::size_t i = block.begin; i < block.end; ++i) {
        if (raycast(ray, triangles_[order_[i]])) return true;
      }
    }
    return false;
  }

 private:
  static constexpr std::size_t block_size = 24;

  struct Block {
    Aabb<S, 3> box;
    std::size_t begin;
    std::size_t end;
  };

  static void grow(Aabb<S, 3>& box, const Vec<S, 3>& point) {
    for (int i = 0; i < 3; ++i) {
      box.min[i] = std::min(box.min[i], point[i]);
      box.max[i] = std::max(box.max[i], point[i]);
    }
  }

  Aabb<S, 3> box_of(std::size_t begin, std::size_t end) const {
    const Vec<S, 3>& start = triangles_[order_[begin]].a;
    Aabb<S, 3> box{start, start};
    for (std::size_t i = begin; i < end; ++i) {
      const auto& triangle = triangles_[order_[i]];
      grow(box, triangle.a);
      grow(box, triangle.b);
      grow(box, triangle.c);
    }
    return box;
  }

  /// Halves [begin, end) across the longest side of its box until the parts are blocks.
  void split(std::size_t begin, std::size_t end) {
    if (begin == end) return;
    const Aabb<S, 3> box = box_of(begin, end);
    if (end - begin <= block_size) {
      blocks_.push_back({box, begin, end});
      return;
    }
    int axis = 0;
    for (int i = 1; i < 3; ++i) {
      if (box.max[i] - box.min[i] > box.max[axis] - box.min[axis]) axis = i;
    }
    const std::size_t middle = begin + (end - begin) / 2;
    const auto at = [&](std::size_t i) { return order_.begin() + static_cast<std::ptrdiff_t>(i); };
    std::nth_element(at(begin), at(middle), at(end), [&](std::size_t a, std::size_t b) {
      return triangles_[a].a[axis] < triangles_[b].a[axis];
    });
    split(begin, middle);
    split(middle, end);
  }

  std::vector<Triangle<S, 3>> triangles_;
  std::vector<std::size_t> order_;
  std::vector<Block> blocks_;
};

}  // namespace detent::cli
