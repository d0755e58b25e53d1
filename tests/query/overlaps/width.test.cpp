// SPDX-License-Identifier: MIT
#include <tuple>

#include "detent/query/kernel/segment_box.hpp"
#include "query/overlaps/helpers.hpp"

namespace detent::test {
namespace {

template <class T, int N>
Vec<T, N> random_vec(Random& random, int bits) {
  return make_vec<N>(
      [&](int) { return T::from_raw(static_cast<typename T::raw_type>(random.wide(bits))); });
}
template <class Wide, class T, int N>
Vec<Wide, N> widened(const Vec<T, N>& v) {
  return make_vec<N>([&](int i) { return Wide(v[i]); });
}

/// Passes the same vectors to `f` in both types; it must return true for some of them.
template <class Narrow, class Wide, int N, int Count, class F>
void compare(const F& f) {
  Random random(0x31d7 + Count);
  HitRate rate;
  for (int i = 0; i < 4000; ++i) {
    const int bits = 2 + i % (Narrow::bits - 1);
    std::array<Vec<Narrow, N>, Count> narrow;
    std::array<Vec<Wide, N>, Count> wide;
    for (std::size_t k = 0; k < Count; ++k) {
      narrow[k] = random_vec<Narrow, N>(random, bits);
      wide[k] = widened<Wide>(narrow[k]);
    }
    auto reach = Narrow::from_raw(
        static_cast<typename Narrow::raw_type>(random.below(std::uint64_t{1} << bits * 3 / 4)));
    const bool answer = std::apply([&](const auto&... v) { return f(v..., reach); }, narrow);
    const bool same = std::apply([&](const auto&... v) { return f(v..., Wide(reach)); }, wide);
    INFO(random << ", case " << i);
    CHECK(answer == same);
    rate.count(answer);
  }
  INFO(rate);
  CHECK(rate.percent() >= 2);
  CHECK(rate.percent() <= 95);
}

template <int N>
void compare_slabs() {
  const auto f = [](const auto& a, const auto& b, const auto& d, const auto& reach) {
    auto low = a, high = b;
    for (int i = 0; i < N; ++i) {
      if (low[i] > high[i]) std::swap(low[i], high[i]);
    }
    return detail::within_slabs(low, high, d, reach);
  };
  compare<Fixed<30, 16>, Fixed<32, 16>, N, 3>(f);
  compare<Fixed<30, 16>, Fixed<62, 16>, N, 3>(f);
  compare<Fixed<30, 16>, Fixed<64, 16>, N, 3>(f);
}

template <int N>
void compare_filtered_slabs() {
  using T = Fixed<62, 16>;
  Random random(0x31d6);
  int wrong = 0, unsure = 0, near = 0;
  for (int i = 0; i < 8000; ++i) {
    const int bits = 2 + i % 59;
    auto low = random_vec<T, N>(random, bits), high = random_vec<T, N>(random, bits);
    const auto d = random_vec<T, N>(random, bits);
    for (int k = 0; k < N; ++k) {
      if (low[k] > high[k]) std::swap(low[k], high[k]);
    }
    const auto reach =
        T::from_raw(static_cast<std::int64_t>(random.below(std::uint64_t{1} << random.below(60))));
    const auto filtered = detail::decide_within_slabs(low, high, d, reach);
    const bool answer = detail::within_slabs(low, high, d, reach);
    near += answer ? 1 : 0;
    unsure += filtered == Filtered::unsure ? 1 : 0;
    wrong += filtered == Filtered::yes && !answer ? 1 : 0;
    wrong += filtered == Filtered::no && answer ? 1 : 0;
    // The least reach that contains the exact distance, and the one below it.
    T least(0), most = T::max();
    while (least < most) {
      const auto middle = T::from_raw(least.raw() + (most.raw() - least.raw()) / 2);
      if (detail::within_slabs(low, high, d, middle)) {
        most = middle;
      } else {
        least = T::from_raw(middle.raw() + 1);
      }
    }
    wrong += detail::decide_within_slabs(low, high, d, most) == Filtered::no ? 1 : 0;
    if (most == 0) continue;
    const auto below = T::from_raw(most.raw() - 1);
    wrong += detail::decide_within_slabs(low, high, d, below) == Filtered::yes ? 1 : 0;
  }
  CHECK(wrong == 0);
  CHECK(near > 400);
  CHECK(unsure > 0);
  CHECK(unsure < 2000);  // nearly all of them have few bits
}

TEST_CASE("overlaps: narrow and wide integers give the same result", "[overlaps]") {
  const auto edge = [](const auto& e, const auto& w, const auto& reach) {
    return detail::within_edge(e, w, reach);
  };
  compare<Fixed<30, 16>, Fixed<32, 16>, 2, 2>(edge);
  compare<Fixed<30, 16>, Fixed<32, 16>, 3, 2>(edge);
  compare<Fixed<29, 16>, Fixed<32, 16>, 3, 3>(
      [](const auto& d, const auto& e, const auto& m, const auto& reach) {
        return detail::within_segments(d, e, m, reach);
      });
  compare<Fixed<29, 16>, Fixed<32, 16>, 3, 3>(
      [](const auto& d, const auto& e, const auto& m, const auto& reach) {
        return detail::within_level(d, e, m, reach);
      });
  compare<Fixed<29, 16>, Fixed<32, 16>, 3, 3>(
      [](const auto& b, const auto& c, const auto& p, const auto& reach) {
        return detail::within_corners(b, c, p, reach);
      });
  compare<Fixed<29, 16>, Fixed<32, 16>, 3, 3>(
      [](const auto& b, const auto& c, const auto& p, const auto& reach) {
        return detail::within_face(b, c, p, reach);
      });
  const auto box = [](const auto& p, const auto& q, const auto& extents, const auto&) {
    auto h = extents;
    for (int i = 0; i < 2; ++i) h[i] = h[i] < 0 ? narrow_negative(h[i]) : h[i];
    if (h[2] < 0) h[2] = narrow_negative(h[2]);  // the third; in 2D the second again
    return detail::segment_meets_box(p, q, h);
  };
  compare<Fixed<29, 16>, Fixed<34, 16>, 2, 3>(box);
  compare<Fixed<29, 16>, Fixed<34, 16>, 3, 3>(box);
  compare_slabs<2>();
  compare_slabs<3>();
  compare_filtered_slabs<2>();
  compare_filtered_slabs<3>();
}

}  // namespace
}  // namespace detent::test
