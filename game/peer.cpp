// SPDX-License-Identifier: MIT
//
// usage: peer [steps | match [FRAMES]]
//
//   steps  plays the match of two simulated players, step by step
//   match  plays it in two sessions over a simulated network that loses, doubles and reorders packets
//
// Both print the same lines: every 600 frames, a digest of all frames so far. The status is 0 if the
// two sessions agree.
#include <array>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <span>
#include <string_view>

#include "lockstep/network.hpp"
#include "session.hpp"
#include "steps.hpp"

using namespace slingshot;

namespace {

void print(std::uint32_t frames, std::uint64_t digest) {
  std::printf("%u %016llx\n", static_cast<unsigned>(frames),
              static_cast<unsigned long long>(digest));
}

struct Peer {
  Session session;
  std::uint32_t seen = 0;   // frames in the chain
  std::uint64_t chain = 0;  // of their digests
  bool is_equal = true;
};

void play(Peer& peer, std::size_t self, std::uint32_t frames) {
  Session& session = peer.session;
  static_cast<void>(session.advance(simulated_pad(golden_seed, self, session.frame()), simulate));
  for (; peer.seen < session.final_frame() && peer.seen < frames; ++peer.seen) {
    peer.chain = chained(peer.chain, *session.result(peer.seen));
    if (self == 0 && (peer.seen + 1) % 600 == 0) print(peer.seen + 1, peer.chain);
  }
  while (const auto event = session.next_event()) {
    peer.is_equal &= event->kind != detent::SessionEvent::Kind::desync;
  }
}

/// Latency of 60 to 90 ms each way; every seventh packet is lost, every twentieth comes twice.
int play_match(std::uint32_t frames) {
  using detent::test::Time;
  detent::test::Network network(golden_seed, {60'000, 30'000, 143, 50});
  const auto start = std::make_unique<Match>(golden_seed);
  std::array<std::unique_ptr<Peer>, 2> peers;
  for (std::size_t i = 0; i < 2; ++i) {
    const detent::SessionConfig config{.match = golden_seed, .self = i, .delay = golden_delay};
    peers[i].reset(new Peer{Session(config, *start)});
  }
  for (Time now = 0; now < Time{frames} * 50'000; now += 16'667) {
    network.deliver(now, [&](std::size_t from, std::size_t to, const auto& packet, Time when) {
      peers[to]->session.receive(from, packet, when);
    });
    bool is_done = true;
    for (std::size_t i = 0; i < 2; ++i) {
      play(*peers[i], i, frames);
      peers[i]->session.poll(now, [&](std::size_t to, std::span<const std::byte> bytes) {
        network.send(i, to, bytes, now);
      });
      is_done &= peers[i]->seen >= frames && peers[i]->session.matched_frame(1 - i) >= frames;
    }
    if (!is_done) continue;
    std::fprintf(stderr, "frames simulated again: %.2f a frame; bytes a second, each way: %.0f\n",
                 static_cast<double>(peers[0]->session.resimulated()) / frames,
                 static_cast<double>(network.bytes()) / 2 / (static_cast<double>(now) / 1e6));
    const bool is_equal = peers[0]->is_equal && peers[1]->is_equal;
    return is_equal && peers[0]->chain == peers[1]->chain ? 0 : 1;
  }
  std::fputs("peer: the match did not get there\n", stderr);
  return 1;
}

}  // namespace

int main(int argc, char** argv) {
  const std::string_view mode = argc > 1 ? argv[1] : "steps";
  const auto frames = static_cast<std::uint32_t>(argc > 2 ? std::atoi(argv[2]) : 3000);
  if (mode == "match") return play_match(frames);
  if (mode != "steps") {
    std::fputs("usage: peer [steps | match [FRAMES]]\n", stderr);
    return 2;
  }
  const auto match = std::make_unique<Match>(golden_seed);
  play_steps(*match, frames, print);
  return 0;
}
