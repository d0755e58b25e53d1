// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <type_traits>
#include <utility>

#include "detent/number/digest.hpp"
#include "support/scalars.hpp"
#include "verify/noinline.hpp"
#include "verify/questions.hpp"

// The corpus of `verify`: a fixed list of test cases (questions) for the library, the same on every
// machine. It needs no operating system, no heap, no floating point, and only a few hundred bytes
// of memory.
//
// A *row* is one query, such as raycast/sphere. A *cell* of it is one scalar and dimension, with
// its own seed, so a smaller corpus is a prefix of a larger one. The digest of a cell is XXH64 of
// its results' canonical bytes, that of a row is XXH64 of its cells' digests, and the total is
// XXH64 of the rows' digests.

namespace detent::verify {

/// Questions per cell: on a desktop, on a microcontroller, and in the compiler. Groups with a
/// `share` run that fraction of them, at least one.
inline constexpr std::uint32_t full_size = 12'000;
inline constexpr std::uint32_t small_size = 64;
inline constexpr std::uint32_t constant_size = 3;

/// Row r of a group with `spaces` spaces has the cells from first + r * spaces on.
[[nodiscard]] constexpr std::size_t cell_index(std::size_t first, std::size_t spaces,
                                               std::size_t row, std::size_t space) noexcept {
  return first + row * spaces + space;
}

template <class... Items>
struct List {};

/// A name as a template argument.
template <std::size_t Size>
struct PartName {
  consteval PartName(const char (&text)[Size]) noexcept {
    for (std::size_t i = 0; i < Size; ++i) characters[i] = text[i];
  }
  [[nodiscard]] constexpr std::string_view view() const noexcept { return {characters, Size - 1}; }

