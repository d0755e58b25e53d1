// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "detent/scene/events.hpp"
#include "detent/scene/snapshot.hpp"
#include "verify/draw/histories.hpp"
#include "verify/questions/cases.hpp"
#include "verify/questions/listed.hpp"

// Scenes after a short history: query results, digests and snapshots.

namespace detent::verify {

/// A scene that runs a history.
template <Scalar S, int N>
class LivingScene {
 public:
  /// Smaller than some histories need.
  static constexpr std::size_t capacity = 10;
  static constexpr std::size_t frame_capacity = 2;

  constexpr LivingScene() noexcept = default;
  explicit constexpr LivingScene(const History<S, N>& history) noexcept {
    live(history, 0, history.before);
  }

  DETENT_VERIFY_NOINLINE constexpr void live(const History<S, N>& history, std::size_t first,
                                             std::size_t last) noexcept {
    for (std::size_t i = first; i < last; ++i) {
      if (happens(history.steps[i])) happened_ |= 1u << i;
    }
  }

  BoundedScene<Bounded<capacity, frame_capacity>, S, N, Sphere, Aabb, Obb> scene;

  /// Bit i is set when step i succeeded.
  [[nodiscard]] constexpr std::uint32_t happened() const noexcept { return happened_; }

 private:
  static constexpr std::uint32_t none = 0xffffffffu;

  constexpr bool happens(const Step<S, N>& step) noexcept {
    const ObjectId& object = objects_[step.target];
    switch (step.deed) {
      case Deed::add: {
        const Traits traits{step.layers, step.user, step.is_fixed ? Motion::fixed : Motion::moving,
                            frame_of(step)};
        const auto id =
            step.shape.visit([&](const auto& shape) { return scene.add(shape, traits); });
        objects_[object_count_++] = id.value_or(ObjectId{none, none});
        return id.has_value();
      }
      case Deed::remove:
        return scene.remove(object);
      case Deed::replace:
        return step.shape.visit(
            [&](const auto& shape) { return scene.replace_local(object, shape); });
      case Deed::move:
        return scene.move(object, step.transform.translation);
      case Deed::set_layers:
        return scene.set_layers(object, step.layers);
      case Deed::set_user:
        return scene.set_user(object, step.user);
      case Deed::add_frame: {
        const auto id = scene.add_frame(step.transform, frame_of(step));
        frames_[frame_count_++] = id.value_or(FrameId{none, none});
        return id.has_value();
      }
      case Deed::move_frame:
        return scene.move_frame(frames_[step.target], step.transform);
      default:
        return scene.remove_frame(frames_[step.target]);
    }
  }
  [[nodiscard]] constexpr FrameId frame_of(const Step<S, N>& step) const noexcept {
    return step.frame == 0 ? FrameId{} : frames_[step.frame - 1u];
  }

  std::array<ObjectId, History<S, N>::capacity> objects_{};
  std::array<FrameId, History<S, N>::capacity> frames_{};
  std::size_t object_count_ = 0;
  std::size_t frame_count_ = 0;
  std::uint32_t happened_ = 0;
};

/// Which steps succeeded, and the resulting scene.
struct Outcome {
  std::uint32_t happened = 0;
  std::uint32_t size = 0;
  std::uint64_t digest = 0;

  [[nodiscard]] friend constexpr bool operator==(const Outcome&, const Outcome&) noexcept = default;
};
template <class D>
constexpr void append(D& digest, const Outcome& outcome) noexcept {
  digest.add(outcome.happened, outcome.size, outcome.digest);
}

/// A snapshot restored into its scene after more steps: whether that succeeded, and the scene's
/// digest, next id and nearest object.
template <Scalar S>
struct Rollback {
  std::uint32_t byte_count = 0;
  std::uint64_t bytes = 0;  // their digest
  std::uint8_t restored = 0;
  std::uint64_t digest = 0;
  std::optional<ObjectId> next;
  std::optional<Found<S>> nearest;

