// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "verify/draw/shapes.hpp"

namespace detent::verify {

/// The triangles of a mesh in input order: none to forty, so that some trees have two levels.
template <Scalar S>
struct MeshTriangles {
  static constexpr std::size_t capacity = 40;
  std::array<Triangle<S, 3>, capacity> triangles{};
  std::uint8_t count = 0;
};
template <class D, Scalar S>
constexpr void append(D& digest, const MeshTriangles<S>& mesh) noexcept {
  digest.add(mesh.count);
  for (std::size_t i = 0; i < mesh.count; ++i) digest.add(mesh.triangles[i]);
}

/// The samples of a height field, at most four by four.
template <Scalar S>
struct FieldSamples {
  Vec<S, 2> corner;
  S cell{};
  std::uint8_t columns = 0;
  std::uint8_t rows = 0;
  std::array<S, 16> heights{};
};
template <class D, Scalar S>
constexpr void append(D& digest, const FieldSamples<S>& field) noexcept {
  digest.add(field.corner, field.cell, field.columns, field.rows);
  for (std::size_t i = 0; i < std::size_t{field.columns} * field.rows; ++i) {
    digest.add(field.heights[i]);
  }
}

/// Draws surfaces of triangles, and query positions on and near them.
template <Scalar S>
class SurfaceScene : public ShapeScene<S, 3> {
  using Base = ShapeScene<S, 3>;
  using Base::any_point;
  using Base::center_;
  using Base::extreme_;
  using Base::far_;
  using Base::frame_;
  using Base::home_;
  using Base::reach_;

 public:
  using Base::random;
  using typename Base::Point;

  using Base::Base;

  constexpr MeshTriangles<S> mesh() noexcept {
    MeshTriangles<S> mesh;
    const auto most = random.one_in(4) ? MeshTriangles<S>::capacity : std::size_t{12};
    mesh.count = static_cast<std::uint8_t>(random.between(0, static_cast<std::int64_t>(most)));
    const auto kind = extreme_ ? 0 : random.below(4);
    const auto step = std::max<std::int64_t>(far_ / 4, 1);
    const auto bump = random.coin() ? 0 : random.between(-step, step);
    for (std::size_t i = 0; i < mesh.count; ++i) {
      auto& triangle = mesh.triangles[i];
      if (kind == 0 || i == 0) {
        triangle = Base::triangle();
        random.coin() ? Base::wander() : Base::turn();
      } else if (kind == 1) {
        triangle = part_of_sheet(static_cast<std::int64_t>(i), step, bump);
      } else if (kind == 2) {
        const auto a = knot(step), b = knot(step);
        triangle = {Base::vec(a), Base::vec(b), Base::vec(knot(step))};
      } else {
        const auto& old = mesh.triangles[static_cast<std::size_t>(random.below(i))];
        triangle = random.coin() ? Triangle<S, 3>{old.b, old.c, old.a} : Base::triangle();
      }
    }
    return mesh;
  }

  constexpr FieldSamples<S> field() noexcept {
    FieldSamples<S> field;
    field.columns = static_cast<std::uint8_t>(random.between(2, 4));
    field.rows = static_cast<std::uint8_t>(random.between(2, 4));
    const auto step = random.between(1, reach_ / 2);
    field.cell = Base::scalar(random.one_in(32) ? random.between(-2, 0) : step);
    field.corner[0] = Base::scalar(home_[0] - random.between(0, step * (field.columns - 1)));
    field.corner[1] = Base::scalar(home_[2] - random.between(0, step * (field.rows - 1)));
    const auto kind = extreme_ ? 3 : random.below(3);
    const auto across = random.between(-step, step), down = random.between(-step, step);
    for (std::int64_t row = 0; row < field.rows; ++row) {
      for (std::int64_t column = 0; column < field.columns; ++column) {
        const auto slope = across * column + down * row;
        const auto height = kind == 0   ? home_[1]
                            : kind == 1 ? home_[1] + slope / 2
                            : kind == 2 ? home_[1] + random.between(-step, step)
                                        : random.edgy(Base::bits);
        field.heights[static_cast<std::size_t>(row * field.columns + column)] =
            Base::scalar(height);
      }
    }
    return field;
  }

  /// Moves the next question to a point of the surface: a corner, on an edge or inside one of its
  /// triangles; one time in three to anywhere near.
  constexpr void aim_at(const MeshTriangles<S>& mesh) noexcept {
    if (mesh.count == 0 || random.one_in(3)) return Base::wander();
    const auto& triangle = mesh.triangles[static_cast<std::size_t>(random.below(mesh.count))];
    aim_between(triangle.a, triangle.b, triangle.c);
  }
  constexpr void aim_at(const FieldSamples<S>& field) noexcept {
    if (random.one_in(3)) return Base::wander();
    const auto column = random.between(0, field.columns - 2);
    const auto row = random.between(0, field.rows - 2);
    const auto sample = [&](std::int64_t i, std::int64_t j) {
      Vec<S, 3> point;
      const auto cell = static_cast<std::int64_t>(field.cell.raw());
      point[0] = Base::scalar(field.corner[0].raw() + i * cell);
      point[1] = field.heights[static_cast<std::size_t>(j * field.columns + i)];
      point[2] = Base::scalar(field.corner[1].raw() + j * cell);
      return point;
    };
    aim_between(sample(column + 1, row), sample(column, row + 1),
                random.coin() ? sample(column, row) : sample(column + 1, row + 1));
  }

  /// A ray at that point; every fourth is straight down or up.
  constexpr Ray<S, 3> upright_ray() noexcept {
    auto ray = Base::aimed_ray();
    if (!random.one_in(4)) return ray;
    const auto sign = random.sign();
    const auto away = random.between(0, reach_);
    ray.direction = Base::direction(Point{{0, Base::one * sign, 0}});
    ray.origin = Base::vec(center_ - Point{{0, away * sign, 0}});
    return ray;
  }

 private:
  constexpr void aim_between(const Vec<S, 3>& a, const Vec<S, 3>& b, const Vec<S, 3>& c) noexcept {
    const auto of_b = random.between(0, 4);
    const auto of_c = random.between(0, 4 - of_b);
    for (int i = 0; i < 3; ++i) {
      const std::int64_t x = a[i].raw(), y = b[i].raw(), z = c[i].raw();
      center_[i] = ((4 - of_b - of_c) * x + of_b * y + of_c * z) / 4;
    }
  }

  /// Half a cell of a grid in the plane through the spot, four cells wide: neighbours share edges,
  /// and are coplanar unless there is a bump.
  constexpr Triangle<S, 3> part_of_sheet(std::int64_t i, std::int64_t step,
                                         std::int64_t bump) noexcept {
    const auto column = i / 2 % 4, row = i / 8;
    const auto corner = [&](std::int64_t x, std::int64_t y) {
      const auto height = bump * (x * y % 3 - 1);
      return Base::vec(home_ + frame_.axes[1] * ((x - 2) * step) +
                       frame_.axes[2] * ((y - 2) * step) + frame_.axes[0] * height);
    };
    const auto low = corner(column, row), high = corner(column + 1, row + 1);
    if (i % 2 == 0) return {low, corner(column + 1, row), high};
    return {low, high, corner(column, row + 1)};
  }

  /// One of a few points, so that triangles share corners and edges, cross, repeat and collapse.
  constexpr Point knot(std::int64_t step) noexcept {
    auto point = home_;
    for (auto& axis : frame_.axes) point += axis * (random.between(-1, 1) * step);
    return point;
  }
};

}  // namespace detent::verify
