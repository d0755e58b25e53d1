// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "detent/version.hpp"
#include "verify/corpus.hpp"
#include "verify/golden.hpp"

namespace detent::verify {

static_assert(golden::results_version == results_version,
              "detent: the golden values are those of another version of the results; see "
              "docs/verify.md");
static_assert(golden::full.size() == count_cells(),
              "detent: the corpus has other rows than the golden values; see docs/verify.md");

/// A row of the report.
struct RowResult {
  std::string_view name;
  std::uint64_t digest;
  bool is_golden;
  std::string_view scalar;  // of the first cell that differs
  int dimension;
};

/// All rows of a part together.
struct TotalResult {
  std::uint64_t digest;
  bool is_golden;
};

/// Runs `size` questions in every cell of a group, whose first cell has the index `first`, or of a
/// `Quarter` of it; calls `report(RowResult)` for every row.
template <class Group, class Share = Whole, class Report>
constexpr void check_group(std::uint32_t size,
                           const std::array<std::uint64_t, count_cells()>& expected,
                           std::size_t first, Report report) {
  constexpr auto rows = rows_of<Group>(), spaces = spaces_of<Group>();
  std::array<Digest, rows> digests{};
  std::array<RowResult, rows> results{};
  for (std::size_t row = 0; row < rows; ++row) results[row] = {Group::names[row], 0, true, {}, 0};
  std::size_t index = 0;
  visit_spaces<Group>([&]<class S, int N>(Space<S, N>) {
    const auto space = index++;
    if constexpr (Share::template has<Group, S, N>) {
      const auto cells = digests_of<Group, S, N>(size);
      for (std::size_t row = 0; row < rows; ++row) {
        digests[row].add(cells[row]);
        if (cells[row] == expected[cell_index(first, spaces, row, space)]) continue;
        if (!results[row].is_golden) continue;
        results[row] = {Group::names[row], 0, false, scalar_name<S>, N};
      }
    }
  });
  for (std::size_t row = 0; row < rows; ++row) {
    results[row].digest = digests[row].value();
    report(results[row]);
  }
}

/// Runs `size` questions in every cell of a part (or a `Quarter` of them), calls
/// `report(RowResult)` for every row, and compares with the golden digests of that size.
template <class Part = Corpus, class Share = Whole, class Report>
[[nodiscard]] constexpr TotalResult check(std::uint32_t size,
                                          const std::array<std::uint64_t, count_cells()>& expected,
                                          Report report) {
  Digest all;
  bool is_golden = true;
  std::size_t first = first_cell<Part>();
  visit_groups<Part>([&]<class Group>(Group) {
    check_group<Group, Share>(size, expected, first, [&](const RowResult& row) {
      all.add(row.digest);
      is_golden = is_golden && row.is_golden;
      report(row);
    });
    first += rows_of<Group>() * spaces_of<Group>();
  });
  return {all.value(), is_golden};
}

}  // namespace detent::verify
