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

using SphereKind = Kind<Sphere>;
using AabbKind = Kind<Aabb>;
using ObbKind = Kind<Obb>;
using PlaneKind = Kind<Plane>;
using TriangleKind = Kind<Triangle>;
using CapsuleKind = Kind<Capsule>;
using SegmentKind = Kind<Segment>;
using RayKind = Kind<Ray>;
using HullKind = Kind<HullPoints>;

/// The parts of the corpus, for compilers or chips that cannot take all of it at once. `large`
/// parts do not fit the smallest chips, with 256 KB of flash and 16 KB of memory.
struct SolidRays {
  static constexpr std::string_view name = "SolidRays";
  using Groups = List<Spheres, Aabbs, Obbs>;
};
struct FlatRays {
  static constexpr std::string_view name = "FlatRays";
  using Groups = List<Planes, Triangles>;
};
struct RoundRays {
  static constexpr std::string_view name = "RoundRays";
  using Groups = List<RaysAgainst<CapsuleKind>, RaysAgainst<SegmentKind>>;
};
struct RoundPoints {
  static constexpr std::string_view name = "RoundPoints";
  using Groups = List<Points<SphereKind>, Points<CapsuleKind>>;
};
struct BoxPoints {
  static constexpr std::string_view name = "BoxPoints";
  using Groups = List<Points<AabbKind>, Points<ObbKind>>;
};
struct FlatPoints {
  static constexpr std::string_view name = "FlatPoints";
  using Groups = List<Points<PlaneKind>, Points<TriangleKind>>;
};
struct LinePoints {
  static constexpr std::string_view name = "LinePoints";
  using Groups = List<Points<SegmentKind>, Points<RayKind>>;
};
struct SphereOverlaps {
  static constexpr std::string_view name = "SphereOverlaps";
  using Groups = List<Overlaps<SphereKind, SphereKind>, Overlaps<SphereKind, AabbKind>,
                      Overlaps<SphereKind, ObbKind>, Overlaps<SphereKind, PlaneKind>,
                      Overlaps<SphereKind, TriangleKind>, Overlaps<SphereKind, CapsuleKind>>;
};
struct AabbOverlaps {
  static constexpr std::string_view name = "AabbOverlaps";
  using Groups =
      List<Overlaps<AabbKind, AabbKind>, Overlaps<AabbKind, ObbKind>, Overlaps<AabbKind, PlaneKind>,
           Overlaps<AabbKind, TriangleKind>, Overlaps<AabbKind, CapsuleKind>>;
};
struct ObbOverlaps {
  static constexpr std::string_view name = "ObbOverlaps";
  using Groups = List<Overlaps<ObbKind, ObbKind>, Overlaps<ObbKind, PlaneKind>,
                      Overlaps<ObbKind, TriangleKind>, Overlaps<ObbKind, CapsuleKind>>;
};
struct FlatOverlaps {
  static constexpr std::string_view name = "FlatOverlaps";
  using Groups = List<Overlaps<PlaneKind, PlaneKind>, Overlaps<PlaneKind, TriangleKind>,
                      Overlaps<PlaneKind, CapsuleKind>, Overlaps<TriangleKind, TriangleKind>,
                      Overlaps<TriangleKind, CapsuleKind>, Overlaps<CapsuleKind, CapsuleKind>>;
};
struct Intersections {
  static constexpr std::string_view name = "Intersections";
  using Groups =
      List<Intersects<SphereKind>, Intersects<AabbKind>, Intersects<ObbKind>, Intersects<PlaneKind>,
           Intersects<TriangleKind>, Intersects<CapsuleKind>, Intersects<SegmentKind>>;
};
struct Hulls {
  static constexpr std::string_view name = "Hulls";
  using Groups = List<RaysAgainst<HullKind>, Points<HullKind>>;
};
struct HullOverlaps {
  static constexpr std::string_view name = "HullOverlaps";
  using Groups = List<Overlaps<SphereKind, HullKind>, Overlaps<AabbKind, HullKind>,
                      Overlaps<ObbKind, HullKind>, Overlaps<PlaneKind, HullKind>>;
};
struct HullMeetings {
  static constexpr std::string_view name = "HullMeetings";
  using Groups = List<Overlaps<TriangleKind, HullKind>, Overlaps<CapsuleKind, HullKind>,
                      Overlaps<HullKind, HullKind>, Intersects<HullKind>>;
};
struct Turns {
  static constexpr std::string_view name = "Turns";
  using Groups =
      List<Normals, Angles, Bearings, FlatTurns, AxisTurns, Quaternions, Eulers, Rotations>;
};
struct Arithmetic {
  static constexpr std::string_view name = "Arithmetic";
  using Groups = List<Roots, Quotients, Texts>;
};
struct Moves {
  static constexpr std::string_view name = "Moves";
  using Groups = List<Matrices, Blends, Motions, Cameras, Lenses, VectorPairs>;
};
struct Extents {
  static constexpr std::string_view name = "Extents";
  using Groups = List<Crossings, Sizes>;
};

