// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>
#include <string>

#include "verify/describe_worlds.hpp"
#include "verify/judge/exact.hpp"

// A move of a character has many correct results; the judge checks what all of them guarantee.

namespace detent::verify::judge {

/// What is wrong with a move of a character, or nothing.
template <Scalar S, int N>
std::string fault_of(const Capsule<S, N>& before, const Walked<S, N>& walked,
                     const Vec<S, N>& lift) {
  const auto& after = walked.mover.shape;
  const auto& result = walked.result;
  const auto moved = oracle::raw(result.moved);
  const bool is_moved = oracle::difference(oracle::raw(after.a), oracle::raw(before.a)) == moved &&
                        oracle::difference(oracle::raw(after.b), oracle::raw(before.b)) == moved;
  if (!is_moved || after.radius != before.radius) return "the same shape, moved";

  using Here = Place<S, N>;
  bool is_in_shape = false;  // before or after
  std::string fault;
  const auto check = [&](const auto& shape, std::uint32_t index) {
    const auto solid = oracle::exact(shape);
    const bool was_in = oracle::meet(oracle::exact(before), solid);
    const bool is_in = oracle::meet(oracle::exact(after), solid);
    is_in_shape = is_in_shape || was_in || is_in;
    if (is_in && !was_in) fault = "outside of object " + std::to_string(index);
    for (std::size_t i = 0; i < result.count; ++i) {
      const auto& touch = result.touched[i];
      if (touch.object.index != index) continue;
      if (oracle::distance_floor(shape, touch.point).value_or(2) > 1) {
        fault = "a point of object " + std::to_string(index);
      }
    }
  };
  check(Here::ground(), 0);
  check(Here::step(), 1);
  check(Here::next_step(), 2);
  check(Here::wall(), 3);
  check(translated(Here::lift(), lift), 4);
  if (!fault.empty()) return fault;
  if (result.is_stuck && !is_in_shape) return "free";
  const auto& ground = walked.mover.ground;
  // The cosine of 50 degrees is 0.6428.
  if (ground.is_grounded && 1000 * oracle::raw(ground.normal)[1] < 642 * oracle::one_of<S>()) {
    return "no ground on so steep a slope";
  }
  return "";
}

template <int Row, Scalar S, int N>
std::optional<Wrong> judge(const WalkCase<S, N>& c,
                           const std::array<Walked<S, N>, WalkCase<S, N>::moves>& got) {
  auto before = c.start;
  for (std::size_t i = 0; i < got.size(); ++i) {
    const auto fault = fault_of(before, got[i], c.lift[i]);
    if (!fault.empty()) return Wrong{"move " + std::to_string(i) + ": " + fault, words(got)};
    before = got[i].mover.shape;
  }
  return std::nullopt;
}

}  // namespace detent::verify::judge
