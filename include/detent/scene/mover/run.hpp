// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <optional>
#include <utility>

#include "detent/math/project.hpp"
#include "detent/scene/mover/half_spaces.hpp"
#include "detent/scene/mover/push.hpp"
#include "detent/scene/mover/result.hpp"
#include "detent/scene/mover/step.hpp"
#include "detent/scene/question.hpp"

namespace detent::detail {

/// One move of a character.
template <Scalar S, int N, class World, class Shape, class Filter>
class MoverRun {
  using Motion = Vec<S, N>;
  using Steps = Stepper<S, N, World, Shape, Filter>;
  using Hit = ObjectHit<S, N>;

 public:
  static constexpr int slides = 5;  // the most planes that a character meets on one path

  constexpr MoverRun(const World& world, const Filter& filter, const MoverSettings<S, N>& settings,
                     const Shape& shape)
      : world_(world),
        filter_(filter),
        up_(settings.up),
        skin_((std::max)(settings.skin, least_skin())),
        step_height_(settings.step_height),
        snap_distance_((std::max)(settings.snap_distance, S(0))),
        least_cosine_(cos<direction_component<S>>(settings.max_slope)),
        steps_(world, filter, shape, skin_) {}

  /// Carries the character, pushes it out of objects, then lets it walk or fly.
  template <class Character>
  constexpr MoveResult<S, N> run(Character& character, const Motion& by) {
    if (thickness(character.shape) < 0) {  // empty: nothing blocks it
      result_.moved = stays_in_range(character.shape, by, S(0)) ? by : Motion{};
      character = {translated(character.shape, result_.moved)};
      return result_;
    }
    const Ground<S, N> ground = character.ground;
    carry(ground);
    steps_.prepare();
    const auto undo_carrying = [&] {
      steps_.go_back(character.shape);
      result_.carried = result_.pushed = {};
      result_.is_stuck = false;
      steps_.prepare();
    };
    if (result_.carried != Motion{} && steps_.overlaps_more() && is_cut()) undo_carrying();
    if (!steps_.has_room()) push();
    if (result_.carried != Motion{} && steps_.overlaps_more()) {
      undo_carrying();
      if (!steps_.has_room()) push();
    }
    const S rise = nearest_to<S>(dot(by, up_));
    const bool leaves =
        rise > 0 && dot(by, ground.normal) > quotient_floor<S>(skin_, as_operand<S>(8));
    if (ground.is_grounded && !leaves) {
      walk(rise < 0 ? across(by) : by, nearest_to<S>(-(std::min)(rise, S(0))));
    } else {
      slide(steps_, by, true, rise > 0);
      if (rise <= 0) land(nearest_to<S>(skin_ + skin_));
    }
    result_.moved = since(character.shape, steps_.shape());
    character.shape = steps_.shape();
    character.ground = ground_;
    return result_;
  }

 private:
  /// Two units for each step on the longest path: up, along, down a step, down to the ground, and
  /// falling; half of the skin remains.
  static constexpr S least_skin() noexcept {
    if constexpr (is_fixed<S>) {
      using Raw = typename S::raw_type;
      constexpr int units = 4 * slides + 12;
      return S::from_raw(
          static_cast<Raw>((std::min)(units, int{S::bits < 7 ? (1 << S::bits) - 1 : units})));
    } else {
      return quotient_nearest<S>(S(1), S(4096));
    }
  }

  /// The point of a shape whose motion is recorded: the whole shape moves by the same vector.
  template <Round Body>
  static constexpr Motion mark(const Body& body) noexcept {
    return reference(body);
  }
  static constexpr Motion mark(const Aabb<S, N>& box) noexcept { return box.min; }
  static constexpr Motion since(const Shape& before, const Shape& now) noexcept {
    return nearest_to<S>(mark(now) - mark(before));
  }

  /// The horizontal part of a vector.
  constexpr Motion across(const Motion& v) const noexcept { return reject(v, up_); }
  constexpr Motion upward(const S& height) const noexcept { return nearest_to<S>(up_ * height); }
  constexpr auto steepness(const Direction<S, N>& normal) const noexcept {
    return dot(normal, up_);
  }
  constexpr bool is_flat(const Direction<S, N>& normal) const noexcept {
    return steepness(normal) >= least_cosine_;
  }

