// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "oracle.hpp"

namespace detent::cli::oracle {

/// Shapes of which the first one hit counts: the triangles of a mesh, or a shape alone.
///
/// A tree of boxes in doubles, which shares no code with the library's trees either, says which of
/// them a ray has to be held against exactly. The boxes are larger than the shapes by far more than
/// the error of a double, so it never hides a hit.
class Group {
 public:
  explicit Group(std::vector<Shape> shapes);

  /// The least of what `first_hit` gives for the shapes.
  [[nodiscard]] std::optional<Integer> first_hit(const Ray& ray) const;

 private:
  struct Box {
    std::array<double, 3> low;
    std::array<double, 3> high;
  };
  struct Node {
    Box box;
    std::size_t shape;   // of a leaf
    std::size_t second;  // the other child beside the next node; 0 for a leaf
  };
  /// The ray in doubles, and how far it still matters.
  struct Probe;

  [[nodiscard]] static Box box_around(const Shape& shape);
  void build(std::vector<std::pair<Box, std::size_t>>& items, std::size_t begin, std::size_t end);
  void search(std::size_t node, const Ray& ray, Probe& probe) const;

  std::vector<Shape> shapes_;
  std::vector<Node> nodes_;  // a node is followed by all that is below it
};

}  // namespace detent::cli::oracle
