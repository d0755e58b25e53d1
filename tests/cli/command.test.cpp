// SPDX-License-Identifier: MIT
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <sstream>

#include "detent/scene/snapshot.hpp"
#include "support/catch.hpp"
#include "support/workshop.hpp"

// Runs the built program as a user does.

namespace {

namespace fs = std::filesystem;
using detent::test::content_of;

struct Workshop : detent::test::Workshop {
  Workshop() : detent::test::Workshop(DETENT_TOOL) {}
};

bool refuses(const Workshop::Result& result, const std::string& start) {
  return is_one_line_of_error(result, "detent: " + start);
}

const std::string ball_scene =
    "{\"shapes\": [{\"type\": \"sphere\", \"id\": \"ball\", \"center\": [0, 0, 10], \"radius\": "
    "2}],\n"
    " \"rays\": [{\"id\": \"hit\", \"origin\": [0.5, 0, 0], \"direction\": [0, 0, 1]},\n"
    "            {\"origin\": [0, 5e0, 0], \"direction\": [0, 0, 1]}]}";

const std::string seen_scene =
    "{\"camera\": {\"position\": [0, 2, 8], \"target\": [0, 1, 0]}, \"shapes\": [\n"
    " {\"type\": \"plane\", \"normal\": [0, 1, 0], \"offset\": 0},\n"
    " {\"type\": \"sphere\", \"center\": [0, 1, 0], \"radius\": 1}]}";

/// An OBJ model of 800 triangles: hills on a grid, partly level.
std::string hills() {
  constexpr int side = 21;
  std::ostringstream model;
  for (int i = 0; i < side * side; ++i) {
    const int x = i % side, y = i / side;
    model << "v " << x << ' ' << y << ' ' << (x * y + 7 * x + 3 * y) % 11 / 2 << '\n';
  }
  for (int i = 1; i < side * (side - 1); ++i) {
    if (i % side == 0) continue;
    model << "f " << i << ' ' << i + 1 << ' ' << i + side << "\nf " << i + 1 << ' ' << i + side + 1
          << ' ' << i + side << '\n';
  }
  return model.str();
}

}  // namespace

TEST_CASE("detent cast: prints one line of JSON for each ray, and a summary") {
  const Workshop shop;
  shop.write("ball.json", ball_scene);
  const auto result = shop.run("cast ball.json");
  CHECK(result.code == 0);
  CHECK(result.err.empty());
  CHECK(result.out.starts_with(
      "{\"ray\": \"hit\", \"hit\": \"ball\", \"distance\": 8.063507080078125,"));
  INFO(result.out);
  CHECK(result.out.find(
            "\n{\"ray\": 1, \"hit\": null}\n{\"rays\": 2, \"hits\": 1, \"digest\": \"0x") !=
        std::string::npos);

  CHECK(shop.run("cast ball.json --out answers").code == 0);
  CHECK(content_of(shop.path("answers")) == result.out);
  CHECK(shop.file_count() == 2);
}

TEST_CASE("detent cast: the example gives the answers shown on its page") {
  const Workshop shop;
  const auto result = shop.run("cast " DETENT_SCENES "/rays.json");
  CHECK(result.code == 0);
  INFO(result.out);
  CHECK(result.out.ends_with("{\"rays\": 11, \"hits\": 8, \"digest\": \"0x71393449c9b2b876\"}\n"));
}

TEST_CASE("detent cast: the page on the tool shows the tool's output") {
  const std::string page = content_of(DETENT_DOCS "/tool.md");
  const auto between = [&](const std::string& begin, const std::string& end) {
    const auto start = page.find(begin) + begin.size();
    return page.substr(start, page.find(end, start) - start);
  };
  const Workshop shop;
  shop.write("crate.json", between("```json\n", "```"));
  std::istringstream shown(between("$ detent cast crate.json\n", "\n\n"));
  std::string expected;
  for (std::string line; std::getline(shown, line);) expected += line.substr(4) + '\n';
  CHECK(shop.run("cast crate.json").out == expected);
}

TEST_CASE("detent cast: among equally near shapes, the first in the file is hit") {
  const Workshop shop;
  shop.write("tie.json",
             "{\"shapes\": ["
             "{\"type\": \"plane\", \"id\": \"far\", \"normal\": [0, 0, 1], \"offset\": 9},"
             "{\"type\": \"plane\", \"id\": \"b\", \"normal\": [0, 0, 1], \"offset\": 5},"
             "{\"type\": \"plane\", \"id\": \"a\", \"normal\": [0, 0, 1], \"offset\": 5}],"
             "\"rays\": [{\"origin\": [0, 0, 0], \"direction\": [0, 0, 3]}]}");
  CHECK(shop.run("cast tie.json").out.starts_with("{\"ray\": 0, \"hit\": \"b\", \"distance\": 5,"));
}

