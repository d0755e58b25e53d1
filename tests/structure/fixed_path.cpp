// SPDX-License-Identifier: MIT
//
// Uses everything that a fixed-point build needs. fixed_path.sh compiles it without floating-point
// registers, standard library, exceptions or type information: queries of shapes (DETENT_PART=1),
// and the layers above (2).

#include <tuple>

#include "detent/detent.hpp"
#include "support/shapes.hpp"

namespace detent {

/// One of each shape that scenes hold.
template <Scalar S, int N>
using Shapes = typename support::SceneShapes<S, N>::template in<std::tuple>;

template <Scalar S, int N>
struct Answers {
  std::optional<S> distance;
  std::optional<RayHit<S, N>> hit;
  std::optional<Interval<S>> interval;
};

template <Scalar S, int N, class Shape>
void cast(const Ray<S, N>& ray, const Shape& shape, Answers<S, N>& answers) noexcept {
  answers = {raycast(ray, shape), raycast_hit(ray, shape), raycast_interval(ray, shape)};
}

template <Scalar S, int N>
void cast_at_all(const Ray<S, N>& ray, const Shapes<S, N>& shapes, const Segment<S, N>& segment,
                 Answers<S, N>* answers) noexcept {
  cast(ray, segment, *answers);
  std::apply([&](const auto&... shape) { (cast(ray, shape, *++answers), ...); }, shapes);
}

template <Scalar S, int N>
struct Measures {
  bool is_inside;
  bool is_near;
  Vec<S, N> closest;
  S distance;
};

template <Scalar S, int N, class Shape>
Measures<S, N> measure(const Shape& shape, const Vec<S, N>& point) noexcept {
  return {contains(shape, point), on(shape, point, point.x), closest_point(shape, point),
          distance(shape, point)};
}

template <Scalar S, int N>
void measure_all(const Vec<S, N>& point, const Shapes<S, N>& shapes, const Segment<S, N>& segment,
                 const Ray<S, N>& ray, Measures<S, N>* measures,
                 Vec<direction_component<S>, 3>& weights) noexcept {
  measures[0] = measure(segment, point);
  measures[1] = measure(ray, point);
  measures[2].distance = distance(point, segment.start);
  measures += 2;
  std::apply([&](const auto&... shape) { ((*++measures = measure(shape, point)), ...); }, shapes);
  if (const auto exact = barycentric(std::get<Triangle<S, N>>(shapes), point)) {
    weights = nearest_to<direction_component<S>>(*exact);
  }
}

/// Overlaps of the first shape with itself and the others, and so on.
template <class Shape, class... Shapes>
int count_overlaps(const Shape& shape, const Shapes&... shapes) noexcept {
  int count = (overlaps(shape, shape) + ... + overlaps(shape, shapes));
  if constexpr (sizeof...(Shapes) > 0) count += count_overlaps(shapes...);
  return count;
}

template <Scalar S, int N>
int meet_all(const Shapes<S, N>& shapes, const Segment<S, N>& segment) noexcept {
  return std::apply(
      [&](const auto&... shape) {
        return count_overlaps(shape...) +
               (intersects(segment, segment) + ... + intersects(segment, shape));
      },
      shapes);
}

template <Scalar S>
void turn(Angle<S> angle, const Direction<S, 3>& axis, S x, S y, S z, S w, Rotation<S, 2>& flat,
          Rotation<S, 3>* rotations, S* numbers) noexcept {
  flat = Rotation<S, 2>::from_angle(angle);
  rotations[0] = Rotation<S, 3>::from_axis_angle(axis, angle);
  rotations[1] = Rotation<S, 3>::from_quaternion(x, y, z, w).value_or(Rotation<S, 3>());
  rotations[2] = Rotation<S, 3>::from_euler(angle, -angle, angle + angle);
  rotations[3] = Rotation<S, 3>::from_axes({axis, -axis, axis});
  numbers[0] = sin(angle);
  numbers[1] = cos(angle);
  numbers[2] = atan2(y, x).degrees();
  numbers[3] = Angle<S>::from_radians(x).radians();
}

template <Scalar S>
struct Motions {
  Quat<S> turns[6];
  Transform<S, 3> frames[4];
  Mat<S, 4, 4> matrices[4];
  Vec<S, 3> vectors[8];
  Angle<S> angles[2];
};

template <Scalar S>
void move(const Vec<S, 3>& u, const Vec<S, 3>& v, Angle<S> angle, S t, const Quat<S>& p,
          const Transform<S, 3>& frame, Motions<S>& motions) noexcept {
  auto& [turns, frames, matrices, vectors, angles] = motions;
  const auto q = Quat<S>::normalize(u.x, u.y, u.z, t).value_or(p);
  turns[0] = Quat<S>::from_euler(angle, -angle, angle + angle);
  turns[1] = Quat<S>::from_axis_angle(frame.rotation.axis(0), angle);
  turns[2] = Quat<S>::from_rotation(frame.rotation);
  turns[3] = compose(p, q);
  turns[4] = nlerp(p, q, t);
  turns[5] = slerp(p, q, t);
  frames[0] = compose(frame, inverse(frame).value_or(frame));
  frames[1].rotation = orthogonalize(to_rotation(q)).value_or(frame.rotation);
  frames[2] = decompose(matrices[3]).value_or(frame);
  frames[3] = look_at(u, v, frame.translation).value_or(frame);
  matrices[0] = nearest_to<S>(to_mat(frame) * view_matrix(frame));
  matrices[1] = inverse(matrices[3]).value_or(matrices[3]);
  matrices[2] = perspective(angle, u.x, u.y, u.z).value_or(identity<S, 4>());
  vectors[0] = project_point(matrices[2], u).value_or(v);
  vectors[1] = transform_point(frame, u);
  vectors[2] = inverse_transform_point(frame, u);
  vectors[3] = rotate(q, u);
  vectors[4] = project(u, v);
  vectors[5] = reject(u, v);
  vectors[6] = reflect(u, frame.rotation.axis(1));
  vectors[7] = lerp(u, v, t);
  angles[0] = angle_between(u, v);
  angles[1] = angle_of(q);
}

/// Cameras, and frusta as shapes.
template <Scalar S>
int look(const OrbitCamera<S>& orbit, Angle<S> fov, S aspect, const Vec<S, 3>& point,
         const Obb<S, 3>& box, Measures<S, 3>& measures, Ray<S, 3>* rays) noexcept {
  auto moving = orbit;
  moving.rotate(fov, fov);
  moving.zoom(aspect);
  moving.pan(aspect, aspect);
  moving.lens = Lens<S>::perspective(fov, aspect, S(1), point.x).value_or(orbit.lens);
  const auto camera = moving.camera();
  const Viewport screen{640, 480};
  const auto seen = project(camera, screen, point);
  rays[0] = pick_ray(camera, aspect, aspect);
  rays[1] = pick_ray(camera, screen, 1, 2);
  const Frustum frustum{camera};
  measures = measure(frustum, unproject(camera, screen, 1, 2, point.x));
  return project(camera, point).has_value() + seen.has_value() + overlaps(frustum, box) +
         raycast(rays[0], frustum).has_value();
}

#define DETENT_LOOK(S)                                                                      \
  template int look(const OrbitCamera<S>&, Angle<S>, S, const Vec<S, 3>&, const Obb<S, 3>&, \
                    Measures<S, 3>&, Ray<S, 3>*) noexcept
#define DETENT_MEASURE(S, N)                                                             \
  template void measure_all(const Vec<S, N>&, const Shapes<S, N>&, const Segment<S, N>&, \
                            const Ray<S, N>&, Measures<S, N>*,                           \
                            Vec<direction_component<S>, 3>&) noexcept
#define DETENT_MEET(S, N) template int meet_all(const Shapes<S, N>&, const Segment<S, N>&) noexcept
#define DETENT_MOVE(S)                                                                \
  template void move(const Vec<S, 3>&, const Vec<S, 3>&, Angle<S>, S, const Quat<S>&, \
                     const Transform<S, 3>&, Motions<S>&) noexcept
#define DETENT_CAST(S, N)                                                                \
  template void cast_at_all(const Ray<S, N>&, const Shapes<S, N>&, const Segment<S, N>&, \
                            Answers<S, N>*) noexcept
#define DETENT_USE(S)                                                               \
  DETENT_CAST(S, 2);                                                                \
  DETENT_CAST(S, 3);                                                                \
  template void turn(Angle<S>, const Direction<S, 3>&, S, S, S, S, Rotation<S, 2>&, \
                     Rotation<S, 3>*, S*) noexcept;                                 \
  template std::optional<Direction<S, 2>> normalize(const Vec<S, 2>&) noexcept;     \
  template std::optional<Direction<S, 3>> normalize(const Vec<S, 3>&) noexcept

#if DETENT_PART == 1
DETENT_USE(q16_16);
DETENT_MOVE(q16_16);
DETENT_LOOK(q16_16);
DETENT_MEASURE(q16_16, 2);
DETENT_MEASURE(q16_16, 3);
DETENT_MEET(q16_16, 3);
DETENT_USE(q14_16);
DETENT_MEASURE(q14_16, 2);
DETENT_MEASURE(q14_16, 3);
DETENT_USE(q24_8);
DETENT_MEASURE(q24_8, 2);
DETENT_MEASURE(q24_8, 3);
DETENT_USE(q8_8);
DETENT_MOVE(q8_8);
DETENT_LOOK(q8_8);
DETENT_MEASURE(q8_8, 2);
DETENT_MEASURE(q8_8, 3);
DETENT_MEET(q8_8, 2);
#endif

#if DETENT_PART == 2
// A mesh that owns its storage, and terrain.
template <Scalar S>
struct Surfaces {
  std::array<MeshTriangle<S>, 40> triangles;
  std::array<MeshNode<S>, tree_capacity(40)> nodes;
  std::array<MeshHit<S>, 8> hits;
  HeightField<S> field;

