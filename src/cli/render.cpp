// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cctype>

#include "commands.hpp"
#include "compare.hpp"
#include "file.hpp"
#include "model_scene.hpp"
#include "obj_reader.hpp"
#include "overlay.hpp"
#include "scene_reader.hpp"

namespace detent::cli {
namespace {

bool is_model(std::string name) {
  std::transform(name.begin(), name.end(), name.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return name.ends_with(".obj");
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
    auto picture = tracer.picture(options.bias, working(options, "shading", tracer.scalar()));
    if (options.debug.any()) {
      draw_over(picture, tracer.view(),
                outlines_of(tracer.scalar(), scene, options.offset, options.debug), tracer.found());
    }
    return picture;
  };
  if (options.compare) {
    // Both are built before either is drawn, so that a number out of range is reported at once.
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
