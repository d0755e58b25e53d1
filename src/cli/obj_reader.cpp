// SPDX-License-Identifier: MIT
#include "obj_reader.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <span>
#include <string_view>

#include "file.hpp"
#include "polygon.hpp"

namespace detent::cli {
namespace {

bool is_line_end(char c) { return c == '\n' || c == '\r'; }

/// The words of a text, line by line. A backslash at the end of a line continues it.
class Words {
 public:
  explicit Words(std::string_view text) : text_(text) {
    if (text_.starts_with("\xef\xbb\xbf")) text_.remove_prefix(3);
  }

  [[nodiscard]] bool has_line() const { return at_ < text_.size(); }

  /// The next word of the line; empty at the end of the line or before a comment.
  std::string_view next() {
    while (at_ < text_.size() && (is_blank() || is_continued())) {
      if (is_blank()) {
        ++at_;
      } else {
        ++at_;
        end_line();
      }
    }
    place_ = {line_, static_cast<int>(at_ - line_start_) + 1};
    const std::size_t start = at_;
    if (at_ < text_.size() && text_[at_] == '#') return {};
    while (at_ < text_.size() && !is_blank() && !is_line_end(text_[at_]) && !is_continued()) ++at_;
    return text_.substr(start, at_ - start);
  }

  void end_line() {
    while (at_ < text_.size() && !is_line_end(text_[at_])) ++at_;
    if (at_ < text_.size()) at_ += text_.substr(at_).starts_with("\r\n") ? 2 : 1;
    ++line_;
    line_start_ = at_;
  }

  /// The position of the last word read.
  [[nodiscard]] Place place() const { return place_; }

 private:
  [[nodiscard]] bool is_blank() const { return text_[at_] == ' ' || text_[at_] == '\t'; }
  [[nodiscard]] bool is_continued() const {
    return text_[at_] == '\\' && at_ + 1 < text_.size() && is_line_end(text_[at_ + 1]);
  }

