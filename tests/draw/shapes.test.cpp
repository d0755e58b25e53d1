// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>

#include "draw/sheet.hpp"
#include "support/catch.hpp"

namespace detent::test {
namespace {

constexpr int cases = 300;

/// Lines of a shape in constant expressions, and of one at the origin.
template <Scalar S, class Shape>
constexpr int line_count(const Shape& shape) {
  Counts<S, 3> counts;
  draw(counts, shape, ink);
  return counts.faces == 0 ? counts.lines : -1;
}
static_assert(line_count<q16_16>(Sphere<q16_16, 3>{{}, q16_16(1)}) == 96);
static_assert(line_count<q8_8>(Aabb<q8_8, 3>{}) == 12);
static_assert(line_count<float>(Sphere<float, 3>{{}, 1.0F}) == 96);
static_assert(line_count<q16_16>(Ray<q16_16, 3>{}) == 1);
static_assert(std::size(draw_palette) == 8 && palette_colour(9) == palette_colour(1));

template <Scalar S, int N>
Capsule<S, N> any_capsule(Random& random) {
  const auto a = any_point<S, N>(random);
  return {a, random.one_in(8) ? a : any_point<S, N>(random), any_length<S>(random)};
}

TEMPLATE_TEST_CASE("draw: the circles of a sphere lie on it", "[draw]", DETENT_EVERY_SPACE) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  Random random(1);
  for (int i = 0; i < cases; ++i) {
    const Sphere<S, N> sphere{any_point<S, N>(random), any_length<S>(random)};
    const auto sheet = drawn<S, N>(sphere);
    REQUIRE(sheet.lines.size() == (N == 2 ? 32 : 96));
    const auto center = in_double(sphere.center);
    const auto radius = static_cast<double>(sphere.radius);
    for (const auto& point : sheet.points()) {
      const double off = norm(minus(in_double(point), center)) - radius;
      REQUIRE(std::abs(off) <= slack<S>(radius, norm(center)));
    }
    // Circles close, their lines join, and each line is a side of a 32-gon.
    for (std::size_t k = 0; k < sheet.lines.size(); ++k) {
      const auto& line = sheet.lines[k];
      const auto next = k % 32 == 31 ? k - 31 : k + 1;
      REQUIRE(line.b == sheet.lines[next].a);
      REQUIRE(line.colour == ink);
      const double side = norm(minus(in_double(line.a), in_double(line.b)));
      REQUIRE(std::abs(side - radius * 2 * std::sin(3.14159265358979 / 32)) <=
              2 * slack<S>(radius, norm(center)));
    }
  }
}

TEMPLATE_TEST_CASE("draw: the outline of a capsule lies on it", "[draw]", DETENT_EVERY_SPACE) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  Random random(2);
  int long_ones = 0;
  for (int i = 0; i < cases; ++i) {
    const auto capsule = any_capsule<S, N>(random);
    auto sheets = std::array{drawn<S, N>(capsule), Sheet<S, N>()};
    const bool is_long = capsule.a != capsule.b;
    long_ones += is_long;
    REQUIRE(sheets[0].lines.size() == (is_long ? (N == 2 ? 34 : 132) : (N == 2 ? 32 : 96)));
    if constexpr (N == 3) {
      sheets[1] = drawn_solid<S>(capsule);
      REQUIRE(sheets[1].faces.size() == (is_long ? 256 : 224));
    }
    const auto a = in_double(capsule.a), way = minus(in_double(capsule.b), a);
    const auto radius = static_cast<double>(capsule.radius);
    for (const auto& sheet : sheets) {
      for (const auto& drawing : sheet.points()) {
        const auto point = minus(in_double(drawing), a);
        const double t = is_long ? std::clamp(inner(point, way) / inner(way, way), 0.0, 1.0) : 0.0;
        const double off = norm(minus(point, {t * way[0], t * way[1], t * way[2]})) - radius;
        REQUIRE(std::abs(off) <= slack<S>(radius, norm(a) + norm(way), 4));
      }
    }
    // Triangles of a solid face outward.
    for (const auto& face : sheets[1].faces) {
      if (radius < std::ldexp(1.0, 10 - (is_fixed<S> ? 8 : 0))) break;
      const auto p = in_double(face.a), u = minus(in_double(face.b), p),
                 v = minus(in_double(face.c), p);
      const Double3 normal{u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2],
                           u[0] * v[1] - u[1] * v[0]};
      const auto out = minus(p, a);
      const double t = is_long ? std::clamp(inner(out, way) / inner(way, way), 0.0, 1.0) : 0.0;
      REQUIRE(inner(normal, minus(out, {t * way[0], t * way[1], t * way[2]})) >= 0);
    }
  }
  CHECK(long_ones > cases * 3 / 4);
  CHECK(long_ones < cases);
}

