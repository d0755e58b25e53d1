// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "detent/query/contact/contact.hpp"
#include "detent/query/contact/feature.hpp"
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
template <Scalar S, int N>
class ContactBuilder {
 public:
  /// `depth` is that of the cores (negative if they are apart), `radius_a` the radius of the first
  /// shape, `radii` the sum of both.
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
  constexpr void meet(Feature<S, N> a, Feature<S, N> b, const WideA& wide_a,
                      const WideB& wide_b) noexcept {
    a = outline(a, seen_);
    b = outline(b, seen_);
    const bool a_is_face = a.count >= std::size_t{N}, b_is_face = b.count >= std::size_t{N};
    // If both are faces, the one with the positive normal, so that swapping the shapes keeps the
    // choice.
    a_is_reference_ = a_is_face && (!b_is_face || seen_ == normal_);
    if (a_is_reference_) {
      clip(a, b_is_face ? b : incident_of(wide_b(b), b), b.corners[0]);
    } else if (b_is_face) {
      clip(b, a_is_face ? a : incident_of(wide_a(a), a), a.corners[0]);
    } else if (a.count == 1) {
      add(a.corners[0], false, depth_, both(corner(a, 0), corner_or_edge(b)));
    } else if (b.count == 1) {
      add(b.corners[0], true, depth_, both(corner_or_edge(a), corner(b, 0)));
    } else if constexpr (N == 3) {
      const auto e = a.corners[1] - a.corners[0], f = b.corners[1] - b.corners[0];
      const auto all = dot(normal_, cross(e, f));
      if (all == 0) {
        a_is_reference_ = seen_ == normal_;
        const auto& first = a_is_reference_ ? a : b;
        const auto& other = a_is_reference_ ? b : a;
        const auto along = first.corners[1] - first.corners[0];
        overlap(first, other, other.corners[0],
                [&](const Corner<S, 3>& p) { return dot(along, p - first.corners[0]); });
      } else {
        const auto part = dot(normal_, cross(b.corners[0] - a.corners[0], f));
        add_between(a.corners[0], a.corners[1], part, all, false, depth_,
                    both(edge(a, 0, 1), edge(b, 0, 1)), a.corners[0]);
      }
    }
    if (count_ == 0) add(b.corners[0], true, depth_, both(face, corner(b, 0)));
  }

  /// Intersects a plane, one of the shapes, and a feature of the other, whose deepest feature is
  /// `deepest`.
  constexpr void meet_plane(bool plane_is_a, const Feature<S, N>& feature,
                            const Feature<S, N>& deepest) noexcept {
    a_is_reference_ = plane_is_a;
    const auto incident = incident_of(feature, deepest);
    const auto& lowest = deepest.corners[0];
    for (std::size_t i = 0; i < incident.count; ++i) {
      add(incident.corners[i], plane_is_a, depth_less(drop(incident.corners[i], lowest)),
          both_by_role(face, corner(incident, i)));
    }
    if (count_ == 0) add(lowest, plane_is_a, depth_, both_by_role(face, corner(incident, 0)));
  }

  /// Writes the points to keep: the deepest, the farthest from it, and in 3D those that add the
  /// largest area on either side of the line through these two. Ties go to the first point.
  constexpr void write(Contact<S, N>& contact) const noexcept {
    const auto best = [&](const auto& value) {
      std::size_t found = 0;
      for (std::size_t i = 1; i < count_; ++i) {
        if (value(i) > value(found)) found = i;
      }
      return found;
    };
    const auto keep = [&](std::size_t i) { contact.points[contact.count++] = points_[i]; };
    contact.count = 0;
    if (count_ == 0) return;
    const auto first = best([&](std::size_t i) { return points_[i].depth; });
    keep(first);
    const auto& p = places_[first];
    const auto second = best([&](std::size_t i) { return squared_distance(p, places_[i]); });
    if (second == first) return;
    keep(second);
    if constexpr (N == 3) {
      const auto& q = places_[second];
      const auto area = [&](std::size_t i) { return turn_of(seen_, p, q, places_[i]); };
      const auto left = best(area);
      if (area(left) > 0) keep(left);
      const auto right = best([&](std::size_t i) { return -area(i); });
      if (area(right) < 0) keep(right);
    }
  }

