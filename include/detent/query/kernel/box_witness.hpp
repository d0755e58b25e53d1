// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <type_traits>
#include <utility>

#include "detent/math/components.hpp"
#include "detent/math/width.hpp"
#include "detent/number/filter/leading.hpp"
#include "detent/query/kernel/length.hpp"
#include "detent/query/kernel/rounded_point.hpp"
#include "detent/query/kernel/simplex.hpp"
#include "detent/query/kernel/spanned_box.hpp"
#include "detent/query/kernel/touch_witness.hpp"
#include "detent/shape/aabb.hpp"
#include "detent/shape/obb.hpp"

// The closest points of two boxes that are apart, by a witness: a feature of their
// difference, found in short numbers, which is then proved to hold the closest difference
// (docs/filters.md, lemma 22).

namespace detent::detail {

/// Whether the differences of two boxes fit words: all lengths together are at most 2^31 steps, so
/// that on the grid of the corners they are at most 2^61.
template <Scalar S>
[[nodiscard]] constexpr bool fit_words(const SpannedBox<S>& a, const SpannedBox<S>& b) noexcept {
  const auto apart = a.center - b.center;
  auto sum = narrow<36>((std::max)((std::max)(abs(apart.x), abs(apart.y)), abs(apart.z)));
  for (int i = 0; i < 3; ++i) sum = narrow<36>(sum + a.half_extents[i] + b.half_extents[i]);
  return fits<32>(sum);
}

/// An extent times a component of its axis: exact, because half steps occur only along axes of the
/// world.
template <Number Place, Number Half, Number Component>
[[nodiscard]] constexpr Place edge_of(const Half& extent, const Component& component) noexcept {
  return narrow_floor<Place>(narrow_product<62>(extent, component));
}

/// Proposes the feature closest to the origin: GJK (see gjk.hpp) on rounded numbers, from the corner
/// that is least far along `start`. Sets the names of its corners and returns their number; 4 if
/// they seem to enclose the origin, 0 if there is no answer.
template <class Names, class LeastAlong, class Corner>
[[nodiscard]] constexpr int propose_feature(Names& names, const Vec<Fixed<28, 0>, 3>& start,
                                            const LeastAlong& least_along,
                                            const Corner& corner) noexcept {
  using Rough = Fixed<28, 0>;
  Simplex<Rough, 3> simplex;
  const auto add = [&](const auto& name, const Vec<Rough, 3>& place) {
    names[static_cast<std::size_t>(simplex.count)] = name;
    simplex.add(place);
  };
  const auto first = least_along(start);
  add(first, corner(first));
  for (int i = 0; i < 16; ++i) {
    const bool is_found = with_direction(simplex, [&](const auto& v) {
      const auto across = shortened<Rough::bits>(v);
      const auto name = least_along(across);
      const auto place = corner(name);
      // `across` is off by less than 1 in each component.
      const auto step = narrow<29>(place - simplex.newest());
      const auto error = narrow<31>(sum_of_magnitudes(step));
      if (!(narrow_dot<60>(across, step) + error < 0)) return true;
      add(name, place);
      return false;
    });
    if (is_found) return simplex.count;
    const auto all = simplex;
    const auto from = names;
    const auto choice = nearest_corners(all);
    if (choice.count > 3) return choice.count;
    simplex = {};
    for (int k = 0; k < choice.count; ++k) {
      add(from[static_cast<std::size_t>(choice[k])], all[choice[k]]);
    }
  }
  return 0;
}

/// The differences p - q of points p of box a and q of box b: center + sum s[m] extent[m] axis[m],
/// |s[m]| <= 1, for the axes of a and the reversed axes of b. A feature is a corner, whose s[m] are
/// -1 or 1, and up to two free axes, along which it extends.
template <Scalar S>
class BoxWitness {
 public:
  using Points = std::pair<Vec<S, 3>, Vec<S, 3>>;

