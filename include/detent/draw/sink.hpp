// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "detent/math/vec.hpp"

namespace detent {

/// A colour in sRGB.
struct Colour {
  std::uint8_t red = 0;
  std::uint8_t green = 0;
  std::uint8_t blue = 0;

  [[nodiscard]] friend constexpr bool operator==(const Colour&, const Colour&) noexcept = default;
};

/// The target of drawings, a type of your own: it has line(a, b, colour) and, in 3D, triangle(a, b,
/// c, colour), for points `Vec<S, N>` of the world. `draw` calls only the first, `draw_solid` only
/// the second.
template <class Sink, class S, int N>
concept DrawSink = Scalar<S> && requires(Sink& sink, const Vec<S, N>& point, const Colour& colour) {
  sink.line(point, point, colour);
} &&(N == 2 || requires(Sink & sink, const Vec<S, N>& point, const Colour& colour) {
  sink.triangle(point, point, point, colour);
});

namespace detail {

/// 16, or the greatest number if that is less.
template <Scalar S>
[[nodiscard]] constexpr S default_reach() noexcept {
  if constexpr (is_fixed<S>) {
    return nearest_to<S>(Fixed<5, 0>(16));
  } else {
    return S(16);
  }
}

}  // namespace detail

/// The drawn part of a plane: a square around the point of the plane closest to `center`, from
/// -reach to reach on both axes; in 2D a line of that length.
template <Scalar S, int N>
struct DrawRegion {
  Vec<S, N> center{};
  S reach = detail::default_reach<S>();
};

template <Scalar S, int N>
DrawRegion(Vec<S, N>, S) -> DrawRegion<S, N>;

/// Colours that most people can distinguish, in order of use.
///
/// source: Okabe and Ito, Color Universal Design, 2008
inline constexpr std::array<Colour, 8> draw_palette = {
    Colour{0xe6, 0x9f, 0x00}, Colour{0x56, 0xb4, 0xe9}, Colour{0x00, 0x9e, 0x73},
    Colour{0xf0, 0xe4, 0x42}, Colour{0x00, 0x72, 0xb2}, Colour{0xd5, 0x5e, 0x00},
    Colour{0xcc, 0x79, 0xa7}, Colour{0xbb, 0xbb, 0xbb}};

/// Colour `i` of the palette, cyclically.
[[nodiscard]] constexpr Colour palette_colour(std::size_t i) noexcept {
  return draw_palette[i % draw_palette.size()];
}

}  // namespace detent
