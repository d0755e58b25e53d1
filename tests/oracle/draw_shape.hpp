// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <utility>

#include "detent/shape/shape.hpp"
#include "oracle/draw.hpp"
#include "support/shapes.hpp"

namespace detent::oracle {

/// How the numbers of a random shape are chosen.
enum class Kind {
  general,     // as in a game: around a center, up to a size, at every scale
  lattice,     // small multiples of the axes of an exact frame: contacts are exact
  tiny,        // a few raw units
  extreme,     // bits from the whole domain
  degenerate,  // on the lattice, collapsed or empty
};
inline constexpr std::array every_kind{Kind::general, Kind::lattice, Kind::tiny, Kind::extreme,
                                       Kind::degenerate};

/// The common setting of the shapes of one case, so that they can overlap.
template <int N>
struct Setting {
  Kind kind;
  Raw<N> center;
  std::int64_t size;    // of a general shape
  std::int64_t spread;  // of the centers of general shapes
  Frame<N> frame;
  std::int64_t stride;  // of the lattice: its points are center + stride * (k[0] axes[0] + ...)
};

/// `aim` is the spread of general shapes in percent of their size.
template <Scalar S, int N>
Setting<N> draw_setting(Draw<S, N>& draw, Kind kind, int aim) {
  using D = Draw<S, N>;
  auto& random = draw.random;
  const auto size = draw.scale() / 2;
  Setting<N> result{
      kind, draw.point(2 * size), size, std::max<std::int64_t>(size * aim / 100, 1), {}, 0};
  if (kind == Kind::tiny) result.center = draw.point(random.coin() ? 3 : D::limit / 2);
  if (kind == Kind::lattice || kind == Kind::degenerate) {
    result.frame = draw.frame();
    const auto norm = result.frame.norm;
    result.stride = draw.steps(D::limit / 16, norm);
    // Multiples of the norm, so that a plane along the lattice has an offset on the grid.
    for (auto& component : result.center) {
      const auto reach = random.coin() ? 0 : D::limit / 4 / norm;
      component = norm * random.between(-reach, reach);
    }
  }
  return result;
}

/// A setting of any kind, of `twice` twice as often as of the others.
template <Scalar S, int N>
Setting<N> any_setting(Draw<S, N>& draw, Kind twice, int aim) {
  const auto
      kind = std::array{Kind::general, twice,         Kind::lattice,
                        Kind::tiny,    Kind::extreme, Kind::degenerate}[draw.random.below(6)];
  return draw_setting(draw, kind, aim);
}

/// Draws the parts of shapes in one setting.
template <Scalar S, int N>
class Artist {
 public:
  using D = Draw<S, N>;
  static constexpr auto dimension = static_cast<std::size_t>(N);

  Artist(Draw<S, N>& source, const Setting<N>& scene)
      : draw(source),
        random(source.random),
        setting(scene),
        center(source.near(scene.center, scene.spread)),
        size(random.one_in(4) ? std::max<std::int64_t>(scene.size >> random.below(6), 1)
                              : scene.size) {}

  Draw<S, N>& draw;
  test::Random& random;
  const Setting<N>& setting;
  Raw<N> center;
  std::int64_t size;

  [[nodiscard]] bool is(Kind kind) const { return setting.kind == kind; }
  [[nodiscard]] bool on_lattice() const { return is(Kind::lattice) || is(Kind::degenerate); }

  Raw<N> steps() {
    const int reach = is(Kind::degenerate) ? 1 : 3;
    Raw<N> result{};
    for (auto& k : result) k = random.coin() ? 0 : random.between(-reach, reach);
    return result;
  }
  Raw<N> lattice_point(const Raw<N>& k) {
    auto result = setting.center;
    for (std::size_t i = 0; i < dimension; ++i) {
      result = D::plus(result, setting.frame.axes[i], setting.stride * k[i]);
    }
    return result;
  }

  /// The position of a shape.
  Raw<N> point() {
    switch (setting.kind) {
      case Kind::general:
        return center;
      case Kind::tiny:
        return draw.near(setting.center, 3);
      case Kind::extreme:
        return draw.extreme_point();
      default:
        return nudged(lattice_point(steps()));
    }
  }

  /// The corners of a shape: on the lattice often in one line or plane along it; degenerate ones
  /// often in one point or on any line.
  template <std::size_t Count>
  std::array<Vec<S, N>, Count> corners() {
    std::array<Raw<N>, Count> result;
    auto k = steps();
    const auto first = k, line = steps();
    const auto free = random.below(dimension);
    const bool keeps_one = random.coin(), keeps_others = Count == 2 || random.one_in(4);
    for (auto& corner : result) {
      if (is(Kind::general)) {
        corner = draw.near(center, size);
      } else if (is(Kind::lattice)) {
        k = steps();
        for (std::size_t i = 0; i < dimension; ++i) {
          if (keeps_one && (i == free) != keeps_others) k[i] = first[i];
        }
        corner = lattice_point(k);
      } else if (is(Kind::degenerate)) {
        corner = lattice_point(k);
        if (!random.one_in(3)) k = D::plus(first, line, random.between(-2, 2));
      } else {
        corner = point();
      }
    }
    std::array<Vec<S, N>, Count> corner_vecs;
    for (std::size_t i = 0; i < Count; ++i) {
      corner_vecs[i] = D::vec(is(Kind::lattice) ? nudged(result[i]) : result[i]);
    }
    return corner_vecs;
  }

