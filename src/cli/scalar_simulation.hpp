// SPDX-License-Identifier: MIT
#pragma once

#include <concepts>
#include <cstddef>
#include <deque>
#include <span>
#include <utility>

#include "detent/draw/box.hpp"
#include "detent/draw/hull.hpp"
#include "detent/draw/round.hpp"
#include "detent/dynamics/dynamics.hpp"
#include "detent/dynamics/snapshot.hpp"
#include "simulation.hpp"

// The implementation of `Simulation`, compiled in a file for each scalar in simulations/.

namespace detent::cli {

template <Scalar S, int N>
class ScalarSimulation : public Simulation, private ScalarReader<S> {
  using Base = ScalarReader<S>;
  using Point3 = std::array<double, 3>;

 public:
  ScalarSimulation(const WorldModel& model, const Move& move)
      : Base(model.file), model_(model), move_(move), world_(settings()) {
    for (std::size_t i = 0; i < 3; ++i) back_[i] = move.by[i].template to<double>().value();
    hulls_.reserve(model_.bodies.size());
    for (const BodyModel& body : model_.bodies) {
      std::visit([&](const auto& form) { add(shape(form, body), body); }, body.form);
    }
    for (const JointModel& joint : model_.joints) add(joint);
  }

  void step() override { world_.step(); }
  [[nodiscard]] std::uint64_t digest() const override { return detent::digest(world_); }
  [[nodiscard]] std::size_t joint_count() const override { return world_.joint_count(); }
  [[nodiscard]] std::size_t asleep() const override {
    std::size_t count = 0;
    for (const auto& body : bodies_) count += world_.is_asleep(body.id);
    return count;
  }

  [[nodiscard]] std::array<double, 3> position(std::size_t body) const override {
    const auto at = world_.position(bodies_[body].id);
    Point3 result{};
    for (int i = 0; i < N; ++i) {
      result[static_cast<std::size_t>(i)] =
          static_cast<double>(at[i]) - back_[static_cast<std::size_t>(i)];
    }
    return result;
  }

  [[nodiscard]] std::string json_lines() const override {
    std::string text;
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
      const BodyId id = bodies_[i].id;
      const auto& name = model_.bodies[i].id;
      text += "{\"body\": " + (name ? '"' + escaped(*name) + '"' : std::to_string(i)) +
              ", \"position\": " + list(to_array(world_.position(id))) +
              ", \"velocity\": " + list(to_array(world_.velocity(id))) +
              ", \"angular_velocity\": " + list(world_.angular_velocity(id)) +
              ", \"asleep\": " + (world_.is_asleep(id) ? "true" : "false") + "}\n";
    }
    return text;
  }

  [[nodiscard]] std::string snapshot() const override {
    const auto bytes = detent::snapshot(world_);
    std::string text(bytes.size(), '\0');
    for (std::size_t i = 0; i < bytes.size(); ++i) text[i] = static_cast<char>(bytes[i]);
    return text;
  }

  void restore(const std::string& file, std::string_view bytes) override {
    switch (detent::restore(world_, std::as_bytes(std::span(bytes)), hulls_)) {
      case Restored::yes:
        return;
      case Restored::no_snapshot:
        throw InputError(file, {}, "is not a snapshot of a world; write one with --snapshot-at");
      case Restored::other_version:
        throw InputError(file, {}, "a snapshot of another version of detent; write it again");
      case Restored::truncated:
      case Restored::corrupted:
        throw InputError(file, {}, "the snapshot is damaged; copy or write it again");
      case Restored::other_scene:
        throw InputError(file, {},
                         "a snapshot of a world with different settings, scalar or dimension; "
                         "resume it with those it was written with");
      default:
        throw InputError(file, {},
                         "a snapshot of a world with different fixed bodies or hulls; resume it "
                         "with the file it was written with");
    }
  }

