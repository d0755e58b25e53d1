// SPDX-License-Identifier: MIT
#include "demo_casts.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
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

/// A closer view of the ends of these casts, from the side, so that all normals are seen.
CameraModel contact_camera() {
  return {{},
          point_of("4", "10", "38"),
          point_of("-17", "1", "22"),
          point_of("0", "1", "0"),
          {Decimal::parse("24").value(), {}}};
}

/// A thrown body `distance` from its start, in steps of q16_16.
Throw moved(const Throw& thrown, double distance) {
  const auto& way = thrown.way;
  const auto fixed = [](double x) { return q16_16::from_double(x); };
  const auto direction = direction_of<q16_16>(Vec{fixed(way[0]), fixed(way[1]), fixed(way[2])});
  const auto by = in_double(nearest_to<q16_16>(direction.value() * fixed(distance)));
  Throw result = thrown;
  for (std::size_t i = 0; i < 3; ++i) {
    result.a[i] += by[i];
    result.b[i] += by[i];
  }
  return result;
}

/// The throws that hit, moved `depth` past the hit.
std::vector<Throw> pressed(const std::vector<Throw>& throws, const CastReport& report,
                           double depth) {
  std::vector<Throw> bodies;
  for (std::size_t i = 0; i < throws.size(); ++i) {
    const auto& distance = report.distances[i];
    if (distance) bodies.push_back(moved(throws[i], *distance + depth));
  }
  return bodies;
}

/// The differences of contacts in one scalar and at one distance from those of q16_16 near the
/// origin.
struct ContactErrors {
  std::size_t wrong = 0;  // a contact instead of none, or the reverse
  std::size_t off = 0;    // pushed to a position that is off by more than 1/1024
  double largest = 0;
};

ContactErrors errors_of(const ContactReport& report, const ContactReport& exact) {
  ContactErrors errors;
  const auto pair = [](const Overlap& overlap) { return std::pair(overlap.body, overlap.shape); };
  auto a = report.overlaps.begin(), b = exact.overlaps.begin();
  const auto end_a = report.overlaps.end(), end_b = exact.overlaps.end();
  while (a != end_a || b != end_b) {
    const bool only_a = b == end_b || (a != end_a && pair(*a) < pair(*b));
    const bool only_b = a == end_a || (b != end_b && pair(*b) < pair(*a));
    if (!only_a && !only_b) {
      const auto &p = a->push, &q = b->push;
      const double error = std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
      errors.off += error > 1.0 / 1024;
      errors.largest = std::max(errors.largest, error);
    }
    errors.wrong += only_a || only_b;
    a += !only_b;
    b += !only_a;
  }
  return errors;
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
  const auto decimals = [](double d) { return rounded(d, 2); };

  /// The scene with `bodies` in it, seen by `camera`, and lines over it.
  const auto picture = [&](const CameraModel& camera, const std::vector<ShapeModel>& bodies,
                           const std::vector<Outline>& lines, const std::vector<Outline>& marks,
                           bool is_fixed, const Move& move) {
    Scene stage = scene;
    stage.camera = camera;
    stage.shapes.insert(stage.shapes.end(), bodies.begin(), bodies.end());
    const auto tracer =
        is_fixed ? make_tracer<q16_16>(stage, move) : make_tracer<float>(stage, move);
    tracer->aim_camera(options.size);
    tracer->cast({options.threads, "casting"});
    Image image = tracer->picture(bias, {options.threads, "shading"});
    draw_over(image, tracer->view(), lines, tracer->found());
    draw_over(image, tracer->view(), marks, std::vector<std::optional<Found>>(tracer->ray_count()));
    return image;
  };

  std::optional<CastReport> exact;
  std::optional<ContactReport> exact_contacts;
  std::vector<Throw> shown_bodies, bodies;
  std::vector<Image> rows, contact_rows;
  std::string table =
      demo_row({"place", "scalar", "casts", "hits", "wrong", "off", "largest", "digest"});
  std::string contact_table =
      demo_row({"place", "scalar", "bodies", "contacts", "wrong", "off", "largest", "digest"});
  for (const bool is_far : {false, true}) {
    const Move move = is_far ? Move{{distance, distance, distance}} : Move{};
    std::vector<Panel> panels, contact_panels;
    for (const bool is_fixed : {true, false}) {
      const std::string place = is_far ? "far" : "near", scalar = is_fixed ? "q16_16" : "float";
      const std::string caption = scalar + ", " + place + ": ";
      const auto report = [&](const std::vector<Throw>& list, bool are_drawn) {
        const Workers workers{options.threads, "casting shapes " + place + ' ' + scalar};
        return is_fixed ? cast_throws<q16_16>(scene, move, list, are_drawn, workers)
                        : cast_throws<float>(scene, move, list, are_drawn, workers);
      };
      const CastReport shown = report(shown_throws(), true), many = report(throws, false);
      const auto length = [&](const std::optional<double>& d) {
        return d ? decimals(*d) : std::string("miss");
      };
      panels.push_back(
          {picture(cast_camera(), shown.bodies, shown.lines, shown.marks, is_fixed, move),
           caption + length(shown.distances[0]) + " and " + length(shown.distances[1])});
      if (!exact) {
        exact = many;
        shown_bodies = pressed(shown_throws(), shown, 0.625);
        bodies = pressed(throws, many, 0.0625);
      }
      const CastErrors errors = errors_of(many, *exact);
      table += demo_row({place, scalar, std::to_string(count), std::to_string(errors.hits),
                         std::to_string(errors.wrong), std::to_string(errors.off),
                         rounded(errors.largest, 4), hexadecimal(many.digest)});

      const auto contacts = [&](const std::vector<Throw>& list, bool are_drawn) {
        const Workers workers{options.threads, "finding contacts " + place + ' ' + scalar};
        return is_fixed ? contacts_of<q16_16>(scene, move, list, are_drawn, workers)
                        : contacts_of<float>(scene, move, list, are_drawn, workers);
      };
      const ContactReport shown_contacts = contacts(shown_bodies, true),
                          many_contacts = contacts(bodies, false);
      std::string depths;
      for (const Overlap& overlap : shown_contacts.overlaps) {
        depths += (depths.empty() ? "depths " : ", ") + decimals(overlap.depth);
      }
      contact_panels.push_back({picture(contact_camera(), {}, shown_contacts.lines,
                                        shown_contacts.marks, is_fixed, move),
                                caption + depths});
      if (!exact_contacts) exact_contacts = many_contacts;
      const ContactErrors contact_errors = errors_of(many_contacts, *exact_contacts);
      contact_table +=
          demo_row({place, scalar, std::to_string(bodies.size()),
                    std::to_string(many_contacts.overlaps.size()),
                    std::to_string(contact_errors.wrong), std::to_string(contact_errors.off),
                    rounded(contact_errors.largest, 4), hexadecimal(many_contacts.digest)});
    }
    rows.push_back(panel_row(panels));
    contact_rows.push_back(panel_row(contact_panels));
  }
  rows.insert(rows.end(), contact_rows.begin(), contact_rows.end());
  return {stacked(rows),
          "balls and capsules cast through the arena, compared with q16_16 near the origin\n"
          "(wrong: hit instead of miss or miss instead of hit; off: by more than 1/1024):\n",
          table,
          "their contacts, 1/16 past the touch of q16_16 near the origin, compared with it\n"
          "(wrong: contact instead of none or none instead of contact; off: pushed out to a\n"
          "place that is off by more than 1/1024):\n",
          contact_table};
}

}  // namespace detent::cli
