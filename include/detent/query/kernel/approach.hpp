// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <type_traits>

#include "detent/number/filter/leading.hpp"
#include "detent/query/kernel/gjk.hpp"
#include "detent/query/kernel/swept_body.hpp"

namespace detent::detail {

/// A lower bound of `x`, on the grid of `T` and clamped, too small by less than 2^-37 of x plus one
/// step. The relative error of `x` must be below 2^-38.
template <class T>
[[nodiscard]] constexpr T floor_below(Leading x) noexcept {
  using Raw = typename T::raw_type;
  constexpr int most = bits_of<T> - T::frac;
  x.word -= x.word >> 38;
  if (x.word == 0) return T(0);
  if (x.exponent + 64 > most) return largest<T>;
  const int dropped = -(x.exponent + T::frac);
  return T::assume_raw(static_cast<Raw>(dropped > 63 ? 0 : x.word >> dropped));
}

/// The distance between two bodies, compared with a radius.
enum class Clearance { none, touch, apart };

/// How far a body can move, rounded down and clamped, before its distance from another one may
/// reach the radius. `approaches` is false if it never does.
template <Number Time>
struct Lead {
  Clearance clearance = Clearance::none;
  bool approaches = true;
  Time distance = Time(0);
};

/// The first time at which the body `a`, moving along `way`, is within `radius` > 0 of the body `b`,
/// by Newton's method. Time is in the unit of `way`.
///
/// The distance of the bodies is a convex function of time. If p is the closest point of b - a at
/// some time, the bodies are at least p . (p - t way) / |p| apart. So a step by (|p| - radius)
/// |p| / (p . way) does not pass the first touch. The step is rounded down to the grid of time;
/// once it is 0, the motion up to the next time on the grid decides. All decisions are exact: the
/// rounding of steps only changes their number.
///
/// Scaled by 2^shift, the scene and its times are the same on a finer grid; `shift` is at most
/// `Shift`.
///
/// source: Newton's method for ray casts against convex bodies: van den Bergen, Ray Casting against
///         General Convex Objects with Application to Continuous Collision Detection (2004)
template <class A, class B, Number W, Scalar S, int Shift>
class Approach {
 public:
  static constexpr int dimension = A::dimension;
  using Way = Vec<W, dimension>;
  using Time = decltype(scale_up<bits_of<S> + Shift>(S(), 0));

  /// The radius is the sum of two scalars.
  template <Number R>
  constexpr Approach(const A& a, const B& b, const Way& way, const R& radius, int shift) noexcept
      : a_(a), b_(b), way_(way), radius_(scale_up<bits_of<Radius>>(radius, shift)), shift_(shift) {}

  /// `time` in the unscaled scene.
  template <Number T>
  [[nodiscard]] constexpr Time scaled(const T& time) const noexcept {
    return scale_up<bits_of<Time>>(time, shift_);
  }
  /// The time `steps` later on the grid.
  [[nodiscard]] static constexpr Time neighbor(const Time& time, int steps) noexcept {
    return Time::assume_raw(static_cast<typename Time::raw_type>(time.raw() + steps));
  }

  /// The first time of at least `time` and at most `limit` at which the bodies are within the
  /// radius, rounded down. They must not be within it before `time`.
  [[nodiscard]] constexpr std::optional<Time> first(Time time, const Time& limit) const noexcept {
    for (Patience<S> patience; patience.step();) {
      const auto lead = lead_at(time);
      if (lead.clearance != Clearance::apart) return time;
      if (!lead.approaches || lead.distance > limit - time) return std::nullopt;
      if constexpr (!is_fixed<S>) {
        if (!(time + lead.distance > time)) return time;
        time = time + lead.distance;
      } else if (lead.distance == 0) {
        if (time == limit) return std::nullopt;
        const auto next = neighbor(time, 1);
        const auto clearance = clearance_between(time, next);
        if (clearance == Clearance::none) return time;
        if (clearance == Clearance::touch) return is_first_touch(next) ? next : time;
        time = next;
      } else {
        time = sum(time, lead.distance);
      }
    }
    return time;
  }

