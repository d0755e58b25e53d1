// SPDX-License-Identifier: MIT
#pragma once

#include "detent/dynamics/manifold/clip.hpp"
#include "detent/dynamics/manifold/round.hpp"

namespace detent::detail {

/// A ball about `q` against a box in its own frame. If the distance rounds to 0, the normal is that
/// of the nearest face; the lower axis on ties, the positive face at the center.
template <Scalar S, Number Q, int N>
[[nodiscard]] constexpr Manifold<S, N> ball_in_box(
    const Vec<typename Formats<S>::Lever, N>& half_extents, const Vec<Q, N>& q, const S& radius,
    const typename Formats<S>::Gap& margin) noexcept {
  using Foot = typename ContactFormats<S>::Foot;
  using Gap = typename Formats<S>::Gap;
  using Lever = typename Formats<S>::Lever;
  using Ratio = typename Formats<S>::Ratio;
  const auto fine = nearest_to<Foot>(q), end = nearest_to<Foot>(half_extents);
  auto on_box =
      make_vec<N>([&](int i) { return (clamp)(fine[i], narrow_negative(end[i]), end[i]); });
  Vec<Ratio, N> normal;
  Gap separation;
  const auto d = fine - on_box;
  const auto length = sqrt_nearest<typename ContactFormats<S>::Length>(squared_length(d));
  if (length > 0) {
    separation = nearest_to<Gap>(length - radius);
    if (separation > margin) return {};
    normal = unit_or_x<Ratio>(d);
  } else {
    int axis = 0;
    const auto depth = [&](int i) { return narrow_abs(fine[i]) - end[i]; };
    for (int i = 1; i < N; ++i) {
      if (depth(i) > depth(axis)) axis = i;
    }
    const bool negative = fine[axis] < 0;
    separation = nearest_to<Gap>(depth(axis) - radius);
    if (separation > margin) return {};
    normal = unit_axis<Ratio, N>(axis, negative);
    on_box[axis] = negative ? narrow_negative(end[axis]) : end[axis];
  }
  const auto p = nearest_to<Lever>(on_box + normal * half(separation));
  return one_point<S, N>(normal, p, separation, 0, margin);
}

/// The segment of a capsule against a box in its own frame.
template <Scalar S, int N>
class SegmentInBox {
 public:
  using Foot = typename ContactFormats<S>::Foot;
  using Lever = typename Formats<S>::Lever;
  using Edge = std::remove_cvref_t<decltype(Lever() - Lever())>;

  constexpr SegmentInBox(const Vec<Lever, N>& half_extents, const RoundCore<S, N>& core) noexcept
      : half_(half_extents), core_(core), edge_(core.b - core.a) {
    find_foot();
  }

  /// The point of the segment closest to the box, the first one from a; rounded once.
  [[nodiscard]] constexpr const Vec<Foot, N>& foot() const noexcept { return foot_; }

  /// Whether the segment meets the box.
  [[nodiscard]] constexpr bool meets() const noexcept { return meets_; }

  /// The distance of the foot from the box, rounded once.
  [[nodiscard]] constexpr auto distance() const noexcept {
    const auto end = nearest_to<Foot>(half_);
    return sqrt_nearest<typename ContactFormats<S>::Length>(squared_length(make_vec<N>(
        [&](int i) { return foot_[i] - (clamp)(foot_[i], narrow_negative(end[i]), end[i]); })));
  }

  /// How far the segment is beyond the face of axis `i`: at most the distance.
  [[nodiscard]] constexpr auto beyond(int i) const noexcept {
    return half(abs(core_.a[i] + core_.b[i]) - abs(edge_[i])) - half_[i];
  }

 private:
  using Numerator = std::remove_cvref_t<decltype(Edge() + Edge())>;
  /// The parameter numerator / denominator, in [0, 1].
  struct Parameter {
    Numerator numerator{};
    Numerator denominator{};
  };

  /// Coordinate i at `t` beyond the box, times the denominator: 0 inside its slab.
  [[nodiscard]] constexpr auto excess(int i, const Parameter& t) const noexcept {
    const auto x = core_.a[i] * t.denominator + edge_[i] * t.numerator;
    const auto end = half_[i] * t.denominator;
    using X = std::remove_cvref_t<decltype(x - end + end)>;
    return x > end ? X(x - end) : x < -end ? X(x + end) : X(x - x);
  }

  /// Half the derivative of the squared distance at `t`, times the denominator.
  [[nodiscard]] constexpr auto slope(const Parameter& t) const noexcept {
    return dot(make_vec<N>([&](int i) { return excess(i, t); }), edge_);
  }

  [[nodiscard]] constexpr bool is_inside(const Parameter& t) const noexcept {
    for (int i = 0; i < N; ++i) {
      if (excess(i, t) != 0) return false;
    }
    return true;
  }

