// SPDX-License-Identifier: MIT
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <optional>
#include <sstream>
#include <vector>

#include "support/catch.hpp"
#include "support/workshop.hpp"

#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_ONLY_PNG
#define STBI_NO_STDIO
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wunused-function"
#include <stb/stb_image.h>
#pragma GCC diagnostic pop

// Runs the built program as a user does.

namespace {

using detent::test::content_of;

struct Workshop : detent::test::Workshop {
  Workshop() : detent::test::Workshop(DETENT_TOOL) {
    write("flat.json", flat_world);
    write("pyramid.json", content_of(DETENT_SCENES "/pyramid.json"));
  }

  static constexpr const char* flat_world = R"({
  "dimension": 2,
  "settings": {"substeps": 8, "gravity": [0, -9.5]},
  "bodies": [
    {"id": "floor", "type": "aabb", "min": [-10, -1], "max": [10, 0], "motion": "fixed"},
    {"id": "arm", "type": "obb", "center": [1, 5], "half_extents": [1, 0.1]},
    {"id": "can", "type": "capsule", "a": [0, 2], "b": [1, 2], "radius": 0.3},
    {"type": "hull", "points": [[0, 0], [1, 0], [0, 1]], "position": [3, 3], "rotation": 30},
    {"id": "ball", "type": "sphere", "center": [-2, 3], "radius": 0.5, "restitution": 0.5}],
  "joints": [{"type": "hinge", "a": "floor", "b": "arm", "at": [0, 5],
    "motor_speed": 2, "motor_torque": 50}]
})";
};

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

/// The "0x..." at the end of a line.
std::string digest_of(const std::string& line) { return line.substr(line.rfind("0x"), 18); }

std::array<double, 3> position_in(const std::string& line) {
  std::array<double, 3> at{};
  const auto start = line.find("\"position\": [") + 13;
  std::istringstream numbers(line.substr(start));
  char comma = 0;
  numbers >> at[0] >> comma >> at[1] >> comma >> at[2];
  return at;
}

/// The pixels of a PNG, by a third-party decoder.
struct Pixels {
  int width = 0, height = 0;
  std::vector<unsigned char> bytes;
};
Pixels decoded(const std::string& png) {
  Pixels pixels;
  int channels = 0;
  auto* const data = stbi_load_from_memory(reinterpret_cast<const unsigned char*>(png.data()),
                                           static_cast<int>(png.size()), &pixels.width,
                                           &pixels.height, &channels, 3);
  REQUIRE(data != nullptr);
  pixels.bytes.assign(data, data + pixels.width * pixels.height * 3);
  stbi_image_free(data);
  return pixels;
}

std::uint32_t number_at(const std::string& bytes, std::size_t at) {
  std::uint32_t number = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    number = number << 8 | static_cast<unsigned char>(bytes[at + i]);
  }
  return number;
}

/// The pictures of an animated PNG, each drawn over the previous one.
std::vector<Pixels> frames_of(const std::string& png) {
  std::vector<Pixels> frames;
  std::string header, control;
  std::uint32_t sequence = 0, announced = 0;
  for (std::size_t at = 8; at < png.size();) {
    const std::size_t length = number_at(png, at);
    const std::string type = png.substr(at + 4, 4), content = png.substr(at + 8, length);
    at += length + 12;
    if (type == "IHDR") header = content;
    if (type == "acTL") announced = number_at(content, 0);
    if (type == "fcTL" || type == "fdAT") CHECK(number_at(content, 0) == sequence++);
    if (type == "fcTL") control = content;
    if (type != "IDAT" && type != "fdAT") continue;
    // A PNG of this part only; the decoder ignores chunk checksums.
    const std::string data = type == "IDAT" ? content : content.substr(4);
    const std::string none(4, '\0');
    const std::string size{
        static_cast<char>(data.size() >> 24), static_cast<char>(data.size() >> 16 & 0xff),
        static_cast<char>(data.size() >> 8 & 0xff), static_cast<char>(data.size() & 0xff)};
    const auto part =
        decoded(png.substr(0, 8) + std::string("\0\0\0\rIHDR", 8) + control.substr(4, 8) +
                header.substr(8) + none + size + "IDAT" + data + none + none + "IEND" + none);
    if (frames.empty()) {
      frames.push_back(part);
      continue;
    }
    Pixels frame = frames.back();
    const auto left = number_at(control, 12), top = number_at(control, 16);
    for (std::uint32_t y = 0; y < static_cast<std::uint32_t>(part.height); ++y) {
      const auto row = static_cast<std::uint32_t>(part.width) * 3;
      std::copy_n(
          part.bytes.begin() + y * row, row,
          frame.bytes.begin() + ((top + y) * static_cast<std::uint32_t>(frame.width) + left) * 3);
    }
    frames.push_back(frame);
  }
  CHECK(announced == frames.size());
  return frames;
}

