// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

#include "detent/shape/shape.hpp"
#include "verify/draw/stage.hpp"

namespace detent::verify {

/// The points of a convex hull, at most eight; the hull itself is only a view.
template <Scalar S, int N>
struct HullPoints {
  std::array<Vec<S, N>, 8> points{};
  std::uint8_t count = 0;
};
template <class D, Scalar S, int N>
constexpr void append(D& digest, const HullPoints<S, N>& hull) noexcept {
  digest.add(hull.count);
  for (int i = 0; i < hull.count; ++i) digest.add(hull.points[static_cast<std::size_t>(i)]);
}

}  // namespace detent::verify

namespace detent::detail {

template <Scalar S, int N>
struct ShapeFields<verify::HullPoints<S, N>> {
  static constexpr std::string_view name = "hull";
};

}  // namespace detent::detail

namespace detent::verify {

/// Converts a drawn shape to the library's type.
template <class Shape>
[[nodiscard]] constexpr const Shape& as_shape(const Shape& shape) noexcept {
  return shape;
}
template <Scalar S, int N>
[[nodiscard]] constexpr ConvexHull<S, N> as_shape(const HullPoints<S, N>& hull) noexcept {
  return {std::span(hull.points).first(hull.count)};
}

/// Draws shapes around one spot of a stage.
///
/// Each shape is on one side of a plane through the spot, whose normal is an axis of an exact
/// frame. Its point nearest to that plane is the spot itself, a whole number of steps before or
/// behind it, or off by a unit. So two shapes on opposite sides often touch exactly, and a point at
/// the spot is often on a surface. Some shapes are anywhere instead, and some are built from
/// extreme numbers.
template <Scalar S, int N>
class ShapeScene : public Stage<S, N> {
  using Base = Stage<S, N>;

 protected:
  using Base::center_;
  using Base::corner;
  using Base::extent;
  using Base::extreme_;
  using Base::part;
  using Base::reach_;

 public:
  using Base::random;
  using typename Base::Point;

  explicit constexpr ShapeScene(Random& source) noexcept : Base(source) {
    Base::begin();
    frame_ = Base::template frame<N>();
    far_ = reach_ / frame_.norm;
    // A plane with this normal contains grid points when it goes through the origin.
    if (!extreme_ && !random.one_in(4) && frame_.norm > 1) center_ = across(far_);
    home_ = center_;
  }

  [[nodiscard]] constexpr Vec<S, N> spot() const noexcept { return Base::vec(center_); }

  /// The gap to the last shape, give or take a unit; or any number.
  constexpr S tolerance() noexcept {
    switch (random.below(8)) {
      case 0:
        return Base::any();
      case 1:
        return Base::scalar(random.between(-2, 2));
      case 2:
        return Base::scalar(random.between(0, reach_));
      default:
        return Base::scalar(gap_ + random.between(-1, 1));
    }
  }

  /// The next shape is on the other side.
  constexpr void turn() noexcept { side_ = -side_; }

  /// The next shape is at another spot, whole steps of the frame from the first one.
  constexpr void wander() noexcept {
    center_ = home_;
    if (extreme_) {
      center_ = any_point();
      return;
    }
    for (int k = 0; k < N; ++k) center_ += frame_.axes[k] * random.between(-far_, far_);
  }
  /// The next shape is at the first spot again.
  constexpr void go_home() noexcept { center_ = home_; }

  constexpr auto draw(Type<Sphere<S, N>>) noexcept { return sphere(); }
  constexpr auto draw(Type<Aabb<S, N>>) noexcept { return aabb(); }
  constexpr auto draw(Type<Obb<S, N>>) noexcept { return obb(); }
  constexpr auto draw(Type<Plane<S, N>>) noexcept { return plane(); }
  constexpr auto draw(Type<Triangle<S, N>>) noexcept { return triangle(); }
  constexpr auto draw(Type<Capsule<S, N>>) noexcept { return capsule(); }
  constexpr auto draw(Type<Segment<S, N>>) noexcept { return segment(); }
  constexpr auto draw(Type<Ray<S, N>>) noexcept { return ray(); }
  constexpr auto draw(Type<HullPoints<S, N>>) noexcept { return hull(); }

