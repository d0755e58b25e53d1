// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <concepts>
#include <cstddef>

#include "detent/number/unit.hpp"

namespace detent {

/// A vector or point of two or three components, or of four for quaternions and for the points that
/// projection matrices multiply.
///
/// Coordinates are `Scalar`s. Results can be any `Number`: sums, differences and products have the
/// component type that holds them exactly.
template <Number T, int N>
struct Vec;

template <Number T>
struct Vec<T, 2> {
  T x{}, y{};

  [[nodiscard]] DETENT_INLINE_TINY constexpr T& operator[](int i) noexcept {
    return i == 0 ? x : y;
  }
  [[nodiscard]] DETENT_INLINE_TINY constexpr const T& operator[](int i) const noexcept {
    return i == 0 ? x : y;
  }
  [[nodiscard]] friend constexpr bool operator==(const Vec&, const Vec&) noexcept = default;
};

template <Number T>
struct Vec<T, 3> {
  T x{}, y{}, z{};

  [[nodiscard]] DETENT_INLINE_TINY constexpr T& operator[](int i) noexcept {
    return i == 0 ? x : i == 1 ? y : z;
  }
  [[nodiscard]] DETENT_INLINE_TINY constexpr const T& operator[](int i) const noexcept {
    return i == 0 ? x : i == 1 ? y : z;
  }
  [[nodiscard]] friend constexpr bool operator==(const Vec&, const Vec&) noexcept = default;
};

template <Number T>
struct Vec<T, 4> {
  T x{}, y{}, z{}, w{};

