// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>
#include <vector>

#include "detent/lockstep/session.hpp"

namespace detent::test {

/// A world that remembers every input and who was in.
struct Toy {
  std::array<std::uint32_t, 8> position{};
  std::array<std::uint32_t, 8> absent{};
  std::uint32_t frame = 0;
  std::uint64_t mixed = 1;
};
template <class F>
void for_each_field(const Toy& toy, const F& f) {
  f("position", toy.position);
  f("absent", toy.absent);
  f("frame", toy.frame);
  f("mixed", toy.mixed);
}

/// A snapshot of ten slices, mostly filler that must be correct.
inline constexpr std::size_t toy_bytes = 76, toy_snapshot = 4000;
inline std::size_t snapshot(const Toy& toy, std::span<std::byte> room) {
  if (room.size() < toy_snapshot) return toy_snapshot;
  auto* to = room.data();
  const auto put = [&](auto word) {
    detent::detail::store_word(to, word);
    to += sizeof(word);
  };
  for (const auto x : toy.position) put(x);
  for (const auto x : toy.absent) put(x);
  put(toy.frame);
  put(toy.mixed);
  for (std::size_t i = toy_bytes; i < toy_snapshot; ++i) {
    *to++ = static_cast<std::byte>(toy.mixed >> (i % 57));
  }
  return toy_snapshot;
}
inline bool restore(Toy& toy, std::span<const std::byte> bytes) {
  if (bytes.size() != toy_snapshot) return false;
  const auto* from = bytes.data();
  const auto get = [&](auto& word) {
    word = detent::detail::load_word<std::remove_reference_t<decltype(word)>>(from);
    from += sizeof(word);
  };
  Toy read;
  for (auto& x : read.position) get(x);
  for (auto& x : read.absent) get(x);
  get(read.frame);
  get(read.mixed);
  for (std::size_t i = toy_bytes; i < toy_snapshot; ++i) {
    if (*from++ != static_cast<std::byte>(read.mixed >> (i % 57))) return false;
  }
  toy = read;
  return true;
}

struct Pad {
  std::int16_t x = 0;
  bool fire = false;

  friend bool operator==(const Pad&, const Pad&) = default;
};

}  // namespace detent::test

template <>
struct detent::InputCodec<detent::test::Pad>
    : detent::FieldCodec<&detent::test::Pad::x, &detent::test::Pad::fire> {};

namespace detent::test {

template <class Inputs>
void simulate(Toy& toy, const Inputs& inputs) {
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    toy.position[i] += static_cast<std::uint32_t>(inputs[i].x) + (inputs[i].fire ? 1000u : 0u);
    toy.absent[i] += inputs.is_in(i) ? 0 : 1;
    toy.mixed = toy.mixed * 6364136223846793005u + toy.position[i] + 7 * toy.absent[i];
  }
  ++toy.frame;
}
inline constexpr auto play = [](Toy& toy, const auto& inputs) { simulate(toy, inputs); };

inline constexpr SessionLimits toy_limits{
    .peers = 10, .history = 256, .events = 256, .packet = 600, .snapshot = 4200};
using ToySession = Session<Toy, Pad, toy_limits>;

}  // namespace detent::test
