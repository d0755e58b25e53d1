// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <utility>

#include "detent/math/components.hpp"
#include "detent/number/fraction.hpp"
#include "detent/number/patience.hpp"
#include "detent/query/kernel/pivot.hpp"
#include "detent/shape/ray.hpp"

namespace detent::detail {

/// Finds N points of a hull whose simplex (a triangle, in 2D a segment) a ray's line stabs, then
/// the first or last such simplex.
///
/// This is a linear program: find nonnegative weights of the points, with the sum 1, that give the
/// point of the line at the least distance. A basis has N columns: points and, initially,
/// directions across the line as slack variables. Points enter and columns leave by the rule of
/// pivot.hpp.
///
/// With w from the ray's origin to a point, the weights of a, b, c are the volumes d . (w_b x w_c),
/// d . (w_c x w_a), d . (w_a x w_b) over their sum.
///
/// `Points` is a span, or has `size()`, `operator[]` and an `entering_point` as in pivot.hpp. `Way`
/// is a direction, or a vector not longer than sqrt(3) in units where a component of 1 fills it.
///
/// source: Dantzig's simplex method
template <Number T, int N, class Points = std::span<const Vec<T, N>>, class Way = Direction<T, N>>
class Stab {
 public:
  using Offset = decltype(Vec<T, N>() - Vec<T, N>());

  /// `points` must not be empty.
  template <Scalar S>
  constexpr Stab(const Ray<S, N>& ray, const Points& points) noexcept
      : Stab(ray.origin, ray.direction, points) {}
  constexpr Stab(const Vec<T, N>& origin, const Way& way, const Points& points) noexcept
      : origin_(origin), direction_(way), points_(points) {
    at(0) = column(0);
    // From the first point towards the line, along each axis except the line's longest.
    const auto& offset = at(0).offset;
    const int k = longest_axis(make_vec<N>([&](int i) { return direction_[i]; }));
    for (int i = 1; i < N; ++i) {
      const int j = (k + i) % N;
      const auto place = offset[j] * direction_[k];
      const auto place_of_line = offset[k] * direction_[j];
      const bool is_beyond = direction_[k] > 0 ? place > place_of_line : place < place_of_line;
      at(i) = {Offset(), no_point};
      at(i).offset[j] = decltype(offset.x)(is_beyond ? -1 : 1);
    }
    orient();
  }

  /// Whether the line meets the hull. If so, the basis then consists of points, except for
  /// directions across the line in which the hull has no extent.
  [[nodiscard]] constexpr bool meets() noexcept {
    descend([this] { return lack(); });
    const auto weight = weights();
    for (int i = 0; i < N; ++i) {
      if (!is_point(i) && weight[index(i)] > 0) return false;
    }
    while (replace_direction()) {
    }
    return true;
  }

  /// Moves to the first or the last simplex that the line stabs.
  constexpr void go_to_first() noexcept {
    descend([this] { return normal(); });
  }
  constexpr void go_to_last() noexcept {
    descend([this] { return narrow_negative(normal()); });
  }

  /// The distance along the ray, of either sign, at which its line stabs the simplex.
  [[nodiscard]] constexpr auto distance() const noexcept {
    const auto along = normal();
    return Fraction{dot(along, at(point()).offset), dot(along, direction_)};
  }

  /// Whether the simplex is part of a face.
  [[nodiscard]] constexpr bool is_face() const noexcept {
    for (int i = 0; i < N; ++i) {
      if (!is_point(i)) return false;
    }
    return true;
  }

  /// The index of the point in column i of the basis.
  [[nodiscard]] constexpr PointIndex index_of(int i) const noexcept { return at(i).index; }

  /// A vector perpendicular to the basis, pointing along the ray.
  [[nodiscard]] constexpr auto normal() const noexcept {
    const int i = point();
    if constexpr (N == 2) {
      const auto e = edge(1 - i);
      const Vec across{narrow_negative(e.y), e.x};
      return i == 0 ? across : narrow_negative(across);
    } else {
      return cross(edge((i + 1) % 3), edge((i + 2) % 3));
    }
  }

  /// The negated vector along which points reduce the slack of the basis. If the line does not meet
  /// the hull, all points are farther along it than the line.
  [[nodiscard]] constexpr auto lack() const noexcept {
    using Sum = decltype(this->gradient(0) + this->gradient(0));
    constexpr int bits = bits_of<decltype(Sum::x)>;
    Sum sum;
    for (int i = 0; i < N; ++i) {
      if (!is_point(i)) sum = narrow<bits>(sum - gradient(i));  // at most two of them
    }
    return sum;
  }

 private:
  /// A point relative to the ray's origin, or a direction across the line.
  struct Column {
    Offset offset;
    PointIndex index = no_point;
  };

  static constexpr std::size_t index(int i) noexcept { return static_cast<std::size_t>(i); }
  [[nodiscard]] constexpr Column& at(int i) noexcept { return basis_[index(i)]; }
  [[nodiscard]] constexpr const Column& at(int i) const noexcept { return basis_[index(i)]; }
  [[nodiscard]] constexpr decltype(auto) point_at(PointIndex i) const noexcept {
    return points_[static_cast<std::size_t>(i)];
  }
  [[nodiscard]] constexpr Column column(PointIndex i) const noexcept {
    return {point_at(i) - origin_, i};
  }
  [[nodiscard]] constexpr bool is_point(int i) const noexcept { return at(i).index != no_point; }

