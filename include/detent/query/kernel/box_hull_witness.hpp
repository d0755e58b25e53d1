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
#include "detent/query/kernel/box_witness.hpp"
#include "detent/query/kernel/rounded_point.hpp"
#include "detent/query/kernel/simplex.hpp"
#include "detent/query/kernel/spanned_box.hpp"
#include "detent/query/kernel/vec_list.hpp"
#include "detent/shape/hull.hpp"
#include "detent/shape/triangle.hpp"

// The closest points of an oriented box and a polytope of few corners that are apart, by a witness
// (docs/filters.md, lemma 28).

namespace detent::detail {

/// The differences p - q of points p of a box and q of a hull. A feature has a corner of the box and
/// one of the hull, up to two free axes of the box, and up to two more corners of the hull.
template <Scalar S>
class BoxHullWitness {
 public:
  using Points = std::pair<Vec<S, 3>, Vec<S, 3>>;

  template <class Box, class Corners>
  constexpr BoxHullWitness(const Box& box, const Corners& corners) noexcept
      : box_(box), size_(corners.size()) {
    if (size_ > capacity) return;
    auto most = Reach(0);
    for (std::size_t k = 0; k < size_; ++k) {
      hull_.set(k, corners[k]);
      const auto apart = box_.center - corners[k];
      for (int i = 0; i < 3; ++i) most = (std::max)(most, Reach(abs(apart[i])));
    }
    for (const auto& extent : box_extents()) most = narrow_sum<Reach::bits>(most, extent);
    fits_ = fits<29>(most);
    if (!fits_) return;
    dropped_ = (std::max)(bit_length(most.raw()) + 29 - (Rough::bits - 1), 0);
    for (std::size_t m = 0; m < 3; ++m) {
      axes_[m] = box_.rotation.axis(static_cast<int>(m)).vec();
      edges_[m] = make_vec<3>([&](int i) { return edge_of<Place>(extent(m), axes_[m][i]); });
      rough_edges_[m] = rough(edges_[m]);
    }
    for (std::size_t k = 0; k < size_; ++k) rough_hull_.set(k, rough(from_center(k)));
  }

  /// Proposes a feature: GJK (see gjk.hpp) on rounded numbers. `yes` if the bodies surely overlap,
  /// `no` if they are probably apart.
  [[nodiscard]] constexpr Filtered find() noexcept {
    if (!fits_) return Filtered::unsure;
    const int count = propose_feature(
        names_, rough_hull_[0], [&](const RoughVec& v) { return least_along(v); },
        [&](const Name& name) { return rough_corner(name); });
    if (count > 3) return encloses_origin() ? Filtered::yes : Filtered::unsure;
    count_ = count;
    return count > 0 && name_feature() ? Filtered::no : Filtered::unsure;
  }

  /// The closest points of the box and the hull, rounded to nearest, if `find` returned `no`.
  [[nodiscard]] constexpr Decided<Points> closest_points() const noexcept {
    if (count_ == 1) return points_of_corner();
    if (count_ == 2) return free_count_ == 1 ? points_of_axis() : points_of_hull_edge();
    if (free_count_ == 2) return points_of_face(axes_[free_[0]], axes_[free_[1]]);
    if (free_count_ == 1) return points_of_face(axes_[free_[0]], hull_edge(1));
    return points_of_face(hull_edge(1), hull_edge(2));
  }

