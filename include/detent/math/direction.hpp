// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <optional>

#include "detent/math/vec.hpp"

namespace detent {

namespace detail {

/// The components with these raw numbers; for scalars that round, the numbers themselves.
template <Number T, class Raw, std::size_t Size>
[[nodiscard]] constexpr std::array<T, Size> from_raw(const std::array<Raw, Size>& raw) noexcept {
  std::array<T, Size> components;
  for (std::size_t i = 0; i < Size; ++i) {
    if constexpr (is_fixed<T>) {
      components[i] = T::from_raw(raw[i]);
    } else {
      components[i] = raw[i];
    }
  }
  return components;
}

}  // namespace detail

/// A unit vector, made only by normalising or from checked raw bits.
///
/// Components are Q2.30 for 32-bit scalars (Q2.14 for 16-bit ones): no component exceeds 1 and the
/// length is 1 within 2^-29 (2^-13). Queries use the direction exactly as stored.
template <Scalar S, int N>
class Direction {
 public:
  using Component = direction_component<S>;
  using Raw = typename raw_of<Component>::type;

  /// The positive x axis.
  constexpr Direction() noexcept { components_.x = Component(1); }

  // Deleted: compilers show the line with the name.
  // clang-format off
  template <class T>
  Direction(const Vec<T, N>&) = delete;  // detent: write normalize(v), which is a std::optional
  // clang-format on

  /// The positive axis `i`.
  [[nodiscard]] static constexpr Direction along(int i) noexcept {
    Direction result;
    result.components_.x = Component(0);
    result.components_[i] = Component(1);
    return result;
  }

  /// The direction with these raw components, or nothing if they do not form a unit vector (a
  /// length off by more than 2^-29, or 2^-13 for 16-bit components, or a component beyond 1).
  [[nodiscard]] static constexpr std::optional<Direction> from_raw(
      const std::array<Raw, std::size_t{N}>& raw) noexcept {
    const auto components = detail::from_raw<Component>(raw);
    if (!is_unit(components)) return std::nullopt;
    return Direction(from_array(components));
  }

  /// The direction with these components. The caller must know that they form a unit vector.
  [[nodiscard]] static constexpr Direction assume_unit(
      const Vec<Component, N>& components) noexcept {
    DETENT_ASSERT(!is_fixed<Component> || is_unit(to_array(components)));
    return Direction(components);
  }

  [[nodiscard]] constexpr Component operator[](int i) const noexcept { return components_[i]; }

  /// The components as a vector.
  [[nodiscard]] constexpr const Vec<Component, N>& vec() const noexcept { return components_; }

  [[nodiscard]] constexpr Direction operator-() const noexcept {
    return Direction(narrow_negative(components_));
  }

  [[nodiscard]] friend constexpr bool operator==(const Direction&,
                                                 const Direction&) noexcept = default;

 private:
  explicit constexpr Direction(const Vec<Component, N>& components) noexcept
      : components_(components) {}

