// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>

#include "detent/math/direction.hpp"
#include "detent/number/next_up.hpp"

namespace detent::detail {

/// The translations x with dot(x, normal) >= offset: those that keep a character in front of a
/// plane.
template <Scalar S, int N>
struct HalfSpace {
  Direction<S, N> normal;
  S offset{};
};

/// The point closest to `to` on the boundary of a half-space: the exact one for the normal as
/// stored, rounded to nearest. If the normal counted as a unit vector, the point would be off by
/// units where `to` is long.
template <Scalar S, int N>
[[nodiscard]] constexpr Vec<S, N> closest_on(const Vec<S, N>& to,
                                             const HalfSpace<S, N>& a) noexcept {
  const auto by = a.offset - dot(to, a.normal);
  const auto squared = squared_length(a.normal.vec());
  return make_vec<N>(
      [&](int i) { return quotient_nearest<S>(to[i] * squared + by * a.normal[i], squared); });
}

/// The point on the boundaries of two half-spaces, or nothing if they are parallel.
template <Scalar S>
[[nodiscard]] constexpr std::optional<Vec<S, 2>> closest_on(const Vec<S, 2>&,
                                                            const HalfSpace<S, 2>& a,
                                                            const HalfSpace<S, 2>& b) noexcept {
  const auto& m = a.normal;
  const auto& n = b.normal;
  const auto area = narrow_cross<cosine_bits<S>>(m.vec(), n.vec());
  if (area == 0) return std::nullopt;
  return Vec<S, 2>{quotient_nearest<S>(a.offset * n[1] - b.offset * m[1], area),
                   quotient_nearest<S>(b.offset * m[0] - a.offset * n[0], area)};
}

/// The point closest to `to` on the line in which the boundaries of two half-spaces meet, or
/// nothing if they are parallel. The exact one for the normals as stored, rounded to nearest.
///
/// source: Cramer's rule for dot(x, m) = a.offset, dot(x, n) = b.offset, dot(x, u) = dot(to, u),
///         where u = m x n
template <Scalar S>
[[nodiscard]] constexpr std::optional<Vec<S, 3>> closest_on(const Vec<S, 3>& to,
                                                            const HalfSpace<S, 3>& a,
                                                            const HalfSpace<S, 3>& b) noexcept {
  const auto& m = a.normal.vec();
  const auto& n = b.normal.vec();
  const auto u = narrow_cross<cosine_bits<S>>(m, n);
  const auto squared = squared_length(u);
  if (squared == 0) return std::nullopt;
  const auto along = u * dot(to, u);
  const auto from_a = cross(n, u) * a.offset, from_b = cross(u, m) * b.offset;
  return make_vec<3>(
      [&](int i) { return quotient_nearest<S>(along[i] + from_a[i] + from_b[i], squared); });
}

/// The point on the boundaries of three half-spaces, or nothing if it is not unique.
template <Scalar S>
[[nodiscard]] constexpr std::optional<Vec<S, 3>> corner_of(const HalfSpace<S, 3>& a,
                                                           const HalfSpace<S, 3>& b,
                                                           const HalfSpace<S, 3>& c) noexcept {
  const auto bc = narrow_cross<cosine_bits<S>>(b.normal.vec(), c.normal.vec());
  const auto ca = narrow_cross<cosine_bits<S>>(c.normal.vec(), a.normal.vec());
  const auto ab = narrow_cross<cosine_bits<S>>(a.normal.vec(), b.normal.vec());
  const auto volume = dot(a.normal.vec(), bc);
  if (volume == 0) return std::nullopt;
  return make_vec<3>([&](int i) {
    return quotient_nearest<S>(bc[i] * a.offset + ca[i] * b.offset + ab[i] * c.offset, volume);
  });
}

/// Some planes, as half-spaces of translations from the character's position: those met during a
/// move, or those of what it overlaps.
template <Scalar S, int N>
class HalfSpaces {
 public:
  static constexpr std::size_t capacity = 8;

  /// Of planes with the same normal the farthest is kept, and of all planes the first `capacity`.
  constexpr void add(const Direction<S, N>& normal, const S& offset) noexcept {
    for (std::size_t i = 0; i < count_; ++i) {
      if (list_[i].normal != normal) continue;
      list_[i].offset = (std::max)(list_[i].offset, offset);
      return;
    }
    if (count_ < capacity) list_[count_++] = {normal, offset};
  }

