// SPDX-License-Identifier: MIT
#include "detent/query/batch.hpp"

#include <vector>

#include "bench/draw.hpp"
#include "detent/query/raycast.hpp"
#include "oracle/draw_shape.hpp"
#include "oracle/space.hpp"
#include "support/catch.hpp"
#include "support/shapes.hpp"

using namespace detent;
using namespace detent::test;

namespace {

// Batches with their blocks in vectors; normally the caller owns the blocks.
template <class Shape>
struct Shapes {
  explicit Shapes(const std::vector<Shape>& list, std::size_t block_count)
      : blocks(block_count), batch(list, blocks) {}
  std::vector<typename ShapeBatch<Shape>::Block> blocks;
  ShapeBatch<Shape> batch;
};
template <Scalar S, int N>
struct Rays {
  Rays(const std::vector<Ray<S, N>>& list, const Aabb<S, N>& frame, std::size_t block_count)
      : blocks(block_count), batch(list, frame, blocks) {}
  std::vector<typename RayBatch<S, N>::Block> blocks;
  RayBatch<S, N> batch;
};

/// Whether batches give the same results as loops; counts the hits.
template <Scalar S, int N, class Shape>
bool batches_are_loops(const std::vector<Ray<S, N>>& rays, const std::vector<Shape>& shapes,
                       const Aabb<S, N>& frame, HitRate& rate) {
  const Shapes<Shape> many_shapes(shapes, batch_blocks(shapes.size()));
  const Shapes<Shape> with_few_blocks(shapes, 1);
  const Rays<S, N> many_rays(rays, frame, batch_blocks(rays.size()));
  bool is_right = true;
  for (const auto& ray : rays) {
    std::vector<std::optional<S>> expected, answers(shapes.size(), S(1));
    std::optional<BatchHit<S>> first;
    for (std::size_t i = 0; i < shapes.size(); ++i) {
      const auto distance = raycast(ray, shapes[i]);
      expected.push_back(distance);
      rate.count(distance.has_value());
      if (distance && (!first || *distance < first->distance)) first = BatchHit<S>{i, *distance};
    }
    raycast_each<S, N>(ray, many_shapes.batch, answers);
    is_right = is_right && answers == expected;
    for (const auto* batch : {&many_shapes.batch, &with_few_blocks.batch}) {
      is_right = is_right && raycast_first(ray, *batch) == first;
      is_right = is_right && raycast_any(ray, *batch) == first.has_value();
    }
  }
  for (std::size_t i = 0; i < shapes.size(); i += 7) {
    std::vector<std::optional<S>> expected, answers(rays.size(), S(1));
    bool any = false;
    for (const auto& ray : rays) expected.push_back(raycast(ray, shapes[i]));
    for (const auto& answer : expected) any = any || answer.has_value();
    raycast_each<S, N>(many_rays.batch, shapes[i], answers);
    is_right = is_right && answers == expected && raycast_any(many_rays.batch, shapes[i]) == any;
  }
  return is_right;
}

/// Tests shapes of several kinds and scenes, with rays from one shape to another.
template <class Shape, Scalar S, int N>
bool examine(std::uint64_t seed, int rounds, HitRate& rate) {
  using oracle::Draw, oracle::Kind;
  Draw<S, N> draw(seed);
  auto& random = draw.random;
  bool is_right = true;
  for (int round = 0; round < rounds; ++round) {
    const auto kind = static_cast<Kind>(round % 5);
    const bool is_mixed = random.one_in(4);
    std::vector<Shape> shapes;
    std::vector<oracle::Raw<N>> centers;
    while (shapes.size() < 80) {
      const auto setting =
          draw_setting(draw, is_mixed && random.coin() ? Kind::general : kind, 100);
      for (auto count = random.between(1, 8); count > 0; --count) {
        shapes.push_back(oracle::draw_shape<Shape>(draw, setting));
      }
      centers.push_back(setting.center);
    }
    std::vector<Ray<S, N>> rays;
    while (rays.size() < 70) {
      const auto from = random.one_in(8) ? draw.extreme_point()
                                         : draw.near(centers[random.below(centers.size())], 3);
      const auto to = centers[random.below(centers.size())];
      const auto direction = random.one_in(4) ? draw.axis_direction() : draw.towards(from, to);
      const auto reach = random.coin() ? draw.reach(1000) : S::max();
      rays.push_back({Draw<S, N>::vec(from), direction, reach});
    }
    Aabb<S, N> frame;
    for (int i = 0; i < N; ++i) {
      frame.min[i] = random.coin() ? S::lowest() : Draw<S, N>::scalar(-draw.scale());
      frame.max[i] = random.coin() ? S::max() : Draw<S, N>::scalar(draw.scale());
    }
    is_right = is_right && batches_are_loops(rays, shapes, frame, rate);
  }
  return is_right;
}

template <class Shape, class Space>
void examine_shape(std::uint64_t seed, int rounds) {
  HitRate rate;
  INFO("seed " << seed);
  CHECK(examine<Shape, typename Space::scalar, Space::dimension>(seed, rounds, rate));
  CHECK(rate.percent() > 0);
}

/// Scattered shapes and rays between them, in double.
template <class Shape>
void draw_scattered(std::vector<Ray<double, 3>>& rays, std::vector<Shape>& shapes) {
  bench::Artist<3> artist(20260505, bench::ordinary);
  for (int i = 0; i < 500; ++i) {
    Ray<double, 3> ray;
    Shape shape;
    artist.next_scene();
    artist.draw(ray);
    artist.draw(shape);
    rays.push_back(ray);
    shapes.push_back(shape);
  }
}

template <class S, class T>
auto converted(const std::vector<T>& list) {
  std::vector<decltype(bench::as<S>(list[0]))> result;
  for (const auto& x : list) result.push_back(bench::as<S>(x));
  return result;
}

}  // namespace

