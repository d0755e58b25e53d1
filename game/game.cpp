// SPDX-License-Identifier: MIT
//
// A peer of the match for a page. Each instance of this module is one player. It imports nothing;
// bytes go in and out through `buffer()`. Times are in milliseconds of any clock.
#include <algorithm>
#include <array>
#include <new>
#include <optional>
#include <span>

#include <detent/lockstep/replay.hpp>

#include "players.hpp"
#include "session.hpp"

using namespace slingshot;

namespace {

using Pads = Session::Inputs;
using Replay = detent::ReplayReader<Pad, most_players>;

/// Storage for an object that `start` constructs.
template <class T>
class Place {
 public:
  template <class... Args>
  T& make(const Args&... args) {
    is_made_ = true;
    return *::new (bytes_) T(args...);
  }
  T* get() { return is_made_ ? std::launder(reinterpret_cast<T*>(bytes_)) : nullptr; }

 private:
  alignas(T) std::byte bytes_[sizeof(T)];
  bool is_made_ = false;
};

template <std::size_t Capacity>
struct File {
  std::array<std::byte, Capacity> bytes;
  std::size_t size = 0;

  /// A full recording ends here, like one cut off by a crash.
  void add(std::span<const std::byte> more) {
    if (size + more.size() > Capacity) size = Capacity;
    if (size == Capacity) return;
    std::copy(more.begin(), more.end(), bytes.begin() + static_cast<std::ptrdiff_t>(size));
    size += more.size();
  }
};

constexpr std::size_t history = 256;  // frames whose digests are kept
constexpr std::string_view replay_kind = "slingshot 1";

Place<Session> session_place;
Place<Match> start_place, replay_place;
std::array<std::byte, 1 << 20> exchange;
std::array<std::int32_t, 32 + 12 * room> view_numbers;

// The recording of the final frames.
std::uint32_t seen = 0;
std::uint64_t chain = 0;
std::array<std::uint64_t, history> chains;
constinit detent::ReplayWriter<Pad, most_players> writer;
File<std::size_t{1} << 20> written;

std::optional<detent::SessionEvent> event;
std::optional<std::uint32_t> flip_at;

// The replay being played.
std::array<std::array<Pad, most_players>, 255> block{};
std::size_t block_size = 0, block_next = 0;
std::optional<std::uint64_t> block_digest;
std::optional<Replay> replay;
File<std::size_t{1} << 20> replayed;
std::uint32_t replay_frame = 0;

/// The smallest possible change: one bit of one velocity of one block.
void flip(Match& match) {
  const Piece* victim = nullptr;
  for (const Piece& piece : match.pieces) {
    if (piece.kind == Kind::wood) victim = &piece;
  }
  if (victim == nullptr) return;
  auto velocity = match.bodies.velocity(victim->id);
  velocity.x = S::from_raw(velocity.x.raw() ^ 1);
  match.bodies.set_velocity(victim->id, velocity);
}

void simulate_here(Match& match, const Pads& pads) {
  simulate(match, pads);
  if (flip_at == pads.frame()) flip(match);
}

std::uint64_t micros(double milliseconds) { return static_cast<std::uint64_t>(milliseconds * 1e3); }

std::int32_t write_view(const Match& match) {
  std::int32_t* out = view_numbers.data();
  const auto put = [&](auto... values) { ((*out++ = static_cast<std::int32_t>(values)), ...); };
  put(match.tick, match.round, match.pause, match.wind.raw(), match.players);
  for (std::size_t i = 0; i < match.players; ++i) {
    const auto& [pad, reload] = match.catapults[i];
    put(pad.angle, pad.power, reload);
  }
  for (const Side& side : match.sides) put(side.score, side.is_fallen);
  std::int32_t* count = out++;
  *count = 0;
  for (const Piece& piece : match.pieces) {
    if (piece.kind == Kind::none) continue;
    const auto place = match.bodies.position(piece.id);
    const auto axis = match.bodies.rotation(piece.id).axis(0).vec();
    put(piece.id.index, piece.id.generation, piece.kind, piece.owner, place.x.raw(), place.y.raw(),
        axis.x.raw(), axis.y.raw(), piece.half.x.raw(), piece.half.y.raw(), piece.age,
        match.bodies.is_asleep(piece.id));
    ++*count;
  }
  return static_cast<std::int32_t>(out - view_numbers.data());
}

void write_bytes(std::span<const std::byte> bytes) { written.add(bytes); }

/// Starts recording at the first frame known here, with the seed and, after a late join, the match
/// before that frame.
void begin_recording() {
  const Session& session = *session_place.get();
  static std::array<std::byte, 8 + snapshot_room> first;
  const std::uint64_t seed = session.config().match;
  for (std::size_t i = 0; i < 8; ++i) first[i] = static_cast<std::byte>(seed >> (8 * i));
  seen = session.start_frame();
  chain = session.digest();
  std::size_t size = 8;
  if (seen > 0) size += snapshot(session.world(), std::span(first).subspan(8));
  written.size = 0;
  writer.begin({.kind = replay_kind,
                .players = session.config().players,
                .snapshot = std::span(first).first((std::min)(size, first.size()))},
               write_bytes);
}

void record_final_frames() {
  Session& session = *session_place.get();
  for (; seen < session.final_frame(); ++seen) {
    const Match* match = session.result(seen);
    const auto pads = session.inputs(seen);
    if (match == nullptr || !pads) return;
    detent::Digest digest(chain);
    digest.add(detent::detail::WorldDigest(*match).all());
    chain = chains[seen % history] = digest.value();
    writer.add(*pads, *match, write_bytes);
  }
}

}  // namespace

