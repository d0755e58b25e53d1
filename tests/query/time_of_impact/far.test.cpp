// SPDX-License-Identifier: MIT
// Small and thin bodies at the ends of the range that turn by up to half a turn. Where the result
// says that they are apart, a proof by intervals says so too: at no time within half of their distance
// divided by a bound on their speed can they touch.
#include <algorithm>
#include <array>
#include <cmath>
#include <typeinfo>
#include <vector>

#include "detent/query/time_of_impact.hpp"
#include "oracle/impact_exam.hpp"
#include "query/raycast/helpers.hpp"

namespace detent::test {
namespace {

/// The greatest speed of a point of `body` relative to its frame's origin. The quaternion moves by v
/// at a distance h from 0, so the frame turns at the rate 2 |v| / h.
double spin_speed(const oracle::motion::Body& body) {
  double side = 0, from = 0, to = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    side += body.from[i] * body.to[i];
    from += body.from[i] * body.from[i];
    to += body.to[i] * body.to[i];
  }
  const double least = std::sqrt(std::min({from, to, (std::min(from, to) + side) / 2}));
  return 2 * std::sqrt(std::max(from + to - 2 * side, 0.0)) / least * body.reach();
}

/// What the intervals between two times prove.
struct Proof {
  double touch = -1;  // a time at which the bodies touch
  long evaluations = 0;
  bool is_complete = true;
};

/// Whether two bodies are apart from time `first` to `last`.
Proof prove_apart(const oracle::motion::Body& a, const oracle::motion::Body& b, double first,
                  double last) {
  using oracle::motion::minus;
  constexpr double rounding = 0.01;  // of a raw unit, in the evaluation
  constexpr long budget = 1500;
  const auto drift = minus(minus(a.end, a.start), minus(b.end, b.start));
  const double speed = oracle::motion::length(drift) + spin_speed(a) + spin_speed(b);
  Proof proof;
  std::vector<std::array<double, 2>> rest{{first, last}};
  while (!rest.empty()) {
    const auto [from, to] = rest.back();
    rest.pop_back();
    if (++proof.evaluations > budget) {
      proof.is_complete = false;
      return proof;
    }
    const double middle = (from + to) / 2, half = (to - from) / 2;
    const double gap = oracle::motion::gap(a, b, middle);
    if (!(gap > 0)) {
      proof.touch = middle;
      return proof;
    }
    const double near = (gap - rounding) / speed;  // no touch within this time
    if (!(speed > 0) || near >= half) continue;
    if (near < 0x1p-40) {
      proof.is_complete = false;
      continue;
    }
    const double skip = near > 0 ? near : 0;
    rest.push_back({middle + skip, to});
    rest.push_back({from, middle - skip});
  }
  return proof;
}

/// Bodies at one place of the world, often a corner of it.
template <Scalar S, int N>
class FarBodies {
 public:
  explicit FarBodies(std::uint64_t seed) : bodies_(seed), random(bodies_.random) {}

 private:
  oracle::Bodies<S, N> bodies_;

 public:
  Random& random;

  void next_case() {
    size_ = static_cast<int>(random.between(3, S::bits - 5));
    is_offset_ = random.one_in(3);
    const auto limit = std::int64_t{1} << S::bits;
    for (auto& x : place_) {
      const auto near_end = limit - (random.coin() ? 0 : random.between(0, limit >> 6));
      x = random.one_in(5) ? random.between(-limit, limit) : near_end * (random.coin() ? 1 : -1);
    }
  }

  /// Around the origin of its frame, or far away from it.
  template <class Shape>
  Shape shape() {
    middle_ = is_offset_ && random.coin() ? arm() : Vec<S, N>();
    if constexpr (support::OfPoints<Shape>) {
      return support::made_of<Shape>([this] { return point(); }, [this] { return thin_extent(); });
    } else if constexpr (std::is_same_v<Shape, Aabb<S, N>>) {
      Aabb<S, N> box{middle_, middle_};
      for (int i = 0; i < N; ++i) {
        const auto half = thin_extent();
        box.min[i] = nearest_to<S>(middle_[i] - half);
        box.max[i] = nearest_to<S>(middle_[i] + half);
      }
      return box;
    } else if constexpr (std::is_same_v<Shape, Obb<S, N>>) {
      const auto half = make_vec<N>([&](int) { return thin_extent(); });
      return {middle_, half, random.coin() ? Rotation<S, N>() : bodies_.rotation()};
    } else {
      auto& points = hulls_[next_hull_++ % hulls_.size()];
      for (auto& p : points) p = point();
      if (random.one_in(3)) {
        for (auto& p : points) p[N - 1] = middle_[N - 1];  // flat
      }
      return Shape{points};
    }
  }

