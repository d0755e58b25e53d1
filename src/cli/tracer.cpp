// SPDX-License-Identifier: MIT
#include "tracer.hpp"

#include <algorithm>
#include <ctime>
#include <utility>

namespace detent::cli {
namespace {

/// This thread's CPU time, which excludes time when a busy machine suspends it.
double thread_nanoseconds() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) * 1e9 + static_cast<double>(time.tv_nsec);
}

}  // namespace

std::vector<double> time_per_ray(const std::vector<const Tracer*>& tracers) {
  constexpr std::size_t batches = 25;
  constexpr std::size_t most_rays = 4096;  // per batch
  constexpr double shortest = 1e6;         // nanoseconds

  struct Lane {
    std::size_t stride;
    double rays;
    int repeats = 1;
    std::vector<double> nanoseconds{};
  };
  const auto time_of = [](const Tracer& tracer, const Lane& lane) {
    const double start = thread_nanoseconds();
    for (int i = 0; i < lane.repeats; ++i) tracer.repeat(lane.stride);
    return thread_nanoseconds() - start;
  };

  std::vector<Lane> lanes;
  for (const Tracer* const tracer : tracers) {
    const std::size_t count = std::max<std::size_t>(tracer->ray_count(), 1);
    const std::size_t stride = (count + most_rays - 1) / most_rays;
    const std::size_t rays = (count + stride - 1) / stride;
    Lane lane{stride, static_cast<double>(rays)};
    while (time_of(*tracer, lane) < shortest && lane.repeats < (1 << 20)) lane.repeats *= 2;
    lanes.push_back(std::move(lane));
  }
  for (std::size_t batch = 0; batch < batches; ++batch) {
    for (std::size_t turn = 0; turn < lanes.size(); ++turn) {
      const std::size_t i = (batch + turn) % lanes.size();  // rotates the order
      lanes[i].nanoseconds.push_back(time_of(*tracers[i], lanes[i]) /
                                     (lanes[i].rays * lanes[i].repeats));
    }
  }
  std::vector<double> medians;
  for (Lane& lane : lanes) {
    const auto middle = lane.nanoseconds.begin() + batches / 2;
    std::nth_element(lane.nanoseconds.begin(), middle, lane.nanoseconds.end());
    medians.push_back(*middle);
  }
  return medians;
}

}  // namespace detent::cli