  template <class A, class B>
  constexpr BoxWitness(const A& a, const B& b) noexcept : a_(a), b_(b), fits_(fit_words(a_, b_)) {
    if (!fits_) return;
    for (int i = 0; i < 3; ++i) {
      axes_[at(i)] = a_.rotation.axis(i).vec();
      axes_[at(i + 3)] = narrow_negative(b_.rotation.axis(i).vec());
      extents_[at(i)] = a_.half_extents[i];
      extents_[at(i + 3)] = b_.half_extents[i];
      center_[i] = narrow<32>(a_.center[i] - b_.center[i]);
    }
    for (std::size_t m = 0; m < size; ++m) {
      edges_[m] = make_vec<3>([&](int i) { return edge_of<Place>(extents_[m], axes_[m][i]); });
    }
  }

  /// The distance, rounded down.
  [[nodiscard]] constexpr Decided<Length<S>> distance_floor() noexcept {
    if (!fits_ || !find()) return {Length<S>(), false};
    if (count_ == 1) return distance_of_corner();
    if (count_ == 2) return distance_of_edge();
    return distance_of_face();
  }

  /// The closest points of a and b, rounded to nearest.
  [[nodiscard]] constexpr Decided<Points> closest_points() noexcept {
    if (!fits_ || !find()) return {Points(), false};
    if (count_ == 1) return points_of_corner();
    if (count_ == 2) return points_of_edge();
    return points_of_face();
  }

 private:
  static constexpr std::size_t size = 6;
  static constexpr int axis_frac = direction_component<S>::frac;
  static_assert(axis_frac == 30);
  static constexpr int frac = S::frac + axis_frac;
  using Axis = Vec<direction_component<S>, 3>;
  using Place = Fixed<61, frac>;
  using Spot = Fixed<63, frac>;  // in the world
  using Sides = std::size_t;     // bit m is set if s[m] = 1
  using Rough = Fixed<28, 0>;
  using RoughVec = Vec<Rough, 3>;

  [[nodiscard]] static constexpr std::size_t at(int i) noexcept {
    return static_cast<std::size_t>(i);
  }
  [[nodiscard]] static constexpr bool is_upper(Sides sides, std::size_t m) noexcept {
    return (sides >> m & 1) != 0;
  }

  /// Proposes a feature: GJK (see gjk.hpp) on rounded numbers. False if the boxes seem to overlap.
  [[nodiscard]] constexpr bool find() noexcept {
    const auto& c = center_;
    auto most = (std::max)((std::max)(abs(c.x), abs(c.y)), abs(c.z));
    for (const auto& extent : extents_) most = narrow_sum<61>(most, extent);
    // So all differences are below 2^27 steps.
    dropped_ = bit_length(most.raw()) - (Rough::bits - 1);
    if (dropped_ < 0) dropped_ = 0;
    rough_center_ = rough(c);
    for (std::size_t m = 0; m < size; ++m) rough_edges_[m] = rough(edges_[m]);
    count_ = propose_feature(
        sides_, rough_center_, [&](const RoughVec& v) { return sides_along(v); },
        [&](Sides sides) { return rough_corner(sides); });
    return count_ > 0 && count_ <= 3 && name_free_axes();
  }

  template <Number T>
  [[nodiscard]] constexpr RoughVec rough(const Vec<T, 3>& v) const noexcept {
    return without_low_bits<Rough>(v, dropped_);
  }
  /// The sides of the corner that is least far along v.
  [[nodiscard]] constexpr Sides sides_along(const RoughVec& v) const noexcept {
    Sides sides = 0;
    for (std::size_t m = 0; m < size; ++m) {
      sides |= static_cast<Sides>(narrow_dot<60>(v, axes_[m]) < 0) << m;
    }
    return sides;
  }
  [[nodiscard]] constexpr RoughVec rough_corner(Sides sides) const noexcept {
    auto corner = rough_center_;
    for (std::size_t m = 0; m < size; ++m) {
      const auto& edge = rough_edges_[m];
      for (int i = 0; i < 3; ++i) {
        corner[i] = is_upper(sides, m) ? narrow_sum<Rough::bits>(corner[i], edge[i])
                                       : narrow_difference<Rough::bits>(corner[i], edge[i]);
      }
    }
    return corner;
  }
  /// Finds the axes along which the corners of the feature differ. False if there are too many.
  [[nodiscard]] constexpr bool name_free_axes() noexcept {
    Sides differ = 0;
    for (int k = 1; k < count_; ++k) differ |= sides_[at(k)] ^ sides_[0];
    int found = 0;
    for (std::size_t m = 0; m < size; ++m) {
      if (!is_upper(differ, m)) continue;
      if (found == 2) return false;
      free_[at(found++)] = m;
    }
    return found == count_ - 1;
  }