  constexpr void find_foot() noexcept {
    // The slope is linear between the crossings of face planes, and never decreases.
    std::array<Parameter, std::size_t{2 + 2 * N}> stops{};
    std::size_t count = 2;
    const auto one = positive<Numerator>();
    stops[0] = {Numerator(), one};
    stops[1] = {one, one};
    for (int i = 0; i < N; ++i) {
      if (edge_[i] == 0) continue;
      const auto length = Numerator(abs(edge_[i]));
      for (const bool negative : {false, true}) {
        const auto to_end = negative ? -half_[i] - core_.a[i] : half_[i] - core_.a[i];
        const auto along = edge_[i] < 0 ? Numerator(-to_end) : Numerator(to_end);
        if (along <= 0 || along >= length) continue;
        std::size_t at = count++;
        for (; stops[at - 1].numerator * length > along * stops[at - 1].denominator; --at) {
          stops[at] = stops[at - 1];
        }
        stops[at] = {along, length};
      }
    }
    if (slope(stops[0]) >= 0) {
      foot_ = nearest_to<Foot>(core_.a);
      meets_ = is_inside(stops[0]);
      return;
    }
    std::size_t last = 1;
    while (last + 1 < count && slope(stops[last]) < 0) ++last;
    const auto at_last = slope(stops[last]);
    if (at_last < 0) {
      foot_ = nearest_to<Foot>(core_.b);
      return;
    }
    meets_ = at_last == 0 && is_inside(stops[last]);
    // The same planes apply between the stop before `last` and `last`.
    solve(stops[last - 1], stops[last]);
  }

  constexpr void solve(const Parameter& from, const Parameter& to) noexcept {
    using Over = Numerator;
    const auto outside = make_vec<N>([&](int i) {
      const auto before = excess(i, from), after = excess(i, to);
      if (before > 0 || after > 0) return Over(core_.a[i] - half_[i]);
      return before < 0 || after < 0 ? Over(core_.a[i] + half_[i]) : Over();
    });
    const auto passed = make_vec<N>(
        [&](int i) { return excess(i, from) == 0 && excess(i, to) == 0 ? Edge() : edge_[i]; });
    const auto whole = dot(passed, edge_);
    const auto share = -dot(outside, edge_);
    foot_ = make_vec<N>([&](int i) {
      return nearest_to<Foot>(core_.a[i] + quotient_nearest<Foot>(edge_[i] * share, whole));
    });
  }

  const Vec<Lever, N>& half_;
  const RoundCore<S, N>& core_;
  Vec<Edge, N> edge_;
  Vec<Foot, N> foot_{};
  bool meets_ = false;
};

/// The axis of greatest separation across the segment and, in 3D, an edge of the box, for a segment
/// that meets the box.
template <Scalar S, int N>
struct AcrossAxis {
  using Length = typename ContactFormats<S>::Length;
  using Lever = typename Formats<S>::Lever;
  using Edge = std::remove_cvref_t<decltype(-(Lever() - Lever()))>;