  constexpr Sphere<S, N> sphere() noexcept {
    if (extreme_) return {Base::vec(any_point()), Base::scalar(extent())};
    if (random.one_in(4)) {
      const auto size = extent();
      auto center = center_;
      for (int i = 0; i < N; ++i) center[i] += part(size, 18);
      return {Base::vec(center), Base::scalar(size)};
    }
    const auto next = anchor(3);
    const auto steps = random.between(0, far_);
    return {Base::vec(next + inward() * steps), radius(steps)};
  }

  constexpr Aabb<S, N> aabb() noexcept {
    const bool loose = random.one_in(4);
    const auto next = loose ? center_ : anchor(3);
    Point min, max;
    for (int i = 0; i < N; ++i) {
      const auto size = extent();
      const auto to_side = loose ? 0 : inward()[i];
      const auto margin = loose ? size / 4 : 0;
      const auto before = to_side > 0   ? 0
                          : to_side < 0 ? size
                                        : random.between(-margin, size + margin);
      min[i] = next[i] - before;
      max[i] = min[i] + size;
    }
    if (extreme_ && random.coin()) max = any_point();
    return {Base::vec(min), Base::vec(max)};
  }

  constexpr Obb<S, N> obb() noexcept {
    Point half;
    if (extreme_ || random.one_in(4)) {
      const auto axes = Base::template axes<N>();
      auto center = center_;
      for (int k = 0; k < N; ++k) {
        half[k] = extent();
        const auto steps = part(half[k], 18);
        for (int i = 0; i < N; ++i) center[i] += axes.axes[k][i] * steps / Base::one;
      }
      return {Base::vec(center), Base::vec(half), Base::rotation(axes)};
    }
    auto center = anchor(3);
    for (int k = 0; k < N; ++k) {
      const auto steps = random.between(0, far_);
      center += k == 0 ? inward() * steps : frame_.axes[k] * random.between(-steps, steps);
      half[k] = radius_of(steps);
    }
    return {Base::vec(center), Base::vec(half), Base::rotation(Base::stretched(frame_))};
  }

  constexpr Plane<S, N> plane() noexcept {
    const bool loose = extreme_ || random.one_in(8);
    const auto normal = loose ? Base::template any_direction<N>() : Base::along(frame_, 0) * side_;
    const auto next = anchor(5);
    // |next| has components below 1.5 * 2^31, so this is at most |normal| |next| < 2^63.
    std::int64_t height = Base::one / 2;
    for (int i = 0; i < N; ++i) height += normal[i] * next[i];
    const auto offset = extreme_ ? random.edgy(Base::bits) : height >> direction_component<S>::frac;
    return {Base::direction(normal), Base::scalar(offset)};
  }

  constexpr Triangle<S, N> triangle() noexcept {
    const bool loose = random.one_in(8);
    auto corners = extreme_ || loose ? anywhere() : standing();
    if (random.one_in(16)) {
      const auto edge = corners[1] - corners[0];
      corners[2] = corners[0] + edge * random.between(-1, 2);
    }
    const auto first = static_cast<std::size_t>(random.below(3));
    const auto second = (first + 1 + static_cast<std::size_t>(random.below(2))) % 3;
    return {Base::vec(corners[first]), Base::vec(corners[second]),
            Base::vec(corners[3 - first - second])};
  }

  constexpr Capsule<S, N> capsule() noexcept {
    const auto [a, b] = ends(3);
    const auto steps = extreme_ || random.one_in(8) ? 0 : random.between(0, far_);
    const auto back = inward() * steps;
    return {Base::vec(a + back), Base::vec(b + back),
            extreme_ ? Base::scalar(extent()) : radius(steps)};
  }

  constexpr Segment<S, N> segment() noexcept {
    const auto [a, b] = ends(5);
    return {Base::vec(a), Base::vec(b)};
  }

