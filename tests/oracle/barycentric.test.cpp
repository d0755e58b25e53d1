// SPDX-License-Identifier: MIT
#include "detent/query/barycentric.hpp"

#include "oracle/point_exam.hpp"

namespace detent::oracle {
namespace {

/// Whether the weights are right: they add up to their total, and the weighted corners give the
/// point, or the foot of the perpendicular from it. Only one set of weights does that.
template <Scalar S, int N>
std::string mistakes(const Triangle<S, N>& triangle, const Vec<S, N>& point) {
  const auto given = barycentric(triangle, point);
  const auto p = raw(point), a = raw(triangle.a), b = raw(triangle.b), c = raw(triangle.c);
  const auto u = difference(b, a), v = difference(c, a);
  const bool is_collapsed = is_zero(cross(u, v));
  if (given.has_value() == is_collapsed) return "  expected weights or nothing, got the other\n";
  if (!given) return "";

  const Integer of_a = whole(given->a.raw()), of_b = whole(given->b.raw());
  const Integer of_c = whole(given->c.raw()), total = whole(given->total.raw());
  if (total <= 0 || of_a + of_b + of_c != total) return "  the weights do not add up\n";
  Vector<N> beside;
  for (std::size_t i = 0; i < p.size(); ++i) {
    beside[i] = a[i] * of_a + b[i] * of_b + c[i] * of_c - p[i] * total;
  }
  if (!is_zero(dot(beside, u)) || !is_zero(dot(beside, v))) return "  the weights miss the point\n";

  using Component = direction_component<S>;
  const auto rounded = nearest_to<Component>(*given);
  const Integer low = whole(Component::lowest().raw()), high = whole(Component::max().raw());
  const Integer one = Integer(1) << static_cast<unsigned>(Component::frac);
  const std::array<Integer, 3> weights{of_a, of_b, of_c};
  for (int i = 0; i < 3; ++i) {
    const Integer exact = nearest_quotient(weights[static_cast<std::size_t>(i)] * one, total);
    if (whole(rounded[i].raw()) != std::clamp(exact, low, high)) return "  wrongly rounded\n";
  }
  return "";
}

template <Scalar S, int N>
void examine(std::uint64_t seed, long count) {
  Draw<S, N> draw(seed);
  auto& random = draw.random;
  using D = Draw<S, N>;
  test::HitRate inside;
  long wrong = 0;
  std::ostringstream out;
  const auto ask = [&](const Raw<N>& a, const Raw<N>& b, const Raw<N>& c, const Raw<N>& p) {
    const Triangle<S, N> triangle{D::vec(a), D::vec(b), D::vec(c)};
    const auto point = D::vec(p);
    const auto found = mistakes(triangle, point);
    if (!found.empty() && ++wrong <= 5) {
      out << describe(triangle) << "; point " << describe(point) << "\n" << found;
    }
    if (const auto weights = barycentric(triangle, point)) {
      inside.count(weights->a >= 0 && weights->b >= 0 && weights->c >= 0);
    }
  };
  for (long i = 0; i < count; ++i) {
    const auto scale = draw.scale();
    const auto a = draw.point(scale), b = draw.point(scale), c = draw.point(scale);
    auto middle = a;
    for (std::size_t j = 0; j < D::size; ++j) middle[j] = (a[j] + b[j] + c[j]) / 3;
    ask(a, b, c, draw.near(middle, scale / 3));
    if (i % 4 == 0) {
      ask(draw.extreme_point(), draw.extreme_point(), draw.extreme_point(), draw.extreme_point());
      ask(draw.point(2), draw.point(2), draw.point(2), draw.point(2));
      const auto step = draw.point(5);  // collapsed
      ask(a, D::plus(a, step, random.between(-9, 9)), D::plus(a, step, random.between(-9, 9)), b);
    }
  }
  INFO(random << "\n" << out.str());
  CHECK(wrong == 0);
  INFO(inside);
  CHECK(inside.is_balanced());
}

TEMPLATE_TEST_CASE("barycentric: the weights are exact", "[oracle]", DETENT_FIXED_SPACES) {
  examine<typename TestType::scalar, TestType::dimension>(0xba7c, point_cases / 2);
}

TEMPLATE_TEST_CASE("barycentric: many more weights are exact", "[oracle][.demand]",
                   DETENT_FIXED_SPACES) {
  for (const auto seed : demanded_seeds()) {
    examine<typename TestType::scalar, TestType::dimension>(seed, 2 * point_cases);
  }
}

}  // namespace
}  // namespace detent::oracle
