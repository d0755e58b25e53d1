// SPDX-License-Identifier: MIT
#include "casts.hpp"

namespace detent::cli {
namespace {

constexpr double skin = 1.0 / 1024;

/// splitmix64, as in the tests.
class Generator {
 public:
  /// A multiple of 1/65536 in [low, high).
  double number(double low, double high) {
    const auto steps = static_cast<std::uint64_t>((high - low) * 65536);
    return low + static_cast<double>(next() % steps) / 65536;
  }
  bool coin() { return (next() >> 63) != 0; }

 private:
  std::uint64_t next() {
    std::uint64_t z = (state_ += 0x9e3779b97f4a7c15u);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
  }

  std::uint64_t state_ = 1;
};

}  // namespace

std::vector<Throw> shown_throws() {
  // The floor of the house is 1/1024 high.
  const std::array<double, 3> ball{-6, 1.25 + skin, 33.5};
  const std::array<double, 3> foot{-10, 0.75 + 2 * skin, 38}, head{-10, 2.5 + 2 * skin, 38};
  return {{ball, ball, 1.25, {-4, 0, -13}, 60, {0xe8, 0x8c, 0x2a}},
          {foot, head, 0.75, {-17, 0, -13}, 60, {0x3c, 0x9a, 0xd6}}};
}

std::vector<Throw> random_throws(int count) {
  Generator random;
  std::vector<Throw> throws;
  for (int i = 0; i < count; ++i) {
    const double radius = random.number(0.25, 1.5);
    const double length = i % 2 == 0 ? 0 : random.number(0.5, 2);
    const bool is_low = random.coin();
    const double bottom = is_low ? skin : random.number(0.25, 12);
    const std::array<double, 3> a{random.number(-40, 40), bottom + radius, random.number(-30, 40)};
    const double rise = is_low ? 0 : random.number(-0.75, 0.75);
    const std::array<double, 3> way{random.number(-1, 1), rise, random.number(-1, 1)};
    throws.push_back({a, {a[0], a[1] + length, a[2]}, radius, way, 60});
  }
  return throws;
}

}  // namespace detent::cli
