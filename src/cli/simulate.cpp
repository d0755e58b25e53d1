// SPDX-License-Identifier: MIT
#include "simulate.hpp"

#include <filesystem>
#include <system_error>

#include "animation.hpp"
#include "file.hpp"
#include "painter.hpp"
#include "print.hpp"
#include "simulation.hpp"

namespace detent::cli {
namespace {

constexpr int most_frames = 100'000;  // their names have five digits

void check(const SimulateOptions& options) {
  if (options.snapshot_at && options.out.empty()) {
    throw InputError("--snapshot-at: no file to write the snapshot to; name one with --out");
  }
  if (options.snapshot_at.value_or(0) > options.ticks) {
    throw InputError("--snapshot-at: tick " + std::to_string(*options.snapshot_at) +
                     " is after the last one; raise --ticks, which is " +
                     std::to_string(options.ticks));
  }
  const bool has_pictures = !options.frames.empty() || !options.animation.empty();
  if (has_pictures && options.ticks / options.picture_every >= most_frames) {
    throw InputError("--picture-every: more than " + std::to_string(most_frames) +
                     " pictures; raise it");
  }
}

/// Takes pictures of a world.
class Film {
 public:
  Film(const SimulateOptions& options, const WorldModel& model, const Simulation& simulation)
      : options_(options), animation_(options.picture_every, model.ticks_per_second) {
    if (options.frames.empty() && options.animation.empty()) return;
    painter_.emplace(model, simulation, options.size);
    if (!options.animation.empty()) file_.emplace(options.animation);
    if (options.frames.empty()) return;
    std::error_code error;
    std::filesystem::create_directories(options.frames, error);
    if (error || !std::filesystem::is_directory(options.frames)) {
      throw InputError(options.frames, {},
                       "cannot be created as a directory; choose another with --frames");
    }
  }

  void see(int tick, const Simulation& simulation) {
    if (!painter_ || tick % options_.picture_every != 0) return;
    const Image picture = painter_->picture(simulation.facets());
    if (file_) animation_.add(picture);
    if (options_.frames.empty()) return;
    const std::string number = std::to_string(count_++);
    const std::string name = "frame-" + std::string(5 - number.size(), '0') + number + ".png";
    OutputFile frame((std::filesystem::path(options_.frames) / name).string());
    frame.write(picture.png());
    frame.commit();
  }

  void end() {
    if (!file_) return;
    file_->write(animation_.png());
    file_->commit();
  }

 private:
  const SimulateOptions& options_;
  Animation animation_;
  std::optional<Painter> painter_;
  std::optional<OutputFile> file_;
  int count_ = 0;
};

}  // namespace

void simulate(const SimulateOptions& options) {
  check(options);
  std::optional<OutputFile> out;
  if (!options.out.empty()) out.emplace(options.out);
  const WorldModel model = parse_world(options.world, read_file(options.world));
  const auto simulation = make_simulation(options.scalar, model, options.offset);
  if (!options.resume.empty()) simulation->restore(options.resume, read_file(options.resume));
  Film film(options, model, *simulation);

  const int snapshot_at = options.snapshot_at.value_or(options.ticks);
  std::string text;
  for (int tick = 0;; ++tick) {
    film.see(tick, *simulation);
    if (out && tick == snapshot_at) out->write(simulation->snapshot());
    if (tick == options.ticks) break;
    simulation->step();
    if ((tick + 1) % options.every != 0) continue;
    text += "{\"tick\": " + std::to_string(tick + 1) +
            ", \"asleep\": " + std::to_string(simulation->asleep()) + ", \"digest\": \"" +
            hexadecimal(simulation->digest()) + "\"}\n";
  }
  if (options.has_bodies) text += simulation->json_lines();
  text += "{\"ticks\": " + std::to_string(options.ticks) +
          ", \"bodies\": " + std::to_string(model.bodies.size()) +
          ", \"joints\": " + std::to_string(simulation->joint_count()) + ", \"digest\": \"" +
          hexadecimal(simulation->digest()) + "\"}\n";
  film.end();
  if (out) out->commit();
  print(text);
}

}  // namespace detent::cli
