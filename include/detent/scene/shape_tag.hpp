// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string_view>

#include "detent/shape/aabb.hpp"
#include "detent/shape/capsule.hpp"
#include "detent/shape/obb.hpp"
#include "detent/shape/plane.hpp"
#include "detent/shape/sphere.hpp"
#include "detent/shape/triangle.hpp"

namespace detent::detail {

/// The number of a shape type in snapshots and digests of scenes. It never changes.
template <class Shape>
inline constexpr std::uint8_t shape_tag = 0;
template <Scalar S, int N>
inline constexpr std::uint8_t shape_tag<Sphere<S, N>> = 1;
template <Scalar S, int N>
inline constexpr std::uint8_t shape_tag<Aabb<S, N>> = 2;
template <Scalar S, int N>
inline constexpr std::uint8_t shape_tag<Obb<S, N>> = 3;
template <Scalar S, int N>
inline constexpr std::uint8_t shape_tag<Plane<S, N>> = 4;
template <Scalar S, int N>
inline constexpr std::uint8_t shape_tag<Triangle<S, N>> = 5;
template <Scalar S, int N>
inline constexpr std::uint8_t shape_tag<Capsule<S, N>> = 6;

/// The names of shapes in lists of differences, by number; the folders mesh/, hull/ and
/// height_field/ name shapes that only some scenes have.
inline constexpr std::string_view shape_names[] = {"shape", "sphere",      "aabb",    "obb",
                                                   "plane", "triangle",    "capsule", "mesh",
                                                   "hull",  "height field"};

}  // namespace detent::detail
