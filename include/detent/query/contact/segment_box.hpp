// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "detent/math/components.hpp"
#include "detent/math/direction.hpp"
#include "detent/number/filter/components.hpp"
#include "detent/query/contact/feature.hpp"
#include "detent/query/kernel/least_push.hpp"
#include "detent/query/kernel/length.hpp"
#include "detent/query/kernel/point_obb.hpp"
#include "detent/query/kernel/segment_in_frame.hpp"

namespace detent::detail {

template <Scalar S, int N>
[[nodiscard]] constexpr bool is_flat(const Obb<S, N>& box, int axis) noexcept {
  return box.half_extents[axis] == 0;
}
template <Scalar S, int N>
[[nodiscard]] constexpr bool is_flat(const Aabb<S, N>& box, int axis) noexcept {
  return box.min[axis] == box.max[axis];
}

/// The least push of a box, measured in its frame, and a segment, with the features that meet.
template <Scalar S, int N>
struct SegmentBoxPush {
  Direction<S, N> away;  // from the box
  Depth<S> depth;
  // The axes on whose upper side the box's feature is, and those along which it extends.
  std::size_t upper = 0, free = 0;
  bool has_start = false, has_end = false;

  template <class T>
  constexpr void add_side(int axis, const T& sign) noexcept {
    upper |= std::size_t{sign > 0} << axis;
    free |= std::size_t{sign == 0} << axis;
  }
  /// The sign of `slope` says towards which end the segment approaches the box.
  template <class T>
  constexpr void set_ends(const T& slope) noexcept {
    has_start = slope >= 0;
    has_end = slope <= 0;
  }

  template <std::size_t Most, class Box>
  [[nodiscard]] constexpr Feature<S, N, Most> side(const Box& box) const noexcept {
    const auto body = body_of(box);
    std::size_t either = free;
    for (int i = 0; i < N; ++i) either |= std::size_t{is_flat(box, i)} << i;
    Feature<S, N, Most> feature;
    for (std::size_t sides = 0; sides < std::size_t{1} << N; ++sides) {
      if ((sides | either) == (upper | either))
        feature.add(nearest_to<Length<S>>(body.corner(sides)), sides);
    }
    return feature;
  }
  template <std::size_t Most>
  [[nodiscard]] constexpr Feature<S, N, Most> end(const Segment<S, N>& segment) const noexcept {
    Feature<S, N, Most> feature;
    if (has_start) feature.add(nearest_to<Length<S>>(segment.start), 0);
    if (has_end) feature.add(nearest_to<Length<S>>(segment.end), 1);
    return feature;
  }
};

/// The least push, exactly; nothing if they do not touch.
template <Scalar S, int N>
[[nodiscard]] constexpr std::optional<SegmentBoxPush<S, N>> find_segment_box_push(
    const Obb<S, N>& box, const Segment<S, N>& segment, const S& radius) noexcept {
  const auto push = least_push_in_frame(box, segment, radius);
  if (!push) return std::nullopt;
  SegmentBoxPush<S, N> result{direction_of<S>(push->normal).value_or(Direction<S, N>()),
                              push->depth};
  for (int i = 0; i < N; ++i) result.add_side(i, push->local[i]);
  result.set_ends(dot(push->local, in_frame(box, segment.end - segment.start)));
  return result;
}

/// The same by a filter (docs/filters.md, lemma 27).
template <Scalar S, int N = 3>
class SegmentBoxFilter {
 public:
  using Result = SegmentBoxPush<S, N>;
  using Found = Decided<std::optional<Result>>;

  template <class Box>
  constexpr SegmentBoxFilter(const Box& box, const Segment<S, N>& segment, const S& radius) noexcept
      : radius_(radius), words_(box, segment) {}

  [[nodiscard]] constexpr Found find() const noexcept {
    switch (words_.closest_at()) {
      case ClosestAt::unsure:
        return unsure;
      case ClosestAt::meets:
        return inside();
      case ClosestAt::between:
        return between();
      default:
        return at_end();
    }
  }

