// SPDX-License-Identifier: MIT
#include "scene/histories.hpp"

using namespace detent;
using detent::test::AnyScene;
using detent::test::Historian;
using detent::test::PlainScene;

namespace {

template <Scalar S, int N, class Question>
long ask(const AnyScene<S, N>& scene, const PlainScene<S, N>& plain, const Question& question,
         std::uint32_t mask) {
  const auto expected = plain.all(question, mask);
  const InLayers filter{mask};
  detent::test::check_all(scene, question, filter, expected);
  if constexpr (std::is_same_v<Question, Vec<S, N>>) {
    CHECK(scene.nearest(question, filter) == plain.nearest(question, mask));
  }
  return expected.empty() ? 0 : 1;
}

/// Checks that a scene gives the results of a list of its objects, and of a new scene of them.
template <Scalar S, int N>
void check(const AnyScene<S, N>& scene, const PlainScene<S, N>& plain, Historian<S, N>& history,
           long& asked, long& found) {
  CHECK(scene.size() == plain.objects.size());
  CHECK(scene.overlaps() == plain.overlaps());
  for (int i = 0; i < 4; ++i) {
    const auto mask = static_cast<std::uint32_t>(history.random().below(8));
    found += ask(scene, plain, history.ray(), mask);
    found += ask(scene, plain, history.point(), mask);
    using Shapes = detent::test::QueryShapes<S, N>;
    asked += 2 + static_cast<long>(Shapes::size);
    Shapes::for_each([&]<class Shape>(const Shape&) {
      found += ask(scene, plain, history.template draw<Shape>(), mask);
    });
    if constexpr (N == 3) {
      ++asked;
      found += ask(scene, plain, history.frustum(), mask);
    }
  }
  auto fresh = plain.fresh();
  CHECK(digest(scene) == digest(fresh));
  const auto bytes = snapshot(scene);
  REQUIRE(restore(fresh, bytes) == Restored::yes);
  CHECK(snapshot(fresh) == bytes);
  CHECK(digest(scene) == digest(fresh));
}

template <Scalar S, int N>
void live(std::uint64_t seed, std::size_t room, int steps, int checks) {
  for (const auto kind : oracle::every_kind) {
    INFO("seed " << seed << ", kind " << static_cast<int>(kind));
    Historian<S, N> history(seed, kind);
    AnyScene<S, N> scene;
    PlainScene<S, N> plain;
    long asked = 0, found = 0;
    for (int i = 0; i < checks; ++i) {
      for (int step = 0; step < steps; ++step) history.step(scene, plain, room);
      if (i % 3 == 2) scene.optimize();
      check(scene, plain, history, asked, found);
    }
    UNSCOPED_INFO(found << " of " << asked << " found something");
    CHECK(asked / 10 <= found);
    CHECK(found < asked);
  }
}

}  // namespace

TEMPLATE_TEST_CASE("scene: results equal those of a list of its objects, after any history", "",
                   DETENT_SCENE_SPACES) {
  live<typename TestType::scalar, TestType::dimension>(7, 60, 150, 6);
}

TEMPLATE_TEST_CASE("scene: long histories", "[.demand]", DETENT_SCENE_SPACES) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    live<typename TestType::scalar, TestType::dimension>(seed, 200, 500, 6);
  }
}
