// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "scene.hpp"

namespace detent::cli {

/// The scene in a JSON file, with the meshes that it names; throws InputError. (docs/tool.md)
[[nodiscard]] Scene read_scene(const std::string& file);

/// The scene in `content`; `file` is what messages call it and what meshes are found beside.
[[nodiscard]] Scene parse_scene(const std::string& file, const std::string& content);

}  // namespace detent::cli
