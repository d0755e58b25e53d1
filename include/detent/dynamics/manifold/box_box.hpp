// SPDX-License-Identifier: MIT
#pragma once

#include "detent/dynamics/manifold/clip.hpp"
#include "detent/dynamics/manifold/pose.hpp"

namespace detent::detail {

/// The separations along the faces' axes of two boxes, exactly: that of a's axis i is
/// |t_i| - a_i - sum |r_ij| b_j, that of b's axis j is |t . r_j| - b_j - sum |r_ij| a_i.
///
/// All of it fits 64 bits: with levers below L = 2^31 steps and rows of r of length at most 1 +
/// 2^-28, |t . r_j| is at most sqrt(3) L and the rest, of the opposite sign, at most (1 + sqrt(3))
/// L, both times 2^30; and 2.74 times 2^61 is below 2^63.
template <Scalar S, int N>
struct FaceAxes {
  using Span = typename ContactFormats<S>::Span;
  static constexpr int bits = bits_of<Span>;

  /// r_ij at row i and column j: component i of b's axis j.
  [[nodiscard]] constexpr auto row(int i) const noexcept {
    return make_vec<N>([&](int j) { return pose.axes[static_cast<std::size_t>(j)][i]; });
  }

  template <Number T, int M>
  [[nodiscard]] static constexpr auto magnitudes(const Vec<T, M>& v) noexcept {
    return make_vec<M>([&](int i) { return narrow_abs(v[i]); });
  }

  [[nodiscard]] constexpr Span of_a(int i) const noexcept {
    using Ratio = typename ContactFormats<S>::Ratio;
    const auto reach = narrow_dot<bits>(magnitudes(row(i)), b);
    return narrow_difference<bits>(narrow_product<bits>(abs(pose.translation[i]) - a[i], Ratio(1)),
                                   reach);
  }

  /// t . r_j
  [[nodiscard]] constexpr Span along_b(int j) const noexcept {
    return narrow_dot<bits>(pose.translation, pose.axes[static_cast<std::size_t>(j)]);
  }

  [[nodiscard]] constexpr Span of_b(int j) const noexcept {
    using Ratio = typename ContactFormats<S>::Ratio;
    const auto own = narrow_product<bits>(b[j], Ratio(1));
    const auto reach = narrow_dot<bits>(magnitudes(pose.axes[static_cast<std::size_t>(j)]), a);
    return narrow_difference<bits>(narrow_difference<bits>(narrow_abs(along_b(j)), own), reach);
  }

  const RelativePose<S, N>& pose;
  const Vec<typename Formats<S>::Lever, N>& a;
  const Vec<typename Formats<S>::Lever, N>& b;
};

/// A gap on the grid of exact separations.
template <Scalar S, class Gap = typename Formats<S>::Gap>
[[nodiscard]] constexpr auto exact_span(const Gap& gap) noexcept {
  return narrow_product<FaceAxes<S, 3>::bits>(gap, typename Formats<S>::Ratio(1));
}

/// The axis of greatest separation of two boxes: 0 to N - 1 for a's, N to 2 N - 1 for b's, and in
/// 3D 2 N + 3 i + j for the edges along axis i of a and axis j of b.
template <Scalar S>
struct BestAxis {
  int index = -1;
  typename Formats<S>::Gap separation{};
};

/// The best face axis: a's first, b's only if its separation is greater by more than the tolerance;
/// the lower index on ties. Index -1 if a separation exceeds the margin.
template <Scalar S, int N>
[[nodiscard]] constexpr BestAxis<S> best_face(const FaceAxes<S, N>& axes,
                                              const typename Formats<S>::Gap& margin) noexcept {
  using Formats = ContactFormats<S>;
  auto best = axes.of_a(0);
  int index = 0;
  for (int i = 1; i < N; ++i) {
    const auto s = axes.of_a(i);
    if (s > best) best = s, index = i;
  }
  const auto most = exact_span<S>(margin);
  if (best > most) return {};
  auto best_of_b = axes.of_b(0);
  int index_of_b = 0;
  for (int j = 1; j < N; ++j) {
    const auto s = axes.of_b(j);
    if (s > best_of_b) best_of_b = s, index_of_b = j;
  }
  if (best_of_b > most) return {};
  // `best` is at most the margin.
  const auto least = narrow_sum<FaceAxes<S, N>::bits>(best, exact_span<S>(Formats::tolerance));
  if (best_of_b > least) {
    best = best_of_b;
    index = N + index_of_b;
  }
  return {index, nearest_to<typename Formats::Gap>(best)};
}

/// The reference face of one box, and the other box in its frame.
template <Scalar S, int N>
struct FaceView {
  using Lever = typename Formats<S>::Lever;
  using Ratio = typename Formats<S>::Ratio;
  using Corner = typename ContactFormats<S>::Corner;

