// SPDX-License-Identifier: MIT
//
// Two honest players and one who sends anything: non-packets, sealed packets of any bits, packets
// of a third session with changed bits, slices of snapshots, other lives and terms. A spectator
// joins late and hears them all. Whatever arrives, the inputs of the honest players take effect in
// both sessions in the right frames; equal inputs give both equal results; and where the third
// player sent them different inputs, both detect it.

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "detent/lockstep/replay.hpp"
#include "lockstep/toy.hpp"
#include "property.hpp"
#include "source.hpp"

namespace detent::fuzz {
namespace {

using test::Pad;
using test::Toy;
using test::ToySession;
using Packet = std::vector<std::byte>;

constexpr std::uint64_t match = 99, tick = 16'667;
constexpr std::size_t liar = 2;

/// A session, and what it considered final.
struct Honest {
  ToySession session;
  std::vector<Pad> pressed{};
  std::vector<std::array<Pad, 3>> inputs{};
  std::vector<bool> is_in{};  // player 2, by frame
  std::vector<std::uint64_t> chain{0};
  bool has_desync = false;
};

class Game {
 public:
  explicit Game(Source& source) : source_(source) {
    SessionConfig config;
    config.match = match;
    config.players = 3;
    config.delay = static_cast<std::uint32_t>(source.below(4));
    config.prediction = static_cast<std::uint32_t>(1 + source.below(12));
    config.silence = 30 * tick;
    config.spectators = 1;
    for (std::size_t i = 0; i < 3; ++i) {
      config.self = i;
      players_[i] = std::make_unique<Honest>(Honest{ToySession(config, Toy{})});
      players_[i]->pressed.resize(i == liar ? 0 : config.delay);
    }
    config.self = 3;
    config.life = 1;
    late_ = std::make_unique<ToySession>(config, Toy{});
  }

  void play(int ticks, bool is_lying) {
    for (int i = 0; i < ticks; ++i, now_ += tick) {
      for (std::size_t self = 0; self < 3; ++self) advance(self);
      for (std::size_t self = 0; self < 3; ++self) {
        players_[self]->session.poll(now_, [&](std::size_t to, std::span<const std::byte> bytes) {
          if (self == liar && is_lying) return send_lie({bytes.begin(), bytes.end()}, to);
          deliver(self, to, bytes);
        });
      }
      late_->advance({}, test::play);
      late_->poll(now_,
                  [&](std::size_t to, std::span<const std::byte> bytes) { deliver(3, to, bytes); });
      require(late_->final_frame() <= late_->frame(), [] { return std::string("from nowhere"); });
    }
  }

  void check() const {
    const Honest &a = *players_[0], &b = *players_[1];
    const bool is_one_match = !a.session.is_dropped(1) && !b.session.is_dropped(0);
    const auto frames = std::min(a.inputs.size(), b.inputs.size());
    bool has_equal_inputs = true;
    for (std::size_t frame = 0; is_one_match && frame < frames; ++frame) {
      for (const std::size_t i : {0u, 1u}) {
        const Pad& pressed = players_[i]->pressed.at(frame);
        require(a.inputs[frame][i] == pressed && b.inputs[frame][i] == pressed,
                [] { return std::string("an honest input has changed"); });
      }
      has_equal_inputs = has_equal_inputs && a.inputs[frame][liar] == b.inputs[frame][liar] &&
                         a.is_in[frame] == b.is_in[frame];
      const auto next = frame + 1;
      if (next >= a.chain.size() || next >= b.chain.size()) break;
      if (a.chain[next] == 0 || b.chain[next] == 0) continue;
      require((a.chain[next] == b.chain[next]) == has_equal_inputs,
              [] { return std::string("equal inputs gave different results"); });
    }
    require(!is_one_match || has_equal_inputs || (a.has_desync && b.has_desync),
            [] { return std::string("different inputs were not noticed"); });
  }

