// SPDX-License-Identifier: MIT
#include "exact.hpp"

#include "exact_world.hpp"
#include "support/catch.hpp"

using namespace detent;

namespace {

using cli::Exact;
using cli::exact;
using cli::ExactGroup;
using cli::ExactShape;
using cli::first_hit;
using cli::Integer;

constexpr int steps_per_unit = 1 << 16;

/// A distance in 1/65536, rounded down like those of q16_16.
std::optional<std::int64_t> raw_distance(const ExactShape& ray, const ExactShape& shape) {
  const auto hit = first_hit(ray, shape);
  if (!hit) return std::nullopt;
  return static_cast<std::int64_t>(Integer(*hit >> (cli::distance_frac - 16)));
}

Ray<double, 3> up() { return {{0, 0, 0}, Direction<double, 3>::along(2), 32767}; }
ExactShape along_z() { return exact(up()); }

}  // namespace

TEST_CASE("exact rays: decide the classic cases in which float errs") {
  const auto sphere = [](double x, double z, double radius) {
    return exact(Sphere<double, 3>{{x, 0, z}, radius});
  };
  CHECK_FALSE(raw_distance(along_z(), sphere(0.75, 10000, 0.5)));
  CHECK(raw_distance(along_z(), sphere(2.25, 10000, 2.5)) == 655288583);  // 9998.91027...
  CHECK(raw_distance(along_z(), sphere(1.875, 10000, 2)) == 655314388);   // 9999.30402...
  CHECK_FALSE(raw_distance(along_z(), sphere(5.5, 30000, 0.25)));
  CHECK(raw_distance(along_z(), sphere(6, 30000, 7.5)) == 29995.5 * steps_per_unit);
  CHECK_FALSE(raw_distance(along_z(), sphere(0.01953125, 100, 0.0078125)));
  CHECK_FALSE(raw_distance(along_z(), sphere(0, -5, 1)));
}

TEST_CASE("exact rays: degenerate triangles are the segments and points they span") {
  const auto segment = exact(Triangle<double, 3>{{-1, 0, 5}, {0, 0, 5}, {1, 0, 5}});
  CHECK(raw_distance(along_z(), segment) == 5 * steps_per_unit);
  const auto along = exact(Triangle<double, 3>{{0, 0, 9}, {0, 0, 7}, {0, 0, 8}});
  CHECK(raw_distance(along_z(), along) == 7 * steps_per_unit);
  const auto point = exact(Triangle<double, 3>{{0, 0, 3}, {0, 0, 3}, {0, 0, 3}});
  CHECK(raw_distance(along_z(), point) == 3 * steps_per_unit);
  const auto beside = exact(Triangle<double, 3>{{1, 0, 3}, {1, 0, 3}, {1, 0, 3}});
  CHECK_FALSE(raw_distance(along_z(), beside));
  const auto edge_on = exact(Triangle<double, 3>{{0, -1, 4}, {0, 1, 4}, {0, 0, 6}});
  CHECK(raw_distance(along_z(), edge_on) == 4 * steps_per_unit);
  const auto around = exact(Triangle<double, 3>{{0, -1, -1}, {0, 1, -1}, {0, 0, 6}});
  CHECK(raw_distance(along_z(), around) == 0);
}

TEST_CASE("exact rays: a double has an exact value") {
  for (const double value : {0.0, 1.0, -0.1, 28000.001953125, 0x1p-149, 0x1.fffffep127}) {
    CHECK(Exact::of(value).approximate() == value);
  }
}

namespace {

/// Coordinates over several scene sizes, on the scalar's grid.
template <class S>
S coordinate(test::Random& random, int bits) {
  return S::from_raw(static_cast<typename S::raw_type>(random.wide(std::min(bits, S::bits))));
}

template <class S>
Vec<S, 3> point(test::Random& random, int bits) {
  return {coordinate<S>(random, bits), coordinate<S>(random, bits), coordinate<S>(random, bits)};
}

template <class S>
Direction<S, 3> some_direction(test::Random& random) {
  for (;;) {
    if (const auto direction = normalize(point<S>(random, S::bits))) return *direction;
  }
}

/// A ray aimed near `target`.
template <class S>
Ray<S, 3> ray_towards(test::Random& random, const Vec<S, 3>& target, int bits) {
  const Vec<S, 3> origin = point<S>(random, bits);
  const Vec<S, 3> aim = nearest_to<S>(target + point<S>(random, bits - 4));
  const auto direction = direction_of<S>(aim - origin);
  return {origin, direction.value_or(Direction<S, 3>()), S::max()};
}

template <class S, class Shape>
bool agrees(const Ray<S, 3>& ray, const Shape& shape, test::HitRate& rate) {
  const auto found = raycast(ray, shape);
  const auto expected = first_hit(exact(ray), exact(shape));
  rate.count(found.has_value());
  if (found.has_value() != expected.has_value()) return false;
  return !found || Integer(*expected >> (cli::distance_frac - S::frac)) == found->raw();
}

}  // namespace

