// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <new>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "c/worlds.hpp"
#include "detent/lockstep/lockstep.hpp"
#include "detent/lockstep/replay.hpp"
#include "detent/scene/difference.hpp"

// Sessions and replays of the worlds of C. Simulation is not a callback: a frame is opened, the
// caller changes the world through its handle, and the frame is closed.
namespace detent::c {

/// The state that a rollback restores: a world and the words next to it.
template <int N>
struct Game {
  typename Worlds<N>::World world;
  Words words;
  const Context* table = nullptr;  // has the assets of snapshots
};
template <int N, class F>
void for_each_field(const Game<N>& game, const F& f) {
  f("", game.world);
  f("word", game.words.span());
}
/// The words, 4 bytes each, and the snapshot of the world.
template <int N>
std::size_t snapshot(const Game<N>& game, std::span<std::byte> room) {
  const auto head = game.words.count * sizeof(std::uint32_t);
  const bool is_large = room.size() >= head;
  for (std::size_t i = 0; is_large && i < game.words.count; ++i) {
    detent::detail::store_word(room.data() + 4 * i, game.words.values[i]);
  }
  return head + detent::snapshot(game.world, is_large ? room.subspan(head) : room.first(0));
}
template <int N>
Restored restore(Game<N>& game, std::span<const std::byte> bytes) {
  const auto head = game.words.count * sizeof(std::uint32_t);
  if (bytes.size() < head) return Restored::truncated;
  const auto restored = restore_with<N>(*game.table, game.world, bytes.subspan(head));
  for (std::size_t i = 0; restored == Restored::yes && i < game.words.count; ++i) {
    game.words.values[i] = detent::detail::load_word<std::uint32_t>(bytes.data() + 4 * i);
  }
  return restored;
}

/// A player's input: the first bytes are the caller's, the others 0.
struct Press {
  std::array<std::uint8_t, DETENT_INPUT> bytes{};
};

/// The common part of sessions and replays of a dimension.
template <int N>
struct Play {
  using Inputs = FrameInputs<Press, DETENT_PLAYERS>;

  static void write(const Inputs& from, std::uint32_t input_size, detent_frame* frame, void* to) {
    *frame = {from.frame(), static_cast<std::uint32_t>(from.size()), 0, DETENT_PLAYED};
    auto* const bytes = static_cast<std::uint8_t*>(to);
    for (std::uint32_t i = 0; i < frame->players; ++i) {
      if (from.is_in(i)) frame->present |= 1u << i;
      std::copy_n(from[i].bytes.begin(), input_size, bytes + i * input_size);
    }
  }

  /// The kind of replay: only a world with these inputs and words can simulate it.
  static FieldName kind_of(std::uint32_t input_size, std::uint32_t words) {
    return FieldName("detent.h ")
        .add_number(N)
        .add(" ")
        .add_number(input_size)
        .add(" ")
        .add_number(words);
  }
};

/// Handles of sessions or replays, which are `Holder`s, and of their worlds.
template <int N, class Holder>
struct Played {
  using World = typename Worlds<N>::World;
  static constexpr Kind world_kind = Worlds<N>::kind;

