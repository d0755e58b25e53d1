// SPDX-License-Identifier: MIT
#include "detent/query/kernel/box_filter.hpp"

#include "detent/query/kernel/box_triangle_filter.hpp"
#include "detent/shape/obb.hpp"
#include "detent/shape/triangle.hpp"
#include "oracle/space.hpp"
#include "query/kernel/turns.hpp"
#include "query/overlaps/helpers.hpp"

namespace detent::test {
namespace {

template <Scalar S>
Obb<S, 3> random_box(Random& random, int bits, const Rotation<S, 3>& rotation) {
  Obb<S, 3> box{{}, {}, rotation};
  for (int i = 0; i < 3; ++i) {
    const auto half = random.one_in(8) ? 0 : random.below(std::uint64_t{1} << bits);
    box.half_extents[i] = S::from_raw(static_cast<std::int32_t>(half));
  }
  return box;
}

/// Unit vectors along which two boxes may just touch: an axis of either box, a cross product, or
/// any vector.
template <Scalar S>
Direction<S, 3> random_way(Random& random, const Obb<S, 3>& a, const Obb<S, 3>& b) {
  const auto& u = a.rotation.axis(static_cast<int>(random.below(3)));
  const auto& v = b.rotation.axis(static_cast<int>(random.below(3)));
  if (random.one_in(3)) return random.coin() ? u : v;
  const auto across = direction_of<S>(cross(u, v.vec()));
  return across && random.coin() ? *across : random_turn<S>(random, 32).axis(0);
}

struct Count {
  int asked = 0, unsure = 0, wrong = 0;

  void add(Filtered filtered, bool answer) {
    ++asked;
    unsure += filtered == Filtered::unsure ? 1 : 0;
    wrong += filtered == (answer ? Filtered::no : Filtered::yes) ? 1 : 0;
  }
};

/// Calls `ask(0)` and, if it returns true, bisects for the smallest number of steps for which it
/// returns false.
template <class Ask>
void ask_up_to_the_last(const Ask& ask) {
  std::int64_t inside = 0, outside = std::int64_t{1} << 32;
  if (!ask(inside)) return;
  while (outside - inside > 1) {
    const auto middle = (inside + outside) / 2;
    (ask(middle) ? inside : outside) = middle;
  }
}

/// Moves b away from a until they are apart, testing on the way, mostly close to the transition.
template <Scalar S>
void ask_on_the_way(Random& random, const Obb<S, 3>& a, const Obb<S, 3>& b, Count& count) {
  const detail::EdgeFrame<S> frame_a(a.rotation), frame_b(b.rotation);
  if (frame_a.is_flat() && frame_b.is_flat()) return;
  const auto way = random_way(random, a, b);
  const auto ask = [&](std::int64_t steps) {
    const auto apart = make_vec<3>([&](int i) {
      return Fixed<32, S::frac>::from_raw((std::int64_t{way[i].raw()} * steps) >> 30);
    });
    const bool answer =
        detail::boxes_overlap(frame_a, a.half_extents, frame_b, b.half_extents, apart);
    count.add(detail::decide_boxes_overlap(detail::AxisFrame(a.rotation), a.half_extents,
                                           detail::AxisFrame(b.rotation), b.half_extents, apart),
              answer);
    return answer;
  };
  ask_up_to_the_last(ask);
}

/// The same with a triangle around the center of a box.
template <Scalar S>
void ask_on_the_way(Random& random, const Obb<S, 3>& box, const Triangle<S, 3>& triangle,
                    Count& count) {
  const detail::EdgeFrame<S> frame(box.rotation);
  if (frame.is_flat()) return;
  const auto way = random_way(random, box, box);
  ask_up_to_the_last([&](std::int64_t steps) {
    const auto seen = [&](const Vec<S, 3>& corner) {
      return make_vec<3>([&](int i) {
        const std::int64_t step = (std::int64_t{way[i].raw()} * steps) >> 31;
        return Fixed<32, S::frac>::from_raw(corner[i].raw() + step);
      });
    };
    const auto a = seen(triangle.a), b = seen(triangle.b), c = seen(triangle.c);
    const bool answer = detail::box_meets_triangle<S::bits + 1>(frame, box.half_extents, a, b, c);
    count.add(detail::decide_box_meets_triangle(detail::AxisFrame(box.rotation), box.half_extents,
                                                std::array{a, b, c}),
              answer);
    return answer;
  });
}

/// Whether all answers are right, and fewer than `most` of those for large boxes unsure.
void check(const Random& random, const Count& any, const Count& large, int most) {
  INFO(random << ": of " << any.asked << " and " << large.asked << " questions, unsure are "
              << any.unsure << " and " << large.unsure);
  CHECK(any.wrong + large.wrong == 0);
  CHECK(any.unsure > 0);
  CHECK(large.unsure < most);
}

TEMPLATE_TEST_CASE("OBB and OBB: the filter is correct or unsure", "[overlaps]",
                   DETENT_FILTER_SCALARS) {
  using S = TestType;
  Random random(0x0bb5);
  Count any, large;
  for (int i = 0; i < 2000; ++i) {
    const int bits = 4 + i % (S::bits - 4);
    const auto turn = random.coin() ? random_turn<S>(random, 32) : Rotation<S, 3>();
    auto other = compose(random_turn<S>(random, static_cast<int>(random.below(33))), turn);
    const auto a = random_box(random, bits, turn);
    auto b = random_box(random, bits, other);
    ask_on_the_way(random, a, b, bits < 20 ? any : large);
    // Sheared, so that its axes may not be perpendicular enough.
    const auto tilted = compose(random_turn<S>(random, static_cast<int>(random.below(20))), other);
    b.rotation = Rotation<S, 3>::from_axes({tilted.axis(0), other.axis(1), tilted.axis(2)});
    ask_on_the_way(random, a, b, any);
  }
  // Half of the steps are within 2^-16 of the transition.
  check(random, any, large, large.asked / 2);
}

TEMPLATE_TEST_CASE("OBB and triangle: the filter is correct or unsure", "[overlaps]",
                   DETENT_FILTER_SCALARS) {
  using S = TestType;
  Random random(0x0b73);
  Count any, large;
  for (int i = 0; i < 1000; ++i) {
    const int bits = 4 + i % (S::bits - 5);
    const auto turn = random_turn<S>(random, static_cast<int>(random.below(33)));
    auto box = random_box(random, bits, turn);
    const auto corner = [&] {
      return make_vec<3>(
          [&](int) { return S::from_raw(static_cast<typename S::raw_type>(random.wide(bits))); });
    };
    const Triangle<S, 3> triangle{corner(), corner(), corner()};
    ask_on_the_way(random, box, triangle, bits < 20 ? any : large);
    const auto tilted = compose(random_turn<S>(random, static_cast<int>(random.below(20))), turn);
    box.rotation = Rotation<S, 3>::from_axes({tilted.axis(0), turn.axis(1), tilted.axis(2)});
    ask_on_the_way(random, box, triangle, any);
  }
  check(random, any, large, large.asked * 3 / 4);
}

}  // namespace
}  // namespace detent::test
