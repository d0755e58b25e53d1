// SPDX-License-Identifier: MIT
#include "model_scene.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "commands.hpp"
#include "print.hpp"

namespace detent::cli {
namespace {

constexpr double largest_size = 1e300;  // far above every scalar of the tool except double

Decimal decimal_of(double value) { return Decimal::parse(rounded(value, 6)).value(); }

}  // namespace

Scene scene_around(MeshModel mesh, const std::string& file) {
  std::array<double, 3> reach{};  // the box is centered, so these are half its sides
  for (const auto& vertex : mesh.vertices) {
    for (std::size_t i = 0; i < 3; ++i) reach[i] = std::max(reach[i], std::abs(vertex[i]));
  }
  const double size = std::max({reach[0], reach[1], reach[2], 1e-3});
  if (size > largest_size) {
    throw InputError(file, {},
                     "is so large that its camera would be out of range; use a smaller scale");
  }
  const auto at = [&](double x, double y, double z) {
    return Point{Literal{decimal_of(x * size), {}}, Literal{decimal_of(y * size), {}},
                 Literal{decimal_of(z * size), {}}};
  };
  Scene scene;
  scene.file = file;
  scene.camera = CameraModel{{},
                             at(1.1, 0.9, 2.6),
                             at(0, -0.1, 0),
                             point_of("0", "1", "0"),
                             {Decimal::parse("50").value(), {}}};
  scene.light = point_of("1", "2", "1.5");
  mesh.position = point_of("0", "0", "0");
  const Literal floor{decimal_of(-reach[1]), {}};
  scene.shapes.push_back({{}, default_colour(1), {}, std::move(mesh)});
  scene.shapes.push_back({{}, default_colour(7), {}, PlaneModel{point_of("0", "1", "0"), floor}});
  return scene;
}

}  // namespace detent::cli
