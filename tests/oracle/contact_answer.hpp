// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <optional>
#include <type_traits>
#include <variant>

#include "detent/query/contact.hpp"
#include "oracle/exact.hpp"
#include "oracle/push.hpp"

namespace detent::oracle {

/// Whether a direction is the unit vector along `v`, each component rounded to nearest.
template <Scalar S, int N>
[[nodiscard]] bool is_unit_along(const Direction<S, N>& given, const Vector<N>& v) {
  for (int i = 0; i < N; ++i) {
    const Integer component = static_cast<std::int64_t>(given[i].raw());
    if (component != unit_component<N>(v, static_cast<std::size_t>(i), one_of<S>())) return false;
  }
  return true;
}

/// Whether a contact is the oracle's: the depth rounded up; the normal rounded to nearest or, for a
/// plane or for a box in its own frame along an axis, as stored.
template <Scalar S, int N>
bool is_contact(const std::optional<Contact<S, N>>& found, const std::optional<Push<N>>& truth) {
  if (!found || !truth) return !found && !truth;
  if (raw(found->depth) != std::min(truth->depth, raw(S::max()))) return false;
  const auto& n = truth->normal;
  if (is_zero(n)) return true;  // for a box in its own frame, if the frame is flat
  return is_unit_along(found->normal, n) || widen(raw(found->normal)) == n;
}

/// A solid that is not a plane, translated by raw units.
template <int N>
Solid<N> moved(Solid<N> solid, const Vector<N>& by) {
  const auto move = [&](auto&... points) {
    const auto move_one = [&](Vector<N>& point) {
      for (std::size_t i = 0; i < by.size(); ++i) point[i] += by[i];
    };
    (move_one(points), ...);
  };
  std::visit(
      [&]<class Shape>(Shape& shape) {
        if constexpr (requires { shape.center; }) {
          move(shape.center);
        } else if constexpr (requires { shape.low; }) {
          move(shape.low, shape.high);
        } else if constexpr (requires { shape.start; }) {
          move(shape.start, shape.end);
        } else if constexpr (requires { shape.core; }) {
          move(shape.core.start, shape.core.end);
        } else if constexpr (requires { shape.corners; }) {
          for (auto& corner : shape.corners) move(corner);
        } else if constexpr (requires { shape.points; }) {
          for (auto& point : shape.points) move(point);
        }
      },
      solid);
  return solid;
}

/// Whether a box's axes are perpendicular up to their rounding.
template <class Shape>
bool is_rigid(const Shape& shape) {
  if constexpr (requires { shape.rotation; }) {
    constexpr int N = sizeof(shape.center) / sizeof(shape.center.x);
    for (int i = 0; i < N; ++i) {
      for (int j = 0; j < i; ++j) {
        const auto cosine = dot(shape.rotation.axis(i), shape.rotation.axis(j));
        const Integer one = Integer(1) << decltype(cosine)::frac;
        if (abs(whole(cosine.raw())) *
                (1 << (direction_component<decltype(shape.center.x)>::frac - 2)) >
            one)
          return false;
      }
    }
  }
  return true;
}

/// Whether the separation of a contact separates, and no shorter translation along its normal does.
template <Scalar S, int N, class A, class B>
bool is_separation(const A& a, const B& b, const Contact<S, N>& found) {
  if (found.depth >= S::max() || !is_rigid(a) || !is_rigid(b)) return true;
  const auto meets_after = [&](const Vector<N>& by) {
    if constexpr (std::is_same_v<B, Plane<S, N>>) {
      return meet(moved(exact(a), negated(by)), exact(b));
    } else {
      return meet(exact(a), moved(exact(b), by));
    }
  };
  if (meets_after(raw(separation(found)))) return false;
  const Integer slack = 2 + (raw(found.depth) >> (direction_component<S>::frac - 3));
  const Integer less = raw(found.depth) - slack;
  if (less <= 0) return true;
  Vector<N> by;
  for (std::size_t i = 0; i < by.size(); ++i) {
    by[i] = less * static_cast<std::int64_t>(found.normal[static_cast<int>(i)].raw()) / one_of<S>();
  }
  return meets_after(by);
}

/// Whether the points of a contact are points of a, and the depth of b there is what they report,
/// within the bound of their docstring. The deepest must be as deep as the contact.
template <Scalar S, int N, class A, class B>
bool has_right_points(const A& a, const B& b, const Contact<S, N>& found) {
  if (found.count == 0) return false;
  if (!is_rigid(a) || !is_rigid(b) || found.depth >= S::max()) return true;
  const Integer one = one_of<S>();
  S deepest(0);
  for (std::size_t k = 0; k < found.count; ++k) {
    const auto& point = found.points[k];
    if (point.depth > deepest) deepest = point.depth;
    auto on_a = raw(point.point), on_b = on_a;
    Integer size =
        std::max({raw(point.depth), raw(detail::radius_of(a)), raw(detail::radius_of(b))});
    for (std::size_t i = 0; i < on_b.size(); ++i) {
      if (on_a[i] <= raw(S::lowest()) || on_a[i] >= raw(S::max())) return true;
      const Integer normal = static_cast<std::int64_t>(found.normal[static_cast<int>(i)].raw());
      on_b[i] -= nearest_quotient(raw(point.depth) * normal, one);
      size = std::max<Integer>(size, abs(on_a[i]));
    }
    const Integer tolerance = 4 + size / (one >> 3);
    if (!is_within(nearest(exact(a), on_a), tolerance)) return false;
    if (!is_within(nearest(exact(b), on_b), tolerance)) return false;
  }
  return deepest == found.depth;
}

/// Whether two contacts are those of the same shapes in both orders.
template <Scalar S, int N>
bool are_mirrored(const Contact<S, N>& found, const Contact<S, N>& back) {
  if (found.normal == back.normal) return true;  // both directions are equally right
  if (found.normal != -back.normal || found.depth != back.depth || found.count != back.count) {
    return false;
  }
  for (std::size_t k = 0; k < found.count; ++k) {
    const auto &p = found.points[k], &q = back.points[k];
    if (p.depth != q.depth || p.feature != (q.feature << 16 | q.feature >> 16)) return false;
  }
  return true;
}

/// Describes what is wrong with the contacts of a and b in both orders; empty if nothing is.
template <Scalar S, int N, class A, class B>
const char* mistake(const A& a, const B& b, const std::optional<Contact<S, N>>& found,
                    const std::optional<Contact<S, N>>& back) {
  if (!is_contact<S, N>(found, least_push(exact(a), exact(b)))) return "contact";
  if (!is_contact<S, N>(back, least_push(exact(b), exact(a)))) return "contact of swapped shapes";
  if (!found) return nullptr;
  if (!is_separation(a, b, *found)) return "separation";
  if (!has_right_points(a, b, *found)) return "points";
  if (!has_right_points(b, a, *back)) return "points of swapped shapes";
  if (!is_rigid(a) || !is_rigid(b) || are_mirrored(*found, *back)) return nullptr;
  return "mirror image";
}

}  // namespace detent::oracle
