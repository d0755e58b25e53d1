// SPDX-License-Identifier: MIT
// What does the library see? A sink passes it to your renderer as lines.
#include <detent/detent.hpp>
#include <vector>
using namespace detent;
using namespace detent::literals;

using Vec3 = Vec<q16_16, 3>;

struct Lines {
  std::vector<Vec3> ends;
  void line(const Vec3& a, const Vec3& b, const Colour&) { ends.insert(ends.end(), {a, b}); }
  void triangle(const Vec3&, const Vec3&, const Vec3&, const Colour&) {}  // for draw_solid
};

int main() {
  Scene<q16_16, 3, Sphere, Aabb> scene;
  scene.add(Sphere{Vec3{0_q16_16, 5_q16_16, 0_q16_16}, 1_q16_16});
  scene.add(Aabb{Vec3{}, Vec3{2_q16_16, 2_q16_16, 2_q16_16}}, {.motion = Motion::fixed});

  Lines lines;
  draw(lines, scene);       // 3 circles of 32 lines, 12 edges
  draw_tree(lines, scene);  // a box around each object
  return lines.ends.size() == 2 * (3 * 32 + 12 + 2 * 12) ? 0 : 1;
}
