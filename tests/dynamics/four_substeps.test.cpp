// SPDX-License-Identifier: MIT
// How still scenes stand in q16_16 at the default of 4 substeps: the table "Standing still" of
// docs/speed.md, which compares other engines.
#include <algorithm>
#include <cmath>

#include "bench/worlds/stage.hpp"
#include "detent/query/contact.hpp"
#include "support/catch.hpp"

namespace detent::test {
namespace {

using S = q16_16;

/// A plan that is played; one of its bodies is watched.
struct Course {
  bench::Plan plan;
  bench::Stage<S> stage;
  BodyId watched;
  Vec<S, 3> start;
  int rest = 0;  // the last tick in which a body was faster than 0.05

  Course(const bench::Plan& scene, std::size_t item)
      : plan(scene), stage(scene), watched(stage.ids[item]), start(stage.world.position(watched)) {}
  explicit Course(const bench::Plan& scene) : Course(scene, scene.items.size() - 1) {}

  Course& play(int ticks) {
    for (int t = 1; t <= ticks; ++t) {
      stage.world.step();
      for (const auto& id : stage.ids) {
        if (length(stage.world.velocity(id)) > num<S>(0.05)) rest = t;
      }
    }
    return *this;
  }
  /// How far the watched body has sunk.
  double sag() const {
    return static_cast<double>(start.y) - static_cast<double>(stage.world.position(watched).y);
  }
  /// How far it has moved sideways.
  double drift() const {
    const auto end = stage.world.position(watched);
    return std::hypot(static_cast<double>(end.x) - static_cast<double>(start.x),
                      static_cast<double>(end.z) - static_cast<double>(start.z));
  }
};

}  // namespace

TEST_CASE("four substeps: stacks stand") {
  const auto ten = Course(bench::stack(10)).play(3000);
  CHECK(std::fabs(ten.sag() - 0.0198) <= 0.0002);
  CHECK(ten.drift() < 0.0002);
  const auto twenty = Course(bench::stack(20)).play(3000);
  CHECK(std::fabs(twenty.sag() - 0.0825) <= 0.0002);
  CHECK(twenty.drift() < 0.0004);
}

TEST_CASE("four substeps: light boxes carry a heavy one") {
  const auto hundred = Course(bench::masses({1, 1, 100})).play(3000);
  CHECK(std::fabs(hundred.sag() - 0.0704) <= 0.0005);
  CHECK(hundred.drift() < 0.001);
  const auto thousand = Course(bench::masses({1, 1000})).play(3000);
  CHECK(std::fabs(thousand.sag() - 0.268) <= 0.001);
  CHECK(thousand.drift() < 0.002);
}

TEST_CASE("four substeps: a house of cards and an arch stand") {
  const auto cards = Course(bench::house_of_cards()).play(3000);
  CHECK(std::fabs(cards.sag() - 0.0083) <= 0.001);
  CHECK(std::fabs(cards.drift() - 0.0112) <= 0.001);
  const auto arch = Course(bench::arch(), 5).play(3000);
  CHECK(std::fabs(arch.sag() - 0.0058) <= 0.0005);
  CHECK(arch.drift() < 0.0005);
}

TEST_CASE("four substeps: a rope carries a heavy ball") {
  for (const auto& [mass, sum] : {std::pair{100.0, 0.483}, {1000.0, 5.24}}) {
    const auto scene = Course(bench::rope(mass)).play(1800);
    // It hangs straight, so the ball has sunk by the gaps of all joints together.
    CAPTURE(mass);
    CHECK(std::fabs(scene.sag() - sum) <= sum / 100);
    CHECK(scene.drift() < 0.001);
  }
}

TEST_CASE("four substeps: a heap of 1,000 boxes comes to rest") {
  const auto scene = Course(bench::heap("", bench::Kind::box, 10, 10, 10)).play(900);
  std::vector<Obb<S, 3>> boxes;
  for (std::size_t i = 0; i < scene.plan.items.size(); ++i) {
    if (!scene.plan.items[i].moves) continue;
    const auto& id = scene.stage.ids[i];
    boxes.push_back({scene.stage.world.position(id), bench::Stage<S>::vec(scene.plan.items[i].half),
                     scene.stage.world.rotation(id)});
  }
  int pairs = 0;
  double sum = 0, most = 0;
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    for (std::size_t k = i + 1; k < boxes.size(); ++k) {
      if (length(boxes[i].center - boxes[k].center) > num<S>(1.8)) continue;
      if (const auto touch = contact(boxes[i], boxes[k])) {
        const auto depth = static_cast<double>(touch->depth);
        sum += depth;
        most = std::max(most, depth);
        ++pairs;
      }
    }
  }
  CAPTURE(scene.rest, pairs, sum / pairs, most);
  CHECK(pairs > 500);
  CHECK(scene.rest < 480);
  CHECK(sum / pairs < 0.0028);
  CHECK(most < 0.0115);
}

}  // namespace detent::test
