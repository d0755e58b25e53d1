// SPDX-License-Identifier: MIT
#include "detent/dynamics/mass.hpp"

#include <algorithm>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <boost/multiprecision/cpp_int.hpp>
#include <vector>

#include "oracle/draw.hpp"
#include "oracle/space.hpp"
#include "query/raycast/helpers.hpp"

namespace detent::test {
namespace {

using boost::multiprecision::cpp_int;
using boost::multiprecision::cpp_rational;
using Real = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<400>>;
using Point = std::vector<cpp_rational>;

template <class Number>
Number power_of_two(int exponent) {
  Number result = 1;
  for (; exponent > 0; --exponent) result *= 2;
  for (; exponent < 0; ++exponent) result /= 2;
  return result;
}

template <class Int>
cpp_int integer(const Int& raw) {
  const Wide<4> wide = integer_cast<Wide<4>>(raw);
  const Wide<4> magnitude = wide.is_negative() ? -wide : wide;
  cpp_int result = 0;
  for (int i = 3; i >= 0; --i) result = (result << 64) + cpp_int(magnitude.word(i));
  return wide.is_negative() ? cpp_int(-result) : result;
}

template <int B, int F>
cpp_rational value(const Fixed<B, F>& x) {
  return cpp_rational(integer(x.raw())) * power_of_two<cpp_rational>(-F);
}

/// `exact` rounded to nearest, ties to even, on the grid of T and clamped, as a raw integer.
template <class T>
cpp_int nearest(const cpp_rational& exact) {
  const cpp_rational scaled = exact * power_of_two<cpp_rational>(T::frac + 1);
  const cpp_int twice =
      numerator(scaled) >= 0
          ? cpp_int(numerator(scaled) / denominator(scaled))
          : cpp_int(-((-numerator(scaled) + denominator(scaled) - 1) / denominator(scaled)));
  const bool whole = scaled == cpp_rational(twice);
  cpp_int down = twice >> 1;  // floor
  const bool half = cpp_int(twice - 2 * down) == 1;
  if (half && (!whole || down % 2 != 0)) ++down;
  const cpp_int limit = cpp_int(1) << T::bits;
  return std::max(cpp_int(-limit), std::min(cpp_int(limit - 1), down));
}

/// The exact mass properties of a solid with N! times this volume and these volume integrals.
template <int N>
struct Integrals {
  cpp_rational volume = 0;
  Point first = Point(N);
  std::vector<Point> second = std::vector<Point>(N, Point(N));

  /// Adds a simplex by a quadrature rule that is exact for polynomials of degree 2: the edge
  /// midpoints in 2D; in 3D corners and midpoints with weights -1/20 and 1/5.
  void add(const std::vector<Point>& corners) {
    std::vector<std::vector<cpp_rational>> m;
    for (std::size_t i = 1; i <= N; ++i) {
      m.push_back(corners[i]);
      for (std::size_t k = 0; k < N; ++k) m.back()[k] -= corners[0][k];
    }
    cpp_rational content = m[0][0] * m[1][1] - m[0][1] * m[1][0];
    if constexpr (N == 3) {
      content = m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
                m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
                m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
    }
    content /= N == 2 ? 2 : 6;
    const auto sample = [&](const Point& p, const cpp_rational& weight) {
      volume += weight;
      for (std::size_t i = 0; i < N; ++i) {
        first[i] += weight * p[i];
        for (std::size_t j = 0; j < N; ++j) second[i][j] += weight * p[i] * p[j];
      }
    };
    for (std::size_t a = 0; a <= N; ++a) {
      if (N == 3) sample(corners[a], -content / 20);
      for (std::size_t b = 0; b < a; ++b) {
        Point middle = corners[a];
        for (std::size_t i = 0; i < N; ++i) middle[i] = (middle[i] + corners[b][i]) / 2;
        sample(middle, content / (N == 2 ? 3 : 5));
      }
    }
  }
};

template <Scalar S, int N>
void check_inverse(const MassProperties<S, N>& given) {
  using Inverse = typename detail::MassFormats<S>::InverseGyration;
  if constexpr (N == 2) {
    const auto k = value(given.gyration);
    REQUIRE(integer(given.inverse_gyration.raw()) == nearest<Inverse>(1 / k));
  } else {
    // Gauss-Jordan elimination; the pivots of a positive definite matrix are positive.
    std::vector<Point> m(3, Point(6));
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j)
        m[std::size_t(i)][std::size_t(j)] = value(given.gyration.at(i, j));
      m[std::size_t(i)][std::size_t(3 + i)] = 1;
    }
    for (std::size_t p = 0; p < 3; ++p) {
      const cpp_rational pivot = m[p][p];
      REQUIRE(pivot > 0);
      for (auto& x : m[p]) x /= pivot;
      for (std::size_t r = 0; r < 3; ++r) {
        const cpp_rational factor = m[r][p];
        for (std::size_t c = 0; r != p && c < 6; ++c) m[r][c] -= factor * m[p][c];
      }
    }
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) {
        REQUIRE(integer(given.inverse_gyration.at(i, j).raw()) ==
                nearest<Inverse>(m[std::size_t(i)][std::size_t(3 + j)]));
      }
    }
  }
}

