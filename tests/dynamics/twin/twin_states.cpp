// SPDX-License-Identifier: MIT
//
// usage: twin_states SCENES NAME TICKS
// Prints the integers of every body and contact of a scene in scenes.txt, at the start and after
// each tick. run.py compares them with its own.

#include <cstdlib>
#include <iostream>
#include <list>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "detent/dynamics/dynamics.hpp"
#include "detent/scene/mesh/owned.hpp"
#include "field_triangles.hpp"
#include "scene_text.hpp"
#include "state_text.hpp"

namespace detent::test {
namespace {

template <int N>
Rotation<S, N> turned(std::istream& in) {
  std::array<std::int32_t, N == 2 ? 2 : 4> raw{};
  for (auto& x : raw) in >> x;
  if constexpr (N == 2) {
    const auto u = Direction<S, 2>::from_raw(raw), v = Direction<S, 2>::from_raw({-raw[1], raw[0]});
    if (!u || !v) fail("not a unit vector");
    return Rotation<S, 2>::from_axes({*u, *v});
  } else {
    const auto q = Quat<S>::from_raw(raw);
    if (!q) fail("not a unit quaternion");
    return to_rotation(*q);
  }
}

template <int N>
struct WorldOf {
  using Type =
      World<S, 3, Sphere, Capsule, Aabb, Obb, BodyHull, BodyCompound, BodyMesh, BodyHeightField,
            DistanceJoint, BallJoint, HingeJoint, WeldJoint, SliderJoint, WheelJoint, ConeJoint>;
};
template <>
struct WorldOf<2> {
  using Type = World<S, 2, Sphere, Capsule, Aabb, Obb, BodyHull, BodyCompound, DistanceJoint,
                     BallJoint, HingeJoint, WeldJoint, SliderJoint, WheelJoint>;
};

/// The world of one scene.
template <int N>
class Stage {
 public:
  void run(const SceneText& scene, int ticks) {
    scene.for_each_line([&](const std::string& word, std::istream& in) { read(word, in); });
    print();
    for (int i = 1; i <= ticks; ++i) {
      scene.for_each_event(i, [&](const std::string& event) { act(event); });
      world_.step();
      print();
    }
  }

 private:
  void read(const std::string& word, std::istream& in) {
    if (word == "set") {
      set(in);
    } else if (word == "points") {
      add_points(in);
    } else if (word == "part") {
      std::string name, kind;
      in >> name >> kind;
      auto& parts = parts_[name];
      with_shape(in, kind, [&](const auto& shape) { add_part(in, parts, shape); });
    } else if (word == "grid") {
      if constexpr (N == 3) add_grid(in);
    } else if (word == "joint") {
      join(in);
    } else if (word == "body") {
      add(in);
    } else if (word != "everyday") {
      fail("unknown: " + word);
    }
  }

  void act(const std::string& event) {
    std::istringstream in(event);
    std::string what;
    std::size_t index = 0;
    in >> what;
    if (what == "gravity") return world_.set_gravity(vector<N>(in));
    in >> index;
    if (what == "end") {
      if (!world_.remove(joints_.at(index))) fail("cannot: " + event);
    } else if (what == "change") {
      change<DistanceJoint<S, N>>(joints_.at(index), in);
      change<BallJoint<S, N>>(joints_.at(index), in);
      change<HingeJoint<S, N>>(joints_.at(index), in);
      change<WeldJoint<S, N>>(joints_.at(index), in);
      change<SliderJoint<S, N>>(joints_.at(index), in);
      change<WheelJoint<S, N>>(joints_.at(index), in);
      if constexpr (N == 3) change<ConeJoint<S, N>>(joints_.at(index), in);
    } else if (what == "place") {
      (void)world_.set_position(ids_.at(index), vector<N>(in));
    } else if (what == "turned") {
      (void)world_.set_rotation(ids_.at(index), turned<N>(in));
    } else if (what == "velocity") {
      world_.set_velocity(ids_.at(index), vector<N>(in));
    } else if (what == "spin") {
      detail::Axial<S, N> spin{};
      for (auto& w : spin) w = number(in);
      world_.set_angular_velocity(ids_.at(index), spin);
    } else if (what == "impulse") {
      const auto impulse = vector<N>(in);
      world_.apply_impulse(ids_.at(index), impulse, vector<N>(in));
    } else if (what == "force") {
      const auto force = vector<N>(in);
      world_.apply_force(ids_.at(index), force, vector<N>(in));
    } else if (what == "push") {
      world_.apply_force(ids_.at(index), vector<N>(in));
    } else if (what == "torque") {
      detail::Axial<S, N> torque{};
      for (auto& t : torque) t = number(in);
      world_.apply_torque(ids_.at(index), torque);
    } else if (what != "remove" || !world_.remove(ids_.at(index))) {
      fail("cannot: " + event);
    }
  }

