// SPDX-License-Identifier: MIT
#pragma once

#include "bench/question.hpp"

namespace detent::bench {

// The measured queries. Each line ends with its golden counts of hits.

template <Scalar S, int N>
using Point = Vec<S, N>;

inline constexpr auto ask_raycast = [](const auto& ray, const auto& shape) {
  return raycast(as_shape(ray), as_shape(shape));
};
inline constexpr auto ask_raycast_hit = [](const auto& ray, const auto& shape) {
  return raycast_hit(as_shape(ray), as_shape(shape));
};
inline constexpr auto ask_raycast_interval = [](const auto& ray, const auto& shape) {
  return raycast_interval(as_shape(ray), as_shape(shape));
};
inline constexpr auto ask_contains = [](const auto& shape, const auto& point) {
  return contains(as_shape(shape), as_shape(point));
};
inline constexpr auto ask_closest_point = [](const auto& shape, const auto& point) {
  return closest_point(as_shape(shape), as_shape(point));
};
inline constexpr auto ask_distance = [](const auto& shape, const auto& point) {
  return distance(as_shape(shape), as_shape(point));
};
inline constexpr auto ask_overlaps = [](const auto& a, const auto& b) {
  return overlaps(as_shape(a), as_shape(b));
};
inline constexpr auto ask_intersects = [](const auto& segment, const auto& shape) {
  return intersects(as_shape(segment), as_shape(shape));
};

template <class Visit, class Ask = decltype(ask_raycast)>
void visit_solid_raycasts(const Visit& visit, const Ask& ask = ask_raycast) {
  visit(query<Ray, Sphere>("raycast/sphere", ask, {2026, 2019}));
  visit(query<Ray, Aabb>("raycast/aabb", ask, {2101, 1969}));
  visit(query<Ray, Obb>("raycast/obb", ask, {2077, 2089}));
  visit(query<Ray, Plane>("raycast/plane", ask, {2064, 2072}));
  visit(query<Ray, Triangle>("raycast/triangle", ask, {2034, 2024}));
  visit(query<Ray, Capsule>("raycast/capsule", ask, {2039, 2057}));
}
template <class Visit>
void visit_raycasts(const Visit& visit) {
  visit_solid_raycasts(visit);
  visit(query<Ray, Segment>("raycast/segment", ask_raycast, {0, 0}));
  visit(query<Ray, Rock>("raycast/hull", ask_raycast, {2041, 2064}));
}

// With normals, and both ends.
template <class Visit>
void visit_raycast_hits(const Visit& visit) {
  visit(query<Ray, Sphere>("raycast_hit/sphere", ask_raycast_hit, {2026, 2019}));
  visit(query<Ray, Aabb>("raycast_hit/aabb", ask_raycast_hit, {2101, 1969}));
  visit(query<Ray, Obb>("raycast_hit/obb", ask_raycast_hit, {2077, 2089}));
  visit(query<Ray, Plane>("raycast_hit/plane", ask_raycast_hit, {2064, 2072}));
  visit(query<Ray, Triangle>("raycast_hit/triangle", ask_raycast_hit, {2034, 2024}));
  visit(query<Ray, Capsule>("raycast_hit/capsule", ask_raycast_hit, {2039, 2057}));
  visit(query<Ray, Segment>("raycast_hit/segment", ask_raycast_hit, {0, 0}));
  visit(query<Ray, Rock>("raycast_hit/hull", ask_raycast_hit, {2041, 2064}));
  visit(query<Ray, Sphere>("raycast_interval/sphere", ask_raycast_interval, {2026, 2019}));
  visit(query<Ray, Aabb>("raycast_interval/aabb", ask_raycast_interval, {2101, 1969}));
  visit(query<Ray, Obb>("raycast_interval/obb", ask_raycast_interval, {2077, 2089}));
}

template <class Visit>
void visit_contains(const Visit& visit) {
  visit(query<Sphere, Point>("contains/sphere", ask_contains, {2006, 2043}));
  visit(query<Aabb, Point>("contains/aabb", ask_contains, {2089, 2013}));
  visit(query<Obb, Point>("contains/obb", ask_contains, {2058, 2079}));
  visit(query<Plane, Point>("contains/plane", ask_contains, {0, 0}));
  visit(query<Triangle, Point>("contains/triangle", ask_contains, {0, 0}));
  visit(query<Capsule, Point>("contains/capsule", ask_contains, {1927, 2030}));
  visit(query<Rock, Point>("contains/hull", ask_contains, {2077, 2094}));
  visit(query<Segment, Point>("contains/segment", ask_contains, {0, 0}));
  visit(query<Ray, Point>("contains/ray", ask_contains, {0, 0}));
}

template <class Visit>
void visit_closest_points(const Visit& visit) {
  visit(query<Sphere, Point>("closest_point/sphere", ask_closest_point, {2094, 2034}));
  visit(query<Aabb, Point>("closest_point/aabb", ask_closest_point, {2038, 2013}));
  visit(query<Obb, Point>("closest_point/obb", ask_closest_point, {2029, 2034}));
  visit(query<Plane, Point>("closest_point/plane", ask_closest_point, {4096, 4086}));
  visit(query<Triangle, Point>("closest_point/triangle", ask_closest_point, {4096, 4094}));
  visit(query<Capsule, Point>("closest_point/capsule", ask_closest_point, {2027, 2041}));
  visit(query<Rock, Point>("closest_point/hull", ask_closest_point, {1983, 2050}));
  visit(query<Segment, Point>("closest_point/segment", ask_closest_point, {4096, 4096}));
  visit(query<Ray, Point>("closest_point/ray", ask_closest_point, {4096, 4096}));
}

template <class Visit>
void visit_distances(const Visit& visit) {
  visit(query<Point, Point>("distance/point", ask_distance, {4096, 4096}));
  visit(query<Sphere, Point>("distance/sphere", ask_distance, {2094, 2033}));
  visit(query<Aabb, Point>("distance/aabb", ask_distance, {2038, 2013}));
  visit(query<Obb, Point>("distance/obb", ask_distance, {2029, 2030}));
  visit(query<Plane, Point>("distance/plane", ask_distance, {4096, 4080}));
  visit(query<Triangle, Point>("distance/triangle", ask_distance, {4096, 4093}));
  visit(query<Capsule, Point>("distance/capsule", ask_distance, {2027, 2041}));
  visit(query<Rock, Point>("distance/hull", ask_distance, {1983, 2047}));
  visit(query<Segment, Point>("distance/segment", ask_distance, {4096, 4096}));
  visit(query<Ray, Point>("distance/ray", ask_distance, {4096, 4096}));
}

template <class Visit, class Ask = decltype(ask_overlaps)>
void visit_sphere_overlaps(const Visit& visit, const Ask& ask = ask_overlaps) {
  visit(query<Sphere, Sphere>("overlaps/sphere_sphere", ask, {2056, 2012}));
  visit(query<Sphere, Aabb>("overlaps/sphere_aabb", ask, {2141, 2055}));
  visit(query<Sphere, Obb>("overlaps/sphere_obb", ask, {2075, 2045}));
  visit(query<Sphere, Plane>("overlaps/sphere_plane", ask, {2028, 2069}));
  visit(query<Sphere, Triangle>("overlaps/sphere_triangle", ask, {1983, 2031}));
  visit(query<Sphere, Capsule>("overlaps/sphere_capsule", ask, {1992, 2011}));
}

template <class Visit, class Ask = decltype(ask_overlaps)>
void visit_box_overlaps(const Visit& visit, const Ask& ask = ask_overlaps) {
  visit(query<Aabb, Aabb>("overlaps/aabb_aabb", ask, {2116, 2093}));
  visit(query<Aabb, Obb>("overlaps/aabb_obb", ask, {2063, 2035}));
  visit(query<Aabb, Plane>("overlaps/aabb_plane", ask, {2019, 2079}));
  visit(query<Aabb, Triangle>("overlaps/aabb_triangle", ask, {2076, 2051}));
  visit(query<Aabb, Capsule>("overlaps/aabb_capsule", ask, {2034, 1997}));
  visit(query<Obb, Obb>("overlaps/obb_obb", ask, {2043, 2083}));
  visit(query<Obb, Plane>("overlaps/obb_plane", ask, {2065, 2006}));
  visit(query<Obb, Triangle>("overlaps/obb_triangle", ask, {2045, 2072}));
  visit(query<Obb, Capsule>("overlaps/obb_capsule", ask, {2046, 2090}));
}

template <class Visit, class Ask = decltype(ask_overlaps)>
void visit_other_overlaps(const Visit& visit, const Ask& ask = ask_overlaps) {
  visit(query<Plane, Plane>("overlaps/plane_plane", ask, {4096, 4096}));
  visit(query<Plane, Triangle>("overlaps/plane_triangle", ask, {2082, 2027}));
  visit(query<Plane, Capsule>("overlaps/plane_capsule", ask, {2044, 2075}));
  visit(query<Triangle, Triangle>("overlaps/triangle_triangle", ask, {2068, 2045}));
  visit(query<Triangle, Capsule>("overlaps/triangle_capsule", ask, {2029, 1977}));
  visit(query<Capsule, Capsule>("overlaps/capsule_capsule", ask, {2043, 2011}));
}

template <class Visit>
void visit_hulls(const Visit& visit) {
  visit(query<Sphere, Rock>("overlaps/sphere_hull", ask_overlaps, {2041, 2028}));
  visit(query<Aabb, Rock>("overlaps/aabb_hull", ask_overlaps, {2077, 2068}));
  visit(query<Obb, Rock>("overlaps/obb_hull", ask_overlaps, {2063, 2059}));
  visit(query<Plane, Rock>("overlaps/plane_hull", ask_overlaps, {2096, 2058}));
  visit(query<Triangle, Rock>("overlaps/triangle_hull", ask_overlaps, {2004, 2078}));
  visit(query<Capsule, Rock>("overlaps/capsule_hull", ask_overlaps, {2087, 1962}));
  visit(query<Rock, Rock>("overlaps/hull_hull", ask_overlaps, {2046, 2074}));
  visit(query<Segment, Rock>("intersects/hull", ask_intersects, {2038, 2071}));
}

// Circles, rectangles, lines and triangles in 2D.
template <class Visit>
void visit_planar(const Visit& visit) {
  visit(query<Ray, Sphere, 2>("2D raycast/sphere", ask_raycast, {2014, 2012}));
  visit(query<Ray, Aabb, 2>("2D raycast/aabb", ask_raycast, {2059, 2061}));
  visit(query<Ray, Obb, 2>("2D raycast/obb", ask_raycast, {2073, 2074}));
  visit(query<Ray, Plane, 2>("2D raycast/plane", ask_raycast, {2050, 2046}));
  visit(query<Ray, Triangle, 2>("2D raycast/triangle", ask_raycast, {2079, 2085}));
  visit(query<Ray, Capsule, 2>("2D raycast/capsule", ask_raycast, {2042, 2079}));
  visit(query<Sphere, Sphere, 2>("2D overlaps/sphere_sphere", ask_overlaps, {1984, 2046}));
  visit(query<Sphere, Aabb, 2>("2D overlaps/sphere_aabb", ask_overlaps, {2037, 2086}));
  visit(query<Aabb, Aabb, 2>("2D overlaps/aabb_aabb", ask_overlaps, {2016, 2056}));
  visit(query<Obb, Obb, 2>("2D overlaps/obb_obb", ask_overlaps, {1998, 2081}));
  visit(query<Triangle, Triangle, 2>("2D overlaps/triangle_triangle", ask_overlaps, {2052, 2046}));
  visit(query<Capsule, Capsule, 2>("2D overlaps/capsule_capsule", ask_overlaps, {2036, 2084}));
  visit(query<Triangle, Point, 2>("2D contains/triangle", ask_contains, {2069, 1996}));
  visit(query<Obb, Point, 2>("2D closest_point/obb", ask_closest_point, {2056, 1994}));
  visit(query<Segment, Point, 2>("2D distance/segment", ask_distance, {4096, 4091}));
  visit(query<Segment, Segment, 2>("2D intersects/segment", ask_intersects, {2058, 2092}));
}

template <class Visit>
void visit_intersects(const Visit& visit) {
  visit(query<Segment, Sphere>("intersects/sphere", ask_intersects, {2051, 2071}));
  visit(query<Segment, Aabb>("intersects/aabb", ask_intersects, {2060, 2057}));
  visit(query<Segment, Obb>("intersects/obb", ask_intersects, {2020, 2038}));
  visit(query<Segment, Plane>("intersects/plane", ask_intersects, {2041, 2047}));
  visit(query<Segment, Triangle>("intersects/triangle", ask_intersects, {1928, 1970}));
  visit(query<Segment, Capsule>("intersects/capsule", ask_intersects, {2064, 2082}));
  visit(query<Segment, Segment>("intersects/segment", ask_intersects, {0, 0}));
}

// Cameras.

inline constexpr auto ask_pick_ray = [](const auto& view, const auto& at) {
  if constexpr (requires { at.column; }) {
    return pick_ray(view.camera, view.screen, at.column, at.row);
  } else {
    return pick_ray(view.camera, at.x, at.y);
  }
};
inline constexpr auto ask_project = [](const auto& view, const auto& point) {
  return project(view.camera, point);
};
inline constexpr auto ask_project_to_pixel = [](const auto& view, const auto& point) {
  return project(view.camera, view.screen, point);
};

template <class Visit>
void visit_cameras(const Visit& visit) {
  visit(query<View, Spot>("pick_ray/screen", ask_pick_ray, {4096, 4096}));
  visit(query<View, Pixel>("pick_ray/pixel", ask_pick_ray, {4096, 4096}));
  visit(query<View, Point>("project/screen", ask_project, {2060, 2115}));
  visit(query<View, Point>("project/pixel", ask_project_to_pixel, {2060, 2115}));
}

/// The number of shapes that make pairs: the columns of the tables of pairs.
inline constexpr int column_count = 8;

/// Calls `visit` with the shape of a column.
template <int Column, class Visit>
void with_shape(const Visit& visit) {
  if constexpr (Column == 0) {
    visit.template operator()<Sphere>();
  } else if constexpr (Column == 1) {
    visit.template operator()<Aabb>();
  } else if constexpr (Column == 2) {
    visit.template operator()<Obb>();
  } else if constexpr (Column == 3) {
    visit.template operator()<Capsule>();
  } else if constexpr (Column == 4) {
    visit.template operator()<Triangle>();
  } else if constexpr (Column == 5) {
    visit.template operator()<Rock>();
  } else if constexpr (Column == 6) {
    visit.template operator()<Segment>();
  } else if constexpr (Column == 7) {
    visit.template operator()<Plane>();
  }
}

}  // namespace detent::bench
