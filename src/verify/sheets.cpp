// SPDX-License-Identifier: MIT
#include "verify/sheets.hpp"

#include "verify/sink.hpp"
#include "verify/visit_sheet.hpp"

namespace detent::verify {
namespace {

/// Keeps the bytes beside their digest.
struct IntoBytes {
  Digest digest{};
  std::string bytes;

  void operator()(std::uint64_t word, int count) {
    digest.add_low_bytes(word, count);
    for (int i = 0; i < count; ++i) bytes += static_cast<char>((word >> (8 * i)) & 0xff);
  }
};

std::vector<Sheet> make_sheets() {
  std::vector<Sheet> sheets;
  std::size_t first_cell = 0, first_row = 0;
  visit_groups([&]<class Group>(Group) {
    constexpr auto rows = rows_of<Group>(), spaces = spaces_of<Group>();
    std::size_t space = 0;
    visit_spaces<Group>([&]<class S, int N>(Space<S, N>) {
      Sheet sheet{Group::names, scalar_name<S>, N, first_row, {}};
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

}  // namespace

const std::vector<Sheet>& sheets() {
  static const auto all = make_sheets();
  return all;
}

std::vector<Answers> answer(std::size_t sheet, std::uint32_t size, bool keep_bytes) {
  std::vector<Answers> answers;
  visit_sheet(sheet, [&]<class Group, class S, int N>(Group, Space<S, N>) {
    if (!keep_bytes) {
      for (const auto digest : digests_of<Group, S, N>(size)) answers.push_back({digest, {}});
      return;
    }
    std::array<Sink<IntoBytes>, rows_of<Group>()> sinks;
    visit_cases<Group, S, N>(size, [&](const auto& c) { answer_all<Group>(c, sinks); });
    for (const auto& sink : sinks) {
      answers.push_back({sink.taken().digest.value(), sink.taken().bytes});
    }
  });
  return answers;
}

std::uint64_t digest_of_questions(std::size_t sheet, std::uint32_t size) {
  Digest digest;
  visit_sheet(sheet, [&]<class Group, class S, int N>(Group, Space<S, N>) {
    visit_cases<Group, S, N>(size, [&](const auto& c) { digest.add(c); });
  });
  return digest.value();
}

}  // namespace detent::verify
