// SPDX-License-Identifier: MIT
#include "verify/sheets.hpp"

#include "verify/corpus.hpp"
#include "verify/part.hpp"

namespace detent::verify {
namespace {

std::vector<Sheet> make_sheets() {
  std::vector<Sheet> sheets;
  std::size_t first_cell = 0, first_row = 0;
  visit_groups([&]<class Group>(Group) {
    constexpr auto rows = rows_of<Group>(), spaces = spaces_of<Group>();
    std::size_t space = 0;
    visit_spaces<Group>([&]<class S, int N>(Space<S, N>) {
      Sheet sheet{Group::names, scalar_name<S>, N, share_of<Group>, first_row, {}};
      for (std::size_t row = 0; row < rows; ++row) {
        sheet.cells.push_back(cell_index(first_cell, spaces, row, space));
      }
      sheets.push_back(std::move(sheet));
      ++space;
    });
    first_cell += rows * spaces;
    first_row += rows;
  });
  return sheets;
}

/// Calls `visit(PartSheets<Part>{}, index)` for the part that contains this sheet.
template <class Visit>
void visit_part(std::size_t sheet, Visit&& visit) {
  std::size_t first = 0;
  visit_parts([&]<class Part>(Part) {
    constexpr auto count = count_sheets<Part>();
    if (sheet >= first && sheet < first + count) visit(PartSheets<Part>{}, sheet - first);
    first += count;
  });
}

}  // namespace

const std::vector<Sheet>& sheets() {
  static const auto all = make_sheets();
  return all;
}

std::uint32_t Sheet::questions(std::uint32_t size) const { return question_count(size, share); }

std::vector<Answers> answer(std::size_t sheet, std::uint32_t size, bool keep_bytes) {
  std::vector<Answers> answers;
  visit_part(sheet,
             [&](auto part, std::size_t index) { answers = part.answer(index, size, keep_bytes); });
  return answers;
}

std::uint64_t digest_of_questions(std::size_t sheet, std::uint32_t size) {
  std::uint64_t digest = 0;
  visit_part(sheet,
             [&](auto part, std::size_t index) { digest = part.digest_of_questions(index, size); });
  return digest;
}

std::optional<Finding> first_wrong(std::size_t sheet, std::size_t row, std::uint32_t size) {
  std::optional<Finding> finding;
  visit_part(sheet,
             [&](auto part, std::size_t index) { finding = part.first_wrong(index, row, size); });
  return finding;
}

}  // namespace detent::verify
