// SPDX-License-Identifier: MIT
#include <cmath>
#include <vector>

#include "detent/dynamics/hull.hpp"
#include "detent/query/distance.hpp"
#include "dynamics/manifold/rational.hpp"
#include "oracle/space.hpp"
#include "support/random.hpp"

namespace detent::test {
namespace {

using S = q16_16;
using Vector = std::array<double, 3>;

/// A hull that owns its points, which do not move.
template <int N>
struct Solid {
  std::vector<Vec<S, N>> points;
  SolidHull<S, N> solid{};

  explicit Solid(std::vector<Vec<S, N>> corners) : points(std::move(corners)) {
    const auto made = solid_hull(1, ConvexHull<S, N>{points});
    REQUIRE(made);
    solid = *made;
  }
  BodyHull<S, N> body() const { return {&solid, {}, {}}; }
};

double unit(Random& random) { return static_cast<double>(random.between(-10000, 10000)) / 10000; }

/// Up to 12 points in a box, some of them on a common face.
template <int N>
Solid<N> draw_hull(Random& random) {
  std::vector<Vec<S, N>> points;
  const auto count = static_cast<std::size_t>(random.between(N + 2, 12));
  const bool flat = random.coin();
  while (points.size() < count) {
    auto p = make_vec<N>([&](int) { return num<S>(unit(random)); });
    if (flat && random.coin()) p.y = S(-1);
    points.push_back(p);
  }
  points.push_back(make_vec<N>([&](int i) { return i == 0 ? S(1) : S(0); }));
  points.push_back(make_vec<N>([&](int i) { return i == 1 ? S(1) : S(0); }));
  points.push_back(make_vec<N>([&](int i) { return i == 0 ? S(-1) : i == 2 ? S(1) : S(0); }));
  return Solid<N>(points);
}

template <int N>
Solid<N> cube(const Vec<S, N>& half) {
  std::vector<Vec<S, N>> points;
  for (int c = 0; c < (1 << N); ++c) {
    points.push_back(
        make_vec<N>([&](int i) { return (c >> i & 1) != 0 ? narrow_negative(half[i]) : half[i]; }));
  }
  return Solid<N>(points);
}

template <int N>
detail::RelativePose<S, N> draw_pose(Random& random, double reach) {
  std::array<double, 4> q{unit(random), unit(random), unit(random), unit(random)};
  if (N == 2) q[1] = q[2] = 0;
  if (random.one_in(4)) q[0] = 1, q[1] = q[2] = 0, q[3] = random.coin() ? 0 : 1e-4;
  detail::RelativePose<S, N> pose;
  turn(pose, q);
  for (int i = 0; i < N; ++i) {
    pose.translation[i] = lever<S>::from_double(reach * unit(random));
  }
  return pose;
}

/// A point of a body in steps of a lever; b's exactly where the pose puts it.
template <int N>
Point exact(const Vec<lever<S>, N>& p) {
  Point result;
  for (int i = 0; i < N; ++i) result.push_back(p[i].raw());
  return result;
}
template <int N>
Point exact_direction(const Vec<ratio<S>, N>& p) {
  Point result;
  for (int i = 0; i < N; ++i) result.push_back(Rational(p[i].raw(), 1 << 30));
  return result;
}
template <int N>
Point exactly_placed(const detail::RelativePose<S, N>& pose, const Vec<lever<S>, N>& p) {
  Point result = exact(pose.translation);
  for (int j = 0; j < N; ++j) {
    const auto axis = exact_direction(pose.axes[static_cast<std::size_t>(j)]);
    for (std::size_t i = 0; i < std::size_t{N}; ++i) result[i] += axis[i] * Rational(p[j].raw());
  }
  return result;
}

Rational support_gap(const std::vector<Point>& a, const std::vector<Point>& b, const Point& n) {
  Rational most = dot(a[0], n), least = dot(b[0], n);
  for (const auto& p : a) most = (std::max)(most, dot(p, n));
  for (const auto& p : b) least = (std::min)(least, dot(p, n));
  return least - most;
}

Vector as_vector(const Point& p) {
  Vector v{};
  for (std::size_t i = 0; i < p.size(); ++i) v[i] = static_cast<double>(p[i]);
  return v;
}

/// The greatest gap over all axes that points of the hulls define: normal to three points of one
/// (two in 2D), or to two points of each.
double greatest_gap(const std::vector<Point>& a, const std::vector<Point>& b) {
  std::vector<Vector> p, q;
  for (const auto& x : a) p.push_back(as_vector(x));
  for (const auto& x : b) q.push_back(as_vector(x));
  const std::size_t size = a[0].size();
  double best = -1e300;
  const auto minus = [](const Vector& u, const Vector& v) {
    return Vector{u[0] - v[0], u[1] - v[1], u[2] - v[2]};
  };
  const auto along = [](const Vector& u, const Vector& v) {
    return u[0] * v[0] + u[1] * v[1] + u[2] * v[2];
  };
  const auto offer = [&](const Vector& u, const Vector& v) {
    Vector n{u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
    if (size == 2) n = {u[1], -u[0], 0};
    const double length = std::sqrt(along(n, n));
    if (length < 1e-2 * std::sqrt(along(u, u) * (size == 2 ? 1 : along(v, v)))) return;
    double low_p = 1e300, high_p = -1e300, low_q = 1e300, high_q = -1e300;
    for (const auto& x : p) {
      low_p = (std::min)(low_p, along(n, x));
      high_p = (std::max)(high_p, along(n, x));
    }
    for (const auto& x : q) {
      low_q = (std::min)(low_q, along(n, x));
      high_q = (std::max)(high_q, along(n, x));
    }
    best = (std::max)({best, (low_q - high_p) / length, (low_p - high_q) / length});
  };
  for (const auto* set : {&p, &q}) {
    for (std::size_t i = 0; i < set->size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        const auto u = minus((*set)[i], (*set)[j]);
        if (size == 2) offer(u, u);
        for (std::size_t k = 0; size == 3 && k < j; ++k) offer(u, minus((*set)[k], (*set)[j]));
        for (std::size_t k = 0; size == 3 && set == &p && k < q.size(); ++k) {
          for (std::size_t l = 0; l < k; ++l) offer(u, minus(q[k], q[l]));
        }
      }
    }
  }
  return best;
}

struct Counts {
  int hits = 0, edges = 0, faces_of_b = 0, many = 0;
};

template <int N>
void check_hulls(Random& random, Counts& counts) {
  const auto first = draw_hull<N>(random), second = draw_hull<N>(random);
  const auto pose = draw_pose<N>(random, N == 2 ? 2.4 : 1.9);
  const auto m = manifold(first.body(), second.body(), pose, gap<S>(0));
  std::vector<Point> a, b;
  for (const auto& p : first.solid.faces().points) a.push_back(exact(p));
  for (const auto& p : second.solid.faces().points) b.push_back(exactly_placed(pose, p));
  const double best = greatest_gap(a, b);
  constexpr double tolerance = 2048, slack = 8;
  if (best > slack) {
    REQUIRE(m.count == 0);
    return;
  }
  if (m.count == 0) {
    REQUIRE(best > -slack);
    return;
  }
  ++counts.hits;
  const auto n = exact_direction(m.normal);
  const double chosen = static_cast<double>(support_gap(a, b, n));
  REQUIRE(chosen <= best + slack);
  REQUIRE(chosen >= best - 2 * tolerance - slack);
  const auto feature = m.points[0].feature;
  counts.edges += feature >= (1u << 30) ? 1 : 0;
  counts.faces_of_b += feature < (1u << 30) && feature >= (1u << 24) ? 1 : 0;
  counts.many += m.count > 2 ? 1 : 0;
  for (int i = 0; i < m.count; ++i) {
    const auto& p = m.points[static_cast<std::size_t>(i)];
    const double s = p.separation.raw();
    REQUIRE(s >= chosen - slack);
    // A corner of one hull, or a point on its edges, this far from the surface of the other: moved
    // either way it is in both hulls, up to the tolerance of the sides.
    for (int k = 0; k < i; ++k) {
      REQUIRE(m.points[static_cast<std::size_t>(k)].feature != p.feature);
    }
    const double along = static_cast<double>(dot(exact(p.point), n));
    double most = -1e300, least = 1e300;
    for (const auto& x : a) most = (std::max)(most, static_cast<double>(dot(x, n)));
    for (const auto& x : b) least = (std::min)(least, static_cast<double>(dot(x, n)));
    // Midway between the reference face and the point's own depth below it.
    const bool of_b = feature < (1u << 30) && feature >= (1u << 24);
    if (feature < (1u << 30)) {
      REQUIRE(std::abs(of_b ? least - s / 2 - along : along - s / 2 - most) < slack);
    } else {
      REQUIRE(std::abs((most + least) / 2 - along) < slack);
    }
  }
}

TEST_CASE("manifold: hulls touch along the axis of greatest separation") {
  Random random(20);
  Counts flat, solid;
  for (int i = 0; i < 600; ++i) check_hulls<2>(random, flat);
  for (int i = 0; i < 400; ++i) check_hulls<3>(random, solid);
  CAPTURE(flat.hits, solid.hits);
  CHECK((flat.hits > 180 && flat.hits < 420));
  CHECK((solid.hits > 120 && solid.hits < 280));
  CHECK(flat.faces_of_b > 40);
  CHECK(solid.faces_of_b > 20);
  CHECK(solid.edges > 20);
  CHECK(solid.many > 30);
}

/// The overlap of the deepest point, in steps.
template <int N>
double deepest(const detail::Manifold<S, N>& m) {
  double least = 1e300;
  for (int i = 0; i < m.count; ++i) {
    least = (std::min)(least,
                       static_cast<double>(m.points[static_cast<std::size_t>(i)].separation.raw()));
  }
  return least;
}

/// The sum of all points, in steps.
template <int N>
Vector sum_of_points(const detail::Manifold<S, N>& m) {
  Vector sum{};
  for (int i = 0; i < m.count; ++i) {
    for (int k = 0; k < N; ++k) {
      sum[static_cast<std::size_t>(k)] += m.points[static_cast<std::size_t>(i)].point[k].raw();
    }
  }
  return sum;
}

/// Within `steps` of a ratio.
template <int N>
bool same_direction(const Vec<ratio<S>, N>& a, const Vec<ratio<S>, N>& b, std::int64_t steps) {
  for (int i = 0; i < N; ++i) {
    if (std::abs(std::int64_t{a[i].raw()} - std::int64_t{b[i].raw()}) > steps) return false;
  }
  return true;
}

/// Compares manifolds computed by other formulas, which may choose another axis or point among
/// equals.
struct Same {
  int cases = 0, others = 0;

