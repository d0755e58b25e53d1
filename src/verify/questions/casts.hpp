// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <type_traits>

#include "detent/query/cast.hpp"
#include "detent/query/time_of_impact.hpp"
#include "verify/questions/cases.hpp"
#include "verify/questions/kinds.hpp"
#include "verify/questions/pairs.hpp"

// Moving shapes: straight until they touch a target, or also turning.

namespace detent::verify {

template <Scalar S, int N, class First, class Second>
struct CastCase {
  First shape;
  Direction<S, N> direction;
  S max_distance;
  Second target;

  constexpr auto fields(const auto& f) const noexcept {
    return f(shape, direction, max_distance, target);
  }
};

template <class First, class Second, int... Dimensions>
struct Casts : PairGroup<Dimensions...> {
  static constexpr std::uint32_t share = 24;
  static constexpr RowName name{"cast/", First::name, "_", Second::name};
  static constexpr std::array<std::string_view, 1> names{name.view()};

  template <Scalar S, int N>
  static constexpr auto draw(Random& random) noexcept {
    ShapeScene<S, N> scene(random);
    const auto target = Second::draw(scene);
    scene.turn();
    const auto way = scene.retreat();
    const auto shape = First::draw(scene);
    return CastCase<S, N, std::remove_const_t<decltype(shape)>,
                    std::remove_const_t<decltype(target)>>{shape, way.direction, way.max_distance,
                                                           target};
  }
  template <int Row, class Case>
  [[nodiscard]] static constexpr auto answer(const Case& c) noexcept {
    return cast(as_shape(c.shape), c.direction, c.max_distance, as_shape(c.target));
  }
};

/// A shape that moves towards the spot or past it.
template <template <Scalar, int> class Shape, Scalar S, int N>
constexpr Cast<Shape<S, N>> drawn_cast(ShapeScene<S, N>& scene) noexcept {
  const auto way = scene.retreat();
  return {scene.draw(Type<Shape<S, N>>()), way.direction, way.max_distance};
}

template <Scalar S, int N, class First, class Second>
struct ImpactCase {
  First a;
  Sweep<S, N> sweep_a;
  Second b;
  Sweep<S, N> sweep_b;

  constexpr auto fields(const auto& f) const noexcept { return f(a, sweep_a, b, sweep_b); }
};

/// Draws shapes around the origins of their frames, and their motions: mostly so that they pass
/// close to each other.
template <Scalar S, int N>
class SweepScene : public ShapeScene<S, N> {
  using Base = ShapeScene<S, N>;
  using Base::center_;
  using Base::corner;
  using Base::extreme_;
  using Base::home_;
  using Base::reach_;

 public:
  using Base::random;

  using Base::Base;

  /// The next shape is drawn around the origin of its frame, or next to it.
  constexpr void enter_frame() noexcept {
    center_ = random.coin() ? typename Base::Point() : corner(reach_ / 4);
  }
  constexpr Sweep<S, N> sweep() noexcept {
    Sweep<S, N> result;
    const auto start = extreme_ ? Base::any_point() : home_ + corner(3 * reach_ / 2);
    const auto end = extreme_           ? Base::any_point()
                     : random.one_in(8) ? start
                                        : home_ + corner(reach_ / 4);
    result.start = Base::vec(start);
    result.end = Base::vec(end);
    if (random.one_in(4)) return result;
    result.start_rotation = Base::template any_rotation<N>();
    const auto turned = Base::template any_rotation<N>();
    result.end_rotation = random.one_in(6) ? result.start_rotation : turned;
    return result;
  }
};

template <class First, class Second>
struct Impacts : PairGroup<> {
  static constexpr std::uint32_t share = 24;
  static constexpr RowName name{"time_of_impact/", First::name, "_", Second::name};
  static constexpr std::array<std::string_view, 1> names{name.view()};

  template <Scalar S, int N>
  static constexpr auto draw(Random& random) noexcept {
    SweepScene<S, N> scene(random);
    scene.enter_frame();
    const auto a = First::draw(scene);
    const auto sweep_a = scene.sweep();
    scene.turn();
    scene.enter_frame();
    const auto b = Second::draw(scene);
    const auto sweep_b = scene.sweep();
    return ImpactCase<S, N, std::remove_const_t<decltype(a)>, std::remove_const_t<decltype(b)>>{
        a, sweep_a, b, sweep_b};
  }
  template <int Row, class Case>
  [[nodiscard]] static constexpr auto answer(const Case& c) noexcept {
    return time_of_impact(as_shape(c.a), c.sweep_a, as_shape(c.b), c.sweep_b);
  }
};

}  // namespace detent::verify
