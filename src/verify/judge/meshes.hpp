// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "verify/describe_worlds.hpp"
#include "verify/judge/pairs.hpp"
#include "verify/judge/points.hpp"
#include "verify/judge/rays.hpp"

// Surfaces are judged triangle by triangle, exactly: no tree, no grid.

namespace detent::verify::judge {

template <Scalar S>
std::vector<Triangle<S, 3>> triangles_of(const MeshTriangles<S>& mesh) {
  return {mesh.triangles.begin(), mesh.triangles.begin() + mesh.count};
}
/// None when the cell is not positive or the far corner is out of range.
template <Scalar S>
std::vector<Triangle<S, 3>> triangles_of(const FieldSamples<S>& field) {
  const auto x = std::int64_t{field.corner.x.raw()}, z = std::int64_t{field.corner.y.raw()};
  const auto cell = std::int64_t{field.cell.raw()};
  const auto end = std::int64_t{S::max().raw()};
  const auto last_x = x + cell * (field.columns - 1), last_z = z + cell * (field.rows - 1);
  if (cell <= 0 || last_x > end || last_z > end) return {};
  const auto sample = [&](int column, int row) {
    const auto along = [&](std::int64_t start, int count) {
      return S::from_raw(static_cast<typename S::raw_type>(start + count * cell));
    };
    return Vec<S, 3>{along(x, column),
                     field.heights[static_cast<std::size_t>(row * field.columns + column)],
                     along(z, row)};
  };
  std::vector<Triangle<S, 3>> triangles;
  for (int row = 0; row + 1 < field.rows; ++row) {
    for (int column = 0; column + 1 < field.columns; ++column) {
      const auto right = sample(column + 1, row), below = sample(column, row + 1);
      triangles.push_back({sample(column, row), below, right});
      triangles.push_back({right, below, sample(column + 1, row + 1)});
    }
  }
  return triangles;
}

template <class T, std::size_t Room>
Listed<T, Room> listed(std::vector<T> all) {
  std::sort(all.begin(), all.end());
  Listed<T, Room> list;
  list.count = static_cast<std::uint32_t>(all.size());
  std::copy_n(all.begin(), std::min(all.size(), Room), list.first.begin());
  return list;
}

/// Compares all results, sorted, with what the library returned of them: the first, whether there
/// are any, or a list.
template <class T>
std::optional<Wrong> compare_results(const std::vector<T>& all, const std::optional<T>& got) {
  return compare(all.empty() ? std::nullopt : std::optional(all.front()), got);
}
template <class T>
std::optional<Wrong> compare_results(const std::vector<T>& all, bool got) {
  return compare(!all.empty(), got);
}
template <class T, std::size_t Room>
std::optional<Wrong> compare_results(const std::vector<T>& all, const Listed<T, Room>& got) {
  return compare(listed<T, Room>(all), got);
}

/// All hits, in order.
template <Scalar S>
std::vector<MeshHit<S>> hits_of(const Ray<S, 3>& ray,
                                const std::vector<Triangle<S, 3>>& triangles) {
  std::vector<MeshHit<S>> hits;
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const auto expected =
        oracle::expected_raycast(in_raw_units<S>(ray), in_raw_units<S>(triangles[i]));
    if (!expected.hit) continue;
    hits.push_back({clamped<S>(expected.hit->enter), static_cast<std::uint32_t>(i)});
  }
  std::sort(hits.begin(), hits.end());
  return hits;
}

template <Scalar S, class Shape>
std::vector<std::uint32_t> met_by(const Shape& shape,
                                  const std::vector<Triangle<S, 3>>& triangles) {
  std::vector<std::uint32_t> met;
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    if (oracle::meet(in_raw_units<S>(shape), in_raw_units<S>(triangles[i]))) {
      met.push_back(static_cast<std::uint32_t>(i));
    }
  }
  return met;
}

template <Scalar S>
std::optional<MeshNearest<S>> nearest_of(const Vec<S, 3>& point,
                                         const std::vector<Triangle<S, 3>>& triangles) {
  std::optional<MeshNearest<S>> best;
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const auto truth = oracle::nearest(in_raw_units<S>(triangles[i]), in_raw_units<S>(point));
    const auto away = distance_to<S>(truth);
    if (best && best->distance <= away) continue;
    best = {away, static_cast<std::uint32_t>(i),
            clamped<S>(nearest_point<3>(truth, oracle::raw(point)))};
  }
  return best;
}