  template <int N>
  void compare(const detail::Manifold<S, N>& m, const detail::Manifold<S, N>& wanted,
               std::int64_t steps) {
    REQUIRE((m.count == 0) == (wanted.count == 0));
    if (m.count == 0) return;
    ++cases;
    REQUIRE(std::abs(deepest(m) - deepest(wanted)) < 2048 + 8);
    // Corners may be beyond the sides by the tolerance.
    bool near_by = true;
    const auto a = sum_of_points(m), b = sum_of_points(wanted);
    for (std::size_t k = 0; k < 3; ++k) near_by = near_by && std::abs(a[k] - b[k]) < 4 * 2048;
    const bool same = near_by && std::abs(deepest(m) - deepest(wanted)) < 8 &&
                      m.count == wanted.count && same_direction(m.normal, wanted.normal, steps);
    others += same ? 0 : 1;
  }
};

template <int N>
void check_boxes(Random& random, Same& same) {
  const auto half_a = make_vec<N>([&](int) { return num<S>(0.6 + 0.4 * unit(random)); });
  const auto half_b = make_vec<N>([&](int) { return num<S>(0.6 + 0.4 * unit(random)); });
  const auto first = cube<N>(half_a), second = cube<N>(half_b);
  const Obb<S, N> box_a{{}, half_a, {}}, box_b{{}, half_b, {}};
  const auto pose = draw_pose<N>(random, 1.5);
  const auto wanted = manifold(box_a, box_b, pose, gap<S>(0.02));
  same.compare(manifold(first.body(), second.body(), pose, gap<S>(0.02)), wanted, 64);
  same.compare(manifold(first.body(), box_b, pose, gap<S>(0.02)), wanted, 64);
  same.compare(manifold(box_a, second.body(), pose, gap<S>(0.02)), wanted, 64);
}

TEST_CASE("manifold: a hull of a box's corners touches as the box does") {
  Random random(21);
  Same same;
  for (int i = 0; i < 1000; ++i) {
    check_boxes<2>(random, same);
    check_boxes<3>(random, same);
  }
  CAPTURE(same.cases, same.others);
  CHECK((same.cases > 1800 && same.cases < 4200));
  CHECK(same.others < same.cases / 50);
}

template <int N>
void check_round(Random& random, bool is_ball, Same& same) {
  const auto half_extents = make_vec<N>([&](int) { return num<S>(0.6 + 0.4 * unit(random)); });
  const auto solid = cube<N>(half_extents);
  const Obb<S, N> box{{}, half_extents, {}};
  const auto pose = draw_pose<N>(random, 1.3);
  const auto end = make_vec<N>([&](int) { return num<S>(unit(random)); });
  const Capsule<S, N> capsule{is_ball ? end : Vec<S, N>{}, end, num<S>(0.2)};
  // With the core 2^-6 away, a step of a lever turns the normal by 2^-16.
  same.compare(manifold(solid.body(), capsule, pose, gap<S>(0.02)),
               manifold(box, capsule, pose, gap<S>(0.02)), 1 << 15);
  same.compare(manifold(capsule, solid.body(), pose, gap<S>(0.02)),
               manifold(capsule, box, pose, gap<S>(0.02)), 1 << 15);
}

TEST_CASE("manifold: balls and capsules touch a hull of a box's corners as they touch the box") {
  Random random(22);
  Same same;
  for (int i = 0; i < 1000; ++i) {
    check_round<2>(random, i % 2 == 0, same);
    check_round<3>(random, i % 2 == 0, same);
  }
  CAPTURE(same.cases, same.others);
  CHECK((same.cases > 1200 && same.cases < 2800));
  CHECK(same.others < same.cases / 50);
}

/// The separation of an outside ball is the distance of its center minus the radius.
template <int N>
void check_distance(Random& random, int& outside) {
  const auto solid = draw_hull<N>(random);
  const auto q = make_vec<N>([&](int) { return num<S>(1.5 * unit(random)); });
  // The hull as its body stores it: around its center of mass, here on the query's grid.
  std::vector<Vec<S, N>> corners;
  for (const auto& p : solid.solid.faces().points) corners.push_back(nearest_to<S>(p));
  const double exact = static_cast<double>(distance(ConvexHull<S, N>{corners}, q)) * (1 << 22);
  const auto m = manifold(solid.body(), Sphere<S, N>{q, num<S>(0.5)}, shifted<S, N>(0, 0),
                          as<typename detail::Formats<S>::Gap>(4));
  REQUIRE(m.count == 1);
  const double separation = m.points[0].separation.raw() + (1 << 21);
  if (exact > 100) {
    ++outside;
    REQUIRE(std::abs(separation - exact) < 200);  // three steps of q16_16
  } else {
    REQUIRE(separation < 200);
  }
}

TEST_CASE("manifold: a ball's separation from a hull is the exact distance") {
  Random random(23);
  int outside = 0;
  for (int i = 0; i < 600; ++i) {
    check_distance<2>(random, outside);
    check_distance<3>(random, outside);
  }
  CHECK((outside > 360 && outside < 1100));
}

/// Two hulls from short cuts, against plain loops over all faces and pairs of edges.
template <Scalar T>
struct ShortCuts {
  using Lever = lever<T>;
  using Polytope = detail::Polytope<T, 3>;
  using Points = std::span<const Vec<Lever, 3>>;
  int hits = 0, edges = 0, fewer = 0, regular = 0, beyond = 0;