  /// One to eight points, rarely none; some are duplicates or inside the hull of the others.
  constexpr HullPoints<S, N> hull() noexcept {
    HullPoints<S, N> result;
    const auto count = random.one_in(64) ? 0 : random.between(1, 8);
    const bool loose = random.one_in(4);
    const auto next = anchor(3);
    const auto corners = loose ? anywhere() : standing_at(next);
    for (std::int64_t i = 0; i < count; ++i) {
      const auto more = extreme_ ? any_point()
                        : loose  ? center_ + corner(reach_)
                                 : next + slanted(far_);
      const auto index = static_cast<std::size_t>(i);
      result.points[index] = Base::vec(i < 3              ? corners[index]
                                       : random.one_in(8) ? corners[0]
                                                          : more);
    }
    result.count = static_cast<std::uint8_t>(count);
    return result;
  }

  /// Along the plane or into its side, starting or ending near the spot.
  constexpr Ray<S, N> ray() noexcept {
    if (extreme_ || random.one_in(8)) {
      const auto origin = extreme_ ? any_point() : center_ + corner(reach_);
      return {Base::vec(origin), Base::direction(Base::template any_direction<N>()), Base::any()};
    }
    const auto next = anchor(5);
    const int axis = random.coin() ? 1 : 0;
    const auto sign = axis == 0 ? side_ : random.sign();
    const auto steps = axis == 0 && random.coin() ? 0 : random.between(0, far_);
    return {Base::vec(next - frame_.axes[axis] * (sign * steps)),
            Base::direction(Base::along(frame_, axis) * sign), end(steps * frame_.norm)};
  }

  /// Along an axis of the frame through the spot or next to it, or towards it from anywhere.
  constexpr Ray<S, N> aimed_ray() noexcept {
    if (random.one_in(4)) {
      const auto origin = extreme_ ? any_point() : center_ + corner(3 * reach_);
      const auto path = center_ - origin;
      return {Base::vec(origin), Base::direction(unit(path, Base::one)), end(length(path))};
    }
    const auto target = random.one_in(8) ? center_ + corner(1) : center_;
    const int axis = static_cast<int>(random.below(N));
    const auto sign = random.sign();
    const auto steps = random.between(-far_ / 8, far_);
    return {Base::vec(target - frame_.axes[axis] * (sign * steps)),
            Base::direction(Base::along(frame_, axis) * sign), end(steps * frame_.norm)};
  }

  /// Moves the spot back, and returns the way from there to the first one: mostly along the frame,
  /// so that shapes on both sides of it that touch there touch at a whole number of steps, or slide
  /// along each other.
  constexpr Ray<S, N> retreat() noexcept {
    if (extreme_ || random.one_in(4)) {
      const auto target = center_ + corner(reach_ / 2);
      center_ = extreme_ ? any_point() : center_ + corner(3 * reach_);
      const auto path = target - center_;
      return {Base::vec(center_), Base::direction(unit(path, Base::one)), end(length(path))};
    }
    // In the plane there are fewer ways past a target.
    const int axis = random.one_in(N == 2 ? 2 : 3) ? static_cast<int>(random.below(N)) : 0;
    const auto sign = axis == 0 ? -side_ : random.sign();
    const auto steps = random.between(-far_ / 8, far_);
    center_ += frame_.axes[axis] * (-sign * steps);
    return {Base::vec(center_), Base::direction(Base::along(frame_, axis) * sign),
            end(steps * frame_.norm)};
  }

 protected:
  constexpr Point any_point() noexcept { return Base::template any_point<N>(); }
  /// From the plane through the spot to the shape's side.
  [[nodiscard]] constexpr Point inward() const noexcept { return frame_.axes[0] * side_; }
  /// A step along that plane.
  constexpr Point across(std::int64_t far) noexcept {
    Point step;
    for (int k = 1; k < N; ++k) step += frame_.axes[k] * random.between(-far, far);
    return step;
  }
  /// A step along that plane and inward.
  constexpr Point slanted(std::int64_t far) noexcept {
    const auto step = across(far);
    return step + inward() * random.between(0, far);
  }

