// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "scene.hpp"

namespace detent::cli {

/// The model on a floor, viewed from its front right at a distance that fits its size; `file` is
/// its name in messages.
[[nodiscard]] Scene scene_around(MeshModel mesh, const std::string& file);

}  // namespace detent::cli
