// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <stdexcept>
#include <string>

namespace detent::fuzz {

using Bytes = std::span<const std::uint8_t>;

/// Thrown when a property does not hold: the replay reports it; the fuzzing engine crashes on it
/// and keeps the input.
class Failure : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// What must hold for every input; each property file defines one, which throws a Failure.
void property(Bytes input);

/// Called once the property has seen every file of its corpus; throws a Failure if a check fails.
inline void (*after_corpus)() = [] {};

/// Throws `message()` unless the property `holds`.
template <class Message>
void require(bool holds, const Message& message) {
  if (!holds) throw Failure(message());
}

}  // namespace detent::fuzz
