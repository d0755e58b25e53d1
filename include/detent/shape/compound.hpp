// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <tuple>

#include "detent/number/require_cxx20.hpp"

namespace detent {

/// The union of several shapes, given as one list for each type of shape:
/// `Compound{spheres, boxes}` of a `std::array<Sphere<S, 3>, 4>` and a `std::vector<Obb<S, 3>>`.
///
/// A view: the caller owns the lists, which must outlive it. Empty lists and empty shapes add
/// nothing. Parts are in the order of the lists. A list of compounds is allowed.
template <class... Shapes>
struct Compound {
  std::tuple<std::span<const Shapes>...> parts;

  constexpr Compound() noexcept = default;
  /// The union of the shapes in `lists`.
  explicit constexpr Compound(std::span<const Shapes>... lists) noexcept
      requires(sizeof...(Shapes) > 0)
      : parts(lists...) {}
};

template <class... Lists>
explicit Compound(const Lists&...) -> Compound<typename Lists::value_type...>;

/// Whether `T` is a `Compound`.
template <class T>
inline constexpr bool is_compound = false;
template <class... Shapes>
inline constexpr bool is_compound<Compound<Shapes...>> = true;

/// Calls visit(part) for every part, in order.
template <class... Shapes, class Visit>
constexpr void for_each_part(const Compound<Shapes...>& compound, const Visit& visit) noexcept {
  const auto visit_list = [&visit](const auto& list) {
    for (const auto& part : list) visit(part);
  };
  std::apply([&](const auto&... lists) { (visit_list(lists), ...); }, compound.parts);
}

/// Whether test(part) is true for any part; stops at the first such part.
template <class... Shapes, class Test>
[[nodiscard]] constexpr bool any_part(const Compound<Shapes...>& compound,
                                      const Test& test) noexcept {
  const auto any_in_list = [&test](const auto& list) {
    for (const auto& part : list) {
      if (test(part)) return true;
    }
    return false;
  };
  return std::apply([&](const auto&... lists) { return (any_in_list(lists) || ...); },
                    compound.parts);
}

/// Appends to a digest: each list as its length in 8 bytes and its parts.
template <class D, class... Shapes>
constexpr void append(D& digest, const Compound<Shapes...>& compound) noexcept {
  const auto append_list = [&digest](const auto& list) {
    digest.add(static_cast<std::uint64_t>(list.size()));
    for (const auto& part : list) digest.add(part);
  };
  std::apply([&](const auto&... lists) { (append_list(lists), ...); }, compound.parts);
}

}  // namespace detent
