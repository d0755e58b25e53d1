// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <type_traits>
#include <utility>

#include "calls.hpp"
#include "detent/query/cast.hpp"
#include "detent/query/closest_points.hpp"
#include "detent/query/contact.hpp"
#include "detent/query/time_of_impact.hpp"
#include "detent/scene/hull.hpp"
#include "detent/shape/compound.hpp"
#include "shapes.hpp"

// On the cases of `verify`, lists of shapes in the C interface give the bits of a C++ `Compound`,
// hulls those of a `PlacedHull`, and rays those of a `Ray`.

namespace detent::test_c {

using S = q16_16;
using c::Output;

/// A hull as an asset of a context, placed, and its points as transformed by C++.
template <int N>
struct TwinHull {
  std::array<Vec<S, N>, 8> points{};
  HullAsset<S, N> asset;
  PlacedHull<S, N> placed;
  typename c::Types<N>::Shape shape{};
  detail::HullPoints<S, N> moved{PlacedHull<S, N>()};

  TwinHull(detent_context& context, std::uint32_t id, const verify::HullPoints<S, N>& given,
           const Transform<S, N>& transform)
      : points(given.points) {
    const std::span<const Vec<S, N>> own(points.data(), static_cast<std::size_t>(given.count));
    asset = *hull_asset(id, ConvexHull<S, N>{own});
    placed = {&asset, transform};
    moved = detail::HullPoints<S, N>(placed);
    std::array<typename c::Types<N>::Vec, 8> raw{};
    for (std::size_t i = 0; i < own.size(); ++i) raw[i] = Output<N>::vec(own[i]);
    shape.kind = DETENT_HULL;
    shape.as.placed = Output<N>::transform(transform);
    REQUIRE(Calls<N>::hull_create(&context, id, raw.data(), static_cast<std::uint32_t>(own.size()),
                                  &shape.asset) == DETENT_OK);
  }
  TwinHull(const TwinHull&) = delete;
  TwinHull& operator=(const TwinHull&) = delete;
};

/// Compares the calls on one case with C++.
template <int N>
struct Case {
  using C = Calls<N>;
  using T = c::Types<N>;
  const detent_context* context;

  template <class Hit, class Expected>
  static void check_hit(const Hit& hit, const Expected& expected) {
    REQUIRE(hit.distance == expected.distance.raw());
    REQUIRE(c::Input<N>::vec(hit.point) == expected.point);
    REQUIRE(c::Input<N>().direction(hit.normal) == expected.normal);
  }

  void check_ray(const Ray<S, N>& ray, const Vec<S, N>& point) const {
    const auto along = in_c<N>(ray);
    const auto at = Output<N>::vec(point);
    typename T::Vec closest{};
    std::int32_t distance = 0;
    REQUIRE(C::ray_contains(&along, &at) == c::yes_or_no(detent::contains(ray, point)));
    REQUIRE(C::ray_closest_point(&along, &at, &closest) == DETENT_OK);
    REQUIRE(c::Input<N>::vec(closest) == detent::closest_point(ray, point));
    REQUIRE(C::ray_distance_to_point(&along, &at, &distance) == DETENT_OK);
    REQUIRE(distance == detent::distance(ray, point).raw());
  }

