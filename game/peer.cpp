// SPDX-License-Identifier: MIT
//
// usage: peer [steps | match [FRAMES [PLAYERS]] | late | pipe SELF SEED PLAYERS LIFE]
//
//   steps  plays the match of two or four simulated players, step by step
//   match  plays it with a session per player, over a simulated network that loses, duplicates and
//          reorders packets
//   late   plays it like this while a player leaves and returns and a spectator joins
//   pipe   is one simulated player of a match with other programs, or a spectator; relay_peer.mjs
//          passes packets. With a LIFE other than 0 it joins late
//
// All except `late` print the same numbers: every 600 frames, a digest of all frames so far. The
// exit status is 0 if the sessions agree.
#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <span>
#include <string_view>
#include <utility>
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
  Peer(const detent::SessionConfig& config, std::uint64_t match_seed, const Match& start)
      : session(config, start), seed(match_seed) {
    begin(session);
  }

  Session session;
  std::uint64_t seed = golden_seed;
  std::uint32_t seen = 0;   // frames in the chain
  std::uint64_t chain = 0;  // of their digests
  bool is_equal = true;
};

void receive(Peer& peer, std::size_t from, std::span<const std::byte> packet, std::uint64_t now) {
  Session& session = peer.session;
  session.receive(from, packet, now);
  if (peer.seen >= session.start_frame()) return;
  peer.seen = session.start_frame();  // the match so far has arrived
  peer.chain = session.digest();
}

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

