// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <optional>
#include <utility>

#include "detent/math/width.hpp"
#include "detent/number/filter/long_quadratic.hpp"
#include "detent/query/kernel/within_segment.hpp"
#include "detent/query/raycast/hit.hpp"
#include "detent/query/raycast/sphere.hpp"
#include "detent/shape/capsule.hpp"

namespace detent {

namespace detail {

/// The part of a capsule's surface that a line crosses.
enum class CapsulePart { none, inside, first_end, side, last_end };

/// Where a ray enters a capsule. At an end, the sphere there gives the distance, if any.
template <Scalar S>
struct CapsuleEntry {
  CapsulePart part;
  std::optional<S> distance{};
};

/// The line of a ray against a capsule: the spheres about its ends and, between the planes through
/// the ends, the cylinder |(m + t d) x e|^2 = r^2 e^2. Here e leads from the end that the ray faces
/// to the other end, and m from the facing end to the ray's origin. The cylinder contains the
/// capsule.
template <Scalar S, int N, Number Length, Number Radius>
class RayCapsule {
 public:
  constexpr RayCapsule(const Direction<S, N>& d, const Vec<Length, N>& m, const Vec<Length, N>& e,
                       const Radius& radius) noexcept
      : d_(d),
        m_(m),
        e_(e),
        radius_(radius),
        k_(cross(d, e)),
        a_(narrow_square<2 * along>(k_)),
        det_(determinant()),
        ee_(squared_length(e)),
        de_(dot(e, d)) {}

  /// Where the ray enters the capsule, at a distance up to `limit`.
  [[nodiscard]] constexpr CapsuleEntry<S> entry(const S& limit) const noexcept {
    if (is_far()) return {CapsulePart::none};
    if (within_edge(e_, m_, radius_)) return {CapsulePart::inside, S(0)};
    const auto b = approach();
    const auto c = start();
    if (c <= 0) return {dot(m_, e_) < 0 ? CapsulePart::first_end : CapsulePart::last_end};
    if (b >= 0 || compare_products(square(radius_), a_, abs(det_), abs(det_)) < 0) {
      return {CapsulePart::none};
    }
    const LongQuadratic side(a_, b, c, reach(), ee_);
    const auto part = entered(side);
    if (part != CapsulePart::side) return {part};
    return {part, side.first_root(limit)};
  }

  /// The part where the line leaves the capsule, which must be ahead of the ray's origin.
  [[nodiscard]] constexpr CapsulePart left() const noexcept {
    if (a_ == 0) return CapsulePart::last_end;
    if constexpr (is_fixed<S>) {
      if (const auto part = part_at(side().leading_last()); part.is_sure) return part.value;
    }
    const auto first = plane_through(m_);
    if (first.after_closest > 0 && first.outside > 0) return CapsulePart::first_end;
    const auto last = plane_through(m_ - e_);
    if (last.after_closest < 0 || last.outside < 0) return CapsulePart::last_end;
    return CapsulePart::side;
  }

  /// a t^2 + 2 b t + c = |(m + t d) x e|^2 - r^2 e^2, for a line that meets the cylinder.
  [[nodiscard]] constexpr auto side() const noexcept {
    return LongQuadratic(a_, approach(), start(), reach(), ee_);
  }

  /// The unit vector from the axis to the point where the line enters through the side, for a
  /// radius > 0. The line is closest to the axis at the offset (m . k) k / a from it, where
  /// k = d x e. The entry is farther back along e x k, by what is left of the radius. Together,
  /// over r, ((m . k) e^2 k - sqrt(b^2 - a c) e x k) / (r a e^2).
  [[nodiscard]] constexpr Direction<S, N> normal() const noexcept {
    if constexpr (N == 2) {
      const auto side = Vec{narrow_negative(e_.y), e_.x};
      const auto normal = *direction_of<S>(side);
      return dot(side, d_) > 0 ? -normal : normal;
    } else {
      return Direction<S, N>::assume_unit(components());
    }
  }