  [[nodiscard]] std::vector<Facet> facets() const override {
    std::vector<Facet> facets;
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
      const auto origin = position(i);
      const auto rotation = world_.rotation(bodies_[i].id);
      for (const Facet& facet : bodies_[i].facets) {
        Facet moved = facet;
        for (std::size_t c = 0; c < 3; ++c) {
          moved.corners[c] = origin;
          for (int k = 0; k < N; ++k) {
            for (int r = 0; r < N; ++r) {
              moved.corners[c][static_cast<std::size_t>(r)] +=
                  static_cast<double>(rotation.axis(k)[r]) *
                  facet.corners[c][static_cast<std::size_t>(k)];
            }
          }
        }
        facets.push_back(moved);
      }
    }
    return facets;
  }

 private:
  using Joined = detent::World<S, N, Sphere, Capsule, Aabb, Obb, BodyHull, DistanceJoint, BallJoint,
                               HingeJoint, WeldJoint, SliderJoint, WheelJoint>;

  struct Body {
    BodyId id{};
    std::vector<Facet> facets;  // in the frame of the body
  };
  /// Collects the drawing of a shape in the frame of its body: in 2D the triangles from its middle
  /// to its outline, which fill it because it is convex.
  struct Sink {
    std::vector<Facet>& facets;
    Point3 middle{};

    template <class... Corners>
    void add(const Colour& colour, const Corners&... corners) {
      Facet facet{{}, colour};
      std::size_t c = 0;
      const auto corner = [&](const Vec<S, N>& at) {
        for (int i = 0; i < N; ++i) {
          const auto k = static_cast<std::size_t>(i);
          facet.corners[c][k] = static_cast<double>(at[i]) - middle[k];
        }
        ++c;
      };
      (corner(corners), ...);
      facets.push_back(facet);
    }
    void line(const Vec<S, N>& a, const Vec<S, N>& b, const Colour& colour) {
      if constexpr (N == 2) add(colour, a, b);
    }
    void triangle(const Vec<S, N>& a, const Vec<S, N>& b, const Vec<S, N>& c,
                  const Colour& colour) {
      add(colour, a, b, c);
    }
  };

  static std::string escaped(const std::string& name) {
    std::string text;
    for (const char c : one_line(name)) {
      if (c == '"' || c == '\\') text += '\\';
      text += c;
    }
    return text;
  }
  template <std::size_t Size>
  static std::string list(const std::array<S, Size>& numbers) {
    std::string text;
    for (const S& number : numbers) text.append(text.empty() ? "[" : ", ").append(text_of(number));
    return text + ']';
  }

  Vec<S, N> lengths(const Point& point, const std::string& name) const {
    return place(point, name, {});
  }
  Vec<S, N> place(const Point& point, const std::string& name) const {
    return place(point, move_.is_zero() ? name : name + " after the move", move_);
  }
  Vec<S, N> place(const Point& point, const std::string& name, const Move& move) const {
    Vec<S, N> result{};  // by a loop: make_vec is noexcept
    for (std::size_t i = 0; i < std::size_t{N}; ++i) {
      result[static_cast<int>(i)] = this->scalar(point[i].value + move.by[i], point[i].place, name);
    }
    return result;
  }
  Rotation<S, N> turn(const Turn& turn) const {
    if constexpr (N == 2) {
      const auto* const flat = std::get_if<FlatTurn>(&turn);
      return flat ? Rotation<S, 2>::from_angle(this->angle(flat->angle, "rotation"))
                  : Rotation<S, 2>();
    } else {
      return this->rotation(turn);
    }
  }
  void set(S& value, const std::optional<Literal>& number, const std::string& name) const {
    if (number) value = this->length(*number, name);
  }

  WorldSettings<S, N> settings() const {
    WorldSettings<S, N> settings;
    settings.ticks_per_second = model_.ticks_per_second;
    settings.substeps = model_.substeps;
    if (model_.gravity) settings.gravity = lengths(*model_.gravity, "gravity");
    set(settings.margin, model_.margin, "margin");
    set(settings.push_speed, model_.push_speed, "push_speed");
    set(settings.bounce_threshold, model_.bounce_threshold, "bounce_threshold");
    set(settings.sleep_speed, model_.sleep_speed, "sleep_speed");
    return settings;
  }

  Sphere<S, N> shape(const SphereModel& model, const BodyModel&) const {
    return {place(model.center, "center"), this->length(model.radius, "radius")};
  }
  Capsule<S, N> shape(const CapsuleModel& model, const BodyModel&) const {
    return {place(model.a, "a"), place(model.b, "b"), this->length(model.radius, "radius")};
  }
  Aabb<S, N> shape(const AabbModel& model, const BodyModel&) const {
    return {place(model.min, "min"), place(model.max, "max")};
  }
  Obb<S, N> shape(const ObbModel& model, const BodyModel&) const {
    return {place(model.center, "center"), lengths(model.half_extents, "half_extents"),
            turn(model.rotation)};
  }
  BodyHull<S, N> shape(const HullModel& model, const BodyModel& body) {
    auto& points = points_.emplace_back();
    for (const Point& point : model.points) points.push_back(lengths(point, "a point of the hull"));
    const auto id = static_cast<std::uint32_t>(hulls_.size() + 1);
    const auto solid = solid_hull(id, ConvexHull<S, N>{points});
    if (!solid) {
      this->fail(body.place, "the hull is flat or has more than " +
                                 std::to_string(SolidHull<S, N>::capacity) +
                                 " points; give it a volume and fewer points");
    }
    hulls_.push_back(*solid);
    return {&hulls_.back(), place(model.position, "position"), turn(model.rotation)};
  }

  template <class Shape>
  void add(const Shape& shape, const BodyModel& model) {
    BodyOptions<S, N> options;
    options.motion = model.motion;
    options.locked = model.locked;
    options.layers = model.layers.value_or(options.layers);
    options.collides_with = model.collides_with.value_or(options.collides_with);
    options.is_sensor = model.is_sensor;
    options.is_fast = model.is_fast;
    set(options.density, model.density, "density");
    set(options.friction, model.friction, "friction");
    set(options.restitution, model.restitution, "restitution");
    set(options.linear_damping, model.linear_damping, "linear_damping");
    set(options.angular_damping, model.angular_damping, "angular_damping");
    set(options.gravity_scale, model.gravity_scale, "gravity_scale");
    if (model.velocity) options.velocity = lengths(*model.velocity, "velocity");
    if (model.angular_velocity) {
      for (std::size_t i = 0; i < options.angular_velocity.size(); ++i) {
        options.angular_velocity[i] =
            this->length((*model.angular_velocity)[i], "angular_velocity");
      }
    }
    const auto id = world_.add(shape, options);
    if (!id) this->fail(model.place, "the world is full; remove bodies");
    bodies_.push_back({*id, facets_of(shape, model)});
  }

  template <class Shape>
  static std::vector<Facet> facets_of(const Shape& shape, const BodyModel& model) {
    std::vector<Facet> facets;
    Sink sink{facets};
    const auto draw_it = [&](const auto& form) {
      if constexpr (N == 2) {
        draw(sink, form, model.colour);
      } else {
        draw_solid(sink, form, model.colour);
      }
    };
    if constexpr (std::same_as<Shape, BodyHull<S, N>>) {
      for (int i = 0; i < N; ++i) {
        sink.middle[static_cast<std::size_t>(i)] = static_cast<double>(shape.asset->center()[i]);
      }
      draw_it(shape.asset->hull());
    } else {
      draw_it(detail::local_form(shape).shape);
    }
    for (Facet& facet : facets) {
      facet.is_fixed = model.motion == BodyMotion::fixed;
      if (std::same_as<Shape, Sphere<S, N>> && is_dark(facet.corners)) {
        for (auto* const c : {&facet.colour.red, &facet.colour.green, &facet.colour.blue}) {
          *c = static_cast<std::uint8_t>(*c * 3 / 4);
        }
      }
    }
    return facets;
  }
  /// Alternating quarters of a ball, so that its turning shows.
  static bool is_dark(const std::array<Point3, 3>& corners) {
    const auto sum = [&](std::size_t i) { return corners[0][i] + corners[1][i] + corners[2][i]; };
    return (sum(0) > 0) != (sum(1) > 0);
  }

  void add(const JointModel& model) {
    switch (model.kind) {
      case JointKind::distance:
        return add<DistanceJoint<S, N>>(model);
      case JointKind::ball:
        return add<BallJoint<S, N>>(model);
      case JointKind::hinge:
        return add<HingeJoint<S, N>>(model);
      case JointKind::weld:
        return add<WeldJoint<S, N>>(model);
      case JointKind::slider:
        return add<SliderJoint<S, N>>(model);
      case JointKind::wheel:
        return add<WheelJoint<S, N>>(model);
    }
  }

  /// Sets the fields of a kind of joint; the reader has rejected others.
  template <class Joint>
  void add(const JointModel& model) {
    Joint joint;
    joint.a = bodies_[model.a].id;
    joint.b = bodies_[model.b].id;
    joint.anchor_a = world_.local_point(joint.a, place(model.anchor_a, "at"));
    joint.anchor_b = world_.local_point(joint.b, place(model.anchor_b, "at"));
    joint.collide = model.collide;
    set(joint.break_force, model.break_force, "break_force");
    if constexpr (requires { joint.least; }) {
      set(joint.least, model.least, "least");
      set(joint.most, model.most, "most");
    }
    if constexpr (requires { joint.length; }) set(joint.length, model.length, "length");
    if constexpr (requires { joint.frequency; }) {
      set(joint.frequency, model.frequency, "frequency");
      set(joint.damping_ratio, model.damping_ratio, "damping_ratio");
    }
    if constexpr (requires { joint.max_force; }) set(joint.max_force, model.max_force, "max_force");
    if constexpr (requires { joint.frame_a; }) {
      const auto frame = turn(model.frame);
      joint.frame_a = world_.local_frame(joint.a, frame);
      joint.frame_b = world_.local_frame(joint.b, frame);
    }
    if constexpr (requires { joint.lower; }) {
      joint.has_limits = model.limits.has_value();
      if (model.limits) {
        joint.lower = this->length((*model.limits)[0], "limits");
        joint.upper = this->length((*model.limits)[1], "limits");
      }
      set(joint.motor_speed, model.motor_speed, "motor_speed");
    }
    if constexpr (requires { joint.motor_torque; }) {
      set(joint.motor_torque, model.motor_torque, "motor_torque");
    }
    if constexpr (requires { joint.motor_force; }) {
      set(joint.motor_force, model.motor_force, "motor_force");
    }
    if (!world_.add(joint)) this->fail(model.place, "the world has no room for the joint");
  }

  WorldModel model_;
  Move move_;
  Point3 back_{};
  std::deque<std::vector<Vec<S, N>>> points_;
  std::vector<SolidHull<S, N>> hulls_;  // capacity is reserved: bodies refer to them
  Joined world_;
  std::vector<Body> bodies_;
};

template <Scalar S, int N>
std::unique_ptr<Simulation> make_simulation(const WorldModel& model, const Move& move) {
  return std::make_unique<ScalarSimulation<S, N>>(model, move);
}

}  // namespace detent::cli
