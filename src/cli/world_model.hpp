// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "detent/dynamics/settings.hpp"
#include "scene.hpp"

namespace detent::cli {

struct CapsuleModel {
  Point a;
  Point b;
  Literal radius;
};
struct HullModel {
  std::vector<Point> points;
  Point position;
  Turn rotation;
};

/// One of the shapes of a compound; missing fields are as in `PartOptions`.
struct PartModel {
  Place place;
  std::variant<SphereModel, CapsuleModel, AabbModel, ObbModel, HullModel> form;
  std::optional<Literal> density, friction, restitution, rolling_resistance;
  bool is_sensor = false;
};
struct CompoundModel {
  std::vector<PartModel> parts;
  Point position;
  Turn rotation;
};

/// Triangles that are written in the file, or those of `model`, whose own position is ignored.
struct MeshBodyModel {
  std::optional<MeshModel> model;
  std::vector<Point> vertices;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  Point position;
  Turn rotation;
};

/// Heights over a grid of the plane of x and z: rows along z, and in a row along x.
struct HeightFieldModel {
  std::array<Literal, 2> corner;
  Literal cell;
  std::uint32_t columns = 0, rows = 0;
  std::vector<Literal> heights;
  Point position;
};

/// A body in a file; missing fields are as in `BodyOptions`.
struct BodyModel {
  std::optional<std::string> id;
  Colour colour;
  Place place;
  std::variant<SphereModel, CapsuleModel, AabbModel, ObbModel, HullModel, CompoundModel,
               MeshBodyModel, HeightFieldModel>
      form;
  BodyMotion motion = BodyMotion::dynamic;
  std::optional<Literal> density, friction, restitution, rolling_resistance, linear_damping,
      angular_damping, gravity_scale;
  std::optional<Point> velocity, angular_velocity;
  std::uint8_t locked = 0;
  std::optional<std::uint32_t> layers, collides_with;
  bool is_sensor = false, is_fast = false;
};

enum class JointKind { distance, ball, cone, hinge, weld, slider, wheel };

/// A joint in a file; missing fields are as in dynamics/joint/kinds.hpp.
struct JointModel {
  JointKind kind{};
  Place place;
  std::size_t a = 0, b = 0;  // bodies
  Point anchor_a, anchor_b;  // in the world
  Turn frame;                // in both bodies, in world coordinates
  bool collide = false;
  std::optional<std::array<Literal, 2>> limits;
  std::optional<Literal> break_force, least, most, length, angle, frequency, damping_ratio,
      max_force, cone_angle, motor_speed, motor_torque, motor_force;
};

/// The side view of a world in two dimensions.
struct FlatCamera {
  Point center;
  Literal height;
};

/// A world of bodies in a JSON file, with its numbers as written there.
struct WorldModel {
  std::string file;
  int dimension = 3;
  int ticks_per_second = 60, substeps = 4;
  std::optional<Point> gravity;
  std::optional<Literal> margin, push_speed, bounce_threshold, sleep_speed, hold_distance;
  std::optional<CameraModel> camera;
  std::optional<FlatCamera> flat_camera;
  Point light;
  std::vector<BodyModel> bodies;
  std::vector<JointModel> joints;
};

/// The world in `content`; `file` is its name in messages. Throws InputError. (docs/tool.md)
[[nodiscard]] WorldModel parse_world(const std::string& file, const std::string& content);

}  // namespace detent::cli
