// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <sstream>
#include <string>
#include <vector>

#include "detent/shape/shape.hpp"
#include "oracle/describe.hpp"
#include "support/catch.hpp"
#include "support/shapes.hpp"

/// Worlds with so few numbers that everything in them can be enumerated. Every coordinate is near
/// an end of the range, and most shapes are degenerate, touch or coincide.
namespace detent::small {

/// Counts cases and keeps the first few that are wrong.
class Verdict {
 public:
  /// `wrong` is empty or describes the error; `describe()` names the case.
  template <class Describe>
  void judge(const std::string& wrong, const Describe& describe) {
    ++cases_;
    if (wrong.empty() || ++wrong_ > 5) return;
    first_ << describe() << "\n" << wrong;
  }

  /// Counts positive results, so that a sweep with only one kind of result fails.
  void count(bool yes) { yes_ += yes ? 1 : 0; }

  /// Checks that `expected` cases were run, so that a sweep that skips some by mistake fails.
  void finish(long expected) const {
    INFO(cases_ << " cases, " << yes_ << " of them yes, " << wrong_ << " wrong\n" << first_.str());
    CHECK(wrong_ == 0);
    CHECK(cases_ == expected);
    CHECK(yes_ > 0);
    CHECK(yes_ < cases_);
  }

 private:
  long cases_ = 0, yes_ = 0, wrong_ = 0;
  std::ostringstream first_;
};

/// Every number of a short scalar in ascending order; of a long scalar, the ends and the numbers
/// next to 0.
template <Scalar S>
std::vector<S> numbers() {
  using Raw = typename S::raw_type;
  const Raw low = S::lowest().raw(), high = S::max().raw();
  if constexpr (S::bits > 7) {
    return {S::from_raw(low), S::from_raw(-1), S(), S::from_raw(1), S::from_raw(high)};
  } else {
    std::vector<S> all;
    for (int raw = low; raw <= high; ++raw) all.push_back(S::from_raw(static_cast<Raw>(raw)));
    return all;
  }
}

/// All of a list, or `most` elements spread over it: every kth, cyclically, with k near the golden
/// ratio of its size, so that no coordinate is always the same.
template <class T>
std::vector<T> some(std::size_t most, const std::vector<T>& all) {
  if (all.size() <= most) return all;
  std::size_t k = all.size() * 618 / 1000;
  while (std::gcd(k, all.size()) != 1) ++k;
  std::vector<T> result;
  for (std::size_t i = 0; i < most; ++i) result.push_back(all[i * k % all.size()]);
  return result;
}

/// Every point with these coordinates.
template <int N, Scalar S>
std::vector<Vec<S, N>> points_of(const std::vector<S>& coordinates) {
  std::vector<Vec<S, N>> all{Vec<S, N>{}};
  for (int i = 0; i < N; ++i) {
    std::vector<Vec<S, N>> longer;
    for (auto point : all) {
      for (const S& x : coordinates) {
        point[i] = x;
        longer.push_back(point);
      }
    }
    all = longer;
  }
  return all;
}

/// The directions of all vectors of integers up to `most`, the axes first, and the longest and
/// shortest directions.
template <Scalar S, int N>
std::vector<Direction<S, N>> directions(int most) {
  using D = Direction<S, N>;
  using Whole = Fixed<15, 0>;
  std::vector<D> all;
  const auto add = [&](const D& direction) {
    if (std::find(all.begin(), all.end(), direction) == all.end()) all.push_back(direction);
  };
  for (int i = 0; i < N; ++i) {
    add(D::along(i));
    add(-D::along(i));
  }
  for (int x = -most; x <= most; ++x) {
    for (int y = -most; y <= most; ++y) {
      for (int z = -most; z <= (N == 2 ? -most : most); ++z) {
        auto vector = Vec<Whole, N>{};
        vector[0] = Whole(x);
        vector[1] = Whole(y);
        if constexpr (N == 3) vector[2] = Whole(z);
        if (const auto direction = direction_of<S>(vector)) add(*direction);
      }
    }
  }
  // Lengths from two steps of the grid below 1 to two steps above it.
  using Raw = typename D::Raw;
  constexpr int frac = D::Component::frac;
  const int unit = 1 << frac, side = frac == 14 ? 11585 : 759'250'125;  // unit / sqrt(2)
  const int step = 1 << (frac / 2 + 1);
  const std::array<int, 2> longest{unit, step}, shortest{2 - unit, 0};
  const std::array<int, 2> aslant{side + 1, -side - 1}, short_of{side - 2, side};
  for (const auto& [x, y] : {longest, shortest, aslant, short_of}) {
    const std::array<Raw, N> raw{static_cast<Raw>(x), static_cast<Raw>(y)};
    if (const auto direction = D::from_raw(raw)) add(*direction);
  }
  return all;
}

/// Rotated, mirrored and sheared frames, some with parallel axes.
template <Scalar S, int N>
std::vector<Rotation<S, N>> rotations() {
  std::vector<Rotation<S, N>> all{Rotation<S, N>()};
  for (const int degrees : {90, 45, 30, 200, 333}) {
    const auto angle = Angle<S>::turn(degrees, 360);
    if constexpr (N == 2) {
      all.push_back(Rotation<S, 2>::from_angle(angle));
    } else {
      all.push_back(Rotation<S, 3>::from_euler(angle, Angle<S>(), Angle<S>()));
      all.push_back(Rotation<S, 3>::from_euler(angle, angle, angle));
    }
  }
  const auto ways = directions<S, N>(2);
  for (const std::size_t i : {1u, 4u, 7u}) {
    auto axes = std::array<Direction<S, N>, N>{ways[0], ways[i]};
    if constexpr (N == 3) axes[2] = ways[i + 4];
    all.push_back(Rotation<S, N>::from_axes(axes));
    axes = {ways[ways.size() - i], ways[i + 2]};
    if constexpr (N == 3) axes[2] = ways[2 * i];
    all.push_back(Rotation<S, N>::from_axes(axes));
  }
  return all;
}

/// The parts of a world, which contains every shape made of them.
template <Scalar S, int N>
struct Parts {
  std::vector<Vec<S, N>> points, half_extents;
  std::vector<S> lengths, offsets;  // of spheres, capsules and rays; of planes
  std::vector<Direction<S, N>> directions;
  std::vector<Rotation<S, N>> rotations;
};

/// All numbers of a scalar, and the directions of integers up to `most`.
template <Scalar S, int N>
Parts<S, N> all_parts(int most = 2) {
  const auto all = points_of<N>(numbers<S>());
  return {all, all, numbers<S>(), numbers<S>(), directions<S, N>(most), rotations<S, N>()};
}

template <Scalar S, int N>
void list(const Parts<S, N>& parts, std::vector<Vec<S, N>>& out) {
  out = parts.points;
}
/// Calls `f` for every choice of points and lengths for the fields; the last one changes first.
template <Scalar S, int N, class F>
void choose(const Parts<S, N>&, const F& f) {
  f();
}
template <Scalar S, int N, class F, class First, class... Rest>
void choose(const Parts<S, N>& parts, const F& f, First& first, Rest&... rest) {
  const auto& values = [&]() -> const std::vector<First>& {
    if constexpr (support::is_point<First>) {
      return parts.points;
    } else {
      return parts.lengths;
    }
  }();
  for (const auto& value : values) {
    first = value;
    choose(parts, f, rest...);
  }
}
template <Scalar S, int N, support::OfPoints Shape>
void list(const Parts<S, N>& parts, std::vector<Shape>& out) {
  Shape shape;
  detent::detail::ShapeFields<Shape>::of(shape, [&](auto&... fields) {
    choose(
        parts, [&] { out.push_back(shape); }, fields...);
  });
}
template <Scalar S, int N>
void list(const Parts<S, N>& parts, std::vector<Aabb<S, N>>& out) {
  for (const auto& min : parts.points) {
    for (const auto& max : parts.points) out.push_back({min, max});
  }
}
template <Scalar S, int N>
void list(const Parts<S, N>& parts, std::vector<Obb<S, N>>& out) {
  for (const auto& rotation : parts.rotations) {
    for (const auto& center : parts.points) {
      for (const auto& half : parts.half_extents) out.push_back({center, half, rotation});
    }
  }
}
template <Scalar S, int N>
void list(const Parts<S, N>& parts, std::vector<Plane<S, N>>& out) {
  for (const auto& normal : parts.directions) {
    for (const S& offset : parts.offsets) out.push_back({normal, offset});
  }
}
template <Scalar S, int N>
void list(const Parts<S, N>& parts, std::vector<Ray<S, N>>& out) {
  for (const auto& origin : parts.points) {
    for (const auto& direction : parts.directions) {
      for (const S& most : parts.lengths) out.push_back({origin, direction, most});
    }
  }
}

/// Up to `most` of every shape of a type.
template <class Shape, Scalar S, int N>
std::vector<Shape> some(std::size_t most, const Parts<S, N>& parts) {
  std::vector<Shape> all;
  list(parts, all);
  return some(most, all);
}

/// The hulls of every choice of up to `most` of `corners`, with repetition; only the first is
/// empty.
template <Scalar S, int N>
class Hulls {
 public:
  Hulls(const std::vector<Vec<S, N>>& corners, std::size_t most) {
    lists_.emplace_back();
    std::size_t begin = 0;
    for (std::size_t count = 1; count <= most; ++count) {
      const std::size_t end = lists_.size();
      for (std::size_t i = begin; i < end; ++i) {
        for (const auto& corner : corners) {
          if (count > 1 && is_before(corner, lists_[i].back())) continue;
          auto longer = lists_[i];
          longer.push_back(corner);
          lists_.push_back(longer);
        }
      }
      begin = end;
    }
  }

  std::vector<ConvexHull<S, N>> all() const {
    std::vector<ConvexHull<S, N>> hulls;
    for (const auto& list : lists_) hulls.push_back({list});
    return hulls;
  }

 private:
  static bool is_before(const Vec<S, N>& a, const Vec<S, N>& b) {
    for (int i = 0; i < N; ++i) {
      if (a[i] != b[i]) return a[i] < b[i];
    }
    return false;
  }

  std::vector<std::vector<Vec<S, N>>> lists_;
};

/// Calls `f` with up to `most` segments and as many of every other shape, one list per type.
template <Scalar S, int N, class F>
void with_some(std::size_t most, const Parts<S, N>& parts, F f) {
  const Hulls<S, N> hulls(some(N == 2 ? 16 : 9, parts.points), N == 2 ? 4 : 5);
  [&]<class... Shape>(support::ShapeList<Shape...>) {
    f(some<Segment<S, N>>(most, parts), some<Shape>(most, parts)..., some(most, hulls.all()));
  }(support::SceneShapes<S, N>());
}

}  // namespace detent::small
