// SPDX-License-Identifier: MIT
#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STB_IMAGE_WRITE_STATIC
#define STBI_WRITE_NO_STDIO
#include "image.hpp"

#include <algorithm>
#include <array>
#include <cstring>
#include <stdexcept>

// Single-file C libraries that do not compile under our warnings.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#include <stb/stb_easy_font.h>
#include <stb/stb_image_write.h>
#pragma GCC diagnostic pop

namespace detent::cli {
namespace {

constexpr int text_scale = 2;

/// The vertex format of stb_easy_font.
struct FontVertex {
  float x, y, z;
  std::array<unsigned char, 4> colour;
};

}  // namespace

void Image::place(const Image& part, int x, int y) {
  for (int row = 0; row < part.height_; ++row) {
    for (int column = 0; column < part.width_; ++column) {
      at(x + column, y + row) = part.at(column, row);
    }
  }
}

void Image::fill(int x, int y, int width, int height, Colour colour) {
  for (int row = std::max(y, 0); row < std::min(y + height, height_); ++row) {
    for (int column = std::max(x, 0); column < std::min(x + width, width_); ++column) {
      at(column, row) = colour;
    }
  }
}

void Image::write(int x, int y, const std::string& text, Colour colour) {
  std::string line = text;
  std::vector<char> buffer(text.size() * 600 + 600);
  const int quads = stb_easy_font_print(0, 0, line.data(), nullptr, buffer.data(),
                                        static_cast<int>(buffer.size()));
  for (int i = 0; i < quads; ++i) {
    std::array<FontVertex, 4> quad;
    std::memcpy(quad.data(), buffer.data() + static_cast<std::size_t>(i) * sizeof(quad),
                sizeof(quad));
    const auto scaled = [](float value) { return static_cast<int>(value) * text_scale; };
    fill(x + scaled(quad[0].x), y + scaled(quad[0].y), scaled(quad[2].x - quad[0].x),
         scaled(quad[2].y - quad[0].y), colour);
  }
}

std::string Image::png() const {
  static_assert(sizeof(Colour) == 3);
  std::string bytes;
  const auto append = [](void* context, void* data, int size) {
    static_cast<std::string*>(context)->append(static_cast<const char*>(data),
                                               static_cast<std::size_t>(size));
  };
  if (stbi_write_png_to_func(append, &bytes, width_, height_, 3, pixels_.data(), 3 * width_) == 0) {
    throw std::runtime_error("the PNG could not be encoded");
  }
  return bytes;
}

}  // namespace detent::cli