struct MeshAnswers {
  static constexpr std::string_view name = "MeshAnswers";
  using Groups = List<Meshes>;
};
struct FieldAnswers {
  static constexpr std::string_view name = "FieldAnswers";
  using Groups = List<HeightFields>;
};
struct SceneAnswers {
  static constexpr std::string_view name = "SceneAnswers";
  using Groups = List<SceneQuestions>;
};
struct SceneContacts {
  static constexpr std::string_view name = "SceneContacts";
  using Groups = List<SceneMeetings>;
};
struct Snapshots {
  static constexpr std::string_view name = "Snapshots";
  using Groups = List<SceneRecords>;
};

struct Sights {
  static constexpr std::string_view name = "Sights";
  using Groups = List<Views>;
};

struct PairDistances {
  static constexpr std::string_view name = "PairDistances";
  using Groups = List<Distances<CapsuleKind, ObbKind>, Distances<HullKind, HullKind>>;
};

struct MoreDistances {
  static constexpr std::string_view name = "MoreDistances";
  using Groups = List<Distances<SphereKind, TriangleKind>, Distances<ObbKind, ObbKind>,
                      Distances<SegmentKind, HullKind>>;
};
struct SpherePairPoints {
  static constexpr std::string_view name = "SpherePairPoints";
  using Groups = List<ClosestPoints<SphereKind, AabbKind>>;
};
struct CapsulePairPoints {
  static constexpr std::string_view name = "CapsulePairPoints";
  using Groups = List<ClosestPoints<CapsuleKind, CapsuleKind>>;
};
struct TrianglePairPoints {
  static constexpr std::string_view name = "TrianglePairPoints";
  using Groups = List<ClosestPoints<TriangleKind, SegmentKind>>;
};
struct HullPairPoints {
  static constexpr std::string_view name = "HullPairPoints";
  using Groups = List<ClosestPoints<HullKind, HullKind, 3>>;
};
struct BoxPairPoints {
  static constexpr std::string_view name = "BoxPairPoints";
  using Groups = List<ClosestPoints<ObbKind, ObbKind, 3>>;
};
struct SphereContacts {
  static constexpr std::string_view name = "SphereContacts";
  static constexpr bool large = true;
  using Groups = List<Contacts<SphereKind, AabbKind>>;
};
struct CapsuleContacts {
  static constexpr std::string_view name = "CapsuleContacts";
  static constexpr bool large = true;
  using Groups = List<Contacts<CapsuleKind, ObbKind, 3>>;
};
struct BoxContacts {
  static constexpr std::string_view name = "BoxContacts";
  static constexpr bool large = true;
  using Groups = List<Contacts<ObbKind, ObbKind, 3>>;
};
struct FlatContacts {
  static constexpr std::string_view name = "FlatContacts";
  static constexpr bool large = true;
  using Groups = List<Contacts<ObbKind, AabbKind, 2>>;
};
struct HullContacts {
  static constexpr std::string_view name = "HullContacts";
  static constexpr bool large = true;
  using Groups = List<Contacts<TriangleKind, HullKind, 3>>;
};
struct PlaneContacts {
  static constexpr std::string_view name = "PlaneContacts";
  static constexpr bool large = true;
  using Groups = List<Contacts<HullKind, PlaneKind>>;
};
struct SphereCasts {
  static constexpr std::string_view name = "SphereCasts";
  static constexpr bool large = true;
  using Groups = List<Casts<SphereKind, TriangleKind, 3>>;
};
struct CapsuleCasts {
  static constexpr std::string_view name = "CapsuleCasts";
  static constexpr bool large = true;
  using Groups = List<Casts<CapsuleKind, ObbKind, 3>>;
};
struct FlatCasts {
  static constexpr std::string_view name = "FlatCasts";
  static constexpr bool large = true;
  using Groups = List<Casts<ObbKind, CapsuleKind, 2>>;
};
struct AabbCasts {
  static constexpr std::string_view name = "AabbCasts";
  static constexpr bool large = true;
  using Groups = List<Casts<AabbKind, AabbKind, 3>>;
};
struct ObbCasts {
  static constexpr std::string_view name = "ObbCasts";
  static constexpr bool large = true;
  using Groups = List<Casts<ObbKind, ObbKind, 3>>;
};
struct HullCasts {
  static constexpr std::string_view name = "HullCasts";
  static constexpr bool large = true;
  using Groups = List<Casts<HullKind, HullKind, 3>>;
};
struct BoxImpacts {
  static constexpr std::string_view name = "BoxImpacts";
  static constexpr bool large = true;
  using Groups = List<Impacts<ObbKind, ObbKind>>;
};
struct Characters {
  static constexpr std::string_view name = "Characters";
  static constexpr bool large = true;
  using Groups = List<Walks>;
};
struct ScenePairs {
  static constexpr std::string_view name = "ScenePairs";
  using Groups = List<SceneEvents>;
};
struct FallingBodies {
  static constexpr std::string_view name = "FallingBodies";
  static constexpr bool large = true;
  using Groups = List<Piles>;
};
struct JoinedBodies {
  static constexpr std::string_view name = "JoinedBodies";
  static constexpr bool large = true;
  using Groups = List<Linkages>;
};
struct SolidBodies {
  static constexpr std::string_view name = "SolidBodies";
  static constexpr bool large = true;
  using Groups = List<Solids>;
};

