// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "scene.hpp"

namespace detent::cli {

/// The scene in a JSON file and the meshes it names; throws InputError. (docs/tool.md)
[[nodiscard]] Scene read_scene(const std::string& file);

/// The scene in `content`; `file` is its name in messages and the base of mesh paths.
[[nodiscard]] Scene parse_scene(const std::string& file, const std::string& content);

}  // namespace detent::cli
