// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

namespace detent::cli {

/// The texts of scenes/arena.json and scenes/pyramid.json, embedded at build time.
extern const std::string_view arena_json;
extern const std::string_view pyramid_json;

}  // namespace detent::cli
