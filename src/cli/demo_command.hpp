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

/// Adds the options of the demonstration to `command`, which then runs it.
void add_demo_options(CLI::App& command, DemoArguments& arguments);

/// "WIDTHxHEIGHT"; throws InputError when that is too large or no size.
[[nodiscard]] Size parse_size(const std::string& text);

}  // namespace detent::cli
