// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "detent/scene/asset_instance.hpp"
#include "detent/scene/height_field/asset.hpp"
#include "detent/scene/height_field/walk.hpp"
#include "detent/scene/mesh/placed_surface.hpp"
#include "detent/scene/shape_tag.hpp"

namespace detent {

/// A translated height field: a surface of its triangles, each coordinate translated, rounded to
/// nearest and clamped to the range of the scalar. It has no rotation, because heights stay
/// upright.
///
/// The caller owns the asset, which must outlive it; without one there are no triangles.
template <Scalar S>
struct PlacedField {
  const FieldAsset<S>* asset = nullptr;
  Vec<S, 3> translation{};

  [[nodiscard]] friend constexpr bool operator==(const PlacedField&,
                                                 const PlacedField&) noexcept = default;
};

template <Scalar S>
PlacedField(const FieldAsset<S>*) -> PlacedField<S>;
template <Scalar S>
PlacedField(const FieldAsset<S>*, Vec<S, 3>) -> PlacedField<S>;

template <>
inline constexpr bool is_surface<PlacedField> = true;
template <>
inline constexpr bool is_placed_surface<PlacedField> = true;

template <Scalar S>
inline constexpr detail::AssetNames detail::asset_names<PlacedField<S>>{"height field",
                                                                        "digest of its heights"};

/// The field moved by a vector: the translation is rounded to nearest and clamped.
template <Scalar S>
[[nodiscard]] constexpr PlacedField<S> translated(const PlacedField<S>& field,
                                                  const Vec<S, 3>& by) noexcept {
  return {field.asset, nearest_to<S>(field.translation + by)};
}

/// The field moved from a local frame to the world. It is not rotated or scaled: only its
/// translation is transformed, as a point.
template <Scalar S>
[[nodiscard]] constexpr PlacedField<S> placed(const Transform<S, 3>& transform,
                                              const PlacedField<S>& field) noexcept {
  return {field.asset, transform_point(transform, field.translation)};
}

namespace detail {

template <Scalar S>
inline constexpr std::uint8_t shape_tag<PlacedField<S>> = 9;

template <Scalar S>
struct AssetSurface<PlacedField<S>> {
  static constexpr const HeightField<S>& of(const PlacedField<S>& field) noexcept {
    return field.asset->field();
  }
  static constexpr const Vec<S, 3>& translation(const PlacedField<S>& field) noexcept {
    return field.translation;
  }
  static constexpr bool only_moves(const PlacedField<S>&) noexcept { return true; }
  template <class Shape>
  static constexpr Shape put(const PlacedField<S>& field, const Shape& shape) noexcept {
    return translated(shape, field.translation);
  }
};

}  // namespace detail

}  // namespace detent
