// SPDX-License-Identifier: MIT
#include "animation.hpp"

#include <algorithm>
#include <cstdint>
#include <string_view>

namespace detent::cli {
namespace {

struct Area {
  int left, top, width, height;
};

std::string word(std::uint32_t value) {
  std::string bytes;
  for (int shift = 24; shift >= 0; shift -= 8) bytes += static_cast<char>((value >> shift) & 0xff);
  return bytes;
}
std::string word(int value) { return word(static_cast<std::uint32_t>(value)); }
std::string half_word(int value) { return word(value).substr(2); }

/// The check of a chunk: CRC-32 of ISO 3309.
std::uint32_t check_of(std::string_view bytes) {
  std::uint32_t crc = 0xffffffffu;
  for (const char c : bytes) {
    crc ^= static_cast<unsigned char>(c);
    for (int bit = 0; bit < 8; ++bit) crc = (crc >> 1) ^ ((crc & 1) != 0 ? 0xedb88320u : 0);
  }
  return ~crc;
}

std::string chunk(const std::string& type, std::string_view content) {
  std::string bytes = type;
  bytes += content;
  return word(static_cast<std::uint32_t>(content.size())) + bytes + word(check_of(bytes));
}

/// The content of all chunks of a type in a PNG.
std::string content_of(std::string_view png, std::string_view type) {
  std::string content;
  const auto number = [&](std::size_t at) {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      value = value << 8 | static_cast<unsigned char>(png[at + i]);
    }
    return value;
  };
  for (std::size_t at = 8; at + 12 <= png.size(); at += 12 + number(at)) {
    if (png.substr(at + 4, 4) == type) content += png.substr(at + 8, number(at));
  }
  return content;
}

bool differ(const Colour& a, const Colour& b) {
  return a.red != b.red || a.green != b.green || a.blue != b.blue;
}

/// The least area that holds all pixels that changed; one pixel if none did.
Area changed(const Image& before, const Image& now) {
  int left = now.width(), top = now.height(), right = -1, bottom = -1;
  for (int y = 0; y < now.height(); ++y) {
    for (int x = 0; x < now.width(); ++x) {
      if (!differ(before.at(x, y), now.at(x, y))) continue;
      left = std::min(left, x);
      right = std::max(right, x);
      top = std::min(top, y);
      bottom = std::max(bottom, y);
    }
  }
  if (right < 0) return {0, 0, 1, 1};
  return {left, top, right - left + 1, bottom - top + 1};
}

Image part_of(const Image& image, const Area& area) {
  Image part(area.width, area.height);
  for (int y = 0; y < area.height; ++y) {
    for (int x = 0; x < area.width; ++x) part.at(x, y) = image.at(area.left + x, area.top + y);
  }
  return part;
}

}  // namespace

void Animation::add(const Image& picture) {
  const bool is_first = !last_;
  const Area area =
      is_first ? Area{0, 0, picture.width(), picture.height()} : changed(*last_, picture);
  const std::string png = part_of(picture, area).png();
  if (is_first) header_ = png.substr(0, 8) + chunk("IHDR", content_of(png, "IHDR"));
  frames_ += chunk("fcTL", word(sequence_++) + word(area.width) + word(area.height) +
                               word(area.left) + word(area.top) + half_word(numerator_) +
                               half_word(denominator_) + std::string(2, '\0'));
  const std::string data = content_of(png, "IDAT");
  frames_ += is_first ? chunk("IDAT", data) : chunk("fdAT", word(sequence_++) + data);
  last_ = picture;
  ++count_;
}

std::string Animation::png() const {
  return header_ + chunk("acTL", word(count_) + word(0)) + frames_ + chunk("IEND", "");
}

}  // namespace detent::cli
