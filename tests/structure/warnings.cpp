// SPDX-License-Identifier: MIT
//
// Typical game code. warnings.sh compiles it with the flags of a strict project.

#include <array>
#include <cstdio>
#include <span>
#include <vector>

#include "detent/detent.hpp"

using namespace detent;
using namespace detent::literals;

namespace {

template <class Shape, Scalar S, int N>
int ask(const Shape& shape, const Ray<S, N>& ray, const Vec<S, N>& point) {
  const auto hit = raycast_hit(ray, shape);
  const auto inside = raycast_interval(ray, shape);
  return (hit ? 1 : 0) + (inside && inside->exit > 1 ? 1 : 0) + (raycast(ray, shape) ? 1 : 0) +
         (contains(shape, point) ? 1 : 0) + (on(shape, point, S(1)) ? 1 : 0) +
         (closest_point(shape, point) == point ? 1 : 0) + (distance(shape, point) > 1 ? 1 : 0);
}

template <Scalar S, int N, class Shape, class... Shapes>
int meet(const Segment<S, N>& segment, const Shape& shape, const Shapes&... shapes) {
  int count =
      intersects(segment, shape) + overlaps(shape, shape) + (overlaps(shape, shapes) + ... + 0);
  if constexpr (sizeof...(Shapes) != 0) count += meet(segment, shapes...);
  return count;
}

template <Scalar S>
struct Numbers {
  Vec<S, 3> point;
  Direction<S, 3> forward;
  Angle<S> angle;

  [[nodiscard]] int queries() const {
    const auto turned = Rotation<S, 3>::from_axis_angle(forward, angle);
    const Ray<S, 3> ray{point, forward};
    const Sphere<S, 3> sphere{point, S(2)};
    const Aabb<S, 3> aabb{Vec<S, 3>{}, point};
    const Obb<S, 3> obb{point, point, turned};
    const Plane<S, 3> plane{forward, S(1)};
    const Triangle<S, 3> triangle{point, Vec<S, 3>{}, rotate(turned, point)};
    const Capsule<S, 3> capsule{point, triangle.c, S(1)};
    const std::array<Vec<S, 3>, 3> corners{triangle.a, triangle.b, triangle.c};
    const ConvexHull<S, 3> hull{corners};
    const Segment<S, 3> segment{point, triangle.c};
    return ask(sphere, ray, point) + ask(aabb, ray, point) + ask(obb, ray, point) +
           ask(plane, ray, point) + ask(triangle, ray, point) + ask(capsule, ray, point) +
           ask(hull, ray, point) + meet(segment, sphere, aabb, obb, plane, triangle, capsule, hull);
  }

  [[nodiscard]] int view() const {
    const auto lens = Lens<S>::perspective(angle, S(1), S(1), S(9));
    if (!lens) return 0;
    OrbitCamera<S> orbit{*lens, point, S(9)};
    orbit.rotate(angle, angle);
    orbit.zoom(S(2));
    const auto camera = orbit.camera();
    const Frustum frustum{camera};
    const Ray<S, 3> ray = pick_ray(camera, Viewport{8, 6}, 1, 2);
    const Segment<S, 3> segment{point, unproject(camera, S(0), S(1), S(2))};
    return ask(frustum, ray, point) + meet(segment, frustum, Sphere<S, 3>{point, S(1)}) +
           (project(camera, point) ? 1 : 0);
  }

  [[nodiscard]] int flat() const {
    const Vec<S, 2> spot{point.x, point.z};
    const Ray<S, 2> ray{spot, Direction<S, 2>::along(0)};
    const Sphere<S, 2> circle{spot, S(2)};
    const Obb<S, 2> obb{spot, spot, Rotation<S, 2>::from_angle(angle)};
    const Capsule<S, 2> capsule{spot, Vec<S, 2>{}, S(1)};
    const Segment<S, 2> segment{spot, Vec<S, 2>{}};
    return ask(circle, ray, spot) + ask(obb, ray, spot) + ask(capsule, ray, spot) +
           meet(segment, circle, obb, capsule);
  }