  /// The corner of the difference on these sides.
  [[nodiscard]] constexpr Vec<Place, 3> corner() const noexcept {
    return moved_corner<Place>(center_, 0, size, false);
  }
  /// The center plus or minus the edges from m to end.
  template <Number T, Number C>
  [[nodiscard]] constexpr Vec<T, 3> moved_corner(const Vec<C, 3>& center, std::size_t m,
                                                 std::size_t end, bool is_reversed) const noexcept {
    auto result = make_vec<3>([&](int i) { return T(center[i]); });
    for (; m < end; ++m) {
      for (int i = 0; i < 3; ++i) {
        result[i] = is_upper(sides_[0], m) != is_reversed
                        ? narrow_sum<T::bits>(result[i], edges_[m][i])
                        : narrow_difference<T::bits>(result[i], edges_[m][i]);
      }
    }
    return result;
  }
  [[nodiscard]] constexpr Vec<Spot, 3> corner_of_a() const noexcept {
    return moved_corner<Spot>(a_.center, 0, 3, false);
  }
  [[nodiscard]] constexpr Vec<Spot, 3> corner_of_b() const noexcept {
    return moved_corner<Spot>(b_.center, 3, size, true);
  }

  [[nodiscard]] constexpr bool is_free(std::size_t m) const noexcept {
    return (count_ > 1 && m == free_[0]) || (count_ > 2 && m == free_[1]);
  }
  /// Whether the difference is least far along v, whose products with the axes are off by less than
  /// `error`, only in the feature.
  template <Number V, Number Error>
  [[nodiscard]] constexpr bool is_least_along(const Vec<V, 3>& v,
                                              const Error& error) const noexcept {
    bool is_least = true;
    for (std::size_t m = 0; m < size; ++m) {
      const auto along = dot(v, axes_[m]);
      const bool is_less = is_upper(sides_[0], m) ? along < -error : along > error;
      is_least = is_least && (is_less || is_free(m) || extents_[m] == 0);
    }
    return is_least;
  }

  /// from + step(i) or from - step(i) for coordinate i, off by less than `Error` steps, rounded.
  template <int Error, class Step>
  static constexpr Vec<S, 3> rounded(const Vec<Spot, 3>& from, const Step& step, bool is_added,
                                     bool& is_sure) noexcept {
    return make_vec<3>([&](int i) {
      const auto x = is_added ? narrow_sum<Spot::bits>(from[i], step(i))
                              : narrow_difference<Spot::bits>(from[i], step(i));
      const auto nearest = decide_coordinate<S>(Approximate{x, Steps<Error>()});
      is_sure = is_sure && nearest.is_sure;
      return nearest.value;
    });
  }

  // A corner.

  [[nodiscard]] constexpr Decided<Length<S>> distance_of_corner() const noexcept {
    const auto x = corner();
    return {sqrt_floor<Length<S>>(narrow_dot<124>(x, x)), is_least_along(x, Place(0))};
  }
  [[nodiscard]] constexpr Decided<Points> points_of_corner() const noexcept {
    return {{nearest_to<S>(corner_of_a()), nearest_to<S>(corner_of_b())},
            is_least_along(corner(), Place(0))};
  }

  // An edge e. The closest difference v is x - e t for its corner x and t = (x.e) / (e.e).

