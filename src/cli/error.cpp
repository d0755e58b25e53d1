// SPDX-License-Identifier: MIT
#include "error.hpp"

namespace detent::cli {
namespace {

std::string located(std::string_view file, Place place, std::string_view what) {
  std::string line(file);
  if (place.line > 0) {
    line += ':' + std::to_string(place.line) + ':' + std::to_string(place.column);
  }
  return line.append(": ").append(what);
}

}  // namespace

InputError::InputError(std::string_view what) : std::runtime_error(one_line(what)) {}

InputError::InputError(std::string_view file, Place place, std::string_view what)
    : InputError(located(file, place, what)) {}

std::string one_line(std::string_view text) {
  std::string line(text);
  for (char& c : line) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 0x20 || byte == 0x7f) c = ' ';
  }
  return line;
}

}  // namespace detent::cli