  /// Returns f(v) for a vector v between the closest points at the first touch, from `a` to `b`, or
  /// less than two times of the grid before it. The bodies touch between `time` and `limit`, and not
  /// before.
  ///
  /// The curvature of the distance is at most 1 / radius. So a Newton step covers at least half of
  /// the way to the first touch.
  template <class F>
  [[nodiscard]] constexpr auto with_touch(const Time& time, const Time& limit,
                                          const F& f) const noexcept {
    return with_touch_of(
        [&](const Time& at, const auto& g) {
          return this->with_feature(at, at, [&](const auto& found) { return across(found, g); });
        },
        time, limit, f);
  }
  /// The same if the closest differences of corners are known to lie in one feature.
  template <class Feature, class F>
  [[nodiscard]] constexpr auto with_touch_on(const Feature& feature, const Time& time,
                                             const Time& limit, const F& f) const noexcept {
    return with_touch_of(
        [&](const Time& at, const auto& g) {
          return with_moved(feature, at, [&](const auto& found) { return across(found, g); });
        },
        time, limit, f);
  }
  /// The same for two points, whose difference is `corner` at the start.
  template <Number T, class F>
  [[nodiscard]] constexpr auto with_touch_of_points(const Vec<T, dimension>& corner,
                                                    const Time& time, const Time& limit,
                                                    const F& f) const noexcept {
    return with_touch_of(
        [&](const Time& at, const auto& g) {
          return by_width<short_bits>(
              [&](const auto& place) {
                return g(place, [&] {
                  const auto excess = squared_length(place) - square(radius_);
                  using One = std::remove_cvref_t<decltype(place.x)>;
                  using Quotient = std::remove_cvref_t<decltype(quotient(excess, One(1)))>;
                  return excess > 0 ? quotient(excess, One(1)) : Quotient();
                });
              },
              moved(corner, way_ * at));
        },
        time, limit, f);
  }

  /// The clearance at `time`, and how far the body can move from there.
  [[nodiscard]] constexpr Lead<Time> lead_at(const Time& time) const noexcept {
    return with_feature(time, time, [&](const auto& feature) {
      if (feature.count > dimension) return Lead<Time>{};
      return with_direction(feature, [&](const auto& v) { return lead(feature, v); });
    });
  }

  /// The least clearance between two times.
  [[nodiscard]] constexpr Clearance clearance_between(const Time& from,
                                                      const Time& to) const noexcept {
    return with_feature(from, to, [&](const auto& feature) {
      if (feature.count > dimension) return Clearance::none;
      return clearance(feature);
    });
  }

 private:
  using Offset = decltype(Time() * W());
  using Radius = decltype(scale_up<bits_of<Time> + 1>(S(), 0));

  /// time + steps, clamped.
  [[nodiscard]] static constexpr Time sum(const Time& time, const Time& steps) noexcept {
    return steps > largest<Time> - time ? largest<Time> : narrow<bits_of<Time>>(time + steps);
  }

  /// The bits of differences below 2^15, which are searched in narrower integers.
  static constexpr int short_bits = [] {
    if constexpr (is_fixed<S>) {
      return W::frac + S::frac + 15;
    } else {
      return 0;
    }
  }();

  template <class F>
  [[nodiscard]] constexpr auto with_feature(const Time& from, const Time& to,
                                            const F& f) const noexcept {
    using MovedA = SweptBody<A, Offset, Shift>;
    using MovedB = SweptBody<B, Offset, Shift>;
    const MovedA a(a_, shift_, way_ * from, way_ * to);
    const MovedB b(b_, shift_, Vec<Offset, dimension>(), Vec<Offset, dimension>());
    return by_width<short_bits>(
        [&](const auto& low, const auto&) {
          using T = std::remove_cvref_t<decltype(low.x)>;
          return f(Gjk<T, MovedB, MovedA>(b, a).closest_feature());
        },
        b.low() - a.high(), b.high() - a.low());
  }

  /// Calls g(v, excess) for the vector v across a feature, where excess() returns the leading bits
  /// of |p|^2 - radius^2 for its closest point p.
  template <class Feature, class G>
  [[nodiscard]] constexpr auto across(const Feature& feature, const G& g) const noexcept {
    return with_direction(feature, [&](const auto& v) {
      return g(v, [&] { return this->leading_excess(feature); });
    });
  }

