// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <type_traits>

#include "detent/math/vec.hpp"

namespace detent::detail {

/// What an array stores of a number: the raw integer, or a number that rounds itself.
template <Number T>
struct Stored {
  using type = T;
  [[nodiscard]] static constexpr const T& of(const T& x) noexcept { return x; }
  [[nodiscard]] static constexpr const T& number(const T& x) noexcept { return x; }
};
template <int Bits, int Frac>
struct Stored<Fixed<Bits, Frac>> {
  using type = typename Fixed<Bits, Frac>::raw_type;
  [[nodiscard]] static constexpr type of(const Fixed<Bits, Frac>& x) noexcept { return x.raw(); }
  [[nodiscard]] static constexpr Fixed<Bits, Frac> number(const type& raw) noexcept {
    return Fixed<Bits, Frac>::assume_raw(raw);
  }
};

/// Room for `Count` vectors. Unlike an array it does not set them to 0, which takes longer than all
/// else if only a few of many are used.
template <Number T, int N, std::size_t Count>
class VecList {
 public:
  constexpr VecList() noexcept {
    if (std::is_constant_evaluated()) raw_ = {};
  }

  [[nodiscard]] constexpr Vec<T, N> operator[](std::size_t k) const noexcept {
    return make_vec<N>(
        [&](int i) { return Stored<T>::number(raw_[k][static_cast<std::size_t>(i)]); });
  }
  constexpr void set(std::size_t k, const Vec<T, N>& v) noexcept {
    for (int i = 0; i < N; ++i) raw_[k][static_cast<std::size_t>(i)] = Stored<T>::of(v[i]);
  }

 private:
  std::array<std::array<typename Stored<T>::type, std::size_t{N}>, Count> raw_;
};

/// The same for numbers.
template <Number T, std::size_t Count>
class NumberList {
 public:
  constexpr NumberList() noexcept {
    if (std::is_constant_evaluated()) raw_ = {};
  }

  [[nodiscard]] constexpr T operator[](std::size_t k) const noexcept {
    return Stored<T>::number(raw_[k]);
  }
  constexpr void set(std::size_t k, const T& x) noexcept { raw_[k] = Stored<T>::of(x); }

 private:
  std::array<typename Stored<T>::type, Count> raw_;
};

}  // namespace detent::detail
