// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <typeinfo>

#include "oracle/impact_truth.hpp"
#include "oracle/seeds.hpp"
#include "oracle/space.hpp"
#include "support/catch.hpp"

namespace detent::oracle {

/// Random bodies: of every size and scale, offset from their frames, turning by any angle, and
/// moving so that about half of them meet.
template <Scalar S, int N>
class Bodies {
 public:
  explicit Bodies(std::uint64_t seed) : random(seed) {}

  test::Random random;

  /// A scale for the next case: the bits of the bodies' size.
  void next_case() { bits_ = static_cast<int>(random.between(2, S::bits - 2)); }

  template <class Shape>
  Shape shape() {
    if constexpr (std::is_same_v<Shape, Sphere<S, N>>) {
      return {offset(), extent()};
    } else if constexpr (support::OfPoints<Shape>) {
      return support::made_of<Shape>([this] { return point(bits_); }, [this] { return extent(); });
    } else if constexpr (std::is_same_v<Shape, Aabb<S, N>>) {
      const auto center = offset();
      Aabb<S, N> box;
      for (int i = 0; i < N; ++i) {
        const auto half = extent();
        box.min[i] = nearest_to<S>(center[i] - half);
        box.max[i] = nearest_to<S>(center[i] + half);
      }
      return box;
    } else if constexpr (std::is_same_v<Shape, Obb<S, N>>) {
      return {offset(), make_vec<N>([&](int) { return extent(); }), rotation()};
    } else {
      auto& points = hulls_[next_hull_++ % hulls_.size()];
      for (auto& p : points) p = point(bits_);
      return Shape{points};
    }
  }

  Sweep<S, N> sweep() {
    Sweep<S, N> result;
    result.start = point(bits_ + 1);
    result.end = random.one_in(8) ? result.start : point(bits_ - (N == 3 ? 1 : 0));
    if (random.one_in(4)) return result;
    result.start_rotation = rotation();
    result.end_rotation = random.one_in(6) ? result.start_rotation : rotation();
    return result;
  }

  Rotation<S, N> rotation() {
    if (random.one_in(6)) return {};
    if constexpr (N == 2) {
      return Rotation<S, 2>::from_angle(Angle<S>::from_raw(
          static_cast<std::uint32_t>(random.one_in(4) ? random.below(8) << 29 : random.next())));
    } else {
      const int reach = random.one_in(4) ? 1 : S::bits - 1;
      const auto part = [&] {
        return S::from_raw(static_cast<typename S::raw_type>(random.wide(reach)));
      };
      return Rotation<S, 3>::from_quaternion(part(), part(), part(), part())
          .value_or(Rotation<S, 3>());
    }
  }

  Vec<S, N> point(int bits) {
    const auto limit = std::int64_t{1} << std::min(bits, S::bits);
    return make_vec<N>([&](int) { return random.number<S>(-limit, limit - 1); });
  }

 private:
  Vec<S, N> offset() { return random.coin() ? Vec<S, N>{} : point(bits_ - 1); }
  S extent() { return random.number<S>(0, std::int64_t{1} << (bits_ - 1)); }

  int bits_ = 4;
  std::array<std::array<Vec<S, N>, 5>, 2> hulls_{};
  std::size_t next_hull_ = 0;
};

/// Counts of a sweep of cases.
struct Tally {
  test::HitRate hits;
  long cases = 0, steps = 0, unfinished = 0;
  int most = 0;

  template <class Found>
  void count(const Found& found) {
    hits.count(found.impact.has_value());
    ++cases;
    steps += found.steps;
    most = std::max(most, found.steps);
    if (found.impact && !found.impact->is_hit) ++unfinished;
  }
};

template <class A, class B, Scalar S, int N>
void examine(Bodies<S, N>& bodies, Tally& tally, long count) {
  for (long i = 0; i < count; ++i) {
    bodies.next_case();
    const auto a = bodies.template shape<A>();
    const auto b = bodies.template shape<B>();
    const auto sweep_a = bodies.sweep(), sweep_b = bodies.sweep();
    const S target = S::from_raw(bodies.random.one_in(4) ? 0 : 8);
    const auto found = detent::detail::search_impact(a, sweep_a, b, sweep_b, target);
    const auto fault = fault_of(found.impact, moving(a, sweep_a), moving(b, sweep_b), target, 12);
    tally.count(found);
    if (!fault) continue;
    INFO(bodies.random << ", case " << i << " of kinds " << typeid(A).name() << " and "
                       << typeid(B).name());
    FAIL_CHECK(*fault);
    return;
  }
}

/// `count` moving pairs of every two kinds of shapes.
template <Scalar S, int N>
void examine_impacts(std::uint64_t seed, long count) {
  Bodies<S, N> bodies(seed);
  Tally tally;
  support::MovingShapes<S, N>::for_each_pair(
      [&]<class A, class B>(const A&, const B&) { examine<A, B>(bodies, tally, count); });
  INFO(tally.hits << ", " << tally.steps << " steps in " << tally.cases << " cases, at most "
                  << tally.most << ", unfinished " << tally.unfinished);
  CHECK(tally.hits.is_balanced());
  CHECK(tally.steps < 6 * tally.cases);
  CHECK(tally.most <= 128);
  CHECK(tally.unfinished * 500 <= tally.cases);
}

}  // namespace detent::oracle
