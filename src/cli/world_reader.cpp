// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <map>
#include <utility>

#include "json_fields.hpp"
#include "world_model.hpp"

namespace detent::cli {
namespace {

class WorldReader : private JsonFields {
 public:
  explicit WorldReader(const std::string& file) : JsonFields(file) { world_.file = file; }

  WorldModel read(const JsonNode& root) {
    expect(root, Kind::object, "the world");
    allow_keys(root, "the world", {"dimension", "settings", "camera", "light", "bodies", "joints"});
    if (const JsonNode* const node = find(root, "dimension")) {
      dimension_ = whole(*node, "dimension", 2, 3);
    }
    world_.dimension = dimension_;
    if (const JsonNode* const node = find(root, "settings")) settings(*node);
    world_.light = point_of("1", "2", "1");
    if (const JsonNode* const node = find(root, "light")) {
      if (dimension_ == 2) fail(*node, "a flat world has no light; remove it");
      world_.light = direction(*node, "light");
    }
    if (const JsonNode* const node = find(root, "camera")) {
      if (dimension_ == 2) {
        world_.flat_camera = flat_camera(*node);
      } else {
        world_.camera = camera(*node);
      }
    }
    const JsonNode& bodies = need(root, "bodies", Kind::array, "the world");
    std::map<std::string, Place> names;
    for (const JsonNode& node : bodies.items) {
      world_.bodies.push_back(body(node));
      keep_unique(names, world_.bodies.back().id, node.place, "body");
    }
    if (const JsonNode* const joints = find(root, "joints")) {
      expect(*joints, Kind::array, "joints");
      for (const JsonNode& node : joints->items) world_.joints.push_back(joint(node));
    }
    return std::move(world_);
  }

 private:
  int whole(const JsonNode& node, std::string_view name, int least, int most) const {
    const auto value = number(node, name).value.to<double>();
    const int rounded = value && *value >= least && *value <= most ? static_cast<int>(*value) : -1;
    if (rounded >= 0 && rounded == *value) return rounded;
    fail(node, std::string(name) + " is not a whole number from " + std::to_string(least) + " to " +
                   std::to_string(most) + "; write " + std::to_string(least) + ", for example");
  }
  bool truth(const JsonNode& object, std::string_view key) const {
    const JsonNode* const node = find(object, key);
    if (node == nullptr) return false;
    expect(*node, Kind::boolean, std::string(key));
    return node->text == "true";
  }
  std::optional<Literal> maybe(const JsonNode& object, std::string_view key) const {
    const JsonNode* const node = find(object, key);
    return node ? std::optional(number(*node, key)) : std::nullopt;
  }
  std::optional<Literal> maybe_positive(const JsonNode& object, std::string_view key) const {
    const JsonNode* const node = find(object, key);
    return node ? std::optional(not_negative(*node, key)) : std::nullopt;
  }
  std::optional<Point> maybe_point(const JsonNode& object, std::string_view key) const {
    const JsonNode* const node = find(object, key);
    return node ? std::optional(point(*node, key)) : std::nullopt;
  }

  void settings(const JsonNode& node) {
    const std::string owner = "the settings";
    expect(node, Kind::object, owner);
    allow_keys(node, owner,
               {"ticks_per_second", "substeps", "gravity", "margin", "push_speed",
                "bounce_threshold", "sleep_speed", "hold_distance"});
    if (const JsonNode* const ticks = find(node, "ticks_per_second")) {
      world_.ticks_per_second = whole(*ticks, "ticks_per_second", 1, 1000);
    }
    if (const JsonNode* const substeps = find(node, "substeps")) {
      world_.substeps = whole(*substeps, "substeps", 1, 32);
    }
    world_.gravity = maybe_point(node, "gravity");
    world_.margin = maybe_positive(node, "margin");
    world_.push_speed = maybe_positive(node, "push_speed");
    world_.bounce_threshold = maybe_positive(node, "bounce_threshold");
    world_.sleep_speed = maybe_positive(node, "sleep_speed");
    world_.hold_distance = maybe_positive(node, "hold_distance");
  }

  FlatCamera flat_camera(const JsonNode& node) const {
    const std::string owner = "the camera";
    expect(node, Kind::object, owner);
    allow_keys(node, owner, {"center", "height"});
    FlatCamera camera{point(node, "center", owner), number(node, "height", owner)};
    if (camera.height.value.is_zero() || camera.height.value.is_negative()) {
      throw InputError(file_, camera.height.place, "height must be more than 0; 20 is usual");
    }
    return camera;
  }

