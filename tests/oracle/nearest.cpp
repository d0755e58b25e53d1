// SPDX-License-Identifier: MIT
#include "oracle/nearest.hpp"

#include <algorithm>

#include "oracle/meet.hpp"
#include "oracle/nearest_parts.hpp"

namespace detent::oracle {
namespace {

template <int N>
using MaybeNearest = std::optional<Nearest<N>>;

template <int N>
MaybeNearest<N> nearest_of(const Ball<N>& ball, const Vector<N>& p) {
  if (ball.radius < 0) return {};
  return Nearest<N>{place_at<N>(p, ball.center), ball.radius, true};
}

template <int N>
MaybeNearest<N> nearest_of(const Box<N>& box, const Vector<N>& p) {
  Nearest<N> result{{p, 1, {}}, 0, true};
  for (std::size_t i = 0; i < p.size(); ++i) {
    if (box.high[i] < box.low[i]) return {};
    const Integer& side = p[i] < box.low[i] ? box.low[i] : box.high[i];
    if (p[i] >= box.low[i] && p[i] <= box.high[i]) continue;
    result.core.over[i] = side;
    result.core.squared.over += (p[i] - side) * (p[i] - side);
  }
  return result;
}

/// In the frame of the box.
template <int N>
MaybeNearest<N> nearest_of(const TurnedBox<N>& box, const Vector<N>& p) {
  const Integer whole = box.one * box.one;
  const auto apart = difference(p, box.center);
  Nearest<N> result{{{}, whole, {0, whole}}, 0, true};
  for (std::size_t j = 0; j < apart.size(); ++j) result.core.over[j] = box.center[j] * whole;
  for (std::size_t i = 0; i < apart.size(); ++i) {
    if (box.half[i] < 0) return {};
    const Integer place = dot(box.axes[i], apart), reach = box.half[i] * box.one;
    const Integer size = place < 0 ? Integer(-place) : place;
    const Integer beyond = size > reach ? Integer(size - reach) : Integer(0);
    const Integer kept = place < 0 ? Integer(place + beyond) : Integer(place - beyond);
    result.core.squared.over += beyond * beyond;
    for (std::size_t j = 0; j < apart.size(); ++j) result.core.over[j] += kept * box.axes[i][j];
  }
  return result;
}

template <int N>
MaybeNearest<N> nearest_of(const Wall<N>& wall, const Vector<N>& p) {
  const auto& n = wall.normal;
  const Integer nn = dot(n, n), short_of = wall.offset * wall.one - dot(n, p);
  Nearest<N> result{{{}, nn, {short_of * short_of, nn}}};
  for (std::size_t i = 0; i < n.size(); ++i) result.core.over[i] = p[i] * nn + n[i] * short_of;
  return result;
}

template <int N>
MaybeNearest<N> nearest_of(const Edge<N>& edge, const Vector<N>& p) {
  std::vector<Place<N>> candidates;
  add_edge<N>(candidates, p, edge.start, edge.end);
  return Nearest<N>{least<N>(candidates)};
}

template <int N>
MaybeNearest<N> nearest_of(const Pill<N>& pill, const Vector<N>& p) {
  if (pill.radius < 0) return {};
  auto result = nearest_of(pill.core, p);
  result->radius = pill.radius;
  result->keeps_inside = true;
  return result;
}

template <int N>
MaybeNearest<N> nearest_of(const Face<N>& face, const Vector<N>& p) {
  const auto& [a, b, c] = face.corners;
  std::vector<Place<N>> candidates;
  add_edge<N>(candidates, p, a, b);
  add_edge<N>(candidates, p, b, c);
  add_edge<N>(candidates, p, c, a);
  add_face<N>(candidates, p, a, b, c);
  return Nearest<N>{least<N>(candidates)};
}

template <int N>
MaybeNearest<N> nearest_of(const Cloud<N>& cloud, const Vector<N>& p) {
  if (cloud.points.empty()) return {};
  if (meet(cloud, Cloud<N>{{p}})) return Nearest<N>{{p, 1, {}}, 0, true};
  return Nearest<N>{nearest_outside<N>(cloud.points, p), 0, true};
}

template <int N>
MaybeNearest<N> nearest_of(const Line<N>& line, const Vector<N>& p) {
  if (line.max < 0) return {};
  std::vector<Place<N>> candidates{place_at<N>(p, line.origin)};
  // In steps of 1 / `one` raw unit, so that the end is on the grid too.
  Vector<N> end, from_end;
  for (std::size_t i = 0; i < end.size(); ++i) {
    end[i] = line.origin[i] * line.one + line.max * line.direction[i];
    from_end[i] = p[i] * line.one - end[i];
  }
  candidates.push_back({end, line.one, {dot(from_end, from_end), line.one * line.one}});
  add_foot<N>(candidates, p, line.origin, line.direction, {line.max, line.one});
  return Nearest<N>{least<N>(candidates)};
}

/// The sign of x - y sqrt(square).
int sign_of_difference(const Integer& x, const Integer& y, const Integer& square) {
  const int x_sign = x.sign(), y_sign = square.is_zero() ? 0 : y.sign();
  if (x_sign != y_sign) return x_sign < y_sign ? -1 : 1;
  const Integer excess = x * x - y * y * square;
  return x_sign < 0 ? -excess.sign() : excess.sign();
}

}  // namespace

std::optional<Nearest<2>> nearest(const Solid<2>& solid, const Vector<2>& point) {
  return std::visit([&](const auto& shape) { return nearest_of(shape, point); }, solid);
}
std::optional<Nearest<3>> nearest(const Solid<3>& solid, const Vector<3>& point) {
  return std::visit([&](const auto& shape) { return nearest_of(shape, point); }, solid);
}
std::optional<Nearest<2>> nearest(const Line<2>& line, const Vector<2>& point) {
  return nearest_of(line, point);
}
std::optional<Nearest<3>> nearest(const Line<3>& line, const Vector<3>& point) {
  return nearest_of(line, point);
}

template <int N>
bool is_rounded(const Integer& given, const Place<N>& core, std::size_t axis, const Integer& radius,
                const Vector<N>& v) {
  const Integer square = dot(v, v);
  const Integer twice = 2 * (given * core.under - core.over[axis]);
  const Integer step = 2 * radius * v[axis] * core.under;
  // twice - under <= step / |v| <= twice + under
  const int below = sign_of_difference(step, twice - core.under, square);
  const int above = sign_of_difference(step, twice + core.under, square);
  if (below == 0 || above == 0) return given % 2 == 0;
  return below > 0 && above < 0;
}

template <int N>
bool is_closest(const Vector<N>& given, const Vector<N>& point,
                const std::optional<Nearest<N>>& truth, const Integer& lowest,
                const Integer& highest) {
  if (!truth || (truth->keeps_inside && is_within(truth, 0))) return given == point;
  const auto& core = truth->core;
  Vector<N> v;
  for (std::size_t i = 0; i < v.size(); ++i) v[i] = point[i] * core.under - core.over[i];
  for (std::size_t i = 0; i < v.size(); ++i) {
    if (!truth->radius.is_zero()) {
      if (!is_rounded<N>(given[i], core, i, truth->radius, v)) return false;
    } else {
      const Integer exact = nearest_quotient(core.over[i], core.under);
      if (given[i] != std::clamp(exact, lowest, highest)) return false;
    }
  }
  return true;
}

template bool is_rounded<2>(const Integer&, const Place<2>&, std::size_t, const Integer&,
                            const Vector<2>&);
template bool is_rounded<3>(const Integer&, const Place<3>&, std::size_t, const Integer&,
                            const Vector<3>&);
template bool is_closest<2>(const Vector<2>&, const Vector<2>&, const std::optional<Nearest<2>>&,
                            const Integer&, const Integer&);
template bool is_closest<3>(const Vector<3>&, const Vector<3>&, const std::optional<Nearest<3>>&,
                            const Integer&, const Integer&);

}  // namespace detent::oracle
