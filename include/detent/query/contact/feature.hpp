// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "detent/math/components.hpp"
#include "detent/math/direction.hpp"
#include "detent/math/width.hpp"
#include "detent/number/filter/filtered.hpp"
#include "detent/query/kernel/convex_body.hpp"
#include "detent/query/kernel/core.hpp"
#include "detent/query/kernel/least_common_point.hpp"
#include "detent/query/kernel/length.hpp"
#include "detent/query/kernel/vec_list.hpp"

namespace detent::detail {

/// A corner of a shape; it may be out of the range of S.
template <Scalar S, int N>
using Corner = Vec<Length<S>, N>;

/// A face, an edge or a corner of a shape: its corners, rounded to the grid, with their numbers in
/// the shape. Corners count once. Of more than `Most` corners the first ones count.
template <Scalar S, int N, std::size_t Most>
struct Feature {
  static constexpr std::size_t most = Most;
  VecList<Length<S>, N, most> corners;
  std::array<std::uint8_t, most> numbers{};
  std::size_t count = 0;

  constexpr Feature() noexcept = default;
  constexpr Feature(const Feature& other) noexcept { *this = other; }
  /// Copies only the corners that are set.
  constexpr Feature& operator=(const Feature& other) noexcept {
    count = other.count;
    for (std::size_t i = 0; i < count; ++i) copy(i, other, i);
    return *this;
  }

  constexpr void add(const Corner<S, N>& corner, std::size_t number) noexcept {
    for (std::size_t i = 0; i < count; ++i) {
      if (corners[i] == corner) return;
    }
    if (count < most) set_next(corner, number);
  }
  /// Adds a corner that is different from all others.
  constexpr void set_next(const Corner<S, N>& corner, std::size_t number) noexcept {
    corners.set(count, corner);
    numbers[count++] = static_cast<std::uint8_t>(number % 255);
  }
  /// Sets corner i to corner k of another feature.
  constexpr void copy(std::size_t i, const Feature& other, std::size_t k) noexcept {
    corners.set(i, other.corners[k]);
    numbers[i] = other.numbers[k];
  }
};

/// How many corners a feature of a body may have: all corners of a box whose edges are parallel.
template <class Body>
inline constexpr std::size_t most_corners = 32;
template <IsBoxBody Body>
inline constexpr std::size_t most_corners<Body> = std::size_t{1} << Body::dimension;
template <Number T, int N, std::size_t Count>
inline constexpr std::size_t most_corners<HullBody<T, N, std::array<Vec<T, N>, Count>>> = Count;

/// The same of either body.
template <class A, class B>
inline constexpr std::size_t most_corners_of = (std::max)(most_corners<A>, most_corners<B>);

/// Returns f(corners...) with the corners of features relative to `origin`, in numbers of 29 bits if
/// they fit.
template <Scalar S, int N, class F, std::size_t... Most>
constexpr auto with_corners_from(const Corner<S, N>& origin, const F& f,
                                 const Feature<S, N, Most>&... features) noexcept {
  bool are_short = true;
  const auto measure = [&](const auto& feature) {
    for (std::size_t i = 0; i < feature.count; ++i) {
      are_short = fits<29>(feature.corners[i] - origin) && are_short;
    }
  };
  (measure(features), ...);
  const auto relative = [&]<class T>(const T&, const auto& feature) {
    VecList<T, N, std::remove_cvref_t<decltype(feature)>::most> corners;
    for (std::size_t i = 0; i < feature.count; ++i) {
      corners.set(i, at_most < is_fixed<T> ? bits_of<T> : 0 > (feature.corners[i] - origin));
    }
    return corners;
  };
  using Wide = std::remove_cvref_t<decltype((origin - origin).x)>;
  using Short = decltype(at_most<29>(Wide()));
  return are_short ? f(relative(Short(), features)...) : f(relative(Wide(), features)...);
}

/// Keeps only the outermost corners of a flat feature, counter-clockwise seen against d, starting
/// with the least one; of a straight feature, both ends; of a feature seen edge-on, any two corners.
///
/// source: Jarvis, On the Identification of the Convex Hull of a Finite Set of Points (1973)
template <Scalar S, std::size_t Most>
[[nodiscard]] constexpr Feature<S, 3, Most> outline(const Feature<S, 3, Most>& feature,
                                                    const Direction<S, 3>& d) noexcept {
  if (feature.count < 2) return feature;
  std::size_t first = 0;
  for (std::size_t i = 1; i < feature.count; ++i) {
    if (is_before(feature.corners[i], feature.corners[first])) first = i;
  }
  const auto from_first = [&](const auto&... order) {
    Feature<S, 3, Most> result;
    const std::array numbers{static_cast<std::size_t>(order)...};
    std::size_t at = 0;
    while (numbers[at] != first) ++at;
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      const auto k = numbers[at + i < numbers.size() ? at + i : at + i - numbers.size()];
      result.copy(i, feature, k);
    }
    result.count = numbers.size();
    return result;
  };
  if constexpr (has_filters) {
    if (feature.count == 2) return from_first(0, 1);
  }
  const auto wrap = [&](const auto& corners) {
    const auto turn_of = [&](std::size_t i, std::size_t j, std::size_t k) {
      const auto turn = dot(d, cross(corners[j] - corners[i], corners[k] - corners[i]));
      return (turn > 0) - (turn < 0);
    };
    if constexpr (has_filters) {
      // Four corners that turn the same way at each of them are their outline: four turns of less than
      // half a circle are less than two circles. The corners of a face of a box come in this order.
      const int turn = feature.count > 4    ? 0
                       : feature.count == 3 ? turn_of(0, 1, 2)
                                            : turn_of(0, 1, 3);
      if (turn != 0) {
        if (feature.count == 3) return turn > 0 ? from_first(0, 1, 2) : from_first(0, 2, 1);
        if (turn_of(1, 3, 2) == turn && turn_of(3, 2, 0) == turn && turn_of(2, 0, 1) == turn)
          return turn > 0 ? from_first(0, 1, 3, 2) : from_first(0, 2, 3, 1);
      }
    }
    Feature<S, 3, Most> result;
    bool is_in_line = true;
    for (std::size_t at = first; result.count < feature.count;) {
      result.copy(result.count++, feature, at);
      const auto& p = corners[at];
      std::size_t next = at == 0 ? 1 : 0;
      for (std::size_t i = 0; i < feature.count; ++i) {
        if (i == at || i == next) continue;
        const auto to_next = corners[next] - p, to_corner = corners[i] - p;
        const auto turn = dot(d, cross(to_next, to_corner));
        is_in_line = is_in_line && turn == 0;
        if (turn < 0 || (turn == 0 && squared_length(to_corner) > squared_length(to_next)))
          next = i;
      }
      if (next == first) break;
      at = next;
    }
    if (is_in_line) result.count = (std::min)(result.count, std::size_t{2});
    return result;
  };
  return with_corners_from(feature.corners[first], wrap, feature);
}
template <Scalar S, std::size_t Most>
[[nodiscard]] constexpr Feature<S, 2, Most> outline(const Feature<S, 2, Most>& feature,
                                                    const Direction<S, 2>&) noexcept {
  if (feature.count < 3) return feature;
  std::size_t low = 0, high = 0;
  for (std::size_t i = 1; i < feature.count; ++i) {
    if (is_before(feature.corners[i], feature.corners[low])) low = i;
    if (is_before(feature.corners[high], feature.corners[i])) high = i;
  }
  Feature<S, 2, Most> result;
  result.add(feature.corners[low], feature.numbers[low]);
  result.add(feature.corners[high], feature.numbers[high]);
  return result;
}

