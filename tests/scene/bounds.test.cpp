// SPDX-License-Identifier: MIT
#include "detent/cull/quantized_box.hpp"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "detent/scene/mesh.hpp"
#include "detent/scene/scene.hpp"
#include "oracle/draw.hpp"
#include "oracle/space.hpp"
#include "scene/mesh_helpers.hpp"
#include "support/catch.hpp"

namespace detent::test {
namespace {

using oracle::Raw;

template <Scalar S, int N>
Raw<N> raw(const Vec<S, N>& point) {
  Raw<N> result{};
  for (int i = 0; i < N; ++i) result[static_cast<std::size_t>(i)] = point[i].raw();
  return result;
}

/// Shapes of nearly the greatest size, anywhere in the scalar's range, that touch at a given point
/// as closely as the grid allows.
template <Scalar S, int N>
class Ends {
 public:
  using D = oracle::Draw<S, N>;
  using Point = Vec<S, N>;

  explicit Ends(std::uint64_t seed) : draw(seed) {}

  D draw;
  Random& random = draw.random;

  S size() {
    switch (random.below(8)) {
      case 0:
        return D::scalar(0);
      case 1:
        return D::scalar(random.between(0, D::limit));
      default:
        return D::scalar(D::limit - random.between(0, 2));
    }
  }
  Point point() { return random.coin() ? D::vec(draw.point(D::limit)) : D::vec(end()); }
  Rotation<S, N> rotation() {
    const auto angle = [&] {
      return Angle<S>::from_raw(static_cast<std::int32_t>(random.next() & 0xffffffff));
    };
    if constexpr (N == 2) {
      return Rotation<S, N>::from_angle(angle());
    } else {
      const auto x = angle(), y = angle(), z = angle();
      return Rotation<S, N>::from_euler(x, y, z);
    }
  }

  Transform<S, N> transform() {
    Transform<S, N> result;
    if (random.coin()) result.rotation = rotation();
    if (random.coin()) result.translation = point();
    return result;
  }

  // Shapes with `spot` on or near their surface, unless no candidate has its center in range.

  void touch(const Raw<N>& spot, Point& point) { point = D::vec(spot); }
  void touch(const Raw<N>& spot, Sphere<S, N>& sphere) {
    sphere.radius = size();
    sphere.center = in_world([&] {
      const auto direction = random.coin() ? draw.axis_direction() : draw.any_direction();
      return draw.near(D::moved(spot, direction, sphere.radius.raw()), 2);
    });
  }
  void touch(const Raw<N>& spot, Capsule<S, N>& capsule) {
    Sphere<S, N> end;
    touch(spot, end);
    capsule = {end.center, random.coin() ? end.center : point(), end.radius};
  }
  void touch(const Raw<N>& spot, Aabb<S, N>& box) {
    box.min = D::vec(spot);
    box.max = random.coin() ? box.min : D::vec(draw.near(spot, D::limit));
    for (int i = 0; i < N; ++i) {
      if (box.max[i] < box.min[i]) std::swap(box.min[i], box.max[i]);
    }
  }
  void touch(const Raw<N>& spot, Obb<S, N>& box) {
    const bool is_point = random.one_in(4), is_cube = random.coin();
    const S edge = size();
    for (int i = 0; i < N; ++i) {
      box.half_extents[i] = is_point ? S(0) : is_cube ? edge : size();
    }
    box.center = in_world([&] {
      box.rotation = rotation();
      return corner(spot, box);
    });
  }
  void touch(Raw<N> spot, Ray<S, N>& ray) {
    ray.direction = draw.any_direction();
    ray.max_distance = S::max();
    ray.origin = D::vec(D::moved(spot, ray.direction, -random.between(0, D::limit)));
  }

  /// A point near a corner of the box if its center were `center`. The axes are only nearly
  /// perpendicular, so slabs end a few units off the corner of the edges.
  Raw<N> corner(Raw<N> center, const Obb<S, N>& box) {
    for (int i = 0; i < N; ++i) {
      const auto across = box.half_extents[i].raw();
      center = D::moved(center, box.rotation.axis(i), random.coin() ? across : -across);
    }
    return draw.near(center, 3);
  }