  template <class VectorAt, class F>
  [[nodiscard]] constexpr auto with_touch_of(const VectorAt& vector_at, Time time,
                                             const Time& limit, const F& f) const noexcept {
    using Result = decltype(f(std::declval<Way>()));
    for (Patience<S> patience; patience.step();) {
      Time next = time;
      const auto result =
          vector_at(time, [&](const auto& v, const auto& excess) -> std::optional<Result> {
            const auto along = dot(v, way_);
            if (along > 0) next = (std::min)(sum(time, steps(excess(), v, along)), limit);
            if (next > time) return std::nullopt;
            return f(v);
          });
      if (result) return *result;
      time = next;
    }
    return f(Way());
  }

  /// A difference of corners, scaled and moved.
  template <Number T>
  [[nodiscard]] constexpr auto moved(const Vec<T, dimension>& corner,
                                     const Vec<Offset, dimension>& offset) const noexcept {
    using MovedA = SweptBody<A, Offset, Shift>;
    using MovedB = SweptBody<B, Offset, Shift>;
    using Moved = decltype(std::declval<MovedB>().some() - std::declval<MovedA>().some());
    return make_vec<dimension>([&](int i) {
      return narrow<bits_of<std::remove_cvref_t<decltype(Moved().x)>>>(
          scale_up<bits_of<T> + Shift>(corner[i], shift_) - offset[i]);
    });
  }

  /// Calls f(simplex) with a feature of differences, scaled and moved.
  template <class Feature, class F>
  [[nodiscard]] constexpr auto with_moved(const Feature& feature, const Time& time,
                                          const F& f) const noexcept {
    const Vec<Offset, dimension> offset = way_ * time;
    std::array<decltype(moved(feature.corners[0], offset)), static_cast<std::size_t>(dimension)>
        corners;
    for (std::size_t k = 0; k < corners.size(); ++k) {
      const auto& corner = feature.corners[k < static_cast<std::size_t>(feature.count) ? k : 0];
      corners[k] = moved(corner, offset);
    }
    const auto with = [&](const auto&... corner) {
      using T = std::common_type_t<std::remove_cvref_t<decltype(corner.x)>...>;
      Simplex<T, dimension> simplex;
      (void)((simplex.count < feature.count && (simplex.add(corner), true)) && ...);
      return f(simplex);
    };
    if constexpr (dimension == 2) {
      return by_width<short_bits>(with, corners[0], corners[1]);
    } else {
      return by_width<short_bits>(with, corners[0], corners[1], corners[2]);
    }
  }

  /// Calls f(numerator, denominator) with |p|^2 - radius^2 for the point p of the feature closest to
  /// 0. Without `Faces` the feature is not a face in 3D, whose numbers are the longest.
  template <bool Faces = true, Number T, int N, class F>
  [[nodiscard]] constexpr auto with_excess(const Simplex<T, N>& feature,
                                           const F& f) const noexcept {
    const auto& corner = feature.newest();
    const auto rr = square(radius_);
    if (feature.count == 1) return f(squared_length(corner) - rr, T(1));
    if constexpr (N == 3) {
      if (feature.count == 2) {
        const auto edge = feature[0] - corner;
        const auto ee = squared_length(edge);
        return f(squared_length(cross(corner, edge)) - rr * ee, ee);
      }
    }
    if constexpr (N == 2 || Faces) {
      const auto normal = facet_normal(feature);
      const auto nn = squared_length(normal);
      return f(square(dot(normal, corner)) - rr * nn, nn);
    } else {
      return f(squared_length(corner) - rr, T(1));
    }
  }

  template <Number T, int N>
  [[nodiscard]] constexpr Clearance clearance(const Simplex<T, N>& feature) const noexcept {
    return with_excess(feature, [](const auto& excess, const auto&) {
      return excess > 0 ? Clearance::apart : excess < 0 ? Clearance::none : Clearance::touch;
    });
  }

