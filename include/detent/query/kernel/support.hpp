// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <span>

#include "detent/number/filter/filtered.hpp"
#include "detent/shape/hull.hpp"

namespace detent::detail {

// The interface of a convex body for GJK: `some()` is one of its corners, all corners lie between
// `low()` and `high()`, and `extreme<Bits>(v, from, farthest)` is a corner farthest along v, or
// least far if not `farthest`. `for_each_extreme<Bits>(v, from, farthest, f)` passes all such
// corners to f, some possibly twice; all corners if v is 0. A body that scans all its corners
// measures them from a point `from`; the caller guarantees that no component of a corner minus
// `from` exceeds `Bits`. `corners()` is an array or a span of all corners, and possibly other
// points of the body. If `has_few_edges()`, `for_each_edge(f)` passes a vector along each edge to
// f, once for parallel edges, and possibly other vectors.

/// The hull of at least one point; `Points` is a span or an array of them.
template <Number S, int N, class Points = std::span<const Vec<S, N>>>
class HullBody {
 public:
  static constexpr int dimension = N;
  /// Whether there may be many points.
  static constexpr bool has_many = has_filters && std::same_as<Points, std::span<const Vec<S, N>>>;

  template <class Hull>
  requires std::same_as<decltype(Hull::points), Points>
  explicit constexpr HullBody(const Hull& hull) noexcept : points_(hull.points) {}
  explicit constexpr HullBody(const Points& points) noexcept
      requires(!std::same_as<Points, std::span<const Vec<S, N>>>)
      : points_(points) {}

  [[nodiscard]] constexpr const Points& corners() const noexcept { return points_; }
  [[nodiscard]] constexpr const Vec<S, N>& some() const noexcept { return points_.front(); }
  [[nodiscard]] constexpr Vec<S, N> low() const noexcept {
    auto bound = some();
    for (const auto& point : points_) {
      if constexpr (has_many) {  // no branch per coordinate
        bound = make_vec<N>([&](int i) { return point[i] < bound[i] ? point[i] : bound[i]; });
      } else {
        for (int i = 0; i < N; ++i) {
          if (point[i] < bound[i]) bound[i] = point[i];
        }
      }
    }
    return bound;
  }
  [[nodiscard]] constexpr Vec<S, N> high() const noexcept {
    auto bound = some();
    for (const auto& point : points_) {
      if constexpr (has_many) {  // no branch per coordinate
        bound = make_vec<N>([&](int i) { return point[i] > bound[i] ? point[i] : bound[i]; });
      } else {
        for (int i = 0; i < N; ++i) {
          if (point[i] > bound[i]) bound[i] = point[i];
        }
      }
    }
    return bound;
  }

  [[nodiscard]] constexpr bool has_few_edges() const noexcept { return points_.size() <= 3; }
  using Edge = decltype(Vec<S, N>() - Vec<S, N>());
  template <class F>
  constexpr void for_each_edge(const F& f) const noexcept {
    for (std::size_t i = 0; i < points_.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) f(points_[i] - points_[j]);
    }
  }

  template <int Bits, Number V, Number T>
  [[nodiscard]] constexpr const Vec<S, N>& extreme(const Vec<V, N>& v, const Vec<T, N>& from,
                                                   bool farthest) const noexcept {
    const auto along = [&](const Vec<S, N>& point) { return dot(v, narrow<Bits>(point - from)); };
    const Vec<S, N>* best = &points_.front();
    auto reached = front_along<Bits>(v, from);
    for (const auto& point : std::span(points_).subspan(1)) {
      const auto place = along(point);
      if (farthest ? place > reached : place < reached) {
        best = &point;
        reached = place;
      }
    }
    return *best;
  }

  template <int Bits, Number V, Number T, class F>
  constexpr void for_each_extreme(const Vec<V, N>& v, const Vec<T, N>& from, bool farthest,
                                  const F& f) const noexcept {
    const auto along = [&](const Vec<S, N>& point) { return dot(v, narrow<Bits>(point - from)); };
    const auto reached = along(extreme<Bits>(v, from, farthest));
    for (const auto& point : points_) {
      if (along(point) == reached) f(point);
    }
  }