TEST_CASE("detent cast: a scene of many shapes and meshes has its golden digests") {
  const Workshop shop;
  shop.write("hills.obj", hills());
  std::ostringstream scene;
  scene << "{\"shapes\": [\n";
  // Meshes, planes, boxes and triangles with coinciding faces: the first in the file is hit.
  const std::string hills_at = "{\"type\": \"mesh\", \"file\": \"hills.obj\", \"scale\": 0.5, ";
  for (int i = 0; i < 30; ++i) {
    const int x = i % 6 * 4 - 10, y = i / 6 * 4 - 8, z = i * 7 % 9;
    scene << "{\"type\": \"sphere\", \"center\": [" << x << ", " << y << ", " << z
          << "], \"radius\": 0." << 3 + i % 7 << "},\n{\"type\": \"aabb\", \"min\": [" << x + 1
          << ", " << y + 1 << ", 9], \"max\": [" << x + 2 << ", " << y + 3 << ", 9." << i
          << "]},\n";
  }
  scene
      << hills_at << "\"position\": [0, 0, 4]},\n"
      << hills_at << "\"position\": [0, 0, 4]},\n"
      << "{\"type\": \"plane\", \"normal\": [0, 0, 1], \"offset\": 9},\n"
      << "{\"type\": \"triangle\", \"a\": [-9, -9, 9], \"b\": [20, 0, 9], \"c\": [0, 20, 9]},\n"
      << "{\"type\": \"obb\", \"center\": [3, 2, 1], \"half_extents\": [2, 1, 0.5], \"rotation\": "
         "{\"euler\": [20, 30, 40]}}],\n \"rays\": [\n";
  for (int i = 0; i < 900; ++i) {
    scene << (i == 0 ? "" : ",\n") << "{\"origin\": [" << i % 30 * 0.75 - 11 << ", "
          << i / 30 * 0.75 - 11 << ", -2], \"direction\": [" << i % 3 - 1 << ", " << i % 7 - 3
          << ", " << i % 5 * 3 + 1 << "], \"max_distance\": " << 4 + i % 11 << "}";
  }
  shop.write("scene.json", scene.str() + "]}");
  const auto summary = [&](const std::string& scalar) {
    const auto out = shop.run("cast scene.json --scalar " + scalar).out;
    const auto line = out.rfind('\n', out.size() - 2);
    return line == std::string::npos ? out : out.substr(line + 1);
  };
  CHECK(summary("q16_16") ==
        "{\"rays\": 900, \"hits\": 293, \"digest\": \"0x861ba70e675d6cec\"}\n");
  CHECK(summary("q14_16") == summary("q16_16"));
  CHECK(summary("q24_8") == "{\"rays\": 900, \"hits\": 293, \"digest\": \"0x9dbafb9257a0ba77\"}\n");
  CHECK(summary("q8_8") == "{\"rays\": 900, \"hits\": 293, \"digest\": \"0xf8fe75d4fa6d3bfd\"}\n");
}

TEST_CASE("detent cast: works in every scalar, and compares two") {
  const Workshop shop;
  shop.write("ball.json", ball_scene);
  for (const char* const scalar : {"q16_16", "q14_16", "q24_8", "q8_8", "float", "double"}) {
    const auto result = shop.run(std::string("cast ball.json --scalar ") + scalar);
    CHECK(result.code == 0);
    CHECK(result.out.find("\"hits\": 1") != std::string::npos);
  }
  const auto table = shop.run("cast ball.json --scalar q8_8 --compare double");
  CHECK(table.code == 0);
  CHECK(table.out.find("disagreements: 0") != std::string::npos);
  CHECK(table.out.find("(ray hit)") != std::string::npos);
  const auto far = shop.run("cast " DETENT_SCENES "/rays.json --compare q16_16,float");
  CHECK(far.out.find("disagreements: 1 (1 hit or miss, 0 which shape)") != std::string::npos);
}

