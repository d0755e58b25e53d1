// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "exact.hpp"

namespace detent::cli {

/// Shapes for which only the first hit is needed: the triangles of a mesh, or a single shape.
///
/// A tree of boxes in doubles, which shares no code with the library's trees, finds the shapes that
/// a ray must be tested against exactly. The boxes are larger than the shapes by far more than the
/// error of a double, so no hit is lost.
class ExactGroup {
 public:
  explicit ExactGroup(std::vector<ExactShape> shapes);

  /// The smallest `first_hit` of the shapes.
  [[nodiscard]] std::optional<Integer> first_hit(const ExactShape& ray) const;

 private:
  struct Box {
    std::array<double, 3> low;
    std::array<double, 3> high;
  };
  struct Node {
    Box box;
    std::size_t shape;   // index of a leaf's shape
    std::size_t second;  // the other child (the first is the next node); 0 for a leaf
  };
  /// The ray in doubles, and its remaining length.
  struct Probe;

  [[nodiscard]] static Box box_around(const ExactShape& shape);
  void build(std::vector<std::pair<Box, std::size_t>>& items, std::size_t begin, std::size_t end);
  void search(std::size_t node, const ExactShape& ray, Probe& probe) const;

  std::vector<ExactShape> shapes_;
  std::vector<Node> nodes_;  // a node is followed by its whole subtree
};

}  // namespace detent::cli
