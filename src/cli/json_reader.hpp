// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "error.hpp"

namespace detent::cli {

/// A JSON value with its position in the file and its numbers as written there.
struct JsonNode {
  enum class Kind { null, boolean, number, string, array, object };

  Kind kind = Kind::null;
  Place place;      // of its first character
  std::string key;  // when it is a member of an object
  Place key_place;
  std::string text;             // a number as written, or a string decoded
  std::vector<JsonNode> items;  // items of an array, or members of an object in file order
};

/// The name of a kind with its article: "a number".
[[nodiscard]] const char* name_of(JsonNode::Kind kind);

/// Parses the content of `file`; throws InputError on malformed JSON, a repeated key, nesting
/// deeper than 64 or an object with more than 64 members.
[[nodiscard]] JsonNode read_json(std::string_view file, std::string_view content);

}  // namespace detent::cli
