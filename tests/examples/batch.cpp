// SPDX-License-Identifier: MIT
// Which of many shapes does a ray hit first?
#include <array>
#include <detent/query/batch.hpp>
#include <detent/query/raycast.hpp>
using namespace detent;

int main() {
  using Ball = Sphere<q16_16, 3>;
  std::array<Ball, 1000> balls;
  for (int i = 0; i < 1000; ++i) {
    balls[static_cast<std::size_t>(i)] = {{q16_16(i % 40 * 5), q16_16(0), q16_16(i)}, q16_16(1)};
  }
  std::array<ShapeBatch<Ball>::Block, batch_blocks(1000)> blocks;  // data about the balls
  const ShapeBatch<Ball> batch(balls, blocks);

  const Ray ray{Vec<q16_16, 3>{}, Direction<q16_16, 3>::along(2), q16_16(2000)};
  const auto first = raycast_first(ray, batch);  // the index and the distance, or nothing
  std::array<std::optional<q16_16>, 1000> distances;
  raycast_each<q16_16, 3>(ray, batch, distances);  // like raycast(ray, balls[i]) for every i
  return first && first->index == 0 && distances[40] == q16_16(39) && !distances[41] ? 0 : 1;
}
