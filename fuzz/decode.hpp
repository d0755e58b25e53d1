// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <deque>
#include <vector>

#include "detent/shape/hull.hpp"
#include "detent/shape/shape.hpp"
#include "oracle/draw.hpp"
#include "source.hpp"
#include "support/shapes.hpp"

namespace detent::fuzz {

/// Decodes bytes into shapes, many of which touch, graze, are parallel, coincide, are tiny or reach
/// the ends of the domain: bytes mostly choose how a point, direction or length follows from
/// earlier ones, and otherwise its value.
template <Scalar S, int N>
class Decoder {
 public:
  using D = oracle::Draw<S, N>;
  using Raw = oracle::Raw<N>;
  static constexpr auto size = static_cast<std::size_t>(N);

  explicit Decoder(Source& source)
      : source_(source),
        manner_(static_cast<Manner>(source.below(5))),
        size_bits_(static_cast<int>(source.below(static_cast<std::size_t>(S::bits)))),
        frame_(frames()[source.word(2) % frames().size()]) {
    for (auto& component : center_) component = source.bits(S::bits);
    keep(center_);
  }

  Vec<S, N> point() { return D::vec(keep(raw_point())); }

  Direction<S, N> direction() {
    const auto result = any_direction();
    directions_.push_back(result);
    return result;
  }

  S number() { return D::scalar(coordinate(0)); }

  /// A radius or half extent: sometimes the distance between two points, to the raw unit.
  S reach() {
    switch (source_.below(8)) {
      case 0:
        return S(0);
      case 1:
        return D::scalar(source_.bits(3));
      case 2: {
        const auto p = earlier(), q = earlier();
        double square = 0;
        for (std::size_t i = 0; i < size; ++i) {
          square += std::pow(static_cast<double>(p[i] - q[i]), 2);
        }
        return D::scalar(static_cast<std::int64_t>(std::sqrt(square)) + source_.step());
      }
      case 3: {
        const auto i = source_.below(size);
        return D::scalar(std::abs(earlier()[i] - earlier()[i]) + source_.step());
      }
      case 4:
        return D::scalar(corner());
      default:
        return D::scalar(std::abs(source_.bits(size_bits_)));
    }
  }

  Rotation<S, N> rotation() {
    std::array<Direction<S, N>, size> axes;
    const auto kind = source_.below(4);
    for (std::size_t i = 0; i < size; ++i) {
      axes[i] = kind == 0   ? Direction<S, N>::along(static_cast<int>(i))
                : kind == 1 ? D::stretched(frame_.axes[i], frame_.norm)
                            : direction();
    }
    if (kind == 2) axes = orthonormal();
    for (const auto& axis : axes) directions_.push_back(axis);
    return Rotation<S, N>::from_axes(axes);
  }

  void read(Sphere<S, N>& sphere) {
    sphere = {point(), reach()};
    auto pole = raw(sphere.center);
    pole[source_.below(size)] += sphere.radius.raw();
    keep(pole);
  }
  void read(Aabb<S, N>& box) {
    box = {point(), point()};
    const bool as_read = source_.below(8) == 0;
    for (int i = 0; i < N && !as_read; ++i) {
      if (box.max[i] < box.min[i]) std::swap(box.min[i], box.max[i]);
    }
    auto corner = raw(box.min);
    corner[0] = box.max.x.raw();
    keep(corner);
  }
  void read(Obb<S, N>& box) {
    box.center = point();
    for (int i = 0; i < N; ++i) box.half_extents[i] = reach();
    box.rotation = rotation();
    auto face = raw(box.center);
    const auto i = static_cast<int>(source_.below(size));
    keep(D::moved(face, box.rotation.axis(i), box.half_extents[i].raw()));
  }
  /// Through a point, or next to it, or anywhere.
  void read(Plane<S, N>& plane) {
    plane.normal = direction();
    const auto p = raw(point());
    oracle::Integer offset = 0;
    for (std::size_t i = 0; i < size; ++i) {
      offset += oracle::Integer(p[i]) * raw_of_component(plane.normal, i);
    }
    const auto nearest = oracle::nearest_even(offset, direction_component<S>::frac);
    plane.offset = source_.below(4) == 0
                       ? number()
                       : D::scalar(static_cast<std::int64_t>(nearest) + source_.step());
  }
  template <support::OfPoints Shape>
  void read(Shape& shape) {
    shape = support::made_of<Shape>([this] { return point(); }, [this] { return reach(); });
  }
  /// Up to seven points, or the corners of a box, whose faces have four. The decoder owns them.
  void read(ConvexHull<S, N>& hull) {
    auto& points = hulls_.emplace_back();
    const auto count = source_.below(9);
    if (count < 8) {
      for (std::size_t i = 0; i < count; ++i) points.push_back(point());
    } else {
      const auto from = point(), to = point();
      for (unsigned corner = 0; corner < 1u << N; ++corner) {
        points.push_back(from);
        for (int i = 0; i < N; ++i) {
          if ((corner >> i & 1) != 0) points.back()[i] = to[i];
        }
      }
    }
    hull = {points};
  }
  /// Usually long.
  void read(Ray<S, N>& ray) {
    const auto origin = point();
    ray = {origin, direction()};
    if (source_.below(4) == 0) ray.max_distance = reach();
  }

