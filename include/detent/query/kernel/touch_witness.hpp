// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <type_traits>
#include <utility>

#include "detent/math/width.hpp"
#include "detent/number/filter/filtered.hpp"
#include "detent/number/next_up.hpp"
#include "detent/query/kernel/convex_body.hpp"
#include "detent/query/kernel/gjk.hpp"
#include "detent/query/kernel/planar_search.hpp"
#include "detent/query/kernel/rounded_point.hpp"
#include "detent/query/kernel/simplex.hpp"
#include "detent/query/kernel/support.hpp"

// The first touch of round bodies by witnesses: a direction along which they are still apart, and
// two points that are close enough one step later. Both are checked exactly, so a search in short
// rounded numbers may propose them (docs/filters.md, lemma 13).

namespace detent::detail {

/// The leading bits of a vector's components, each with the same number of low bits dropped.
template <int Bits, Number V, int N>
[[nodiscard]] constexpr auto shortened(const Vec<V, N>& v) noexcept {
  if constexpr (bits_of<V> <= Bits) {
    return v;
  } else {
    const int dropped = (std::max)(longest_bits(v) - Bits, 0);
    return make_vec<N>([&](int i) { return scale_down<Bits>(v[i], dropped); });
  }
}

/// Whether a body is a point, or a box along the axes.
template <class Body>
inline constexpr bool is_point = false;
template <Number S, int N>
inline constexpr bool is_point<HullBody<S, N, std::array<Vec<S, N>, 1>>> = true;
template <class Body>
inline constexpr bool is_aligned_box = false;
template <Number S, int N>
inline constexpr bool is_aligned_box<AabbBody<S, N>> = true;

/// Finds the first touch, within a radius, of the body `a`, moving along `way`, and the body `b`.
template <class A, class B, Number W, Scalar S, Number R>
class TouchWitness {
 public:
  static constexpr int dimension = A::dimension;
  using Way = Vec<W, dimension>;
  using Corner = decltype(std::declval<const B&>().some() - std::declval<const A&>().some());
  using Component = std::remove_cvref_t<decltype(Corner().x)>;

  constexpr TouchWitness(const A& a, const B& b, const Way& way, const R& radius) noexcept
      : a_(a),
        b_(b),
        way_(way),
        radius_(radius),
        low_(b.low() - a.high()),
        high_(b.high() - a.low()) {}

  /// The first time of at least `time` and at most `limit` at which the bodies are within the
  /// radius, rounded down, or nothing if there is none. Unsure if they are within it at `time`.
  [[nodiscard]] constexpr Decided<std::optional<S>> first(S time, const S& limit) noexcept {
    constexpr Decided<std::optional<S>> unsure{std::nullopt, false};
    for (int i = 0; i < 6; ++i) {
      if (!find(time)) return unsure;
      const auto speed = dot(across_, way_);
      const auto gap = reached_ - radius_ * sqrt_ceil<Norm>(squared_length(across_));
      if (!(gap > speed * time)) return unsure;
      if (!(speed > 0) || gap > speed * limit) return {std::nullopt, true};
      // Until then they are apart along `across_`.
      const S next = quotient_floor<S>(gap, speed);
      if (next < limit && meet_at(next_raw(next), radius_)) return {next, true};
      if (!(next < limit)) return unsure;
      if (!(next > time)) return sharper(time, limit);
      time = next;
    }
    return unsure;
  }

  /// Whether the bodies share a point at the start.
  [[nodiscard]] constexpr Filtered overlap() noexcept {
    return holds_origin(low_, high_) ? overlap_or_closest(true) : Filtered::no;
  }
  /// The same. If the answer is `no`, `found` is probably the closest feature, unless the search
  /// was only `until_apart`.
  [[nodiscard]] constexpr Filtered overlap_or_closest(bool until_apart = false) noexcept {
    if (find(S(0), until_apart)) return reached_ > 0 ? Filtered::no : Filtered::unsure;
    return count_ > dimension && encloses_origin() ? Filtered::yes : Filtered::unsure;
  }

  /// The corner differences of a feature at the start.
  struct Feature {
    std::array<Corner, static_cast<std::size_t>(dimension)> corners;
    int count;

