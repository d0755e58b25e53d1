// SPDX-License-Identifier: MIT
//
// A rotating lidar casts 270 rays per tick into a scene. Every hit is exact, and every distance is
// rounded once.
#include "bodies.hpp"

namespace samples {

class Rays final : public Sample {
 public:
  Rays() {
    add(Box{{{}, -0.25_q16_16, {}}, {9_q16_16, 0.25_q16_16, 9_q16_16}, {}}, pale);
    add(Ball{{4_q16_16, 1.2_q16_16, -2_q16_16}, 1.2_q16_16}, blue);
    add(Ball{{-2_q16_16, 0.6_q16_16, 4_q16_16}, 0.6_q16_16}, pink);
    add(Ball{{-6_q16_16, 1_q16_16, 5_q16_16}, 1_q16_16}, blue);
    add(
        Capsule<S, 3>{
            {-5_q16_16, 0.5_q16_16, -1_q16_16}, {-5_q16_16, 2.5_q16_16, 1_q16_16}, 0.5_q16_16},
        green);
    add(
        Capsule<S, 3>{
            {3_q16_16, 0.4_q16_16, 5_q16_16}, {6_q16_16, 0.4_q16_16, 4_q16_16}, 0.4_q16_16},
        green);
    add(
        Capsule<S, 3>{
            {6.5_q16_16, 0.4_q16_16, 0_q16_16}, {6.5_q16_16, 3_q16_16, 0_q16_16}, 0.4_q16_16},
        green);
    add(Aabb<S, 3>{{-4_q16_16, 0_q16_16, -6_q16_16}, {-1_q16_16, 2_q16_16, -5_q16_16}}, yellow);
    add(Aabb<S, 3>{{-8_q16_16, 0_q16_16, -8_q16_16}, {-7_q16_16, 3_q16_16, 2_q16_16}}, yellow);
    for (int i = 0; i < 4; ++i) {
      const auto turn =
          Rotation<S, 3>::from_axis_angle(Direction<S, 3>::along(1), Angle<S>::turn(i, 11));
      const Point half{0.6_q16_16, quotient_nearest<S>(i + 2, 3), 0.6_q16_16};
      add(Box{{S(2 * i - 1), half.y, saturate_to<S>(i * 0.9_q16_16 - 7)}, half, turn}, red);
    }
  }

  void step(const Input& input) override {
    ++tick;
    if (input.is_pointing) {
      lidar.x = quotient_nearest<S>(input.x, 200);
      lidar.z = quotient_nearest<S>(-input.y, 120);
    }
    lidar.x = saturate_to<S>(lidar.x + input.across() * 0.06_q16_16);
    lidar.z = saturate_to<S>(lidar.z - input.along() * 0.06_q16_16);

    hits.clear();
    for (int ring = 0; ring < 3; ++ring) {
      for (int i = 0; i < 90; ++i) {
        const auto angle = Angle<S>::turn(6 * i + tick, 540);
        const Point ahead{nearest_to<S>(cos(angle)), quotient_nearest<S>(ring * 2 - 3, 9),
                          nearest_to<S>(sin(angle))};
        const Ray<S, 3> ray{lidar, *normalize(ahead), 12_q16_16};
        // The state of this sample: a digest of all hits so far.
        if (const auto hit = things.nearest_hit(ray)) {
          hits.push_back(*hit);
          seen.add(hit->id, hit->distance);
        }
      }
    }
  }

  void draw(Picture& picture) const override {
    for (std::size_t i = 0; i < ids.size(); ++i) {
      things.visit(ids[i], [&](const auto& shape) { draw_solid(picture, shape, colours[i]); });
    }
    draw_solid(picture, Ball{lidar, 0.22_q16_16}, ink);
    for (const auto& hit : hits) {
      const bool is_ground = hit.id == ids[0];
      picture.line(lidar, hit.point,
                   is_ground ? Colour{0xb9, 0xc6, 0xd2} : Colour{0xe8, 0x9a, 0x86});
      if (!is_ground) detent::draw(picture, hit.point, red, 0.08_q16_16);
    }
  }

  [[nodiscard]] std::uint64_t digest() const override {
    Digest all = seen;
    all.add(lidar);
    return all.value();
  }
  [[nodiscard]] View view() const override { return {{5, 11, 13}, {0, 0.2f, -0.3f}, 13}; }
  [[nodiscard]] std::string status() const override {
    return std::to_string(hits.size()) + " of 270 rays hit";
  }

 private:
  template <class Shape>
  void add(const Shape& shape, const Colour& colour) {
    ids.push_back(things.add(shape, {.motion = Motion::fixed}).value_or(no_object));
    colours.push_back(colour);
  }

  Scene<S, 3, Sphere, Aabb, Obb, Capsule> things;
  std::vector<ObjectId> ids;
  std::vector<Colour> colours;
  Point lidar{0_q16_16, 1.4_q16_16, 0_q16_16};
  std::vector<ObjectHit<S, 3>> hits;
  Digest seen;
  int tick = 0;
};

extern const Entry rays;
const Entry rays{"rays", "A turning lidar casts 270 rays per tick, and every hit is exact.",
                 "The pointer or the arrow keys move the lidar", make<Rays>};

}  // namespace samples
