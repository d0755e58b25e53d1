// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "decimal.hpp"
#include "detent/draw/sink.hpp"
#include "error.hpp"

namespace detent::cli {

/// A number as written in the file, and its position; only world_builder.hpp converts it to a
/// scalar.
struct Literal {
  Decimal value;
  Place place;
};

using Point = std::array<Literal, 3>;

/// Rotation about `axis`, or about world x, then y, then z; angles in degrees.
struct AxisAngle {
  Point axis;
  Literal angle;
};
struct EulerAngles {
  Point angles;
};
/// In two dimensions.
struct FlatTurn {
  Literal angle;
};
using Turn = std::variant<std::monostate, AxisAngle, EulerAngles, FlatTurn>;

struct SphereModel {
  Point center;
  Literal radius;
};
struct AabbModel {
  Point min;
  Point max;
};
struct ObbModel {
  Point center;
  Point half_extents;
  Turn rotation;
};
struct PlaneModel {
  Point normal;
  Literal offset;
};
struct TriangleModel {
  Point a;
  Point b;
  Point c;
};

/// Vertices are relative to the center of the model's bounding box, already scaled.
struct MeshModel {
  Point position;
  std::vector<std::array<double, 3>> vertices;
  std::vector<std::array<std::uint32_t, 3>> triangles;
};

struct ShapeModel {
  std::optional<std::string> id;
  Colour colour;
  Place place;
  std::variant<SphereModel, AabbModel, ObbModel, PlaneModel, TriangleModel, MeshModel> form;
};

struct RayModel {
  std::optional<std::string> id;
  Place place;
  Point origin;
  Point direction;
  std::optional<Literal> max_distance;
};

struct CameraModel {
  Place place;
  Point position;
  Point target;
  Point up;
  Literal field_of_view;  // vertical, in degrees
};

struct Scene {
  std::string file;
  std::optional<CameraModel> camera;
  Point light;  // from the scene towards the light
  std::vector<ShapeModel> shapes;
  std::vector<RayModel> rays;
};

/// The point with these decimals as coordinates.
[[nodiscard]] Point point_of(const char* x, const char* y, const char* z);

/// The name of a shape or a ray in results: its id, or its number from 0.
[[nodiscard]] std::string name_of(const std::optional<std::string>& id, std::size_t index);

/// The colour of a shape that does not name one.
[[nodiscard]] Colour default_colour(std::size_t index);

}  // namespace detent::cli