  /// The common point of the box and a triangle that meet, as `common_point` chooses it, by heights
  /// over the triangle's plane. `enter_box` finds where the first edge of the triangle that meets
  /// the box enters it, or nothing.
  template <class EnterBox>
  [[nodiscard]] constexpr Decided<Vec<S, 3>> common_point_of_triangle(
      bool is_box_first, const EnterBox& enter_box) const noexcept {
    using Point = Decided<Vec<S, 3>>;
    constexpr Point unsure{{}, false};
    const auto to = [&](std::size_t k) { return narrow<Edge::bits>(hull_[k] - hull_[0]); };
    const auto n = narrow_cross<61>(to(1), to(2));
    // No corner of the box is in the plane.
    std::array<Height, 4> terms;
    for (std::size_t m = 0; m < 3; ++m) terms[m] = narrow_dot<122>(n, edges_[m]);
    terms[3] = narrow_dot<122>(n, from_center(0));
    std::array<Height, 8> heights;
    for (std::size_t c = 0; c < 8; ++c) {
      auto& height = heights[c] = terms[3];
      for (std::size_t m = 0; m < 3; ++m) {
        height = is_upper(c, m) ? narrow_sum<122>(height, terms[m])
                                : narrow_difference<122>(height, terms[m]);
      }
      if (height == 0) return unsure;
    }
    for (std::size_t k = 0; k < 3; ++k) {
      const auto is_inside = is_in_box(k);
      if (is_inside == Filtered::unsure) return unsure;
      if (is_inside == Filtered::yes) return Point{hull_[k], true};
    }
    if (!is_box_first) {
      if (const auto found = enter_box()) return Point{*found, true};
    }
    for (std::size_t i = 0; i < 8; ++i) {
      for (std::size_t j = i + 1; j < 8; ++j) {
        if ((heights[i] < 0) == (heights[j] < 0)) continue;
        const auto meets = pierces_triangle(i, j);
        if (meets == Filtered::unsure) return unsure;
        if (meets == Filtered::yes) return at_height(i, j, abs(heights[i]), abs(heights[j]));
      }
    }
    if (is_box_first) {
      if (const auto found = enter_box()) return Point{*found, true};
    }
    return unsure;
  }

 private:
  static constexpr std::size_t capacity = 16;
  static constexpr int axis_frac = direction_component<S>::frac;
  static constexpr int frac = S::frac + axis_frac;
  using Half = typename SpannedBox<S>::Half;
  using Reach = Fixed<36, Half::frac>;
  using Axis = Vec<direction_component<S>, 3>;
  using Edge = Fixed<30, S::frac>;  // of the hull
  using Place = Fixed<61, frac>;
  using Spot = Fixed<63, frac>;  // in the world
  using Height = Fixed<122, 2 * S::frac + frac>;
  using Share = Fixed<63, 61>;  // of an edge of the hull
  using Rough = Fixed<28, 0>;
  using RoughVec = Vec<Rough, 3>;
  /// A corner of the difference: bit m of `sides` is set if the box's is on the upper end of axis m.
  struct Name {
    std::size_t sides = 0, hull = 0;
  };

  [[nodiscard]] static constexpr std::size_t at(int i) noexcept {
    return static_cast<std::size_t>(i);
  }
  [[nodiscard]] static constexpr bool is_upper(std::size_t sides, std::size_t m) noexcept {
    return (sides >> m & 1) != 0;
  }
  [[nodiscard]] constexpr const Half& extent(std::size_t m) const noexcept {
    return box_.half_extents[static_cast<int>(m)];
  }
  [[nodiscard]] constexpr std::array<Half, 3> box_extents() const noexcept {
    return {extent(0), extent(1), extent(2)};
  }
  /// From a corner of the hull to the center of the box.
  [[nodiscard]] constexpr Vec<Place, 3> from_center(std::size_t k) const noexcept {
    return make_vec<3>([&](int i) { return Place(narrow<32>(box_.center[i] - hull_[k][i])); });
  }
  [[nodiscard]] constexpr RoughVec rough(const Vec<Place, 3>& v) const noexcept {
    return without_low_bits<Rough>(v, dropped_);
  }
  [[nodiscard]] constexpr Name least_along(const RoughVec& v) const noexcept {
    Name name;
    for (std::size_t m = 0; m < 3; ++m) {
      name.sides |= static_cast<std::size_t>(narrow_dot<60>(v, axes_[m]) < 0) << m;
    }
    auto least = narrow_dot<60>(v, rough_hull_[0]);
    for (std::size_t k = 1; k < size_; ++k) {
      const auto along = narrow_dot<60>(v, rough_hull_[k]);
      if (!(along < least)) continue;
      least = along;
      name.hull = k;
    }
    return name;
  }
  [[nodiscard]] constexpr RoughVec rough_corner(const Name& name) const noexcept {
    return moved<Rough>(rough_hull_[name.hull], rough_edges_, name.sides);
  }
  /// The corner of the box, seen from that of the hull.
  [[nodiscard]] constexpr Vec<Place, 3> corner(const Name& name) const noexcept {
    return moved<Place>(from_center(name.hull), edges_, name.sides);
  }
  [[nodiscard]] constexpr Vec<Spot, 3> corner_of_box() const noexcept {
    return moved<Spot>(make_vec<3>([&](int i) { return Spot(box_.center[i]); }), edges_,
                       names_[0].sides);
  }
  template <Number T, Number E>
  [[nodiscard]] static constexpr Vec<T, 3> moved(Vec<T, 3> center,
                                                 const std::array<Vec<E, 3>, 3>& edges,
                                                 std::size_t sides) noexcept {
    for (std::size_t m = 0; m < 3; ++m) {
      for (int i = 0; i < 3; ++i) {
        center[i] = is_upper(sides, m) ? narrow_sum<T::bits>(center[i], edges[m][i])
                                       : narrow_difference<T::bits>(center[i], edges[m][i]);
      }
    }
    return center;
  }
  /// From the hull's first corner of the feature to another one.
  [[nodiscard]] constexpr Vec<Edge, 3> hull_edge(std::size_t k) const noexcept {
    return to_corner(hull_names_[k]);
  }
  [[nodiscard]] constexpr Vec<Edge, 3> to_corner(std::size_t k) const noexcept {
    return narrow<Edge::bits>(hull_[k] - hull_[hull_names_[0]]);
  }

