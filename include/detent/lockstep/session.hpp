// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "detent/lockstep/config.hpp"
#include "detent/lockstep/event.hpp"
#include "detent/lockstep/input_queue.hpp"
#include "detent/lockstep/members.hpp"
#include "detent/lockstep/packet.hpp"
#include "detent/lockstep/peer.hpp"
#include "detent/lockstep/timeline.hpp"
#include "detent/lockstep/transfer.hpp"
#include "detent/scene/world.hpp"

namespace detent {

/// A world whose snapshots a session can send to who comes late: with functions
///
///     std::size_t snapshot(const World&, std::span<std::byte> room);   // written if it fits
///     bool restore(World&, std::span<const std::byte> bytes);          // any bytes; or `Restored`
///
/// found by argument-dependent lookup. Scenes and worlds of bodies have them. What they leave out,
/// such as fixed bodies, must be in the world that a session starts with.
template <class World>
concept SnapshotWorld = requires(World& world, const World& from, std::span<std::byte> room,
                                 std::span<const std::byte> bytes) {
  { snapshot(from, room) } -> std::convertible_to<std::size_t>;
  restore(world, bytes);
};

/// What `Session::receive` did with a packet.
enum class Received : std::uint8_t {
  yes,
  other_match,  // or broken, of another version or not from this peer
  malformed,    // it says what no session says; nothing of it was used
  dropped,      // its sender was dropped
};

/// What `Session::advance` did.
enum class Advanced : std::uint8_t {
  yes,          // it simulated a new frame with the given input
  connecting,   // not every player has been heard
  catching_up,  // frames to simulate again are left for the next call
  starved,      // an input of another player is needed first: see `is_awaited`
  ahead,        // the others are behind; waits one frame for them
  paused,       // by a player, or by `pause`
  over,         // a spectator without players, or 2^31 frames
  joining,      // the snapshot of the match has not come yet
};

/// A match of 2 to 8 players and spectators who simulate the same world and exchange inputs alone.
///
/// It knows neither sockets nor clocks: packets go in by `receive` and out by `poll`, and the caller
/// says what time it is. Packets may be lost, doubled, delayed and reordered. An input takes effect
/// `delay` frames later. Until the inputs of others come they are predicted to stay the same, for
/// up to `prediction` frames; frames that used a wrong guess are simulated again.
///
///     Session<Game, Pad> session({.match = id, .self = 0}, game);
///     // for every packet:             session.receive(peer, bytes, now);
///     // sixty times a second:         session.advance(pad, simulate);
///     //                               session.poll(now, send);
///     // simulate(Game&, const FrameInputs<Pad, 8>&) is the game; send(peer, span of bytes) is yours
///
/// World: a `RollbackWorld`, which `simulate` changes by its inputs alone (`SyncTest` shows that).
/// Input: anything with an `InputCodec`. All storage is inside, sized by `Limits`: nothing here
/// allocates, unless copies of the world do.
///
/// Any bytes may come in. A peer can neither change an input that it sent, nor make another write
/// out of bounds, wait unseen, or go on with other inputs unnoticed: one that sends different inputs
/// to different peers shows as a `desync` whose field is `input`. Who may join, and that packets are
/// from whom they seem to be, is up to the transport.                      (fuzz/lockstep.cpp)
///
/// A peer that comes late, or again after its program ended, starts a session with a `life` and with
/// the same world at the start as all others. It gets a snapshot in slices, catches up, and takes its
/// seat if that is free and it wants to; `Limits.snapshot` must have room at both ends.
/// (tests/lockstep/join.test.cpp)
///
/// (tests/lockstep/session.test.cpp, tests/lockstep/match.test.cpp, tests/examples/lockstep.cpp)
template <RollbackWorld World, class Input, SessionLimits Limits = SessionLimits{}>
class Session {
  static_assert(Limits.is_valid(), "see the bounds of each field in SessionLimits");

 public:
  using Inputs = FrameInputs<Input, Limits.players>;

  /// All peers start from equal worlds.
  Session(const SessionConfig& config, const World& start)
      : config_(config.within(Limits)), timeline_(start), members_(config_.self, config_.players) {
    is_loading_ = config_.life != 0;
    is_guest_ = is_loading_;
    for (std::size_t i = 0; i < config_.players; ++i) {
      const bool is_absent = ((config_.absent >> i) & 1u) != 0 && i != config_.self;
      if (is_absent && !is_loading_) members_.leave_empty(i, 0);
    }
    if (!is_player()) return;
    for (std::uint32_t i = 0; i < config_.delay; ++i) {
      own().push(detail::wire_of<Input>(detail::bytes_of(Input{})));
    }
  }

