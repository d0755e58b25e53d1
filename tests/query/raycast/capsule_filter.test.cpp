// SPDX-License-Identifier: MIT
#include "detent/query/raycast/capsule/entry_filter.hpp"

#include <array>
#include <cstddef>

#include "detent/query/raycast/capsule.hpp"
#include "oracle/space.hpp"
#include "query/raycast/helpers.hpp"

namespace detent::test {
namespace {

template <int N>
using Raws = std::array<std::int64_t, static_cast<std::size_t>(N)>;

/// Counts the filter's verdicts, compared with the exact entry.
struct Count {
  int sure = 0, unsure = 0, none = 0, side = 0, ends = 0, wrong = 0;
};

template <Scalar S, int N>
std::optional<S> distance_at(const Ray<S, N>& ray, const S& radius, const Segment<S, N>& axis,
                             const detail::CapsuleEntry<S>& entry) {
  if (!is_end(entry.part)) return entry.distance;
  return raycast(ray, detail::end_of(axis, radius, entry.part));
}

/// Counts the verdict for a ray from the origin `m` relative to the start of the axis `e`.
template <Scalar S, int N>
void ask(Count& count, const Direction<S, N>& d, const Raws<N>& m, const Raws<N>& e,
         std::int64_t radius, std::int64_t limit) {
  const auto number = [](std::int64_t x) {
    return S::from_raw(static_cast<typename S::raw_type>(x));
  };
  const auto point = [&](const Raws<N>& v) {
    return make_vec<N>([&](int i) { return number(v[static_cast<std::size_t>(i)]); });
  };
  const Ray<S, N> ray{point(m), d, number(limit)};
  const Segment<S, N> axis{{}, point(e)};
  const auto entry = detail::decide_capsule_entry(d, detail::at_most<29>(ray.origin - axis.start),
                                                  detail::at_most<29>(axis.end - axis.start),
                                                  number(radius), ray.max_distance);
  ++(entry.is_sure ? count.sure : count.unsure);
  if (!entry.is_sure) return;
  ++(entry.value.part == detail::CapsulePart::none   ? count.none
     : entry.value.part == detail::CapsulePart::side ? count.side
                                                     : count.ends);
  const auto exact =
      detail::exact_axis_entry(ray, Capsule<S, N>{axis.start, axis.end, number(radius)});
  const auto given = distance_at(ray, number(radius), axis, entry.value);
  if (given != distance_at(ray, number(radius), exact.axis, exact.entry)) ++count.wrong;
}

TEMPLATE_TEST_CASE("capsule filter: a sure result is the exact entry", "[raycast]",
                   DETENT_FILTER_SCALARS) {
  using S = TestType;
  Random random(0xca97);
  INFO(random);
  const auto check = [&]<int N>(Vec<S, N>) {
    Count count;
    for (int i = 0; i < 6'000; ++i) {
      const auto reach = std::int64_t{1} << random.between(10, 28);
      const auto vec = [&](std::int64_t size) {
        Raws<N> v;
        for (auto& x : v) x = random.between(-size, size);
        return v;
      };
      const auto e = vec(reach >> random.below(6));
      const auto m = vec(reach);
      auto aim = vec(1 + (reach >> random.below(6)));
      if (aim == m) aim[0] += 1;
      const auto along = make_vec<N>(
          [&](int k) { return S::from_raw(static_cast<typename S::raw_type>(aim[k] - m[k])); });
      const auto d = direction_of<S>(along);
      if (!d) continue;
      ask<S, N>(count, *d, m, e, random.between(0, reach >> random.below(6)),
                random.coin() ? S::max().raw() : random.between(0, 2 * reach));
    }
    CHECK(count.wrong == 0);
    CHECK(count.sure > 3'000);
    CHECK(count.unsure > 100);
    CHECK(count.none > 500);
    CHECK(count.side > 500);
    CHECK(count.ends > 300);
  };
  check(Vec<S, 2>());
  check(Vec<S, 3>());
}

// Along axes the direction is exact. So a line touches exactly, a hit is a whole number of steps
// away, or the hit lies in the plane of an end: within the filter's error, so it must be unsure.
TEST_CASE("capsule filter: unsure where its error could change the result", "[raycast]") {
  using S = q16_16;
  using V = Raws<3>;
  const auto along_z = Direction<S, 3>::along(2);
  constexpr std::int64_t far = 0x7fffffff;
  Random random(0xca98);
  INFO(random);
  Count touches, whole, at_end;
  for (int i = 0; i < 3'000; ++i) {
    const auto k = random.between(1, 1 << random.between(4, 22)) | 1;
    const auto j = random.between(1, 1 << random.between(4, 20)) | 1;
    const auto start = random.between(1 << 20, 1 << 26);
    // Passes the axis (4, 3) k at 5 j, across (3, -4) j, at any height of the axis.
    const auto turn = random.between(0, k);
    ask<S, 3>(touches, along_z, V{4 * turn + 3 * j, 3 * turn - 4 * j, -start}, V{4 * k, 3 * k, 0},
              5 * j, far);
    // Through the axis, so that the entry is 5 j before it.
    ask<S, 3>(whole, along_z, V{4 * turn, 3 * turn, -start - 5 * j}, V{4 * k, 3 * k, 0}, 5 * j,
              far);
    // Along (3, 4) to (-24, -7) j from an end of the axis (-7, 24) k, which is perpendicular to it.
    // The direction is 2^-30 too long, so this is not a whole number of steps.
    const auto ahead = random.between(1 << 20, 1 << 24), end = random.coin() ? k : 0;
    ask<S, 3>(at_end, three_four_fifths<S, 3>(),
              V{-7 * end - 24 * j - 3 * ahead, 24 * end - 7 * j - 4 * ahead, 0},
              V{-7 * k, 24 * k, 0}, 25 * j, far);
    if (at_end.side + at_end.ends + at_end.none > 0) ++at_end.wrong;
  }
  CHECK(touches.wrong == 0);
  CHECK(touches.none == 0);
  CHECK(touches.unsure > 2'900);
  CHECK(whole.wrong == 0);
  CHECK(whole.unsure > 2'900);
  CHECK(at_end.wrong == 0);
  CHECK(at_end.unsure > 2'900);
}

}  // namespace
}  // namespace detent::test