  /// Makes a `Holder` from the arguments, and a handle for its world.
  template <class... Arguments>
  static detent_status make(Context& table, detent_handle* out, Arguments&... arguments) {
    detent_status status = DETENT_OK;
    Slot* slot = table.reserve(Holder::kind, status);
    if (slot == nullptr) return status;
    const auto handle = slot->handle;
    slot = table.reserve(world_kind, status);
    if (slot == nullptr) {
      table.give_back(*table.find(Holder::kind, handle));
      return status;
    }
    const auto world = slot->handle;
    void* const memory = table.allocate(sizeof(Holder));
    if (memory == nullptr) status = DETENT_NO_MEMORY;
    if (status == DETENT_OK) {
      status = guarded(nullptr, [&]() -> detent_status {
        auto* const holder = new (memory) Holder(arguments...);
        holder->world = world;
        return DETENT_OK;
      });
    }
    if (status != DETENT_OK) {
      table.release(memory, sizeof(Holder));
      table.give_back(*table.find(world_kind, world));
      table.give_back(*table.find(Holder::kind, handle));
      return status;
    }
    slot = table.find(world_kind, world);
    slot->is_owned = true;
    slot->destroy = [](Context&, void*) {};
    slot = table.find(Holder::kind, handle);
    slot->object = memory;
    slot->refers_to = [](const void* object, const void* asset) {
      // Worlds of earlier frames may refer to any asset.
      const auto& game = static_cast<const Holder*>(object)->current();
      return bodies_can_have<N>(*game.table, asset);
    };
    slot->destroy = [](Context& context, void* object) {
      auto* const holder = static_cast<Holder*>(object);
      Slot* const of_world = context.find(world_kind, holder->world);
      if (of_world != nullptr) context.give_back(*of_world);
      holder->~Holder();
      context.release(object, sizeof(Holder));
    };
    show(table, *static_cast<Holder*>(memory));
    *out = handle;
    return DETENT_OK;
  }

  /// Points the handle of the world to the current one.
  static void show(Context& table, Holder& holder) {
    Slot* const slot = table.find(world_kind, holder.world);
    if (slot == nullptr) return;
    auto& game = const_cast<Game<N>&>(holder.current());
    slot->object = &game.world;
    slot->words = &game.words;
    slot->is_locked = !holder.is_open();
  }
  /// f(table, holder) for a call that may change it.
  template <class F>
  static detent_status change(detent_context* context, detent_handle handle, const F& f) {
    return with_object<Holder>(context, Holder::kind, handle,
                               [&](Context& table, Holder& holder) -> detent_status {
                                 const Slot* const slot = table.find(world_kind, holder.world);
                                 if (slot == nullptr || slot->is_broken) return DETENT_BROKEN;
                                 const detent_status status = f(holder);
                                 show(table, holder);
                                 return status;
                               });
  }
  template <class F>
  static detent_status read(const detent_context* context, detent_handle handle, const F& f) {
    return read_object<Holder>(context, Holder::kind, handle,
                               [&](const Context&, const Holder& holder) { return f(holder); });
  }
  static detent_status destroy(detent_context* context, detent_handle handle) {
    return destroy_object(context, Holder::kind, handle);
  }
  static detent_status world(const detent_context* context, detent_handle handle,
                             detent_handle* world) {
    return write_from<Holder>(context, Holder::kind, handle, world,
                              [](const Holder& holder) { return holder.world; });
  }
};

template <int N>
struct Recorder {
  using Inputs = typename Play<N>::Inputs;
  static constexpr SessionLimits limits{.snapshot = DETENT_LATE_SNAPSHOT};
  using Session = detent::Session<Game<N>, Press, limits>;

  void begin(const Session& session, const detent_session_settings& settings) {
    if (settings.replay_every == 0 || settings.life != 0) return;
    writer.emplace(settings.replay_every);
    std::vector<std::byte> start(snapshot(session.world(), std::span<std::byte>()));
    snapshot(session.world(), std::span(start));
    const auto kind = Play<N>::kind_of(settings.input_size, settings.words);
    writer->begin({.kind = kind.view(), .players = settings.players, .snapshot = start}, sink());
  }
  void add(const Session& session) {
    if (!writer) return;
    for (; frames < session.final_frame(); ++frames) {
      const auto inputs = session.inputs(frames);
      const auto* const result = session.result(frames);
      if (!inputs || result == nullptr) return;
      writer->add(*inputs, *result, sink());
    }
  }
  /// The whole replay so far, without ending the current block.
  [[nodiscard]] std::vector<std::byte> bytes(const Session& session) const {
    Recorder copy = *this;
    const auto* const last = frames == 0 ? nullptr : session.result(frames - 1);
    if (copy.writer && last != nullptr) copy.writer->end(*last, copy.sink());
    return std::move(copy.file);
  }
  auto sink() {
    return [this](std::span<const std::byte> more) {
      file.insert(file.end(), more.begin(), more.end());
    };
  }