template <Scalar S, int N>
void check(const MassProperties<S, N>& given, const Integrals<N>& exact, const S& density) {
  using Formats = detail::MassFormats<S>;
  using Mass = typename Formats::Mass;
  using Gyration = typename Formats::Gyration;
  const auto mass = nearest<Mass>(exact.volume * value(density));
  if (mass <= 0) {
    REQUIRE(given == MassProperties<S, N>{});
    return;
  }
  REQUIRE(integer(given.mass.raw()) == mass);
  std::vector<Point> central(N, Point(N));
  for (std::size_t i = 0; i < N; ++i) {
    const cpp_rational center = exact.first[i] / exact.volume;
    REQUIRE(integer(given.center[int(i)].raw()) == nearest<typename Formats::Center>(center));
    for (std::size_t j = 0; j < N; ++j) {
      central[i][j] = exact.second[i][j] / exact.volume - center * exact.first[j] / exact.volume;
    }
  }
  if constexpr (N == 2) {
    REQUIRE(integer(given.gyration.raw()) == nearest<Gyration>(central[0][0] + central[1][1]));
  } else {
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) {
        cpp_rational entry = -central[std::size_t(i)][std::size_t(j)];
        for (std::size_t k = 0; i == j && k < 3; ++k) entry += central[k][k];
        REQUIRE(integer(given.gyration.at(i, j).raw()) == nearest<Gyration>(entry));
      }
    }
  }
  check_inverse(given);
}

template <Scalar S, int N>
Point point_of(const Vec<S, N>& p) {
  Point result;
  for (int i = 0; i < N; ++i) result.push_back(value(p[i]));
  return result;
}

/// Splits a box into simplices: the paths from its least corner to the opposite one along every
/// order of the axes.
template <Scalar S, int N>
Integrals<N> of_box(const Vec<S, N>& low, const Vec<S, N>& high) {
  Integrals<N> result;
  std::vector<std::size_t> order(N);
  for (std::size_t i = 0; i < N; ++i) order[i] = i;
  bool odd = false;
  do {
    std::vector<Point> corners{point_of(low)};
    for (const auto axis : order) {
      corners.push_back(corners.back());
      corners.back()[axis] = value(high[int(axis)]);
    }
    odd = false;
    for (std::size_t i = 0; i < N; ++i) {
      for (std::size_t j = 0; j < i; ++j) odd = odd != (order[j] > order[i]);
    }
    if (odd) std::swap(corners[0], corners[1]);
    result.add(corners);
  } while (std::next_permutation(order.begin(), order.end()));
  return result;
}