  void set(std::istream& in) {
    std::string key;
    in >> key;
    if (key == "ticks")
      in >> settings_.ticks_per_second;
    else if (key == "substeps")
      in >> settings_.substeps;
    else if (key == "gravity")
      settings_.gravity = vector<N>(in);
    else if (key == "margin")
      settings_.margin = number(in);
    else if (key == "push")
      settings_.push_speed = number(in);
    else if (key == "bounce")
      settings_.bounce_threshold = number(in);
    else if (key == "sleep")
      settings_.sleep_speed = number(in);
    else if (key == "hold")
      settings_.hold_distance = number(in);
    else
      fail("unknown setting: " + key);
    world_ = decltype(world_)(settings_);
  }

  void add_points(std::istream& in) {
    std::string name;
    in >> name;
    auto& points = points_.emplace_back();
    while (in >> std::ws && in.peek() != EOF) points.push_back(vector<N>(in));
    const auto id = static_cast<std::uint32_t>(points_.size());
    const auto solid = solid_hull(id, ConvexHull<S, N>{points});
    if (!solid) fail("no hull: " + name);
    hulls_.emplace(name, *solid);
  }

  void add_grid(std::istream& in) {
    std::string name;
    in >> name;
    const auto corner = vector<2>(in);
    const auto cell = number(in);
    std::uint32_t columns = 0, rows = 0;
    in >> columns >> rows;
    std::vector<S> some;
    while (in >> std::ws && in.peek() != EOF) some.push_back(number(in));
    auto& heights = heights_.emplace_back();
    for (std::size_t i = 0; i < std::size_t{columns} * rows; ++i) {
      heights.push_back(some.at(i % some.size()));
    }
    const auto field = height_field<S>(corner, cell, columns, rows, heights);
    if (!field) fail("no grid: " + name);
    const auto id = static_cast<std::uint32_t>(heights_.size());
    fields_.emplace(name, FieldAsset<S>(id, *field));
    meshes_.emplace_back(triangles_of(*field));
    assets_.emplace(name, MeshAsset<S>(id, meshes_.back().view()));
  }

  void add(std::istream& in) {
    std::string motion, kind;
    in >> motion >> kind;
    if (kind == "compound") {
      const auto translation = vector<N>(in);
      std::string name;
      in >> name;
      if (compounds_.count(name) == 0) {
        const auto id = static_cast<std::uint32_t>(compounds_.size() + 1);
        compounds_.emplace(name, solid_compound(id, parts_.at(name)).value());
      }
      finish(in, motion, BodyCompound<S, N>{&compounds_.at(name), translation, {}});
    } else if (kind == "mesh" || kind == "field") {
      if constexpr (N == 3) {
        const auto translation = vector<N>(in);
        std::string name;
        in >> name;
        if (kind == "mesh") {
          finish(in, motion, BodyMesh<S, N>{&assets_.at(name), translation, {}});
        } else {
          finish(in, motion, BodyHeightField<S, N>{&fields_.at(name), translation});
        }
      }
    } else {
      with_shape(in, kind, [&](const auto& shape) { finish(in, motion, shape); });
    }
  }

