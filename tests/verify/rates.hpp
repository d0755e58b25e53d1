// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "support/catch.hpp"
#include "verify/corpus.hpp"

namespace detent::verify {

/// Check that 30 to 70 % of the answers are yes, and return the number of rows of their parts. Each
/// is in a file of its own: a compiler takes gigabytes for all parts.
std::size_t rates_of_rays_and_points();
std::size_t rates_of_overlaps();
std::size_t rates_of_hulls();
std::size_t rates_of_numbers();
std::size_t rates_of_surfaces();
std::size_t rates_of_scenes();

/// A sink that counts hits instead of computing a digest.
struct Yes {
  test::HitRate rate;

  template <class T>
  void add(const std::optional<T>& answer) {
    rate.count(answer.has_value());
  }
  void add(bool answer) { rate.count(answer); }
  template <class T>
  void add(const T&) {}
};

/// Rows with yes-or-no or optional results, which should be balanced.
inline bool asks_yes_or_no(std::string_view row) {
  for (const std::string_view query :
       {"raycast", "contains/", "on/", "overlaps/", "intersects/", "mesh/raycast_nearest",
        "mesh/raycast_any", "mesh/raycast_hit", "mesh/overlaps/", "mesh/intersects",
        "height_field/raycast_nearest", "height_field/overlaps/", "scene/nearest/ray", "scene/any/",
        "camera/project", "frustum/overlaps"}) {
    if (row.starts_with(query)) return true;
  }
  return false;
}

template <class... Parts>
std::size_t check_rates() {
  std::size_t rows = 0;
  const auto check_group = [&]<class Group>(Group) {
    rows += rows_of<Group>();
    if constexpr (Group::template asks<2> || Group::template asks<3>) {
      for (const auto size : {full_size, small_size}) {
        if (question_count(size, share_of<Group>) < small_size) continue;  // too few for a rate
        std::array<Yes, rows_of<Group>()> seen;
        visit_spaces<Group>([&]<class S, int N>(Space<S, N>) {
          visit_cases<Group, S, N>(size, [&](const auto& c) { answer_all<Group>(c, seen); });
        });
        for (std::size_t row = 0; row < seen.size(); ++row) {
          if (!asks_yes_or_no(Group::names[row])) continue;
          INFO(std::string(Group::names[row]) << ": " << seen[row].rate);
          CHECK(seen[row].rate.is_balanced());
        }
      }
    }
  };
  (visit_groups<Parts>(check_group), ...);
  return rows;
}

}  // namespace detent::verify
