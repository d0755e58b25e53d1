// SPDX-License-Identifier: MIT
//
// The world of microcontroller.hpp, which fits a small chip. A Cortex-M3 gives the same digests;
// `samples/check cortex-m3` runs it in an emulator.
#include "microcontroller.hpp"

#include "arena.hpp"

namespace samples {

class Microcontroller final : public Sample {
 public:
  Microcontroller() { microcontroller::build(toy); }

  void step(const Input& input) override {
    if (input.has(Input::action)) {
      toy = {};
      tick = 0;
      microcontroller::build(toy);
    }
    microcontroller::step(toy, tick++);
  }

  void draw(Picture& picture) const override {
    using namespace microcontroller;
    for (std::uint32_t i = 0; i < toy.size(); ++i) {
      const BodyId id{i, i + 1};
      const Colour colour = toy.is_asleep(id) ? stone : palette_colour(i);
      if (i >= fixed_count + box_count) {
        draw_slab(picture, toy, id, Sphere<S, 2>{{}, radius}, {}, colour);
      } else {
        const Obb<S, 2> shape{{}, box(i).half_extents, {}};
        draw_slab(picture, toy, id, shape, {}, i < fixed_count ? green : colour);
      }
    }
  }

  [[nodiscard]] std::uint64_t digest() const override { return detent::digest(toy); }
  [[nodiscard]] View view() const override { return {{2, 5.5f, 14}, {-0.4f, 2.9f, 0}, 8.6f}; }
  [[nodiscard]] std::string status() const override {
    return std::to_string(sizeof toy) + " bytes of static memory hold the world, for " +
           std::to_string(microcontroller::Toy::capacity) + " bodies; " +
           std::to_string(toy.size()) + " are in it";
  }

 private:
  microcontroller::Toy toy;
  std::uint32_t tick = 0;
};

extern const Entry micro;
const Entry micro{"microcontroller",
                  "A world without a heap that has the same bits on a Cortex-M3.",
                  "Space starts again", make<Microcontroller>};

}  // namespace samples
