// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

namespace detent::cli {

/// The text of scenes/arena.json, put into the program when it is built.
extern const std::string_view arena_json;

}  // namespace detent::cli