  /// One union with a ray and a point.
  template <class Union>
  void check_one(const Union& all, std::span<const typename T::Shape> list, const Ray<S, N>& ray,
                 const Vec<S, N>& point, Share& hits, Share& held) const {
    const auto count = static_cast<std::uint32_t>(list.size());
    const auto along = in_c<N>(ray);
    const auto at = Output<N>::vec(point);
    const auto expected = raycast_hit(ray, all);
    typename T::Hit hit{};
    REQUIRE(C::shapes_raycast(context, &along, list.data(), count, &hit) ==
            c::yes_or_no(expected.has_value()));
    REQUIRE(C::shapes_raycast(context, &along, list.data(), count, nullptr) ==
            c::yes_or_no(expected.has_value()));
    if (expected) check_hit(hit, *expected);
    hits.add(expected.has_value());
    const bool holds = detent::contains(all, point);
    REQUIRE(C::shapes_contains(context, list.data(), count, &at) == c::yes_or_no(holds));
    held.add(holds);
    typename T::Vec closest{};
    std::int32_t distance = 0;
    REQUIRE(C::shapes_closest_point(context, list.data(), count, &at, &closest) == DETENT_OK);
    REQUIRE(c::Input<N>::vec(closest) == detent::closest_point(all, point));
    REQUIRE(C::shapes_distance_to_point(context, list.data(), count, &at, &distance) == DETENT_OK);
    REQUIRE(distance == detent::distance(all, point).raw());
  }

  /// Two unions.
  template <class A, class B>
  void check_two(const A& a, std::span<const typename T::Shape> a_list, const B& b,
                 std::span<const typename T::Shape> b_list, Share& meetings) const {
    const auto a_count = static_cast<std::uint32_t>(a_list.size());
    const auto b_count = static_cast<std::uint32_t>(b_list.size());
    const bool do_meet = detent::overlaps(a, b);
    REQUIRE(C::shapes_overlaps(context, a_list.data(), a_count, b_list.data(), b_count) ==
            c::yes_or_no(do_meet));
    meetings.add(do_meet);
    std::int32_t between = 0;
    REQUIRE(C::shapes_distance(context, a_list.data(), a_count, b_list.data(), b_count, &between) ==
            DETENT_OK);
    REQUIRE(between == detent::distance(a, b).raw());
  }
  template <class A, class B>
  void check_closest(const A& a, std::span<const typename T::Shape> a_list, const B& b,
                     std::span<const typename T::Shape> b_list) const {
    const auto expected = detent::closest_points(a, b);
    typename T::Vec point_a{}, point_b{};
    REQUIRE(C::shapes_closest_points(
                context, a_list.data(), static_cast<std::uint32_t>(a_list.size()), b_list.data(),
                static_cast<std::uint32_t>(b_list.size()), &point_a, &point_b) == DETENT_OK);
    REQUIRE(c::Input<N>::vec(point_a) == expected.first);
    REQUIRE(c::Input<N>::vec(point_b) == expected.second);
  }

  /// A moving shape and a union.
  template <class A, class B>
  void check_cast(const A& a, const typename T::Shape& moving, const Ray<S, N>& way, const B& b,
                  std::span<const typename T::Shape> list, Share& hits) const {
    const auto along = Output<N>::direction(way.direction);
    const auto expected = detent::cast(a, way.direction, way.max_distance, b);
    typename T::Hit hit{};
    REQUIRE(C::shapes_cast(context, &moving, &along, way.max_distance.raw(), list.data(),
                           static_cast<std::uint32_t>(list.size()),
                           &hit) == c::yes_or_no(expected.has_value()));
    if (expected) check_hit(hit, *expected);
    hits.add(expected.has_value());
  }