  bool of_b;       // the reference is a face of b
  int axis;        // of the reference
  bool negative;   // the face looks along -axis
  int other_axis;  // of the incident face
  bool other_negative;

  /// Component `k` of the other box's axis `m` in the frame of the reference.
  [[nodiscard]] constexpr const Ratio& entry(const RelativePose<S, N>& pose, int k,
                                             int m) const noexcept {
    return of_b ? pose.axes[static_cast<std::size_t>(k)][m]
                : pose.axes[static_cast<std::size_t>(m)][k];
  }
};

/// The incident face is the one whose normal is most opposed to that of the reference; the lower
/// axis on ties, and the positive face if it is perpendicular.
template <Scalar S, int N>
[[nodiscard]] constexpr FaceView<S, N> face_view(const FaceAxes<S, N>& axes, int index) noexcept {
  FaceView<S, N> view{};
  view.of_b = index >= N;
  view.axis = index % N;
  view.negative = view.of_b ? axes.along_b(view.axis) >= 0 : axes.pose.translation[view.axis] < 0;
  const auto& pose = axes.pose;
  for (int m = 1; m < N; ++m) {
    if (narrow_abs(view.entry(pose, view.axis, m)) >
        narrow_abs(view.entry(pose, view.axis, view.other_axis))) {
      view.other_axis = m;
    }
  }
  const auto& cosine = view.entry(pose, view.axis, view.other_axis);
  view.other_negative = view.negative ? cosine < 0 : cosine > 0;
  return view;
}

/// Corner `v` of the incident face in the frame of the reference, with the reference's axis first;
/// each coordinate rounded once. In 3D around the face: (+, +), (-, +), (-, -), (+, -).
template <Scalar S, int N>
[[nodiscard]] constexpr Vec<typename ContactFormats<S>::Corner, N> incident_corner(
    const FaceAxes<S, N>& axes, const FaceView<S, N>& view, int v) noexcept {
  using Corner = typename ContactFormats<S>::Corner;
  using Ratio = typename Formats<S>::Ratio;
  constexpr int bits = FaceAxes<S, N>::bits;
  const auto& half = view.of_b ? axes.a : axes.b;
  const int signs = v ^ (v >> 1);
  Vec<typename Formats<S>::Lever, N> p;
  for (int c = 0; c < N; ++c) {
    const int m = (view.other_axis + c) % N;
    const bool negative = c == 0 ? view.other_negative : (signs >> (c - 1)) % 2 != 0;
    p[m] = negative ? narrow_negative(half[m]) : half[m];
  }
  const auto& pose = axes.pose;
  if (view.of_b) {  // a's corner from b's center, along b's axes: below 2 sqrt(3) 2^61
    const auto offset = p - pose.translation;
    return axis_first(make_vec<N>([&](int j) {
                        return nearest_to<Corner>(
                            narrow_dot<bits>(offset, pose.axes[static_cast<std::size_t>(j)]));
                      }),
                      view.axis);
  }
  return axis_first(
      make_vec<N>([&](int i) {
        return nearest_to<Corner>(narrow_sum<bits>(
            narrow_product<bits>(pose.translation[i], Ratio(1)), narrow_dot<bits>(axes.row(i), p)));
      }),
      view.axis);
}

/// The corners of the incident face, in order. In fixed point each product is computed once: sums
/// are exact, so their order does not matter. Partial sums have the bounds of the whole.
template <Scalar S, int N>
[[nodiscard]] constexpr auto incident_face(const FaceAxes<S, N>& axes,
                                           const FaceView<S, N>& view) noexcept {
  using Corner = typename ContactFormats<S>::Corner;
  ClippedFace<Corner, N> face;
  if constexpr (is_fixed<S> && N == 3) {
    constexpr int bits = FaceAxes<S, 3>::bits;
    const auto& half = view.of_b ? axes.a : axes.b;
    const int m = view.other_axis, m1 = m == 2 ? 0 : m + 1, m2 = m == 0 ? 2 : m - 1;
    std::array<Vec<Corner, 3>, 4> corners;
    for (int c = 0, k = view.axis; c < 3; ++c, k = k == 2 ? 0 : k + 1) {
      const auto part = [&](int i) {
        return narrow_product<bits>(view.entry(axes.pose, k, i), half[i]);
      };
      const auto center =
          view.of_b ? narrow_negative(axes.along_b(k)) : exact_span<S>(axes.pose.translation[k]);
      const auto x = part(m), y = part(m1), z = part(m2);
      const auto middle =
          view.other_negative ? narrow_difference<bits>(center, x) : narrow_sum<bits>(center, x);
      const auto right = narrow_sum<bits>(middle, y), left = narrow_difference<bits>(middle, y);
      corners[0][c] = nearest_to<Corner>(narrow_sum<bits>(right, z));
      corners[1][c] = nearest_to<Corner>(narrow_sum<bits>(left, z));
      corners[2][c] = nearest_to<Corner>(narrow_difference<bits>(left, z));
      corners[3][c] = nearest_to<Corner>(narrow_difference<bits>(right, z));
    }
    for (int v = 0; v < 4; ++v) face.add(corners[static_cast<std::size_t>(v)], v);
  } else {
    for (int v = 0; v < face.corners; ++v) face.add(incident_corner(axes, view, v), v);
  }
  return face;
}

/// The point midway between the surfaces, in the frame of a. `p` is on the incident face, in the
/// frame of the reference with its axis first.
template <Scalar S, int N>
[[nodiscard]] constexpr Vec<typename Formats<S>::Lever, N> midway(
    const FaceAxes<S, N>& axes, const FaceView<S, N>& view,
    const Vec<typename ContactFormats<S>::Corner, N>& p,
    const typename Formats<S>::Gap& separation) noexcept {
  using Lever = typename Formats<S>::Lever;
  const auto drop = half(separation);
  const auto at = make_vec<N>([&](int c) {
    const auto shift = c == 0 ? drop : decltype(drop)(0);
    return view.negative ? p[c] + shift : p[c] - shift;
  });
  if (!view.of_b) return axis_back(nearest_to<Lever>(at), view.axis);
  return placed_point<Lever>(axes.pose, axis_back(at, view.axis));
}

/// From a to b.
template <Scalar S, int N>
[[nodiscard]] constexpr Vec<typename Formats<S>::Ratio, N> face_normal(
    const FaceAxes<S, N>& axes, const FaceView<S, N>& view) noexcept {
  if (!view.of_b) return unit_axis<typename Formats<S>::Ratio, N>(view.axis, view.negative);
  const auto& axis = axes.pose.axes[static_cast<std::size_t>(view.axis)];
  return view.negative ? axis : narrow_negative(axis);  // from a to b: into b's face
}

/// Identifies a point of a face contact: the reference face, the incident face, and its corner or
/// edge.
template <Scalar S, int N>
[[nodiscard]] constexpr std::uint32_t face_feature(const FaceView<S, N>& view, int code) noexcept {
  const int reference = ((view.of_b ? N : 0) + view.axis) * 2 + (view.negative ? 1 : 0);
  const int incident = view.other_axis * 2 + (view.other_negative ? 1 : 0);
  return static_cast<std::uint32_t>((reference * 8 + incident) * 64 + code);
}

/// The incident face of `index`, clipped against the sides of the reference.
template <Scalar S, int N>
[[nodiscard]] constexpr Manifold<S, N> face_manifold(
    const FaceAxes<S, N>& axes, int index, const typename Formats<S>::Gap& margin) noexcept {
  using Gap = typename Formats<S>::Gap;
  using Corner = typename ContactFormats<S>::Corner;
  const auto view = face_view(axes, index);
  const auto& half = view.of_b ? axes.b : axes.a;
  auto face = incident_face(axes, view);
  const auto ends = axis_first(half, view.axis);
  const auto end = [&](int c) { return ends[c] + ContactFormats<S>::tolerance; };
  face.template clip<1>(end(1), false, face.corners);
  face.template clip<1>(end(1), true, face.corners + 1);
  if constexpr (N == 3) {
    face.template clip<2>(end(2), false, face.corners + 2);
    face.template clip<2>(end(2), true, face.corners + 3);
  }
  const auto height = [&](const auto& p) {
    return nearest_to<Gap>((view.negative ? -p[0] : p[0] + decltype(p[0] - p[0])(0)) - ends[0]);
  };
  face.keep([&](const auto& p) { return height(p) <= margin; });
  if (face.count == 0) return {};
  std::array<Gap, ClippedFace<Corner, N>::capacity> heights{};
  for (std::size_t v = 0; v < static_cast<std::size_t>(face.count); ++v) {
    heights[v] = height(face.points[v]);
  }
  Manifold<S, N> result;
  result.normal = face_normal(axes, view);
  const auto chosen = face.choose(heights);
  for (int v = 0; v < face.count; ++v) {
    if (!chosen[static_cast<std::size_t>(v)]) continue;
    const auto& s = heights[static_cast<std::size_t>(v)];
    result.points[static_cast<std::size_t>(result.count++)] = {
        midway(axes, view, face.points[static_cast<std::size_t>(v)], s), s,
        face_feature(view, face.code(v))};
  }
  return result;
}

/// An edge of each box, along a's axis i and b's axis j.
template <Scalar S>
struct EdgePair {
  using Span = typename ContactFormats<S>::Span;
  static constexpr int bits = bits_of<Span>;
  int i, j;

