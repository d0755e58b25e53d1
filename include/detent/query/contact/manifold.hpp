// SPDX-License-Identifier: MIT
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "detent/math/components.hpp"
#include "detent/number/filter/ratio.hpp"
#include "detent/query/contact/contact.hpp"
#include "detent/query/contact/feature.hpp"
#include "detent/query/contact/overlay.hpp"
#include "detent/query/contact/points.hpp"
#include "detent/query/kernel/expansion.hpp"
#include "detent/query/kernel/length.hpp"
#include "detent/query/kernel/rounded_point.hpp"

namespace detent::detail {

/// The contact points of two features that face each other across a contact's normal, projected
/// along it. Corners on the grid and the rounded normal are taken as exact; each coordinate and
/// each depth is rounded once.
///
/// The reference is the feature whose plane is perpendicular to the normal; the incident one is
/// clipped against its sides. Points are corners of the incident feature over the reference,
/// crossings of their edges, and corners of the reference under the incident one.
template <Scalar S, int N, std::size_t Most>
class ContactBuilder {
 public:
  using Face = Feature<S, N, Most>;

  /// `depth` is that of the cores (negative if they are apart), `radius_a` that of the first shape,
  /// `radii` the sum.
  template <Number Depth, Number Radii>
  constexpr ContactBuilder(const Direction<S, N>& normal, const Depth& depth, const S& radius_a,
                           const Radii& radii) noexcept
      : normal_(normal),
        seen_(is_positive(normal.vec()) ? normal : -normal),
        depth_(depth),
        radius_a_(radius_a),
        radii_(radii) {}

  /// Intersects the features a and b of the shapes, in their order. `wide_a` and `wide_b` return
  /// the faces that meet a reference face of the other shape.
  template <class WideA, class WideB>
  constexpr void meet(Face a, Face b, const WideA& wide_a, const WideB& wide_b) noexcept {
    a = outline(a, seen_);
    b = outline(b, seen_);
    const bool a_is_face = a.count >= std::size_t{N}, b_is_face = b.count >= std::size_t{N};
    // If both are faces, the one with the positive normal, so that swapping the shapes keeps the
    // choice.
    a_is_reference_ = a_is_face && (!b_is_face || seen_ == normal_);
    if (a_is_reference_) {
      clip(a, b_is_face ? b : incident_of(wide_b(b), b), b);
    } else if (b_is_face) {
      clip(b, a_is_face ? a : incident_of(wide_a(a), a), a);
    } else if (a.count == 1) {
      add(a.corners[0], false, depth_, both(corner(a, 0), corner_or_edge(b)));
    } else if (b.count == 1) {
      add(b.corners[0], true, depth_, both(corner_or_edge(a), corner(b, 0)));
    } else if constexpr (N == 3) {
      if (!meet_edges(a, b)) {
        a_is_reference_ = seen_ == normal_;
        const auto& first = a_is_reference_ ? a : b;
        const auto& other = a_is_reference_ ? b : a;
        const auto along = first.corners[1] - first.corners[0];
        overlap(first, other, other, squared_length(along),
                [&](const Corner<S, 3>& p) { return dot(along, p - first.corners[0]); });
      }
    }
    if (points_.size() == 0) add(b.corners[0], true, depth_, both(face, corner(b, 0)));
  }

  /// Intersects a plane, one of the shapes, and a feature of the other, whose deepest feature is
  /// `deepest`.
  constexpr void meet_plane(bool plane_is_a, const Face& feature, const Face& deepest) noexcept {
    a_is_reference_ = plane_is_a;
    const auto incident = incident_of(feature, deepest);
    const auto& lowest = deepest.corners[0];
    for (std::size_t i = 0; i < incident.count; ++i) {
      add(incident.corners[i], plane_is_a, depth_less(drop(incident.corners[i], lowest)),
          both_by_role(face, corner(incident, i)));
    }
    if (!is_reached_) add(lowest, plane_is_a, depth_, both_by_role(face, corner(deepest, 0)));
  }

