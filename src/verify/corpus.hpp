// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <utility>

#include "detent/number/digest.hpp"
#include "verify/questions.hpp"

// The corpus of `verify`: a fixed list of questions to the library, the same on every machine. It
// needs no operating system, no heap and no floating point, and a few hundred bytes of memory.
//
// A *row* is one query, such as raycast/sphere. Its *cells* put it to every scalar and dimension
// that it has, each with its own seed, so a smaller corpus is the beginning of a larger one. The
// digest of a cell is XXH64 of its answers' canonical bytes, that of a row XXH64 of its cells'
// digests, and the digest of all that of the rows' digests.

namespace detent::verify {

/// How many questions a cell asks: at a desk, on a microcontroller, and of the compiler.
inline constexpr std::uint32_t full_size = 12'000;
inline constexpr std::uint32_t small_size = 64;
inline constexpr std::uint32_t constant_size = 3;

/// Row r of a group that asks in `spaces` spaces has the cells first + r * spaces and on.
[[nodiscard]] constexpr std::size_t cell_index(std::size_t first, std::size_t spaces,
                                               std::size_t row, std::size_t space) noexcept {
  return first + row * spaces + space;
}

template <class... Items>
struct List {};

using Groups = List<Spheres, Aabbs, Obbs, Planes, Triangles, Normals, Angles, Bearings, FlatTurns,
                    AxisTurns, Quaternions, Eulers, Rotations, Roots, Quotients, Texts>;

/// The scalar and the dimension of a cell.
template <Scalar S, int N>
struct Space {
  using scalar = S;
  static constexpr int dimension = N;
};

template <Scalar S>
inline constexpr std::string_view scalar_name;
template <>
inline constexpr std::string_view scalar_name<q16_16> = "q16_16";
template <>
inline constexpr std::string_view scalar_name<q14_16> = "q14_16";
template <>
inline constexpr std::string_view scalar_name<q24_8> = "q24_8";
template <>
inline constexpr std::string_view scalar_name<q8_8> = "q8_8";

namespace detail {

template <class Group, Scalar S, class Visit>
constexpr void visit_dimensions(Visit&& visit) {
  if constexpr (Group::template asks<1>) visit(Space<S, 1>{});
  if constexpr (Group::template asks<2>) visit(Space<S, 2>{});
  if constexpr (Group::template asks<3>) visit(Space<S, 3>{});
}

template <class... Items, class Visit>
constexpr void visit(List<Items...>, Visit&& visit) {
  (visit(Items{}), ...);
}

}  // namespace detail

/// Calls `visit(Group{})` for every group, in the order of the report.
template <class Visit>
constexpr void visit_groups(Visit&& visit) {
  detail::visit(Groups{}, visit);
}

/// Calls `visit(Space<S, N>{})` for every space in which a group asks, in the order of the digests.
template <class Group, class Visit>
constexpr void visit_spaces(Visit&& visit) {
  detail::visit_dimensions<Group, q16_16>(visit);
  detail::visit_dimensions<Group, q14_16>(visit);
  detail::visit_dimensions<Group, q24_8>(visit);
  detail::visit_dimensions<Group, q8_8>(visit);
}

template <class Group>
[[nodiscard]] constexpr std::size_t rows_of() noexcept {
  return Group::names.size();
}
template <class Group>
[[nodiscard]] constexpr std::size_t spaces_of() noexcept {
  std::size_t count = 0;
  visit_spaces<Group>([&](auto) { ++count; });
  return count;
}
[[nodiscard]] constexpr std::size_t count_rows() noexcept {
  std::size_t count = 0;
  visit_groups([&](auto group) { count += rows_of<decltype(group)>(); });
  return count;
}
[[nodiscard]] constexpr std::size_t count_cells() noexcept {
  std::size_t count = 0;
  visit_groups(
      [&](auto group) { count += rows_of<decltype(group)>() * spaces_of<decltype(group)>(); });
  return count;
}

/// Every cell has its own beginning.
template <class Group, Scalar S, int N>
[[nodiscard]] constexpr std::uint64_t seed_of() noexcept {
  std::uint64_t hash = 0xcbf29ce484222325u;  // FNV-1a
  const auto mix = [&](int byte) {
    hash = (hash ^ static_cast<std::uint64_t>(byte)) * 0x100000001b3u;
  };
  for (const char c : Group::names[0]) mix(c);
  mix(S::bits);
  mix(S::frac);
  mix(N);
  return hash;
}

/// Calls `ask(c)` for the first `size` cases of a group in one space.
template <class Group, Scalar S, int N, class Ask>
constexpr void visit_cases(std::uint32_t size, Ask&& ask) {
  Scene<S, N> scene(seed_of<Group, S, N>());
  for (std::uint32_t i = 0; i < size; ++i) ask(Group::template draw<S, N>(scene));
}

/// Adds the answers of every row of a group to the row's sink, a `Digest` or what looks like one.
template <class Group, class Case, class Sinks>
constexpr void answer_all(const Case& c, Sinks& sinks) {
  [&]<std::size_t... Row>(std::index_sequence<Row...>) {
    (sinks[Row].add(Group::template answer<static_cast<int>(Row)>(c)), ...);
  }
  (std::make_index_sequence<rows_of<Group>()>{});
}

/// The digests of a group's cells in one space, one for each row.
template <class Group, Scalar S, int N>
#if defined(__GNUC__)
[[gnu::noinline]]  // a small stack wants one cell's variables at a time
#endif
constexpr auto
digests_of(std::uint32_t size) noexcept {
  std::array<Digest, rows_of<Group>()> running;
  visit_cases<Group, S, N>(size, [&](const auto& c) { answer_all<Group>(c, running); });
  std::array<std::uint64_t, rows_of<Group>()> digests{};
  for (std::size_t row = 0; row < digests.size(); ++row) digests[row] = running[row].value();
  return digests;
}

}  // namespace detent::verify