  Length separation{};
  Vec<Edge, N> direction{};  // from the box to the segment; 0: there is none
  int axis = 0;              // of the edge
};

template <Scalar S, int N>
[[nodiscard]] constexpr AcrossAxis<S, N> best_across(
    const Vec<typename Formats<S>::Lever, N>& half_extents, const RoundCore<S, N>& core) noexcept {
  using Result = AcrossAxis<S, N>;
  using Edge = typename Result::Edge;
  using Root = typename ContactFormats<S>::Foot;
  Result best;
  bool found = false;
  const auto edge = core.b - core.a;
  const auto whole = squared_length(edge);
  for (int i = 0; i < (N == 2 ? 1 : 3); ++i) {
    Vec<Edge, N> l{};
    const int i1 = N == 2 ? 0 : (i + 1) % 3, i2 = N == 2 ? 1 : (i + 2) % 3;
    l[i1] = Edge(edge[i2]);
    l[i2] = -edge[i1];
    const auto squared = squared_length(l);
    if (squared * as_operand<S>(4096) < whole || squared <= 0) continue;
    const auto along = dot(l, core.a + core.b);
    const auto reach = dot(make_vec<N>([&](int c) { return Edge(abs(l[c])); }), half_extents);
    const auto s = half(abs(along)) - reach;
    const auto q = quotient_nearest<typename Result::Length>(s, sqrt_floor<Root>(squared));
    if (found && q <= best.separation) continue;
    found = true;
    best.separation = q;
    best.direction = along < 0 ? make_vec<N>([&](int c) { return Edge(-l[c]); }) : l;
    best.axis = i;
  }
  return best;
}

/// One point: the segment penetrates the edge (in 2D the corner) of the box.
template <Scalar S, int N>
[[nodiscard]] constexpr Manifold<S, N> across_manifold(
    const Vec<typename Formats<S>::Lever, N>& half_extents, const RoundCore<S, N>& core,
    const AcrossAxis<S, N>& best, const typename Formats<S>::Gap& margin) noexcept {
  using Foot = typename ContactFormats<S>::Foot;
  using Gap = typename Formats<S>::Gap;
  using Lever = typename Formats<S>::Lever;
  const auto separation = nearest_to<Gap>(best.separation - core.radius);
  if (separation > margin) return {};
  const auto middle = core.a + core.b;
  Vec<Lever, N> corner;
  for (int c = 0; c < N; ++c) {
    const auto& d = best.direction[c];
    const bool negative = d < 0 || (d == 0 && middle[c] < 0);
    corner[c] = negative ? narrow_negative(half_extents[c]) : half_extents[c];
  }
  // The point of the segment closest to the edge, seen along the edge.
  const auto edge = core.b - core.a;
  auto flat = edge;
  auto offset = corner - core.a;
  if constexpr (N == 3) {
    flat[best.axis] = std::remove_cvref_t<decltype(edge.x)>(0);
    offset[best.axis] = std::remove_cvref_t<decltype(offset.x)>(0);
  }
  const auto along = dot(offset, flat);
  const auto whole = squared_length(flat);
  const auto on_segment =
      along <= 0 ? nearest_to<Foot>(core.a)
      : along >= whole
          ? nearest_to<Foot>(core.b)
          : make_vec<N>([&](int i) {
              return nearest_to<Foot>(core.a[i] + quotient_nearest<Foot>(edge[i] * along, whole));
            });
  const auto normal = unit_or_x<typename Formats<S>::Ratio>(best.direction);
  const auto back = half(core.radius + best.separation);
  return one_point<S, N>(normal, nearest_to<Lever>(on_segment - normal * back), separation, 4,
                         margin);
}

/// The segment over the face of `axis`: its part between the face's sides, a point at each end.
template <Scalar S, int N>
[[nodiscard]] constexpr Manifold<S, N> segment_on_face(
    const Vec<typename Formats<S>::Lever, N>& half_extents, const RoundCore<S, N>& core, int axis,
    const typename Formats<S>::Gap& margin) noexcept {
  using Corner = typename ContactFormats<S>::Corner;
  using Gap = typename Formats<S>::Gap;
  using Lever = typename Formats<S>::Lever;
  const bool negative = core.a[axis] + core.b[axis] < 0;
  ClippedFace<Corner, N, true> part;
  part.add(nearest_to<Corner>(axis_first(core.a, axis)), 0);
  part.add(nearest_to<Corner>(axis_first(core.b, axis)), 1);
  const auto ends = axis_first(half_extents, axis);
  const auto end = [&](int c) { return ends[c] + ContactFormats<S>::tolerance; };
  part.template clip<1>(end(1), false, 2);
  part.template clip<1>(end(1), true, 3);
  if constexpr (N == 3) {
    part.template clip<2>(end(2), false, 4);
    part.template clip<2>(end(2), true, 5);
  }
  Manifold<S, N> result;
  result.normal = unit_axis<typename Formats<S>::Ratio, N>(axis, negative);
  for (int v = 0; v < part.count; ++v) {
    const auto& p = part.points[static_cast<std::size_t>(v)];
    const auto height = negative ? -p[0] : p[0] + decltype(p[0] - p[0])(0);
    const auto separation = nearest_to<Gap>((height - ends[0]) - core.radius);
    if (separation > margin) continue;
    const auto back = core.radius + half(separation);
    const auto at = make_vec<N>([&](int c) {
      const auto shift = c == 0 ? back : decltype(back)(0);
      return nearest_to<Lever>(negative ? p[c] + shift : p[c] - shift);
    });
    const auto name = static_cast<std::uint32_t>(part.lines[static_cast<std::size_t>(v)]);
    const auto face = static_cast<std::uint32_t>(2 * axis + (negative ? 1 : 0));
    result.points[static_cast<std::size_t>(result.count++)] = {axis_back(at, axis), separation,
                                                               8 + 8 * face + name};
  }
  return result;
}

/// A box in its own frame, and a round shape in the same frame. The face is used unless the closest
/// points, or an axis across, are better by more than the tolerance.
template <Scalar S, int N>
[[nodiscard]] constexpr Manifold<S, N> box_round_manifold(
    const Vec<typename Formats<S>::Lever, N>& half_extents, const RoundCore<S, N>& core,
    const typename Formats<S>::Gap& margin) noexcept {
  if (core.a == core.b) return ball_in_box(half_extents, core.a, core.radius, margin);
  const SegmentInBox<S, N> segment(half_extents, core);
  int axis = 0;
  for (int i = 1; i < N; ++i) {
    if (segment.beyond(i) > segment.beyond(axis)) axis = i;
  }
  const auto limit = segment.beyond(axis) + ContactFormats<S>::tolerance;
  if (segment.meets()) {
    const auto across = best_across(half_extents, core);
    if (across.direction != decltype(across.direction){} && across.separation > limit) {
      return across_manifold(half_extents, core, across, margin);
    }
    return segment_on_face(half_extents, core, axis, margin);
  }
  const auto single = ball_in_box(half_extents, segment.foot(), core.radius, margin);
  if (single.count == 0 || segment.distance() > limit) return single;
  const auto both = segment_on_face(half_extents, core, axis, margin);
  return both.count > 0 ? both : single;
}

}  // namespace detent::detail