  /// The same in one pass: calls f(corner, is_better), where `is_better` means that the previous
  /// corners are not extreme.
  template <int Bits, Number V, Number T, class F>
  constexpr void find_extreme(const Vec<V, N>& v, const Vec<T, N>& from, bool farthest,
                              const F& f) const noexcept {
    const auto along = [&](const Vec<S, N>& point) { return dot(v, narrow<Bits>(point - from)); };
    auto reached = front_along<Bits>(v, from);
    f(points_.front(), true);
    for (const auto& point : std::span(points_).subspan(1)) {
      const auto place = along(point);
      const bool is_better = farthest ? place > reached : place < reached;
      if (is_better) reached = place;
      if (place == reached) f(point, is_better);
    }
  }

 private:
  /// dot(v, front - from), without its long products if `from` is the front, as it often is.
  template <int Bits, Number V, Number T>
  [[nodiscard]] constexpr auto front_along(const Vec<V, N>& v,
                                           const Vec<T, N>& from) const noexcept {
    using Along = decltype(dot(v, narrow<Bits>(some() - from)));
    if constexpr (is_fixed<S> && std::same_as<S, T>) {
      if (some() == from) return Along();
    }
    return dot(v, narrow<Bits>(some() - from));
  }

  Points points_;
};
template <Scalar S, int N>
HullBody(const ConvexHull<S, N>&) -> HullBody<S, N>;
template <Number S, int N, std::size_t Count>
HullBody(const std::array<Vec<S, N>, Count>&) -> HullBody<S, N, std::array<Vec<S, N>, Count>>;

/// The corners of a body that are farthest along v, or least far if not `farthest`, relative to
/// `origin`, in numbers of type T (see least_common_point.hpp). Their differences must fit T, and
/// the grid of `origin` must be the finer one of two bodies.
template <Number T, class Body, Number V, Number O, int N>
class ExtremeCorners {
 public:
  static constexpr int dimension = N;

  /// `u` is v in a narrower type, times a power of two.
  template <Number U>
  constexpr ExtremeCorners(const Body& body, const Vec<U, N>& u, const Vec<V, N>& v, bool farthest,
                           const Vec<O, N>& origin) noexcept
      : body_(body), v_(v), origin_(origin), farthest_(farthest) {
    const auto keep = [&](const auto& corner, bool is_better) {
      if (is_better) count_ = 0;
      if (count_ < corners_.size()) corners_[count_] = narrow<bits>(corner - origin_);
      ++count_;
    };
    if constexpr (requires { body.template find_extreme<bits>(u, origin, farthest, keep); }) {
      body.template find_extreme<bits>(u, origin, farthest, keep);
    } else {
      body.template for_each_extreme<bits>(u, origin, farthest,
                                           [&](const auto& corner) { keep(corner, false); });
    }
  }

  [[nodiscard]] constexpr const Vec<T, N>& some() const noexcept { return corners_.front(); }
  template <class F>
  constexpr void for_each(const F& f) const noexcept {
    if (count_ > corners_.size()) {
      scan(f);
    } else {
      for (std::size_t i = 0; i < count_; ++i) f(corners_[i]);
    }
  }

 private:
  static constexpr int bits = bits_of<T>;

  template <class F>
  constexpr void scan(const F& f) const noexcept {
    body_.template for_each_extreme<bits>(
        v_, origin_, farthest_, [&](const auto& corner) { f(narrow<bits>(corner - origin_)); });
  }

  const Body& body_;
  Vec<V, N> v_;
  Vec<O, N> origin_;
  bool farthest_;
  // The first of them; faces seldom have more. If there are more, all corners are scanned again.
  std::array<Vec<T, N>, 8> corners_{};
  std::size_t count_ = 0;
};

template <Number T, class Body, Number U, Number V, Number O, int N>
[[nodiscard]] constexpr auto extreme_corners(const Body& body, const Vec<U, N>& u,
                                             const Vec<V, N>& v, bool farthest,
                                             const Vec<O, N>& origin) noexcept {
  return ExtremeCorners<T, Body, V, O, N>(body, u, v, farthest, origin);
}

}  // namespace detent::detail