  /// A motion that is about as long as the bodies; some turn by half a turn, or almost.
  Sweep<S, N> sweep() {
    Sweep<S, N> result;
    result.start = at_place(2);
    result.end = random.one_in(8) ? result.start : at_place(1);
    result.start_rotation = bodies_.rotation();
    result.end_rotation = random.one_in(8)   ? result.start_rotation
                          : random.one_in(3) ? bodies_.rotation()
                                             : compose(half_turn(), result.start_rotation);
    return result;
  }

 private:
  static std::int64_t clamped(std::int64_t raw) {
    const auto limit = std::int64_t{1} << S::bits;
    return std::clamp(raw, -limit, limit - 1);
  }
  static S number(std::int64_t raw) {
    return S::from_raw(static_cast<typename S::raw_type>(clamped(raw)));
  }

  Vec<S, N> at_place(int factor) {
    const auto far = factor << size_;
    return make_vec<N>([&](int i) {
      const auto x = place_[static_cast<std::size_t>(i)] - middle_[i].raw();
      return number(clamped(x) + random.between(-far, far));
    });
  }
  Vec<S, N> arm() {
    const auto far = std::int64_t{1} << (S::bits - 2);
    return make_vec<N>([&](int) { return number(random.between(-far, far)); });
  }
  Vec<S, N> point() {
    const auto far = std::int64_t{1} << size_;
    return make_vec<N>([&](int i) { return number(middle_[i].raw() + random.between(-far, far)); });
  }
  /// Half of a plate's thickness, or of its width.
  S thin_extent() {
    if (random.one_in(3)) return number(random.between(0, 2));
    return number(random.between(0, std::int64_t{1} << size_));
  }
  Rotation<S, N> half_turn() {
    const auto less = random.one_in(4) ? 0 : random.between(-(1 << 20), 1 << 20);
    const auto angle = Angle<S>::from_raw((1u << 31) + static_cast<std::uint32_t>(less));
    if constexpr (N == 2) {
      return Rotation<S, 2>::from_angle(angle);
    } else {
      return Rotation<S, 3>::from_axis_angle(bodies_.rotation().axis(0), angle);
    }
  }

  int size_ = 4;
  bool is_offset_ = false;
  Vec<S, N> middle_{};
  std::array<std::int64_t, N> place_{};
  std::array<std::array<Vec<S, N>, 5>, 2> hulls_{};
  std::size_t next_hull_ = 0;
};

struct Counts : oracle::Tally {
  long unproved = 0;
};

template <class A, class B, Scalar S, int N>
void examine(FarBodies<S, N>& bodies, Counts& counts, int count) {
  for (int i = 0; i < count; ++i) {
    bodies.next_case();
    const auto a = bodies.template shape<A>();
    const auto sweep_a = bodies.sweep();
    const auto b = bodies.template shape<B>();
    const auto sweep_b = bodies.sweep();
    const S target = S::from_raw(8);
    const auto found = detail::search_impact(a, sweep_a, b, sweep_b, target);
    const auto body_a = oracle::moving(a, sweep_a), body_b = oracle::moving(b, sweep_b);
    INFO(bodies.random << ", case " << i << " of kinds " << typeid(A).name() << " and "
                       << typeid(B).name());
    const auto fault = oracle::fault_of(found.impact, body_a, body_b, target, 0);
    if (fault) FAIL(*fault);
    const double end = found.impact ? static_cast<double>(found.impact->time) : 1;
    if (end > 0) {
      const auto proof = prove_apart(body_a, body_b, 0, end);
      if (proof.touch >= 0) FAIL("they touch at " << proof.touch << ", before " << end);
      counts.unproved += proof.is_complete ? 0 : 1;
    }
    counts.count(found);
  }
}

template <Scalar S, int N>
void examine_all(std::uint64_t seed, int count) {
  FarBodies<S, N> bodies(seed);
  Counts counts;
  support::MovingShapes<S, N>::for_each_pair(
      [&]<class A, class B>(const A&, const B&) { examine<A, B>(bodies, counts, count); });
  INFO(counts.hits << ", " << counts.steps << " steps in " << counts.cases << " cases, at most "
                   << counts.most << ", unfinished " << counts.unfinished << ", not proved "
                   << counts.unproved);
  CHECK(counts.hits.is_balanced());
  CHECK(counts.steps < 8 * counts.cases);
  CHECK(counts.most <= 128);
  CHECK(counts.unfinished * 200 <= counts.cases);
  CHECK(counts.unproved * 200 <= counts.cases);
}

TEMPLATE_TEST_CASE("time of impact: never late at the ends of the range, for fast and thin bodies",
                   "[toi]", DETENT_FIXED_SPACES) {
  examine_all<typename TestType::scalar, TestType::dimension>(0xfa7, 50);
}

TEMPLATE_TEST_CASE("time of impact: never late at the ends of the range, many more",
                   "[toi][.demand]", DETENT_FIXED_SPACES) {
  for (const auto seed : oracle::demanded_seeds()) {
    examine_all<typename TestType::scalar, TestType::dimension>(seed, 200);
  }
}

}  // namespace
}  // namespace detent::test
