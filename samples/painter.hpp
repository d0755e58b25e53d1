// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "sample.hpp"

namespace samples {

/// The bytes of a PNG file with the picture, as the page shows it.
std::string png_of(const Picture& picture, const View& view, int width, int height);

}  // namespace samples