 private:
  using Far = Length<S>;
  static constexpr std::uint32_t face = 0xffff;
  static constexpr std::size_t most = 4 * Feature<S, N>::most;

  [[nodiscard]] static constexpr std::uint32_t edge(const Feature<S, N>& feature, std::size_t i,
                                                    std::size_t j) noexcept {
    const std::uint32_t p = feature.numbers[i], q = feature.numbers[j];
    return p < q ? p | q << 8 : q | p << 8;
  }
  [[nodiscard]] static constexpr std::uint32_t corner(const Feature<S, N>& feature,
                                                      std::size_t i) noexcept {
    return edge(feature, i, i);
  }
  [[nodiscard]] static constexpr std::uint32_t corner_or_edge(
      const Feature<S, N>& feature) noexcept {
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

  /// The outline of a face. A face seen edge-on is its two ends; if the deepest feature is in
  /// between, only that counts.
  [[nodiscard]] constexpr Feature<S, N> incident_of(const Feature<S, N>& wide,
                                                    const Feature<S, N>& deepest) const noexcept {
    const auto seen = outline(wide, seen_);
    if (seen.count >= std::size_t{N}) return seen;
    for (std::size_t i = 0; i < seen.count; ++i) {
      for (std::size_t k = 0; k < deepest.count; ++k) {
        if (seen.corners[i] == deepest.corners[k]) return seen;
      }
    }
    return outline(deepest, seen_);
  }

  /// How much less deeply than `deepest` a point of the incident feature reaches into the
  /// reference.
  [[nodiscard]] constexpr auto drop(const Corner<S, N>& point,
                                    const Corner<S, N>& deepest) const noexcept {
    return a_is_reference_ ? dot(normal_, point - deepest) : dot(normal_, deepest - point);
  }
  template <Number T>
  [[nodiscard]] constexpr Far depth_less(const T& drop) const noexcept {
    return nearest_to<Far>(depth_ - drop);
  }

  /// Adds a point of the core of a or, if `is_on_b`, of b, where the cores are `depth` deep.
  template <Number Depth>
  constexpr void add(const Corner<S, N>& point, bool is_on_b, const Depth& depth,
                     std::uint32_t feature) noexcept {
    push(make_vec<N>([&](int i) {
           return nearest_to<S>(point[i] + normal_[i] * to_surface(is_on_b, depth));
         }),
         depth, feature, point);
  }
  /// Adds the point at part / all of the way from one point to another, at most all of it.
  template <Number Part, Number All, Number Depth>
  constexpr void add_between(const Corner<S, N>& from, const Corner<S, N>& to, const Part& part,
                             const All& all, bool is_on_b, const Depth& depth,
                             std::uint32_t feature, const Corner<S, N>& place) noexcept {
    const All whole = all < 0 ? narrow_negative(all) : all;
    const All ahead(all < 0 ? narrow_negative(part) : part);
    const All along = ahead < 0 ? All(0) : ahead > whole ? whole : ahead;
    push(make_vec<N>([&](int i) {
           const auto start = from[i] + normal_[i] * to_surface(is_on_b, depth);
           return rounded<S>(start * whole + (to[i] - from[i]) * along, whole);
         }),
         depth, feature, place);
  }
  template <Number Depth>
  [[nodiscard]] constexpr auto to_surface(bool is_on_b, const Depth& depth) const noexcept {
    return radius_a_ + (is_on_b ? depth : Depth(0));
  }
  template <Number Depth>
  constexpr void push(const Vec<S, N>& point, const Depth& depth, std::uint32_t feature,
                      const Corner<S, N>& place) noexcept {
    const auto whole_depth = radii_ + depth;
    if (whole_depth < 0 || count_ == most) return;
    places_[count_] = place;
    points_[count_++] = {point, floor_to<S>(depth < depth_ ? whole_depth : radii_ + depth_),
                         feature};
  }

  /// Two segments, or a segment and a point, whose projections along the normal are in one line:
  /// `place` is the position along that line.
  template <class Place>
  constexpr void overlap(const Feature<S, N>& reference, const Feature<S, N>& incident,
                         const Corner<S, N>& deepest, const Place& place) noexcept {
    const auto start = place(reference.corners[0]), end = place(reference.corners[1]);
    const auto& low = start < end ? start : end;
    const auto& high = start < end ? end : start;
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
    if (count_ > 0) return;
    // Without the rounding of the normal, they would meet in ends.
    const auto beyond = [&](const auto& at) { return at < low ? low - at : at - high; };
    const std::size_t i = beyond(last) < beyond(first) ? incident.count - 1 : 0;
    add(incident.corners[i], a_is_reference_, depth_,
        both_by_role(edge(reference, 0, 1), corner(incident, i)));
  }

  /// Adds corner i of the reference, part / all of the way along an incident segment.
  template <Number Part, Number All>
  constexpr void add_under(const Feature<S, N>& reference, std::size_t i,
                           const Feature<S, N>& incident, const Far& depth, const Part& part,
                           const All& all) noexcept {
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

  constexpr void clip(const Feature<S, 2>& reference, const Feature<S, 2>& incident,
                      const Corner<S, 2>& deepest) noexcept {
    overlap(reference, incident, deepest,
            [&](const Corner<S, 2>& p) { return cross(seen_, p - reference.corners[0]); });
  }

  constexpr void clip(const Feature<S, 3>& reference, const Feature<S, 3>& incident,
                      const Corner<S, 3>& deepest) noexcept {
    clip_within(reference, incident, deepest, 0);
    // Without the rounding of the normal, they would meet in their rims.
    if (count_ == 0) clip_within(reference, incident, deepest, 4);
    if (count_ > 0) return;
    add(deepest, a_is_reference_, depth_, both_by_role(face, corner(incident, 0)));
  }

  /// `slack` is how many steps of S a corner may be outside.
  constexpr void clip_within(const Feature<S, 3>& reference, const Feature<S, 3>& incident,
                             const Corner<S, 3>& deepest, int slack) noexcept {
    for (std::size_t i = 0; i < incident.count; ++i) {
      const auto& q = incident.corners[i];
      if (!is_over(reference, q, slack)) continue;
      add(q, a_is_reference_, depth_less(drop(q, deepest)),
          both_by_role(face, corner(incident, i)));
    }
    cross_all_edges(reference, incident, deepest);
    for (std::size_t i = 0; i < reference.count && incident.count > 1; ++i) {
      const auto& r = reference.corners[i];
      bool is_corner = false;
      for (std::size_t k = 0; k < incident.count; ++k) {
        is_corner = is_corner || is_zero(cross(seen_, r - incident.corners[k]));
      }
      if (is_corner || !is_over(incident, r, slack)) continue;
      if (incident.count == 2) {
        add_under_segment(reference, i, incident, deepest);
      } else {
        add_under_face(reference, i, incident, deepest);
      }
    }
  }

  /// Adds corner i of the reference, if it is over the incident segment between its ends.
  constexpr void add_under_segment(const Feature<S, 3>& reference, std::size_t i,
                                   const Feature<S, 3>& incident,
                                   const Corner<S, 3>& deepest) noexcept {
    const auto& from = incident.corners[0];
    const auto& to = incident.corners[1];
    const auto e = to - from, w = reference.corners[i] - from;
    const auto part = dot(e, w) - dot(normal_, e) * dot(normal_, w);
    const auto all = dot(e, e) - dot(normal_, e) * dot(normal_, e);
    if (part <= 0 || part >= all) return;
    add_under(reference, i, incident,
              depth_between(drop(from, deepest), drop(to, deepest), part, all), part, all);
  }

  /// Adds corner i of the reference, which is over the incident face.
  constexpr void add_under_face(const Feature<S, 3>& reference, std::size_t i,
                                const Feature<S, 3>& incident,
                                const Corner<S, 3>& deepest) noexcept {
    const auto& q = incident.corners;
    const auto m = cross(q[1] - q[0], q[2] - q[0]);
    const auto slope = dot(m, normal_);
    if (slope == 0) return;
    const auto w = reference.corners[i] - deepest;
    const auto fall =
        quotient_nearest<Far>(dot(w, normal_) * slope - dot(m, w) * squared_length(normal_), slope);
    add(reference.corners[i], !a_is_reference_,
        depth_less(a_is_reference_ ? fall : narrow_negative(fall)),
        both_by_role(corner(reference, i), face));
  }

  /// Whether a point is over an outline, or at most `slack` steps outside.
  [[nodiscard]] constexpr bool is_over(const Feature<S, 3>& outline, const Corner<S, 3>& point,
                                       int slack) const noexcept {
    for (std::size_t i = 0; i < outline.count; ++i) {
      const auto& p = outline.corners[i];
      const auto& q = outline.corners[i + 1 < outline.count ? i + 1 : 0];
      const auto turn = turn_of(seen_, p, q, point);
      if (turn >= 0) continue;
      if (slack == 0) return false;
      if (square(turn) > squared_distance(p, q) * square(steps(slack))) return false;
    }
    return true;
  }
  [[nodiscard]] static constexpr S steps(int count) noexcept {
    if constexpr (is_fixed<S>) {
      return S::from_raw(static_cast<typename S::raw_type>(count));
    } else {
      return S(0);
    }
  }

  using Turn = decltype(turn_of(Direction<S, 3>(), Corner<S, 3>(), Corner<S, 3>(), Corner<S, 3>()));

  /// Adds the crossings of all edges of the reference and the incident feature.
  constexpr void cross_all_edges(const Feature<S, 3>& reference, const Feature<S, 3>& incident,
                                 const Corner<S, 3>& deepest) noexcept {
    const auto& r = reference.corners;
    const auto next = [&](std::size_t i) { return i + 1 < reference.count ? i + 1 : 0; };
    const std::size_t edges = incident.count < 3 ? incident.count - 1 : incident.count;
    if (edges == 0) return;
    // The side of the incident corners relative to the edges of the reference: the first corner,
    // and in turn the two ends of an edge.
    std::array<std::array<Turn, Feature<S, 3>::most>, 3> sides{};
    const auto find = [&](std::size_t at, std::size_t k) {
      for (std::size_t i = 0; i < reference.count; ++i) {
        sides[at][i] = turn_of(seen_, r[i], r[next(i)], incident.corners[k]);
      }
      return at;
    };
    for (std::size_t k = 0, start = find(0, 0), end = 0; k < edges; ++k, start = end) {
      const std::size_t l = k + 1 < incident.count ? k + 1 : 0;
      end = l == 0 ? 0 : find(1 + k % 2, l);
      for (std::size_t i = 0; i < reference.count; ++i) {
        const auto& from = sides[start][i];
        const auto& to = sides[end][i];
        if (!are_opposite(from, to)) continue;
        cross_edges(reference, i, next(i), incident, k, l, from, to, deepest);
      }
    }
  }
  [[nodiscard]] static constexpr bool are_opposite(const Turn& x, const Turn& y) noexcept {
    return (x < 0 && y > 0) || (x > 0 && y < 0);
  }

  /// Adds the crossing of the edge from i to j of the reference and the edge from k to l of the
  /// incident feature, between the ends of both; `from` and `to` are the sides of the first edge on
  /// which the second starts and ends.
  constexpr void cross_edges(const Feature<S, 3>& reference, std::size_t i, std::size_t j,
                             const Feature<S, 3>& incident, std::size_t k, std::size_t l,
                             const Turn& from, const Turn& to,
                             const Corner<S, 3>& deepest) noexcept {
    const auto& r = reference.corners;
    const auto& q = incident.corners;
    const auto start = turn_of(seen_, q[k], q[l], r[i]), end = turn_of(seen_, q[k], q[l], r[j]);
    if (!are_opposite(start, end)) return;
    const auto depth = depth_between(drop(q[k], deepest), drop(q[l], deepest), from, from - to);
    const auto feature = both_by_role(edge(reference, i, j), edge(incident, k, l));
    const auto all = start - end;
    const auto place = make_vec<3>([&](int axis) {
      return quotient(r[i][axis] * all + (r[j][axis] - r[i][axis]) * start, all);
    });
    if (a_is_reference_) {
      add_between(r[i], r[j], start, all, false, depth, feature, place);
    } else {
      add_between(q[k], q[l], from, from - to, false, depth, feature, place);
    }
  }

  Direction<S, N> normal_;
  Direction<S, N> seen_;  // the positive one of both directions: invariant under swapping
  Far depth_;
  S radius_a_;
  decltype(S() + S()) radii_;
  bool a_is_reference_ = true;
  std::array<ContactPoint<S, N>, most> points_{};
  // The positions by which to choose the points to keep: on the grid, invariant under swapping the
  // shapes.
  std::array<Corner<S, N>, most> places_{};
  std::size_t count_ = 0;
};

}  // namespace detent::detail
