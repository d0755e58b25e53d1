// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string_view>

namespace detent::bench {

/// How many of a query's inputs are hits, in every fixed scalar: a benchmark with another count
/// would be fast by being wrong.
struct Golden {
  std::string_view query;
  std::size_t ordinary;
  std::size_t small;
};

inline constexpr Golden golden_hits[] = {
    {"raycast/sphere", 2026, 2019},
    {"raycast/aabb", 2101, 1969},
    {"raycast/obb", 2077, 2089},
    {"raycast/plane", 2064, 2072},
    {"raycast/triangle", 2034, 2024},
    {"raycast/capsule", 2039, 2057},
    {"raycast/segment", 0, 0},
    {"raycast/hull", 2041, 2064},
    {"raycast_hit/sphere", 2026, 2019},
    {"raycast_hit/aabb", 2101, 1969},
    {"raycast_hit/obb", 2077, 2089},
    {"raycast_hit/plane", 2064, 2072},
    {"raycast_hit/triangle", 2034, 2024},
    {"raycast_hit/capsule", 2039, 2057},
    {"raycast_hit/segment", 0, 0},
    {"raycast_hit/hull", 2041, 2064},
    {"raycast_interval/sphere", 2026, 2019},
    {"raycast_interval/aabb", 2101, 1969},
    {"raycast_interval/obb", 2077, 2089},
    {"contains/sphere", 2006, 2043},
    {"contains/aabb", 2089, 2013},
    {"contains/obb", 2058, 2079},
    {"contains/plane", 0, 0},
    {"contains/triangle", 0, 0},
    {"contains/capsule", 1927, 2030},
    {"contains/hull", 2077, 2094},
    {"contains/segment", 0, 0},
    {"contains/ray", 0, 0},
    {"closest_point/sphere", 2094, 2034},
    {"closest_point/aabb", 2038, 2013},
    {"closest_point/obb", 2029, 2034},
    {"closest_point/plane", 4096, 4086},
    {"closest_point/triangle", 4096, 4094},
    {"closest_point/capsule", 2027, 2041},
    {"closest_point/hull", 1983, 2050},
    {"closest_point/segment", 4096, 4096},
    {"closest_point/ray", 4096, 4096},
    {"distance/point", 4096, 4096},
    {"distance/sphere", 2094, 2033},
    {"distance/aabb", 2038, 2013},
    {"distance/obb", 2029, 2030},
    {"distance/plane", 4096, 4080},
    {"distance/triangle", 4096, 4093},
    {"distance/capsule", 2027, 2041},
    {"distance/hull", 1983, 2047},
    {"distance/segment", 4096, 4096},
    {"distance/ray", 4096, 4096},
    {"overlaps/sphere_sphere", 2056, 2012},
    {"overlaps/sphere_aabb", 2141, 2055},
    {"overlaps/sphere_obb", 2075, 2045},
    {"overlaps/sphere_plane", 2028, 2069},
    {"overlaps/sphere_triangle", 1983, 2031},
    {"overlaps/sphere_capsule", 1992, 2011},
    {"overlaps/aabb_aabb", 2116, 2093},
    {"overlaps/aabb_obb", 2063, 2035},
    {"overlaps/aabb_plane", 2019, 2079},
    {"overlaps/aabb_triangle", 2076, 2051},
    {"overlaps/obb_obb", 2043, 2083},
    {"overlaps/obb_plane", 2065, 2006},
    {"overlaps/obb_triangle", 2045, 2072},
    {"overlaps/plane_plane", 4096, 4096},
    {"overlaps/plane_triangle", 2082, 2027},
    {"overlaps/triangle_triangle", 2068, 2045},
    {"overlaps/aabb_capsule", 2034, 1997},
    {"overlaps/obb_capsule", 2046, 2090},
    {"overlaps/plane_capsule", 2044, 2075},
    {"overlaps/triangle_capsule", 2029, 1977},
    {"overlaps/capsule_capsule", 2043, 2011},
    {"overlaps/sphere_hull", 2041, 2028},
    {"overlaps/aabb_hull", 2077, 2068},
    {"overlaps/obb_hull", 2063, 2059},
    {"overlaps/plane_hull", 2096, 2058},
    {"overlaps/triangle_hull", 2004, 2078},
    {"overlaps/capsule_hull", 2087, 1962},
    {"overlaps/hull_hull", 2046, 2074},
    {"intersects/sphere", 2051, 2071},
    {"intersects/aabb", 2060, 2057},
    {"intersects/obb", 2020, 2038},
    {"intersects/plane", 2041, 2047},
    {"intersects/triangle", 1928, 1970},
    {"intersects/capsule", 2064, 2082},
    {"intersects/segment", 0, 0},
    {"intersects/hull", 2038, 2071},
    {"2D raycast/sphere", 2014, 2012},
    {"2D raycast/aabb", 2059, 2061},
    {"2D raycast/obb", 2073, 2074},
    {"2D raycast/plane", 2050, 2046},
    {"2D raycast/triangle", 2079, 2085},
    {"2D raycast/capsule", 2042, 2079},
    {"2D overlaps/sphere_sphere", 1984, 2046},
    {"2D overlaps/sphere_aabb", 2037, 2086},
    {"2D overlaps/aabb_aabb", 2016, 2056},
    {"2D overlaps/obb_obb", 1998, 2081},
    {"2D overlaps/triangle_triangle", 2052, 2046},
    {"2D overlaps/capsule_capsule", 2036, 2084},
    {"2D contains/triangle", 2069, 1996},
    {"2D closest_point/obb", 2056, 1994},
    {"2D distance/segment", 4096, 4091},
    {"2D intersects/segment", 2058, 2092},
};

/// The golden counts of a query, or null for one that has none yet.
constexpr const Golden* golden_for(std::string_view query) {
  for (const auto& golden : golden_hits) {
    if (golden.query == query) return &golden;
  }
  return nullptr;
}

}  // namespace detent::bench
