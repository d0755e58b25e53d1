// SPDX-License-Identifier: MIT
#include "json_reader.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <nlohmann/json.hpp>
#include <utility>

namespace detent::cli {
namespace {

constexpr std::size_t deepest_nesting = 64;
constexpr std::size_t most_members = 64;

/// Reads characters and counts them, so that the SAX handler knows the lexer's position.
class TrackedIterator {
 public:
  using iterator_category = std::input_iterator_tag;
  using value_type = char;
  using difference_type = std::ptrdiff_t;
  using pointer = const char*;
  using reference = const char&;

  TrackedIterator(const char* at, std::size_t* consumed) : at_(at), consumed_(consumed) {}

  reference operator*() const { return *at_; }
  TrackedIterator& operator++() {
    ++at_;
    ++*consumed_;
    return *this;
  }
  TrackedIterator operator++(int) {
    const TrackedIterator before = *this;
    ++*this;
    return before;
  }
  friend bool operator==(const TrackedIterator& a, const TrackedIterator& b) {
    return a.at_ == b.at_;
  }

 private:
  const char* at_;
  std::size_t* consumed_;
};

/// Converts increasing offsets to lines and columns; a column counts characters, not bytes.
class PlaceCounter {
 public:
  explicit PlaceCounter(std::string_view content) : content_(content) {
    if (content_.starts_with("\xef\xbb\xbf")) offset_ = 3;  // a byte order mark has no column
  }

  Place at(std::size_t offset) {
    for (; offset_ < std::min(offset, content_.size()); ++offset_) {
      const auto byte = static_cast<unsigned char>(content_[offset_]);
      if (byte == '\n') {
        ++place_.line;
        place_.column = 1;
      } else if ((byte & 0xc0) != 0x80) {
        ++place_.column;
      }
    }
    return place_;
  }

 private:
  std::string_view content_;
  std::size_t offset_ = 0;
  Place place_{1, 1};
};

bool is_number_character(char c) {
  return (c >= '0' && c <= '9') || c == '+' || c == '-' || c == '.' || c == 'e' || c == 'E';
}

/// Builds the tree. Tokens are copied from the text itself, so no number passes through a double.
class TreeBuilder : public nlohmann::json_sax<nlohmann::json> {
 public:
  TreeBuilder(std::string_view file, std::string_view content)
      : file_(file), content_(content), places_(content) {}

  std::size_t* consumed() { return &consumed_; }
  JsonNode take() { return std::move(root_); }

  bool null() override { return add(JsonNode::Kind::null, {}, consumed_ - 4); }
  bool boolean(bool value) override {
    return add(JsonNode::Kind::boolean, value ? "true" : "false", consumed_ - (value ? 4 : 5));
  }
  bool number_integer(std::int64_t) override { return number(); }
  bool number_unsigned(std::uint64_t) override { return number(); }
  bool number_float(double, const std::string&) override { return number(); }
  bool string(std::string& value) override {
    return add(JsonNode::Kind::string, std::move(value), string_start());
  }
  bool binary(nlohmann::json::binary_t&) override { return false; }  // not in JSON text

  bool start_object(std::size_t) override { return add(JsonNode::Kind::object, {}, consumed_ - 1); }
  bool start_array(std::size_t) override { return add(JsonNode::Kind::array, {}, consumed_ - 1); }
  bool end_object() override { return close(); }
  bool end_array() override { return close(); }

  bool key(std::string& name) override {
    key_place_ = places_.at(string_start());
    const auto& members = open_.back()->items;
    if (members.size() == most_members) {
      fail(key_place_, "more than " + std::to_string(most_members) +
                           " keys in one object; remove those that docs/tool.md does not list");
    }
    for (const JsonNode& member : members) {
      if (member.key == name) {
        fail(key_place_,
             "key " + in_quotes(name) + " appears twice in one object; keep one of them");
      }
    }
    key_ = std::move(name);
    return true;
  }

  bool parse_error(std::size_t, const std::string&,
                   const nlohmann::json::exception& error) override {
    if (error.id == 406) {
      fail(places_.at(number_start()), "number too large for any scalar; use a smaller one");
    }
    std::string_view what = error.what();
    for (const std::string_view lead : {"syntax error while parsing ", " - "}) {
      if (const auto at = what.find(lead); at != std::string_view::npos) {
        what.remove_prefix(at + lead.size());
      }
    }
    std::string reason = with_short_quote(what);
    std::replace(reason.begin(), reason.end(), ';', ',');
    fail(places_.at(error_start(what)), "malformed JSON: " + reason + "; correct the file here");
    return false;
  }

