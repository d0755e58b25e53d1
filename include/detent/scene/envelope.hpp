// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

#include "detent/number/digest.hpp"
#include "detent/scene/bytes.hpp"

// The common format of snapshots of scenes, worlds and particles: a header that starts with a magic
// number, a version, the dimension and the scalar, and at the end the XXH64 of everything before
// it.

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

/// The reason in words.
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

/// The dimension and the scalar of a snapshot.
struct SnapshotSpace {
  std::uint8_t dimension = 0;
  std::uint8_t is_floating = 0;  // 1 for floating-point scalars
  std::uint8_t bits = 0;         // of the scalar: Fixed<bits, frac>, or 32 or 64
  std::uint8_t frac = 0;

  template <Scalar S, int N>
  [[nodiscard]] static constexpr SnapshotSpace of() noexcept {
    SnapshotSpace space;
    space.dimension = static_cast<std::uint8_t>(N);
    if constexpr (is_fixed<S>) {
      space.bits = static_cast<std::uint8_t>(S::bits);
      space.frac = static_cast<std::uint8_t>(S::frac);
    } else {
      space.is_floating = 1;
      space.bits = static_cast<std::uint8_t>(8 * sizeof(S));
    }
    return space;
  }

  [[nodiscard]] friend constexpr bool operator==(const SnapshotSpace&,
                                                 const SnapshotSpace&) noexcept = default;
};

/// The base of every header. `Header::fields(header, f)` calls `f` with the fields that follow
/// `space`, in the order of their bytes.
template <std::uint32_t Magic, std::uint16_t Version, std::size_t Size>
struct SnapshotStart {
  static constexpr std::size_t size = Size;
  static constexpr std::size_t checksum_size = 8;

  std::uint32_t magic = Magic;
  std::uint16_t version = Version;
  SnapshotSpace space;
  std::uint64_t byte_count = 0;

  [[nodiscard]] constexpr bool has_magic() const noexcept { return magic == Magic; }
  [[nodiscard]] constexpr bool has_version() const noexcept { return version == Version; }

  /// The bytes between the header and the checksum.
  [[nodiscard]] static constexpr std::span<const std::byte> body(
      std::span<const std::byte> bytes) noexcept {
    return bytes.subspan(size, bytes.size() - size - checksum_size);
  }
};

[[nodiscard]] constexpr std::uint64_t checksum_of(std::span<const std::byte> bytes) noexcept {
  Digest digest;
  digest.add_bytes(bytes);
  return digest.value();
}

/// Writes the header and the checksum around the `header.byte_count` bytes of a snapshot, whose other
/// bytes are in `room` already.
template <class Header>
constexpr void store_envelope(std::byte* room, const Header& header) noexcept {
  Writer out(std::span<std::byte>(room, Header::size));
  const auto& space = header.space;
  out.add(header.magic, header.version, space.dimension, space.is_floating, space.bits, space.frac);
  Header::fields(header, [&](const auto&... fields) { out.add(fields...); });
  const auto length = static_cast<std::size_t>(header.byte_count) - Header::checksum_size;
  store_word(room + length, checksum_of(std::span<const std::byte>(room, length)));
}

/// Writes a header, the bytes that `describe(writer)` writes, and the checksum; returns their
/// number. If `room` is smaller, its contents are unspecified. `describe` may still change the
/// header.
template <class Header, class Describe>
constexpr std::size_t seal(std::span<std::byte> room, Header& header,
                           const Describe& describe) noexcept {
  Writer body(room.subspan((std::min)(room.size(), Header::size)));
  describe(body);
  const auto size = Header::size + body.size() + Header::checksum_size;
  header.byte_count = size;
  if (room.size() >= size) store_envelope(room.data(), header);
  return size;
}

/// Reads the header of a snapshot, and checks what can be checked without a scene.
template <class Header>
[[nodiscard]] constexpr Restored open(std::span<const std::byte> bytes, Header& header) noexcept {
  Reader in(bytes);
  auto& space = header.space;
  in.get(header.magic, header.version);
  if (in.has_failed()) return Restored::truncated;
  if (!header.has_magic()) return Restored::no_snapshot;
  if (!header.has_version()) return Restored::other_version;
  in.get(space.dimension, space.is_floating, space.bits, space.frac);
  Header::fields(header, [&](auto&... fields) { in.get(fields...); });
  if (in.has_failed() || bytes.size() < header.byte_count) return Restored::truncated;
  if (bytes.size() != header.byte_count || bytes.size() < Header::size + Header::checksum_size ||
      header.uses_reserved()) {
    return Restored::corrupted;
  }
  const auto length = bytes.size() - Header::checksum_size;
  const auto checksum = load_word<std::uint64_t>(bytes.data() + length);
  return checksum_of(bytes.first(length)) == checksum ? Restored::yes : Restored::corrupted;
}

}  // namespace detail

}  // namespace detent