bool refuses(const Workshop::Result& result, const std::string& start) {
  return is_one_line_of_error(result, "detent: " + start);
}

}  // namespace

TEST_CASE("detent simulate: prints a digest for each tick, and a summary") {
  const Workshop shop;
  const auto result = shop.run("simulate flat.json --ticks 60");
  CHECK(result.code == 0);
  CHECK(result.err.empty());
  const auto lines = lines_of(result.out);
  REQUIRE(lines.size() == 61);
  CHECK(lines[0].starts_with("{\"tick\": 1, \"asleep\": 0, \"digest\": \"0x"));
  CHECK(lines[60].starts_with("{\"ticks\": 60, \"bodies\": 5, \"joints\": 1, \"digest\": \"0x"));
  CHECK(digest_of(lines[59]) == digest_of(lines[60]));
  CHECK(digest_of(lines[0]) != digest_of(lines[1]));

  const auto some = lines_of(shop.run("simulate flat.json --ticks 60 --every 20").out);
  REQUIRE(some.size() == 4);
  for (std::size_t i = 0; i < 3; ++i) CHECK(some[i] == lines[20 * i + 19]);
}

TEST_CASE("detent simulate: worlds have their golden digests") {
  const Workshop shop;
  const auto flat = lines_of(shop.run("simulate flat.json --ticks 120 --every 120").out);
  CHECK(digest_of(flat.back()) == "0xe30affbbbb1753b8");
  const auto pyramid = lines_of(shop.run("simulate pyramid.json --ticks 150 --every 150").out);
  CHECK(digest_of(pyramid.back()) == "0xf6dd83aaee5a3de3");
}

TEST_CASE("detent simulate: hinges and welds have springs") {
  const Workshop shop;
  const auto world = [](const std::string& of_hinge, const std::string& of_weld) {
    return R"({"settings": {"gravity": [0, 0, 0], "sleep_speed": 0}, "bodies": [
  {"id": "wall", "type": "sphere", "center": [0, 0, 0], "radius": 0.1, "motion": "fixed"},
  {"id": "arm", "type": "obb", "center": [1, 0, 0], "half_extents": [1, 0.1, 0.1]},
  {"id": "hand", "type": "obb", "center": [3, 0, 0], "half_extents": [1, 0.1, 0.1],
   "angular_velocity": [0, 0, 1]}],
  "joints": [{"type": "hinge", "a": "wall", "b": "arm", "at": [0, 0, 0])" +
           of_hinge + R"(}, {"type": "weld", "a": "arm", "b": "hand", "at": [2, 0, 0])" + of_weld +
           "}]}";
  };
  const std::string spring = R"(, "frequency": 4, "damping_ratio": 0.7)";
  const auto digest_after = [&](const std::string& text) {
    shop.write("springs.json", text);
    const auto result = shop.run("simulate springs.json --ticks 120 --every 120");
    CHECK(result.err.empty());
    REQUIRE(result.code == 0);
    return digest_of(lines_of(result.out).back());
  };
  const auto rigid = digest_after(world("", ""));
  const auto turned = digest_after(world(spring + ", \"angle\": 0.5", ""));
  const auto bent = digest_after(world("", spring));
  CHECK(rigid != turned);
  CHECK(rigid != bent);
  CHECK(turned != digest_after(world(spring + ", \"angle\": 0.25", "")));
  shop.write("springs.json", world("", ", \"angle\": 1"));
  CHECK(refuses(shop.run("simulate springs.json"), "springs.json:6:"));
}