/// Of a face seen edge-on, the edge at its deepest corner that is most opposed to d: the one that
/// rises least along d. Of two equal ones it is the longer, then the first.
template <Scalar S, std::size_t Most>
[[nodiscard]] constexpr Feature<S, 3, Most> opposed_edge(const Feature<S, 3, Most>& face,
                                                         const Feature<S, 3, Most>& deepest,
                                                         const Direction<S, 3>& d) noexcept {
  // All corners are in one plane with d, so their cross products with d are parallel.
  const auto reach_of = [&](const auto& v) { return sum_of_magnitudes(cross(d, v)); };
  const auto& corner = deepest.corners[0];
  Feature<S, 3, Most> edge = deepest;
  auto best = corner - corner;
  for (std::size_t i = 0; i < face.count; ++i) {
    const auto v = face.corners[i] - corner;
    const auto reach = reach_of(v), best_reach = reach_of(best);
    const auto rise = dot(d, v) * best_reach, best_rise = dot(d, best) * reach;
    if (!(rise < best_rise || (rise == best_rise && reach > best_reach))) continue;
    best = v;
    edge.count = 1;
    edge.set_next(face.corners[i], face.numbers[i]);
  }
  return edge;
}

/// The feature of `body` that is farthest along v, or least far, exactly; its corners in the world
/// are those of `world`.
template <Scalar S, std::size_t Most, class Body, class World, Number V, int N>
[[nodiscard]] constexpr Feature<S, N, Most> extreme_feature(const Body& body, const World& world,
                                                            const Vec<V, N>& v,
                                                            bool farthest) noexcept {
  Feature<S, N, Most> feature;
  if constexpr (IsBoxBody<Body>) {
    std::size_t upper = 0, either = 0;
    for (int i = 0; i < N; ++i) {
      const auto along = dot(v, body.span(i));
      upper |= std::size_t{(along > 0) == farthest} << i;
      either |= std::size_t{along == 0} << i;
    }
    for (std::size_t sides = 0; sides < std::size_t{1} << N; ++sides) {
      if ((sides | either) == (upper | either))
        feature.add(nearest_to<Length<S>>(world.corner(sides)), sides);
    }
  } else {
    constexpr int bits = bits_of<decltype(body.some().x)> + 1;
    const auto best = body.template extreme<bits>(v, body.some(), farthest);
    const auto& corners = body.corners();
    const auto& in_world = world.corners();
    for (std::size_t i = 0; i < corners.size(); ++i) {
      if (dot(v, corners[i] - best) == 0) feature.add(nearest_to<Length<S>>(in_world[i]), i);
    }
  }
  return feature;
}

