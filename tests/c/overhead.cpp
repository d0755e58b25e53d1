// SPDX-License-Identifier: MIT
//
// Measures the nanoseconds of a call through the C interface and without it, and their difference:
// the least CPU time of many runs. Neither is inlined: inlined, a query whose distance is unused
// would not compute it. `cmake --build BUILD --target detent_c_overhead` builds it.

#include <algorithm>
#include <array>
#include <cstdio>
#include <ctime>
#include <vector>

#include "c/convert.hpp"
#include "detent/scene/scene.hpp"
#include "verify/draw/shapes.hpp"

namespace {

using namespace detent;
using S = q16_16;

constexpr int count = 1024, rounds = 64, runs = 25;

/// The nanoseconds of one f(i), the least of many runs, and a sum of the results.
template <class F>
double least(const char* name, const F& f, long& sum) {
  double best = 1e9;
  for (int run = 0; run < runs; ++run) {
    const auto start = std::clock();
    for (int round = 0; round < rounds; ++round) {
      for (std::size_t i = 0; i < count; ++i) sum += f(i);
    }
    const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    best = std::min(best, seconds / (count * rounds) * 1e9);
  }
  std::printf("%-40s %8.2f ns\n", name, best);
  return best;
}

}  // namespace

int main() {
  verify::Random random(1);
  std::vector<Ray<S, 3>> rays;
  std::vector<Sphere<S, 3>> balls;
  std::vector<detent_ray3> c_rays;
  std::vector<detent_shape3> c_balls;
  using Out = c::Output<3>;
  for (int i = 0; i < count; ++i) {
    verify::ShapeScene<S, 3> scene(random);
    balls.push_back(scene.sphere());
    rays.push_back(scene.aimed_ray());
    detent_shape3 shape{};
    Out::shape(shape, balls.back());
    c_balls.push_back(shape);
    c_rays.push_back({Out::vec(rays.back().origin), Out::direction(rays.back().direction),
                      rays.back().max_distance.raw()});
  }
  detent_context context{};
  detent_handle scene = 0;
  if (detent_open(&context, nullptr) != DETENT_OK) return 1;
  if (detent_scene3_create(&context, &scene) != DETENT_OK) return 1;

  long sum_c = 0, sum_cpp = 0;
  const auto yes = [](const auto& answer) { return answer ? 1 : 0; };
  least(
      "a call that finds its handle",
      [&](std::size_t) {
        std::uint32_t size = 0;
        return detent_scene3_size(&context, scene, &size);
      },
      sum_c);
  sum_c = 0;
  const auto in_cpp = least(
      "raycast of a sphere, C++",
      [&](std::size_t i) {
        return yes(detail::separately<detail::job::Raycast>(rays[i], balls[i]));
      },
      sum_cpp);
  const auto in_c = least(
      "raycast of a sphere, C",
      [&](std::size_t i) { return detent_raycast3(&c_rays[i], &c_balls[i], nullptr); }, sum_c);
  std::printf("%-40s %8.2f ns\n", "difference", in_c - in_cpp);
  const auto overlap_cpp = least(
      "overlap of two spheres, C++",
      [&](std::size_t i) {
        return yes(detail::separately<detail::job::Overlaps>(balls[i], balls[i ^ 1]));
      },
      sum_cpp);
  const auto overlap_c = least(
      "overlap of two spheres, C",
      [&](std::size_t i) { return detent_overlaps3(&c_balls[i], &c_balls[i ^ 1]); }, sum_c);
  std::printf("%-40s %8.2f ns\n", "difference", overlap_c - overlap_cpp);
  if (sum_c != sum_cpp) std::printf("other answers: %ld and %ld\n", sum_c, sum_cpp);
  return sum_c == sum_cpp && detent_close(&context) == DETENT_OK ? 0 : 1;
}
