// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "sample.hpp"

namespace samples {

/// All samples, in gallery order.
std::span<const Entry* const> gallery();

/// The sample with this name, or nullptr.
const Entry* find(const std::string& name);

/// The column-major transform from world to screen: x and y from -1 to 1 in a window `aspect` times
/// as wide as high, and depth as in WebGL.
std::array<float, 16> matrix(const View& view, float aspect);

}  // namespace samples
