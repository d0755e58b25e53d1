// SPDX-License-Identifier: MIT
//
// A pyramid of 55 boxes at rest until a ball hits it. This is all there is to using a world: add
// bodies, call step(), read their poses.
#include "bodies.hpp"

namespace samples {

class Pyramid final : public Sample {
 public:
  Pyramid() {
    world.add(Box{{0_q16_16, -1_q16_16, 0_q16_16}, {40_q16_16, 1_q16_16, 40_q16_16}, {}},
              fixed_body());
    for (int level = 0; level < 5; ++level) {
      for (int i = 0; i < 5 - level; ++i) {
        for (int j = 0; j < 5 - level; ++j) add_box(level, i, j);
      }
    }
  }

  void step(const Input& input) override {
    ++tick;
    // The first ball comes by itself, the others on the action key.
    const bool is_pressed = input.has(Input::action) && !was_pressed;
    was_pressed = input.has(Input::action);
    if ((tick == 40 || is_pressed) && balls.size() < 8) throw_ball(input);
    world.step();
  }

  void draw(Picture& picture) const override {
    draw_solid(picture,
               Box{{0_q16_16, -0.1_q16_16, 0_q16_16}, {9_q16_16, 0.1_q16_16, 9_q16_16}, {}}, pale);
    for (const auto& each : boxes) each.draw(world, picture);
    for (const auto& each : balls) each.draw(world, picture);
  }

  [[nodiscard]] std::uint64_t digest() const override { return detent::digest(world); }
  [[nodiscard]] View view() const override { return {{9, 6.5f, 11}, {0, 1.6f, 0}, 8}; }
  [[nodiscard]] std::string status() const override {
    std::size_t asleep = 0;
    for (const auto& each : boxes) asleep += world.is_asleep(each.id) ? 1 : 0;
    return std::to_string(asleep) + " of " + std::to_string(boxes.size()) + " boxes sleep";
  }

 private:
  void add_box(int level, int i, int j) {
    // Boxes are one unit wide, with gaps of a sixteenth; each level is half a unit further in.
    const auto along = [&](int k) { return saturate_to<S>((2 * k + level - 4) * 0.53125_q16_16); };
    const Point half{0.5_q16_16, 0.5_q16_16, 0.5_q16_16};
    const Box box{{along(i), saturate_to<S>(level + 0.5_q16_16), along(j)}, half, {}};
    if (const auto id = world.add(box)) {
      boxes.push_back({*id, palette_colour(static_cast<std::size_t>(level))});
    }
  }
  void throw_ball(const Input& input) {
    BodyOptions<S, 3> heavy;
    heavy.density = 4_q16_16;
    const S aside = input.is_pointing ? quotient_nearest<S>(input.x, 300) : 0.4_q16_16;
    heavy.velocity = {-20_q16_16, 3_q16_16, saturate_to<S>(-aside)};
    if (const auto id = world.add(Ball{{12_q16_16, 2_q16_16, aside}, 0.7_q16_16}, heavy)) {
      balls.push_back({*id, red});
    }
  }

  Bodies world;
  std::vector<Drawn> boxes, balls;
  int tick = 0;
  bool was_pressed = false;
};

extern const Entry pyramid;
const Entry pyramid{
    "pyramid",
    "A ball hits a pyramid of 55 boxes, which come to rest with the same bits everywhere.",
    "Space throws a ball, the pointer aims", make<Pyramid>};

}  // namespace samples