namespace detail {

template <class... Items>
constexpr auto joined(List<Items...> list) {
  return list;
}
template <class... Left, class... Right, class... Rest>
constexpr auto joined(List<Left...>, List<Right...>, Rest... rest) {
  return joined(List<Left..., Right...>{}, rest...);
}
template <class... Items>
constexpr auto groups_of(List<Items...>) {
  return joined(typename Items::Groups{}...);
}
template <class... Items>
constexpr auto parts_of(List<Items...>) {
  return joined(typename Items::Parts{}...);
}

}  // namespace detail

/// The corpus in five programs, for compilers that cannot take it in one.
struct Basics {
  static constexpr std::string_view name = "Basics";
  using Parts = List<SolidRays, FlatRays, RoundRays, RoundPoints, BoxPoints, FlatPoints, LinePoints,
                     SphereOverlaps, AabbOverlaps, ObbOverlaps, FlatOverlaps, Intersections, Hulls,
                     HullOverlaps, HullMeetings, Turns, Arithmetic, Moves, Extents, MeshAnswers,
                     FieldAnswers, SceneAnswers, SceneContacts, Snapshots, Sights, PairDistances>;
  using Groups = decltype(detail::groups_of(Parts{}));
};
struct Pairs {
  static constexpr std::string_view name = "Pairs";
  using Parts = List<MoreDistances, SpherePairPoints, CapsulePairPoints, TrianglePairPoints,
                     HullPairPoints, BoxPairPoints, SphereContacts, CapsuleContacts, BoxContacts,
                     FlatContacts, HullContacts, PlaneContacts>;
  using Groups = decltype(detail::groups_of(Parts{}));
};
struct Movements {
  static constexpr std::string_view name = "Movements";
  using Parts = List<SphereCasts, CapsuleCasts, FlatCasts, AabbCasts, ObbCasts, HullCasts>;
  using Groups = decltype(detail::groups_of(Parts{}));
};
struct Bodies {
  static constexpr std::string_view name = "Bodies";
  using Parts = List<BoxImpacts, Characters, ScenePairs>;
  using Groups = decltype(detail::groups_of(Parts{}));
};
struct Worlds {
  static constexpr std::string_view name = "Worlds";
  using Parts = List<FallingBodies, JoinedBodies, SolidBodies>;
  using Groups = decltype(detail::groups_of(Parts{}));
};
using Volumes = List<Basics, Pairs, Movements, Bodies, Worlds>;

using Parts = decltype(detail::parts_of(Volumes{}));

/// All parts together.
struct Corpus {
  static constexpr std::string_view name = "all";
  using Groups = decltype(detail::groups_of(Parts{}));
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
template <class Part = Corpus>
[[nodiscard]] constexpr std::size_t count_rows() noexcept {
  std::size_t count = 0;
  visit_groups<Part>([&](auto group) { count += rows_of<decltype(group)>(); });
  return count;
}
template <class Part = Corpus>
[[nodiscard]] constexpr std::size_t count_cells() noexcept {
  std::size_t count = 0;
  visit_groups<Part>(
      [&](auto group) { count += rows_of<decltype(group)>() * spaces_of<decltype(group)>(); });
  return count;
}
template <class Part = Corpus>
[[nodiscard]] constexpr std::size_t count_sheets() noexcept {
  std::size_t count = 0;
  visit_groups<Part>([&](auto group) { count += spaces_of<decltype(group)>(); });
  return count;
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
