// SPDX-License-Identifier: MIT
#pragma once

#include "oracle/ask.hpp"
#include "oracle/describe.hpp"
#include "oracle/hull.hpp"
#include "small/world.hpp"

/// Rays of a small world against every shape, or every shape of an exhaustive set: raycast,
/// raycast_hit and raycast_interval.
namespace detent::small {

template <Scalar S, int N, class Shape>
std::string ray_mistakes(const Ray<S, N>& ray, const Shape& shape,
                         const oracle::Expected<N>& expected) {
  auto found = oracle::mistakes(expected, oracle::ask(ray, shape));
  if constexpr (requires { detent::raycast(ray, shape, Facing::front); }) {
    const auto front = oracle::meets_front(ray, shape) ? expected : oracle::Expected<N>{};
    found += oracle::mistakes(front, oracle::ask(ray, shape, Facing::front));
  }
  return found;
}

template <class Shape, Scalar S, int N>
void ask_rays(Verdict& verdict, const std::vector<Ray<S, N>>& rays,
              const std::vector<Shape>& shapes) {
  for (const auto& shape : shapes) {
    for (const auto& ray : rays) {
      const auto expected = oracle::expected_raycast(ray, shape);
      verdict.count(expected.hit.has_value());
      verdict.judge(ray_mistakes(ray, shape, expected),
                    [&] { return oracle::describe(ray) + "; " + oracle::describe(shape); });
    }
  }
}

/// At most `most_rays` rays against at most `most` shapes of every kind.
template <Scalar S, int N>
void ask_every_ray(std::size_t most_rays, std::size_t most, long expected) {
  Verdict verdict;
  const auto rays = some<Ray<S, N>>(most_rays, all_parts<S, N>(3));
  with_some(most, all_parts<S, N>(),
            [&](const auto&... shapes) { (ask_rays(verdict, rays, shapes), ...); });
  verdict.finish(expected);
}

}  // namespace detent::small
