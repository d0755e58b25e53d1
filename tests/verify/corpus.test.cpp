// SPDX-License-Identifier: MIT
#include <xxhash.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "detent/version.hpp"
#include "support/catch.hpp"
#include "support/shapes.hpp"
#include "verify/check.hpp"
#include "verify/sheets.hpp"

using namespace detent;
using namespace detent::verify;

namespace {

std::string name_of(const Sheet& sheet, std::size_t row) {
  return std::string(sheet.rows[row]) + " " + std::string(sheet.scalar) + " " +
         std::to_string(sheet.dimension) + "D";
}

/// Checks the first `size` results of every cell with exact arithmetic.
void confirm(std::uint32_t size) {
  for (std::size_t i = 0; i < sheets().size(); ++i) {
    for (std::size_t row = 0; row < sheets()[i].rows.size(); ++row) {
      const auto wrong = first_wrong(i, row, size);
      INFO(name_of(sheets()[i], row)
           << ": question " << (wrong ? wrong->index : 0) << ", expected "
           << (wrong ? wrong->expected : "") << ", got " << (wrong ? wrong->got : ""));
      CHECK_FALSE(wrong);
    }
  }
}

/// The digests of all cells.
std::array<std::uint64_t, count_cells()> digests(std::uint32_t size) {
  std::array<std::uint64_t, count_cells()> cells{};
  for (std::size_t i = 0; i < sheets().size(); ++i) {
    const auto answers = answer(i, size, false);
    for (std::size_t row = 0; row < answers.size(); ++row) {
      cells[sheets()[i].cells[row]] = answers[row].digest;
    }
  }
  return cells;
}

template <class Part, class... Parts>
inline constexpr bool is_one_of = (std::is_same_v<Part, Parts> || ...);

/// Rows with yes-or-no or optional results, which should be balanced.
bool asks_yes_or_no(std::string_view row) {
  for (const std::string_view query : {"raycast",
                                       "contains/",
                                       "on/",
                                       "overlaps/",
                                       "intersects/",
                                       "mesh/raycast_nearest",
                                       "mesh/raycast_any",
                                       "mesh/raycast_hit",
                                       "mesh/overlaps/",
                                       "mesh/intersects",
                                       "height_field/raycast_nearest",
                                       "height_field/overlaps/",
                                       "scene/nearest/ray",
                                       "scene/nearest/cast",
                                       "scene/nearest/frustum",
                                       "scene/any/",
                                       "mesh/cast",
                                       "height_field/cast",
                                       "camera/project",
                                       "frustum/overlaps",
                                       "contact/",
                                       "cast/",
                                       "time_of_impact/"}) {
    if (row.starts_with(query)) return true;
  }
  return false;
}

/// How often the corpus has special cases that random inputs would miss.
struct Occasions {
  std::uint32_t starts_inside = 0, touches = 0, ends_at_hit = 0, along_axis = 0;
  std::uint32_t at_ends_of_range = 0;
};

template <class Group>
Occasions occasions() {
  Occasions seen;
  constexpr auto unit = q16_16::from_raw(1);
  visit_cases<Group, q16_16, 3>(full_size, [&](const auto& c) {
    const auto hit = raycast_interval(c.ray, c.shape);
    int zeros = 0;
    for (int i = 0; i < 3; ++i) zeros += c.ray.direction[i] == 0 ? 1 : 0;
    seen.along_axis += zeros == 2 ? 1u : 0u;
    seen.at_ends_of_range += c.ray.origin.x == largest<q16_16> ? 1u : 0u;
    if (!hit) return;
    seen.starts_inside += hit->enter == 0 ? 1u : 0u;
    seen.touches += hit->enter == hit->exit && hit->enter > 0 ? 1u : 0u;
    seen.ends_at_hit += hit->enter > 0 && c.ray.max_distance - hit->enter <= unit ? 1u : 0u;
  });
  return seen;
}

/// How often a point is exactly on a surface or at its tolerance.
struct Verges {
  std::uint32_t at_tolerance = 0, at_surface = 0, at_ends_of_range = 0, empty = 0;
};

template <class Group>
Verges verges() {
  Verges seen;
  constexpr auto unit = q16_16::from_raw(1);
  visit_cases<Group, q16_16, 3>(full_size, [&](const auto& c) {
    const auto away = distance(c.shape, c.point);
    if (away == largest<q16_16>) ++seen.empty;
    for (int i = 0; i < 3; ++i) {
      if (c.point[i] == largest<q16_16> || c.point[i] == lowest<q16_16>) ++seen.at_ends_of_range;
    }
    if (away > 0 && c.tolerance == away && on(c.shape, c.point, away)) ++seen.at_tolerance;
    if (away > 0 || !contains(c.shape, c.point)) return;
    auto beside = c.point;
    for (int i = 0; i < 3; ++i) {
      for (const auto step : {unit, q16_16::from_raw(-1)}) {
        beside[i] = nearest_to<q16_16>(c.point[i] + step);
        if (contains(c.shape, beside)) continue;
        ++seen.at_surface;
        return;
      }
      beside[i] = c.point[i];
    }
  });
  return seen;
}
/// The same for points and this type of shape.
template <template <class, int> class Shape, class S, int N>
Verges verges_at(const Shape<S, N>&) {
  return verges<Points<Kind<Shape>>>();
}

}  // namespace