  BodyModel body(const JsonNode& node) const {
    const std::string nameless = "body " + std::to_string(world_.bodies.size());
    expect(node, Kind::object, nameless);
    const JsonNode& type = need(node, "type", Kind::string, nameless);
    BodyModel body;
    body.colour = default_colour(world_.bodies.size());
    body.place = node.place;
    body.form = form(node, type);
    const bool is_surface = std::holds_alternative<MeshBodyModel>(body.form) ||
                            std::holds_alternative<HeightFieldModel>(body.form);
    if (is_surface) body.motion = BodyMotion::fixed;
    if (const JsonNode* const id = find(node, "id")) {
      expect(*id, Kind::string, "id");
      body.id = id->text;
    }
    if (const JsonNode* const text = find(node, "color")) body.colour = colour(*text);
    if (const JsonNode* const motion = find(node, "motion")) body.motion = motion_of(*motion);
    if (is_surface && body.motion == BodyMotion::dynamic) {
      fail(*find(node, "motion"), "the " + type.text +
                                      " has no mass and does not fall; write \"fixed\" or "
                                      "\"kinematic\"");
    }
    read_material(node, body);
    body.linear_damping = maybe_positive(node, "linear_damping");
    body.angular_damping = maybe_positive(node, "angular_damping");
    body.gravity_scale = maybe(node, "gravity_scale");
    body.velocity = maybe_point(node, "velocity");
    if (dimension_ == 3) {
      body.angular_velocity = maybe_point(node, "angular_velocity");
    } else if (const auto spin = maybe(node, "angular_velocity")) {
      body.angular_velocity = point_of("0", "0", "0");
      (*body.angular_velocity)[0] = *spin;
    }
    if (const JsonNode* const locked = find(node, "locked")) body.locked = locks(*locked);
    body.layers = maybe_layers(node, "layers");
    body.collides_with = maybe_layers(node, "collides_with");
    body.is_sensor = truth(node, "sensor");
    body.is_fast = truth(node, "fast");
    return body;
  }

  /// The material: of a body, or of each part of a compound.
  template <class Model>
  void read_material(const JsonNode& node, Model& model) const {
    model.density = maybe_positive(node, "density");
    model.friction = maybe_positive(node, "friction");
    model.restitution = maybe_positive(node, "restitution");
    model.rolling_resistance = maybe_positive(node, "rolling_resistance");
  }

  decltype(BodyModel::form) form(const JsonNode& node, const JsonNode& type) const {
    const std::string owner = "the " + type.text;
    const auto allow = [&](const Keys& keys, const Keys& not_of_it) {
      Keys all{"type", "id", "color"};
      all.insert(all.end(), keys.begin(), keys.end());
      for (const std::string_view key :
           {"motion", "density", "friction", "restitution", "rolling_resistance", "linear_damping",
            "angular_damping", "gravity_scale", "velocity", "angular_velocity", "locked", "layers",
            "collides_with", "sensor", "fast"}) {
        const bool is_left_out =
            std::find(not_of_it.begin(), not_of_it.end(), key) != not_of_it.end();
        if (!is_left_out) all.push_back(key);
      }
      allow_keys(node, owner, all);
    };
    const Keys of_parts{"density", "friction", "restitution", "rolling_resistance"};
    const Keys of_masses{"density",       "linear_damping", "angular_damping",
                         "gravity_scale", "locked",         "fast"};
    if (type.text == "compound") {
      for (const std::string_view key : of_parts) {
        if (const JsonNode* const own = find(node, key)) {
          fail(*own, std::string(key) + " is that of each part of a compound; move it there");
        }
      }
      allow({"parts", "position", "rotation"}, of_parts);
      return compound(node, owner);
    }
    if (type.text == "mesh") {
      surface_in_3d(type, owner);
      allow({"file", "scale", "vertices", "triangles", "position", "rotation"}, of_masses);
      return mesh(node, owner);
    }
    if (type.text == "height_field") {
      surface_in_3d(type, owner);
      allow({"corner", "cell", "heights", "position"}, of_masses);
      return height_field(node, owner);
    }
    return solid_form<decltype(BodyModel::form)>(
        node, type, "sphere, capsule, aabb, obb, hull, compound, mesh, height_field",
        [&](const Keys& keys) { allow(keys, {}); });
  }

