// SPDX-License-Identifier: MIT
#include "scene_reader.hpp"

#include <charconv>
#include <filesystem>
#include <initializer_list>
#include <map>
#include <string_view>
#include <utility>

#include "file.hpp"
#include "json_reader.hpp"
#include "obj_reader.hpp"

namespace detent::cli {
namespace {

using Kind = JsonNode::Kind;
using Keys = std::initializer_list<std::string_view>;

/// Truncates long names, so that a message stays readable whatever the file contains.
std::string in_quotes(std::string_view name) {
  constexpr std::size_t longest = 40;
  return '"' + std::string(name.substr(0, longest)) + (name.size() > longest ? "...\"" : "\"");
}

std::string listed(Keys keys) {
  std::string text;
  for (const std::string_view key : keys) text.append(text.empty() ? "" : ", ").append(key);
  return text;
}

class SceneReader {
 public:
  explicit SceneReader(const std::string& file) { scene_.file = file; }

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
  [[noreturn]] void fail(const JsonNode& node, const std::string& what) const {
    throw InputError(scene_.file, node.place, what);
  }

  void expect(const JsonNode& node, Kind kind, const std::string& name) const {
    if (node.kind == kind) return;
    fail(node, name + " is " + name_of(node.kind) + "; write " + name_of(kind));
  }

  void allow_keys(const JsonNode& object, const std::string& owner, Keys keys) const {
    for (const JsonNode& member : object.items) {
      bool known = false;
      for (const std::string_view key : keys) known = known || key == member.key;
      if (known) continue;
      throw InputError(scene_.file, member.key_place,
                       "unknown key " + in_quotes(member.key) + " in " + owner + "; it may have " +
                           listed(keys));
    }
  }

  static const JsonNode* find(const JsonNode& object, std::string_view key) {
    for (const JsonNode& member : object.items) {
      if (member.key == key) return &member;
    }
    return nullptr;
  }

  const JsonNode& need(const JsonNode& object, std::string_view key,
                       const std::string& owner) const {
    if (const JsonNode* const member = find(object, key)) return *member;
    fail(object, owner + " has no " + in_quotes(key) + "; add it");
  }

  const JsonNode& need(const JsonNode& object, std::string_view key, Kind kind,
                       const std::string& owner) const {
    const JsonNode& member = need(object, key, owner);
    expect(member, kind, std::string(key));
    return member;
  }

  Literal number(const JsonNode& node, std::string_view name) const {
    expect(node, Kind::number, std::string(name));
    const auto value = Decimal::parse(node.text);
    if (!value) {
      fail(node, std::string(name) + " is longer than " + std::to_string(Decimal::max_length) +
                     " digits; no scalar holds it, use a shorter number");
    }
    return {*value, node.place};
  }

  Literal number(const JsonNode& object, std::string_view key, const std::string& owner) const {
    return number(need(object, key, owner), key);
  }

  Literal not_negative(const JsonNode& node, std::string_view name) const {
    Literal value = number(node, name);
    if (value.value.is_negative()) fail(node, std::string(name) + " is negative; use 0 or more");
    return value;
  }

  Point point(const JsonNode& node, std::string_view name) const {
    expect(node, Kind::array, std::string(name));
    if (node.items.size() != 3) {
      fail(node, std::string(name) + " has " + std::to_string(node.items.size()) +
                     " numbers; write three: [x, y, z]");
    }
    return {number(node.items[0], name), number(node.items[1], name), number(node.items[2], name)};
  }

  Point point(const JsonNode& object, std::string_view key, const std::string& owner) const {
    return point(need(object, key, owner), key);
  }

  Point direction(const JsonNode& node, std::string_view name) const {
    Point vector = point(node, name);
    if (vector[0].value.is_zero() && vector[1].value.is_zero() && vector[2].value.is_zero()) {
      fail(node, std::string(name) + " is the zero vector; give it a direction");
    }
    return vector;
  }

  Point direction(const JsonNode& object, std::string_view key, const std::string& owner) const {
    return direction(need(object, key, owner), key);
  }

