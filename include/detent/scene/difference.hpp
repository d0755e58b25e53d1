// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <optional>
#include <string_view>

#include "detent/scene/world.hpp"

namespace detent {

namespace detail {

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

/// The number of fields, and a digest of the names and values of `count` fields from `first` on.
struct FieldStretch {
  std::size_t field_count = 0;
  std::uint64_t digest = 0;
};
template <class World>
[[nodiscard]] constexpr FieldStretch stretch(const World& world, Fields which, std::size_t first,
                                             std::size_t count) {
  std::size_t seen = 0;
  Digest digest;
  for_each_place(world, which, [&](const FieldPlace& place, std::uint64_t value) {
    const auto i = seen++;
    if (i < first || i - first >= count) return;
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

/// Whether a field is `whole` or a part of it.
[[nodiscard]] constexpr bool is_part_of(const FieldName& name, const FieldName& whole) noexcept {
  const auto text = name.view(), start = whole.view();
  const auto size = start.size();
  // Not starts_with: on a bare machine it needs a function that throws.
  if (text.size() < size || !std::equal(start.begin(), start.end(), text.begin())) return false;
  return text.size() == size || text[size] == ' ' || text[size] == '.' || text[size] == '[';
}
/// The number of fields from `first` on that are parts of `whole`.
template <class World>
[[nodiscard]] constexpr std::size_t parts_from(const World& world, Fields which, std::size_t first,
                                               const FieldName& whole) {
  std::size_t seen = 0, end = first;
  for_each_place(world, which, [&](const FieldPlace& place, std::uint64_t) {
    if (seen++ == end && is_part_of(place.name, whole)) ++end;
  });
  return end - first;
}

/// Iterates over the fields in which two worlds differ: the value differs, or only one world has
/// the field; its parts are then skipped. Bisects digests, so it stores no list of fields.
template <class World>
class FieldDifferences {
 public:
  constexpr FieldDifferences(const World& a, const World& b, Fields which)
      : a_(a), b_(b), which_(which) {}

  [[nodiscard]] constexpr std::optional<FieldPlace> next() {
    constexpr auto everything = static_cast<std::size_t>(-1);
    const auto of_a = stretch(a_, which_, in_a_, everything);
    const auto of_b = stretch(b_, which_, in_b_, everything);
    if (of_a.digest == of_b.digest) return std::nullopt;
    std::size_t equal = 0;
    auto other = (std::max)(of_a.field_count - in_a_, of_b.field_count - in_b_);
    while (other - equal > 1) {
      const auto middle = equal + (other - equal) / 2;
      const bool is_equal =
          stretch(a_, which_, in_a_, middle).digest == stretch(b_, which_, in_b_, middle).digest;
      (is_equal ? equal : other) = middle;
    }
    in_a_ += equal;
    in_b_ += equal;
    const auto a = place_of(a_, which_, in_a_), b = place_of(b_, which_, in_b_);
    if (a && b && a->name == b->name) {
      ++in_a_, ++in_b_;
      return a;
    }
    const bool is_of_b = !a || (b && has_field(b_, which_, a->name));
    if (is_of_b) {
      in_b_ += parts_from(b_, which_, in_b_, b->name);
      return b;
    }
    in_a_ += parts_from(a_, which_, in_a_, a->name);
    return a;
  }

 private:
  const World& a_;
  const World& b_;
  Fields which_;
  std::size_t in_a_ = 0, in_b_ = 0;  // all fields before are compared
};

template <class World>
[[nodiscard]] constexpr std::optional<FieldPlace> first_difference(const World& a, const World& b,
                                                                   Fields which) {
  return FieldDifferences<World>(a, b, which).next();
}

}  // namespace detail

/// A field in which two worlds differ.
struct FieldDifference {
  FieldName field;                 // such as `body 3:17 (sphere) velocity.y`
  std::optional<ObjectId> object;  // the object or body that it belongs to, if any
};

/// Calls visit(difference) for the first fields in which two worlds differ, in order, at most
/// `most` of them, and returns their number. If only one world has an object, a body or an element,
/// only its first field is visited.
///
/// domain: worlds of bodies, scenes, and any type that lists its fields
/// result: 0 if all fields are equal
///                                   (tests/dynamics/fields.test.cpp, tests/scene/difference.test.cpp)
template <RollbackWorld World, class Visit>
constexpr std::size_t diff(const World& a, const World& b, const Visit& visit,
                           std::size_t most = 16) {
  detail::FieldDifferences<World> differences(a, b, detail::Fields::all);
  std::size_t count = 0;
  for (; count < most; ++count) {
    const auto place = differences.next();
    if (!place) break;
    visit(FieldDifference{place->name,
                          place->object ? std::optional(place->object->id) : std::nullopt});
  }
  return count;
}
/// The first field in which two worlds differ, or nothing.
template <RollbackWorld World>
[[nodiscard]] constexpr std::optional<FieldDifference> diff(const World& a, const World& b) {
  std::optional<FieldDifference> first;
  (void)diff(
      a, b, [&](const FieldDifference& difference) { first = difference; }, 1);
  return first;
}

}  // namespace detent
