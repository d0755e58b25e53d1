// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "scene.hpp"

namespace detent::cli {

/// How long the longest side of a model becomes for which no scale is given.
inline constexpr double default_model_size = 20;

/// The triangles of a Wavefront OBJ file, its box centred at the origin and scaled by `scale`, or
/// without one to its default size; throws InputError.
[[nodiscard]] MeshModel read_obj(const std::string& file, std::optional<double> scale);

/// The triangles of the OBJ model in `content`; `file` is what messages call it.
[[nodiscard]] MeshModel parse_obj(const std::string& file, const std::string& content,
                                  std::optional<double> scale);

}  // namespace detent::cli