  /// Adds the point where two edges cross, seen along the normal; false if they are parallel.
  ///
  /// Rounding may move the point far beyond an end of edges that are nearly parallel. As they do
  /// meet, the end that it is farthest beyond is then on both.
  [[nodiscard]] constexpr bool meet_edges(const Face& a, const Face& b) noexcept requires(N == 3) {
    const auto e = a.corners[1] - a.corners[0], f = b.corners[1] - b.corners[0];
    const auto all = dot(normal_, cross(e, f));
    if (all == 0) return false;
    const auto w = b.corners[0] - a.corners[0];
    const auto part = dot(normal_, cross(w, f)), part_of_b = dot(normal_, cross(w, e));
    const auto feature = both(edge(a, 0, 1), edge(b, 0, 1));
    // Twice the part of an edge that the point is beyond its end; negative between the ends.
    const auto beyond = [&](const auto& to_point) {
      return abs(to_point + to_point - all) - abs(all);
    };
    const auto beyond_b = beyond(part_of_b);
    if (beyond_b > 0 && beyond_b * sum_of_magnitudes(f) > beyond(part) * sum_of_magnitudes(e)) {
      add(b.corners[(part_of_b > 0) == (all > 0) ? 1 : 0], true, depth_, feature);
      return true;
    }
    add_between(a.corners[0], a.corners[1], part, all, false, depth_, feature, a.corners[0]);
    return true;
  }

  /// Intersects two faces, given as outlines, if it is known where they cross; their corners are at
  /// most 2^29 steps from each other. False if no point is as deep as the contact, but for rounding.
  [[nodiscard]] constexpr bool meet_faces(bool a_is_reference, const Face& reference,
                                          const Face& incident, const Corner<S, N>& deepest,
                                          const Overlay<Most>& overlay) noexcept requires(N == 3) {
    a_is_reference_ = a_is_reference;
    const auto relative = [&](const Face& feature) {
      VecList<Fixed<29, S::frac>, N, Most> corners;
      for (std::size_t i = 0; i < feature.count; ++i) {
        corners.set(i, narrow<29>(feature.corners[i] - reference.corners[0]));
      }
      return corners;
    };
    const auto corners = relative(reference), incident_corners = relative(incident);
    add_points(overlay, reference, rim_of(reference, corners), incident,
               rim_of(incident, incident_corners), deepest);
    return is_reached_;
  }

  /// The positive one of the normal and its opposite: invariant under swapping the shapes.
  [[nodiscard]] constexpr const Direction<S, N>& seen() const noexcept { return seen_; }

  /// Writes the points to keep.
  constexpr void write(Contact<S, N>& contact) const noexcept { points_.write(contact, seen_); }

 private:
  using Far = Length<S>;
  template <Number T>
  using Rim = detail::Rim<S, Most, T>;
  static constexpr std::uint32_t face = 0xffff;
  static constexpr std::size_t most = 4 * Most;

  [[nodiscard]] static constexpr std::uint32_t edge(const Face& feature, std::size_t i,
                                                    std::size_t j) noexcept {
    const std::uint32_t p = feature.numbers[i], q = feature.numbers[j];
    return p < q ? p | q << 8 : q | p << 8;
  }
  [[nodiscard]] static constexpr std::uint32_t corner(const Face& feature, std::size_t i) noexcept {
    return edge(feature, i, i);
  }
  [[nodiscard]] static constexpr std::uint32_t corner_or_edge(const Face& feature) noexcept {
    return edge(feature, 0, feature.count - 1);
  }
  [[nodiscard]] static constexpr std::uint32_t both(std::uint32_t a, std::uint32_t b) noexcept {
    return a | b << 16;
  }
  /// The same, given parts of the reference and the incident feature.
  [[nodiscard]] constexpr std::uint32_t both_by_role(std::uint32_t reference,
                                                     std::uint32_t incident) const noexcept {
    return a_is_reference_ ? both(reference, incident) : both(incident, reference);
  }

  /// The outline of a face; of a face seen edge-on, its deepest edge or, if only one corner is
  /// deepest, its most opposed edge there.
  [[nodiscard]] constexpr Face incident_of(const Face& wide, const Face& deepest) const noexcept {
    const auto seen = outline(wide, seen_);
    if constexpr (N == 3) {
      if (seen.count == 2 && wide.count > 2) {
        return outline(deepest.count > 1
                           ? deepest
                           : opposed_edge(wide, deepest, a_is_reference_ ? normal_ : -normal_),
                       seen_);
      }
    }
    return seen;
  }

  /// How much less deeply than `deepest` a point of the incident feature reaches into the
  /// reference.
  [[nodiscard]] constexpr auto drop(const Corner<S, N>& point,
                                    const Corner<S, N>& deepest) const noexcept {
    return a_is_reference_ ? dot(normal_, point - deepest) : dot(normal_, deepest - point);
  }
  /// At most `depth_`, although `drop` may be negative: no point is deeper, but for rounding.
  template <Number T>
  [[nodiscard]] constexpr Far depth_less(const T& drop) const noexcept {
    return drop > 0 ? nearest_to<Far>(depth_ - drop) : depth_;
  }

