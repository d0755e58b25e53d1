// SPDX-License-Identifier: MIT
//
// The figures of docs/lockstep.md: a long match of two over a bad connection.
#include <cstdio>

#include "lockstep/match.hpp"
#include "support/catch.hpp"

using namespace detent;
using namespace detent::test;

namespace {

struct Figures {
  double resimulated, bytes_per_second, starved, waited;  // per frame, each way, in percent
};

/// A match of two with a round trip of 200 ms, 10 ms of jitter, every tenth packet lost and 60
/// frames per second. Clocks differ by 120 ppm; inputs change every eighth frame.
Figures play_long(std::uint32_t frames, std::uint32_t delay, std::uint32_t prediction,
                  std::uint64_t loss) {
  SessionConfig config;
  config.delay = delay;
  config.prediction = prediction;
  Match match(17, {95'000, 10'000, loss, 0}, {config, config});
  match.peers[1]->period += 2;
  REQUIRE(match.run_until(frames, Time{20'000} * frames * 2));
  const auto last = match.peers[0]->session.checked_frame();
  const auto offline = match.offline(0, last);
  std::size_t compared = 0;
  for (const auto& peer : match.peers) {
    for (std::size_t i = 0; i < offline.size() && i < peer->chain.size(); ++i) {
      if (peer->chain[i] == 0) continue;
      REQUIRE(peer->chain[i] == offline[i]);
      ++compared;
    }
  }
  CHECK(compared > frames);
  const auto of = [&](auto number) { return static_cast<double>(number) / (2.0 * frames); };
  const auto sum = [&](const auto& get) { return get(*match.peers[0]) + get(*match.peers[1]); };
  return {
      of(sum([](const MatchPeer& p) { return p.session.resimulated(); })),
      static_cast<double>(match.network.bytes()) / 2 / (1e-6 * static_cast<double>(match.now())),
      100 * of(sum([](const MatchPeer& p) { return p.starved; })),
      100 * of(sum([](const MatchPeer& p) { return p.waited; }))};
}

}  // namespace

TEST_CASE("figures: 20 % packet loss causes no request and hardly any stall") {
  const auto good = play_long(2000, 2, 12, 0), bad = play_long(2000, 2, 12, 200);
  CHECK(good.starved < 1);
  CHECK(bad.starved < 3);
  CHECK(bad.bytes_per_second < 1.2 * good.bytes_per_second);
}

TEST_CASE("figures: two players, 100,000 frames, 200 ms and 10 % of loss", "[.demand]") {
  std::printf("delay prediction | again a frame, bytes a second each way, starved %%, waited %%\n");
  for (const auto& [delay, prediction] :
       {std::pair{0u, 8u}, std::pair{2u, 8u}, std::pair{2u, 12u}, std::pair{4u, 8u},
        std::pair{8u, 0u}, std::pair{8u, 8u}}) {
    const auto figures = play_long(100'000, delay, prediction, 100);
    std::printf("%u %u | %.2f %.0f %.2f %.2f\n", delay, prediction, figures.resimulated,
                figures.bytes_per_second, figures.starved, figures.waited);
  }
}
