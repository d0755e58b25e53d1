// SPDX-License-Identifier: MIT
#pragma once

#include "verify/corpus.hpp"

namespace detent::verify {

/// Calls `visit(Group{}, Space<S, N>{})` for the sheet with this index.
template <class Visit>
void visit_sheet(std::size_t index, Visit&& visit) {
  std::size_t at = 0;
  visit_groups([&]<class Group>(Group group) {
    visit_spaces<Group>([&](auto space) {
      if (at++ == index) visit(group, space);
    });
  });
}

}  // namespace detent::verify
