// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <type_traits>

#include "c/movers.hpp"
#include "calls.hpp"
#include "numbers.hpp"
#include "support/catch.hpp"
#include "support/random.hpp"

// Characters and casts in scenes: the C interface gives the bits of C++.

namespace detent::test_c {

/// Casts a shape through the scene: the first object, any, and all.
template <int N, class Shape>
bool check_cast(const detent_context& context, detent_handle scene,
                const typename c::SceneOf<N>::type& twin, const typename c::Types<N>::Shape& shape,
                const Shape& own, const Direction<S, N>& along) {
  using C = Calls<N>;
  using Hit = typename c::Types<N>::ObjectHit;
  const auto way = c::Output<N>::direction(along);
  const Cast moving{own, along, S(5)};
  const auto same = [](const Hit& hit, const ObjectHit<S, N>& expected) {
    REQUIRE(id_of(hit.id) == expected.id);
    REQUIRE(hit.distance == expected.distance.raw());
    REQUIRE(c::Input<N>::vec(hit.point) == expected.point);
    REQUIRE(c::Input<N>().direction(hit.normal) == expected.normal);
  };
  Hit hit{};
  const auto first = twin.nearest_hit(moving, InLayers{2});
  REQUIRE(C::scene_cast(&context, scene, &shape, &way, 5 * one, 2, &hit) ==
          c::yes_or_no(first.has_value()));
  if (first) same(hit, *first);
  REQUIRE(C::scene_cast_any(&context, scene, &shape, &way, 5 * one, 2) ==
          c::yes_or_no(first.has_value()));
  std::array<Hit, 3> hits{};
  std::array<ObjectHit<S, N>, 3> expected{};
  std::uint32_t count = 0;
  const auto all = twin.all_hits(moving, std::span(expected), InLayers{3});
  REQUIRE(C::scene_cast_all(&context, scene, &shape, &way, 5 * one, 3, hits.data(), 3, &count) ==
          DETENT_OK);
  REQUIRE(count == all);
  for (std::size_t i = 0; i < all && i < 3; ++i) same(hits[i], expected[i]);
  return first.has_value();
}

/// Walks over a floor with boxes, balls and a platform, with casts at each step.
template <int N, template <class, int> class Shape>
void check_walk(const Shape<S, N>& walker) {
  using C = Calls<N>;
  using T = c::Types<N>;
  using In = c::Input<N>;
  using Out = c::Output<N>;
  test::Random random(60 + N);
  detent_context context{};
  detent_handle scene = 0;
  REQUIRE(detent_open(&context, nullptr) == DETENT_OK);
  REQUIRE(C::scene_create(&context, &scene) == DETENT_OK);
  typename c::SceneOf<N>::type twin;
  const auto vec = [](const auto& f) { return make_vec<N>([&](int i) { return raw(f(i)); }); };

  const Transform<S, N> still{vec([](int i) { return i == 0 ? one : 0; }), {}, S(1)};
  const auto placed = Out::transform(still);
  detent_id frame{};
  REQUIRE(C::scene_add_frame(&context, scene, &placed, {}, &frame) == DETENT_OK);
  const auto own_frame = *twin.add_frame(still);
  const auto add = [&](const auto& shape, std::uint32_t layers, bool on_frame) {
    typename T::Shape given{};
    Out::shape(given, shape);
    const detent_traits traits{0, layers, DETENT_MOVING, on_frame ? frame : detent_id{}};
    detent_id id{};
    REQUIRE(C::scene_add(&context, scene, &given, &traits, &id) == DETENT_OK);
    REQUIRE(twin.add(shape, {layers, 0, Motion::moving, on_frame ? own_frame : FrameId{}}) ==
            id_of(id));
    return id;
  };
  add(Aabb{vec([](int i) { return i == 1 ? -one : -20 * one; }),
           vec([](int i) { return i == 1 ? 0 : 20 * one; })},
      1, false);
  add(Aabb{vec([](int i) { return i == 1 ? 0 : -4 * one; }),
           vec([](int i) { return i == 1 ? one / 4 : 4 * one; })},
      1, true);
  for (int i = 0; i < 12; ++i) {
    const auto at = vec(
        [&](int k) { return k == 1 ? 0 : static_cast<int>(random.between(-8 * one, 8 * one)); });
    add(Sphere{at, raw(one / 2)}, random.one_in(3) ? 2u : 1u, false);
  }
  const auto self =
      add(Sphere{vec([](int i) { return i == 1 ? one : 0; }), raw(one / 2)}, 1, false);

  Mover<S, N, Shape> own{walker};
  typename T::Mover mover{};
  Out::shape(mover.shape, own.shape);
  typename T::MoverSettings settings{};
  REQUIRE(C::mover_default_settings(&settings) == DETENT_OK);
  MoverSettings<S, N> own_settings;
  const auto not_itself = [&](const ObjectInfo& info) {
    return (info.layers & 1) != 0 && !(info.id == id_of(self));
  };
  int touches = 0, grounded = 0, carried = 0, hits = 0;
  for (int step = 0; step < 200; ++step) {
    CAPTURE(N, step);
    if (step == 100) {
      settings.step_height = 0;
      own_settings.step_height = S(0);
    }
    const Transform<S, N> moved{
        vec([&](int i) { return i == 0 ? one + step % 20 * (one / 32) : 0; }), {}, S(1)};
    const auto to = Out::transform(moved);
    REQUIRE(C::scene_move_frame(&context, scene, frame, &to) == DETENT_OK);
    REQUIRE(twin.move_frame(own_frame, moved));
    const auto by = vec([&](int i) {
      return i == 1 ? -one / 8
                    : static_cast<int>(random.between(-one / 2, one / 2)) + (i == 0 ? one / 6 : 0);
    });
    const auto theirs = Out::vec(by);
    typename T::Move result{};
    const auto expected = own.move(twin, by, own_settings, not_itself);
    REQUIRE(C::mover_move(&context, scene, &mover, &theirs, step < 50 ? nullptr : &settings, 1,
                          self, &result) == DETENT_OK);
    if constexpr (std::is_same_v<Shape<S, N>, Capsule<S, N>>) {
      REQUIRE(In().capsule(mover.shape) == own.shape);
    } else {
      REQUIRE(In().aabb(mover.shape) == own.shape);
    }
    REQUIRE((mover.is_grounded == 1) == own.ground.is_grounded);
    REQUIRE(id_of(mover.object) == own.ground.object);
    REQUIRE(In().direction(mover.normal) == own.ground.normal);
    REQUIRE(In::vec(mover.local) == own.ground.local);
    REQUIRE(In::vec(mover.point) == own.ground.point);
    REQUIRE(In::vec(result.moved) == expected.moved);
    REQUIRE(In::vec(result.carried) == expected.carried);
    REQUIRE(In::vec(result.pushed) == expected.pushed);
    REQUIRE(result.count == expected.count);
    REQUIRE((result.is_stuck == 1) == expected.is_stuck);
    for (std::size_t i = 0; i < expected.count; ++i) {
      REQUIRE(id_of(result.touched[i].object) == expected.touched[i].object);
      REQUIRE(In::vec(result.touched[i].point) == expected.touched[i].point);
      REQUIRE(In().direction(result.touched[i].normal) == expected.touched[i].normal);
    }
    typename T::Vec clipped{};
    REQUIRE(C::mover_clip_velocity(&theirs, &result, &clipped) == DETENT_OK);
    REQUIRE(In::vec(clipped) == clip_velocity(by, expected));
    touches += expected.count != 0 ? 1 : 0;
    grounded += own.ground.is_grounded ? 1 : 0;
    carried += expected.carried == Vec<S, N>{} ? 0 : 1;

    const auto axis = static_cast<int>(random.below(N));
    const auto along = random.coin() ? Direction<S, N>::along(axis) : -Direction<S, N>::along(axis);
    const bool is_hit = check_cast<N>(context, scene, twin, mover.shape, own.shape, along);
    hits += is_hit ? 1 : 0;
    if constexpr (std::is_same_v<Shape<S, N>, Aabb<S, N>>) {
      const auto& box = own.shape;
      const auto middle = [&](int i) { return nearest_to<S>(half(box.min[i] + box.max[i])); };
      const Obb<S, N> turned{make_vec<N>(middle), make_vec<N>([](int) { return raw(one / 2); }),
                             Rotation<S, N>()};
      typename T::Shape given{};
      Out::shape(given, turned);
      check_cast<N>(context, scene, twin, given, turned, along);
    }
  }
  CHECK(touches > 20);
  CHECK(grounded > 20);
  CHECK(hits > 5);
  CHECK(carried > 0);
  CHECK(detent_close(&context) == DETENT_OK);
}

template <int N>
Capsule<S, N> person() {
  return {make_vec<N>([](int i) { return raw(i == 1 ? one : 0); }),
          make_vec<N>([](int i) { return raw(i == 1 ? 2 * one : 0); }), raw(one / 2)};
}
template <int N>
Aabb<S, N> crate() {
  return {make_vec<N>([](int i) { return raw(i == 1 ? one / 2 : -one / 2); }),
          make_vec<N>([](int i) { return raw(i == 1 ? 2 * one : one / 2); })};
}

}  // namespace detent::test_c
