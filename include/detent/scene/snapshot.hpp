// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "detent/scene/assets.hpp"
#include "detent/scene/header.hpp"
#include "detent/scene/scene.hpp"

// A scene as bytes, and back:
//   snapshot(scene)              -> std::vector<std::byte>
//   snapshot(scene, room)        -> how many bytes, written when `room` holds them
//   restore(scene, bytes)        -> Restored: yes, or why the scene is unchanged
//   restore(scene, bytes, lists...) the same if moving objects refer to meshes, hulls, fields
//   digest(scene)                -> 64 bits of all objects and frames
//   digest_of(scene, id)         -> 64 bits of one object
//
// Version 1, all little-endian:
// * a header of 48 bytes (header.hpp);
// * each frame, in order of index: index, generation, index of its parent or 2^32 - 1 (4 bytes
//   each), transform;
// * each moving object, in order of index: index, generation, layers (4 bytes each), user word (8),
//   index of its frame or 2^32 - 1 (4), shape type (1), the numbers of the shape in order; for a
//   mesh or hull its id (4), digest (8) and transform, for a height field its id, digest and
//   translation. A moving sphere takes 41 bytes in Q16.16;
// * the XXH64 of all that.
//
// Equal scenes have equal bytes. Fixed objects appear only as the sum of their digests, and a scene
// restores only snapshots taken with the same fixed objects: once one is added, changed, moved or
// removed, earlier snapshots are `other_fixed_part`. Copies of a scene, with `=`, hold everything
// and are faster still.
//
// The digest of a scene omits the next generation, which depends on past objects.

namespace detent {

namespace detail {

template <Scalar S, int N, class... Shapes>
[[nodiscard]] constexpr SnapshotHeader header_for() noexcept {
  SnapshotHeader header;
  header.space = SnapshotSpace::of<S, N>();
  header.shapes = static_cast<std::uint16_t>(((1u << shape_tag<Shapes>) | ...));
  return header;
}

template <class D, class Frames>
constexpr std::uint32_t describe_frames(D& out, const Frames& frames) noexcept {
  std::uint32_t count = 0;
  for (std::size_t i = 0; i < frames.end(); ++i) {
    if (!frames.is_frame(i)) continue;
    ++count;
    out.add(static_cast<std::uint32_t>(i), frames[i].generation, frames[i].parent, frames[i].local);
  }
  return count;
}

template <class Shape, class Assets>
[[nodiscard]] constexpr Restored read_shape(Reader& in, Shape& shape, const Assets&) noexcept {
  in.get(shape);
  return Restored::yes;
}

/// Reads the parts of a snapshot in order.
template <class Assets, Scalar S, int N, class... Shapes>
class SnapshotReader {
 public:
  using Shape = OneOf<Shapes...>;
  static constexpr std::size_t frame_size = FrameHeader::size + byte_count<Transform<S, N>>;

  constexpr SnapshotReader(std::span<const std::byte> bytes, const SnapshotHeader& header,
                           const Assets& assets) noexcept
      : frames_(SnapshotHeader::body(bytes)), header_(header), assets_(assets), in_(frames_) {}

  [[nodiscard]] constexpr Reader& in() noexcept { return in_; }

  /// The generation of the frame with this index, or 0 when there is none.
  [[nodiscard]] constexpr std::uint32_t frame_generation(std::uint32_t index) const noexcept {
    std::size_t first = 0, last = header_.frame_count;
    while (first < last) {
      const auto middle = (first + last) / 2;
      FrameHeader frame;
      Reader in(frames_.subspan(middle * frame_size));
      frame.read(in);
      if (frame.index == index) return frame.generation;
      (frame.index < index ? first : last) = frame.index < index ? middle + 1 : middle;
    }
    return 0;
  }

  /// Reads the shape with this tag, or nothing when the scene has no such type.
  [[nodiscard]] constexpr std::optional<Shape> shape(std::uint8_t tag) noexcept {
    std::optional<Shape> result;
    (void)((shape_tag<Shapes> == tag ? (read<Shapes>(result), true) : false) || ...);
    return result;
  }
  /// The result of reading the last shape.
  [[nodiscard]] constexpr Restored said() const noexcept { return said_; }

 private:
  template <class T>
  constexpr void read(std::optional<Shape>& result) noexcept {
    T shape{};
    said_ = read_shape(in_, shape, assets_);
    result.emplace(shape);
  }