  /// The same, but the planes with the greatest offsets are kept, in this order, and then in that of
  /// their normals: so the order of these calls does not matter.
  constexpr void add_sorted(const Direction<S, N>& normal, const S& offset) noexcept {
    const HalfSpace<S, N> added{normal, offset};
    std::size_t old = 0;  // of this normal, or the last one
    while (old < count_ && list_[old].normal != normal) ++old;
    if (old < count_) {
      if (offset <= list_[old].offset) return;
    } else if (count_ < capacity) {
      ++count_;
    } else if (!is_before(added, list_[--old])) {
      return;
    }
    for (; old > 0 && is_before(added, list_[old - 1]); --old) list_[old] = list_[old - 1];
    list_[old] = added;
  }

  /// Translates the character by `by`: offsets change with it, rounded up. Planes farther away than
  /// `reach` are dropped: they may belong to an object that it has passed.
  constexpr void shift(const Vec<S, N>& by, const S& reach) noexcept {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < count_; ++i) {
      auto space = list_[i];
      space.offset = ceil_to<S>(space.offset - dot(by, space.normal));
      if (space.offset + reach >= 0) list_[kept++] = space;
    }
    count_ = kept;
  }

  /// The greatest offset, at least 0: no shorter translation is in all half-spaces.
  [[nodiscard]] constexpr S greatest_offset() const noexcept {
    S greatest(0);
    for (std::size_t i = 0; i < count_; ++i) greatest = (std::max)(greatest, list_[i].offset);
    return greatest;
  }

  /// The translation in all half-spaces, or outside by at most `slack`, that is closest to `to`; of
  /// several, the first in order of planes. Nothing if there is none. `to` itself may only be outside
  /// by rounding: otherwise short motions would end in front of a plane instead of along it.
  ///
  /// It is the projection of `to` onto a polyhedron: `to` itself, or a point on one plane, on a
  /// crease of two or in a corner of three. All of them are tried.
  ///
  /// source: b2SolvePlanes of Box2D 3.1 solves the same problem by iteration; clipping against
  ///         creases, Quake, PM_SlideMove (pmove.c)
  [[nodiscard]] constexpr std::optional<Vec<S, N>> closest(const Vec<S, N>& to,
                                                           const S& slack) const noexcept {
    const S least = (std::max)(quotient_floor<S>(slack, as_operand<S>(1024)), next_up(S(0)));
    if (contain(to, least)) return to;
    Best best{*this, to, slack, std::nullopt};
    for (std::size_t i = 0; i < count_; ++i) {
      // A violated plane whose closest point is in all other half-spaces is the only active one.
      if (!is_in(to, list_[i], least) && best.offer(closest_on(to, list_[i]))) return best.point;
    }
    for (std::size_t i = 0; i < count_; ++i) {
      for (std::size_t j = 0; j < i; ++j) best.offer(closest_on(to, list_[j], list_[i]));
    }
    if constexpr (N == 3) {
      for (std::size_t i = 0; i < count_; ++i) {
        for (std::size_t j = 0; j < i; ++j) {
          for (std::size_t k = 0; k < j; ++k) best.offer(corner_of(list_[k], list_[j], list_[i]));
        }
      }
    }
    return best.point;
  }

 private:
  struct Best {
    const HalfSpaces& spaces;
    const Vec<S, N>& to;
    const S& slack;
    std::optional<Vec<S, N>> point;

    constexpr bool offer(const std::optional<Vec<S, N>>& x) noexcept {
      if (!x || !spaces.contain(*x, slack)) return false;
      if (!point || squared_distance(*x, to) < squared_distance(*point, to)) point = x;
      return true;
    }
  };

  static constexpr bool is_before(const HalfSpace<S, N>& a, const HalfSpace<S, N>& b) noexcept {
    if (a.offset != b.offset) return a.offset > b.offset;
    for (int i = 0; i < N; ++i) {
      if (a.normal[i] != b.normal[i]) return a.normal[i] < b.normal[i];
    }
    return false;
  }

  static constexpr bool is_in(const Vec<S, N>& x, const HalfSpace<S, N>& space,
                              const S& slack) noexcept {
    return dot(x, space.normal) + slack >= space.offset;
  }
  constexpr bool contain(const Vec<S, N>& x, const S& slack) const noexcept {
    for (std::size_t i = 0; i < count_; ++i) {
      if (!is_in(x, list_[i], slack)) return false;
    }
    return true;
  }

  std::array<HalfSpace<S, N>, capacity> list_{};
  std::size_t count_ = 0;
};

}  // namespace detent::detail
