// SPDX-License-Identifier: MIT
//
// Two peers on a network with a latency of a tenth of a second that loses every seventh packet.
// Each plays on with a prediction of the other's keys, and rolls back when it was wrong. Both end
// up with the same bits.
#include <algorithm>
#include <deque>

#include "arena.hpp"

namespace samples {

class Rollback final : public Sample {
 public:
  void step(const Input& input) override {
    const auto now = static_cast<std::uint64_t>(tick) * 16'667;  // microseconds
    for (; !wire.empty() && wire.front().due <= tick; wire.pop_front()) {
      const Packet& packet = wire.front();
      peers[packet.to].receive(1 - packet.to, packet.bytes, now);
    }
    is_driven = is_driven || input.keys != 0;
    for (std::size_t i = 0; i < 2; ++i) {
      const auto before = peers[i].resimulated();
      const bool is_yours = i == 0 && is_driven;
      peers[i].advance(is_yours ? pad_of(input) : played(static_cast<int>(i), tick), simulate);
      went_back[i] = peers[i].resimulated() - before;
      peers[i].poll(now, [&](std::size_t to, std::span<const std::byte> bytes) {
        if (++sent % 7 != 0) wire.push_back({to, tick + latency, {bytes.begin(), bytes.end()}});
      });
      while (const auto event = peers[i].next_event()) {
        is_equal = is_equal && event->kind != SessionEvent::Kind::desync;
      }
    }
    ++tick;
  }

  /// Bodies on which the two peers currently disagree, because one of them predicts, are red.
  void draw(Picture& picture) const override {
    for (std::size_t i = 0; i < 2; ++i) {
      const auto is_guessed = [&](std::uint32_t body) {
        const auto here = peers[i].world().position(body_of(body));
        return body >= first_player && here != peers[1 - i].world().position(body_of(body));
      };
      draw_arena(picture, peers[i].world(), S(i == 0 ? -7 : 7), went_back[i] > 0 ? pink : stone,
                 is_guessed);
    }
  }

  [[nodiscard]] std::uint64_t digest() const override {
    Digest both;
    for (const Match& peer : peers) {
      both.add(peer.frame(), peer.checked_frame());
      both.add_low_bytes(peer.digest(), 8);
      both.add_low_bytes(detent::digest(peer.world()), 8);
    }
    return both.value();
  }
  [[nodiscard]] View view() const override { return {{0, 8, 26}, {0, 3.9f, 0}, 17.5f}; }
  [[nodiscard]] std::string status() const override {
    const auto matched = (std::min)(peers[0].matched_frame(1), peers[1].matched_frame(0));
    return std::string(is_equal ? "equal" : "DIFFERENT") + " up to frame " +
           std::to_string(matched) + " of " + std::to_string(peers[0].frame()) + "; " +
           std::to_string(peers[0].resimulated() + peers[1].resimulated()) +
           " frames simulated again";
  }

 private:
  using Match = Session<Arena, Pad>;
  struct Packet {
    std::size_t to;
    int due;
    std::vector<std::byte> bytes;
  };
  static constexpr int latency = 6;  // ticks

  std::array<Match, 2> peers{Match({.match = 4711, .self = 0}, new_arena()),
                             Match({.match = 4711, .self = 1}, new_arena())};
  std::deque<Packet> wire;
  std::array<std::uint64_t, 2> went_back{};
  std::uint32_t sent = 0;
  int tick = 0;
  bool is_driven = false, is_equal = true;
};

extern const Entry rollback;
const Entry rollback{"rollback",
                     "Two peers predict each other's keys, roll back when they are wrong, and end "
                     "with the same bits.",
                     "Arrow keys fly the left peer's blue ball", make<Rollback>};

}  // namespace samples