/// The simplices of a hull in general position, from its first point to each facet (N points with
/// all others on one side). Nothing if some facet has more points.
template <Scalar S, int N>
std::optional<Integrals<N>> of_hull(const std::vector<Vec<S, N>>& points) {
  Integrals<N> result;
  const std::size_t n = points.size();
  const auto height = [&](std::size_t i, std::size_t j, std::size_t k, std::size_t l) {
    if constexpr (N == 2) {
      return sign_of(cross(points[j] - points[i], points[l] - points[i]).raw());
    } else {
      return sign_of(
          dot(cross(points[j] - points[i], points[k] - points[i]), points[l] - points[i]).raw());
    }
  };
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = i + 1; j < n; ++j) {
      for (std::size_t k = N == 2 ? n - 1 : j + 1; k < n; ++k) {
        int above = 0, below = 0;
        for (std::size_t l = 0; l < n; ++l) {
          if (l == i || l == j || (N == 3 && l == k)) continue;
          const int side = height(i, j, k, l);
          if (side == 0) return std::nullopt;
          ++(side > 0 ? above : below);
        }
        if (above != 0 && below != 0) continue;
        // The first point is inside, or on the facet, where the simplex has no volume.
        std::vector<Point> corners{point_of(points[0]), point_of(points[i]), point_of(points[j])};
        if (N == 3) corners.push_back(point_of(points[k]));
        if ((N == 2) == (above == 0)) std::swap(corners[1], corners[2]);
        result.add(corners);
      }
    }
  }
  return result;
}

TEMPLATE_TEST_CASE("mass: simple shapes have their textbook values", "[mass]", q16_16, q14_16,
                   q24_8, double) {
  using S = TestType;
  const auto box = mass_properties(Aabb{at<S, 3>(-1, -2, -3), at<S, 3>(1, 2, 3)}, num<S>(2));
  CHECK(box.mass == 96);
  CHECK(box.center == decltype(box.center){});
  CHECK(box.gyration.at(0, 1) == 0);
  CHECK(box.gyration.at(2, 2) * 3 > num<S>(4.75));
  CHECK(box.gyration.at(2, 2) * 3 < num<S>(5.25));
  const auto flat = mass_properties(Obb<S, 2>{at<S, 2>(5, 6), at<S, 2>(1, 2), {}}, num<S>(3));
  CHECK(flat.mass == 24);
  CHECK(flat.center == Vec{decltype(flat.center.x)(num<S>(5)), decltype(flat.center.x)(num<S>(6))});
  CHECK(mass_properties(Sphere<S, 2>{at<S, 2>(0, 0), num<S>(2)}, num<S>(1)).gyration == 2);
}

TEMPLATE_TEST_CASE("mass: is 0 without volume or density", "[mass]", q16_16, q8_8, float) {
  using S = TestType;
  using Flat = MassProperties<S, 2>;
  using Solid = MassProperties<S, 3>;
  const S one = num<S>(1);
  CHECK(mass_properties(Sphere<S, 3>{at<S, 3>(1, 1, 1), num<S>(0)}, one) == Solid{});
  CHECK(mass_properties(Sphere<S, 2>{at<S, 2>(1, 1), num<S>(-1)}, one) == Flat{});
  CHECK(mass_properties(Capsule<S, 3>{at<S, 3>(0, 0, 0), at<S, 3>(1, 1, 1), num<S>(0)}, one) ==
        Solid{});
  CHECK(mass_properties(Aabb{at<S, 3>(0, 0, 0), at<S, 3>(1, 1, 0)}, one) == Solid{});
  CHECK(mass_properties(Aabb{at<S, 2>(0, 0), at<S, 2>(-1, -1)}, one) == Flat{});
  CHECK(mass_properties(Obb<S, 3>{{}, at<S, 3>(-1, -1, 1), {}}, one) == Solid{});
  CHECK(mass_properties(Sphere<S, 3>{{}, one}, num<S>(0)) == Solid{});
  CHECK(mass_properties(Sphere<S, 3>{{}, one}, num<S>(-2)) == Solid{});
  CHECK(mass_properties(ConvexHull<S, 3>{}, one) == Solid{});
  const std::array<Vec<S, 3>, 4> square{at<S, 3>(0, 0, 1), at<S, 3>(1, 0, 1), at<S, 3>(1, 1, 1),
                                        at<S, 3>(0, 1, 1)};
  CHECK(mass_properties(ConvexHull{square}, one) == Solid{});
  const std::array<Vec<S, 2>, 3> line{at<S, 2>(0, 0), at<S, 2>(1, 1), at<S, 2>(2, 2)};
  CHECK(mass_properties(ConvexHull{line}, one) == Flat{});
  CHECK(mass_properties(std::span<const Solid>{}) == Solid{});
}

