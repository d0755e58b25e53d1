// SPDX-License-Identifier: MIT
//
// The compiler is a platform too: it answers the first questions of every cell of the corpus while
// it compiles this file, and refuses the file when an answer is not the golden one. That is a check
// for machines whose programs cannot be run:
//
//     c++ -std=c++20 -Iinclude -Isrc -fsyntax-only src/verify/constant.cpp

#include "verify/check.hpp"

namespace detent::verify {

template <class Group>
consteval std::size_t first_cell_of() {
  std::size_t cell = 0;
  bool found = false;
  visit_groups([&]<class Other>(Other) {
    found = found || std::is_same_v<Group, Other>;
    if (!found) cell += rows_of<Other>() * spaces_of<Other>();
  });
  return cell;
}

template <class Group, class Here>
consteval std::size_t space_index() {
  std::size_t index = 0;
  bool found = false;
  visit_spaces<Group>([&]<class Other>(Other) {
    found = found || std::is_same_v<Here, Other>;
    if (!found) ++index;
  });
  return index;
}

template <class Group, Scalar S, int N>
consteval bool is_golden() {
  const auto digests = digests_of<Group, S, N>(constant_size);
  for (std::size_t row = 0; row < digests.size(); ++row) {
    const auto cell = cell_index(first_cell_of<Group>(), spaces_of<Group>(), row,
                                 space_index<Group, Space<S, N>>());
    if (digests[row] != golden::constant[cell]) return false;
  }
  return true;
}

/// One assertion for each group and space: compilers count the steps of each by itself.
template <class Group>
void check_at_compile_time() {
  visit_spaces<Group>([]<class S, int N>(Space<S, N>) { static_assert(is_golden<Group, S, N>()); });
}

template <class... All>
void check_all(List<All...>) {
  (check_at_compile_time<All>(), ...);
}

template void check_all(Corpus::Groups);

}  // namespace detent::verify
