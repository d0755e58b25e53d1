// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <type_traits>

#include "detent/query/cast.hpp"
#include "detent/query/closest_points.hpp"
#include "detent/query/contact.hpp"
#include "detent/query/distance.hpp"
#include "verify/draw/compounds.hpp"
#include "verify/questions/casts.hpp"
#include "verify/questions/kinds.hpp"
#include "verify/questions/meshes.hpp"

// One shape against a target of several parts: a mesh, a height field or a compound. The results
// are those of the part that is nearest or touched first.

namespace detent::verify {

/// Calls ask(target) with the library's view of a drawn target.
template <Scalar S, class Ask>
[[nodiscard]] constexpr auto with_target(const MeshTriangles<S>& mesh, const Ask& ask) noexcept {
  const BuiltMesh<S> built(mesh);
  return ask(built.view());
}
template <Scalar S, class Ask>
[[nodiscard]] constexpr auto with_target(const FieldSamples<S>& field, const Ask& ask) noexcept {
  return ask(view_of(field));
}
template <Scalar S, int N, class Ask>
[[nodiscard]] constexpr auto with_target(const CompoundParts<S, N>& parts,
                                         const Ask& ask) noexcept {
  return ask(Compound{std::span(parts.spheres).first(parts.sphere_count),
                      std::span(parts.triangles).first(parts.triangle_count)});
}

/// Each kind draws a target and leaves the stage at a spot on it or near it.
struct SurfaceKind : InDimensions<3> {
  template <Scalar S, int N>
  using Stage = SurfaceScene<S>;

 protected:
  template <Scalar S, class Surface>
  static constexpr Surface aimed(SurfaceScene<S>& scene, const Surface& surface) noexcept {
    scene.aim_at(surface);
    return surface;
  }
};
struct MeshKind : SurfaceKind {
  static constexpr std::string_view name = "mesh";
  template <Scalar S>
  static constexpr auto draw(SurfaceScene<S>& scene) noexcept {
    return aimed(scene, scene.mesh());
  }
};
struct FieldKind : SurfaceKind {
  static constexpr std::string_view name = "height_field";
  template <Scalar S>
  static constexpr auto draw(SurfaceScene<S>& scene) noexcept {
    return aimed(scene, scene.field());
  }
};
struct CompoundKind : InDimensions<2, 3> {
  static constexpr std::string_view name = "compound";
  template <Scalar S, int N>
  using Stage = ShapeScene<S, N>;
  template <Scalar S, int N>
  static constexpr auto draw(ShapeScene<S, N>& scene) noexcept {
    return compound_parts(scene);
  }
};

/// Groups of targets run one question in forty.
template <class Kind>
struct TargetGroup : Kind {
  static constexpr std::uint32_t share = 40;
};

template <Scalar S, int N, class Target, class Shape>
struct TargetCase {
  Target target;
  Shape shape;

  static constexpr std::array<std::string_view, 2> field_names{"", ""};
  constexpr auto fields(const auto& f) const noexcept { return f(target, shape); }
};

/// The distance of a sphere, and the closest points.
template <class Kind>
struct TargetDistances : TargetGroup<Kind> {
  static constexpr RowName distance_name{Kind::name, "/distance"};
  static constexpr RowName points_name{Kind::name, "/closest_points"};
  static constexpr std::array<std::string_view, 2> names{distance_name.view(), points_name.view()};

  template <Scalar S, int N>
  static constexpr auto draw(Random& random) noexcept {
    typename Kind::template Stage<S, N> scene(random);
    const auto target = Kind::draw(scene);
    scene.turn();
    return TargetCase<S, N, std::remove_const_t<decltype(target)>, Sphere<S, N>>{target,
                                                                                 scene.sphere()};
  }
  template <int Row, class Case>
  [[nodiscard]] static constexpr auto answer(const Case& c) noexcept {
    return with_target(c.target, [&](const auto& target) {
      if constexpr (Row == 0) {
        return distance(target, c.shape);
      } else {
        const auto [a, b] = closest_points(target, c.shape);
        return std::array{a, b};
      }
    });
  }
};

/// The contacts of the first triangles, and the number of all contacts.
template <Scalar S>
struct MeshContacts : Listed<MeshContact<S>, 3> {
  using Listed<MeshContact<S>, 3>::Listed;
};
template <class D, Scalar S>
constexpr void append(D& digest, const MeshContacts<S>& list) noexcept {
  digest.add(list.count);
  for (const auto& item : list.kept()) digest.add(item.triangle, item.contact);
}

/// The contacts of a hull with the triangles of a surface.
template <class Kind>
struct TargetContacts : TargetGroup<Kind> {
  static constexpr RowName name{Kind::name, "/contacts"};
  static constexpr std::array<std::string_view, 1> names{name.view()};

  template <Scalar S, int N>
  static constexpr auto draw(Random& random) noexcept {
    SurfaceScene<S> scene(random);
    const auto target = Kind::draw(scene);
    return TargetCase<S, N, std::remove_const_t<decltype(target)>, HullPoints<S, N>>{target,
                                                                                     scene.hull()};
  }
  template <int Row, Scalar S, int N, class Target>
  [[nodiscard]] static constexpr auto answer(
      const TargetCase<S, N, Target, HullPoints<S, N>>& c) noexcept {
    return with_target(c.target, [&](const auto& target) {
      return MeshContacts<S>([&](std::span<MeshContact<S>> room) {
        return contacts(target, as_shape(c.shape), room);
      });
    });
  }
};

template <Scalar S, int N, class Target, class Shape>
struct TargetCastCase {
  Target target;
  Shape shape;
  Direction<S, N> direction;
  S max_distance;

  static constexpr std::array<std::string_view, 4> field_names{"", "", "direction", "max_distance"};
  constexpr auto fields(const auto& f) const noexcept {
    return f(target, shape, direction, max_distance);
  }
};

/// A moving shape; rows of spheres do not name them.
template <class Target, class Moving = Kind<Sphere>>
struct TargetCasts : Target {
  static constexpr std::uint32_t share = 24;
  static constexpr RowName name = std::is_same_v<Moving, Kind<Sphere>>
                                      ? RowName(Target::name, "/cast")
                                      : RowName(Target::name, "/cast/", Moving::name);
  static constexpr std::array<std::string_view, 1> names{name.view()};

  template <Scalar S, int N>
  static constexpr auto draw(Random& random) noexcept {
    typename Target::template Stage<S, N> scene(random);
    const auto target = Target::draw(scene);
    scene.turn();
    const auto way = scene.retreat();
    const auto shape = Moving::draw(scene);
    return TargetCastCase<S, N, std::remove_const_t<decltype(target)>,
                          std::remove_const_t<decltype(shape)>>{target, shape, way.direction,
                                                                way.max_distance};
  }
  template <int Row, class Case>
  [[nodiscard]] static constexpr auto answer(const Case& c) noexcept {
    return with_target(c.target, [&](const auto& target) {
      return cast(as_shape(c.shape), c.direction, c.max_distance, target);
    });
  }
};

}  // namespace detent::verify