  CameraModel camera(const JsonNode& node) const {
    const std::string owner = "the camera";
    expect(node, Kind::object, owner);
    allow_keys(node, owner, {"position", "target", "up", "field_of_view"});
    CameraModel camera{node.place,
                       point(node, "position", owner),
                       point(node, "target", owner),
                       point_of("0", "1", "0"),
                       {Decimal::parse("60").value(), node.place}};
    if (const JsonNode* const up = find(node, "up")) camera.up = direction(*up, "up");
    if (const JsonNode* const angle = find(node, "field_of_view")) {
      camera.field_of_view = number(*angle, "field_of_view");
      const auto degrees = camera.field_of_view.value.to<double>();
      if (!degrees || *degrees <= 0 || *degrees >= 180) {
        fail(*angle, "field_of_view must lie between 0 and 180 degrees; 60 is usual");
      }
    }
    return camera;
  }

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
                     "; there are sphere, aabb, obb, plane, triangle, mesh");
    }
    return shape;
  }

  Turn rotation(const JsonNode* node) const {
    if (!node) return {};
    const std::string owner = "the rotation";
    expect(*node, Kind::object, owner);
    allow_keys(*node, owner, {"axis", "angle", "euler"});
    if (const JsonNode* const euler = find(*node, "euler")) {
      if (node->items.size() > 1) fail(*node, "rotation mixes euler with axis; keep one of them");
      return EulerAngles{point(*euler, "euler")};
    }
    return AxisAngle{direction(*node, "axis", owner), number(*node, "angle", owner)};
  }

  MeshModel mesh(const JsonNode& node, const std::string& owner) const {
    const JsonNode& file = need(node, "file", Kind::string, owner);
    if (file.text.empty()) fail(file, "file is empty; name a model in OBJ");
    if (file.text.find('\0') != std::string::npos) {
      fail(file, "file contains a zero byte, which file names cannot; remove it");
    }
    std::optional<double> scale;
    if (const JsonNode* const text = find(node, "scale")) {
      scale = number(*text, "scale").value.to<double>();
      if (!scale || *scale <= 0) fail(*text, "scale must be more than 0; 1 keeps the model's size");
    }
    const auto path = std::filesystem::path(scene_.file).parent_path() / file.text;
    MeshModel mesh = read_obj(path.string(), scale);
    const JsonNode* const position = find(node, "position");
    mesh.position = position ? point(*position, "position") : point_of("0", "0", "0");
    return mesh;
  }

  Colour colour(const JsonNode& node) const {
    expect(node, Kind::string, "color");
    unsigned value = 0;
    const char* const begin = node.text.data();
    const char* const end = begin + node.text.size();
    bool valid = node.text.size() == 7 && node.text.front() == '#';
    if (valid) {
      const auto [stop, error] = std::from_chars(begin + 1, end, value, 16);
      valid = error == std::errc() && stop == end;
    }
    if (!valid)
      fail(node,
           "color " + in_quotes(node.text) + " is not a color; write, for example, \"#c96f4a\"");
    return {static_cast<std::uint8_t>(value >> 16), static_cast<std::uint8_t>((value >> 8) & 0xff),
            static_cast<std::uint8_t>(value & 0xff)};
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

  void keep_unique(std::map<std::string, Place>& names, const std::optional<std::string>& id,
                   Place place, const char* what) const {
    if (!id) return;
    const auto [first, inserted] = names.try_emplace(*id, place);
    if (inserted) return;
    throw InputError(scene_.file, place,
                     std::string(what) + " id " + in_quotes(*id) + " is taken by the one on line " +
                         std::to_string(first->second.line) + "; choose another");
  }

  Scene scene_;
};

}  // namespace

Scene parse_scene(const std::string& file, const std::string& content) {
  return SceneReader(file).read(read_json(file, content));
}

Scene read_scene(const std::string& file) { return parse_scene(file, read_file(file)); }

}  // namespace detent::cli
