// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include "verify/sheets.hpp"

namespace detent::verify {

/// The operations on the sheets of a part, counted from 0. Each part has its own source, which
/// CMake writes from part.cpp.in.
template <class Part>
struct PartSheets {
  static std::vector<Answers> answer(std::size_t sheet, std::uint32_t size, bool keep_bytes);
  static std::uint64_t digest_of_questions(std::size_t sheet, std::uint32_t size);
  static std::optional<Finding> first_wrong(std::size_t sheet, std::size_t row, std::uint32_t size);
};

}  // namespace detent::verify
