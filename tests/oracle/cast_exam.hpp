// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <type_traits>

#include "detent/query/cast.hpp"
#include "oracle/cast_judge.hpp"
#include "oracle/hull.hpp"
#include "oracle/pair_exam.hpp"
#include "support/shapes.hpp"

namespace detent::oracle {

/// Every shape that a cast can move.
template <Scalar S, int N>
using CastShapes = typename support::MovingShapes<S, N>::template and_also<Segment<S, N>>;

/// Every target or, in the everyday run, one of each family: all take a minute more to compile.
template <Scalar S, int N>
using CastTargets = std::conditional_t<DETENT_TEST_ALL, support::AllShapes<S, N>,
                                       support::ShapeList<Sphere<S, N>, Obb<S, N>, Triangle<S, N>>>;

/// Each has sources of its own, which takes less time and memory to compile.
enum class CastFamily { round, boxes, polytopes };

template <class Shape>
inline constexpr auto family_of = [] {
  if constexpr (requires(Shape shape) { shape.radius; }) return CastFamily::round;
  constexpr bool is_box = detail::is_kind<Shape, Aabb> || detail::is_kind<Shape, Obb>;
  return is_box ? CastFamily::boxes : CastFamily::polytopes;
}();

/// Compares the casts of random shapes at random targets with the oracle's. Every third cast goes
/// from a corner of the range to anywhere within it.
template <Scalar S, int N>
class CastExam {
 public:
  explicit CastExam(std::uint64_t seed) : draw_(seed) {}

  template <class A, class B>
  void examine(long count) {
    long hits = 0, starts = 0;
    for (long i = 0; i < count; ++i) {
      const bool is_long = i % 3 == 2;
      auto setting = is_long ? corner_setting() : any_setting(draw_, Kind::general, 300);
      const auto a = draw_shape<A>(draw_, setting);
      if (is_long) setting.center = anywhere_near(setting.center);
      const auto b = draw_shape<B>(draw_, setting);
      const auto direction = draw_direction(setting, a, b);
      const S most = draw_.reach(setting.size);
      const auto found = cast(a, direction, most, b);
      const auto travel = travel_of(a, direction, b);
      auto complaint = fault_of(travel, a, direction, b, found, most);
      if (complaint.empty() && found) {
        ++hits;
        if (found->distance == S(0)) ++starts;
        if (is_long && raw_of(found->distance) > Draw<S, N>::limit / 8) ++long_hits_;
        // Hit or miss for motions that end at the touch.
        for (const int more : {-1, 0, 1}) {
          const S limit = Draw<S, N>::scalar(raw_of(found->distance) + more);
          if (limit > most || !complaint.empty()) continue;
          complaint = fault_of_distance(travel, cast(a, direction, limit, b), limit);
        }
      }
      if (complaint.empty() && detail::cast_distance(a, direction, most, b) !=
                                   (found ? std::optional(found->distance) : std::nullopt)) {
        complaint = "cast_distance differs";
      }
      if (complaint.empty()) continue;
      FAIL_CHECK(draw_.random << ": " << describe(a) << "; " << describe(b) << " along "
                              << describe(direction) << " by " << most.raw() << ": " << complaint
                              << "; found "
                              << (found ? std::to_string(found->distance.raw()) : "nothing"));
      return;
    }
    INFO(draw_.random << ", " << hits << " of " << count << " hit, " << starts << " at the start");
    CHECK(hits > starts);
    hits_ += hits;
    starts_ += starts;
    asked_ += count;
  }

  /// `count` casts of A at every target.
  template <class A>
  void examine_all(long count) {
    CastTargets<S, N>::for_each([&]<class B>(const B&) { examine<A, B>(count); });
    if constexpr (DETENT_TEST_ALL) {
      for (long i = 0; i < count; ++i) examine_compound<A>();
    }
  }

  void finish() {
    INFO(draw_.random << ", " << hits_ << " of " << asked_ << " hit, " << starts_
                      << " at the start");
    CHECK(hits_ <= asked_ * 8 / 10);
    CHECK(hits_ - starts_ >= asked_ / 4);
    CHECK(long_hits_ >= asked_ / 20);
  }

