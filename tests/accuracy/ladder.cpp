// SPDX-License-Identifier: MIT
#include "accuracy/ladder.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace detent::accuracy {
namespace {

constexpr double any_angle = -1;
constexpr int fine = 16, coarse = 8;

std::string power_of_two(int exponent) { return "2^" + std::to_string(exponent); }

std::string whole(double value) { return std::to_string(static_cast<long>(value)); }

std::vector<Rung> all_rungs() {
  std::vector<Rung> all;
  for (int k = -16; k <= 14; k += 2) {
    const double size = std::ldexp(1, k);
    const double length = std::min(std::max(60.0, 2 * size), 24000.0);
    const auto name = k < -4 ? power_of_two(k) : k < 0 ? "1/" + whole(1 / size) : whole(size);
    all.push_back({Ladder::size, size, name, size, length, 0, any_angle, fine});
  }
  for (const double length : {0x1p-8, 0x1p-4, 1.0, 4.0, 16.0, 60.0, 250.0, 1000.0, 4000.0, 10000.0,
                              20000.0, 30000.0, 100000.0, 1000000.0, 5000000.0}) {
    const auto name =
        length < 1 ? power_of_two(static_cast<int>(std::log2(length))) : whole(length);
    all.push_back(
        {Ladder::distance, length, name, 1, length, 0, any_angle, length > 30000 ? coarse : fine});
  }
  all.push_back({Ladder::distance, 0, "0", 1, 0, 0, any_angle, fine});
  for (const double place : {0.0, 4.0, 16.0, 100.0, 250.0, 1000.0, 4000.0, 10000.0, 20000.0,
                             32700.0, 100000.0, 1000000.0, 8000000.0}) {
    all.push_back({Ladder::place, place, whole(place), 1, 10, place, any_angle,
                   place > 32700 ? coarse : fine});
  }
  for (int k = -30; k <= -2; k += 4) {
    all.push_back(
        {Ladder::angle, std::ldexp(1, k), power_of_two(k), 1000, 4000, 0, std::ldexp(1, k), fine});
  }
  all.push_back({Ladder::angle, 0, "parallel", 1000, 4000, 0, 0, fine});
  std::stable_sort(all.begin(), all.end(), [](const Rung& a, const Rung& b) {
    return a.ladder < b.ladder || (a.ladder == b.ladder && a.value < b.value);
  });
  return all;
}

}  // namespace

std::string_view name_of(Ladder ladder) {
  static constexpr std::array<std::string_view, 4> names{"size", "distance", "place", "angle"};
  return names[static_cast<std::size_t>(ladder)];
}

std::string_view description_of(Ladder ladder) {
  static constexpr std::array<std::string_view, 4> texts{
      "the size of the shapes, near the world's origin; rays come from 60 units away, or twice the "
      "size",
      "how far rays and casts that start at the world's origin are from shapes of size 1",
      "the coordinates on every axis of shapes of size 1; rays and casts come from 10 units away",
      "the angle in radians between an axis of one shape and of the other, or the ray; size 1000, "
      "rays from 4000 units away (q8_8: 14 and 60)"};
  return texts[static_cast<std::size_t>(ladder)];
}

double Rung::reach() const {
  // Shapes overlap within about 2 sizes of each other; rays can be 1.5 times as long as needed.
  return std::max(place + (ladder == Ladder::distance ? 0 : length) + 4 * size,
                  1.5 * length + 2 * size + 8);
}

const std::vector<Rung>& rungs() {
  static const std::vector<Rung> all = all_rungs();
  return all;
}

}  // namespace detent::accuracy
