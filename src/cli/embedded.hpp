// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

namespace detent::cli {

/// The text of scenes/arena.json, embedded at build time.
extern const std::string_view arena_json;

}  // namespace detent::cli
