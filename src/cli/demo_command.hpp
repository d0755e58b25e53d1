// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "commands.hpp"

namespace detent::cli {

/// The demonstration's options, as text until all of them have been read.
struct DemoArguments {
  DemoOptions options;
  std::string size = "480x300";
};

/// Adds the demonstration's options to `command`, which runs it.
void add_demo_options(CLI::App& command, DemoArguments& arguments);

/// Parses "WIDTHxHEIGHT"; throws InputError when it is too large or not a size.
[[nodiscard]] Size parse_size(const std::string& text);

}  // namespace detent::cli