TEMPLATE_TEST_CASE("draw: the edges of boxes join their corners", "[draw]", DETENT_EVERY_SPACE) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  Random random(3);
  for (int i = 0; i < cases; ++i) {
    const auto a = any_point<S, N>(random), b = any_point<S, N>(random);
    const Aabb<S, N> box{make_vec<N>([&](int k) { return std::min(a[k], b[k]); }),
                         make_vec<N>([&](int k) { return std::max(a[k], b[k]); })};
    const auto sheet = drawn<S, N>(box);
    REQUIRE(sheet.lines.size() == (N == 2 ? 4 : 12));
    for (const auto& line : sheet.lines) {
      int ways = 0;
      for (int k = 0; k < N; ++k) {
        REQUIRE((line.a[k] == box.min[k] || line.a[k] == box.max[k]));
        REQUIRE((line.b[k] == box.min[k] || line.b[k] == box.max[k]));
        if (line.a[k] != line.b[k]) ++ways;
      }
      REQUIRE(ways <= 1);
    }
    const Obb<S, N> turned{
        a, make_vec<N>([&](int) { return any_length<S>(random); }), [&] {
          const auto x = any_direction<S, N>(random);
          const auto y = detail::perpendicular(x);
          if constexpr (N == 2) {
            return Rotation<S, N>::from_axes({x, y});
          } else {
            return Rotation<S, N>::from_axes({x, y, detail::perpendicular(x, y)});
          }
        }()};
    const auto edges = drawn<S, N>(turned);
    REQUIRE(edges.lines.size() == (N == 2 ? 4 : 12));
    const auto center = in_double(turned.center);
    std::array<int, 8> seen{};
    for (const auto& drawing : edges.points()) {
      // center + sum of signs times the half extents along the axes.
      double least = 1e300;
      std::size_t nearest = 0;
      for (std::size_t corner = 0; corner < (1u << N); ++corner) {
        auto at = center;
        for (int k = 0; k < N; ++k) {
          const auto axis = in_double(turned.rotation.axis(k).vec());
          const double along =
              static_cast<double>(turned.half_extents[k]) * ((corner >> k & 1) != 0 ? 1 : -1);
          for (std::size_t c = 0; c < 3; ++c) at[c] += along * axis[c];
        }
        const double off = norm(minus(in_double(drawing), at));
        if (off < least) nearest = corner, least = off;
      }
      ++seen[nearest];
      REQUIRE(least <= slack<S>(0, norm(center) + 3 * norm(in_double(turned.half_extents))));
    }
    bool is_thick = true;
    for (int k = 0; k < N; ++k) is_thick &= turned.half_extents[k] > num<S>(1);
    if (is_thick) REQUIRE(std::count(seen.begin(), seen.end(), N) == (1 << N));
  }
}

