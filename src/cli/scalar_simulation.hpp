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
#include "detent/scene/mesh/owned.hpp"
#include "simulation.hpp"

// The implementation of `Simulation`, compiled in a file for each scalar in simulations/.

namespace detent::cli {

/// A world of all shapes and joints; surfaces are for three dimensions.
template <Scalar S, int N>
struct JoinedWorld {
  using Type = detent::World<S, 3, Sphere, Capsule, Aabb, Obb, BodyHull, BodyCompound, BodyMesh,
                             BodyHeightField, DistanceJoint, BallJoint, HingeJoint, WeldJoint,
                             SliderJoint, WheelJoint, ConeJoint>;
};
template <Scalar S>
struct JoinedWorld<S, 2> {
  using Type =
      detent::World<S, 2, Sphere, Capsule, Aabb, Obb, BodyHull, BodyCompound, DistanceJoint,
                    BallJoint, HingeJoint, WeldJoint, SliderJoint, WheelJoint>;
};

template <Scalar S, int N>
class ScalarSimulation : public Simulation, private ScalarReader<S> {
  using Base = ScalarReader<S>;
  using Point3 = std::array<double, 3>;

 public:
  ScalarSimulation(const WorldModel& model, const Move& move)
      : Base(model.file), model_(model), move_(move), world_(settings()) {
    for (std::size_t i = 0; i < 3; ++i) back_[i] = move.by[i].template to<double>().value();
    // Bodies refer to elements of these lists, so the lists never grow beyond their reserved
    // capacity.
    std::size_t hulls = 0;
    for (const BodyModel& body : model_.bodies) {
      const auto* const compound = std::get_if<CompoundModel>(&body.form);
      hulls += compound == nullptr ? 1 : compound->parts.size();
    }
    hulls_.reserve(hulls);
    compounds_.reserve(model_.bodies.size());
    meshes_.reserve(model_.bodies.size());
    fields_.reserve(model_.bodies.size());
    for (const BodyModel& body : model_.bodies) {
      std::visit([&](const auto& form) { add_form(form, body); }, body.form);
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
    switch (restored(std::as_bytes(std::span(bytes)))) {
      case Restored::yes:
        return;
      case Restored::no_snapshot:
        throw InputError(file, {}, "is not a snapshot of a world; write one with --out");
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
                         "a snapshot of a world with different fixed bodies, hulls, compounds or "
                         "surfaces; resume it with the file it was written with");
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
  Restored restored(std::span<const std::byte> bytes) {
    if constexpr (N == 2) {
      return detent::restore(world_, bytes, hulls_, compounds_);
    } else {
      return detent::restore(world_, bytes, hulls_, compounds_, meshes_, fields_);
    }
  }

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
    return place(point, name, move_);
  }
  Vec<S, N> place(const Point& point, const std::string& name, const Move& move) const {
    const std::string moved = move.is_zero() ? name : name + " after the move";
    Vec<S, N> result{};  // by a loop: make_vec is noexcept
    for (std::size_t i = 0; i < std::size_t{N}; ++i) {
      result[static_cast<int>(i)] =
          this->scalar(point[i].value + move.by[i], point[i].place, moved);
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
    set(settings.hold_distance, model_.hold_distance, "hold_distance");
    return settings;
  }

  /// Shapes of bodies are moved by the offset; those of parts are in the frame of a body, which is
  /// moved.
  Sphere<S, N> shape(const SphereModel& model, const Move& move, Place) const {
    return {place(model.center, "center", move), this->length(model.radius, "radius")};
  }
  Capsule<S, N> shape(const CapsuleModel& model, const Move& move, Place) const {
    return {place(model.a, "a", move), place(model.b, "b", move),
            this->length(model.radius, "radius")};
  }
  Aabb<S, N> shape(const AabbModel& model, const Move& move, Place) const {
    return {place(model.min, "min", move), place(model.max, "max", move)};
  }
  Obb<S, N> shape(const ObbModel& model, const Move& move, Place) const {
    return {place(model.center, "center", move), lengths(model.half_extents, "half_extents"),
            turn(model.rotation)};
  }
  BodyHull<S, N> shape(const HullModel& model, const Move& move, Place at) {
    auto& points = points_.emplace_back();
    for (const Point& point : model.points) points.push_back(lengths(point, "a point of the hull"));
    const auto id = static_cast<std::uint32_t>(hulls_.size() + 1);
    const auto solid = solid_hull(id, ConvexHull<S, N>{points});
    if (!solid) {
      this->fail(at, "the hull is flat or has more than " +
                         std::to_string(SolidHull<S, N>::capacity) +
                         " points; give it a volume and fewer points");
    }
    hulls_.push_back(*solid);
    return {&hulls_.back(), place(model.position, "position", move), turn(model.rotation)};
  }

  template <class Form>
  void add_form(const Form& form, const BodyModel& model) {
    const auto solid = shape(form, move_, model.place);
    add(solid, model, facets_of(solid, model));
  }
  void add_form(const CompoundModel& form, const BodyModel& model) {
    auto& parts = parts_.emplace_back();
    std::vector<std::vector<Facet>> drawn;
    for (const PartModel& part : form.parts) {
      PartOptions<S> options;
      set(options.density, part.density, "density");
      set(options.friction, part.friction, "friction");
      set(options.restitution, part.restitution, "restitution");
      set(options.rolling_resistance, part.rolling_resistance, "rolling_resistance");
      options.is_sensor = part.is_sensor;
      std::visit(
          [&](const auto& plain) {
            const auto solid = shape(plain, Move(), part.place);
            parts.emplace_back(solid, options);
            drawn.push_back(part.is_sensor ? std::vector<Facet>() : facets_of(solid, model));
          },
          part.form);
    }
    const auto id = static_cast<std::uint32_t>(compounds_.size() + 1);
    const auto compound = solid_compound(id, parts);
    if (!compound) this->fail(model.place, "the compound has too many parts; use more bodies");
    compounds_.push_back(*compound);
    std::vector<Facet> facets;
    for (std::size_t i = 0; i < parts.size(); ++i) {
      const auto& part = parts[i];
      for (Facet facet : drawn[i]) {
        for (auto& corner : facet.corners) {
          const auto inner = corner;
          for (int k = 0; k < N; ++k) {
            auto& x = corner[static_cast<std::size_t>(k)];
            x = static_cast<double>(part.place()[k]) - static_cast<double>(compound->center()[k]);
            for (std::size_t j = 0; j < std::size_t{N}; ++j) {
              x += static_cast<double>(part.axes()[j][k]) * inner[j];
            }
          }
        }
        facets.push_back(facet);
      }
    }
    add(BodyCompound<S, N>{&compounds_.back(), place(form.position, "position"),
                           turn(form.rotation)},
        model, facets);
  }
  void add_form(const MeshBodyModel& form, const BodyModel& model) {
    if constexpr (N == 3) {
      std::vector<Vec<S, 3>> vertices;
      for (const Point& vertex : form.vertices) {
        vertices.push_back(lengths(vertex, "a vertex of the mesh"));
      }
      if (form.model) {
        const auto limit = static_cast<double>(largest<S>);
        for (const auto& v : form.model->vertices) {
          auto& vertex = vertices.emplace_back();
          for (int k = 0; k < 3; ++k) {
            const double x = v[static_cast<std::size_t>(k)];
            if (!(x <= limit && x >= -limit)) fail_reach(model, "mesh");
            if constexpr (is_fixed<S>) {
              vertex[k] = S::from_double(x);
            } else {
              vertex[k] = static_cast<S>(x);
            }
          }
        }
      }
      std::vector<Triangle<S, 3>> triangles;
      for (const auto& corners : form.triangles) {
        triangles.push_back({vertices[corners[0]], vertices[corners[1]], vertices[corners[2]]});
      }
      for (const auto& vertex : vertices) check_reach(vertex, model, "mesh");
      if (triangles.size() > most_triangles) {
        this->fail(model.place,
                   "the mesh has more than 1,048,576 triangles; split it into several");
      }
      owned_.emplace_back(triangles);
      const auto id = static_cast<std::uint32_t>(meshes_.size() + 1);
      meshes_.emplace_back(id, owned_.back().view());
      add(BodyMesh<S, 3>{&meshes_.back(), place(form.position, "position"), turn(form.rotation)},
          model, facets_of(triangles, model));
    } else {
      static_cast<void>(form);
      this->fail(model.place, "a mesh is for worlds of three dimensions");
    }
  }
  void add_form(const HeightFieldModel& form, const BodyModel& model) {
    if constexpr (N == 3) {
      auto& heights = heights_.emplace_back();
      for (const Literal& height : form.heights)
        heights.push_back(this->length(height, "a height"));
      const auto field = height_field<S>(
          {this->length(form.corner[0], "corner"), this->length(form.corner[1], "corner")},
          this->length(form.cell, "cell"), form.columns, form.rows, heights);
      if (!field) {
        this->fail(form.cell.place, "the cell is too small or too large for " +
                                        std::string(scalar_name<S>) + "; write 1, for example");
      }
      check_reach(field->bounds.min, model, "height field");
      check_reach(field->bounds.max, model, "height field");
      std::vector<Triangle<S, 3>> triangles;
      visit_within(*field, field->bounds, [&](std::span<const MeshTriangle<S>> some) {
        for (const auto& each : some) triangles.push_back(each.triangle);
        return Walk::go_on;
      });
      if (triangles.size() > most_triangles) {
        this->fail(model.place,
                   "the height field has more than 524,288 cells; split it into several");
      }
      const auto id = static_cast<std::uint32_t>(fields_.size() + 1);
      fields_.emplace_back(id, *field);
      add(BodyHeightField<S, 3>{&fields_.back(), place(form.position, "position")}, model,
          facets_of(triangles, model));
    } else {
      static_cast<void>(form);
      this->fail(model.place, "a height field is for worlds of three dimensions");
    }
  }

  /// The most triangles that contacts of surfaces can index (docs/dynamics.md).
  static constexpr std::size_t most_triangles = std::size_t{1} << 20;
  [[noreturn]] void fail_reach(const BodyModel& model, const std::string& what) const {
    this->fail(model.place, "the " + what + " reaches farther than 512 units from its position; " +
                                "make it smaller or split it into several");
  }
  void check_reach(const Vec<S, N>& point, const BodyModel& model, const std::string& what) const {
    for (int k = 0; k < N && is_fixed<S>; ++k) {
      if (abs(point[k]) > S(512)) fail_reach(model, what);
    }
  }

  template <class Shape>
  void add(const Shape& shape, const BodyModel& model, std::vector<Facet> facets) {
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
    set(options.rolling_resistance, model.rolling_resistance, "rolling_resistance");
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
    bodies_.push_back({*id, std::move(facets)});
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
    if constexpr (requires { shape.front().a; }) {
      for (const auto& triangle : shape)
        sink.triangle(triangle.a, triangle.b, triangle.c, model.colour);
    } else if constexpr (std::same_as<Shape, BodyHull<S, N>>) {
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
      case JointKind::cone:
        if constexpr (N == 3) add<ConeJoint<S, N>>(model);
        return;
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

  /// Sets the fields that this kind of joint has; the reader has rejected others.
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
    if constexpr (requires { joint.angle; }) set(joint.angle, model.angle, "angle");
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
    if constexpr (requires { joint.cone_angle; }) {
      set(joint.cone_angle, model.cone_angle, "cone_angle");
    }
    if constexpr (requires { joint.lower; }) {
      joint.has_limits = model.limits.has_value();
      if (model.limits) {
        joint.lower = this->length((*model.limits)[0], "limits");
        joint.upper = this->length((*model.limits)[1], "limits");
      }
    }
    if constexpr (requires { joint.motor_speed; }) {
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
  std::vector<SolidHull<S, N>> hulls_;
  std::deque<std::vector<BodyPart<S, N>>> parts_;
  std::vector<SolidCompound<S, N>> compounds_;
  std::deque<OwnedMesh<S>> owned_;
  std::vector<MeshAsset<S>> meshes_;
  std::deque<std::vector<S>> heights_;
  std::vector<FieldAsset<S>> fields_;
  typename JoinedWorld<S, N>::Type world_;
  std::vector<Body> bodies_;
};

template <Scalar S, int N>
std::unique_ptr<Simulation> make_simulation(const WorldModel& model, const Move& move) {
  return std::make_unique<ScalarSimulation<S, N>>(model, move);
}

}  // namespace detent::cli
