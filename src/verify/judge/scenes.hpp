// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <concepts>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "verify/judge/meshes.hpp"
#include "verify/sink.hpp"

// Scenes are judged by a plain list of objects with the same history, which tests every object
// exactly. Frames and movements use the library's `compose`, `placed` and `translated`; snapshots
// are rebuilt from the byte format described in snapshot.hpp.

namespace detent::verify::judge {

/// The objects and frames of a scene, by index.
template <Scalar S, int N>
class PlainScene {
 public:
  static constexpr std::uint32_t none = 0xffffffffu;

  struct Object {
    std::uint32_t generation = 0;
    Traits traits;
    std::uint32_t frame = none;
    SceneShape<S, N> shape;  // in its frame
  };
  struct Frame {
    std::uint32_t generation = 0;
    std::uint32_t parent = none;
    Transform<S, N> transform;
  };

  static constexpr auto is_there = [](const auto& item) { return item.generation != 0; };

  PlainScene() = default;
  explicit PlainScene(const History<S, N>& history) {
    for (std::size_t i = 0; i < history.before; ++i) live(history, i);
  }
  void live(const History<S, N>& history, std::size_t step) {
    if (happens(history.steps[step])) happened_ |= 1u << step;
  }
  [[nodiscard]] std::uint32_t happened() const { return happened_; }
  [[nodiscard]] std::uint32_t next() const { return next_; }
  [[nodiscard]] std::uint32_t size() const {
    return static_cast<std::uint32_t>(std::count_if(objects_.begin(), objects_.end(), is_there));
  }
  [[nodiscard]] std::optional<ObjectId> next_id() const {
    const auto i = free_in(objects_);
    return i < objects_.size() ? std::optional(ObjectId{i, next_}) : std::nullopt;
  }

  /// Calls visit(id, object, shape in the world) for every object, in id order.
  template <class Visit>
  void visit(const Visit& visit) const {
    for (std::uint32_t i = 0; i < objects_.size(); ++i) {
      const Object& object = objects_[i];
      if (!is_there(object)) continue;
      object.shape.visit([&](const auto& shape) {
        visit(ObjectId{i, object.generation}, object,
              object.frame == none ? shape : placed(world_of(object.frame), shape));
      });
    }
  }
  [[nodiscard]] const auto& objects() const { return objects_; }
  [[nodiscard]] const auto& frames() const { return frames_; }

 private:
  struct Name {
    std::uint32_t index = none;
    std::uint32_t generation = 0;
  };

  template <class Items>
  [[nodiscard]] static std::uint32_t free_in(const Items& items) {
    return static_cast<std::uint32_t>(std::find_if_not(items.begin(), items.end(), is_there) -
                                      items.begin());
  }
  /// The object or frame of the addition with this number, if it still exists.
  template <class Items>
  [[nodiscard]] static auto* named(Items& items, const std::vector<Name>& names, std::size_t i) {
    const auto name = i < names.size() ? names[i] : Name();
    const bool is = name.index != none && items[name.index].generation == name.generation;
    return is ? &items[name.index] : nullptr;
  }
  template <class Items, class Item>
  bool added(Items& items, std::vector<Name>& names, Item item, bool is_allowed) {
    const auto i = free_in(items);
    names.emplace_back();
    if (!is_allowed || i == items.size()) return false;
    item.generation = next_++;
    items[i] = item;
    names.back() = {i, item.generation};
    return true;
  }

  [[nodiscard]] Transform<S, N> world_of(std::uint32_t frame) const {
    const Frame& here = frames_[frame];
    return here.parent == none ? here.transform : compose(world_of(here.parent), here.transform);
  }

  bool happens(const Step<S, N>& step) {
    auto* const inside =
        step.frame == 0 ? nullptr : named(frames_, frame_names_, step.frame - std::size_t{1});
    const bool has_place = step.frame == 0 || inside != nullptr;
    const auto place =
        inside == nullptr ? none : static_cast<std::uint32_t>(inside - frames_.data());
    if (step.deed == Deed::add) {
      const auto motion = step.is_fixed ? Motion::fixed : Motion::moving;
      return added(objects_, names_,
                   Object{0, {step.layers, step.user, motion, {}}, place, step.shape},
                   has_place && !(step.is_fixed && step.frame != 0));
    }
    if (step.deed == Deed::add_frame) {
      return added(frames_, frame_names_, Frame{0, place, step.transform}, has_place);
    }
    if (step.deed == Deed::move_frame || step.deed == Deed::remove_frame) {
      return happens(step, named(frames_, frame_names_, step.target));
    }
    return happens(step, named(objects_, names_, step.target));
  }
  bool happens(const Step<S, N>& step, Frame* frame) {
    if (frame == nullptr) return false;
    if (step.deed == Deed::move_frame) {
      frame->transform = step.transform;
      return true;
    }
    const auto index = static_cast<std::uint32_t>(frame - frames_.data());
    for (const Frame& other : frames_) {
      if (is_there(other) && other.parent == index) return false;
    }
    for (const Object& object : objects_) {
      if (is_there(object) && object.frame == index) return false;
    }
    *frame = Frame();
    return true;
  }
  bool happens(const Step<S, N>& step, Object* object) {
    if (object == nullptr) return false;
    switch (step.deed) {
      case Deed::remove:
        *object = Object();
        break;
      case Deed::replace:
        object->shape = step.shape;
        break;
      case Deed::set_layers:
        object->traits.layers = step.layers;
        break;
      case Deed::set_user:
        object->traits.user = step.user;
        break;
      default:
        object->shape = object->shape.visit([&](const auto& shape) {
          return SceneShape<S, N>(translated(shape, step.transform.translation));
        });
    }
    return true;
  }

