// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <type_traits>

#include "detent/query/contact/pair.hpp"
#include "detent/query/raycast/hit.hpp"
#include "detent/scene/mesh/overlaps.hpp"

namespace detent {

/// The contact of one triangle of a surface and a shape, seen from the triangle.
template <Scalar S>
struct MeshContact {
  Contact<S, 3> contact;
  std::uint32_t triangle = 0;

  [[nodiscard]] friend constexpr bool operator==(const MeshContact&,
                                                 const MeshContact&) noexcept = default;
};

namespace detail {

/// Which sides of a surface push, unless the caller says: terrain has its front above.
template <class Surface>
inline constexpr Facing usual_facing = Facing::both;
template <class Surface>
requires requires(const Surface& s) { s.heights; }
inline constexpr Facing usual_facing<Surface> = Facing::front;
template <class Surface>
requires requires(const Surface& s) { s.asset->field(); }
inline constexpr Facing usual_facing<Surface> = Facing::front;

/// How deep a shape is behind the plane of a triangle; `normal` is perpendicular to it.
template <Scalar S, class Normal>
struct FacePush {
  Normal normal;
  Depth<S> depth;
};

/// The contacts of one shape with the triangles of a surface.
///
/// Let n be the rounded normal of `contact` of a triangle T and the shape. A point is higher than
/// another if it is so along every vector that rounds to n. Another triangle U rises at T if U has
/// all corners of T than which no other is higher, and one that is higher than these. A collapsed
/// triangle does not rise, and of its own corners only the two ends count.
///
/// n is valid if n is the front of T or, with two sides, its back, or if nothing rises at T: the
/// surface ends there, and the shape leaves it over an edge or a corner. With Facing::front, n must
/// also point to the front of T. If n is valid, T has that contact. A collapsed T has it, too, unless
/// the shape touches a triangle that rises at T.
///
/// Otherwise the shape leaves T along T's own normal, out of its plane: to the front or, with two
/// sides, to the nearer one, to the front if both are equally near. T defers, and has no contact,
/// if the shape touches a triangle U that rises at T and whose contact has a valid normal or whose
/// plane is nearer: the translation out of it has a lesser depth, rounded up. Of equally near ones
/// the first counts, so one of the triangles that defer to each other remains.
template <class Surface, class Shape, Scalar S>
class SurfaceContacts {
 public:
  constexpr SurfaceContacts(const Surface& surface, const Shape& shape, Facing facing) noexcept
      : surface_(surface), shape_(shape), facing_(facing) {}

  template <class Found>
  constexpr void visit(const Found& found) const noexcept {
    visit_near(bounding_box(shape_), [&](const MeshTriangle<S>& part) {
      const auto free = contact(part.triangle, shape_);
      if (!free) return;
      if (const auto here = contact_with(part, *free)) found(MeshContact<S>{*here, part.index});
    });
  }

 private:
  template <class Visit>
  constexpr void visit_near(const Aabb<S, 3>& box, const Visit& visit) const noexcept {
    visit_within(surface_, box, [&](std::span<const MeshTriangle<S>> parts) {
      for (const auto& part : parts) visit(part);
      return Walk::go_on;
    });
  }

  /// The contact of a triangle, whose least translation is `free`.
  [[nodiscard]] constexpr std::optional<Contact<S, 3>> contact_with(
      const MeshTriangle<S>& part, const Contact<S, 3>& free) const noexcept {
    const auto& triangle = part.triangle;
    bool gives_way = false;
    if (is_zero(normal_of(triangle))) {
      visit_risers(part, free.normal, [&](const MeshTriangle<S>& other) {
        gives_way = gives_way || contact(other.triangle, shape_).has_value();
      });
      return gives_way ? std::nullopt : std::optional(free);
    }
    if (is_right(part, free.normal)) return free;
    const auto face = face_push(triangle);
    visit_risers(part, free.normal, [&](const MeshTriangle<S>& other) {
      if (gives_way) return;
      const auto others = contact(other.triangle, shape_);
      if (!others) return;
      const auto depth = face_push(other.triangle).depth;
      gives_way = is_right(other, others->normal) || depth < face.depth ||
                  (depth == face.depth && other.index < part.index);
    });
    if (gives_way) return std::nullopt;
    return along_face(triangle, face);
  }