  /// The shape's point nearest to the plane: the spot itself `at_spot` times in eight.
  constexpr Point anchor(std::uint64_t at_spot) noexcept {
    const auto pick = random.below(8);
    gap_ = 0;
    if (pick < at_spot) return center_;
    if (pick == 7) return center_ + corner(1);
    if (pick % 2 == 0) return center_ - inward() * random.between(0, far_ / 2);
    const auto steps = random.between(0, far_);
    gap_ = steps * frame_.norm;
    return center_ + inward() * steps;
  }

  /// Mostly `steps` of the frame; sometimes off by a unit, 0 or negative.
  constexpr std::int64_t radius_of(std::int64_t steps) noexcept {
    if (random.one_in(64)) return random.between(-2, 0);
    const auto beside = random.one_in(16) ? random.between(-1, 1) : 0;
    return steps * frame_.norm + beside;
  }
  constexpr S radius(std::int64_t steps) noexcept { return Base::scalar(radius_of(steps)); }

  /// The ends of a segment: inward from the anchor, to both sides of it along the plane, or through
  /// it in any direction.
  constexpr std::array<Point, 2> ends(std::uint64_t at_spot) noexcept {
    if (extreme_) {
      const auto a = random.coin() ? center_ : any_point();
      return {a, any_point()};
    }
    if (random.one_in(8)) {
      const auto a = center_ + corner(reach_);
      return {a, center_ + corner(reach_)};
    }
    const auto next = anchor(at_spot);
    std::array<Point, 2> result{next, next};
    switch (random.below(4)) {
      case 0:
        result[1] += inward() * random.between(0, far_);
        break;
      case 1:
        result[1] += slanted(far_);
        break;
      default: {
        const auto step = random.coin() ? across(far_ / 4) : slanted(far_ / 4);
        const auto before = random.between(0, 3), after = random.between(0, 3);
        result = {next - step * before, next + step * after};
      }
    }
    if (random.coin()) return {result[1], result[0]};
    return result;
  }

  constexpr std::array<Point, 3> anywhere() noexcept {
    std::array<Point, 3> corners;
    for (auto& point : corners) {
      point = !extreme_ ? center_ + corner(reach_) : random.one_in(4) ? center_ : any_point();
    }
    return corners;
  }
  /// A triangle with the anchor at a corner, on an edge, or inside.
  constexpr std::array<Point, 3> standing() noexcept { return standing_at(anchor(N == 2 ? 3 : 5)); }
  constexpr std::array<Point, 3> standing_at(const Point& next) noexcept {
    switch (random.below(3)) {
      case 0: {
        const auto b = next + slanted(far_), c = next + slanted(far_);
        return {next, b, c};
      }
      case 1: {
        const auto step = across(far_ / 4);
        const auto before = random.between(0, 3), after = random.between(0, 3);
        return {next - step * before, next + step * after, next + slanted(far_)};
      }
      default: {
        const auto u = N == 2 ? slanted(far_ / 8) : across(far_ / 8);
        const auto v = N == 2 ? slanted(far_ / 8) : across(far_ / 8);
        const auto s = random.between(0, 4), t = random.between(0, 4);
        const auto first = next - u * s - v * t;
        return {first, first + u * 8, first + v * 8};
      }
    }
  }

  /// The end of a ray whose anchor is at `distance`: mostly the maximum.
  constexpr S end(std::int64_t distance) noexcept {
    switch (random.below(8)) {
      case 0:
      case 1:
        return Base::scalar(distance + random.between(-1, 1));
      case 2:
        return Base::scalar(random.between(-1, reach_));
      default:
        return largest<S>;
    }
  }

  Frame<N> frame_{};
  std::int64_t far_ = 0;  // the reach in steps of the frame
  Point home_{};          // the first spot
  std::int64_t side_ = 1;
  std::int64_t gap_ = 0;  // from the spot to the shape, where known
};

}  // namespace detent::verify