  std::array<Object, LivingScene<S, N>::capacity> objects_{};
  std::array<Frame, LivingScene<S, N>::frame_capacity> frames_{};
  std::vector<Name> names_, frame_names_;
  std::uint32_t next_ = 1;
  std::uint32_t happened_ = 0;
};

/// Collects canonical bytes.
struct IntoText {
  std::string bytes;
  void operator()(std::uint64_t word, int count) {
    for (int i = 0; i < count; ++i) bytes += static_cast<char>((word >> (8 * i)) & 0xff);
  }
};
using Bytes = Sink<IntoText>;

inline std::uint64_t digest_of(const std::string& bytes) {
  Digest digest;
  for (const char c : bytes) digest.add(static_cast<std::uint8_t>(c));
  return digest.value();
}

template <Scalar S, int N>
void put_frames(Bytes& out, const PlainScene<S, N>& scene) {
  for (std::uint32_t i = 0; i < scene.frames().size(); ++i) {
    const auto& frame = scene.frames()[i];
    if (scene.is_there(frame)) out.add(i, frame.generation, frame.parent, frame.transform);
  }
}
template <Scalar S, int N>
void put_object(Bytes& out, std::uint32_t i, const typename PlainScene<S, N>::Object& object) {
  out.add(i, object.generation, object.traits.layers, object.traits.user, object.frame);
  const auto put = [&](std::uint8_t tag, const auto* shape) {
    if (shape != nullptr) out.add(tag, *shape);
  };
  put(1, object.shape.template get<Sphere<S, N>>());
  put(2, object.shape.template get<Aabb<S, N>>());
  put(3, object.shape.template get<Obb<S, N>>());
}

template <Scalar S, int N>
std::uint64_t digest_of(const PlainScene<S, N>& scene) {
  Bytes out;
  put_frames(out, scene);
  for (std::uint32_t i = 0; i < scene.objects().size(); ++i) {
    const auto& object = scene.objects()[i];
    if (!scene.is_there(object)) continue;
    out.add(static_cast<std::uint8_t>(object.traits.motion));
    put_object<S, N>(out, i, object);
  }
  return digest_of(out.taken().bytes);
}

template <Scalar S, int N>
std::string snapshot_of(const PlainScene<S, N>& scene) {
  Bytes body;
  put_frames(body, scene);
  std::uint32_t moving = 0, fixed = 0;
  std::uint64_t fixed_digest = 0;
  for (std::uint32_t i = 0; i < scene.objects().size(); ++i) {
    const auto& object = scene.objects()[i];
    if (!scene.is_there(object)) continue;
    if (object.traits.motion == Motion::moving) {
      ++moving;
      put_object<S, N>(body, i, object);
    } else {
      Bytes alone;
      put_object<S, N>(alone, i, object);
      ++fixed;
      fixed_digest += digest_of(alone.taken().bytes);
    }
  }
  const auto& frames = scene.frames();
  const auto frame_count = std::count_if(frames.begin(), frames.end(), scene.is_there);
  Bytes out;
  for (const char c : {'D', 'T', 'N', 'S'}) out.add(static_cast<std::uint8_t>(c));
  out.add(std::uint16_t{1}, static_cast<std::uint8_t>(N), std::uint8_t{0},
          static_cast<std::uint8_t>(S::bits), static_cast<std::uint8_t>(S::frac),
          std::uint16_t{2 + 4 + 8}, scene.next(), static_cast<std::uint32_t>(frame_count), moving,
          fixed, fixed_digest, std::uint64_t{48 + body.taken().bytes.size() + 8}, std::uint32_t{0});
  const auto bytes = out.taken().bytes + body.taken().bytes;
  Bytes end;
  end.add(digest_of(bytes));
  return bytes + end.taken().bytes;
}

/// All objects with a distance_of(shape), as `Scene::all` defines.
template <Scalar S, int N, class DistanceOf>
std::vector<Found<S>> all_with(const PlainScene<S, N>& scene, std::uint32_t mask,
                               const DistanceOf& distance_of) {
  std::vector<Found<S>> all;
  scene.visit([&](const ObjectId& id, const auto& object, const auto& shape) {
    if ((object.traits.layers & mask) == 0) return;
    if (const std::optional<S> distance = distance_of(shape)) all.push_back({*distance, id});
  });
  std::sort(all.begin(), all.end());
  return all;
}
/// The distance of a point from a shape that shares a point with `question`.
template <Scalar S, int N, class Shape>
std::optional<S> distance_if_met(const oracle::Solid<N>& question, const Vec<S, N>& point,
                                 const Shape& shape) {
  if (!oracle::meet(question, oracle::exact(in_raw_units<S>(shape)))) return std::nullopt;
  return distance_to<S>(oracle::nearest(in_raw_units<S>(shape), in_raw_units<S>(point)));
}
template <Scalar S, int N>
std::vector<Found<S>> all_of(const PlainScene<S, N>& scene, const Sphere<S, N>& sphere,
                             std::uint32_t mask) {
  const auto solid = oracle::exact(sphere);
  return all_with(scene, mask,
                  [&](const auto& shape) { return distance_if_met(solid, sphere.center, shape); });
}
template <Scalar S, int N>
std::vector<Found<S>> all_of(const PlainScene<S, N>& scene, const Ray<S, N>& ray,
                             std::uint32_t mask) {
  return all_with(scene, mask, [&](const auto& shape) {
    const auto expected = oracle::expected_raycast(in_raw_units<S>(ray), in_raw_units<S>(shape));
    return expected.hit ? std::optional(clamped<S>(expected.hit->enter)) : std::nullopt;
  });
}

/// The object nearest to a point; empty shapes are skipped.
template <Scalar S, int N>
std::optional<Found<S>> nearest_of(const PlainScene<S, N>& scene, const Vec<S, N>& point,
                                   std::uint32_t mask) {
  std::optional<Found<S>> best;
  scene.visit([&](const ObjectId& id, const auto& object, const auto& shape) {
    const auto truth = oracle::nearest(in_raw_units<S>(shape), in_raw_units<S>(point));
    if (!truth || (object.traits.layers & mask) == 0) return;
    const Found<S> found{distance_to<S>(truth), id};
    if (!best || found < *best) best = found;
  });
  return best;
}

template <Scalar S, int N>
std::vector<Overlap> pairs_of(const PlainScene<S, N>& scene) {
  std::vector<Overlap> pairs;
  scene.visit([&](const ObjectId& a, const auto& first, const auto& shape) {
    scene.visit([&](const ObjectId& b, const auto& second, const auto& other) {
      const bool rest =
          first.traits.motion == Motion::fixed && second.traits.motion == Motion::fixed;
      if (!(a < b) || rest) return;
      if (oracle::meet(in_raw_units<S>(shape), in_raw_units<S>(other))) pairs.push_back({a, b});
    });
  });
  return pairs;
}

template <int Row, Scalar S, int N, class Answer>
std::optional<Wrong> judge(const SceneCase<S, N>& c, const Answer& got) {
  const PlainScene<S, N> scene(c.history);
  if constexpr (Row == 1) {
    return compare(nearest_of(scene, c.point, c.mask), got);
  } else {
    return compare_results(all_of(scene, c.ray, c.mask), got);
  }
}

template <int Row, Scalar S, int N, class Answer>
std::optional<Wrong> judge(const MeetingCase<S, N>& c, const Answer& got) {
  const PlainScene<S, N> scene(c.history);
  if constexpr (Row < 2) {
    return compare_results(all_of(scene, c.sphere, c.mask), got);
  } else {
    return compare_results(pairs_of(scene), got);
  }
}

template <int Row, Scalar S, int N, class Answer>
std::optional<Wrong> judge(const RecordCase<S, N>& c, const Answer& got) {
  const PlainScene<S, N> scene(c.history);
  if constexpr (Row == 0) {
    return compare(Answer{scene.happened(), scene.size(), digest_of(scene)}, got);
  } else {
    const auto bytes = snapshot_of(scene);
    return compare(Answer{static_cast<std::uint32_t>(bytes.size()), digest_of(bytes),
                          static_cast<std::uint8_t>(Restored::yes), digest_of(scene),
                          scene.next_id(), nearest_of(scene, c.point, ~std::uint32_t{0})},
                   got);
  }
}

template <int Row, Scalar S, int N>
std::optional<Wrong> judge(const EventsCase<S, N>& c, const Events& got) {
  PlainScene<S, N> scene;
  std::vector<Overlap> before;
  Events expected;
  for (std::size_t i = 0; i < c.history.count; ++i) {
    scene.live(c.history, i);
    auto now = pairs_of(scene);
    std::sort(now.begin(), now.end());
    std::vector<Overlap> began, stayed, ended;
    for (const auto& pair : now) {
      const bool was = std::find(before.begin(), before.end(), pair) != before.end();
      (was ? stayed : began).push_back(pair);
    }
    for (const auto& pair : before) {
      if (std::find(now.begin(), now.end(), pair) == now.end()) ended.push_back(pair);
    }
    expected.add(began, stayed, ended);
    before = std::move(now);
  }
  return compare(expected, got);
}

}  // namespace detent::verify::judge
