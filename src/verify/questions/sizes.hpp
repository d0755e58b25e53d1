// SPDX-License-Identifier: MIT
#pragma once

#include "detent/query/intersection.hpp"
#include "detent/shape/bounding_sphere.hpp"
#include "detent/shape/measure.hpp"
#include "verify/draw/shapes.hpp"
#include "verify/questions/cases.hpp"
#include "verify/questions/motions.hpp"

// Intersections of planes, sizes of shapes, and bounding shapes.

namespace detent::verify {

template <Scalar S, int N>
struct CrossingCase {
  std::array<Plane<S, N>, N> planes;
};
template <class D, Scalar S, int N>
constexpr void append(D& digest, const CrossingCase<S, N>& c) noexcept {
  for (const auto& plane : c.planes) digest.add(plane);
}

struct Crossings : InDimensions<2, 3> {
  static constexpr std::array<std::string_view, 1> names{"intersection/plane"};
  template <Scalar S, int N>
  static constexpr auto draw(Random& random) noexcept {
    Numbers<S> numbers(random);
    CrossingCase<S, N> c;
    for (auto& plane : c.planes) {
      plane.normal = numbers.direction(numbers.template any_direction<N>());
      plane.offset = numbers.any();
    }
    if (random.one_in(8)) c.planes[1].normal = c.planes[0].normal;
    return c;
  }
  template <int Row, Scalar S, int N>
  [[nodiscard]] static constexpr auto answer(const CrossingCase<S, N>& c) noexcept {
    if constexpr (N == 2) {
      return intersection(c.planes[0], c.planes[1]);
    } else {
      return intersection(c.planes[0], c.planes[1], c.planes[2]);
    }
  }
};

template <Scalar S, int N>
struct SizeCase {
  Triangle<S, N> triangle;
  Aabb<S, N> aabb;
  Sphere<S, N> sphere;
  Obb<S, N> obb;

  static constexpr std::array<std::string_view, 4> field_names{"", "", "", ""};
  constexpr auto fields(const auto& f) const noexcept { return f(triangle, aabb, sphere, obb); }
};

/// Areas, and volumes of shapes that have one, rounded down to the grid of the scalar.
struct Sizes : InDimensions<2, 3> {
  static constexpr std::array<std::string_view, 6> names{
      "measure/triangle", "measure/aabb",        "measure/sphere",
      "bounding_box/obb", "bounding_sphere/obb", "bounding_sphere/triangle"};
  template <Scalar S, int N>
  static constexpr auto draw(Random& random) noexcept {
    ShapeScene<S, N> scene(random);
    const auto triangle = scene.triangle();
    const auto aabb = scene.aabb();
    const auto sphere = scene.sphere();
    return SizeCase<S, N>{triangle, aabb, sphere, scene.obb()};
  }
  template <int Row, Scalar S, int N>
  [[nodiscard]] static constexpr auto answer(const SizeCase<S, N>& c) noexcept {
    if constexpr (Row == 0) {
      return floor_to<typename long_of<S>::type>(area(c.triangle));
    } else if constexpr (Row < 3) {
      const auto& shape = [&]() -> const auto& {
        if constexpr (Row == 1) {
          return c.aabb;
        } else {
          return c.sphere;
        }
      }
      ();
      if constexpr (N == 2) {
        return floor_to<typename long_of<S>::type>(area(shape));
      } else {
        return floor_to<typename long_of<S>::type>(volume(shape));
      }
    } else if constexpr (Row == 3) {
      return bounding_box(c.obb);
    } else if constexpr (Row == 4) {
      return bounding_sphere(c.obb);
    } else {
      return bounding_sphere(c.triangle);
    }
  }
};

}  // namespace detent::verify
