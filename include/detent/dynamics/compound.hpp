// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "detent/dynamics/asset_body.hpp"
#include "detent/dynamics/local.hpp"
#include "detent/dynamics/mass.hpp"
#include "detent/scene/one_of.hpp"

namespace detent {

/// The material of a part of a compound, as in `BodyOptions`. A compound ignores the fields with
/// these names in its `BodyOptions`.
template <Scalar S>
struct PartOptions {
  S density = S(1);  // mass per area or volume; 0: the part adds no mass
  S friction = quotient_nearest<S>(detail::as_operand<S>(3), detail::as_operand<S>(5));  // 0.6
  S restitution{};
  bool is_sensor = false;  // its touches are reported, and it pushes nothing
  S rolling_resistance{};
};

/// A shape of a compound, in the compound's frame: `BodyPart(Obb<q16_16, 2>{...})`, optionally with
/// options.
template <Scalar S, int N>
class BodyPart {
  using F = detail::Formats<S>;
  using Center = typename detail::MassFormats<S>::Center;

 public:
  using Shape = detail::OneOf<Sphere<S, N>, Capsule<S, N>, Aabb<S, N>, Obb<S, N>, BodyHull<S, N>>;

  /// A part with this shape, given in the compound's frame.
  template <detail::Among<Sphere<S, N>, Capsule<S, N>, Aabb<S, N>, Obb<S, N>, BodyHull<S, N>> Part>
  explicit constexpr BodyPart(const Part& shape, const PartOptions<S>& options = {}) noexcept
      : options_(options) {
    const auto local = detail::local_form(shape);
    shape_ = Shape(local.shape);
    place_ = make_vec<N>([&](int i) { return typename F::Place(local.center[i]); });
    axes_ = detail::axes_of<S, N>(local.orientation);
    reach_ = detail::extent_of(local.shape);
    mass_ = turned(mass_properties(local.shape, options.density));
    mass_.center = mass_.mass > 0 ? center_of(shape) : Vec<Center, N>();
  }

  /// The shape in its own frame: the origin is the center of mass of a hull, the middle of others.
  [[nodiscard]] constexpr const Shape& shape() const noexcept { return shape_; }
  [[nodiscard]] constexpr const PartOptions<S>& options() const noexcept { return options_; }
  /// The position of that frame in the compound's.
  [[nodiscard]] constexpr const auto& place() const noexcept { return place_; }
  [[nodiscard]] constexpr const detail::Axes<S, N>& axes() const noexcept { return axes_; }
  [[nodiscard]] constexpr const detail::BodyExtent<S, N>& reach() const noexcept { return reach_; }
  /// In the compound's frame.
  [[nodiscard]] constexpr const MassProperties<S, N>& mass() const noexcept { return mass_; }

 private:
  template <class Part>
  [[nodiscard]] constexpr Vec<Center, N> center_of(const Part& shape) const noexcept {
    if constexpr (detail::is_hull_body<Part>) {
      return make_vec<N>([&](int i) { return nearest_to<Center>(place_[i]); });
    } else {
      return mass_properties(shape, S(1)).center;
    }
  }
  /// The mass with its gyration along the compound's axes: each entry rounded to nearest once.
  [[nodiscard]] constexpr MassProperties<S, N> turned(MassProperties<S, N> mass) const noexcept {
    if constexpr (N == 3) {
      using Gyration = typename detail::MassFormats<S>::Gyration;
      const auto& own = mass.gyration;
      const auto entry = [&](int r, int c) {
        const auto row = [&](int i) {
          const auto& [a, b, d] = axes_;
          return own.at(i, 0) * a[c] + own.at(i, 1) * b[c] + own.at(i, 2) * d[c];
        };
        return nearest_to<Gyration>(row(0) * axes_[0][r] + row(1) * axes_[1][r] +
                                    row(2) * axes_[2][r]);
      };
      mass.gyration = {{entry(0, 0), entry(1, 1), entry(2, 2)},
                       {entry(1, 2), entry(2, 0), entry(0, 1)}};
    }
    return mass;
  }

  Shape shape_{};
  PartOptions<S> options_;
  Vec<typename F::Place, N> place_{};
  detail::Axes<S, N> axes_{};
  detail::BodyExtent<S, N> reach_{};
  MassProperties<S, N> mass_{};
};
template <template <Scalar, int> class Shape, Scalar S, int N>
BodyPart(const Shape<S, N>&) -> BodyPart<S, N>;
template <template <Scalar, int> class Shape, Scalar S, int N>
BodyPart(const Shape<S, N>&, const PartOptions<S>&) -> BodyPart<S, N>;

/// Several shapes that move as one body, with an id chosen by the caller; `BodyCompound` refers to
/// it. `solid_compound` makes one. Snapshots store the id and the digest of the parts.
///
/// The caller owns the parts and must not change them.
template <Scalar S, int N>
class SolidCompound {
 public:
  /// The most parts of a compound.
  static constexpr std::size_t capacity = std::size_t{1} << 16;