  /// A shape that can be a part of a compound. `allow(keys)` refuses every key that is neither one
  /// of the shape's nor one of the object that holds the shape.
  template <class Model, class Allow>
  Model solid_form(const JsonNode& node, const JsonNode& type, const std::string& known,
                   const Allow& allow) const {
    const std::string owner = "the " + type.text;
    if (type.text == "sphere") {
      allow({"center", "radius"});
      return SphereModel{point(node, "center", owner),
                         not_negative(need(node, "radius", owner), "radius")};
    }
    if (type.text == "capsule") {
      allow({"a", "b", "radius"});
      return CapsuleModel{point(node, "a", owner), point(node, "b", owner),
                          not_negative(need(node, "radius", owner), "radius")};
    }
    if (type.text == "aabb") {
      allow({"min", "max"});
      return AabbModel{point(node, "min", owner), point(node, "max", owner)};
    }
    if (type.text == "obb") {
      allow({"center", "half_extents", "rotation"});
      return ObbModel{point(node, "center", owner), point(node, "half_extents", owner),
                      rotation(find(node, "rotation"))};
    }
    if (type.text == "plane") fail(type, "a plane cannot be a body; write a large obb");
    if (type.text != "hull") {
      fail(type, "unknown shape " + in_quotes(type.text) + "; choose from " + known);
    }
    allow({"points", "position", "rotation"});
    HullModel hull{{}, {}, rotation(find(node, "rotation"))};
    for (const JsonNode& corner : need(node, "points", Kind::array, owner).items) {
      hull.points.push_back(point(corner, "a point of the hull"));
    }
    hull.position = position_of(node);
    return hull;
  }

  Point position_of(const JsonNode& node) const {
    const JsonNode* const position = find(node, "position");
    return position ? point(*position, "position") : point_of("0", "0", "0");
  }

  CompoundModel compound(const JsonNode& node, const std::string& owner) const {
    CompoundModel compound{{}, position_of(node), rotation(find(node, "rotation"))};
    const JsonNode& parts = need(node, "parts", Kind::array, owner);
    if (parts.items.empty()) fail(parts, "the compound has no parts; give it a shape");
    for (const JsonNode& item : parts.items) {
      const std::string name = "part " + std::to_string(compound.parts.size());
      expect(item, Kind::object, name);
      const JsonNode& type = need(item, "type", Kind::string, name);
      PartModel part;
      part.place = item.place;
      part.form = solid_form<decltype(part.form)>(
          item, type, "sphere, capsule, aabb, obb, hull as parts", [&](const Keys& keys) {
            Keys all{"type"};
            all.insert(all.end(), keys.begin(), keys.end());
            all.insert(all.end(),
                       {"density", "friction", "restitution", "rolling_resistance", "sensor"});
            allow_keys(item, "the " + type.text, all);
          });
      read_material(item, part);
      part.is_sensor = truth(item, "sensor");
      compound.parts.push_back(std::move(part));
    }
    return compound;
  }

  void surface_in_3d(const JsonNode& type, const std::string& owner) const {
    if (dimension_ == 2) {
      fail(type, owner + " is for worlds of three dimensions; build flat ground of other shapes");
    }
  }

  MeshBodyModel mesh(const JsonNode& node, const std::string& owner) const {
    MeshBodyModel mesh;
    mesh.position = position_of(node);
    mesh.rotation = rotation(find(node, "rotation"));
    const JsonNode* const own = find(node, "vertices");
    if (find(node, "file") != nullptr) {
      if (own != nullptr) fail(*own, owner + " mixes file and vertices; keep one of them");
      mesh.model = model_file(node, owner);
      mesh.triangles = mesh.model->triangles;
      return mesh;
    }
    if (own == nullptr) fail(node, owner + " has no file and no vertices; add one of them");
    for (const JsonNode& vertex : need(node, "vertices", Kind::array, owner).items) {
      mesh.vertices.push_back(point(vertex, "a vertex"));
    }
    const JsonNode& triangles = need(node, "triangles", Kind::array, owner);
    if (triangles.items.empty()) fail(triangles, owner + " has no triangles; write some");
    for (const JsonNode& triangle : triangles.items) {
      expect(triangle, Kind::array, "a triangle");
      if (triangle.items.size() != 3) {
        fail(triangle, "a triangle is not three vertices; write [0, 1, 2]");
      }
      auto& corners = mesh.triangles.emplace_back();
      for (std::size_t i = 0; i < 3; ++i) {
        const int last = static_cast<int>(mesh.vertices.size()) - 1;
        if (last < 0) fail(triangle, owner + " has no vertices; write some");
        corners[i] = static_cast<std::uint32_t>(
            whole(triangle.items[i], "a vertex of the triangle", 0, last));
      }
    }
    return mesh;
  }

