// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "detent/number/digest.hpp"
#include "detent/scene/height_field/view.hpp"
#include "detent/scene/height_field/walk.hpp"

namespace detent {

/// Appends to a digest: corner, cell, columns, rows and the heights in order.
template <class D, Scalar S>
constexpr void append(D& digest, const HeightField<S>& field) noexcept {
  digest.add(field.corner, field.cell, field.columns, field.rows);
  for (const auto& height : field.heights) digest.add(height);
}

/// A height field that objects of scenes share, with an id chosen by the caller. Snapshots store
/// the id and the digest instead of the heights; the digest shows whether the heights are the same.
///
/// The caller owns the heights and must not change them: the digest is computed once.
template <Scalar S>
class FieldAsset {
 public:
  constexpr FieldAsset() noexcept : FieldAsset(0, HeightField<S>()) {}
  constexpr FieldAsset(std::uint32_t id, const HeightField<S>& view) noexcept
      : field_(view), digest_(detent::digest(view)), id_(id) {}

  [[nodiscard]] constexpr const HeightField<S>& field() const noexcept { return field_; }
  [[nodiscard]] constexpr std::uint32_t id() const noexcept { return id_; }
  [[nodiscard]] constexpr std::uint64_t digest() const noexcept { return digest_; }

 private:
  HeightField<S> field_;
  std::uint64_t digest_;
  std::uint32_t id_;
};

}  // namespace detent
