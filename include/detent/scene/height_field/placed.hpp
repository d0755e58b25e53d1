// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "detent/scene/height_field/asset.hpp"
#include "detent/scene/height_field/walk.hpp"
#include "detent/scene/put.hpp"
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

/// Appends to a digest: id and digest of the field (zeros for none), and the
/// translation.
template <class D, Scalar S>
constexpr void append(D& digest, const PlacedField<S>& field) noexcept {
  digest.add(field.asset ? field.asset->id() : std::uint32_t{0},
             field.asset ? field.asset->digest() : std::uint64_t{0}, field.translation);
}

/// Its fields in a `Desync`: see fields.hpp.
template <Scalar S, class F>
constexpr void for_each_field(const PlacedField<S>& field, const F& f) {
  f("height field", field.asset ? field.asset->id() : std::uint32_t{0});
  f("digest of its heights", field.asset ? field.asset->digest() : std::uint64_t{0});
  f("translation", field.translation);
}

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

/// Wraps visit(triangles): it gets the translated triangles when called with those of the asset.
template <Scalar S, class Visit>
[[nodiscard]] constexpr auto in_place(const PlacedField<S>& field, const Visit& visit) noexcept {
  return [&](std::span<const MeshTriangle<S>> triangles) {
    std::array<MeshTriangle<S>, 2> there;
    for (std::size_t i = 0; i < triangles.size(); ++i) {
      there[i] = {translated(triangles[i].triangle, field.translation), triangles[i].index};
    }
    return visit(std::span<const MeshTriangle<S>>(there).first(triangles.size()));
  };
}

/// Whether every triangle is translated exactly, as for a placed mesh.
template <Scalar S>
[[nodiscard]] constexpr bool moves_exactly(const PlacedField<S>& field) noexcept {
  if (!is_fixed<S> || field.asset == nullptr) return false;
  const auto& bounds = field.asset->field().bounds;
  return is_in_range<S>(bounds.min + field.translation) &&
         is_in_range<S>(bounds.max + field.translation);
}

}  // namespace detail

/// The smallest box around all triangles, empty for none.
template <Scalar S>
[[nodiscard]] constexpr Aabb<S, 3> bounding_box(const PlacedField<S>& field) noexcept {
  if (field.asset == nullptr || field.asset->field().heights.empty()) {
    return detail::no_box<Aabb<S, 3>>;
  }
  return translated(field.asset->field().bounds, field.translation);
}

/// The parts of a translated field: see mesh/parts.hpp.
template <Scalar S>
[[nodiscard]] constexpr auto whole_of(const PlacedField<S>& field) noexcept {
  return whole_of(field.asset->field());
}
template <Scalar S, class Test>
constexpr bool any_child(const PlacedField<S>& field, const detail::FieldCells& cells,
                         const Test& test) noexcept {
  return any_child(field.asset->field(), cells,
                   [&](const detail::FieldCells& child, const Aabb<S, 3>& box) {
                     return test(child, translated(box, field.translation));
                   });
}
template <Scalar S, class Visit>
constexpr bool at_leaf(const PlacedField<S>& field, const detail::FieldCells& cell,
                       const Visit& visit) noexcept {
  return at_leaf(field.asset->field(), cell, detail::in_place(field, visit));
}

/// The traversals of a placed field: those of the field if the query can be moved back exactly,
/// else those through its parts.
template <Scalar S, class Visit>
constexpr void visit_along(const PlacedField<S>& field, const Ray<S, 3>& ray,
                           const Visit& visit) noexcept {
  const auto origin = ray.origin - field.translation;
  if (!detail::moves_exactly(field) || !detail::is_in_range<S>(origin)) {
    return visit_along<PlacedField>(field, ray, visit);
  }
  visit_along(field.asset->field(),
              Ray<S, 3>{nearest_to<S>(origin), ray.direction, ray.max_distance},
              detail::in_place(field, visit));
}
template <Scalar S, class Visit>
constexpr bool visit_crossing(const PlacedField<S>& field, const Segment<S, 3>& segment,
                              const Visit& visit) noexcept {
  const auto start = segment.start - field.translation, end = segment.end - field.translation;
  if (!detail::moves_exactly(field) || !detail::is_in_range<S>(start) ||
      !detail::is_in_range<S>(end)) {
    return visit_crossing<PlacedField>(field, segment, visit);
  }
  return visit_crossing(field.asset->field(), Segment{nearest_to<S>(start), nearest_to<S>(end)},
                        detail::in_place(field, visit));
}
/// The part of the box that is out of range once moved back touches no triangle.
template <Scalar S, class Visit>
constexpr bool visit_within(const PlacedField<S>& field, const Aabb<S, 3>& box,
                            const Visit& visit) noexcept {
  if (!detail::moves_exactly(field)) return visit_within<PlacedField>(field, box, visit);
  const auto& by = field.translation;
  return visit_within(field.asset->field(),
                      Aabb<S, 3>{nearest_to<S>(box.min - by), nearest_to<S>(box.max - by)},
                      detail::in_place(field, visit));
}
template <Scalar S, class Visit>
constexpr void visit_around(const PlacedField<S>& field, const Vec<S, 3>& point,
                            const Visit& visit) noexcept {
  const auto from = point - field.translation;
  if (!detail::moves_exactly(field) || !detail::is_in_range<S>(from)) {
    return visit_around<PlacedField>(field, point, visit);
  }
  visit_around(field.asset->field(), nearest_to<S>(from), detail::in_place(field, visit));
}

}  // namespace detent
