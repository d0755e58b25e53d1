// SPDX-License-Identifier: MIT
//
// Which houses of a town does a camera see? A scene can be queried with a frustum as with a ray,
// and the answer is exact: a house that touches the frustum in a single point is visible.
#include <detent/shape/camera.hpp>

#include "bodies.hpp"

namespace samples {

class Culling final : public Sample {
 public:
  Culling() {
    for (int row = -14; row < 14; ++row) {
      for (int column = -14; column < 14; ++column) {
        if (row % 5 == 0 || column % 5 == 0) continue;  // streets
        const auto noise = static_cast<std::uint32_t>((row + 20) * 41 + column + 20) * 2654435761u;
        const S x = S(2 * column), z = S(2 * row);
        const S top = quotient_nearest<S>(2 + static_cast<int>(noise >> 28), 4);
        const Aabb<S, 3> house{
            {x, {}, z}, {saturate_to<S>(x + 1.6_q16_16), top, saturate_to<S>(z + 1.6_q16_16)}};
        things.add(house, {.motion = Motion::fixed});
        houses.push_back(house);
      }
    }
    lens =
        *Lens<S>::perspective(Angle<S>::from_degrees(24_q16_16), 1.6_q16_16, 1_q16_16, 22_q16_16);
  }

  void step(const Input& input) override {
    is_driven = is_driven || input.keys != 0;
    heading += Angle<S>::turn(is_driven ? -input.across() : 1, 600);
    const Point ahead{nearest_to<S>(cos(heading)), -0.12_q16_16, nearest_to<S>(-sin(heading))};
    if (is_driven) {
      eye.x = saturate_to<S>(eye.x + ahead.x * (input.along() * 0.1_q16_16));
      eye.z = saturate_to<S>(eye.z + ahead.z * (input.along() * 0.1_q16_16));
    }
    const Point up{{}, 1_q16_16, {}};
    const auto pose = look_at(eye, nearest_to<S>(eye + ahead), up);
    frustum = Frustum{Camera{*pose, lens}};
    // Nearest first. The index of an id is the order in which houses were added.
    is_seen.assign(houses.size(), false);
    count = 0;
    for (const auto& found : things.all(frustum)) {
      seen.add(found.id, found.distance);
      is_seen[found.id.index] = true;
      ++count;
    }
  }

  void draw(Picture& picture) const override {
    const Aabb<S, 3> ground{{S(-29), -0.2_q16_16, S(-29)}, {S(29), {}, S(29)}};
    draw_solid(picture, ground, pale);
    for (std::size_t i = 0; i < houses.size(); ++i) {
      draw_solid(picture, houses[i], is_seen[i] ? yellow : Colour{0xb4, 0xbf, 0xc8});
    }
    detent::draw(picture, frustum, red);
    draw_solid(picture, Ball{eye, 0.5_q16_16}, red);
  }

  [[nodiscard]] std::uint64_t digest() const override {
    Digest all = seen;
    all.add(eye, heading);
    return all.value();
  }
  [[nodiscard]] View view() const override { return {{0, 30, 40}, {0, 0, 1.5f}, 33}; }
  [[nodiscard]] std::string status() const override {
    return std::to_string(count) + " of " + std::to_string(houses.size()) + " houses are in view";
  }

 private:
  Scene<S, 3, Aabb> things;
  std::vector<Aabb<S, 3>> houses;
  std::vector<bool> is_seen;
  Lens<S> lens =
      *Lens<S>::perspective(Angle<S>::from_degrees(24_q16_16), 1.6_q16_16, 1_q16_16, 22_q16_16);
  Frustum<S> frustum{Camera{Transform<S, 3>(), lens}};
  Point eye{0.8_q16_16, 4_q16_16, 0.8_q16_16};
  Angle<S> heading;
  Digest seen;
  std::size_t count = 0;
  bool is_driven = false;
};

extern const Entry culling;
const Entry culling{"culling",
                    "A camera turns over a town; the houses that its frustum touches are yellow.",
                    "Left and right turn the camera, up and down move it", make<Culling>};

}  // namespace samples