  /// Adds a point of the core of a or, if `is_on_b`, of b, where the cores are `depth` deep.
  template <Number Depth>
  constexpr void add(const Corner<S, N>& point, bool is_on_b, const Depth& depth,
                     std::uint32_t feature) noexcept {
    push(on_surface(point, is_on_b, depth), depth, feature, point);
  }
  /// Adds the point at part / all of the way from one point to another, at most all of it.
  template <Number Part, Number All, Number Depth>
  constexpr void add_between(const Corner<S, N>& from, const Corner<S, N>& to, const Part& part,
                             const All& all, bool is_on_b, const Depth& depth,
                             std::uint32_t feature, const Corner<S, N>& place) noexcept {
    const All whole = all < 0 ? narrow_negative(all) : all;
    const All ahead(all < 0 ? narrow_negative(part) : part);
    if (!(ahead > 0)) {
      push(on_surface(from, is_on_b, depth), depth, feature, place);
    } else if (!(ahead < whole)) {
      push(on_surface(to, is_on_b, depth), depth, feature, place);
    } else {
      push(on_surface(from, to, make_ratio_below_one(ahead, whole), is_on_b, depth), depth, feature,
           place);
    }
  }
  /// The point of the surface at a point of a core.
  template <Number Depth>
  [[nodiscard]] constexpr Vec<S, N> on_surface(const Corner<S, N>& point, bool is_on_b,
                                               const Depth& depth) const noexcept {
    return make_vec<N>(
        [&](int i) { return nearest_to<S>(point[i] + normal_[i] * to_surface(is_on_b, depth)); });
  }
  /// The same at a part of the way from one point to another.
  template <class Ratio, Number Depth>
  [[nodiscard]] constexpr Vec<S, N> on_surface(const Corner<S, N>& from, const Corner<S, N>& to,
                                               const Ratio& ratio, bool is_on_b,
                                               const Depth& depth) const noexcept {
    return make_vec<N>([&](int i) {
      return nearest_between<S>(from[i] + normal_[i] * to_surface(is_on_b, depth), to[i] - from[i],
                                ratio);
    });
  }
  template <Number Depth>
  [[nodiscard]] constexpr auto to_surface(bool is_on_b, const Depth& depth) const noexcept {
    return radius_a_ + (is_on_b ? depth : Depth(0));
  }
  template <Number Depth>
  constexpr void push(const Vec<S, N>& point, const Depth& depth, std::uint32_t feature,
                      const Corner<S, N>& place) noexcept {
    const auto whole_depth = radii_ + depth;
    if (whole_depth < lowest_depth_ || points_.is_full()) return;
    points_.add(point, whole_depth < 0 ? S(0) : floor_to<S>(whole_depth), feature, place);
    is_reached_ = is_reached_ || !is_fixed<S> || !(depth < depth_ - steps_of<S>(most_tilt));
  }

  /// How many of the least steps of S the rounding of the normal may move a corner.
  static constexpr int most_tilt = 4;
  /// Calls `find` again, for points that may be slightly apart, if no point is deep enough yet: long
  /// features in one plane may seem apart where they meet, because the normal is rounded.
  template <class Find>
  constexpr void find_tilted(const Find& find) noexcept {
    if constexpr (is_fixed<S>) {
      if (is_reached_) return;
      points_.clear();
      lowest_depth_ = steps_of<S>(-most_tilt);
      find();
      lowest_depth_ = S(0);
    }
  }

