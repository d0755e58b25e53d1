// SPDX-License-Identifier: MIT
#include "diff.hpp"

#include <map>
#include <span>
#include <utility>
#include <vector>

#include "commands.hpp"
#include "detent/scene/header.hpp"
#include "detent/scene/height_field/instance.hpp"
#include "detent/scene/hull/instance.hpp"
#include "detent/scene/mesh/instance.hpp"
#include "detent/scene/shape_tag.hpp"
#include "error.hpp"
#include "file.hpp"
#include "numbers.hpp"
#include "print.hpp"
#include "support/shapes.hpp"

namespace detent::cli {
namespace {

using detail::Reader;
using detail::SnapshotHeader;
using detail::SnapshotSpace;

constexpr const char* remedy = "; take a new one with snapshot(scene)";

/// A named number of a snapshot, as text.
struct Field {
  std::string name;
  std::string value;
};

/// A frame or an object: anything with an id.
struct Part {
  std::uint32_t generation = 0;
  std::string type;
  std::vector<Field> fields;
};
using Parts = std::map<std::uint32_t, Part>;

struct Contents {
  SnapshotHeader header;
  Parts frames;
  Parts objects;
};

/// Reads the frames and objects of a snapshot, with the names of their fields.
template <Scalar S, int N>
class PartReader {
 public:
  PartReader(const std::string& file, std::span<const std::byte> bytes) : file_(file), in_(bytes) {}

  /// Rejects what `restore` rejects in every scene (tests/cli/diff.test.cpp).
  Contents read(const SnapshotHeader& header) {
    if (header.shapes == 0 || (header.shapes & ~known_types) != 0) fail();
    if (header.next_generation == 0) fail();
    Contents contents{header, {}, {}};
    std::map<std::uint32_t, std::uint32_t> parents;
    for (std::uint32_t i = 0; i < header.frame_count; ++i) {
      detail::FrameHeader frame;
      frame.read(in_);
      Part part{frame.generation, "frame", {}};
      part.fields.push_back({"parent", frame_name(frame.parent)});
      read<Transform<S, N>>(part);
      keep(header, contents.frames, frame.index, std::move(part));
      if (frame.parent != nowhere) parents.emplace(frame.index, frame.parent);
    }
    for (const auto& [index, parent] : parents) {
      const auto found = contents.frames.find(parent);
      if (found == contents.frames.end()) fail();
      if (found->second.generation >= contents.frames.at(index).generation) fail();
    }
    for (std::uint32_t i = 0; i < header.object_count; ++i) {
      detail::ObjectHeader object;
      object.read(in_);
      if (in_.has_failed() || object.tag >= std::size(detail::shape_names) ||
          (header.shapes >> object.tag) % 2 == 0 ||
          (object.frame != nowhere && !contents.frames.contains(object.frame))) {
        fail();
      }
      Part part{object.generation, std::string(detail::shape_names[object.tag]), {}};
      part.fields.push_back({"type", part.type});
      part.fields.push_back({"layers", hexadecimal(object.layers)});
      part.fields.push_back({"user", hexadecimal(object.user)});
      part.fields.push_back({"frame", frame_name(object.frame)});
      add_shape(part, object.tag);
      keep(header, contents.objects, object.index, std::move(part));
    }
    if (in_.left() != 0) fail();
    return contents;
  }

 private:
  [[noreturn]] void fail() const {
    throw InputError(file_, {}, "its contents are not a valid snapshot" + std::string(remedy));
  }

  static constexpr std::uint32_t nowhere = 0xffffffffu;

  /// A bit for each tag: meshes and height fields are in 3D.
  static constexpr unsigned known_types =
      (1u << std::size(detail::shape_names)) - 2 -
      (N == 2 ? 1u << detail::shape_tag<PlacedMesh<S>> | 1u << detail::shape_tag<PlacedField<S>>
              : 0u);

  static std::string frame_name(std::uint32_t index) {
    return index == nowhere ? "none" : std::to_string(index);
  }

  /// Indices must increase, and generations must be below the next one.
  void keep(const SnapshotHeader& header, Parts& parts, std::uint32_t index, Part part) const {
    if (in_.has_failed() || part.generation == 0 || part.generation >= header.next_generation ||
        (!parts.empty() && parts.rbegin()->first >= index)) {
      fail();
    }
    parts.emplace_hint(parts.end(), index, std::move(part));
  }

  /// A number, or the fields of a value as "name.field".
  template <class T>
  void add(Part& part, const std::string& name, const T& value) {
    if constexpr (detail::HasFields<T>) {
      for_each_field(value, [&](const detail::PartName& field, const auto& inner) {
        add(part, name + (name.empty() ? "" : ".") + std::string(field.view()), inner);
      });
    } else {
      std::string raw;
      if constexpr (is_fixed<T>) {
        raw = std::to_string(value.raw());
      } else {
        raw = hexadecimal(detail::to_word(value));
      }
      part.fields.push_back({name, text_of(value) + " (raw " + raw + ")"});
    }
  }
  template <class T>
  void read(Part& part, const std::string& name = {}) {
    T value{};
    in_.get(value);
    add(part, name, value);
  }

  void add_asset(Part& part, const std::string& kind, const std::string& contents) {
    part.fields.push_back({kind, std::to_string(in_.number<std::uint32_t>())});
    part.fields.push_back({"digest of its " + contents, hexadecimal(in_.number<std::uint64_t>())});
  }