TEST_CASE("detent simulate: the page on the tool shows the tool's output") {
  const std::string page = content_of(DETENT_DOCS "/tool.md");
  const auto section = page.substr(page.find("## Simulating"));
  const auto between = [&](const std::string& begin, const std::string& end) {
    const auto start = section.find(begin) + begin.size();
    return section.substr(start, section.find(end, start) - start);
  };
  const Workshop shop;
  shop.write("swing.json", between("```json\n", "```"));
  const std::string command = "simulate swing.json --ticks 90 --every 30";
  const auto shown = lines_of(between("$ detent " + command + "\n", "\n\n"));
  const auto printed = lines_of(shop.run(command).out);
  REQUIRE(printed.size() == 4);
  REQUIRE(shown.size() == printed.size());
  for (std::size_t i = 0; i < printed.size(); ++i) CHECK(shown[i] == "    " + printed[i]);

  // The picture there is the one that its command draws.
  const auto line = between("$ detent simulate src/cli/scenes/", "\n");
  CHECK(shop.run("simulate " + line).code == 0);
  CHECK(content_of(shop.path("pyramid.png")) == content_of(DETENT_DOCS "/pyramid.png"));
}

TEST_CASE("detent simulate: a world continued from a snapshot has the same digests") {
  const Workshop shop;
  for (const std::string world : {"flat.json", "pyramid.json"}) {
    for (const std::string scalar : {"q16_16", "float", "double"}) {
      INFO(world << ' ' << scalar);
      const std::string command = "simulate " + world + " --scalar " + scalar + " --ticks ";
      const auto whole = lines_of(shop.run(command + "60 --snapshot-at 37 --out at37").out);
      const auto rest = lines_of(shop.run(command + "23 --resume at37 --out end").out);
      REQUIRE(whole.size() == 61);
      REQUIRE(rest.size() == 24);
      for (std::size_t i = 0; i < 23; ++i) CHECK(digest_of(rest[i]) == digest_of(whole[37 + i]));
      CHECK(shop.run(command + "60 --out last").code == 0);
      CHECK(content_of(shop.path("end")) == content_of(shop.path("last")));
    }
  }
}

TEST_CASE("detent simulate: far from the origin everything is shifted, in q16_16 to the last bit") {
  const Workshop shop;
  const std::string command = "simulate pyramid.json --ticks 200 --every 200 --bodies";
  const auto here = lines_of(shop.run(command).out);
  const auto there = lines_of(shop.run(command + " --offset 28000,28000,-28000").out);
  REQUIRE(here.size() == 25);
  REQUIRE(there.size() == here.size());
  for (std::size_t i = 1; i + 1 < here.size(); ++i) {
    INFO(here[i]);
    const auto a = position_in(here[i]), b = position_in(there[i]);
    CHECK(a[0] + 28000 == b[0]);
    CHECK(a[1] + 28000 == b[1]);
    CHECK(a[2] - 28000 == b[2]);
  }
  CHECK(there[1].starts_with("{\"body\": \"ground\", \"position\": [28000, 27999, -28000], "));
}

TEST_CASE("detent simulate: the animation shows the pictures") {
  const Workshop shop;
  for (const std::string world : {"flat.json", "pyramid.json"}) {
    INFO(world);
    const auto result =
        shop.run("simulate " + world + " --ticks 40 --picture-every 8 --size 192x128 --frames " +
                 world + "-pictures --animation film.png --every 40");
    CHECK(result.code == 0);
    CHECK(result.err.empty());
    const auto frames = frames_of(content_of(shop.path("film.png")));
    REQUIRE(frames.size() == 6);
    for (std::size_t i = 0; i < frames.size(); ++i) {
      const auto name = world + "-pictures/frame-0000" + std::to_string(i) + ".png";
      const auto picture = decoded(content_of(shop.path(name)));
      CHECK(picture.width == 192);
      CHECK(picture.height == 128);
      CHECK(picture.bytes == frames[i].bytes);
      if (i > 0) CHECK(picture.bytes != frames[i - 1].bytes);
    }
  }
}

