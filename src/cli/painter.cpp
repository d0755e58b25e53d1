// SPDX-License-Identifier: MIT
#include "painter.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace detent::cli {
namespace {

/// Each pixel is the mean of this many squared.
constexpr int samples = 2;
constexpr Colour sky{0xd8, 0xe4, 0xee};

std::optional<Double3> unit(const Double3& a) {
  const double length = std::sqrt(inner(a, a));
  if (!(length > 0)) return std::nullopt;
  return Double3{a[0] / length, a[1] / length, a[2] / length};
}
Double3 in_double(const Point& point) {
  const auto number = [&](std::size_t i) { return point[i].value.to<double>().value_or(0); };
  return {number(0), number(1), number(2)};
}
Colour shaded(const Colour& colour, double share) {
  const auto channel = [&](std::uint8_t c) {
    return static_cast<std::uint8_t>(std::lround(std::clamp(c * share, 0.0, 255.0)));
  };
  return {channel(colour.red), channel(colour.green), channel(colour.blue)};
}

/// A point of the picture: x and y in samples, and 1 / depth, which is linear in them.
struct Corner {
  double x, y, nearness;
};

/// A picture of triangles with a depth buffer.
class Canvas {
 public:
  Canvas(int width, int height)
      : image_(width * samples, height * samples, sky),
        nearest_(
            static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * samples * samples,
            0.0) {}

  [[nodiscard]] int width() const { return image_.width(); }
  [[nodiscard]] int height() const { return image_.height(); }

  /// `colour(x, y, nearness)` returns the colour of a sample.
  template <class ColourAt>
  void fill(const std::array<Corner, 3>& t, const ColourAt& colour) {
    const double area = cross(t[0], t[1], t[2].x, t[2].y);
    if (!(std::abs(area) > 0)) return;
    const auto [left, right] = std::minmax({t[0].x, t[1].x, t[2].x});
    const auto [top, bottom] = std::minmax({t[0].y, t[1].y, t[2].y});
    for (int y = first(top); y <= last(bottom, height()); ++y) {
      for (int x = first(left); x <= last(right, width()); ++x) {
        const double a = cross(t[1], t[2], x, y) / area, b = cross(t[2], t[0], x, y) / area;
        const double c = 1 - a - b;
        if (a < -slack || b < -slack || c < -slack) continue;
        const double nearness = a * t[0].nearness + b * t[1].nearness + c * t[2].nearness;
        auto& best = nearest_[static_cast<std::size_t>(y) * static_cast<std::size_t>(width()) +
                              static_cast<std::size_t>(x)];
        if (nearness <= best) continue;
        best = nearness;
        image_.at(x, y) = colour(x, y, nearness);
      }
    }
  }

  [[nodiscard]] Image reduced() const {
    Image small(width() / samples, height() / samples);
    for (int y = 0; y < small.height(); ++y) {
      for (int x = 0; x < small.width(); ++x) {
        int red = 0, green = 0, blue = 0;
        for (int k = 0; k < samples * samples; ++k) {
          const Colour& c = image_.at(x * samples + k % samples, y * samples + k / samples);
          red += c.red;
          green += c.green;
          blue += c.blue;
        }
        const auto mean = [](int sum) {
          return static_cast<std::uint8_t>(sum / (samples * samples));
        };
        small.at(x, y) = {mean(red), mean(green), mean(blue)};
      }
    }
    return small;
  }

 private:
  static constexpr double slack = 1e-9;  // so that samples on a common edge are covered

  static double cross(const Corner& a, const Corner& b, double x, double y) {
    return (b.x - a.x) * (y - a.y) - (b.y - a.y) * (x - a.x);
  }
  static int first(double low) { return static_cast<int>(std::ceil(std::clamp(low, 0.0, 1e6))); }
  static int last(double high, int size) {
    return static_cast<int>(std::floor(std::clamp(high, -1.0, size - 1.0)));
  }

  Image image_;
  std::vector<double> nearest_;
};

/// The part of a triangle in front of the camera, as depth, right and up: up to two triangles.
std::vector<std::array<Double3, 3>> in_front(const std::array<Double3, 3>& t) {
  constexpr double closest = 1e-3;
  std::vector<Double3> corners;
  for (std::size_t i = 0; i < 3; ++i) {
    const Double3 &a = t[i], &b = t[(i + 1) % 3];
    if (a[0] >= closest) corners.push_back(a);
    if ((a[0] >= closest) != (b[0] >= closest)) {
      const double share = (closest - a[0]) / (b[0] - a[0]);
      corners.push_back({closest, a[1] + share * (b[1] - a[1]), a[2] + share * (b[2] - a[2])});
    }
  }
  std::vector<std::array<Double3, 3>> parts;
  for (std::size_t i = 2; i < corners.size(); ++i) {
    parts.push_back({corners[0], corners[i - 1], corners[i]});
  }
  return parts;
}

/// A view of all bodies that are not fixed, or of all if all are, with a margin of half their
/// extent.
View view_of(const std::vector<Facet>& facets, Size size) {
  Double3 low{}, high{};
  bool is_empty = true;
  const bool any_moves =
      std::any_of(facets.begin(), facets.end(), [](const Facet& f) { return !f.is_fixed; });
  for (const Facet& facet : facets) {
    if (facet.is_fixed && any_moves) continue;
    for (const Double3& corner : facet.corners) {
      for (std::size_t i = 0; i < 2; ++i) {
        low[i] = is_empty ? corner[i] : std::min(low[i], corner[i]);
        high[i] = is_empty ? corner[i] : std::max(high[i], corner[i]);
      }
      is_empty = false;
    }
  }
  const double aspect = static_cast<double>(size.width) / size.height;
  const double half =
      std::max({0.75 * (high[1] - low[1]), 0.75 * (high[0] - low[0]) / aspect, 0.5});
  return {
      {(low[0] + high[0]) / 2, (low[1] + high[1]) / 2, 1}, {0, 0, -1}, {half, 0, 0}, {0, half, 0}};
}

}  // namespace

