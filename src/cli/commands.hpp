// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "outlines.hpp"
#include "tracer.hpp"

namespace detent::cli {

/// Two scalars to run side by side.
struct Pair {
  std::string first;
  std::string second;
};

struct CastOptions {
  std::string scene;
  std::string scalar = "q16_16";
  std::optional<Pair> compare;
  std::string out;  // empty for standard output
};

/// The height above a surface at which its shadow rays start: 64 steps of q16_16.
inline constexpr const char* default_bias = "0.0009765625";

struct RenderOptions {
  std::string input;  // a scene, or a model when its name ends in .obj
  std::string out;
  std::string scalar = "q16_16";
  std::optional<Pair> compare;
  Size size{};
  Move offset;
  Decimal bias;
  DebugParts debug;
  std::optional<double> scale;  // of a model
  int threads = 0;
};

struct DemoOptions {
  std::string directory = "build/demo";
  std::string mesh;  // a model to show as well; empty for none
  Size size{};
  int threads = 0;
};

/// Each runs its subcommand (docs/tool.md) and throws InputError when it cannot.
void cast(const CastOptions& options);
void render(const RenderOptions& options);
void demo(const DemoOptions& options);

}  // namespace detent::cli
