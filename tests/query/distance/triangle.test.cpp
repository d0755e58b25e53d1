// SPDX-License-Identifier: MIT
#include "detent/query/distance/triangle.hpp"

#include "query/raycast/helpers.hpp"

namespace detent::test {
namespace {

TEMPLATE_TEST_CASE("distance, triangle: to the face, an edge or a corner", "[distance]",
                   DETENT_EVERY_SPACE) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  const auto triangle = right_triangle<S, N>();
  CHECK(distance(triangle, at<S, N>(-3, -4)) == num<S>(5));
  CHECK(distance(triangle, at<S, N>(3, -2)) == num<S>(2));
  CHECK(distance(triangle, at<S, N>(2, 3)) == num<S>(0));
  CHECK(distance(triangle, at<S, N>(8, 0)) == num<S>(0));
  CHECK(squared_distance(triangle, at<S, N>(3, -2)) <= num<S>(4));
  CHECK_FALSE(squared_distance(triangle, at<S, N>(3, -2)) <= num<S>(3.5));
  if (N == 3) {
    CHECK(distance(triangle, at<S, N>(2, 3, 7)) == num<S>(7));
    CHECK(distance(triangle, at<S, N>(3, -3, 4)) == num<S>(5));
  }
  const auto a = at<S, N>(1, 1), b = at<S, N>(3, 1), c = at<S, N>(9, 1);
  CHECK(distance(Triangle<S, N>{b, a, c}, at<S, N>(5, 7)) == num<S>(6));
  CHECK(distance(Triangle<S, N>{a, a, a}, at<S, N>(4, 5)) == num<S>(5));
}

TEMPLATE_TEST_CASE("distance, triangle: clamped at the ends of the domain", "[distance]",
                   DETENT_FIXED_SPACES) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  const auto low = filled<S, N>(S::lowest()), high = filled<S, N>(S::max());
  CHECK(distance(Triangle<S, N>{low, low, low}, high) == S::max());
  auto side = low;
  side.x = S::max();
  CHECK(distance(Triangle<S, N>{low, side, high}, high) == S(0));
  auto across = high;
  across.x = S::lowest();
  CHECK(distance(Triangle<S, N>{low, side, high}, across) == S::max());
}

template <class Narrow, int N>
void compare_widths(std::uint64_t seed) {
  using Wide = Fixed<33, 16>;
  Random random(seed);
  INFO(random);
  HitRate faces;
  for (int i = 0; i < 4000; ++i) {
    const int bits = 2 + i % (Narrow::bits - 2);
    const auto vec = [&] {
      return make_vec<N>([&](int) {
        return Narrow::from_raw(static_cast<typename Narrow::raw_type>(random.wide(bits)));
      });
    };
    const auto wide = [](const Vec<Narrow, N>& v) {
      return make_vec<N>([&](int j) { return Wide(v[j]); });
    };
    const auto b = vec(), c = vec(), p = vec();
    const auto bp = wide(p) - wide(b), cp = wide(p) - wide(c);
    if (!fits<Narrow::bits>(bp) || !fits<Narrow::bits>(cp)) continue;
    const auto part =
        detail::nearest_part(b, c, p, narrow<Narrow::bits>(bp), narrow<Narrow::bits>(cp));
    CHECK(part == detail::nearest_part(wide(b), wide(c), wide(p), narrow<33>(bp), narrow<33>(cp)));
    faces.count(part == detail::TrianglePart::face);
    const auto distance_of = [](const auto& squared) { return sqrt_floor<q16_16>(squared); };
    CHECK(distance_of(detail::squared_distance_from_edge(b, p)) ==
          distance_of(detail::squared_distance_from_edge(wide(b), wide(p))));
    if constexpr (N == 3 && Narrow::bits == 20) {
      if (detail::are_parallel(b, c)) continue;
      CHECK(distance_of(detail::squared_distance_from_face(b, c, p)) ==
            distance_of(detail::squared_distance_from_face(wide(b), wide(c), wide(p))));
    }
  }
  INFO(faces);
  CHECK(faces.percent() >= 5);
}

TEST_CASE("distance, triangle: narrow and wide integers give the same result", "[distance]") {
  compare_widths<Fixed<30, 16>, 2>(0xd157);
  compare_widths<Fixed<30, 16>, 3>(0xd158);
  compare_widths<Fixed<20, 16>, 3>(0xd159);
}

TEST_CASE("distance, triangle: a height is rounded down exactly, on a step and next to one",
          "[distance]") {
  using Component = Fixed<30, 16>;
  Random random(0xd15a);
  INFO(random);
  const auto vec = [](std::int64_t x, std::int64_t y, std::int64_t z) {
    const auto raw = [](std::int64_t r) {
      return Component::from_raw(static_cast<Component::raw_type>(r));
    };
    return Vec{raw(x), raw(y), raw(z)};
  };
  int wrong = 0, on_step = 0;
  for (int i = 0; i < 20'000; ++i) {
    // Two vectors across (2, 3, 6), whose length is 7, and a point `height` times 7 along it.
    const std::int64_t s = 1 + random.next() % 4096, t = 1 + random.next() % 4096;
    const std::int64_t height = random.between(1, std::int64_t{1} << random.between(1, 24));
    const std::int64_t off = i % 3 == 0 ? 0 : random.between(-1, 1);
    const auto b = vec(3 * s, -2 * s, 0), c = vec(6 * t, off, -2 * t);
    const auto p = vec(2 * height, 3 * height, 6 * height);
    const auto found = detail::distance_from_face<q16_16>(b, c, p);
    wrong += found == sqrt_floor<q16_16>(detail::squared_distance_from_face(b, c, p)) ? 0 : 1;
    if (off != 0) continue;
    ++on_step;
    wrong += found == q16_16::from_raw(static_cast<q16_16::raw_type>(7 * height)) ? 0 : 1;
  }
  CHECK(wrong == 0);
  CHECK(on_step > 5'000);
  CHECK(detail::distance_from_face<q16_16>(vec(1, 2, 3), vec(3, 5, 1), vec(4, 7, 4)) == 0);
}

}  // namespace
}  // namespace detent::test