  std::optional<ReplayWriter<Press, DETENT_PLAYERS>> writer;
  std::vector<std::byte> file;
  std::uint32_t frames = 0;
};

/// A session, the packets of the last poll, and its replay.
template <int N>
struct SessionHolder {
  using Session = typename Recorder<N>::Session;
  static constexpr Kind kind = N == 2 ? Kind::session2 : Kind::session3;
  struct Sent {
    std::uint32_t peer = 0, size = 0;
    std::array<std::byte, DETENT_PACKET> bytes;
  };

  SessionHolder(const detent_session_settings& given, const Game<N>& start)
      : settings(given), session(config_of(given), start) {
    recorder.begin(session, given);
  }
  static SessionConfig config_of(const detent_session_settings& given) {
    return {.match = given.match,
            .self = given.self,
            .players = given.players,
            .spectators = given.spectators,
            .delay = given.delay,
            .prediction = given.prediction,
            .send_interval = given.send_interval,
            .silence = given.silence,
            .frames_per_call = given.frames_per_call,
            .absent = given.absent,
            .life = given.life,
            .wants_seat = given.wants_seat != 0};
  }
  [[nodiscard]] bool is_open() const { return session.is_open(); }
  [[nodiscard]] const Game<N>& current() const {
    return is_open() ? const_cast<SessionHolder*>(this)->session.opened() : session.world();
  }

  detent_session_settings settings;
  Session session;
  Recorder<N> recorder;
  std::array<Sent, Recorder<N>::limits.peers> sent{};
  std::uint32_t sent_count = 0, next_sent = 0;
  bool is_polled = false;
  detent_handle world = 0;
};

template <int N>
struct Sessions : Played<N, SessionHolder<N>> {
  using Holder = SessionHolder<N>;
  using P = Played<N, Holder>;
  using P::change;
  using P::read;

  static detent_status create(detent_context* context, const detent_session_settings* settings,
                              detent_handle world, detent_handle* session) {
    Context* const table = table_of(context);
    if (table == nullptr) return DETENT_BAD_CONTEXT;
    if (settings == nullptr || session == nullptr || !is_valid(*settings)) {
      return DETENT_BAD_ARGUMENT;
    }
    *session = 0;
    const auto copy = [&](const Context&, const typename P::World& start) {
      Game<N> game{start, {}, table};
      game.words.count = settings->words;
      return P::make(*table, session, *settings, game);
    };
    return read_object<typename P::World>(context, P::world_kind, world, copy);
  }

