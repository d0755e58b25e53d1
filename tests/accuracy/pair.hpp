// SPDX-License-Identifier: MIT
#pragma once

#include "accuracy/asking.hpp"

namespace detent::accuracy {

template <class Kind>
Query ray_query(std::string name, int cost, bool has_angles = true) {
  return {"raycast", std::move(name), cost,
          [has_angles](const Rung& rung) { return rung.angle <= 0 || has_angles; }, ask_all<Kind>};
}
template <class Kind>
Query cast_query(std::string name, int cost) {
  return {"cast", std::move(name), cost, [](const Rung&) { return true; }, ask_all<Kind>};
}

template <class Kind>
Query pair_query(std::string kind, std::string name, int cost) {
  return {std::move(kind), std::move(name), cost,
          [](const Rung& rung) {
            return rung.ladder != Ladder::distance && (rung.angle <= 0 || Kind::has_angle);
          },
          ask_all<Kind>};
}

/// `cost` divides the number of test cases where the exact result is slow to compute.
template <class Kind>
Query overlap_query(std::string name, int cost) {
  return pair_query<Kind>("overlaps", std::move(name), cost);
}
template <class Kind>
Query closest_points_query(std::string name, int cost) {
  return pair_query<Kind>("closest_points", std::move(name), cost);
}
template <class Kind>
Query segment_query(std::string name, int cost) {
  return pair_query<Kind>("intersects", std::move(name), cost);
}

// A row for each shape of a list.

template <int N>
std::string row_name(const std::string& query, const std::string& shapes) {
  return query + "/" + shapes + (N == 2 ? "_2d" : "");
}
template <int N, class... Shape>
void add_raycasts_at(std::vector<Query>& queries, kind::List<Shape...>) {
  (queries.push_back(ray_query<Raycast<Shape, NoBaseline, N>>(row_name<N>("raycast", Shape::name),
                                                              Shape::ray_cost)),
   ...);
}
template <int N, class... Shape>
void add_segments_at(std::vector<Query>& queries, kind::List<Shape...>) {
  (queries.push_back(segment_query<Overlap<kind::Segment, Shape, N>>(
       row_name<N>("intersects", Shape::name), Shape::segment_cost)),
   ...);
}
template <int N, class A, class B>
void add_overlap(std::vector<Query>& queries) {
  queries.push_back(overlap_query<Overlap<A, B, N>>(
      row_name<N>("overlaps", std::string(A::name) + "_" + B::name), kind::overlap_cost<A, B>()));
}
/// A with each shape after it.
template <int N, class A, class First, class... Rest>
void add_overlaps_after(std::vector<Query>& queries, kind::List<First, Rest...>) {
  if constexpr (std::is_same_v<A, First>) {
    (add_overlap<N, A, Rest>(queries), ...);
  } else {
    add_overlaps_after<N, A>(queries, kind::List<Rest...>());
  }
}
/// A with itself and each shape after it.
template <int N, class A>
void add_overlaps_from(std::vector<Query>& queries) {
  add_overlap<N, A, A>(queries);
  add_overlaps_after<N, A>(queries, kind::Solids());
}
/// Each shape with B.
template <int N, class B, class... Shape>
void add_overlaps_with(std::vector<Query>& queries, kind::List<Shape...>) {
  (add_overlap<N, Shape, B>(queries), ...);
}

}  // namespace detent::accuracy