/// Whether a box contains a triangle or another box, given by corners.
template <Scalar S>
bool holds(const Aabb<S, 3>& box, std::initializer_list<Vec<S, 3>> corners) {
  for (const auto& corner : corners) {
    for (int i = 0; i < 3; ++i) {
      if (corner[i] < box.min[i] || box.max[i] < corner[i]) return false;
    }
  }
  return true;
}

/// Finds a fault in a tree, if there is one: each triangle has to be in one leaf and inside all
/// boxes above it. Many trees are valid; only the digest checks for the exact one.
template <Scalar S>
class TreeInspection {
 public:
  TreeInspection(const Mesh<S>& mesh, const std::vector<Triangle<S, 3>>& triangles)
      : mesh_(mesh), triangles_(triangles), seen_(triangles.size()) {
    if (mesh.tree.nodes.size() > tree_capacity(triangles.size())) fault_ = "too many nodes";
    if (!triangles.empty()) look(0, {mesh.tree.bounds}, 0);
    for (std::size_t i = 0; i < seen_.size(); ++i) {
      if (seen_[i] == 1) continue;
      fault_ = "triangle " + std::to_string(i) + " is in " + std::to_string(seen_[i]) + " leaves";
    }
  }
  [[nodiscard]] const std::optional<std::string>& fault() const { return fault_; }

 private:
  void look(std::size_t place, const std::vector<Aabb<S, 3>>& above, int depth) {
    if (place >= mesh_.tree.nodes.size() || depth == static_tree_depth) {
      fault_ = "no node " + std::to_string(place);
      return;
    }
    const auto& node = mesh_.tree.nodes[place];
    for (std::size_t child = 0; child < node.children; ++child) {
      auto boxes = above;
      boxes.push_back(node.box(child));
      if (node.count[child] == 0) {
        look(node.first[child], boxes, depth + 1);
        continue;
      }
      for (std::size_t i = 0; i < node.count[child]; ++i) {
        look_at(node.first[child] + i, boxes, "node " + std::to_string(place));
      }
    }
  }
  void look_at(std::size_t item, const std::vector<Aabb<S, 3>>& boxes, const std::string& where) {
    if (item >= mesh_.triangles.size() || mesh_.triangles[item].index >= triangles_.size()) {
      fault_ = where + " has triangles that there are not";
      return;
    }
    const auto& [triangle, index] = mesh_.triangles[item];
    ++seen_[index];
    if (!(triangle == triangles_[index])) fault_ = "triangle " + std::to_string(index) + " changed";
    for (const auto& box : boxes) {
      if (holds(box, {triangle.a, triangle.b, triangle.c})) continue;
      fault_ =
          "triangle " + std::to_string(index) + " below " + where + " is not within " + words(box);
    }
  }

  const Mesh<S>& mesh_;
  const std::vector<Triangle<S, 3>>& triangles_;
  std::vector<int> seen_;
  std::optional<std::string> fault_;
};

template <int Row, Scalar S, int N, class Answer>
std::optional<Wrong> judge(const MeshCase<S, N>& c, const Answer& got) {
  const auto triangles = triangles_of(c.mesh);
  if constexpr (Row == 8) {
    const auto mesh = got.view();
    const TreeInspection<S> inspection(mesh, triangles);
    if (!inspection.fault()) return std::nullopt;
    return Wrong{"each triangle in one leaf and within the boxes above it", *inspection.fault()};
  } else if constexpr (Row == 4) {
    return compare_results(met_by(c.sphere, triangles), got);
  } else if constexpr (Row == 5) {
    return compare_results(met_by(c.obb, triangles), got);
  } else if constexpr (Row == 6) {
    return compare_results(met_by(c.segment, triangles), got);
  } else if constexpr (Row == 7) {
    return compare(nearest_of(c.point, triangles), got);
  } else {
    const auto hits = hits_of(c.ray, triangles);
    if constexpr (Row < 3) {
      return compare_results(hits, got);
    } else {
      if (hits.empty()) return compare(Answer(), got);
      const auto& first = triangles[hits.front().index];
      return judge<1>(RayCase<S, N, Triangle<S, N>>{c.ray, first}, got);
    }
  }
}

template <int Row, Scalar S, int N, class Answer>
std::optional<Wrong> judge(const FieldCase<S, N>& c, const Answer& got) {
  const auto triangles = triangles_of(c.field);
  if constexpr (Row == 2) {
    return compare_results(met_by(c.aabb, triangles), got);
  } else if constexpr (Row == 3) {
    return compare(nearest_of(c.point, triangles), got);
  } else {
    return compare_results(hits_of(c.ray, triangles), got);
  }
}

}  // namespace detent::verify::judge