  /// Takes a packet that the transport got from `peer`.
  Received receive(std::size_t peer, std::span<const std::byte> bytes, std::uint64_t now);

  /// Simulates frames again whose inputs were guessed wrong, then the next frame, if it may. The
  /// input was used if the result is `yes`.
  template <class Simulate>
  Advanced advance(const Input& input, const Simulate& simulate);

  /// The frames of `advance` one after another, for callers that cannot pass a function:
  ///
  ///     while (const auto inputs = session.open_frame(pad)) {
  ///       simulate(session.opened(), *inputs);
  ///       session.close_frame();
  ///     }
  ///
  /// Nothing when no more are due now: `advanced()` is what `advance` would return. A frame that was
  /// not closed before the next call, or before one of `receive`, `poll` and `drop`, is opened again
  /// as it was at first.
  [[nodiscard]] std::optional<Inputs> open_frame(const Input& input);
  /// The world of the open frame.
  [[nodiscard]] World& opened() { return timeline_.opened(); }
  [[nodiscard]] bool is_open() const { return timeline_.is_open(); }
  /// The open frame is simulated. Nothing if none is open.
  void close_frame();
  /// What the last `advance`, or the frames of the last `open_frame`, did.
  [[nodiscard]] Advanced advanced() const { return advanced_; }

  /// Calls send(peer, bytes) with what is due for each peer, at most one packet for each.
  template <class Send>
  void poll(std::uint64_t now, const Send& send);

  /// What happened since, oldest first.
  [[nodiscard]] std::optional<SessionEvent> next_event() { return events_.pop(); }

  /// The world after the last frame that is simulated.
  [[nodiscard]] const World& world() const { return timeline_.world(); }
  /// The number of frames played.
  [[nodiscard]] std::uint32_t frame() const { return frame_; }
  /// The number of frames whose results are final: no packet can change them.
  [[nodiscard]] std::uint32_t final_frame() const { return (std::min)(known(), timeline_.done()); }
  /// The world after a frame, while it is kept.
  [[nodiscard]] const World* result(std::uint32_t frame) const {
    return timeline_.has_result(frame) ? &timeline_.result(frame) : nullptr;
  }
  /// The inputs of a final frame, while they are kept.
  [[nodiscard]] std::optional<Inputs> inputs(std::uint32_t frame) const {
    if (frame >= final_frame() || frame + Limits.history / 2 < frame_ || frame < start_) {
      return std::nullopt;
    }
    return inputs_of(frame).inputs;
  }
  /// A digest of the results of all frames before `checked_frame()`.
  [[nodiscard]] std::uint64_t digest() const { return checksums_.chain(); }
  [[nodiscard]] std::uint32_t checked_frame() const { return checksums_.count(); }
  /// All frames before this one are known to be equal at `peer` and here.
  [[nodiscard]] std::uint32_t matched_frame(std::size_t peer) const {
    return peer < peers_.size() ? peers_[peer].comparison.matched() : 0;
  }

  /// Goes on without a peer, as the caller decides when it is silent. All who go on agree on the
  /// first frame without this player.
  void drop(std::size_t peer);
  /// Whether this peer was dropped, by anyone.
  [[nodiscard]] bool is_dropped(std::size_t peer) const {
    return peer < peers_.size() && (members_.is_dropped(peer) || peers_[peer].is_gone);
  }
  /// Whether this peer plays: it is a player, and if it came late it has its seat.
  [[nodiscard]] bool is_player() const { return config_.self < config_.players && !is_guest_; }
  /// The first frame that is known here: 0, or the one of the snapshot it began with.
  [[nodiscard]] std::uint32_t start_frame() const { return start_; }
  /// Stops, or goes on; the others see it.
  void pause(bool is_paused) { is_paused_ = is_paused; }

  /// Whether this player keeps the session from going on.
  [[nodiscard]] bool is_awaited(std::size_t player) const;

  /// Frames that were simulated more than once, counted each time.
  [[nodiscard]] std::uint64_t resimulated() const { return simulated_ - frame_; }
  [[nodiscard]] const SessionConfig& config() const { return config_; }

 private:
  using Wire = detail::WireInput<Input>;
  using Queue = detail::InputQueue<Input, Limits.history>;
  using Timeline =
      detail::Timeline<World, Input, Limits.players, Limits.prediction + Limits.evidence + 2>;
  using Kind = SessionEvent::Kind;
  struct Used {
    Inputs inputs;
    typename Timeline::Used bytes{};
  };
  static constexpr std::uint32_t lead = 64;  // inputs that are kept beyond final frames
  static constexpr std::uint32_t last_frame = 0x7fffffff - lead;

