// SPDX-License-Identifier: MIT
//
// A cloth falls over a ball. No particle ever touches the ball, because contact is decided exactly.
#include <detent/query/overlaps.hpp>

#include "bodies.hpp"

namespace samples {

class FallingCloth final : public Sample {
 public:
  FallingCloth() : particles(air()) { hang(); }

  void step(const Input& input) override {
    if (input.has(Input::action) || ++tick % 360 == 0) hang();
    const S speed = 0.01_q16_16;
    ball.center.x = saturate_to<S>(ball.center.x + input.across() * speed);
    ball.center.z = saturate_to<S>(ball.center.z - input.along() * speed);
    particles.step(obstacles<S, 3>(ball, ground));
  }

  void draw(Picture& picture) const override {
    draw_solid(picture, Box{{{}, -0.1_q16_16, {}}, {3_q16_16, 0.1_q16_16, 3_q16_16}, {}}, pale);
    draw_solid(picture, ball, blue);
    const auto at = [&](std::uint32_t i, std::uint32_t j) {
      return particles.position(cloth.at(i, j));
    };
    for (std::uint32_t i = 0; i + 1 < size; ++i) {
      for (std::uint32_t j = 0; j + 1 < size; ++j) {
        const Colour colour = (i / 2 + j / 2) % 2 == 0 ? red : Colour{0xe8, 0xdc, 0xc8};
        picture.triangle(at(i, j), at(i, j + 1), at(i + 1, j), colour);
        picture.triangle(at(i + 1, j), at(i, j + 1), at(i + 1, j + 1), colour);
      }
    }
  }

  [[nodiscard]] std::uint64_t digest() const override {
    Digest both;
    both.add_low_bytes(detent::digest(particles), 8);
    both.add(ball);
    return both.value();
  }
  [[nodiscard]] View view() const override { return {{4, 4.2f, 6.5f}, {0, 1.15f, 0}, 3.4f}; }
  [[nodiscard]] std::string status() const override {
    int touching = 0;
    for (ParticleIndex i = 0; i < particles.size(); ++i) {
      touching += overlaps(particles.ball(i), ball) ? 1 : 0;
    }
    return std::to_string(touching) + " of " + std::to_string(particles.size()) +
           " particles touch the ball";
  }

 private:
  static constexpr std::uint32_t size = 25;

  static ParticleSettings<S, 3> air() {
    ParticleSettings<S, 3> settings;
    settings.damping = 1_q16_16;
    settings.friction = 0.4_q16_16;
    return settings;
  }
  void hang() {
    particles = ParticleSystem<S, 3>(air());
    FabricOptions<S, 3> linen;
    linen.bend = 4_q16_16;
    const S step = 0.15_q16_16, edge = -1.8_q16_16;
    cloth = add_cloth(particles, Point{edge, 3_q16_16, edge}, Point{step, {}, {}},
                      Point{{}, {}, step}, size, size, linen)
                .value_or(Cloth());
  }

  ParticleSystem<S, 3> particles;
  Cloth cloth;
  Ball ball{{{}, 1.3_q16_16, {}}, 1_q16_16};
  Aabb<S, 3> ground{{S(-50), S(-2), S(-50)}, {S(50), S(0), S(50)}};
  int tick = 0;
};

extern const Entry cloth_sample;
const Entry cloth_sample{
    "cloth", "A cloth of 625 particles falls over a ball, and none of them ever touches it.",
    "Arrow keys move the ball, space drops the cloth again", make<FallingCloth>};

}  // namespace samples
