// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "sample.hpp"

namespace samples {

/// All samples, in the order of the gallery.
std::span<const Entry* const> gallery();

/// The one with this name, or nullptr.
const Entry* find(const std::string& name);

/// From the world to the screen, in columns: x and y from -1 to 1 in a window `aspect` times as wide
/// as high, and a depth as WebGL has it.
std::array<float, 16> matrix(const View& view, float aspect);

}  // namespace samples