TEMPLATE_TEST_CASE("draw: a plane is drawn around its point closest to the region", "[draw]",
                   DETENT_EVERY_SPACE) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  Random random(4);
  for (int i = 0; i < cases; ++i) {
    Plane<S, N> plane{any_direction<S, N>(random), any_number<S>(random)};
    DrawRegion<S, N> region{any_point<S, N>(random), any_length<S>(random)};
    if (is_fixed<S> && i % 4 == 0) {  // the closest point may be outside the range
      region.center = make_vec<N>([&](int) { return random.coin() ? largest<S> : lowest<S>; });
      plane.offset = random.coin() ? largest<S> : lowest<S>;
    }
    Sheet<S, N> sheet;
    draw(sheet, plane, ink, region);
    REQUIRE(sheet.lines.size() == (N == 2 ? 1 : 18));
    const auto normal = in_double(plane.normal.vec());
    const auto reach = static_cast<double>(region.reach);
    const auto center = in_double(region.center);
    const double height =
        (inner(normal, center) - static_cast<double>(plane.offset)) / inner(normal, normal);
    auto middle = center;
    for (std::size_t k = 0; k < 3; ++k) middle[k] -= normal[k] * height;
    const double from = norm(center);
    bool has_corner = false;
    for (const auto& point : sheet.points()) {
      const auto at = in_double(point);
      const bool is_clamped = std::any_of(at.begin(), at.end(), [](double x) {
        return x >= static_cast<double>(largest<S>) || x <= static_cast<double>(lowest<S>);
      });
      if (is_clamped) {
        has_corner = true;
        continue;
      }
      const double off = inner(normal, at) - static_cast<double>(plane.offset);
      REQUIRE(std::abs(off) <= 2 * slack<S>(reach + norm(middle), norm(middle) + from));
      const double away = norm(minus(at, middle));
      REQUIRE(away <= reach * std::sqrt(N - 1.0) + 2 * slack<S>(reach, norm(middle)));
      has_corner |= away >= reach * std::sqrt(N - 1.0) - 2 * slack<S>(reach, norm(middle));
    }
    REQUIRE(has_corner);
    if constexpr (N == 3) {
      Sheet<S, 3> solid;
      draw_solid(solid, plane, ink, region);
      REQUIRE(solid.faces.size() == 2);
    }
  }
}

TEMPLATE_TEST_CASE("draw: a ray ends at its length or at the end of the range", "[draw]",
                   DETENT_FIXED_SPACES) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  Random random(5);
  int ended = 0;
  for (int i = 0; i < cases; ++i) {
    const Ray<S, N> ray{any_point<S, N>(random), any_direction<S, N>(random),
                        random.coin() ? largest<S> : any_length<S>(random)};
    const auto sheet = drawn<S, N>(ray);
    REQUIRE(sheet.lines.size() == 1);
    REQUIRE(sheet.lines[0].a == ray.origin);
    const auto along = minus(in_double(sheet.lines[0].b), in_double(ray.origin));
    const auto direction = in_double(ray.direction.vec());
    const double length = norm(along);
    for (std::size_t k = 0; k < 3; ++k) {
      REQUIRE(std::abs(along[k] - length * direction[k]) <= 2 * slack<S>(length, 0));
    }
    const double rest = static_cast<double>(ray.max_distance) - length;
    bool is_at_end = false;
    for (int k = 0; k < N; ++k) {
      const auto off = std::min(static_cast<double>(largest<S>) -
                                    in_double(sheet.lines[0].b)[static_cast<std::size_t>(k)],
                                in_double(sheet.lines[0].b)[static_cast<std::size_t>(k)] -
                                    static_cast<double>(lowest<S>));
      is_at_end |= off <= 2 * slack<S>(length, 0);
    }
    ended += !is_at_end;
    REQUIRE((is_at_end || rest <= 2 * slack<S>(length, 0)));
  }
  CHECK(ended > cases / 10);
  CHECK(ended < cases * 19 / 20);
}

