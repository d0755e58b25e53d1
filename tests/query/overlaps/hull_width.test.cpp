// SPDX-License-Identifier: MIT
#include "query/overlaps/hulls.hpp"

namespace detent::test {
namespace {

/// The results computed in numbers of T.
template <Number T, class A, class B>
void same_in(const A& a, const B& b, bool expected) {
  CHECK(detail::Gjk<T, A, B>(a, b).touches() == expected);
  if (expected) return;
  using Wide = std::remove_cvref_t<decltype((a.some() - b.some()).x)>;
  const auto none = detail::squared_distance_of_none<Wide, A::dimension>();
  const auto here = detail::Gjk<T, A, B>(a, b).squared_distance(none);
  const auto there = detail::Gjk<Wide, A, B>(a, b).squared_distance(none);
  CHECK(here.numerator == there.numerator);
  CHECK(here.denominator == there.denominator);
}

TEMPLATE_TEST_CASE("overlaps, hull: narrow and wide integers give the same result", "[overlaps]",
                   DETENT_FIXED_SPACES) {
  using S = typename TestType::scalar;
  constexpr int N = TestType::dimension;
  using Difference = decltype(S() - S());
  Random random(0x41);
  int hits = 0;
  for (int round = 0; round < 200; ++round) {
    Points<S, N, 5> a, b;
    const std::int64_t reach = std::int64_t{1} << random.between(3, S::bits - 4);
    const auto aside = random_near(random, Vec<S, N>(), reach);
    for (auto& point : a) point = random_near(random, Vec<S, N>(), reach);
    for (auto& point : b) point = random_near(random, aside, reach / 2);
    const detail::HullBody hull(ConvexHull<S, N>{a}), other(ConvexHull<S, N>{b});
    const bool answer = overlaps(ConvexHull<S, N>{a}, ConvexHull<S, N>{b});
    hits += answer ? 1 : 0;
    same_in<Fixed<S::bits - 2, S::frac>>(hull, other, answer);
    same_in<Difference>(hull, other, answer);

    auto half = random_near(random, Vec<S, N>(), reach / 2);
    for (int i = 0; i < N; ++i) half[i] = half[i] < 0 ? moved(S(0), 1) : half[i];
    const Obb<S, N> box{aside, half, three_four_fifths_frame<S, N>()};
    const auto box_body = detail::edge_body(box);
    using Fine = std::remove_cvref_t<decltype((box_body.some() - hull.some()).x)>;
    const bool touches = overlaps(box, ConvexHull<S, N>{a});
    CHECK(detail::Gjk<Fine, decltype(box_body), decltype(hull)>(box_body, hull).touches() ==
          touches);
    using Narrow = Fixed<Fine::bits - 3, Fine::frac>;
    CHECK(detail::Gjk<Narrow, decltype(box_body), decltype(hull)>(box_body, hull).touches() ==
          touches);
  }
  CHECK(hits > 20);
  CHECK(hits < 180);
}

}  // namespace
}  // namespace detent::test
