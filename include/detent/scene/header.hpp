// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include "detent/scene/envelope.hpp"

namespace detent::detail {

/// The first 48 bytes of a snapshot: "DTNS", version 1.
struct SnapshotHeader : SnapshotStart<0x534e5444u, 1, 48> {
  std::uint16_t shapes = 0;  // bit shape_tag for each type of shape in the scene
  std::uint32_t next_generation = 0;
  std::uint32_t frame_count = 0;
  std::uint32_t object_count = 0;
  std::uint32_t fixed_count = 0;
  std::uint64_t fixed_digest = 0;
  std::uint32_t reserved = 0;

  [[nodiscard]] constexpr bool uses_reserved() const noexcept { return reserved != 0; }

  template <class Header, class F>
  static constexpr void fields(Header& h, const F& f) noexcept {
    f(h.shapes, h.next_generation, h.frame_count, h.object_count, h.fixed_count, h.fixed_digest,
      h.byte_count, h.reserved);
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

}  // namespace detent::detail
