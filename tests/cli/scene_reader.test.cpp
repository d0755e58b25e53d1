// SPDX-License-Identifier: MIT
#include "scene_reader.hpp"

#include "support/catch.hpp"

using namespace detent::cli;

namespace {

/// The error message for a scene with this content, without the file name.
std::string error_of(const std::string& content) {
  try {
    (void)parse_scene("f", content);
    return "none";
  } catch (const InputError& error) {
    return std::string(error.what()).substr(2);
  }
}

std::string shape_error(const std::string& shape) {
  return error_of("{\"shapes\": [\n" + shape + "\n]}");
}

std::string ray_error(const std::string& ray) {
  return error_of("{\"shapes\": [], \"rays\": [\n" + ray + "\n]}");
}

}  // namespace

TEST_CASE("scene: every part is read") {
  const Scene scene = parse_scene("f", R"({
    "camera": {"position": [0, 1, 5], "target": [0, 0, 0], "up": [0, 0, 1], "field_of_view": 45},
    "light": [1, 1, 1],
    "shapes": [
      {"type": "sphere", "id": "ball", "center": [1, 2, 3], "radius": 1e-1, "color": "#0180fF"},
      {"type": "aabb", "min": [0, 0, 0], "max": [1, 1, 1]},
      {"type": "obb", "center": [0, 0, 0], "half_extents": [1, 1, 1],
       "rotation": {"axis": [0, 1, 0], "angle": 30}},
      {"type": "obb", "center": [0, 0, 0], "half_extents": [1, 1, 1],
       "rotation": {"euler": [10, 20, 30]}},
      {"type": "plane", "normal": [0, 1, 0], "offset": -2},
      {"type": "triangle", "a": [0, 0, 0], "b": [1, 0, 0], "c": [0, 1, 0]}],
    "rays": [{"id": "r", "origin": [0, 0, 0], "direction": [0, 0, 1], "max_distance": 9},
             {"origin": [0, 0, 0], "direction": [1, 0, 0]}]})");
  REQUIRE(scene.shapes.size() == 6);
  CHECK(scene.shapes[0].id == "ball");
  CHECK(scene.shapes[0].colour == detent::Colour{0x01, 0x80, 0xff});
  CHECK(std::get<SphereModel>(scene.shapes[0].form).radius.value.text() == "0.1");
  CHECK(std::holds_alternative<AxisAngle>(std::get<ObbModel>(scene.shapes[2].form).rotation));
  CHECK(std::holds_alternative<EulerAngles>(std::get<ObbModel>(scene.shapes[3].form).rotation));
  REQUIRE(scene.camera);
  CHECK(scene.camera->field_of_view.value.text() == "45");
  REQUIRE(scene.rays.size() == 2);
  CHECK(scene.rays[0].max_distance->value.text() == "9");
  CHECK_FALSE(scene.rays[1].id);
}

TEST_CASE("scene: an unexpected key is named with its position and a remedy") {
  CHECK(error_of("[]") == "1:1: the scene is an array; write an object");
  CHECK(error_of("{}") == "1:1: the scene has no \"shapes\"; add it");
  CHECK(error_of("{\"shapes\": 3}") == "1:12: shapes is a number; write an array");
  CHECK(error_of("{\"shapes\": [], \"fog\": 1}") ==
        "1:16: unknown key \"fog\" in the scene; it may have camera, light, shapes, rays");
  CHECK(error_of("{\"shapes\": [], \"light\": [0, 0.0, 0e5]}") ==
        "1:25: light is the zero vector; give it a direction");
  CHECK(error_of("{\"shapes\": [], \"camera\": {\"position\": [0,0,0]}}") ==
        "1:26: the camera has no \"target\"; add it");
  CHECK(error_of("{\"shapes\": [], \"camera\": {\"position\": [0,0,0], \"target\": [0,0,1],\n"
                 "\"field_of_view\": 180}}") ==
        "2:18: field_of_view must lie between 0 and 180 degrees; 60 is usual");
}

TEST_CASE("scene: a bad shape is refused") {
  CHECK(shape_error("{\"center\": [0,0,0]}") == "2:1: shape 0 has no \"type\"; add it");
  CHECK(shape_error(" 7") == "2:2: shape 0 is a number; write an object");
  CHECK(shape_error("{\"type\": \"cone\"}") ==
        "2:10: unknown shape \"cone\"; choose from sphere, aabb, obb, plane, triangle, mesh");
  CHECK(shape_error("{\"type\": \"sphere\", \"centre\": [0,0,0], \"radius\": 1}") ==
        "2:20: unknown key \"centre\" in the sphere; it may have type, id, color, center, radius");
  CHECK(shape_error("{\"type\": \"sphere\", \"center\": [0,0], \"radius\": 1}") ==
        "2:30: center has 2 numbers; write three: [x, y, z]");
  CHECK(shape_error("{\"type\": \"sphere\", \"center\": [0,0,\"1\"], \"radius\": 1}") ==
        "2:35: center is a string; write a number");
  CHECK(shape_error("{\"type\": \"sphere\", \"center\": [0,0,0], \"radius\": -1}") ==
        "2:49: radius is negative; use 0 or more");
  CHECK(shape_error("{\"type\": \"plane\", \"normal\": [0,0,0], \"offset\": 0}") ==
        "2:29: normal is the zero vector; give it a direction");
  CHECK(shape_error("{\"type\": \"sphere\", \"color\": \"red\"}") ==
        "2:29: color \"red\" is not a color; write, for example, \"#c96f4a\"");
  CHECK(shape_error("{\"type\": \"sphere\", \"color\": \"#+12345\"}").find("is not a color") !=
        std::string::npos);
  CHECK(shape_error("{\"type\": \"aabb\", \"id\": 4}") == "2:24: id is a number; write a string");
  CHECK(shape_error("{\"type\": \"obb\", \"center\": [0,0,0], \"half_extents\": [1,1,1],\n"
                    " \"rotation\": {\"euler\": [0,0,0], \"angle\": 1}}") ==
        "3:14: rotation mixes euler with axis; keep one of them");
  CHECK(shape_error("{\"type\": \"plane\", \"id\": \"x\", \"normal\": [0,1,0], \"offset\": 0},\n"
                    "{\"type\": \"plane\", \"id\": \"x\", \"normal\": [0,1,0], \"offset\": 0}") ==
        "3:1: shape id \"x\" is taken by the one on line 2; choose another");
  CHECK(shape_error("{\"type\": \"mesh\", \"file\": \"no.obj\", \"scale\": 0}") ==
        "2:45: scale must be more than 0; 1 keeps the model's size");
}

TEST_CASE("scene: a bad ray is refused") {
  CHECK(ray_error("{\"origin\": [0,0,0], \"direction\": [0,0,0]}") ==
        "2:34: direction is the zero vector; give it a direction");
  CHECK(ray_error("{\"origin\": [0,0,0], \"direction\": [0,0,1], \"max_distance\": -1}") ==
        "2:59: max_distance is negative; use 0 or more");
  CHECK(ray_error("{\"origin\": [0,0,0]}") == "2:1: ray 0 has no \"direction\"; add it");
  CHECK(ray_error("{\"id\": \"a\", \"origin\": [0,0,0], \"direction\": [0,0,1]},\n"
                  "{\"id\": \"a\", \"origin\": [0,0,0], \"direction\": [0,0,1]}") ==
        "3:1: ray id \"a\" is taken by the one on line 2; choose another");
}
