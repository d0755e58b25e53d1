// SPDX-License-Identifier: MIT
//
// A scene that is mirrored, has its axes permuted, is translated along the grid, or has the parts
// of a shape in another order gives the same results: decisions, distances and intervals to the
// bit, closest points to the bit once transformed back.

#include "decode.hpp"
#include "detent/query/closest_point.hpp"
#include "detent/query/contains.hpp"
#include "detent/query/distance.hpp"
#include "detent/query/raycast.hpp"
#include "reasons.hpp"
#include "spaces.hpp"

namespace detent::fuzz {
namespace {

/// x[i] becomes sign[i] * x[from[i]] + shift[i]; the shift applies to points only. It is even, so
/// that ties still round to the same number.
template <Scalar S, int N>
class Isometry {
 public:
  static constexpr auto size = static_cast<std::size_t>(N);

  explicit Isometry(Source& source) {
    const auto first = source.below(size);
    const bool swaps = source.below(2) == 1;
    for (std::size_t i = 0; i < size; ++i) {
      from_[i] = static_cast<int>((swaps ? size + first - i : first + i) % size);
      negates_[i] = source.below(2) == 1;
      if (source.below(2) == 1) shift_[i] = 2 * source.bits(S::bits - 2);
    }
  }

  /// Whether every point so far stayed strictly inside the range of S. Its ends are not mirror
  /// images, and a result at an end may have been clamped.
  [[nodiscard]] bool stayed_inside() const { return inside_; }

  Vec<S, N> operator()(const Vec<S, N>& p) {
    Vec<S, N> result;
    for (int i = 0; i < N; ++i) {
      const std::int64_t raw = p[from(i)].raw();
      const auto moved = (negates_[at(i)] ? -raw : raw) + shift_[at(i)];
      const std::int64_t limit = S::max().raw();
      inside_ = inside_ && moved < limit && moved > -limit && raw < limit && raw > -limit;
      result[i] = oracle::Draw<S, N>::scalar(moved);
    }
    return result;
  }
  Direction<S, N> operator()(const Direction<S, N>& d) const {
    std::array<typename Direction<S, N>::Raw, size> raw{};
    for (int i = 0; i < N; ++i) {
      const auto component = d[from(i)].raw();
      raw[at(i)] =
          static_cast<typename Direction<S, N>::Raw>(negates_[at(i)] ? -component : component);
    }
    return Direction<S, N>::from_raw(raw).value();
  }

  S operator()(const S& length) const { return length; }

  template <support::Mappable Shape>
  Shape operator()(const Shape& shape) {
    return support::mapped(shape, [this](const auto& field) { return (*this)(field); });
  }
  Aabb<S, N> operator()(const Aabb<S, N>& box) {
    Aabb<S, N> result{(*this)(box.min), (*this)(box.max)};
    for (int i = 0; i < N; ++i) {
      if (negates_[at(i)]) std::swap(result.min[i], result.max[i]);
    }
    return result;
  }
  Obb<S, N> operator()(const Obb<S, N>& box) {
    std::array<Direction<S, N>, size> axes;
    for (int i = 0; i < N; ++i) axes[at(i)] = (*this)(box.rotation.axis(i));
    return {(*this)(box.center), box.half_extents, Rotation<S, N>::from_axes(axes)};
  }
  /// A shift would change the offset by an amount that need not be on the grid.
  Plane<S, N> operator()(const Plane<S, N>& plane) {
    for (const auto shift : shift_) inside_ = inside_ && shift == 0;
    return {(*this)(plane.normal), plane.offset};
  }

 private:
  static std::size_t at(int i) { return static_cast<std::size_t>(i); }
  [[nodiscard]] int from(int i) const { return from_[at(i)]; }

  std::array<int, size> from_{};
  std::array<bool, size> negates_{};
  oracle::Raw<N> shift_{};
  bool inside_ = true;
};

// The same set of points with its parts in another order.
template <template <Scalar, int> class Shape, Scalar S, int N>
requires support::OfPoints<Shape<S, N>> Shape<S, N> renamed(const Shape<S, N>& shape) {
  std::vector<Vec<S, N>> points;
  support::visit_fields(shape, [&]<class Field>(const Field& field) {
    if constexpr (support::is_point<Field>) points.push_back(field);
  });
  return support::with_points(shape, [&](const auto&) {
    const auto last = points.back();
    points.pop_back();
    return last;
  });
}
template <Scalar S, int N>
Aabb<S, N> renamed(const Aabb<S, N>& box) {
  return box;
}
template <Scalar S, int N>
Plane<S, N> renamed(const Plane<S, N>& plane) {
  const bool mirrors = plane.offset > S::lowest();
  return mirrors ? Plane<S, N>{-plane.normal, nearest_to<S>(-plane.offset)} : plane;
}
template <Scalar S, int N>
Obb<S, N> renamed(const Obb<S, N>& box) {
  std::array<Direction<S, N>, static_cast<std::size_t>(N)> axes;
  Obb<S, N> result = box;
  for (int i = 0; i < N; ++i) {
    const int j = (i + 1) % N;
    axes[static_cast<std::size_t>(i)] = j == 0 ? -box.rotation.axis(j) : box.rotation.axis(j);
    result.half_extents[i] = box.half_extents[j];
  }
  result.rotation = Rotation<S, N>::from_axes(axes);
  return result;
}

template <class Shape, Scalar S, int N>
void check(Source& source) {
  Isometry<S, N> moved(source);
  Decoder<S, N> decoder(source);
  const auto shape = decoder.template shape<Shape>();
  const auto ray = decoder.template shape<Ray<S, N>>();
  const auto point = decoder.point();
  const auto because = reasons(shape, ray, point);

  const auto same = renamed(shape);
  const auto closest = closest_point(shape, point);
  require(contains(same, point) == contains(shape, point), because("renamed contains"));
  require(distance(same, point) == distance(shape, point), because("renamed distance"));
  require(closest_point(same, point) == closest, because("renamed closest_point"));
  const auto there = moved(shape);
  const auto point_there = moved(point), closest_there = moved(closest);
  const bool is_comparable = moved.stayed_inside();
  if (is_comparable) {
    require(contains(there, point_there) == contains(shape, point), because("moved contains"));
    require(distance(there, point_there) == distance(shape, point), because("moved distance"));
    require(closest_point(there, point_there) == closest_there, because("moved closest_point"));
  }
  if constexpr (requires { raycast(ray, shape); }) {
    const auto interval = raycast_interval(ray, shape);
    require(raycast(ray, same) == raycast(ray, shape), because("renamed raycast"));
    require(raycast_interval(ray, same) == interval, because("renamed raycast_interval"));
    const auto ray_there = moved(ray);
    if (is_comparable && moved.stayed_inside()) {
      require(raycast_interval(ray_there, there) == interval, because("moved raycast_interval"));
      require(raycast(ray_there, there) == raycast(ray, shape), because("moved raycast"));
    }
  }
}

}  // namespace

void property(Bytes input) {
  Source source(input);
  in_a_space(source, [&]<Scalar S, int N>(Space<S, N>) {
    with_one_shape<S, N, Segment<S, N>>(
        source, [&]<class Shape>(std::type_identity<Shape>) { check<Shape, S, N>(source); });
  });
}

}  // namespace detent::fuzz
