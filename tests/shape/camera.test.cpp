// SPDX-License-Identifier: MIT
#include "detent/shape/camera.hpp"

#include <array>
#include <cstddef>
#include <cstdint>

#include "detent/number/digest.hpp"
#include "detent/shape/frustum.hpp"
#include "math/decimals.hpp"
#include "math/frames.hpp"
#include "math/matrices.hpp"

using namespace detent;
using namespace detent::test;

namespace {

using S = q16_16;
using V = Vec<S, 3>;
using D = Direction<S, 3>;
using A = Angle<S>;

// At (0, 0, 10), looking along -z; half the width equals the depth, half the height half of it.
constexpr Camera camera{*look_at(v3(0, 0, 10), V{}, v3(0, 1, 0)),
                        *Lens<S>::perspective(A::turn(1, 4), n(1), n(1), n(100))};
static_assert(project(camera, v3(0, 0, 0)) == ScreenPoint<S, S>{n(0), n(0), n(10)}, "middle");
static_assert(project(camera, v3(10, -5, 0)) == ScreenPoint<S, S>{n(1), n(-0.5), n(10)});
static_assert(project(camera, v3(20, 0, 9)) == ScreenPoint<S, S>{n(20), n(0), n(1)}, "outside");
static_assert(project(camera, v3(0, 0, -190))->depth == 200, "beyond far");
static_assert(!project(camera, v3(0, 0, 10)) && !project(camera, v3(1, 0, 10)), "beside the eye");
static_assert(!project(camera, v3(0, 0, 11)), "behind");
static_assert(unproject(camera, n(1), n(-0.5), n(10)) == v3(10, -5, 0));
static_assert(unproject(camera, n(0), n(0), n(-1)) == v3(0, 0, 11));
static_assert(pick_ray(camera, n(0), n(0)) == Ray{v3(0, 0, 10), -D::along(2)});
static_assert(pick_ray(camera, n(0.75), n(0)).direction == *normalize(v3(3, 0, -4)));
static_assert(pick_ray(camera, n(1), n(1)).direction == *normalize(v3(1, 1, -1)), "the corner");

constexpr Viewport screen{4, 2};
static_assert(project(camera, screen, V{}) == ScreenPoint<S, S>{n(2), n(1), n(10)});
static_assert(project(camera, screen, v3(-10, 10, 0)) == ScreenPoint<S, S>{n(0), n(0), n(10)},
              "the top left corner");
static_assert(project(camera, screen, v3(10, -10, 0)) == ScreenPoint<S, S>{n(4), n(2), n(10)});
static_assert(unproject(camera, screen, 0, 0, n(4)) == v3(-3, 2, 6), "the middle of a pixel");
static_assert(unproject(camera, screen, 3, 1, n(4)) == v3(3, -2, 6));
static_assert(pick_ray(camera, screen, 0, 0).direction == *normalize(v3(-3, 2, -4)));
static_assert(pick_ray(camera, Viewport{1, 1}, 0, 0) == pick_ray(camera, n(0), n(0)));
static_assert(pick_ray(camera, Viewport{0, 3}, 7, 7) == pick_ray(camera, n(0), n(0)), "no pixel");
static_assert(unproject(camera, Viewport{-1, 1}, 7, 7, n(10)) == V{});

// Orthographic: 8 wide, 4 high, from 1 behind to 3 in front of (0, 0, 10).
constexpr Camera flat{*look_at(v3(0, 0, 10), V{}, v3(0, 1, 0)),
                      *Lens<S>::orthographic(n(4), n(2), n(-1), n(3))};
static_assert(project(flat, v3(2, 1, 12)) == ScreenPoint<S, S>{n(0.5), n(0.5), n(-2)});
static_assert(unproject(flat, n(0.5), n(0.5), n(-2)) == v3(2, 1, 12));
static_assert(pick_ray(flat, n(-1), n(1)) == Ray{v3(-4, 2, 11), -D::along(2)}, "the near plane");
static_assert(pick_ray(flat, screen, 0, 0) == Ray{v3(-3, 1, 11), -D::along(2)});

// Coplanar axes see nothing; a mirrored frame sees a mirrored image.
constexpr Camera broken{
    Transform<S, 3>{V{}, Rotation<S, 3>::from_axes({D(), D(), D::along(2)}), n(1)}, camera.lens};
static_assert(!project(broken, v3(0, 0, -5)));
constexpr Camera mirrored{
    Transform<S, 3>{V{}, Rotation<S, 3>::from_axes({-D(), D::along(1), D::along(2)}), n(1)},
    camera.lens};
static_assert(project(mirrored, v3(5, 0, -5))->x == -1);
constexpr Camera nowhere{Transform<S, 3>{V{}, Rotation<S, 3>::from_axes({D(), D(), D()}), n(1)},
                         camera.lens};
static_assert(pick_ray(nowhere, n(1), n(0)).direction == -D(), "x - x is no direction");

template <class T>
BigRational exact(const T& x) {
  return rational(x);
}
using Exact = std::array<BigRational, 3>;

template <Scalar T>
bool is_nearest(T found, const BigRational& x) {
  return big_raw(found) == clamped<T>(nearest_of(on_grid<T>(x)));
}
template <Scalar T>
bool is_nearest(const Vec<T, 3>& found, const Exact& x) {
  return is_nearest(found.x, x[0]) && is_nearest(found.y, x[1]) && is_nearest(found.z, x[2]);
}

/// The frame of a camera as a matrix, and its half sizes at a depth.
template <Scalar T>
struct Model {
  explicit Model(const Camera<T>& of) : camera(of) {
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) {
        frame[i][j] = exact(of.pose.rotation.axis(static_cast<int>(j))[static_cast<int>(i)]);
      }
      eye[i] = exact(of.pose.translation[static_cast<int>(i)]);
    }
  }
  [[nodiscard]] BigRational half_size(int i, const BigRational& depth) const {
    return exact(camera.lens.slope(i)) * depth + exact(camera.lens.extent(i));
  }
  /// From the eye to a point of the screen at a depth.
  [[nodiscard]] Exact offset(const BigRational& x, const BigRational& y,
                             const BigRational& depth) const {
    Exact result;
    for (std::size_t i = 0; i < 3; ++i) {
      result[i] = x * half_size(0, depth) * frame[i][0] + y * half_size(1, depth) * frame[i][1] -
                  depth * frame[i][2];
    }
    return result;
  }
  [[nodiscard]] Exact at(const BigRational& x, const BigRational& y,
                         const BigRational& depth) const {
    auto result = offset(x, y, depth);
    for (std::size_t i = 0; i < 3; ++i) result[i] += eye[i];
    return result;
  }

  Camera<T> camera;
  Rationals<3> frame;
  Exact eye;
};

