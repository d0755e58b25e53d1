// SPDX-License-Identifier: MIT
#include "overlay.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace detent::cli {
namespace {

/// A point on the screen, in pixels from the middle of the first one. `nearness` is 1 / depth: like
/// x and y, it is linear along the picture of a line.
struct ScreenPoint {
  double x, y, nearness;
};

ScreenPoint between(const ScreenPoint& a, const ScreenPoint& b, double t) {
  return {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y), a.nearness + t * (b.nearness - a.nearness)};
}

class Overlay {
 public:
  Overlay(Image& picture, const View& view, const std::vector<std::optional<Found>>& found)
      : picture_(picture), view_(view), found_(found) {}

  void draw(const Outline& line) {
    auto a = view_.seen(line.a), b = view_.seen(line.b);
    if (!clip_front(a, b)) return;
    auto from = on_screen(a), to = on_screen(b);
    if (!clip(from, to)) return;
    const double steps = std::ceil(std::max(std::abs(to.x - from.x), std::abs(to.y - from.y)));
    const bool is_steep = std::abs(to.y - from.y) > std::abs(to.x - from.x);
    for (double i = 0; i <= steps; ++i) {
      const auto at = between(from, to, steps > 0 ? i / steps : 0);
      // Two pixels share each step, by how close they are.
      const double across = is_steep ? at.x : at.y, first = std::floor(across);
      for (const double k : {0.0, 1.0}) {
        const double share = 1 - std::abs(across - (first + k));
        const double along = std::round(is_steep ? at.y : at.x);
        mark(is_steep ? first + k : along, is_steep ? along : first + k, at.nearness, share,
             line.colour);
      }
    }
  }

 private:
  /// The depth of the near plane, in lengths of the view's vectors.
  static constexpr double closest = 1e-3;

  /// The part of a line in front of the camera; false if there is none.
  static bool clip_front(Double3& a, Double3& b) {
    if (!(a[0] >= closest || b[0] >= closest)) return false;
    const auto cut = [](Double3& out, const Double3& in) {
      const double t = (closest - in[0]) / (out[0] - in[0]);
      for (std::size_t i = 0; i < 3; ++i) out[i] = in[i] + t * (out[i] - in[i]);
    };
    if (a[0] < closest) cut(a, b);
    if (b[0] < closest) cut(b, a);
    return true;
  }

  ScreenPoint on_screen(const Double3& p) const {
    const double height = picture_.height();
    return {(p[1] / p[0] * height + picture_.width() - 1) / 2,
            (height - 1 - p[2] / p[0] * height) / 2, 1 / p[0]};
  }

  /// The part of a line in the picture; false if there is none.
  ///
  /// source: Liang and Barsky, A New Concept and Method for Line Clipping, 1984
  bool clip(ScreenPoint& a, ScreenPoint& b) const {
    double first = 0, last = 1;
    const auto cut = [&](double start, double way, double most) {
      if (way == 0) {
        if (!(start >= 0 && start <= most)) last = -1;
        return;
      }
      const double enter = (way > 0 ? -start : most - start) / way;
      const double leave = (way > 0 ? most - start : -start) / way;
      first = std::max(first, enter);
      last = std::min(last, leave);
    };
    cut(a.x, b.x - a.x, picture_.width() - 1);
    cut(a.y, b.y - a.y, picture_.height() - 1);
    if (!(first <= last)) return false;
    const auto from = between(a, b, first), to = between(a, b, last);
    a = from;
    b = to;
    return true;
  }

  void mark(double x, double y, double nearness, double share, const Colour& colour) {
    const int column = static_cast<int>(x), row = static_cast<int>(y);
    if (column >= picture_.width() || row >= picture_.height() ||
        is_hidden(column, row, nearness)) {
      return;
    }
    Colour& pixel = picture_.at(column, row);
    const auto mixed = [&](std::uint8_t a, std::uint8_t b) {
      return static_cast<std::uint8_t>(std::lround(a + (b - a) * share));
    };
    pixel = {mixed(pixel.red, colour.red), mixed(pixel.green, colour.green),
             mixed(pixel.blue, colour.blue)};
  }

  bool is_hidden(int column, int row, double nearness) const {
    const auto width = static_cast<std::size_t>(picture_.width());
    const auto& found =
        found_[static_cast<std::size_t>(row) * width + static_cast<std::size_t>(column)];
    if (!found) return false;
    // The ray of the pixel is ahead + x right + y up.
    const double height = picture_.height();
    const double x = (2.0 * column + 1 - picture_.width()) / height;
    const double y = (height - 1 - 2.0 * row) / height;
    const double length =
        std::sqrt(inner(view_.ahead, view_.ahead) + x * x * inner(view_.right, view_.right) +
                  y * y * inner(view_.up, view_.up));
    return length / nearness > found->distance * (1 + 1.0 / 128);
  }

  Image& picture_;
  const View& view_;
  const std::vector<std::optional<Found>>& found_;
};

}  // namespace

void draw_over(Image& picture, const View& view, const std::vector<Outline>& lines,
               const std::vector<std::optional<Found>>& found) {
  Overlay overlay(picture, view, found);
  for (const Outline& line : lines) overlay.draw(line);
}

}  // namespace detent::cli