  [[nodiscard]] bool ask(const Ray<S, 3>& ray, const Sphere<S, 3>& sphere) noexcept {
    const auto mesh = build_mesh<S>(triangles, nodes);
    if (!mesh) return false;
    const auto ask_one = [&](const auto& surface) {
      return raycast_all(ray, surface, std::span<MeshHit<S>>(hits)) != 0 ||
             raycast_hit(ray, surface).has_value() || overlaps(surface, sphere) ||
             nearest_triangle(surface, ray.origin).has_value();
    };
    return ask_one(*mesh) || ask_one(field);
  }
};
template struct Surfaces<q16_16>;

// A scene for a sync test, and a ray hit in it.
using Arena = BoundedScene<Bounded<8, 2>, q16_16, 3, Sphere>;
std::size_t play(SyncTest<Arena, q16_16, 4>& test, Arena& arena, q16_16 push,
                 const Ray<q16_16, 3>& ray, std::span<ObjectHit<q16_16, 3>> hits) noexcept {
  const auto desync = test.step(arena, push, [](Arena& scene, q16_16 by) {
    scene.move({0, 1}, {by, by, by});
    scene.add(Sphere<q16_16, 3>{}).value_or(no_object);
  });
  return desync ? desync->field.size() : arena.all_hits(ray, hits);
}

// A character in a scene.
bool stroll(const Arena& arena, Mover<q16_16, 3, Sphere>& player,
            const Vec<q16_16, 3>& by) noexcept {
  return clip_velocity(by, player.move(arena, by, {}, InLayers{1})) == by;
}

// Draws everything to a sink that counts.
struct Paper {
  std::size_t marks = 0;
  template <int N>
  void line(const Vec<q16_16, N>&, const Vec<q16_16, N>&, const Colour&) noexcept {
    ++marks;
  }
  void triangle(const Vec<q16_16, 3>&, const Vec<q16_16, 3>&, const Vec<q16_16, 3>&,
                const Colour&) noexcept {
    ++marks;
  }
};
std::size_t sketch(const Arena& arena, const ConvexHull<q16_16, 3>& hull,
                   const Capsule<q16_16, 3>& capsule, const Capsule<q16_16, 2>& flat,
                   const HeightField<q16_16>& field, const Contact<q16_16, 3>& touch) {
  Paper paper;
  draw(paper, arena);
  draw_tree(paper, arena);
  draw(paper, hull, Colour());
  draw_solid(paper, hull, Colour());
  draw_solid(paper, capsule, Colour());
  draw_sweep(paper, capsule, touch.normal, touch.depth, Colour());
  draw(paper, flat, Colour());
  draw(paper, field, Colour());
  draw_tree(paper, field);
  draw(paper, touch, Colour(), touch.depth);
  return paper.marks;
}

// Casts of moving shapes, against one shape and in the scene.
std::size_t sweep_all(const Arena& arena, const Sphere<q16_16, 3>& sphere,
                      const Aabb<q16_16, 3>& aabb, const Obb<q16_16, 3>& box,
                      const Capsule<q16_16, 3>& capsule, const Triangle<q16_16, 3>& triangle,
                      const Plane<q16_16, 3>& plane, const HeightField<q16_16>& field,
                      const Direction<q16_16, 3>& ahead, q16_16 distance,
                      std::span<ObjectHit<q16_16, 3>> hits) noexcept {
  return (cast(sphere, ahead, distance, triangle) ? 1u : 0u) +
         (cast(capsule, ahead, distance, box) ? 1u : 0u) +
         (cast(aabb, ahead, distance, triangle) ? 1u : 0u) +
         (cast(box, ahead, distance, plane) ? 1u : 0u) +
         (cast(sphere, ahead, distance, field) ? 1u : 0u) +
         arena.all_hits(Cast{sphere, ahead, distance}, hits);
}
bool sweep_flat(const Sphere<q8_8, 2>& sphere, const Aabb<q8_8, 2>& box,
                const Direction<q8_8, 2>& ahead, q8_8 distance) noexcept {
  return cast(sphere, ahead, distance, box) || cast(box, ahead, distance, box);
}

// Times of impact of moving bodies, and the events of a scene.
std::size_t collide(const Capsule<q16_16, 3>& capsule, const Obb<q16_16, 3>& box,
                    const ConvexHull<q16_16, 3>& hull, const Plane<q16_16, 3>& plane,
                    const Sweep<q16_16, 3>& sweep, const Obb<q8_8, 2>& flat_box,
                    const Sweep<q8_8, 2>& flat, BoundedOverlapEvents<8>& events,
                    std::span<const Overlap> pairs, Transform<q16_16, 3>& pose) noexcept {
  const auto impact = time_of_impact(capsule, sweep, box, sweep);
  if (impact) pose = transform_at(sweep, impact->time);
  const bool fits = events.update(pairs);
  return events.began().size() + (time_of_impact(box, sweep, hull, sweep) ? 1u : 0u) +
         (time_of_impact(hull, sweep, plane) ? 1u : 0u) +
         (time_of_impact(flat_box, flat, flat_box, flat) ? 1u : 0u) + (fits ? 1u : 0u);
}
#endif

}  // namespace detent