  std::span<const std::byte> frames_;
  SnapshotHeader header_;
  const Assets& assets_;
  Restored said_ = Restored::yes;
  Reader in_;
};

/// Whether the parts of a snapshot are valid and fit this scene.
template <class Storage, Scalar S, int N, class... Shapes, class Assets>
[[nodiscard]] constexpr Restored check_parts(const BasicScene<Storage, S, N, Shapes...>& scene,
                                             std::span<const std::byte> bytes,
                                             const SnapshotHeader& header,
                                             const Assets& assets) noexcept {
  using Snapshot = SnapshotReader<Assets, S, N, Shapes...>;
  const auto is_generation = [&](std::uint32_t generation) {
    return generation != 0 && generation < header.next_generation;
  };
  Snapshot snapshot(bytes, header, assets);
  Reader& in = snapshot.in();
  if (header.next_generation == 0) return Restored::corrupted;
  if (header.frame_count > in.left() / Snapshot::frame_size) return Restored::corrupted;
  std::uint64_t lowest_index = 0;
  for (std::uint32_t i = 0; i < header.frame_count; ++i) {
    FrameHeader frame;
    Transform<S, N> transform;
    frame.read(in);
    in.get(transform);
    if (in.has_failed() || frame.index < lowest_index || !is_generation(frame.generation)) {
      return Restored::corrupted;
    }
    if (frame.index >= Storage::frame_capacity) return Restored::no_room;
    lowest_index = std::uint64_t{frame.index} + 1;
    if (frame.parent == nowhere) continue;
    const auto parent = snapshot.frame_generation(frame.parent);
    if (parent == 0 || parent >= frame.generation) return Restored::corrupted;  // parents are older
  }
  lowest_index = 0;
  const auto& store = SceneAccess::store(scene);
  for (std::uint32_t i = 0; i < header.object_count; ++i) {
    ObjectHeader object;
    object.read(in);
    const auto shape = snapshot.shape(object.tag);
    if (!shape || in.has_failed() || object.index < lowest_index ||
        !is_generation(object.generation)) {
      return Restored::corrupted;
    }
    if (snapshot.said() != Restored::yes) return snapshot.said();
    if (object.index >= Storage::capacity) return Restored::no_room;
    lowest_index = std::uint64_t{object.index} + 1;
    const bool is_taken =
        store.is_object(object.index) && store[object.index].motion == Motion::fixed;
    const bool has_frame = object.frame == nowhere || snapshot.frame_generation(object.frame) != 0;
    if (is_taken || !has_frame) return Restored::corrupted;
  }
  return in.left() == 0 ? Restored::yes : Restored::corrupted;
}

/// Replaces the moving part of a scene by that of a checked snapshot.
template <class Storage, Scalar S, int N, class... Shapes, class Assets>
constexpr void apply(BasicScene<Storage, S, N, Shapes...>& scene, std::span<const std::byte> bytes,
                     const SnapshotHeader& header, const Assets& assets) {
  auto& store = SceneAccess::store(scene);
  SnapshotReader<Assets, S, N, Shapes...> snapshot(bytes, header, assets);
  Reader& in = snapshot.in();
  store.begin_bulk();
  store.frames().clear();
  for (std::uint32_t i = 0; i < header.frame_count; ++i) {
    FrameHeader frame;
    Transform<S, N> transform;
    frame.read(in);
    in.get(transform);
    store.frames().set({frame.index, frame.generation}, transform, frame.parent);
  }
  separately<job::PlaceFrames>(store.frames());
  std::size_t first = 0;
  const auto remove_until = [&](std::size_t end) {
    for (auto i = store.next_moving(first); i < end; i = store.next_moving(i + 1)) {
      store.remove(static_cast<std::uint32_t>(i));
    }
  };
  for (std::uint32_t i = 0; i < header.object_count; ++i) {
    ObjectHeader object;
    object.read(in);
    const auto shape = snapshot.shape(object.tag);
    if (first < object.index) remove_until(std::min<std::size_t>(object.index, store.end()));
    Traits traits{object.layers, object.user, Motion::moving, {}};
    if (object.frame != nowhere) {
      traits.frame = {object.frame, store.frames()[object.frame].generation};
    }
    const ObjectId id{object.index, object.generation};
    if (!store.put_shape(id, *shape, traits)) store.put(id, *shape, traits);
    first = std::size_t{object.index} + 1;
  }
  remove_until(store.end());
  store.end_bulk();
  store.set_next_generation(header.next_generation);
}

}  // namespace detail

/// Writes the canonical bytes of the moving part of a scene to `room`; returns their number. If
/// `room` is too small, its contents are unspecified.
template <class Storage, Scalar S, int N, class... Shapes>
constexpr std::size_t snapshot(const BasicScene<Storage, S, N, Shapes...>& scene,
                               std::span<std::byte> room) noexcept {
  const auto& store = detail::SceneAccess::store(scene);
  auto header = detail::header_for<S, N, Shapes...>();
  header.next_generation = store.next_generation();
  header.fixed_count = static_cast<std::uint32_t>(store.fixed_size());
  header.fixed_digest = store.fixed_digest();
  return detail::seal(room, header, [&](detail::Writer& out) {
    header.frame_count = detail::describe_frames(out, store.frames());
    for (auto i = store.next_moving(0); i < store.end(); i = store.next_moving(i + 1)) {
      ++header.object_count;
      store.describe(out, i);
    }
  });
}

/// The canonical bytes of the moving part of a scene.
template <class Storage, Scalar S, int N, class... Shapes>
[[nodiscard]] auto snapshot(const BasicScene<Storage, S, N, Shapes...>& scene) requires(
    Storage::is_growing) {
  typename Storage::template List<std::byte, 0> bytes(snapshot(scene, std::span<std::byte>()));
  snapshot(scene, std::span<std::byte>(bytes));
  return bytes;
}

// Deleted: compilers show the line with the name.
// clang-format off
template <std::size_t... Rooms, Scalar S, int N, class... Shapes>
void snapshot(const BasicScene<Bounded<Rooms...>, S, N, Shapes...>&) = delete;  // detent: a BoundedScene writes to a std::span: snapshot(scene, room)
// clang-format on

/// Replaces the moving objects and the frames of `scene` by those of a snapshot, or leaves the
/// scene unchanged and returns why. No bytes make it allocate more memory than the objects of a
/// full scene need. The meshes, hulls and height fields of moving objects are looked up by id and
/// digest in `lists` of `MeshAsset<S>`, `HullAsset<S, N>` and `FieldAsset<S>`, which must outlive
/// the scene.
template <class Storage, Scalar S, int N, class... Shapes, AssetList... Lists>
[[nodiscard]] constexpr Restored restore(BasicScene<Storage, S, N, Shapes...>& scene,
                                         std::span<const std::byte> bytes, const Lists&... lists) {
  const detail::AssetLists<Lists...> assets(lists...);
  detail::SnapshotHeader header;
  const auto read = detail::open(bytes, header);
  if (read != Restored::yes) return read;
  const auto right = detail::header_for<S, N, Shapes...>();
  if (header.space != right.space || header.shapes != right.shapes) return Restored::other_scene;
  const auto& store = detail::SceneAccess::store(scene);
  if (header.fixed_count != store.fixed_size() || header.fixed_digest != store.fixed_digest()) {
    return Restored::other_fixed_part;
  }
  const auto checked = detail::check_parts(scene, bytes, header, assets);
  if (checked != Restored::yes) return checked;
  detail::apply(scene, bytes, header, assets);
  return Restored::yes;
}

/// Appends to a digest: frames and objects in order of index.
template <class D, class Storage, Scalar S, int N, class... Shapes>
constexpr void append(D& digest, const BasicScene<Storage, S, N, Shapes...>& scene) noexcept {
  const auto& store = detail::SceneAccess::store(scene);
  detail::describe_frames(digest, store.frames());
  for (std::size_t i = 0; i < store.end(); ++i) {
    if (!store.is_object(i)) continue;
    digest.add(store[i].motion);
    store.describe(digest, i);
  }
}

/// The digest of one object: its id, traits and shape; nothing when it does not exist.
template <class Storage, Scalar S, int N, class... Shapes>
[[nodiscard]] constexpr std::optional<std::uint64_t> digest_of(
    const BasicScene<Storage, S, N, Shapes...>& scene, const ObjectId& id) noexcept {
  if (!scene.contains(id)) return std::nullopt;
  Digest digest;
  const auto& store = detail::SceneAccess::store(scene);
  digest.add(store[id.index].motion);
  store.describe(digest, id.index);
  return digest.value();
}

}  // namespace detent
