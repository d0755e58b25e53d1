// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "scene.hpp"

namespace detent::cli {

/// The length of a model's longest side when no scale is given.
inline constexpr double default_model_size = 20;

/// The triangles of a Wavefront OBJ file, its bounding box centered at the origin and scaled by
/// `scale`, or to its default size without one; throws InputError.
[[nodiscard]] MeshModel read_obj(const std::string& file, std::optional<double> scale);

/// The triangles of the OBJ model in `content`; `file` is its name in messages.
[[nodiscard]] MeshModel parse_obj(const std::string& file, const std::string& content,
                                  std::optional<double> scale);

}  // namespace detent::cli