  static auto least_height(const Polytope& shape, std::size_t f, const Points& points) {
    auto least = shape.height(shape.faces[f], points[0]);
    for (const auto& p : points) least = (min)(least, shape.height(shape.faces[f], p));
    return least;
  }
  void check_faces(const Polytope& shape, const Points& points, const Vec<Lever, 3>& center,
                   const typename detail::Formats<T>::Gap& margin) {
    std::size_t face = 0;
    for (std::size_t f = 1; f < shape.faces.size(); ++f) {
      if (least_height(shape, f, points) > least_height(shape, face, points)) face = f;
    }
    const auto separation = least_height(shape, face, points);
    const detail::BestPlane<T, 3> plain(shape, points);
    REQUIRE((plain.face == face && plain.separation == separation));
    detail::FaceHeights<T> heights;
    const detail::BestPlane<T, 3> best(shape, points, center, margin, heights);
    REQUIRE((best.separation > margin) == (separation > margin));
    if (separation > margin) return;
    REQUIRE((best.face == face && best.separation == separation));
    for (std::size_t f = 0; f < shape.faces.size(); ++f) {
      REQUIRE(heights[f] == shape.height(shape.faces[f], points[best.lowest]));
    }
  }
  /// The incident face of every face, and of every edge's direction.
  void check_opposed(const Polytope& a, const Polytope& b, const detail::RelativePose<T, 3>& pose) {
    const auto turn = [&](const auto& v) { return detail::turned(pose, v); };
    const auto back = [&](const auto& v) { return detail::turned_back(pose, v); };
    const auto check_one = [&](const Vec<ratio<T>, 3>& n) {
      const auto cosine = [&](std::size_t f) {
        return dot(n, nearest_to<ratio<T>>(turn(b.faces[f].normal)));
      };
      std::size_t found = 0;
      for (std::size_t f = 1; f < b.faces.size(); ++f) {
        if (cosine(f) < cosine(found)) found = f;
      }
      REQUIRE(detail::most_opposed(b, n, turn, back) == found);
    };
    for (const auto& face : a.faces) check_one(face.normal);
    for (const auto& edge : a.edges) check_one(edge.along);
  }

