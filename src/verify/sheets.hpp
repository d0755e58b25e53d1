// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

// The corpus for a program with an operating system: the questions of check.hpp, in pieces for
// several threads, with the bytes of the results and an exact judge.

namespace detent::verify {

/// One group's questions for one scalar and dimension, for each of the group's rows.
struct Sheet {
  std::span<const std::string_view> rows;
  std::string_view scalar;
  int dimension = 0;
  std::uint32_t share = 1;         // it runs one in this many of the questions
  std::size_t first_row = 0;       // of the report
  std::vector<std::size_t> cells;  // for each row, its index among the golden values

  /// The number of questions per row in a corpus of this size.
  [[nodiscard]] std::uint32_t questions(std::uint32_t size) const;
};

/// All sheets, in the order of the report.
[[nodiscard]] const std::vector<Sheet>& sheets();

/// The results of one row of a sheet.
struct Answers {
  std::uint64_t digest = 0;
  std::string bytes;      // canonical, and only if requested; `digest` is their XXH64
  std::uint32_t yes = 0;  // how many are true, or have a value
};

[[nodiscard]] std::vector<Answers> answer(std::size_t sheet, std::uint32_t size, bool keep_bytes);

/// The digest of the first `size` questions of a sheet.
[[nodiscard]] std::uint64_t digest_of_questions(std::size_t sheet, std::uint32_t size);

/// A wrong result, as text.
struct Finding {
  std::uint32_t index = 0;  // of the question, from 0
  std::vector<std::pair<std::string, std::string>> question;
  std::string expected;
  std::string got;
};

/// The first of `size` results in a row of a sheet that exact arithmetic does not confirm.
[[nodiscard]] std::optional<Finding> first_wrong(std::size_t sheet, std::size_t row,
                                                 std::uint32_t size);

}  // namespace detent::verify