Painter::Painter(const WorldModel& model, const Simulation& start, Size size)
    : size_(size), is_flat_(model.dimension == 2) {
  if (is_flat_) {
    if (!model.flat_camera) {
      view_ = view_of(start.facets(), size);
      return;
    }
    const auto center = in_double(model.flat_camera->center);
    const double half = model.flat_camera->height.value.to<double>().value_or(1) / 2;
    view_ = {{center[0], center[1], 1}, {0, 0, -1}, {half, 0, 0}, {0, half, 0}};
    return;
  }
  if (!model.camera) {
    throw InputError(model.file, {},
                     "the world has no \"camera\"; add one with a position and a target");
  }
  const CameraModel& camera = *model.camera;
  const auto fail = [&](const std::string& what) {
    throw InputError(model.file, camera.place, what);
  };
  const auto position = in_double(camera.position);
  const auto forward = unit(minus(in_double(camera.target), position));
  if (!forward) fail("position and target are the same point; move one of them");
  const auto right = unit(outer(*forward, in_double(camera.up)));
  if (!right) fail("the camera looks along its up vector; choose another up");
  const double degrees = camera.field_of_view.value.to<double>().value_or(60);
  const double reach = std::tan(degrees * 3.14159265358979323846 / 360);
  const auto up = outer(*right, *forward);
  view_ = {position,
           *forward,
           {(*right)[0] * reach, (*right)[1] * reach, (*right)[2] * reach},
           {up[0] * reach, up[1] * reach, up[2] * reach}};
  light_ = unit(in_double(model.light)).value_or(Double3{0, 1, 0});
}

Image Painter::picture(const std::vector<Facet>& facets) const {
  Canvas canvas(size_.width, size_.height);
  const double middle_x = (canvas.width() - 1) / 2.0, middle_y = (canvas.height() - 1) / 2.0;
  const double scale = canvas.height() / 2.0;
  const auto on_screen = [&](const Double3& p, double depth) {
    return Corner{middle_x + p[1] / depth * scale, middle_y - p[2] / depth * scale, 1 / depth};
  };
  double order = 1;  // in two dimensions, later bodies are drawn over earlier ones
  for (const Facet& facet : facets) {
    if (is_flat_) {
      order *= 1 - 1e-9;
      std::array<Corner, 3> corners{};
      for (std::size_t i = 0; i < 3; ++i) {
        corners[i] = on_screen(view_.seen(facet.corners[i]), 1);
        corners[i].nearness = 1 / order;
      }
      // The outline goes from corner 0 to corner 1; corner 2 is the middle of the body.
      const Colour edge = shaded(facet.colour, 0.6);
      const double along_x = corners[1].x - corners[0].x, along_y = corners[1].y - corners[0].y;
      const double width = samples * std::hypot(along_x, along_y);
      canvas.fill(corners, [&](int x, int y, double) {
        const double off = along_x * (y - corners[0].y) - along_y * (x - corners[0].x);
        return std::abs(off) <= width ? edge : facet.colour;
      });
      continue;
    }
    const auto normal = unit(outer(minus(facet.corners[1], facet.corners[0]),
                                   minus(facet.corners[2], facet.corners[0])));
    if (!normal || inner(*normal, minus(view_.position, facet.corners[0])) <= 0) continue;
    const double bright = 0.45 + 0.55 * std::max(0.0, inner(*normal, light_));
    const Colour light = shaded(facet.colour, bright), dark = shaded(facet.colour, bright * 0.92);
    const auto part = [&](const std::array<Double3, 3>& t) {
      std::array<Corner, 3> corners{};
      for (std::size_t i = 0; i < 3; ++i) corners[i] = on_screen(t[i], t[i][0]);
      canvas.fill(corners, [&](int x, int y, double nearness) {
        if (!facet.is_fixed) return light;
        // A checker of one unit, on the two axes along which the normal is least.
        const double depth = 1 / nearness;
        const double right = (x - middle_x) / scale * depth, up = (middle_y - y) / scale * depth;
        double squares = 0;
        for (std::size_t i = 0; i < 3; ++i) {
          if (std::abs((*normal)[i]) > 0.7) continue;
          const double at = view_.position[i] + depth * view_.ahead[i] + right * view_.right[i] +
                            up * view_.up[i];
          squares += std::floor(at);
        }
        return std::fmod(squares, 2) == 0 ? light : dark;
      });
    };
    std::array<Double3, 3> t{};
    for (std::size_t i = 0; i < 3; ++i) t[i] = view_.seen(facet.corners[i]);
    for (const auto& front : in_front(t)) part(front);
  }
  return canvas.reduced();
}

}  // namespace detent::cli