  /// Two segments, or a segment and a point, whose projections along the normal are in one line:
  /// `place` is the position along that line, in units whose square is `squared_unit`.
  template <class Square, class Place>
  constexpr void overlap(const Face& reference, const Face& incident, const Face& deepest,
                         const Square& squared_unit, const Place& place) noexcept {
    const auto start = place(reference.corners[0]), end = place(reference.corners[1]);
    const auto& low = start < end ? start : end;
    const auto& high = start < end ? end : start;
    const auto& from = deepest.corners[0];
    const auto& to = deepest.corners[deepest.count - 1];
    const auto find = [&] { overlap_between(low, high, reference, incident, from, place); };
    find();
    if (is_reached_) return;
    // Without the rounding of the normal, they would meet in ends.
    const auto beyond = [&](const auto& p) {
      const auto at = place(p);
      return at < low ? low - at : at - high;
    };
    const bool is_last = beyond(to) < beyond(from);
    const auto distance = is_last ? beyond(to) : beyond(from);
    if (square(distance) > squared_unit * square(steps_of<S>(most_tilt))) find_tilted(find);
    if (is_reached_) return;
    const std::size_t i = is_last ? deepest.count - 1 : 0;
    add(deepest.corners[i], a_is_reference_, depth_,
        both_by_role(edge(reference, 0, 1), corner(deepest, i)));
  }
  template <class At, class Place>
  constexpr void overlap_between(const At& low, const At& high, const Face& reference,
                                 const Face& incident, const Corner<S, N>& deepest,
                                 const Place& place) noexcept {
    for (std::size_t i = 0; i < incident.count; ++i) {
      const auto& q = incident.corners[i];
      const auto at = place(q);
      if (at < low || at > high) continue;
      add(q, a_is_reference_, depth_less(drop(q, deepest)),
          both_by_role(edge(reference, 0, 1), corner(incident, i)));
    }
    const auto& from = incident.corners[0];
    const auto& to = incident.corners[incident.count - 1];
    const auto first = place(from), last = place(to);
    for (std::size_t i = 0; i < 2; ++i) {
      const auto at = place(reference.corners[i]);
      if (!((first < at && at < last) || (last < at && at < first))) continue;
      add_under(reference, i, incident,
                depth_between(drop(from, deepest), drop(to, deepest), at - first, last - first),
                at - first, last - first);
    }
  }

  /// Adds corner i of the reference, part / all of the way along an incident segment.
  template <Number Part, Number All>
  constexpr void add_under(const Face& reference, std::size_t i, const Face& incident,
                           const Far& depth, const Part& part, const All& all) noexcept {
    const auto feature = both_by_role(corner(reference, i), edge(incident, 0, 1));
    if (a_is_reference_) {
      add(reference.corners[i], false, depth, feature);
    } else {
      add_between(incident.corners[0], incident.corners[1], part, all, false, depth, feature,
                  reference.corners[i]);
    }
  }
  /// over / under, rounded to nearest, for under != 0.
  template <Number Over, Number Under>
  [[nodiscard]] static constexpr Far quotient(const Over& over, const Under& under) noexcept {
    return under < 0 ? rounded<Far>(narrow_negative(over), narrow_negative(under))
                     : rounded<Far>(over, under);
  }
  template <Number Drop, Number Part, Number All>
  [[nodiscard]] constexpr Far depth_between(const Drop& from, const Drop& to, const Part& part,
                                            const All& all) const noexcept {
    return depth_less(quotient(from * all + (to - from) * part, all));
  }

  /// Intersects a reference face and an incident feature of a shape whose deepest feature is
  /// `deepest`.
  constexpr void clip(const Face& reference, const Face& incident, const Face& deepest) noexcept
      requires(N == 2) {
    overlap(reference, incident, deepest, S(1),
            [&](const Corner<S, 2>& p) { return cross(seen_, p - reference.corners[0]); });
  }

  constexpr void clip(const Face& reference, const Face& incident, const Face& deepest) noexcept
      requires(N == 3) {
    const auto& lowest = deepest.corners[0];
    with_corners_from(
        reference.corners[0],
        [&](const auto& corners, const auto& incident_corners, const auto& deepest_corners) {
          const auto rim = rim_of(reference, corners);
          const auto incident_rim = rim_of(incident, incident_corners);
          const auto find = [&] { clip_within(reference, rim, incident, incident_rim, lowest, 0); };
          find();
          find_tilted([&] {
            find();
            // Then the deepest feature meets the rim of the reference, but for rounding.
            if (!is_reached_)
              clip_within(reference, rim, deepest, rim_of(deepest, deepest_corners), lowest,
                          most_tilt);
          });
        },
        reference, incident, deepest);
    if (is_reached_) return;
    add(lowest, a_is_reference_, depth_, both_by_role(face, corner(deepest, 0)));
  }

  template <Number T>
  [[nodiscard]] constexpr Rim<T> rim_of(const Face& of,
                                        const VecList<T, 3, Most>& corners) const noexcept {
    return {seen_, corners, of.count};
  }

  /// `slack` is how many of the least steps of S a corner may be outside.
  template <Number T>
  constexpr void clip_within(const Face& reference, const Rim<T>& rim, const Face& incident,
                             const Rim<T>& incident_rim, const Corner<S, 3>& deepest,
                             int slack) noexcept {
    add_points(overlay_of(rim, incident_rim, slack), reference, rim, incident, incident_rim,
               deepest);
  }

