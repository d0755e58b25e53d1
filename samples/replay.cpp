// SPDX-License-Identifier: MIT
//
// Records a match as its inputs and a digest every tenth frame, then plays it twice: unchanged on
// the left, and on the right with one speed changed by 1/65536. The check names the frames between
// which they diverge.
#include <algorithm>

#include "arena.hpp"

namespace samples {

class Replay final : public Sample {
  /// The writer appends its bytes here.
  auto sink() {
    return [this](std::span<const std::byte> bytes) {
      file.insert(file.end(), bytes.begin(), bytes.end());
    };
  }

 public:
  Replay() { begin(); }

  void step(const Input& input) override {
    if (frame == length && !is_recorded) finish();
    if (is_recorded) {
      const int to = frame + 1 + 4 * input.across();  // left and right seek
      if (to > length + 60 || input.has(Input::action)) return begin();
      return seek((std::max)(to, 0));
    }
    Pads pads(static_cast<std::uint32_t>(frame), 2);
    for (int i = 0; i < 2; ++i) pads.set(static_cast<std::size_t>(i), played(i, frame));
    simulate(left, pads);
    writer.add(pads, left, sink());
    ++frame;
  }

  void draw(Picture& picture) const override {
    const auto nothing = [](std::uint32_t) { return false; };
    if (!is_recorded) return draw_arena(picture, left, {}, stone, nothing);
    draw_arena(picture, left, S(-7), stone, nothing);
    draw_arena(picture, right, S(7), stone, [&](std::uint32_t i) { return differs(i); });
  }

  [[nodiscard]] std::uint64_t digest() const override {
    Digest all;
    all.add_bytes(file);
    all.add_low_bytes(detent::digest(left), 8);
    all.add_low_bytes(detent::digest(right), 8);
    all.add(static_cast<std::uint32_t>(frame));
    return all.value();
  }
  [[nodiscard]] View view() const override { return {{0, 8, 26}, {0, 3.9f, 0}, 17.5f}; }
  [[nodiscard]] std::string status() const override {
    if (!is_recorded)
      return "recording frame " + std::to_string(frame) + ", " + std::to_string(file.size()) +
             " bytes";
    int count = 0;
    for (std::uint32_t i = first_player; i < body_count; ++i) count += differs(i) ? 1 : 0;
    return "frame " + std::to_string((std::min)(frame, length)) + " of " + std::to_string(length) +
           " in " + std::to_string(file.size()) + " bytes; left: " + std::to_string(truth.equal) +
           " frames equal; right: differs within frames " + std::to_string(planted.equal) + " to " +
           std::to_string(planted.frames) + "; " + std::to_string(count) +
           " bodies moved elsewhere";
  }

 private:
  static constexpr int length = 150, fault = 40;

  void begin() {
    file.clear();
    frame = 0;
    is_recorded = false;
    left = right = new_arena();
    writer = ReplayWriter<Pad>(10);
    writer.begin({.kind = "arena 1", .snapshot = {}}, sink());
  }
  /// The same match with an error: after a frame, a box is faster by one unit in the last place.
  static void simulate_wrongly(Arena& arena, const Pads& pads) {
    simulate(arena, pads);
    if (pads.frame() != fault) return;
    const auto id = body_of(first_player);
    auto velocity = arena.velocity(id);
    velocity.x += S::assume_raw(1);
    arena.set_velocity(id, velocity);
  }
  void finish() {
    writer.end(left, sink());
    is_recorded = true;
    const ReplayReader<Pad> reader(file);
    truth = check_replay(reader, new_arena(), simulate);
    planted = check_replay(reader, new_arena(), simulate_wrongly);
    inputs.clear();
    auto all = reader;
    while (all.next_block([&](const Pads& pads) { inputs.push_back(pads); })) {
    }
    frame = -1;
    left = right = new_arena();
  }
  /// Advances to a frame; going back restarts from the beginning.
  void seek(int to) {
    if (to < frame) {
      left = right = new_arena();
      frame = 0;
    }
    for (frame = (std::max)(frame, 0); frame < to; ++frame) {
      if (frame >= length) continue;
      simulate(left, inputs[static_cast<std::size_t>(frame)]);
      simulate_wrongly(right, inputs[static_cast<std::size_t>(frame)]);
    }
  }
  [[nodiscard]] bool differs(std::uint32_t i) const {
    return left.position(body_of(i)) != right.position(body_of(i));
  }

  Arena left, right;
  std::vector<std::byte> file;
  ReplayWriter<Pad> writer;
  ReplayCheck truth, planted;
  std::vector<Pads> inputs;
  int frame = 0;
  bool is_recorded = false;
};

extern const Entry replay;
const Entry replay{"replay",
                   "A match is recorded, replayed and checked; the check detects a changed bit.",
                   "Left and right seek, space records again", make<Replay>};

}  // namespace samples