    [[nodiscard]] constexpr bool is_facet() const noexcept { return count == dimension; }
    [[nodiscard]] constexpr auto simplex() const noexcept {
      Simplex<Component, dimension> result;
      for (int k = 0; k < count; ++k) result.add(corners[static_cast<std::size_t>(k)]);
      return result;
    }
  };
  /// The feature that the last search found.
  [[nodiscard]] constexpr Feature found() const noexcept {
    Feature feature{{}, count_};
    for (int k = 0; k < count_; ++k) {
      feature.corners[static_cast<std::size_t>(k)] = corners_[static_cast<std::size_t>(k)];
    }
    return feature;
  }

  /// The feature that contains the closest differences from `time`, for which `first` was sure, to
  /// the next time on the grid; nothing if it is not the same feature throughout.
  ///
  /// That they are on it, and that all others lie behind it, are inequalities linear in time.
  [[nodiscard]] constexpr std::optional<Feature> feature_from(const S& time) const noexcept {
    const Feature feature = found();
    if constexpr (dimension == 2) {
      if (feature.is_facet()) {
        if (!stays_on_edge(feature, time)) return std::nullopt;
        return feature;
      }
    }
    if (!holds_closest(feature, time)) return std::nullopt;
    if (!holds_closest(feature, next_raw(time))) return std::nullopt;
    return feature;
  }

  /// The distance of the bodies at the start, rounded down to the grid of `T`.
  template <Number T>
  [[nodiscard]] constexpr Decided<T> distance_floor() noexcept {
    if (!find_feature(S(0))) return {T(0), count_ > dimension && encloses_origin()};
    // A direction that tilts by e lets the ends of the feature reach nearer by e times its size.
    const auto distance = with_direction(simplex_at<Fixed<40, 0>>(S(0)), [&](const auto& v) {
      const auto u = shortened<44>(v);
      const auto reached = dot(u, least_along(u));
      if (!(reached > 0)) return Decided<T>{T(), false};
      const auto floor = quotient_floor<T>(reached, sqrt_ceil<Fixed<62, 16>>(squared_length(u)));
      return Decided<T>{floor, floor < largest<T>};
    });
    return {distance.value, distance.is_sure && meet_at(S(0), next_raw(distance.value))};
  }

  /// The point of `b` closest to `a` at `time`, rounded to nearest; nothing unless it is simply the
  /// foot of the only closest corner of `a`.
  [[nodiscard]] constexpr std::optional<Vec<S, dimension>> closest_point(const S& time) noexcept {
    std::optional<Vec<S, dimension>> result;
    if (!find_feature(time)) return result;
    const bool is_found = with_closest(found(), time, [&](const auto& v, const auto& point) {
      constexpr int bits = bits_of<std::remove_cvref_t<decltype(a_.some().x)>> + 1;
      const auto foot = a_.template extreme<bits>(v, a_.some(), true);
      bool is_only = true;
      a_.template for_each_extreme<bits>(
          v, a_.some(), true, [&](const auto& corner) { is_only = is_only && corner == foot; });
      if (!is_only) return false;
      const auto p = point();
      result = rounded<S>(RationalPoint{(way_ * time + foot) * p.under + p.over, p.under});
      return true;
    });
    if (!is_found) result.reset();
    return result;
  }

 private:
  static constexpr int across_bits = 28;
  using Rough = Fixed<28, 0>;
  using Norm = Fixed<across_bits + 18, 16>;
  using Moved = decltype(Corner() - Way() * S());
  using Across = Vec<Fixed<across_bits, 0>, dimension>;

  [[nodiscard]] constexpr Moved moved(const Corner& corner, const S& time) const noexcept {
    return corner - way_ * time;
  }
  /// The feature in the bits of T.
  template <class T>
  [[nodiscard]] constexpr Simplex<T, dimension> simplex_at(const S& time) const noexcept {
    std::array<Moved, static_cast<std::size_t>(dimension)> corners;
    int length = 0;
    for (int k = 0; k < count_; ++k) {
      auto& corner = corners[static_cast<std::size_t>(k)];
      corner = moved(corners_[static_cast<std::size_t>(k)], time);
      length = (std::max)(length, longest_bits(corner));
    }
    const int dropped = (std::max)(length - (T::bits - 1), 0);
    Simplex<T, dimension> simplex;
    for (int k = 0; k < count_; ++k) {
      simplex.add(without_low_bits<T>(corners[static_cast<std::size_t>(k)], dropped));
    }
    return simplex;
  }
  template <Number V>
  [[nodiscard]] static constexpr Across across(const Vec<V, dimension>& v) noexcept {
    return shortened<across_bits>(v);
  }

