// SPDX-License-Identifier: MIT
//
// `detent demo` as a separate program, which builds in a fraction of the tool's time.
#include "demo_command.hpp"
#include "program.hpp"

int main(int argc, char** argv) {
  return detent::cli::run_program("detent-demo", [&] {
    CLI::App app("detent: draw the arena near and far from the origin, and count errors",
                 "detent-demo");
    detent::cli::DemoArguments arguments;
    detent::cli::add_demo_options(app, arguments);
    static_cast<void>(detent::cli::parse(app, argc, argv));
    return 0;
  });
}
