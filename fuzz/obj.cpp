// SPDX-License-Identifier: MIT
//
// Reading an OBJ model of any bytes gives a mesh whose triangles refer to existing vertices, finite
// and at most 10 units from the origin, or an error that names the file and the remedy. A face that
// names a vertex by more digits than any vertex number has is always rejected.

#include <algorithm>
#include <cmath>
#include <optional>
#include <sstream>
#include <string>

#include "obj_reader.hpp"
#include "property.hpp"

namespace detent::fuzz {
namespace {

/// Whether some line is a face with a word that starts with a number of more than nine digits.
bool names_a_far_vertex(const std::string& content) {
  std::istringstream lines(content.substr(0, content.find_first_of("\r\\#")));
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with("f ")) continue;
    std::istringstream words(line.substr(2));
    std::string word;
    while (words >> word) {
      const auto first = word.find_first_not_of('0', word.starts_with('-') ? 1 : 0);
      const auto end = std::min(word.find_first_not_of("-0123456789"), word.size());
      if (first < end && end - first > 9) return true;
    }
  }
  return false;
}

}  // namespace

void property(Bytes input) {
  const std::string content(reinterpret_cast<const char*>(input.data()), input.size());
  cli::MeshModel mesh;
  try {
    mesh = cli::parse_obj("f", content, std::nullopt);
  } catch (const cli::InputError& error) {
    const std::string what = error.what();
    require(what.starts_with("f:"), [&] { return "names no file: " + what; });
    return require(what.find("; ") != std::string::npos, [&] { return "no remedy: " + what; });
  }
  require(!names_a_far_vertex(content), [] { return std::string("reads a number that wraps"); });
  require(!mesh.triangles.empty(), [] { return std::string("no triangles"); });
  for (const auto& triangle : mesh.triangles) {
    for (const auto vertex : triangle) {
      require(vertex < mesh.vertices.size(), [] { return std::string("no such vertex"); });
    }
  }
  for (const auto& vertex : mesh.vertices) {
    for (const double coordinate : vertex) {
      require(std::isfinite(coordinate) && std::abs(coordinate) <= 10 * (1 + 0x1p-50),
              [&] { return "a coordinate of " + std::to_string(coordinate); });
    }
  }
}

}  // namespace detent::fuzz
