// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <string_view>

#include "verify/draw/shapes.hpp"

// The kinds of shapes: the name used in row names, the type, and how to draw one.

namespace detent::verify {

struct SphereKind {
  static constexpr std::string_view name = "sphere";
  template <Scalar S, int N>
  static constexpr auto draw(ShapeScene<S, N>& scene) noexcept {
    return scene.sphere();
  }
};
struct AabbKind {
  static constexpr std::string_view name = "aabb";
  template <Scalar S, int N>
  static constexpr auto draw(ShapeScene<S, N>& scene) noexcept {
    return scene.aabb();
  }
};
struct ObbKind {
  static constexpr std::string_view name = "obb";
  template <Scalar S, int N>
  static constexpr auto draw(ShapeScene<S, N>& scene) noexcept {
    return scene.obb();
  }
};
struct PlaneKind {
  static constexpr std::string_view name = "plane";
  template <Scalar S, int N>
  static constexpr auto draw(ShapeScene<S, N>& scene) noexcept {
    return scene.plane();
  }
};
struct TriangleKind {
  static constexpr std::string_view name = "triangle";
  template <Scalar S, int N>
  static constexpr auto draw(ShapeScene<S, N>& scene) noexcept {
    return scene.triangle();
  }
};
struct CapsuleKind {
  static constexpr std::string_view name = "capsule";
  template <Scalar S, int N>
  static constexpr auto draw(ShapeScene<S, N>& scene) noexcept {
    return scene.capsule();
  }
};
struct SegmentKind {
  static constexpr std::string_view name = "segment";
  template <Scalar S, int N>
  static constexpr auto draw(ShapeScene<S, N>& scene) noexcept {
    return scene.segment();
  }
};
struct RayKind {
  static constexpr std::string_view name = "ray";
  template <Scalar S, int N>
  static constexpr auto draw(ShapeScene<S, N>& scene) noexcept {
    return scene.ray();
  }
};

struct HullKind {
  static constexpr std::string_view name = "hull";
  template <Scalar S, int N>
  static constexpr auto draw(ShapeScene<S, N>& scene) noexcept {
    return scene.hull();
  }
};

/// The name of a row, concatenated from a few words at compile time.
class RowName {
 public:
  template <class... Words>
  explicit constexpr RowName(const Words&... words) noexcept {
    (add(words), ...);
  }
  [[nodiscard]] constexpr std::string_view view() const noexcept {
    return {characters_.data(), length_};
  }

 private:
  constexpr void add(std::string_view word) noexcept {
    for (const char c : word) characters_[length_++] = c;
  }

  std::array<char, 32> characters_{};
  std::size_t length_ = 0;
};

}  // namespace detent::verify
