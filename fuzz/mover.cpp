// SPDX-License-Identifier: MIT
//
// A character in any scene, with any settings, ends every move overlapping nothing that it did not
// overlap at its start, and on the same side of every plane that it did not overlap. It moved by
// the reported distance, and repeating the move gives the same result.

#include <string>
#include <type_traits>

#include "decode.hpp"
#include "detent/scene/mover.hpp"
#include "spaces.hpp"

namespace detent::fuzz {
namespace {

template <Scalar S, int N>
using World = Scene<S, N, Sphere, Aabb, Triangle, Plane>;

/// A point of a shape, which moves by the same vector as all of it.
template <Scalar S, int N>
Vec<S, N> mark(const Sphere<S, N>& sphere) {
  return sphere.center;
}
template <Scalar S, int N>
Vec<S, N> mark(const Capsule<S, N>& capsule) {
  return capsule.a;
}

template <Scalar S, int N>
int side_of(const Plane<S, N>& plane, const Vec<S, N>& point) {
  const auto height = dot(plane.normal, point) - plane.offset;
  return height < 0 ? -1 : height > 0 ? 1 : 0;
}

template <Scalar S, int N>
void populate(World<S, N>& world, Source& source, Decoder<S, N>& decoder, FrameId frame) {
  for (auto count = source.below(8); count > 0; --count) {
    Traits traits{.layers = 1u << source.below(2)};
    if (source.below(3) == 0) traits.frame = frame;
    with_one_of<Sphere<S, N>, Aabb<S, N>, Triangle<S, N>, Plane<S, N>>(
        source, [&]<class Shape>(std::type_identity<Shape>) {
          // Boxes do not rotate with a frame.
          if constexpr (std::is_same_v<Shape, Aabb<S, N>>) traits.frame = FrameId{};
          world.add(decoder.template shape<Shape>(), traits);
        });
  }
}

template <Scalar S, int N>
MoverSettings<S, N> settings_of(Source& source, Decoder<S, N>& decoder) {
  MoverSettings<S, N> settings;
  if (source.below(2) == 0) settings.up = decoder.direction();
  if (source.below(2) == 0) settings.skin = decoder.reach();
  if (source.below(2) == 0) settings.step_height = decoder.number();
  if (source.below(2) == 0) settings.snap_distance = decoder.number();
  settings.max_slope = Angle<S>::turn(static_cast<int>(source.below(91)), 360);
  return settings;
}

template <Scalar S, int N, template <class, int> class Shape>
void check_move(const World<S, N>& world, Mover<S, N, Shape>& mover, const Vec<S, N>& by,
                const MoverSettings<S, N>& settings, const InLayers& filter) {
  const auto before = mover;
  const auto result = mover.move(world, by, settings, filter);
  const char* fault = nullptr;  // visitors must not throw
  world.for_each([&](const ObjectInfo& object, const auto& target) {
    if (!filter(object) || overlaps(before.shape, target)) return;
    if (overlaps(mover.shape, target)) fault = "it overlaps what it did not overlap before";
    if constexpr (std::is_same_v<decltype(target), const Plane<S, N>&>) {
      // The character's carrier moved before it did.
      const bool is_carried = before.ground.is_grounded && before.ground.frame != FrameId{};
      const auto frame = world.frame_of(object.id).value_or(FrameId{});
      if ((is_carried && frame == before.ground.frame) || mover.shape.radius < 0) return;
      if (side_of(target, mark(before.shape)) != side_of(target, mark(mover.shape))) {
        fault = "it passed a plane";
      }
    }
  });
  require(fault == nullptr, [&] { return std::string(fault); });
  // An empty shape at the end of the range is clamped there.
  require(before.shape.radius < 0 ||
              result.moved == nearest_to<S>(mark(mover.shape) - mark(before.shape)),
          [] { return std::string("it moved by something else"); });
  auto again = before;
  require(again.move(world, by, settings, filter) == result && again == mover,
          [] { return std::string("the same move again has another result"); });
}

template <template <class, int> class Shape, Scalar S, int N>
void check(Source& source) {
  Decoder<S, N> decoder(source);
  World<S, N> world;
  const auto frame = world.add_frame({.translation = decoder.point()}).value_or(FrameId{});
  populate(world, source, decoder, frame);
  const auto settings = settings_of(source, decoder);
  const InLayers filter{static_cast<std::uint32_t>(1 + source.below(3))};
  Mover<S, N, Shape> mover{decoder.template shape<Shape<S, N>>()};
  for (auto moves = 1 + source.below(4); moves > 0; --moves) {
    check_move(world, mover, decoder.point(), settings, filter);
    if (source.below(3) == 0) world.move_frame(frame, {.translation = decoder.point()});
  }
}

}  // namespace

void property(Bytes input) {
  Source source(input);
  in_a_space(source, [&]<Scalar S, int N>(Space<S, N>) {
    if constexpr (N == 3) {
      check<Capsule, S, N>(source);
    } else {
      check<Sphere, S, N>(source);
    }
  });
}

}  // namespace detent::fuzz