TEMPLATE_TEST_CASE("draw: empty shapes draw nothing, and flat ones only their extent", "[draw]",
                   DETENT_EVERY_SPACE) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  const auto one = num<S>(1), less = num<S>(-1);
  CHECK(drawn<S, N>(Sphere{at<S, N>(1), less}).is_blank());
  CHECK(drawn<S, N>(Capsule{at<S, N>(1), at<S, N>(2), less}).is_blank());
  CHECK(drawn<S, N>(Aabb{at<S, N>(0, 1), at<S, N>(1, 0)}).is_blank());
  CHECK(drawn<S, N>(Obb<S, N>{at<S, N>(0), at<S, N>(1, -1), {}}).is_blank());
  CHECK(drawn<S, N>(Ray{at<S, N>(0), toward<S, N>(1), less}).is_blank());
  CHECK(drawn<S, N>(ConvexHull<S, N>{}).is_blank());
  CHECK(drawn<S, N>(Compound<Sphere<S, N>>()).is_blank());
  CHECK(drawn<S, N>(Compound{std::array{Sphere{at<S, N>(1), less}}}).is_blank());
  const Segment segment{at<S, N>(1, 2), at<S, N>(3, 4)};
  REQUIRE(drawn<S, N>(segment).lines.size() == 1);
  CHECK(drawn<S, N>(segment).lines[0].b == segment.end);
  const auto triangle = drawn<S, N>(Triangle{at<S, N>(0), at<S, N>(1), at<S, N>(0, 1)});
  REQUIRE(triangle.lines.size() == 3);
  for (std::size_t i = 0; i < 3; ++i) CHECK(triangle.lines[i].b == triangle.lines[(i + 1) % 3].a);
  const std::array balls{Sphere{at<S, N>(1), one}, Sphere{at<S, N>(2), one}};
  const std::array boxes{Aabb{at<S, N>(1), at<S, N>(2)}};
  CHECK(drawn<S, N>(Compound{balls, boxes}).lines.size() == (N == 2 ? 68 : 204));
  if constexpr (N == 3) {
    CHECK(drawn_solid<S>(Sphere{at<S, N>(1), less}).is_blank());
    CHECK(drawn_solid<S>(Aabb{at<S, N>(0, 1), at<S, N>(1, 0)}).is_blank());
    CHECK(drawn_solid<S>(Obb<S, N>{at<S, N>(0), at<S, N>(1, -1), {}}).is_blank());
    CHECK(drawn_solid<S>(ConvexHull<S, N>{}).is_blank());
    CHECK(drawn_solid<S>(Compound{balls, boxes}).faces.size() == 2 * 224 + 12);
    CHECK(drawn_solid<S>(Triangle{at<S, N>(0), at<S, N>(1), at<S, N>(0, 1)}).faces.size() == 1);
  }
}

TEMPLATE_TEST_CASE("draw_solid: the sides of a box enclose its volume", "[draw]",
                   DETENT_EVERY_SCALAR) {
  using S = TestType;
  const auto volume = [](const Sheet<S, 3>& sheet) {
    double six_times = 0;
    for (const auto& face : sheet.faces) {
      const auto a = in_double(face.a), b = in_double(face.b), c = in_double(face.c);
      six_times += a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
                   a[2] * (b[0] * c[1] - b[1] * c[0]);
    }
    return six_times / 6;
  };
  const auto box = drawn_solid<S>(Aabb{at<S, 3>(1, 2, 3), at<S, 3>(3, 5, 7)});
  CHECK(box.faces.size() == 12);
  CHECK(volume(box) == 24);
  const auto turned = drawn_solid<S>(
      Obb<S, 3>{at<S, 3>(-3, 5, 2), at<S, 3>(1, 2, 4),
                Rotation<S, 3>::from_axis_angle(toward<S, 3>(0, 0, 1), Angle<S>::turn(1, 4))});
  CHECK(std::abs(volume(turned) - 64) < 0.01);
  const double ball = volume(drawn_solid<S>(Sphere{at<S, 3>(3, 3, 3), num<S>(4)}));
  CHECK(ball > 0.9 * 268.08);
  CHECK(ball < 268.08);
}

TEMPLATE_TEST_CASE("draw: points beyond the scalar's range are clamped", "[draw]",
                   DETENT_FIXED_SPACES) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  const auto sheet = drawn<S, N>(Sphere{filled<S, N>(S::max()), S::max()});
  S least = S::max();
  for (const auto& point : sheet.points()) least = std::min(least, point[0]);
  CHECK(sheet.lines[0].a[0] == S::max());
  CHECK(least <= num<S>(1));
  const auto box = drawn<S, N>(Obb<S, N>{filled<S, N>(S::lowest()), filled<S, N>(S::max()), {}});
  for (const auto& point : box.points()) {
    for (int i = 0; i < N; ++i) {
      CHECK((point[i] == S::lowest() || point[i] == S::from_raw(static_cast<typename S::raw_type>(
                                                        S::lowest().raw() + S::max().raw()))));
    }
  }
}

}  // namespace
}  // namespace detent::test
