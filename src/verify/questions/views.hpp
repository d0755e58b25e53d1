// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

#include "detent/query/overlaps/frustum.hpp"
#include "detent/shape/camera.hpp"
#include "verify/draw/numbers.hpp"
#include "verify/questions/cases.hpp"

// Queries on cameras and frusta.

namespace detent::verify {

template <Scalar S, int N>
struct ViewCase {
  Transform<S, N> pose;
  bool narrows;  // perspective: a field of view; otherwise half the width and height
  Angle<S> fov;
  S width, height, near_distance, far_distance;
  Vec<S, N> point;
  S x, y, depth;
  Aabb<S, N> box;

  [[nodiscard]] constexpr std::optional<Camera<S>> camera() const noexcept {
    const auto lens = narrows ? Lens<S>::perspective(fov, width, near_distance, far_distance)
                              : Lens<S>::orthographic(width, height, near_distance, far_distance);
    if (!lens) return std::nullopt;
    return Camera<S>{pose, *lens};
  }

  static constexpr std::array<std::string_view, 12> field_names{"pose",
                                                                "perspective",
                                                                "fov",
                                                                "aspect, or half width",
                                                                "half height",
                                                                "near_distance",
                                                                "far_distance",
                                                                "point",
                                                                "x",
                                                                "y",
                                                                "depth",
                                                                "box"};
  constexpr auto fields(const auto& f) const noexcept {
    return f(pose, narrows, fov, width, height, near_distance, far_distance, point, x, y, depth,
             box);
  }
};

struct Views : InDimensions<3> {
  static constexpr std::array<std::string_view, 5> names{"camera/project", "camera/unproject",
                                                         "camera/pick_ray", "camera/corners",
                                                         "frustum/overlaps"};
  static constexpr std::uint32_t share = 32;
  template <Scalar S, int N>
  static constexpr auto draw(Random& random) noexcept {
    Numbers<S> numbers(random);
    constexpr auto one = std::int64_t{1} << S::frac;
    constexpr auto limit = Numbers<S>::limit;
    ViewCase<S, N> c{};
    // Mostly near each other, each pair at its own scale.
    const auto reach = std::int64_t{1} << random.between(4, S::bits - 1);
    const auto near = [&] {
      Raw<N> raw;
      for (int i = 0; i < N; ++i) raw[i] = random.between(-reach, reach);
      return numbers.vec(raw);
    };
    const bool any = random.one_in(8);
    c.pose.translation = any ? numbers.vec(numbers.template any_point<N>()) : near();
    c.pose.rotation = numbers.template any_rotation<N>();
    c.narrows = !random.one_in(3);
    c.fov = Angle<S>::from_raw(
        static_cast<std::uint32_t>(random.between(1 << 24, (std::int64_t{1} << 31) - 1)));
    c.width =
        numbers.scalar(c.narrows ? random.between(one / 4, 4 * one) : random.between(1, reach));
    c.height = numbers.scalar(random.between(any ? -1 : 1, reach));
    const auto nearest = random.between(any ? -1 : 1, reach / 2);
    c.near_distance = numbers.scalar(nearest);
    c.far_distance = numbers.scalar(nearest + random.between(1, reach));
    c.point = any ? numbers.vec(numbers.template any_point<N>()) : near();
    c.x = numbers.scalar(random.between(-2 * one, 2 * one));
    c.y = numbers.scalar(random.between(-2 * one, 2 * one));
    c.depth = any ? numbers.any() : numbers.scalar(random.between(-limit / 8, limit / 8));
    // Around a point ahead of the camera.
    const auto ahead = random.between(0, reach);
    for (int i = 0; i < N; ++i) {
      const auto along = c.pose.rotation.axis(2)[i].raw() * ahead / Numbers<S>::one;
      const auto middle = c.pose.translation[i].raw() - along + random.between(-reach, reach) / 2;
      c.box.min[i] = numbers.scalar(middle - random.between(0, reach / 2));
      c.box.max[i] = numbers.scalar(middle + random.between(0, reach / 2));
    }
    return c;
  }
  template <int Row, Scalar S, int N>
  [[nodiscard]] static constexpr auto answer(const ViewCase<S, N>& c) noexcept {
    const auto camera = c.camera();
    if constexpr (Row == 0) {
      return camera ? project(*camera, c.point) : std::nullopt;
    } else if constexpr (Row == 1) {
      return camera ? std::optional(unproject(*camera, c.x, c.y, c.depth)) : std::nullopt;
    } else if constexpr (Row == 2) {
      return camera ? std::optional(pick_ray(*camera, c.x, c.y)) : std::nullopt;
    } else if constexpr (Row == 3) {
      return camera ? std::optional(Frustum{*camera}.corners()) : std::nullopt;
    } else {
      return camera && overlaps(Frustum{*camera}, c.box);
    }
  }
};

}  // namespace detent::verify