TEST_CASE("detent render: --debug draws over the picture, in every scalar") {
  const Workshop shop;
  shop.write("seen.json", seen_scene);
  const auto picture = [&](const std::string& options) {
    const auto result = shop.run("render seen.json -o p.png --size 64x40 " + options);
    INFO(options << result.err);
    CHECK(result.code == 0);
    return content_of(shop.path("p.png"));
  };
  const auto plain = picture("");
  const auto shapes = picture("--debug");
  CHECK(shapes.starts_with("\x89PNG"));
  CHECK(shapes != plain);
  CHECK(picture("--debug=shapes --threads 2") == shapes);
  CHECK(picture("--debug=tree,shapes") == shapes);
  CHECK(picture("--debug=tree") == plain);  // a list of two shapes has no tree
  for (const char* const scalar : {"q14_16", "q24_8", "q8_8", "float", "double"}) {
    const auto with = std::string("--scalar ") + scalar;
    CHECK(picture(with + " --debug") != picture(with));
  }
  CHECK(picture("--compare --debug") != picture("--compare"));

  // A mesh has one.
  shop.write("hills.obj", hills());
  const auto model = [&](const std::string& options) {
    CHECK(shop.run("render hills.obj -o p.png --size 64x40 " + options).code == 0);
    return content_of(shop.path("p.png"));
  };
  CHECK(model("--debug=tree") != model(""));
  CHECK(model("--debug=tree") != model("--debug=shapes,tree"));
}

TEST_CASE("detent render: draws the same picture with any number of threads") {
  const Workshop shop;
  shop.write("seen.json", seen_scene);
  CHECK(shop.run("render seen.json -o one.png --size 61x40 --threads 1").code == 0);
  CHECK(shop.run("render seen.json -o many.png --size 61x40 --threads 7").code == 0);
  const std::string picture = content_of(shop.path("one.png"));
  CHECK(picture.starts_with("\x89PNG"));
  CHECK(picture == content_of(shop.path("many.png")));
  CHECK(shop.run("render seen.json -o both.png --size 61x40 --compare q8_8,float").code == 0);
  CHECK(shop.run("render seen.json -o far.png --size 61x40 --offset 28000,-28000.5,1e2").code == 0);
  CHECK(shop.file_count() == 5);
}

TEST_CASE("detent render: a model can be drawn on its own and in a scene") {
  const Workshop shop;
  shop.write("tent.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\nf 1 3 4\nf 1/1 2/2 4/4\n");
  CHECK(shop.run("render tent.obj -o a.png --size 32x20").code == 0);
  CHECK(shop.run("render tent.obj -o b.png --size 32x20 --scale 3").code == 0);
  shop.write(
      "scene.json",
      "{\"shapes\": [{\"type\": \"mesh\", \"id\": \"tent\", \"file\": \"tent.obj\", \"scale\": 2,"
      " \"position\": [0, 0, 5]}],"
      "\"rays\": [{\"origin\": [-0.5, -0.5, 0], \"direction\": [0, 0, 1]}]}");
  const auto result = shop.run("cast scene.json");
  INFO(result.out << result.err);
  CHECK(result.out.starts_with("{\"ray\": 0, \"hit\": \"tent\", \"distance\": 4,"));
}

namespace {

/// The output after a title, which it must contain.
std::istringstream text_after(const std::string& title, const std::string& out) {
  const auto start = out.find(title);
  REQUIRE(start != std::string::npos);
  return std::istringstream(out.substr(start + title.size()));
}

/// The next row of the table printed by `detent demo`.
struct DemoRow {
  explicit DemoRow(std::istream& table) {
    table >> place >> scalar >> rays >> hits >> wrong >> off >> time >> digest;
  }