  constexpr void touch(const Hit& hit) noexcept {
    for (std::size_t i = 0; i < result_.count; ++i) {
      const auto& known = result_.touched[i];
      if (known.object == hit.id && known.normal == hit.normal) return;
    }
    if (result_.count < result_.touched.size()) {
      result_.touched[result_.count++] = {hit.id, hit.point, hit.normal};
    }
  }

  /// Moves with the frame of the ground: the point under the character moves rigidly. A frame that
  /// tilts may then overlap it a little.
  constexpr void carry(const Ground<S, N>& ground) {
    if (!ground.is_grounded || ground.frame == FrameId{}) return;
    const auto frame = world_.frame(ground.frame);
    if (!frame) return;
    const auto by = nearest_to<S>(transform_point(frame->world, ground.local) - ground.point);
    if (by == Motion{}) return;
    steps_.prepare(ground.frame);
    const Shape before = steps_.shape();
    slide(steps_, by, false, true);
    result_.carried = since(before, steps_.shape());
  }

  /// Whether something is between the middle of the character and its feet: its carrier, if that
  /// turned upside down.
  constexpr bool is_cut() const {
    const auto center = middle(steps_.shape());
    const S height = floor_to<S>(dot(center, up_) - lowest_along(steps_.shape(), up_));
    return world_.nearest_hit(Ray<S, N>{center, -up_, height}, steps_.new_ones()).has_value();
  }

  constexpr void push() {
    const Shape before = steps_.shape();
    push_apart(steps_, world_, filter_, skin_);
    result_.pushed = since(before, steps_.shape());
    steps_.prepare();
    result_.is_stuck = steps_.is_held();
  }

  /// Moves by `by`, sliding along obstacles. A character that `lands` loses its downward motion on
  /// ground; one that does not climb treats steep slopes as walls; one that does neither walks.
  /// Returns whether a wall or a steep slope was in its way.
  ///
  /// Each step heads for the same end, as far as the planes met so far allow. So the character
  /// never turns back, and it follows the crease of two planes. Where a character walks onto ground
  /// this end rises, see `lift`.
  constexpr bool slide(Steps& steps, const Motion& by, bool lands, bool climbs) {
    HalfSpaces<S, N> spaces;
    Motion left = by;
    bool meets_wall = false;
    for (int i = 0; i < slides; ++i) {
      const auto way = spaces.closest(left, quotient_floor<S>(skin_, as_operand<S>(8)));
      if (!way || *way == Motion{}) break;
      const auto step = steps.look(*way);
      steps.go(step.by);
      left = nearest_to<S>(left - step.by);
      if (!step.hit) {
        if (step.is_whole || step.by == Motion{}) break;
        continue;
      }
      touch(*step.hit);
      const auto& normal = step.hit->normal;
      const auto slope = steepness(normal);
      spaces.shift(step.by, nearest_to<S>(skin_ + skin_));
      spaces.add(normal, step.offset);
      if (slope >= least_cosine_) {
        if (lands && dot(left, up_) < 0) left = across(left);
        if (!lands && !climbs) left = nearest_to<S>(left + up_ * lift(step, slope));
      } else {
        meets_wall = meets_wall || -slope < least_cosine_;
        if (!climbs && slope > 0) {
          const auto wall =
              direction_of<S>(nearest_to<direction_component<S>>(normal.vec() - up_.vec() * slope));
          if (wall) spaces.add(*wall, S(0));
        }
      }
    }
    return meets_wall;
  }

  /// How far a walking character must rise to be a skin away from the ground that ended a step.
  ///
  /// Otherwise a slow one would never get onto a slope: it lands on the ground in front, less than a
  /// skin from the slope, whose half-space pushes it back. Where the ground allowed no step at all, it
  /// rises by a unit: `HalfSpaces::closest` ignores how much less than that a motion leads into it.
  template <class Cosine>
  constexpr S lift(const Step<S, N>& step, const Cosine& slope) const noexcept {
    const S least = step.by == Motion{} ? next_up(S(0)) : S(0);
    const S rounded_up = nearest_to<S>(-quotient_floor<S>(-step.offset, slope));
    return (std::max)(rounded_up, least);
  }