  Vec<Component, N> components_;
};

/// Appends to a digest: the components.
template <class D, Scalar S, int N>
constexpr void append(D& digest, const Direction<S, N>& direction) noexcept {
  digest.add(direction.vec());
}

/// The direction of a vector of any number type, or nothing for the zero vector.
///
/// domain: every vector, of any length
/// exact:  each component is the exact one rounded to nearest    (tests/math/direction.test.cpp)
template <Scalar S, Number T, int N>
[[nodiscard]] constexpr std::optional<Direction<S, N>> direction_of(const Vec<T, N>& v) noexcept {
  const auto unit = unit_vector<direction_component<S>>(to_array(v));
  if (!unit) return std::nullopt;
  return Direction<S, N>::assume_unit(from_array(*unit));
}

/// `direction_of` with a deduced scalar: that of a vector of scalars, or of a sum or difference of
/// 32-bit ones, as in normalize(b - a). `normalize<S>(v)` names the scalar.
template <Scalar S, int N>
[[nodiscard]] constexpr std::optional<Direction<S, N>> normalize(const Vec<S, N>& v) noexcept {
  return direction_of<S>(v);
}
template <Number T, int N>
requires(!Scalar<T> && Scalar<typename detail::length_of<T>::type>)
    [[nodiscard]] constexpr auto normalize(const Vec<T, N>& v) noexcept {
  return direction_of<typename detail::length_of<T>::type>(v);
}
template <Scalar S, Number T, int N>
requires(!std::same_as<S, T>)
    [[nodiscard]] constexpr std::optional<Direction<S, N>> normalize(const Vec<T, N>& v) noexcept {
  return direction_of<S>(v);
}

namespace detail {

/// The bits of |v| |d| for a vector with components of type T and a direction of scalar S:
/// sqrt(3) 2^B (1 + 2^-13) < 2^(B + 1).
template <Scalar S, Number T>
inline constexpr int along_bits = bits_of<T> + bits_of<direction_component<S>>;

/// The bits of the dot product of two directions: at most (1 + 2^-13)^2 < 2.
template <Scalar S>
inline constexpr int cosine_bits = 2 * bits_of<direction_component<S>> - 1;

}  // namespace detail

/// Products with a direction, bounded by the length of the other factor (Cauchy-Schwarz).
template <Scalar S, Number T, int N>
[[nodiscard]] constexpr auto dot(const Vec<T, N>& v, const Direction<S, N>& d) noexcept {
  return narrow_dot<detail::along_bits<S, T>>(v, d.vec());
}
template <Scalar S, Number T, int N>
[[nodiscard]] constexpr auto dot(const Direction<S, N>& d, const Vec<T, N>& v) noexcept {
  return dot(v, d);
}
template <Scalar S, int N>
[[nodiscard]] constexpr auto dot(const Direction<S, N>& a, const Direction<S, N>& b) noexcept {
  return narrow_dot<detail::cosine_bits<S>>(a.vec(), b.vec());
}

/// The squared length, exactly: 1 up to the rounding of the components.
template <Scalar S, int N>
[[nodiscard]] constexpr auto squared_length(const Direction<S, N>& d) noexcept {
  return dot(d, d);
}

/// The cross product, exactly.
template <Scalar S, Number T, int N>
[[nodiscard]] constexpr auto cross(const Direction<S, N>& d, const Vec<T, N>& v) noexcept {
  return narrow_cross<detail::along_bits<S, T>>(d.vec(), v);
}
template <Scalar S, Number T, int N>
[[nodiscard]] constexpr auto cross(const Vec<T, N>& v, const Direction<S, N>& d) noexcept {
  return narrow_cross<detail::along_bits<S, T>>(v, d.vec());
}
template <Scalar S, int N>
[[nodiscard]] constexpr auto cross(const Direction<S, N>& a, const Direction<S, N>& b) noexcept {
  return narrow_cross<detail::cosine_bits<S>>(a.vec(), b.vec());
}

/// Products with a number or a built-in integer are vectors, exact and as wide as those of `Vec`.
template <Scalar S, int N, class T>
requires Number<T> || std::integral<T>
[[nodiscard]] constexpr auto operator*(const Direction<S, N>& d, const T& factor) noexcept {
  return d.vec() * factor;
}
template <Scalar S, int N, class T>
requires Number<T> || std::integral<T>
[[nodiscard]] constexpr auto operator*(const T& factor, const Direction<S, N>& d) noexcept {
  return d.vec() * factor;
}

namespace detail {

template <class T>
inline constexpr bool is_vec = false;
template <class T, int N>
inline constexpr bool is_vec<Vec<T, N>> = true;
template <class T>
inline constexpr bool is_direction = false;
template <Scalar S, int N>
inline constexpr bool is_direction<Direction<S, N>> = true;

/// Two directions, or a direction and a vector.
template <class A, class B>
concept DirectionAndVec = (is_direction<A> && (is_direction<B> || is_vec<B>)) ||
                          (is_vec<A> && is_direction<B>);

}  // namespace detail

// One line each, because compilers show the line with the name.
// clang-format off
template <class A, class B>
requires detail::DirectionAndVec<A, B>
void operator*(const A&, const B&) = delete;  // detent: write dot or cross
template <class A, class B>
requires detail::DirectionAndVec<A, B>
void operator+(const A&, const B&) = delete;  // detent: write distance * d, or d.vec()
template <class A, class B>
requires detail::DirectionAndVec<A, B>
void operator-(const A&, const B&) = delete;  // detent: write distance * d, or d.vec()
// clang-format on

}  // namespace detent