  /// The corner difference that is least along `v`.
  template <Number V>
  [[nodiscard]] constexpr Corner least_along(const Vec<V, dimension>& v) const noexcept {
    constexpr int bits_a = bits_of<std::remove_cvref_t<decltype(a_.some().x)>> + 1;
    constexpr int bits_b = bits_of<std::remove_cvref_t<decltype(b_.some().x)>> + 1;
    return b_.template extreme<bits_b>(v, b_.some(), false) -
           a_.template extreme<bits_a>(v, a_.some(), true);
  }

  /// Calls f(v, point) if the closest difference at `time` lies in a feature: it is the rational
  /// point `point()`, along v. Returns whether it does and f returns true.
  template <class F>
  [[nodiscard]] constexpr bool with_closest(const Feature& feature, const S& time,
                                            const F& f) const noexcept {
    const auto simplex = feature.simplex();
    const auto& corner = simplex.newest();
    const auto place = moved(corner, time);
    const auto is_least_along = [&](const auto& v) {
      const auto least = least_along(v);
      return least == corner || !(dot(v, least) < dot(v, corner));
    };
    if (feature.count == 1) {
      const auto point = [&] { return RationalPoint{place * Rough(1), Rough(1)}; };
      return is_least_along(place) && f(place, point);
    }
    if (feature.count == 2) {
      const auto edge = simplex[0] - corner;
      const auto along = dot(edge, place);
      if (along > 0 || dot(edge, moved(simplex[0], time)) < 0) return false;
      if constexpr (dimension == 3) {
        const auto whole = squared_length(edge);
        const auto v = place * whole - edge * along;
        return is_least_along(v) && f(v, [&] { return RationalPoint{v, whole}; });
      }
    }
    const auto normal = facet_normal(simplex);
    if constexpr (dimension == 3) {
      for (int i = 0; i < 3; ++i) {
        const auto side =
            cross(moved(simplex[(i + 1) % 3], time), moved(simplex[(i + 2) % 3], time));
        if (dot(normal, side) < 0) return false;
      }
    }
    const auto height = dot(normal, place);
    const auto outward = height < 0 ? Vec(-normal) : normal;
    const auto point = [&] { return RationalPoint{normal * height, squared_length(normal)}; };
    if constexpr (dimension == 2) {
      return by_width<61>(is_least_along, outward) && f(outward, point);
    } else {
      return is_least_along(outward) && f(outward, point);
    }
  }
  [[nodiscard]] constexpr bool holds_closest(const Feature& feature, const S& time) const noexcept {
    if constexpr (dimension == 3 && is_point<A> && is_aligned_box<B>) {
      if (const auto holds = is_closest_on_box(feature, time)) return *holds;
    }
    return with_closest(feature, time, [](const auto&, const auto&) { return true; });
  }

  /// `holds_closest` for an edge in the plane, at `time` and the next time on the grid: each
  /// inequality compares a product of the edge and a corner with one of the edge, the way and a time.
  [[nodiscard]] constexpr bool stays_on_edge(const Feature& feature, const S& time) const noexcept {
    const auto simplex = feature.simplex();
    const Corner& corner = simplex.newest();
    return by_width<61>(
        [&](const auto& edge, const auto& from, const auto& to, const auto& normal) {
          const auto speed = dot(edge, way_), sinking = dot(normal, way_);
          const auto first = dot(edge, from), last = dot(edge, to), height = dot(normal, from);
          const auto is_least_along = [&](const auto& v) {
            const auto least = least_along(v);
            return least == corner || !(dot(v, least) < dot(v, corner));
          };
          int side = 0;
          for (const S& t : std::array{time, next_raw(time)}) {
            const auto moved_by = speed * t;
            if (first > moved_by || last < moved_by) return false;
            const int now = height < sinking * t ? -1 : 1;
            if (now == side) continue;
            side = now;
            if (!is_least_along(side < 0 ? Vec(-normal) : normal)) return false;
          }
          return true;
        },
        simplex[0] - corner, corner, simplex[0], facet_normal(simplex));
  }