#define EXPORT(name) extern "C" __attribute__((export_name(#name)))

EXPORT(buffer) std::byte* buffer() { return exchange.data(); }
EXPORT(buffer_size) std::size_t buffer_size() { return exchange.size(); }
EXPORT(view_at) std::int32_t* view_at() { return view_numbers.data(); }

/// Begins a match of two or four players. All peers pass the same seed. Spectators are numbered
/// after the players. A peer that joins late or rejoins passes a `life`, greater each time.
EXPORT(start)
void start(std::uint64_t seed, std::size_t self, std::uint32_t delay, std::size_t players,
           std::uint32_t life) {
  const Match& match = start_place.make(seed, players);
  begin(session_place.make(detent::SessionConfig{.match = seed,
                                                 .self = self,
                                                 .players = match.players,
                                                 .spectators = most_spectators,
                                                 .delay = delay,
                                                 .life = life},
                           match));
  flip_at.reset();
  event.reset();
  begin_recording();
}

/// Takes another player's packet from the buffer. Returns 0 if it was good: see detent::Received.
EXPORT(receive) int receive(std::size_t from, std::size_t size, double now) {
  const std::span<const std::byte> packet(exchange.data(), (std::min)(size, exchange.size()));
  const auto received = session_place.get()->receive(from, packet, micros(now));
  if (seen < session_place.get()->start_frame()) begin_recording();  // the match so far has arrived
  return static_cast<int>(received);
}
/// Whether this peer plays, rather than only watches.
EXPORT(is_player) int is_player() { return session_place.get()->is_player() ? 1 : 0; }
/// The first frame known here; 0 unless it joined late.
EXPORT(start_frame) std::uint32_t start_frame() { return session_place.get()->start_frame(); }
/// Whether the match waits for this player.
EXPORT(is_awaited) int is_awaited(std::size_t player) {
  return session_place.get()->is_awaited(player) ? 1 : 0;
}
/// Continues without a player who has left.
EXPORT(drop) void drop(std::size_t player) { session_place.get()->drop(player); }
/// Plays a frame. Returns 0 if the keys were used: see detent::Advanced.
EXPORT(advance) int advance(int angle, int power, int fire) {
  const Pad pad{static_cast<std::int16_t>(angle), static_cast<std::uint8_t>(power), fire != 0};
  const auto result = session_place.get()->advance(pad, simulate_here);
  record_final_frames();
  return static_cast<int>(result);
}
/// Writes the packets due to the buffer: recipient (1 byte), size (2), packet. Returns the total
/// size.
EXPORT(poll) std::size_t poll(double now) {
  std::size_t size = 0;
  const auto put = [&](std::size_t byte) { exchange[size++] = static_cast<std::byte>(byte); };
  session_place.get()->poll(micros(now), [&](std::size_t to, std::span<const std::byte> bytes) {
    put(to);
    put(bytes.size() & 255);
    put(bytes.size() >> 8);
    for (const std::byte byte : bytes) exchange[size++] = byte;
  });
  return size;
}
EXPORT(set_paused) void set_paused(int is_paused) { session_place.get()->pause(is_paused != 0); }

EXPORT(frame) std::uint32_t frame() { return session_place.get()->frame(); }
EXPORT(final_frame) std::uint32_t final_frame() { return seen; }
/// The number of frames known to be equal at all remaining players.
EXPORT(matched_frame) std::uint32_t matched_frame() {
  const Session& session = *session_place.get();
  std::uint32_t matched = seen;
  for (std::size_t i = 0; i < session.config().players; ++i) {
    if (i == session.config().self || session.is_dropped(i)) continue;
    matched = (std::min)(matched, session.matched_frame(i));
  }
  return matched;
}
EXPORT(resimulated) double resimulated() {
  return static_cast<double>(session_place.get()->resimulated());
}
/// The digest of all frames up to this one, which must be final and among the last 256; otherwise
/// 0.
EXPORT(digest) std::uint64_t digest(std::uint32_t frame) {
  return frame < seen && seen - frame <= history ? chains[frame % history] : 0;
}