  static detent_status receive(detent_context* context, detent_handle session, std::uint32_t peer,
                               const void* bytes, std::uint32_t size, std::uint64_t now) {
    return change(context, session, [&](Holder& holder) -> detent_status {
      if (bytes == nullptr && size != 0) return DETENT_BAD_ARGUMENT;
      const std::span from(static_cast<const std::byte*>(bytes), size);
      return yes_or_no(holder.session.receive(peer, from, now) == Received::yes);
    });
  }
  static detent_status begin_frame(detent_context* context, detent_handle session,
                                   const void* input, detent_frame* frame, void* inputs) {
    return change(context, session, [&](Holder& holder) -> detent_status {
      if (input == nullptr || frame == nullptr || inputs == nullptr) return DETENT_BAD_ARGUMENT;
      Press press;
      std::copy_n(static_cast<const std::uint8_t*>(input), holder.settings.input_size,
                  press.bytes.begin());
      const auto opened = holder.session.open_frame(press);
      if (opened) {
        Play<N>::write(*opened, holder.settings.input_size, frame, inputs);
      } else {
        *frame = {holder.session.frame(), holder.settings.players, 0,
                  static_cast<std::uint32_t>(holder.session.advanced())};
      }
      return yes_or_no(opened.has_value());
    });
  }
  static detent_status end_frame(detent_context* context, detent_handle session) {
    return change(context, session, [&](Holder& holder) -> detent_status {
      if (!holder.is_open()) return DETENT_NOT_NOW;
      holder.session.close_frame();
      holder.recorder.add(holder.session);
      return DETENT_OK;
    });
  }
  static detent_status packet(detent_context* context, detent_handle session, std::uint64_t now,
                              std::uint32_t* peer, void* bytes, std::uint32_t room,
                              std::uint32_t* size) {
    return change(context, session, [&](Holder& holder) -> detent_status {
      if (peer == nullptr || bytes == nullptr || size == nullptr || room < DETENT_PACKET) {
        return DETENT_BAD_ARGUMENT;
      }
      if (!holder.is_polled) {
        holder.sent_count = holder.next_sent = 0;
        holder.session.poll(now, [&](std::size_t to, std::span<const std::byte> packet) {
          auto& sent = holder.sent[holder.sent_count++];
          sent.peer = static_cast<std::uint32_t>(to);
          sent.size = static_cast<std::uint32_t>(packet.size());
          std::copy(packet.begin(), packet.end(), sent.bytes.begin());
        });
      }
      holder.is_polled = holder.next_sent < holder.sent_count;
      if (!holder.is_polled) return DETENT_NO;
      const auto& sent = holder.sent[holder.next_sent++];
      *peer = sent.peer;
      *size = sent.size;
      std::copy_n(sent.bytes.begin(), sent.size, static_cast<std::byte*>(bytes));
      return DETENT_OK;
    });
  }
  static detent_status event(detent_context* context, detent_handle session,
                             detent_session_event* event, void* name, std::uint32_t room) {
    return change(context, session, [&](Holder& holder) -> detent_status {
      if (event == nullptr || (name == nullptr && room != 0)) return DETENT_BAD_ARGUMENT;
      const auto happened = holder.session.next_event();
      if (!happened) return DETENT_NO;
      const auto text = happened->field.view();
      *event = {static_cast<std::uint32_t>(happened->kind),
                static_cast<std::uint32_t>(happened->peer),
                happened->frame,
                static_cast<std::uint32_t>(text.size()),
                happened->object ? 1u : 0u,
                happened->object ? id_of(*happened->object) : detent_id{}};
      std::copy_n(text.begin(), (std::min<std::size_t>)(room, text.size()),
                  static_cast<char*>(name));
      return DETENT_OK;
    });
  }

  static detent_status status(const detent_context* context, detent_handle session,
                              detent_session_status* status) {
    return read(context, session, [&](const Holder& holder) -> detent_status {
      if (status == nullptr) return DETENT_BAD_ARGUMENT;
      const auto& own = holder.session;
      *status = {own.digest(),        own.resimulated(), own.frame(),     own.final_frame(),
                 own.checked_frame(), own.start_frame(), own.is_player(), holder.settings.players};
      return DETENT_OK;
    });
  }
  static detent_status matched(const detent_context* context, detent_handle session,
                               std::uint32_t peer, std::uint32_t* frame) {
    return read(context, session, [&](const Holder& holder) -> detent_status {
      if (frame == nullptr || !is_peer(holder, peer)) return DETENT_BAD_ARGUMENT;
      *frame = holder.session.matched_frame(peer);
      return DETENT_OK;
    });
  }
  static detent_status is_awaited(const detent_context* context, detent_handle session,
                                  std::uint32_t player) {
    return read(context, session, [&](const Holder& holder) -> detent_status {
      return yes_or_no(holder.session.is_awaited(player));
    });
  }
  static detent_status drop(detent_context* context, detent_handle session, std::uint32_t peer) {
    return change(context, session, [&](Holder& holder) -> detent_status {
      if (!is_peer(holder, peer)) return DETENT_BAD_ARGUMENT;
      holder.session.drop(peer);
      return DETENT_OK;
    });
  }
  static detent_status pause(detent_context* context, detent_handle session,
                             std::uint32_t is_paused) {
    return change(context, session, [&](Holder& holder) -> detent_status {
      if (is_paused > 1) return DETENT_BAD_ARGUMENT;
      holder.session.pause(is_paused != 0);
      return DETENT_OK;
    });
  }
  static detent_status replay(const detent_context* context, detent_handle session, void* bytes,
                              std::uint32_t room, std::uint32_t* size) {
    return read(context, session, [&](const Holder& holder) -> detent_status {
      if (size == nullptr || (bytes == nullptr && room != 0)) return DETENT_BAD_ARGUMENT;
      const auto file = holder.recorder.bytes(holder.session);
      *size = static_cast<std::uint32_t>(file.size());
      if (file.size() > room || file.empty()) return DETENT_NO;
      std::copy(file.begin(), file.end(), static_cast<std::byte*>(bytes));
      return DETENT_OK;
    });
  }

