// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <optional>
#include <utility>

#include "detent/math/width.hpp"
#include "detent/number/long_quadratic.hpp"
#include "detent/query/contains/capsule.hpp"
#include "detent/query/raycast/sphere.hpp"

namespace detent {

namespace detail {

/// Which part of a capsule's surface a line passes.
enum class CapsulePart { none, first_end, side, last_end };

/// Whether the point at `m` is in the cylinder about the line through 0 along `e`:
/// |m x e|^2 <= radius^2 e^2; everywhere for e = 0.
template <Number M, Number E, Number R, int N>
[[nodiscard]] constexpr bool is_in_cylinder(const Vec<M, N>& m, const Vec<E, N>& e,
                                            const R& radius) noexcept {
  using Product = decltype(squared_length(m) * squared_length(e));
  return narrow_square<bits_of<Product>>(cross(m, e)) <= square(radius) * squared_length(e);
}

/// The line of a ray against a capsule: the spheres about its ends, and between the planes through
/// the ends the cylinder |(m + t d) x e|^2 = r^2 e^2, where e leads from the end that the ray
/// faces to the other and m from there to the ray's origin. All of the capsule is in the cylinder.
template <Scalar S, int N>
class RayCapsule {
 public:
  constexpr RayCapsule(const Ray<S, N>& ray, const Capsule<S, N>& capsule) noexcept
      : ray_(ray),
        capsule_(capsule),
        ends_(dot(capsule.b - capsule.a, ray.direction) < 0 ? Segment{capsule.b, capsule.a}
                                                            : Segment{capsule.a, capsule.b}),
        m_(ray.origin - ends_.start),
        e_(ends_.end - ends_.start),
        k_(cross(ray.direction, e_)),
        a_(narrow_square<2 * along>(k_)),
        det_(determinant()),
        ee_(squared_length(e_)),
        de_(dot(e_, ray.direction)) {}

  /// Where the ray, which starts outside the capsule, may enter it. At an end, the sphere there
  /// tells whether it does.
  [[nodiscard]] constexpr CapsulePart entered() const noexcept {
    if (is_far()) return CapsulePart::none;
    if (starts_in_cylinder())
      return dot(m_, e_) < 0 ? CapsulePart::first_end : CapsulePart::last_end;
    if (!approaches_axis() || reach() < 0) return CapsulePart::none;
    const auto first = plane_through(ends_.start), last = plane_through(ends_.end);
    if (first.after_closest > 0 || first.outside < 0) return CapsulePart::first_end;
    if (last.after_closest < 0 && last.outside > 0) return CapsulePart::last_end;
    return CapsulePart::side;
  }

  /// Where the line leaves the capsule that it meets.
  [[nodiscard]] constexpr CapsulePart left() const noexcept {
    if (a_ == 0) return CapsulePart::last_end;
    const auto first = plane_through(ends_.start), last = plane_through(ends_.end);
    if (first.after_closest > 0 && first.outside > 0) return CapsulePart::first_end;
    if (last.after_closest < 0 || last.outside < 0) return CapsulePart::last_end;
    return CapsulePart::side;
  }

  [[nodiscard]] constexpr Sphere<S, N> sphere(CapsulePart part) const noexcept {
    return {part == CapsulePart::first_end ? ends_.start : ends_.end, capsule_.radius};
  }

  /// a t^2 + 2 b t + c = |(m + t d) x e|^2 - r^2 e^2, for a line that meets the cylinder.
  [[nodiscard]] constexpr auto side() const noexcept {
    return LongQuadratic(a_, b(), c(), discriminant());
  }