template <class Space, template <Scalar, int> class... Shapes>
void examine_shapes(std::uint64_t seed, int rounds) {
  (examine_shape<Shapes<typename Space::scalar, Space::dimension>, Space>(seed, rounds), ...);
}
template <class Space>
void examine_balls_and_boxes(std::uint64_t seed, int rounds) {
  examine_shapes<Space, Sphere, Aabb>(seed, rounds);
}
template <class Space>
void examine_turned(std::uint64_t seed, int rounds) {
  examine_shapes<Space, Obb, Triangle>(seed, rounds);
}

TEMPLATE_TEST_CASE("batch: results equal those of a loop over single queries", "",
                   DETENT_FIXED_SPACES) {
  examine_balls_and_boxes<TestType>(1, 15);
}

TEMPLATE_TEST_CASE("batch: rotated boxes, triangles and all other shapes as well", "",
                   (Space<q16_16, 3>), (Space<q8_8, 2>)) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  examine_turned<TestType>(2, 15);
  support::SceneShapes<S, N>::template without<
      Sphere<S, N>, Aabb<S, N>, Obb<S, N>, Triangle<S, N>>::for_each([]<class Shape>(const Shape&) {
    examine_shape<Shape, TestType>(3, 5);
  });
}

TEMPLATE_TEST_CASE("batch: thousands of further rounds", "[.demand]", DETENT_FIXED_SPACES) {
  for (std::uint64_t seed = 100; seed < 103; ++seed) examine_balls_and_boxes<TestType>(seed, 200);
}

TEMPLATE_TEST_CASE("batch: thousands of further rounds at any angle", "[.demand]",
                   (Space<q16_16, 3>), (Space<q8_8, 2>)) {
  for (std::uint64_t seed = 100; seed < 103; ++seed) examine_turned<TestType>(seed, 200);
}

TEMPLATE_TEST_CASE("batch: culls most shapes that miss", "", (Sphere<double, 3>),
                   (Triangle<double, 3>)) {
  std::vector<Ray<double, 3>> rays;
  std::vector<TestType> shapes;
  draw_scattered(rays, shapes);
  const auto check = [&](auto scalar) {
    using S = decltype(scalar);
    const auto own_rays = converted<S>(rays);
    const auto own_shapes = converted<S>(shapes);
    using Shape = typename std::decay_t<decltype(own_shapes)>::value_type;
    const auto frame =
        Aabb{make_vec<3>([](int) { return S(-8000); }), make_vec<3>([](int) { return S(8000); })};
    HitRate rate;
    CHECK(batches_are_loops(own_rays, own_shapes, frame, rate));
    std::size_t asked = 0;
    const Shapes<Shape> many(own_shapes, batch_blocks(own_shapes.size()));
    for (const auto& ray : own_rays) {
      many.batch.visit_candidates(ray, [&](std::size_t, S&) {
        ++asked;
        return Walk::go_on;
      });
    }
    const Rays<S, 3> many_rays(own_rays, frame, batch_blocks(own_rays.size()));
    for (const auto& shape : own_shapes) {
      many_rays.batch.visit_candidates(shape, [&](std::size_t) {
        ++asked;
        return Walk::go_on;
      });
    }
    INFO(rate << ", asked " << asked);
    CHECK(asked < 2 * 500 * 500 / 50);
  };
  check(float());
  check(double());
  check(q16_16());
}

/// Specks within `reach` raw units, each a raw unit wide plus `size` on each side, and rays aimed
/// at them. Every other ray ends just after it enters, so the error of the quantized numbers
/// decides.
template <Scalar S, int N>
void examine_specks(std::int64_t reach, std::int64_t size) {
  using Drawn = oracle::Draw<S, N>;
  Drawn draw(0x5bec);
  INFO(draw.random << ", within " << reach);
  std::vector<Aabb<S, N>> specks;
  std::vector<Ray<S, N>> rays;
  std::size_t met = 0;
  while (specks.size() < 100) {
    const auto at = draw.point(reach);
    auto low = at, high = at;
    for (auto& x : low) x -= size;
    for (auto& x : high) x += size + 1;
    specks.push_back({Drawn::vec(low), Drawn::vec(high)});
    const auto from = draw.point(reach);
    Ray<S, N> ray{Drawn::vec(from), draw.towards(from, at)};
    const auto distance = raycast(ray, specks.back());
    met += distance ? 1 : 0;
    if (distance && specks.size() % 2 == 0) ray.max_distance = Drawn::scalar(distance->raw() + 1);
    rays.push_back(ray);
  }
  CHECK(met > 25);
  const Aabb<S, N> world{make_vec<N>([](int) { return S::lowest(); }),
                         make_vec<N>([](int) { return S::max(); })};
  HitRate rate;
  CHECK(batches_are_loops(rays, specks, world, rate));
}

