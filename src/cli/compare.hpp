// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "image.hpp"
#include "tracer.hpp"

namespace detent::cli {

/// Where two scalars differ over the same rays.
struct Difference {
  std::size_t hit_or_miss = 0;  // one hits, the other does not
  std::size_t shape = 0;        // both hit, but not the same shape
  std::size_t distance = 0;     // the same shape, more than `visible_distance` apart
  double largest_distance = 0;  // between hits of the same shape
  std::size_t largest_ray = 0;

  [[nodiscard]] std::size_t disagreements() const { return hit_or_miss + shape; }
};

inline constexpr double visible_distance = 1.0 / 64;

[[nodiscard]] Difference compare(const Tracer& a, const Tracer& b);

/// A dark copy of `picture` that marks the pixels whose results differ: bright for hit or miss or
/// for another shape, dimmer for distances farther apart than `visible_distance`.
[[nodiscard]] Image difference_picture(const Image& picture, const Tracer& a, const Tracer& b);

/// The caption of that picture: "red: shape differs at 12 pixels".
[[nodiscard]] std::string difference_caption(const Difference& difference);

/// A row of pictures of one size, each below its caption.
struct Panel {
  Image image;
  std::string caption;
};
[[nodiscard]] Image panel_row(const std::vector<Panel>& panels);

/// A dark copy of picture `a`, of the size of `b`, that marks the pixels in which they differ.
[[nodiscard]] Panel difference_panel(const Image& a, const Image& b);

/// Stacks rows of one width.
[[nodiscard]] Image stacked(const std::vector<Image>& rows);

}  // namespace detent::cli
