// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "json_reader.hpp"
#include "scene.hpp"

namespace detent::cli {

/// Reads the fields of a JSON file; anything invalid throws an InputError with its position and
/// what to write.
class JsonFields {
 protected:
  using Kind = JsonNode::Kind;
  using Keys = std::vector<std::string_view>;

  explicit JsonFields(std::string file) : file_(std::move(file)) {}

  [[noreturn]] void fail(const JsonNode& node, const std::string& what) const;
  void expect(const JsonNode& node, Kind kind, const std::string& name) const;
  /// Fails if the object has another key.
  void allow_keys(const JsonNode& object, const std::string& owner, const Keys& keys) const;
  /// The member with this key, or nullptr.
  [[nodiscard]] static const JsonNode* find(const JsonNode& object, std::string_view key);
  [[nodiscard]] const JsonNode& need(const JsonNode& object, std::string_view key,
                                     const std::string& owner) const;
  [[nodiscard]] const JsonNode& need(const JsonNode& object, std::string_view key, Kind kind,
                                     const std::string& owner) const;
  [[nodiscard]] Literal number(const JsonNode& node, std::string_view name) const;
  [[nodiscard]] Literal number(const JsonNode& object, std::string_view key,
                               const std::string& owner) const;
  [[nodiscard]] Literal not_negative(const JsonNode& node, std::string_view name) const;
  [[nodiscard]] Point point(const JsonNode& node, std::string_view name) const;
  [[nodiscard]] Point point(const JsonNode& object, std::string_view key,
                            const std::string& owner) const;
  [[nodiscard]] Point direction(const JsonNode& node, std::string_view name) const;
  [[nodiscard]] Point direction(const JsonNode& object, std::string_view key,
                                const std::string& owner) const;
  /// `{"position", "target", "up", "field_of_view"}`; see docs/tool.md.
  [[nodiscard]] CameraModel camera(const JsonNode& node) const;
  /// No rotation without a node; in two dimensions an angle.
  [[nodiscard]] Turn rotation(const JsonNode* node) const;
  [[nodiscard]] Colour colour(const JsonNode& node) const;
  /// The OBJ model that `file` names, from the folder of this file, with its `scale` if there is one.
  [[nodiscard]] MeshModel model_file(const JsonNode& node, const std::string& owner) const;
  /// Fails if another one has this id.
  void keep_unique(std::map<std::string, Place>& names, const std::optional<std::string>& id,
                   Place place, const char* what) const;

  std::string file_;
  int dimension_ = 3;  // of points
};

}  // namespace detent::cli
