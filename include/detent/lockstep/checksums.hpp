// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "detent/lockstep/packet.hpp"
#include "detent/number/digest.hpp"

namespace detent::detail {

/// A digest for every final frame, each chained to the previous one: two peers with equal digests
/// of a frame had equal results in all frames up to it.
template <std::size_t History>
class Checksums {
 public:
  /// The number of frames whose results are final and digested.
  [[nodiscard]] constexpr std::uint32_t count() const noexcept { return count_; }
  [[nodiscard]] constexpr std::uint64_t chain() const noexcept { return chain_; }
  [[nodiscard]] constexpr bool has(std::uint32_t frame) const noexcept {
    return frame < count_ && count_ - frame <= History && frame >= start_;
  }
  /// Begins at `frame`, with the digest of all frames before.
  constexpr void start(std::uint32_t frame, std::uint64_t chain) noexcept {
    start_ = count_ = frame;
    chain_ = chain;
  }
  [[nodiscard]] constexpr std::uint32_t operator[](std::uint32_t frame) const noexcept {
    return values_[frame % History];
  }
  constexpr void add(std::uint64_t digest_of_world) noexcept {
    Digest digest(chain_);
    digest.add(digest_of_world);
    chain_ = digest.value();
    values_[count_++ % History] = static_cast<std::uint32_t>(chain_);
  }
  /// Digests of up to `DigestRun::most` frames from `first` on, except those no longer stored.
  [[nodiscard]] constexpr DigestRun run(std::uint32_t first) const noexcept {
    const auto kept = (std::min)(count_, static_cast<std::uint32_t>(History));
    const auto oldest = (std::max)(count_ - kept, start_);
    DigestRun run;
    run.first = (std::max)(first, oldest);
    if (run.first < count_) run.count = (std::min)(count_ - run.first, DigestRun::most);
    for (std::uint32_t i = 0; i < run.count; ++i) run.values[i] = (*this)[run.first + i];
    return run;
  }

 private:
  std::array<std::uint32_t, History> values_{};
  std::uint32_t count_ = 0, start_ = 0;
  std::uint64_t chain_ = 0;
};

/// Compares the digests of one other peer with ours, and finds the first frame that differs.
///
/// While all are equal, a packet has only the newest digest; once one differs, it has those of many
/// frames.
class Comparison {
 public:
  constexpr Comparison() noexcept = default;
  /// For two peers with equal digests of all frames before `start`, as far as they can know.
  explicit constexpr Comparison(std::uint32_t start) noexcept : matched_(start) {}

  /// All frames before this one are equal.
  [[nodiscard]] constexpr std::uint32_t matched() const noexcept { return matched_; }
  [[nodiscard]] constexpr bool has_found() const noexcept { return found_.has_value(); }
  [[nodiscard]] constexpr std::uint32_t found() const noexcept { return *found_; }

  /// Takes the other peer's digests; returns whether the first differing frame has now been found.
  template <std::size_t History>
  [[nodiscard]] constexpr bool compare(const DigestRun& run,
                                       const Checksums<History>& ours) noexcept {
    if (found_) return false;
    bool is_equal_before = false;
    for (std::uint32_t i = 0; i < run.count; ++i) {
      const auto frame = run.first + i;
      if (frame >= ours.count() && !waiting_) waiting_ = {frame, run.values[i]};
      if (frame < matched_ || !ours.has(frame)) continue;
      if (ours[frame] == run.values[i]) {
        matched_ = frame + 1;
        is_equal_before = true;
      } else if (frame == matched_ || is_equal_before) {
        found_ = frame;
        return true;
      } else {
        differs_ = true;
        return false;
      }
    }
    return false;
  }
  /// Compares a digest that arrived before ours was known.
  template <std::size_t History>
  [[nodiscard]] constexpr bool compare_waiting(const Checksums<History>& ours) noexcept {
    if (!waiting_ || waiting_->frame >= ours.count()) return false;
    DigestRun run;
    run.first = waiting_->frame;
    run.count = 1;
    run.values[0] = waiting_->value;
    waiting_.reset();
    return compare(run, ours);
  }

  constexpr void forget_waiting() noexcept { waiting_.reset(); }

  /// The digests that the other peer needs next.
  template <std::size_t History>
  [[nodiscard]] constexpr DigestRun next(const Checksums<History>& ours) const noexcept {
    if (found_) return ours.run(*found_ - (std::min)(*found_, DigestRun::most * 3 / 4));
    if (differs_) return ours.run(matched_);
    return ours.run(ours.count() - (std::min<std::uint32_t>)(ours.count(), 1));
  }

 private:
  struct Waiting {
    std::uint32_t frame, value;
  };
  std::uint32_t matched_ = 0;
  bool differs_ = false;
  std::optional<std::uint32_t> found_;
  std::optional<Waiting> waiting_;  // of a frame that is not final here
};

}  // namespace detent::detail