  /// The unit vector from the axis to the point where the line enters through the side, for a
  /// radius > 0: the line is closest to the axis at (m . k) k / a from it, where k = d x e, and
  /// before that it is farther back along e x k by what the radius leaves. Together, over r,
  /// ((m . k) e^2 k - sqrt(b^2 - a c) e x k) / (r a e^2).
  [[nodiscard]] constexpr Direction<S, N> normal() const noexcept {
    using Component = direction_component<S>;
    if constexpr (N == 2) {
      const auto side = Vec{narrow_negative(e_.y), e_.x};
      const auto normal = *direction_of<S>(side);
      return dot(side, ray_.direction) > 0 ? -normal : normal;
    } else {
      constexpr int bits = bits_of<S> + bits_of<decltype(a_ * ee_)>;  // |m . k| <= r sqrt(a)
      const auto root = leading_root(discriminant());
      const auto length = scale_up<bits + 63>(a_ * ee_ * capsule_.radius, root.scale);
      return Direction<S, N>::assume_unit(make_vec<N>([&](int i) {
        const auto closest = narrow<bits>(det_ * ee_ * k_[i]);
        const auto back = root.root * (ee_ * ray_.direction[i] - de_ * e_[i]);
        return quotient_nearest<Component>(
            narrow_difference<bits + 64>(scale_up<bits + 63>(closest, root.scale), back), length);
      }));
    }
  }

 private:
  using Length = decltype(S() - S());
  // |v| |d| for the differences of points, and |u| |v| |d| for two of them: see `RayTriangle`.
  static constexpr int along = along_bits<S, Length>;
  static constexpr int volume = bits_of<Length> + along + 1;

  /// m . (d x e), which is 0 for vectors of one plane.
  [[nodiscard]] constexpr auto determinant() const noexcept {
    if constexpr (N == 2) {
      return decltype(narrow<volume>(m_.x * k_))();
    } else {
      return narrow_dot<volume>(m_, k_);
    }
  }

  [[nodiscard]] constexpr auto b() const noexcept {
    const auto moment = cross(m_, e_);
    if constexpr (N == 2) {
      return k_ * moment;
    } else {
      return dot(k_, moment);
    }
  }
  [[nodiscard]] constexpr auto c() const noexcept {
    const auto moment = cross(m_, e_);
    return narrow_square<bits_of<decltype(ee_ * ee_)>>(moment) - square(capsule_.radius) * ee_;
  }

  /// c <= 0.
  [[nodiscard]] constexpr bool starts_in_cylinder() const noexcept {
    return by_width<30>([](const auto&... x) { return is_in_cylinder(x...); }, m_, e_,
                        capsule_.radius);
  }
  /// b < 0, as (d . m) e^2 - (d . e) (m . e) by Lagrange's identity.
  [[nodiscard]] constexpr bool approaches_axis() const noexcept {
    return by_width<62>([](const auto& dm, const auto& ee, const auto& de,
                           const auto& me) { return dm * ee < de * me; },
                        dot(m_, ray_.direction), ee_, de_, dot(m_, e_));
  }

  /// Whether |m . k| > r (|kx| + |ky| + |kz|), so that it is also greater than r |k|: in integers
  /// half as long as those of `reach`, the answer for most lines that miss.
  [[nodiscard]] constexpr bool is_far() const noexcept {
    if constexpr (N == 2) {
      return false;
    } else {
      return abs(det_) > (abs(k_.x) + abs(k_.y) + abs(k_.z)) * capsule_.radius;
    }
  }

  /// (b^2 - a c) / e^2 = r^2 a - (m . k)^2 by Lagrange's identity: negative where the line misses
  /// the cylinder.
  [[nodiscard]] constexpr auto reach() const noexcept {
    return square(capsule_.radius) * a_ - square(det_);
  }
  [[nodiscard]] constexpr auto discriminant() const noexcept {
    using Most = decltype(square(capsule_.radius) * a_);
    return narrow<bits_of<Most>>(reach()) * ee_;
  }