  void check(const SolidHull<T, 3>& first, const SolidHull<T, 3>& second,
             const detail::RelativePose<T, 3>& pose,
             const typename detail::Formats<T>::Gap& margin) {
    const auto a = first.faces(), b = second.faces();
    auto all_of_a = a, all_of_b = b;
    all_of_a.reach = all_of_b.reach = {};
    const auto m = detail::polytope_manifold(a, b, pose, margin);
    const auto wanted = detail::polytope_manifold(all_of_a, all_of_b, pose, margin);
    REQUIRE(m.count == wanted.count);
    REQUIRE(m.normal == wanted.normal);
    for (std::size_t i = 0; i < static_cast<std::size_t>(m.count); ++i) {
      REQUIRE(m.points[i].point == wanted.points[i].point);
      REQUIRE(m.points[i].separation == wanted.points[i].separation);
      REQUIRE(m.points[i].feature == wanted.points[i].feature);
    }
    const detail::MovedPoints<T, 3> points(
        b, [&](const auto& p) { return detail::placed_point<Lever>(pose, p); });
    check_faces(a, points.view(), pose.translation, margin);
    check_opposed(a, b, pose);
    if (detail::ball_is_above(a, b, pose.translation, margin)) {
      ++beyond;
      REQUIRE(wanted.count == 0);
    }
    regular += a.reach > 0 && b.reach > 0 ? 1 : 0;
    if (m.count == 0) return;
    ++hits;
    edges += m.points[0].feature >= (1u << 30) ? 1 : 0;
    const auto limit = detail::facing_height(a, b, pose, m.points[0].separation);
    detail::FaceHeights<T> heights;
    for (std::size_t f = 0; f < a.faces.size(); ++f) {
      heights[f] = a.height(a.faces[f], points.at[0]);
    }
    const auto facing = detail::edges_facing(a, heights, limit);
    fewer += facing.count < a.edges.size() ? 1 : 0;
  }
};

/// Boxes, thin plates, needles and points on a sphere, whose coordinates have up to `bits` bits.
template <Scalar T>
std::optional<SolidHull<T, 3>> draw_any_hull(Random& random, int bits, std::vector<Vec<T, 3>>& to) {
  to.clear();
  const auto kind = random.below(5);
  const auto size = static_cast<double>(std::int64_t{1} << bits);
  const auto count = static_cast<std::size_t>(random.between(4, 16));
  const auto flatness = random.between(0, bits);
  while (to.size() < count) {
    double v[3] = {unit(random), unit(random), unit(random)};
    if (kind >= 2) {  // on a sphere
      const double norm = std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]) + 1e-9;
      for (double& x : v) x /= norm;
    }
    if (kind == 0) {
      for (double& x : v) x = x < 0 ? -1 : 1;
    }
    to.push_back(make_vec<3>([&](int i) {
      const bool is_thin = (kind == 1 && i == 1) || (kind == 4 && i > 0);
      const auto raw = static_cast<std::int64_t>(v[i] * size) >> (is_thin ? flatness : 0);
      return T::assume_raw(static_cast<typename T::raw_type>(raw));
    }));
    if (kind == 0 && to.size() == 8) break;
  }
  return solid_hull(1, ConvexHull<T, 3>{to});
}