template <Scalar S, int N>
void check_boxes() {
  oracle::Draw<S, N> draw(0x3a55b + N);
  INFO(draw.random);
  int solid = 0;
  for (int i = 0; i < 150; ++i) {
    const auto reach = draw.scale();
    auto low = draw.vec(draw.random.one_in(4) ? draw.extreme_point() : draw.point(reach));
    auto high = draw.vec(draw.random.one_in(4) ? draw.extreme_point() : draw.point(reach));
    for (int k = 0; k < N; ++k) {
      if (high[k] < low[k]) std::swap(low[k], high[k]);
    }
    const S density = draw.scalar(draw.random.edgy(S::bits));
    const auto given = mass_properties(Aabb<S, N>{low, high}, density);
    check(given, of_box(low, high), density);
    solid += given.mass > 0 ? 1 : 0;
    // The same box as a hull of its corners, with interior points.
    std::vector<Vec<S, N>> corners{nearest_to<S>(half(low + high)), low, low};
    for (int c = 0; c < (1 << N); ++c) {
      corners.push_back(make_vec<N>([&](int k) { return (c >> k) % 2 == 0 ? low[k] : high[k]; }));
    }
    for (std::size_t k = corners.size(); k > 1; --k) {
      std::swap(corners[k - 1], corners[draw.random.below(k)]);
    }
    if (i % 4 == 0) CHECK(mass_properties(ConvexHull<S, N>{corners}, density) == given);
  }
  CHECK(solid > 40);
}

TEMPLATE_TEST_CASE("mass: of boxes, with each number rounded once", "[mass][oracle]",
                   DETENT_FIXED_SCALARS) {
  check_boxes<TestType, 2>();
  check_boxes<TestType, 3>();
}

template <Scalar S, int N>
void check_turned_boxes() {
  oracle::Draw<S, N> draw(0x0bb + N);
  INFO(draw.random);
  for (int i = 0; i < 100; ++i) {
    const auto reach = draw.scale();
    Obb<S, N> box{draw.vec(draw.point(reach)), draw.vec(draw.point(reach)), draw.rotation()};
    for (int k = 0; k < N; ++k) box.half_extents[k] = nearest_to<S>(abs(box.half_extents[k]));
    const S density = draw.scalar(draw.random.between(1, 1 << 20));
    const auto given = mass_properties(box, density);
    if (given.mass <= 0) continue;
    cpp_rational content = value(density);
    for (int k = 0; k < N; ++k) content *= 2 * value(box.half_extents[k]);
    REQUIRE(integer(given.mass.raw()) == nearest<typename detail::MassFormats<S>::Mass>(content));
    // Along each axis, the second moment is a third of the squared half extent.
    if constexpr (N == 3) {
      for (int r = 0; r < 3; ++r) {
        for (int c = 0; c < 3; ++c) {
          cpp_rational entry = 0;
          for (int k = 0; k < 3; ++k) {
            const cpp_rational h = value(box.half_extents[k]);
            for (int axis = 0; axis < 3; ++axis) {
              if (axis == k) continue;
              entry +=
                  h * h / 3 * value(box.rotation.axis(axis)[r]) * value(box.rotation.axis(axis)[c]);
            }
          }
          REQUIRE(integer(given.gyration.at(r, c).raw()) ==
                  nearest<typename detail::MassFormats<S>::Gyration>(entry));
        }
      }
    }
    check_inverse(given);
  }
}

