// SPDX-License-Identifier: MIT
#pragma once

#include "oracle/ray_exam.hpp"

namespace detent::oracle {

/// Rays from anywhere, roughly towards a point of a box: box(scale) draws one, on_edge(box, loose) a
/// point of it, and question(origin, direction, max_distance, box) is the case.
template <Scalar S, int N, class Box, class OnEdge, class Question>
void draw_rays_at_boxes(RayExam<S, N>& exam, Draw<S, N>& draw, long count, const Box& box,
                        const OnEdge& on_edge, const Question& question) {
  exam.family("random", count, 30, 70, [&] {
    const auto scale = draw.scale();
    const auto origin = draw.point(scale);
    const auto b = box(scale);
    const auto target = on_edge(b, draw.size);
    const auto spread = draw.random.between(0, N == 2 ? scale : scale / 2);
    const auto direction = draw.towards(origin, draw.near(target, spread));
    return question(origin, direction, draw.reach(scale), b);
  });
}

}  // namespace detent::oracle
