// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "scene.hpp"

namespace detent::cli {

/// The model on a floor, seen from its front right, from as far as its size asks for; `file` is
/// what messages call it.
[[nodiscard]] Scene scene_around(MeshModel mesh, const std::string& file);

}  // namespace detent::cli
