// SPDX-License-Identifier: MIT
//
// Cameras and frusta of the C interface give the bits of C++, with cameras that look at the shapes
// of `verify`, singly and in a scene.

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <tuple>
#include <type_traits>

#include "c/scenes.hpp"
#include "detent/math/projection.hpp"
#include "detent/shape/camera.hpp"
#include "shapes.hpp"

namespace detent {
namespace {

using S = q16_16;
using In = c::Input<3>;
using Out = c::Output<3>;
constexpr int one = 65536;

/// A camera in C and in C++.
struct TwinCamera {
  detent_camera3 raw{};
  Camera<S> own;

  TwinCamera(const Transform<S, 3>& pose, const Lens<S>& lens) : own{pose, lens} {}
};

/// A camera near `spot` that looks at it or past it, if possible.
std::optional<TwinCamera> camera_at(const Vec<S, 3>& spot, verify::Random& random) {
  const auto step = [&](std::int32_t most) {
    return make_vec<3>(
        [&](int) { return S::from_raw(static_cast<std::int32_t>(random.between(-most, most))); });
  };
  const auto target = nearest_to<S>(spot + step(2 * one));
  const auto eye = nearest_to<S>(spot + step(4 * one));
  const Vec<S, 3> up{S(0), S(1), S(0)};
  const auto pose = look_at(eye, target, up);
  detent_transform3 given{};
  const auto eye_in_c = Out::vec(eye), target_in_c = Out::vec(target), up_in_c = Out::vec(up);
  REQUIRE(detent_camera3_look_at(&eye_in_c, &target_in_c, &up_in_c, &given) ==
          c::yes_or_no(pose.has_value()));
  if (!pose) return std::nullopt;
  REQUIRE(In().transform(given) == *pose);
  const bool has_perspective = random.coin();
  const auto low = S::from_raw(one / 8), high = S(8);
  const auto fov = static_cast<std::uint32_t>(random.between(1 << 26, 1 << 30));
  const auto wide = S::from_raw(static_cast<std::int32_t>(random.between(one / 2, 2 * one)));
  const auto lens = has_perspective ? Lens<S>::perspective(Angle<S>::from_raw(fov), wide, low, high)
                                    : Lens<S>::orthographic(wide, S(2), low, high);
  REQUIRE(lens.has_value());
  TwinCamera camera(*pose, *lens);
  camera.raw.pose = given;
  camera.raw.has_perspective = has_perspective ? 1 : 0;
  camera.raw.fov = fov;
  camera.raw.aspect = camera.raw.half_width = wide.raw();
  camera.raw.half_height = 2 * one;
  camera.raw.near_distance = low.raw();
  camera.raw.far_distance = high.raw();
  return camera;
}

void check_screen(const TwinCamera& camera, const Vec<S, 3>& point, verify::Random& random) {
  const Viewport view{static_cast<int>(random.between(0, 2000)), 1080};
  const auto column = static_cast<int>(random.between(-9, 2000));
  const auto row = static_cast<int>(random.between(-9, 2000));
  const auto ray = pick_ray(camera.own, view, column, row);
  detent_ray3 picked{};
  REQUIRE(detent_camera3_pick_ray(&camera.raw, view.width, view.height, column, row, &picked) ==
          DETENT_OK);
  REQUIRE(In().ray(picked) == ray);
  const auto seen = project(camera.own, view, point);
  const auto at = Out::vec(point);
  detent_screen_point3 pixel{};
  REQUIRE(detent_camera3_project(&camera.raw, view.width, view.height, &at, &pixel) ==
          c::yes_or_no(seen.has_value()));
  if (seen) {
    REQUIRE(pixel.x == seen->x.raw());
    REQUIRE(pixel.y == seen->y.raw());
    REQUIRE(pixel.depth == seen->depth.raw());
  }
  detent_vec3 back{};
  REQUIRE(detent_camera3_unproject(&camera.raw, view.width, view.height, column, row, 3 * one,
                                   &back) == DETENT_OK);
  REQUIRE(In::vec(back) == unproject(camera.own, view, column, row, S(3)));
}

template <class Shape>
bool meets(const Frustum<S>& frustum, const Shape& shape) {
  if constexpr (std::is_same_v<Shape, Segment<S, 3>>) {
    return intersects(shape, frustum);
  } else {
    return overlaps(frustum, shape);
  }
}

TEST_CASE("C frusta: cameras, frusta and scenes give the bits of C++") {
  verify::Random random(33);
  detent_context context{};
  REQUIRE(detent_open(&context, nullptr) == DETENT_OK);
  Share hits, held, meetings, found_any;
  for (int i = 0; i < 300; ++i) {
    CAPTURE(i);
    Draw<3> draw{verify::ShapeScene<S, 3>(random)};
    const auto shapes = draw.all();
    const auto point = draw.scene.spot();
    const auto ray = draw.scene.aimed_ray();
    const auto camera = camera_at(point, random);
    if (!camera) continue;
    check_screen(*camera, point, random);

    const Frustum<S> own(camera->own);
    detent_frustum3 frustum{};
    REQUIRE(detent_camera3_frustum(&camera->raw, &frustum) == DETENT_OK);
    for (std::size_t k = 0; k < 8; ++k) {
      REQUIRE(In::vec(frustum.corners[k]) == own.corners()[k]);
    }
    const auto along = in_c<3>(ray);
    const auto expected = raycast_hit(ray, own);
    detent_hit3 hit{};
    REQUIRE(detent_frustum3_raycast(&along, &frustum, &hit) == c::yes_or_no(expected.has_value()));
    if (expected) {
      REQUIRE(hit.distance == expected->distance.raw());
      REQUIRE(In::vec(hit.point) == expected->point);
      REQUIRE(In().direction(hit.normal) == expected->normal);
    }
    hits.add(expected.has_value());
    const auto near_by = std::get<0>(shapes).center;
    const auto near_by_in_c = Out::vec(near_by);
    const bool holds = contains(own, near_by);
    REQUIRE(detent_frustum3_contains(&frustum, &near_by_in_c) == c::yes_or_no(holds));
    held.add(holds);
    detent_vec3 closest{};
    std::int32_t distance_in_c = 0;
    REQUIRE(detent_frustum3_closest_point(&frustum, &near_by_in_c, &closest) == DETENT_OK);
    REQUIRE(In::vec(closest) == closest_point(own, near_by));
    REQUIRE(detent_frustum3_distance_to_point(&frustum, &near_by_in_c, &distance_in_c) ==
            DETENT_OK);
    REQUIRE(distance_in_c == distance(own, near_by).raw());
    const Frustum<S> other({camera->own.pose, *Lens<S>::orthographic(S(1), S(1), S(-4), S(-1))});
    detent_frustum3 behind{};
    for (std::size_t k = 0; k < 8; ++k) behind.corners[k] = Out::vec(other.corners()[k]);
    REQUIRE(detent_frustum3_overlaps_frustum(&frustum, &behind) ==
            c::yes_or_no(overlaps(own, other)));

    detent_handle scene = 0;
    REQUIRE(detent_scene3_create(&context, &scene) == DETENT_OK);
    c::SceneOf<3>::type twin;
    std::apply(
        [&](const auto&... shape) {
          const auto check = [&](const auto& own_shape) {
            const auto raw = in_c<3>(own_shape);
            const bool do_meet = meets(own, own_shape);
            REQUIRE(detent_frustum3_overlaps(nullptr, &frustum, &raw, 1) == c::yes_or_no(do_meet));
            meetings.add(do_meet);
            if constexpr (!std::is_same_v<std::remove_cvref_t<decltype(own_shape)>,
                                          Segment<S, 3>>) {
              detent_id id{};
              REQUIRE(detent_scene3_add(&context, scene, &raw, nullptr, &id) == DETENT_OK);
              REQUIRE(twin.add(own_shape) == c::id_of(id));
            }
          };
          (check(shape), ...);
        },
        shapes);
    const auto first = twin.nearest(own, InLayers{1});
    detent_found found{};
    REQUIRE(detent_scene3_frustum_nearest(&context, scene, &frustum, 1, &found) ==
            c::yes_or_no(first.has_value()));
    if (first)
      REQUIRE((c::id_of(found.id) == first->id && found.distance == first->distance.raw()));
    REQUIRE(detent_scene3_frustum_any(&context, scene, &frustum, 1) ==
            c::yes_or_no(first.has_value()));
    REQUIRE(detent_scene3_frustum_any(&context, scene, &frustum, 2) == DETENT_NO);
    std::array<detent_found, 4> list{};
    std::array<Found<S>, 4> expected_list{};
    std::uint32_t count = 0;
    const auto all = twin.all(own, std::span(expected_list), InLayers{1});
    REQUIRE(detent_scene3_frustum_all(&context, scene, &frustum, 1, list.data(), 4, &count) ==
            DETENT_OK);
    REQUIRE(count == all);
    for (std::size_t k = 0; k < all && k < 4; ++k) {
      REQUIRE(c::id_of(list[k].id) == expected_list[k].id);
      REQUIRE(list[k].distance == expected_list[k].distance.raw());
    }
    found_any.add(all > 3);
    REQUIRE(detent_scene3_destroy(&context, scene) == DETENT_OK);
  }
  for (const auto& share : {hits, held, meetings, found_any}) share.check();
  REQUIRE(detent_close(&context) == DETENT_OK);
}

TEST_CASE("C frusta: null, wrong and stale arguments are errors") {
  detent_context context{};
  detent_handle scene = 0, hull = 0;
  const detent_vec3 zero{}, up{0, one, 0}, corners[4] = {zero, {one, 0, 0}, up, {0, 0, one}};
  REQUIRE(detent_open(&context, nullptr) == DETENT_OK);
  REQUIRE(detent_scene3_create(&context, &scene) == DETENT_OK);
  REQUIRE(detent_hull3_create(&context, 1, corners, 4, &hull) == DETENT_OK);
  detent_camera3 camera{};
  detent_frustum3 frustum{};
  detent_ray3 ray{};
  detent_screen_point3 seen{};
  detent_vec3 point{};
  CHECK(detent_camera3_look_at(&zero, &zero, &up, &camera.pose) == DETENT_NO);
  CHECK(detent_camera3_frustum(&camera, &frustum) == DETENT_NOT_UNIT);
  REQUIRE(detent_camera3_look_at(&corners[3], &zero, &up, &camera.pose) == DETENT_OK);
  CHECK(detent_camera3_frustum(&camera, &frustum) == DETENT_BAD_ARGUMENT);
  camera.half_width = camera.half_height = camera.far_distance = one;
  CHECK(detent_camera3_frustum(&camera, &frustum) == DETENT_OK);
  camera.has_perspective = 1;
  CHECK(detent_camera3_pick_ray(&camera, 9, 9, 0, 0, &ray) == DETENT_BAD_ARGUMENT);
  camera.has_perspective = 2;
  CHECK(detent_camera3_frustum(&camera, &frustum) == DETENT_BAD_ARGUMENT);
  camera.has_perspective = 0;
  CHECK(detent_camera3_frustum(nullptr, &frustum) == DETENT_BAD_ARGUMENT);
  CHECK(detent_camera3_frustum(&camera, nullptr) == DETENT_BAD_ARGUMENT);
  CHECK(detent_camera3_project(&camera, 9, 9, nullptr, &seen) == DETENT_BAD_ARGUMENT);
  CHECK(detent_camera3_project(&camera, 9, 9, &zero, nullptr) == DETENT_BAD_ARGUMENT);
  CHECK(detent_camera3_unproject(&camera, 9, 9, 0, 0, 0, nullptr) == DETENT_BAD_ARGUMENT);
  CHECK(detent_camera3_look_at(&zero, nullptr, &up, &camera.pose) == DETENT_BAD_ARGUMENT);

  std::int32_t distance = 0;
  std::uint32_t count = 0;
  CHECK(detent_frustum3_contains(nullptr, &zero) == DETENT_BAD_ARGUMENT);
  CHECK(detent_frustum3_contains(&frustum, &zero) == DETENT_OK);
  CHECK(detent_frustum3_closest_point(&frustum, &zero, nullptr) == DETENT_BAD_ARGUMENT);
  CHECK(detent_frustum3_closest_point(&frustum, &zero, &point) == DETENT_OK);
  CHECK(detent_frustum3_distance_to_point(&frustum, nullptr, &distance) == DETENT_BAD_ARGUMENT);
  CHECK(detent_frustum3_overlaps_frustum(&frustum, nullptr) == DETENT_BAD_ARGUMENT);
  CHECK(detent_frustum3_overlaps_frustum(&frustum, &frustum) == DETENT_OK);
  CHECK(detent_frustum3_raycast(&ray, &frustum, nullptr) == DETENT_NOT_UNIT);
  detent_shape3 shape{};
  shape.kind = DETENT_HULL;
  shape.asset = hull;
  shape.as.placed = camera.pose;
  CHECK(detent_frustum3_overlaps(&context, &frustum, &shape, 1) == DETENT_OK);
  CHECK(detent_frustum3_overlaps(&context, &frustum, nullptr, 1) == DETENT_BAD_ARGUMENT);
  CHECK(detent_frustum3_overlaps(&context, nullptr, &shape, 1) == DETENT_BAD_ARGUMENT);
  CHECK(detent_frustum3_overlaps(nullptr, &frustum, &shape, 1) == DETENT_BAD_CONTEXT);
  shape.asset = scene;
  CHECK(detent_frustum3_overlaps(&context, &frustum, &shape, 1) == DETENT_BAD_HANDLE);
  shape.kind = DETENT_COMPOUND;
  CHECK(detent_frustum3_overlaps(&context, &frustum, &shape, 1) == DETENT_NO_QUERY);

  CHECK(detent_scene3_frustum_any(&context, scene, nullptr, 1) == DETENT_BAD_ARGUMENT);
  CHECK(detent_scene3_frustum_all(&context, scene, &frustum, 1, nullptr, 1, &count) ==
        DETENT_BAD_ARGUMENT);
  for (const detent_handle wrong : {detent_handle{0}, hull, scene + (1u << 17)}) {
    CHECK(detent_scene3_frustum_any(&context, wrong, &frustum, 1) == DETENT_BAD_HANDLE);
    CHECK(detent_scene3_frustum_nearest(&context, wrong, &frustum, 1, nullptr) ==
          DETENT_BAD_HANDLE);
  }
  REQUIRE(detent_scene3_destroy(&context, scene) == DETENT_OK);
  CHECK(detent_scene3_frustum_all(&context, scene, &frustum, 1, nullptr, 0, &count) ==
        DETENT_BAD_HANDLE);
  CHECK(detent_scene3_frustum_any(nullptr, scene, &frustum, 1) == DETENT_BAD_CONTEXT);
  REQUIRE(detent_close(&context) == DETENT_OK);
  CHECK(detent_scene3_frustum_any(&context, scene, &frustum, 1) == DETENT_BAD_CONTEXT);
}

}  // namespace
}  // namespace detent