  template <Number T, int N, Number V>
  [[nodiscard]] constexpr Lead<Time> lead(const Simplex<T, N>& feature,
                                          const Vec<V, N>& v) const noexcept {
    const auto along = dot(v, way_);
    return with_excess(feature, [&](const auto& excess, const auto& under) -> Lead<Time> {
      if (excess < 0) return {};
      const auto is = excess > 0 ? Clearance::apart : Clearance::touch;
      if (!(along > 0)) return {is, false, Time(0)};
      return {is, true, steps(quotient(excess, under), v, along)};
    });
  }

  /// A quotient n / d >= 0 or its leading bits.
  template <Number Over, Number Under>
  [[nodiscard]] static constexpr auto quotient(const Over& n, const Under& d) noexcept {
    if constexpr (is_fixed<S>) {
      return Leading(n) / Leading(d);
    } else {
      return n / d;
    }
  }

  /// |p|^2 - radius^2 or its leading bits, 0 if it is negative. For a face in 3D, whose exact
  /// number would be the longest, it is the difference of such bits, since the closest vector of a
  /// face does not depend on time.
  template <Number T, int N>
  [[nodiscard]] constexpr auto leading_excess(const Simplex<T, N>& feature) const noexcept {
    if constexpr (is_fixed<S> && N == 3) {
      if (feature.count == 3) {
        const auto normal = facet_normal(feature);
        const auto height = Leading(abs(dot(normal, feature.newest())));
        const auto squared = height * height / leading_square(normal);
        const Leading rr = Leading(radius_) * Leading(radius_);
        const auto excess = difference(squared, rr, Relative{50}).value;
        Leading result;
        if (excess > 0) {
          result = Leading(excess);
          result.exponent += (std::max)(squared.exponent, rr.exponent) + 1;
        }
        return result;
      }
    }
    return with_excess<!is_fixed<S>>(feature, [](const auto& excess, const auto& under) {
      return excess > 0 ? quotient(excess, under) : decltype(quotient(excess, under))();
    });
  }

  template <Number V>
  [[nodiscard]] static constexpr Leading leading_square(const Vec<V, dimension>& v) noexcept {
    Leading sum;
    for (int i = 0; i < dimension; ++i) {
      const Leading component(abs(v[i]));
      sum = sum + component * component;
    }
    return sum;
  }

  /// A lower bound of (|p| - r) |v| / (v . way) for excess = |p|^2 - r^2 and the closest point p,
  /// which is parallel to v: (|p| - r) = excess / (|p| + r). It is too small by less than 2^-37 of
  /// its value, and then rounded down.
  template <class Excess, Number V, Number Along>
  [[nodiscard]] constexpr Time steps(const Excess& excess, const Vec<V, dimension>& v,
                                     const Along& along) const noexcept {
    if constexpr (is_fixed<S>) {
      const Leading r(radius_);
      const auto reach = sqrt(excess + r * r) + r;
      return floor_below<Time>(excess / reach * sqrt(leading_square(v)) / Leading(along));
    } else {
      const auto distance = sqrt_floor<S>(excess + square(radius_));
      return excess / (distance + radius_) * sqrt_floor<S>(squared_length(v)) / along;
    }
  }

  /// Whether `time`, at which the body touches, is the first touch.
  [[nodiscard]] constexpr bool is_first_touch(const Time& time) const noexcept {
    const auto lead = lead_at(time);
    if (lead.clearance != Clearance::touch) return false;
    if (lead.approaches) return true;
    // The bodies pass each other at this distance, or slide along each other.
    using Difference =
        std::remove_cvref_t<decltype((std::declval<SweptBody<B, Offset, Shift>>().some() -
                                      std::declval<SweptBody<A, Offset, Shift>>().some())
                                         .x)>;
    // Squared distances need six times the bits of a difference and a few more.
    constexpr int finer =
        std::clamp(103 - bits_of<Difference>, 0, bits_of<direction_component<S>> + 1);
    using Finer = Approach<A, B, W, S, finer>;
    const auto just_before = Finer::neighbor(Finer(a_, b_, way_, radius_, finer).scaled(time), -1);
    return Finer(a_, b_, way_, radius_, finer).clearance_between(just_before, just_before) ==
           Clearance::apart;
  }

  A a_;
  B b_;
  Way way_;
  Radius radius_;
  int shift_;
};

}  // namespace detent::detail
