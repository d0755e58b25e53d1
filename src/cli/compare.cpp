// SPDX-License-Identifier: MIT
#include "compare.hpp"

#include <algorithm>
#include <cmath>

namespace detent::cli {
namespace {

constexpr int gap = 6;
constexpr int caption_height = 28;
constexpr Colour paper{0x16, 0x18, 0x1c};
constexpr Colour ink{0xe8, 0xe8, 0xe4};
constexpr Colour loud{0xff, 0x4b, 0x3e};
constexpr Colour quiet{0x8a, 0x62, 0x1c};

enum class Kind { same, hit_or_miss, shape, distance };

Kind kind_of(const std::optional<Found>& a, const std::optional<Found>& b) {
  if (a.has_value() != b.has_value()) return Kind::hit_or_miss;
  if (!a) return Kind::same;
  if (a->shape != b->shape) return Kind::shape;
  return std::abs(a->distance - b->distance) <= visible_distance ? Kind::same : Kind::distance;
}

Colour dimmed(const Colour& colour) {
  const int grey = (2 * colour.red + 5 * colour.green + colour.blue) / 8;
  const auto dark = static_cast<std::uint8_t>(8 + grey / 5);
  return {dark, dark, dark};
}

std::string pixels(std::size_t count) {
  return std::to_string(count) + (count == 1 ? " pixel" : " pixels");
}

}  // namespace

Difference compare(const Tracer& a, const Tracer& b) {
  const auto found_a = a.found();
  const auto found_b = b.found();
  Difference result;
  for (std::size_t i = 0; i < found_a.size(); ++i) {
    switch (kind_of(found_a[i], found_b[i])) {
      case Kind::same:
        break;
      case Kind::hit_or_miss:
        ++result.hit_or_miss;
        break;
      case Kind::shape:
        ++result.shape;
        break;
      case Kind::distance:
        ++result.distance;
        break;
    }
    if (!found_a[i] || !found_b[i] || found_a[i]->shape != found_b[i]->shape) continue;
    const double difference = std::abs(found_a[i]->distance - found_b[i]->distance);
    if (difference <= result.largest_distance) continue;
    result.largest_distance = difference;
    result.largest_ray = i;
  }
  return result;
}

Image difference_picture(const Image& picture, const Tracer& a, const Tracer& b) {
  const auto found_a = a.found();
  const auto found_b = b.found();
  Image result = picture;
  std::size_t i = 0;
  for (int y = 0; y < picture.height(); ++y) {
    for (int x = 0; x < picture.width(); ++x, ++i) {
      Colour& pixel = result.at(x, y);
      switch (kind_of(found_a[i], found_b[i])) {
        case Kind::same:
          pixel = dimmed(pixel);
          break;
        case Kind::distance:
          pixel = quiet;
          break;
        default:
          pixel = loud;
      }
    }
  }
  return result;
}

std::string difference_caption(const Difference& difference) {
  return "red: shape differs at " + pixels(difference.disagreements());
}

Panel difference_panel(const Image& a, const Image& b) {
  Image result = a;
  std::size_t count = 0;
  for (int y = 0; y < a.height(); ++y) {
    for (int x = 0; x < a.width(); ++x) {
      Colour& pixel = result.at(x, y);
      const Colour& other = b.at(x, y);
      const bool is_same =
          pixel.red == other.red && pixel.green == other.green && pixel.blue == other.blue;
      count += !is_same;
      pixel = is_same ? dimmed(pixel) : loud;
    }
  }
  return {result, "red: differs at " + pixels(count)};
}

Image panel_row(const std::vector<Panel>& panels) {
  int width = gap;
  for (const Panel& panel : panels) width += panel.image.width() + gap;
  Image row(width, caption_height + panels.front().image.height(), paper);
  int x = gap;
  for (const Panel& panel : panels) {
    row.write(x + 2, 7, panel.caption, ink);
    row.place(panel.image, x, caption_height);
    x += panel.image.width() + gap;
  }
  return row;
}

Image stacked(const std::vector<Image>& rows) {
  int height = gap;
  for (const Image& row : rows) height += row.height();
  Image page(rows.front().width(), height, paper);
  int y = 0;
  for (const Image& row : rows) {
    page.place(row, 0, y);
    y += row.height();
  }
  return page;
}

}  // namespace detent::cli