  /// A ball (as a capsule) of the greatest radius, and a one-point box exactly where a world axis
  /// leaves it; in the box's frame it may be a unit nearer.
  std::pair<Capsule<S, N>, Obb<S, N>> ball_and_point() {
    Raw<N> center = draw.point(D::limit / 2);
    const auto at = random.below(N);
    const bool is_behind = random.coin();
    center[at] = is_behind ? random.between(0, D::limit) : -random.between(1, D::limit);
    const Capsule<S, N> ball{D::vec(center), D::vec(center), D::scalar(D::limit)};
    const auto away = D::limit + random.between(0, 1);
    center[at] += is_behind ? -away : away;
    return {ball, {D::vec(center), Point(), rotation()}};
  }
  /// A point, and a cube of the greatest half extents with a corner near it.
  std::pair<Point, Obb<S, N>> cube_and_corner() {
    const Raw<N> spot = draw.point(D::limit - 4);
    Obb<S, N> box;
    for (int i = 0; i < N; ++i) box.half_extents[i] = D::scalar(D::limit);
    box.center = in_world([&] {
      box.rotation = rotation();
      return corner(spot, box);
    });
    return {D::vec(spot), box};
  }

  /// In range or beyond it.
  Raw<N> spot() {
    if (random.coin()) return end();
    return draw.point(random.coin() ? D::limit : 2 * D::limit);
  }