 private:
  /// The first part that is hit, in the order of the lists.
  template <class A>
  void examine_compound() {
    const auto setting = any_setting(draw_, Kind::lattice, 300);
    const auto a = draw_shape<A>(draw_, setting);
    const auto draw_two = [&]<class B>(const B&) {
      return std::array{draw_shape<B>(draw_, setting), draw_shape<B>(draw_, setting)};
    };
    const auto boxes = draw_two(Obb<S, N>());
    const auto spheres = draw_two(Sphere<S, N>());
    const auto triangles = draw_two(Triangle<S, N>());
    const auto direction = draw_direction(setting, a, triangles[0]);
    const S most = draw_.reach(setting.size);
    std::optional<CastHit<S, N>> first;
    const auto offer = [&](const auto& parts) {
      for (const auto& part : parts) {
        const auto hit = cast(a, direction, most, part);
        if (hit && (!first || hit->distance < first->distance)) first = hit;
      }
    };
    offer(boxes);
    offer(spheres);
    offer(triangles);
    INFO(draw_.random << ": " << describe(a) << " along " << describe(direction));
    CHECK(cast(a, direction, most, Compound{boxes, spheres, triangles}) == first);
  }

  /// Shapes of any size in a corner of the range.
  Setting<N> corner_setting() {
    auto setting = draw_setting(draw_, Kind::general, 100);
    const auto reach = std::min(4 * setting.size, Draw<S, N>::limit);
    for (auto& x : setting.center) {
      x = Draw<S, N>::limit - draw_.random.between(0, reach);
      if (draw_.random.coin()) x = -x;
    }
    return setting;
  }
  /// Up to the length of a cast away from a corner on every axis, within the range.
  Raw<N> anywhere_near(Raw<N> corner) {
    for (auto& x : corner) {
      const auto reach = draw_.random.between(0, Draw<S, N>::limit >> draw_.random.below(4));
      x += x < 0 ? reach : -reach;
    }
    return corner;
  }

  static std::int64_t raw_of(const S& x) { return static_cast<std::int64_t>(x.raw()); }

  template <class Shape>
  Raw<N> some_point(const Shape& shape) {
    Raw<N> point{};
    if constexpr (requires { shape.normal; }) {
      for (std::size_t i = 0; i < point.size(); ++i) {
        const auto n = static_cast<std::int64_t>(shape.normal[static_cast<int>(i)].raw());
        point[i] =
            static_cast<std::int64_t>(floor_quotient(Integer(n) * raw(shape.offset), one_of<S>()));
      }
    } else if constexpr (requires { shape.points; }) {
      if (shape.points.empty()) return point;
      return plain(shape.points[draw_.random.below(shape.points.size())]);
    } else {
      return plain(detail::first_point(shape));
    }
    return point;
  }
  static Raw<N> plain(const Vec<S, N>& v) {
    Raw<N> point{};
    for (int i = 0; i < N; ++i) point[static_cast<std::size_t>(i)] = raw_of(v[i]);
    return point;
  }

  template <class A, class B>
  Direction<S, N> draw_direction(const Setting<N>& setting, const A& a, const B& b) {
    auto& random = draw_.random;
    const bool on_lattice = setting.kind == Kind::lattice || setting.kind == Kind::degenerate;
    if (on_lattice && !random.one_in(4)) {
      const bool is_axis = random.coin();
      const auto direction = Draw<S, N>::stretched(
          is_axis ? draw_.unit() : setting.frame.axes[random.below(Draw<S, N>::size)],
          is_axis ? 1 : setting.frame.norm);
      return random.coin() ? direction : -direction;
    }
    if (random.one_in(8)) return draw_.any_direction();
    const auto to = draw_.near(some_point(b), setting.kind == Kind::general ? setting.size / 2 : 1);
    const auto direction = draw_.towards(some_point(a), to);
    return direction;
  }

  Draw<S, N> draw_;
  long hits_ = 0, starts_ = 0, long_hits_ = 0, asked_ = 0;
};

/// Casts `count` of every shape of these families at every target.
template <Scalar S, int N, CastFamily... Family>
void examine_casts(std::uint64_t seed, long count) {
  CastExam<S, N> exam(seed);
  CastShapes<S, N>::for_each([&]<class A>(const A&) {
    if constexpr (((family_of<A> == Family) || ...)) exam.template examine_all<A>(count);
  });
  exam.finish();
}

}  // namespace detent::oracle
