// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "tracer.hpp"

namespace detent::cli {

struct SimulateOptions {
  std::string world;
  std::string scalar = "q16_16";
  Move offset;
  int ticks = 300;
  int every = 1;                   // a digest every so many ticks
  bool has_bodies = false;         // also print the final poses of the bodies
  std::string resume;              // a snapshot to start from; empty for none
  std::string out;                 // the snapshot to write; empty for none
  std::optional<int> snapshot_at;  // its tick; the last without one
  std::string frames;              // a folder for pictures; empty for none
  std::string animation;           // an animated picture; empty for none
  int picture_every = 2;           // a picture every so many ticks
  Size size{};
};

/// Steps a world and prints digests (docs/tool.md); throws InputError when it cannot.
void simulate(const SimulateOptions& options);

}  // namespace detent::cli
