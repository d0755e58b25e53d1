// SPDX-License-Identifier: MIT
#include "error.hpp"

namespace detent::cli {
namespace {

constexpr std::size_t longest = 40;  // bytes of a name in a message

/// Whether a byte continues a character of UTF-8.
bool continues(char c) { return (static_cast<unsigned char>(c) & 0xc0) == 0x80; }

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

std::string in_quotes(std::string_view name) {
  if (name.size() <= longest) return '"' + std::string(name) + '"';
  std::size_t end = longest;
  while (end > 0 && continues(name[end])) --end;
  return '"' + std::string(name.substr(0, end)) + "...\"";
}

std::string end_of(std::string_view text) {
  if (text.size() <= longest) return std::string(text);
  std::size_t start = text.size() - longest;
  while (start < text.size() && continues(text[start])) ++start;
  return "..." + std::string(text.substr(start));
}

}  // namespace detent::cli