 private:
  // The bits of |v| |d| for a difference v of points, and of |u| |v| |d| for two of them: see
  // `RayTriangle`.
  static constexpr int along = along_bits<S, Length>;
  static constexpr int volume = bits_of<Length> + along + 1;

  /// The components of the normal, from leading bits where these settle the rounding.
  [[nodiscard]] constexpr auto components() const noexcept {
    using Component = direction_component<S>;
    const auto back = make_vec<N>([&](int i) { return ee_ * d_[i] - de_ * e_[i]; });
    if constexpr (is_fixed<S>) {
      const auto area = Leading(a_) * Leading(radius_), across = Leading(ee_);
      const auto beside = Leading(abs(det_)) / area;
      const auto behind = sqrt(Leading(reach()) * across) / (area * across);
      return make_vec<N>([&](int i) {
        const auto nearest = decide_nearest_difference<Component>(
            beside, det_ < 0 ? narrow_negative(k_[i]) : k_[i], behind, back[i]);
        return or_exact(nearest, [&] { return component(i, back[i]); });
      });
    } else {
      return make_vec<N>([&](int i) { return component(i, back[i]); });
    }
  }
  template <Number Back>
  [[nodiscard]] constexpr auto component(int i, const Back& back) const noexcept {
    constexpr int bits = bits_of<Radius> + bits_of<decltype(a_ * ee_)>;  // |m . k| <= r sqrt(a)
    const auto root = leading_root(reach() * ee_);
    const auto length = scale_up<bits + 63>(a_ * ee_ * radius_, root.scale);
    const auto closest = narrow<bits>(det_ * ee_ * k_[i]);
    return quotient_nearest<direction_component<S>>(
        narrow_difference<bits + 64>(scale_up<bits + 63>(closest, root.scale), root.root * back),
        length);
  }

  /// m . (d x e), which is 0 in 2D, for vectors of one plane.
  [[nodiscard]] constexpr auto determinant() const noexcept {
    if constexpr (N == 2) {
      return decltype(narrow<volume>(m_.x * k_))();
    } else {
      return narrow_dot<volume>(m_, k_);
    }
  }

  /// `approach` is b = k . (m x e), by Lagrange's identity; `start` is c.
  [[nodiscard]] constexpr auto approach() const noexcept {
    return dot(m_, d_) * ee_ - de_ * dot(m_, e_);
  }
  [[nodiscard]] constexpr auto start() const noexcept {
    return narrow_square<bits_of<decltype(ee_ * ee_)>>(cross(m_, e_)) - square(radius_) * ee_;
  }

  /// A bound on the length of any direction, which is within 2^-13 of 1.
  [[nodiscard]] static constexpr auto longest() noexcept {
    if constexpr (is_fixed<S>) {
      return Fixed<13, 12>::from_raw(4097);
    } else {
      return S(4097) / 4096;
    }
  }

  /// Whether |m . k| > r (|kx| + |ky| + |kz|), which is at least r |k|; in 2D, whether both ends
  /// are on one side of the line by more than r |d|. It settles most misses, in integers half as
  /// long as those of `reach`.
  [[nodiscard]] constexpr bool is_far() const noexcept {
    if constexpr (N == 2) {
      const auto first = cross(m_, d_.vec());
      const auto last = first + k_;
      const auto reach = radius_ * longest();
      return (first > reach && last > reach) || (first < -reach && last < -reach);
    } else {
      return abs(det_) > (abs(k_.x) + abs(k_.y) + abs(k_.z)) * radius_;
    }
  }

  /// (b^2 - a c) / e^2 = r^2 a - (m . k)^2 by Lagrange's identity: negative if the line misses the
  /// cylinder.
  [[nodiscard]] constexpr auto reach() const noexcept {
    return square(radius_) * a_ - square(det_);
  }

