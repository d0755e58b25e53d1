// SPDX-License-Identifier: MIT
//
// The contact of two shapes has the exact depth and normal, each rounded once, and points on both
// shapes. Moved by its separation, the shapes no longer touch; moved by less, they do.

#include "detent/query/contact.hpp"
#include "decode.hpp"
#include "oracle/describe.hpp"
#include "oracle/hull.hpp"
//
#include "oracle/contact_answer.hpp"
#include "pairs.hpp"

namespace detent::fuzz {
namespace {

template <class A, class B, Scalar S, int N>
void check(Decoder<S, N>& decoder) {
  if constexpr (!(std::is_same_v<A, B> && std::is_same_v<A, Plane<S, N>>)) {
    const auto a = decoder.template shape<A>();
    const auto b = decoder.template shape<B>();
    const char* wrong = oracle::mistake<S, N>(a, b, contact(a, b), contact(b, a));
    require(wrong == nullptr, [&] {
      return std::string(wrong) + ": " + oracle::describe(a) + "; " + oracle::describe(b);
    });
  }
}

}  // namespace

void property(Bytes input) {
  check_two_shapes(input, []<class A, class B>(auto& decoder) { check<A, B>(decoder); });
}

}  // namespace detent::fuzz