  struct OnEdge {
    Fixed<62, frac> t;
    Vec<Place, 3> v;
    bool is_sure = false;
  };
  [[nodiscard]] constexpr OnEdge on_edge() const noexcept {
    const auto& e = axes_[free_[0]];
    const auto x = corner();
    const auto excess = narrow_dot<61>(e, e) - Fixed<61, 2 * axis_frac>(1);
    if (!fits<33>(excess)) return {};
    // 1 / (1 + excess) is nearly 1 - excess.
    const auto along = narrow_floor<Fixed<62, frac>>(narrow_dot<92>(x, e));
    const auto t = along - narrow_floor<Fixed<36, frac>>(along * narrow<33>(excess));
    constexpr auto error = Place::from_raw(1 << 10);
    const auto& extent = extents_[free_[0]];
    const auto end = extent + extent;
    const bool is_inside = is_upper(sides_[0], free_[0]) ? t > error && t + error < end
                                                         : t < -error && -t + error < end;
    if (!is_inside) return {};
    OnEdge result;
    result.t = narrow<62>(t);
    result.v = make_vec<3>([&](int i) {
      return narrow_difference<61>(x[i], narrow_floor<Fixed<62, frac>>(result.t * e[i]));
    });
    constexpr auto sign_error = Fixed<12, frac>::from_raw(1 << 11);
    constexpr auto least = Place::from_raw(1 << 12);
    bool is_long = false;
    for (int i = 0; i < 3; ++i) is_long = is_long || abs(result.v[i]) > least;
    result.is_sure = is_long && is_least_along(result.v, sign_error);
    return result;
  }
  [[nodiscard]] constexpr Decided<Length<S>> distance_of_edge() const noexcept {
    const auto closest = on_edge();
    if (!closest.is_sure) return {Length<S>(), false};
    const auto length = sqrt_floor<Fixed<62, frac>>(narrow_dot<124>(closest.v, closest.v));
    return decide_floor<Length<S>>(Approximate{length, Steps<1 << 12>()});
  }
  [[nodiscard]] constexpr Decided<Points> points_of_edge() const noexcept {
    const auto closest = on_edge();
    if (!closest.is_sure) return {Points(), false};
    Decided<Points> result{Points(), true};
    const auto p = corner_of_a(), q = corner_of_b();
    const auto& e = axes_[free_[0]];
    const auto step = [&](int i) { return narrow_floor<Fixed<62, frac>>(closest.t * e[i]); };
    auto& [on_a, on_b] = result.value;
    const bool is_of_a = free_[0] < 3;
    on_a = is_of_a ? rounded<1 << 11>(p, step, false, result.is_sure) : nearest_to<S>(p);
    on_b = is_of_a ? nearest_to<S>(q) : rounded<1 << 11>(q, step, true, result.is_sure);
    return result;
  }

  // A face with the edges e and f. The closest difference is v = n (n.x) / (n.n) for n = e x f, and
  // x = v + s e + t f for s = x.(f x n) / (n.n), t = x.(n x e) / (n.n).