  /// The part that the ray is at for t, by its distance along the axis, m . e + t d . e.
  [[nodiscard]] constexpr Decided<CapsulePart> part_at(const Leading& t) const noexcept {
    const auto me = dot(m_, e_);
    const auto to_last = ee_ - me;
    const auto passed = t * Leading(de_);
    const auto is_past = [&](const auto& end) {
      return decide(difference(passed, Leading(abs(end)), Relative{42}));
    };
    const Filtered first = me > 0 ? Filtered::yes : is_past(me);
    const Filtered last = to_last < 0 ? Filtered::yes : is_past(to_last);
    if (first == Filtered::no) return {CapsulePart::first_end, true};
    if (last == Filtered::yes) return {CapsulePart::last_end, true};
    return {CapsulePart::side, first == Filtered::yes && last == Filtered::no};
  }

  /// The part of the surface where the line enters the cylinder, ahead of the ray's origin.
  template <class Side>
  [[nodiscard]] constexpr CapsulePart entered(const Side& side) const noexcept {
    if constexpr (is_fixed<S>) {
      if (const auto part = part_at(side.leading_first()); part.is_sure) return part.value;
    }
    const auto at_first = plane_through(m_);
    if (at_first.after_closest > 0 || at_first.outside < 0) return CapsulePart::first_end;
    const auto at_last = plane_through(m_ - e_);
    if (at_last.after_closest < 0 && at_last.outside > 0) return CapsulePart::last_end;
    return CapsulePart::side;
  }

  /// Signs for the point where the line meets the plane through an end, across the axis: after or
  /// before the line is closest to the axis, and outside or inside the sphere about the end.
  struct Crossing {
    int after_closest;
    int outside;
  };
  /// `m` leads from the end to the ray's origin.
  template <Number M>
  [[nodiscard]] constexpr Crossing plane_through(const Vec<M, N>& m) const noexcept {
    // Compares t = -(m . e) / (d . e) with t = -(m . d) / (d . d), the latter without the
    // components along the axis.
    const auto me = dot(m, e_);
    const auto after = de_ * dot(m, d_);
    const auto closest = me * squared_length(d_);
    const auto there = make_vec<N>([&](int i) { return de_ * m[i] - me * d_[i]; });
    return {(after > closest) - (after < closest),
            compare_length(to_array(there), abs(de_) * radius_)};
  }

