// SPDX-License-Identifier: MIT
#include "oracle/inner_edges.hpp"

#include <algorithm>
#include <utility>
#include <variant>

#include "oracle/cores.hpp"

// The rule of `contacts` (detent/scene/mesh/contact.hpp) for every triangle against every other:
// no search, and heights are measured from the origin.
namespace detent::oracle {
namespace {

Vector<3> normal_of(const Face<3>& face) {
  const auto& [a, b, c] = face.corners;
  return cross(difference(b, a), difference(c, a));
}

Vector<3> unit_of(const Vector<3>& v, const Integer& one) {
  return {unit_component<3>(v, 0, one), unit_component<3>(v, 1, one), unit_component<3>(v, 2, one)};
}

/// The points within a radius of a hull.
struct Round {
  Hull<3> hull;
  Integer radius;
};
Round round_of(const Solid<3>& shape) {
  return std::visit(
      [](const auto& solid) -> Round {
        if constexpr (requires { hull_of(core(solid)); }) {
          return {hull_of(core(solid)), radius(solid)};
        } else {
          return {};
        }
      },
      shape);
}

/// How deep the hull is below the plane across v, times the length of v.
Moment sunken(const Vector<3>& v, const Vector<3>& point, const Hull<3>& hull) {
  Integer lowest = dot(v, hull.over.front());
  for (const auto& corner : hull.over) lowest = std::min(lowest, dot(v, corner));
  return {dot(v, point) * hull.under - lowest, hull.under};
}

/// Whether a plane across an axis separates a shape with points from a face; saves time.
bool are_clearly_apart(const Face<3>& face, const Round& shape) {
  for (const std::size_t axis : {0u, 1u, 2u}) {
    for (const int side : {-1, 1}) {
      Vector<3> v{};
      v[axis] = side;
      bool is_above = true;
      for (const auto& corner : face.corners) {
        const auto depth = sunken(v, corner, shape.hull);
        is_above = is_above && depth.over + shape.radius * depth.under < 0;
      }
      if (is_above) return true;
    }
  }
  return false;
}

/// Whether k is at least `t` divided by the root of `square`.
bool is_at_least(const Integer& k, const Moment& t, const Integer& square) {
  const Integer left = k * k * square * t.under * t.under, right = t.over * t.over;
  if (k < 0) return t.over < 0 && left <= right;
  return t.over <= 0 || left >= right;
}

Integer lift_above(const Vector<3>& v, const Vector<3>& point, const Round& shape) {
  const auto depth = sunken(v, point, shape.hull);
  const Integer square = dot(v, v);
  Integer k = sqrt(Integer(depth.over * depth.over / (square * depth.under * depth.under)));
  if (depth.over < 0) k = -k - 1;
  while (!is_at_least(k, depth, square)) ++k;
  return k + shape.radius;
}

/// Whether p is higher than q along every vector whose components round to those of n.
bool is_higher(const Vector<3>& n, const Vector<3>& p, const Vector<3>& q) {
  const auto d = difference(p, q);
  for (const int x : {-1, 1}) {
    for (const int y : {-1, 1}) {
      for (const int z : {-1, 1}) {
        if (dot(Vector<3>{2 * n[0] + x, 2 * n[1] + y, 2 * n[2] + z}, d) <= 0) return false;
      }
    }
  }
  return true;
}

/// The corners of a face; if it is collapsed, its two ends, perhaps more than once.
std::vector<Vector<3>> outer_corners(const Face<3>& face) {
  const auto& [a, b, c] = face.corners;
  if (!is_zero(normal_of(face))) return {a, b, c};
  const auto square = [](const Vector<3>& p, const Vector<3>& q) -> Integer {
    return dot(difference(p, q), difference(p, q));
  };
  if (square(a, b) >= square(b, c) && square(a, b) >= square(c, a)) return {a, b};
  if (square(b, c) >= square(c, a)) return {b, c};
  return {c, a};
}

/// Whether `other` has every outer corner of `face` that is highest along n, and a higher one.
bool rises_over(const Face<3>& face, const Face<3>& other, const Vector<3>& n) {
  const auto corners = outer_corners(face);
  std::vector<Vector<3>> highest;
  for (const auto& corner : corners) {
    if (std::none_of(corners.begin(), corners.end(),
                     [&](const auto& c) { return is_higher(n, c, corner); })) {
      highest.push_back(corner);
    }
  }
  const auto& others = other.corners;
  return std::all_of(highest.begin(), highest.end(),
                     [&](const auto& corner) {
                       return std::count(others.begin(), others.end(), corner) > 0;
                     }) &&
         std::any_of(others.begin(), others.end(), [&](const auto& c) {
           return std::all_of(highest.begin(), highest.end(),
                              [&](const auto& corner) { return is_higher(n, c, corner); });
         });
}

class Surface {
 public:
  Surface(const std::vector<Face<3>>& triangles, const Solid<3>& shape, bool has_front,
          const Integer& one)
      : triangles_(triangles),
        shape_(shape),
        round_(round_of(shape)),
        has_front_(has_front),
        one_(one) {
    for (const auto& triangle : triangles) parts_.push_back(part_of(triangle));
    for (std::size_t i = 0; i < parts_.size(); ++i) find_risers(i);
  }

