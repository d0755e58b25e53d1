// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <optional>
#include <string_view>

#include "detent/scene/world.hpp"

namespace detent::detail {

/// The full name of a field, and the scene object that it belongs to, if any.
struct FieldPlace {
  FieldName name;
  std::optional<ObjectInfo> object;
};

/// Calls visit(place, digest) for each leaf field of a world, in order.
template <class Visit>
class FieldWalk {
 public:
  explicit constexpr FieldWalk(const Visit& visit) : visit_(visit) {}

  template <class T>
  constexpr void walk(const T& value) {
    if constexpr (HasFields<T>) {
      for_each_field(value,
                     [&](const PartName& name, const auto& part) { enter(name.view(), part); });
    } else if constexpr (IsList<T>) {
      enter(PartName("size").view(), static_cast<std::uint64_t>(std::size(value)));
      std::uint64_t i = 0;
      for (const auto& element : value) {
        enter(FieldName("[").add_number(i++).add("]"), element);
      }
    } else {
      visit_(place_, digest(value));
    }
  }

 private:
  template <class T>
  constexpr void enter(std::string_view name, const T& part) {
    const auto size = place_.name.size();
    const auto object = place_.object;
    place_.name.add_part(name);
    if constexpr (requires { part.info(); }) place_.object = part.info();
    walk(part);
    place_.name.cut(size);
    place_.object = object;
  }

  const Visit& visit_;
  FieldPlace place_;
};

enum class Fields { all, of_fixed_objects };

template <class World, class Visit>
constexpr void for_each_place(const World& world, Fields which, const Visit& visit) {
  const auto visit_some = [&](const FieldPlace& place, std::uint64_t value) {
    const bool is_fixed = place.object && place.object->motion == Motion::fixed;
    if (which == Fields::all || is_fixed) visit(place, value);
  };
  FieldWalk<decltype(visit_some)>(visit_some).walk(world);
}

/// The number of fields, and the digest of the first `count` names and values.
struct Beginning {
  std::size_t field_count = 0;
  std::uint64_t digest = 0;
};
template <class World>
[[nodiscard]] constexpr Beginning beginning(const World& world, Fields which, std::size_t count) {
  std::size_t seen = 0;
  Digest digest;
  for_each_place(world, which, [&](const FieldPlace& place, std::uint64_t value) {
    if (seen++ >= count) return;
    for (const char c : place.name.view()) digest.add(c);
    digest.add(value);
  });
  return {seen, digest.value()};
}

/// The name and object of field `i`, or nothing when there are fewer.
template <class World>
[[nodiscard]] constexpr std::optional<FieldPlace> place_of(const World& world, Fields which,
                                                           std::size_t i) {
  std::optional<FieldPlace> result;
  for_each_place(world, which, [&](const FieldPlace& place, std::uint64_t) {
    if (i-- == 0) result = place;
  });
  return result;
}

template <class World>
[[nodiscard]] constexpr bool has_field(const World& world, Fields which, const FieldName& name) {
  bool result = false;
  for_each_place(world, which,
                 [&](const FieldPlace& place, std::uint64_t) { result |= place.name == name; });
  return result;
}

/// The first field in which two worlds differ: its value differs, or only one of them has it. Found
/// by bisection over digests of the first fields, so no list of fields is kept.
template <class World>
[[nodiscard]] constexpr std::optional<FieldPlace> first_difference(const World& a, const World& b,
                                                                   Fields which) {
  constexpr auto everything = static_cast<std::size_t>(-1);
  const auto of_a = beginning(a, which, everything), of_b = beginning(b, which, everything);
  if (of_a.digest == of_b.digest) return std::nullopt;
  std::size_t equal = 0, other = (std::max)(of_a.field_count, of_b.field_count);
  while (other - equal > 1) {
    const auto middle = equal + (other - equal) / 2;
    const bool is_equal = beginning(a, which, middle).digest == beginning(b, which, middle).digest;
    (is_equal ? equal : other) = middle;
  }
  const auto in_a = place_of(a, which, equal), in_b = place_of(b, which, equal);
  if (!in_a || !in_b) return in_a ? in_a : in_b;
  return in_a->name != in_b->name && has_field(b, which, in_a->name) ? in_b : in_a;
}

}  // namespace detent::detail