  template <class F>
  void with_shape(std::istream& in, const std::string& kind, const F& f) {
    if (kind == "ball") {
      const auto center = vector<N>(in);
      f(Sphere<S, N>{center, number(in)});
    } else if (kind == "box") {
      const auto center = vector<N>(in);
      f(Obb<S, N>{center, vector<N>(in), {}});
    } else if (kind == "aligned") {
      const auto low = vector<N>(in);
      f(Aabb<S, N>{low, vector<N>(in)});
    } else if (kind == "capsule") {
      const auto a = vector<N>(in), b = vector<N>(in);
      f(Capsule<S, N>{a, b, number(in)});
    } else if (kind == "hull") {
      const auto translation = vector<N>(in);
      std::string name;
      in >> name;
      f(BodyHull<S, N>{&hulls_.at(name), translation, {}});
    } else {
      fail("unknown shape: " + kind);
    }
  }

  /// Reads an option that bodies and parts have; returns false if `key` is none.
  template <class Shape, class Options>
  static bool read_option(const std::string& key, std::istream& in, Shape& shape,
                          Options& options) {
    if (key == "density")
      options.density = number(in);
    else if (key == "friction")
      options.friction = number(in);
    else if (key == "restitution")
      options.restitution = number(in);
    else if (key == "rolling")
      options.rolling_resistance = number(in);
    else if (key == "sensor")
      options.is_sensor = true;
    else if (key != "turned")
      return false;
    else if constexpr (requires { shape.rotation; })
      shape.rotation = turned<N>(in);
    return true;
  }

  template <class Shape>
  void add_part(std::istream& in, std::vector<BodyPart<S, N>>& parts, Shape shape) {
    PartOptions<S> options;
    for (std::string key; in >> key;) {
      if (!read_option(key, in, shape, options)) fail("unknown option: " + key);
    }
    parts.emplace_back(shape, options);
  }

  template <class Shape>
  void finish(std::istream& in, const std::string& motion, Shape shape) {
    BodyOptions<S, N> options;
    if (motion == "fixed") options.motion = BodyMotion::fixed;
    if (motion == "kinematic") options.motion = BodyMotion::kinematic;
    for (std::string key; in >> key;) {
      if (read_option(key, in, shape, options)) continue;
      if (key == "damping")
        options.linear_damping = number(in);
      else if (key == "spin_damping")
        options.angular_damping = number(in);
      else if (key == "velocity")
        options.velocity = vector<N>(in);
      else if (key == "spin")
        for (auto& w : options.angular_velocity) w = number(in);
      else if (key == "gravity_scale")
        options.gravity_scale = number(in);
      else if (key == "locked") {
        unsigned bits = 0;
        in >> bits;
        options.locked = static_cast<std::uint8_t>(bits);
      } else if (key == "fast")
        options.is_fast = true;
      else if (key == "layers")
        in >> options.layers;
      else if (key == "meets")
        in >> options.collides_with;
      else
        fail("unknown option: " + key);
    }
    const auto id = world_.add(shape, options);
    if (!id) fail("the world is full");
    ids_.push_back(*id);
  }