  std::string place, scalar, digest;
  int rays = 0, hits = 0, wrong = 0, off = 0;
  double time = 0;  // the largest error of casts and contacts
};

void check_exact_row(const DemoRow& row, const std::string& place, int rays,
                     const std::string& digest) {
  CHECK(row.place == place);
  CHECK(row.scalar == "q16_16");
  CHECK(row.rays == rays);
  CHECK(row.wrong == 0);
  CHECK(row.off == 0);
  CHECK(row.digest == digest);
}
/// Whether float is wrong, and far from the origin more often than `often`.
void check_rough_row(const DemoRow& row, const std::string& place, int often) {
  CHECK(row.scalar == "float");
  CHECK(row.wrong + row.off > (place == "near" ? 0 : often));
}

void check_rays(const std::string& out) {
  std::istringstream table(out);
  std::string line;
  std::getline(table, line);
  for (const std::string place : {"near", "far"}) {
    check_exact_row(DemoRow(table), place, 96 * 60,
                    place == "near" ? "0xbb70c39c8de1e496" : "0x263088e24c3564ee");
    check_rough_row(DemoRow(table), place, 1000);
  }
}

void check_casts(const std::string& out) {
  auto table = text_after("off: by more than 1/1024):\n", out);
  std::string line;
  std::getline(table, line);
  CHECK(line.starts_with("place scalar"));
  for (const std::string place : {"near", "far"}) {
    const DemoRow exact(table);
    check_exact_row(exact, place, 2000,
                    place == "near" ? "0x5718cabfe926e42b" : "0x39ade166360dabaa");
    CHECK(exact.hits > 600);
    CHECK(exact.hits < 1600);
    CHECK(exact.time < 0.001);
    check_rough_row(DemoRow(table), place, 300);
  }
}

void check_contacts(const std::string& out) {
  auto table = text_after("place that is off by more than 1/1024):\n", out);
  std::string line;
  std::getline(table, line);
  CHECK(line.starts_with("place scalar     bodies contacts"));
  for (const std::string place : {"near", "far"}) {
    const DemoRow exact(table);
    check_exact_row(exact, place, 1428,
                    place == "near" ? "0xf026afbae0d60c5d" : "0xb852e3d5600c4405");
    CHECK(exact.hits == 1633);
    CHECK(exact.time == 0);
    check_rough_row(DemoRow(table), place, 300);
  }
}

void check_bodies(const std::string& out) {
  for (const char* const row :
       {"\nnear  q16_16         23      240       5       0  0.0000  0xf076246de4216d15\n",
        "\nfar   q16_16         23      240       5       0  0.0000  0x27ac348fd2dadf46\n"}) {
    CHECK(out.find(row) != std::string::npos);
  }
  const auto far_row = out.find("\nfar   float          23      240 ");
  REQUIRE(far_row != std::string::npos);
  std::istringstream row(out.substr(far_row));
  std::string place, scalar;
  int bodies = 0, ticks = 0, asleep = 0, off = 0;
  REQUIRE(row >> place >> scalar >> bodies >> ticks >> asleep >> off);
  CHECK(off > 10);
}

void check_hills(const std::string& out) {
  auto table = text_after("\nhills.obj, 800 triangles, 0.5 units long:\n", out);
  for (const std::string place : {"near", "far"}) {
    check_exact_row(DemoRow(table), place, 96 * 60,
                    place == "near" ? "0xc11b076d76079dca" : "0xdc2d1a5827d5c63e");
    CHECK(DemoRow(table).scalar == "float");
  }
}

}  // namespace

TEST_CASE("detent demo: q16_16 is right near and far, about a model too, and float is not") {
  const Workshop shop;
  shop.write("hills.obj", hills());
  const auto result = shop.run("demo --size 96x60 --out pictures --mesh hills.obj");
  INFO(result.out << result.err);
  REQUIRE(result.code == 0);
  check_rays(result.out);
  check_casts(result.out);
  check_contacts(result.out);
  check_bodies(result.out);
  check_hills(result.out);
  std::string pictures;
  for (const std::string name : {"demo", "casts", "bodies", "mesh"}) {
    CHECK(content_of(shop.path("pictures/" + name + ".png")).starts_with("\x89PNG"));
    pictures += "picture: pictures/" + name + ".png\n";
  }
  CHECK(result.out.ends_with("\n" + pictures));
}

TEST_CASE("detent demo: a model that cannot be shown is refused with file and line") {
  const Workshop shop;
  const auto refused = [&](const std::string& content, const std::string& line) {
    shop.write("m.obj", content);
    const auto result = shop.run("demo --size 8x8 --out pictures --mesh m.obj");
    INFO(result.out << result.err);
    CHECK(refuses(result, "m.obj:"));
    CHECK(result.err.find(line) != std::string::npos);
    CHECK(fs::is_empty(shop.path("pictures")));
  };
  refused("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n\nf 1 2 9\n", "m.obj:6:1: the face names vertex 9");
  refused("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 0 1 2\n", "m.obj:4:3: the face names vertex 0");
  refused("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4294967299\n",
          "m.obj:4:7: the face names vertex 4294967299");
  refused("# 1e400\nv 0 0 0\nv 1 0 0\nv 0 1e400 0\nf 1 2 3\n",
          "m.obj:4:5: vertex 3 is not finite; ");
  refused("v 0 0 0\nv 1 0 0\nv 0 x 0\nf 1 2 3\n",
          "m.obj:3:5: vertex 3 has a coordinate that is not a number");
  refused("v 0 0 0\n", "has no triangles; ");
  shop.write("m.obj", "v 0 0 0\nv 1e305 0 0\nv 0 1e305 0\nf 1 2 3\n");
  CHECK(refuses(shop.run("render m.obj -o x.png --scale 1"), "m.obj: is so large "));
  CHECK(refuses(shop.run("demo --out pictures --mesh no.obj"), "no.obj: no such file"));
  CHECK(refuses(shop.run("demo --out pictures --mesh pictures"), "pictures: is a directory"));
}

