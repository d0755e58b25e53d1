// SPDX-License-Identifier: MIT
//
// Peers that join late or rejoin.
#include <algorithm>
#include <string>

#include "lockstep/match.hpp"
#include "support/catch.hpp"

using namespace detent;
using namespace detent::test;

namespace {

using Kind = SessionEvent::Kind;

std::vector<SessionConfig> configs(std::size_t players, SessionConfig config = {}) {
  config.players = players;
  return std::vector<SessionConfig>(players + config.spectators, config);
}

/// All peers' digests are those of the offline simulation, given who was in according to
/// `reference`.
void check_digests(const Match& match, std::size_t reference) {
  std::uint32_t frames = 0;
  for (std::size_t i = 0; i < match.peers.size(); ++i) {
    if (match.is_awaited(i)) frames = std::max(frames, match.peers[i]->session.checked_frame());
  }
  frames = std::min(frames, match.peers[reference]->session.checked_frame());
  const auto offline = match.offline(reference, frames);
  for (std::size_t i = 0; i < match.peers.size(); ++i) {
    const MatchPeer& peer = *match.peers[i];
    if (!match.is_awaited(i)) continue;
    std::size_t compared = 0;
    for (std::size_t frame = 1; frame < std::min(offline.size(), peer.chain.size()); ++frame) {
      if (peer.chain[frame] == 0) continue;
      ++compared;
      if (peer.chain[frame] != offline[frame]) {
        FAIL("peer " << i << " has another digest before frame " << frame);
      }
    }
    CHECK(compared > 0);
  }
}

bool has_event(const Match& match, Kind kind) {
  return std::any_of(match.peers.begin(), match.peers.end(), [&](const auto& peer) {
    return std::any_of(peer->events.begin(), peer->events.end(),
                       [&](const SessionEvent& event) { return event.kind == kind; });
  });
}
std::size_t count_events(const MatchPeer& peer, Kind kind, std::size_t about) {
  return static_cast<std::size_t>(std::count_if(
      peer.events.begin(), peer.events.end(),
      [&](const SessionEvent& event) { return event.kind == kind && event.peer == about; }));
}
/// Plays until this holds. Returns whether it did before `limit`.
template <class Condition>
bool play_until(Match& match, Time limit, const Condition& condition) {
  while (match.now() < limit && !condition()) match.tick();
  return condition();
}
std::uint32_t checked(const Match& match, std::size_t i) {
  return match.peers[i]->session.checked_frame();
}

/// A match in which peers leave, rejoin, watch or play, on any network.
void run_random_joins(std::uint64_t seed) {
  INFO("seed " << seed);
  Random random(seed);
  Weather weather{random.below(80'000), random.coin() ? random.below(40'000) : 0,
                  random.coin() ? random.below(250) : 0, random.coin() ? random.below(200) : 0};
  const auto players = 2 + random.below(4);
  SessionConfig config;
  config.match = random.next();
  config.spectators = random.one_in(3) ? 1 : 0;
  config.silence = 600'000 + random.below(400'000);
  // Peer 0 stays, so that the others can be compared with it.
  for (std::size_t i = 1; i < players; ++i) {
    if (random.one_in(5)) config.absent |= 1u << i;
  }
  auto all = configs(players, config);
  for (auto& one : all) {
    one.delay = static_cast<std::uint32_t>(random.below(9));
    one.prediction = static_cast<std::uint32_t>(random.one_in(4) ? 0 : random.below(17));
    one.frames_per_call = static_cast<std::uint32_t>(4 + random.below(14));
  }
  Match match(random.next(), weather, all);
  for (auto& peer : match.peers) {
    peer->period = static_cast<Time>(16'667 + random.between(-80, 80));
  }
  for (std::size_t i = 1; i < players; ++i) {
    match.peers[i]->is_off = ((config.absent >> i) & 1u) != 0;
  }
  std::size_t lives = 0;
  for (int change = 0; change < 5; ++change) {
    const auto until = match.now() + 300'000 + random.below(2'500'000);
    (void)play_until(match, until, [] { return false; });
    const auto i = 1 + random.below(match.peers.size() - 1);
    MatchPeer& peer = *match.peers[i];
    if (!peer.is_off && random.coin()) {
      peer.is_off = true;
    } else if (!peer.is_off || random.below(3) != 0) {
      match.restart(i, !random.one_in(5));  // at once, or after a while
      ++lives;
    }
  }
  const auto limit = match.now() + 60'000'000;
  const auto end = checked(match, 0) + 60;
  bool is_done = false;
  const auto has_caught_up = [&](std::size_t i) {
    const auto& session = match.peers[i]->session;
    const bool has_seat = session.is_player() || i >= players || !session.config().wants_seat;
    return has_seat && session.checked_frame() >= end && !session.is_dropped(0);
  };
  while (!is_done && match.now() < limit) {
    (void)play_until(match, match.now() + 500'000, [] { return false; });
    is_done = true;
    for (std::size_t i = 0; i < match.peers.size(); ++i) {
      MatchPeer& peer = *match.peers[i];
      if (peer.is_off) continue;
      // A peer that was dropped or fell behind joins again.
      const bool is_out = peer.session.is_dropped(0) || count_events(peer, Kind::too_slow, i) > 0;
      if (i != 0 && is_out) {
        peer.events.clear();
        match.restart(i);
        ++lives;
      }
      is_done = is_done && has_caught_up(i);
    }
  }
  INFO(story(match));
  REQUIRE(is_done);
  check_digests(match, 0);
  CHECK_FALSE(has_event(match, Kind::desync));
  CHECK_FALSE(has_event(match, Kind::contradiction));
  CHECK_FALSE(has_event(match, Kind::no_snapshot));
}

}  // namespace

TEST_CASE("join: a player whose program ended rejoins, gets the match and plays on") {
  for (const std::uint64_t loss : {0u, 200u}) {
    SessionConfig config;
    config.silence = 500'000;
    Match match(3, {40'000, 10'000, loss, 50}, configs(3, config));
    REQUIRE(match.run_until(100, 10'000'000));
    match.peers[2]->is_off = true;
    REQUIRE(match.run_until(200, 20'000'000));
    REQUIRE(match.peers[0]->ends[2]);
    match.restart(2);
    const MatchPeer& late = *match.peers[2];
    CHECK_FALSE(late.session.is_player());
    REQUIRE(play_until(match, match.now() + 5'000'000,
                       [&] { return count_events(late, Kind::joined, 2) == 1; }));
    CHECK(late.session.is_player());
    CHECK(late.session.start_frame() >= 190);
    CHECK(count_events(late, Kind::loaded, 0) + count_events(late, Kind::loaded, 1) == 1);
    for (std::size_t i = 0; i < 3; ++i) CHECK(count_events(*match.peers[i], Kind::joined, 2) == 1);
    CHECK(count_events(*match.peers[0], Kind::arrived, 2) == 1);
    REQUIRE(match.run_until(late.begin + 200, match.now() + 20'000'000));
    CHECK(match.peers[0]->session.world().position[2] != 0);
    CHECK_FALSE(match.peers[0]->session.is_dropped(2));
    INFO(story(match));
    check_digests(match, 0);
    check_digests(match, 1);
    CHECK_FALSE(has_event(match, Kind::desync));
  }
}

TEST_CASE("join: a seat that is free at the start is taken later") {
  SessionConfig config;
  config.absent = 1u << 1;
  Match match(4, {30'000, 0, 100, 0}, configs(3, config));
  match.peers[1]->is_off = true;
  REQUIRE(match.run_until(150, 10'000'000));
  CHECK(match.peers[0]->session.world().absent[1] >= 150);
  match.restart(1);
  REQUIRE(match.run_until(400, 20'000'000));
  CHECK(match.peers[1]->session.is_player());
  check_digests(match, 0);
  check_digests(match, 2);
}

TEST_CASE("join: a spectator joins late, and a player can come back only to watch") {
  SessionConfig config;
  config.spectators = 1;
  config.silence = 500'000;
  Match match(5, {30'000, 5'000, 100, 0}, configs(2, config));
  match.peers[2]->is_off = true;
  REQUIRE(match.run_until(300, 10'000'000));
  match.restart(2);
  REQUIRE(match.run_until(500, 20'000'000));
  CHECK(match.peers[2]->session.start_frame() >= 290);
  match.restart(1, false);
  REQUIRE(match.run_until(900, 30'000'000));
  CHECK_FALSE(match.peers[1]->session.is_player());
  CHECK(match.peers[0]->session.world().absent[1] > 100);
  check_digests(match, 0);
}

TEST_CASE("join: a peer that ends and rejoins at once is not mistaken for its old session") {
  SessionConfig config;
  Match match(6, {60'000, 30'000, 100, 100}, configs(3, config));
  REQUIRE(match.run_until(100, 10'000'000));
  for (int i = 0; i < 3; ++i) {
    match.restart(1);
    REQUIRE(play_until(match, match.now() + 20'000'000,
                       [&] { return match.peers[1]->session.is_player(); }));
    REQUIRE(match.run_until(checked(match, 0) + 150, match.now() + 20'000'000));
  }
  check_digests(match, 0);
  CHECK_FALSE(has_event(match, Kind::contradiction));
  CHECK_FALSE(has_event(match, Kind::desync));
}

TEST_CASE("join: a desync of a late joiner is found and named") {
  SessionConfig config;
  Match match(7, {20'000, 0, 0, 0}, configs(2, config));
  REQUIRE(match.run_until(100, 10'000'000));
  match.restart(1);
  REQUIRE(match.run_until(250, 20'000'000));
  REQUIRE(match.peers[1]->session.is_player());
  const auto frame = match.peers[1]->session.frame() + 20;
  match.simulate_at = [&](std::size_t peer, Toy& toy, const ToySession::Inputs& inputs) {
    simulate(toy, inputs);
    if (peer == 1 && inputs.frame() == frame) toy.position[6] ^= 1;
  };
  REQUIRE(match.run_until(frame + 100, 30'000'000));
  for (std::size_t i = 0; i < 2; ++i) {
    bool is_named = false;
    for (const auto& event : match.peers[i]->events) {
      is_named = is_named || (event.kind == Kind::desync_field && event.frame == frame &&
                              event.field.view() == "position[6]");
    }
    CHECK(is_named);
  }
}

TEST_CASE("join: an invalid snapshot is refused, and another player is asked") {
  SessionConfig config;
  config.silence = 700'000;
  Match match(8, {20'000, 0, 0, 0}, configs(3, config));
  REQUIRE(match.run_until(100, 10'000'000));
  // Player 0 sends slices of a world that nobody has: the digest is valid, the filler is not.
  detail::Outgoing<4200, 440> forged;
  std::size_t refused = 0;
  match.meddle = [&](std::size_t from, std::size_t to, Packet& packet) {
    if (from != 0 || to != 2 || match.peers[2]->session.is_player()) return;
    const auto read = detail::Packet::read<Pad>(
        std::span<const std::byte>(packet).subspan(detail::PacketHeader::size), 3);
    if (!read || !read->slice) return;
    for (std::size_t i = 0; i < 4100; ++i) forged.room()[i] = std::byte{7};
    forged.start(2, 1, read->slice->frame, 4100);
    auto lie = *read;
    lie.run_count = 0;
    detail::JoinState all;
    all.frame = read->slice->frame;
    all.first = read->slice->index;
    lie.slice = forged.next(all);
    packet.assign(600, {});
    detail::BitWriter out(std::span<std::byte>(packet).subspan(detail::PacketHeader::size));
    lie.write(out, 3, [](auto&, const auto&) {});
    packet.resize(detail::PacketHeader::size + out.byte_count());
    detail::PacketHeader{0}.seal(packet, 0);
  };
  match.on_event = [&](std::size_t peer, const SessionEvent& event) {
    refused += peer == 2 && event.kind == Kind::no_snapshot ? 1 : 0;
  };
  const auto start = match.now();
  match.network.is_cut = [&](std::size_t from, std::size_t to, Time now) {
    return from == 1 && to == 2 && now < start + 400'000;  // so it asks player 0 first
  };
  (void)play_until(match, start + 200'000, [] { return false; });
  match.restart(2);
  REQUIRE(play_until(match, 60'000'000, [&] { return match.peers[2]->session.is_player(); }));
  CHECK(refused > 0);
  REQUIRE(match.run_until(checked(match, 0) + 100, match.now() + 10'000'000));
  check_digests(match, 1);
}

TEST_CASE("join: random matches in which peers leave and rejoin end with equal digests") {
  for (std::uint64_t seed = 1; seed <= 150; ++seed) run_random_joins(seed);
}
TEST_CASE("join: matches that once exposed faults") {
  for (const std::uint64_t seed : {1013u, 2136u, 3003u, 4843u}) run_random_joins(seed);
}
TEST_CASE("join: 10,000 random matches", "[.demand]") {
  for (std::uint64_t seed = 1000; seed < 11'000; ++seed) run_random_joins(seed);
}
