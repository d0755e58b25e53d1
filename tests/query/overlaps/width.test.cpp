// SPDX-License-Identifier: MIT
#include <tuple>

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

/// Puts the same vectors in both types to `f` and expects it to say yes in some of the cases.
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
    return detail::is_near_slabs(low, high, d, reach);
  };
  compare<Fixed<30, 16>, Fixed<32, 16>, N, 3>(f);
  compare<Fixed<30, 16>, Fixed<62, 16>, N, 3>(f);
  compare<Fixed<30, 16>, Fixed<64, 16>, N, 3>(f);
}

TEST_CASE("overlaps: an answer in narrow integers is the same in wide ones", "[overlaps]") {
  const auto edge = [](const auto& e, const auto& w, const auto& reach) {
    return detail::is_near_edge(e, w, reach);
  };
  compare<Fixed<30, 16>, Fixed<32, 16>, 2, 2>(edge);
  compare<Fixed<30, 16>, Fixed<32, 16>, 3, 2>(edge);
  compare<Fixed<29, 16>, Fixed<32, 16>, 3, 3>(
      [](const auto& d, const auto& e, const auto& m, const auto& reach) {
        return detail::are_near(d, e, m, reach);
      });
  compare<Fixed<29, 16>, Fixed<32, 16>, 3, 3>(
      [](const auto& d, const auto& e, const auto& m, const auto& reach) {
        return detail::is_near_level(d, e, m, reach);
      });
  compare<Fixed<29, 16>, Fixed<32, 16>, 3, 3>(
      [](const auto& b, const auto& c, const auto& p, const auto& reach) {
        return detail::is_near_corners(b, c, p, reach);
      });
  compare<Fixed<29, 16>, Fixed<32, 16>, 3, 3>(
      [](const auto& b, const auto& c, const auto& p, const auto& reach) {
        return detail::is_near_face(b, c, p, reach);
      });
  compare_slabs<2>();
  compare_slabs<3>();
}

}  // namespace
}  // namespace detent::test
