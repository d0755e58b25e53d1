// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <type_traits>

#include <detent/dynamics/snapshot.hpp>

#include "rules.hpp"

// A match as bytes, for late joiners: the fields of `Match` except its bodies, each piece with the
// pose of the rocks among them, then the snapshot of the bodies, which omits rocks. Numbers are
// little-endian.

namespace slingshot {

inline constexpr std::size_t snapshot_room = 16'384;  // bytes; tests use at most half of it

namespace detail {

template <class T>
using Word = std::make_unsigned_t<T>;

/// Counts numbers, and writes those that fit.
class Out {
 public:
  explicit constexpr Out(std::span<std::byte> room) : room_(room) {}

  template <class... T>
  constexpr void operator()(const T&... values) {
    (put(values), ...);
  }
  [[nodiscard]] constexpr std::size_t size() const { return size_; }

 private:
  template <class T>
  constexpr void put(const T& value) {
    if constexpr (std::is_same_v<T, S>) {
      put(value.raw());
    } else if constexpr (std::is_same_v<T, bool>) {
      put(static_cast<std::uint8_t>(value ? 1 : 0));
    } else if constexpr (std::is_enum_v<T>) {
      put(static_cast<std::uint8_t>(value));
    } else {
      for (std::size_t i = 0; i < sizeof(T); ++i) {
        const auto byte = static_cast<std::uint64_t>(static_cast<Word<T>>(value)) >> (8 * i);
        if (size_ < room_.size()) room_[size_] = static_cast<std::byte>(byte & 255u);
        ++size_;
      }
    }
  }

  std::span<std::byte> room_;
  std::size_t size_ = 0;
};

/// Reads numbers; any bytes are safe.
class In {
 public:
  explicit constexpr In(std::span<const std::byte> bytes) : rest_(bytes) {}

  template <class... T>
  constexpr void operator()(T&... values) {
    (get(values), ...);
  }
  constexpr void refuse() { is_right_ = false; }
  [[nodiscard]] constexpr bool is_right() const { return is_right_; }
  [[nodiscard]] constexpr std::span<const std::byte> rest() const { return rest_; }

 private:
  template <class T>
  constexpr void get(T& value) {
    if constexpr (std::is_same_v<T, S>) {
      std::int32_t raw = 0;
      get(raw);
      value = S::from_raw(raw == INT32_MIN ? 0 : raw);  // not a valid number
      if (raw == INT32_MIN) refuse();
    } else if constexpr (std::is_same_v<T, bool> || std::is_enum_v<T>) {
      std::uint8_t byte = 0;
      get(byte);
      if (byte > (std::is_enum_v<T> ? static_cast<int>(Kind::ball) : 1)) byte = 0, refuse();
      value = static_cast<T>(byte);
    } else {
      std::uint64_t word = 0;
      if (rest_.size() < sizeof(T)) return refuse();
      for (std::size_t i = sizeof(T); i-- > 0;) {
        word = word << 8 | std::to_integer<std::uint64_t>(rest_[i]);
      }
      value = static_cast<T>(static_cast<Word<T>>(word));
      rest_ = rest_.subspan(sizeof(T));
    }
  }

  std::span<const std::byte> rest_;
  bool is_right_ = true;
};

/// Calls io(numbers...) for all fields of a match except its pieces and bodies.
template <class Io, class M>
constexpr void visit_numbers(Io& io, M& match) {
  io(match.random, match.tick, match.round, match.pause, match.hill, match.wind);
  for (auto& [pad, reload] : match.catapults) io(pad.angle, pad.power, pad.fire, reload);
  for (auto& side : match.sides) {
    io(side.score, side.is_fallen, side.king.index, side.king.generation);
  }
}

inline void clear(Match& match) {
  match.pieces = {};
  std::construct_at(&match.bodies);
}

/// Reads the pieces and adds the rocks among them.
inline void read_pieces(In& in, Match& match) {
  for (std::uint32_t i = 0; i < room && in.is_right(); ++i) {
    Piece piece;
    in(piece.kind);
    if (piece.kind == Kind::none) continue;
    piece.id.index = i;
    in(piece.id.generation, piece.owner, piece.age, piece.half.x, piece.half.y);
    if (piece.owner > 1 || piece.half.x <= S() || piece.half.y <= S()) in.refuse();
    if (piece.kind == Kind::rock && in.is_right()) {
      Point center;
      in(center.x, center.y);
      const Box box{center, piece.half, {}};
      if (!in.is_right() || !match.bodies.put(piece.id, box, box_options(Kind::rock))) in.refuse();
    }
    if (in.is_right()) match.pieces[i] = piece;
  }
}

}  // namespace detail

/// The size of the match in bytes. Writes it if there is room.
[[nodiscard]] inline std::size_t snapshot(const Match& match, std::span<std::byte> bytes) {
  detail::Out out(bytes);
  out(static_cast<std::uint8_t>(match.players));
  detail::visit_numbers(out, match);
  for (const Piece& piece : match.pieces) {
    out(piece.kind);
    if (piece.kind == Kind::none) continue;
    out(piece.id.generation, piece.owner, piece.age, piece.half.x, piece.half.y);
    if (piece.kind != Kind::rock) continue;
    const auto center = match.bodies.position(piece.id);
    out(center.x, center.y);
  }
  return out.size() + snapshot(match.bodies, bytes.subspan((std::min)(out.size(), bytes.size())));
}

/// Restores `match` from bytes. Returns whether they are a match with as many players; if not, its
/// field is empty.
[[nodiscard]] inline bool restore(Match& match, std::span<const std::byte> bytes) {
  detail::clear(match);
  detail::In in(bytes);
  std::uint8_t players = 0;
  in(players);
  detail::visit_numbers(in, match);
  detail::read_pieces(in, match);
  if (in.is_right() && players == match.players &&
      restore(match.bodies, in.rest()) == detent::Restored::yes) {
    const auto has_body = [&](const Piece& piece) {
      return piece.kind == Kind::none || match.bodies.contains(piece.id);
    };
    const auto count = std::count_if(match.pieces.begin(), match.pieces.end(),
                                     [](const Piece& p) { return p.kind != Kind::none; });
    const bool has_all = std::all_of(match.pieces.begin(), match.pieces.end(), has_body) &&
                         static_cast<std::size_t>(count) == match.bodies.size();
    if (has_all) return true;
  }
  detail::clear(match);
  return false;
}

}  // namespace slingshot
