// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <optional>

#include "detent/number/next_up.hpp"
#include "detent/query/overlaps/aabb_aabb.hpp"
#include "detent/scene/mover/body.hpp"
#include "detent/scene/scene.hpp"

namespace detent::detail {

/// The objects that can block a character: those that pass the caller's filter, except its carrier,
/// objects that overlap it too deeply, and objects that the box around its path does not overlap.
/// The last exception only saves casts: the boxes of trees are coarser than a skin, so every step
/// along a floor would cast at it.
template <Scalar S, int N, class World, class Shape, class Filter>
struct Met {
  const World& world;
  const Filter& filter;
  FrameId carrier{};           // objects in this frame, and in frames below it, are skipped
  const Shape* outside{};      // objects that this shape overlaps are skipped
  const Shape* inside{};       // only objects that this shape overlaps are tested
  const Aabb<S, N>* around{};  // a box around the path

  [[nodiscard]] constexpr bool operator()(const ObjectInfo& object) const {
    if (!filter(object)) return false;
    if (carrier != FrameId{} && moves_with_carrier(object.id)) return false;
    if (outside == nullptr && inside == nullptr && around == nullptr) return true;
    bool is_met = true;
    world.visit(object.id, [&]<class Target>(const Target& target) {
      if constexpr (!is_surface_type<Target> && requires { bounding_box(target); }) {
        if (around != nullptr) is_met = overlaps(bounding_box(target), *around);
      }
      if (inside != nullptr) is_met = is_met && separately<job::Overlaps>(*inside, target);
      if (outside != nullptr) is_met = is_met && !separately<job::Overlaps>(*outside, target);
    });
    return is_met;
  }

  [[nodiscard]] constexpr bool moves_with_carrier(const ObjectId& object) const {
    auto frame = world.frame_of(object);
    while (frame && *frame != carrier) {
      const auto found = world.frame(*frame);
      if (!found) return false;
      frame = found->parent;
    }
    return frame.has_value();
  }
};

/// How far a character gets along a straight path.
template <Scalar S, int N>
struct Step {
  Vec<S, N> by;
  bool is_whole = false;                 // nothing is in the way
  std::optional<ObjectHit<S, N>> hit{};  // the obstacle
  S offset{};                            // how far to move along its normal, to be a skin away
};

/// Moves a character along straight paths, on which it touches only objects that it already
/// overlaps.
///
/// Casts are those of the shape grown by a guard, which shrinks by one ULP per step. Proof: until
/// the end of a step the grown shape touches nothing. The end is then rounded to the grid, by at
/// most sqrt(3)/2 ULP, and a path of at most a quarter of the range differs from its rounded
/// direction by less than another 1/2 ULP, or is rounded with it. So the shape, grown by one ULP
/// less, touches nothing from there to the rounded end, where the next step starts.
///
/// The guard starts with half of the skin. A step stops a whole skin before a plane, so that later
/// steps along the plane pass it by the other half. Without room for that, the guard is 0, and
/// `shorten` checks where each step ends.
///
/// Objects that the shape overlaps are kept apart, and stop only its inner part.
template <Scalar S, int N, class World, class Shape, class Filter>
class Stepper {
 public:
  static constexpr int dimension = N;
  using Passes = Met<S, N, World, Shape, Filter>;

  constexpr Stepper(const World& world, const Filter& filter, const Shape& shape, const S& skin)
      : world_(&world), filter_(&filter), start_(shape), shape_(shape), held_(shape), skin_(skin) {}

  [[nodiscard]] constexpr const Shape& shape() const noexcept { return shape_; }
  /// The objects that may be in the way.
  [[nodiscard]] constexpr Passes passes() const noexcept {
    return {*world_, *filter_, carrier_, is_deep_ ? &core_ : nullptr};
  }

  /// Ignores objects in this frame, and in frames below it, until the next `prepare`.
  constexpr void prepare(const FrameId& carrier = {}) {
    carrier_ = carrier;
    is_held_ = is_deep_ = false;
    guard_ = floor_to<S>(half(skin_));
    has_room_ = is_free(guard_);
    if (has_room_) return;
    held_ = shape_;
    is_held_ = !is_free(S(0));
    if (!is_held_ || world_->any(grown(shape_, guard_), others())) guard_ = S(0);
    if (!is_held_) return;
    const S thick = thickness(shape_);
    for (const int eighths : {1, 2, 4}) {
      sunk_ = quotient_floor<S>(-thick * as_operand<S>(eighths), as_operand<S>(8));
      if (is_free(sunk_)) return;
    }
    core_ = grown(shape_, sunk_);
    is_deep_ = true;
  }
  /// Whether the shape, grown by `by`, touches nothing.
  [[nodiscard]] constexpr bool is_free(const S& by) const {
    return !world_->any(grown(shape_, by), passes());
  }
  /// Whether nothing is within half of the skin.
  [[nodiscard]] constexpr bool has_room() const { return has_room_; }
  /// Whether the shape overlaps something.
  [[nodiscard]] constexpr bool is_held() const { return is_held_; }

  /// How far the character gets when it moves by `by`. It stops a skin before an obstacle.
  [[nodiscard]] constexpr Step<S, N> look(const Vec<S, N>& by) { return look(by, skin_, is_held_); }