TEMPLATE_TEST_CASE("mass: of oriented boxes, with each number rounded once", "[mass][oracle]",
                   q16_16, q24_8, q8_8) {
  check_turned_boxes<TestType, 2>();
  check_turned_boxes<TestType, 3>();
}

template <Scalar S, int N>
void check_hulls() {
  oracle::Draw<S, N> draw(0x4011 + N);
  INFO(draw.random);
  int known = 0;
  for (int i = 0; i < 120; ++i) {
    const auto reach = draw.scale();
    std::vector<Vec<S, N>> points;
    for (auto n = draw.random.between(N + 1, 9); n > 0; --n) {
      points.push_back(draw.vec(draw.random.one_in(8) ? draw.extreme_point() : draw.point(reach)));
    }
    const auto exact = of_hull(points);
    if (!exact) continue;
    const S density = draw.scalar(draw.random.between(1, 1 << 12));
    if (draw.random.coin()) points.push_back(points[draw.random.below(points.size())]);
    const auto given = mass_properties(ConvexHull<S, N>{points}, density);
    check(given, *exact, density);
    known += given.mass > 0 ? 1 : 0;
  }
  CHECK(known > 60);
}

TEMPLATE_TEST_CASE("mass: of hulls, with each number rounded once", "[mass][oracle]",
                   DETENT_FIXED_SCALARS) {
  check_hulls<TestType, 2>();
  check_hulls<TestType, 3>();
}

TEMPLATE_TEST_CASE("mass: of hulls in float equals that of double", "[mass]", float) {
  oracle::Draw<q16_16, 3> draw(0xf10a7);
  INFO(draw.random);
  for (int i = 0; i < 40; ++i) {
    std::vector<Vec<float, 3>> points;
    std::vector<Vec<double, 3>> fine;
    for (int k = 0; k < 12; ++k) {
      const auto raw = draw.point(1 << 16);
      fine.push_back(make_vec<3>([&](int c) { return double(raw[std::size_t(c)]) / (1 << 16); }));
      points.push_back(make_vec<3>([&](int c) { return float(fine.back()[c]); }));
    }
    const auto given = mass_properties(ConvexHull<float, 3>{points}, 1.0f);
    const auto exact = mass_properties(ConvexHull<double, 3>{fine}, 1.0);
    CHECK(std::abs(double(given.mass) - exact.mass) < 1e-5 * exact.mass);
    CHECK(std::abs(double(given.gyration.diagonal.x) - exact.gyration.diagonal.x) < 1e-4);
  }
}

/// Whether `given` is `exact` rounded to nearest; pi and the root are irrational.
template <class T>
bool is_nearest(const T& given, const Real& exact) {
  const Real scaled = exact * power_of_two<Real>(T::frac);
  const Real limit = power_of_two<Real>(T::bits);
  const Real clamped = scaled > limit - 1 ? Real(limit - 1) : scaled;
  return abs(Real(integer(given.raw())) - clamped) < Real(0.5) + power_of_two<Real>(-40);
}

const Real& pi() {
  static const Real value = boost::math::constants::pi<Real>();
  return value;
}

template <Scalar S>
Real real(const S& x) {
  return Real(integer(x.raw())) * power_of_two<Real>(-S::frac);
}

