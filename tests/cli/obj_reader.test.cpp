// SPDX-License-Identifier: MIT
#include "obj_reader.hpp"

#include <array>
#include <cmath>
#include <string>

#include "support/catch.hpp"

using detent::cli::InputError;
using detent::cli::parse_obj;

namespace {

std::string error_of(const std::string& content) {
  try {
    (void)parse_obj("f", content, {});
    return "none";
  } catch (const InputError& error) {
    return error.what();
  }
}

constexpr auto face = "f 1 2 3\n";

}  // namespace

TEST_CASE("obj: a model is centred, and its longest side is 20 units") {
  const auto mesh = parse_obj("f", std::string("v 1 1 1\nv 5 1 1\nv 1 2 1\n") + face, {});
  REQUIRE(mesh.vertices.size() == 3);
  CHECK(mesh.vertices[0] == std::array{-10.0, -2.5, 0.0});
  CHECK(mesh.vertices[1] == std::array{10.0, -2.5, 0.0});
  CHECK(mesh.vertices[2] == std::array{-10.0, 2.5, 0.0});
  REQUIRE(mesh.triangles.size() == 1);
  CHECK(mesh.triangles[0] == std::array{0u, 1u, 2u});
}

TEST_CASE("obj: sizes at the ends of the range of a double are scaled as any other") {
  const auto wide =
      parse_obj("f", std::string("v -1e308 0 0\nv 1e308 0 0\nv 0 1e308 0\n") + face, {});
  CHECK(wide.vertices[1][0] == 10);
  const auto far =
      parse_obj("f", std::string("v 1.6e308 0 0\nv 1.7e308 0 0\nv 1.6e308 1e307 0\n") + face, {});
  CHECK(std::abs(far.vertices[1][0] - 10) < 1e-9);
  CHECK(error_of(std::string("v 0 0 0\nv 1e-320 0 0\nv 0 0 0\n") + face) ==
        "f: cannot be scaled to its size; export the model in other units");
}

TEST_CASE("obj: faces that name no vertex are refused") {
  CHECK(error_of("v 0 0 0\nf 1 2 3\n").starts_with("f: face 1 names a vertex"));
  const std::string vertices = "v 0 0 0\nv 1 0 0\n\nv 0 1 0\n";
  CHECK(error_of(vertices + "f 1 2 3\nf 3/1 4/1 2/1\n") ==
        "f: face 2 names a vertex that is not there on line 6; export the model again");
  CHECK(error_of(vertices + "f -1 -2 -3\nf -1 -2 -4\n") ==
        "f: face 2 names a vertex that is not there on line 6; export the model again");
  CHECK(error_of("v 0 0 0\n") == "f: has no triangles; name a Wavefront OBJ model with faces");
}
