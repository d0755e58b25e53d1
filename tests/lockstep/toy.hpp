// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
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

inline constexpr SessionLimits toy_limits{.peers = 10, .history = 128, .events = 256};
using ToySession = Session<Toy, Pad, toy_limits>;

}  // namespace detent::test
