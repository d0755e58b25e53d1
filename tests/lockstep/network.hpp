// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "support/random.hpp"

namespace detent::test {

using Time = std::uint64_t;  // microseconds
using Packet = std::vector<std::byte>;

/// What a network does to packets; probabilities are in thousandths.
struct Weather {
  Time latency = 0;
  Time jitter = 0;  // up to this much more, so packets overtake each other
  std::uint64_t loss = 0;
  std::uint64_t doubling = 0;
};

/// A network whose behaviour is determined by a seed.
class Network {
 public:
  Network(std::uint64_t seed, const Weather& weather) : random_(seed), weather_(weather) {}

  /// No packet passes from one peer to the other while this holds.
  std::function<bool(std::size_t from, std::size_t to, Time now)> is_cut = [](auto, auto, auto) {
    return false;
  };

  void send(std::size_t from, std::size_t to, std::span<const std::byte> bytes, Time now) {
    ++sent_;
    bytes_ += bytes.size();
    if (is_cut(from, to, now)) return;
    const bool is_double = random_.below(1000) < weather_.doubling;
    for (int i = 0; i < (is_double ? 2 : 1); ++i) {
      if (random_.below(1000) < weather_.loss) continue;
      const auto when = now + weather_.latency + random_.below(weather_.jitter + 1);
      flying_.push_back({when, count_++, from, to, {bytes.begin(), bytes.end()}});
      std::push_heap(flying_.begin(), flying_.end(), later);
    }
  }
  /// Calls take(from, to, packet, time) for everything that arrives until `now`.
  template <class Take>
  void deliver(Time now, const Take& take) {
    while (!flying_.empty() && flying_.front().when <= now) {
      std::pop_heap(flying_.begin(), flying_.end(), later);
      const auto packet = std::move(flying_.back());
      flying_.pop_back();
      take(packet.from, packet.to, packet.bytes, packet.when);
    }
  }
  [[nodiscard]] std::uint64_t sent() const { return sent_; }
  [[nodiscard]] std::uint64_t bytes() const { return bytes_; }

 private:
  struct Flying {
    Time when;
    std::uint64_t number;
    std::size_t from, to;
    Packet bytes;
  };
  static bool later(const Flying& a, const Flying& b) {
    return a.when != b.when ? a.when > b.when : a.number > b.number;
  }

  Random random_;
  Weather weather_;
  std::vector<Flying> flying_;
  std::uint64_t count_ = 0, sent_ = 0, bytes_ = 0;
};

}  // namespace detent::test