  HeightFieldModel height_field(const JsonNode& node, const std::string& owner) const {
    HeightFieldModel field;
    const auto zero = point_of("0", "0", "0");
    field.corner = {zero[0], zero[2]};
    if (const JsonNode* const corner = find(node, "corner")) {
      expect(*corner, Kind::array, "corner");
      if (corner->items.size() != 2) fail(*corner, "corner is not two numbers; write [x, z]");
      field.corner = {number(corner->items[0], "corner"), number(corner->items[1], "corner")};
    }
    field.cell = number(need(node, "cell", owner), "cell");
    if (field.cell.value.is_zero() || field.cell.value.is_negative()) {
      throw InputError(file_, field.cell.place, "cell must be more than 0; 1 is usual");
    }
    const JsonNode& rows = need(node, "heights", Kind::array, owner);
    for (const JsonNode& row : rows.items) {
      expect(row, Kind::array, "a row of heights");
      if (field.rows == 0) field.columns = static_cast<std::uint32_t>(row.items.size());
      if (row.items.size() != field.columns) {
        fail(row, "a row has " + std::to_string(row.items.size()) + " heights and the first one " +
                      std::to_string(field.columns) + "; make them equal");
      }
      for (const JsonNode& height : row.items) field.heights.push_back(number(height, "a height"));
      ++field.rows;
    }
    if (field.rows < 2 || field.columns < 2) {
      fail(rows, owner + " has less than two rows or columns of heights; add some");
    }
    field.position = position_of(node);
    return field;
  }

  BodyMotion motion_of(const JsonNode& node) const {
    expect(node, Kind::string, "motion");
    if (node.text == "dynamic") return BodyMotion::dynamic;
    if (node.text == "kinematic") return BodyMotion::kinematic;
    if (node.text == "fixed") return BodyMotion::fixed;
    fail(node,
         "unknown motion " + in_quotes(node.text) + "; choose from dynamic, kinematic, fixed");
  }

  std::optional<std::uint32_t> maybe_layers(const JsonNode& object, std::string_view key) const {
    const JsonNode* const node = find(object, key);
    if (node == nullptr) return std::nullopt;
    expect(*node, Kind::array, std::string(key));
    std::uint32_t layers = 0;
    for (const JsonNode& item : node->items) {
      layers |= std::uint32_t{1} << whole(item, "a layer of " + std::string(key), 0, 31);
    }
    return layers;
  }

  std::uint8_t locks(const JsonNode& node) const {
    constexpr std::array<std::pair<std::string_view, std::uint8_t>, 7> axes{
        {{"x", AxisLock::x},
         {"y", AxisLock::y},
         {"z", AxisLock::z},
         {"turn_x", AxisLock::turn_x},
         {"turn_y", AxisLock::turn_y},
         {"turn_z", AxisLock::turn_z},
         {"turn", AxisLock::turn}}};
    expect(node, Kind::array, "locked");
    unsigned locked = 0;
    for (const JsonNode& item : node.items) {
      expect(item, Kind::string, "an axis of locked");
      unsigned axis = 0;
      for (const auto& [name, lock] : axes) axis |= name == item.text ? lock : 0u;
      if (axis == 0) {
        fail(item, "unknown axis " + in_quotes(item.text) +
                       "; choose from x, y, z, turn_x, turn_y, turn_z, turn");
      }
      locked |= axis;
    }
    return static_cast<std::uint8_t>(locked);
  }

