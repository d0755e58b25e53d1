// SPDX-License-Identifier: MIT
#define TINYOBJLOADER_USE_DOUBLE
#define TINYOBJLOADER_IMPLEMENTATION
#include <tiny_obj_loader.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

#include "file.hpp"
#include "obj_reader.hpp"

namespace detent::cli {
namespace {

constexpr double default_size = 20;

/// The loader's diagnostics may have several lines; the first says what failed.
std::string first_line(const std::string& text) { return text.substr(0, text.find('\n')); }

void append_faces(const std::string& file, const tinyobj::mesh_t& source, MeshModel& mesh) {
  for (std::size_t i = 0; i + 2 < source.indices.size(); i += 3) {
    std::array<std::uint32_t, 3> triangle{};
    for (std::size_t k = 0; k < 3; ++k) {
      const int index = source.indices[i + k].vertex_index;
      if (index < 0 || static_cast<std::size_t>(index) >= mesh.vertices.size()) {
        throw InputError(file, {},
                         "face " + std::to_string(mesh.triangles.size() + 1) +
                             " names a vertex that is not there; export the model again");
      }
      triangle[k] = static_cast<std::uint32_t>(index);
    }
    mesh.triangles.push_back(triangle);
  }
}

void centre_and_scale(MeshModel& mesh, std::optional<double> scale) {
  std::array<double, 3> low = mesh.vertices.front();
  std::array<double, 3> high = low;
  for (const auto& vertex : mesh.vertices) {
    for (std::size_t i = 0; i < 3; ++i) {
      low[i] = std::min(low[i], vertex[i]);
      high[i] = std::max(high[i], vertex[i]);
    }
  }
  const double longest = std::max({high[0] - low[0], high[1] - low[1], high[2] - low[2]});
  const double factor = scale.value_or(longest > 0 ? default_size / longest : 1);
  for (auto& vertex : mesh.vertices) {
    for (std::size_t i = 0; i < 3; ++i) vertex[i] = (vertex[i] - (low[i] + high[i]) / 2) * factor;
  }
}

}  // namespace

MeshModel read_obj(const std::string& file, std::optional<double> scale) {
  std::istringstream stream(read_file(file));
  tinyobj::attrib_t attributes;
  std::vector<tinyobj::shape_t> shapes;
  std::vector<tinyobj::material_t> materials;
  std::string warning;
  std::string error;
  if (!tinyobj::LoadObj(&attributes, &shapes, &materials, &warning, &error, &stream)) {
    throw InputError(
        file, {},
        "not a readable OBJ model: " + first_line(error) + "; export it again as Wavefront OBJ");
  }

  MeshModel mesh;
  for (std::size_t i = 0; i + 2 < attributes.vertices.size(); i += 3) {
    mesh.vertices.push_back(
        {attributes.vertices[i], attributes.vertices[i + 1], attributes.vertices[i + 2]});
    for (const double coordinate : mesh.vertices.back()) {
      if (!std::isfinite(coordinate)) {
        throw InputError(file, {},
                         "vertex " + std::to_string(mesh.vertices.size()) +
                             " is not finite; export the model again");
      }
    }
  }
  for (const auto& shape : shapes) append_faces(file, shape.mesh, mesh);
  if (mesh.triangles.empty()) {
    throw InputError(file, {}, "has no triangles; name a Wavefront OBJ model with faces");
  }
  centre_and_scale(mesh, scale);
  return mesh;
}

}  // namespace detent::cli