  /// Whether a contact with this normal is that of the triangle's face, or of an edge or a corner
  /// where no triangle rises.
  [[nodiscard]] constexpr bool is_right(const MeshTriangle<S>& part,
                                        const Direction<S, 3>& normal) const noexcept {
    const auto across = normal_of(part.triangle);
    const auto front = unit_of<S>(across);
    if (normal == front) return true;
    if (facing_ == Facing::both && normal == -front) return true;
    if (facing_ == Facing::front && dot(normal, across) <= 0) return false;
    bool rises = false;
    visit_risers(part, normal, [&](const MeshTriangle<S>&) { rises = true; });
    return !rises;
  }

  /// Visits the other triangles that rise at the edge or corner of `part` that is highest along
  /// `normal`.
  template <class Visit>
  constexpr void visit_risers(const MeshTriangle<S>& part, const Direction<S, 3>& normal,
                              const Visit& visit) const noexcept {
    const auto top = highest_corners(part.triangle, normal);
    visit_near(bounding_box(part.triangle), [&](const MeshTriangle<S>& other) {
      if (other == part || is_zero(normal_of(other.triangle))) return;
      if (rises_at(top, normal, other.triangle)) visit(other);
    });
  }

  [[nodiscard]] static constexpr auto normal_of(const Triangle<S, 3>& triangle) noexcept {
    return cross(triangle.b - triangle.a, triangle.c - triangle.a);
  }

  /// Whether p is higher than q along every vector that rounds to `normal`.
  [[nodiscard]] static constexpr bool is_higher(const Direction<S, 3>& normal, const Vec<S, 3>& p,
                                                const Vec<S, 3>& q) noexcept {
    const auto d = p - q;
    return dot(normal, d) > (abs(d.x) + abs(d.y) + abs(d.z)) * rounding_of_normal();
  }
  /// Of each of its components.
  [[nodiscard]] static constexpr auto rounding_of_normal() noexcept {
    if constexpr (is_fixed<S>) {
      return Fixed<1, direction_component<S>::frac + 1>::from_raw(1);
    } else {
      return S(1) / 4096;
    }
  }

  struct HighestCorners {
    std::array<Vec<S, 3>, 3> corners{};
    std::size_t count = 0;
  };
  /// The corners of a triangle than which no other is higher along `normal`, without one between two
  /// others.
  [[nodiscard]] static constexpr HighestCorners highest_corners(
      const Triangle<S, 3>& triangle, const Direction<S, 3>& normal) noexcept {
    const std::array corners{triangle.a, triangle.b, triangle.c};
    const bool is_collapsed = is_zero(normal_of(triangle));
    HighestCorners top;
    for (std::size_t i = 0; i < 3; ++i) {
      const auto& corner = corners[i];
      const auto& next = corners[(i + 1) % 3];
      const auto& last = corners[(i + 2) % 3];
      if (is_higher(normal, next, corner) || is_higher(normal, last, corner)) continue;
      if (is_collapsed && dot(next - corner, last - corner) < 0) continue;
      top.corners[top.count++] = corner;
    }
    return top;
  }
  /// Whether a triangle has all these corners, and one that is higher along `normal`.
  [[nodiscard]] static constexpr bool rises_at(const HighestCorners& top,
                                               const Direction<S, 3>& normal,
                                               const Triangle<S, 3>& other) noexcept {
    const std::array others{other.a, other.b, other.c};
    const std::span highest(top.corners.data(), top.count);
    return std::all_of(highest.begin(), highest.end(),
                       [&](const auto& corner) {
                         return std::find(others.begin(), others.end(), corner) != others.end();
                       }) &&
           std::any_of(others.begin(), others.end(), [&](const auto& p) {
             return std::all_of(highest.begin(), highest.end(),
                                [&](const auto& corner) { return is_higher(normal, p, corner); });
           });
  }

  /// The translation that pushes the shape out of the plane of a triangle: to the front or, if it
  /// has two sides, to the nearer one.
  [[nodiscard]] constexpr auto face_push(const Triangle<S, 3>& triangle) const noexcept {
    auto normal = normal_of(triangle);
    const auto corners = corners_of(core_of(shape_));
    const auto body = body_of_corners(corners);
    constexpr int bits = bits_of<decltype(body.some().x)> + 1;
    const auto height_along = [&](const auto& v) {
      return dot(v, triangle.a - body.template extreme<bits>(v, body.some(), false));
    };
    auto height = height_along(normal);
    if (facing_ == Facing::both) {
      const auto back = narrow_negative(normal);
      const auto behind = height_along(back);
      if (behind < height) {
        normal = back;
        height = behind;
      }
    }
    const auto squared = squared_length(normal);
    const auto radius = radius_of(shape_);
    const auto root = Fraction{square(height), squared};
    const Depth<S> depth = height < 0 ? Depth<S>(radius - sqrt_floor<Length<S>>(root))
                                      : Depth<S>(radius + sqrt_ceil<Length<S>>(root));
    return FacePush<S, decltype(normal)>{normal, depth};
  }