/// Latency of 60 to 90 ms each way; every seventh packet is lost, every twentieth is duplicated.
int play_match(std::uint32_t frames, std::size_t players) {
  using detent::test::Time;
  detent::test::Network network(golden_seed, {60'000, 30'000, 143, 50});
  const auto start = std::make_unique<Match>(golden_seed, players);
  std::vector<std::unique_ptr<Peer>> peers(players);
  for (std::size_t i = 0; i < players; ++i) {
    const detent::SessionConfig config{
        .match = golden_seed, .self = i, .players = players, .delay = golden_delay};
    peers[i] = std::make_unique<Peer>(config, golden_seed, *start);
  }
  for (Time now = 0; now < Time{frames} * 50'000; now += 16'667) {
    network.deliver(now, [&](std::size_t from, std::size_t to, const auto& packet, Time when) {
      receive(*peers[to], from, packet, when);
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

/// Checks that a snapshot restores the same match, in which every further tick is the same, and
/// that wrong or truncated bytes restore another match or none but do no harm.
bool is_restored(const Match& match) {
  std::vector<std::byte> bytes(snapshot(match, {}));
  if (bytes.size() > snapshot_room || snapshot(match, bytes) != bytes.size()) return false;
  const auto copy = std::make_unique<Match>(golden_seed + 1, match.players);
  const std::array<Pad, most_players> pads{};
  for (std::size_t i = 0; i < bytes.size(); i += 7) {
    const auto byte = std::exchange(bytes[i], bytes[i] ^ std::byte{129});
    if (restore(*copy, bytes)) step(*copy, pads);
    bytes[i] = byte;
    if (restore(*copy, std::span(bytes).first(i))) return false;
  }
  if (!restore(*copy, bytes)) return false;
  const auto original = std::make_unique<Match>(match);
  for (int tick = 0; tick < 60; ++tick) {
    step(*copy, pads);
    step(*original, pads);
    if (chained(0, *copy) != chained(0, *original)) return false;
  }
  return true;
}

/// A match of two with room for a spectator: player 1 leaves at 5 s and returns at 8 s, and the
/// spectator joins at 10 s. All have equal digests at frame 1,500.
int play_late() {
  using detent::test::Time;
  constexpr std::uint32_t end = 1500;
  detent::test::Network network(golden_seed, {40'000, 20'000, 143, 50});
  const auto start = std::make_unique<Match>(golden_seed, 2);
  detent::SessionConfig config{
      .match = golden_seed, .players = 2, .spectators = 1, .delay = golden_delay};
  std::array<std::unique_ptr<Peer>, 3> peers;
  std::array<std::uint64_t, 3> digests{};
  const auto begin_peer = [&](std::size_t i, std::uint32_t life) {
    config.self = i;
    config.life = life;
    peers[i] = std::make_unique<Peer>(config, golden_seed, *start);
  };
  begin_peer(0, 0);
  begin_peer(1, 0);
  for (Time tick = 0; tick < 60 * 60; ++tick) {
    const Time now = tick * 16'667;
    if (tick == 300) {
      peers[1].reset();
      peers[0]->session.drop(1);
    }
    if (tick == 480) begin_peer(1, 1);
    if (tick == 600) begin_peer(2, 1);
    network.deliver(now, [&](std::size_t from, std::size_t to, const auto& packet, Time when) {
      if (peers[to]) receive(*peers[to], from, packet, when);
    });
    for (std::size_t i = 0; i < peers.size(); ++i) {
      if (!peers[i]) continue;
      play(*peers[i], end, [](std::uint32_t, std::uint64_t) {});
      digests[i] = peers[i]->seen == end ? peers[i]->chain : 0;
      peers[i]->session.poll(now, [&](std::size_t to, std::span<const std::byte> bytes) {
        network.send(i, to, bytes, now);
      });
    }
    if (digests[0] == 0 || digests[1] == 0 || digests[2] == 0) continue;
    std::fprintf(stderr, "joined from frames %u and %u; the match is %u bytes\n",
                 static_cast<unsigned>(peers[1]->session.start_frame()),
                 static_cast<unsigned>(peers[2]->session.start_frame()),
                 static_cast<unsigned>(snapshot(peers[0]->session.world(), {})));
    const bool is_equal = digests[0] == digests[1] && digests[1] == digests[2] &&
                          peers[1]->session.is_player() && peers[1]->session.start_frame() > 300 &&
                          peers[2]->session.start_frame() > 500;
    const bool is_fine = is_equal && is_restored(peers[0]->session.world());
    return is_fine && peers[0]->is_equal && peers[1]->is_equal && peers[2]->is_equal ? 0 : 1;
  }
  std::fputs("peer: not all came back\n", stderr);
  return 1;
}

template <class Number>
void write_number(Number number) {
  for (std::size_t i = 0; i < sizeof(Number); ++i) {
    std::putchar(static_cast<int>(std::uint64_t{number} >> (8 * i) & 255));
  }
}

/// Reads the time in milliseconds (4 bytes, little-endian), the size of a packet (2), its sender
/// (1) and the packet. Without a packet it plays a frame; the size 65535 means that the peer has
/// left. Writes the size of a packet (2), its recipient (1) and the packet; or 65535, the number of
/// frames (4) and their digest (8).
int play_pipe(std::size_t self, std::uint64_t seed, std::size_t players, std::uint32_t life) {
  const auto start = std::make_unique<Match>(seed, players);
  const detent::SessionConfig config{.match = seed,
                                     .self = self,
                                     .players = start->players,
                                     .spectators = most_spectators,
                                     .delay = golden_delay,
                                     .life = life};
  const auto peer = std::make_unique<Peer>(config, seed, *start);
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
      receive(*peer, from, std::span(packet).first(size), now);
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
  if (mode == "pipe" && argc == 6) {
    return play_pipe(static_cast<std::size_t>(number(2, 0)), number(3, 0),
                     static_cast<std::size_t>(number(4, 2)),
                     static_cast<std::uint32_t>(number(5, 0)));
  }
  if (mode == "late") return play_late();
  const auto frames = static_cast<std::uint32_t>(number(2, 3000));
  const std::size_t players = number(3, 2) == most_players ? most_players : 2;
  if (mode == "match") return play_match(frames, players);
  if (mode != "steps") {
    std::fputs(
        "usage: peer [steps | match [FRAMES [PLAYERS]] | late | pipe SELF SEED PLAYERS LIFE]\n",
        stderr);
    return 2;
  }
  const auto match = std::make_unique<Match>(golden_seed, players);
  play_steps(*match, frames, print);
  return 0;
}
