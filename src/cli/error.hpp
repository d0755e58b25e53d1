// SPDX-License-Identifier: MIT
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

namespace detent::cli {

/// A position in a text file, counted from 1; line 0 means the whole file.
struct Place {
  int line = 0;
  int column = 0;
};

/// What is wrong with the input or the command, and how the user can fix it.
///
/// The text is a complete line: "FILE:LINE:COLUMN: what is wrong; remedy". All errors with a cause
/// outside the program end up here; `main` prints the line and exits with 2. Control characters
/// become spaces, because a zero byte would cut the text.
class InputError : public std::runtime_error {
 public:
  explicit InputError(std::string_view what);
  InputError(std::string_view file, Place place, std::string_view what);
};

/// `text` on one line without control characters, so that no input can forge a second line.
[[nodiscard]] std::string one_line(std::string_view text);

/// `name` in quotation marks. Truncates long names, so that a message stays readable whatever the
/// file contains.
[[nodiscard]] std::string in_quotes(std::string_view name);

/// The last characters of `text`, after an ellipsis if it is long: what a reader saw before an error.
[[nodiscard]] std::string end_of(std::string_view text);

}  // namespace detent::cli
