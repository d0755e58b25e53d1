// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "c/hulls.hpp"
#include "detent/query/closest_points.hpp"

// Closest points of two shapes.
namespace detent::c {

template <int N>
struct Closest {
  using T = Types<N>;

  static detent_status closest_points(const typename T::Shape* a, const typename T::Shape* b,
                                      typename T::Vec* point_a, typename T::Vec* point_b) {
    if (a == nullptr || b == nullptr || point_a == nullptr || point_b == nullptr) {
      return DETENT_BAD_ARGUMENT;
    }
    return with_points<N>(*a, [&](const auto& one) {
      return with_points<N>(*b,
                            [&](const auto& other) { return write(one, other, point_a, point_b); });
    });
  }

  static detent_status closest_points_of_shapes(const detent_context* context,
                                                const typename T::Shape* a, std::uint32_t a_count,
                                                const typename T::Shape* b, std::uint32_t b_count,
                                                typename T::Vec* point_a,
                                                typename T::Vec* point_b) {
    if (point_a == nullptr || point_b == nullptr) return DETENT_BAD_ARGUMENT;
    const auto status = check_lists<N>(context, a, a_count, b, b_count);
    if (status != DETENT_OK) return status;
    const auto has_points = [&](const typename T::Shape& shape) {
      return with_hull_or_points<N>(context, shape, [](const auto& one) {
               return detail::has_points(one) ? DETENT_OK : DETENT_NO;
             }) == DETENT_OK;
    };
    // As for two compounds in C++: of equally near parts the first that are not empty.
    const typename T::Shape *one = nullptr, *other = nullptr;
    bool has_found = false;
    std::int32_t least = 0;
    for (std::uint32_t i = 0; i < a_count; ++i) {
      for (std::uint32_t k = 0; k < b_count; ++k) {
        std::int32_t between = 0;
        static_cast<void>(distance(context, &a[i], 1, &b[k], 1, &between));
        const bool is_found = has_found || (has_points(a[i]) && has_points(b[k]));
        if (one != nullptr && (has_found || !is_found) && between >= least) continue;
        has_found = is_found;
        one = &a[i];
        other = &b[k];
        least = between;
      }
    }
    *point_a = *point_b = typename T::Vec{};
    if (one == nullptr) return DETENT_OK;
    return with_hull_or_points<N>(context, *one, [&](const auto& first) {
      return with_hull_or_points<N>(context, *other, [&](const auto& second) {
        return write(first, second, point_a, point_b);
      });
    });
  }

 private:
  static constexpr auto distance = [] {
    if constexpr (N == 2) {
      return detent_shapes2_distance;
    } else {
      return detent_shapes3_distance;
    }
  }();
  template <class A, class B>
  static detent_status write(const A& a, const B& b, typename T::Vec* point_a,
                             typename T::Vec* point_b) {
    const auto points = detent::closest_points(a, b);
    *point_a = Output<N>::vec(points.first);
    *point_b = Output<N>::vec(points.second);
    return DETENT_OK;
  }
};

}  // namespace detent::c
