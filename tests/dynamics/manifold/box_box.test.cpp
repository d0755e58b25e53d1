// SPDX-License-Identifier: MIT
#include "detent/dynamics/manifold/box_box.hpp"

#include <cmath>
#include <optional>
#include <vector>

#include "dynamics/manifold/rational.hpp"
#include "support/random.hpp"

namespace detent::test {
namespace {

/// Converts to steps of a lever or gap; ratios stay as they are.
template <Number T, int N>
Point exact(const Vec<T, N>& v, int frac) {
  Point result;
  for (int i = 0; i < N; ++i) {
    result.push_back(Rational(static_cast<std::int64_t>(v[i].raw()), std::int64_t{1} << frac));
  }
  return result;
}

/// Two boxes: half extents, and the pose of the second in the frame of the first.
template <Scalar S, int N>
struct Boxes {
  Vec<lever<S>, N> a, b;
  detail::RelativePose<S, N> pose;
};

/// Boxes of about `size` steps that roughly touch, with small or large rotations.
template <Scalar S, int N>
Boxes<S, N> draw_boxes(Random& random, double size) {
  const auto unit = [&] { return static_cast<double>(random.between(-10000, 10000)) / 10000; };
  const auto steps = [](double x) {
    return lever<S>::from_raw(
        static_cast<std::int32_t>(std::clamp(std::llround(x), -(1LL << 31), (1LL << 31) - 1)));
  };
  Boxes<S, N> boxes;
  std::array<double, 4> q{unit(), unit(), unit(), unit()};
  const int kind = static_cast<int>(random.below(4));  // 0: aligned, 1: nearly
  if (kind <= 1) {
    q[0] = 1;
    for (int i = 1; i < 4; ++i) q[i] *= kind * std::ldexp(1, -static_cast<int>(random.below(24)));
    if (random.one_in(4)) q[1] = q[0];  // a quarter turn
  }
  if (N == 2) q[1] = q[2] = 0;
  turn(boxes.pose, q);
  const auto side = static_cast<int>(random.below(N));
  for (int i = 0; i < N; ++i) {
    boxes.a[i] = steps(size * (0.55 + 0.45 * unit()));
    boxes.b[i] = random.one_in(4) ? boxes.a[i] : steps(size * (0.55 + 0.45 * unit()));
  }
  for (int i = 0; i < N; ++i) {
    // One side touches and the others overlap or are flush; sometimes anywhere.
    const double both =
        static_cast<double>(boxes.a[i].raw()) + static_cast<double>(boxes.b[i].raw());
    double offset = random.one_in(4) ? 0 : 1.2 * unit() * both;
    if (i == side && kind <= 1) offset = both * (random.coin() ? 1 : -1) * (1 + 0.01 * unit());
    boxes.pose.translation[i] = steps(offset);
  }
  return boxes;
}

template <Scalar S, int N>
std::vector<Point> corners_of(const Boxes<S, N>& boxes, bool of_b) {
  std::vector<Point> corners;
  const auto t = exact(boxes.pose.translation, 0);
  for (int c = 0; c < (1 << N); ++c) {
    Point local = exact(of_b ? boxes.b : boxes.a, 0);
    for (std::size_t i = 0; i < N; ++i) {
      if ((c >> i) % 2 != 0) local[i] = -local[i];
    }
    if (of_b) {
      Point p = t;
      for (std::size_t j = 0; j < N; ++j) {
        const auto axis = exact(boxes.pose.axes[j], 30);
        for (std::size_t i = 0; i < N; ++i) p[i] += axis[i] * local[j];
      }
      local = p;
    }
    corners.push_back(local);
  }
  return corners;
}

/// The gap along `n`: the least projection of b's corners minus the greatest of a's.
Rational support_gap(const std::vector<Point>& a, const std::vector<Point>& b, const Point& n) {
  Rational most = dot(a[0], n), least = dot(b[0], n);
  for (const auto& p : a) most = std::max(most, dot(p, n));
  for (const auto& p : b) least = std::min(least, dot(p, n));
  return least - most;
}

double as_double(const Rational& x) { return static_cast<double>(x); }

/// The greatest gap over all axes (face normals and cross products of edges), in steps.
template <Scalar S, int N>
double greatest_gap(const Boxes<S, N>& boxes) {
  const auto a = corners_of(boxes, false), b = corners_of(boxes, true);
  double best = -1e300;
  const auto offer = [&](Point n) {
    const double length = std::sqrt(as_double(dot(n, n)));
    if (length < 1.0 / 64) return;
    for (int side = 0; side < 2; ++side) {
      best = std::max(best, as_double(support_gap(a, b, n)) / length);
      for (auto& x : n) x = -x;
    }
  };
  for (std::size_t i = 0; i < N; ++i) {
    Point e(N);
    e[i] = 1;
    offer(e);
    const auto r = exact(boxes.pose.axes[i], 30);
    offer(r);
    for (std::size_t k = 0; N == 3 && k < 3; ++k) {
      const auto u = exact(boxes.pose.axes[k], 30);
      Point l(3);
      l[(i + 1) % 3] = -u[(i + 2) % 3];
      l[(i + 2) % 3] = u[(i + 1) % 3];
      offer(l);
    }
  }
  return best;
}

/// Clips a convex polygon (a segment in 2D) to n . x <= limit.
std::vector<Point> cut(const std::vector<Point>& polygon, const Point& n, const Rational& limit) {
  std::vector<Point> result;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const auto& p = polygon[i];
    const auto& q = polygon[(i + 1) % polygon.size()];
    const Rational u = limit - dot(p, n), v = limit - dot(q, n);
    if (u >= 0) result.push_back(p);
    if ((u > 0 && v < 0) || (u < 0 && v > 0)) {
      Point mid = p;
      for (std::size_t k = 0; k < p.size(); ++k) mid[k] += (q[k] - p[k]) * u / (u - v);
      result.push_back(mid);
    }
  }
  return result;
}

/// The least height above the reference face of the clipped incident face, with the sides moved out
/// by `slack` steps; nothing if nothing remains.
template <Scalar S, int N>
std::optional<double> least_height(const Boxes<S, N>& boxes, std::uint32_t feature, double slack) {
  const auto reference = (feature >> 6) / 8, incident = (feature >> 6) % 8;
  const bool of_b = reference >= 2 * N;
  const std::size_t k = reference / 2 % N, m = incident / 2;
  const bool negative = reference % 2 != 0;
  const auto frame = [&](bool b, std::size_t i) {
    Point e(N);
    e[i] = 1;
    return b ? exact(boxes.pose.axes[i], 30) : e;
  };
  const auto half = exact(of_b ? boxes.b : boxes.a, 0);
  const auto other = exact(of_b ? boxes.a : boxes.b, 0);
  const auto t = exact(boxes.pose.translation, 0);
  std::vector<Point> polygon;
  for (int v = 0; v < (N == 2 ? 2 : 4); ++v) {
    Point p = of_b ? Point(N) : t;
    for (std::size_t c = 0; c < N; ++c) {
      const std::size_t axis = (m + c) % N;
      const int bits = v ^ (v >> 1);
      const bool minus = c == 0 ? incident % 2 != 0 : (bits >> (c - 1)) % 2 != 0;
      const auto direction = frame(!of_b, axis);
      for (std::size_t i = 0; i < N; ++i) {
        p[i] += direction[i] * other[axis] * (minus ? -1 : 1);
      }
    }
    for (std::size_t i = 0; of_b && i < N; ++i) p[i] -= t[i];
    polygon.push_back(p);
  }
  for (std::size_t c = 1; c < N; ++c) {
    const std::size_t side = (k + c) % N;
    auto n = frame(of_b, side);
    for (int sign = 0; sign < 2; ++sign) {
      polygon = cut(polygon, n, half[side] + 2048 + Rational(slack));
      for (auto& x : n) x = -x;
    }
  }
  if (polygon.empty()) return std::nullopt;
  const auto up = frame(of_b, k);
  double least = 1e300;
  for (const auto& p : polygon) {
    least = std::min(least, as_double((negative ? -1 : 1) * dot(p, up) - half[k]));
  }
  return least;
}

struct Counts {
  int hits = 0, cases = 0, faces_of_b = 0, edges = 0, clipped = 0;
};

template <Scalar S, int N>
void check_boxes(Random& random, double size, Counts& counts) {
  const auto boxes = draw_boxes<S, N>(random, size);
  const auto margin = detail::Formats<S>::Gap::from_raw(static_cast<std::int32_t>(size / 25));
  const auto m = detail::box_manifold<S, N>(boxes.a, boxes.b, boxes.pose, margin);
  ++counts.cases;
  // Axes are unit vectors and orthogonal within 2^-28, so no projection is off by more.
  const double slack = 3 + size * std::ldexp(1, -25);
  constexpr double tolerance = 2048;
  const double best = greatest_gap(boxes);
  const double limit = static_cast<double>(margin.raw());
  if (best > limit + slack) {
    REQUIRE(m.count == 0);
    return;
  }
  if (m.count == 0) {
    // Some axis is beyond the margin, or no corner within it is above the face.
    REQUIRE(best > limit - size / 2 - tolerance - slack);
    return;
  }
  ++counts.hits;
  const auto a = corners_of(boxes, false), b = corners_of(boxes, true);
  const auto n = exact(m.normal, 30);
  const double chosen = as_double(support_gap(a, b, n));
  REQUIRE(std::abs(as_double(dot(n, n)) - 1) < std::ldexp(1, -27));
  REQUIRE(chosen <= best + slack);
  if (best <= -2147483648.0) return;  // all depths are clamped
  REQUIRE(chosen >= best - 2 * tolerance - slack);
  const bool is_edge = m.points[0].feature >= (1u << 15);
  counts.edges += is_edge ? 1 : 0;
  double least = 1e300;
  for (int i = 0; i < m.count; ++i) {
    const auto& p = m.points[static_cast<std::size_t>(i)];
    const double s = p.separation.raw();
    least = std::min(least, s);
    REQUIRE(p.separation <= margin);
    for (int k = 0; k < i; ++k) {
      REQUIRE(m.points[static_cast<std::size_t>(k)].feature != p.feature);
    }
    bool clamped = p.separation == lowest<typename detail::Formats<S>::Gap>;
    for (int k = 0; k < N; ++k) {
      clamped = clamped || p.point[k] == lowest<lever<S>> || p.point[k] == largest<lever<S>>;
    }
    if (clamped) continue;
    // The point is midway: half the separation along n from the surface of one of the boxes.
    const double along = as_double(dot(exact(p.point, 0), n));
    double most_a = -1e300, least_b = 1e300;
    for (const auto& q : a) most_a = std::max(most_a, as_double(dot(q, n)));
    for (const auto& q : b) least_b = std::min(least_b, as_double(dot(q, n)));
    if (is_edge) {
      REQUIRE(std::abs(along - (most_a + least_b) / 2) < slack);
    } else {
      const bool of_b = (p.feature >> 6) / 8 >= 2 * N;
      counts.faces_of_b += of_b ? 1 : 0;
      REQUIRE(std::abs(along - (of_b ? least_b - s / 2 : most_a + s / 2)) < slack);
    }
  }
  if (least <= -2147483648.0) return;
  if (is_edge) {
    REQUIRE(m.count == 1);
    REQUIRE(std::abs(least - chosen) < slack);
    return;
  }
  const auto inside = least_height(boxes, m.points[0].feature, -slack);
  const auto outside = least_height(boxes, m.points[0].feature, slack);
  REQUIRE(outside.has_value());
  REQUIRE(least >= *outside - slack);
  if (inside) {
    REQUIRE(least <= *inside + slack);
    counts.clipped += *inside > chosen + 1 ? 1 : 0;
  }
}

template <Scalar S, int N>
void check_all(std::uint64_t seed, int cases) {
  Random random(seed);
  CAPTURE(random.seed());
  Counts counts;
  for (int i = 0; i < cases; ++i) {
    CAPTURE(i);
    const double sizes[] = {4194304, 209715, 419430400, 2e9};
    check_boxes<S, N>(random, sizes[random.below(4)], counts);
  }
  CHECK(counts.hits > counts.cases * 3 / 10);
  CHECK(counts.hits < counts.cases * 9 / 10);
  CHECK(counts.faces_of_b > counts.cases / 50);
  CHECK(counts.clipped > counts.cases / 200);
  if (N == 3) CHECK(counts.edges > counts.cases / 100);
}

TEMPLATE_TEST_CASE(
    "box manifold: the normal is the best axis, and the points are those of the exact clip",
    "[manifold][oracle]", q16_16, q8_8) {
  check_all<TestType, 2>(0xb0c5, 800);
  check_all<TestType, 3>(0xb0c6, 800);
}

TEST_CASE("box manifold: every scalar computes the same integers", "[manifold]") {
  Random random(0x5ca1e);
  for (int i = 0; i < 500; ++i) {
    const auto boxes = draw_boxes<q16_16, 3>(random, 4194304);
    Boxes<q24_8, 3> same;
    for (int k = 0; k < 3; ++k) {
      same.a[k] = lever<q24_8>::from_raw(boxes.a[k].raw());
      same.b[k] = lever<q24_8>::from_raw(boxes.b[k].raw());
      same.pose.translation[k] = lever<q24_8>::from_raw(boxes.pose.translation[k].raw());
    }
    same.pose.axes = boxes.pose.axes;
    const auto one =
        detail::box_manifold<q16_16, 3>(boxes.a, boxes.b, boxes.pose, gap<q16_16>(0.02));
    const auto other = detail::box_manifold<q24_8, 3>(
        same.a, same.b, same.pose, detail::Formats<q24_8>::Gap::from_raw(gap<q16_16>(0.02).raw()));
    REQUIRE(one.count == other.count);
    CHECK(one.normal == other.normal);
    for (std::size_t p = 0; p < static_cast<std::size_t>(one.count); ++p) {
      CHECK(one.points[p].feature == other.points[p].feature);
      CHECK(one.points[p].separation.raw() == other.points[p].separation.raw());
      CHECK(one.points[p].point.x.raw() == other.points[p].point.x.raw());
    }
  }
}

template <Scalar S, int N>
std::vector<std::uint32_t> features(const detail::Manifold<S, N>& m) {
  std::vector<std::uint32_t> result;
  for (int i = 0; i < m.count; ++i) {
    result.push_back(m.points[static_cast<std::size_t>(i)].feature);
  }
  return result;
}

TEST_CASE("box manifold: tiny motions of stacked boxes keep the features", "[manifold]") {
  using S = q16_16;
  Random random(0x717);
  const auto half = levers<S, 3>(0.5, 0.5, 0.5);
  const auto margin = gap<S>(0.02);
  const auto still = detail::box_manifold<S, 3>(half, half, shifted<S, 3>(0, 0, 1), margin);
  REQUIRE(still.count == 4);
  for (int i = 0; i < 1000; ++i) {
    auto pose = shifted<S, 3>(0, 0, 1);
    for (int k = 0; k < 3; ++k) {
      const auto jitter = [&](int steps) {
        return static_cast<std::int32_t>(random.between(-steps, steps));
      };
      pose.translation[k] = lever<S>::from_raw(pose.translation[k].raw() + jitter(400));
      for (int j = 0; j < 3; ++j) {
        auto& entry = pose.axes[static_cast<std::size_t>(j)][k];
        if (j != k) entry = ratio<S>::from_raw(jitter(1 << 16));
      }
    }
    const auto moved = detail::box_manifold<S, 3>(half, half, pose, margin);
    REQUIRE(features(moved) == features(still));
  }
}

TEST_CASE("box manifold: swapping the boxes flips the normal and keeps the depth", "[manifold]") {
  using S = q16_16;
  Random random(0x59ab);
  int hits = 0;
  for (int i = 0; i < 1000; ++i) {
    const auto boxes = draw_boxes<S, 3>(random, 4194304);
    // The inverse pose is rounded, so results agree within roundings.
    detail::RelativePose<S, 3> inverse;
    for (int j = 0; j < 3; ++j) {
      for (int k = 0; k < 3; ++k) {
        inverse.axes[static_cast<std::size_t>(j)][k] =
            boxes.pose.axes[static_cast<std::size_t>(k)][j];
      }
      inverse.translation[j] = nearest_to<lever<S>>(
          -detent::dot(boxes.pose.axes[static_cast<std::size_t>(j)], boxes.pose.translation));
    }
    const auto margin = gap<S>(0.02);
    const auto one = detail::box_manifold<S, 3>(boxes.a, boxes.b, boxes.pose, margin);
    const auto other = detail::box_manifold<S, 3>(boxes.b, boxes.a, inverse, margin);
    if (one.count == 0 || other.count == 0) continue;
    ++hits;
    const auto a = corners_of(boxes, false), b = corners_of(boxes, true);
    const auto back = nearest_to<ratio<S>>(-detail::turned(boxes.pose, other.normal));
    const double first = as_double(support_gap(a, b, exact(one.normal, 30)));
    const double second = as_double(support_gap(a, b, exact(back, 30)));
    CHECK(std::abs(first - second) < 2 * 2048 + 8);
  }
  CHECK(hits > 250);
}

}  // namespace
}  // namespace detent::test
