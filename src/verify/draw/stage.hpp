// SPDX-License-Identifier: MIT
#pragma once

#include "verify/draw/numbers.hpp"

namespace detent::verify {

/// A type of shapes as a value.
template <class Shape>
struct Type {};

/// The position and size of a case: anywhere in the world, at a scale from a few raw units to the
/// whole range. One case in eight is built from extreme numbers instead.
template <Scalar S, int N>
class Stage : public Numbers<S> {
  using Base = Numbers<S>;

 public:
  using Base::limit;
  using Base::one;
  using Base::random;
  using Point = Raw<N>;

  using Base::Base;

 protected:
  constexpr void begin() noexcept {
    extreme_ = random.one_in(8);
    const int size = static_cast<int>(random.between(2, Base::bits - 1));
    reach_ = std::int64_t{1} << size;
    const auto room = limit - 4 * reach_;
    for (int i = 0; i < N; ++i) {
      const auto place = random.wide(Base::bits);
      center_[i] = extreme_        ? random.edgy(Base::bits)
                   : room <= 0     ? 0
                   : place > room  ? room
                   : place < -room ? -room
                                   : place;
    }
  }

  constexpr Point corner(std::int64_t far) noexcept {
    Point point;
    for (int i = 0; i < N; ++i) point[i] = random.between(-far, far);
    return point;
  }

  /// A radius or half extent, sometimes 0 and sometimes negative.
  constexpr std::int64_t extent() noexcept {
    if (random.one_in(32)) return random.between(-2, 0);
    return extreme_ ? static_cast<std::int64_t>(magnitude(random.edgy(Base::bits)))
                    : random.between(0, reach_);
  }
  /// Up to `sixteenths` of `length` in either direction.
  constexpr std::int64_t part(std::int64_t length, std::int64_t sixteenths) noexcept {
    const auto far = length * sixteenths / 16;
    return random.between(-far, far);
  }
  /// Inside, outside or exactly at the end of an extent, or one unit off the end.
  constexpr std::int64_t face_or_part(std::int64_t half) noexcept {
    switch (random.below(8)) {
      case 0:
      case 1:
        return half * random.sign();
      case 2: {
        const auto beside = random.between(-1, 1);
        return half * random.sign() + beside;
      }
      default:
        return part(half, 20);
    }
  }

  bool extreme_ = false;
  std::int64_t reach_ = 1;
  Point center_{};
};

}  // namespace detent::verify