TEMPLATE_TEST_CASE("exact rays: agree with the library", "", q16_16, q14_16, q24_8, q8_8) {
  using S = TestType;
  test::Random random(20240917);
  INFO(random);
  test::HitRate rate;
  int wrong = 0;
  for (int i = 0; i < 4000; ++i) {
    const int bits = static_cast<int>(random.between(8, S::bits));
    const Vec<S, 3> center = point<S>(random, bits);
    const auto ray = ray_towards(random, center, bits);
    const S size = S::from_raw(static_cast<typename S::raw_type>(
        std::min<std::int64_t>(random.between(0, std::int64_t{1} << (bits - 4)), S::max().raw())));
    const auto offset = [&] { return nearest_to<S>(center + point<S>(random, bits - 2)); };
    const Vec<S, 3> a = offset(), b = offset(), c = offset();
    const Rotation<S, 3> rotation = Rotation<S, 3>::from_axis_angle(
        some_direction<S>(random), Angle<S>::from_raw(static_cast<std::uint32_t>(random.next())));
    const bool right =
        agrees(ray, Sphere<S, 3>{center, size}, rate) &&
        agrees(ray,
               Aabb<S, 3>{make_vec<3>([&](int k) { return std::min(a[k], b[k]); }),
                          make_vec<3>([&](int k) { return std::max(a[k], b[k]); })},
               rate) &&
        agrees(ray, Obb<S, 3>{center, {size, size, size}, rotation}, rate) &&
        agrees(ray, Plane<S, 3>{rotation.axis(0), coordinate<S>(random, bits)}, rate) &&
        agrees(ray, Triangle<S, 3>{a, b, c}, rate);
    wrong += right ? 0 : 1;
  }
  CHECK(wrong == 0);
  INFO(rate);
  CHECK(rate.is_balanced());
}

TEST_CASE("exact rays: the box around a shape never hides a hit") {
  using S = q16_16;
  test::Random random(77);
  INFO(random);
  int hidden = 0;
  for (int i = 0; i < 2000; ++i) {
    const int bits = static_cast<int>(random.between(8, 31));
    const Vec<S, 3> center = point<S>(random, bits);
    const auto ray = exact(ray_towards(random, center, bits));
    const auto offset = [&] { return nearest_to<S>(center + point<S>(random, bits - 2)); };
    const std::array<ExactShape, 3> shapes{
        exact(Sphere<S, 3>{center, abs(coordinate<S>(random, bits - 4)) > 0
                                       ? S::from_raw(1 << (bits / 2))
                                       : S(0)}),
        exact(Triangle<S, 3>{offset(), offset(), offset()}),
        exact(Obb<S, 3>{center, {S(1), S(2), S(3)}, {}})};
    for (const auto& shape : shapes) {
      hidden += ExactGroup({shape}).first_hit(ray) == first_hit(ray, shape) ? 0 : 1;
    }
  }
  CHECK(hidden == 0);
}

TEMPLATE_TEST_CASE("exact rays: the first hit of a group is the first of all its shapes", "",
                   q16_16, float) {
  using S = TestType;
  test::Random random(4711);
  INFO(random);
  const auto random_point = [&](int spread) {
    const auto coordinate = [&] {
      const auto steps = static_cast<int>(random.between(-spread, spread));
      if constexpr (is_fixed<S>) {
        return S::from_raw(28000 * 65536 + steps * 512);
      } else {
        return S(28000) + static_cast<S>(steps) / 128;
      }
    };
    return Vec<S, 3>{coordinate(), coordinate(), coordinate()};
  };
  int wrong = 0;
  test::HitRate rate;
  for (int scene = 0; scene < 20; ++scene) {
    std::vector<ExactShape> triangles;
    for (int i = 0; i < 60; ++i) {
      const Vec<S, 3> a = random_point(1000);
      const auto near_a = [&] { return nearest_to<S>(a + (random_point(500) - random_point(0))); };
      triangles.push_back(exact(Triangle<S, 3>{a, near_a(), near_a()}));
    }
    const ExactGroup group(triangles);
    for (int i = 0; i < 40; ++i) {
      const Vec<S, 3> origin = random_point(2000);
      const auto direction = direction_of<S>(random_point(900) - origin);
      const auto ray = exact(Ray<S, 3>{origin, direction.value_or(Direction<S, 3>())});
      std::optional<Integer> first;
      for (const auto& triangle : triangles) {
        const auto hit = first_hit(ray, triangle);
        if (hit && (!first || *hit < *first)) first = hit;
      }
      rate.count(first.has_value());
      wrong += group.first_hit(ray) == first ? 0 : 1;
    }
  }
  CHECK(wrong == 0);
  INFO(rate);
  CHECK(rate.is_balanced());
}