  [[nodiscard]] DETENT_INLINE_TINY constexpr T& operator[](int i) noexcept {
    return i == 0 ? x : i == 1 ? y : i == 2 ? z : w;
  }
  [[nodiscard]] DETENT_INLINE_TINY constexpr const T& operator[](int i) const noexcept {
    return i == 0 ? x : i == 1 ? y : i == 2 ? z : w;
  }
  [[nodiscard]] friend constexpr bool operator==(const Vec&, const Vec&) noexcept = default;
};

template <class T>
Vec(T, T) -> Vec<T, 2>;
template <class T>
Vec(T, T, T) -> Vec<T, 3>;
template <class T>
Vec(T, T, T, T) -> Vec<T, 4>;

/// Appends to a digest: the components in order.
template <class D, Number T, int N>
constexpr void append(D& digest, const Vec<T, N>& v) noexcept {
  for (int i = 0; i < N; ++i) digest.add(v[i]);
}

/// The vector whose component i is f(i).
template <int N, class F>
[[nodiscard]] constexpr auto make_vec(const F& f) noexcept {
  using T = decltype(f(0));
  if constexpr (N == 2) {
    return Vec<T, 2>{f(0), f(1)};
  } else if constexpr (N == 3) {
    return Vec<T, 3>{f(0), f(1), f(2)};
  } else {
    return Vec<T, 4>{f(0), f(1), f(2), f(3)};
  }
}

/// Converts a vector to an array of its components, and back.
template <Number T, int N>
[[nodiscard]] constexpr auto to_array(const Vec<T, N>& v) noexcept {
  std::array<T, static_cast<std::size_t>(N)> components;
  for (int i = 0; i < N; ++i) components[static_cast<std::size_t>(i)] = v[i];
  return components;
}
template <Number T, std::size_t Size>
[[nodiscard]] constexpr auto from_array(const std::array<T, Size>& components) noexcept {
  return make_vec<static_cast<int>(Size)>(
      [&](int i) { return components[static_cast<std::size_t>(i)]; });
}

template <Number A, Number B, int N>
[[nodiscard]] constexpr auto operator+(const Vec<A, N>& a, const Vec<B, N>& b) noexcept {
  return make_vec<N>([&](int i) { return a[i] + b[i]; });
}
template <Number A, Number B, int N>
[[nodiscard]] constexpr auto operator-(const Vec<A, N>& a, const Vec<B, N>& b) noexcept {
  return make_vec<N>([&](int i) { return a[i] - b[i]; });
}
template <Number T, int N>
[[nodiscard]] constexpr auto operator-(const Vec<T, N>& v) noexcept {
  return make_vec<N>([&](int i) { return -v[i]; });
}
template <Number A, Number B, int N>
[[nodiscard]] constexpr auto operator*(const Vec<A, N>& v, const B& factor) noexcept {
  return make_vec<N>([&](int i) { return v[i] * factor; });
}
template <Number A, Number B, int N>
[[nodiscard]] constexpr auto operator*(const A& factor, const Vec<B, N>& v) noexcept {
  return v * factor;
}

/// A built-in integer has all the bits of its type, as for numbers.
template <Number T, std::integral Int, int N>
[[nodiscard]] constexpr auto operator*(const Vec<T, N>& v, Int factor) noexcept {
  return v * detail::as_operand<T>(factor);
}
template <Number T, std::integral Int, int N>
[[nodiscard]] constexpr auto operator*(Int factor, const Vec<T, N>& v) noexcept {
  return v * detail::as_operand<T>(factor);
}

// One line each, because compilers show the line with the name.
// clang-format off
template <Number A, Number B, int N, int M>
void operator*(const Vec<A, N>&, const Vec<B, M>&) = delete;  // detent: write dot or cross
template <Number T, int N, class B>
requires Number<B> || std::integral<B>
void operator/(const Vec<T, N>&, const B&) = delete;  // detent: write quotient_nearest<S>(v, x)
// clang-format on

/// Rounds each component to nearest and clamps it, as for numbers.
template <Number A, Number B, int N>
constexpr Vec<A, N>& operator+=(Vec<A, N>& a, const Vec<B, N>& b) noexcept {
  for (int i = 0; i < N; ++i) a[i] += b[i];
  return a;
}
template <Number A, Number B, int N>
constexpr Vec<A, N>& operator-=(Vec<A, N>& a, const Vec<B, N>& b) noexcept {
  for (int i = 0; i < N; ++i) a[i] -= b[i];
  return a;
}
template <Number A, Number B, int N>
constexpr Vec<A, N>& operator*=(Vec<A, N>& v, const B& factor) noexcept {
  for (int i = 0; i < N; ++i) v[i] *= factor;
  return v;
}
template <Number T, std::integral Int, int N>
constexpr Vec<T, N>& operator*=(Vec<T, N>& v, Int factor) noexcept {
  return v *= detail::as_operand<T>(factor);
}

/// `v` with each component rounded to nearest, ties to even, and clamped.
template <Number S, Number T, int N>
[[nodiscard]] constexpr Vec<S, N> nearest_to(const Vec<T, N>& v) noexcept {
  return make_vec<N>([&](int i) { return nearest_to<S>(v[i]); });
}

/// v / d with each component rounded and clamped, and v / 2 exactly, as for numbers.
template <Number S, Number T, class D, int N>
requires Number<D> || std::integral<D>
[[nodiscard]] constexpr Vec<S, N> quotient_nearest(const Vec<T, N>& v, const D& d) noexcept {
  return make_vec<N>([&](int i) { return quotient_nearest<S>(v[i], detail::as_operand<T>(d)); });
}
template <Number S, Number T, class D, int N>
requires Number<D> || std::integral<D>
[[nodiscard]] constexpr Vec<S, N> quotient_floor(const Vec<T, N>& v, const D& d) noexcept {
  return make_vec<N>([&](int i) { return quotient_floor<S>(v[i], detail::as_operand<T>(d)); });
}
template <Number T, int N>
[[nodiscard]] constexpr auto half(const Vec<T, N>& v) noexcept {
  return make_vec<N>([&](int i) { return half(v[i]); });
}

/// `v` where each component is known to fit; see `narrow` for numbers.
template <int Bits, Number T, int N>
[[nodiscard]] constexpr auto narrow(const Vec<T, N>& v) noexcept {
  return make_vec<N>([&](int i) { return narrow<Bits>(v[i]); });
}

/// -v in the type of v; see `narrow_negative` for numbers.
template <Number T, int N>
[[nodiscard]] constexpr Vec<T, N> narrow_negative(const Vec<T, N>& v) noexcept {
  return make_vec<N>([&](int i) { return narrow_negative(v[i]); });
}

/// The dot product, exactly.
template <Number A, Number B, int N>
[[nodiscard]] constexpr auto dot(const Vec<A, N>& a, const Vec<B, N>& b) noexcept {
  if constexpr (N == 2) {
    return a.x * b.x + a.y * b.y;
  } else {
    // Three or four terms need two bits more than one, whatever the order of addition.
    constexpr int bits = detail::result_bits(bits_of<A> + bits_of<B> + 2);
    if constexpr (N == 3) {
      return narrow<bits>(a.x * b.x + a.y * b.y + a.z * b.z);
    } else {
      return narrow<bits>(a.x * b.x + a.y * b.y + a.z * b.z + a.w * b.w);
    }
  }
}

/// The dot product. The caller must prove that |a| |b| fits `Bits`; then every partial sum fits
/// too, and everything is computed in an integer of that size.
template <int Bits, Number A, Number B, int N>
[[nodiscard]] constexpr auto narrow_dot(const Vec<A, N>& a, const Vec<B, N>& b) noexcept {
  // Not const: GCC 12 keeps const objects of several words in memory.
  auto sum = narrow_sum<Bits>(narrow_product<Bits>(a.x, b.x), narrow_product<Bits>(a.y, b.y));
  if constexpr (N == 2) {
    return sum;
  } else {
    auto three = narrow_sum<Bits>(sum, narrow_product<Bits>(a.z, b.z));
    if constexpr (N == 3) {
      return three;
    } else {
      return narrow_sum<Bits>(three, narrow_product<Bits>(a.w, b.w));
    }
  }
}

/// The cross product, exactly.
template <Number A, Number B>
[[nodiscard]] constexpr auto cross(const Vec<A, 3>& a, const Vec<B, 3>& b) noexcept {
  return Vec{a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// The z component of the cross product: positive when `b` is counter-clockwise of `a`.
template <Number A, Number B>
[[nodiscard]] constexpr auto cross(const Vec<A, 2>& a, const Vec<B, 2>& b) noexcept {
  return a.x * b.y - a.y * b.x;
}

/// The cross product. The caller must prove that |a| |b| fits `Bits`.
template <int Bits, Number A, Number B>
[[nodiscard]] constexpr auto narrow_cross(const Vec<A, 2>& a, const Vec<B, 2>& b) noexcept {
  return narrow_difference<Bits>(narrow_product<Bits>(a.x, b.y), narrow_product<Bits>(a.y, b.x));
}
template <int Bits, Number A, Number B>
[[nodiscard]] constexpr auto narrow_cross(const Vec<A, 3>& a, const Vec<B, 3>& b) noexcept {
  return make_vec<3>([&](int i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    return narrow_cross<Bits>(Vec{a[j], a[k]}, Vec{b[j], b[k]});
  });
}

/// The squared length, exactly.
template <Number T, int N>
[[nodiscard]] constexpr auto squared_length(const Vec<T, N>& v) noexcept {
  return dot(v, v);
}

namespace detail {

/// The type of the length of a vector with components of type T. Unconstrained: when `normalize`
/// checks whether it is a scalar, GCC 12 would consider a constraint here recursive.
template <class T>
struct length_of {
  using type = T;
};
template <int Bits, int Frac>
requires(Bits == 32 || Bits == 33) struct length_of<Fixed<Bits, Frac>> {
  using type = Fixed<31, Frac>;
};

}  // namespace detail

/// The length of `v`, rounded down and clamped to the range of its component type: a scalar if the
/// components are scalars. For a sum or difference of 32-bit scalars it is a scalar too, so
/// `length(a - b)` is `distance(a, b)`. `length<T>(v)` rounds down to T instead.
template <Scalar S, int N>
[[nodiscard]] constexpr S length(const Vec<S, N>& v) noexcept {
  return sqrt_floor<S>(squared_length(v));
}
template <Number T, int N>
requires(!Scalar<T>) [[nodiscard]] constexpr auto length(const Vec<T, N>& v) noexcept {
  return sqrt_floor<typename detail::length_of<T>::type>(squared_length(v));
}
template <Number To, Number T, int N>
requires(!std::same_as<To, T>) [[nodiscard]] constexpr To length(const Vec<T, N>& v) noexcept {
  return sqrt_floor<To>(squared_length(v));
}

/// The square of the distance between two points, exactly.
template <Number A, Number B, int N>
[[nodiscard]] constexpr auto squared_distance(const Vec<A, N>& a, const Vec<B, N>& b) noexcept {
  return squared_length(a - b);
}

/// The distance between two points, rounded down and clamped to the range of the scalar.
template <Scalar S, int N>
[[nodiscard]] constexpr S distance(const Vec<S, N>& a, const Vec<S, N>& b) noexcept {
  if constexpr (N <= 3 && detail::has_short_differences<S>) {
    return distance_floor(to_array(a), to_array(b));
  } else {
    return sqrt_floor<S>(squared_distance(a, b));
  }
}

}  // namespace detent
