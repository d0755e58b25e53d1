// SPDX-License-Identifier: MIT
#pragma once

// The interface of a sample: one class per file, which builds a scene, steps it by one tick, draws
// it, and has a digest of its state that is the same on every machine. The same sources run in a
// terminal (native.cpp) and in a page (page.cpp). Pictures use float, because they are only for
// display; the simulation does not.

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include <detent/draw/sink.hpp>
#include <detent/number/floating.hpp>
#include <detent/number/literals.hpp>

namespace samples {

using namespace detent;
using namespace detent::literals;

using S = q16_16;
using Point = Vec<S, 3>;
using Point2 = Vec<S, 2>;

/// The player's input in a tick, in whole numbers, so that a recorded match can repeat it exactly.
struct Input {
  static constexpr std::uint8_t left = 1, right = 2, up = 4, down = 8, action = 16;
  std::uint8_t keys = 0;
  bool is_pointing = false;
  std::int16_t x = 0, y = 0;  // the pointer, in thousandths of half the height, from the center

  [[nodiscard]] bool has(std::uint8_t key) const { return (keys & key) != 0; }
  /// -1, 0 or 1.
  [[nodiscard]] int across() const { return int{has(right)} - int{has(left)}; }
  [[nodiscard]] int along() const { return int{has(up)} - int{has(down)}; }
};

/// A corner of a triangle or an end of a line. The page gives these bytes to WebGL.
struct Vertex {
  float x, y, z;
  std::uint8_t red, green, blue, alpha;
};

/// Colours of the samples, dark enough for lines on a light background.
inline constexpr Colour ink{0x33, 0x3d, 0x47}, pale{0xc9, 0xd2, 0xd9}, stone{0xa9, 0xb4, 0xbe},
    blue{0x2a, 0x7d, 0xb8}, red{0xc8, 0x4a, 0x2b}, green{0x1f, 0x93, 0x6c},
    yellow{0xe0, 0xa0, 0x20}, pink{0xb8, 0x62, 0x94};

/// A sink of `detent::draw`: lines, and triangles with lighting.
class Picture {
 public:
  std::vector<Vertex> triangles, lines;

  void clear() {
    triangles.clear();
    lines.clear();
  }
  template <int N>
  void line(const Vec<S, N>& a, const Vec<S, N>& b, const Colour& colour) {
    add(lines, in_float(a), colour, 1);
    add(lines, in_float(b), colour, 1);
  }
  void triangle(const Point& a, const Point& b, const Point& c, const Colour& colour) {
    const Float3 p = in_float(a), q = in_float(b), r = in_float(c);
    const Float3 u{q[0] - p[0], q[1] - p[1], q[2] - p[2]}, v{r[0] - p[0], r[1] - p[1], r[2] - p[2]};
    const Float3 n{u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
    const float size = std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
    const float facing = size > 0 ? (0.35f * n[0] + 0.80f * n[1] + 0.48f * n[2]) / size : 0;
    const float light = 0.78f + 0.30f * facing;
    for (const Float3& point : {p, q, r}) add(triangles, point, colour, light);
  }

 private:
  using Float3 = std::array<float, 3>;
  template <int N>
  static Float3 in_float(const Vec<S, N>& p) {
    Float3 result{};
    for (int i = 0; i < N; ++i)
      result[static_cast<std::size_t>(i)] = static_cast<float>(static_cast<double>(p[i]));
    return result;
  }
  static void add(std::vector<Vertex>& to, const Float3& p, const Colour& colour, float light) {
    const auto lit = [&](std::uint8_t c) {
      const float value = static_cast<float>(c) * light;
      return static_cast<std::uint8_t>(value < 255 ? value : 255);
    };
    to.push_back({p[0], p[1], p[2], lit(colour.red), lit(colour.green), lit(colour.blue), 255});
  }
};

/// The camera: 3D scenes are seen from `eye`, and `height` units are visible at the target.
struct View {
  std::array<float, 3> eye, target;
  float height;
};

/// A running sample.
class Sample {
 public:
  virtual ~Sample() = default;
  /// One tick, 1/60 second.
  virtual void step(const Input& input) = 0;
  virtual void draw(Picture& picture) const = 0;
  /// A digest of everything that later ticks depend on.
  [[nodiscard]] virtual std::uint64_t digest() const = 0;
  [[nodiscard]] virtual View view() const = 0;
  /// A status line with figures.
  [[nodiscard]] virtual std::string status() const = 0;
};

/// A sample in the gallery.
struct Entry {
  const char* name;
  const char* sentence;
  const char* keys;  // the controls, for the player
  std::unique_ptr<Sample> (*make)();
};

template <class T>
std::unique_ptr<Sample> make() {
  return std::make_unique<T>();
}

}  // namespace samples