/// The same of one body; with `level` if it is known which corners belong to the feature: a bit each.
template <Scalar S, std::size_t Most, class Body, Number V, int N>
[[nodiscard]] constexpr Feature<S, N, Most> face_along(const Body& body, const Vec<V, N>& v,
                                                       bool farthest) noexcept {
  return extreme_feature<S, Most>(body, body, v, farthest);
}
template <Scalar S, std::size_t Most, class Body, Number V, int N>
[[nodiscard]] constexpr Feature<S, N, Most> face_along(const Body& body, const Vec<V, N>&, bool,
                                                       std::uint32_t level) noexcept {
  const auto& corners = body.corners();
  Feature<S, N, Most> feature;
  for (; level != 0; level &= level - 1) {
    const auto k = static_cast<std::size_t>(std::countr_zero(level));
    feature.add(nearest_to<Length<S>>(corners[k]), k);
  }
  return feature;
}

/// A vector perpendicular to the line or plane of N corners.
template <Number T>
[[nodiscard]] constexpr auto across_corners(const std::array<Vec<T, 2>, 2>& p) noexcept {
  const auto edge = p[1] - p[0];
  return Vec{edge.y, narrow_negative(edge.x)};
}
template <Number T>
[[nodiscard]] constexpr auto across_corners(const std::array<Vec<T, 3>, 3>& p) noexcept {
  return cross(p[1] - p[0], p[2] - p[0]);
}

/// Finds the face of a hull that holds `corner` and is most opposed to d; all corners of a hull
/// without faces.
template <class Body, Scalar S, int N, std::size_t Most>
class OpposedFace {
 public:
  constexpr OpposedFace(const Body& body, const Corner<S, N>& at, const Direction<S, N>& d) noexcept
      : corners_(body.corners()), from_(nearest_to<S>(at)), d_(d) {
    bool are_short = true;
    for (const auto& corner : corners_) are_short = fits<29>(corner - from_) && are_short;
    using Wide = std::remove_cvref_t<decltype(from_.x - from_.x)>;
    are_short ? find<decltype(at_most<29>(Wide()))>() : find<Wide>();
  }

  [[nodiscard]] constexpr const Feature<S, N, Most>& feature() const noexcept { return feature_; }

 private:
  template <Number T>
  using Offsets = std::array<Vec<T, N>, std::size_t{N}>;
  template <Number T>
  using Normal = decltype(across_corners(Offsets<T>()));

  /// Corner i, seen from the given one, in numbers of type T.
  template <Number T>
  [[nodiscard]] constexpr Vec<T, N> offset(std::size_t i) const noexcept {
    return at_most<(is_fixed<T> ? bits_of<T> : 0)>(corners_[i] - from_);
  }

  template <Number T>
  constexpr void find() noexcept {
    Normal<T> best{};
    if (!wrap<T>(best)) {
      best = {};
      try_all<T>(best);
    }
    for (std::size_t i = 0; i < corners_.size(); ++i) {
      if (dot(best, offset<T>(i)) == 0) feature_.add(nearest_to<Length<S>>(corners_[i]), i);
    }
  }