  constexpr SolidCompound() noexcept = default;

  [[nodiscard]] constexpr std::span<const BodyPart<S, N>> parts() const noexcept { return parts_; }
  [[nodiscard]] constexpr std::uint32_t id() const noexcept { return id_; }
  [[nodiscard]] constexpr std::uint64_t digest() const noexcept { return digest_; }
  /// The mass of all parts; its `center` is in the frame of the parts. Where parts overlap, masses
  /// add.
  [[nodiscard]] constexpr const MassProperties<S, N>& mass() const noexcept { return mass_; }
  [[nodiscard]] constexpr const auto& center() const noexcept { return mass_.center; }
  /// A box about the center that contains all parts.
  [[nodiscard]] constexpr const detail::BodyExtent<S, N>& reach() const noexcept { return reach_; }
  /// Whether a part has a rolling resistance.
  [[nodiscard]] constexpr bool resists_rolling() const noexcept { return resists_rolling_; }
  /// The position of a part's frame relative to the center.
  [[nodiscard]] constexpr auto offset(const BodyPart<S, N>& part) const noexcept {
    using Lever = typename detail::Formats<S>::Lever;
    return make_vec<N>([&](int i) { return nearest_to<Lever>(part.place()[i] - mass_.center[i]); });
  }

  /// What `solid_compound` returns.
  [[nodiscard]] static constexpr std::optional<SolidCompound> make(
      std::uint32_t id, std::span<const BodyPart<S, N>> parts) noexcept {
    if (parts.empty() || parts.size() > capacity) return std::nullopt;
    SolidCompound solid;
    solid.parts_ = parts;
    solid.id_ = id;
    solid.mass_ = detail::sum_of<S, N>([&](const auto& add) {
      for (const auto& part : parts) add(part.mass());
    });
    Digest digest;
    for (const auto& part : parts) {
      const auto& options = part.options();
      part.shape().visit([&]<class Shape>(const Shape& shape) {
        digest.add(detail::shape_tag<Shape>, shape, part.place());
      });
      for (const auto& axis : part.axes()) digest.add(axis);
      const bool resists = options.rolling_resistance != S{};
      solid.resists_rolling_ = solid.resists_rolling_ || options.rolling_resistance > 0;
      digest.add(options.density, options.friction, options.restitution,
                 static_cast<std::uint8_t>((options.is_sensor ? 1 : 0) | (resists ? 2 : 0)));
      if (resists) digest.add(options.rolling_resistance);
      const auto at = make_vec<N>([&](int i) {
        return saturate_to<typename detail::Formats<S>::Place>(solid.offset(part)[i]);
      });
      const auto bounds = detail::bounds_of<S, N>(at, part.axes(), part.reach(), S(0));
      solid.reach_.half_extents = make_vec<N>([&](int k) {
        const auto most = (max)(abs(bounds.least[k]), abs(bounds.most[k]));
        return (max)(solid.reach_.half_extents[k], saturate_to<S>(ceil_to<S>(most)));
      });
    }
    solid.digest_ = digest.value();
    return solid;
  }

 private:
  std::span<const BodyPart<S, N>> parts_;
  std::uint64_t digest_ = 0;
  std::uint32_t id_ = 0;
  bool resists_rolling_ = false;
  MassProperties<S, N> mass_{};
  detail::BodyExtent<S, N> reach_{};
};

/// The compound of these parts, or nothing if there are none or more than `SolidCompound<S,
/// N>::capacity`. Parts are identified by their index in the list.
///
/// exact: mass, center and gyration are those of the sum of the parts, each rounded once; see
///        docs/dynamics.md                              (tests/dynamics/compound.test.cpp)
template <Scalar S, int N>
[[nodiscard]] constexpr std::optional<SolidCompound<S, N>> solid_compound(
    std::uint32_t id, std::span<const BodyPart<S, N>> parts) noexcept {
  return SolidCompound<S, N>::make(id, parts);
}
/// The same for an array or a vector of parts.
template <class List>
requires requires(const List& list) { std::span(list).front().mass(); }
[[nodiscard]] constexpr auto solid_compound(std::uint32_t id, const List& list) noexcept {
  return solid_compound(id, [&]<Scalar S, int N>(const BodyPart<S, N>* first) {
    return std::span<const BodyPart<S, N>>(first, std::span(list).size());
  }(std::span(list).data()));
}

/// A body of several shapes: the parts of `asset`, rotated, then moved by `translation`. Worlds that
/// hold such bodies list it and the shapes of the parts: `World<q16_16, 2, Obb, BodyCompound>`.
///
/// The body's position is the parts' common center of mass. Density, friction and restitution are
/// those of the parts. The caller owns the asset, which must outlive the world; a body without one
/// has no mass and touches nothing.
template <Scalar S, int N>
struct BodyCompound {
  const SolidCompound<S, N>* asset = nullptr;
  Vec<S, N> translation{};
  Rotation<S, N> rotation{};

