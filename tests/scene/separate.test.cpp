// SPDX-License-Identifier: MIT
#include "detent/scene/separate.hpp"

#include <array>

#include "detent/scene/snapshot.hpp"
#include "support/catch.hpp"

using namespace detent;

namespace {

using Arena = BoundedScene<Bounded<8, 2>, q16_16, 3, Sphere, Capsule>;
using Vec3 = Vec<q16_16, 3>;

constexpr Vec3 at(int x) { return {q16_16(x), {}, {}}; }

// Every job of separate.hpp, as a constant expression.
constexpr bool scenes_are_constant_expressions() {
  Arena scene;
  const auto ball = scene.add(Sphere{at(9), q16_16(1)}).value_or(no_object);
  const auto frame = scene.add_frame(Transform<q16_16, 3>{}).value_or(no_frame);
  if (!scene.add(Capsule{at(4), at(5), q16_16(1)}, {.frame = frame})) return false;
  scene.optimize();
  const Ray ray{Vec3{}, Direction<q16_16, 3>::along(0)};
  const auto hit = scene.nearest_hit(ray);
  const auto nearest = scene.nearest(at(20));
  std::array<Overlap, 1> pairs;
  if (!hit || hit->distance != 3 || !nearest || nearest->distance != 10) return false;
  if (!scene.any(at(9)) || !scene.any(Segment{at(0), at(3)}) || scene.any(Sphere{at(0), {}}) ||
      scene.overlaps(pairs) != 0) {
    return false;
  }
  scene.move_frame(frame, Transform<q16_16, 3>{at(3), {}});
  return scene.overlaps(pairs) == 1 && pairs[0].first == ball && digest(scene) != digest(Arena());
}
static_assert(scenes_are_constant_expressions());

TEST_CASE("separate: a scene gives the same results in constant expressions and at run time") {
  CHECK(scenes_are_constant_expressions());
}

TEST_CASE("separate: a reference to a function object calls that object") {
  int sum = 0;
  const auto add = [&sum](std::uint32_t i) {
    sum += static_cast<int>(i);
    return sum > 4 ? Walk::stop : Walk::go_on;
  };
  const std::array<int, 4> records{};
  const detail::ObjectVisitor visitor(add, records.data());
  visitor.ahead(3);
  CHECK(visitor(3) == Walk::go_on);
  CHECK(visitor(2) == Walk::stop);
  CHECK(sum == 5);
}

}  // namespace
