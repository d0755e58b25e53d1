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

template <class Group, Scalar S, int N, int Row>
consteval bool is_golden() {
  Digest digest;
  visit_cases<Group, S, N>(constant_size,
                           [&](const auto& c) { digest.add(answer<Group, Row>(c)); });
  return digest.value() == golden::constant[cell_index(first_cell_of<Group>(), spaces_of<Group>(),
                                                       Row, space_index<Group, Space<S, N>>())];
}

/// One assertion for each cell: compilers count the steps of each by itself.
template <class Group, Scalar S, int N, int Row>
void check_cell() {
  static_assert(is_golden<Group, S, N, Row>());
}
template <class Group>
void check_at_compile_time() {
  visit_spaces<Group>([]<class S, int N>(Space<S, N>) {
    []<std::size_t... Row>(std::index_sequence<Row...>) {
      (check_cell<Group, S, N, static_cast<int>(Row)>(), ...);
    }
    (std::make_index_sequence<rows_of<Group>()>{});
  });
}

template <class... All>
void check_all(List<All...>) {
  (check_at_compile_time<All>(), ...);
}

template void check_all(Corpus::Groups);

}  // namespace detent::verify