  /// The first column that is a point. There is one, because the weights of points have the sum 1.
  [[nodiscard]] constexpr int point() const noexcept {
    int i = 0;
    while (!is_point(i)) ++i;
    return i;
  }

  /// From the first point of the basis to column i, or column i itself if it is a direction.
  [[nodiscard]] constexpr Offset edge(int i) const noexcept {
    if (!is_point(i)) return at(i).offset;
    return point_at(at(i).index) - point_at(at(point()).index);
  }

  /// d . (v x w), in 2D d x v: the side on which the line passes the edge from v to w, or the
  /// point v.
  [[nodiscard]] constexpr auto side(const Offset& v) const noexcept requires(N == 2) {
    return cross(direction_, v);
  }
  [[nodiscard]] constexpr auto side(const Offset& v, const Offset& w) const noexcept
      requires(N == 3) {
    const auto moment = cross(direction_, v);
    // |d| |v| |w| < 3 2^(2B) (1 + 2^-13) for vectors whose components have B bits.
    constexpr int bits = bits_of<decltype(moment.x)> + bits_of<decltype(w.x)> + 1;
    return narrow_dot<bits>(w, moment);
  }

  /// The weights of the columns, times a common positive factor.
  [[nodiscard]] constexpr auto weights() const noexcept {
    if constexpr (N == 2) {
      return std::array{narrow_negative(side(at(1).offset)), side(at(0).offset)};
    } else {
      return std::array{side(at(1).offset, at(2).offset), side(at(2).offset, at(0).offset),
                        side(at(0).offset, at(1).offset)};
    }
  }

  /// Makes the common factor of the weights, normal . direction, positive.
  constexpr void orient() noexcept {
    if (dot(normal(), direction_) < 0) std::swap(at(N - 2), at(N - 1));
  }

  /// A vector g for a column i that is a direction: if a point p moves by v, the slack of that
  /// direction falls by g . v, times that common factor.
  [[nodiscard]] constexpr auto gradient(int i) const noexcept {
    const int first = point();
    if constexpr (N == 2) {
      const Vec across{direction_[1], narrow_negative(direction_[0])};
      return first == 0 ? across : narrow_negative(across);
    } else {
      const int other = (first + 1) % 3 == i ? (first + 2) % 3 : (first + 1) % 3;
      const auto across = cross(direction_, edge(other));
      return other == (first + 1) % 3 ? across : narrow_negative(across);
    }
  }

  /// Lets points against the vector `gradient_of()` of the basis enter until there is none.
  template <class GradientOf>
  constexpr void descend(const GradientOf& gradient_of) noexcept {
    bool moved = true;
    for (Patience<T> patience; patience.step();) {
      const auto& from = point_at(at(point()).index);
      const auto entering = entering_point(points_, gradient_of(), from, !moved);
      if (entering == no_point) return;
      moved = enter(entering);
    }
  }

  /// Adds a point to the basis. Returns whether that changed where the line stabs it.
  constexpr bool enter(PointIndex entering) noexcept {
    const auto added = column(entering);
    const auto weight = weights();
    Pivot<typename decltype(weight)::value_type, N> pivot{weight, {}, {}};
    for (int i = 0; i < N; ++i) {
      pivot.indices[index(i)] = at(i).index;
      if constexpr (N == 2) {
        const auto passed = side(added.offset);
        pivot.sides[index(i)] = i == 0 ? narrow_negative(passed) : passed;
      } else {
        pivot.sides[index(i)] = side(added.offset, at(i).offset);
      }
    }
    const int leaving = pivot.leaving();
    if (leaving == N) return false;
    at(leaving) = added;
    return weight[index(leaving)] > 0;
  }

  /// Replaces a direction of weight 0 by a point that needs it. Returns whether it did.
  constexpr bool replace_direction() noexcept {
    for (int i = 0; i < N; ++i) {
      if (is_point(i)) continue;
      const auto across = gradient(i);
      const auto& from = point_at(at(point()).index);
      for (PointIndex p = 0; p < static_cast<PointIndex>(points_.size()); ++p) {
        if (dot(across, point_at(p) - from) == 0) continue;
        at(i) = column(p);
        orient();
        return true;
      }
    }
    return false;
  }

  Vec<T, N> origin_;
  Way direction_;
  Points points_;
  std::array<Column, static_cast<std::size_t>(N)> basis_{};
};

/// The distance at which a ray enters a hull, rounded down, and whether it is 0 because the ray
/// starts inside.
template <Scalar S>
struct HullEntry {
  S distance;
  bool starts_inside;
};

/// Where a ray enters the hull of the points in `stab`. Leaves `stab` at the simplex that the ray
/// enters through, unless the ray starts inside.
template <Scalar S, class Stab>
[[nodiscard]] constexpr std::optional<HullEntry<S>> entry(Stab& stab, const S& limit) noexcept {
  if (limit < 0 || !stab.meets()) return std::nullopt;
  stab.go_to_first();
  const auto enter = stab.distance();
  if (enter.numerator > 0) {
    const auto distance = floor_within(enter, limit);
    if (!distance) return std::nullopt;
    return HullEntry<S>{*distance, false};
  }
  stab.go_to_last();
  if (stab.distance().numerator < 0) return std::nullopt;
  return HullEntry<S>{S(0), true};
}

}  // namespace detent::detail