  void add_shape(Part& part, std::uint8_t tag) {
    switch (tag) {
      case detail::shape_tag<PlacedMesh<S>>:
        add_asset(part, "mesh", "triangles");
        return read<Transform<S, N>>(part);
      case detail::shape_tag<PlacedHull<S, N>>:
        add_asset(part, "hull", "points");
        return read<Transform<S, N>>(part);
      case detail::shape_tag<PlacedField<S>>:
        add_asset(part, "height field", "heights");
        return read<Vec<S, N>>(part, "translation");
      default:
        support::SceneShapes<S, N>::for_each([&]<class Shape>(const Shape&) {
          if (tag == detail::shape_tag<Shape>) read<Shape>(part);
        });
    }
  }

  const std::string& file_;
  Reader in_;
};

/// Calls f with the tool's scalar of a snapshot; false if it has none.
template <class F>
bool with_scalar(SnapshotSpace space, const F& f) {
  space.dimension = 2;
  const auto try_one = [&](auto scalar) {
    return space == SnapshotSpace::of<decltype(scalar), 2>() && (f(scalar), true);
  };
  return [&]<class... S>(support::ScalarList<S...>) {
    return (try_one(S()) || ...);
  }(support::AllScalars());
}

std::span<const std::byte> as_bytes(const std::string& text) {
  return std::as_bytes(std::span(text.data(), text.size()));
}

Contents read_snapshot(const std::string& file, const std::string& text) {
  const auto bytes = as_bytes(text);
  SnapshotHeader header;
  const auto read = detail::open(bytes, header);
  if (read == Restored::no_snapshot && text.starts_with("DTNW")) {  // WorldHeader
    throw InputError(file, {},
                     "a snapshot of a world; name snapshots of scenes, and compare worlds with "
                     "diff(a, b) in a program");
  }
  if (read != Restored::yes) {
    throw InputError(file, {}, std::string(detent::describe(read)) + remedy);
  }
  Contents contents;
  const auto parts = SnapshotHeader::body(bytes);
  const auto read_parts = [&](auto scalar) {
    using S = decltype(scalar);
    contents = header.space.dimension == 2 ? PartReader<S, 2>(file, parts).read(header)
                                           : PartReader<S, 3>(file, parts).read(header);
  };
  const bool has_dimension = header.space.dimension == 2 || header.space.dimension == 3;
  if (!has_dimension || !with_scalar(header.space, read_parts)) {
    throw InputError(
        file, {}, "the tool does not support its scalar or dimension; use restore and digest_of");
  }
  return contents;
}

class Listing {
 public:
  Listing(std::string name_a, std::string name_b)
      : name_a_(std::move(name_a)), name_b_(std::move(name_b)) {}

  void compare(const std::string& name, const std::string& a, const std::string& b) {
    if (a != b) add(name + ": " + a + " | " + b);
  }

  void compare(const char* kind, const Parts& a, const Parts& b) {
    for (const auto& [index, part] : a) {
      const auto other = b.find(index);
      if (other == b.end() || other->second.generation != part.generation) {
        add(name_of(kind, index, part) + ": only in " + name_a_);
      } else {
        compare(name_of(kind, index, part), part.fields, other->second.fields);
      }
    }
    for (const auto& [index, part] : b) {
      const auto other = a.find(index);
      if (other == a.end() || other->second.generation != part.generation) {
        add(name_of(kind, index, part) + ": only in " + name_b_);
      }
    }
  }

  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  static std::string name_of(const char* kind, std::uint32_t index, const Part& part) {
    const auto name =
        std::string(kind) + " " + std::to_string(index) + ":" + std::to_string(part.generation);
    return part.type == kind ? name : name + " (" + part.type + ")";
  }

  /// Compares the fields that have the same name; the types may differ.
  void compare(const std::string& part, const std::vector<Field>& a, const std::vector<Field>& b) {
    for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) {
      if (a[i].name == b[i].name) compare(part + " " + a[i].name, a[i].value, b[i].value);
    }
  }

  void add(const std::string& line) { text_ += line + "\n"; }

  std::string name_a_;
  std::string name_b_;
  std::string text_;
};

}  // namespace

SnapshotDifference compare_snapshots(const std::string& name_a, const std::string& bytes_a,
                                     const std::string& name_b, const std::string& bytes_b) {
  const Contents a = read_snapshot(name_a, bytes_a), b = read_snapshot(name_b, bytes_b);
  const auto& first = a.header;
  const auto& second = b.header;
  if (first.space != second.space) {
    throw InputError(name_b, {},
                     "has a different scalar or dimension than " + name_a +
                         "; compare snapshots of the same kind of scene");
  }
  Listing listing(one_line(name_a), one_line(name_b));
  listing.compare("types of shapes", hexadecimal(first.shapes), hexadecimal(second.shapes));
  listing.compare("fixed objects", std::to_string(first.fixed_count),
                  std::to_string(second.fixed_count));
  listing.compare("digest of the fixed objects", hexadecimal(first.fixed_digest),
                  hexadecimal(second.fixed_digest));
  listing.compare("next generation", std::to_string(first.next_generation),
                  std::to_string(second.next_generation));
  listing.compare("frame", a.frames, b.frames);
  listing.compare("object", a.objects, b.objects);
  return {listing.text(), listing.text().empty()};
}

bool diff(const DiffOptions& options) {
  const auto difference =
      compare_snapshots(options.a, read_file(options.a), options.b, read_file(options.b));
  print(difference.is_none ? "the snapshots are equal\n" : difference.text);
  return difference.is_none;
}

}  // namespace detent::cli