TEST_CASE("detent simulate: errors in a world are named by line, and nothing is written") {
  const Workshop shop;
  const std::string ball =
      "{\"id\": \"b\", \"type\": \"sphere\", \"center\": [0, 0, 9], "
      "\"radius\": 1}";
  const auto refused = [&](const std::string& world, const std::string& what) {
    shop.write("bad.json", world);
    INFO(world);
    const auto files = shop.file_count();
    const auto result = shop.run("simulate bad.json --out x --ticks 3");
    INFO(result.err);
    CHECK(refuses(result, "bad.json:" + what));
    CHECK(shop.file_count() == files);
  };
  refused("{}", "1:1: the world has no \"bodies\"; add it");
  refused("{\"bodies\": [],\n\"boddies\": 1}", "2:1: unknown key \"boddies\" in the world; ");
  refused("{\"bodies\": [],\n\"dimension\": 4}",
          "2:14: dimension is not a whole number from 2 to 3;");
  refused("{\"bodies\": [\n{\"type\": \"cone\"}]}",
          "2:10: unknown shape \"cone\"; choose from sphere,");
  refused("{\"bodies\": [\n{\"type\": \"sphere\", \"center\": [0, 1], \"radius\": 1}]}",
          "2:30: center has 2 numbers; write three: [x, y, z]");
  refused("{\"bodies\": [\n{\"type\": \"sphere\", \"center\": [0, 1, 99999], \"radius\": 1}]}",
          "2:37: center = 99999 is out of range for q16_16");
  refused("{\"bodies\": [" + ball + ",\n" + ball + "]}",
          "2:1: body id \"b\" is taken by the one on");
  refused("{\"bodies\": [\n{\"type\": \"hull\", \"points\": [[0, 0, 0], [1, 0, 0]]}]}",
          "2:1: the hull is flat or has more than 32 points; ");
  refused(
      "{\"bodies\": [\n{\"type\": \"sphere\", \"center\": [0, 1, 2], \"radius\": 1,\n"
      "\"motion\": \"static\"}]}",
      "3:11: unknown motion \"static\"; choose from dynamic, kinematic, fixed");
  refused(
      "{\"bodies\": [\n{\"type\": \"sphere\", \"center\": [0, 1, 2], \"radius\": 1,\n"
      "\"locked\": [\"w\"]}]}",
      "3:12: unknown axis \"w\"; choose from x, y, z, turn_x, turn_y, turn_z, turn");
  refused(
      "{\"bodies\": [\n{\"type\": \"sphere\", \"center\": [0, 1, 2], \"radius\": 1,\n"
      "\"layers\": [32]}]}",
      "3:12: a layer of layers is not a whole number from 0 to 31;");
  refused(
      "{\"bodies\": [" + ball + "], \"joints\": [\n{\"type\": \"glue\"}]}",
      "2:10: unknown joint \"glue\"; choose from distance, ball, cone, hinge, weld, slider, wheel");
  refused("{\"dimension\": 2, \"bodies\": [], \"joints\": [\n{\"type\": \"cone\"}]}",
          "2:10: cones are for three dimensions; use a hinge with limits");
  refused("{\"bodies\": [" + ball +
              "], \"joints\": [\n{\"type\": \"ball\", \"a\": \"b\", "
              "\"b\": \"c\", \"at\": [0, 0, 0]}]}",
          "2:33: no body has the id \"c\"; name an existing body");
  refused("{\"bodies\": [" + ball +
              "], \"joints\": [\n{\"type\": \"ball\", \"a\": \"b\", "
              "\"b\": \"b\", \"at\": [0, 0, 0]}]}",
          "2:1: the ball joint joins a body to itself; name two bodies");
  refused("{\"bodies\": [" + ball +
              "], \"joints\": [\n{\"type\": \"ball\", \"a\": \"b\", "
              "\"b\": \"b\", \"limits\": [0, 0]}]}",
          "2:38: unknown key \"limits\" in the ball joint; it may have type, a, b, at,");
  const auto joint = [&](const std::string& keys) {
    return "{\"bodies\": [" + ball + ", {\"id\": \"c\"" + ball.substr(ball.find(',')) +
           "], \"joints\": [\n{\"type\": \"hinge\", \"a\": \"b\", \"b\": \"c\", " + keys + "}]}";
  };
  refused(joint("\"at\": [0, 0, 0], \"limits\": [1, -0.5]"),
          "2:66: limits are not in order; write the lower one first");
  refused(joint("\"at\": [0, 0, 0], \"limits\": [-1, 3.2]"),
          "2:66: limits of the hinge joint are not within -pi and pi; write radians, or omit them");
  refused(joint("\"at\": [0, 0, 0], \"limits\": [-3.15, 3]"), "2:66: limits of the hinge joint");
  refused(joint("\"collide\": true"),
          "2:1: the hinge joint has no anchor; write \"at\", or \"at_a\"");
  refused(joint("\"at_b\": [0, 0, 0]"), "2:1: the hinge joint has no \"at_a\"; add it");
  refused("{\"bodies\": [\n{\"type\": \"compound\", \"parts\": []}]}",
          "2:31: the compound has no parts; give it a shape");
  refused(
      "{\"bodies\": [\n{\"type\": \"sphere\", \"center\": [0, 1, 2], \"radius\": 1,\n"
      "\"rolling_resistance\": -1}]}",
      "3:23: rolling_resistance is negative; ");
  refused("{\"bodies\": [\n{\"type\": \"compound\", \"density\": 2, \"parts\": [" + ball + "]}]}",
          "2:33: density is that of each part of a compound; move it there");
  refused("{\"bodies\": [{\"type\": \"compound\", \"parts\": [\n" + ball + "]}]}",
          "2:2: unknown key \"id\" in the sphere; it may have type, center, radius, density,");
  refused("{\"bodies\": [{\"type\": \"compound\", \"parts\": [\n{\"type\": \"mesh\"}]}]}",
          "2:10: unknown shape \"mesh\"; choose from sphere, capsule, aabb, obb, hull as parts");
  const std::string corners = "\"vertices\": [[0, 0, 0], [0, 0, 1], [1, 0, 0]],\n";
  const auto mesh = [&](const std::string& rest) {
    return "{\"bodies\": [{\"type\": \"mesh\", " + rest + "}]}";
  };
  refused(mesh("\"position\": [0, 0, 0]"), "1:13: the mesh has no file and no vertices; add one");
  refused(mesh(corners + "\"file\": \"a.obj\""),
          "1:42: the mesh mixes file and vertices; keep one");
  refused(mesh(corners + "\"triangles\": []"), "2:14: the mesh has no triangles; write some");
  refused(mesh(corners + "\"triangles\": [[0, 1]]"),
          "2:15: a triangle is not three vertices; write [0, 1, 2]");
  refused(mesh(corners + "\"triangles\": [[0, 1, 3]]"),
          "2:22: a vertex of the triangle is not a whole number from 0 to 2;");
  refused(mesh(corners + "\"triangles\": [[0, 1, 2]], \"motion\": \"dynamic\""),
          "2:37: the mesh has no mass and does not fall; write \"fixed\" or \"kinematic\"");
  refused(mesh(corners + "\"triangles\": [[0, 1, 2]], \"density\": 1"),
          "2:27: unknown key \"density\" in the mesh; it may have type, id, color, file,");
  refused(mesh("\"vertices\": [[0, 0, 0], [0, 0, 513], [1, 0, 0]], \"triangles\": [[0, 1, 2]]"),
          "1:13: the mesh reaches farther than 512 units from its position; make it smaller");
  const auto field = [&](const std::string& rest) {
    return "{\"bodies\": [{\"type\": \"height_field\",\n" + rest + "}]}";
  };
  refused(field("\"heights\": [[0, 1], [1, 0]]"), "1:13: the height_field has no \"cell\"; add it");
  refused(field("\"cell\": 0, \"heights\": [[0, 1], [1, 0]]"),
          "2:9: cell must be more than 0; 1 is usual");
  refused(field("\"cell\": 1, \"heights\": [[0, 1], [1]]"),
          "2:32: a row has 1 heights and the first one 2; make them equal");
  refused(field("\"cell\": 1, \"heights\": [[0, 1]]"),
          "2:23: the height_field has less than two rows or columns of heights; add some");
  refused(field("\"cell\": 1, \"corner\": [0], \"heights\": [[0, 1], [1, 0]]"),
          "2:22: corner is not two numbers; write [x, z]");
  refused("{\"dimension\": 2, \"bodies\": [\n{\"type\": \"mesh\"}]}",
          "2:10: the mesh is for worlds of three dimensions; build flat ground");
  refused("{\"dimension\": 2, \"bodies\": [],\n\"camera\": {\"center\": [0, 0], \"height\": 0}}",
          "2:40: height must be more than 0; 20 is usual");
}

