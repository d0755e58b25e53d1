// SPDX-License-Identifier: MIT
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
                "bounce_threshold", "sleep_speed"});
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
    if (const JsonNode* const id = find(node, "id")) {
      expect(*id, Kind::string, "id");
      body.id = id->text;
    }
    if (const JsonNode* const text = find(node, "color")) body.colour = colour(*text);
    if (const JsonNode* const motion = find(node, "motion")) body.motion = motion_of(*motion);
    body.density = maybe_positive(node, "density");
    body.friction = maybe_positive(node, "friction");
    body.restitution = maybe_positive(node, "restitution");
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

  decltype(BodyModel::form) form(const JsonNode& node, const JsonNode& type) const {
    const std::string owner = "the " + type.text;
    const auto allow = [&](const Keys& keys) {
      Keys all{"type", "id", "color"};
      all.insert(all.end(), keys.begin(), keys.end());
      all.insert(all.end(), {"motion", "density", "friction", "restitution", "linear_damping",
                             "angular_damping", "gravity_scale", "velocity", "angular_velocity",
                             "locked", "layers", "collides_with", "sensor", "fast"});
      allow_keys(node, owner, all);
    };
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
    if (type.text != "hull") {
      fail(type, "unknown shape " + in_quotes(type.text) +
                     "; choose from sphere, capsule, aabb, obb, hull");
    }
    allow({"points", "position", "rotation"});
    HullModel hull{{}, point_of("0", "0", "0"), rotation(find(node, "rotation"))};
    for (const JsonNode& corner : need(node, "points", Kind::array, owner).items) {
      hull.points.push_back(point(corner, "a point of the hull"));
    }
    if (const JsonNode* const position = find(node, "position")) {
      hull.position = point(*position, "position");
    }
    return hull;
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
      joint.anchor_a = point(node, "at_a", owner);
      joint.anchor_b = point(node, "at_b", owner);
    }
    joint.frame = rotation(find(node, "rotation"));
    joint.collide = truth(node, "collide");
    if (const JsonNode* const limits = find(node, "limits")) {
      expect(*limits, Kind::array, "limits");
      if (limits->items.size() != 2) fail(*limits, "limits are not two numbers; write [from, to]");
      joint.limits = {number(limits->items[0], "limits"), number(limits->items[1], "limits")};
    }
    joint.break_force = maybe_positive(node, "break_force");
    joint.least = maybe_positive(node, "least");
    joint.most = maybe_positive(node, "most");
    joint.length = maybe(node, "length");
    joint.frequency = maybe_positive(node, "frequency");
    joint.damping_ratio = maybe_positive(node, "damping_ratio");
    joint.max_force = maybe_positive(node, "max_force");
    joint.motor_speed = maybe(node, "motor_speed");
    joint.motor_torque = maybe_positive(node, "motor_torque");
    joint.motor_force = maybe_positive(node, "motor_force");
    return joint;
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
    if (type.text == "hinge") {
      allow({"rotation", "limits", "motor_speed", "motor_torque"});
      return JointKind::hinge;
    }
    if (type.text == "weld") {
      allow({"rotation"});
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
                   "; choose from distance, ball, hinge, weld, slider, wheel");
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