  /// The same for a point and a corner, an edge or half a face of a box: the inequalities are those
  /// of single coordinates. Nothing for other features.
  [[nodiscard]] constexpr std::optional<bool> is_closest_on_box(const Feature& feature,
                                                                const S& time) const noexcept {
    const auto offset = way_ * time;
    const auto& corner = feature.corners[0];
    std::array<bool, 3> varies{};
    int along = 0, across = 0;  // the number of axes along which the feature extends, and another
    for (int i = 0; i < 3; ++i) {
      bool& does_vary = varies[static_cast<std::size_t>(i)];
      for (int k = 1; k < feature.count; ++k) {
        does_vary = does_vary || feature.corners[static_cast<std::size_t>(k)][i] != corner[i];
      }
      along += does_vary ? 1 : 0;
      if (!does_vary) across = i;
    }
    if (along != feature.count - 1) return std::nullopt;
    if (along == 2) return is_closest_on_face(feature.simplex(), across, offset);
    for (int i = 0; i < 3; ++i) {
      if (varies[static_cast<std::size_t>(i)]) {
        if (low_[i] > offset[i] || high_[i] < offset[i]) return false;
      } else {
        const bool is_before = corner[i] == low_[i] && !(corner[i] < offset[i]);
        const bool is_behind = corner[i] == high_[i] && !(corner[i] > offset[i]);
        if (!is_before && !is_behind) return false;
      }
    }
    return true;
  }
  template <class Triangle, Number O>
  [[nodiscard]] constexpr std::optional<bool> is_closest_on_face(
      const Triangle& triangle, int axis, const Vec<O, 3>& offset) const noexcept {
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    const auto normal = facet_normal(triangle)[axis];
    if (normal == 0) return std::nullopt;
    for (int k = 0; k < 3; ++k) {
      const auto p = triangle[(k + 1) % 3] - offset, q = triangle[(k + 2) % 3] - offset;
      const auto side = p[u] * q[v] - p[v] * q[u];
      if (normal > 0 ? side < 0 : side > 0) return false;
    }
    const auto height = triangle.newest()[axis] - offset[axis];
    const bool faces_up = height > 0 || (height == 0 && normal > 0);
    return triangle.newest()[axis] == (faces_up ? low_ : high_)[axis];
  }

  /// Finds, approximately, the feature that contains the closest difference at `time`, and a
  /// direction across it: GJK (see gjk.hpp) on rounded corners. False if there seems to be none: if
  /// there are more than N corners, they seem to enclose the origin.
  [[nodiscard]] constexpr bool find(const S& time, bool until_apart = false) noexcept {
    if constexpr (dimension == 2) {
      if (has_few(a_) && has_few(b_)) {
        if (!find_in_plane(time)) return false;
        reached_ = dot(across_, least_along(across_));
        return true;
      }
    }
    count_ = 0;
    const int dropped =
        (std::max)((std::max)(longest_bits(moved(low_, time)), longest_bits(moved(high_, time))) -
                       (Rough::bits - 1),
                   0);
    Simplex<Rough, dimension> simplex;
    const auto add = [&](const Corner& corner, const Vec<Rough, dimension>& place) {
      corners_[static_cast<std::size_t>(simplex.count)] = corner;
      simplex.add(place);
    };
    // A corner on the near side.
    const auto low = without_low_bits<Rough>(moved(low_, time), dropped),
               high = without_low_bits<Rough>(moved(high_, time), dropped);
    const Corner first = least_along(across(low + high));
    add(first, without_low_bits<Rough>(moved(first, time), dropped));
    for (int i = 0; i < 24; ++i) {
      const bool is_found = with_direction(simplex, [&](const auto& v) {
        across_ = across(v);
        const Corner corner = least_along(across_);
        reached_ = dot(across_, corner);
        if (until_apart && reached_ > 0) return true;
        const auto place = without_low_bits<Rough>(moved(corner, time), dropped);
        if (!(dot(v, place) < dot(v, simplex.newest()))) return true;
        add(corner, place);
        return false;
      });
      if (is_found) {
        count_ = simplex.count;
        return true;
      }
      const auto all = simplex;
      const auto from = corners_;
      const auto choice = nearest_corners(all);
      count_ = choice.count;
      if (count_ > dimension) return false;
      simplex = {};
      for (int k = 0; k < choice.count; ++k) {
        add(from[static_cast<std::size_t>(choice[k])], all[choice[k]]);
      }
    }
    return false;
  }