  void join(std::istream& in) {
    std::string kind;
    in >> kind;
    if (kind == "distance")
      join_as<DistanceJoint<S, N>>(in);
    else if (kind == "ball")
      join_as<BallJoint<S, N>>(in);
    else if (kind == "hinge")
      join_as<HingeJoint<S, N>>(in);
    else if (kind == "weld")
      join_as<WeldJoint<S, N>>(in);
    else if (kind == "slider")
      join_as<SliderJoint<S, N>>(in);
    else if (kind == "wheel")
      join_as<WheelJoint<S, N>>(in);
    else if (N == 2 || kind != "cone")
      fail("unknown joint: " + kind);
    else if constexpr (N == 3)
      join_as<ConeJoint<S, N>>(in);
  }
  template <class Joint>
  void join_as(std::istream& in) {
    Joint joint;
    std::size_t a = 0, b = 0;
    in >> a >> b;
    joint.a = ids_.at(a);
    joint.b = ids_.at(b);
    joint.anchor_a = vector<N>(in);
    joint.anchor_b = vector<N>(in);
    read_keys(joint, in);
    const auto id = world_.add(joint);
    if (!id) fail("no room for a joint");
    joints_.push_back(*id);
  }
  template <class Joint>
  void change(const JointId& id, std::istream& in) {
    const auto* joint = world_.template find_joint<Joint>(id);
    if (joint == nullptr) return;
    auto changed = *joint;
    read_keys(changed, in);
    if (!world_.change(id, changed)) fail("cannot change a joint");
  }

  template <class Joint>
  void read_keys(Joint& joint, std::istream& in) {
    for (std::string key; in >> key;) {
      bool known = false;
      const auto when = [&](const char* name, auto read) {
        if (key != name) return;
        known = true;
        read();
      };
      when("collide", [&] { joint.collide = true; });
      when("break", [&] { joint.break_force = number(in); });
      if constexpr (requires { joint.least; }) {
        when("least", [&] { joint.least = number(in); });
        when("most", [&] { joint.most = number(in); });
      }
      if constexpr (requires { joint.length; }) when("length", [&] { joint.length = number(in); });
      if constexpr (requires { joint.angle; }) when("angle", [&] { joint.angle = number(in); });
      if constexpr (requires { joint.frequency; }) {
        when("frequency", [&] { joint.frequency = number(in); });
        when("damping", [&] { joint.damping_ratio = number(in); });
      }
      if constexpr (requires { joint.max_force; })
        when("max_force", [&] { joint.max_force = number(in); });
      if constexpr (requires { joint.frame_a; }) {
        when("frame_a", [&] { joint.frame_a = turned<N>(in); });
        when("frame_b", [&] { joint.frame_b = turned<N>(in); });
      }
      if constexpr (requires { joint.has_limits; }) {
        when("limits", [&] {
          joint.has_limits = true;
          joint.lower = number(in);
          joint.upper = number(in);
        });
      }
      if constexpr (requires { joint.cone_angle; })
        when("cone", [&] { joint.cone_angle = number(in); });
      if constexpr (requires { joint.motor_speed; }) {
        when("motor", [&] {
          joint.motor_speed = number(in);
          if constexpr (requires { joint.motor_torque; })
            joint.motor_torque = number(in);
          else
            joint.motor_force = number(in);
        });
      }
      if (!known) fail("unknown key of a joint: " + key);
    }
  }

  void print() const { print_state<S, N>(world_); }

  WorldSettings<S, N> settings_;
  std::vector<BodyId> ids_;
  std::vector<JointId> joints_;
  std::list<std::vector<Vec<S, N>>> points_;
  std::map<std::string, SolidHull<S, N>> hulls_;
  std::map<std::string, std::vector<BodyPart<S, N>>> parts_;
  std::map<std::string, SolidCompound<S, N>> compounds_;
  std::list<std::vector<S>> heights_;
  std::list<OwnedMesh<S>> meshes_;
  std::map<std::string, FieldAsset<S>> fields_;
  std::map<std::string, MeshAsset<S>> assets_;
  typename WorldOf<N>::Type world_;
};

}  // namespace
}  // namespace detent::test

int main(int count, char** arguments) {
  using namespace detent::test;
  if (count != 4) fail("usage: twin_states SCENES NAME TICKS");
  const auto scene = read_scene(arguments[1], arguments[2]);
  const int ticks = std::atoi(arguments[3]);
  std::ios::sync_with_stdio(false);
  if (scene.dimension == 2)
    Stage<2>().run(scene, ticks);
  else
    Stage<3>().run(scene, ticks);
  return 0;
}