  [[nodiscard]] friend constexpr bool operator==(const Rollback&,
                                                 const Rollback&) noexcept = default;
};
template <class D, Scalar S>
constexpr void append(D& digest, const Rollback<S>& rollback) noexcept {
  digest.add(rollback.byte_count, rollback.bytes, rollback.restored, rollback.digest, rollback.next,
             rollback.nearest);
}

/// Groups of scenes run one question in twelve, because each builds its scene.
struct SceneGroup : InDimensions<2, 3> {
  static constexpr std::uint32_t share = 12;
};

template <Scalar S, int N>
struct SceneCase {
  History<S, N> history;
  std::uint32_t mask = 0;
  Ray<S, N> ray;
  Vec<S, N> point;

  constexpr auto fields(const auto& f) const noexcept { return f(history, mask, ray, point); }
};

/// The nearest objects along a ray and to a point, in some layers.
struct SceneQuestions : SceneGroup {
  static constexpr std::array<std::string_view, 3> names{"scene/nearest/ray", "scene/nearest/point",
                                                         "scene/all/ray"};
  template <Scalar S, int N>
  static constexpr auto draw(Random& random) noexcept {
    HistoryScene<S, N> scene(random);
    SceneCase<S, N> c;
    c.history = scene.history();
    c.mask = static_cast<std::uint32_t>(random.below(8));
    scene.look_around();
    c.ray = scene.aimed_ray();
    c.point = scene.spot();
    return c;
  }
  template <int Row, Scalar S, int N>
  [[nodiscard]] static constexpr auto answer(const SceneCase<S, N>& c) noexcept {
    const LivingScene<S, N> living(c.history);
    const auto& scene = living.scene;
    const InLayers filter{c.mask};
    if constexpr (Row == 0) {
      return scene.nearest(c.ray, filter);
    } else if constexpr (Row == 1) {
      return scene.nearest(c.point, filter);
    } else {
      return list_all<Found<S>, 4>(scene, c.ray, filter);
    }
  }
};

template <Scalar S, int N>
struct MeetingCase {
  History<S, N> history;
  std::uint32_t mask = 0;
  Sphere<S, N> sphere;

  constexpr auto fields(const auto& f) const noexcept { return f(history, mask, sphere); }
};

/// The objects that overlap a sphere in some layers, and all overlapping pairs.
struct SceneMeetings : SceneGroup {
  static constexpr std::array<std::string_view, 3> names{"scene/any/sphere", "scene/all/sphere",
                                                         "scene/overlaps"};
  template <Scalar S, int N>
  static constexpr auto draw(Random& random) noexcept {
    HistoryScene<S, N> scene(random);
    MeetingCase<S, N> c;
    c.history = scene.history();
    c.mask = static_cast<std::uint32_t>(random.below(8));
    scene.look_around();
    c.sphere = scene.sphere();
    return c;
  }
  template <int Row, Scalar S, int N>
  [[nodiscard]] static constexpr auto answer(const MeetingCase<S, N>& c) noexcept {
    const LivingScene<S, N> living(c.history);
    const auto& scene = living.scene;
    const InLayers filter{c.mask};
    if constexpr (Row == 0) {
      return scene.any(c.sphere, filter);
    } else if constexpr (Row == 1) {
      return list_all<Found<S>, 4>(scene, c.sphere, filter);
    } else {
      return Listed<Overlap, 6>([&](std::span<Overlap> room) { return scene.overlaps(room); });
    }
  }
};

template <Scalar S, int N>
struct RecordCase {
  History<S, N> history;
  Vec<S, N> point;
  Sphere<S, N> sphere;

  constexpr auto fields(const auto& f) const noexcept { return f(history, point, sphere); }
};

/// The digest of a scene, and its snapshot.
struct SceneRecords : SceneGroup {
  static constexpr std::array<std::string_view, 2> names{"scene/digest", "scene/snapshot"};
  template <Scalar S, int N>
  static constexpr auto draw(Random& random) noexcept {
    HistoryScene<S, N> scene(random);
    RecordCase<S, N> c;
    c.history = scene.history();
    scene.look_around();
    c.point = scene.spot();
    c.sphere = scene.sphere();
    return c;
  }
  template <int Row, Scalar S, int N>
  [[nodiscard]] static constexpr auto answer(const RecordCase<S, N>& c) noexcept {
    if constexpr (Row == 0) {
      const LivingScene<S, N> living(c.history);
      return Outcome{living.happened(), static_cast<std::uint32_t>(living.scene.size()),
                     digest(living.scene)};
    } else {
      return rollback(c);
    }
  }

