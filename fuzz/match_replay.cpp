// SPDX-License-Identifier: MIT
//
// Any bytes may be read as a replay: reading ends, within the bytes, and returns what those bytes
// encode. The input is read directly, and as the blocks of a replay with a correct head and
// checksums, to reach the rest of the reader: then each block has its frames, and writing them
// again gives the same inputs.

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "detent/lockstep/replay.hpp"
#include "property.hpp"
#include "source.hpp"

namespace detent::fuzz {
namespace {

using Input = std::array<std::uint8_t, 2>;
using Replay = std::vector<std::byte>;
using Reader = ReplayReader<Input, 3>;
using Frames = std::vector<FrameInputs<Input, 3>>;

struct Read {
  Frames frames;
  std::vector<std::uint64_t> digests;
  ReplayState state;
};

Read read(std::span<const std::byte> bytes) {
  Reader reader(bytes);
  Read result;
  const auto keep = [&](const auto& inputs) { result.frames.push_back(inputs); };
  while (const auto digest = reader.next_block(keep)) result.digests.push_back(*digest);
  result.state = reader.state();
  // A block has at least 15 bytes and at most 255 frames; one more may be read before it is
  // refused.
  require(result.frames.size() <= 255 * (bytes.size() / 15 + 1),
          [] { return std::string("more frames than the bytes can hold"); });
  return result;
}

Replay head() {
  Replay bytes;
  ReplayWriter<Input, 3> writer;
  writer.begin({.kind = "any", .players = 3, .snapshot = {}}, [&](std::span<const std::byte> more) {
    bytes.insert(bytes.end(), more.begin(), more.end());
  });
  return bytes;
}

/// A replay of blocks whose bits and frame counts come from the input.
Replay blocks(Source& source) {
  Replay bytes = head();
  auto seed = detail::load_word<std::uint64_t>(bytes.data() + bytes.size() - 8);
  for (auto count = source.below(4); count > 0; --count) {
    Replay block(11 + source.below(40));
    detail::store_word(block.data(), static_cast<std::uint16_t>(block.size() - 11));
    for (std::size_t i = 2; i < block.size(); ++i) block[i] = static_cast<std::byte>(source.byte());
    if (source.below(2) == 0) block[2] = static_cast<std::byte>((block.size() - 11) * 2);
    seed = detail::digest_from(seed, block);
    bytes.insert(bytes.end(), block.begin(), block.end());
    std::array<std::byte, 4> sum{};
    detail::store_word(sum.data(), static_cast<std::uint32_t>(seed));
    bytes.insert(bytes.end(), sum.begin(), sum.end());
  }
  return bytes;
}

void check_again(const Read& first) {
  Replay again = head();
  ReplayWriter<Input, 3> writer(5);
  const auto sink = [&](std::span<const std::byte> more) {
    again.insert(again.end(), more.begin(), more.end());
  };
  again.clear();
  writer.begin({.kind = "any", .players = 3, .snapshot = {}}, sink);
  for (const auto& inputs : first.frames) writer.add(inputs, 0, sink);
  writer.end(0, sink);
  const auto second = read(again);
  bool is_equal = second.frames.size() == first.frames.size();
  for (std::size_t i = 0; is_equal && i < first.frames.size(); ++i) {
    for (std::size_t player = 0; player < 3; ++player) {
      is_equal = is_equal && first.frames[i].is_in(player) == second.frames[i].is_in(player) &&
                 first.frames[i][player] == second.frames[i][player];
    }
  }
  require(is_equal && second.state == ReplayState::whole,
          [] { return std::string("written again, the frames are others"); });
}

}  // namespace

void property(Bytes input) {
  (void)read(std::as_bytes(input));
  Source source(input);
  const auto sealed = blocks(source);
  const auto all = read(sealed);
  require(all.state == ReplayState::whole || all.state == ReplayState::corrupted,
          [] { return std::string("right checksums are not believed"); });
  check_again(all);
  const auto cut = read(std::span<const std::byte>(sealed).first(sealed.size() - 1));
  require(cut.state != ReplayState::whole, [] { return std::string("a cut is not seen"); });
}

}  // namespace detent::fuzz
