// SPDX-License-Identifier: MIT
#include "demo_command.hpp"

#include <charconv>
#include <string>

#include "error.hpp"
#include "image.hpp"
#include "program.hpp"

namespace detent::cli {

void add_demo_options(CLI::App& command, DemoArguments& arguments) {
  command.add_option("-o,--out", arguments.options.directory, "The directory to write pictures to")
      ->check(check_name)
      ->capture_default_str();
  command
      .add_option("--mesh", arguments.options.mesh,
                  "An OBJ model to show as well, half a unit long, in mesh.png")
      ->check(check_name);
  command.add_option("--size", arguments.size, "Size of each picture, in pixels")
      ->capture_default_str();
  command
      .add_option("--threads", arguments.options.threads,
                  "Number of threads; 0 for one per processor")
      ->capture_default_str()
      ->check(CLI::Range(0, 1024));
  command.final_callback([&arguments] {
    arguments.options.size = parse_size(arguments.size);
    demo(arguments.options);
  });
}

Size parse_size(const std::string& text) {
  constexpr int most_pixels = 1 << 24;  // each takes about 80 bytes during rendering
  Size size{};
  const char* const end = text.data() + text.size();
  const auto width = std::from_chars(text.data(), end, size.width);
  if (width.ec == std::errc() && width.ptr != end && *width.ptr == 'x') {
    const auto height = std::from_chars(width.ptr + 1, end, size.height);
    const bool valid = height.ec == std::errc() && height.ptr == end && size.width > 0 &&
                       size.height > 0 && size.width < largest_image &&
                       size.height < largest_image - size.width &&
                       size.width * size.height <= most_pixels;
    if (valid) return size;
  }
  throw InputError("--size: \"" + text + "\" is not WIDTHxHEIGHT with at most " +
                   std::to_string(most_pixels) + " pixels and sides that add up to less than " +
                   std::to_string(largest_image) + "; write, for example, 640x360");
}

}  // namespace detent::cli