/// Whether `ray` goes through the screen points at x and y.
template <Scalar T>
bool is_pick_ray(const Model<T>& model, const Ray<T, 3>& ray, const BigRational& x,
                 const BigRational& y) {
  if (ray.max_distance != largest<T>) return false;
  if (!model.camera.lens.has_perspective()) {
    const auto start = model.at(x, y, exact(model.camera.lens.near_distance()));
    return is_nearest(ray.origin, start) && ray.direction == -model.camera.pose.rotation.axis(2);
  }
  const auto toward = model.offset(x, y, 1);
  BigInteger under = 1;
  for (const auto& c : toward) under *= denominator(c);
  std::array<BigInteger, 3> whole;
  for (std::size_t i = 0; i < 3; ++i) {
    whole[i] = numerator(BigRational(toward[i] * BigRational(under)));
  }
  return ray.origin == model.camera.pose.translation && is_direction_of(ray.direction, whole);
}

template <Scalar T>
std::optional<Camera<T>> random_camera(Random& random) {
  const auto positive = [&] { return nearest_to<T>(abs(random_fixed<T>(random))); };
  const Transform<T, 3> pose{
      random_vec<T, 3>(random),
      random.one_in(3) ? random_frame<T, 3>(random) : random_rotation<T, 3>(random),
      random_fixed<T>(random)};
  const auto near = random.one_in(3) ? random_fixed<T>(random) : T::from_raw(1);
  const bool has_perspective = !random.one_in(3);
  const auto far_distance = positive();
  const auto aspect_or_half_height =
      has_perspective ? T(static_cast<int>(random.between(1, T::bits - T::frac > 1 ? 2 : 1)))
                      : positive();
  const auto lens =
      has_perspective
          ? Lens<T>::perspective(
                Angle<T>::from_raw(static_cast<std::uint32_t>(random.between(1 << 20, 1 << 30))),
                aspect_or_half_height, near, far_distance)
          : Lens<T>::orthographic(positive(), aspect_or_half_height, near, far_distance);
  if (!lens) return std::nullopt;
  return Camera<T>{pose, *lens};
}

}  // namespace