  struct OnFace {
    Vec<Fixed<61, 2 * axis_frac>, 3> n;
    Fixed<123, frac + 2 * axis_frac> height;  // n.x
    Fixed<123, 4 * axis_frac> whole;          // n.n
    Fixed<62, frac> s, t;
    Leading part;  // 1 / (n.n)
    bool is_sure = false;
  };
  [[nodiscard]] constexpr OnFace on_face() const noexcept {
    const auto &e = axes_[free_[0]], &f = axes_[free_[1]];
    const auto x = corner();
    OnFace result;
    auto& n = result.n;
    n = narrow_cross<61>(e, f);
    result.height = narrow_dot<123>(n, x);
    result.whole = narrow_dot<123>(n, n);
    if (result.height == 0) return result;
    if (result.whole < Fixed<1, 8>::from_raw(1)) return result;
    const auto v = result.height < 0 ? narrow_negative(n) : n;
    if (!is_least_along(v, Place(0))) return result;
    result.part = Leading(Fixed<2, 0>(1)) / Leading(result.whole);
    const auto across = [](const auto& u, const auto& w) {
      const auto product = cross(u, w);
      return make_vec<3>([&](int i) { return narrow_floor<Fixed<61, 2 * axis_frac>>(product[i]); });
    };
    bool is_inside = true;
    const auto along = [&](std::size_t k, const auto& w) {
      const auto over = narrow_dot<124>(x, w);
      const auto length =
          Fixed<63, frac>::assume_raw((Leading(abs(over)) * result.part).template scaled<frac>());
      constexpr auto error = Place::from_raw(1 << 12);
      const auto& extent = extents_[free_[k]];
      is_inside = is_inside && (over > 0) == is_upper(sides_[0], free_[k]) && length > error &&
                  length + error < extent + extent;
      return over < 0 ? narrow_negative(length) : length;
    };
    const auto s = along(0, across(f, n)), t = along(1, across(n, e));
    if (!is_inside) return result;
    result.s = narrow<62>(s);
    result.t = narrow<62>(t);
    result.is_sure = true;
    return result;
  }
  [[nodiscard]] constexpr Decided<Length<S>> distance_of_face() const noexcept {
    const auto closest = on_face();
    if (!closest.is_sure) return {Length<S>(), false};
    return decide_floor<Length<S>>(
        Approximate{Leading(abs(closest.height)) / sqrt(Leading(closest.whole)), Relative{41}});
  }
  [[nodiscard]] constexpr Decided<Points> points_of_face() const noexcept {
    const auto closest = on_face();
    if (!closest.is_sure) return {Points(), false};
    Decided<Points> result{Points(), true};
    const auto p = corner_of_a(), q = corner_of_b();
    auto& [on_a, on_b] = result.value;
    constexpr int error = 1 << 13;
    if (free_[0] < 3 && free_[1] >= 3) {
      const auto along = [&](const auto& t, std::size_t k) {
        return [&t, &axis = axes_[free_[k]]](int i) {
          return narrow_floor<Fixed<62, frac>>(t * axis[i]);
        };
      };
      on_a = rounded<error>(p, along(closest.s, 0), false, result.is_sure);
      on_b = rounded<error>(q, along(closest.t, 1), true, result.is_sure);
      return result;
    }
    const auto height = Leading(abs(closest.height)) * closest.part;
    const auto v = [&](int i) {
      const auto& n = closest.n[i];
      const auto length = Spot::assume_raw((height * Leading(abs(n))).template scaled<frac>());
      return (n < 0) == (closest.height < 0) ? length : narrow_negative(length);
    };
    const bool is_of_a = free_[0] < 3;
    on_a = is_of_a ? rounded<error>(q, v, true, result.is_sure) : nearest_to<S>(p);
    on_b = is_of_a ? nearest_to<S>(q) : rounded<error>(p, v, false, result.is_sure);
    return result;
  }

  SpannedBox<S> a_, b_;
  bool fits_ = false;
  int count_ = 0;
  Vec<Place, 3> center_;
  std::array<Axis, size> axes_;
  std::array<typename SpannedBox<S>::Half, size> extents_;
  std::array<Vec<Place, 3>, size> edges_;
  int dropped_ = 0;
  RoughVec rough_center_;
  std::array<RoughVec, size> rough_edges_;
  std::array<Sides, 4> sides_{};  // of the feature's corners
  std::array<std::size_t, 2> free_{};
};

/// Whether to search the closest points of two shapes by such a witness.
template <class A, class B>
inline constexpr bool has_box_witness = false;
template <Scalar S>
inline constexpr bool has_box_witness<Obb<S, 3>, Obb<S, 3>> = is_fixed<S>&& filter_pays<S>;
template <Scalar S>
inline constexpr bool has_box_witness<Aabb<S, 3>, Obb<S, 3>> = is_fixed<S>&& filter_pays<S>;
template <Scalar S>
inline constexpr bool has_box_witness<Obb<S, 3>, Aabb<S, 3>> = is_fixed<S>&& filter_pays<S>;

}  // namespace detent::detail