  /// Finds the normal of the face by walking about the corner, from each edge to the next; false if
  /// the hull is flat, or if two faces are equally opposed, and in 2D.
  ///
  /// The face on the left of an edge is the one on which a corner is leftmost, seen along the edge.
  /// If no corner is beyond any of the faces, the walk comes back to its first edge, and has
  /// then crossed every face about the corner.
  ///
  /// source: Jarvis, On the Identification of the Convex Hull of a Finite Set of Points (1973)
  template <Number T>
  [[nodiscard]] constexpr bool wrap(Normal<T>& best) const noexcept {
    if constexpr (N == 2 || !is_fixed<S> || !has_filters) {
      return false;
    } else {
      std::size_t first = 0;
      auto step = face_left_of<T>(first);
      while (!step.is_face && ++first < corners_.size()) step = face_left_of<T>(first);
      for (std::size_t steps = 0; step.is_face && steps < corners_.size(); ++steps) {
        if (!keep_better<T>(step.normal, dot(step.normal, d_), best)) return false;
        if (step.next == first) return true;
        step = face_left_of<T>(step.next);
      }
      return false;
    }
  }
  template <Number T>
  struct Step {
    Normal<T> normal{};
    std::size_t next = 0;
    bool is_face = false;
  };
  /// The face on the left of the edge to corner i: its normal, and the corner at its other side.
  template <Number T>
  [[nodiscard]] constexpr Step<T> face_left_of(std::size_t i) const noexcept {
    Step<T> step;
    Offsets<T> p{};
    p[1] = offset<T>(i);
    for (std::size_t k = 0; k < corners_.size(); ++k) {
      p[2] = offset<T>(k);
      if (!is_zero(step.normal) && !(dot(step.normal, p[2]) > 0)) continue;
      step.normal = across_corners(p);
      step.next = k;
    }
    bool is_flat = true;
    for (std::size_t k = 0; k < corners_.size(); ++k) {
      const auto height = dot(step.normal, offset<T>(k));
      if (height > 0) return step;
      is_flat = is_flat && height == 0;
    }
    step.is_face = !is_flat;
    return step;
  }

  template <Number T>
  constexpr void try_all(Normal<T>& best) const noexcept {
    Offsets<T> p{};
    for (std::size_t i = 0; i < corners_.size(); ++i) {
      p[1] = offset<T>(i);
      if constexpr (N == 2) {
        offer(p, best);
      } else {
        for (std::size_t j = 0; j < i; ++j) {
          p[2] = offset<T>(j);
          offer(p, best);
        }
      }
    }
  }

  template <Number T>
  constexpr void offer(const Offsets<T>& p, Normal<T>& best) const noexcept {
    auto normal = across_corners(p);
    if (is_zero(normal)) return;
    bool is_below = true, is_above = true;
    for (std::size_t i = 0; i < corners_.size() && (is_below || is_above); ++i) {
      const auto height = dot(normal, offset<T>(i));
      is_below = is_below && height <= 0;
      is_above = is_above && height >= 0;
    }
    if (!is_below && !is_above) return;
    auto along = dot(normal, d_);
    if (is_below ? is_above && along > 0 : true) {
      normal = narrow_negative(normal);
      along = narrow_negative(along);
    }
    keep_better<T>(normal, along, best);
  }

  /// Keeps the first of the most opposed normals; false if another one is equally opposed.
  template <Number T, Number Along>
  constexpr bool keep_better(const Normal<T>& normal, const Along& along,
                             Normal<T>& best) const noexcept {
    if (is_zero(best)) {
      best = normal;
      return true;
    }
    const auto squared = squared_length(normal);
    const auto best_along = dot(best, d_);
    const auto left = square(along) * squared_length(best), right = square(best_along) * squared;
    const bool is_better =
        along < 0 ? best_along >= 0 || left > right : best_along > 0 && left < right;
    if (is_better) best = normal;
    return is_better || left != right || are_parallel(normal, best);
  }

  decltype(std::declval<const Body&>().corners()) corners_;
  Vec<S, N> from_;
  const Direction<S, N>& d_;
  Feature<S, N, Most> feature_;
};

/// The face of a box that is most opposed to d; `along` are the products of d and its axes.
template <Scalar S, std::size_t Most, class Body, Number T, int N>
[[nodiscard]] constexpr Feature<S, N, Most> opposed_side(const Body& body,
                                                         const Vec<T, N>& along) noexcept {
  const int axis = longest_axis(along);
  const std::size_t end = along[axis] < 0 ? 1 : 0;
  Feature<S, N, Most> feature;
  for (std::size_t sides = 0; sides < std::size_t{1} << N; ++sides) {
    if ((sides >> axis & 1) == end) feature.add(nearest_to<Length<S>>(body.corner(sides)), sides);
  }
  return feature;
}

/// The feature of a core that meets a face with the outward normal d, given its corner or edge that
/// reaches deepest: the face most opposed to d; a whole segment or a point.
template <class Core, class Body, Scalar S, int N, std::size_t Most>
[[nodiscard]] constexpr Feature<S, N, Most> opposed_feature(const Core& core, const Body& body,
                                                            const Feature<S, N, Most>& deepest,
                                                            const Direction<S, N>& d) noexcept {
  if constexpr (is_kind<Core, Aabb>) {
    return opposed_side<S, Most>(body, d.vec());
  } else if constexpr (is_kind<Core, Obb>) {
    return opposed_side<S, Most>(body,
                                 make_vec<N>([&](int i) { return dot(core.rotation.axis(i), d); }));
  } else {
    return OpposedFace<Body, S, N, Most>(body, deepest.corners[0], d).feature();
  }
}

}  // namespace detent::detail
