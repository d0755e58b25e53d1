// SPDX-License-Identifier: MIT
#pragma once

#include <new>
#include <utility>

namespace detent::oracle {

/// The number of Boost's that an `Owner` keeps in its bytes `number_`, so that only the source of its
/// members includes Boost.
template <class Owner, class Number>
struct HiddenNumber {
  static_assert(sizeof(Number) <= sizeof(Owner::number_) && alignof(Number) <= alignof(Owner));

  static Number& of(Owner& x) { return *std::launder(reinterpret_cast<Number*>(x.number_.data())); }
  static const Number& of(const Owner& x) {
    return *std::launder(reinterpret_cast<const Number*>(x.number_.data()));
  }
  template <class Value>
  static void make(Owner& x, Value&& value) {
    ::new (x.number_.data()) Number(std::forward<Value>(value));
  }
};

}  // namespace detent::oracle