  /// A step of a character on the ground: along it, over steps, and back down to it.
  constexpr void walk(const Motion& along, const S& fall) {
    if (along != Motion{}) {
      Steps over = steps_;
      const auto before = result_;
      if (slide(steps_, along, false, false) && step_height_ > 0) {
        const auto after = std::exchange(result_, before);
        const Shape start = over.shape();
        const auto reached = dot(since(start, steps_.shape()), along);
        if (climb(over, along) && dot(since(start, over.shape()), along) > reached) {
          steps_ = over;
        } else {
          result_ = after;
        }
      }
    }
    const S least = nearest_to<S>(skin_ + skin_);
    if (land((std::max)(nearest_to<S>(fall + snap_distance_), least))) return;
    if (fall > 0) {
      slide(steps_, upward(nearest_to<S>(-fall)), true, false);
      land(least);
    }
  }

  /// Moves up, along and down again, at least two skins along: it stopped a skin before the step.
  /// Returns whether that leads onto ground or, if `along` is long enough, over what was in the way.
  constexpr bool climb(Steps& steps, const Motion& along) {
    const Shape start = steps.shape();
    steps.go(steps.look(upward(step_height_)).by);
    const S risen = nearest_to<S>(dot(since(start, steps.shape()), up_));
    if (risen <= 0) return false;
    const S least = nearest_to<S>(skin_ + skin_);
    const bool is_short = squared_length(along) < square(least);
    const auto direction = direction_of<S>(along);
    slide(steps, is_short && direction ? nearest_to<S>(*direction * least) : along, false, false);
    const auto down = steps.look(upward(nearest_to<S>(-risen)));
    if (down.hit) {
      if (!ground_normal(*down.hit)) return false;
      const auto height = dot(down.hit->point, up_) - lowest_along(start, up_);
      if (height > step_height_ + skin_) return false;
    } else if (is_short || !down.is_whole) {
      return false;
    }
    steps.go(down.by);
    return true;
  }

  /// The normal of the ground that a downward cast hit, or nothing if it is too steep. Over an
  /// edge, the normal of the surface at the edge.
  constexpr std::optional<Direction<S, N>> ground_normal(const Hit& hit) const {
    if (is_flat(hit.normal)) return hit.normal;
    const auto slope = steepness(hit.normal);
    if (slope <= 0) return std::nullopt;
    const auto away =
        direction_of<S>(nearest_to<direction_component<S>>(hit.normal.vec() - up_.vec() * slope));
    if (!away) return std::nullopt;
    // So near that the steepest ground is less than a skin higher or lower than the edge.
    const S inward = floor_to<S>(skin_ * least_cosine_);
    const auto origin = nearest_to<S>(hit.point + up_ * skin_ - *away * inward);
    const Ray<S, N> ray{origin, -up_, nearest_to<S>(skin_ + skin_)};
    const auto below = world_.nearest_hit(ray, steps_.passes());
    // A ray that starts in a solid is under a steeper slope.
    if (!below || below->distance <= 0 || !is_flat(below->normal)) return std::nullopt;
    return below->normal;
  }

  /// Goes down to ground within `distance`, if there is any, and stands on it.
  constexpr bool land(const S& distance) {
    const auto step = steps_.look(upward(nearest_to<S>(-distance)));
    if (!step.hit) return false;
    const auto normal = ground_normal(*step.hit);
    if (!normal) return false;
    steps_.go(step.by);
    touch(*step.hit);
    ground_.is_grounded = true;
    ground_.object = step.hit->id;
    ground_.normal = *normal;
    ground_.frame = world_.frame_of(step.hit->id).value_or(FrameId{});
    ground_.point = below_middle(step.hit->point);
    if (const auto frame = world_.frame(ground_.frame)) {
      ground_.local = inverse_transform_point(frame->world, ground_.point);
      ground_.point = transform_point(frame->world, ground_.local);
    }
    return true;
  }

  /// The point at the height of `point` below the middle of the character, with which it turns.
  constexpr Motion below_middle(const Motion& point) const noexcept {
    return nearest_to<S>(point + across(nearest_to<S>(middle(steps_.shape()) - point)));
  }

  const World& world_;
  const Filter& filter_;
  Direction<S, N> up_;
  S skin_;
  S step_height_;
  S snap_distance_;
  direction_component<S> least_cosine_;
  Steps steps_;
  MoveResult<S, N> result_{};
  Ground<S, N> ground_{};
};

}  // namespace detent::detail
