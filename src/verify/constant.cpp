// SPDX-License-Identifier: MIT
//
// Compile-time evaluation is a platform as well: while it compiles this file, the compiler
// evaluates the first questions of every cell of the volume Basics, and it fails if a result is not
// golden. This checks machines whose programs cannot be run:
//
//     c++ -std=c++20 -Iinclude -Isrc -fsyntax-only src/verify/constant.cpp
//
// That takes g++ 4 GB of memory. DETENT_VERIFY_PARTS=SolidRays,FlatRays evaluates only these parts
// of corpus.hpp. Questions of the other volumes take more steps than compilers allow for a
// constant.

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

struct Running {
  Random random;
  Digest digest;
};
/// The state after the first `Count` results. Compilers limit the steps of each constant
/// separately.
template <class Group, Scalar S, int N, int Row, std::uint32_t Count>
inline constexpr Running running = [] {
  Running next = running<Group, S, N, Row, Count - 1>;
  const auto c = draw<Group, S, N>(next.random);
  next.digest.add(answer<Group, Row>(c));
  return next;
}();
template <class Group, Scalar S, int N, int Row>
inline constexpr Running running<Group, S, N, Row, 0> = {Random(seed_of<Group, S, N>()), {}};

template <class Group, Scalar S, int N, int Row>
void check_cell() {
  constexpr auto cell = cell_index(first_cell_of<Group>(), spaces_of<Group>(), Row,
                                   space_index<Group, Space<S, N>>());
  constexpr auto count = question_count(constant_size, share_of<Group>);
  static_assert(running<Group, S, N, Row, count>.digest.value() == golden::constant[cell]);
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
template <class... Chosen>
void check_parts(List<Chosen...>) {
  (check_all(typename Chosen::Groups()), ...);
}

#ifdef DETENT_VERIFY_PARTS
template void check_parts(List<DETENT_VERIFY_PARTS>);
#else
template void check_parts(Basics::Parts);
#endif

}  // namespace detent::verify
