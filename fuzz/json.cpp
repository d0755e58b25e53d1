// SPDX-License-Identifier: MIT
//
// Reading a file of any bytes as a scene or as a world gives a value or an error that names the
// file. The tokens of the tree are at their reported positions, and no other exception leaves the
// reader.

#include <string>
#include <string_view>

#include "json_reader.hpp"
#include "property.hpp"
#include "scene_reader.hpp"
#include "world_model.hpp"

namespace detent::fuzz {
namespace {

using cli::InputError;
using cli::JsonNode;

class Tree {
 public:
  explicit Tree(std::string_view content) : content_(content) {}

  void check(const JsonNode& node) const {
    const auto at = offset(node.place);
    require(at < content_.size(), [] { return std::string("a place beyond the end"); });
    const auto here = content_.substr(at);
    const auto because = [&] { return "a token is not where it is said to be: " + node.text; };
    switch (node.kind) {
      case JsonNode::Kind::number:
        return require(!node.text.empty() && here.starts_with(node.text), because);
      case JsonNode::Kind::null:
        return require(here.starts_with("null"), because);
      case JsonNode::Kind::boolean:
        return require(here.starts_with(node.text), because);
      case JsonNode::Kind::string:
        return require(here.starts_with('"'), because);
      case JsonNode::Kind::array:
        require(here.starts_with('['), because);
        break;
      case JsonNode::Kind::object:
        require(here.starts_with('{'), because);
        break;
    }
    for (const auto& item : node.items) check(item);
  }

 private:
  /// Columns count characters; a byte order mark is not one.
  [[nodiscard]] std::size_t offset(cli::Place place) const {
    std::size_t at = content_.starts_with("\xef\xbb\xbf") ? 3 : 0;
    for (int line = 1; line < place.line; ++line) at = content_.find('\n', at) + 1;
    for (int column = 1; at < content_.size(); ++at) {
      const bool starts = (static_cast<unsigned char>(content_[at]) & 0xc0) != 0x80;
      if (starts && column++ == place.column) break;
    }
    return at;
  }

  std::string_view content_;
};

/// Whether `read` returns; if it throws, the error must name the file.
template <class Read>
bool returns(const Read& read) {
  try {
    read();
    return true;
  } catch (const InputError& error) {
    const std::string_view what = error.what();
    require(what.starts_with("f/"), [&] { return "names no file: " + std::string(what); });
    return false;
  }
}

}  // namespace

void property(Bytes input) {
  const std::string content(reinterpret_cast<const char*>(input.data()), input.size());
  const bool is_json = returns([&] { Tree(content).check(cli::read_json("f/f", content)); });
  // A mesh may name any file; here only names of missing files are allowed.
  if (content.find('/') != std::string::npos || content.find("\\u") != std::string::npos) return;
  const bool is_scene = returns([&] { (void)cli::parse_scene("f/f", content); });
  const bool is_world = returns([&] { (void)cli::parse_world("f/f", content); });
  require(is_json || !is_scene, [] { return std::string("a scene that is no JSON"); });
  require(is_json || !is_world, [] { return std::string("a world that is no JSON"); });
  require(!is_scene || !is_world, [] { return std::string("a scene that is a world"); });
}

}  // namespace detent::fuzz