  [[nodiscard]] friend constexpr bool operator==(const BodyCompound&,
                                                 const BodyCompound&) noexcept = default;
};

template <Scalar S, int N>
BodyCompound(const SolidCompound<S, N>*, Vec<S, N> = {}, Rotation<S, N> = {}) -> BodyCompound<S, N>;

template <Scalar S, int N>
inline constexpr detail::AssetNames detail::asset_names<BodyCompound<S, N>>{"compound",
                                                                            "digest of its parts"};

/// The mass of the parts, each by its own density.
template <Scalar S, int N>
[[nodiscard]] constexpr MassProperties<S, N> mass_properties(const BodyCompound<S, N>& body,
                                                             S) noexcept {
  return body.asset ? body.asset->mass() : MassProperties<S, N>{};
}

namespace detail {

template <class T>
inline constexpr bool is_compound_body = false;
template <Scalar S, int N>
inline constexpr bool is_compound_body<BodyCompound<S, N>> = true;

template <Scalar S, int N>
inline constexpr std::uint8_t shape_tag<BodyCompound<S, N>> = 13;

template <Scalar S, int N>
[[nodiscard]] constexpr auto local_form(const BodyCompound<S, N>& body) noexcept {
  return centered_form<S, N>(body);
}

template <Scalar S, int N>
[[nodiscard]] constexpr BodyExtent<S, N> extent_of(const BodyCompound<S, N>& body) noexcept {
  return body.asset ? body.asset->reach() : BodyExtent<S, N>{};
}

/// The compound of a body, or nullptr.
template <Scalar S, int N, class... Shapes>
[[nodiscard]] constexpr const SolidCompound<S, N>* compound_of(
    const OneOf<Shapes...>& shape) noexcept {
  if constexpr ((is_compound_body<Shapes> || ...)) {
    const auto* body = shape.template get<BodyCompound<S, N>>();
    return body == nullptr ? nullptr : body->asset;
  } else {
    return nullptr;
  }
}

/// Whether all parts are of shapes among these.
template <class... Shapes, Scalar S, int N>
[[nodiscard]] constexpr bool has_only(const SolidCompound<S, N>& compound) noexcept {
  for (const auto& part : compound.parts()) {
    if (!part.shape().visit([]<class Part>(const Part&) { return Among<Part, Shapes...>; })) {
      return false;
    }
  }
  return true;
}

/// The frame of a part in that of its body.
template <Scalar S, int N>
[[nodiscard]] constexpr RelativePose<S, N> pose_in(const SolidCompound<S, N>& compound,
                                                   const BodyPart<S, N>& part) noexcept {
  return {part.axes(), compound.offset(part)};
}

/// Transforms a manifold from the frame of a part to that of its body: each number rounded once
/// more.
template <Scalar S, int N>
[[nodiscard]] constexpr Manifold<S, N> in_body(const RelativePose<S, N>& part,
                                               Manifold<S, N> manifold) noexcept {
  using Ratio = typename Formats<S>::Ratio;
  manifold.normal = nearest_to<Ratio>(turned(part, manifold.normal));
  move_points(part, manifold);
  return manifold;
}

/// A pose at a given time.
template <Scalar S, int N>
struct Standing {
  Vec<typename Formats<S>::Place, N> place{};
  Axes<S, N> axes{};
};

/// The world position of a point `p` in the frame of a body, each coordinate rounded once.
template <Scalar S, int N>
[[nodiscard]] constexpr Vec<typename Formats<S>::Place, N> out_of(
    const Standing<S, N>& body, const Vec<typename Formats<S>::Lever, N>& p) noexcept {
  return make_vec<N>([&](int k) {
    const auto row = make_vec<N>([&](int i) { return body.axes[static_cast<std::size_t>(i)][k]; });
    return nearest_to<typename Formats<S>::Place>(body.place[k] + dot(row, p));
  });
}

/// The pose of a part of a body at `body`: each number rounded once.
template <Scalar S, int N>
[[nodiscard]] constexpr Standing<S, N> part_at(const Standing<S, N>& body,
                                               const RelativePose<S, N>& part) noexcept {
  Standing<S, N> result;
  result.place = out_of(body, part.translation);
  for (std::size_t j = 0; j < std::size_t{N}; ++j) {
    result.axes[j] = make_vec<N>([&](int k) {
      const auto row =
          make_vec<N>([&](int i) { return body.axes[static_cast<std::size_t>(i)][k]; });
      return nearest_to<typename Formats<S>::Ratio>(narrow_dot<62>(row, part.axes[j]));
    });
  }
  return result;
}

}  // namespace detail

}  // namespace detent
