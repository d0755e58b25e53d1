// SPDX-License-Identifier: MIT
#include "demo_bodies.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "compare.hpp"
#include "demo_casts.hpp"
#include "embedded.hpp"
#include "painter.hpp"
#include "print.hpp"
#include "workers.hpp"

namespace detent::cli {
namespace {

constexpr int ticks = 240;       // the ball arrives at about 60
constexpr int shown_tick = 105;  // the tick of the picture

/// The distance of bodies from their positions in another world.
struct Apart {
  std::size_t off = 0;  // by more than 1/1024
  double largest = 0;
};

Apart apart(const Simulation& a, const Simulation& b, std::size_t bodies) {
  Apart result;
  for (std::size_t i = 0; i < bodies; ++i) {
    const auto p = a.position(i), q = b.position(i);
    const double distance = std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
    result.off += distance > 1.0 / 1024;
    result.largest = std::max(result.largest, distance);
  }
  return result;
}

struct Rows {
  Image picture;
  std::string text;
};

/// The world in one scalar, near and far.
template <Scalar S>
Rows rows(const WorldModel& model, const std::string& scalar, const DemoOptions& options) {
  const Decimal distance = Decimal::parse(far_away).value();
  const auto close = make_simulation<S, 3>(model, {});
  const auto away = make_simulation<S, 3>(model, {{distance, distance, distance}});
  const Painter painter(model, *close, options.size);
  const auto step = [&](int count) {
    for_each_index({options.threads, ""}, 2, [&](int which) {
      Simulation& simulation = which == 0 ? *close : *away;
      for (int i = 0; i < count; ++i) simulation.step();
    });
  };
  step(shown_tick);
  const Image picture = painter.picture(close->facets()), other = painter.picture(away->facets());
  step(ticks - shown_tick);

  std::string text;
  for (const Simulation* const simulation : {close.get(), away.get()}) {
    const Apart errors = apart(*simulation, *close, model.bodies.size());
    text += demo_row({simulation == close.get() ? "near" : "far", scalar,
                      std::to_string(model.bodies.size()), std::to_string(ticks),
                      std::to_string(simulation->asleep()), std::to_string(errors.off),
                      rounded(errors.largest, 4), hexadecimal(simulation->digest())});
  }
  return {panel_row({{picture, scalar + ", near the origin"},
                     {other, scalar + ", moved by " + far_away},
                     difference_panel(picture, other)}),
          text};
}

}  // namespace

BodyPage body_page(const DemoOptions& options) {
  const WorldModel model = parse_world("pyramid.json", std::string(pyramid_json));
  const Rows fixed = rows<q16_16>(model, "q16_16", options);
  const Rows floating = rows<float>(model, "float", options);
  return {stacked({fixed.picture, floating.picture}),
          "a ball thrown at a pyramid of boxes, far compared with near in the same scalar\n"
          "(off: bodies that end more than 1/1024 from where they end near the origin):\n",
          demo_row({"place", "scalar", "bodies", "ticks", "asleep", "off", "largest", "digest"}) +
              fixed.text + floating.text};
}

}  // namespace detent::cli
