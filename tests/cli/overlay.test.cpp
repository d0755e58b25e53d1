// SPDX-License-Identifier: MIT
#include "overlay.hpp"

#include <algorithm>

#include "support/catch.hpp"

namespace detent::cli {
namespace {

constexpr Colour ink{200, 100, 50};
constexpr int width = 21, height = 11;

/// At the origin, looking along -z, 90 degrees vertically.
const View view{{0, 0, 0}, {0, 0, -0.5}, {0.5, 0, 0}, {0, 0.5, 0}};

using Distances = std::vector<std::optional<Found>>;

Image drawn(const std::array<double, 3>& a, const std::array<double, 3>& b,
            const Distances& found = Distances(width * height)) {
  Image picture(width, height);
  draw_over(picture, view, {{a, b, ink}}, found);
  return picture;
}
int marks(const Image& picture) {
  int count = 0;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) count += picture.at(x, y) != Colour();
  }
  return count;
}

TEST_CASE("draw_over: lines appear where the camera sees them") {
  // The middle pixel is (10, 5), and at depth 11 each pixel is 2 high.
  const auto point = drawn({0, 0, -11}, {0, 0, -11});
  CHECK(point.at(10, 5) == ink);
  CHECK(marks(point) == 1);
  const auto row = drawn({-4, 2, -11}, {4, 2, -11});
  CHECK(marks(row) == 5);
  for (int x = 8; x <= 12; ++x) CHECK(row.at(x, 4) == ink);
  const auto column = drawn({2, -4, -11}, {2, 4, -11});
  CHECK(marks(column) == 5);
  for (int y = 3; y <= 7; ++y) CHECK(column.at(11, y) == ink);
  // Half-way between two rows, each gets half.
  const auto between = drawn({0, 1, -11}, {0, 1, -11});
  CHECK(between.at(10, 5) == Colour{100, 50, 25});
  CHECK(between.at(10, 4) == Colour{100, 50, 25});
}

TEST_CASE("draw_over: lines end at the picture's border and in front of the camera") {
  CHECK(marks(drawn({-1e6, 0, -11}, {1e6, 0, -11})) == width);
  CHECK(marks(drawn({0, -1e6, -11}, {0, 1e6, -11})) == height);
  CHECK(marks(drawn({0, 30, -11}, {0, 40, -11})) == 0);
  CHECK(marks(drawn({0, 0, 5}, {0, 3, 5})) == 0);
  CHECK(marks(drawn({0, 0, 0}, {0, 0, 0})) == 0);
  // From behind the camera, to the right of it, to the middle.
  const auto behind = drawn({4, 0, 11}, {0, 0, -11});
  CHECK(marks(behind) == 11);
  for (int x = 10; x < width; ++x) CHECK(behind.at(x, 5) == ink);
}

TEST_CASE("draw_over: objects in front of a line hide it") {
  Distances found(width * height);
  for (std::size_t x = 0; x < width; ++x) found[5 * width + x] = Found{0, x < 10 ? 8.0 : 40.0};
  const auto half = drawn({-20, 0, -11}, {20, 0, -11}, found);
  CHECK(marks(half) == 11);
  for (int x = 10; x < width; ++x) CHECK(half.at(x, 5) == ink);
  // Slightly below a surface, it is visible.
  std::fill(found.begin(), found.end(), Found{0, 11});
  CHECK(marks(drawn({0, 0, -11.05}, {0, 0, -11.05}, found)) == 1);
  CHECK(marks(drawn({0, 0, -11.2}, {0, 0, -11.2}, found)) == 0);
}

}  // namespace
}  // namespace detent::cli
