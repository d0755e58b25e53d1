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

TEST_CASE("obj: a model is centered, and its longest side is 20 units") {
  const auto mesh = parse_obj("f", std::string("v 1 1 1\nv 5 1 1\nv 1 2 1\n") + face, {});
  REQUIRE(mesh.vertices.size() == 3);
  CHECK(mesh.vertices[0] == std::array{-10.0, -2.5, 0.0});
  CHECK(mesh.vertices[1] == std::array{10.0, -2.5, 0.0});
  CHECK(mesh.vertices[2] == std::array{-10.0, 2.5, 0.0});
  REQUIRE(mesh.triangles.size() == 1);
  CHECK(mesh.triangles[0] == std::array{0u, 1u, 2u});
}

TEST_CASE("obj: sizes at the ends of double's range are scaled like any other") {
  const auto wide =
      parse_obj("f", std::string("v -1e308 0 0\nv 1e308 0 0\nv 0 1e308 0\n") + face, {});
  CHECK(wide.vertices[1][0] == 10);
  const auto far =
      parse_obj("f", std::string("v 1.6e308 0 0\nv 1.7e308 0 0\nv 1.6e308 1e307 0\n") + face, {});
  CHECK(std::abs(far.vertices[1][0] - 10) < 1e-9);
  CHECK(error_of(std::string("v 0 0 0\nv 1e-320 0 0\nv 0 0 0\n") + face) ==
        "f: cannot be scaled to its size; export the model in other units");
}

TEST_CASE("obj: faces with missing vertices are refused") {
  const auto names = [](const std::string& place, const std::string& number, int count) {
    return "f:" + place + ": the face names vertex " + number + ", and the model has 1 to " +
           std::to_string(count) + "; export the model again";
  };
  CHECK(error_of("v 0 0 0\nf 1 2 3\n") == names("2:1", "2", 1));
  const std::string vertices = "v 0 0 0\nv 1 0 0\n\nv 0 1 0\n";
  CHECK(error_of(vertices + "f 1 2 3\nf 3/1 4/1 2/1\n") == names("6:1", "4", 3));
  CHECK(error_of(vertices + "f -1 -2 -3\nf -1 -2 -4\n") == names("6:9", "-4", 3));
  CHECK(error_of(vertices + "f 0 1 2\n") == names("5:3", "0", 3));
  CHECK(error_of(vertices + "f 1 2 3 4\n") == names("5:1", "4", 3));
  CHECK(error_of(vertices + "f 1 2 3\nf 4 5\n") == names("6:1", "4", 3));
  CHECK(error_of("v 0 0 0\n") == "f: has no triangles; name a Wavefront OBJ model with faces");
}

TEST_CASE("obj: vertex numbers of any size do not wrap") {
  const std::string vertices = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  for (const char* const number :
       {"4294967295", "4294967296", "4294967299", "-4294967293", "2147483651", "-2147483648",
        "18446744073709551619", "-18446744073709551613", "99999999999999999999999999"}) {
    INFO(number);
    CHECK(error_of(vertices + "f 1 2 " + number + "\n").starts_with("f:4:"));
    CHECK(error_of(vertices + "f 1 2 " + number + "\n").find(number) != std::string::npos);
    // Texture coordinates and normals are ignored but must be numbers.
    CHECK(error_of(vertices + "f 1 2 3/" + number + "\n") == "none");
  }
}

TEST_CASE("obj: unreadable vertices and corners are refused") {
  for (const char* const vertex : {"v", "v 1", "v 1 2", "v 1 2 x", "v 1,5 2 3", "v 1 2 # 3",
                                   "v 1 2 3x", "v 0x1p3 0 0", "v +-1 0 0", "v 1 2 3 green"}) {
    INFO(vertex);
    const auto error = error_of(std::string("v 0 0 0\n") + vertex + "\nv 1 0 0\nf 1 2 3\n");
    CHECK(error.starts_with("f:2:"));
    CHECK(error.find(": vertex 2 has ") != std::string::npos);
    CHECK(error.ends_with("; export the model again"));
  }
  CHECK(error_of("v 0 0 0\nv 0 inf 0\n").starts_with("f:2:5: vertex 2 is not finite; "));
  CHECK(error_of("v 0 -1e400 0\n").starts_with("f:1:5: vertex 1 is not finite; "));
  const std::string vertices = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  for (const char* const corner : {"x", "1x", "/1", "1/a", "1/2/3/4", "1.0", "1\\2"}) {
    INFO(corner);
    CHECK(
        error_of(vertices + "f 1 2 " + corner + "\n").starts_with("f:4:7: the face has a corner "));
  }
}

TEST_CASE("obj: every kind of line content is read") {
  const auto read = [](const std::string& text) { return parse_obj("f", text, 1); };
  const auto plain = read("v 0 0 0\nv 1 0 0\nv 0 2 0\nf 1 2 3\n");
  for (const char* const text : {
           "v 0 0 0\rv 1 0 0\rv 0 2 0\rf 1 2 3",
           "\xef\xbb\xbfv 0 0 0\r\n\tv +1. -0 1e-400\r\n v .0e0 2E0 0 \r\nf 1 2 3",
           "# v 9 9 9\nv 0 0 0 1 # v\nv 1 0 0 0.5 0.5 0.5\nv 0 2 0 1 1 1 1\nvn x\nf 1/ 2// 3// #",
           "f 1 2 3\nv 0 0 0\nv 1 0 0\nv 0 2 0\nf 1\nf 1 2\n",
           "o a\nv 0 \\\n0 0\nv 1 0 0\nv 0 2 0\ng b\\\nf -3 \\\r\n-2\\\n -1/-1/-1\n",
       }) {
    INFO(text);
    const auto mesh = read(text);
    CHECK(mesh.vertices == plain.vertices);
    CHECK(mesh.triangles == plain.triangles);
  }
}
