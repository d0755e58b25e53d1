// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <string>

namespace detent::cli {

/// The exit code of `run`, or 2 after one line on standard error when it throws.
[[nodiscard]] int run_program(const std::string& name, const std::function<int()>& run);

/// Reads the command line; false when that printed a help text or a version and there is nothing
/// left to do. Throws InputError for wrong arguments.
[[nodiscard]] bool parse(CLI::App& app, int argc, char** argv);

/// Rejects an empty file name, which would otherwise mean that the option was not given.
[[nodiscard]] std::string check_name(const std::string& name);

}  // namespace detent::cli
