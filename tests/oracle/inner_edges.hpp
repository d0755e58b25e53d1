// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "oracle/push.hpp"
#include "oracle/solid.hpp"

namespace detent::oracle {

/// What becomes of a triangle of a surface that a shape may touch.
struct TriangleContact {
  enum class Kind { apart, deferred, least, face };
  Kind kind = Kind::apart;
  /// The least translation off the triangle, or the least along its normal; nothing for the others.
  std::optional<Push<3>> push;
};

/// The contacts of a shape with the triangles of a surface, in order. With `has_front` triangles
/// have one side. Normals are rounded to steps of 1 / one before they are compared.
[[nodiscard]] std::vector<TriangleContact> surface_contacts(const std::vector<Face<3>>& triangles,
                                                            const Solid<3>& shape, bool has_front,
                                                            const Integer& one);

/// The depth of the least translation along `normal` that lifts a shape above the plane through
/// `point`, rounded up; negative if the shape is above the plane.
[[nodiscard]] Integer lift_above(const Vector<3>& normal, const Vector<3>& point,
                                 const Solid<3>& shape);

}  // namespace detent::oracle
