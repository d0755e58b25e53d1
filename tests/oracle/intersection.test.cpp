// SPDX-License-Identifier: MIT
#include "detent/query/intersection.hpp"

#include "oracle/describe.hpp"
#include "oracle/draw.hpp"
#include "oracle/oracle_test.hpp"
#include "support/catch.hpp"

namespace detent::oracle {
namespace {

/// The exact coordinates, times `under` > 0, of the common point of N planes.
template <int N>
struct Solution {
  Vector<N> over;
  Integer under;
};

template <Scalar S, int N>
std::optional<Solution<N>> solve(
    const std::array<Plane<S, N>, static_cast<std::size_t>(N)>& planes) {
  constexpr auto size = static_cast<std::size_t>(N);
  const Integer one = Integer(1) << static_cast<unsigned>(direction_component<S>::frac);
  std::array<std::array<Integer, size + 1>, size> rows;
  for (std::size_t i = 0; i < size; ++i) {
    const auto normal = widen(raw(planes[i].normal));
    for (std::size_t j = 0; j < size; ++j) rows[i][j] = normal[j];
    rows[i][size] = raw(planes[i].offset) * one;
  }
  // Every number stays a minor of the matrix, and the diagonal ends as its determinant.
  Integer last = 1;
  for (std::size_t k = 0; k < size; ++k) {
    std::size_t pivot = k;
    while (pivot < size && rows[pivot][k].is_zero()) ++pivot;
    if (pivot == size) return {};
    std::swap(rows[k], rows[pivot]);
    for (std::size_t i = 0; i < size; ++i) {
      if (i == k) continue;
      const Integer times = rows[i][k];
      for (std::size_t j = 0; j <= size; ++j) {
        rows[i][j] = (rows[i][j] * rows[k][k] - times * rows[k][j]) / last;
      }
    }
    last = rows[k][k];
  }
  Solution<N> solution{{}, last < 0 ? Integer(-last) : last};
  for (std::size_t i = 0; i < size; ++i) {
    solution.over[i] = last < 0 ? Integer(-rows[i][size]) : rows[i][size];
  }
  return solution;
}

/// Whether `given` is over / under rounded to nearest, ties to even, and clamped.
template <Scalar S>
bool is_nearest(const S& given, const Integer& over, const Integer& under) {
  const Integer answer = raw(given);
  const Integer twice_off = 2 * (over - answer * under);
  const bool even = answer % 2 == 0;
  const bool not_less = twice_off < under || (twice_off == under && even) || given == S::max();
  const bool not_more = twice_off > -under || (twice_off == -under && even) || given == S::lowest();
  return not_less && not_more;
}

template <Scalar S>
auto ask(const std::array<Plane<S, 3>, 3>& planes) {
  return intersection(planes[0], planes[1], planes[2]);
}
template <Scalar S>
auto ask(const std::array<Plane<S, 2>, 2>& planes) {
  return intersection(planes[0], planes[1]);
}

template <Scalar S, int N>
void examine(std::uint64_t seed, long count) {
  using D = Draw<S, N>;
  D draw(seed);
  auto& random = draw.random;
  std::array<Plane<S, N>, static_cast<std::size_t>(N)> planes;
  long wrong = 0, points = 0, within = 0;
  std::string first;
  for (long i = 0; i < count; ++i) {
    const auto kind = random.below(4);
    const auto scale = draw.scale();
    const auto& frame = draw.frame();
    for (std::size_t k = 0; k < planes.size(); ++k) {
      auto& plane = planes[k];
      plane.normal = kind == 0   ? draw.any_direction()
                     : kind == 1 ? draw.rotation().axis(static_cast<int>(k))
                     : kind == 2 ? D::stretched(frame.axes[random.below(D::size)], frame.norm)
                                 : draw.disturbed(planes[0].normal);
      plane.offset = D::scalar(random.one_in(4) ? draw.extreme() : random.between(-scale, scale));
    }
    const auto exact = solve(planes);
    const auto given = ask(planes);
    bool is_right = exact.has_value() == given.has_value();
    if (exact && given) {
      ++points;
      bool inside = true;
      for (int j = 0; j < N; ++j) {
        const auto& over = exact->over[static_cast<std::size_t>(j)];
        is_right = is_right && is_nearest((*given)[j], over, exact->under);
        inside = inside && (*given)[j] != S::max() && (*given)[j] != S::lowest();
      }
      within += inside ? 1 : 0;
    }
    if (is_right || ++wrong > 3) continue;
    for (const auto& plane : planes) first += describe(plane) + "; ";
    first += given ? describe(*given) : "nothing";
    first += "\n";
  }
  INFO(random << ", " << count << " cases, " << points << " points, " << within << " within\n"
              << first);
  CHECK(wrong == 0);
  CHECK(points * 100 >= count * 50);
  CHECK(points * 100 <= count * 99);
  CHECK(within * 100 >= count * 30);
}

DETENT_ORACLE_TEST("intersection", 0x1a7e5, 20'000, 20'000)

}  // namespace
}  // namespace detent::oracle