TEST_CASE("detent simulate: terrain from a file carries what falls on it, and is drawn") {
  const Workshop shop;
  // Both triangles face up. A scale of 1 keeps the size; the box around a model is centered.
  shop.write("ground.obj", "v 0 0 0\nv 0 0 8\nv 8 0 0\nv 8 0 8\nf 1 2 3\nf 3 2 4\n");
  shop.write("terrain.json", R"({
  "camera": {"position": [0, 12, 12], "target": [0, 0, 0]},
  "bodies": [
    {"id": "plain", "type": "mesh", "file": "ground.obj", "scale": 1, "position": [0, -1, 0]},
    {"id": "shelf", "type": "mesh", "vertices": [[0, 0, 0], [0, 0, 2], [2, 0, 0], [2, 0, 2]],
     "triangles": [[0, 1, 2], [2, 1, 3]], "position": [4, 2, -1], "motion": "kinematic"},
    {"id": "hills", "type": "height_field", "corner": [-2, -2], "cell": 2, "friction": 0.9,
     "heights": [[0, 0, 0], [0, 0, 0], [1, 1, 1]], "position": [-8, 0.5, 0]},
    {"id": "a", "type": "sphere", "center": [0.3, 1, 0.2], "radius": 0.5},
    {"id": "b", "type": "sphere", "center": [5, 4, 0], "radius": 0.5},
    {"id": "c", "type": "obb", "center": [-8, 2, -1], "half_extents": [0.4, 0.3, 0.4]},
    {"id": "hammer", "type": "compound", "position": [-2, 2, 0], "parts": [
      {"type": "obb", "center": [0, 0, 0], "half_extents": [1, 0.1, 0.1]},
      {"type": "obb", "center": [1, 0, 0], "half_extents": [0.2, 0.2, 0.4], "density": 8}]}]
})");
  const auto result = shop.run("simulate terrain.json --ticks 150 --every 150 --bodies");
  INFO(result.err);
  REQUIRE(result.code == 0);
  const auto lines = lines_of(result.out);
  REQUIRE(lines.size() == 1 + 7 + 1);
  const auto height = [&](std::size_t body) { return position_in(lines[1 + body])[1]; };
  CHECK(std::abs(height(3) - (-0.5)) < 0.02);
  CHECK(std::abs(height(4) - 2.5) < 0.02);
  CHECK(std::abs(height(5) - 0.8) < 0.02);
  // The hammer lies on its head; its center of mass is between the heights of head and handle.
  CHECK(-0.9 < height(6));
  CHECK(height(6) < -0.7);
  CHECK(lines.back().find("\"bodies\": 7") != std::string::npos);

  // A snapshot has the assets' ids and digests, and goes on with the same bits.
  CHECK(shop.run("simulate terrain.json --ticks 40 --every 40 --out half").code == 0);
  const auto rest = shop.run("simulate terrain.json --ticks 110 --every 110 --resume half");
  CHECK(digest_of(lines_of(rest.out).back()) == digest_of(lines.back()));

  // What lies in the middle of the picture is the ground.
  CHECK(shop.run("simulate terrain.json --ticks 2 --frames film --size 90x60").code == 0);
  const auto picture = decoded(content_of(shop.path("film/frame-00000.png")));
  const auto pixel = [&](int x, int y) {
    const auto* const p = &picture.bytes[static_cast<std::size_t>(3 * (y * picture.width + x))];
    return std::array{p[0], p[1], p[2]};
  };
  CHECK(pixel(45, 30) != pixel(45, 1));
  CHECK(pixel(40, 38) != pixel(45, 1));
}

