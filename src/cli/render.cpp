// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cctype>

#include "commands.hpp"
#include "compare.hpp"
#include "file.hpp"
#include "obj_reader.hpp"
#include "scene_reader.hpp"

namespace detent::cli {
namespace {

bool is_model(std::string name) {
  std::transform(name.begin(), name.end(), name.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return name.ends_with(".obj");
}

Decimal decimal_of(double value) { return Decimal::parse(rounded(value, 6)).value(); }

/// The model on a floor, seen from its front right, from as far as its size asks for.
Scene scene_around(MeshModel mesh, const std::string& file) {
  std::array<double, 3> reach{};  // the box is centred, so these are half its sides
  for (const auto& vertex : mesh.vertices) {
    for (std::size_t i = 0; i < 3; ++i) reach[i] = std::max(reach[i], std::abs(vertex[i]));
  }
  const double size = std::max({reach[0], reach[1], reach[2], 1e-3});
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

Scene read_input(const RenderOptions& options) {
  if (is_model(options.input)) {
    return scene_around(read_obj(options.input, options.scale), options.input);
  }
  if (options.scale) {
    throw InputError("--scale is for OBJ models; set \"scale\" of the meshes in the scene instead");
  }
  return read_scene(options.input);
}

Workers working(const RenderOptions& options, std::string_view what, std::string_view scalar) {
  return {options.threads, std::string(what).append(" ").append(scalar)};
}

}  // namespace

void render(const RenderOptions& options) {
  OutputFile file(options.out);
  const Scene scene = read_input(options);
  const auto trace = [&](const std::string& scalar) {
    auto tracer = make_tracer(scalar, scene, options.offset);
    tracer->aim_camera(options.size);
    return tracer;
  };
  const auto draw = [&](Tracer& tracer) {
    tracer.cast(working(options, "casting", tracer.scalar()));
    return tracer.picture(options.bias, working(options, "shading", tracer.scalar()));
  };
  if (options.compare) {
    // Both are made before either is drawn, so that a number out of range is found at once.
    const auto a = trace(options.compare->first);
    const auto b = trace(options.compare->second);
    const Image picture_a = draw(*a);
    const Image picture_b = draw(*b);
    const Difference difference = compare(*a, *b);
    file.write(stacked({panel_row({{picture_a, options.compare->first},
                                   {picture_b, options.compare->second},
                                   {difference_picture(picture_a, *a, *b),
                                    difference_caption(difference)}})})
                   .png());
  } else {
    const auto tracer = trace(options.scalar);
    file.write(draw(*tracer).png());
  }
  file.commit();
}

}  // namespace detent::cli