  /// Moves by `by`, or as far as other objects allow: objects that the shape overlaps do not stop
  /// it.
  ///
  /// `by` is a solution of half-spaces within an eighth of the skin, so it may lead closer than a
  /// skin to other objects, but not closer than three quarters of it.
  constexpr void escape(const Vec<S, N>& by) {
    guard_ = S(0);
    go(look(by, quotient_floor<S>(skin_ * as_operand<S>(3), as_operand<S>(4)), false).by);
  }
  constexpr void go_back(const Shape& shape) noexcept { shape_ = shape; }

  /// The objects that the shape did not overlap at first.
  [[nodiscard]] constexpr Passes new_ones() const noexcept {
    return {*world_, *filter_, FrameId{}, &start_};
  }
  /// Whether the shape overlaps one of these.
  [[nodiscard]] constexpr bool overlaps_more() const { return world_->any(shape_, new_ones()); }

  constexpr void go(const Vec<S, N>& by) noexcept { shape_ = translated(shape_, by); }

 private:
  /// Objects that block the whole shape, and objects that block only its inner part.
  [[nodiscard]] constexpr Passes others() const noexcept {
    return {*world_, *filter_, carrier_, is_held_ ? &held_ : nullptr};
  }
  [[nodiscard]] constexpr Passes held() const noexcept {
    auto passed = passes();
    passed.inside = &held_;
    return passed;
  }

  /// How far the character gets if it stops at the distance `clear` from an obstacle.
  [[nodiscard]] constexpr Step<S, N> look(const Vec<S, N>& by, const S& clear, bool stops_in_held) {
    const auto direction = direction_of<S>(by);
    if (!direction) return {{}, true};
    // Rounding the direction moves the end of a longer path by more than a unit.
    const S cap = floor_to<S>(half(half(largest<S>)));
    const S whole = sqrt_ceil<S>(squared_length(by));
    S length = (std::min)(whole, cap);
    const S reach = nearest_to<S>(length + (skin_ + skin_) + (skin_ + skin_));
    Step<S, N> step;
    step.is_whole = whole <= cap;
    step.by = step.is_whole ? by : nearest_to<S>(*direction * length);
    const auto cast_grown = [&](const S& guard, Passes passed) {
      const Cast way{grown(shape_, guard), *direction, reach};
      const auto around = box_around(way);
      passed.around = &around;
      const auto hit = world_->nearest_hit(way, passed);
      if (hit) stop(step, *hit, *direction, length, nearest_to<S>(clear - guard));
    };
    const bool is_tight = guard_ == 0;
    cast_grown(guard_, others());
    spend(guard_);
    if (stops_in_held) {
      cast_grown(sunk_, held());
      spend(sunk_);
    }
    if (!stays_in_range(shape_, step.by, skin_)) return {{}, false};
    if (is_tight) shorten(step);
    return step;
  }

  /// A box around all that a moving shape may touch.
  static constexpr Aabb<S, N> box_around(const Cast<Shape>& way) noexcept {
    Aabb<S, N> box;
    for (int i = 0; i < N; ++i) {
      const auto by = way.direction[i] * way.max_distance;
      const auto least = least_on(way.shape, i), greatest = greatest_on(way.shape, i);
      box.min[i] = by < 0 ? floor_to<S>(least + by) : floor_to<S>(least);
      box.max[i] = by > 0 ? ceil_to<S>(greatest + by) : ceil_to<S>(greatest);
    }
    return box;
  }

  /// Ends a step of this `length` where the gap to the plane of a hit is `clear`.
  constexpr void stop(Step<S, N>& step, const ObjectHit<S, N>& hit,
                      const Direction<S, N>& direction, S& length, const S& clear) const {
    auto closing = -dot(direction, hit.normal);
    if (closing < 0) closing = decltype(closing)(0);
    const auto gap = hit.distance * closing;
    const auto ahead = gap - clear;
    S distance(0);
    if (ahead > 0) distance = quotient_floor<S>(ahead, closing);
    if (distance >= length) return;
    length = distance;
    step.is_whole = false;
    step.by = nearest_to<S>(direction * distance);
    step.hit = hit;
    step.offset = ceil_to<S>(clear - gap - dot(step.by, hit.normal));
  }

  /// Without room for the guard, halves a step until its end overlaps nothing that was not
  /// overlapped.
  ///
  /// An end is less than 2 ULP from a point of the path. A shape that is 2 ULP thick does not pass
  /// a plane in between without overlapping it at one of them; a thinner one is grown.
  constexpr void shorten(Step<S, N>& step) const {
    const S ulp = next_up(S(0));
    const S margin = thickness(shape_) < ulp ? nearest_to<S>(ulp + ulp) : S(0);
    for (int i = 0; i < 8; ++i) {
      if (!world_->any(grown(translated(shape_, step.by), margin), others())) return;
      step.by = nearest_to<S>(half(step.by));
      step.is_whole = false;
    }
    step.by = {};
  }

  /// The next guard. Scalars that round keep it.
  static constexpr void spend(S& guard) noexcept {
    if constexpr (is_fixed<S>) {
      if (guard != 0) guard = previous_raw(guard);
    }
  }

  const World* world_;
  const Filter* filter_;
  Shape start_;
  Shape shape_;
  Shape held_;    // objects that this overlaps stop only an inner part of the shape
  Shape core_{};  // objects that this overlaps stop nothing
  FrameId carrier_{};
  S skin_;
  S guard_{};
  S sunk_{};  // the guard of that part
  bool has_room_ = true;
  bool is_held_ = false;
  bool is_deep_ = false;
};

}  // namespace detent::detail