TEST_CASE("detent simulate: a compound of one part moves like that part") {
  const Workshop shop;
  const auto world = [](const std::string& body) {
    return "{\"dimension\": 2, \"bodies\": [{\"type\": \"aabb\", \"min\": [-9, -1], \"max\": [9, "
           "0], "
           "\"motion\": \"fixed\"}, {" +
           body + "}]}";
  };
  const std::string box = "\"type\": \"obb\", \"half_extents\": [0.5, 0.25], \"friction\": 0.4, ";
  shop.write("plain.json", world(box + "\"center\": [1, 3], \"rotation\": 30"));
  shop.write("compound.json",
             world("\"type\": \"compound\", \"position\": [1, 3], \"rotation\": 30, \"parts\": [{" +
                   box + "\"center\": [0, 0]}]"));
  const auto plain = lines_of(shop.run("simulate plain.json --ticks 80 --every 80 --bodies").out);
  const auto compound =
      lines_of(shop.run("simulate compound.json --ticks 80 --every 80 --bodies").out);
  REQUIRE(plain.size() == 4);
  REQUIRE(compound.size() == 4);
  CHECK(plain[2] == compound[2]);

  CHECK(shop.run("simulate plain.json --ticks 20 --frames a --size 60x40").code == 0);
  CHECK(shop.run("simulate compound.json --ticks 20 --frames b --size 60x40").code == 0);
  CHECK(content_of(shop.path("a/frame-00010.png")) == content_of(shop.path("b/frame-00010.png")));
}