/// Capsules and balls as a cylinder and two half balls, each around its own center and shifted to
/// the capsule's (Steiner).
template <Scalar S>
void check_round_solids() {
  using Formats = detail::MassFormats<S>;
  oracle::Draw<S, 3> draw(0xca5);
  INFO(draw.random);
  int solid = 0;
  for (int i = 0; i < 150; ++i) {
    const auto reach = draw.scale();
    Capsule<S, 3> shape{draw.vec(draw.point(reach)), draw.vec(draw.point(reach)),
                        draw.scalar(draw.random.between(1, reach))};
    if (draw.random.one_in(6)) shape.b = shape.a;
    if (draw.random.one_in(6)) {
      shape = {draw.vec(draw.extreme_point()), draw.vec(draw.extreme_point()),
               draw.scalar(std::abs(draw.extreme()))};
    }
    const S density = draw.scalar(draw.random.between(1, 1 << 12));
    const auto given = mass_properties(shape, density);
    if (shape.a == shape.b) {
      CHECK(given == mass_properties(Sphere<S, 3>{shape.a, shape.radius}, density));
    }
    const Real r = real(shape.radius);
    Real d[3], squared = 0;
    cpp_int raw_squared = 0;
    for (int k = 0; k < 3; ++k) {
      d[k] = real(shape.b[k]) - real(shape.a[k]);
      squared += d[k] * d[k];
      const cpp_int raw = integer(shape.b[k].raw()) - integer(shape.a[k].raw());
      raw_squared += raw * raw;
    }
    const Real l =
        Real(cpp_int(sqrt(cpp_int(raw_squared << 48)))) * power_of_two<Real>(-24 - S::frac);
    const Real tube = pi() * r * r * l, bulb = pi() * r * r * r * 2 / 3;
    const Real volume = tube + 2 * bulb;
    const Real mass = volume * real(density);
    if (given.mass <= 0) {
      CHECK(mass * power_of_two<Real>(Formats::Mass::frac) < Real(0.51));
      continue;
    }
    ++solid;
    CHECK(is_nearest(given.mass, mass));
    const Real mean = 3 * r / 8;
    const Real bulb_along = r * r / 5 - mean * mean + (l / 2 + mean) * (l / 2 + mean);
    const Real along = (tube * l * l / 12 + 2 * bulb * bulb_along) / volume;
    const Real across = (tube * r * r / 4 + 2 * bulb * r * r / 5) / volume;
    for (int row = 0; row < 3; ++row) {
      CHECK(is_nearest(given.center[row], (real(shape.a[row]) + real(shape.b[row])) / 2));
      for (int c = 0; c < 3; ++c) {
        // The part along u is (along - across) u u^T with u = d / l.
        const Real share = l == 0 ? Real(0) : Real((along - across) / (l * l));
        Real entry = -share * d[row] * d[c];
        if (row == c) entry += 2 * across + share * squared;
        CHECK(is_nearest(given.gyration.at(row, c), entry));
      }
    }
    check_inverse(given);
  }
  CHECK(solid > 60);
}

TEMPLATE_TEST_CASE("mass: of capsules and balls, with each number rounded once", "[mass][oracle]",
                   DETENT_FIXED_SCALARS) {
  check_round_solids<TestType>();
}

TEMPLATE_TEST_CASE("mass: of stadiums and discs, with each number rounded once", "[mass][oracle]",
                   q16_16, q24_8, q8_8) {
  using S = TestType;
  oracle::Draw<S, 2> draw(0x57ad);
  INFO(draw.random);
  for (int i = 0; i < 150; ++i) {
    const auto reach = draw.scale();
    Capsule<S, 2> shape{draw.vec(draw.point(reach)), draw.vec(draw.point(reach)),
                        draw.scalar(draw.random.between(1, reach))};
    if (draw.random.one_in(6)) shape.b = shape.a;
    const S density = draw.scalar(draw.random.between(1, 1 << 12));
    const auto given = mass_properties(shape, density);
    if (shape.a == shape.b) {
      CHECK(given == mass_properties(Sphere<S, 2>{shape.a, shape.radius}, density));
    }
    if (given.mass <= 0) continue;
    const Real r = real(shape.radius);
    cpp_int raw_squared = 0;
    for (int k = 0; k < 2; ++k) {
      const cpp_int raw = integer(shape.b[k].raw()) - integer(shape.a[k].raw());
      raw_squared += raw * raw;
    }
    const Real l =
        Real(cpp_int(sqrt(cpp_int(raw_squared << 48)))) * power_of_two<Real>(-24 - S::frac);
    const Real middle = 2 * r * l, disc = pi() * r * r;
    CHECK(is_nearest(given.mass, Real((middle + disc) * real(density))));
    const Real mean = 4 * r / (3 * pi());
    const Real part = r * r / 2 - mean * mean + (l / 2 + mean) * (l / 2 + mean);
    const Real polar = (middle * (l * l + 4 * r * r) / 12 + disc * part) / (middle + disc);
    CHECK(is_nearest(given.gyration, polar));
    check_inverse(given);
  }
}