  /// Signs that tell where the line meets the plane across the axis through an end: after or before
  /// it is closest to the axis, and outside or inside the sphere about the end.
  struct Crossing {
    int after_closest;
    int outside;
  };
  [[nodiscard]] constexpr Crossing plane_through(const Vec<S, N>& end) const noexcept {
    const auto sign = [](const auto& left, const auto& right) {
      return (left > right) - (left < right);
    };
    const auto& d = ray_.direction;
    const auto m = ray_.origin - end;
    // At t = -(m . e) / (d . e), against t = -(m . d) / (d . d) less what leads along the axis.
    const int after = sign(de_ * dot(m, d), dot(m, e_) * squared_length(d));
    // (d . e) (m + t d) = e x (m x d), whose square is e^2 |m x d|^2 - (m . (d x e))^2.
    const auto squared = ee_ * narrow_square<2 * along>(cross(d, m)) - square(det_);
    return {after, sign(squared, square(capsule_.radius) * square(de_))};
  }

  const Ray<S, N>& ray_;
  const Capsule<S, N>& capsule_;
  Segment<S, N> ends_;
  Vec<Length, N> m_;
  Vec<Length, N> e_;
  decltype(cross(Direction<S, N>(), Vec<Length, N>())) k_;
  decltype(narrow_square<2 * along>(cross(Direction<S, N>(), Vec<Length, N>()))) a_;
  decltype(narrow<volume>(Length() * dot(Vec<Length, N>(), Direction<S, N>()))) det_;
  decltype(squared_length(Vec<Length, N>())) ee_;
  decltype(dot(Vec<Length, N>(), Direction<S, N>())) de_;
};

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
  if (contains(capsule, ray.origin)) return S(0);
  const detail::RayCapsule<S, N> meeting(ray, capsule);
  const auto part = meeting.entered();
  if (part == detail::CapsulePart::none) return std::nullopt;
  if (part == detail::CapsulePart::side) return meeting.side().first_root(ray.max_distance);
  return raycast(ray, meeting.sphere(part));
}

/// Distance, point and normal where `ray` first touches `capsule`, or nothing.
///
/// exact:  normal within 1 ULP of 2^-30 (2^-14 in 16 bits), on the side within 0.501; a capsule of
///         radius 0 has none and gives the opposite of the direction
///         (tests/oracle/ray_capsule.test.cpp)
template <Scalar S, int N>
[[nodiscard]] constexpr std::optional<RayHit<S, N>> raycast_hit(
    const Ray<S, N>& ray, const Capsule<S, N>& capsule) noexcept {
  const auto distance = raycast(ray, capsule);
  if (!distance) return std::nullopt;
  if (capsule.radius == 0 || contains(capsule, ray.origin)) {
    return detail::hit_at(ray, *distance, -ray.direction);
  }
  const detail::RayCapsule<S, N> meeting(ray, capsule);
  const auto part = meeting.entered();
  if (part != detail::CapsulePart::side) return raycast_hit(ray, meeting.sphere(part));
  return detail::hit_at(ray, *distance, meeting.normal());
}

/// Distances at which `ray` enters and leaves `capsule`, or nothing.
///
/// exact:  both rounded down, error in [0, 1) ULP             (tests/oracle/ray_capsule.test.cpp)
template <Scalar S, int N>
[[nodiscard]] constexpr std::optional<Interval<S>> raycast_interval(
    const Ray<S, N>& ray, const Capsule<S, N>& capsule) noexcept {
  const auto enter = raycast(ray, capsule);
  if (!enter) return std::nullopt;
  const detail::RayCapsule<S, N> meeting(ray, capsule);
  const auto part = meeting.left();
  if (part == detail::CapsulePart::side) {
    return Interval<S>{*enter, meeting.side().last_root(ray.max_distance)};
  }
  // The sphere that it leaves may lie wholly beyond the end of the ray.
  const detail::RaySphere<S, N> sphere(ray, meeting.sphere(part));
  const S exit = sphere.quadratic().last_root(ray.max_distance);
  return Interval<S>{*enter, std::min(exit, ray.max_distance)};
}

}  // namespace detent
