// SPDX-License-Identifier: MIT
#include <algorithm>
#include <vector>

#include "oracle/crossing_parts.hpp"

namespace detent::oracle {
namespace {

/// {x : normal . (x - point) <= 0}, and whether its boundary contains a face.
template <int N>
struct Facet {
  Vector<N> normal;
  Vector<N> point;
  bool is_face;
};

/// A normal that may be any of several.
template <int N>
struct OneOfNormals final : Normal<N> {
  std::vector<NormalPointer<N>> choices;

  [[nodiscard]] bool allows(const Raw<N>& given) const override {
    return std::any_of(choices.begin(), choices.end(),
                       [&](const auto& choice) { return choice->allows(given); });
  }
  [[nodiscard]] std::string text() const override {
    std::string out = "one of:";
    for (const auto& choice : choices) out += " " + choice->text() + ";";
    return out;
  }
};

/// The half-spaces bounded at `corner` perpendicular to `normal` that contain all points: up to
/// two.
template <int N>
void add_supporting(std::vector<Facet<N>>& facets, const std::vector<Vector<N>>& points,
                    const Vector<N>& normal, const Vector<N>& corner, bool is_face) {
  if (is_zero(normal)) return;
  bool some_above = false, some_below = false;
  for (const auto& point : points) {
    const Integer height = dot(normal, difference(point, corner));
    some_above = some_above || height > 0;
    some_below = some_below || height < 0;
  }
  if (!some_above) facets.push_back({normal, corner, is_face});
  if (!some_below) facets.push_back({negated(normal), corner, is_face});
}

/// The half-spaces whose intersection is the hull of `points`: those supported by any of their
/// lines and planes; for coplanar points (in 2D, collinear ones) also those within the plane. None
/// for collinear points (in 2D, for equal ones).
std::vector<Facet<2>> facets_of(const std::vector<Vector<2>>& points) {
  std::vector<Facet<2>> facets;
  for (const auto& p : points) {
    for (const auto& q : points) {
      const auto e = difference(q, p);
      if (is_zero(e)) continue;
      const bool is_flat = std::all_of(points.begin(), points.end(), [&](const auto& point) {
        return cross(e, difference(point, p)).is_zero();
      });
      add_supporting<2>(facets, points, {-e[1], e[0]}, p, true);
      if (is_flat) add_supporting<2>(facets, points, e, q, false);
    }
  }
  return facets;
}
std::vector<Facet<3>> facets_of(const std::vector<Vector<3>>& points) {
  std::vector<Facet<3>> facets;
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      for (std::size_t k = 0; k < j; ++k) {
        const auto& p = points[i];
        const auto normal = cross(difference(points[j], p), difference(points[k], p));
        if (is_zero(normal)) continue;
        const bool is_flat = std::all_of(points.begin(), points.end(), [&](const auto& point) {
          return dot(normal, difference(point, p)).is_zero();
        });
        add_supporting<3>(facets, points, normal, p, true);
        if (!is_flat) continue;
        for (const auto& a : points) {
          for (const auto& b : points) {
            add_supporting<3>(facets, points, cross(normal, difference(b, a)), a, false);
          }
        }
        return facets;
      }
    }
  }
  return facets;
}

}  // namespace

template <int N>
MaybeCrossing<N> crossing_of(const Line<N>& line, const Cloud<N>& cloud) {
  const auto& points = cloud.points;
  if (points.empty()) return {};
  const auto facets = facets_of(points);
  if (facets.empty()) {  // collinear points, or one
    const auto [first, last] = std::minmax_element(points.begin(), points.end());
    return crossing_of(line, Edge<N>{*first, *last});
  }
  std::vector<HalfSpace> spaces;
  spaces.reserve(facets.size());
  for (const auto& facet : facets) {
    spaces.push_back({dot(facet.normal, difference(line.origin, facet.point)) * line.one,
                      dot(facet.normal, line.direction)});
  }
  const auto inside = span(spaces, line.max);
  if (!inside) return {};
  const auto entered = std::make_shared<OneOfNormals<N>>();
  for (std::size_t i = 0; i < facets.size(); ++i) {
    if (!facets[i].is_face || !spaces[i].entered_at(inside->enter)) continue;
    entered->choices.push_back(normalized<N>(facets[i].normal, line));
  }
  NormalPointer<N> normal = entered;
  if (inside_at_start(spaces) || entered->choices.empty()) normal = against(line);
  return crossing_at<N>(*inside, normal);
}

template MaybeCrossing<2> crossing_of(const Line<2>&, const Cloud<2>&);
template MaybeCrossing<3> crossing_of(const Line<3>&, const Cloud<3>&);

}  // namespace detent::oracle