 private:
  template <class F>
  Point in_world(const F& propose) {
    Raw<N> result = propose();
    const auto is_outside = [](std::int64_t x) { return x < -D::limit - 1 || x > D::limit; };
    for (int i = 0; i < 30 && std::any_of(result.begin(), result.end(), is_outside); ++i) {
      result = propose();
    }
    return D::vec(result);
  }
  Raw<N> end() {
    Raw<N> result{};
    for (auto& x : result) x = random.coin() ? D::limit : random.one_in(4) ? 0 : -D::limit - 1;
    return result;
  }
};

template <class A, class B>
bool both_meet(const A& a, const B& b) {
  return detail::meets(a, b);
}
template <Scalar S, int N, class B>
bool both_meet(const Ray<S, N>& ray, const B& b) {
  return raycast(ray, b).has_value();
}

template <class A, class B>
bool boxes_meet(const A& a, const B& b) {
  const auto box = detail::quantized_box(a), other = detail::quantized_box(b);
  for (std::size_t i = 0; i < box.low.size(); ++i) {
    if (box.low[i] > other.high[i] || other.low[i] > box.high[i]) return false;
  }
  return true;
}
template <Scalar S, int N, class B>
bool boxes_meet(const Ray<S, N>& ray, const B& b) {
  detail::TreeNode<S, N> node;
  node.set(0, detail::quantized_box(b));
  node.count = 1;
  const detail::RayProbe<S, N> probe(ray);
  const auto meet = [&](const auto& keys) {
    std::array<typename std::remove_cvref_t<decltype(keys)>::Key, decltype(node)::width> times;
    return keys.keys(node, times) == 1 && keys.reaches(times[0]);
  };
  if constexpr (is_fixed<S>) {
    using Array = detail::ArrayLanes<std::int32_t>;
    using Compared = detail::ComparedLanes<std::int32_t>;
    const bool do_meet = meet(detail::RayLanes<S, N, Array>(probe));
    REQUIRE(meet(detail::RayLanes<S, N, Compared>(probe)) == do_meet);
    if (!do_meet) return false;
  }
  return meet(detail::RayKeys<S, N>(probe));
}

/// Checks for pairs of shapes drawn by `next` that if they overlap, so do their boxes.
template <class Next>
void compare_boxes(int count, const Next& next) {
  HitRate rate;
  int missed = 0;
  for (int i = 0; i < count; ++i) {
    const auto [a, b] = next();
    const bool meet = both_meet(a, b);
    rate.count(meet);
    if (meet && !boxes_meet(a, b)) ++missed;
  }
  CHECK(missed == 0);
  CHECK(rate.percent() > 2);
}
template <class A, class B, Scalar S, int N>
void compare_boxes(Ends<S, N>& ends, int count) {
  compare_boxes(count, [&] {
    const auto spot = ends.spot();
    std::pair<A, B> both;
    ends.touch(spot, both.first);
    ends.touch(spot, both.second);
    return both;
  });
}

template <class B, Scalar S, int N>
void compare_with_all(Ends<S, N>& ends, int count) {
  compare_boxes<Vec<S, N>, B>(ends, count);
  compare_boxes<Ray<S, N>, B>(ends, count);
  compare_boxes<Sphere<S, N>, B>(ends, count);
  compare_boxes<Aabb<S, N>, B>(ends, count);
  compare_boxes<Capsule<S, N>, B>(ends, count);
  compare_boxes<Obb<S, N>, B>(ends, count);
}

}  // namespace

TEST_CASE("bounds: a corner of a box with the greatest half extent is found", "[scene]") {
  using S = q16_16;
  using Point = Vec<S, 3>;
  const auto x = *normalize(Point{S(2048), S(1), S(0)});
  const auto y = Direction<S, 3>::along(1), z = Direction<S, 3>::along(2);
  const Obb<S, 3> box{Point{S(-16384), S(0), S(0)}, Point{S::max(), S(16384), S(1)},
                      Rotation<S, 3>::from_axes({x, y, z})};
  const Point corner{S(16388), S(-16384), S(0)};
  REQUIRE(contains(box, corner));
  Scene<S, 3, Obb> scene;
  const auto id = scene.add(box);
  REQUIRE(id);
  CHECK(scene.any(corner));
  CHECK(scene.all(corner).size() == 1);
  CHECK(scene.nearest(corner) == Found<S>{S(0), *id});
}

TEMPLATE_TEST_CASE("bounds: overlapping shapes have overlapping boxes at the ends of the range",
                   "[scene]", (Space<q16_16, 3>), (Space<q14_16, 2>), (Space<q8_8, 3>)) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  Ends<S, N> ends(0xb0f5);
  INFO("seed " << ends.random.seed());
  compare_with_all<Obb<S, N>>(ends, 2'000);
  compare_with_all<Sphere<S, N>>(ends, 1'000);
  compare_with_all<Capsule<S, N>>(ends, 1'000);
  compare_boxes(10'000, [&] { return ends.cube_and_corner(); });
  compare_boxes(10'000, [&] { return ends.ball_and_point(); });
  compare_boxes(10'000, [&] {
    const auto [ball, box] = ends.ball_and_point();
    return std::pair{Sphere<S, N>{ball.a, ball.radius}, box};
  });
}

namespace {

/// A point on the surface of a shape, in range or beyond it.
template <Scalar S, int N>
Raw<N> spot_on(Ends<S, N>& ends, const Sphere<S, N>& ball) {
  return Ends<S, N>::D::moved(raw(ball.center), ends.draw.any_direction(), ball.radius.raw());
}
template <Scalar S, int N>
Raw<N> spot_on(Ends<S, N>& ends, const Obb<S, N>& box) {
  return ends.corner(raw(box.center), box);
}

template <class World, class Question>
void ask(const World& scene, const Question& question, HitRate& rate) {
  std::vector<ObjectId> expected, answer;
  scene.for_each([&](const ObjectInfo& info, const auto& shape) {
    if (detail::meets(question, shape)) expected.push_back(info.id);
  });
  for (const auto& found : scene.all(question)) answer.push_back(found.id);
  std::sort(answer.begin(), answer.end());
  CHECK(answer == expected);
  CHECK(scene.any(question) == !expected.empty());
  rate.count(!expected.empty());
}

template <class World>
void ask_for_pairs(const World& scene, HitRate& rate) {
  std::vector<Overlap> expected;
  scene.for_each([&](const ObjectInfo& a, const auto& shape) {
    scene.for_each([&](const ObjectInfo& b, const auto& other) {
      if (a.id < b.id && detail::meets(shape, other)) expected.push_back({a.id, b.id});
    });
  });
  CHECK(scene.overlaps() == expected);
  rate.count(!expected.empty());
}

}  // namespace

TEMPLATE_TEST_CASE(
    "bounds: moved objects, and objects in frames, are found at the ends of the range", "[scene]",
    (Space<q16_16, 2>), (Space<q8_8, 3>)) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  using Ball = Sphere<S, N>;
  using Box = Obb<S, N>;
  Ends<S, N> ends(0xf4a3e);
  INFO("seed " << ends.random.seed());
  HitRate rate, pairs;
  for (int i = 0; i < 300; ++i) {
    Scene<S, N, Sphere, Obb> scene;
    const auto frame = scene.add_frame(ends.transform());
    REQUIRE(frame);
    const auto add = [&](auto shape) {
      ends.touch(ends.spot(), shape);
      const auto id = scene.add(shape, {.frame = ends.random.coin() ? *frame : FrameId{}});
      REQUIRE(id);
      if (ends.random.coin()) CHECK(scene.move(*id, ends.point()));
      return *scene.template shape<decltype(shape)>(*id);
    };
    const Ball ball = add(Ball());
    const Box box = add(Box());
    if (ends.random.one_in(4)) CHECK(scene.move_frame(*frame, ends.transform()));
    for (const auto& spot : {spot_on(ends, ball), spot_on(ends, box)}) {
      Vec<S, N> point;
      Ball other_ball;
      Box other_box;
      ends.touch(spot, point);
      ends.touch(spot, other_ball);
      ends.touch(spot, other_box);
      ask(scene, point, rate);
      ask(scene, other_ball, rate);
      ask(scene, other_box, rate);
      REQUIRE(scene.add(other_ball));
      REQUIRE(scene.add(other_box));
      ask_for_pairs(scene, pairs);
    }
  }
  CHECK(rate.percent() > 10);
  CHECK(pairs.percent() > 10);
}

TEMPLATE_TEST_CASE("bounds: scenes find the largest balls and boxes, alone and as pairs", "[scene]",
                   (Space<q16_16, 2>), (Space<q8_8, 3>)) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  Ends<S, N> ends(0x1a49e);
  INFO("seed " << ends.random.seed());
  HitRate rate;
  for (int i = 0; i < 1000; ++i) {
    const auto [capsule, point] = ends.ball_and_point();
    const Sphere<S, N> ball{capsule.a, capsule.radius};
    const auto [corner, cube] = ends.cube_and_corner();
    Scene<S, N, Sphere, Obb> with_point, with_ball, with_cube;
    REQUIRE(with_point.add(point));
    REQUIRE(with_ball.add(ball));
    REQUIRE(with_cube.add(cube));
    ask(with_point, ball, rate);
    ask(with_ball, point, rate);
    ask(with_cube, corner, rate);
    REQUIRE(with_point.add(ball));
    ask_for_pairs(with_point, rate);
  }
  INFO(rate);
  CHECK(rate.percent() > 15);
}

TEST_CASE("bounds: placed meshes are found at the ends of the range", "[scene]") {
  using S = q8_8;
  Ends<S, 3> ends(0x3e54);
  INFO("seed " << ends.random.seed());
  HitRate rate;
  for (int i = 0; i < 200; ++i) {
    const auto list = draw_mesh(ends.draw, MeshKind::extreme, 1 + ends.random.below(12), 1);
    const OwnedMesh<S> mesh{std::span<const Triangle<S, 3>>(list)};
    const std::array assets{MeshAsset<S>(1, mesh.view())};
    const PlacedMesh<S> there{&assets[0], ends.transform()};
    Scene<S, 3, MeshInstance> scene;
    REQUIRE(scene.add(there));
    const auto ask_mesh = [&](auto question) {
      const auto& triangle = list[ends.random.below(list.size())];
      const auto spot = raw(placed(there.transform, triangle).b);
      ends.touch(spot, question);
      const bool expected = std::any_of(list.begin(), list.end(), [&](const auto& part) {
        return detail::meets(question, placed(there.transform, part));
      });
      CHECK(scene.any(question) == expected);
      rate.count(expected);
    };
    ask_mesh(Vec<S, 3>());
    ask_mesh(Sphere<S, 3>());
    ask_mesh(Capsule<S, 3>());
    ask_mesh(Obb<S, 3>());
  }
  CHECK(rate.percent() > 10);
}

}  // namespace detent::test