  /// Whether the simplex of all four corners contains the origin, exactly: see TouchWitness.
  [[nodiscard]] constexpr bool encloses_origin() const noexcept {
    const auto c0 = corner(names_[0]), c1 = corner(names_[1]);
    const auto c2 = corner(names_[2]), c3 = corner(names_[3]);
    const auto same_sign = [](const auto&... weight) {
      return ((weight >= 0) && ...) != ((weight <= 0) && ...);
    };
    const auto first = cross(c0, c1), last = cross(c2, c3);
    return same_sign(dot(last, c1), narrow_negative(dot(last, c0)), dot(first, c3),
                     narrow_negative(dot(first, c2)));
  }

  /// Finds the axes and corners of the feature. False if there are too many.
  [[nodiscard]] constexpr bool name_feature() noexcept {
    std::size_t differ = 0;
    hull_count_ = 0;
    for (int i = 0; i < count_; ++i) {
      differ |= names_[at(i)].sides ^ names_[0].sides;
      bool is_new = true;
      for (std::size_t k = 0; k < hull_count_; ++k) {
        is_new = is_new && hull_names_[k] != names_[at(i)].hull;
      }
      if (is_new) hull_names_[hull_count_++] = names_[at(i)].hull;
    }
    free_count_ = 0;
    for (std::size_t m = 0; m < 3; ++m) {
      if (!is_upper(differ, m)) continue;
      if (free_count_ == 2) return false;
      free_[free_count_++] = m;
    }
    return free_count_ + hull_count_ == at(count_);
  }
  [[nodiscard]] constexpr bool is_free(std::size_t m) const noexcept {
    return (free_count_ > 0 && m == free_[0]) || (free_count_ > 1 && m == free_[1]);
  }
  /// Whether the difference is least far along v, whose components are off by less than `error`, only
  /// in the feature.
  template <Number V>
  [[nodiscard]] constexpr bool is_least_along(const Vec<V, 3>& v, const V& error) const noexcept {
    bool is_least = true;
    for (std::size_t m = 0; m < 3; ++m) {
      const auto along = narrow_dot<93>(v, axes_[m]);
      const auto limit = error * Fixed<2, 0>(2);  // an axis has less than 2 in all
      const bool is_less = is_upper(names_[0].sides, m) ? along < -limit : along > limit;
      is_least = is_least && (is_less || is_free(m) || extent(m) == 0);
    }
    for (std::size_t k = 0; k < size_ && is_least; ++k) {
      bool is_in_feature = false;
      for (std::size_t i = 0; i < hull_count_; ++i) {
        is_in_feature = is_in_feature || k == hull_names_[i];
      }
      if (is_in_feature) continue;
      const auto step = to_corner(k);
      const auto limit = error * narrow<32>(sum_of_magnitudes(step));
      is_least = narrow_dot<93>(v, step) < -limit || is_zero(step);
    }
    return is_least;
  }

