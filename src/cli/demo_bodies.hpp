// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "commands.hpp"
#include "image.hpp"

namespace detent::cli {

/// A ball thrown at a pyramid of boxes, near and far in both scalars; and a table of the distances
/// of bodies from where they end near the origin.
struct BodyPage {
  Image page;
  std::string title;
  std::string rows;
};
[[nodiscard]] BodyPage body_page(const DemoOptions& options);

}  // namespace detent::cli
