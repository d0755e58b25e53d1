// SPDX-License-Identifier: MIT
//
// A car on a height field: four balls as wheels, each on a joint with a spring and a motor. It
// drives by itself until you press a key.
#include "bodies.hpp"

namespace samples {

class Vehicle final : public Sample {
 public:
  Vehicle() {
    for (int row = 0; row < size; ++row) {
      for (int column = 0; column < size; ++column) heights.push_back(height(column, row));
    }
    const S corner = quotient_nearest<S>(-(size - 1) * cell, 2);
    field = *height_field<S>({corner, corner}, S(cell), size, size, heights);
    terrain = FieldAsset<S>(1, field);
    world.add(BodyHeightField<S, 3>{&terrain, {}}, fixed_body());

    for (std::size_t i = 0; i < 4; ++i) {
      // Fences at the edges.
      const S end = i % 2 == 0 ? S(size - 1) : S(1 - size), thin = 0.2_q16_16, far = S(size - 1);
      fences[i] = i < 2 ? Box{{end, {}, {}}, {thin, 3_q16_16, far}, {}}
                        : Box{{{}, {}, end}, {far, 3_q16_16, thin}, {}};
      world.add(fences[i], fixed_body());
    }

    BodyOptions<S, 3> metal, rubber;
    metal.density = 2_q16_16;
    const Point start{-30_q16_16, 3.2_q16_16, 0_q16_16}, half{1.2_q16_16, 0.3_q16_16, 0.6_q16_16};
    car = {world.add(Box{start, half, {}}, metal).value_or(no_object), red};
    rubber.friction = 1.8_q16_16;
    for (std::size_t i = 0; i < 4; ++i) {
      const Point offset{i < 2 ? 0.9_q16_16 : -0.9_q16_16, -0.35_q16_16,
                         i % 2 == 0 ? 0.8_q16_16 : -0.8_q16_16};
      const Ball wheel{nearest_to<S>(start + offset), 0.45_q16_16};
      wheels[i] = {world.add(wheel, rubber).value_or(no_object), ink};
      joints[i].a = car.id;
      joints[i].b = wheels[i].id;
      joints[i].anchor_a = offset;
      joints[i].frame_a = axle({});
      joints[i].frequency = 4_q16_16;
      joints[i].damping_ratio = 0.7_q16_16;
      axles[i] = world.add(joints[i]).value_or(no_joint);
    }
  }

  void step(const Input& input) override {
    ++tick;
    is_driven = is_driven || input.keys != 0;
    const int along = is_driven ? input.along() : 1;
    const int across = is_driven ? input.across() : by_itself();
    // The wheels steer gradually towards their target.
    steering += quotient_nearest<S>(across * -0.45_q16_16 - steering, 8);
    for (std::size_t i = 0; i < 4; ++i) {
      if (i < 2) joints[i].frame_a = axle(Angle<S>::from_radians(steering));
      joints[i].motor_speed = S(-24 * along);
      joints[i].motor_torque = input.has(Input::action) ? 8_q16_16 : S(2 * along * along);
      if (input.has(Input::action)) joints[i].motor_speed = {};  // the brake
      world.change(axles[i], joints[i]);
    }
    world.step();
  }

  void draw(Picture& picture) const override {
    // Alternate fields of four cells are darker, to make the motion visible.
    for (std::uint32_t row = 0; row + 1 < size; ++row) {
      for (std::uint32_t column = 0; column + 1 < size; ++column) {
        const bool is_dark = (row / 2 + column / 2) % 2 == 0;
        for (const auto& triangle : cell_triangles(field, column, row)) {
          draw_solid(picture, triangle.triangle, is_dark ? meadow : grass);
        }
      }
    }
    for (const Box& fence : fences) draw_solid(picture, fence, stone);
    car.draw(world, picture);
    const Box cabin{{-0.25_q16_16, 0.5_q16_16, {}}, {0.65_q16_16, 0.25_q16_16, 0.5_q16_16}, {}};
    draw_solid(picture, placed(world.pose(car.id), cabin), pale);
    detent::draw(picture, placed(world.pose(car.id), cabin), ink);
    for (const auto& wheel : wheels) wheel.draw(world, picture);
  }

  [[nodiscard]] std::uint64_t digest() const override {
    Digest both;
    both.add_low_bytes(detent::digest(world), 8);
    both.add(steering);
    return both.value();
  }
  /// From behind the car.
  [[nodiscard]] View view() const override {
    const auto place = world.position(car.id);
    const auto ahead = world.rotation(car.id).axis(0);
    const auto number = [](const auto& x) { return static_cast<float>(static_cast<double>(x)); };
    const float x = number(place.x), y = number(place.y), z = number(place.z);
    return {{x - 9 * number(ahead[0]), y + 4.5f, z - 9 * number(ahead[2])}, {x, y + 0.5f, z}, 7};
  }
  [[nodiscard]] std::string status() const override {
    const auto speed = length(world.velocity(car.id));
    return std::to_string(static_cast<int>(static_cast<double>(speed) * 3.6)) + " km/h" +
           (is_driven ? "" : ", driving by itself");
  }

 private:
  static constexpr int size = 49, cell = 2;
  static constexpr Colour grass{0x9c, 0xbf, 0x7d}, meadow{0x8f, 0xb4, 0x72};

  /// Drives back and forth, turning around at the edges.
  [[nodiscard]] int by_itself() const {
    const auto place = world.position(car.id);
    const auto ahead = world.rotation(car.id).axis(0);
    const bool is_far = abs(place.x) > 20 || abs(place.z) > 20;
    if (is_far && place.x * ahead[0] + place.z * ahead[2] > 0) return 1;
    return is_far ? 0 : (tick / 90 % 4 == 1) - (tick / 90 % 4 == 3);
  }
  /// Hills: sums of sines, correctly rounded, so that the ground is the same everywhere.
  static S height(int column, int row) {
    const auto wave = [](int phase, int period) { return sin(Angle<S>::turn(phase, period)); };
    return nearest_to<S>(wave(column, 13) * 0.5_q16_16 + wave(row + column, 17) * 0.6_q16_16 +
                         wave(3 * row - column, 31) * 0.6_q16_16);
  }
  /// The frame of a wheel: axis 0 points up along the spring, axis 2 is the axle.
  static Rotation<S, 3> axle(Angle<S> turn) {
    const auto up = Direction<S, 3>::along(1);
    const auto straight =
        Rotation<S, 3>::from_axes({up, -Direction<S, 3>::along(0), Direction<S, 3>::along(2)});
    return compose(Rotation<S, 3>::from_axis_angle(up, turn), straight);
  }

  std::vector<S> heights;
  HeightField<S> field;
  FieldAsset<S> terrain;
  Bodies world;
  std::array<Box, 4> fences;
  Drawn car;
  std::array<Drawn, 4> wheels;
  std::array<WheelJoint<S, 3>, 4> joints;
  std::array<JointId, 4> axles;
  S steering{};
  int tick = 0;
  bool is_driven = false;
};

extern const Entry vehicle;
const Entry vehicle{"vehicle", "A car with springs and four motors drives over a height field.",
                    "Arrow keys drive, space brakes", make<Vehicle>};

}  // namespace samples