TEMPLATE_TEST_CASE("batch: rays aimed at specks all over the world", "", (Space<q16_16, 3>),
                   (Space<q16_16, 2>)) {
  examine_specks<typename TestType::scalar, TestType::dimension>(1 << 30, 8);
  examine_specks<typename TestType::scalar, TestType::dimension>(1 << 13, 0);
}

/// Whether `ray` hits `shape`, alone and in a batch.
template <class Shape>
bool is_hit_in_both(const Ray<q16_16, 2>& ray, const Shape& shape) {
  const std::vector<Shape> only{shape};
  const Shapes<Shape> shapes(only, 1);
  return raycast(ray, shape) && raycast_any(ray, shapes.batch);
}

TEST_CASE("batch: a shape that extends beyond one end of the world is still hit there") {
  using S = q16_16;
  const auto across = *normalize(Vec<S, 2>{S(3), S(-4)});
  const auto beside = nearest_to<S>(S::max() - S(1));
  CHECK(is_hit_in_both(Ray{Vec<S, 2>{beside, S(12)}, across},
                       Sphere{Vec<S, 2>{S::max(), S(0)}, S(10)}));
}

TEST_CASE("batch: the slabs of a skewed box reach beyond its edges") {
  using S = q16_16;
  using D = Direction<S, 2>;
  const auto slanted =
      Rotation<S, 2>::from_axes({D::along(0), *normalize(Vec<S, 2>{S(1), S(1100)})});
  const Obb<S, 2> box{{}, {S(1000), S(1000)}, slanted};
  CHECK(is_hit_in_both(Ray{Vec<S, 2>{S(-2000), nearest_to<S>(S(1000) + half(S(1)))}, D::along(0)},
                       box));
}

TEST_CASE("batch: slabs along skewed axes end outside the box around the edges") {
  using S = q8_8;
  // Less than a unit outside, where the bounding box tested by a batch is no larger.
  Random random(20261122);
  INFO("seed " << random.seed());
  const auto number = [](std::int64_t raw) { return S::from_raw(static_cast<std::int16_t>(raw)); };
  const auto skewed = Direction<S, 2>::from_raw({16384, 16});
  const auto up = Direction<S, 2>::along(1);
  REQUIRE(skewed);
  HitRate rate;
  int wrong = 0;
  for (int i = 0; i < 20'000; ++i) {
    const auto size = random.between(30, 63);
    const std::array boxes{
        Obb<S, 2>{{}, {number(size), number(size)}, Rotation<S, 2>::from_axes({*skewed, up})}};
    const Vec<S, 2> origin{number(size - random.between(1, 40)),
                           number(random.between(-size - 40, -size - 1))};
    // Up to an eighth of a unit from the corner.
    const auto direction =
        normalize(Vec<S, 2>{number(64 * (size - origin.x.raw()) + random.between(0, 8)),
                            number(64 * (-size - origin.y.raw()))});
    if (!direction) continue;
    const Ray ray{origin, *direction, S::max()};
    std::array<ShapeBatch<Obb<S, 2>>::Block, 1> blocks;
    const ShapeBatch<Obb<S, 2>> batch(boxes, blocks);
    const bool is_hit = raycast(ray, boxes[0]).has_value();
    rate.count(is_hit);
    if (raycast_any(ray, batch) != is_hit) ++wrong;
  }
  INFO(rate);
  CHECK(wrong == 0);
  CHECK(rate.is_balanced());
}

TEST_CASE("batch: an empty batch, and shapes without room for results") {
  using S = q16_16;
  const Ray<S, 3> ray;
  CHECK_FALSE(raycast_first(ray, ShapeBatch<Sphere<S, 3>>({}, {})));
  const std::array<Sphere<S, 3>, 2> balls{Sphere<S, 3>{{}, S(1)}, Sphere<S, 3>{{}, S(2)}};
  const ShapeBatch<Sphere<S, 3>> batch(balls, {});
  std::array<std::optional<S>, 1> answers;
  raycast_each<S, 3>(ray, batch, answers);
  CHECK(answers[0] == S(0));
  CHECK(raycast_first(ray, batch) == BatchHit<S>{0, S(0)});
}

static_assert([] {
  using S = q16_16;
  std::array<Sphere<S, 3>, 3> balls{};
  for (std::size_t i = 0; i < 3; ++i) balls[i] = {{S(10 - int(i)), S(0), S(0)}, S(1)};
  std::array<ShapeBatch<Sphere<S, 3>>::Block, 1> blocks;
  const ShapeBatch<Sphere<S, 3>> batch(balls, blocks);
  return raycast_first(Ray<S, 3>(), batch) == BatchHit<S>{2, S(7)};
}());
