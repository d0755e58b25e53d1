// SPDX-License-Identifier: MIT
//
// Scenes of the C interface in 2D against scenes of C++: the same calls give the same bits.

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "c/scenes.hpp"
#include "detent/scene/difference.hpp"
#include "support/catch.hpp"
#include "support/random.hpp"

namespace detent {
namespace {

using S = q16_16;
using c::id_of;
using Out = c::Output<2>;
using V = Vec<S, 2>;
constexpr int one = 65536;

V at(std::int64_t x, std::int64_t y) {
  const auto raw = [](std::int64_t n) { return S::from_raw(static_cast<std::int32_t>(n)); };
  return {raw(x), raw(y)};
}

/// A scene of C and one of C++ with the same hull.
struct Twins {
  detent_context context{};
  detent_handle scene = 0, hull = 0;
  std::vector<V> corners{at(0, 0), at(2 * one, 0), at(0, 2 * one)};
  std::array<HullAsset<S, 2>, 1> hulls{*hull_asset(7, ConvexHull<S, 2>{corners})};
  c::SceneOf<2>::type twin;

  Twins() {
    REQUIRE(detent_open(&context, nullptr) == DETENT_OK);
    REQUIRE(detent_scene2_create(&context, &scene) == DETENT_OK);
    std::vector<detent_vec2> points;
    for (const auto& corner : corners) points.push_back(Out::vec(corner));
    REQUIRE(detent_hull2_create(&context, 7, points.data(), 3, &hull) == DETENT_OK);
  }
  Twins(const Twins&) = delete;
  Twins& operator=(const Twins&) = delete;
  ~Twins() { detent_close(&context); }

  /// Shape `kind` at a place, for both.
  template <class F>
  void with_shape(std::uint64_t kind, const V& place, const F& f) const {
    detent_shape2 shape{};
    const auto call = [&](const auto& own) {
      Out::shape(shape, own);
      f(shape, own);
    };
    const auto far = nearest_to<S>(place + corners[1]), high = nearest_to<S>(place + corners[2]);
    const Transform<S, 2> moved{place, {}, S(1)};
    switch (kind) {
      case 0:
        return call(Sphere{place, S(1)});
      case 1:
        return call(Aabb{place, V(nearest_to<S>(place + at(one, one)))});
      case 2:
        return call(Obb{place, at(one, one / 2), Rotation<S, 2>()});
      case 3:
        return call(Plane{Direction<S, 2>::along(1), S::from_raw(-20 * one)});
      case 4:
        return call(Triangle{place, far, high});
      case 5:
        return call(Capsule{place, far, S::from_raw(one / 2)});
      default:
        shape.kind = DETENT_HULL;
        shape.asset = hull;
        shape.as.placed = Out::transform(moved);
        return f(shape, PlacedHull<S, 2>{&hulls[0], moved});
    }
  }