TEMPLATE_TEST_CASE("camera: points, pixels, rays and corners follow its formulas, rounded once", "",
                   q16_16, q14_16, q24_8, q8_8, (Fixed<5, 2>), (Fixed<1, 0>)) {
  using T = TestType;
  Random random(0xca3e4a);
  int wrong = 0, cameras = 0, seen = 0, unseen = 0;
  for (int k = 0; k < 1'500; ++k) {
    const auto drawn = random_camera<T>(random);
    if (!drawn) continue;
    ++cameras;
    const Model<T> model(*drawn);
    const auto& lens = drawn->lens;
    const auto x = random_fixed<T>(random), y = random_fixed<T>(random),
               depth = random_fixed<T>(random);
    if (!is_nearest(unproject(*drawn, x, y, depth), model.at(exact(x), exact(y), exact(depth)))) {
      ++wrong;
    }
    if (!is_pick_ray(model, pick_ray(*drawn, x, y), exact(x), exact(y))) ++wrong;

    const Viewport viewport{static_cast<std::int32_t>(random.between(1, 5'000)),
                            static_cast<std::int32_t>(random.between(1, 1 << 24) - 1 + k % 2)};
    const auto column = static_cast<std::int32_t>(random.edgy(24)),
               row = static_cast<std::int32_t>(random.between(0, viewport.height));
    const BigRational across = BigRational(2 * std::int64_t{column} + 1, viewport.width) - 1;
    if (viewport.height > 0) {
      const BigRational upward = 1 - BigRational(2 * std::int64_t{row} + 1, viewport.height);
      if (!is_pick_ray(model, pick_ray(*drawn, viewport, column, row), across, upward)) ++wrong;
      if (!is_nearest(unproject(*drawn, viewport, column, row, depth),
                      model.at(across, upward, exact(depth)))) {
        ++wrong;
      }
    }

    const auto point = random_vec<T, 3>(random);
    const auto inverse = eliminate(model.frame);
    const auto found = project(*drawn, point);
    const auto in_pixels = project<q16_16>(*drawn, viewport, point);
    Exact local;
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3 && inverse.determinant != 0; ++j) {
        local[i] += inverse.inverse[i][j] * (exact(point[static_cast<int>(j)]) - model.eye[j]);
      }
    }
    const BigRational ahead = -local[2];
    const bool expected = inverse.determinant != 0 && (!lens.has_perspective() || ahead > 0);
    if (found.has_value() != expected || in_pixels.has_value() != expected) ++wrong;
    ++(expected ? seen : unseen);
    if (expected && found && in_pixels) {
      const BigRational a = local[0] / model.half_size(0, ahead),
                        b = local[1] / model.half_size(1, ahead);
      if (!is_nearest(found->x, a) || !is_nearest(found->y, b)) ++wrong;
      if (!is_nearest(found->depth, ahead) || in_pixels->depth != found->depth) ++wrong;
      if (!is_nearest(in_pixels->x, (a + 1) * viewport.width / 2)) ++wrong;
      if (!is_nearest(in_pixels->y, (1 - b) * viewport.height / 2)) ++wrong;
    }

    const Frustum<T> frustum{*drawn};
    for (std::size_t i = 0; i < 8; ++i) {
      const auto& at = (i & 4) != 0 ? lens.far_distance() : lens.near_distance();
      const auto corner = model.at((i & 1) != 0 ? 1 : -1, (i & 2) != 0 ? 1 : -1, exact(at));
      if (!is_nearest(frustum.corners()[i], corner)) ++wrong;
    }
  }
  INFO(random);
  CHECK(wrong == 0);
  CHECK(cameras > 40);
  CHECK(seen > cameras / 4);
  CHECK(unseen > cameras / 8);
}

TEMPLATE_TEST_CASE("camera: float and double agree", "", float, double) {
  using F = TestType;
  const auto pose = look_at(Vec<F, 3>{0, 0, 10}, Vec<F, 3>{}, Vec<F, 3>{0, 1, 0});
  const auto lens = Lens<F>::perspective(Angle<F>::turn(1, 4), F(1), F(1), F(100));
  const Camera<F> eye{*pose, *lens};
  const auto seen = project(eye, Vec<F, 3>{10, -5, 0});
  REQUIRE(seen);
  CHECK(seen->x == Approx(1));
  CHECK(seen->y == Approx(-0.5));
  CHECK(seen->depth == Approx(10));
  CHECK(!project(eye, Vec<F, 3>{0, 0, 11}));
  CHECK(unproject(eye, F(1), F(-0.5), F(10)).x == Approx(10));
  CHECK(pick_ray(eye, F(0.75), F(0)).direction[0] == Approx(0.6));
  CHECK(pick_ray(eye, Viewport{4, 2}, 0, 0).direction[2] == Approx(-4 / std::sqrt(29.0)));
  CHECK(Frustum{eye}.corners()[7].x == Approx(100));
}

TEST_CASE("camera: its digest covers every field") {
  const auto of = [](const Camera<S>& c) { return digest(c); };
  auto other = camera;
  other.pose.translation.x = n(1);
  CHECK(of(other) != of(camera));
  other = camera;
  other.lens = *Lens<S>::perspective(A::turn(1, 4), n(1), n(1), n(99));
  CHECK(of(other) != of(camera));
  CHECK(of(camera) == of(Camera{camera.pose, camera.lens}));
  CHECK(digest(Frustum{camera}) != digest(Frustum{other}));
}
