// SPDX-License-Identifier: MIT
//
// usage: peer [steps | match [FRAMES] | pipe SELF SEED]
//
//   steps  plays the match of two simulated players, step by step
//   match  plays it in two sessions over a simulated network that loses, doubles and reorders packets
//   pipe   is one simulated player of a match with another program: relay_peer.mjs passes packets
//
// All give the same numbers: every 600 frames, a digest of all frames so far. The status is 0 if the
// sessions agree.
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
  std::uint64_t seed = golden_seed;
  std::uint32_t seen = 0;   // frames in the chain
  std::uint64_t chain = 0;  // of their digests
  bool is_equal = true;
};

template <class Print>
void play(Peer& peer, std::uint32_t frames, const Print& print_digest) {
  Session& session = peer.session;
  const auto pad = simulated_pad(peer.seed, session.config().self, session.frame());
  static_cast<void>(session.advance(pad, simulate));
  for (; peer.seen < session.final_frame() && peer.seen < frames; ++peer.seen) {
    peer.chain = chained(peer.chain, *session.result(peer.seen));
    if ((peer.seen + 1) % 600 == 0) print_digest(peer.seen + 1, peer.chain);
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
      play(*peers[i], frames, [&](std::uint32_t frame, std::uint64_t digest) {
        if (i == 0) print(frame, digest);
      });
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

template <class Number>
void write_number(Number number) {
  for (std::size_t i = 0; i < sizeof(Number); ++i) {
    std::putchar(static_cast<int>(std::uint64_t{number} >> (8 * i) & 255));
  }
}

/// Reads: the time in milliseconds (4 bytes, the low one first), the size of a packet (2), the packet.
/// Without a packet it plays a frame. Writes: the size of a packet (2), the packet; or 65535, the
/// number of frames (4), their digest (8).
int play_pipe(std::size_t self, std::uint64_t seed) {
  const auto start = std::make_unique<Match>(seed);
  const detent::SessionConfig config{.match = seed, .self = self, .delay = golden_delay};
  const std::unique_ptr<Peer> peer(new Peer{Session(config, *start), seed});
  std::array<unsigned char, 6> head{};
  std::array<std::byte, 65535> packet{};
  while (std::fread(head.data(), head.size(), 1, stdin) == 1) {
    std::uint64_t now = 0;
    for (std::size_t i = 4; i-- > 0;) now = now << 8 | head[i];
    now *= 1000;
    const std::size_t size = head[4] + std::size_t{256} * head[5];
    if (std::fread(packet.data(), 1, size, stdin) != size) break;
    if (size > 0) {
      peer->session.receive(1 - self, std::span(packet).first(size), now);
      continue;
    }
    play(*peer, 0x7fffffff, [](std::uint32_t frames, std::uint64_t digest) {
      write_number(std::uint16_t{65535});
      write_number(frames);
      write_number(digest);
    });
    peer->session.poll(now, [](std::size_t, std::span<const std::byte> bytes) {
      write_number(static_cast<std::uint16_t>(bytes.size()));
      std::fwrite(bytes.data(), 1, bytes.size(), stdout);
    });
    std::fflush(stdout);
  }
  return peer->is_equal ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  const std::string_view mode = argc > 1 ? argv[1] : "steps";
  if (mode == "pipe" && argc == 4) {
    return play_pipe(argv[2][0] == '1' ? 1 : 0, std::strtoull(argv[3], nullptr, 10));
  }
  const auto frames = static_cast<std::uint32_t>(argc > 2 ? std::atoi(argv[2]) : 3000);
  if (mode == "match") return play_match(frames);
  if (mode != "steps") {
    std::fputs("usage: peer [steps | match [FRAMES] | pipe SELF SEED]\n", stderr);
    return 2;
  }
  const auto match = std::make_unique<Match>(golden_seed);
  play_steps(*match, frames, print);
  return 0;
}
