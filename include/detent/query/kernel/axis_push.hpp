// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <type_traits>
#include <utility>

#include "detent/math/components.hpp"
#include "detent/number/filter/filtered.hpp"
#include "detent/query/kernel/axis_filter.hpp"
#include "detent/query/kernel/convex_body.hpp"
#include "detent/query/kernel/expansion.hpp"
#include "detent/query/kernel/for_each_two.hpp"

namespace detent::detail {

/// A type that holds every number of A and of B.
template <Number A, Number B>
struct holder_of {
  using type = A;
};
template <int BitsA, int FracA, int BitsB, int FracB>
struct holder_of<Fixed<BitsA, FracA>, Fixed<BitsB, FracB>> {
  static constexpr int frac = (std::max)(FracA, FracB);
  using type = Fixed<(std::max)(BitsA - FracA, BitsB - FracB) + frac, frac>;
};
template <Number A, Number B>
using HolderOf = typename holder_of<A, B>::type;

/// Whether T is the type of a direction's components.
template <Number T>
inline constexpr bool is_unit_component = false;
template <int Bits, int Frac>
inline constexpr bool is_unit_component<Fixed<Bits, Frac>> = Bits == Frac + 1;

/// The least push of b out of a among those perpendicular to two edges (in 2D, to one), for boxes,
/// triangles, segments and points; nothing for bodies with more edges, or too few.
///
/// If its height is positive, it is the least push of all, and that of a facet. If it is negative,
/// the bodies are apart. If it is 0, they may be apart, touch, or lie in one plane.
///
/// Along every direction, P, the differences a - b, reaches at least the distance d of its nearest
/// facet from the origin, and each facet is perpendicular to two edges. So the least push is among
/// those tried. If d > 0, the ball of radius d about the origin touches the surface of P only at
/// facets, each with the normal of the ball there; so no other direction reaches d.
///
/// source: Gottschalk, Lin, Manocha, OBBTree (1996), the axes; see Expansion for P
template <Number T, class A, class B, int N = A::dimension>
class AxisPush {
 public:
  constexpr AxisPush(const A& a, const B& b) noexcept : a_(a), b_(b) {}

  /// Ends with the first push that is not positive. `filter` may rule out axes and sides.
  template <class Filter = AnyAxis>
  [[nodiscard]] constexpr auto least(const Filter& filter = {}) const noexcept {
    using Result = Push<Vec<Axis, N>, decltype(dot(Vec<Axis, N>(), Vec<T, N>()))>;
    std::optional<Result> best;
    if (!a_.has_few_edges() || !b_.has_few_edges()) return best;
    const auto push_along = [&](const Vec<Axis, N>& normal) {
      return Result{normal, dot(normal, farthest(normal))};
    };
    const auto offer = [&](const Result& push) {
      if (!best || !(push.height > 0) || is_less(push, *best)) best = push;
    };
    const auto is_done = [&] { return best && !(best->height > 0); };
    for_each_axis([&](std::size_t i) { return filter.can_be_least(i); },
                  [&](const auto& axis) {
                    if (is_zero(axis) || is_done()) return;
                    const auto along = make_vec<N>([&](int i) { return Axis(axis[i]); });
                    const auto back = narrow_negative(along);
                    const int side = filter.side_of(axis);
                    if (side != 0) return offer(push_along(side > 0 ? along : back));
                    const auto push = push_along(along);
                    if constexpr (is_fixed<T>) {
                      if (push.height > 0) {
                        // Their normals are of one length, so their heights compare them.
                        const auto other = push_along(back);
                        const bool is_other =
                            other.height < push.height ||
                            (other.height == push.height && is_preferred(back, along));
                        return offer(is_other ? other : push);
                      }
                      best = push;
                    } else {
                      offer(push);
                      if (!is_done()) offer(push_along(back));
                    }
                  });
    return best;
  }

 private:
  using EdgeA = decltype(A::Edge::x);
  using EdgeB = decltype(B::Edge::x);
  /// The cross product of two edges. Components of directions do not exceed 1, so those of their
  /// cross products do not exceed 2.
  template <Number E, Number F>
  [[nodiscard]] static constexpr auto axis_of(const Vec<E, 3>& e, const Vec<F, 3>& f) noexcept {
    if constexpr (is_unit_component<E> && is_unit_component<F>) {
      return narrow_cross<E::frac + F::frac + 2>(e, f);
    } else {
      return cross(e, f);
    }
  }
  template <Number E, Number F>
  using Across = std::remove_cvref_t<decltype(axis_of(Vec<E, 3>(), Vec<F, 3>()).x)>;
  /// Holds the components of every axis.
  using Axis = std::conditional_t<
      N == 2, HolderOf<EdgeA, EdgeB>,
      HolderOf<Across<EdgeA, EdgeB>, HolderOf<Across<EdgeA, EdgeA>, Across<EdgeB, EdgeB>>>>;

  /// Calls f with a vector along each axis whose number satisfies `wants`; some may be 0 or
  /// repeated.
  template <class Wants, class F>
  constexpr void for_each_axis(const Wants& wants, const F& f) const noexcept {
    std::size_t i = 0;
    if constexpr (N == 2) {
      const auto across = [&](const auto& e) {
        if (wants(i++)) f(Vec{e.y, narrow_negative(e.x)});
      };
      a_.for_each_edge(across);
      b_.for_each_edge(across);
    } else {
      const auto across = [&](const auto& e, const auto& g) {
        if (wants(i++)) f(axis_of(e, g));
      };
      for_each_two([&](const auto& g) { a_.for_each_edge(g); }, across);
      for_each_two([&](const auto& g) { b_.for_each_edge(g); }, across);
      a_.for_each_edge(
          [&](const auto& e) { b_.for_each_edge([&](const auto& g) { across(e, g); }); });
    }
  }

  template <Number V>
  [[nodiscard]] constexpr Vec<T, N> farthest(const Vec<V, N>& v) const noexcept {
    constexpr int bits = bits_of<T>;
    return narrow<bits>(a_.template extreme<bits>(v, origin_of(b_), true) -
                        b_.template extreme<bits>(v, origin_of(a_), false));
  }
  /// Some corner of the other body, for a body that measures its corners from there.
  template <class Body>
  [[nodiscard]] static constexpr decltype(auto) origin_of(const Body& body) noexcept {
    if constexpr (IsBoxBody<A> && IsBoxBody<B>) {
      return Vec<T, N>();
    } else {
      return body.some();
    }
  }

  const A& a_;
  const B& b_;
};

}  // namespace detent::detail
