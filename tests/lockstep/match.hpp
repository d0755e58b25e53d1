// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "lockstep/network.hpp"
#include "lockstep/toy.hpp"

namespace detent::test {

/// A peer of a simulated match: its session, its clock and its observations.
struct MatchPeer {
  ToySession session;
  Time tick = 0;               // of its next frame
  Time period = 0;             // of its frames: clocks drift
  std::vector<Pad> pressed{};  // its inputs, from the first frame in which they take effect
  std::vector<std::uint64_t> chain{0};  // digests of all frames before the index
  std::vector<SessionEvent> events{};
  std::array<std::optional<std::uint32_t>, 8> ends{};
  std::uint64_t starved = 0, waited = 0;
  bool is_off = false;  // its program has ended
  std::uint32_t life = 0;
  std::uint32_t begin = 0;  // the first frame in which inputs of its current session take effect
};

/// Sessions that play over a simulated network. Silent peers are dropped.
class Match {
 public:
  Match(std::uint64_t seed, const Weather& weather, std::vector<SessionConfig> configs)
      : network(seed, weather), random_(seed + 1) {
    for (auto& config : configs) {
      config.self = peers.size();
      peers.push_back(std::make_unique<MatchPeer>(MatchPeer{ToySession(config, Toy{})}));
      MatchPeer& peer = *peers.back();
      peer.tick = random_.below(200'000);
      peer.period = 16'667;
      for (std::uint32_t i = 0; i < peer.session.config().delay; ++i) peer.pressed.emplace_back();
    }
  }

  /// Simulates a frame of a peer instead of `play`.
  std::function<void(std::size_t peer, Toy&, const ToySession::Inputs&)> simulate_at =
      [](std::size_t, Toy& toy, const ToySession::Inputs& inputs) { simulate(toy, inputs); };
  std::function<void(std::size_t peer, const SessionEvent&)> on_event = [](auto, const auto&) {};
  /// Changes a packet in transit.
  std::function<void(std::size_t from, std::size_t to, Packet&)> meddle = [](auto, auto, auto&) {};
  std::uint64_t keep_pressed = 8;  // an input changes once in this many frames
  bool drops_silent = true;
  bool awaits_spectators = true;

  /// The peer that is due next plays one tick.
  void tick() {
    std::size_t i = 0;
    for (std::size_t k = 0; k < peers.size(); ++k) {
      if (peers[k]->tick < peers[i]->tick) i = k;
    }
    MatchPeer& peer = *peers[i];
    const Time now = peer.tick;
    peer.tick += peer.period;
    now_ = now;
    network.deliver(now, [&](std::size_t from, std::size_t to, const Packet& sent, Time when) {
      Packet packet = sent;
      meddle(from, to, packet);
      if (!peers[to]->is_off) peers[to]->session.receive(from, packet, when);
    });
    if (!peer.is_off) run(i, peer, now);
  }
  /// Plays until all running peers have checked `frames` frames. Returns whether they did before
  /// `limit`.
  [[nodiscard]] bool run_until(std::uint32_t frames, Time limit) {
    while (now_ < limit) {
      bool is_done = true;
      for (std::size_t i = 0; i < peers.size(); ++i) {
        is_done = is_done && (!is_awaited(i) || peers[i]->session.checked_frame() >= frames);
      }
      if (is_done) return true;
      tick();
    }
    return false;
  }

  /// Ends a peer's program and restarts it: it joins late.
  void restart(std::size_t i, bool wants_seat = true) {
    MatchPeer& peer = *peers[i];
    auto config = peer.session.config();
    config.life = ++peer.life;
    config.wants_seat = wants_seat;
    peer.session = ToySession(config, Toy{});
    peer.chain.assign(1, 0);
    peer.begin = 0xffffffffu;
    peer.is_off = false;
  }

  /// The digests of all frames, simulated offline from the players' inputs and from the frames in
  /// which they left according to `peer`.
  [[nodiscard]] std::vector<std::uint64_t> offline(std::size_t peer, std::uint32_t frames) const {
    Toy toy;
    std::vector<std::uint64_t> chain{0};
    const auto& config = peers[peer]->session.config();
    const auto players = config.players;
    std::array<std::vector<SessionEvent>, 8> changes;  // of who is in, according to `peer`
    for (const auto& event : peers[peer]->events) {
      const bool is_change =
          event.kind == SessionEvent::Kind::left || event.kind == SessionEvent::Kind::joined;
      if (is_change) changes[event.peer].push_back(event);
    }
    for (std::uint32_t frame = 0; frame < frames; ++frame) {
      FrameInputs<Pad, 8> inputs(frame, players);
      for (std::size_t i = 0; i < players; ++i) {
        bool is_in = ((config.absent >> i) & 1u) == 0;
        for (const auto& change : changes[i]) {
          if (change.frame <= frame) is_in = change.kind == SessionEvent::Kind::joined;
        }
        if (is_in) inputs.set(i, peers[i]->pressed.at(frame));
      }
      simulate(toy, inputs);
      Digest digest(chain.back());
      digest.add(detail::WorldDigest(toy).all());
      chain.push_back(digest.value());
    }
    return chain;
  }

  [[nodiscard]] Time now() const { return now_; }
  /// Whether the match is over only once this peer has played it.
  [[nodiscard]] bool is_awaited(std::size_t i) const {
    const auto& peer = *peers[i];
    return !peer.is_off && (awaits_spectators || i < peer.session.config().players);
  }

  Network network;
  std::vector<std::unique_ptr<MatchPeer>> peers;

 private:
  void run(std::size_t i, MatchPeer& peer, Time now) {
    ToySession& session = peer.session;
    Pad pad = peer.pressed.empty() ? Pad{} : peer.pressed.back();
    if (random_.one_in(keep_pressed)) {
      pad = {static_cast<std::int16_t>(random_.between(-3, 3)), random_.coin()};
    }
    const auto acts = session.frame() + session.config().delay;
    const auto result = session.advance(
        pad, [&](Toy& toy, const ToySession::Inputs& inputs) { simulate_at(i, toy, inputs); });
    if (result == Advanced::yes && session.is_player() && acts >= peer.begin) {
      if (peer.pressed.size() <= acts) peer.pressed.resize(acts + 1);
      peer.pressed[acts] = pad;
    }
    peer.starved += result == Advanced::starved ? 1 : 0;
    peer.waited += result == Advanced::ahead ? 1 : 0;
    while (peer.chain.size() <= session.checked_frame()) {
      peer.chain.push_back(peer.chain.size() == session.checked_frame() ? session.digest() : 0);
    }
    session.poll(now, [&](std::size_t to, std::span<const std::byte> bytes) {
      network.send(i, to, bytes, now);
    });
    while (const auto event = session.next_event()) {
      peer.events.push_back(*event);
      if (event->kind == SessionEvent::Kind::joined && event->peer == i) peer.begin = event->frame;
      if (event->kind == SessionEvent::Kind::left) peer.ends[event->peer] = event->frame;
      if (event->kind == SessionEvent::Kind::silent && drops_silent) session.drop(event->peer);
      on_event(i, *event);
    }
  }

  Random random_;
  Time now_ = 0;
};

/// The peers' observations, for failure messages.
inline std::string story(const Match& match) {
  std::string result;
  for (const auto& peer : match.peers) {
    const auto& session = peer->session;
    result += "\npeer " + std::to_string(session.config().self) + ", frame " +
              std::to_string(session.frame()) + ", checked " +
              std::to_string(session.checked_frame()) + ":";
    for (const auto& event : peer->events) {
      result += " " + std::string(describe(event.kind)) + " " + std::to_string(event.peer) + " " +
                std::to_string(event.frame) + ",";
    }
  }
  return result;
}

}  // namespace detent::test