  /// Whether `find_in_plane` can list the corners of a body.
  template <class Body>
  [[nodiscard]] static constexpr bool has_few(const Body& body) noexcept {
    return body.corners().size() <= PlanarSearch::most;
  }
  /// `find` without `reached_` for bodies with few corners.
  [[nodiscard]] constexpr bool find_in_plane(const S& time) noexcept {
    const auto& list_a = a_.corners();
    const auto& list_b = b_.corners();
    using Place = PlanarSearch::Place;
    PlanarSearch search;
    const bool is_found = by_width<61>(
        [&](const auto& from, const auto& low, const auto& high) {
          // Differences of corners are between low and high, those within `a` at most twice as long.
          using Difference = std::remove_cvref_t<decltype(low.x)>;
          constexpr int bits = bits_of<Difference> + 1;
          const int dropped = (std::max)((std::max)(longest_bits(low), longest_bits(high)) - 27, 0);
          const auto place = [&](const auto& corner, const auto& origin) {
            // On the grid of `low`, which may be finer than that of the corners.
            return without_low_bits<Place>(make_vec<2>([&](int i) {
                                             return narrow_sum<bits>(
                                                 narrow_difference<bits>(corner[i], origin[i]),
                                                 Difference(0));
                                           }),
                                           dropped);
          };
          for (const auto& corner : list_b) search.b.add(place(corner, from));
          for (const auto& corner : list_a) search.a.add(place(corner, list_a[0]));
          return search.find(narrow<29>(without_low_bits<Place>(low, dropped) +
                                        without_low_bits<Place>(high, dropped)));
        },
        list_a[0] + way_ * time, moved(low_, time), moved(high_, time));
    count_ = search.count();
    for (std::size_t k = 0; k < static_cast<std::size_t>(count_); ++k) {
      corners_[k] = list_b[search.index_b(k)] - list_a[search.index_a(k)];
    }
    across_ = across(search.across());
    return is_found;
  }
  /// `find` without `reached_`, which not every caller needs.
  [[nodiscard]] constexpr bool find_feature(const S& time) noexcept {
    if constexpr (dimension == 2) {
      if (has_few(a_) && has_few(b_)) return find_in_plane(time);
    }
    return find(time);
  }

  /// `first` by the exact direction across the feature that was found at `time`, in more bits: the
  /// ends of a long edge or face need them.
  [[nodiscard]] constexpr Decided<std::optional<S>> sharper(const S& time,
                                                            const S& limit) const noexcept {
    using Result = Decided<std::optional<S>>;
    constexpr int bits = across_bits + 16;
    using Sharp = Fixed<bits, 0>;
    Simplex<std::remove_cvref_t<decltype(Moved().x)>, dimension> simplex;
    for (int k = 0; k < count_; ++k) {
      simplex.add(moved(corners_[static_cast<std::size_t>(k)], time));
    }
    return with_direction(simplex, [&](const auto& exact) -> Result {
      const auto leading = shortened<bits>(exact);
      const auto across = make_vec<dimension>([&](int i) {
        return Sharp::assume_raw(integer_cast<typename Sharp::raw_type>(leading[i].raw()));
      });
      const auto speed = dot(across, way_);
      const auto gap = dot(across, least_along(across)) -
                       radius_ * sqrt_ceil<Fixed<bits + 18, 16>>(squared_length(across));
      if (!(speed > 0) || !(gap > speed * time)) return {std::nullopt, false};
      if (gap > speed * limit) return {std::nullopt, true};
      const S next = quotient_floor<S>(gap, speed);
      if (next < limit && this->meet_at(next_raw(next), radius_)) return {next, true};
      return {std::nullopt, false};
    });
  }