  template <Number T>
  constexpr void add_points(const Overlay<Most>& overlay, const Face& reference, const Rim<T>& rim,
                            const Face& incident, const Rim<T>& incident_rim,
                            const Corner<S, 3>& deepest) noexcept {
    const auto for_each_bit = [](std::uint32_t bits, const auto& f) {
      for (; bits != 0; bits &= bits - 1) f(static_cast<std::size_t>(std::countr_zero(bits)));
    };
    for_each_bit(overlay.over, [&](std::size_t k) {
      const auto& q = incident.corners[k];
      add(q, a_is_reference_, depth_less(drop(q, deepest)),
          both_by_role(face, corner(incident, k)));
    });
    for (std::size_t k = 0; k < incident.count; ++k) {
      for_each_bit(overlay.crossed[k], [&](std::size_t i) {
        cross_edges(reference, rim, i, incident, incident_rim, k, deepest);
      });
    }
    for_each_bit(overlay.under, [&](std::size_t i) {
      if (incident.count == 2) {
        add_under_segment(reference, i, incident, deepest);
      } else {
        add_under_face(reference, i, incident, deepest);
      }
    });
  }

  /// Adds corner i of the reference, if it is over the incident segment between its ends.
  constexpr void add_under_segment(const Face& reference, std::size_t i, const Face& incident,
                                   const Corner<S, 3>& deepest) noexcept {
    const auto& from = incident.corners[0];
    const auto& to = incident.corners[1];
    const auto along = cross(normal_, to - from), way = cross(normal_, reference.corners[i] - from);
    const auto part = dot(along, way), all = dot(along, along);
    if (part <= 0 || part >= all) return;
    add_under(reference, i, incident,
              depth_between(drop(from, deepest), drop(to, deepest), part, all), part, all);
  }

  /// Adds corner i of the reference, which is over the incident face.
  constexpr void add_under_face(const Face& reference, std::size_t i, const Face& incident,
                                const Corner<S, 3>& deepest) noexcept {
    const auto& q = incident.corners;
    const auto m = cross(q[1] - q[0], q[2] - q[0]);
    const auto slope = dot(m, normal_);
    if (slope == 0) return;
    const auto w = reference.corners[i] - deepest;
    const auto fall =
        quotient(dot(w, normal_) * slope - dot(m, w) * squared_length(normal_), slope);
    add(reference.corners[i], !a_is_reference_,
        depth_less(a_is_reference_ ? fall : narrow_negative(fall)),
        both_by_role(corner(reference, i), face));
  }

  /// x / (x - y) for numbers of opposite signs.
  template <Number Side>
  [[nodiscard]] static constexpr auto part_of(const Side& x, const Side& y) noexcept {
    const auto all = x - y;
    using All = std::remove_cvref_t<decltype(all)>;
    return x < 0 ? make_ratio_below_one(All(narrow_negative(x)), narrow_negative(all))
                 : make_ratio_below_one(All(x), all);
  }

  /// Adds the crossing of edge i of the reference and edge k of the incident feature.
  template <Number T>
  constexpr void cross_edges(const Face& reference, const Rim<T>& rim, std::size_t i,
                             const Face& incident, const Rim<T>& incident_rim, std::size_t k,
                             const Corner<S, 3>& deepest) noexcept {
    const std::size_t j = rim.next(i), l = incident_rim.next(k);
    const auto part =
        part_of(incident_rim.side(k, rim.corners[i]), incident_rim.side(k, rim.corners[j]));
    const auto incident_part =
        part_of(rim.side(i, incident_rim.corners[k]), rim.side(i, incident_rim.corners[l]));
    const auto& r = reference.corners;
    const auto& q = incident.corners;
    const auto from = drop(q[k], deepest), to = drop(q[l], deepest);
    const Far depth = depth_less(nearest_between<Far>(from, to - from, incident_part));
    const auto feature = both_by_role(edge(reference, i, j), edge(incident, k, l));
    const auto place = make_vec<3>(
        [&](int axis) { return nearest_between<Far>(r[i][axis], r[j][axis] - r[i][axis], part); });
    push(a_is_reference_ ? on_surface(r[i], r[j], part, false, depth)
                         : on_surface(q[k], q[l], incident_part, false, depth),
         depth, feature, place);
  }

  Direction<S, N> normal_;
  Direction<S, N> seen_;  // the positive one of both directions: invariant under swapping
  Far depth_;
  S radius_a_;
  decltype(S() + S()) radii_;
  S lowest_depth_{};
  bool a_is_reference_ = true;
  ContactPoints<S, N, most> points_;
  bool is_reached_ = false;  // whether a point is as deep as the contact, but for rounding
};

}  // namespace detent::detail