 private:
  static bool is_valid(const detent_session_settings& given) {
    return given.players >= 1 && given.players <= DETENT_PLAYERS && given.spectators <= 15 &&
           given.players + given.spectators <= 16 &&
           given.self < given.players + given.spectators && given.delay <= 8 &&
           given.prediction <= 16 && (given.prediction != 0 || given.delay != 0) &&
           given.frames_per_call >= 1 && given.absent >> given.players == 0 &&
           given.wants_seat <= 1 && given.input_size >= 1 && given.input_size <= DETENT_INPUT &&
           given.words <= DETENT_WORDS && given.replay_every <= 255;
  }
  static bool is_peer(const Holder& holder, std::uint32_t peer) {
    return peer < holder.settings.players + holder.settings.spectators;
  }
};

/// A replay and the world that simulates it.
template <int N>
struct ReplayHolder {
  using Inputs = typename Play<N>::Inputs;
  using Reader = ReplayReader<Press, DETENT_PLAYERS>;
  static constexpr Kind kind = N == 2 ? Kind::replay2 : Kind::replay3;

  ReplayHolder(const Game<N>& start, std::span<const std::byte> given, std::uint32_t size)
      : game(start), bytes(given.begin(), given.end()), reader(bytes), input_size(size) {}
  [[nodiscard]] bool is_open() const { return is_simulating; }
  [[nodiscard]] const Game<N>& current() const { return game; }

  Game<N> game;
  std::vector<std::byte> bytes;
  Reader reader;
  ReplayCheck check;
  std::vector<Inputs> block;  // the frames up to the next digest
  std::size_t next = 0;
  std::uint64_t digest = 0;
  std::uint32_t input_size;
  bool is_simulating = false, is_over = false;
  detent_handle world = 0;
};

template <int N>
struct Replays : Played<N, ReplayHolder<N>> {
  using Holder = ReplayHolder<N>;
  using P = Played<N, Holder>;

  static detent_status create(detent_context* context, const void* bytes, std::uint32_t size,
                              detent_handle world, std::uint32_t input_size, std::uint32_t words,
                              detent_handle* replay) {
    Context* const table = table_of(context);
    if (table == nullptr) return DETENT_BAD_CONTEXT;
    if ((bytes == nullptr && size != 0) || replay == nullptr || input_size == 0 ||
        input_size > DETENT_INPUT || words > DETENT_WORDS) {
      return DETENT_BAD_ARGUMENT;
    }
    *replay = 0;
    const std::span from(static_cast<const std::byte*>(bytes), size);
    const auto copy = [&](const Context&, const typename P::World& start) -> detent_status {
      const typename Holder::Reader reader(from);
      switch (reader.state()) {
        case ReplayState::whole:
          break;
        case ReplayState::other_results:
          return DETENT_OTHER_VERSION;
        case ReplayState::other_inputs:
          return DETENT_OTHER_SCENE;
        default:
          return DETENT_NO_SNAPSHOT;
      }
      if (!reader.is_kind(Play<N>::kind_of(input_size, words).view())) return DETENT_OTHER_SCENE;
      Game<N> game{start, {}, table};
      game.words.count = words;
      const auto restored = restore(game, reader.snapshot());
      if (restored != Restored::yes) return status_of(restored);
      return P::make(*table, replay, game, from, input_size);
    };
    return read_object<typename P::World>(context, P::world_kind, world, copy);
  }