  char characters[Size];
};

template <PartName Text, class... Items>
struct NamedPart {
  static constexpr std::string_view name = Text.view();
  using Groups = List<Items...>;
};
template <PartName Text, class... Items>
struct LargePart : NamedPart<Text, Items...> {
  static constexpr bool large = true;
};

using SphereKind = Kind<Sphere>;
using AabbKind = Kind<Aabb>;
using ObbKind = Kind<Obb>;
using PlaneKind = Kind<Plane>;
using TriangleKind = Kind<Triangle>;
using CapsuleKind = Kind<Capsule>;
using SegmentKind = Kind<Segment>;
using RayKind = Kind<Ray>;
using HullKind = Kind<HullPoints>;

/// The parts of the corpus, for compilers or chips that cannot take all of it at once. Those that
/// are `large` do not fit the smallest chips, with 256 KB of flash and 16 KB of memory.
using SolidRays =
    NamedPart<"SolidRays", AimedRays<SphereKind>, AimedRays<AabbKind>, AimedRays<ObbKind>>;
using FlatRays = NamedPart<"FlatRays", AimedRays<PlaneKind>, AimedRays<TriangleKind>>;
using RoundRays = NamedPart<"RoundRays", RaysAgainst<CapsuleKind>, RaysAgainst<SegmentKind>>;
using RoundPoints = NamedPart<"RoundPoints", Points<SphereKind>, Points<CapsuleKind>>;
using BoxPoints = NamedPart<"BoxPoints", Points<AabbKind>, Points<ObbKind>>;
using FlatPoints = NamedPart<"FlatPoints", Points<PlaneKind>, Points<TriangleKind>>;
using LinePoints = NamedPart<"LinePoints", Points<SegmentKind>, Points<RayKind>>;
using SphereOverlaps =
    NamedPart<"SphereOverlaps", Overlaps<SphereKind, SphereKind>, Overlaps<SphereKind, AabbKind>,
              Overlaps<SphereKind, ObbKind>, Overlaps<SphereKind, PlaneKind>,
              Overlaps<SphereKind, TriangleKind>, Overlaps<SphereKind, CapsuleKind>>;
using AabbOverlaps = NamedPart<"AabbOverlaps", Overlaps<AabbKind, AabbKind>,
                               Overlaps<AabbKind, ObbKind>, Overlaps<AabbKind, PlaneKind>,
                               Overlaps<AabbKind, TriangleKind>, Overlaps<AabbKind, CapsuleKind>>;
using ObbOverlaps =
    NamedPart<"ObbOverlaps", Overlaps<ObbKind, ObbKind>, Overlaps<ObbKind, PlaneKind>,
              Overlaps<ObbKind, TriangleKind>, Overlaps<ObbKind, CapsuleKind>>;
using FlatOverlaps =
    NamedPart<"FlatOverlaps", Overlaps<PlaneKind, PlaneKind>, Overlaps<PlaneKind, TriangleKind>,
              Overlaps<PlaneKind, CapsuleKind>, Overlaps<TriangleKind, TriangleKind>,
              Overlaps<TriangleKind, CapsuleKind>, Overlaps<CapsuleKind, CapsuleKind>>;
using Intersections =
    NamedPart<"Intersections", Intersects<SphereKind>, Intersects<AabbKind>, Intersects<ObbKind>,
              Intersects<PlaneKind>, Intersects<TriangleKind>, Intersects<CapsuleKind>,
              Intersects<SegmentKind>>;
using Hulls = NamedPart<"Hulls", RaysAgainst<HullKind>, Points<HullKind>>;
using HullOverlaps =
    NamedPart<"HullOverlaps", Overlaps<SphereKind, HullKind>, Overlaps<AabbKind, HullKind>,
              Overlaps<ObbKind, HullKind>, Overlaps<PlaneKind, HullKind>>;
using HullMeetings =
    NamedPart<"HullMeetings", Overlaps<TriangleKind, HullKind>, Overlaps<CapsuleKind, HullKind>,
              Overlaps<HullKind, HullKind>, Intersects<HullKind>>;
using Turns = NamedPart<"Turns", Normals, Angles, Bearings, FlatTurns, AxisTurns, Quaternions,
                        Eulers, Rotations>;
using Arithmetic = NamedPart<"Arithmetic", Roots, Quotients, Texts>;
using Moves = NamedPart<"Moves", Matrices, Blends, Motions, Cameras, Lenses, VectorPairs>;
using Extents = NamedPart<"Extents", Crossings, Sizes>;
using MeshAnswers = NamedPart<"MeshAnswers", Meshes>;
using FieldAnswers = NamedPart<"FieldAnswers", HeightFields>;
using SceneAnswers = NamedPart<"SceneAnswers", SceneQuestions>;
using SceneContacts = NamedPart<"SceneContacts", SceneMeetings>;
using Snapshots = NamedPart<"Snapshots", SceneRecords>;
using Sights = NamedPart<"Sights", Views>;
using PairDistances =
    NamedPart<"PairDistances", Distances<CapsuleKind, ObbKind>, Distances<HullKind, HullKind>>;
using MoreDistances = NamedPart<"MoreDistances", Distances<SphereKind, TriangleKind>,
                                Distances<ObbKind, ObbKind>, Distances<SegmentKind, HullKind>>;
using SpherePairPoints = NamedPart<"SpherePairPoints", ClosestPoints<SphereKind, AabbKind>>;
using CapsulePairPoints = NamedPart<"CapsulePairPoints", ClosestPoints<CapsuleKind, CapsuleKind>>;
using TrianglePairPoints =
    NamedPart<"TrianglePairPoints", ClosestPoints<TriangleKind, SegmentKind>>;
using HullPairPoints = NamedPart<"HullPairPoints", ClosestPoints<HullKind, HullKind, 3>>;
using BoxPairPoints = NamedPart<"BoxPairPoints", ClosestPoints<ObbKind, ObbKind, 3>>;
using SphereContacts = LargePart<"SphereContacts", Contacts<SphereKind, AabbKind>>;
using CapsuleContacts = LargePart<"CapsuleContacts", Contacts<CapsuleKind, ObbKind, 3>>;
using BoxContacts = LargePart<"BoxContacts", Contacts<ObbKind, ObbKind, 3>>;
using FlatContacts = LargePart<"FlatContacts", Contacts<ObbKind, AabbKind, 2>>;
using HullContacts = LargePart<"HullContacts", Contacts<TriangleKind, HullKind, 3>>;
using PlaneContacts = LargePart<"PlaneContacts", Contacts<HullKind, PlaneKind>>;
using SphereCasts = LargePart<"SphereCasts", Casts<SphereKind, TriangleKind, 3>>;
using CapsuleCasts = LargePart<"CapsuleCasts", Casts<CapsuleKind, ObbKind, 3>>;
using FlatCasts = LargePart<"FlatCasts", Casts<ObbKind, CapsuleKind, 2>>;
using AabbCasts = LargePart<"AabbCasts", Casts<AabbKind, AabbKind, 3>>;
using ObbCasts = LargePart<"ObbCasts", Casts<ObbKind, ObbKind, 3>>;
using HullCasts = LargePart<"HullCasts", Casts<HullKind, HullKind, 3>>;
using SurfaceDistances =
    NamedPart<"SurfaceDistances", TargetDistances<MeshKind>, TargetDistances<FieldKind>>;
using CompoundDistances = NamedPart<"CompoundDistances", TargetDistances<CompoundKind>>;
using SurfaceContacts =
    LargePart<"SurfaceContacts", TargetContacts<MeshKind>, TargetContacts<FieldKind>>;
using MeshCasts = LargePart<"MeshCasts", TargetCasts<MeshKind>>;
using FieldCasts = LargePart<"FieldCasts", TargetCasts<FieldKind>>;
using CompoundSphereCasts = LargePart<"CompoundSphereCasts", TargetCasts<CompoundKind>>;
using CompoundCapsuleCasts =
    LargePart<"CompoundCapsuleCasts", TargetCasts<CompoundKind, CapsuleKind>>;
using CompoundObbCasts = LargePart<"CompoundObbCasts", TargetCasts<CompoundKind, ObbKind>>;
using CompoundHullCasts = LargePart<"CompoundHullCasts", TargetCasts<CompoundKind, HullKind>>;
using BoxImpacts = LargePart<"BoxImpacts", Impacts<ObbKind, ObbKind>>;
using Characters = LargePart<"Characters", Walks>;
using ScenePairs = NamedPart<"ScenePairs", SceneEvents>;
using MovingCapsules = LargePart<"MovingCapsules", SceneCasts>;
using FlatCharacters = LargePart<"FlatCharacters", FlatWalks>;
using OrbitSights = NamedPart<"OrbitSights", SceneViews>;
using FallingBodies = LargePart<"FallingBodies", Piles>;
using JoinedBodies = LargePart<"JoinedBodies", Linkages>;
using SolidBodies = LargePart<"SolidBodies", Solids>;
using ConedBodies = LargePart<"ConedBodies", Cones>;

namespace detail {

template <class... Lists>
struct Joined;
template <class... Items>
struct Joined<List<Items...>> {
  using type = List<Items...>;
};
template <class... First, class... Second, class... Rest>
struct Joined<List<First...>, List<Second...>, Rest...>
    : Joined<List<First..., Second...>, Rest...> {};

template <class Parts>
struct GroupsOf;
template <class... Items>
struct GroupsOf<List<Items...>> : Joined<typename Items::Groups...> {};

template <class Volumes>
struct PartsOf;
template <class... Items>
struct PartsOf<List<Items...>> : Joined<typename Items::Parts...> {};

}  // namespace detail

template <PartName Text, class... Items>
struct NamedVolume {
  static constexpr std::string_view name = Text.view();
  using Parts = List<Items...>;
  using Groups = typename detail::GroupsOf<Parts>::type;
};

/// The corpus in five programs, for compilers that cannot take it in one.
using Basics =
    NamedVolume<"Basics", SolidRays, FlatRays, RoundRays, RoundPoints, BoxPoints, FlatPoints,
                LinePoints, SphereOverlaps, AabbOverlaps, ObbOverlaps, FlatOverlaps, Intersections,
                Hulls, HullOverlaps, HullMeetings, Turns, Arithmetic, Moves, Extents, MeshAnswers,
                FieldAnswers, SceneAnswers, SceneContacts, Snapshots, Sights, PairDistances>;
using Pairs = NamedVolume<"Pairs", MoreDistances, SpherePairPoints, CapsulePairPoints,
                          TrianglePairPoints, HullPairPoints, BoxPairPoints, SphereContacts,
                          CapsuleContacts, BoxContacts, FlatContacts, HullContacts, PlaneContacts,
                          SurfaceDistances, CompoundDistances, SurfaceContacts>;
using Movements = NamedVolume<"Movements", SphereCasts, CapsuleCasts, FlatCasts, AabbCasts,
                              ObbCasts, HullCasts, MeshCasts, FieldCasts, CompoundSphereCasts,
                              CompoundCapsuleCasts, CompoundObbCasts, CompoundHullCasts>;
using Bodies = NamedVolume<"Bodies", BoxImpacts, Characters, ScenePairs, MovingCapsules,
                           FlatCharacters, OrbitSights>;
using Worlds = NamedVolume<"Worlds", FallingBodies, JoinedBodies, SolidBodies, ConedBodies>;
using Volumes = List<Basics, Pairs, Movements, Bodies, Worlds>;

using Parts = detail::PartsOf<Volumes>::type;

/// All parts together.
struct Corpus {
  static constexpr std::string_view name = "all";
  using Groups = detail::GroupsOf<Parts>::type;
};

/// The scalar and the dimension of a cell.
template <Scalar S, int N>
struct Space {
  using scalar = S;
  static constexpr int dimension = N;
};

using support::scalar_index;
using support::scalar_name;

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

/// Calls `visit(Part{})` for every part, or for every volume, in the order of the report.
template <class Visit>
constexpr void visit_parts(Visit&& visit) {
  detail::visit(Parts{}, visit);
}
template <class Visit>
constexpr void visit_volumes(Visit&& visit) {
  detail::visit(Volumes{}, visit);
}

/// Calls `visit(Group{})` for every group of a part, in the order of the report.
template <class Part = Corpus, class Visit>
constexpr void visit_groups(Visit&& visit) {
  detail::visit(typename Part::Groups{}, visit);
}

/// Calls `visit(Space<S, N>{})` for every space of a group, in the order of the digests.
template <class Group, class Visit>
constexpr void visit_spaces(Visit&& visit) {
  support::for_each_scalar(support::FixedScalars(),
                           [&]<Scalar S>(S) { detail::visit_dimensions<Group, S>(visit); });
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

/// The sum of count(group) over the groups of a part.
template <class Part, class Count>
[[nodiscard]] constexpr std::size_t count_groups(const Count& count) noexcept {
  std::size_t sum = 0;
  visit_groups<Part>([&](auto group) { sum += count(group); });
  return sum;
}
template <class Part = Corpus>
[[nodiscard]] constexpr std::size_t count_rows() noexcept {
  return count_groups<Part>([](auto group) { return rows_of<decltype(group)>(); });
}
template <class Part = Corpus>
[[nodiscard]] constexpr std::size_t count_cells() noexcept {
  return count_groups<Part>(
      [](auto group) { return rows_of<decltype(group)>() * spaces_of<decltype(group)>(); });
}
template <class Part = Corpus>
[[nodiscard]] constexpr std::size_t count_sheets() noexcept {
  return count_groups<Part>([](auto group) { return spaces_of<decltype(group)>(); });
}
namespace detail {

template <class Part>
struct FirstPart {
  using type = Part;
};
template <class First, class... Rest>
struct FirstPart<List<First, Rest...>> {
  using type = First;
};
template <class Volume>
requires requires { typename Volume::Parts; }
struct FirstPart<Volume> : FirstPart<typename Volume::Parts> {};

}  // namespace detail

/// The index of the first cell of a part, or of a volume, among the golden values.
template <class Part>
[[nodiscard]] constexpr std::size_t first_cell() noexcept {
  using First = typename detail::FirstPart<Part>::type;
  std::size_t before = 0;
  bool found = std::is_same_v<Part, Corpus>;
  visit_parts([&](auto part) {
    found = found || std::is_same_v<First, decltype(part)>;
    if (!found) before += count_cells<decltype(part)>();
  });
  return before;
}

/// A group runs one question in this many.
template <class Group>
inline constexpr std::uint32_t share_of = [] {
  if constexpr (requires { Group::share; }) {
    return Group::share;
  } else {
    return 1u;
  }
}();
/// The number of questions of a cell with this share in a corpus of this size.
[[nodiscard]] constexpr std::uint32_t question_count(std::uint32_t size,
                                                     std::uint32_t share) noexcept {
  return size < share ? 1 : size / share;
}
/// The number of questions in all cells of a part.
template <class Part = Corpus>
[[nodiscard]] constexpr std::uint32_t count_questions(std::uint32_t size) noexcept {
  std::size_t count = 0;
  visit_groups<Part>([&]<class Group>(Group) {
    count += rows_of<Group>() * spaces_of<Group>() * question_count(size, share_of<Group>);
  });
  return static_cast<std::uint32_t>(count);
}

/// Every cell has its own seed.
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

/// All cells, the default.
struct Whole {
  template <class Group, Scalar S, int N>
  static constexpr bool has = true;
};

/// A quarter of the cells, for slow compilers and emulators: every query in every dimension, each
/// in one of the four scalars, so that all scalars occur.
template <int Number>
struct Quarter {
  static_assert(Number >= 0 && Number < 4);

  template <class Group, Scalar S, int N>
  static constexpr bool has = (seed_of<Group, q16_16, N>() + scalar_index<S> + N) % 4 == Number;
};

/// Draws the next case of a group.
template <class Group, Scalar S, int N>
DETENT_VERIFY_NOINLINE constexpr auto draw(Random& random) noexcept {
  return Group::template draw<S, N>(random);
}

/// The library's result for row `Row` of a group.
template <class Group, int Row, class Case>
DETENT_VERIFY_NOINLINE constexpr auto answer(const Case& c) noexcept {
  return Group::template answer<Row>(c);
}

/// Calls `ask(c)` for each case of a group in one space in a corpus of this size.
template <class Group, Scalar S, int N, class Ask>
constexpr void visit_cases(std::uint32_t size, Ask&& ask) {
  Random random(seed_of<Group, S, N>());
  const auto count = question_count(size, share_of<Group>);
  for (std::uint32_t i = 0; i < count; ++i) ask(draw<Group, S, N>(random));
}

/// Adds a result to a sink. A large result is on the stack only during the call.
template <class Group, int Row, class Case, class Taker>
DETENT_VERIFY_NOINLINE constexpr void add_large(const Case& c, Taker& sink) {
  sink.add(answer<Group, Row>(c));
}
template <class Group, int Row, class Case, class Taker>
constexpr void add_answer(const Case& c, Taker& sink) {
  if constexpr (sizeof(answer<Group, Row>(c)) > 512) {
    add_large<Group, Row>(c, sink);
  } else {
    sink.add(answer<Group, Row>(c));
  }
}

/// Adds the results of every row of a group to the row's sink: a `Digest`, or the same interface.
template <class Group, class Case, class Sinks>
constexpr void answer_all(const Case& c, Sinks& sinks) {
  [&]<std::size_t... Row>(std::index_sequence<Row...>) {
    (add_answer<Group, static_cast<int>(Row)>(c, sinks[Row]), ...);
  }
  (std::make_index_sequence<rows_of<Group>()>{});
}

/// The digests of a group's cells in one space, one per row.
template <class Group, Scalar S, int N>
DETENT_VERIFY_NOINLINE constexpr auto digests_of(std::uint32_t size) noexcept {
  std::array<Digest, rows_of<Group>()> running{};
  visit_cases<Group, S, N>(size, [&](const auto& c) { answer_all<Group>(c, running); });
  std::array<std::uint64_t, rows_of<Group>()> digests{};
  for (std::size_t row = 0; row < digests.size(); ++row) digests[row] = running[row].value();
  return digests;
}

}  // namespace detent::verify