  /// The extent of a shape: a radius or a half extent.
  std::int64_t reach() {
    switch (setting.kind) {
      case Kind::general:
        return random.between(0, size);
      case Kind::tiny:
        return random.between(random.one_in(8) ? -1 : 0, 3);
      case Kind::extreme:
        return random.one_in(16) ? draw.extreme() : std::abs(draw.extreme());
      case Kind::degenerate:
        if (random.one_in(12)) return random.coin() ? -1 : draw.extreme();
        if (random.coin()) return 0;
        [[fallthrough]];
      default:
        return setting.stride * setting.frame.norm * random.between(0, 2) +
               (random.one_in(4) ? random.between(-1, 1) : 0);
    }
  }

  Rotation<S, N> rotation() {
    if (on_lattice() && !random.one_in(8)) return draw.rotation(setting.frame);
    if (is(Kind::degenerate)) return parallel();
    if (is(Kind::extreme) && random.one_in(4)) return parallel();
    return random.one_in(4) ? draw.skewed() : draw.rotation();
  }

 private:
  /// The same point, or sometimes a neighbour on the grid.
  Raw<N> nudged(const Raw<N>& point) { return random.one_in(6) ? draw.near(point, 1) : point; }

  /// A frame without volume.
  Rotation<S, N> parallel() {
    const auto axis = draw.any_direction();
    if constexpr (N == 2) {
      return Rotation<S, N>::from_axes({axis, -axis});
    } else {
      return Rotation<S, N>::from_axes({axis, random.coin() ? axis : draw.any_direction(), -axis});
    }
  }
};

template <Scalar S, int N>
void draw_shape(Artist<S, N>& artist, Sphere<S, N>& sphere) {
  sphere = {Draw<S, N>::vec(artist.point()), Draw<S, N>::scalar(artist.reach())};
}

template <Scalar S, int N>
void draw_shape(Artist<S, N>& artist, Aabb<S, N>& box) {
  using D = Draw<S, N>;
  auto low = artist.point(), high = low;
  for (std::size_t i = 0; i < D::size; ++i) {
    if (artist.is(Kind::extreme)) {
      high[i] = artist.draw.extreme();
      if (!artist.random.one_in(40) && high[i] < low[i]) std::swap(low[i], high[i]);
    } else {
      const auto reach = artist.reach();
      low[i] -= reach;
      high[i] += reach;
    }
  }
  box = {D::vec(low), D::vec(high)};
}

template <Scalar S, int N>
void draw_shape(Artist<S, N>& artist, Obb<S, N>& box) {
  using D = Draw<S, N>;
  Raw<N> half_extents{};
  for (auto& half : half_extents) half = artist.reach();
  box = {D::vec(artist.point()), D::vec(half_extents), artist.rotation()};
}

template <Scalar S, int N>
void draw_shape(Artist<S, N>& artist, Plane<S, N>& plane) {
  using D = Draw<S, N>;
  const auto point = artist.point();
  if (artist.is(Kind::extreme)) {
    plane = {artist.draw.any_direction(), D::scalar(artist.draw.extreme())};
    return;
  }
  plane.normal = artist.draw.any_direction();
  if (artist.on_lattice()) {
    const auto& frame = artist.setting.frame;
    plane.normal = D::stretched(frame.axes[artist.random.below(D::size)], frame.norm);
    if (artist.random.coin()) plane.normal = -plane.normal;
  }
  Integer offset = 0;
  for (std::size_t i = 0; i < D::size; ++i) {
    offset +=
        Integer(point[i]) * static_cast<std::int64_t>(plane.normal[static_cast<int>(i)].raw());
  }
  plane.offset =
      D::scalar(static_cast<std::int64_t>(nearest_even(offset, direction_component<S>::frac)));
}

/// The corners first, then the lengths.
template <Scalar S, int N, support::OfPoints Shape>
void draw_shape(Artist<S, N>& artist, Shape& shape) {
  const auto corners = artist.template corners<support::point_count<Shape>>();
  std::size_t next = 0;
  shape = support::made_of<Shape>([&] { return corners[next++]; },
                                  [&] { return Draw<S, N>::scalar(artist.reach()); });
}

/// A shape of the type `Shape` in `setting`.
template <class Shape, Scalar S, int N>
Shape draw_shape(Draw<S, N>& draw, const Setting<N>& setting) {
  Artist<S, N> artist(draw, setting);
  Shape shape;
  draw_shape(artist, shape);
  return shape;
}

}  // namespace detent::oracle
