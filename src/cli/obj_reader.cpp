// SPDX-License-Identifier: MIT
#define TINYOBJLOADER_USE_DOUBLE
#define TINYOBJLOADER_IMPLEMENTATION
#include <tiny_obj_loader.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <sstream>

#include "file.hpp"
#include "obj_reader.hpp"

namespace detent::cli {
namespace {

/// The loader's diagnostics may have several lines; the first says what failed.
std::string first_line(const std::string& text) { return text.substr(0, text.find('\n')); }

/// " on line 7", where `is_it(words)` is true of the words of that line, or nothing.
template <class Test>
std::string on_line(const std::string& content, const Test& is_it) {
  std::istringstream lines(content);
  std::string line;
  for (int number = 1; std::getline(lines, line); ++number) {
    std::istringstream words(line);
    if (is_it(words)) return " on line " + std::to_string(number);
  }
  return {};
}

std::string line_of_vertex(const std::string& content, std::size_t number) {
  std::size_t seen = 0;
  return on_line(content, [&](std::istream& words) {
    std::string word;
    return words >> word && word == "v" && ++seen == number;
  });
}

/// Of the first face that names a vertex which is not among `count`; negative numbers count back
/// from the last one so far.
std::string line_of_bad_face(const std::string& content, std::size_t count) {
  long seen = 0;
  return on_line(content, [&](std::istream& words) {
    std::string word;
    words >> word;
    if (word == "v") ++seen;
    if (word != "f") return false;
    while (words >> word) {
      const long index = std::strtol(word.c_str(), nullptr, 10);
      if (index == 0 || index < -seen || index > static_cast<long>(count)) return true;
    }
    return false;
  });
}

void append_faces(const std::string& file, const std::string& content,
                  const tinyobj::mesh_t& source, MeshModel& mesh) {
  for (std::size_t i = 0; i + 2 < source.indices.size(); i += 3) {
    std::array<std::uint32_t, 3> triangle{};
    for (std::size_t k = 0; k < 3; ++k) {
      const int index = source.indices[i + k].vertex_index;
      if (index < 0 || static_cast<std::size_t>(index) >= mesh.vertices.size()) {
        throw InputError(file, {},
                         "face " + std::to_string(mesh.triangles.size() + 1) +
                             " names a vertex that is not there" +
                             line_of_bad_face(content, mesh.vertices.size()) +
                             "; export the model again");
      }
      triangle[k] = static_cast<std::uint32_t>(index);
    }
    mesh.triangles.push_back(triangle);
  }
}

/// Halves are taken before sums and differences, which may be beyond the range of a double.
void centre_and_scale(const std::string& file, MeshModel& mesh, std::optional<double> scale) {
  std::array<double, 3> low = mesh.vertices.front();
  std::array<double, 3> high = low;
  for (const auto& vertex : mesh.vertices) {
    for (std::size_t i = 0; i < 3; ++i) {
      low[i] = std::min(low[i], vertex[i]);
      high[i] = std::max(high[i], vertex[i]);
    }
  }
  double longest_half = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    longest_half = std::max(longest_half, high[i] / 2 - low[i] / 2);
  }
  const double factor =
      scale.value_or(longest_half > 0 ? default_model_size / 2 / longest_half : 1);
  for (auto& vertex : mesh.vertices) {
    for (std::size_t i = 0; i < 3; ++i) {
      vertex[i] = (vertex[i] - (low[i] / 2 + high[i] / 2)) * factor;
      if (!std::isfinite(vertex[i])) {
        throw InputError(file, {}, "cannot be scaled to its size; export the model in other units");
      }
    }
  }
}

}  // namespace

MeshModel parse_obj(const std::string& file, const std::string& content,
                    std::optional<double> scale) {
  std::istringstream stream(content);
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
                         "vertex " + std::to_string(mesh.vertices.size()) + " is not finite" +
                             line_of_vertex(content, mesh.vertices.size()) +
                             "; export the model again");
      }
    }
  }
  for (const auto& shape : shapes) append_faces(file, content, shape.mesh, mesh);
  if (mesh.triangles.empty()) {
    throw InputError(file, {}, "has no triangles; name a Wavefront OBJ model with faces");
  }
  centre_and_scale(file, mesh, scale);
  return mesh;
}

MeshModel read_obj(const std::string& file, std::optional<double> scale) {
  return parse_obj(file, read_file(file), scale);
}

}  // namespace detent::cli