  JointModel joint(const JsonNode& node) const {
    const std::string nameless = "joint " + std::to_string(world_.joints.size());
    expect(node, Kind::object, nameless);
    const JsonNode& type = need(node, "type", Kind::string, nameless);
    const std::string owner = "the " + type.text + " joint";
    JointModel joint;
    joint.kind = kind_of(node, type, owner);
    joint.place = node.place;
    joint.a = end(node, "a", owner);
    joint.b = end(node, "b", owner);
    if (joint.a == joint.b) fail(node, owner + " joins a body to itself; name two bodies");
    if (const JsonNode* const at = find(node, "at")) {
      if (find(node, "at_a") || find(node, "at_b")) {
        fail(*at, owner + " mixes at with at_a and at_b; keep one of them");
      }
      joint.anchor_a = joint.anchor_b = point(*at, "at");
    } else {
      if (!find(node, "at_a") && !find(node, "at_b")) {
        fail(node, owner + " has no anchor; write \"at\", or \"at_a\" and \"at_b\"");
      }
      joint.anchor_a = point(node, "at_a", owner);
      joint.anchor_b = point(node, "at_b", owner);
    }
    joint.frame = rotation(find(node, "rotation"));
    joint.collide = truth(node, "collide");
    if (const JsonNode* const limits = find(node, "limits")) {
      expect(*limits, Kind::array, "limits");
      if (limits->items.size() != 2) fail(*limits, "limits are not two numbers; write [from, to]");
      const auto from = number(limits->items[0], "limits"), to = number(limits->items[1], "limits");
      if ((to.value - from.value).is_negative()) {
        fail(*limits, "limits are not in order; write the lower one first");
      }
      if (joint.kind == JointKind::hinge || joint.kind == JointKind::cone) {
        if (is_beyond_pi(from.value) || is_beyond_pi(to.value)) {
          fail(*limits,
               "limits of " + owner +
                   " are not within -pi and pi; write radians, or omit them for whole turns");
        }
      }
      joint.limits = {from, to};
    }
    joint.break_force = maybe_positive(node, "break_force");
    joint.least = maybe_positive(node, "least");
    joint.most = maybe_positive(node, "most");
    joint.length = maybe(node, "length");
    joint.angle = maybe(node, "angle");
    joint.frequency = maybe_positive(node, "frequency");
    joint.damping_ratio = maybe_positive(node, "damping_ratio");
    joint.max_force = maybe_positive(node, "max_force");
    joint.cone_angle = maybe_positive(node, "cone_angle");
    joint.motor_speed = maybe(node, "motor_speed");
    joint.motor_torque = maybe_positive(node, "motor_torque");
    joint.motor_force = maybe_positive(node, "motor_force");
    return joint;
  }

  /// Half a turn is where the angle of a hinge and the twist of a cone end.
  static bool is_beyond_pi(const Decimal& angle) {
    static const Decimal pi = *Decimal::parse("3.14159265358979323846");
    return (pi - (angle.is_negative() ? -angle : angle)).is_negative();
  }

  /// The kind of a joint, whose other keys are those of that kind.
  JointKind kind_of(const JsonNode& node, const JsonNode& type, const std::string& owner) const {
    const auto allow = [&](const Keys& keys) {
      Keys all{"type", "a", "b", "at", "at_a", "at_b"};
      all.insert(all.end(), keys.begin(), keys.end());
      all.insert(all.end(), {"collide", "break_force"});
      allow_keys(node, owner, all);
    };
    if (type.text == "distance") {
      allow({"least", "most", "length", "frequency", "damping_ratio"});
      return JointKind::distance;
    }
    if (type.text == "ball") {
      allow({"frequency", "damping_ratio", "max_force"});
      return JointKind::ball;
    }
    if (type.text == "cone") {
      if (dimension_ == 2) {
        fail(type, "cones are for three dimensions; use a hinge with limits");
      }
      allow({"rotation", "cone_angle", "limits"});
      return JointKind::cone;
    }
    if (type.text == "hinge") {
      allow({"rotation", "limits", "motor_speed", "motor_torque", "angle", "frequency",
             "damping_ratio"});
      return JointKind::hinge;
    }
    if (type.text == "weld") {
      allow({"rotation", "frequency", "damping_ratio"});
      return JointKind::weld;
    }
    if (type.text == "slider") {
      allow({"rotation", "limits", "motor_speed", "motor_force", "length", "frequency",
             "damping_ratio"});
      return JointKind::slider;
    }
    if (type.text == "wheel") {
      allow({"rotation", "limits", "motor_speed", "motor_torque", "length", "frequency",
             "damping_ratio"});
      return JointKind::wheel;
    }
    fail(type, "unknown joint " + in_quotes(type.text) +
                   "; choose from distance, ball, cone, hinge, weld, slider, wheel");
  }

  /// The body that an end of a joint names.
  std::size_t end(const JsonNode& joint, std::string_view key, const std::string& owner) const {
    const JsonNode& node = need(joint, key, Kind::string, owner);
    for (std::size_t i = 0; i < world_.bodies.size(); ++i) {
      if (world_.bodies[i].id == node.text) return i;
    }
    fail(node, "no body has the id " + in_quotes(node.text) + "; name an existing body");
  }

  WorldModel world_;
};

}  // namespace

WorldModel parse_world(const std::string& file, const std::string& content) {
  return WorldReader(file).read(read_json(file, content));
}

}  // namespace detent::cli
