// SPDX-License-Identifier: MIT
//
// A character walks up stairs, down a ramp, along a wall and onto a lift. It walks by itself until
// you press a key.
#include <algorithm>

#include <detent/scene/mover.hpp>

#include "bodies.hpp"

namespace samples {

class Character final : public Sample {
 public:
  Character() {
    add(block(-40, -4, -20, 40, 0, 20), pale);
    for (int i = 0; i < 6; ++i) add(block(2 * i - 12, 0, -4, 2 * i - 10, i + 1, 4), stone);
    add(block(0, 0, -4, 12, 6, 4), stone);
    const auto z = Direction<S, 3>::along(2);
    const auto down = Rotation<S, 3>::from_axis_angle(z, Angle<S>::from_degrees(-22_q16_16));
    add(Box{{4.7_q16_16, 0.66_q16_16, {}}, {2_q16_16, 0.1_q16_16, 1_q16_16}, down}, yellow);
    add(block(32, 0, -16, 36, 8, 16), blue);
    add(block(-16, 12, -16, 0, 16, -8), blue);  // reached by the lift
    add(block(12, 0, -16, 16, 4, -12), red);
    lift = things.add_frame({}).value_or(no_frame);
    cabin = things
                .add(Box{{-5_q16_16, 0.1_q16_16, -3_q16_16}, {1_q16_16, 0.1_q16_16, 1_q16_16}, {}},
                     {.frame = lift})
                .value_or(no_object);
  }

  void step(const Input& input) override {
    ++tick;
    // The lift takes ten seconds up and down, and carries what stands on it.
    const int phase = tick % 600 < 300 ? tick % 600 : 600 - tick % 600;
    const S height = quotient_nearest<S>(std::clamp(phase - 60, 0, 180) * 4, 180);
    things.move_frame(lift, {.translation = {{}, height, {}}});

    is_driven = is_driven || input.keys != 0;
    const Input keys = is_driven ? input : of_round();
    const S speed = 0.06_q16_16;
    velocity.x = nearest_to<S>(keys.across() * speed);
    velocity.z = nearest_to<S>(-keys.along() * speed);
    if (keys.has(Input::action) && player.ground.is_grounded) velocity.y = 0.16_q16_16;
    velocity.y -= 0.008_q16_16;
    velocity = clip_velocity(velocity, player.move(things, velocity));
    way.push_back(player.shape.a);
    if (way.size() > 900) way.erase(way.begin());
  }

  void draw(Picture& picture) const override {
    for (std::size_t i = 0; i < ids.size(); ++i) {
      things.visit(ids[i], [&](const Box& shape) {
        draw_solid(picture, shape, colours[i]);
        if (i > 0) detent::draw(picture, shape, ink);
      });
    }
    things.visit(cabin, [&](const Box& shape) {
      draw_solid(picture, shape, green);
      detent::draw(picture, shape, ink);
    });
    draw_solid(picture, player.shape, pink);
    for (std::size_t i = 1; i < way.size(); ++i) picture.line(way[i - 1], way[i], pink);
  }

  [[nodiscard]] std::uint64_t digest() const override {
    Digest all;
    all.add(player, velocity);
    all.add_low_bytes(detent::digest(things), 8);
    return all.value();
  }
  [[nodiscard]] View view() const override { return {{1.5f, 9, 15}, {0.2f, 1.2f, -0.5f}, 11.5f}; }
  [[nodiscard]] std::string status() const override {
    const char* where = !player.ground.is_grounded      ? "in the air"
                        : player.ground.object == cabin ? "on the lift"
                                                        : "on the ground";
    return std::string(where) + (is_driven ? "" : ", walking by itself");
  }

 private:
  /// The box between two corners, in quarters of a unit.
  static Box block(int x, int y, int z, int right, int top, int front) {
    const auto quarter = [](int n) { return quotient_nearest<S>(n, 8); };
    return {{quarter(x + right), quarter(y + top), quarter(z + front)},
            {quarter(right - x), quarter(top - y), quarter(front - z)},
            {}};
  }
  void add(const Box& shape, const Colour& colour) {
    ids.push_back(things.add(shape, {.motion = Motion::fixed}).value_or(no_object));
    colours.push_back(colour);
  }
  /// The keys of its tour: over the stairs to the wall, back over a block, up with the lift.
  [[nodiscard]] Input of_round() const {
    struct Leg {
      int until;
      std::uint8_t keys;
    };
    constexpr std::array<Leg, 11> legs{{{225, Input::right},
                                        {278, Input::up | Input::right},
                                        {325, Input::left},
                                        {335, Input::left | Input::action},
                                        {440, Input::left},
                                        {545, 0},
                                        {594, Input::left},
                                        {840, 0},
                                        {930, Input::right},
                                        {1040, Input::left},
                                        {1093, Input::down}}};
    for (const Leg& leg : legs) {
      if (tick % 1200 < leg.until) return {.keys = leg.keys};
    }
    return {};
  }

  Scene<S, 3, Obb> things;  // shapes that a scene does not use cost nothing
  std::vector<ObjectId> ids;
  std::vector<Colour> colours;
  FrameId lift;
  ObjectId cabin;
  Mover<S, 3, Capsule> player{
      {{-6_q16_16, 0.5_q16_16, {}}, {-6_q16_16, 1.3_q16_16, {}}, 0.35_q16_16}};
  Point velocity{};
  std::vector<Point> way;
  int tick = 0;
  bool is_driven = false;
};

extern const Entry character;
const Entry character{"character",
                      "A capsule walks up stairs, down a ramp and along walls, and rides a lift.",
                      "Arrow keys walk, space jumps", make<Character>};

}  // namespace samples
