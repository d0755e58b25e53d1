// SPDX-License-Identifier: MIT
#include <algorithm>
#include <span>
#include <vector>

#include "detent/number/text.hpp"
#include "detent/scene/scene.hpp"
#include "support/catch.hpp"
#include "support/random.hpp"

using namespace detent;

namespace {

using S = q16_16;
using V = Vec<S, 2>;

/// Axes with a cosine just below 2^-10: as skewed as an `Obb` can be without counting as unbounded.
Rotation<S, 2> skewed() {
  return Rotation<S, 2>::from_axes({Direction<S, 2>::along(0), *normalize(V{S(1), S(1100)})});
}

}  // namespace

TEST_CASE("scene: a skewed box extends beyond its edges by a fraction of its longest side") {
  Scene<S, 2, Obb> scene;
  // |x| <= 1000 and |y + x / 1100| <= 1: at x = -999 up to y = 1.9.
  const Obb<S, 2> plank{{}, {S(1000), S(1)}, skewed()};
  const V point{S(-999), *S::parse("1.8")};
  REQUIRE(contains(plank, point));
  REQUIRE(scene.add(plank));
  CHECK(scene.any(point));
}

TEST_CASE("scene: the distance of a skewed box is less in its own frame") {
  Scene<S, 2, Obb, Sphere> scene;
  const Obb<S, 2> speck{{}, {}, skewed()};
  const V point{S(700), S(-700)};
  // 989.95 away; 989.63 in the frame of the box.
  const Sphere<S, 2> ball{{S(700), *S::parse("289.8")}, S(0)};
  REQUIRE(distance(speck, point) < distance(ball, point));
  REQUIRE(distance(ball, point) < distance(V{}, point));
  REQUIRE(scene.add(ball));
  const auto id = scene.add(speck);
  const auto nearest = scene.nearest(point);
  REQUIRE(nearest);
  CHECK(nearest->id == *id);
}

TEST_CASE("scene: an object that moves slightly beyond its neighbours is found there") {
  using Ball = Sphere<S, 2>;
  Scene<S, 2, Sphere> scene;
  std::vector<ObjectId> ids;
  std::vector<V> centers;
  for (int i = 0; i < 40; ++i) {
    centers.push_back({S(i % 8 * 4), S(i / 8 * 4)});
    ids.push_back(scene.add(Ball{centers.back(), S(1)}).value());
  }
  for (std::size_t i = 0; i < ids.size(); ++i) {
    for (int axis = 0; axis < 2; ++axis) {
      for (const int sign : {-1, 1}) {
        V there = centers[i], tip = centers[i];
        there[axis] += 2 * sign;
        tip[axis] += 3 * sign;
        REQUIRE(scene.replace(ids[i], Ball{there, S(1)}));
        CHECK(scene.any(tip));
        REQUIRE(scene.replace(ids[i], Ball{centers[i], S(1)}));
      }
    }
  }
}

TEST_CASE("scene: a removed frame differs from the next one at its index") {
  Scene<S, 2, Sphere> scene;
  const auto gone = scene.add_frame({}).value();
  REQUIRE(scene.remove_frame(gone));
  const auto next = scene.add_frame({}).value();
  REQUIRE(next.index == gone.index);
  CHECK(scene.move_frame(next, {}));
  CHECK_FALSE(scene.move_frame(gone, {}));
  CHECK_FALSE(scene.add_frame({}, gone));
}

namespace {

/// The pairs that overlap and the objects in a region, found by testing every object.
template <class Scene>
void compare_with_loops(const Scene& scene, const Sphere<S, 2>& region) {
  std::vector<Overlap> pairs;
  std::vector<Found<S>> found;
  scene.for_each([&](const ObjectInfo& a, const auto& first) {
    if (overlaps(region, first)) found.push_back({distance(first, region.center), a.id});
    scene.for_each([&](const ObjectInfo& b, const auto& second) {
      const bool counts = a.motion == Motion::moving || b.motion == Motion::moving;
      if (a.id < b.id && counts && overlaps(first, second)) pairs.push_back({a.id, b.id});
    });
  });
  std::sort(pairs.begin(), pairs.end());
  std::sort(found.begin(), found.end());
  CHECK(scene.overlaps() == pairs);
  CHECK(scene.all(region) == found);
  CHECK(scene.any(region) == !found.empty());
  // As many as fit.
  std::vector<Overlap> first_pairs(pairs.size() / 2);
  CHECK(scene.overlaps(first_pairs) == pairs.size());
  pairs.resize(first_pairs.size());
  CHECK(first_pairs == pairs);
  for (const std::size_t room : {found.size() / 2, found.size() + 1}) {
    std::vector<Found<S>> first_found(room);
    CHECK(scene.all(region, std::span(first_found)) == found.size());
    first_found.resize(std::min(room, found.size()));
    CHECK(std::equal(first_found.begin(), first_found.end(), found.begin()));
  }
}

}  // namespace

// More candidates than wait for an exact test at once, and more or fewer pairs than objects.
TEST_CASE("scene: a crowd and a sparse scene give the results of loops") {
  for (const int spread : {3, 15, 300}) {
    test::Random random(0xc70d);
    Scene<S, 2, Sphere, Obb> scene;
    std::vector<ObjectId> ids;
    const auto draw = [&] { return S(random.between(-spread, spread)); };
    for (int i = 0; i < 200; ++i) {
      const V center{draw(), draw()};
      const bool is_fixed = spread > 3 && random.one_in(4);
      const Traits traits{.motion = is_fixed ? Motion::fixed : Motion::moving};
      const auto id = random.coin() ? scene.add(Sphere<S, 2>{center, S(1)}, traits)
                                    : scene.add(Obb<S, 2>{center, {S(1), S(2)}, skewed()}, traits);
      ids.push_back(id.value());
      if (i % 3 == 2) scene.remove(ids[static_cast<std::size_t>(random.below(ids.size()))]);
    }
    compare_with_loops(scene, {{}, S(spread)});
    compare_with_loops(scene, {{S(1), {}}, S(spread / 3)});
    scene.optimize();
    compare_with_loops(scene, {{}, S(spread)});
  }
}
