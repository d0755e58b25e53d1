// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <string>
#include <utility>

#include "camera.hpp"
#include "scalar_reader.hpp"
#include "scene.hpp"
#include "world.hpp"

namespace detent::cli {

/// The offset of a scene before its numbers become scalars; exact decimals, 0 for none.
struct Move {
  std::array<Decimal, 3> by;

  [[nodiscard]] bool is_zero() const {
    return by[0].is_zero() && by[1].is_zero() && by[2].is_zero();
  }
};

/// Converts the numbers of a scene to a scalar, each rounded once; throws InputError when one is
/// out of the scalar's range.
template <Scalar S>
class WorldBuilder : private ScalarReader<S> {
  using Base = ScalarReader<S>;
  using Base::angle, Base::direction, Base::fail, Base::length, Base::lengths, Base::rotation,
      Base::scalar, Base::vector;

 public:
  WorldBuilder(const Scene& scene, const Move& move)
      : Base(scene.file), scene_(scene), move_(move) {}

  [[nodiscard]] std::vector<typename World<S>::Shape> shapes() const {
    std::vector<typename World<S>::Shape> shapes;
    shapes.reserve(scene_.shapes.size());
    for (const ShapeModel& model : scene_.shapes) {
      std::visit([&](const auto& form) { shapes.emplace_back(shape(form, model)); }, model.form);
    }
    return shapes;
  }
  [[nodiscard]] World<S> world() const { return World<S>(shapes()); }

  [[nodiscard]] std::vector<Ray<S, 3>> rays() const {
    std::vector<Ray<S, 3>> rays;
    rays.reserve(scene_.rays.size());
    for (const RayModel& model : scene_.rays) {
      Ray<S, 3> ray{position(model.origin, "origin"), direction(model.direction)};
      if (model.max_distance) ray.max_distance = length(*model.max_distance, "max_distance");
      rays.push_back(ray);
    }
    return rays;
  }

  [[nodiscard]] Camera<S> camera() const {
    if (!scene_.camera) {
      fail({}, "the scene has no \"camera\"; add one with a position and a target");
    }
    const CameraModel& model = *scene_.camera;
    // The view is computed from the decimals, before positions are rounded.
    Point view;
    for (std::size_t i = 0; i < 3; ++i) {
      view[i].value = model.target[i].value - model.position[i].value;
    }
    const auto forward = detent::direction_of<S>(vector(view));
    if (!forward) fail(model.place, "position and target are the same point; move one of them");
    const auto right = detent::direction_of<S>(cross(forward->vec(), vector(model.up)));
    if (!right) fail(model.place, "the camera looks along its up vector; choose another up");
    const Decimal degrees = model.field_of_view.value;
    const Decimal half = (degrees + degrees + degrees + degrees + degrees).scaled(-1);
    return Camera<S>(position(model.position, "position"), *forward, *right,
                     angle({half, model.field_of_view.place}, "field_of_view"));
  }

  /// The region around the camera's target, with its distance as the reach.
  [[nodiscard]] DrawRegion<S, 3> region() const {
    const auto target = position(scene_.camera->target, "target");
    return {target, detent::length<S>(target - position(scene_.camera->position, "position"))};
  }

  [[nodiscard]] Direction<S, 3> light() const { return direction(scene_.light); }

 private:
  Vec<S, 3> position(const Point& point, const std::string& name) const {
    const std::string what = move_.is_zero() ? name : name + " after the move";
    const auto moved = [&](std::size_t i) {
      return scalar(point[i].value + move_.by[i], point[i].place, what);
    };
    return {moved(0), moved(1), moved(2)};
  }

  Sphere<S, 3> shape(const SphereModel& model, const ShapeModel&) const {
    return {position(model.center, "center"), length(model.radius, "radius")};
  }

  Aabb<S, 3> shape(const AabbModel& model, const ShapeModel&) const {
    return {position(model.min, "min"), position(model.max, "max")};
  }

  Obb<S, 3> shape(const ObbModel& model, const ShapeModel&) const {
    return {position(model.center, "center"), lengths(model.half_extents, "half_extents"),
            rotation(model.rotation)};
  }

  Plane<S, 3> shape(const PlaneModel& model, const ShapeModel&) const {
    const Direction<S, 3> normal = direction(model.normal);
    const S offset = length(model.offset, "offset");
    if (move_.is_zero()) return {normal, offset};
    const auto by = [&](std::size_t i) {
      return scalar(move_.by[i], model.offset.place, "--offset");
    };
    const auto moved = offset + dot(normal, Vec<S, 3>{by(0), by(1), by(2)});
    if (moved > largest<S> || moved < -largest<S>) {
      fail(model.offset.place, "offset of the moved plane is out of range for " +
                                   std::string(scalar_name<S>) + " (" + range_of<S>() +
                                   "); move it less far or use a wider scalar");
    }
    return {normal, nearest_to<S>(moved)};
  }

  Triangle<S, 3> shape(const TriangleModel& model, const ShapeModel&) const {
    return {position(model.a, "a"), position(model.b, "b"), position(model.c, "c")};
  }

  OwnedMesh<S> shape(const MeshModel& model, const ShapeModel& owner) const {
    std::array<double, 3> middle{};
    for (std::size_t i = 0; i < 3; ++i) {
      middle[i] = (model.position[i].value + move_.by[i]).to<double>().value_or(1e300);
    }
    const auto limit = static_cast<double>(largest<S>);
    const auto coordinate = [&](double relative, std::size_t i) {
      const double value = middle[i] + relative;
      if (!(value <= limit && value >= -limit)) {
        fail(owner.place, "the mesh is partly out of the range of " + std::string(scalar_name<S>) +
                              " (" + range_of<S>() + "); scale or place it differently");
      }
      if constexpr (is_fixed<S>) {
        return S::from_double(value);
      } else {
        return static_cast<S>(value);
      }
    };
    std::vector<Vec<S, 3>> vertices;
    vertices.reserve(model.vertices.size());
    for (const auto& v : model.vertices) {
      vertices.push_back({coordinate(v[0], 0), coordinate(v[1], 1), coordinate(v[2], 2)});
    }
    return OwnedMesh<S>::from_faces(vertices, model.triangles).value();
  }

  const Scene& scene_;
  const Move& move_;
};

}  // namespace detent::cli
