// SPDX-License-Identifier: MIT
#include "json_reader.hpp"

#include "support/catch.hpp"

using detent::cli::InputError;
using detent::cli::JsonNode;
using detent::cli::read_json;

namespace {

std::string error_of(const std::string& content) {
  try {
    (void)read_json("f", content);
    return "none";
  } catch (const InputError& error) {
    return error.what();
  }
}

bool starts(const std::string& text, const std::string& lead) { return text.starts_with(lead); }

std::string where(const JsonNode& node) {
  return std::to_string(node.place.line) + ':' + std::to_string(node.place.column);
}

}  // namespace

TEST_CASE("json: values keep their text and position") {
  const JsonNode root = read_json("f",
                                  "{\n"
                                  "  \"a\": [1, -2.50 ,3e1],\n"
                                  "  \"\\\"q\\\\\": \"x\\ny\", \"n\": null,\n"
                                  "\t\"big\": 123456789012345678901234567890}");
  REQUIRE(root.items.size() == 4);
  const JsonNode& array = root.items[0];
  CHECK(array.key == "a");
  CHECK(where(array) == "2:8");
  CHECK(array.key_place.column == 3);
  REQUIRE(array.items.size() == 3);
  CHECK(array.items[0].text == "1");
  CHECK(where(array.items[0]) == "2:9");
  CHECK(array.items[1].text == "-2.50");
  CHECK(where(array.items[1]) == "2:12");
  CHECK(array.items[2].text == "3e1");
  CHECK(where(array.items[2]) == "2:19");
  CHECK(root.items[1].key == "\"q\\");
  CHECK(root.items[1].text == "x\ny");
  CHECK(where(root.items[1]) == "3:12");
  CHECK(root.items[1].key_place.column == 3);
  CHECK(where(root.items[2]) == "3:25");
  CHECK(root.items[3].text == "123456789012345678901234567890");
  CHECK(where(root.items[3]) == "4:9");
}

TEST_CASE("json: columns count characters, and a byte order mark is not one") {
  CHECK(where(read_json("f", "\xef\xbb\xbf 7")) == "1:2");
  const JsonNode root = read_json("f", "[\"\xc3\xa4\xe2\x82\xac\", 7]");
  CHECK(where(root.items[1]) == "1:8");
  CHECK(root.items[1].text == "7");
}

TEST_CASE("json: a number at the end of the file is complete") {
  CHECK(read_json("f", "-12.5").text == "-12.5");
}

TEST_CASE("json: malformed text is refused at the faulty position") {
  CHECK(starts(error_of(""), "f:1:1: malformed JSON: unexpected end of input"));
  CHECK(starts(error_of("{\"a\": 1,\n  ]"), "f:2:3: malformed JSON"));
  CHECK(starts(error_of("[1 2]"), "f:1:4: malformed JSON"));
  CHECK(starts(error_of("[01]"), "f:1:2: malformed JSON"));
  CHECK(starts(error_of("[1-2]"), "f:1:2: malformed JSON"));
  CHECK(starts(error_of("[1]]"), "f:1:4: malformed JSON"));
  CHECK(starts(error_of("[nul]"), "f:1:5: malformed JSON"));
  CHECK(starts(error_of("\"abc"), "f:1:4: malformed JSON"));
  CHECK(starts(error_of("\"\xff\""), "f:1:2: malformed JSON"));
  CHECK(starts(error_of("[1, 1e999]"), "f:1:5: number too large"));
  CHECK(starts(error_of("{\"a\": 1,\n \"a\": 2}"), "f:2:2: key \"a\" appears twice"));
  CHECK(starts(error_of(std::string(100'000, '[')), "f:1:65: nested deeper than 64"));
}

TEST_CASE("json: messages quote little of long keys and strings") {
  const std::string name(100'000, 'k'), forty(40, 'k');
  CHECK(error_of("{\"" + name + "\": 1, \"" + name + "\": 2}") ==
        "f:1:100009: key \"" + forty + "...\" appears twice in one object; keep one of them");
  const auto unclosed = error_of("[\"" + name);
  CHECK(unclosed.find("last read: '..." + forty + "'") != std::string::npos);
  CHECK(unclosed.size() < 200);
  const auto unescaped = error_of("[\"" + name + "\n\"]");
  CHECK(unescaped.find("last read: '...k") != std::string::npos);
  CHECK(unescaped.size() < 250);
  CHECK(error_of("[nul]").find("last read: '[nul]'") != std::string::npos);
  // Whole characters of two bytes.
  std::string accents;
  for (int i = 0; i < 30; ++i) accents += "\u00e9";
  CHECK(error_of("{\"" + accents + "\": 1, \"" + accents + "\": 2}")
            .find(accents.substr(0, 40) + "...") != std::string::npos);
  CHECK(error_of("{\"k" + accents + "\": 1, \"k" + accents + "\": 2}")
            .find("\"k" + accents.substr(0, 38) + "...") != std::string::npos);
}

TEST_CASE("json: an object with very many keys is refused before it takes time") {
  std::string content = "{";
  for (int i = 0; i < 200'000; ++i) content += "\"" + std::to_string(i) + "\": 0,";
  CHECK(error_of(content).find("more than 64 keys") != std::string::npos);
}
