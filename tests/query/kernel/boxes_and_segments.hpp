// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstdint>

#include "detent/math/rotation.hpp"
#include "detent/shape/aabb.hpp"
#include "detent/shape/obb.hpp"
#include "detent/shape/segment.hpp"
#include "query/kernel/turns.hpp"
#include "support/catch.hpp"
#include "support/random.hpp"

namespace detent::test {

/// How the axes of a box are turned; `skew` ones are not perpendicular, and may be equal.
enum class Turning { any, none, little, skew };

/// Draws boxes and segments with lengths below 2^bits steps, many of them flat, without length, along
/// an axis, or touching.
template <Scalar S>
class BoxesAndSegments {
 public:
  BoxesAndSegments(Random& random, int bits) : random_(random), reach_(std::int64_t{1} << bits) {}

  [[nodiscard]] S number(std::int64_t low, std::int64_t high) {
    return random_.number<S>(low, high);
  }
  [[nodiscard]] Vec<S, 3> vector(std::int64_t reach) {
    return make_vec<3>([&](int) { return number(-reach, reach - 1); });
  }
  [[nodiscard]] S extent() { return random_.one_in(8) ? S(0) : number(0, reach_ / 2); }
  [[nodiscard]] S radius() { return random_.one_in(3) ? S(0) : number(0, reach_ / 2); }

  [[nodiscard]] Obb<S, 3> box(Turning turning) {
    Obb<S, 3> box{vector(std::max<std::int64_t>(reach_ / 4, 1)),
                  make_vec<3>([&](int) { return extent(); }),
                  {}};
    const auto turn = [&](int bits) { return random_turn<S>(random_, bits); };
    if (turning == Turning::any) box.rotation = turn(32);
    if (turning == Turning::little) box.rotation = turn(static_cast<int>(random_.below(20)));
    if (turning == Turning::skew) {
      const auto first = turn(32), second = turn(32);
      box.rotation = Rotation<S, 3>::from_axes(
          {first.axis(0), second.axis(1), random_.coin() ? first.axis(2) : first.axis(0)});
    }
    return box;
  }
  [[nodiscard]] Aabb<S, 3> aligned_box() {
    const auto middle = vector(std::max<std::int64_t>(reach_ / 4, 1));
    Aabb<S, 3> box;
    for (int i = 0; i < 3; ++i) {
      box.min[i] = nearest_to<S>(middle[i] - extent());
      box.max[i] = std::max(box.min[i], nearest_to<S>(middle[i] + extent()));
    }
    return box;
  }
  template <class Box>
  [[nodiscard]] Segment<S, 3> segment(const Box& box) {
    Segment<S, 3> segment{vector(reach_), vector(reach_)};
    if (random_.one_in(8)) segment.start = some_point(box);
    if (random_.one_in(8)) segment.end = segment.start;
    if (random_.one_in(4)) {
      const int i = static_cast<int>(random_.below(3));
      segment.end[i] = segment.start[i];
    }
    return segment;
  }

 private:
  [[nodiscard]] Vec<S, 3> some_point(const Obb<S, 3>& box) { return box.center; }
  [[nodiscard]] Vec<S, 3> some_point(const Aabb<S, 3>& box) {
    return make_vec<3>([&](int i) { return random_.coin() ? box.min[i] : box.max[i]; });
  }

  Random& random_;
  std::int64_t reach_;
};

/// Calls f(draw) with a `BoxesAndSegments`, `asked` times.
template <Scalar S, class F>
void draw_boxes_and_segments(int bits, int asked, const F& f) {
  Random random(static_cast<std::uint64_t>(bits));
  INFO(random);
  for (int i = 0; i < asked; ++i) {
    CAPTURE(bits, i);
    f(BoxesAndSegments<S>(random, bits));
  }
}

}  // namespace detent::test
