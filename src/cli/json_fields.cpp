// SPDX-License-Identifier: MIT
#include "json_fields.hpp"

#include <charconv>
#include <filesystem>
#include <system_error>

#include "obj_reader.hpp"

namespace detent::cli {

namespace {

std::string listed(const std::vector<std::string_view>& keys) {
  std::string text;
  for (const std::string_view key : keys) text.append(text.empty() ? "" : ", ").append(key);
  return text;
}

}  // namespace

void JsonFields::fail(const JsonNode& node, const std::string& what) const {
  throw InputError(file_, node.place, what);
}

void JsonFields::expect(const JsonNode& node, Kind kind, const std::string& name) const {
  if (node.kind == kind) return;
  fail(node, name + " is " + name_of(node.kind) + "; write " + name_of(kind));
}

void JsonFields::allow_keys(const JsonNode& object, const std::string& owner,
                            const Keys& keys) const {
  for (const JsonNode& member : object.items) {
    bool known = false;
    for (const std::string_view key : keys) known = known || key == member.key;
    if (known) continue;
    throw InputError(
        file_, member.key_place,
        "unknown key " + in_quotes(member.key) + " in " + owner + "; it may have " + listed(keys));
  }
}

const JsonNode* JsonFields::find(const JsonNode& object, std::string_view key) {
  for (const JsonNode& member : object.items) {
    if (member.key == key) return &member;
  }
  return nullptr;
}

const JsonNode& JsonFields::need(const JsonNode& object, std::string_view key,
                                 const std::string& owner) const {
  if (const JsonNode* const member = find(object, key)) return *member;
  fail(object, owner + " has no " + in_quotes(key) + "; add it");
}

const JsonNode& JsonFields::need(const JsonNode& object, std::string_view key, Kind kind,
                                 const std::string& owner) const {
  const JsonNode& member = need(object, key, owner);
  expect(member, kind, std::string(key));
  return member;
}

Literal JsonFields::number(const JsonNode& node, std::string_view name) const {
  expect(node, Kind::number, std::string(name));
  const auto value = Decimal::parse(node.text);
  if (!value) {
    fail(node, std::string(name) + " is longer than " + std::to_string(Decimal::max_length) +
                   " digits; no scalar holds it, use a shorter number");
  }
  return {*value, node.place};
}

Literal JsonFields::number(const JsonNode& object, std::string_view key,
                           const std::string& owner) const {
  return number(need(object, key, owner), key);
}

Literal JsonFields::not_negative(const JsonNode& node, std::string_view name) const {
  Literal value = number(node, name);
  if (value.value.is_negative()) fail(node, std::string(name) + " is negative; use 0 or more");
  return value;
}

Point JsonFields::point(const JsonNode& node, std::string_view name) const {
  expect(node, Kind::array, std::string(name));
  if (node.items.size() != static_cast<std::size_t>(dimension_)) {
    fail(node, std::string(name) + " has " + std::to_string(node.items.size()) +
                   " numbers; write " + (dimension_ == 2 ? "two: [x, y]" : "three: [x, y, z]"));
  }
  Point point = point_of("0", "0", "0");
  for (std::size_t i = 0; i < node.items.size(); ++i) point[i] = number(node.items[i], name);
  return point;
}

Point JsonFields::point(const JsonNode& object, std::string_view key,
                        const std::string& owner) const {
  return point(need(object, key, owner), key);
}

Point JsonFields::direction(const JsonNode& node, std::string_view name) const {
  Point vector = point(node, name);
  if (vector[0].value.is_zero() && vector[1].value.is_zero() && vector[2].value.is_zero()) {
    fail(node, std::string(name) + " is the zero vector; give it a direction");
  }
  return vector;
}

Point JsonFields::direction(const JsonNode& object, std::string_view key,
                            const std::string& owner) const {
  return direction(need(object, key, owner), key);
}

CameraModel JsonFields::camera(const JsonNode& node) const {
  const std::string owner = "the camera";
  expect(node, Kind::object, owner);
  allow_keys(node, owner, {"position", "target", "up", "field_of_view"});
  CameraModel camera{node.place,
                     point(node, "position", owner),
                     point(node, "target", owner),
                     point_of("0", "1", "0"),
                     {Decimal::parse("60").value(), node.place}};
  if (const JsonNode* const up = find(node, "up")) camera.up = direction(*up, "up");
  if (const JsonNode* const angle = find(node, "field_of_view")) {
    camera.field_of_view = number(*angle, "field_of_view");
    const auto degrees = camera.field_of_view.value.to<double>();
    if (!degrees || *degrees <= 0 || *degrees >= 180) {
      fail(*angle, "field_of_view must lie between 0 and 180 degrees; 60 is usual");
    }
  }
  return camera;
}

Turn JsonFields::rotation(const JsonNode* node) const {
  if (!node) return {};
  if (dimension_ == 2) return FlatTurn{number(*node, "rotation")};
  const std::string owner = "the rotation";
  expect(*node, Kind::object, owner);
  allow_keys(*node, owner, {"axis", "angle", "euler"});
  if (const JsonNode* const euler = find(*node, "euler")) {
    if (node->items.size() > 1) fail(*node, "rotation mixes euler with axis; keep one of them");
    return EulerAngles{point(*euler, "euler")};
  }
  return AxisAngle{direction(*node, "axis", owner), number(*node, "angle", owner)};
}

MeshModel JsonFields::model_file(const JsonNode& node, const std::string& owner) const {
  const JsonNode& file = need(node, "file", Kind::string, owner);
  if (file.text.empty()) fail(file, "file is empty; name a model in OBJ");
  if (file.text.find('\0') != std::string::npos) {
    fail(file, "file contains a zero byte, which file names cannot; remove it");
  }
  std::optional<double> scale;
  if (const JsonNode* const text = find(node, "scale")) {
    scale = number(*text, "scale").value.to<double>();
    if (!scale || *scale <= 0) fail(*text, "scale must be more than 0; 1 keeps the model's size");
  }
  const auto path = std::filesystem::path(file_).parent_path() / file.text;
  if (std::error_code error; !std::filesystem::exists(path, error)) {
    fail(file, "there is no file " + in_quotes(file.text) +
                   " in the folder of this one; correct its name");
  }
  return read_obj(path.string(), scale);
}

Colour JsonFields::colour(const JsonNode& node) const {
  expect(node, Kind::string, "color");
  unsigned value = 0;
  const char* const begin = node.text.data();
  const char* const end = begin + node.text.size();
  bool valid = node.text.size() == 7 && node.text.front() == '#';
  if (valid) {
    const auto [stop, error] = std::from_chars(begin + 1, end, value, 16);
    valid = error == std::errc() && stop == end;
  }
  if (!valid)
    fail(node,
         "color " + in_quotes(node.text) + " is not a color; write, for example, \"#c96f4a\"");
  return {static_cast<std::uint8_t>(value >> 16), static_cast<std::uint8_t>((value >> 8) & 0xff),
          static_cast<std::uint8_t>(value & 0xff)};
}

void JsonFields::keep_unique(std::map<std::string, Place>& names,
                             const std::optional<std::string>& id, Place place,
                             const char* what) const {
  if (!id) return;
  const auto [first, inserted] = names.try_emplace(*id, place);
  if (inserted) return;
  throw InputError(file_, place,
                   std::string(what) + " id " + in_quotes(*id) + " is taken by the one on line " +
                       std::to_string(first->second.line) + "; choose another");
}

}  // namespace detent::cli