  /// from + step(i) for coordinate i, off by less than `Error` steps, rounded.
  template <int Error, class Step>
  static constexpr Vec<S, 3> rounded(const Vec<Spot, 3>& from, const Step& step,
                                     bool& is_sure) noexcept {
    return make_vec<3>([&](int i) {
      const auto x = narrow_sum<Spot::bits>(from[i], step(i));
      const auto nearest = decide_coordinate<S>(Approximate{x, Steps<Error>()});
      is_sure = is_sure && nearest.is_sure;
      return nearest.value;
    });
  }
  [[nodiscard]] constexpr Vec<S, 3> on_box() const noexcept {
    return nearest_to<S>(corner_of_box());
  }
  [[nodiscard]] constexpr Vec<S, 3> on_hull() const noexcept { return hull_[hull_names_[0]]; }

  [[nodiscard]] constexpr Decided<Points> points_of_corner() const noexcept {
    return {{on_box(), on_hull()}, is_least_along(corner(names_[0]), Place(0))};
  }

  /// Whether v, off by less than 2^10 steps, is not 0, and least only in the feature.
  [[nodiscard]] constexpr bool is_sure_along(const Vec<Place, 3>& v) const noexcept {
    constexpr auto least = Place::from_raw(1 << 12);
    const bool is_long = abs(v.x) > least || abs(v.y) > least || abs(v.z) > least;
    return is_long && is_least_along(v, Place::from_raw(1 << 10));
  }

  // As an edge of two boxes: see BoxWitness.
  [[nodiscard]] constexpr Decided<Points> points_of_axis() const noexcept {
    constexpr Decided<Points> unsure{Points(), false};
    const auto& e = axes_[free_[0]];
    const auto x = corner(names_[0]);
    const auto excess = narrow_dot<61>(e, e) - Fixed<61, 2 * axis_frac>(1);
    if (!fits<33>(excess)) return unsure;
    // 1 / (1 + excess) is nearly 1 - excess.
    const auto along = narrow_floor<Fixed<62, frac>>(narrow_dot<92>(x, e));
    const auto t = narrow<62>(along - narrow_floor<Fixed<36, frac>>(along * narrow<33>(excess)));
    if (!is_along_axis(Spot(t), 0)) return unsure;
    const auto step = [&](int i) { return narrow_floor<Fixed<62, frac>>(t * e[i]); };
    const auto v = make_vec<3>([&](int i) { return narrow_difference<61>(x[i], step(i)); });
    if (!is_sure_along(v)) return unsure;
    Decided<Points> result{Points(), true};
    result.value.first = rounded<1 << 11>(
        corner_of_box(), [&](int i) { return narrow_negative(step(i)); }, result.is_sure);
    result.value.second = on_hull();
    return result;
  }
  /// Whether a point t back along free axis k from the corner is surely between the ends.
  [[nodiscard]] constexpr bool is_along_axis(const Spot& t, std::size_t k) const noexcept {
    constexpr auto error = Place::from_raw(1 << 12);
    const auto& half = extent(free_[k]);
    const auto end = half + half;
    return is_upper(names_[0].sides, free_[k]) ? t > error && t + error < end
                                               : t < -error && -t + error < end;
  }

  [[nodiscard]] constexpr Decided<Points> points_of_hull_edge() const noexcept {
    const auto e = hull_edge(1);
    const auto x = corner(names_[0]);
    using Over = Fixed<93, frac + S::frac>;
    const Over over(narrow_dot<93>(x, e)), under(narrow_dot<62>(e, e));
    if (!(over > 0 && over < under)) return {Points(), false};
    const auto ratio = make_ratio_below_one(over, under);
    const auto v = make_vec<3>([&](int i) {
      return narrow_difference<61>(x[i],
                                   narrow_floor<Fixed<61, frac>>(ratio.quotient.value * e[i]));
    });
    if (!is_sure_along(v)) return {Points(), false};
    const auto from = on_hull();
    return {
        {on_box(), make_vec<3>([&](int i) { return nearest_between<S>(from[i], e[i], ratio); })},
        true};
  }