TEST_CASE("detent simulate: rolling resistance stops a ball, and a part that is one") {
  const Workshop shop;
  const auto way = [&](const std::string& body, const std::string& part) {
    shop.write("roll.json",
               "{\"dimension\": 2, \"bodies\": [{\"type\": \"aabb\", \"min\": [-9, -1], "
               "\"max\": [90, 0], \"motion\": \"fixed\"}, {" +
                   body + ", \"velocity\": [2, 0], \"angular_velocity\": -4" + part + "}]}");
    const auto result = shop.run("simulate roll.json --ticks 300 --every 300 --bodies");
    INFO(result.err);
    REQUIRE(result.code == 0);
    return position_in(lines_of(result.out).at(2))[0];
  };
  const std::string ball = "\"type\": \"sphere\", \"center\": [0, 0.5], \"radius\": 0.5";
  const std::string of_part =
      ", \"parts\": [{\"type\": \"sphere\", \"center\": [0, 0], \"radius\": 0.5";
  const std::string compound = "\"type\": \"compound\", \"position\": [0, 0.5]";
  const std::string resistance = ", \"rolling_resistance\": 0.1";
  CHECK(way(ball, "") > 9.9);
  const double stopped = way(ball + resistance, "");
  CHECK(std::abs(stopped - 3.06) < 0.1);  // v^2 (1 + 1/2) / (2 * 0.1 g)
  CHECK(way(compound, of_part + "}]") > 9.9);
  CHECK(way(compound, of_part + resistance + "}]") == stopped);
}

TEST_CASE("detent simulate: an arm drops until its cone stops it") {
  const Workshop shop;
  const auto hanging = [&](const std::string& cone) {
    shop.write("arm.json", R"({"bodies": [
      {"type": "sphere", "id": "a", "center": [0, 3, 0], "radius": 0.3, "motion": "fixed"},
      {"type": "capsule", "id": "b", "a": [0.4, 3, 0], "b": [1.4, 3, 0], "radius": 0.1}],
      "joints": [{"type": "cone", "a": "a", "b": "b", "at": [0.4, 3, 0], "limits": [-0.5, 0.5],
        "rotation": {"axis": [0, 1, 0], "angle": 90}, "cone_angle": )" +
                               cone + "}]}");
    const auto lines = lines_of(shop.run("simulate arm.json --ticks 60 --every 60 --bodies").out);
    REQUIRE(lines.size() == 4);
    return position_in(lines[2]);
  };
  for (const double cone : {0.4, 0.8}) {
    const auto at = hanging(std::to_string(cone));
    CHECK(std::fabs(at[0] - 0.4 - 0.5 * std::cos(cone)) < 0.001);
    CHECK(std::fabs(at[1] - 3 + 0.5 * std::sin(cone)) < 0.001);
  }
}