  [[nodiscard]] constexpr int i1() const noexcept { return (i + 1) % 3; }
  [[nodiscard]] constexpr int i2() const noexcept { return (i + 2) % 3; }

  /// e_i x r_j, whose component i is 0: the components i + 1 and i + 2.
  [[nodiscard]] constexpr auto cross_of(const FaceAxes<S, 3>& axes) const noexcept {
    const auto& r = axes.pose.axes[static_cast<std::size_t>(j)];
    return Vec{narrow_negative(r[i2()]), r[i1()]};
  }

  /// (e_i x r_j) . t
  [[nodiscard]] constexpr auto along(const FaceAxes<S, 3>& axes) const noexcept {
    const auto& t = axes.pose.translation;
    return narrow_dot<bits>(cross_of(axes), Vec{t[i1()], t[i2()]});
  }
};

/// The separation along e_I x r_J times its length: |(e_I x r_J) . t| - sum over a's axes - sum
/// over b's axes. `m` has the magnitudes |r_ij| of b's axis j at m[j][i].
template <int I, int J, Scalar S>
[[nodiscard]] constexpr auto edge_separation(
    const FaceAxes<S, 3>& axes,
    const std::array<Vec<typename Formats<S>::Ratio, 3>, 3>& m) noexcept {
  constexpr int bits = FaceAxes<S, 3>::bits;
  constexpr int i1 = (I + 1) % 3, i2 = (I + 2) % 3, j1 = (J + 1) % 3, j2 = (J + 2) % 3;
  const auto& r = axes.pose.axes[J];
  const auto& t = axes.pose.translation;
  const auto along = narrow_difference<bits>(narrow_product<bits>(t[i2], r[i1]),
                                             narrow_product<bits>(t[i1], r[i2]));
  const auto of_a = narrow_sum<bits>(narrow_product<bits>(m[J][i2], axes.a[i1]),
                                     narrow_product<bits>(m[J][i1], axes.a[i2]));
  const auto of_b = narrow_sum<bits>(narrow_product<bits>(m[j2][I], axes.b[j1]),
                                     narrow_product<bits>(m[j1][I], axes.b[j2]));
  return narrow_difference<bits>(narrow_difference<bits>(narrow_abs(along), of_a), of_b);
}

/// A pair of axes known at compile time, so that every index is a constant.
template <int I, int J>
struct Pick {};

/// The best edge axis: one is chosen if its separation, divided by the length of the cross product,
/// exceeds that of the faces by more than the tolerance; the first on ties. Edges within 2^-6 of
/// parallel are skipped.
template <Scalar S>
[[nodiscard]] constexpr BestAxis<S> best_edge(const FaceAxes<S, 3>& axes, BestAxis<S> best,
                                              const typename Formats<S>::Gap& margin) noexcept {
  using Gap = typename Formats<S>::Gap;
  using Ratio = typename Formats<S>::Ratio;
  auto limit = nearest_to<Gap>(best.separation + ContactFormats<S>::tolerance);
  constexpr auto shortest = quotient_nearest<Ratio>(Ratio(1), as_operand<Ratio>(4096));
  const auto harmless_to = [&] { return exact_span<S>((min)((min)(limit, margin), Gap(0))); };
  auto harmless = harmless_to();
  std::array<Vec<Ratio, 3>, 3> m;
  for (std::size_t j = 0; j < 3; ++j) m[j] = FaceAxes<S, 3>::magnitudes(axes.pose.axes[j]);
  const auto length_of = [&]<int I, int J>(Pick<I, J>) {
    const auto& r = axes.pose.axes[J];
    return squared_length(Vec{r[(I + 1) % 3], r[(I + 2) % 3]});
  };
  const auto is_apart = [&]<int I, int J>(Pick<I, J> pick) {
    const auto s = edge_separation<I, J>(axes, m);
    // The length counts as at most 1, so the quotient is at most s.
    if (s <= harmless) return false;
    const auto squared = length_of(pick);
    if (squared < shortest) return false;
    const auto length = (min)(sqrt_floor<Ratio>(squared), Ratio(1));
    const auto q = quotient_nearest<Gap>(s, length);
    if (q > limit) {
      best = {6 + 3 * I + J, limit = q};
      harmless = harmless_to();
    }
    return q > margin;
  };
  const bool apart = is_apart(Pick<0, 0>()) || is_apart(Pick<0, 1>()) || is_apart(Pick<0, 2>()) ||
                     is_apart(Pick<1, 0>()) || is_apart(Pick<1, 1>()) || is_apart(Pick<1, 2>()) ||
                     is_apart(Pick<2, 0>()) || is_apart(Pick<2, 1>()) || is_apart(Pick<2, 2>());
  return apart ? BestAxis<S>() : best;
}

/// One point, midway between the two edges where they are closest.
template <Scalar S>
[[nodiscard]] constexpr Manifold<S, 3> edge_manifold(
    const FaceAxes<S, 3>& axes, const BestAxis<S>& best,
    const typename Formats<S>::Gap& margin) noexcept {
  using Ratio = typename Formats<S>::Ratio;
  using Lever = typename Formats<S>::Lever;
  using Corner = typename ContactFormats<S>::Corner;
  const EdgePair<S> edge{(best.index - 6) / 3, (best.index - 6) % 3};
  const auto& pose = axes.pose;
  const auto& t = pose.translation;
  const auto& direction = pose.axes[static_cast<std::size_t>(edge.j)];
  auto l = edge.cross_of(axes);
  if (edge.along(axes) < 0) l = narrow_negative(l);
  Vec<Ratio, 3> normal{};
  normal[edge.i1()] = l.x;
  normal[edge.i2()] = l.y;
  // The edges that face each other; if the normal leaves this open, those towards the other box's
  // center.
  int code = edge.i * 3 + edge.j;
  Vec<Lever, 3> on_a{}, on_b{};
  for (int c = 0; c < 3; ++c) {
    if (c == edge.i) continue;
    const bool negative = normal[c] < 0 || (normal[c] == 0 && t[c] < 0);
    on_a[c] = negative ? narrow_negative(axes.a[c]) : axes.a[c];
    code = code * 2 + (negative ? 1 : 0);
  }
  for (int k = 0; k < 3; ++k) {
    if (k == edge.j) continue;
    const auto along = dot(normal, pose.axes[static_cast<std::size_t>(k)]);
    const bool negative = along > 0 || (along == 0 && axes.along_b(k) >= 0);
    on_b[k] = negative ? narrow_negative(axes.b[k]) : axes.b[k];
    code = code * 2 + (negative ? 1 : 0);
  }
  // From a's edge to b's, then along both to where they are closest.
  const auto to_b = make_vec<3>([&](int c) {
    return nearest_to<Corner>(
               narrow_sum<EdgePair<S>::bits>(narrow_product<EdgePair<S>::bits>(t[c], Ratio(1)),
                                             narrow_dot<EdgePair<S>::bits>(axes.row(c), on_b))) -
           on_a[c];
  });
  const Vec across{direction[edge.i1()], direction[edge.i2()]};
  const auto back = dot(Vec{to_b[edge.i1()], to_b[edge.i2()]}, across);
  const auto v = (clamp)(quotient_nearest<Corner>(-back, squared_length(across)),
                         Corner(narrow_negative(axes.b[edge.j])), Corner(axes.b[edge.j]));
  const auto u = nearest_to<Corner>(to_b[edge.i] + v * direction[edge.i]);
  on_a[edge.i] = nearest_to<Lever>(
      (clamp)(u, Corner(narrow_negative(axes.a[edge.i])), Corner(axes.a[edge.i])));
  const auto unit = unit_or_x<Ratio>(normal);
  const auto p = nearest_to<Lever>(on_a + unit * half(best.separation));
  return one_point<S, 3>(unit, p, best.separation,
                         (std::uint32_t{1} << 15) | static_cast<std::uint32_t>(code), margin);
}

/// Two boxes, each in its own frame; `pose` is that of b in the frame of a.
template <Scalar S, int N>
[[nodiscard]] constexpr Manifold<S, N> box_manifold(
    const Vec<typename Formats<S>::Lever, N>& a, const Vec<typename Formats<S>::Lever, N>& b,
    const RelativePose<S, N>& pose, const typename Formats<S>::Gap& margin) noexcept {
  const FaceAxes<S, N> axes{pose, a, b};
  auto best = best_face(axes, margin);
  if (best.index < 0) return {};
  if constexpr (N == 3) {
    best = best_edge(axes, best, margin);
    if (best.index < 0) return {};
    if (best.index >= 6) return edge_manifold(axes, best, margin);
  }
  return face_manifold(axes, best.index, margin);
}

}  // namespace detent::detail