  [[nodiscard]] int motions() const {
    const auto turn = Quat<S>::from_axis_angle(forward, angle);
    const Transform<S, 3> frame{point, Rotation<S, 3>::from_axis_angle(forward, angle)};
    const auto there = compose(frame, inverse(frame).value_or(frame));
    const auto matrix = nearest_to<S>(to_mat(there) * view_matrix(frame));
    return (inverse(matrix) ? 1 : 0) + (slerp(turn, turn, S(0)) == turn ? 1 : 0) +
           (transform_point(frame, point) == point ? 1 : 0) +
           (time_of_impact(Sphere{point, S(1)}, Sweep{point, point}, Sphere{point, S(1)}) ? 1 : 0) +
           (cast(Sphere{point, S(1)}, forward, S(1), Sphere{point, S(1)}) ? 1 : 0) +
           (contact(Aabb{point, point}, Sphere{point, S(1)}) ? 1 : 0) +
           (sin(angle) + cos(angle) > 1 ? 1 : 0) + (angle_between(point, point) == angle ? 1 : 0);
  }
};

template <class World>
int play(World& world, const Numbers<q16_16>& numbers) {
  const Sphere ball{numbers.point, 1_q16_16};
  const auto first = world.add(ball), second = world.add(ball, {.layers = 2, .user = 77});
  if (!first || !second) return 1;
  world.move(*first, numbers.point);
  world.replace(*second, ball);
  world.set_layers(*second, 3);
  world.optimize();
  std::array<Found<q16_16>, 4> found;
  std::array<Overlap, 4> pairs;
  const auto ray = Ray{numbers.point, numbers.forward};
  auto count = world.all(ray, std::span(found), InLayers{2}) + world.overlaps(std::span(pairs));
  if (world.nearest(numbers.point) || world.any(ball) || world.nearest_hit(ray)) ++count;
  if (const auto frame = world.add_frame({.translation = numbers.point})) {
    const auto attached = world.add(ball, {.frame = *frame});
    world.move_frame(*frame, {.translation = numbers.point});
    if (attached) world.remove(*attached);
    world.remove_frame(*frame);
  }
  const auto other = world;
  world.remove(*first);
  std::array<std::byte, 4096> room;
  const auto saved = std::span(room).first(snapshot(other, room));
  if (restore(world, saved) == Restored::yes && digest(world) == digest(other)) ++count;
  return static_cast<int>(count);
}

int surfaces(const Numbers<q16_16>& numbers) {
  const auto point = numbers.point;
  const std::array triangles{Triangle{point, Vec<q16_16, 3>{}, point}};
  const OwnedMesh<q16_16> mesh(triangles);
  const std::array<q16_16, 9> heights{};
  const auto field = height_field<q16_16>({}, 1_q16_16, 3, 3, heights);
  const Ray ray{point, numbers.forward};
  const auto look = [&](const auto& surface) {
    std::array<MeshHit<q16_16>, 4> hits;
    return raycast_all(ray, surface, std::span<MeshHit<q16_16>>(hits)) +
           (raycast_hit(ray, surface) ? 1u : 0u) + (raycast_any(ray, surface) ? 1u : 0u) +
           (nearest_triangle(surface, point) ? 1u : 0u) +
           (overlaps(surface, Sphere{point, 1_q16_16}) ? 1u : 0u) +
           (intersects(Segment{point, Vec<q16_16, 3>{}}, surface) ? 1u : 0u);
  };
  auto count = look(mesh.view());
  if (field) count += look(*field) + (overlaps(mesh.view(), *field) ? 1u : 0u);
  using Ball = Sphere<q16_16, 3>;
  const std::vector<Ball> balls(20, Ball{point, 1_q16_16});
  std::array<ShapeBatch<Ball>::Block, batch_blocks(20)> room;
  const ShapeBatch<Ball> batch(balls, room);
  if (raycast_first(ray, batch)) ++count;
  return static_cast<int>(count);
}

/// Negative literals initialize members.
struct Wheel {
  Vec<q16_16, 2> center{-6_q16_16, 0.5_q16_16};
  q16_16 radius = 1_q16_16;
};

/// Bodies of every kind fall for a tick.
int fall(const Wheel& wheel) {
  const Sphere disk{wheel.center, wheel.radius};
  const std::array corners{wheel.center, Vec{1_q16_16, 0_q16_16}, Vec{0_q16_16, 1_q16_16}};
  const auto hull = solid_hull(1, ConvexHull{corners});
  const std::array parts{BodyPart{disk}, BodyPart{Sphere{corners[1], 1_q16_16}}};
  const auto compound = solid_compound(2, parts);
  if (!hull || !compound) return 1;
  World<q16_16, 2, Sphere, BodyHull, BodyCompound> world;
  const auto ball = world.add(disk);
  world.add(BodyHull{&*hull});
  world.add(BodyCompound{&*compound, {2_q16_16, 0_q16_16}, {}});
  world.step();
  int touches = 0;
  world.for_each_contact([&](const auto&) { ++touches; });
  return touches + (ball && world.velocity(*ball) == Vec<q16_16, 2>{} ? 1 : 0);
}

/// Counts the draw calls.
struct Paper {
  int marks = 0;
  void line(const Vec<q16_16, 3>&, const Vec<q16_16, 3>&, const Colour&) { ++marks; }
  void triangle(const Vec<q16_16, 3>&, const Vec<q16_16, 3>&, const Vec<q16_16, 3>&,
                const Colour&) {
    ++marks;
  }
};

template <class Scene>
int sketch(const Scene& scene) {
  Paper paper;
  draw(paper, scene, ColourByKind());
  draw_tree(paper, scene);
  return paper.marks;
}

/// A match with one packet, and its replay.
int match(int input) {
  constexpr SessionLimits limits{.players = 2, .peers = 2, .prediction = 2, .evidence = 2};
  using Match = Session<int, std::int16_t, limits>;
  static Match session({.match = 5}, 0);
  const auto simulate = [](int& world, const auto& inputs) { world += inputs[0]; };
  int bytes = 0;
  session.poll(0, [&](std::size_t, auto packet) { bytes += static_cast<int>(packet.size()); });
  session.drop(1);
  session.advance(static_cast<std::int16_t>(input), simulate);
  std::array<std::byte, 200> file{};
  std::size_t size = 0;
  ReplayWriter<std::int16_t, 2> writer;
  const auto append = [&](std::span<const std::byte> more) {
    for (const auto byte : more) file[size++ % file.size()] = byte;
  };
  writer.begin({.kind = "sum", .snapshot = {}}, append);
  if (const auto inputs = session.inputs(0)) writer.add(*inputs, session.world(), append);
  writer.end(session.world(), append);
  const ReplayReader<std::int16_t, 2> reader(file);
  return bytes + static_cast<int>(check_replay(reader, 0, simulate).frames);
}

}  // namespace