  Direction<S, N> d_;
  Vec<Length, N> m_;
  Vec<Length, N> e_;
  Radius radius_;
  decltype(cross(Direction<S, N>(), Vec<Length, N>())) k_;
  decltype(narrow_square<2 * along>(cross(Direction<S, N>(), Vec<Length, N>()))) a_;
  decltype(narrow<volume>(Length() * dot(Vec<Length, N>(), Direction<S, N>()))) det_;
  decltype(squared_length(Vec<Length, N>())) ee_;
  decltype(dot(Vec<Length, N>(), Direction<S, N>())) de_;
};

/// The axis of `capsule`, starting at the end that `ray` faces.
template <Scalar S, int N>
[[nodiscard]] constexpr Segment<S, N> facing_axis(const Ray<S, N>& ray,
                                                  const Capsule<S, N>& capsule) noexcept {
  if (dot(capsule.b - capsule.a, ray.direction) < 0) return {capsule.b, capsule.a};
  return {capsule.a, capsule.b};
}

/// Returns f(meeting) for a ray and a capsule about `axis`, in the narrowest integers that hold
/// them.
template <Scalar S, int N, class F>
[[nodiscard]] constexpr auto with_meeting(const Ray<S, N>& ray, const Segment<S, N>& axis,
                                          const S& radius, const F& f) noexcept {
  return by_width<29>(
      [&]<Number L, Number R>(const Vec<L, N>& m, const Vec<L, N>& e, const R& r) {
        return f(RayCapsule<S, N, L, R>(ray.direction, m, e, r));
      },
      ray.origin - axis.start, axis.end - axis.start, radius);
}

[[nodiscard]] constexpr bool is_end(CapsulePart part) noexcept {
  return part == CapsulePart::first_end || part == CapsulePart::last_end;
}

/// The sphere about the end through which a ray enters or leaves a capsule.
template <Scalar S, int N>
[[nodiscard]] constexpr Sphere<S, N> end_of(const Segment<S, N>& axis, const S& radius,
                                            CapsulePart part) noexcept {
  return {part == CapsulePart::first_end ? axis.start : axis.end, radius};
}

}  // namespace detail

/// Distance along `ray` at which it first touches `capsule`, or nothing.
///
/// units:  lengths in world units (Q16.16: 1/65536); direction is unit length
/// domain: every input; a negative radius is an empty capsule and is never hit
/// result: 0 when the ray starts inside or on the capsule; a hit past max_distance is a miss
/// exact:  hit or miss exact; distance rounded down, error in [0, 1) ULP
///         (tests/oracle/ray_capsule.test.cpp)
/// source: the cylinder, Ericson, Real-Time Collision Detection, 5.3.7
template <Scalar S, int N>
[[nodiscard]] constexpr std::optional<S> raycast(const Ray<S, N>& ray,
                                                 const Capsule<S, N>& capsule) noexcept {
  if (capsule.radius < 0 || ray.max_distance < 0) return std::nullopt;
  const auto axis = detail::facing_axis(ray, capsule);
  const auto [part, distance] =
      detail::with_meeting(ray, axis, capsule.radius,
                           [&](const auto& meeting) { return meeting.entry(ray.max_distance); });
  if (!is_end(part)) return distance;
  return raycast(ray, detail::end_of(axis, capsule.radius, part));
}

/// Distance, point and normal where `ray` first touches `capsule`, or nothing.
///
/// exact:  normal within 1 ULP of 2^-30 (2^-14 in 16 bits), on the side within 0.501; a capsule of
///         radius 0 has no normal and gives the opposite of the direction
///         (tests/oracle/ray_capsule.test.cpp)
template <Scalar S, int N>
[[nodiscard]] constexpr std::optional<RayHit<S, N>> raycast_hit(
    const Ray<S, N>& ray, const Capsule<S, N>& capsule) noexcept {
  if (capsule.radius < 0 || ray.max_distance < 0) return std::nullopt;
  const auto axis = detail::facing_axis(ray, capsule);
  struct Entry {
    detail::CapsuleEntry<S> at;
    Direction<S, N> normal;
  };
  const Entry entry = detail::with_meeting(ray, axis, capsule.radius, [&](const auto& meeting) {
    const auto at = meeting.entry(ray.max_distance);
    const bool is_side = at.part == detail::CapsulePart::side && at.distance;
    return Entry{at, is_side && capsule.radius > 0 ? meeting.normal() : -ray.direction};
  });
  const auto [part, distance] = entry.at;
  if (is_end(part)) return raycast_hit(ray, detail::end_of(axis, capsule.radius, part));
  if (!distance) return std::nullopt;
  return detail::hit_at(ray, *distance, entry.normal);
}

/// Distances at which `ray` enters and leaves `capsule`, or nothing.
///
/// exact:  both rounded down, error in [0, 1) ULP             (tests/oracle/ray_capsule.test.cpp)
template <Scalar S, int N>
[[nodiscard]] constexpr std::optional<Interval<S>> raycast_interval(
    const Ray<S, N>& ray, const Capsule<S, N>& capsule) noexcept {
  const auto enter = raycast(ray, capsule);
  if (!enter) return std::nullopt;
  const auto axis = detail::facing_axis(ray, capsule);
  const auto exit = detail::with_meeting(ray, axis, capsule.radius, [&](const auto& meeting) {
    const auto part = meeting.left();
    if (part == detail::CapsulePart::side) return meeting.side().last_root(ray.max_distance);
    // The sphere at the exit may lie wholly beyond the end of the ray.
    const detail::RaySphere<S, N> sphere(ray, detail::end_of(axis, capsule.radius, part));
    return (std::min)(sphere.quadratic().last_root(ray.max_distance), ray.max_distance);
  });
  return Interval<S>{*enter, exit};
}

}  // namespace detent
