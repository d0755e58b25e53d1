// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "detent/dynamics/compound.hpp"
#include "detent/dynamics/particle/collide.hpp"
#include "detent/dynamics/terrain.hpp"
#include "detent/query/overlaps/aabb_aabb.hpp"
#include "detent/scene/mesh/surface.hpp"

// Bodies that are surfaces, as obstacles of particles.

namespace detent::detail {

/// A point of a body's frame in the world, each coordinate rounded to nearest once.
template <Scalar S>
[[nodiscard]] constexpr Vec<S, 3> placed_corner(const Standing<S, 3>& body,
                                                const Vec<S, 3>& point) noexcept {
  return make_vec<3>([&](int k) {
    const auto along =
        make_vec<3>([&](int i) { return body.axes[static_cast<std::size_t>(i)][k]; });
    return saturate_to<S>(body.place[k] + dot(along, point));
  });
}

/// A box around a placed box. The placed triangles of the contents lie inside it, because rounding
/// is monotone.
template <Scalar S>
[[nodiscard]] constexpr Aabb<S, 3> placed_box(const Standing<S, 3>& body,
                                              const Aabb<S, 3>& box) noexcept {
  auto result = no_box<Aabb<S, 3>>;
  if (!(box.min.x <= box.max.x)) return result;
  for (unsigned corner = 0; corner < 8; ++corner) {
    const auto at = placed_corner(
        body, make_vec<3>([&](int i) { return (corner >> i & 1) != 0 ? box.max[i] : box.min[i]; }));
    result = bounding_box(result, Aabb<S, 3>{at, at});
  }
  return result;
}

/// A box in a body's frame around all points that `placed_corner` may map into `box`, among those
/// up to `reach` from the frame's origin along each axis.
///
/// The axes A are orthonormal within 2^-28 per entry, so A (A^T p) differs from p by less than 3
/// reach 2^-28. Rounding a placed corner moves it by half a step along each axis, less than a step
/// in the frame.
template <Scalar S>
[[nodiscard]] constexpr Aabb<S, 3> box_in(const Standing<S, 3>& body, const Aabb<S, 3>& box,
                                          const S& reach) noexcept {
  const auto margin =
      grown(saturate_to<S>(reach * fraction<typename Formats<S>::Ratio>(1, 1 << 20)), 2);
  Aabb<S, 3> result;
  for (int i = 0; i < 3; ++i) {
    const auto& axis = body.axes[static_cast<std::size_t>(i)];
    const auto end = [&](bool is_most) {
      return dot(axis, make_vec<3>([&](int k) {
                   return ((axis[k] < 0) == is_most ? box.min[k] : box.max[k]) - body.place[k];
                 }));
    };
    result.min[i] = saturate_to<S>(floor_to<S>(end(false)) - margin);
    result.max[i] = saturate_to<S>(ceil_to<S>(end(true)) + margin);
  }
  return result;
}

/// The greatest magnitude of a coordinate of a box.
template <Scalar S>
[[nodiscard]] constexpr S reach_of(const Aabb<S, 3>& box) noexcept {
  S reach(0);
  for (int i = 0; i < 3; ++i) {
    reach = (std::max)({reach, saturate_to<S>(abs(box.min[i])), saturate_to<S>(abs(box.max[i]))});
  }
  return reach;
}

/// Calls f(triangle) for each triangle of a body's surface, in the world, that touches `box`, and
/// for some whose bounding box does, in the order of their indices.
template <Scalar S, class Body, class F>
constexpr void visit_placed_surface(const Standing<S, 3>& at, const Aabb<S, 3>& box,
                                    const Body& body, const F& f) {
  if (body.asset == nullptr) return;
  const auto& surface = surface_of(body);
  const auto within = box_in(at, box, reach_of(bounding_box(surface)));
  // The tree is walked in a different order, so each walk finds the next 16 indices.
  std::array<MeshTriangle<S>, 16> next{};
  for (std::optional<std::uint32_t> last;;) {
    std::size_t count = 0;
    bool are_more = false;
    visit_within(surface, within, [&](std::span<const MeshTriangle<S>> parts) {
      for (const auto& part : parts) {
        if (last && part.index <= *last) continue;
        const MeshTriangle<S> placed{
            {placed_corner(at, part.triangle.a), placed_corner(at, part.triangle.b),
             placed_corner(at, part.triangle.c)},
            part.index};
        if (!overlaps(box, bounding_box(placed.triangle))) continue;
        if (count == next.size()) {
          are_more = true;
          if (next[count - 1].index <= placed.index) continue;
          --count;
        }
        std::size_t i = count++;
        for (; i > 0 && next[i - 1].index > placed.index; --i) next[i] = next[i - 1];
        next[i] = placed;
      }
      return Walk::go_on;
    });
    for (std::size_t i = 0; i < count; ++i) f(next[i].triangle);
    if (!are_more) return;
    last = next[count - 1].index;
  }
}

}  // namespace detent::detail