 private:
  void advance(std::size_t self) {
    Honest& player = *players_[self];
    ToySession& session = player.session;
    const Pad pad{static_cast<std::int16_t>(now_ / tick / (3 + self) % 5), now_ / tick % 7 == 0};
    if (session.advance(pad, test::play) == Advanced::yes) player.pressed.push_back(pad);
    for (auto frame = player.inputs.size(); frame < session.final_frame(); ++frame) {
      const auto inputs = session.inputs(static_cast<std::uint32_t>(frame));
      require(inputs.has_value(), [] { return std::string("final inputs are not kept"); });
      player.inputs.push_back({(*inputs)[0], (*inputs)[1], (*inputs)[2]});
      player.is_in.push_back(inputs->is_in(liar));
    }
    while (player.chain.size() <= session.checked_frame()) {
      player.chain.push_back(player.chain.size() == session.checked_frame() ? session.digest() : 0);
    }
    while (const auto event = session.next_event()) {
      player.has_desync |= event->kind == SessionEvent::Kind::desync;
      if (event->kind == SessionEvent::Kind::silent && event->peer == liar) session.drop(liar);
    }
  }

  void deliver(std::size_t from, std::size_t to, std::span<const std::byte> bytes) {
    ToySession& session = to == 3 ? *late_ : players_[to]->session;
    session.receive(from, bytes, now_);
  }
  /// A packet that announces a late join or new seats, or has a slice of a snapshot.
  Packet late_lie(const Packet& honest) {
    const auto body = std::span<const std::byte>(honest).subspan(detail::PacketHeader::size);
    auto packet = detail::Packet::read<Pad>(body, 3);
    if (!packet) return honest;
    packet->run_count = 0;
    if (source_.below(2) == 0) packet->terms[source_.below(3)] = source_.byte();
    if (source_.below(2) == 0) {
      detail::JoinState join;
      join.life = source_.byte();
      join.wants_seat = source_.below(2) == 0;
      join.is_loaded = source_.below(2) == 0;
      join.start = static_cast<std::uint32_t>(source_.word(source_.below(2) == 0 ? 1 : 4));
      join.source = source_.below(4);
      join.frame = source_.byte();
      join.first = static_cast<std::uint32_t>(source_.word(source_.below(2) == 0 ? 1 : 4));
      join.later = static_cast<std::uint32_t>(source_.word(4));
      packet->join = join;
    }
    Packet bytes(440, static_cast<std::byte>(source_.byte()));
    if (source_.below(2) == 0) {
      detail::Slice slice;
      slice.frame = source_.byte();
      slice.total = static_cast<std::uint32_t>(source_.word(2));
      slice.digest = source_.below(2) == 0 ? detail::digest_from(0, bytes) : source_.byte();
      slice.index = source_.byte();
      slice.size = static_cast<std::uint32_t>(source_.word(2) % 441);
      slice.bytes = std::span<const std::byte>(bytes).first(slice.size);
      packet->slice = slice;
    }
    Packet result(600);
    detail::BitWriter out(std::span<std::byte>(result).subspan(detail::PacketHeader::size));
    packet->write(out, 3, [](auto&, const auto&) {});
    result.resize(std::min(result.size(), detail::PacketHeader::size + out.byte_count()));
    return result;
  }

  void send_lie(Packet packet, std::size_t to) {
    const auto kind = source_.below(5);
    if (kind == 0) return;  // silence
    if (kind == 1) {
      packet.resize(detail::PacketHeader::size + source_.below(64));
      for (auto& byte : packet) byte = static_cast<std::byte>(source_.byte());
    } else if (kind == 2) {
      for (auto changes = source_.below(4); changes > 0; --changes) {
        const auto bit = source_.word(2) % (8 * packet.size());
        packet[bit / 8] ^= std::byte{1} << (bit % 8);
      }
    }
    if (kind == 4) packet = late_lie(packet);
    if (source_.below(8) != 0) {
      detail::PacketHeader{liar}.seal(packet, match);
    }
    deliver(liar, to, packet);
  }

  Source& source_;
  std::array<std::unique_ptr<Honest>, 3> players_;
  std::unique_ptr<ToySession> late_;
  std::uint64_t now_ = 0;
};

}  // namespace

void property(Bytes input) {
  Source source(input);
  Game game(source);
  game.play(5, false);
  const int lies = static_cast<int>(5 + source.below(30));
  game.play(lies, true);
  game.play(60, false);  // time to notice
  game.check();
}

}  // namespace detent::fuzz
