// SPDX-License-Identifier: MIT
#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STB_IMAGE_WRITE_STATIC
#define STBI_WRITE_NO_STDIO
#include "painter.hpp"

#include <algorithm>

// A single-file C library that does not compile under our warnings.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wshadow"
#pragma GCC diagnostic ignored "-Wmissing-field-initializers"
#include <stb/stb_image_write.h>
#pragma GCC diagnostic pop

#include "gallery.hpp"

namespace samples {
namespace {

constexpr int fine = 3;  // samples per axis of a pixel

struct Seen {
  float x, y, depth, w;
  Vertex vertex;
};
using Rgb = std::array<std::uint8_t, 3>;

class Canvas {
 public:
  Canvas(int width, int height)
      : width_(width),
        height_(height),
        colours_(area(), Rgb{0xf4, 0xf6, 0xf8}),
        depths_(area(), 1) {}

  void put(int x, int y, float depth, const Vertex& v) {
    if (x < 0 || y < 0 || x >= width_ || y >= height_) return;
    const auto i = static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
                   static_cast<std::size_t>(x);
    if (depth < -1 || depth > depths_[i]) return;
    depths_[i] = depth;
    colours_[i] = {v.red, v.green, v.blue};
  }
  void fill(const Seen& a, const Seen& b, const Seen& c) {
    const float whole = side(a, b, c.x, c.y);
    if (!(std::abs(whole) > 0)) return;
    const auto [left, right] = std::minmax({a.x, b.x, c.x});
    const auto [top, bottom] = std::minmax({a.y, b.y, c.y});
    for (int y = first(top); y <= last(bottom, height_); ++y) {
      for (int x = first(left); x <= last(right, width_); ++x) {
        const auto px = static_cast<float>(x), py = static_cast<float>(y);
        const float u = side(b, c, px, py) / whole, v = side(c, a, px, py) / whole;
        if (u < 0 || v < 0 || u + v > 1) continue;
        put(x, y, u * a.depth + v * b.depth + (1 - u - v) * c.depth, a.vertex);
      }
    }
  }
  void stroke(const Seen& a, const Seen& b) {
    const float steps = std::min(std::max(std::abs(b.x - a.x), std::abs(b.y - a.y)) + 1, 8192.0f);
    for (float i = 0; i <= steps; ++i) {
      const float t = i / steps;
      const auto x = static_cast<int>(a.x + t * (b.x - a.x)),
                 y = static_cast<int>(a.y + t * (b.y - a.y));
      // Slightly nearer, so that edges are over their own faces.
      const float depth = a.depth + t * (b.depth - a.depth) - 2e-4f;
      for (int k = 0; k < 9; ++k) put(x + k % 3 - 1, y + k / 3 - 1, depth, a.vertex);
    }
  }
  [[nodiscard]] Image reduced() const {
    Image image(width_ / fine, height_ / fine);
    for (int y = 0; y < image.height; ++y) {
      for (int x = 0; x < image.width; ++x) {
        for (std::size_t channel = 0; channel < 3; ++channel) {
          int sum = 0;
          for (int k = 0; k < fine * fine; ++k) {
            sum += colours_[static_cast<std::size_t>((y * fine + k / fine) * width_ + x * fine +
                                                     k % fine)][channel];
          }
          image.pixels[3 * static_cast<std::size_t>(y * image.width + x) + channel] =
              static_cast<std::uint8_t>(sum / (fine * fine));
        }
      }
    }
    return image;
  }

 private:
  [[nodiscard]] std::size_t area() const {
    return static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_);
  }
  static float side(const Seen& a, const Seen& b, float x, float y) {
    return (b.x - a.x) * (y - a.y) - (b.y - a.y) * (x - a.x);
  }
  static int first(float low) { return static_cast<int>(std::ceil(std::clamp(low, 0.0f, 1e6f))); }
  static int last(float high, int size) {
    return static_cast<int>(std::floor(std::clamp(high, -1.0f, static_cast<float>(size) - 1)));
  }

  int width_, height_;
  std::vector<Rgb> colours_;
  std::vector<float> depths_;
};

}  // namespace

Image::Image(int wide, int high)
    : width(wide),
      height(high),
      pixels(3 * static_cast<std::size_t>(wide) * static_cast<std::size_t>(high), 255) {}

void Image::place(const Image& part, int x, int y) {
  for (int row = 0; row < part.height; ++row) {
    const auto from = part.pixels.begin() + 3 * row * part.width;
    std::copy(from, from + 3 * part.width, pixels.begin() + 3 * ((y + row) * width + x));
  }
}

std::string Image::png() const {
  std::string bytes;
  stbi_write_png_compression_level = 16;
  stbi_write_png_to_func(
      [](void* to, void* data, int size) {
        static_cast<std::string*>(to)->append(static_cast<const char*>(data),
                                              static_cast<std::size_t>(size));
      },
      &bytes, width, height, 3, pixels.data(), 3 * width);
  return bytes;
}

Image painted(const Picture& picture, const View& view, int width, int height) {
  Canvas canvas(width * fine, height * fine);
  const auto wide = static_cast<float>(width * fine), high = static_cast<float>(height * fine);
  const auto m = matrix(view, wide / high);
  const auto seen = [&](const Vertex& v) {
    std::array<float, 4> p{};
    for (std::size_t row = 0; row < 4; ++row) {
      p[row] = m[row] * v.x + m[4 + row] * v.y + m[8 + row] * v.z + m[12 + row];
    }
    const float w = p[3] > 0 ? p[3] : 1;
    return Seen{(p[0] / w + 1) / 2 * wide, (1 - p[1] / w) / 2 * high, p[2] / w, p[3], v};
  };
  // Lines and triangles that reach behind the camera are skipped; samples have few.
  const auto& t = picture.triangles;
  for (std::size_t i = 0; i + 2 < t.size(); i += 3) {
    const Seen a = seen(t[i]), b = seen(t[i + 1]), c = seen(t[i + 2]);
    if (a.w > 0 && b.w > 0 && c.w > 0) canvas.fill(a, b, c);
  }
  for (std::size_t i = 0; i + 1 < picture.lines.size(); i += 2) {
    const Seen a = seen(picture.lines[i]), b = seen(picture.lines[i + 1]);
    if (a.w > 0 && b.w > 0) canvas.stroke(a, b);
  }
  return canvas.reduced();
}

}  // namespace samples
