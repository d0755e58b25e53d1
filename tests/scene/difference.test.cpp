// SPDX-License-Identifier: MIT
#include "detent/scene/difference.hpp"

#include <array>
#include <string>
#include <vector>

#include "detent/scene/scene.hpp"
#include "support/catch.hpp"

using namespace detent;
using S = q16_16;

namespace {

struct Game {
  Scene<S, 3, Sphere> arena;
  std::vector<int> score{1, 2, 3};
  std::array<Vec<S, 3>, 2> velocity{};
};
template <class F>
void for_each_field(const Game& game, const F& f) {
  f("arena", game.arena);
  f("score", game.score);
  f("velocity", game.velocity);
}

Game start() {
  Game game;
  for (int i = 0; i < 3; ++i) game.arena.add(Sphere<S, 3>{{S(3 * i), {}, {}}, S(1)});
  return game;
}

using Names = std::vector<std::string>;
template <class World>
Names names(const World& a, const World& b, std::size_t most = 16) {
  Names result;
  const auto count = diff(
      a, b, [&](const FieldDifference& d) { result.emplace_back(d.field.view()); }, most);
  CHECK(count == result.size());
  return result;
}

}  // namespace

TEST_CASE("diff: equal structs have no difference") {
  CHECK(names(start(), start()).empty());
  CHECK_FALSE(diff(start(), start()));
}

TEST_CASE("diff: names every differing field, in order, with its object") {
  const auto game = start();
  auto other = game;
  other.arena.move({1, 2}, Vec<S, 3>{{}, S(2), {}});
  other.score[2] = 9;
  other.velocity[1].z = S(1);
  CHECK(names(game, other) ==
        Names{"arena object 1:2 (sphere) center.y", "score[2]", "velocity[1].z"});
  CHECK(names(game, other, 2) == Names{"arena object 1:2 (sphere) center.y", "score[2]"});
  const auto first = diff(game, other);
  REQUIRE(first);
  CHECK(first->object == ObjectId{1, 2});
  other.arena = game.arena;
  CHECK_FALSE(diff(game, other)->object);
}

TEST_CASE(
    "diff: an object or element that only one side has is named once, and the rest is compared") {
  const auto game = start();
  auto other = game;
  REQUIRE(other.arena.remove({0, 1}));
  other.score.push_back(4);
  other.velocity[0].x = S(1);
  const Names expected{"arena object 0:1", "score.size", "score[3]", "velocity[0].x"};
  CHECK(names(game, other) == expected);
  CHECK(names(other, game) == expected);
}

TEST_CASE("diff: one element of many is found, and names with equal beginnings are kept apart") {
  std::array<int, 300> a{};
  auto b = a;
  for (std::size_t i = 0; i < a.size(); ++i) {
    b = a;
    b[i] = 1;
    REQUIRE(names(a, b) == Names{"[" + std::to_string(i) + "]"});
  }
  CHECK(detail::is_part_of(FieldName("object 1:2 (sphere)"), FieldName("object 1:2")));
  CHECK_FALSE(detail::is_part_of(FieldName("object 1:21"), FieldName("object 1:2")));
}
