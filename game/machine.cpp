// SPDX-License-Identifier: MIT
//
// Parts of the corpus of `detent verify` for the page, which checks that this machine gives the
// golden answers. DETENT_MACHINE_PARTS lists the parts, separated by commas.
#include <array>
#include <string_view>

#include "verify/check.hpp"

using namespace detent::verify;

namespace {

using Here = List<DETENT_MACHINE_PARTS>;

std::array<char, 1 << 16> text;
std::size_t size = 0;

void put(std::string_view more) {
  for (const char letter : more) {
    if (size < text.size()) text[size++] = letter;
  }
}

/// A line: name, digest, and what differs from the golden one, if anything.
void put_line(const RowResult& row) {
  put(row.name);
  put(" ");
  for (int i = 60; i >= 0; i -= 4) {
    put(std::string_view(&"0123456789abcdef"[(row.digest >> i) & 15], 1));
  }
  if (!row.is_golden) {
    put(" ");
    put(row.scalar);
    put(row.dimension == 1 ? ",1D" : row.dimension == 2 ? ",2D" : ",3D");
  }
  put("\n");
}

/// Calls visit(group, index of its first cell) for all groups of these parts.
template <class Visit>
void visit_all(const Visit& visit) {
  const auto visit_part = [&]<class Part>(Part) {
    std::size_t first = first_cell<Part>();
    visit_groups<Part>([&]<class Group>(Group group) {
      visit(group, first);
      first += rows_of<Group>() * spaces_of<Group>();
    });
  };
  [&]<class... Part>(List<Part...>) { (visit_part(Part{}), ...); }(Here{});
}

}  // namespace

#define EXPORT(name) extern "C" __attribute__((export_name(#name)))

EXPORT(text_at) char* text_at() { return text.data(); }

EXPORT(group_count) int group_count() {
  int count = 0;
  visit_all([&](auto, std::size_t) { ++count; });
  return count;
}

/// The number of queries in the whole corpus.
EXPORT(row_count) std::size_t row_count() { return count_rows<Corpus>(); }

/// The index of a group's first cell in the whole corpus.
EXPORT(first_cell_of) std::size_t first_cell_of(int number) {
  std::size_t result = 0;
  visit_all([&](auto, std::size_t first) {
    if (number-- == 0) result = first;
  });
  return result;
}

/// Runs the queries of group `number`, on all questions or on a microcontroller's share. Returns
/// the number of characters in its lines.
EXPORT(run_group) std::size_t run_group(int number, int is_full) {
  size = 0;
  visit_all([&]<class Group>(Group, std::size_t first) {
    if (number-- != 0) return;
    check_group<Group>(is_full != 0 ? full_size : small_size,
                       is_full != 0 ? golden::full : golden::small, first, put_line);
  });
  return size;
}

/// The digest of `count` digests, 8 bytes each, that the caller wrote to the text buffer.
EXPORT(digest_of) std::uint64_t digest_of(std::size_t count) {
  detent::Digest digest;
  for (std::size_t i = 0; i < count && 8 * i + 8 <= text.size(); ++i) {
    std::uint64_t word = 0;
    for (std::size_t k = 8; k-- > 0;) {
      word = word << 8 | static_cast<unsigned char>(text[8 * i + k]);
    }
    digest.add(word);
  }
  return digest.value();
}