  /// Whether the simplex of all corners contains the origin at the start, exactly: the volumes that
  /// the origin spans with its faces are the origin's weights, times a common factor.
  [[nodiscard]] constexpr bool encloses_origin() const noexcept {
    const auto &c0 = corners_[0], &c1 = corners_[1], &c2 = corners_[2];
    const auto same_sign = [](const auto&... weight) {
      return ((weight >= 0) && ...) != ((weight <= 0) && ...);
    };
    if constexpr (dimension == 2) {
      return same_sign(cross(c1, c2), cross(c2, c0), cross(c0, c1));
    } else {
      const auto& c3 = corners_[3];
      const auto first = cross(c0, c1), last = cross(c2, c3);
      return same_sign(dot(last, c1), narrow_negative(dot(last, c0)), dot(first, c3),
                       narrow_negative(dot(first, c2)));
    }
  }

  /// Whether a difference in the feature is nearer than `radius` at `time`.
  template <Number Radius>
  [[nodiscard]] constexpr bool meet_at(const S& time, const Radius& radius) const noexcept {
    const auto simplex = simplex_at<Rough>(time);
    return with_weights(simplex, [&](const auto& exact) {
      const auto weights = shortened<across_bits>(exact);
      Weighted sum{};
      Fixed<across_bits + 2, 0> whole(0);
      for (int k = 0; k < count_; ++k) {
        const Fixed<across_bits, 0> weight =
            Fixed<across_bits, 0>::assume_raw(integer_cast<std::int32_t>(weights[k].raw()));
        if (weight < 0) return false;
        const auto corner = moved(corners_[static_cast<std::size_t>(k)], time);
        sum = narrow<weighted_bits>(sum + corner * weight);
        whole = narrow<across_bits + 2>(whole + weight);
      }
      return squared_length(sum) < square(radius * whole);
    });
  }

  static constexpr int weighted_bits =
      bits_of<std::remove_cvref_t<decltype(Moved().x)>> + across_bits + 2;
  using Weighted =
      Vec<Fixed<weighted_bits, std::remove_cvref_t<decltype(Moved().x)>::frac>, dimension>;

  /// Calls f(weights) with the weights of the feature's point closest to 0, times a common factor.
  template <class F>
  [[nodiscard]] static constexpr bool with_weights(const Simplex<Rough, dimension>& simplex,
                                                   const F& f) noexcept {
    if (simplex.count == 1) return f(Vec<Rough, dimension>{Rough(1)});
    if (simplex.count == 2) {
      const auto edge = simplex[0] - simplex[1];
      using Weight = decltype(dot(edge, simplex[0]));
      Vec<Weight, dimension> weights{};
      weights[0] = narrow_negative(dot(edge, simplex[1]));
      weights[1] = dot(edge, simplex[0]);
      return f(weights);
    }
    if constexpr (dimension == 3) {
      const auto normal = shortened<across_bits>(facet_normal(simplex));
      return f(make_vec<3>(
          [&](int i) { return dot(normal, cross(simplex[(i + 1) % 3], simplex[(i + 2) % 3])); }));
    } else {
      return false;
    }
  }

  A a_;
  B b_;
  Way way_;
  R radius_;
  Corner low_, high_;
  Across across_{};
  decltype(dot(Across(), Corner())) reached_{};
  std::array<Corner, static_cast<std::size_t>(dimension + 1)> corners_{};
  int count_ = 0;
};

/// The same for bodies that do not move.
template <class A, class B>
using StillWitness = TouchWitness<A, B, Fixed<1, 0>, Fixed<1, 0>, Fixed<1, 0>>;
template <class A, class B>
[[nodiscard]] constexpr auto still_witness(const A& a, const B& b) noexcept {
  return StillWitness<A, B>(a, b, typename StillWitness<A, B>::Way(), Fixed<1, 0>(0));
}

/// Whether such a witness pays before an exact search: one in 3D whose numbers are long.
template <class A, class B>
inline constexpr bool witness_pays =
    has_filters&& A::dimension == 3 &&
    is_fine<std::remove_cvref_t<
        decltype((std::declval<const A&>().some() - std::declval<const B&>().some()).x)>>;

}  // namespace detent::detail