int main(int argc, char** argv) {
  const auto x = q16_16::parse(argv[argc - 1]);
  const auto forward = normalize(Vec<q16_16, 3>{1_q16_16, q16_16(argc), 0_q16_16});
  if (!x || !forward) return 1;
  Numbers<q16_16> numbers{{*x, 1_q16_16, 2_q16_16}, *forward, Angle<q16_16>::from_degrees(*x)};
  numbers.point += numbers.forward.vec() * *x;
  const Numbers<float> rough{{static_cast<float>(argc), 1, 2}, Direction<float, 3>::along(0), {}};
  int sum = fall({}) + numbers.queries() + numbers.flat() + numbers.motions() + numbers.view() +
            rough.flat();

  BoundedScene<Bounded<16>, q16_16, 3, Sphere> bounded;
  BoundedScene<Bounded<16, 2>, q16_16, 3, Sphere, Obb, Capsule> framed;
  Scene<q16_16, 3, Sphere, Aabb, MeshInstance> growing;
  sum +=
      play(bounded, numbers) + play(framed, numbers) + play(growing, numbers) + surfaces(numbers);
  SyncTest<decltype(growing), int> test(2);
  if (test.step(growing, argc, [](auto&, int) {})) ++sum;
  sum += sketch(bounded) + sketch(framed) + sketch(growing) + match(argc);
  std::printf("%d %s\n", sum, to_string(*x).c_str());
}