TEST_CASE(
    "detent diff: 0 for equal snapshots, 1 and a line per difference, 2 if one is no snapshot") {
  using namespace detent;
  const auto bytes_of = [](int x) {
    Scene<q16_16, 3, Sphere> scene;
    scene.add(Sphere<q16_16, 3>{{q16_16(x), q16_16(0), q16_16(0)}, q16_16(1)});
    const auto bytes = snapshot(scene);
    return std::string(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  };
  const Workshop shop;
  shop.write("a.snap", bytes_of(1));
  shop.write("b.snap", bytes_of(2));
  shop.write("c.snap", bytes_of(1).substr(0, 70));
  const auto equal = shop.run("diff a.snap a.snap");
  CHECK(equal.code == 0);
  CHECK(equal.out == "the snapshots are equal\n");
  const auto other = shop.run("diff a.snap b.snap");
  CHECK(other.code == 1);
  CHECK(other.out == "object 0:1 (sphere) center.x: 1 (raw 65536) | 2 (raw 131072)\n");
  CHECK(refuses(shop.run("diff a.snap c.snap"), "c.snap: the snapshot is cut off; "));
  CHECK(refuses(shop.run("diff a.snap missing.snap"), "missing.snap: "));
}

TEST_CASE("detent: help and version go to standard output") {
  const Workshop shop;
  for (const char* const arguments : {"--help", "--version", "cast --help", "render --help"}) {
    const auto result = shop.run(arguments);
    CHECK(result.code == 0);
    CHECK_FALSE(result.out.empty());
    CHECK(result.err.empty());
  }
}

TEST_CASE("detent: a bad command line prints one line and writes nothing") {
  const Workshop shop;
  shop.write("seen.json", seen_scene);
  shop.write("ball.json", ball_scene);
  for (const char* const arguments : {"",
                                      "fly",
                                      "cast",
                                      "cast ball.json extra",
                                      "cast ball.json --scalar q1_1",
                                      "cast ball.json --compare float,half",
                                      "cast ball.json --compare ,",
                                      "cast ball.json --compare float,double,q8_8",
                                      "cast ball.json --compare ''",
                                      "cast ball.json --fast",
                                      "render seen.json",
                                      "render seen.json -o x.png --size 0x10",
                                      "render seen.json -o x.png --size 10",
                                      "render seen.json -o x.png --size 99999999999x1",
                                      "render seen.json -o x.png --size 16000x16000",
                                      "render seen.json -o x.png --offset 1,2",
                                      "render seen.json -o x.png --offset 1,2,3,4",
                                      "render seen.json -o x.png --offset a,b,c",
                                      "render seen.json -o x.png --scale 2",
                                      "render seen.json -o x.png --bias -1",
                                      "render seen.json -o x.png --debug=edges",
                                      "render seen.json -o x.png --debug=shapes,",
                                      "render seen.json -o x.png --threads x",
                                      "render seen.json -o x.png --threads -1",
                                      "render seen.json -o ''",
                                      "cast ball.json --out ''x/y"}) {
    INFO(arguments);
    const auto result = shop.run(arguments);
    INFO(result.out << result.err);
    CHECK(refuses(result, ""));
    CHECK(shop.file_count() == 2);
  }
}

TEST_CASE("detent: an unknown command is named") {
  const Workshop shop;
  const std::string known = "; there are cast, render, demo, verify, diff, replay, simulate, and ";
  CHECK(refuses(shop.run(""), "no command" + known));
  CHECK(refuses(shop.run("foo"), "unknown command 'foo'" + known));
  CHECK(refuses(shop.run("accuracy"), "unknown command 'accuracy'" + known));
  CHECK(refuses(shop.run("foo --help"), "unknown command 'foo'" + known));
  CHECK(refuses(shop.run("''"), "unknown command ''" + known));
  CHECK(refuses(shop.run("--foo"), "unknown option '--foo'" + known));
  CHECK(refuses(shop.run("--foo cast"), "unknown option '--foo'" + known));
  const std::string of_replay = "; there are check, example, and detent replay --help";
  CHECK(refuses(shop.run("replay"), "no command" + of_replay));
  CHECK(refuses(shop.run("replay foo"), "unknown command 'foo'" + of_replay));
}

TEST_CASE("detent: an empty name is refused for every option") {
  const Workshop shop;
  shop.write("ball.json", ball_scene);
  shop.write("seen.json", seen_scene);
  const auto refused = [&](const std::string& arguments, const std::string& what) {
    INFO(arguments);
    CHECK(refuses(shop.run(arguments), what + ": the name is empty; "));
    CHECK(shop.file_count() == 2);
  };
  refused("cast ''", "scene");
  refused("cast ball.json --out ''", "--out");
  refused("cast ball.json -o \"\"", "--out");
  refused("render '' -o x.png", "input");
  refused("render seen.json --out ''", "--out");
  refused("demo --out ''", "--out");
  refused("demo --mesh ''", "--mesh");
  refused("verify --dump ''", "--dump");
  refused("diff '' ball.json", "a");
  refused("diff ball.json ''", "b");
  shop.write("ball.json", "{\"shapes\": [{\"type\": \"mesh\", \"file\": \"\"}], \"rays\": []}");
  CHECK(refuses(shop.run("cast ball.json"), "ball.json:1:38: file is empty; "));
}

TEST_CASE("detent: a name with a zero byte is not truncated") {
  const Workshop shop;
  shop.write("tent.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  shop.write("s.json",
             "{\"shapes\": [{\"type\": \"mesh\", \"file\": \"tent.obj\\u0000.png\"}],"
             " \"rays\": [{\"origin\": [0, 0, 0], \"direction\": [0, 0, 1]}]}");
  CHECK(refuses(shop.run("cast s.json"), "s.json:1:38: file contains a zero byte"));
  shop.write("s.json", "{\"shapes\": [], \"sun\\u0000\": 1}");
  CHECK(refuses(shop.run("cast s.json"), "s.json:1:16: unknown key \"sun \" in the scene; "));
}

TEST_CASE("detent: missing files, and directories, are named") {
  const Workshop shop;
  shop.write("ball.json", ball_scene);
  shop.write("seen.json", seen_scene);
  fs::create_directory(shop.path("folder"));
  fs::create_directory(shop.path("folder.obj"));
  CHECK(refuses(shop.run("cast no.json"), "no.json: no such file"));
  CHECK(refuses(shop.run("cast folder"), "folder: is a directory"));
  CHECK(refuses(shop.run("render no.obj -o x.png"), "no.obj: no such file"));
  CHECK(refuses(shop.run("render folder.obj -o x.png"), "folder.obj: is a directory"));
  CHECK(refuses(shop.run("cast ball.json --out folder"), "folder: is a directory"));
  CHECK(refuses(shop.run("cast ball.json --out no/where"), "no/where: cannot be written"));
  CHECK(refuses(shop.run("render seen.json -o no/where.png"), "no/where.png: cannot be written"));
  CHECK(refuses(shop.run("demo --out ball.json"), "ball.json: "));
  CHECK(shop.file_count() == 4);
  if (geteuid() != 0) {
    fs::permissions(shop.path("ball.json"), fs::perms::none);
    CHECK(refuses(shop.run("cast ball.json"), "ball.json: cannot be opened"));
  }
}

TEST_CASE("detent: a full disk is reported as such") {
  const Workshop shop;
  shop.write("ball.json", ball_scene);
  shop.write("seen.json", seen_scene);
  // A file size limit of one block simulates a nearly full disk.
  CHECK(refuses(shop.run_script("ulimit -f 1; \"$DETENT\" render seen.json -o x.png --size 99x99"),
                "x.png: cannot be written: File too large; free some space"));
  CHECK(shop.file_count() == 2);
  if (!fs::exists("/dev/full")) return;
  const std::string reason = "cannot be written: No space left on device; ";
  CHECK(refuses(shop.run("cast ball.json --out /dev/full"), "/dev/full: " + reason + "free"));
  for (const char* const arguments : {"cast ball.json", "--help", "cast --help", "--version"}) {
    INFO(arguments);
    CHECK(refuses(shop.run(std::string(arguments) + " >/dev/full"), "standard output: " + reason));
  }
}

TEST_CASE("detent: closed standard streams are reported and not reused for files") {
  const Workshop shop;
  shop.write("ball.json", ball_scene);
  CHECK(refuses(shop.run("cast ball.json >&-"),
                "standard output: cannot be written: Bad file descriptor; "));
  CHECK(shop.run("cast ball.json --out a >&- 2>&- <&-").code == 0);
  CHECK(content_of(shop.path("a")) == shop.run("cast ball.json").out);
  CHECK(shop.run("cast no.json --out a >&- 2>&- <&-").code == 2);
  CHECK(content_of(shop.path("a")) == shop.run("cast ball.json").out);
}

TEST_CASE("detent: a file is replaced only by a complete one") {
  const Workshop shop;
  shop.write("ball.json", ball_scene);
  shop.write("answers", "precious");
  shop.write("bad.json", "{");
  CHECK(refuses(shop.run("cast bad.json --out answers"), "bad.json:1:2: malformed JSON"));
  CHECK(content_of(shop.path("answers")) == "precious");
  CHECK(shop.run("cast ball.json --out answers").code == 0);
  CHECK(content_of(shop.path("answers")).starts_with("{\"ray\""));
}

TEST_CASE("detent: a link to the output remains a link, whether or not its file exists") {
  const Workshop shop;
  shop.write("ball.json", ball_scene);
  fs::create_directory(shop.path("folder"));
  fs::create_symlink("folder/answers", shop.path("link"));
  fs::create_symlink("link", shop.path("other"));
  for (const char* const name : {"link", "other"}) {
    CHECK(shop.run(std::string("cast ball.json --out ") + name).code == 0);
    CHECK(fs::is_symlink(shop.path(name)));
    CHECK_FALSE(fs::is_symlink(shop.path("folder/answers")));
    CHECK(content_of(shop.path("folder/answers")).starts_with("{\"ray\""));
    fs::remove(shop.path("folder/answers"));
    shop.write("folder/answers", "old");
  }
  fs::create_symlink("loop", shop.path("loop"));
  CHECK(refuses(shop.run("cast ball.json --out loop"), "loop: cannot be written: "));
}

TEST_CASE("detent: an existing output keeps its permissions, and a new one gets the usual ones") {
  const Workshop shop;
  shop.write("ball.json", ball_scene);
  shop.write("answers", "");
  const auto permissions = [&](const char* name) {
    return static_cast<unsigned>(fs::status(shop.path(name)).permissions());
  };
  fs::create_symlink("answers", shop.path("link"));
  for (const unsigned mode : {0600u, 0666u, 0751u, 0640u}) {
    for (const char* const name : {"answers", "link"}) {
      fs::permissions(shop.path("answers"), static_cast<fs::perms>(mode));
      CHECK(shop.run_script(std::string("umask 022; \"$DETENT\" cast ball.json --out ") + name)
                .code == 0);
      CHECK(permissions("answers") == mode);
    }
  }
  CHECK(shop.run_script("umask 027; \"$DETENT\" cast ball.json --out new").code == 0);
  CHECK(permissions("new") == 0640);
  if (geteuid() != 0) {
    fs::permissions(shop.path("new"), fs::perms::owner_read);
    CHECK(refuses(shop.run("cast ball.json --out new"),
                  "new: cannot be written: Permission denied; "));
  }
}

TEST_CASE("detent: a signal that ends it leaves no partial file") {
  const Workshop shop;
  shop.write("answers", "precious");
  for (const auto& [signal, number] :
       {std::pair{"TERM", 15}, {"HUP", 1}, {"XCPU", 24}, {"PIPE", 13}}) {
    // It opens its output, then waits for a scene that never comes.
    const auto result = shop.run_script(
        "mkfifo scene\n"
        "\"$DETENT\" cast scene --out answers & program=$!\n"
        "for i in 0 1 2 3 4 5 6 7 8 9; do for j in 0 1 2 3 4 5 6 7 8 9; do\n"
        "  ls -A | grep -q part && break 2; sleep 0.1\n"
        "done; done\n"
        "ls -A | grep -c part\n"
        "kill -s " +
        std::string(signal) + " $program; wait $program; echo $?; rm scene");
    CHECK(result.out == "1\n" + std::to_string(128 + number) + "\n");
    CHECK(shop.file_count() == 1);
    CHECK(content_of(shop.path("answers")) == "precious");
  }
}

TEST_CASE("detent: bad scenes are refused with file, line and column") {
  const Workshop shop;
  const auto refused = [&](const std::string& content, const std::string& start,
                           const std::string& arguments = "cast s.json") {
    shop.write("s.json", content);
    const auto result = shop.run(arguments);
    INFO(result.out << result.err);
    CHECK(refuses(result, start));
    CHECK(shop.file_count() == 1);
  };
  const auto with_sphere = [](const std::string& center, const std::string& radius) {
    return "{\"shapes\": [{\"type\": \"sphere\", \"center\": " + center +
           ",\n  \"radius\": " + radius +
           "}],\n \"rays\": [{\"origin\": [0, 0, 0], \"direction\": [0, 0, 1]}]}";
  };
  refused("", "s.json:1:1: malformed JSON");
  refused("\xef\xbb\xbf", "s.json:1:1: malformed JSON");
  refused(with_sphere("[0, 0, 0]", "1").substr(0, 60), "s.json:2:8: malformed JSON");
  refused(std::string("\0\0", 2), "s.json:1:1: malformed JSON: a zero byte");
  refused(ball_scene + '\0' + "{", "s.json:3:62: malformed JSON: a zero byte");
  refused(std::string(1'000'000, '['), "s.json:1:65: nested deeper");
  refused("{\"shapes\": [], \"shapes\": []}", "s.json:1:16: key \"shapes\" appears twice");
  refused("{\"shapes\": []}", "s.json: the scene has no \"rays\"");
  refused("{\"shapes\": [], \"sun\\u000a\": 1}", "s.json:1:16: unknown key \"sun \" in the scene");
  refused(with_sphere("[0, 0]", "1"), "s.json:1:42: center has 2 numbers");
  refused(with_sphere("[0, 0, 1e5]", "1"),
          "s.json:1:49: center = 100000 is out of range for q16_16");
  refused(with_sphere("[0, 0, 1e999]", "1"), "s.json:1:49: number too large");
  refused(with_sphere("[0, 0, " + std::string(5000, '9') + "]", "1"),
          "s.json:1:49: number too large");
  refused(with_sphere("[0, 0, 0." + std::string(5000, '9') + "]", "1"),
          "s.json:1:49: center is longer than 1000 digits");
  refused(with_sphere("[0, 0, 10]", "32768"), "s.json:2:13: radius = 32768 is out of range");
  refused(with_sphere("[0, 0, 200]", "1"), "s.json:1:49: center = 200 is out of range for q8_8",
          "cast s.json --scalar q8_8");
  refused(with_sphere("[0, 0, 1e39]", "1"), "s.json:1:49: center = 1000",
          "cast s.json --scalar float");
  refused(with_sphere("[0, 0, 0]", "1"), "s.json: the scene has no \"camera\"",
          "render s.json -o x.png");
  refused(seen_scene, "s.json:2:51: --offset = 32768 is out of range",
          "render s.json -o x.png --offset 32768,0,0");
  refused(seen_scene, "s.json:1:29: position after the move = 32768 is out of range",
          "render s.json -o x.png --offset 0,32766,0");
  refused("{\"camera\": {\"position\": [1, 1, 1], \"target\": [1.0, 1, 1]}, \"shapes\": []}",
          "s.json:1:12: position and target are the same", "render s.json -o x.png");
  refused("{\"camera\": {\"position\": [1, 1, 1], \"target\": [1, 7, 1]}, \"shapes\": []}",
          "s.json:1:12: the camera looks along its up", "render s.json -o x.png");
  refused("{\"shapes\": [{\"type\": \"mesh\", \"file\": \"no.obj\"}]}",
          "s.json:1:38: there is no file \"no.obj\" in the folder of this one");
  const auto turned = [](const std::string& rotation) {
    return "{\"shapes\": [{\"type\": \"obb\", \"center\": [0, 0, 0], \"half_extents\": [1, 1, "
           "1],\n" +
           ("\"rotation\": " + rotation) +
           "}],\n \"rays\": [{\"origin\": [0, 0, 0], \"direction\": [0, 0, 1]}]}";
  };
  for (const char* const scalar : {"q16_16", "q14_16", "q24_8", "q8_8"}) {
    const std::string arguments = std::string("cast s.json --scalar ") + scalar;
    const std::string range =
        " = 40000 is out of range for degrees (-32768 to 32767.9999847412109375); subtract "
        "whole turns ";
    refused(turned("{\"axis\": [0, 0, 1], \"angle\": 40000}"), "s.json:2:42: angle" + range,
            arguments);
    refused(turned("{\"euler\": [0, 40000, 1]}"), "s.json:2:27: euler" + range, arguments);
  }
}

TEST_CASE("detent: a byte order mark and other unusual but valid text are accepted") {
  const Workshop shop;
  shop.write("bom.json", "\xef\xbb\xbf" + ball_scene);
  CHECK(shop.run("cast bom.json").code == 0);
  std::string windows = ball_scene;
  for (std::size_t at = 0; (at = windows.find('\n', at)) != std::string::npos; at += 2) {
    windows.replace(at, 1, "\r\n");
  }
  shop.write("windows.json", windows);
  CHECK(shop.run("cast windows.json").out == shop.run("cast bom.json").out);
}

TEST_CASE("detent: unusable models are refused") {
  const Workshop shop;
  const auto refused = [&](const std::string& content, const std::string& what) {
    shop.write("m.obj", content);
    const auto result = shop.run("render m.obj -o x.png --size 8x8");
    INFO(result.out << result.err);
    CHECK(refuses(result, "m.obj:"));
    CHECK(result.err.find(what) != std::string::npos);
    CHECK(shop.file_count() == 1);
  };
  refused("", "has no triangles");
  refused("v 0 0 0\nv 1 0 0\nv 0 1 0\n", "has no triangles");
  refused("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n", "m.obj:4:1: ");
  refused("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 0 1 2\n", "m.obj:4:3: ");
  refused("v 0 0 0\nv 1 0 0\nv 0 1e400 0\nf 1 2 3\n", "m.obj:3:5: ");
  refused(std::string("\x7f"
                      "ELF\x02\x01\0\0\0",
                      9),
          "has no triangles");
}