  template <class Push>
  [[nodiscard]] constexpr std::optional<Contact<S, 3>> along_face(const Triangle<S, 3>& triangle,
                                                                  const Push& push) const noexcept {
    const auto& core = core_of(shape_);
    const auto corners = corners_of(core);
    const auto body = body_of_corners(corners);
    const auto face = corners_of(triangle);
    const auto face_body = body_of_corners(face);
    const auto normal = unit_of<S>(push.normal);
    constexpr auto most = most_corners_of<std::remove_cvref_t<decltype(body)>,
                                          std::remove_cvref_t<decltype(face_body)>>;
    return make_contact<most>(normal, push.depth, S(0), radius_of(shape_), [&](auto& manifold) {
      const auto deepest = extreme_feature<S, most>(body, body, push.normal, false);
      manifold.meet(
          extreme_feature<S, most>(face_body, face_body, push.normal, true), deepest,
          [](const auto& feature) { return feature; },
          [&](const auto& feature) { return opposed_feature(core, body, feature, normal); });
    });
  }

  const Surface& surface_;
  const Shape& shape_;
  Facing facing_;
};

/// Inserts a contact into the first `count` of `out`, sorted by triangle; contacts beyond `out` are
/// dropped.
template <Scalar S>
constexpr void insert_contact(std::span<MeshContact<S>> out, std::size_t count,
                              const MeshContact<S>& contact) noexcept {
  std::size_t i = count < out.size() ? count : out.size();
  if (i == out.size()) {
    if (i == 0 || !(contact.triangle < out[i - 1].triangle)) return;
    --i;
  }
  for (; i > 0 && contact.triangle < out[i - 1].triangle; --i) out[i] = out[i - 1];
  out[i] = contact;
}

}  // namespace detail

/// The contacts of a shape (sphere, AABB, OBB, triangle, capsule, convex hull) with the triangles
/// of `surface`, at most one per triangle. Returns their number. Writes those of the least indices,
/// as many as `out` holds, sorted.
///
/// There are no bumps at inner edges: a normal is that of the triangle, unless the shape touches an
/// edge or a corner at which no other triangle rises. So a shape that slides over a tessellated
/// plane only meets the plane's normal, and in a valley only those of both sides. Triangles share
/// an edge if its corners have equal coordinates. The rule is that of `detail::SurfaceContacts`.
///
/// With Facing::both, a triangle may push to either side. A shape that is deep in the surface may be
/// pushed out at the back.
///
/// With Facing::front, every normal points to the front of its triangle, so a shape partly behind
/// it is pushed out in front. Height fields always have this facing, with the front above. A shape
/// that touches no triangle has no contact, on either side.
///
/// exact:  each contact as for `contact` of the triangle and the shape, or along the triangle's normal,
///         with points in its plane that may be beyond its edges; which triangles have one is decided
///         exactly for the rounded normals, so one at an inner edge may lean from the triangle's by
///         their rounding times length over width of the triangle
///                                                           (tests/scene/inner_edges.test.cpp)
template <template <class> class Surface, Scalar S, MeetsTriangles<S> Shape>
requires is_surface<Surface> && detail::HaveContact<Triangle<S, 3>, Shape>
constexpr std::size_t contacts(const Surface<S>& surface, const Shape& shape,
                               std::span<std::type_identity_t<MeshContact<S>>> out,
                               Facing facing) noexcept {
  std::size_t count = 0;
  if (!detail::has_points(shape)) return count;
  detail::SurfaceContacts<Surface<S>, Shape, S>(surface, shape, facing)
      .visit([&](const MeshContact<S>& contact) { detail::insert_contact(out, count++, contact); });
  return count;
}
template <template <class> class Surface, Scalar S, MeetsTriangles<S> Shape>
requires is_surface<Surface> && detail::HaveContact<Triangle<S, 3>, Shape>
constexpr std::size_t contacts(const Surface<S>& surface, const Shape& shape,
                               std::span<std::type_identity_t<MeshContact<S>>> out) noexcept {
  return contacts(surface, shape, out, detail::usual_facing<Surface<S>>);
}

}  // namespace detent