template <Scalar S, int N>
void check_sums() {
  oracle::Draw<S, N> draw(0x5a3 + N);
  INFO(draw.random);
  for (int i = 0; i < 60; ++i) {
    const auto reach = draw.scale() / 4 + 64;
    std::vector<Aabb<S, N>> boxes;
    std::vector<Sphere<S, N>> balls;
    std::vector<MassProperties<S, N>> parts;
    for (int k = 0; k < 3; ++k) {
      const auto low = draw.point(reach);
      auto high = low;
      for (auto& c : high) c += draw.random.between(1, reach);
      boxes.push_back({draw.vec(low), draw.vec(high)});
      balls.push_back({draw.vec(draw.point(reach)), draw.scalar(draw.random.between(1, reach))});
    }
    const S density = draw.scalar(draw.random.between(1, 1 << 12));
    for (const auto& box : boxes) parts.push_back(mass_properties(box, density));
    for (const auto& ball : balls) parts.push_back(mass_properties(ball, density));
    const std::span<const MassProperties<S, N>> all(parts);
    const auto given = mass_properties(all);
    CHECK(given == mass_properties(Compound(boxes, balls), density));
    std::reverse(parts.begin(), parts.end());
    CHECK(given == mass_properties(all));
    if (given.mass <= 0) continue;
    cpp_rational mass = 0;
    Point center(N);
    for (const auto& part : parts) {
      mass += value(part.mass);
      for (std::size_t k = 0; k < N; ++k)
        center[k] += value(part.mass) * value(part.center[int(k)]);
    }
    using Formats = detail::MassFormats<S>;
    CHECK(integer(given.mass.raw()) == nearest<typename Formats::Mass>(mass));
    for (std::size_t k = 0; k < N; ++k) {
      CHECK(integer(given.center[int(k)].raw()) ==
            nearest<typename Formats::Center>(center[k] / mass));
    }
    // Steiner: every part about the rounded center.
    const auto entry = [&](int r, int c) {
      cpp_rational sum = 0;
      for (const auto& part : parts) {
        const auto offset = [&](int k) {
          return cpp_rational(value(part.center[k]) - value(given.center[k]));
        };
        cpp_rational squared = 0;
        for (int k = 0; k < N; ++k) squared += offset(k) * offset(k);
        cpp_rational moved = 0;
        if constexpr (N == 2) {
          moved = value(part.gyration) + squared;
        } else {
          moved = value(part.gyration.at(r, c)) - offset(r) * offset(c);
          if (r == c) moved += squared;
        }
        sum += value(part.mass) * moved;
      }
      return nearest<typename Formats::Gyration>(sum / mass);
    };
    if constexpr (N == 2) {
      CHECK(integer(given.gyration.raw()) == entry(0, 0));
    } else {
      for (int r = 0; r < 3; ++r) {
        for (int c = 0; c < 3; ++c) CHECK(integer(given.gyration.at(r, c).raw()) == entry(r, c));
      }
    }
    check_inverse(given);
  }
}

TEMPLATE_TEST_CASE("mass: parts add up, in any order", "[mass][oracle]", q16_16, q24_8, q8_8) {
  check_sums<TestType, 2>();
  check_sums<TestType, 3>();
}

static_assert(mass_properties(Aabb<q16_16, 2>{{}, {q16_16(1), q16_16(2)}}, q16_16(3)).mass == 6);

}  // namespace
}  // namespace detent::test