  [[nodiscard]] std::vector<std::byte> saved() const {
    std::uint32_t size = 0;
    REQUIRE(detent_scene2_snapshot(&context, scene, nullptr, 0, &size) == DETENT_NO);
    std::vector<std::byte> bytes(size);
    REQUIRE(detent_scene2_snapshot(&context, scene, bytes.data(), size, &size) == DETENT_OK);
    return bytes;
  }
  void check_digest() const {
    std::uint64_t sum = 0;
    REQUIRE(detent_scene2_digest(&context, scene, &sum) == DETENT_OK);
    REQUIRE(sum == digest(twin));
    std::uint32_t size = 0;
    REQUIRE(detent_scene2_size(&context, scene, &size) == DETENT_OK);
    REQUIRE(size == twin.size());
  }
};

template <class F, class G>
void check_lists(const std::vector<F>& theirs, std::uint32_t count, const std::vector<G>& own,
                 bool (*same)(const F&, const G&)) {
  REQUIRE(count == own.size());
  for (std::size_t i = 0; i < own.size(); ++i) REQUIRE(same(theirs[i], own[i]));
}

bool same_found(const detent_found& a, const Found<S>& b) {
  return a.distance == b.distance.raw() && id_of(a.id) == b.id;
}
bool same_pair(const detent_pair& a, const Overlap& b) {
  return id_of(a.first) == b.first && id_of(a.second) == b.second;
}
bool same_hit(const detent_object_hit2& a, const ObjectHit<S, 2>& b) {
  return a.distance == b.distance.raw() && id_of(a.id) == b.id &&
         c::Input<2>::vec(a.point) == b.point && a.normal.x == b.normal[0].raw() &&
         a.normal.y == b.normal[1].raw();
}

template <class Question>
void check_question(const Twins& twins, const detent_shape2& asked, const Question& question) {
  const InLayers layers{5};
  std::uint32_t count = 0;
  std::vector<detent_found> found(64);
  REQUIRE(detent_scene2_all(&twins.context, twins.scene, &asked, 5, found.data(), 64, &count) ==
          DETENT_OK);
  check_lists(found, count, twins.twin.all(question, layers), same_found);
  REQUIRE(detent_scene2_any(&twins.context, twins.scene, &asked, 5) ==
          c::yes_or_no(twins.twin.any(question, layers)));
  const auto nearest = twins.twin.nearest(question, layers);
  detent_found first{};
  REQUIRE(detent_scene2_nearest(&twins.context, twins.scene, &asked, 5, &first) ==
          c::yes_or_no(nearest.has_value()));
  if (nearest) REQUIRE(same_found(first, *nearest));
}

void check_ray(const Twins& twins, const Ray<S, 2>& ray, int& hits) {
  const detent_ray2 asked{Out::vec(ray.origin), Out::direction(ray.direction),
                          ray.max_distance.raw()};
  const auto all = twins.twin.all_hits(ray, InLayers{7});
  std::vector<detent_object_hit2> list(64);
  std::uint32_t count = 0;
  REQUIRE(detent_scene2_raycast_all(&twins.context, twins.scene, &asked, 7, list.data(), 64,
                                    &count) == DETENT_OK);
  check_lists(list, count, all, same_hit);
  detent_object_hit2 hit{};
  const auto expected = c::yes_or_no(!all.empty());
  REQUIRE(detent_scene2_raycast(&twins.context, twins.scene, &asked, 7, &hit) == expected);
  REQUIRE(detent_scene2_raycast_any(&twins.context, twins.scene, &asked, 7) == expected);
  if (!all.empty()) REQUIRE(same_hit(hit, all[0]));
  REQUIRE(detent_scene2_raycast_many(&twins.context, twins.scene, &asked, 1, 7, &hit) == DETENT_OK);
  REQUIRE((all.empty() ? hit.distance == -1 : same_hit(hit, all[0])));
  hits += all.empty() ? 0 : 1;
}

/// The first difference of the scene from another, a line.
std::string difference(const Twins& twins, detent_handle other) {
  std::array<char, 200> text{};
  std::uint32_t size = 0;
  const auto status =
      detent_scene2_diff(&twins.context, twins.scene, other, 1, text.data(), text.size(), &size);
  REQUIRE(status == c::yes_or_no(size != 0));
  return {text.data(), size};
}

TEST_CASE("C scenes: histories give the bits of C++, in 2D") {
  test::Random random(8);
  Twins twins;
  auto* const context = &twins.context;
  const auto scene = twins.scene;
  std::vector<detent_id> ids;
  std::vector<std::byte> saved;
  int hits = 0, rays = 0;
  const auto place = [&] {
    const auto x = random.between(-12 * one, 12 * one);
    return at(x, random.between(-12 * one, 12 * one));
  };
  for (int i = 0; i < 400; ++i) {
    CAPTURE(i, random.seed());
    const auto where = place();
    const auto choice = random.below(12);
    if (choice < 4 || ids.empty()) {
      const detent_traits traits{random.next(),
                                 static_cast<std::uint32_t>(1 + random.below(7)),
                                 random.one_in(5) && i < 100 ? 1u : 0u,
                                 {}};
      const Traits own_traits{traits.layers, traits.user, static_cast<Motion>(traits.motion), {}};
      const detent_id chosen{static_cast<std::uint32_t>(1000 + random.below(20)), 3};
      const bool is_chosen = random.one_in(4);
      twins.with_shape(random.below(7), where, [&](const auto& theirs, const auto& own) {
        auto id = chosen;
        bool is_added = true;
        if (is_chosen) {
          is_added = twins.twin.add_as(id_of(id), own, own_traits);
          REQUIRE(detent_scene2_add_as(context, scene, id, &theirs, &traits) ==
                  c::yes_or_no(is_added));
        } else {
          REQUIRE(detent_scene2_add(context, scene, &theirs, &traits, &id) == DETENT_OK);
          REQUIRE(twins.twin.add(own, own_traits) == id_of(id));
        }
        if (is_added && traits.motion == DETENT_MOVING) ids.push_back(id);
      });
    } else {
      const auto which = random.below(ids.size());
      const detent_id id = ids[which];
      if (choice < 6) {
        twins.with_shape(random.below(7), where, [&](const auto& theirs, const auto& own) {
          REQUIRE(detent_scene2_replace(context, scene, id, &theirs) ==
                  c::yes_or_no(twins.twin.replace(id_of(id), own)));
        });
      } else if (choice < 8) {
        const detent_vec2 by = Out::vec(where);
        REQUIRE(detent_scene2_move(context, scene, id, &by) ==
                c::yes_or_no(twins.twin.move(id_of(id), where)));
      } else if (choice < 10) {
        const detent_traits traits{
            random.next(), static_cast<std::uint32_t>(random.below(8)), 0, {}};
        const bool is_there = twins.twin.set_layers(id_of(id), traits.layers) &&
                              twins.twin.set_user(id_of(id), traits.user);
        REQUIRE(detent_scene2_set_traits(context, scene, id, &traits) == c::yes_or_no(is_there));
        detent_traits read{};
        REQUIRE(detent_scene2_object(context, scene, id, nullptr, &read) == c::yes_or_no(is_there));
        if (is_there) REQUIRE((read.user == traits.user && read.layers == traits.layers));
      } else {
        REQUIRE(detent_scene2_remove(context, scene, id) ==
                c::yes_or_no(twins.twin.remove(id_of(id))));
        if (random.coin()) ids.erase(ids.begin() + static_cast<std::ptrdiff_t>(which));
      }
    }
    if (i % 50 == 20) REQUIRE(detent_scene2_optimize(context, scene) == DETENT_OK);
    twins.check_digest();
    if (i == 200) saved = twins.saved();

    if (const auto toward = normalize(place())) {
      check_ray(twins, Ray{place(), *toward, S(20)}, hits);
      ++rays;
    }
    detent_shape2 question{};
    question.kind = DETENT_POINT;
    question.as.point = Out::vec(where);
    check_question(twins, question, where);
    const Obb box{where, at(2 * one, one), Rotation<S, 2>()};
    Out::shape(question, box);
    check_question(twins, question, box);
    std::vector<detent_pair> pairs(4096);
    std::uint32_t count = 0;
    REQUIRE(detent_scene2_overlaps(context, scene, pairs.data(), 4096, &count) == DETENT_OK);
    check_lists(pairs, count, twins.twin.overlaps(), same_pair);
  }
  CHECK(hits * 10 > 3 * rays);
  CHECK(hits * 10 < 9 * rays);
  CHECK((twins.saved() == snapshot(twins.twin)));
  REQUIRE(c::status_of(restore(twins.twin, saved, twins.hulls)) == DETENT_OK);
  REQUIRE(detent_scene2_restore(context, scene, saved.data(),
                                static_cast<std::uint32_t>(saved.size())) == DETENT_OK);
  twins.check_digest();
  CHECK((twins.saved() == saved));
}

TEST_CASE("C scenes: frames move what is in them, and differences are named, in 2D") {
  Twins twins;
  auto* const context = &twins.context;
  const auto scene = twins.scene;
  const Transform<S, 2> first{at(3 * one, one), Rotation<S, 2>::from_angle(Angle<S>::turn(1, 8)),
                              S(1)},
      second{at(0, one), {}, S(2)};
  const auto outer = Out::transform(first), inner = Out::transform(second);
  detent_id frame{}, child{}, id{};
  REQUIRE(detent_scene2_add_frame(context, scene, &outer, {}, &frame) == DETENT_OK);
  REQUIRE(detent_scene2_add_frame(context, scene, &inner, frame, &child) == DETENT_OK);
  const auto own = *twins.twin.add_frame(first), own_child = *twins.twin.add_frame(second, own);
  for (std::uint64_t kind = 0; kind < 7; ++kind) {
    CAPTURE(kind);
    const detent_traits traits{kind, 1, DETENT_MOVING, child};
    twins.with_shape(kind, at(one, 0), [&](const detent_shape2& shape, const auto& same) {
      REQUIRE(detent_scene2_add(context, scene, &shape, &traits, &id) == DETENT_OK);
      REQUIRE(twins.twin.add(same, {1, kind, Motion::moving, own_child}) == id_of(id));
    });
  }
  twins.check_digest();
  REQUIRE(detent_scene2_move_frame(context, scene, frame, &inner) == DETENT_OK);
  REQUIRE(twins.twin.move_frame(own, second));
  twins.check_digest();
  detent_transform2 local{}, world{};
  REQUIRE(detent_scene2_frame(context, scene, child, &local, &world) == DETENT_OK);
  const auto found = *twins.twin.frame(own_child);
  CHECK(local.translation.y == found.local.translation[1].raw());
  CHECK(world.translation.y == found.world.translation[1].raw());
  CHECK(world.scale == found.world.scale.raw());
  CHECK(detent_scene2_remove_frame(context, scene, child) ==
        c::yes_or_no(twins.twin.remove_frame(own_child)));

  detent_handle other = 0;
  REQUIRE(detent_scene2_create(context, &other) == DETENT_OK);
  const auto saved = twins.saved();
  REQUIRE(detent_scene2_restore(context, other, saved.data(),
                                static_cast<std::uint32_t>(saved.size())) == DETENT_OK);
  CHECK(difference(twins, other).empty());
  const detent_traits changed{99, 1, DETENT_MOVING, {}};
  REQUIRE(detent_scene2_set_traits(context, other, id, &changed) == DETENT_OK);
  auto twin = twins.twin;
  REQUIRE(twin.set_user(id_of(id), 99));
  const auto named = detent::diff(twins.twin, twin);
  REQUIRE(named.has_value());
  const auto expected = std::string(named->field.view()) + "\n";
  CHECK(difference(twins, other) == expected);
  CHECK(expected.find("user") != std::string::npos);
  CHECK(detent_scene2_destroy(context, other) == DETENT_OK);
}

}  // namespace
}  // namespace detent
