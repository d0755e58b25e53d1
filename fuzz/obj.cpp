// SPDX-License-Identifier: MIT
//
// Whatever bytes an OBJ model holds, reading it gives a mesh whose triangles name vertices that are
// there, finite and no further than 10 units from the origin, or an error that names the file.

#include <cmath>
#include <optional>
#include <string>

#include "obj_reader.hpp"
#include "property.hpp"

namespace detent::fuzz {

void property(Bytes input) {
  const std::string content(reinterpret_cast<const char*>(input.data()), input.size());
  cli::MeshModel mesh;
  try {
    mesh = cli::parse_obj("f", content, std::nullopt);
  } catch (const cli::InputError& error) {
    const std::string what = error.what();
    return require(what.starts_with("f:"), [&] { return "names no file: " + what; });
  }
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