  std::vector<TriangleContact> contacts() const {
    std::vector<TriangleContact> result;
    for (std::size_t i = 0; i < parts_.size(); ++i) {
      const auto& part = parts_[i];
      if (!part.push) {
        result.push_back({});
      } else if (part.is_valid) {
        result.push_back({Kind::least, part.push});
      } else if (is_zero(part.across)) {
        result.push_back({Kind::deferred, {}});
      } else {
        const auto own = face_push(i);
        const bool is_deferred =
            std::any_of(part.risers.begin(), part.risers.end(), [&](std::size_t j) {
              const auto& other = parts_[j];
              if (!other.push) return false;
              return other.is_valid || std::pair(face_push(j).depth, j) < std::pair(own.depth, i);
            });
        if (is_deferred) {
          result.push_back({Kind::deferred, {}});
        } else {
          result.push_back({Kind::face, own});
        }
      }
    }
    return result;
  }

 private:
  using Kind = TriangleContact::Kind;

  struct Part {
    Vector<3> across;             // perpendicular to the triangle, to its front
    std::optional<Push<3>> push;  // nothing if the shape does not touch it
    Vector<3> n;                  // the rounded normal of `push`
    bool is_valid = false;
    std::vector<std::size_t> risers;
  };

  Part part_of(const Face<3>& triangle) const {
    Part part{normal_of(triangle), {}, {}, false, {}};
    if (round_.hull.over.empty() || are_clearly_apart(triangle, round_)) return part;
    part.push = least_push(Solid<3>(triangle), shape_);
    if (part.push) part.n = unit_of(part.push->normal, one_);
    return part;
  }

  void find_risers(std::size_t i) {
    auto& part = parts_[i];
    if (!part.push) return;
    for (std::size_t j = 0; j < parts_.size(); ++j) {
      if (is_zero(parts_[j].across)) continue;
      if (rises_over(triangles_[i], triangles_[j], part.n)) part.risers.push_back(j);
    }
    part.is_valid = is_zero(part.across) ? !meets_risers(part) : is_valid(part);
  }

  /// Whether the shape touches a triangle that rises here.
  bool meets_risers(const Part& part) const {
    return std::any_of(part.risers.begin(), part.risers.end(),
                       [&](std::size_t j) { return parts_[j].push.has_value(); });
  }

  bool is_valid(const Part& part) const {
    const auto front = unit_of(part.across, one_);
    if (part.n == front || (!has_front_ && part.n == negated(front))) return true;
    return part.risers.empty() && !(has_front_ && dot(part.n, part.across) <= 0);
  }

  /// The push out of the plane of triangle i, to its front or to the nearer side.
  Push<3> face_push(std::size_t i) const {
    const auto& front = parts_[i].across;
    const auto& corner = triangles_[i].corners[0];
    const auto back = negated(front);
    const bool is_back_nearer =
        !has_front_ && sunken(back, corner, round_.hull) < sunken(front, corner, round_.hull);
    const auto& normal = is_back_nearer ? back : front;
    return {normal, lift_above(normal, corner, round_)};
  }

  const std::vector<Face<3>>& triangles_;
  const Solid<3>& shape_;
  Round round_;
  bool has_front_;
  Integer one_;
  std::vector<Part> parts_;
};

}  // namespace

std::vector<TriangleContact> surface_contacts(const std::vector<Face<3>>& triangles,
                                              const Solid<3>& shape, bool has_front,
                                              const Integer& one) {
  return Surface(triangles, shape, has_front, one).contacts();
}

Integer lift_above(const Vector<3>& normal, const Vector<3>& point, const Solid<3>& shape) {
  return lift_above(normal, point, round_of(shape));
}

}  // namespace detent::oracle
