// SPDX-License-Identifier: MIT
//
// Twenty ragdolls fall down a flight of stairs, each made of ten bodies and nine ball joints.
#include "bodies.hpp"

namespace samples {

class Ragdolls final : public Sample {
 public:
  Ragdolls() {
    for (int i = 0; i < steps; ++i) {
      const Point half{0.7_q16_16, 3_q16_16, 4_q16_16};
      const Box stair{
          {saturate_to<S>(i * 1.4_q16_16 - 8), saturate_to<S>(3_q16_16 - i * 0.9_q16_16), {}},
          half,
          {}};
      stairs.push_back(stair);
      world.add(stair, fixed_body());
    }
    floor = {{3_q16_16, -4.2_q16_16, {}}, {13_q16_16, 1_q16_16, 7_q16_16}, {}};
    world.add(floor, fixed_body());
  }

  void step(const Input&) override {
    if (tick % 12 == 0 && count < 20) add_ragdoll(count++);
    ++tick;
    world.step();
  }

  void draw(Picture& picture) const override {
    for (const Box& stair : stairs) {
      draw_solid(picture, stair, stone);
      detent::draw(picture, stair, ink);
    }
    draw_solid(picture, floor, pale);
    for (const auto& each : parts) each.draw(world, picture);
  }

  [[nodiscard]] std::uint64_t digest() const override { return detent::digest(world); }
  [[nodiscard]] View view() const override { return {{13, 9, 17}, {-1.2f, 1.6f, 0}, 13.5f}; }
  [[nodiscard]] std::string status() const override {
    return std::to_string(count) + " ragdolls, " + std::to_string(10 * count) + " bodies, " +
           std::to_string(world.joint_count()) + " joints";
  }

 private:
  void add_ragdoll(int number) {
    const Point hips{-8.4_q16_16, 8_q16_16, saturate_to<S>((number * 7 % 5 - 2) * 1.3_q16_16)};
    const Colour colour = palette_colour(static_cast<std::size_t>(number % 7));
    const auto at = [&](const Point& p) { return nearest_to<S>(hips + p); };
    flesh.velocity = {5_q16_16, {}, quotient_nearest<S>(number % 3 - 1, 2)};
    flesh.angular_velocity = {S(0), S(0), S(-number % 4)};
    flesh.friction = 0.15_q16_16;
    flesh.angular_damping = 0.5_q16_16;

    const Point half{0.24_q16_16, 0.34_q16_16, 0.15_q16_16};
    const auto torso = world.add(Box{at({}), half, {}}, flesh).value_or(no_object);
    const Ball skull{at({{}, 0.6_q16_16, {}}), 0.2_q16_16};
    const auto head = world.add(skull, flesh).value_or(no_object);
    parts.push_back({torso, colour});
    parts.push_back({head, colour});
    join(torso, head, at({{}, 0.38_q16_16, {}}));
    for (const int side : {-1, 1}) {
      const auto x = [&](S past) { return saturate_to<S>(side * past); };
      // Arms stretch out, legs hang down.
      const Point shoulder{x(0.3_q16_16), 0.26_q16_16, {}}, elbow{x(0.65_q16_16), 0.26_q16_16, {}},
          hand{x(1_q16_16), 0.26_q16_16, {}};
      add_limb(torso, at(shoulder), at(elbow), at(hand), colour);
      const Point hip{x(0.14_q16_16), -0.4_q16_16, {}}, knee{x(0.16_q16_16), -0.85_q16_16, {}},
          foot{x(0.18_q16_16), -1.3_q16_16, {}};
      add_limb(torso, at(hip), at(knee), at(foot), colour);
    }
  }
  /// Two capsules: from the torso to the middle joint, and on to the end.
  void add_limb(BodyId torso, const Point& start, const Point& middle, const Point& end,
                const Colour& colour) {
    const auto upper = add_bone(start, middle, colour), lower = add_bone(middle, end, colour);
    join(torso, upper, start);
    join(upper, lower, middle);
  }
  BodyId add_bone(const Point& a, const Point& b, const Colour& colour) {
    const auto id = world.add(Capsule<S, 3>{a, b, 0.09_q16_16}, flesh).value_or(no_object);
    parts.push_back({id, colour});
    return id;
  }
  /// Joins two bodies at a world point.
  void join(BodyId a, BodyId b, const Point& point) {
    BallJoint<S, 3> joint;
    joint.a = a;
    joint.b = b;
    joint.anchor_a = world.local_point(a, point);
    joint.anchor_b = world.local_point(b, point);
    world.add(joint);
  }

  static constexpr int steps = 9;
  Bodies world;
  BodyOptions<S, 3> flesh;
  Box floor;
  std::vector<Box> stairs;
  std::vector<Drawn> parts;
  int tick = 0, count = 0;
};

extern const Entry ragdolls;
const Entry ragdolls{
    "ragdolls", "Twenty ragdolls of ten bodies and nine ball joints fall down a flight of stairs.",
    "Nothing to press: watch", make<Ragdolls>};

}  // namespace samples