  /// Whether a corner of the hull is in the box, exactly: its coordinates in the frame of the box, by
  /// the normals of the faces, are at most the half extents times the determinant. See lemma 23.
  [[nodiscard]] constexpr Filtered is_in_box(std::size_t corner) const noexcept {
    const auto apart =
        make_vec<3>([&](int i) { return narrow<32>(hull_[corner][i] - box_.center[i]); });
    const auto volume = abs(narrow_dot<92>(narrow_cross<61>(axes_[1], axes_[2]), axes_[0]));
    if (volume == 0) return Filtered::unsure;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto normal = narrow_cross<61>(axes_[(k + 1) % 3], axes_[(k + 2) % 3]);
      if (abs(narrow_dot<93>(normal, apart)) > narrow_product<124>(extent(k), volume))
        return Filtered::no;
    }
    return Filtered::yes;
  }

  /// Whether the segment between two corners of the box, on different sides of the triangle's plane,
  /// pierces the triangle: it passes all edges on the same side. Differences are rounded down to 40
  /// bits, so a volume is off by less than 2^86.
  [[nodiscard]] constexpr Filtered pierces_triangle(std::size_t i, std::size_t j) const noexcept {
    using Cut = Fixed<41, 0>;
    const int dropped = (std::max)(dropped_ - 12, 0);
    const auto cut = [dropped](const Vec<Place, 3>& v) {
      return without_low_bits<Cut>(v, dropped);
    };
    std::array<Vec<Cut, 3>, 3> to;
    for (std::size_t k = 0; k < 3; ++k) to[k] = cut(corner({i, k}));
    const auto e = cut(make_vec<3>([&](int axis) {
      return narrow_difference<61>(corner({j, 0})[axis], corner({i, 0})[axis]);
    }));
    constexpr auto error = Fixed<88, 0>::from_raw(typename Fixed<88, 0>::raw_type(1) << 86);
    int positive = 0, negative = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto volume = narrow_dot<125>(e, narrow_cross<83>(to[k], to[k == 2 ? 0 : k + 1]));
      positive += volume > error;
      negative += volume < -error;
    }
    if (positive > 0 && negative > 0) return Filtered::no;
    return positive == 3 || negative == 3 ? Filtered::yes : Filtered::unsure;
  }
  /// Where that segment is in the plane, given the heights of its ends, rounded to nearest.
  [[nodiscard]] constexpr Decided<Vec<S, 3>> at_height(std::size_t i, std::size_t j,
                                                       const Height& start,
                                                       const Height& end) const noexcept {
    const auto ratio = make_ratio_below_one(start, narrow_sum<122>(start, end));
    const auto center = make_vec<3>([&](int k) { return Spot(box_.center[k]); });
    const auto p = moved<Spot>(center, edges_, i), q = moved<Spot>(center, edges_, j);
    return decide_each<S, 3>(
        [&](int k) { return decide_between<S>(p[k], narrow_difference<63>(q[k], p[k]), ratio); });
  }

  // A face with the edges e and f, each an axis of the box or an edge of the hull. The closest
  // difference is along n = e x f, and it is x - s e - t f for s = x.(f x n) / (n.n) and
  // t = x.(n x e) / (n.n).
  template <Number E, Number F>
  [[nodiscard]] constexpr Decided<Points> points_of_face(const Vec<E, 3>& e,
                                                         const Vec<F, 3>& f) const noexcept {
    constexpr Decided<Points> unsure{Points(), false};
    constexpr bool is_axis_e = E::frac == axis_frac && std::is_same_v<E, direction_component<S>>;
    constexpr bool is_axis_f = std::is_same_v<F, direction_component<S>>;
    const auto x = corner(names_[0]);
    const auto n = narrow_cross<61>(e, f);
    const auto height = narrow_dot<122>(n, x);
    const auto whole = narrow_dot<123>(n, n);
    const auto squares = narrow_dot<62>(e, e) * narrow_dot<62>(f, f);
    if (height == 0 || whole.raw() < shift_right_floor(squares.raw(), 8)) return unsure;
    using Normal = std::remove_cvref_t<decltype(n)>;
    const Normal v = height < 0 ? narrow_negative(n) : n;
    if (!is_least_along(v, decltype(n.x)(0))) return unsure;
    const auto part = Leading(Fixed<2, 0>(1)) / Leading(whole);
    // x.w / (n.n), in the unit of the result.
    const auto share = [&]<class Result>(const auto& w, const Result&) {
      const int dropped = (std::max)(longest_bits(w) - 60, 0);
      using W = std::remove_cvref_t<decltype(w.x)>;
      const auto over = narrow_dot<124>(x, without_low_bits<Fixed<61, W::frac>>(w, dropped));
      Leading leading(abs(over));
      leading.exponent += dropped;
      const auto magnitude = Result::assume_raw((leading * part).template scaled<Result::frac>());
      return over < 0 ? narrow_negative(magnitude) : magnitude;
    };
    const auto s = share(cross(f, n), std::conditional_t<is_axis_e, Spot, Share>());
    const auto t = share(cross(n, e), std::conditional_t<is_axis_f, Spot, Share>());
    constexpr auto margin = Share::from_raw(typename Share::raw_type{1} << 41);
    constexpr Share one(1);
    if constexpr (is_axis_e) {
      if (!is_along_axis(s, 0)) return unsure;
    } else {
      if (!(s > margin && t > margin && s < one && t < one && s + t + margin < one)) return unsure;
    }
    if constexpr (is_axis_f) {
      if (!is_along_axis(t, 1)) return unsure;
    } else {
      if (!(t > margin && t + margin < one)) return unsure;
    }
    const auto along = [](const auto& part_of, const auto& edge) {
      return narrow_floor<Fixed<62, frac>>(part_of * edge);
    };
    constexpr int error = 1 << 13;
    Decided<Points> result{Points(), true};
    auto& [p, q] = result.value;
    const auto from = make_vec<3>([&](int i) { return Spot(on_hull()[i]); });
    if constexpr (is_axis_f) {
      p = rounded<error>(
          corner_of_box(), [&](int i) { return narrow<62>(-along(s, e[i]) - along(t, f[i])); },
          result.is_sure);
      q = on_hull();
    } else if constexpr (is_axis_e) {
      p = rounded<error>(
          corner_of_box(), [&](int i) { return narrow_negative(along(s, e[i])); }, result.is_sure);
      q = rounded<error>(
          from, [&](int i) { return along(t, f[i]); }, result.is_sure);
    } else {
      p = on_box();
      q = rounded<error>(
          from, [&](int i) { return narrow<62>(along(s, e[i]) + along(t, f[i])); }, result.is_sure);
    }
    return result;
  }

  SpannedBox<S> box_;
  std::size_t size_ = 0;
  bool fits_ = false;
  VecList<S, 3, capacity> hull_;
  std::array<Axis, 3> axes_;
  std::array<Vec<Place, 3>, 3> edges_;
  int dropped_ = 0;
  std::array<RoughVec, 3> rough_edges_;
  VecList<Rough, 3, capacity> rough_hull_;
  int count_ = 0;
  std::array<Name, 4> names_{};  // of the feature's corners
  std::array<std::size_t, 2> free_{};
  std::array<std::size_t, 3> hull_names_{};
  std::size_t free_count_ = 0, hull_count_ = 0;
};

/// The corners of a triangle or a hull.
template <Scalar S>
[[nodiscard]] constexpr auto hull_corners(const Triangle<S, 3>& triangle) noexcept {
  return std::array{triangle.a, triangle.b, triangle.c};
}
template <Scalar S>
[[nodiscard]] constexpr auto hull_corners(const ConvexHull<S, 3>& hull) noexcept {
  return hull.points;
}

/// Whether to search the closest points of two shapes by such a witness.
template <class A, class B>
inline constexpr bool has_box_hull_witness = false;
template <Scalar S>
inline constexpr bool has_box_hull_witness<Obb<S, 3>, Triangle<S, 3>> =
    is_fixed<S>&& filter_pays<S>;
template <Scalar S>
inline constexpr bool has_box_hull_witness<Obb<S, 3>, ConvexHull<S, 3>> =
    is_fixed<S>&& filter_pays<S>;

}  // namespace detent::detail
