// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <compare>
#include <cstddef>
#include <cstdint>

#include "detent/dynamics/local.hpp"

namespace detent::detail {

/// Two bodies by index, the lower one first.
struct BodyPair {
  std::uint32_t a = 0, b = 0;
  [[nodiscard]] friend constexpr auto operator<=>(const BodyPair&,
                                                  const BodyPair&) noexcept = default;
};

/// The bodies of a contact.
template <class Contact>
[[nodiscard]] constexpr BodyPair pair_of(const Contact& contact) noexcept {
  return {contact.a, contact.b};
}

/// What identifies a contact: bodies and parts.
struct ContactKey {
  BodyPair pair{};
  std::uint16_t member = 0;
  std::uint32_t part = 0;
  [[nodiscard]] friend constexpr auto operator<=>(const ContactKey&,
                                                  const ContactKey&) noexcept = default;
};
template <class Contact>
[[nodiscard]] constexpr ContactKey key_of(const Contact& contact) noexcept {
  return {pair_of(contact), contact.member, contact.part};
}

/// A body in the sweep for pairs.
template <Scalar S, int N>
struct SweepEntry {
  BodyBox<S, N> bounds{};
  std::uint32_t body = 0;
  std::uint8_t first_strip = 0, last_strip = 0;
};

/// Strips across the world along one axis other than x, with about equally many bodies in each. A
/// body is in all strips from that of its least coordinate to that of its greatest.
template <Scalar S, int N>
class Strips {
 public:
  using Bound = typename Formats<S>::Bound;
  static constexpr std::size_t most_strips = 32;

  /// Chooses the axis on which the middle half of a sample of the bodies is widest.
  constexpr Strips(const SweepEntry<S, N>* bodies, std::size_t count) noexcept
      : count_((std::min)(count / 64 + 1, most_strips)) {
    if (count_ == 1) return;
    Bound widest{};
    for (int axis = 1; axis < N; ++axis) {
      std::array<Bound, sample_size> sample{};
      for (std::size_t i = 0; i < sample_size; ++i) {
        sample[i] = bodies[i * count / sample_size].bounds.least[axis];
      }
      std::sort(sample.begin(), sample.end());
      const auto width = nearest_to<Bound>(sample[3 * sample_size / 4] - sample[sample_size / 4]);
      if (axis > 1 && width <= widest) continue;
      widest = width;
      axis_ = axis;
      for (std::size_t k = 1; k < count_; ++k) ends_[k - 1] = sample[k * sample_size / count_];
    }
  }

  [[nodiscard]] constexpr std::size_t count() const noexcept { return count_; }
  [[nodiscard]] constexpr std::uint8_t first_of(const BodyBox<S, N>& box) const noexcept {
    return strip_of(box.least[axis_]);
  }
  [[nodiscard]] constexpr std::uint8_t last_of(const BodyBox<S, N>& box) const noexcept {
    return strip_of(box.most[axis_]);
  }

 private:
  static constexpr std::size_t sample_size = 256;

  [[nodiscard]] constexpr std::uint8_t strip_of(const Bound& x) const noexcept {
    const auto last = ends_.begin() + static_cast<std::ptrdiff_t>(count_ - 1);
    return static_cast<std::uint8_t>(std::upper_bound(ends_.begin(), last, x) - ends_.begin());
  }

  std::size_t count_;
  int axis_ = 1;
  std::array<Bound, most_strips> ends_{};  // where the next strip begins
};

/// Sorts pairs by counting: by b, then by a, keeping the order by b. Bodies have indices below
/// `bodies`. `room` and `ends` are overwritten.
template <class Pairs, class Ends>
constexpr void order_pairs(Pairs& pairs, Pairs& room, Ends& ends, std::size_t bodies) {
  room.resize(pairs.size());
  const auto by = [&](const Pairs& from, Pairs& to, std::uint32_t BodyPair::*key) {
    ends.clear();
    ends.resize(bodies);
    for (std::size_t i = 0; i < from.size(); ++i) ++ends[from[i].*key];
    std::uint32_t end = 0;
    for (std::size_t i = 0; i < bodies; ++i) ends[i] = end += ends[i];
    for (std::size_t i = from.size(); i-- > 0;) to[--ends[from[i].*key]] = from[i];
  };
  by(pairs, room, &BodyPair::b);
  by(room, pairs, &BodyPair::a);
}

/// Calls found(pair) for all pairs of bodies whose bounds overlap, in no particular order: a sweep
/// along the x axis in each strip. Overlapping bodies are both in the later of their first strips,
/// and are reported there. Sorts `bodies`; `lane` has room for as many indices.
template <Scalar S, int N, class Lane, class Found>
constexpr void sweep(SweepEntry<S, N>* bodies, std::size_t count, Lane& lane, const Found& found) {
  std::sort(bodies, bodies + count, [](const auto& p, const auto& q) {
    if (p.bounds.least.x != q.bounds.least.x) return p.bounds.least.x < q.bounds.least.x;
    return p.body < q.body;
  });
  const Strips<S, N> strips(bodies, count);
  for (std::size_t i = 0; i < count; ++i) {
    bodies[i].first_strip = strips.first_of(bodies[i].bounds);
    bodies[i].last_strip = strips.last_of(bodies[i].bounds);
  }
  lane.resize(count);
  for (std::size_t strip = 0; strip < strips.count(); ++strip) {
    std::size_t size = 0;
    for (std::size_t i = 0; i < count; ++i) {
      lane[size] = static_cast<std::uint32_t>(i);
      const bool is_in = bodies[i].first_strip <= strip && strip <= bodies[i].last_strip;
      size += is_in ? 1u : 0u;
    }
    // Branchless, because it is unpredictable which bodies are apart along another axis: every pair
    // is written, and the next one overwrites it unless the bodies overlap.
    std::array<BodyPair, 64> met{};
    std::size_t met_size = 0;
    const auto report = [&] {
      for (std::size_t k = 0; k < met_size; ++k) found(met[k]);
      met_size = 0;
    };
    for (std::size_t i = 0; i < size; ++i) {
      const auto& first = bodies[lane[i]];
      for (std::size_t j = i + 1; j < size; ++j) {
        const auto& second = bodies[lane[j]];
        if (second.bounds.least.x > first.bounds.most.x) break;
        auto meets =
            static_cast<unsigned>((std::max)(first.first_strip, second.first_strip) == strip);
        for (int k = 1; k < N; ++k) {
          meets &= static_cast<unsigned>(second.bounds.least[k] <= first.bounds.most[k]) &
                   static_cast<unsigned>(first.bounds.least[k] <= second.bounds.most[k]);
        }
        met[met_size] = {(std::min)(first.body, second.body), (std::max)(first.body, second.body)};
        met_size += meets;
        if (met_size == met.size()) report();
      }
    }
    report();
  }
}

}  // namespace detent::detail