 private:
  [[noreturn]] void fail(Place place, const std::string& what) const {
    throw InputError(file_, place, what);
  }

  /// The parser's message, which quotes a whole token: a string may be the rest of the file.
  static std::string with_short_quote(std::string_view what) {
    constexpr std::string_view lead = "last read: '";
    const auto lead_at = what.find(lead);
    if (lead_at == std::string_view::npos) return std::string(what);
    const auto start = lead_at + lead.size();
    const auto end = std::max(start, std::min(what.rfind("'; expected "), what.size() - 1));
    return std::string(what.substr(0, start))
        .append(end_of(what.substr(start, end - start)))
        .append(what.substr(end));
  }

  /// Where the unexpected token begins, or the character that cannot begin a token.
  std::size_t error_start(std::string_view what) const {
    if (what.starts_with("unexpected end of input")) return consumed_;
    if (what.starts_with("unexpected number literal")) return number_start();
    if (what.starts_with("unexpected string literal")) return string_start();
    std::size_t length = 1;
    if (what.starts_with("unexpected true") || what.starts_with("unexpected null")) length = 4;
    if (what.starts_with("unexpected false")) length = 5;
    return consumed_ - std::min(consumed_, length);
  }

  std::size_t number_end() const {
    const bool read_past = consumed_ > 0 && !is_number_character(content_[consumed_ - 1]);
    return consumed_ - (read_past ? 1 : 0);
  }

  std::size_t number_start() const {
    std::size_t start = number_end();
    while (start > 0 && is_number_character(content_[start - 1])) --start;
    return start;
  }

  /// Where the string that ends at the lexer's position begins: at the nearest quotation mark
  /// before its end that is preceded by an even number of backslashes.
  std::size_t string_start() const {
    std::size_t start = consumed_ - 1;
    while (start > 0) {
      --start;
      if (content_[start] != '"') continue;
      std::size_t slashes = 0;
      while (slashes < start && content_[start - 1 - slashes] == '\\') ++slashes;
      if (slashes % 2 == 0) break;
    }
    return start;
  }

  bool number() {
    const std::size_t start = number_start();
    return add(JsonNode::Kind::number, std::string(content_.substr(start, number_end() - start)),
               start);
  }

  bool add(JsonNode::Kind kind, std::string text, std::size_t start) {
    JsonNode node{kind, places_.at(start), {}, {}, std::move(text), {}};
    if (open_.empty()) {
      root_ = std::move(node);
      if (is_container(kind)) open_.push_back(&root_);
      return true;
    }
    if (open_.size() == deepest_nesting) {
      fail(node.place, "nested deeper than " + std::to_string(deepest_nesting) +
                           " levels; scenes and worlds need no more than seven");
    }
    JsonNode& parent = *open_.back();
    if (parent.kind == JsonNode::Kind::object) {
      node.key = std::move(key_);
      node.key_place = key_place_;
    }
    parent.items.push_back(std::move(node));
    // Only the last item of a container is ever open, so its address stays valid meanwhile.
    if (is_container(kind)) open_.push_back(&parent.items.back());
    return true;
  }

  static bool is_container(JsonNode::Kind kind) {
    return kind == JsonNode::Kind::array || kind == JsonNode::Kind::object;
  }

  bool close() {
    open_.pop_back();
    return true;
  }

  std::string file_;
  std::string_view content_;
  PlaceCounter places_;
  std::size_t consumed_ = 0;
  JsonNode root_;
  std::vector<JsonNode*> open_;
  std::string key_;
  Place key_place_;
};

}  // namespace

const char* name_of(JsonNode::Kind kind) {
  switch (kind) {
    case JsonNode::Kind::null:
      return "null";
    case JsonNode::Kind::boolean:
      return "true or false";
    case JsonNode::Kind::number:
      return "a number";
    case JsonNode::Kind::string:
      return "a string";
    case JsonNode::Kind::array:
      return "an array";
    case JsonNode::Kind::object:
      return "an object";
  }
  return "";
}

JsonNode read_json(std::string_view file, std::string_view content) {
  // The parser would treat a zero byte as the end of the text.
  if (const auto zero = content.find('\0'); zero != std::string_view::npos) {
    throw InputError(file, PlaceCounter(content).at(zero),
                     "malformed JSON: a zero byte; save the file as UTF-8 text");
  }
  TreeBuilder builder(file, content);
  const char* const begin = content.data();
  nlohmann::json::sax_parse(TrackedIterator(begin, builder.consumed()),
                            TrackedIterator(begin + content.size(), builder.consumed()), &builder);
  return builder.take();
}

}  // namespace detent::cli