  static detent_status begin_frame(detent_context* context, detent_handle replay,
                                   detent_frame* frame, void* inputs) {
    return P::change(context, replay, [&](Holder& holder) -> detent_status {
      if (frame == nullptr || inputs == nullptr) return DETENT_BAD_ARGUMENT;
      while (!holder.is_over && holder.next == holder.block.size()) {
        holder.block.clear();
        holder.next = 0;
        const auto digest = holder.reader.next_block(
            [&](const typename Holder::Inputs& one) { holder.block.push_back(one); });
        if (!digest) holder.block.clear();
        holder.is_over = !digest;
        holder.digest = digest.value_or(0);
        if (digest && holder.block.empty()) compare(holder);
      }
      if (holder.is_over) {
        const auto players = static_cast<std::uint32_t>(holder.reader.players());
        *frame = {holder.check.frames, players, 0, DETENT_OVER};
        return DETENT_NO;
      }
      Play<N>::write(holder.block[holder.next], holder.input_size, frame, inputs);
      holder.is_simulating = true;
      return DETENT_OK;
    });
  }
  static detent_status end_frame(detent_context* context, detent_handle replay) {
    return P::change(context, replay, [&](Holder& holder) -> detent_status {
      if (!holder.is_simulating) return DETENT_NOT_NOW;
      holder.is_simulating = false;
      ++holder.check.frames;
      if (++holder.next == holder.block.size()) compare(holder);
      return DETENT_OK;
    });
  }
  static detent_status check(const detent_context* context, detent_handle replay,
                             detent_replay_check* check) {
    return P::read(context, replay, [&](const Holder& holder) -> detent_status {
      if (check == nullptr) return DETENT_BAD_ARGUMENT;
      *check = {static_cast<std::uint32_t>(holder.reader.state()), holder.check.frames,
                holder.check.equal, holder.check.is_equal ? 1u : 0u,
                static_cast<std::uint32_t>(holder.reader.players())};
      return DETENT_OK;
    });
  }

 private:
  static void compare(Holder& holder) {
    auto& check = holder.check;
    check.is_equal = detent::detail::WorldDigest(holder.game).all() == holder.digest;
    if (check.is_equal) {
      check.equal = check.frames;
    } else {
      holder.is_over = true;
    }
  }
};

/// The fields in which two worlds or scenes differ, one line each.
template <int N>
struct Differences {
  static detent_status of_worlds(const detent_context* context, detent_handle a, detent_handle b,
                                 std::uint32_t most, void* names, std::uint32_t room,
                                 std::uint32_t* size) {
    return of<typename Worlds<N>::World>(Worlds<N>::kind, context, a, b, most, names, room, size);
  }
  static detent_status of_scenes(const detent_context* context, detent_handle a, detent_handle b,
                                 std::uint32_t most, void* names, std::uint32_t room,
                                 std::uint32_t* size) {
    return of<typename SceneOf<N>::type>(SceneOf<N>::kind, context, a, b, most, names, room, size);
  }

 private:
  template <class T>
  static detent_status of(Kind kind, const detent_context* context, detent_handle a,
                          detent_handle b, std::uint32_t most, void* names, std::uint32_t room,
                          std::uint32_t* size) {
    const auto compare = [&](const T& one, const T& other) -> detent_status {
      if (size == nullptr || (names == nullptr && room != 0)) return DETENT_BAD_ARGUMENT;
      std::uint32_t written = 0;
      const auto put = [&](char c) {
        if (written < room) static_cast<char*>(names)[written] = c;
        ++written;
      };
      const auto count = detent::diff(
          one, other,
          [&](const FieldDifference& difference) {
            for (const char c : difference.field.view()) put(c);
            put('\n');
          },
          most);
      *size = written;
      return yes_or_no(count != 0);
    };
    return read_object<T>(context, kind, a, [&](const Context&, const T& one) {
      return read_object<T>(context, kind, b,
                            [&](const Context&, const T& other) { return compare(one, other); });
    });
  }
};

}  // namespace detent::c
