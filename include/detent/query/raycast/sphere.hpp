// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "detent/number/filter/components.hpp"
#include "detent/number/quadratic.hpp"
#include "detent/query/raycast/hit.hpp"
#include "detent/shape/sphere.hpp"

namespace detent {

namespace detail {

/// |m + t d|^2 = r^2 as a t^2 + 2 b t + c = 0, where m leads from the center to the ray's origin.
template <Scalar S, int N>
struct RaySphere {
  constexpr RaySphere(const Ray<S, N>& ray, const Sphere<S, N>& sphere) noexcept
      : direction(ray.direction),
        m(ray.origin - sphere.center),
        a(squared_length(direction)),
        b(dot(m, direction)),
        c(inside_distance(squared_length(m), sphere.radius)) {}

  // |m|^2 - r^2 is at most |m|^2, and r^2 is smaller than the most that |m|^2 can be.
  template <class Squared>
  static constexpr auto inside_distance(const Squared& squared, const S& radius) noexcept {
    return narrow_difference<bits_of<Squared>>(squared, square(radius));
  }

  /// a >= 0 and c <= |m|^2, so a c <= |d|^2 |m|^2, which fits where the square of b does.
  [[nodiscard]] constexpr auto quadratic() const noexcept { return Quadratic(a, b, c); }

  /// The unit vector from the center to the first point where the line meets the sphere, for a
  /// radius > 0 and a line that meets it.
  ///
  /// It is (m + t d) / r for t = (-b - sqrt(D)) / a, hence (w - sqrt(D) d) / (a r) for
  /// w = a m - b d, and |w| <= a r.
  [[nodiscard]] constexpr Direction<S, N> normal(const S& radius) const noexcept {
    constexpr int closest_bits = bits_of<S> + bits_of<decltype(a)>;  // |d|^2 r
    const auto discriminant = quadratic().discriminant();
    const auto ratio = root_ratio<direction_component<S>>(discriminant, a * radius);
    return Direction<S, N>::assume_unit(make_vec<N>([&](int i) {
      const auto closest = narrow<closest_bits>(a * m[i] - b * direction[i]);
      return or_exact(ratio.decide_nearest(closest, direction[i]),
                      [&] { return component(closest, direction[i], discriminant, radius); });
    }));
  }

  using Offset = decltype(Vec<S, N>() - Vec<S, N>());
  Direction<S, N> direction;
  Offset m;
  decltype(squared_length(Direction<S, N>())) a;
  decltype(dot(Offset(), Direction<S, N>())) b;
  decltype(inside_distance(squared_length(Offset()), S())) c;

 private:
  /// A component of the normal, in long integers. Scaling the scene by 2^k keeps the direction and
  /// makes r as long as its type allows. So the error of the root, below 1, is below 2^-28 steps of
  /// the result (2^-12 in 16 bits), even for the smallest sphere.
  template <Number Closest, Number Discriminant>
  [[nodiscard]] constexpr auto component(const Closest& closest,
                                         const direction_component<S>& along,
                                         const Discriminant& discriminant,
                                         const S& radius) const noexcept {
    using Component = direction_component<S>;
    constexpr int root_bits = bits_of<S> + bits_of<Component>;  // |d| r
    const int k = headroom(radius);
    using Root = decltype(narrow<root_bits>(b));
    const auto root = sqrt_floor<Root>(scale_up<2 * root_bits>(discriminant, 2 * k));
    const auto length = a * scale_up<bits_of<S>>(radius, k);
    return quotient_nearest<Component>(scale_up<bits_of<Closest>>(closest, k) - root * along,
                                       length);
  }
};

}  // namespace detail

/// Distance along `ray` at which it first touches `sphere`, or nothing.
///
/// units:  lengths in world units (Q16.16: 1/65536); direction is unit length
/// domain: every input; a negative radius is an empty sphere and is never hit
/// result: 0 when the ray starts inside or on the sphere; a hit past max_distance is a miss
/// exact:  hit or miss exact; distance rounded down, error in [0, 1) ULP
///         (tests/oracle/ray_sphere.test.cpp)
/// source: quadratic form, Ericson, Real-Time Collision Detection, 5.3.2
template <Scalar S, int N>
[[nodiscard]] constexpr std::optional<S> raycast(const Ray<S, N>& ray,
                                                 const Sphere<S, N>& sphere) noexcept {
  if (sphere.radius < 0 || ray.max_distance < 0) return std::nullopt;
  const auto m = ray.origin - sphere.center;
  const auto c = detail::RaySphere<S, N>::inside_distance(squared_length(m), sphere.radius);
  if (c <= 0) return S(0);  // starts inside
  const auto b = dot(m, ray.direction);
  if (b >= 0) return std::nullopt;  // moves away
  const Quadratic quadratic(squared_length(ray.direction), b, c);
  if (!quadratic.has_roots()) return std::nullopt;
  return quadratic.first_root(ray.max_distance);
}

/// Distance, point and normal where `ray` first touches `sphere`, or nothing.
///
/// exact:  normal within 1 ULP of 2^-30 (2^-14 in 16 bits); a sphere of radius 0 has no normal and
///         gives the opposite of the direction                   (tests/oracle/ray_sphere.test.cpp)
template <Scalar S, int N>
[[nodiscard]] constexpr std::optional<RayHit<S, N>> raycast_hit(
    const Ray<S, N>& ray, const Sphere<S, N>& sphere) noexcept {
  const auto distance = raycast(ray, sphere);
  if (!distance) return std::nullopt;
  const detail::RaySphere<S, N> meeting(ray, sphere);
  const bool has_normal = meeting.c > 0 && sphere.radius > 0;
  return detail::hit_at(ray, *distance,
                        has_normal ? meeting.normal(sphere.radius) : -ray.direction);
}

/// Distances at which `ray` enters and leaves `sphere`, or nothing.
///
/// exact:  both rounded down, error in [0, 1) ULP           (tests/oracle/ray_sphere.test.cpp)
template <Scalar S, int N>
[[nodiscard]] constexpr std::optional<Interval<S>> raycast_interval(
    const Ray<S, N>& ray, const Sphere<S, N>& sphere) noexcept {
  const auto enter = raycast(ray, sphere);
  if (!enter) return std::nullopt;
  const detail::RaySphere<S, N> meeting(ray, sphere);
  return Interval<S>{*enter, meeting.quadratic().last_root(ray.max_distance)};
}

}  // namespace detent
