// SPDX-License-Identifier: MIT
#include <cmath>
#include <map>
#include <stdexcept>

#include "accuracy/report.hpp"
#include "support/catch.hpp"

namespace detent::accuracy {
namespace {

constexpr std::uint64_t seed = 0xacc;

double share_of_wrong(const Cell* cell) {
  REQUIRE(cell != nullptr);
  return static_cast<double>(cell->wrong) / static_cast<double>(cell->questions);
}

const Query& query_named(const std::string& name) {
  for (const Query& query : queries()) {
    if (query.name == name) return query;
  }
  throw std::runtime_error("no query " + name);
}

const Rung& rung_named(Ladder ladder, const std::string& name) {
  for (const Rung& rung : rungs()) {
    if (rung.ladder == ladder && rung.name == name) return rung;
  }
  throw std::runtime_error("no rung " + name);
}

/// How many steps of a fixed scalar its right answers are off by. Two points that are rounded on
/// every axis are together off by up to a step on each; the rounding of a direction moves a ray by
/// up to two steps at the far end of the world; bodies are apart at their time of impact.
double most_steps(const std::string& kind) {
  if (kind == "closest_points") return std::sqrt(3);
  if (kind == "pick_ray") return 2.5;
  return kind == "time_of_impact" ? 10 : 1;
}

}  // namespace

TEST_CASE("accuracy: fixed-point answers are exact on every rung of every query") {
  std::map<std::string, long> questions;
  std::map<std::string, double> largest;
  for (const Query& query : queries()) {
    if (query.kind == "mover") continue;  // the roundings of its moves add up: see below
    for (const Rung& rung : rungs()) {
      if (!query.applies(rung)) continue;
      const Result result = survey(query, rung, 40, seed);  // throws outside 30 to 70 % hits
      for (const Cell& cell : result.cells) {
        if (cell.inputs == Inputs::asked || cell.scalar[0] != 'q') continue;
        INFO(query.name << ", " << name_of(rung.ladder) << " " << rung.name << ", " << cell.scalar);
        CHECK(cell.wrong == 0);
        CHECK(cell.off == 0);
        questions[cell.scalar] += cell.questions;
        largest[cell.scalar] =
            std::max(largest[cell.scalar], cell.largest / most_steps(query.kind));
      }
    }
  }
  // Errors, in units of 2^-16, are below one step of the scalar, and nearly that large.
  for (const auto& [scalar, step] :
       std::map<std::string, double>{{"q16_16", 1}, {"q14_16", 1}, {"q24_8", 256}, {"q8_8", 256}}) {
    INFO(scalar);
    CHECK(questions[scalar] > 5000);
    CHECK(largest[scalar] < step);
    CHECK(largest[scalar] > 0.9 * step);
  }
}

TEST_CASE("accuracy: far away, float is no better than a coin toss, even for its own numbers") {
  const Query& query = query_named("raycast/sphere");
  const auto wrong_at = [&](const std::string& distance, const char* scalar, Inputs inputs) {
    const auto result = survey(query, rung_named(Ladder::distance, distance), 1000, seed);
    return share_of_wrong(find(result, scalar, inputs));
  };
  for (const auto inputs : {Inputs::own, Inputs::asked}) {
    for (const auto* const scalar : {"float", "textbook float"}) {
      INFO(scalar);
      CHECK(wrong_at("16", scalar, inputs) == 0);
      CHECK(wrong_at("1000", scalar, inputs) > 0.005);
      CHECK(wrong_at("30000", scalar, inputs) > 0.4);
      CHECK(wrong_at("30000", scalar, inputs) < 0.6);
    }
  }
  CHECK(wrong_at("30000", "double", Inputs::own) == 0);
}

TEST_CASE("accuracy: characters end where they should, and walks that do not are found") {
  const Query& query = query_named("mover/capsule");
  const auto walks_on = [&](const Rung& rung, long count) {
    return survey(query, rung, count * query.cost, seed);
  };
  long walks = 0;
  for (const Rung& rung : rungs()) {
    if (!query.applies(rung)) continue;
    for (const Cell& cell : walks_on(rung, 2).cells) {
      if (cell.inputs == Inputs::asked || cell.scalar[0] != 'q') continue;
      INFO(rung.name << ", " << cell.scalar);
      CHECK(cell.wrong == 0);
      CHECK(cell.largest > 0);
      walks += cell.questions;
    }
  }
  CHECK(walks == 2 * (10 + 7 + 13 + 4));  // by q16_16, q14_16, q24_8 and q8_8
  // The numbers of float are 1/16 apart there.
  const auto far = walks_on(rung_named(Ladder::place, "1000000"), 8);
  CHECK(share_of_wrong(find(far, "float", Inputs::own)) > 0.5);
}

TEST_CASE("accuracy: unrepresentable inputs count only for questions as asked") {
  const auto result =
      survey(query_named("raycast/sphere"), rung_named(Ladder::size, "2^-16"), 200, seed);
  CHECK(find(result, "q24_8", Inputs::own) == nullptr);
  CHECK(share_of_wrong(find(result, "q24_8", Inputs::asked)) == 0.5);
  CHECK(share_of_wrong(find(result, "q16_16", Inputs::own)) == 0);
}

TEST_CASE("accuracy: equal seeds give equal questions, other seeds others") {
  const Query& query = query_named("raycast/triangle");
  const Rung& rung = rung_named(Ladder::place, "1000");
  const auto error = [&](std::uint64_t of) {
    return find(survey(query, rung, 100, of), "float", Inputs::own)->largest;
  };
  CHECK(error(1) == error(1));
  CHECK(error(1) != error(2));
}

TEST_CASE("accuracy: a rung whose hit rate is outside 30 to 70 % is an error") {
  Query query = query_named("raycast/sphere");
  long hits = 0;
  query.ask = [&](const Rung&, long count, std::uint64_t) {
    Cell cell;
    cell.questions = count;
    cell.hits = hits;
    return std::vector{cell};
  };
  const Rung& rung = rungs().front();
  for (const long good : {30L, 50L, 70L}) {
    hits = good;
    CHECK_NOTHROW(survey(query, rung, 100, seed));
  }
  for (const long bad : {0L, 29L, 71L, 100L}) {
    hits = bad;
    CHECK_THROWS_AS(survey(query, rung, 100, seed), std::runtime_error);
  }
}

}  // namespace detent::accuracy
