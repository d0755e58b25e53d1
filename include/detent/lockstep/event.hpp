// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

#include "detent/scene/field_name.hpp"
#include "detent/scene/object.hpp"

namespace detent {

/// An event of a session. `peer` is the peer it concerns.
struct SessionEvent {
  /// The kind of event.
  enum class Kind : std::uint8_t {
    connected,      // the first packet of this peer arrived
    silent,         // nothing arrived from it for `silence`; the caller may `drop` it
    heard_again,    // it is no longer silent
    paused,         // it paused
    resumed,        // it resumed
    dropped,        // this player is out, as decided by one of the remaining peers
    expelled,       // it dropped us: we continue alone
    left,           // all remaining peers agree: `frame` is the first without this player's input
    too_slow,       // a spectator fell behind by more than is stored; it gets nothing more
    contradiction,  // it sent a second, different input for `frame`; the first one stays
    desync,         // its result of `frame` differs from ours; all before were equal
    desync_field,   // the first field that differs in that result: `field`, `object`
    arrived,        // it joins late or rejoins, and gets a snapshot
    loaded,         // we joined late and have the world before `frame`, from this peer
    no_snapshot,    // this peer's snapshot is not one of our world: we ask another peer
    joined,         // this player takes part from `frame` on
  };

  Kind kind{};
  std::size_t peer = 0;
  std::uint32_t frame = 0;
  FieldName field;
  std::optional<ObjectId> object;  // the scene object that the field belongs to, if any
};

/// The kind of an event as text.
[[nodiscard]] constexpr std::string_view describe(SessionEvent::Kind kind) noexcept {
  switch (kind) {
    case SessionEvent::Kind::connected:
      return "connected";
    case SessionEvent::Kind::silent:
      return "silent";
    case SessionEvent::Kind::heard_again:
      return "heard again";
    case SessionEvent::Kind::paused:
      return "paused";
    case SessionEvent::Kind::resumed:
      return "resumed";
    case SessionEvent::Kind::dropped:
      return "dropped";
    case SessionEvent::Kind::expelled:
      return "dropped this player";
    case SessionEvent::Kind::left:
      return "left";
    case SessionEvent::Kind::too_slow:
      return "too slow";
    case SessionEvent::Kind::contradiction:
      return "sent a second, different input";
    case SessionEvent::Kind::desync:
      return "has another result";
    case SessionEvent::Kind::desync_field:
      return "has another value in a field";
    case SessionEvent::Kind::arrived:
      return "comes late";
    case SessionEvent::Kind::loaded:
      return "sent the match so far";
    case SessionEvent::Kind::no_snapshot:
      return "sent no snapshot of this world";
    case SessionEvent::Kind::joined:
      return "joined";
  }
  return "";
}

namespace detail {

/// Events that the caller has not taken yet. When full, further ones are counted but not stored.
template <std::size_t Capacity>
class EventQueue {
 public:
  constexpr void push(const SessionEvent& event) noexcept {
    if (end_ - begin_ == Capacity) {
      ++lost_;
    } else {
      events_[end_++ % Capacity] = event;
    }
  }
  [[nodiscard]] constexpr std::optional<SessionEvent> pop() noexcept {
    if (begin_ == end_) return std::nullopt;
    return events_[begin_++ % Capacity];
  }
  [[nodiscard]] constexpr std::size_t lost() const noexcept { return lost_; }

 private:
  std::array<SessionEvent, Capacity> events_{};
  std::size_t begin_ = 0, end_ = 0;
  std::size_t lost_ = 0;
};

}  // namespace detail

}  // namespace detent
