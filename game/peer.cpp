// SPDX-License-Identifier: MIT
//
// usage: peer [steps | match [FRAMES [PLAYERS]] | pipe SELF SEED PLAYERS]
//
//   steps  plays the match of simulated players, two or four, step by step
//   match  plays it in a session each over a simulated network that loses, doubles and reorders packets
//   pipe   is one simulated player of a match with other programs: relay_peer.mjs passes packets
//
// All give the same numbers: every 600 frames, a digest of all frames so far. The status is 0 if the
// sessions agree.
#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

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
int play_match(std::uint32_t frames, std::size_t players) {
  using detent::test::Time;
  detent::test::Network network(golden_seed, {60'000, 30'000, 143, 50});
  const auto start = std::make_unique<Match>(golden_seed, players);
  std::vector<std::unique_ptr<Peer>> peers(players);
  for (std::size_t i = 0; i < players; ++i) {
    const detent::SessionConfig config{
        .match = golden_seed, .self = i, .players = players, .delay = golden_delay};
    peers[i].reset(new Peer{Session(config, *start)});
  }
  for (Time now = 0; now < Time{frames} * 50'000; now += 16'667) {
    network.deliver(now, [&](std::size_t from, std::size_t to, const auto& packet, Time when) {
      peers[to]->session.receive(from, packet, when);
    });
    bool is_done = true;
    for (std::size_t i = 0; i < players; ++i) {
      play(*peers[i], frames, [&](std::uint32_t frame, std::uint64_t digest) {
        if (i == 0) print(frame, digest);
      });
      peers[i]->session.poll(now, [&](std::size_t to, std::span<const std::byte> bytes) {
        network.send(i, to, bytes, now);
      });
      is_done &= peers[i]->seen >= frames;
      for (std::size_t other = 0; other < players; ++other) {
        is_done &= other == i || peers[i]->session.matched_frame(other) >= frames;
      }
    }
    if (!is_done) continue;
    const auto ways = static_cast<double>(players * (players - 1));
    std::fprintf(stderr, "frames simulated again: %.2f a frame; bytes a second, each way: %.0f\n",
                 static_cast<double>(peers[0]->session.resimulated()) / frames,
                 static_cast<double>(network.bytes()) / ways / (static_cast<double>(now) / 1e6));
    const bool is_equal = std::all_of(peers.begin(), peers.end(), [&](const auto& peer) {
      return peer->is_equal && peer->chain == peers[0]->chain;
    });
    return is_equal ? 0 : 1;
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

/// Reads: the time in milliseconds (4 bytes, the low one first), the size of a packet (2), the peer
/// that it came from (1), the packet. Without a packet it plays a frame; with the size 65535 that
/// peer has left. Writes: the size of a packet (2), the peer that it goes to (1), the packet; or
/// 65535, the number of frames (4), their digest (8).
int play_pipe(std::size_t self, std::uint64_t seed, std::size_t players) {
  const auto start = std::make_unique<Match>(seed, players);
  const detent::SessionConfig config{
      .match = seed, .self = self, .players = start->players, .delay = golden_delay};
  const std::unique_ptr<Peer> peer(new Peer{Session(config, *start), seed});
  std::array<unsigned char, 7> head{};
  std::array<std::byte, 65535> packet{};
  while (std::fread(head.data(), head.size(), 1, stdin) == 1) {
    std::uint64_t now = 0;
    for (std::size_t i = 4; i-- > 0;) now = now << 8 | head[i];
    now *= 1000;
    const std::size_t size = head[4] + std::size_t{256} * head[5], from = head[6];
    if (size == 65535) {
      peer->session.drop(from);
      continue;
    }
    if (std::fread(packet.data(), 1, size, stdin) != size) break;
    if (size > 0) {
      peer->session.receive(from, std::span(packet).first(size), now);
      continue;
    }
    play(*peer, 0x7fffffff, [](std::uint32_t frames, std::uint64_t digest) {
      write_number(std::uint16_t{65535});
      write_number(frames);
      write_number(digest);
    });
    peer->session.poll(now, [](std::size_t to, std::span<const std::byte> bytes) {
      write_number(static_cast<std::uint16_t>(bytes.size()));
      write_number(static_cast<std::uint8_t>(to));
      std::fwrite(bytes.data(), 1, bytes.size(), stdout);
    });
    std::fflush(stdout);
  }
  return peer->is_equal ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  const std::string_view mode = argc > 1 ? argv[1] : "steps";
  const auto number = [&](int i, std::uint64_t otherwise) {
    return argc > i ? std::strtoull(argv[i], nullptr, 10) : otherwise;
  };
  if (mode == "pipe" && argc == 5) {
    return play_pipe(static_cast<std::size_t>(number(2, 0)), number(3, 0),
                     static_cast<std::size_t>(number(4, 2)));
  }
  const auto frames = static_cast<std::uint32_t>(number(2, 3000));
  const std::size_t players = number(3, 2) == most_players ? most_players : 2;
  if (mode == "match") return play_match(frames, players);
  if (mode != "steps") {
    std::fputs("usage: peer [steps | match [FRAMES [PLAYERS]] | pipe SELF SEED PLAYERS]\n", stderr);
    return 2;
  }
  const auto match = std::make_unique<Match>(golden_seed, players);
  play_steps(*match, frames, print);
  return 0;
}
