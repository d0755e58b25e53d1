// SPDX-License-Identifier: MIT
#include "support/catch.hpp"
#include "support/workshop.hpp"

// Runs the built program as a user does.

namespace {

using detent::test::content_of;
using detent::test::Workshop;

bool refuses(const Workshop::Result& result, const std::string& start) {
  return is_one_line_of_error(result, "detent-accuracy: " + start);
}

}  // namespace

TEST_CASE("detent-accuracy: prints a summary, numbers and a plot") {
  const Workshop shop(DETENT_ACCURACY);
  const std::string plane = "--only raycast/plane --count 100";
  const auto result = shop.run(plane + " --csv t.csv --svg t.svg");
  CHECK(result.code == 0);
  CHECK(result.err == "accuracy 1/2 raycast/plane\naccuracy 2/2 raycast/plane_2d\n");
  CHECK(result.out.find("\n| q16_16 | own | ") != std::string::npos);
  CHECK(result.out.find("\n| raycast in 2D | ") != std::string::npos);
  const auto data = content_of(shop.path("t.csv"));
  CHECK(data.find(", seed 1, ") != std::string::npos);
  CHECK(data.find("\nquery,ladder,rung,q16_16 wrong %,q16_16 largest,") != std::string::npos);
  CHECK(data.find("\nraycast/plane,angle,parallel,0,") != std::string::npos);
  const auto plot = content_of(shop.path("t.svg"));
  CHECK(plot.starts_with("<svg "));
  CHECK(plot.ends_with("</svg>\n"));
  CHECK(plot.find(">plane</text>") != std::string::npos);

  CHECK(shop.run(plane).out == result.out);
  CHECK(shop.run(plane + " --seed 2").out.find(", seed 2, ") != std::string::npos);
}

TEST_CASE("detent-accuracy: impossible requests are refused") {
  const Workshop shop(DETENT_ACCURACY);
  CHECK(refuses(shop.run("--only raycast/torus"), "--only: "));
  CHECK(refuses(shop.run("--count 0"), "--count: "));
  CHECK(refuses(shop.run("--csv no/such/place.csv"), "no/such/place.csv: "));
  CHECK(refuses(shop.run("--seed -1"), "--seed: "));
  CHECK(refuses(shop.run("--seed 18446744073709551616"), "--seed: "));
  CHECK(refuses(shop.run("--seed ''"), "--seed: "));
  CHECK(refuses(shop.run("--csv ''"), "--csv: the name is empty; "));
  CHECK(refuses(shop.run("--svg ''"), "--svg: the name is empty; "));
  CHECK(refuses(shop.run("--fast"), ""));
  CHECK(shop.file_count() == 0);
}