 private:
  using Words = SegmentInFrame<S, N>;
  using Place = typename Words::Place;
  static constexpr int frac = Words::frac;
  static constexpr Found unsure{std::nullopt, false};

  [[nodiscard]] constexpr Found at_end() const noexcept {
    const auto squared = words_.squared();
    const auto gap = sqrt_floor<Length<S>>(squared);
    if (gap > radius_ || (gap == radius_ && !(squared <= square(gap)))) return {std::nullopt, true};
    return apart(direction_of<S>(from_frame(rotation(), words_.beyond())).value_or(none()), gap);
  }
  [[nodiscard]] constexpr Found between() const noexcept {
    const auto gap = words_.distance_floor();
    if (!gap.is_sure) return unsure;
    // The distance is above its floor.
    if (!(gap.value < radius_)) return {std::nullopt, true};
    const auto away = direction();
    if (!away.is_sure) return unsure;
    return apart(away.value, gap.value);
  }
  [[nodiscard]] constexpr Found apart(const Direction<S, N>& away,
                                      const Length<S>& gap) const noexcept {
    Result result{away, Depth<S>(radius_ - gap)};
    for (int i = 0; i < N; ++i) result.add_side(i, words_.side(i));
    result.set_ends(words_.is_across() ? 0 : words_.closest_at() == ClosestAt::start ? 1 : -1);
    return {result, true};
  }

  /// The direction of `beyond` in the world.
  [[nodiscard]] constexpr Decided<Direction<S, N>> direction() const noexcept {
    constexpr Decided<Direction<S, N>> unsure_direction{{}, false};
    using Spot = Fixed<63, frac>;
    using Component = direction_component<S>;
    using Wrong = Fixed<40, Share::frac>;
    const auto in_world = from_frame(rotation(), words_.beyond());
    const auto v = make_vec<N>([&](int i) { return narrow_floor<Spot>(in_world[i]); });
    const int length = bit_length(v[longest_axis(v)].raw());
    if (length < 44) return unsure_direction;
    // v is off by less than 4 times this in each component, and at least 2^(length - 1) long: the
    // direction is off by less than 2 sqrt(3) times the quotient.
    const auto& error = words_.error();
    const auto steps = shift_left(integer_cast<typename Wrong::raw_type>(error.raw()), 67 - length);
    const auto shares = detail::shares(magnitudes<typename Spot::raw_type>(to_array(v)));
    const auto share_error = Wrong::from_raw(shares.error.raw()) + Wrong::assume_raw(steps);
    std::array<Component, std::size_t{N}> unit;
    for (std::size_t i = 0; i < unit.size(); ++i) {
      const auto nearest = decide_nearest<Component>(Approximate{shares.value[i], share_error});
      if (!nearest.is_sure) return unsure_direction;
      unit[i] = with_sign(nearest.value, v[static_cast<int>(i)] < 0);
    }
    return {Direction<S, N>::assume_unit(from_array(unit)), true};
  }

  // A segment that meets the box leaves it across a face, or across the segment and an edge. The
  // heights are those of AxisPush.

  /// Across a face.
  struct FacePush {
    int axis = 0;
    bool is_upper = false;
    Fixed<63, frac> height;
  };
  /// Across the segment and an edge along an axis, over the root of `squared`.
  struct EdgePush {
    int axis = 0;
    Vec<Place, N> normal;
    Fixed<125, 2 * frac> height, squared;
    bool is_sure = true;
  };

