// SPDX-License-Identifier: MIT
#include "verify/judge.hpp"

#include "verify/sheets.hpp"
#include "verify/visit_sheet.hpp"

namespace detent::verify {
namespace {

template <int Row, class Group, Scalar S, int N>
std::optional<Finding> first_wrong_answer(std::uint32_t size) {
  std::optional<Finding> finding;
  std::uint32_t index = 0;
  visit_cases<Group, S, N>(size, [&](const auto& c) {
    if (!finding) {
      if (auto wrong = judge::judge<Row>(c, Group::template answer<Row>(c))) {
        finding = Finding{index, fields_of(c), std::move(wrong->expected), std::move(wrong->got)};
      }
    }
    ++index;
  });
  return finding;
}

}  // namespace

std::optional<Finding> first_wrong(std::size_t sheet, std::size_t row, std::uint32_t size) {
  std::optional<Finding> finding;
  visit_sheet(sheet, [&]<class Group, class S, int N>(Group, Space<S, N>) {
    [&]<std::size_t... Row>(std::index_sequence<Row...>) {
      const auto look = [&]<std::size_t R>(std::integral_constant<std::size_t, R>) {
        if (R == row) finding = first_wrong_answer<static_cast<int>(R), Group, S, N>(size);
      };
      (look(std::integral_constant<std::size_t, Row>{}), ...);
    }
    (std::make_index_sequence<rows_of<Group>()>{});
  });
  return finding;
}

}  // namespace detent::verify
