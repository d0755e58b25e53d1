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

/// A world whose snapshots a session can send to late peers: with functions
///
///     std::size_t snapshot(const World&, std::span<std::byte> room);   // written if it fits
///     bool restore(World&, std::span<const std::byte> bytes);          // any bytes; or `Restored`
///
/// found by argument-dependent lookup. Scenes and worlds of bodies have them. State that they leave
/// out, such as fixed bodies, must be in the world that a session starts with.
template <class World>
concept SnapshotWorld = requires(World& world, const World& from, std::span<std::byte> room,
                                 std::span<const std::byte> bytes) {
  { snapshot(from, room) } -> std::convertible_to<std::size_t>;
  restore(world, bytes);
};

/// The result of `Session::receive`.
enum class Received : std::uint8_t {
  yes,
  other_match,  // of another match, version or peer, or damaged
  malformed,    // no session sends such a packet; it was ignored
  dropped,      // its sender was dropped
};

/// The result of `Session::advance`.
enum class Advanced : std::uint8_t {
  yes,          // it simulated a new frame with the given input
  connecting,   // not every player has been heard yet
  catching_up,  // frames to resimulate are left for the next call
  starved,      // an input of another player is needed first: see `is_awaited`
  ahead,        // the others are behind; waits one frame
  paused,       // by a player, or by `pause`
  over,         // a spectator without players, or after 2^31 frames
  joining,      // the snapshot of the match has not arrived yet
};

/// A match of 2 to 8 players and spectators who simulate the same world and exchange only inputs.
///
/// It uses neither sockets nor clocks: packets go in by `receive` and out by `poll`, and the caller
/// passes the time. Packets may be lost, duplicated, delayed and reordered. An input takes effect
/// `delay` frames later. Until the inputs of others arrive they are predicted to stay the same, for
/// up to `prediction` frames; frames with a wrong prediction are simulated again.
///
///     Session<Game, Pad> session({.match = id, .self = 0}, game);
///     // for every packet:             session.receive(peer, bytes, now);
///     // sixty times a second:         session.advance(pad, simulate);
///     //                               session.poll(now, send);
///     // simulate(Game&, const FrameInputs<Pad, 8>&) is the game; send(peer, span of bytes) is yours
///
/// World: a `RollbackWorld`, which `simulate` changes only by its inputs (`SyncTest` checks that).
/// Input: anything with an `InputCodec`. All storage is inside the session, sized by `Limits`:
/// nothing here allocates, unless copies of the world do.
///
/// Any bytes may come in. A peer can neither change an input that it sent, nor make another peer
/// write out of bounds, wait without being reported, or continue with different inputs unnoticed:
/// sending different inputs to different peers shows as a `desync` whose field is `input`. The
/// transport decides who may join and must authenticate senders.
/// (fuzz/lockstep.cpp)
///
/// A peer that joins late, or rejoins after its program ended, starts a session with a `life` and
/// with the same initial world as all others. It gets a snapshot in slices, catches up, and takes
/// its seat if the seat is free and it wants to; `Limits.snapshot` must have room at both ends.
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

  /// Takes a packet that the transport received from `peer`.
  Received receive(std::size_t peer, std::span<const std::byte> bytes, std::uint64_t now);

  /// Resimulates frames whose inputs were mispredicted, then simulates the next frame, if it may.
  /// The input was used if the result is `yes`.
  template <class Simulate>
  Advanced advance(const Input& input, const Simulate& simulate);

  /// The frames of `advance` one after another, for callers that cannot pass a function:
  ///
  ///     while (const auto inputs = session.open_frame(pad)) {
  ///       simulate(session.opened(), *inputs);
  ///       session.close_frame();
  ///     }
  ///
  /// Returns nothing when no more frames are due now: `advanced()` is what `advance` would return.
  /// A frame that was not closed before the next call, or before one of `receive`, `poll` and
  /// `drop`, is reopened in its initial state.
  [[nodiscard]] std::optional<Inputs> open_frame(const Input& input);
  /// The world of the open frame.
  [[nodiscard]] World& opened() { return timeline_.opened(); }
  [[nodiscard]] bool is_open() const { return timeline_.is_open(); }
  /// Closes the open frame, once simulated. Does nothing if none is open.
  void close_frame();
  /// The result of the last `advance`, or of the frames of the last `open_frame`.
  [[nodiscard]] Advanced advanced() const { return advanced_; }

  /// Calls send(peer, bytes) for each peer to which a packet is due, at most one packet each.
  template <class Send>
  void poll(std::uint64_t now, const Send& send);

  /// The events since the last call, oldest first.
  [[nodiscard]] std::optional<SessionEvent> next_event() { return events_.pop(); }

  /// The world after the last simulated frame.
  [[nodiscard]] const World& world() const { return timeline_.world(); }
  /// The number of frames played.
  [[nodiscard]] std::uint32_t frame() const { return frame_; }
  /// The number of frames whose results are final: no packet can change them.
  [[nodiscard]] std::uint32_t final_frame() const { return (std::min)(known(), timeline_.done()); }
  /// The world after a frame, while it is stored.
  [[nodiscard]] const World* result(std::uint32_t frame) const {
    return timeline_.has_result(frame) ? &timeline_.result(frame) : nullptr;
  }
  /// The inputs of a final frame, while they are stored.
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

  /// Continues without a peer; the caller decides this when the peer is silent. All remaining peers
  /// agree on the first frame without this player.
  void drop(std::size_t peer);
  /// Whether any peer dropped this one.
  [[nodiscard]] bool is_dropped(std::size_t peer) const {
    return peer < peers_.size() && (members_.is_dropped(peer) || peers_[peer].is_gone);
  }
  /// Whether this peer plays: it is a player and, if it joined late, has its seat.
  [[nodiscard]] bool is_player() const { return config_.self < config_.players && !is_guest_; }
  /// The first frame known here: 0, or that of the snapshot it started with.
  [[nodiscard]] std::uint32_t start_frame() const { return start_; }
  /// Pauses or resumes; the others see it.
  void pause(bool is_paused) { is_paused_ = is_paused; }

  /// Whether this player holds up the session.
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
  static constexpr std::uint32_t lead = 64;  // inputs stored beyond final frames
  static constexpr std::uint32_t last_frame = 0x7fffffff - lead;

  static constexpr std::uint32_t notice = 32;  // frames from giving a seat to taking it
  static constexpr bool can_serve = Limits.snapshot > 0 && SnapshotWorld<World>;
  static_assert(Limits.snapshot == 0 || SnapshotWorld<World>,
                "a late joiner needs snapshot(world, room) and restore(world, bytes)");
  static constexpr std::size_t slice_size = Limits.packet - detail::Packet::slice_room;
  static constexpr std::size_t most_peers_mark = 15;  // no source yet

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
  /// Whether packets are sent to this peer and read from it.
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
  std::optional<World> odd_;  // our result of the differing frame
  typename Timeline::Used odd_inputs_{};
  std::uint32_t odd_frame_ = 0;
  std::uint32_t frame_ = 0;
  std::uint64_t simulated_ = 0;
  detail::Outgoing<Limits.snapshot, slice_size> outgoing_;
  detail::Incoming<Limits.snapshot, slice_size> incoming_;
  std::optional<std::size_t> source_;  // the player from which we request a snapshot
  std::uint64_t progress_ = 0;         // when the last slice arrived
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
