// SPDX-License-Identifier: MIT
#include <algorithm>

#include "commands.hpp"
#include "compare.hpp"
#include "file.hpp"
#include "print.hpp"
#include "scene_reader.hpp"

namespace detent::cli {
namespace {

std::size_t count_hits(const Tracer& tracer) {
  const auto found = tracer.found();
  return static_cast<std::size_t>(
      std::count_if(found.begin(), found.end(), [](const auto& f) { return f.has_value(); }));
}

std::string summary(const Tracer& tracer) {
  return "{\"rays\": " + std::to_string(tracer.ray_count()) +
         ", \"hits\": " + std::to_string(count_hits(tracer)) + ", \"digest\": \"" +
         hexadecimal(tracer.digest()) + "\"}\n";
}

/// A label and a value for each scalar.
std::string table_row(const std::string& label, const std::string& a, const std::string& b) {
  std::string row(62, ' ');
  row.replace(0, label.size(), label);
  row.replace(40 - std::min<std::size_t>(a.size(), 25), a.size(), a);
  row.replace(62 - std::min<std::size_t>(b.size(), 20), b.size(), b);
  return row + '\n';
}

std::string comparison(const Scene& scene, const Tracer& a, const Tracer& b) {
  const Difference difference = compare(a, b);
  const auto times = time_per_ray({&a, &b});
  std::string text = table_row("", std::string(a.scalar()), std::string(b.scalar()));
  text += table_row("rays", std::to_string(a.ray_count()), std::to_string(b.ray_count()));
  text += table_row("hits", std::to_string(count_hits(a)), std::to_string(count_hits(b)));
  text += table_row("ns per ray", rounded(times[0], 1), rounded(times[1], 1));
  text += table_row("digest", hexadecimal(a.digest()), hexadecimal(b.digest()));
  text += "disagreements: " + std::to_string(difference.disagreements()) + " (" +
          std::to_string(difference.hit_or_miss) + " hit or miss, " +
          std::to_string(difference.shape) + " which shape)\n";
  text += "largest distance difference: " + rounded(difference.largest_distance, 9);
  if (difference.largest_distance > 0) {
    const std::size_t ray = difference.largest_ray;
    text += " (ray " + one_line(name_of(scene.rays[ray].id, ray)) + ")";
  }
  return text + '\n';
}

}  // namespace

void cast(const CastOptions& options) {
  std::optional<OutputFile> file;
  if (!options.out.empty()) file.emplace(options.out);
  const Scene scene = read_scene(options.scene);
  if (scene.rays.empty()) {
    throw InputError(options.scene, {},
                     "the scene has no \"rays\"; add some, or use detent render");
  }
  const auto run = [&](const std::string& scalar) {
    auto tracer = make_tracer(scalar, scene);
    tracer->cast({});
    return tracer;
  };
  std::string text;
  if (options.compare) {
    text = comparison(scene, *run(options.compare->first), *run(options.compare->second));
  } else {
    const auto tracer = run(options.scalar);
    text = tracer->json_lines() + summary(*tracer);
  }
  if (file) {
    file->write(text);
    file->commit();
  } else {
    print(text);
  }
}

}  // namespace detent::cli
