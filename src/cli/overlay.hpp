// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "image.hpp"
#include "outlines.hpp"
#include "tracer.hpp"

namespace detent::cli {

/// Draws lines over a picture, hidden where a ray hit something in front of them by more than 1/128
/// of the distance: the lines of round shapes are chords, slightly below their surface.
void draw_over(Image& picture, const View& view, const std::vector<Outline>& lines,
               const std::vector<std::optional<Found>>& found);

}  // namespace detent::cli
