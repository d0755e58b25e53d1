// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <string>

#include "commands.hpp"
#include "image.hpp"

namespace detent::cli {

/// The distance of the second half of the demonstration from the origin, on each axis.
inline constexpr const char* far_away = "28000";

/// A row of a table of the demonstration.
[[nodiscard]] std::string demo_row(const std::array<std::string, 8>& cells);

/// A ball and a capsule cast through a scene, near and far in both scalars, and their contacts a
/// little past the touch; and tables of the errors of many casts and contacts.
struct CastPage {
  Image page;
  std::string title;
  std::string rows;
  std::string contact_title;
  std::string contact_rows;
};
[[nodiscard]] CastPage cast_page(const Scene& scene, const DemoOptions& options);

}  // namespace detent::cli