  /// A contact and a time of impact of two shapes.
  template <class A, class B>
  void check_pair(const A& a, const typename T::Shape& first, const B& b,
                  const typename T::Shape& second, const Sweep<S, N>& sweep, Share& share) const {
    const auto expected = detent::contact(a, b);
    typename T::Manifold found{};
    REQUIRE(C::shapes_contact(context, &first, &second, &found) ==
            c::yes_or_no(expected.has_value()));
    if (expected) {
      REQUIRE(c::Input<N>().direction(found.normal) == expected->normal);
      REQUIRE(found.depth == expected->depth.raw());
      REQUIRE(found.count == expected->count);
      for (std::size_t i = 0; i < expected->count; ++i) {
        REQUIRE(c::Input<N>::vec(found.points[i].point) == expected->points[i].point);
        REQUIRE(found.points[i].feature == expected->points[i].feature);
      }
    }
    share.add(expected.has_value());
    const typename T::Sweep motion{Output<N>::vec(sweep.start), Output<N>::vec(sweep.end),
                                   Output<N>::rotation(sweep.start_rotation),
                                   Output<N>::rotation(sweep.end_rotation)};
    const auto meeting = detent::time_of_impact(a, sweep, b, S::from_raw(8));
    detent_impact impact{};
    REQUIRE(C::shapes_time_of_impact(context, &first, &motion, &second, nullptr, 8, &impact) ==
            c::yes_or_no(meeting.has_value()));
    if (!meeting) return;
    REQUIRE(impact.time == meeting->time.raw());
    REQUIRE(impact.distance == meeting->distance.raw());
    REQUIRE((impact.is_hit == 1) == meeting->is_hit);
  }
};

template <int N>
void check_unions(std::uint64_t seed, int count) {
  using T = c::Types<N>;
  verify::Random random(seed);
  Share hits, held, meetings, contacts;
  for (int i = 0; i < count; ++i) {
    CAPTURE(N, seed, i);
    detent_context memory{};
    REQUIRE(detent_open(&memory, nullptr) == DETENT_OK);
    const Case<N> with{&memory};
    verify::ShapeScene<S, N> scene(random);
    const auto ball = scene.sphere(), other_ball = scene.sphere();
    const auto box = scene.aabb();
    const auto turned = scene.obb();
    const auto corners = scene.hull();
    const Rotation<S, N> rotation = random.one_in(4) ? turned.rotation : Rotation<S, N>();
    const auto raw = [&](const S& x) { return S::from_raw(x.raw() % (4 * 65536)); };
    const auto step = make_vec<N>([&](int k) { return raw(turned.center[k]); });
    const TwinHull<N> hull(memory, 1, corners,
                           {random.one_in(3) ? step : Vec<S, N>(), rotation, S(1)});
    scene.turn();
    const auto far_ball = scene.sphere();
    const auto far_corners = scene.hull();
    const TwinHull<N> far_hull(memory, 2, far_corners, {});
    const auto ray = scene.aimed_ray();
    const auto point = scene.spot();

    const std::array balls{ball, other_ball};
    const std::array boxes{box};
    const std::array hulls{hull.moved.hull()}, far_hulls{far_hull.moved.hull()};
    const std::array far_balls{far_ball};
    const Compound whole(balls, boxes, hulls);
    const std::array<typename T::Shape, 4> list{in_c<N>(ball), in_c<N>(other_ball), in_c<N>(box),
                                                hull.shape};
    const Compound ends(far_balls, far_hulls);
    const std::array<typename T::Shape, 2> far_list{in_c<N>(far_ball), far_hull.shape};
    const std::span<const typename T::Shape> all(list), none;

    with.check_ray(ray, point);
    with.check_one(whole, all, ray, point, hits, held);
    with.check_one(Compound<Sphere<S, N>>(), none, ray, point, hits, held);
    with.check_one(hulls[0], all.subspan(3), ray, point, hits, held);
    with.check_two(whole, all, ends, far_list, meetings);
    with.check_two(ends, far_list, Compound<Sphere<S, N>>(), none, meetings);
    // What takes long to compile is compared in one dimension only; the other has the same code.
    if constexpr (N == 2) {
      with.check_closest(Compound(balls, hulls), std::array{list[0], list[1], list[3]}, ends,
                         far_list);
      with.check_cast(hulls[0], list[3], ray, ends, far_list, hits);
    } else {
      const Sweep<S, N> sweep{{}, step, {}, turned.rotation};
      with.check_pair(hulls[0], list[3], far_ball, far_list[0], sweep, contacts);
      with.check_pair(ball, list[0], far_hulls[0], far_list[1], sweep, contacts);
    }
    REQUIRE(detent_close(&memory) == DETENT_OK);
  }
  for (const auto& share : {hits, held, meetings}) share.check();
  if constexpr (N == 3) contacts.check();
}

}  // namespace detent::test_c
