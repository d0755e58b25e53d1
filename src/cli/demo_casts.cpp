// SPDX-License-Identifier: MIT
#include "demo_casts.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "casts.hpp"
#include "compare.hpp"
#include "overlay.hpp"
#include "print.hpp"

namespace detent::cli {
namespace {

/// The view of the two casts that are shown, from the side towards which they move.
CameraModel cast_camera() {
  return {{},
          point_of("7", "15.5", "53"),
          point_of("-13", "1", "23.5"),
          point_of("0", "1", "0"),
          {Decimal::parse("34").value(), {}}};
}

/// The differences of casts in one scalar and at one distance from those of q16_16 near the origin.
struct CastErrors {
  std::size_t hits = 0;
  std::size_t wrong = 0;  // a hit instead of a miss, or the reverse
  std::size_t off = 0;    // by more than 1/1024
  double largest = 0;
};

CastErrors errors_of(const CastReport& report, const CastReport& exact) {
  CastErrors errors;
  for (std::size_t i = 0; i < exact.distances.size(); ++i) {
    const auto &a = report.distances[i], &b = exact.distances[i];
    errors.hits += a.has_value();
    errors.wrong += a.has_value() != b.has_value();
    if (!a || !b) continue;
    const double error = std::abs(*a - *b);
    errors.off += error > 1.0 / 1024;
    errors.largest = std::max(errors.largest, error);
  }
  return errors;
}

}  // namespace

std::string demo_row(const std::array<std::string, 8>& cells) {
  static constexpr std::array<std::size_t, 8> widths{6, 8, 9, 9, 8, 8, 8, 20};
  std::string line;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const std::string space(widths[i] - std::min(widths[i], cells[i].size()), ' ');
    line += i < 2 ? cells[i] + space : space + cells[i];
  }
  return line + '\n';
}

CastPage cast_page(const Scene& scene, const DemoOptions& options) {
  constexpr int count = 2000;
  const Decimal distance = Decimal::parse(far_away).value();
  // Large enough for correct shadows in float.
  const Decimal bias = Decimal::parse("0.00390625").value();
  const auto throws = random_throws(count);
  std::optional<CastReport> exact;
  std::vector<Image> rows;
  std::string table =
      demo_row({"place", "scalar", "casts", "hits", "wrong", "off", "largest", "digest"});
  for (const bool is_far : {false, true}) {
    const Move move = is_far ? Move{{distance, distance, distance}} : Move{};
    std::vector<Panel> panels;
    for (const bool is_fixed : {true, false}) {
      const auto report = [&](const std::vector<Throw>& list, bool are_drawn) {
        return is_fixed ? cast_throws<q16_16>(scene, move, list, are_drawn)
                        : cast_throws<float>(scene, move, list, are_drawn);
      };
      const CastReport shown = report(shown_throws(), true);
      Scene stage = scene;
      stage.camera = cast_camera();
      stage.shapes.insert(stage.shapes.end(), shown.bodies.begin(), shown.bodies.end());
      const auto tracer =
          is_fixed ? make_tracer<q16_16>(stage, move) : make_tracer<float>(stage, move);
      tracer->aim_camera(options.size);
      tracer->cast({options.threads, "casting"});
      Image picture = tracer->picture(bias, {options.threads, "shading"});
      draw_over(picture, tracer->view(), shown.lines, tracer->found());
      draw_over(picture, tracer->view(), shown.marks,
                std::vector<std::optional<Found>>(tracer->ray_count()));
      const auto length = [](const std::optional<double>& d) {
        return d ? rounded(*d, 2) : std::string("miss");
      };
      panels.push_back({picture, std::string(tracer->scalar()) + (is_far ? ", far: " : ", near: ") +
                                     length(shown.distances[0]) + " and " +
                                     length(shown.distances[1])});

      const CastReport many = report(throws, false);
      if (!exact) exact = many;
      const CastErrors errors = errors_of(many, *exact);
      table += demo_row({is_far ? "far" : "near", std::string(tracer->scalar()),
                         std::to_string(count), std::to_string(errors.hits),
                         std::to_string(errors.wrong), std::to_string(errors.off),
                         rounded(errors.largest, 4), hexadecimal(many.digest)});
    }
    rows.push_back(panel_row(panels));
  }
  return {stacked(rows),
          "balls and capsules cast through the arena, compared with q16_16 near the origin\n"
          "(wrong: hit instead of miss or miss instead of hit; off: by more than 1/1024):\n",
          table};
}

}  // namespace detent::cli
