// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

// The corpus for a program that runs under an operating system: the same questions as check.hpp
// asks, in pieces that several threads can take, with the answers' bytes and an exact judge.

namespace detent::verify {

/// One group's questions to one scalar in one dimension, for each of the group's rows.
struct Sheet {
  std::span<const std::string_view> rows;
  std::string_view scalar;
  int dimension = 0;
  std::uint32_t share = 1;         // it asks one in so many of the questions
  std::size_t first_row = 0;       // of the report
  std::vector<std::size_t> cells;  // for each row, its place among the golden values

  /// How many questions each of its rows asks in a corpus of this size.
  [[nodiscard]] std::uint32_t questions(std::uint32_t size) const;
};

/// All sheets, in the order of the report.
[[nodiscard]] const std::vector<Sheet>& sheets();

/// The answers to one row of a sheet.
struct Answers {
  std::uint64_t digest = 0;
  std::string bytes;  // canonical, and only when asked for; `digest` is their XXH64
};

[[nodiscard]] std::vector<Answers> answer(std::size_t sheet, std::uint32_t size, bool keep_bytes);

/// The digest of the first `size` questions of a sheet.
[[nodiscard]] std::uint64_t digest_of_questions(std::size_t sheet, std::uint32_t size);

/// A wrong answer, in words.
struct Finding {
  std::uint32_t index = 0;  // of the question, from 0
  std::vector<std::pair<std::string, std::string>> question;
  std::string expected;
  std::string got;
};

/// The first of `size` answers to a row of a sheet that exact arithmetic does not confirm.
[[nodiscard]] std::optional<Finding> first_wrong(std::size_t sheet, std::size_t row,
                                                 std::uint32_t size);

}  // namespace detent::verify
