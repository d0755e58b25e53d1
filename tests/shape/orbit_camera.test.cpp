// SPDX-License-Identifier: MIT
#include "detent/shape/orbit_camera.hpp"

#include <cmath>

#include "detent/number/digest.hpp"
#include "math/decimals.hpp"
#include "math/frames.hpp"

using namespace detent;
using namespace detent::test;

namespace {

using S = q16_16;
using V = Vec<S, 3>;
using A = Angle<S>;
constexpr auto lens = *Lens<S>::perspective(A::turn(1, 4), n(1), n(1), n(100));

constexpr OrbitCamera<S> start{lens, v3(1, 2, 3), n(10)};
static_assert(start.camera().pose == Transform<S, 3>{v3(1, 2, 13), {}, n(1)}, "it looks along -z");

/// The camera after one operation.
template <class F>
constexpr OrbitCamera<S> after(const F& f) {
  auto orbit = start;
  f(orbit);
  return orbit;
}
constexpr auto turned = after([](auto& orbit) { orbit.rotate(A::turn(1, 4), A()); });
static_assert(turned.camera().pose.translation == v3(11, 2, 3), "yaw turns towards +x");
static_assert(project(turned.camera(), v3(1, 2, 3)) == ScreenPoint<S, S>{n(0), n(0), n(10)});
constexpr auto above = after([](auto& orbit) { orbit.rotate(A(), A::turn(1, 12)); });
static_assert(above.camera().pose.translation.y == 7, "pitch lifts");
static_assert(above.camera().pose.translation.z > n(3 + 8.66));

static_assert(after([](auto& orbit) { orbit.rotate(A(), A::turn(1, 4)); }).pitch ==
                  start.limits.max_pitch,
              "as far as the limit");
static_assert(after([](auto& orbit) { orbit.rotate(A(), A::turn(-1, 3)); }).pitch ==
              start.limits.min_pitch);
static_assert(after([](auto& orbit) {
                orbit.rotate(A(), A::turn(1, 5));
                orbit.rotate(A(), A::turn(49, 100));
              }).pitch == start.limits.max_pitch,
              "a large step does not come out below");

static_assert(after([](auto& orbit) { orbit.zoom(n(0.5)); }).distance == 5);
static_assert(after([](auto& orbit) { orbit.zoom(n(0.01)); }).distance == 1, "not too near");
static_assert(after([](auto& orbit) { orbit.zoom(n(-3)); }).distance == 1);
static_assert(after([](auto& orbit) {
                orbit.limits.max_distance = n(15);
                orbit.zoom(n(3));
              }).distance == 15);
static_assert(after([](auto& orbit) { orbit.zoom(S::max()); }).distance == S::max());

static_assert(after([](auto& orbit) { orbit.pan(n(2), n(-1)); }).target == v3(3, 1, 3));
static_assert(after([](auto& orbit) {
                orbit.rotate(A::turn(1, 4), A());
                orbit.pan(n(2), n(1));
              }).target == v3(1, 3, 1),
              "right in the image is -z");

}  // namespace

TEMPLATE_TEST_CASE("orbit camera: looks at its target from its distance", "", q16_16, q14_16, q24_8,
                   q8_8, float, double) {
  using T = TestType;
  Random random(0x0461);
  int frac = 0;
  if constexpr (is_fixed<T>) frac = T::frac;
  const auto angle = [&] {
    return Angle<T>::turn(static_cast<int>(random.between(-999, 999)), 1000);
  };
  const auto glass = *Lens<T>::perspective(Angle<T>::turn(1, 6), T(1), T(1), T(100));
  OrbitCamera<T> orbit{glass, {}, T(20)};
  for (int k = 0; k < 300; ++k) {
    orbit.rotate(angle(), angle());
    orbit.zoom(T(random.coin() ? 2 : 0));
    if (orbit.distance < T(16)) orbit.distance = T(16);
    orbit.limits.max_distance = T(64);
    if (k % 8 == 0) orbit.pan(T(static_cast<int>(random.between(-3, 3))), T(1));
    if (k % 64 == 0) orbit.target = {};
    const auto camera = orbit.camera();
    const auto seen = project(camera, orbit.target);
    REQUIRE(seen);
    // Off by less than two steps of the position, seen from 16 units or more.
    const auto off = [](const T& x) { return std::abs(static_cast<double>(x)); };
    const double step = is_fixed<T> ? std::ldexp(2.0, -frac) : 1e-4;
    CHECK(off(seen->x) < step);
    CHECK(off(seen->y) < step);
    CHECK(std::abs(off(seen->depth) - off(orbit.distance)) < step);
    const auto up = static_cast<double>(camera.pose.rotation.axis(1)[1]);
    CHECK(up > 0.03);  // cos(88 degrees): it is never upside down
  }
}

TEST_CASE("orbit camera: the digest covers every field") {
  const auto differs = [](const auto& change) {
    auto other = start;
    change(other);
    return digest(other) != digest(start) && !(other == start);
  };
  CHECK(differs([](auto& orbit) { orbit.yaw = A::turn(1, 9); }));
  CHECK(differs([](auto& orbit) { orbit.pitch = A::turn(1, 9); }));
  CHECK(differs([](auto& orbit) { orbit.distance = n(9); }));
  CHECK(differs([](auto& orbit) { orbit.target.y = n(9); }));
  CHECK(differs([](auto& orbit) { orbit.limits.max_pitch = A::turn(1, 9); }));
  CHECK(differs([](auto& orbit) { orbit.limits.min_distance = n(9); }));
}
