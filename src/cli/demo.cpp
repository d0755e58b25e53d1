// SPDX-License-Identifier: MIT
#include <algorithm>
#include <filesystem>
#include <system_error>

#include "commands.hpp"
#include "compare.hpp"
#include "demo_bodies.hpp"
#include "demo_casts.hpp"
#include "embedded.hpp"
#include "file.hpp"
#include "model_scene.hpp"
#include "obj_reader.hpp"
#include "print.hpp"
#include "scene_reader.hpp"

namespace detent::cli {
namespace {

constexpr const char* longest_side = "0.5";  // of a model

/// One position and one scalar: a picture and a line of the table.
struct Run {
  std::string place;
  std::unique_ptr<Tracer> tracer;
  Image picture;
  Verdict verdict;
};

void make_directory(const std::string& directory) {
  std::error_code error;
  std::filesystem::create_directories(directory, error);
  if (error || !std::filesystem::is_directory(directory)) {
    throw InputError(directory, {}, "cannot be created as a directory; choose another with --out");
  }
}

/// The path of a file in the demonstration's directory.
std::string path_in(const DemoOptions& options, const char* name) {
  return (std::filesystem::path(options.directory) / name).string();
}

/// One scene near and far in both scalars: a page of pictures and the rows of the table.
struct Exhibit {
  Image page;
  std::string rows;
};

Exhibit exhibit(const Scene& scene, const DemoOptions& options) {
  const Decimal distance = Decimal::parse(far_away).value();
  const Decimal bias = Decimal::parse(default_bias).value();

  std::vector<Run> runs;
  for (const bool is_far : {false, true}) {
    const Move move = is_far ? Move{{distance, distance, distance}} : Move{};
    for (const bool is_fixed : {true, false}) {
      Run run{is_far ? "far" : "near",
              is_fixed ? make_tracer<q16_16>(scene, move) : make_tracer<float>(scene, move),
              Image(0, 0),
              {}};
      const std::string what = ' ' + run.place + ' ' + std::string(run.tracer->scalar());
      run.tracer->aim_camera(options.size);
      run.tracer->cast({options.threads, "casting" + what});
      run.picture = run.tracer->picture(bias, {options.threads, "shading" + what});
      run.verdict = run.tracer->judge({options.threads, "checking" + what});
      runs.push_back(std::move(run));
    }
  }
  const auto times = time_per_ray(
      {runs[0].tracer.get(), runs[1].tracer.get(), runs[2].tracer.get(), runs[3].tracer.get()});

  std::vector<Image> pictures;
  std::string rows;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const Tracer& tracer = *runs[i].tracer;
    const auto found = tracer.found();
    const auto hits =
        std::count_if(found.begin(), found.end(), [](auto& f) { return f.has_value(); });
    rows += demo_row({runs[i].place, std::string(tracer.scalar()),
                      std::to_string(tracer.ray_count()), std::to_string(hits),
                      std::to_string(runs[i].verdict.wrong), std::to_string(runs[i].verdict.off),
                      rounded(times[i], 0), hexadecimal(tracer.digest())});
  }
  for (std::size_t i = 0; i < runs.size(); i += 2) {
    const Run& exact = runs[i];
    const Run& rough = runs[i + 1];
    const std::string place = i == 0 ? "near the origin" : std::string("moved by ") + far_away;
    const Difference difference = compare(*exact.tracer, *rough.tracer);
    pictures.push_back(panel_row({{exact.picture, "q16_16, " + place},
                                  {rough.picture, "float, " + place},
                                  {difference_picture(exact.picture, *exact.tracer, *rough.tracer),
                                   difference_caption(difference)}}));
  }
  return {stacked(pictures), rows};
}

/// The model shown in addition to the arena.
struct Model {
  Scene scene;
  std::string title;
};

Model read_model(const DemoOptions& options) {
  const double size = Decimal::parse(longest_side).value().to<double>().value();
  MeshModel mesh = read_obj(options.mesh, {});
  for (auto& vertex : mesh.vertices) {
    for (double& coordinate : vertex) coordinate *= size / default_model_size;
  }
  const std::string title = options.mesh + ", " + std::to_string(mesh.triangles.size()) +
                            " triangles, " + longest_side + " units long:\n";
  return {scene_around(std::move(mesh), options.mesh), title};
}

}  // namespace

void demo(const DemoOptions& options) {
  make_directory(options.directory);
  const std::string path = path_in(options, "demo.png");
  OutputFile file(path);
  const std::string cast_path = path_in(options, "casts.png");
  OutputFile cast_file(cast_path);
  const std::string body_path = path_in(options, "bodies.png");
  OutputFile body_file(body_path);
  // Read before anything is drawn, so that errors in it are reported at once.
  const std::string mesh_path = path_in(options, "mesh.png");
  std::optional<OutputFile> mesh_file;
  std::optional<Model> model;
  if (!options.mesh.empty()) {
    mesh_file.emplace(mesh_path);
    model = read_model(options);
  }

  const Scene scene = parse_scene("arena.json", std::string(arena_json));
  const Exhibit arena = exhibit(scene, options);
  std::string text =
      demo_row({"place", "scalar", "rays", "hits", "wrong", "off", "ns/ray", "digest"}) +
      arena.rows;
  file.write(arena.page.png());
  if (model) {
    const Exhibit shown = exhibit(model->scene, options);
    text += '\n' + model->title + shown.rows;
    mesh_file->write(shown.page.png());
    mesh_file->commit();
  }
  const CastPage casts = cast_page(scene, options);
  text += '\n' + casts.title + casts.rows;
  text += '\n' + casts.contact_title + casts.contact_rows;
  cast_file.write(casts.page.png());
  cast_file.commit();
  const BodyPage bodies = body_page(options);
  text += '\n' + bodies.title + bodies.rows;
  body_file.write(bodies.page.png());
  body_file.commit();
  file.commit();

  text +=
      "\nEvery ray was checked in exact arithmetic on the inputs of its scalar:"
      "\n  wrong  hit instead of miss, miss instead of hit, or not the nearest shape"
      "\n  off    the right shape, its distance off by more than 1/65536"
      "\nfar: every coordinate moved by " +
      std::string(far_away) + "; shadow rays start 1/1024 above a surface" + "\npicture: " + path +
      "\npicture: " + cast_path + "\npicture: " + body_path + '\n';
  if (model) text += "picture: " + mesh_path + '\n';
  print(text);
}

}  // namespace detent::cli