  [[nodiscard]] constexpr Found inside() const noexcept {
    const auto &low = words_.low(), &high = words_.high(), &d = words_.along();
    FacePush face;
    bool is_only = true;
    for (int i = 0; i < N; ++i) {
      const auto up = narrow_difference<63>(high[i], d[i] < 0 ? d[i] : Place(0));
      const auto down = narrow_difference<63>(d[i] > 0 ? d[i] : Place(0), low[i]);
      const bool is_upper = up < down;
      const auto& height = is_upper ? up : down;
      if (i > 0 && height > face.height) continue;
      is_only = up != down && (i == 0 || height < face.height);
      face = {i, is_upper, height};
    }
    if (!is_only || !(face.height > 0)) return unsure;
    const Leading leading_face(face.height);
    const Leading face_squared = leading_face * leading_face;
    EdgePush best;
    Leading best_height;
    bool has_edge = false;
    for (int i = N == 2 ? 2 : 0; i < 3; ++i) {
      const auto edge = across_edge(i);
      if (edge.squared == 0) continue;
      if (!edge.is_sure) return unsure;
      const Leading leading(edge.height), squared(edge.squared);
      const auto height = leading * leading;
      // The sign of the difference of two pushes.
      const auto order = has_edge ? compare(height * Leading(best.squared), best_height * squared)
                                  : compare(height, face_squared * squared);
      if (order == Filtered::unsure) return unsure;
      if (order == Filtered::yes) continue;
      best = edge;
      best_height = height;
      has_edge = true;
    }
    return {has_edge ? push_across(best) : push_across(face), true};
  }
  [[nodiscard]] static constexpr Filtered compare(const Leading& a, const Leading& b) noexcept {
    return decide(difference(a, b, Relative{56}));
  }

  /// The lesser of both pushes along the segment's cross product with axis i; in 2D, axis 2 is that of
  /// the plane.
  [[nodiscard]] constexpr EdgePush across_edge(int i) const noexcept {
    const auto &low = words_.low(), &high = words_.high(), &d = words_.along();
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    EdgePush push;
    push.axis = i;
    auto& n = push.normal;
    n[j] = narrow_negative(d[k]);
    n[k] = d[j];
    push.squared = narrow_dot<125>(n, n);
    const auto reach = [&](int axis, bool is_upper) {
      return narrow_product<125>(n[axis], (n[axis] > 0) == is_upper ? high[axis] : low[axis]);
    };
    const auto up = narrow_sum<125>(reach(j, true), reach(k, true));
    const auto down = narrow_negative(narrow_sum<125>(reach(j, false), reach(k, false)));
    push.is_sure = up != down && up > 0 && down > 0;
    push.height = up < down ? up : down;
    if (!(up < down)) n = narrow_negative(n);
    return push;
  }

  [[nodiscard]] constexpr Result push_across(const FacePush& face) const noexcept {
    const auto& d = words_.along()[face.axis];
    const auto outward = direction_of<S>(rotation().axis(face.axis).vec()).value_or(none());
    Result result{face.is_upper ? outward : -outward,
                  Depth<S>(radius_ + ceil_to<Length<S>>(face.height))};
    for (int i = 0; i < N; ++i) result.add_side(i, i != face.axis ? 0 : face.is_upper ? 1 : -1);
    result.set_ends(face.is_upper ? d : narrow_negative(d));
    return result;
  }
  [[nodiscard]] constexpr Result push_across(const EdgePush& edge) const noexcept {
    const auto away = direction_of<S>(from_frame(rotation(), edge.normal)).value_or(none());
    Result result{away, depth_of_height<S>(radius_, edge.height, edge.squared)};
    for (int i = 0; i < N; ++i) result.add_side(i, edge.normal[i]);
    result.set_ends(0);
    return result;
  }
  [[nodiscard]] static constexpr Direction<S, N> none() noexcept { return {}; }

  [[nodiscard]] constexpr const Rotation<S, N>& rotation() const noexcept {
    return words_.rotation();
  }

  const S& radius_;
  Words words_;
};

/// The least push, by the filter where it pays.
template <Scalar S, int N>
[[nodiscard]] constexpr std::optional<SegmentBoxPush<S, N>> segment_box_push(
    const Obb<S, N>& box, const Segment<S, N>& segment, const S& radius) noexcept {
  if constexpr (has_segment_in_frame<Obb<S, N>>) {
    const auto found = SegmentBoxFilter<S, N>(box, segment, radius).find();
    if (found.is_sure) return found.value;
  }
  return find_segment_box_push(box, segment, radius);
}

}  // namespace detent::detail
