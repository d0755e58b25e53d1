// SPDX-License-Identifier: MIT
//
// Frusta of eight points or of a camera: overlaps, intersects, contains and the raycasts give the
// exact result, and `project` puts a point inside the image where the camera sees it.

#include "detent/query/contains/frustum.hpp"
#include "decode.hpp"
#include "detent/query/intersects/frustum.hpp"
#include "detent/query/overlaps/frustum.hpp"
#include "detent/query/raycast/frustum.hpp"
#include "detent/shape/camera.hpp"
#include "oracle/describe.hpp"
#include "oracle/hull.hpp"
#include "oracle/view.hpp"
#include "ray_truth.hpp"
#include "spaces.hpp"

namespace detent::fuzz {
namespace {

template <class Shape, Scalar S>
void check_pair(const Shape& shape, const Frustum<S>& frustum) {
  const auto hull = frustum.hull();
  const auto because = [&] { return oracle::describe(shape) + "; " + oracle::describe(hull); };
  const bool truth = oracle::meet(shape, hull);
  if constexpr (requires { overlaps(shape, frustum); }) {
    require(overlaps(shape, frustum) == truth && overlaps(frustum, shape) == truth, because);
  } else {
    require(intersects(shape, frustum) == truth, because);
  }
}

template <Scalar S>
void check_view(const Camera<S>& camera, const Vec<S, 3>& point) {
  const auto seen = project(camera, point);
  if (!seen) return;
  const auto& lens = camera.lens;
  const auto leaves = [](const S& x, const S& low, const S& high) { return x < low || x > high; };
  const auto enters = [](const S& x, const S& low, const S& high) { return x > low && x < high; };
  const S one(1), minus_one(-1);
  const bool is_outside = leaves(seen->x, minus_one, one) || leaves(seen->y, minus_one, one) ||
                          leaves(seen->depth, lens.near_distance(), lens.far_distance());
  const bool is_inside = enters(seen->x, minus_one, one) && enters(seen->y, minus_one, one) &&
                         enters(seen->depth, lens.near_distance(), lens.far_distance());
  if (!is_outside && !is_inside) return;  // rounded onto the border
  const bool truth = oracle::meet(oracle::polytope(camera), oracle::polytope(Aabb{point, point}));
  require(truth == is_inside, [&] { return "seen or not: " + oracle::describe(point); });
}

template <Scalar S>
void check(Source& source, Decoder<S, 3>& decoder) {
  typename Frustum<S>::Corners corners;
  for (auto& corner : corners) corner = decoder.point();
  Frustum<S> frustum{corners};
  const auto kind = source.below(4);
  if (kind != 0) {
    const auto a = decoder.reach(), b = decoder.reach(), c = decoder.reach(), d = decoder.reach();
    const auto fov = Angle<S>::from_raw(static_cast<std::uint32_t>(source.bits(30)) & 0x7fffffffu);
    const auto lens = kind == 1 ? Lens<S>::orthographic(a, b, c, d)
                                : Lens<S>::perspective(fov, kind == 2 ? S(1) : a, c, d);
    if (lens) {
      const Camera<S> camera{Transform<S, 3>{decoder.point(), decoder.rotation(), S(1)}, *lens};
      frustum = Frustum{camera};
      check_view(camera, decoder.point());
    }
  }
  check_pair(decoder.template shape<Sphere<S, 3>>(), frustum);
  check_pair(decoder.template shape<Aabb<S, 3>>(), frustum);
  check_pair(decoder.template shape<Obb<S, 3>>(), frustum);
  check_pair(decoder.template shape<Plane<S, 3>>(), frustum);
  check_pair(decoder.template shape<Triangle<S, 3>>(), frustum);
  check_pair(decoder.template shape<Segment<S, 3>>(), frustum);
  check_pair(decoder.template shape<ConvexHull<S, 3>>(), frustum);
  const auto point = decoder.point();
  const auto hull = frustum.hull();
  require(contains(frustum, point) == oracle::meet(hull, point),
          [&] { return oracle::describe(point) + "; " + oracle::describe(hull); });
  check_ray(decoder.template shape<Ray<S, 3>>(), frustum, hull);
}

}  // namespace

void property(Bytes input) {
  Source source(input);
  in_a_space(source, [&]<Scalar S, int N>(Space<S, N>) {
    Decoder<S, 3> decoder(source);
    check(source, decoder);
  });
}

}  // namespace detent::fuzz
