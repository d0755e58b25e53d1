// SPDX-License-Identifier: MIT
#include "scene_reader.hpp"

#include <map>
#include <string_view>
#include <utility>

#include "file.hpp"
#include "json_fields.hpp"

namespace detent::cli {
namespace {

using Kind = JsonNode::Kind;

class SceneReader : private JsonFields {
 public:
  explicit SceneReader(const std::string& file) : JsonFields(file) { scene_.file = file; }

  Scene read(const JsonNode& root) {
    expect(root, Kind::object, "the scene");
    allow_keys(root, "the scene", {"camera", "light", "shapes", "rays"});
    const JsonNode* const light = find(root, "light");
    scene_.light = light ? direction(*light, "light") : point_of("1", "2", "1");
    if (const JsonNode* const node = find(root, "camera")) scene_.camera = camera(*node);

    std::map<std::string, Place> names;
    const JsonNode& shapes = need(root, "shapes", Kind::array, "the scene");
    for (const JsonNode& node : shapes.items) {
      scene_.shapes.push_back(shape(node, scene_.shapes.size()));
      keep_unique(names, scene_.shapes.back().id, node.place, "shape");
    }
    names.clear();
    if (const JsonNode* const rays = find(root, "rays")) {
      expect(*rays, Kind::array, "rays");
      for (const JsonNode& node : rays->items) {
        scene_.rays.push_back(ray(node));
        keep_unique(names, scene_.rays.back().id, node.place, "ray");
      }
    }
    return std::move(scene_);
  }

 private:
  ShapeModel shape(const JsonNode& node, std::size_t index) const {
    expect(node, Kind::object, "shape " + std::to_string(index));
    const JsonNode& type = need(node, "type", Kind::string, "shape " + std::to_string(index));
    ShapeModel shape{{}, default_colour(index), node.place, {}};
    if (const JsonNode* const id = find(node, "id")) {
      expect(*id, Kind::string, "id");
      shape.id = id->text;
    }
    if (const JsonNode* const text = find(node, "color")) shape.colour = colour(*text);

    const std::string owner = "the " + type.text;
    if (type.text == "sphere") {
      allow_keys(node, owner, {"type", "id", "color", "center", "radius"});
      shape.form = SphereModel{point(node, "center", owner),
                               not_negative(need(node, "radius", owner), "radius")};
    } else if (type.text == "aabb") {
      allow_keys(node, owner, {"type", "id", "color", "min", "max"});
      shape.form = AabbModel{point(node, "min", owner), point(node, "max", owner)};
    } else if (type.text == "obb") {
      allow_keys(node, owner, {"type", "id", "color", "center", "half_extents", "rotation"});
      shape.form = ObbModel{point(node, "center", owner), point(node, "half_extents", owner),
                            rotation(find(node, "rotation"))};
    } else if (type.text == "plane") {
      allow_keys(node, owner, {"type", "id", "color", "normal", "offset"});
      shape.form = PlaneModel{direction(node, "normal", owner), number(node, "offset", owner)};
    } else if (type.text == "triangle") {
      allow_keys(node, owner, {"type", "id", "color", "a", "b", "c"});
      shape.form =
          TriangleModel{point(node, "a", owner), point(node, "b", owner), point(node, "c", owner)};
    } else if (type.text == "mesh") {
      allow_keys(node, owner, {"type", "id", "color", "file", "scale", "position"});
      shape.form = mesh(node, owner);
    } else {
      fail(type, "unknown shape " + in_quotes(type.text) +
                     "; choose from sphere, aabb, obb, plane, triangle, mesh");
    }
    return shape;
  }

  MeshModel mesh(const JsonNode& node, const std::string& owner) const {
    MeshModel mesh = model_file(node, owner);
    const JsonNode* const position = find(node, "position");
    mesh.position = position ? point(*position, "position") : point_of("0", "0", "0");
    return mesh;
  }

  RayModel ray(const JsonNode& node) const {
    const std::string owner = "ray " + std::to_string(scene_.rays.size());
    expect(node, Kind::object, owner);
    allow_keys(node, owner, {"id", "origin", "direction", "max_distance"});
    RayModel ray{
        {}, node.place, point(node, "origin", owner), direction(node, "direction", owner), {}};
    if (const JsonNode* const id = find(node, "id")) {
      expect(*id, Kind::string, "id");
      ray.id = id->text;
    }
    if (const JsonNode* const distance = find(node, "max_distance")) {
      ray.max_distance = not_negative(*distance, "max_distance");
    }
    return ray;
  }

  Scene scene_;
};

}  // namespace

Scene parse_scene(const std::string& file, const std::string& content) {
  return SceneReader(file).read(read_json(file, content));
}

Scene read_scene(const std::string& file) { return parse_scene(file, read_file(file)); }

}  // namespace detent::cli