TEST_CASE("detent simulate: layers select collisions, and fast bodies pass no plate") {
  const Workshop shop;
  shop.write("layers.json", R"({"dimension": 2, "bodies": [
    {"type": "aabb", "min": [-60, -1], "max": [60, 0], "motion": "fixed"},
    {"type": "aabb", "min": [10, 0], "max": [10.02, 8], "motion": "fixed"},
    {"id": "meets", "type": "sphere", "center": [0, 1], "radius": 0.5, "layers": [1]},
    {"id": "falls", "type": "sphere", "center": [3, 1], "radius": 0.5, "layers": [2],
     "collides_with": [2, 31]},
    {"id": "shell", "type": "sphere", "center": [5, 3], "radius": 0.05, "velocity": [500, 0]},
    {"id": "bullet", "type": "sphere", "center": [5, 5], "radius": 0.05, "velocity": [500, 0],
     "fast": true}]})");
  const auto result = shop.run("simulate layers.json --ticks 60 --every 60 --bodies");
  INFO(result.out << result.err);
  REQUIRE(result.code == 0);
  const auto at = [&](const std::string& name) {
    for (const auto& line : lines_of(result.out)) {
      if (line.starts_with("{\"body\": \"" + name + '"')) return position_in(line);
    }
    FAIL(name);
    return std::array<double, 3>{};
  };
  CHECK(at("meets")[1] > 0.4);
  CHECK(at("falls")[1] < -1);
  CHECK(at("shell")[0] > 11);
  CHECK(at("bullet")[0] < 10);
}

TEST_CASE("detent simulate: wrong options and snapshots are refused, and nothing is written") {
  const Workshop shop;
  CHECK(shop.run("simulate flat.json --ticks 5 --out good").code == 0);
  shop.write("short", content_of(shop.path("good")).substr(0, 100));
  shop.write("text", "not a snapshot, but long enough to hold a header of one");
  shop.write("level.json", "{\"bodies\": []}");
  const auto files = shop.file_count();
  const auto refused = [&](const std::string& arguments, const std::string& what) {
    INFO(arguments);
    const auto result = shop.run("simulate " + arguments);
    INFO(result.err);
    CHECK(refuses(result, what));
    CHECK(shop.file_count() == files);
  };
  refused("", "world is required; see detent simulate --help");
  refused("none.json", "none.json: no such file; ");
  refused("flat.json --scalar q8_8",
          "--scalar: no world has the scalar \"q8_8\"; choose from q16_16,");
  refused("flat.json --ticks 9 --snapshot-at 4",
          "--snapshot-at: no file to write the snapshot to;");
  refused("flat.json --ticks 9 --snapshot-at 10 -o x", "--snapshot-at: tick 10 is after the last");
  refused("flat.json --ticks -1", "");
  refused("flat.json --every 0", "");
  refused("flat.json --offset 1,2", "--offset: \"1,2\" is not three numbers; ");
  refused("flat.json --resume none", "none: no such file; ");
  refused("flat.json --resume text -o x", "text: is not a snapshot of a world; ");
  refused("flat.json --resume short -o x", "short: the snapshot is damaged; ");
  refused("pyramid.json --resume good", "good: a snapshot of a world with different settings, ");
  refused("flat.json --scalar float --resume good", "good: a snapshot of a world with different ");
  refused("flat.json --offset 1,0,0 --resume good",
          "good: a snapshot of a world with different fixed");
  CHECK(refuses(shop.run("diff good good"), "good: a snapshot of a world; "));
  refused("level.json --animation x.png", "level.json: the world has no \"camera\"; ");
  refused("flat.json --frames flat.json/x", "flat.json/x: cannot be created as a directory; ");
}