  std::string_view text_;
  std::size_t at_ = 0;
  std::size_t line_start_ = 0;
  int line_ = 1;
  Place place_;
};

std::optional<double> number(std::string_view word) {
  if (word.starts_with('+') && !word.starts_with("+-")) word.remove_prefix(1);
  double value = 0;
  const auto [stop, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (stop != word.data() + word.size() || error == std::errc::invalid_argument) return {};
  // Underflow gives 0, overflow infinity.
  if (error == std::errc::result_out_of_range)
    value = std::strtod(std::string(word).c_str(), nullptr);
  return value;
}

/// Parses a word of a face, "3", "3/1", "3//2" or "3/1/2": its first number, clamped to the range
/// of the type.
std::optional<std::int64_t> vertex_number(std::string_view word) {
  std::optional<std::int64_t> first;
  const char* at = word.data();
  const char* const end = at + word.size();
  for (int slashes = 0; slashes <= 2; ++slashes) {
    std::int64_t value = 0;
    const auto [stop, error] = std::from_chars(at, end, value);
    if (error == std::errc::result_out_of_range) {
      value = *at == '-' ? std::numeric_limits<std::int64_t>::min()
                         : std::numeric_limits<std::int64_t>::max();
    }
    if (slashes == 0) {
      if (error == std::errc::invalid_argument) return {};
      first = value;
    }
    at = stop;
    if (at == end) return first;
    if (*at++ != '/') return {};
  }
  return {};
}

class ObjReader {
 public:
  ObjReader(const std::string& file, std::string_view content) : file_(file), words_(content) {}

  MeshModel read() {
    for (; words_.has_line(); words_.end_line()) {
      const std::string_view word = words_.next();
      if (word == "v") {
        read_vertex();
      } else if (word == "f") {
        read_face();
      }
    }
    PolygonCutter cutter(mesh_.vertices);
    for (const Face& face : faces_) cut(cutter, face);
    if (mesh_.triangles.empty()) {
      throw InputError(file_, {}, "has no triangles; name a Wavefront OBJ model with faces");
    }
    return std::move(mesh_);
  }

 private:
  /// Its corners are those from `first` to `end` in `corners_`.
  struct Face {
    Place place;
    std::size_t first;
    std::size_t end;
  };

  [[noreturn]] void fail(Place place, const std::string& what) const {
    throw InputError(file_, place, what + "; export the model again");
  }

  [[noreturn]] void fail_vertex(Place place, const std::string& number) const {
    fail(place, "the face names vertex " + number + ", and the model has 1 to " +
                    std::to_string(mesh_.vertices.size()));
  }

  /// A weight and a colour may follow the three coordinates.
  void read_vertex() {
    std::array<double, 3> vertex{};
    const auto which = [&] { return "vertex " + std::to_string(mesh_.vertices.size() + 1); };
    for (std::size_t i = 0;; ++i) {
      const std::string_view word = words_.next();
      if (word.empty() && i >= 3) break;
      const auto value = number(word);
      if (!value) {
        fail(words_.place(), which() + (word.empty() ? " has fewer than three coordinates"
                                                     : " has a coordinate that is not a number"));
      }
      if (i >= 3) continue;
      if (!std::isfinite(*value)) fail(words_.place(), which() + " is not finite");
      vertex[i] = *value;
    }
    mesh_.vertices.push_back(vertex);
  }

  /// Negative numbers count back from the last vertex so far; others may name later vertices.
  void read_face() {
    constexpr std::int64_t most = std::numeric_limits<std::uint32_t>::max();
    Face face{words_.place(), corners_.size(), 0};
    for (auto word = words_.next(); !word.empty(); word = words_.next()) {
      const auto number = vertex_number(word);
      if (!number)
        fail(words_.place(),
             "the face has a corner that is not written like 1, 1/2, 1//3 or 1/2/3");
      const auto seen = static_cast<std::int64_t>(mesh_.vertices.size());
      if (*number == 0 || *number < -seen || *number > most) {
        fail_vertex(words_.place(), std::string(word.substr(0, word.find('/'))));
      }
      corners_.push_back(static_cast<std::uint32_t>(*number < 0 ? seen + *number : *number - 1));
    }
    face.end = corners_.size();
    faces_.push_back(face);
  }

  /// A face with fewer than three corners is skipped.
  void cut(PolygonCutter& cutter, const Face& face) {
    const auto corners = std::span(corners_).subspan(face.first, face.end - face.first);
    for (const auto corner : corners) {
      if (corner >= mesh_.vertices.size()) {
        fail_vertex(face.place, std::to_string(std::uint64_t{corner} + 1));
      }
    }
    if (corners.size() < 3) return;
    if (!cutter.cut(corners, mesh_.triangles)) {
      throw InputError(file_, face.place,
                       "the face has " + std::to_string(corners.size()) +
                           " corners and takes too long to cut into triangles; export the model "
                           "as triangles");
    }
  }

  const std::string& file_;
  Words words_;
  MeshModel mesh_;
  std::vector<std::uint32_t> corners_;
  std::vector<Face> faces_;
};

/// Halves before adding and subtracting: the sums could overflow a double.
void center_and_scale(const std::string& file, MeshModel& mesh, std::optional<double> scale) {
  std::array<double, 3> low = mesh.vertices.front();
  std::array<double, 3> high = low;
  for (const auto& vertex : mesh.vertices) {
    for (std::size_t i = 0; i < 3; ++i) {
      low[i] = std::min(low[i], vertex[i]);
      high[i] = std::max(high[i], vertex[i]);
    }
  }
  double longest_half = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    longest_half = std::max(longest_half, high[i] / 2 - low[i] / 2);
  }
  const double factor =
      scale.value_or(longest_half > 0 ? default_model_size / 2 / longest_half : 1);
  for (auto& vertex : mesh.vertices) {
    for (std::size_t i = 0; i < 3; ++i) {
      vertex[i] = (vertex[i] - (low[i] / 2 + high[i] / 2)) * factor;
      if (!std::isfinite(vertex[i])) {
        throw InputError(file, {}, "cannot be scaled to its size; export the model in other units");
      }
    }
  }
}

}  // namespace

MeshModel parse_obj(const std::string& file, const std::string& content,
                    std::optional<double> scale) {
  MeshModel mesh = ObjReader(file, content).read();
  center_and_scale(file, mesh, scale);
  return mesh;
}

MeshModel read_obj(const std::string& file, std::optional<double> scale) {
  return parse_obj(file, read_file(file), scale);
}

}  // namespace detent::cli
