// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

#include "detent/number/digest.hpp"
#include "detent/scene/bytes.hpp"

namespace detent {

/// The result of `restore`.
enum class Restored {
  yes,
  no_snapshot,
  other_version,
  truncated,
  corrupted,
  other_scene,
  other_fixed_part,
  no_room,
  unknown_asset,
  other_asset,
  unknown_mesh = unknown_asset,
  other_mesh = other_asset,
};

/// The reason as text.
[[nodiscard]] constexpr std::string_view describe(Restored restored) noexcept {
  switch (restored) {
    case Restored::yes:
      return "restored";
    case Restored::no_snapshot:
      return "these bytes are not a snapshot";
    case Restored::other_version:
      return "the snapshot has a version that this library does not read";
    case Restored::truncated:
      return "the snapshot is cut off";
    case Restored::corrupted:
      return "the bytes of the snapshot have been changed";
    case Restored::other_scene:
      return "the snapshot is of another scalar, dimension or set of shapes";
    case Restored::other_fixed_part:
      return "fixed objects have been added, changed, moved or removed since the snapshot was "
             "taken";
    case Restored::no_room:
      return "the snapshot has more than the storage of the scene can hold";
    case Restored::unknown_asset:
      return "the snapshot refers to a mesh, hull or height field by an id that none of the given "
             "ones has";
    case Restored::other_asset:
      return "the snapshot refers to a mesh, hull or height field of this id with other triangles, "
             "points or heights";
  }
  return "";
}

namespace detail {

/// The first 48 bytes of a snapshot.
struct SnapshotHeader {
  static constexpr std::uint32_t right_magic = 0x534e5444u;  // "DTNS"
  static constexpr std::uint16_t right_version = 1;
  static constexpr std::size_t size = 48;
  static constexpr std::size_t checksum_size = 8;

  std::uint32_t magic = right_magic;
  std::uint16_t version = right_version;
  std::uint8_t dimension = 0;
  std::uint8_t is_floating = 0;  // 1 for floating-point scalars
  std::uint8_t bits = 0;         // of the scalar: Fixed<bits, frac>, or 32 or 64
  std::uint8_t frac = 0;
  std::uint16_t shapes = 0;  // bit shape_tag for each type of shape in the scene
  std::uint32_t next_generation = 0;
  std::uint32_t frame_count = 0;
  std::uint32_t object_count = 0;
  std::uint32_t fixed_count = 0;
  std::uint64_t fixed_digest = 0;
  std::uint64_t byte_count = 0;
  std::uint32_t reserved = 0;

  template <class D>
  constexpr void describe(D& out) const noexcept {
    out.add(magic, version, dimension, is_floating, bits, frac, shapes, next_generation,
            frame_count, object_count, fixed_count, fixed_digest, byte_count, reserved);
  }

  /// Reads the header, and checks what can be checked without a scene.
  constexpr Restored read(std::span<const std::byte> bytes) noexcept {
    Reader in(bytes);
    in.get(magic, version, dimension, is_floating, bits, frac, shapes, next_generation, frame_count,
           object_count, fixed_count, fixed_digest, byte_count, reserved);
    if (bytes.size() >= 6) Reader(bytes).get(magic, version);
    if (bytes.size() < 6) return Restored::truncated;
    if (magic != right_magic) return Restored::no_snapshot;
    if (version != right_version) return Restored::other_version;
    if (in.has_failed() || bytes.size() < byte_count) return Restored::truncated;
    if (bytes.size() != byte_count || bytes.size() < size + checksum_size || reserved != 0) {
      return Restored::corrupted;
    }
    Digest digest;
    digest.add_bytes(bytes.first(bytes.size() - checksum_size));
    const auto checksum = load_word<std::uint64_t>(bytes.last(checksum_size).data());
    return digest.value() == checksum ? Restored::yes : Restored::corrupted;
  }
};

/// The fields of an object before its shape.
struct ObjectHeader {
  std::uint32_t index = 0;
  std::uint32_t generation = 0;
  std::uint32_t layers = 0;
  std::uint64_t user = 0;
  std::uint32_t frame = 0;
  std::uint8_t tag = 0;

  constexpr void read(Reader& in) noexcept { in.get(index, generation, layers, user, frame, tag); }
};

/// The fields of a frame before its transform.
struct FrameHeader {
  std::uint32_t index = 0;
  std::uint32_t generation = 0;
  std::uint32_t parent = 0;
  static constexpr std::size_t size = 12;

  constexpr void read(Reader& in) noexcept { in.get(index, generation, parent); }
};

}  // namespace detail

}  // namespace detent
