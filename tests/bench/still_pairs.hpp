// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <string_view>

#include "bench/pairs.hpp"

namespace detent::bench {

/// The queries of two shapes that do not move.
enum class PairQuery { distance, closest_points, contact };
inline constexpr std::array<std::string_view, 3> pair_query_names{"distance", "closest_points",
                                                                  "contact"};
inline constexpr std::array<std::string_view, column_count> column_names{
    "sphere", "aabb", "obb", "capsule", "triangle", "hull", "segment", "plane"};

/// The golden counts of a query: row i has those of the i-th shape with itself and the shapes after
/// it.
struct PairCounts {
  std::size_t ordinary[column_count][column_count];
  std::size_t small[column_count][column_count];
};
template <PairQuery What, int N>
inline constexpr PairCounts pair_counts{};
template <>
inline constexpr PairCounts pair_counts<PairQuery::distance, 3>{
    {
        {2055, 2063, 2040, 2078, 2081, 2066, 2038, 2086},
        {1977, 2037, 1997, 2004, 2032, 2041, 2026},
        {2060, 2055, 2124, 2100, 2031, 2039},
        {2036, 2015, 2081, 2037, 2071},
        {1994, 2025, 2158, 2079},
        {2043, 2013, 2019},
        {4096, 2046},
        {0},
    },
    {
        {2032, 2009, 2040, 2041, 2010, 2043, 2088, 2061},
        {2032, 1976, 2065, 2053, 2043, 2035, 2035},
        {2025, 2034, 2006, 2013, 2018, 2056},
        {2061, 2034, 2072, 2013, 2057},
        {2032, 2065, 2169, 2032},
        {1985, 2059, 2047},
        {4093, 2061},
        {0},
    },
};
template <>
inline constexpr PairCounts pair_counts<PairQuery::distance, 2>{
    {
        {2067, 2044, 2028, 1964, 2088, 2016, 2003, 2048},
        {2007, 2079, 2009, 2004, 2056, 2017, 2066},
        {2025, 2050, 2101, 2077, 2080, 2033},
        {2076, 2039, 2067, 2101, 1990},
        {2057, 1995, 2066, 2020},
        {1807, 2032, 2060},
        {2044, 2056},
        {0},
    },
    {
        {2032, 2055, 2058, 2006, 1989, 2087, 1965, 2035},
        {2014, 2040, 2002, 2087, 2056, 2029, 2078},
        {1997, 2012, 2075, 2022, 2003, 2062},
        {2025, 2031, 2054, 2059, 2036},
        {2055, 2056, 2062, 2031},
        {1770, 2037, 2009},
        {2067, 2005},
        {0},
    },
};
template <>
inline constexpr PairCounts pair_counts<PairQuery::closest_points, 3>{
    {
        {2055, 2063, 2040, 2078, 2081, 2066, 2038, 2086},
        {1977, 2035, 1997, 2004, 2032, 2041, 2026},
        {2053, 2055, 2071, 2058, 2031, 2039},
        {2036, 2015, 2081, 2037, 2071},
        {1994, 2025, 2158, 2079},
        {2043, 2013, 2019},
        {4096, 2046},
        {0},
    },
    {
        {2040, 2011, 2048, 2043, 2013, 2048, 2089, 2070},
        {2032, 1979, 2070, 2055, 2044, 2037, 2039},
        {2007, 2036, 1988, 1986, 2021, 2058},
        {2064, 2035, 2076, 2013, 2061},
        {2036, 2066, 2169, 2035},
        {1991, 2063, 2053},
        {4095, 2061},
        {0},
    },
};
template <>
inline constexpr PairCounts pair_counts<PairQuery::closest_points, 2>{
    {
        {2067, 2044, 2028, 1964, 2088, 2016, 2003, 2048},
        {2007, 2079, 2009, 2004, 2056, 2017, 2066},
        {2025, 2050, 2101, 2077, 2080, 2033},
        {2076, 2039, 2067, 2101, 1990},
        {2057, 1995, 2066, 2020},
        {1807, 2032, 2060},
        {2044, 2056},
        {0},
    },
    {
        {2037, 2056, 2068, 2010, 1992, 2092, 1968, 2040},
        {2014, 2048, 2003, 2088, 2060, 2033, 2083},
        {2003, 2019, 2078, 2028, 2004, 2070},
        {2030, 2033, 2057, 2060, 2038},
        {2057, 2059, 2065, 2034},
        {1776, 2039, 2013},
        {2067, 2009},
        {0},
    },
};
template <>
inline constexpr PairCounts pair_counts<PairQuery::contact, 3>{
    {
        {2056, 2141, 2075, 1992, 1983, 2041, 2030, 2028},
        {2116, 2063, 2034, 2076, 2077, 2020, 2019},
        {2043, 2046, 2045, 2072, 2056, 2065},
        {2043, 2061, 2087, 2053, 2038},
        {2068, 2004, 1956, 2039},
        {2046, 2039, 2067},
        {0, 2041},
    },
    {
        {2012, 2055, 2045, 2011, 2031, 2028, 2055, 2069},
        {2093, 2035, 1997, 2051, 2068, 1983, 2079},
        {2083, 2090, 2072, 2048, 2019, 2006},
        {2011, 2078, 1962, 2059, 2022},
        {2045, 2078, 1924, 1980},
        {2074, 2032, 2093},
        {0, 2047},
    },
};
template <>
inline constexpr PairCounts pair_counts<PairQuery::contact, 2>{
    {
        {1984, 2037, 2065, 2046, 2012, 2128, 2037, 2025},
        {2016, 2083, 2002, 2003, 2055, 2033, 2043},
        {1998, 2080, 2094, 2089, 2074, 2040},
        {2036, 2133, 2037, 2084, 2037},
        {2052, 2072, 1979, 2035},
        {2327, 2045, 2033},
        {2058, 2093},
    },
    {
        {2046, 2086, 2052, 2069, 2077, 2056, 2045, 2049},
        {2056, 2012, 2050, 2099, 2055, 2078, 2044},
        {2081, 2042, 2039, 2077, 2015, 2082},
        {2084, 2066, 2079, 2066, 2041},
        {2046, 2046, 2035, 2015},
        {2298, 2055, 2010},
        {2092, 2052},
    },
};

/// The name of a query of two columns, ending with 0.
template <PairQuery What, int N, int A, int B>
inline constexpr auto pair_name = [] {
  std::array<char, 40> name{};
  auto end = name.begin();
  for (const std::string_view part :
       {std::string_view(N == 2 ? "2D " : ""), pair_query_names[static_cast<std::size_t>(What)],
        std::string_view("/"), column_names[A], std::string_view("_"), column_names[B]}) {
    end = std::copy(part.begin(), part.end(), end);
  }
  return name;
}();

/// Whether the pair of two columns is listed: each once, and two planes have no contact.
template <PairQuery What, int A, int B>
inline constexpr bool is_listed = A <= B && !(What == PairQuery::contact && A == column_count - 1);

/// Visits a query of two columns.
template <PairQuery What, int N, int A, int B, class Visit>
void visit_pair(const Visit& visit) {
  constexpr auto counts = pair_counts<What, N>;
  const PairRow row{pair_name<What, N, A, B>.data(),
                    {counts.ordinary[A][B - A], counts.small[A][B - A]}};
  with_shape<A>([&]<template <class, int> class Shape>() {
    if constexpr (What == PairQuery::distance) {
      visit_column<Shape, N, B>(visit, ask_pair_distance, row);
    } else if constexpr (What == PairQuery::closest_points) {
      visit_column<Shape, N, B>(visit, ask_closest_points, row);
    } else {
      visit_column<Shape, N, B>(visit, ask_contact, row);
    }
  });
}
/// Calls `visit` with the two columns of each listed pair.
template <PairQuery What, class Visit>
void for_each_pair(const Visit& visit) {
  for_each_column([&]<int A>() {
    for_each_column([&]<int B>() {
      if constexpr (is_listed<What, A, B>) visit.template operator()<A, B>();
    });
  });
}
/// Visits a query of all pairs.
template <PairQuery What, int N, class Visit>
void visit_pairs(const Visit& visit) {
  for_each_pair<What>([&]<int A, int B>() { visit_pair<What, N, A, B>(visit); });
}

/// Adds one to a suite: still_pairs.cpp, in an object of its own.
template <PairQuery What, int N, int A, int B>
void add_pair(Suite& suite);
template <PairQuery What, int N>
void add_pairs(Suite& suite) {
  for_each_pair<What>([&]<int A, int B>() { add_pair<What, N, A, B>(suite); });
}

}  // namespace detent::bench
