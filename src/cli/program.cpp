// SPDX-License-Identifier: MIT
#include "program.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cstdio>
#include <exception>
#include <new>
#include <sstream>

#include "error.hpp"
#include "print.hpp"

namespace detent::cli {
namespace {

/// Opens an unwritable file in place of a closed standard input, output or error; otherwise the
/// next file to be opened would get its descriptor and its output.
void fill_standard_descriptors() {
  int descriptor = 0;
  while (descriptor >= 0 && descriptor <= STDERR_FILENO) descriptor = open("/dev/null", O_RDONLY);
  if (descriptor > STDERR_FILENO) close(descriptor);
}

/// The name of the program, then those of the commands that the command line names.
std::string name_as_called(const CLI::App& app) {
  std::string name = app.get_name();
  for (const CLI::App* const command : app.get_subcommands()) {
    name += ' ' + name_as_called(*command);
  }
  return name;
}

int fail(const std::string& name, const char* what) {
  constexpr int bad_input = 2;
  std::fprintf(stderr, "%s: %s\n", name.c_str(), one_line(what).c_str());
  return bad_input;
}

}  // namespace

int run_program(const std::string& name, const std::function<int()>& run) {
  try {
    fill_standard_descriptors();
    return run();
  } catch (const std::bad_alloc&) {
    return fail(name, "out of memory; use a smaller scene, model or picture");
  } catch (const std::exception& error) {
    return fail(name, error.what());
  }
}

bool parse(CLI::App& app, int argc, char** argv) {
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& success) {
    std::ostringstream text;
    app.exit(success, text);
    print(text.str());
    return false;
  } catch (const CLI::ParseError& error) {
    throw InputError(std::string(error.what()) + "; see " + name_as_called(app) + " --help");
  }
  return true;
}

std::string check_name(const std::string& name) {
  return name.empty() ? "the name is empty; give it one" : "";
}

}  // namespace detent::cli