  static constexpr std::uint32_t notice = 32;  // frames from giving a seat to taking it
  static constexpr bool can_serve = Limits.snapshot > 0 && SnapshotWorld<World>;
  static_assert(Limits.snapshot == 0 || SnapshotWorld<World>,
                "who comes late needs snapshot(world, room) and restore(world, bytes)");
  static constexpr std::size_t slice_size = Limits.packet - detail::Packet::slice_room;
  static constexpr std::size_t most_peers_mark = 15;  // asks nobody yet

  [[nodiscard]] std::size_t peer_count() const { return config_.players + config_.spectators; }
  [[nodiscard]] Queue& own() { return queues_[config_.self]; }
  void tell(Kind kind, std::size_t peer, std::uint32_t frame = 0) {
    events_.push({kind, peer, frame, {}, {}});
  }

  [[nodiscard]] std::uint32_t known_of(std::size_t player) const;
  [[nodiscard]] std::uint32_t known_of_others() const;
  [[nodiscard]] std::uint32_t known() const;
  [[nodiscard]] bool is_deserted() const;
  [[nodiscard]] Used inputs_of(std::uint32_t frame) const;

  void apply(std::size_t from, const detail::Packet& packet);
  void take(std::size_t from, detail::InputRun run);
  void agree();
  void admit();
  void let_in(std::size_t seat, std::uint32_t frame);
  [[nodiscard]] std::byte invitation();
  [[nodiscard]] bool meet(std::size_t peer, const detail::Packet& packet);
  [[nodiscard]] bool hear_guest(std::size_t from, const detail::Packet& packet);
  void serve();
  [[nodiscard]] static constexpr std::size_t snapshot_head(std::size_t players) {
    return 4 + 1 + 8 + players * (1 + 1 + 4 + std::tuple_size_v<Wire>);
  }
  [[nodiscard]] std::size_t write_snapshot(std::uint32_t frame, std::span<std::byte> room) const;
  [[nodiscard]] bool read_snapshot(std::span<const std::byte> bytes);
  void load(std::size_t from, const detail::Packet& packet, std::uint64_t now);
  void ask_another(std::uint64_t now);
  [[nodiscard]] std::optional<detail::JoinState> join_state() const;
  /// Whether packets go to this peer and are read from it.
  [[nodiscard]] bool is_met(std::size_t peer) const {
    return !is_dropped(peer) || peers_[peer].is_guest;
  }
  void compare(std::size_t from, const detail::Packet& packet);
  void found_desync(std::size_t peer);
  template <class Visit>
  void with_evidence(std::uint32_t frame, const Visit& visit) const;

  [[nodiscard]] Inputs open();
  [[nodiscard]] std::optional<Advanced> obstacle();

  [[nodiscard]] bool is_due(std::size_t to, std::uint64_t now);
  [[nodiscard]] std::size_t write(std::size_t to, std::span<std::byte> room);
  void add_run(detail::Packet& packet, std::size_t player, std::uint32_t first,
               std::size_t& bits) const;

  SessionConfig config_;
  Timeline timeline_;
  detail::Members members_;
  std::array<Queue, Limits.players> queues_{};
  std::array<detail::Peer, Limits.peers> peers_{};
  detail::Checksums<Limits.history> checksums_;
  detail::EventQueue<Limits.events> events_;
  detail::Waiting waiting_;
  std::optional<World> odd_;  // our result of the frame that differs
  typename Timeline::Used odd_inputs_{};
  std::uint32_t odd_frame_ = 0;
  std::uint32_t frame_ = 0;
  std::uint64_t simulated_ = 0;
  detail::Outgoing<Limits.snapshot, slice_size> outgoing_;
  detail::Incoming<Limits.snapshot, slice_size> incoming_;
  std::optional<std::size_t> source_;  // the player that we ask for a snapshot
  std::uint64_t progress_ = 0;         // when the last slice came
  std::uint32_t start_ = 0;
  std::uint32_t admitted_ = 0;  // frames whose words are read
  std::uint32_t served_ = 0;    // the frame of the last snapshot
  bool is_loading_ = false, is_guest_ = false, is_lost_ = false;
  bool is_paused_ = false;
  bool is_expelled_ = false;
  std::uint32_t left_ = 0;  // frames that this call of `advance` may still simulate
  bool is_advancing_ = false, has_played_ = false;
  Advanced advanced_ = Advanced::connecting;
};

}  // namespace detent

#include "detent/lockstep/advance.hpp"
#include "detent/lockstep/join.hpp"
#include "detent/lockstep/receive.hpp"
#include "detent/lockstep/send.hpp"
