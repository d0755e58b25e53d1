// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "error.hpp"

namespace detent::cli {

/// A JSON value that knows where it stood and keeps its numbers as the file wrote them.
struct JsonNode {
  enum class Kind { null, boolean, number, string, array, object };

  Kind kind = Kind::null;
  Place place;      // of its first character
  std::string key;  // when it is a member of an object
  Place key_place;
  std::string text;             // of a number as written, of a string decoded
  std::vector<JsonNode> items;  // of an array, or the members of an object in file order
};

/// The name of a kind with its article: "a number".
[[nodiscard]] const char* name_of(JsonNode::Kind kind);

/// Parses the content of `file`; throws InputError on malformed JSON, a repeated key, nesting
/// deeper than 64 or an object of more than 64 members.
[[nodiscard]] JsonNode read_json(std::string_view file, std::string_view content);

}  // namespace detent::cli
