// SPDX-License-Identifier: MIT
#include "detent/dynamics/formats.hpp"

#include <concepts>

#include "detent/dynamics/manifold.hpp"
#include "support/catch.hpp"

namespace {

using namespace detent;

/// The formats of a step's products and results. All scalars compute the same integers if every
/// product is as much finer than its result as with q16_16.
template <Scalar S>
constexpr bool runs_the_integers_of_q16_16() {
  using F = detail::Formats<S>;
  using G = detail::Formats<q16_16>;
  const auto shift = []<class A, class B, class To>(A, B, To) {
    return A::frac + B::frac - To::frac;
  };
  const auto same = [&](auto of) { return of(F()) == of(G()); };
  return same([&]<class X>(X) {
           return shift(typename X::Arm(), typename X::Spin(), typename X::Speed());
         }) &&
         same([&]<class X>(X) {
           return shift(typename X::Response(), typename X::Impulse(), typename X::Spin());
         }) &&
         same([&]<class X>(X) {
           return shift(typename X::Gyration(), typename X::Arm(), typename X::Response());
         }) &&
         same([&]<class X>(X) {
           return shift(typename X::Arm(), typename X::Response(), typename X::Ratio());
         }) &&
         same([&]<class X>(X) {
           return shift(typename X::Ratio(), typename X::Place(), typename X::Speed());
         }) &&
         F::Place::frac - S::frac == 12 && F::Lever::frac == F::Gap::frac &&
         F::Lever::frac == F::Arm::frac && F::Speed::frac == F::Place::frac;
}

}  // namespace

TEST_CASE("formats: every scalar computes the same integers") {
  STATIC_REQUIRE(runs_the_integers_of_q16_16<q16_16>());
  STATIC_REQUIRE(runs_the_integers_of_q16_16<q14_16>());
  STATIC_REQUIRE(runs_the_integers_of_q16_16<q24_8>());
  STATIC_REQUIRE(runs_the_integers_of_q16_16<q8_8>());
  STATIC_REQUIRE(runs_the_integers_of_q16_16<Fixed<31, 30>>());
  STATIC_REQUIRE(runs_the_integers_of_q16_16<Fixed<31, 0>>());
}

TEST_CASE("formats: a speed and a lever of q16_16 have the documented grids") {
  using F = detail::Formats<q16_16>;
  STATIC_REQUIRE(std::same_as<F::Place, Fixed<43, 28>>);
  STATIC_REQUIRE(std::same_as<F::Speed, Fixed<30, 28>>);
  STATIC_REQUIRE(std::same_as<F::Lever, Fixed<31, 22>>);
  STATIC_REQUIRE(std::same_as<detail::Formats<double>::Lever, double>);
  STATIC_REQUIRE(sizeof(detail::ManifoldPoint<q16_16, 3>) == 20);
}
