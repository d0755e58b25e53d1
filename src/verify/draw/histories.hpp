// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "detent/math/transform.hpp"
#include "detent/scene/one_of.hpp"
#include "detent/scene/shape_tag.hpp"
#include "verify/draw/shapes.hpp"

namespace detent::verify {

template <Scalar S, int N>
using SceneShape = detail::OneOf<Sphere<S, N>, Aabb<S, N>, Obb<S, N>>;

/// An event in the history of a scene.
enum class Deed : std::uint8_t {
  add,
  remove,
  replace,
  move,
  set_layers,
  set_user,
  add_frame,
  move_frame,
  remove_frame
};

/// One event in the history of a scene. Objects and frames are referred to by the number of
/// additions attempted before theirs, successful or not, so some references are to removed objects
/// or to ones that were never added.
template <Scalar S, int N>
struct Step {
  Deed deed = Deed::add;
  std::uint8_t target = 0;
  std::uint8_t frame = 0;  // of a new object or frame, counted from 1; 0 is the world
  bool is_fixed = false;
  std::uint32_t layers = 0;
  std::uint64_t user = 0;
  SceneShape<S, N> shape{};
  Transform<S, N> transform{};  // of a frame; its translation is how far an object moves
};
template <class D, Scalar S, int N>
constexpr void append(D& digest, const Step<S, N>& step) noexcept {
  digest.add(static_cast<std::uint8_t>(step.deed), step.target, step.frame, step.is_fixed,
             step.layers, step.user);
  step.shape.visit([&](const auto& shape) {
    digest.add(detail::shape_tag<std::remove_cvref_t<decltype(shape)>>, shape);
  });
  digest.add(step.transform);
}

/// A short history: the steps before a snapshot is taken, then those before it is restored.
template <Scalar S, int N>
struct History {
  static constexpr std::size_t capacity = 18;
  std::array<Step<S, N>, capacity> steps{};
  std::uint8_t before = 0;
  std::uint8_t count = 0;
};
template <class D, Scalar S, int N>
constexpr void append(D& digest, const History<S, N>& history) noexcept {
  digest.add(history.before, history.count);
  for (std::size_t i = 0; i < history.count; ++i) digest.add(history.steps[i]);
}

/// Draws shapes around one spot and others near it, and a history of them.
template <Scalar S, int N>
class HistoryScene : public ShapeScene<S, N> {
  using Base = ShapeScene<S, N>;
  using Base::center_;
  using Base::extreme_;
  using Base::far_;
  using Base::frame_;
  using Base::home_;

 public:
  using Base::random;
  using typename Base::Point;

  using Base::Base;

  constexpr History<S, N> history() noexcept {
    History<S, N> history;
    const auto frames = random.between(0, 2);
    const auto objects = random.one_in(3) ? random.between(1, 4) : random.between(8, 11);
    const auto changes = random.between(0, 3), later = random.between(0, 2);
    const auto next = [&]() -> auto& { return history.steps[history.count++]; };
    for (std::int64_t i = 0; i < frames; ++i) add_frame(next());
    for (std::int64_t i = 0; i < objects; ++i) add_object(next());
    for (std::int64_t i = 0; i < changes; ++i) change(next());
    history.before = history.count;
    is_later_ = true;
    for (std::int64_t i = 0; i < later; ++i) change(next());
    return history;
  }

  /// The next question is at a spot with many objects, or near it.
  constexpr void look_around() noexcept {
    Base::go_home();
    if (random.coin()) Base::wander();
  }

  /// A length from `low` to `high` sixteenths of the scene's scale.
  constexpr S length(std::int64_t low, std::int64_t high) noexcept {
    const auto step = Base::reach_;
    return Base::scalar(random.between(step * low / 16, step * high / 16));
  }

 private:
  constexpr std::uint32_t layers() noexcept {
    return static_cast<std::uint32_t>(random.between(1, 7));
  }

  /// The shape of an object in a frame is around the frame's origin.
  constexpr SceneShape<S, N> shape(bool is_in_frame) noexcept {
    const auto home = home_;
    if (is_in_frame) home_ = Point();
    look_around();
    home_ = home;
    if (random.coin()) Base::turn();
    switch (random.below(3)) {
      case 0:
        return SceneShape<S, N>(Base::sphere());
      case 1:
        return SceneShape<S, N>(Base::aabb());
      default:
        return SceneShape<S, N>(Base::obb());
    }
  }

  constexpr void add_object(Step<S, N>& step) noexcept {
    step.deed = Deed::add;
    // The first object is a moving one, so that there is always one to change.
    step.is_fixed = objects_ != 0 && !is_later_ && random.one_in(5);
    const bool may_be_in_frame = frames_ != 0 && (!step.is_fixed || random.one_in(8));
    if (may_be_in_frame && random.one_in(3)) step.frame = frame();
    step.layers = layers();
    step.user = random.next();
    step.shape = shape(step.frame != 0);
    if (step.is_fixed) fixed_ |= 1u << objects_;
    ++objects_;
  }
  constexpr std::uint8_t frame() noexcept {
    return static_cast<std::uint8_t>(1 + random.below(frames_));
  }

  constexpr void add_frame(Step<S, N>& step) noexcept {
    step.deed = Deed::add_frame;
    if (frames_ != 0 && random.coin()) step.frame = frame();
    step.transform = transform(step.frame != 0);
    ++frames_;
  }

  /// Near the spot or the origin of the parent frame: mostly rigid, and half the time one that maps
  /// the grid to itself.
  constexpr Transform<S, N> transform(bool is_in_frame) noexcept {
    Transform<S, N> result;
    auto place = extreme_ ? Base::any_point() : is_in_frame ? Point() : home_;
    for (auto& axis : frame_.axes) place += axis * random.between(-far_ / 4, far_ / 4);
    result.translation = Base::vec(place);
    if (random.coin()) result.rotation = Base::template any_rotation<N>();
    const auto whole = std::int64_t{1} << S::frac;
    const auto kind = random.below(8);
    const auto scale = kind == 0   ? -whole
                       : kind == 1 ? whole / 2
                       : kind == 2 ? random.between(-2 * whole, 2 * whole)
                                   : whole;
    result.scale = Base::scalar(scale);
    return result;
  }

  constexpr void change(Step<S, N>& step) noexcept {
    const auto kind = random.below(8);
    if (kind == 0) return add_object(step);
    step.target = static_cast<std::uint8_t>(random.below(objects_));
    // A restore only concerns moving objects.
    if (is_later_) {
      while ((fixed_ >> step.target & 1u) != 0) --step.target;
    }
    switch (kind) {
      case 1:
      case 2:
        step.deed = Deed::remove;
        break;
      case 3:
        step.deed = Deed::replace;
        step.shape = shape(false);
        break;
      case 4:
        step.deed = random.coin() ? Deed::set_layers : Deed::set_user;
        step.layers = layers();
        step.user = random.next();
        break;
      case 5:
        if (frames_ != 0) {
          step.deed = random.one_in(3) ? Deed::remove_frame : Deed::move_frame;
          step.target = static_cast<std::uint8_t>(frame() - 1);
          step.transform = transform(false);
          break;
        }
        [[fallthrough]];
      default: {
        step.deed = Deed::move;
        Point by;
        for (auto& axis : frame_.axes) by += axis * random.between(-far_, far_);
        step.transform.translation = Base::vec(extreme_ ? Base::any_point() : by);
      }
    }
  }

  std::uint32_t objects_ = 0;
  std::uint32_t frames_ = 0;
  std::uint32_t fixed_ = 0;  // bit i for object i
  bool is_later_ = false;
};

}  // namespace detent::verify