template <class T>
void compare_short_cuts(int rounds) {
  Random random(24);
  ShortCuts<T> checked;
  std::vector<Vec<T, 3>> first, second;
  for (int i = 0; i < rounds; ++i) {
    const int most = (std::min)(bits_of<T> - 1, 25);
    const int bits = static_cast<int>(random.between(4, most));
    const auto a = draw_any_hull<T>(random, bits, first),
               b = draw_any_hull<T>(random, bits, second);
    if (!a || !b) continue;
    auto turn = draw_pose<3>(random, 1);
    detail::RelativePose<T, 3> pose;
    pose.axes = turn.axes;
    // Levers have 6 bits of fraction more: closer than both radii, or about as far.
    const auto step = std::int64_t{1} << (bits + 6);
    const double far = random.coin() ? 0.9 : 0.02 * static_cast<double>(random.between(40, 100));
    for (int c = 0; c < 3; ++c) {
      const auto raw = static_cast<std::int64_t>(far * unit(random) * static_cast<double>(step));
      pose.translation[c] = saturate_to<lever<T>>(Fixed<62, lever<T>::frac>::assume_raw(raw));
    }
    if (random.one_in(4)) {  // faces next to each other
      pose.axes = shifted<T, 3>(0, 0).axes;
    }
    using Gap = typename detail::Formats<T>::Gap;
    checked.check(*a, *b, pose, Gap::assume_raw(random.coin() ? 0 : 80'000));
  }
  CAPTURE(checked.hits, checked.edges, checked.fewer, checked.regular, checked.beyond);
  CHECK(checked.hits > rounds / 5);
  CHECK(checked.edges > rounds / 100);
  CHECK(checked.fewer > checked.hits / 5);
  CHECK(checked.regular > rounds / 5);
  CHECK(checked.regular < rounds);
  CHECK(checked.beyond > rounds / 50);
}

TEMPLATE_TEST_CASE("manifold: edges and faces left out change nothing", "", DETENT_FIXED_SCALARS) {
  compare_short_cuts<TestType>(4000);
}
TEMPLATE_TEST_CASE("manifold: long comparison of edges and faces left out", "[.demand]",
                   DETENT_FIXED_SCALARS) {
  compare_short_cuts<TestType>(200'000);
}

/// The rotation of `from` to `to`, both unit vectors.
template <Scalar T>
void turn_onto(detail::RelativePose<T, 3>& pose, const Vector& from, const Vector& to) {
  const double c = 1 + from[0] * to[0] + from[1] * to[1] + from[2] * to[2];
  const Vector n{from[1] * to[2] - from[2] * to[1], from[2] * to[0] - from[0] * to[2],
                 from[0] * to[1] - from[1] * to[0]};
  turn(pose, {c, n[0], n[1], n[2]});
}

/// The ball around a hull whose farthest corner points at a face, close to where it counts as above.
template <class T>
void compare_balls(int rounds) {
  Random random(25);
  int near = 0, above = 0, reached = 0;
  std::vector<Vec<T, 3>> first, second;
  for (int i = 0; i < rounds; ++i) {
    const int most = (std::min)(bits_of<T> - 1, 21);
    const int bits = static_cast<int>(random.between(6, most));
    const auto a = draw_any_hull<T>(random, bits, first),
               b = draw_any_hull<T>(random, bits, second);
    if (!a || !b || b->faces().radius == 0) continue;
    const auto shape = a->faces(), other = b->faces();
    const auto length = [](const auto& p) {
      return std::hypot(double(p.x.raw()), double(p.y.raw()), double(p.z.raw()));
    };
    const auto scaled = [&](const auto& p, double by) {
      return Vector{p.x.raw() * by, p.y.raw() * by, p.z.raw() * by};
    };
    auto farthest = other.points[0];
    for (const auto& p : other.points) {
      if (length(p) > length(farthest)) farthest = p;
    }
    const double radius = other.radius.raw();
    REQUIRE((radius >= length(farthest) && radius <= length(farthest) + 2));
    const auto& face = shape.faces[random.below(shape.faces.size())];
    const auto n = scaled(face.normal, std::ldexp(1, -30));
    detail::RelativePose<T, 3> pose;
    turn_onto(pose, scaled(farthest, 1 / length(farthest)), {-n[0], -n[1], -n[2]});
    using Gap = typename detail::Formats<T>::Gap;
    const auto margin = Gap::assume_raw(random.coin() ? 0 : 80'000);
    const auto extra = static_cast<double>(random.between(-1500, 1500));
    const double height = radius + margin.raw() + extra;
    for (int c = 0; c < 3; ++c) {
      pose.translation[c] = lever<T>::assume_raw(static_cast<std::int32_t>(
          shape.corner(face, 0)[c].raw() + height * n[static_cast<std::size_t>(c)]));
    }
    const detail::MovedPoints<T, 3> points(
        other, [&](const auto& p) { return detail::placed_point<lever<T>>(pose, p); });
    const bool is_over =
        ShortCuts<T>::least_height(shape, static_cast<std::size_t>(&face - shape.faces.data()),
                                   points.view()) > margin;
    const bool is_above = detail::ball_is_above(shape, other, pose.translation, margin);
    ++near;
    above += is_above ? 1 : 0;
    reached += is_over ? 0 : 1;
    if (is_above) {
      REQUIRE(detail::polytope_manifold(shape, other, pose, margin).count == 0);
    } else {
      REQUIRE(extra < 1030);
    }
    if (extra > 64) REQUIRE(is_over);
    if (extra < -64) REQUIRE(!is_over);
  }
  CAPTURE(near, above, reached);
  CHECK(near > rounds / 2);
  CHECK((above > near / 10 && above < near / 2));
  CHECK((reached > near / 4 && reached < 3 * near / 4));
}

TEMPLATE_TEST_CASE("manifold: a hull whose ball is above a face does not touch", "",
                   DETENT_FIXED_SCALARS) {
  compare_balls<TestType>(4000);
}

/// Edges in every direction, some of them almost parallel, and separations close to theirs.
template <class T>
void compare_crossings(int rounds) {
  Random random(26);
  int sure = 0, close = 0, crossed = 0;
  using Gap = typename detail::Formats<T>::Gap;
  const auto direction = [&](const Vector& near, double spread) {
    Vec<Fixed<31, 20>, 3> v{};
    for (int c = 0; c < 3; ++c) {
      v[c] = Fixed<31, 20>::from_double(near[static_cast<std::size_t>(c)] + spread * unit(random));
    }
    return detail::unit_or_x<ratio<T>>(v);
  };
  const auto as_doubles = [](const Vec<ratio<T>, 3>& v) {
    return Vector{std::ldexp(v.x.raw(), -30), std::ldexp(v.y.raw(), -30),
                  std::ldexp(v.z.raw(), -30)};
  };
  for (int i = 0; i < rounds; ++i) {
    const auto e = direction({}, 1);
    const auto f = direction(as_doubles(e), random.coin() ? 1 : 0.03);
    const auto u = direction({}, 1), v = direction({}, 1);
    const auto outward = u + v;
    const int bits = static_cast<int>(random.between(4, 30));
    const auto coordinate = [&] {
      return lever<T>::assume_raw(static_cast<std::int32_t>(
          random.between(-(std::int64_t{1} << bits), std::int64_t{1} << bits)));
    };
    const Vec<lever<T>, 3> p{coordinate(), coordinate(), coordinate()};
    const Vec<lever<T>, 3> q{coordinate(), coordinate(), coordinate()};
    const auto n = detail::across_edges<T>(e, f, outward);
    std::int64_t exact = 0;
    if (n) {
      exact = nearest_to<Gap>(detail::Polytope<T, 3>::along(*n, q, p)).raw();
      ++crossed;
    }
    const auto width = random.coin() ? std::int64_t{3000} : (std::int64_t{1} << bits) / 4 + 1;
    const auto separation =
        nearest_to<Gap>(Fixed<62, Gap::frac>::assume_raw(exact + random.between(-width, width)));
    const bool is_low = detail::is_surely_at_most<T>(e, f, outward, q - p, separation);
    sure += is_low ? 1 : 0;
    if (is_low && n) {
      REQUIRE(exact <= separation.raw());
      close += separation.raw() - exact < 2000 ? 1 : 0;
    }
  }
  CAPTURE(sure, close, crossed);
  CHECK((sure > rounds / 20 && sure < rounds / 2));
  CHECK(close > rounds / 200);
  CHECK((crossed > rounds / 2 && crossed < rounds));
}

TEMPLATE_TEST_CASE("manifold: what the filter of edge separations is sure of is exact", "",
                   DETENT_FIXED_SCALARS) {
  compare_crossings<TestType>(20'000);
}
TEMPLATE_TEST_CASE("manifold: long comparison of edges too close together", "[.demand]", q16_16,
                   q8_8) {
  compare_crossings<TestType>(2'000'000);
}

TEST_CASE("manifold: a hull without an asset touches nothing") {
  const BodyHull<S, 3> none;
  const Sphere<S, 3> ball{{}, S(1)};
  const Obb<S, 3> box{{}, at<S, 3>(1, 1, 1), {}}, empty{{}, at<S, 3>(-1, 1, 1), {}};
  const auto solid = cube<3>(at<S, 3>(1, 1, 1));
  const auto pose = shifted<S, 3>(0, 0);
  CHECK(manifold(none, ball, pose, gap<S>(1)).count == 0);
  CHECK(manifold(ball, none, pose, gap<S>(1)).count == 0);
  CHECK(manifold(none, solid.body(), pose, gap<S>(1)).count == 0);
  CHECK(manifold(box, none, pose, gap<S>(1)).count == 0);
  CHECK(manifold(solid.body(), empty, pose, gap<S>(1)).count == 0);
  CHECK(manifold(solid.body(), Sphere<S, 3>{{}, S(-1)}, pose, gap<S>(1)).count == 0);
}

}  // namespace
}  // namespace detent::test