/// The kind of the next event, or -1. Its field is in the buffer, as zero-terminated text.
EXPORT(next_event) int next_event() {
  event = session_place.get()->next_event();
  if (!event) return -1;
  const auto text = event->field.view();
  std::transform(text.begin(), text.end(), exchange.begin(),
                 [](char letter) { return static_cast<std::byte>(letter); });
  exchange[text.size()] = std::byte{0};
  return static_cast<int>(event->kind);
}
EXPORT(event_frame) std::uint32_t event_frame() { return event ? event->frame : 0; }
EXPORT(event_object) int event_object() {
  return event && event->object ? static_cast<int>(event->object->index) : -1;
}
/// Flips a bit after the next frame.
EXPORT(flip_a_bit) void flip_a_bit() { flip_at = session_place.get()->frame(); }

/// The number of values of the match at `view_at()`.
EXPORT(view) std::int32_t view() { return write_view(session_place.get()->world()); }
/// A simulated player's input: angle * 65536 + power * 256 + fire.
EXPORT(simulated) int simulated(std::uint64_t seed, std::size_t player, std::uint32_t frame) {
  const Pad pad = simulated_pad(seed, player, frame);
  return pad.angle * 65536 + pad.power * 256 + (pad.fire ? 1 : 0);
}

/// Writes the recording of this match to the buffer as a file. Returns its size.
EXPORT(save_replay) std::size_t save_replay() {
  static File<exchange.size()> file;
  file = {};
  file.add(std::span(written.bytes).first(written.size));
  auto rest = writer;
  const Match* last = seen == 0 ? nullptr : session_place.get()->result(seen - 1);
  if (last != nullptr) {
    rest.end(*last, [&](std::span<const std::byte> bytes) { file.add(bytes); });
  }
  std::copy(file.bytes.begin(), file.bytes.begin() + static_cast<std::ptrdiff_t>(file.size),
            exchange.begin());
  return file.size;
}
/// Takes a file from the buffer. Returns 0 if it is a replay of this game: see detent::ReplayState.
EXPORT(load_replay) int load_replay(std::size_t size) {
  replayed.size = 0;
  replayed.add(std::span<const std::byte>(exchange).first((std::min)(size, exchange.size())));
  replay.emplace(std::span<const std::byte>(replayed.bytes).first(replayed.size));
  block_size = block_next = 0;
  replay_frame = 0;
  const auto snapshot = replay->snapshot();
  if (replay->state() != detent::ReplayState::whole) return static_cast<int>(replay->state());
  if (!replay->is_kind(replay_kind) || snapshot.size() < 8 ||
      (replay->players() != 2 && replay->players() != most_players)) {
    return static_cast<int>(detent::ReplayState::no_replay);
  }
  std::uint64_t seed = 0;
  for (std::size_t i = 8; i-- > 0;) seed = seed << 8 | std::to_integer<std::uint64_t>(snapshot[i]);
  Match& match = replay_place.make(seed, replay->players());
  const bool is_match = snapshot.size() == 8 || restore(match, snapshot.subspan(8));
  return is_match ? 0 : static_cast<int>(detent::ReplayState::no_replay);
}
/// Plays one frame of the replay. Returns 0 on success, 1 at the end, 2 if a digest differs.
EXPORT(replay_step) int replay_step() {
  if (!replay || replay_place.get() == nullptr) return 1;
  if (block_next == block_size) {
    block_size = block_next = 0;
    block_digest = replay->next_block([](const Pads& pads) {
      if (block_size < block.size()) block[block_size++] = {pads[0], pads[1], pads[2], pads[3]};
    });
    if (!block_digest || block_size == 0) return 1;
  }
  Match& match = *replay_place.get();
  step(match, block[block_next++]);
  ++replay_frame;
  if (block_next < block_size) return 0;
  return detent::detail::WorldDigest(match).all() == *block_digest ? 0 : 2;
}
EXPORT(replay_frame) std::uint32_t replay_frame_number() { return replay_frame; }
/// How the file ended, once it is fully played: see detent::ReplayState.
EXPORT(replay_state) int replay_state() { return replay ? static_cast<int>(replay->state()) : -1; }
EXPORT(replay_view) std::int32_t replay_view() { return write_view(*replay_place.get()); }