TEST_CASE("corpus: has millions of questions, and a small part for microcontrollers") {
  CHECK(count_questions(full_size) >= 10'000'000);
  CHECK(count_questions(small_size) >= 30'000);
  CHECK(count_questions(small_size) <= 71'000);
  // The number in the documentation.
  CHECK(count_rows() == 228);
  CHECK(count_questions(full_size) == 13'278'492);
  CHECK(count_questions(small_size) == 70'668);
}

TEST_CASE("corpus: its parts make up the whole, in order") {
  std::size_t cells = 0, rows = 0, sheet_count = 0;
  visit_parts([&]<class Part>(Part) {
    CHECK(first_cell<Part>() == cells);
    cells += count_cells<Part>();
    rows += count_rows<Part>();
    sheet_count += count_sheets<Part>();
  });
  CHECK(cells == count_cells());
  CHECK(rows == count_rows());
  CHECK(sheet_count == sheets().size());
}

// `detent verify` answers the full corpus in another test.
TEST_CASE("corpus: between 30 and 70 percent of the answers are yes, for every query and size") {
  constexpr std::uint32_t large_size = full_size / 6;
  for (const auto size : {large_size, small_size}) {
    std::map<std::string_view, test::HitRate> rates;
    for (std::size_t i = 0; i < sheets().size(); ++i) {
      const auto& sheet = sheets()[i];
      const auto count = sheet.questions(size);
      const bool has_rates = sheet.dimension != 1 && count >= small_size;  // others have too few
      if (!has_rates || std::ranges::none_of(sheet.rows, asks_yes_or_no)) continue;
      const auto answers = answer(i, size, false);
      for (std::size_t row = 0; row < answers.size(); ++row) {
        if (!asks_yes_or_no(sheet.rows[row])) continue;
        for (std::uint32_t k = 0; k < count; ++k)
          rates[sheet.rows[row]].count(k < answers[row].yes);
      }
    }
    CHECK(rates.size() >= (size == large_size ? 100 : 50));
    for (const auto& [row, rate] : rates) {
      INFO(row << ": " << rate);
      CHECK(rate.is_balanced());
    }
  }
}

TEST_CASE("corpus: every shape is touched, started in, grazed along and hit at a ray's end") {
  const auto check = [](const char* name, const Occasions& seen) {
    INFO(name << ": inside " << seen.starts_inside << ", touches " << seen.touches << ", ends "
              << seen.ends_at_hit << ", axes " << seen.along_axis << ", range "
              << seen.at_ends_of_range);
    CHECK(seen.starts_inside >= full_size / 50);
    CHECK(seen.touches >= full_size / 100);
    CHECK(seen.ends_at_hit >= full_size / 500);
    CHECK(seen.along_axis >= full_size / 20);
    CHECK(seen.at_ends_of_range > 0);
  };
  check("sphere", occasions<AimedRays<SphereKind>>());
  check("aabb", occasions<AimedRays<AabbKind>>());
  check("obb", occasions<AimedRays<ObbKind>>());
  check("plane", occasions<AimedRays<PlaneKind>>());
  check("triangle", occasions<AimedRays<TriangleKind>>());
}

TEST_CASE(
    "corpus: points are on every surface, exactly as far off as asked, and at the world's ends") {
  const auto check = [](std::string_view name, const Verges& seen) {
    INFO(name << ": at a surface " << seen.at_surface << ", at the tolerance " << seen.at_tolerance
              << ", empty " << seen.empty << ", range " << seen.at_ends_of_range);
    CHECK(seen.at_surface >= full_size / 10);
    CHECK(seen.at_tolerance >= full_size / 200);
    CHECK(seen.at_ends_of_range > 0);
  };
  using Shapes = support::SceneShapes<q16_16, 3>::and_also<Segment<q16_16, 3>, Ray<q16_16, 3>>;
  Shapes::for_each([&](const auto& shape) { check(support::name_of(shape), verges_at(shape)); });
}

TEST_CASE("corpus: trees of meshes have several nodes, and scenes are full and reuse indices") {
  std::uint32_t deep = 0, full = 0, reused = 0, refused = 0, fixed = 0;
  visit_cases<Meshes, q16_16, 3>(full_size, [&](const auto& c) {
    if (Meshes::answer<8>(c).view().tree.nodes.size() > 1) ++deep;
  });
  visit_cases<SceneRecords, q16_16, 3>(full_size, [&](const auto& c) {
    const LivingScene<q16_16, 3> living(c.history);
    if (living.scene.size() == living.capacity) ++full;
    if (living.happened() != (1u << c.history.before) - 1) ++refused;
    if (detent::detail::SceneAccess::store(living.scene).fixed_size() != 0) ++fixed;
    std::uint32_t last = 0;
    bool is_reused = false;
    living.scene.for_each([&](const ObjectInfo& info, const auto&) {
      is_reused = is_reused || info.id.generation < last;
      last = info.id.generation;
    });
    if (is_reused) ++reused;
  });
  constexpr auto count = question_count(full_size, share_of<SceneRecords>);
  INFO("deep " << deep << ", full " << full << ", used again " << reused << ", refused " << refused
               << ", fixed " << fixed);
  CHECK(deep >= count / 20);
  CHECK(full >= count / 20);
  CHECK(reused > 0);
  CHECK(refused >= count / 10);
  CHECK(fixed >= count / 4);
}

TEST_CASE("corpus: exact arithmetic confirms the first answers of every cell") { confirm(150); }

TEST_CASE("corpus: exact arithmetic confirms every answer", "[.demand]") { confirm(full_size); }

TEST_CASE("corpus: no two sheets have the same questions") {
  std::set<std::uint64_t> digests;
  for (std::size_t i = 0; i < sheets().size(); ++i) digests.insert(digest_of_questions(i, 10));
  CHECK(digests.size() == sheets().size());
}

TEST_CASE("corpus: the digest of a cell is XXH64 of the bytes in a dump") {
  for (std::size_t i = 0; i < sheets().size(); ++i) {
    const auto kept = answer(i, 20, true), digested = answer(i, 20, false);
    for (std::size_t row = 0; row < kept.size(); ++row) {
      INFO(name_of(sheets()[i], row));
      CHECK(kept[row].digest == digested[row].digest);
      CHECK(kept[row].digest == XXH64(kept[row].bytes.data(), kept[row].bytes.size(), 0));
    }
  }
}

TEST_CASE("corpus: a smaller corpus is a prefix of a larger one") {
  for (std::size_t i = 0; i < sheets().size(); ++i) {
    const auto small = answer(i, 20, true), large = answer(i, 40, true);
    for (std::size_t row = 0; row < small.size(); ++row) {
      INFO(name_of(sheets()[i], row));
      CHECK(large[row].bytes.starts_with(small[row].bytes));
    }
  }
}

TEST_CASE("corpus: the small size gives its golden digests") {
  CHECK(digests(small_size) == golden::small);
}

TEST_CASE("corpus: the parts give the golden digests of their rows") {
  std::vector<std::uint64_t> rows;
  std::size_t cell = 0;
  visit_groups([&]<class Group>(Group) {
    for (std::size_t row = 0; row < rows_of<Group>(); ++row) {
      Digest digest;
      for (std::size_t i = 0; i < spaces_of<Group>(); ++i) digest.add(golden::small[cell++]);
      rows.push_back(digest.value());
    }
  });
  std::size_t first = 0, checked = 0;
  visit_parts([&]<class Part>(Part) {
    // The others take gigabytes to compile; tests/platforms runs them.
    if constexpr (is_one_of<Part, SolidRays, Turns, Extents>) {
      std::vector<std::uint64_t> answered;
      const auto keep = [&](const RowResult& row) { answered.push_back(row.digest); };
      CHECK(check<Part>(small_size, golden::small, keep).is_golden);
      CHECK(std::equal(answered.begin(), answered.end(), rows.begin() + std::ptrdiff_t(first)));
      checked += answered.size();
    }
    first += count_rows<Part>();
  });
  CHECK(first == rows.size());
  CHECK(checked == count_rows<SolidRays>() + count_rows<Turns>() + count_rows<Extents>());
}

TEST_CASE(
    "corpus: a quarter covers every query and dimension, and four quarters cover everything") {
  visit_groups([]<class Group>(Group) {
    // For each dimension, the scalars of each quarter as a bit mask.
    std::array<std::array<int, 4>, 4> scalars{};
    visit_spaces<Group>([&]<class S, int N>(Space<S, N>) {
      const auto add = [&](std::size_t quarter, bool has) {
        if (has) scalars[N][quarter] += 1 << scalar_index<S>;
      };
      add(0, Quarter<0>::has<Group, S, N>);
      add(1, Quarter<1>::has<Group, S, N>);
      add(2, Quarter<2>::has<Group, S, N>);
      add(3, Quarter<3>::has<Group, S, N>);
    });
    for (auto& quarters : scalars) {
      std::sort(quarters.begin(), quarters.end());
      const bool asks = quarters != std::array{0, 0, 0, 0};
      CHECK((!asks || quarters == std::array{1, 2, 4, 8}));
    }
  });
  const auto ignore = [](const RowResult&) {};
  CHECK(check<SolidRays, Quarter<1>>(small_size, golden::small, ignore).is_golden);
  auto expected = golden::small;
  for (auto& cell : expected) cell ^= 1;
  CHECK_FALSE(check<SolidRays, Quarter<1>>(small_size, expected, ignore).is_golden);
}

TEST_CASE("corpus: a single wrong golden value is a difference, and its cell is named") {
  auto expected = golden::small;
  expected[1] ^= 1;
  int different = 0;
  const auto total = check<SolidRays>(small_size, expected, [&](const RowResult& row) {
    if (row.is_golden) return;
    ++different;
    CHECK(row.name == "raycast/sphere");
    CHECK(row.scalar == "q16_16");
    CHECK(row.dimension == 3);
  });
  CHECK_FALSE(total.is_golden);
  CHECK(different == 1);
}