  template <class Shape>
  Shape shape() {
    Shape result;
    read(result);
    return result;
  }

 private:
  enum class Manner { scene, corners, tiny, lattice, any };

  static const std::vector<oracle::Frame<N>>& frames() {
    static const auto all = oracle::exact_frames<S, N>();
    return all;
  }
  static std::int64_t raw_of_component(const Direction<S, N>& direction, std::size_t i) {
    return direction[static_cast<int>(i)].raw();
  }
  static Raw raw(const Vec<S, N>& v) {
    Raw result{};
    for (std::size_t i = 0; i < size; ++i) result[i] = v[static_cast<int>(i)].raw();
    return result;
  }

  const Raw& keep(const Raw& point) {
    points_.push_back(raw(D::vec(point)));  // clamped
    return points_.back();
  }
  Raw earlier() { return points_[source_.below(points_.size())]; }

  /// At or next to an end of the domain or a power of two.
  std::int64_t corner() {
    const auto power = std::int64_t{1} << source_.below(static_cast<std::size_t>(S::bits) + 1);
    return (source_.below(2) == 0 ? power : -power) + source_.step();
  }
  std::int64_t coordinate(std::int64_t center) {
    switch (manner_) {
      case Manner::corners:
        return corner();
      case Manner::tiny:
        return center + source_.bits(2);
      case Manner::any:
        return source_.bits(S::bits);
      default:
        return center + source_.bits(size_bits_);
    }
  }

  Raw raw_point() {
    switch (source_.below(8)) {
      case 4:
        return earlier();
      case 5: {
        auto result = earlier();
        result[source_.below(size)] += source_.step();
        return result;
      }
      case 6: {  // parallel to two others, or collinear with them
        const auto from = earlier(), to = earlier(), start = earlier();
        const auto times = source_.bits(2);
        return D::plus(D::plus(start, to, times), from, -times);
      }
      case 7: {
        auto result = D::plus(earlier(), earlier());
        for (auto& component : result) component /= 2;
        return result;
      }
      default:
        break;
    }
    Raw result = center_;
    if (manner_ != Manner::lattice) {
      for (auto& component : result) component = coordinate(component);
      return result;
    }
    const auto stride = std::int64_t{1} << (size_bits_ / 2);
    for (const auto& axis : frame_.axes) result = D::plus(result, axis, stride * source_.bits(2));
    return result;
  }

  Direction<S, N> any_direction() {
    const auto known =
        directions_.empty() ? Direction<S, N>() : directions_[source_.below(directions_.size())];
    const auto kind = source_.below(8);
    const auto i = source_.below(size);
    switch (kind) {
      case 0:
        return Direction<S, N>::along(static_cast<int>(i));
      case 1:
        return D::stretched(frame_.axes[i], frame_.norm);
      case 2:
        return source_.below(2) == 0 ? known : -known;
      case 3: {  // nearly parallel, its length off by as much as allowed
        std::array<typename Direction<S, N>::Raw, size> raw{};
        for (std::size_t k = 0; k < size; ++k) {
          raw[k] = static_cast<typename Direction<S, N>::Raw>(raw_of_component(known, k) +
                                                              source_.step());
        }
        return Direction<S, N>::from_raw(raw).value_or(known);
      }
      case 4: {
        Raw v{};
        for (auto& component : v) component = source_.bits(15);
        return towards(v);
      }
      case 5: {  // perpendicular
        const auto from = earlier(), to = earlier();
        const auto k = (i + 1) % size;
        Raw v{};
        v[i] = to[k] - from[k];
        v[k] = from[i] - to[i];
        return towards(v);
      }
      default: {
        const auto from = earlier();
        return towards(D::plus(earlier(), from, -1));
      }
    }
  }
  static Direction<S, N> towards(const Raw& v) {
    std::array<double, size> along{};
    for (std::size_t i = 0; i < size; ++i) along[i] = static_cast<double>(v[i]);
    return v == Raw{} ? Direction<S, N>() : D::along(along);
  }

  /// From a quaternion; in 2D, from one direction.
  std::array<Direction<S, N>, size> orthonormal() {
    if constexpr (N == 2) {
      const auto d = direction();
      const auto x = static_cast<double>(d[0].raw()), y = static_cast<double>(d[1].raw());
      return {d, D::along({-y, x})};
    } else {
      std::array<S, 4> q;
      for (auto& component : q) {
        component =
            S::from_raw(static_cast<typename S::raw_type>(source_.bits(std::min(S::bits, 15))));
      }
      const auto turn = Rotation<S, N>::from_quaternion(q[0], q[1], q[2], q[3]);
      const auto result = turn.value_or(Rotation<S, N>());
      return {result.axis(0), result.axis(1), result.axis(2)};
    }
  }

  Source& source_;
  Manner manner_;
  int size_bits_;
  oracle::Frame<N> frame_;
  Raw center_{};
  std::vector<Raw> points_;
  std::vector<Direction<S, N>> directions_;
  std::deque<std::vector<Vec<S, N>>> hulls_;
};

}  // namespace detent::fuzz