 private:
  /// The snapshot size of the largest history.
  template <Scalar S, int N>
  static constexpr std::size_t room_for() noexcept {
    constexpr auto object = 25 + detail::byte_count<Obb<S, N>>;
    constexpr auto frame = 12 + detail::byte_count<Transform<S, N>>;
    return 56 + LivingScene<S, N>::capacity * object + LivingScene<S, N>::frame_capacity * frame;
  }
  template <Scalar S, int N>
  using Bytes = std::array<std::byte, room_for<S, N>()>;

  // One scene at a time, for small memories.
  template <Scalar S, int N>
  DETENT_VERIFY_NOINLINE static constexpr auto rollback(const RecordCase<S, N>& c) noexcept {
    Bytes<S, N> room{};
    Rollback<S> result;
    result.byte_count = static_cast<std::uint32_t>(save(c, room));
    const auto bytes = std::span(room).first(result.byte_count);
    Digest digest;
    digest.add_bytes(bytes);
    result.bytes = digest.value();
    load(c, bytes, result);
    return result;
  }
  template <Scalar S, int N>
  DETENT_VERIFY_NOINLINE static constexpr std::size_t save(const RecordCase<S, N>& c,
                                                           Bytes<S, N>& room) noexcept {
    const LivingScene<S, N> living(c.history);
    return snapshot(living.scene, room);
  }
  template <Scalar S, int N>
  DETENT_VERIFY_NOINLINE static constexpr void load(const RecordCase<S, N>& c,
                                                    std::span<const std::byte> bytes,
                                                    Rollback<S>& result) noexcept {
    LivingScene<S, N> living(c.history);
    living.live(c.history, c.history.before, c.history.count);
    auto& scene = living.scene;
    result.restored = static_cast<std::uint8_t>(restore(scene, bytes));
    result.digest = digest(scene);
    result.nearest = scene.nearest(c.point);
    result.next = scene.add(c.sphere);
  }
};

/// The pairs that began, stayed and ended: counts over all frames, and a digest of the lists.
struct Events {
  std::uint32_t began = 0, stayed = 0, ended = 0;
  Digest lists{};

  template <class Pairs>
  constexpr void add(const Pairs& began_now, const Pairs& stayed_now,
                     const Pairs& ended_now) noexcept {
    const auto add_list = [&](std::uint32_t& count, const Pairs& list) {
      count += static_cast<std::uint32_t>(list.size());
      lists.add(static_cast<std::uint32_t>(list.size()));
      for (const Overlap& pair : list) lists.add(pair);
    };
    add_list(began, began_now);
    add_list(stayed, stayed_now);
    add_list(ended, ended_now);
  }
  [[nodiscard]] friend constexpr bool operator==(const Events& a, const Events& b) noexcept {
    return a.began == b.began && a.stayed == b.stayed && a.ended == b.ended &&
           a.lists.value() == b.lists.value();
  }
};
template <class D>
constexpr void append(D& digest, const Events& events) noexcept {
  digest.add(events.began, events.stayed, events.ended, events.lists.value());
}

template <Scalar S, int N>
struct EventsCase {
  History<S, N> history;

  constexpr auto fields(const auto& f) const noexcept { return f(history); }
};

/// Which pairs begin, stay and end overlapping in each step of a history.
struct SceneEvents : SceneGroup {
  static constexpr std::array<std::string_view, 1> names{"scene/events"};
  template <Scalar S, int N>
  static constexpr auto draw(Random& random) noexcept {
    HistoryScene<S, N> scene(random);
    return EventsCase<S, N>{scene.history()};
  }
  template <int Row, Scalar S, int N>
  [[nodiscard]] static constexpr auto answer(const EventsCase<S, N>& c) noexcept {
    constexpr std::size_t most =
        LivingScene<S, N>::capacity * (LivingScene<S, N>::capacity - 1) / 2;
    LivingScene<S, N> living;
    BoundedOverlapEvents<most> events;
    Events result;
    for (std::size_t i = 0; i < c.history.count; ++i) {
      living.live(c.history, i, i + 1);
      std::array<Overlap, most> pairs{};
      const auto count = living.scene.overlaps(pairs);
      events.update(std::span(pairs).first(count));
      result.add(events.began(), events.stayed(), events.ended());
    }
    return result;
  }
};

}  // namespace detent::verify
