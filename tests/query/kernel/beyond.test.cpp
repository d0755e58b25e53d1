// SPDX-License-Identifier: MIT
#include "detent/query/kernel/beyond.hpp"

#include <algorithm>
#include <array>

#include "detent/query/overlaps/frustum.hpp"
#include "math/frames.hpp"

namespace detent::test {
namespace {

using S = q16_16;
using V = Vec<S, 3>;
constexpr auto n = [](double value) { return S::from_double(value); };
constexpr auto v3 = [](double x, double y, double z) { return V{n(x), n(y), n(z)}; };

// The cube from -4 to 4, with its corners in frustum order.
constexpr Frustum<S> cube{[] {
  Frustum<S>::Corners corners;
  for (std::size_t i = 0; i < 8; ++i) {
    corners[i] = v3((i & 1) != 0 ? 4 : -4, (i & 2) != 0 ? 4 : -4, (i & 4) != 0 ? -4 : 4);
  }
  return corners;
}()};
static_assert(cube.planes()[0].normal == Direction<S, 3>::along(0) && cube.planes()[0].reach == 4);
static_assert(cube.planes()[1].normal == -Direction<S, 3>::along(0) && cube.planes()[1].reach == 4);
static_assert(cube.planes()[4].normal == -Direction<S, 3>::along(2), "far");
static_assert(cube.planes()[5].normal == Direction<S, 3>::along(2), "near");

// The planes alone decide what lies beyond one of them: touching is not beyond, one step further
// is.
constexpr S step = S::from_raw(1);
static_assert(!detail::is_beyond(cube, v3(4, 0, 0)));
static_assert(detail::is_beyond(cube, V{nearest_to<S>(n(4) + step), n(0), n(0)}));
static_assert(!detail::is_beyond(cube, Segment{v3(4, 9, 0), v3(9, 4, 0)}), "beyond an edge only");
static_assert(!detail::is_beyond(cube, Aabb{v3(4, -9, -9), v3(9, 9, 9)}));
static_assert(detail::is_beyond(cube,
                                Aabb{V{nearest_to<S>(n(4) + step), n(-9), n(-9)}, v3(9, 9, 9)}));
static_assert(!detail::is_beyond(cube, Sphere{v3(0, -6, 0), n(2)}));
static_assert(detail::is_beyond(cube, Sphere{v3(0, -6, 0), n(1.999)}));
static_assert(detail::is_beyond(cube, Capsule{v3(0, 0, 6), v3(9, 9, 9), n(1.999)}));
static_assert(!detail::is_beyond(cube, Capsule{v3(0, 0, 6), v3(9, 9, 9), n(2)}));
static_assert(!detail::is_beyond(cube, Obb<S, 3>{v3(6, 0, 0), v3(2, 1, 1), {}}));
static_assert(detail::is_beyond(cube, Obb<S, 3>{v3(6, 0, 0), v3(1.999, 1, 1), {}}));
static_assert(detail::is_beyond(cube, Triangle{v3(5, 0, 0), v3(6, 0, 0), v3(5, 9, 0)}));
static_assert(!detail::is_beyond(cube, Ray{v3(9, 0, 0), -Direction<S, 3>::along(0)}));
static_assert(detail::is_beyond(cube, Ray{v3(9, 0, 0), Direction<S, 3>::along(1)}));
static_assert(!detail::is_beyond(cube, Ray{v3(4, 0, 0), Direction<S, 3>::along(0)}), "touching");

/// dot(normal, x), exact.
template <Scalar T>
BigRational along(const Direction<T, 3>& normal, const Vec<T, 3>& x) {
  BigRational sum = 0;
  for (int i = 0; i < 3; ++i) sum += rational(normal[i]) * rational(x[i]);
  return sum;
}

TEMPLATE_TEST_CASE("frustum planes: contain every corner, for any corners", "", q16_16, q14_16,
                   q24_8, q8_8, (Fixed<1, 0>)) {
  using T = TestType;
  Random random(0xbe704d);
  int outside = 0, apart = 0;
  for (int k = 0; k < 2'000; ++k) {
    typename Frustum<T>::Corners corners;
    for (auto& corner : corners) corner = random_vec<T, 3>(random);
    if (random.one_in(4)) corners[3] = corners[1];
    if (random.one_in(8)) corners.fill(corners[0]);
    const Frustum<T> frustum{corners};
    for (const auto& plane : frustum.planes()) {
      BigRational reach = along(plane.normal, corners[0]);
      for (const auto& corner : corners) {
        if (along(plane.normal, corner) > rational(plane.reach)) ++outside;
        reach = (std::max)(reach, along(plane.normal, corner));
      }
      if (reach != rational(plane.reach)) ++apart;
    }
  }
  INFO(random);
  CHECK(outside == 0);
  CHECK(apart == 0);
}

// A lower bound for a box must hold for each of its corners, and for a ball for each of its points:
// that of a ball is at most dot(normal, center) - radius |normal|.
TEMPLATE_TEST_CASE("least_along: a lower bound within two steps", "", q16_16, q14_16, q24_8, q8_8) {
  using T = TestType;
  Random random(0x1ea57);
  int above = 0, loose = 0;
  for (int k = 0; k < 3'000; ++k) {
    const auto normal = random_frame<T, 3>(random).axis(0);
    BigRational squared = 0;
    for (int i = 0; i < 3; ++i) squared += rational(normal[i]) * rational(normal[i]);

    const auto half = random_vec<T, 3>(random);
    Obb<T, 3> box{random_vec<T, 3>(random), half, random_frame<T, 3>(random)};
    for (int i = 0; i < 3; ++i) box.half_extents[i] = saturate_to<T>(abs(half[i]));
    BigRational exact = along(normal, box.center);
    for (int i = 0; i < 3; ++i) {
      BigRational cosine = 0;
      for (int j = 0; j < 3; ++j) {
        cosine += rational(normal[j]) * rational(box.rotation.axis(i)[j]);
      }
      exact -= rational(box.half_extents[i]) * abs(cosine);
    }
    const BigRational found = rational(detail::least_along(normal, box));
    // Each cosine is off by less than one step of its grid, times a half extent below 2^(b - f).
    const BigRational most(power_of_two(T::bits - T::frac) * 3,
                           power_of_two(direction_component<T>::frac));
    if (found > exact) ++above;
    if (found < exact - most) ++loose;

    const T radius = saturate_to<T>(abs(half.x));
    const Sphere<T, 3> ball{box.center, radius};
    const BigRational gap = along(normal, box.center) - rational(detail::least_along(normal, ball));
    if (gap * gap < squared * rational(radius) * rational(radius)) ++above;
    if (gap > rational(radius) * (1 + BigRational(1, 1 << 12))) ++loose;
    const Capsule<T, 3> capsule{box.center, half, radius};
    if (rational(detail::least_along(normal, capsule)) >
        rational(detail::least_along(normal, ball))) {
      ++above;
    }
  }
  INFO(random);
  CHECK(above == 0);
  CHECK(loose == 0);
}

}  // namespace
}  // namespace detent::test
