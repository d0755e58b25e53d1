// SPDX-License-Identifier: MIT
//
// Whole matches over a simulated network.
#include "lockstep/match.hpp"

#include <algorithm>

#include "support/catch.hpp"

using namespace detent;
using namespace detent::test;

namespace {

/// All peers' digests are those of the offline simulation of the players' inputs.
void check_digests(const Match& match, std::uint32_t at_least) {
  for (std::size_t i = 0; i < match.peers.size(); ++i) {
    const MatchPeer& peer = *match.peers[i];
    if (!match.is_awaited(i)) continue;
    REQUIRE(peer.session.checked_frame() >= at_least);
    const auto offline = match.offline(i, peer.session.checked_frame());
    for (std::size_t frame = 0; frame < offline.size(); ++frame) {
      if (peer.chain[frame] != 0 && peer.chain[frame] != offline[frame]) {
        FAIL("peer " << i << " has another digest before frame " << frame);
      }
    }
  }
}

/// No peer reported an event of this kind.
bool has_event(const Match& match, SessionEvent::Kind kind) {
  return std::any_of(match.peers.begin(), match.peers.end(), [&](const auto& peer) {
    return std::any_of(peer->events.begin(), peer->events.end(),
                       [&](const SessionEvent& event) { return event.kind == kind; });
  });
}

std::vector<SessionConfig> configs(std::size_t players, SessionConfig config = {}) {
  config.players = players;
  return std::vector<SessionConfig>(players + config.spectators, config);
}

/// A fully random match: players, delays, network, clocks, and who falls silent when.
class RandomMatch {
 public:
  explicit RandomMatch(std::uint64_t seed)
      : random_(seed), match_(seed, weather(), draw_configs()) {
    for (auto& peer : match_.peers) {
      peer->period = static_cast<Time>(16'667 + random_.between(-80, 80));  // half a percent
    }
    if (random_.one_in(3)) {
      falls_silent_ = random_.below(players_);
      silent_from_ = 400'000 + random_.below(2'000'000);
      // Gone for good, cut off for a while, or heard only by some.
      const auto way = random_.below(3);
      const auto until = way == 1 ? silent_from_ + random_.below(400'000) : ~Time{0};
      const auto some = way == 2 ? random_.next() : ~std::uint64_t{0};
      // A spectator that does not hear a player whom others hear falls behind.
      if (way == 2) match_.awaits_spectators = false;
      match_.network.is_cut = [=, this](std::size_t from, std::size_t to, Time now) {
        const auto other = from == falls_silent_ ? to : from;
        return (from == falls_silent_ || to == falls_silent_) && now >= silent_from_ &&
               now < until && ((some >> other) & 1u) != 0;
      };
    }
  }

  void run(std::uint32_t frames) {
    const bool is_done = match_.run_until(frames, 60'000'000);
    INFO(story(match_));
    REQUIRE(is_done);
    check_digests(match_, frames);
    CHECK_FALSE(has_event(match_, SessionEvent::Kind::desync));
    CHECK_FALSE(has_event(match_, SessionEvent::Kind::contradiction));
    check_ends();
  }
  [[nodiscard]] bool had_drop() const { return has_event(match_, SessionEvent::Kind::left); }

 private:
  Weather weather() {
    Weather weather;
    weather.latency = random_.below(120'000);
    weather.jitter = random_.coin() ? random_.below(60'000) : 0;
    weather.loss = random_.coin() ? random_.below(300) : 0;
    weather.doubling = random_.coin() ? random_.below(200) : 0;
    return weather;
  }
  std::vector<SessionConfig> draw_configs() {
    players_ = 2 + random_.below(7);
    SessionConfig config;
    config.match = random_.next();
    config.spectators = random_.one_in(3) ? 1 + random_.below(2) : 0;
    config.silence = 1'000'000 + random_.below(500'000);
    auto all = configs(players_, config);
    for (auto& one : all) {
      one.delay = static_cast<std::uint32_t>(random_.below(9));
      one.prediction = static_cast<std::uint32_t>(random_.one_in(4) ? 0 : random_.below(17));
      one.frames_per_call = static_cast<std::uint32_t>(1 + random_.below(17));
      if (one.frames_per_call < 3) one.frames_per_call = 3;
    }
    return all;
  }
  /// Peers that still listen to each other agree on who left when.
  void check_ends() {
    for (std::size_t a = 0; a < players_; ++a) {
      for (std::size_t b = 0; b < a; ++b) {
        const MatchPeer &of_a = *match_.peers[a], &of_b = *match_.peers[b];
        if (of_a.session.is_dropped(b) || of_b.session.is_dropped(a)) continue;
        for (std::size_t i = 0; i < players_; ++i) {
          if (of_a.ends[i] && of_b.ends[i]) CHECK(*of_a.ends[i] == *of_b.ends[i]);
        }
      }
    }
  }

  Random random_;
  std::size_t players_ = 0;
  std::size_t falls_silent_ = 0;
  Time silent_from_ = 0;
  Match match_;
};

void run_random_matches(std::uint64_t first, std::uint64_t count) {
  std::uint64_t drops = 0;
  for (auto seed = first; seed < first + count; ++seed) {
    INFO("seed " << seed);
    RandomMatch match(seed);
    match.run(150);
    drops += match.had_drop() ? 1 : 0;
  }
  CHECK(drops * 10 > count);  // players must leave often enough
}

}  // namespace

TEST_CASE("match: two players without latency never resimulate") {
  SessionConfig config;
  config.delay = 3;
  Match match(1, {}, configs(2, config));
  REQUIRE(match.run_until(500, 60'000'000));
  check_digests(match, 500);
  CHECK(match.peers[0]->session.resimulated() == 0);
  CHECK(match.peers[1]->session.resimulated() == 0);
}

TEST_CASE("match: random matches end with the digests of an offline simulation") {
  run_random_matches(1000, 200);
}
TEST_CASE("match: 10,000 random matches", "[.demand]") { run_random_matches(1000, 10'000); }
