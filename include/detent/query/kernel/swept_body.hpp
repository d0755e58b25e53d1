// SPDX-License-Identifier: MIT
#pragma once

#include <type_traits>
#include <utility>

#include "detent/query/kernel/support.hpp"

namespace detent::detail {

/// A convex body for GJK: the volume swept by `body`, scaled by 2^shift, from the offset `start` to
/// the offset `end`. `shift` is at most `Shift`.
template <class Body, Number T, int Shift>
class SweptBody {
 public:
  static constexpr int dimension = Body::dimension;
  using Offset = Vec<T, dimension>;

  constexpr SweptBody(const Body& body, int shift, const Offset& start, const Offset& end) noexcept
      : body_(body), shift_(shift), start_(start), end_(end), way_(end - start) {}

  [[nodiscard]] constexpr auto some() const noexcept { return moved(body_.some(), start_); }
  [[nodiscard]] constexpr auto low() const noexcept {
    return moved(body_.low(),
                 make_vec<dimension>([this](int i) { return way_[i] < 0 ? end_[i] : start_[i]; }));
  }
  [[nodiscard]] constexpr auto high() const noexcept {
    return moved(body_.high(),
                 make_vec<dimension>([this](int i) { return way_[i] < 0 ? start_[i] : end_[i]; }));
  }

  template <int, Number V, class From>
  [[nodiscard]] constexpr auto extreme(const Vec<V, dimension>& v, const From&,
                                       bool farthest) const noexcept {
    constexpr int bits = bits_of<Component> + 1;
    const auto corner = body_.template extreme<bits>(v, body_.some(), farthest);
    return moved(corner, (dot(v, way_) > 0) == farthest ? end_ : start_);
  }

  template <int, Number V, class From, class F>
  constexpr void for_each_extreme(const Vec<V, dimension>& v, const From&, bool farthest,
                                  const F& f) const noexcept {
    constexpr int bits = bits_of<Component> + 1;
    const auto along = dot(v, way_);
    body_.template for_each_extreme<bits>(v, body_.some(), farthest, [&](const auto& corner) {
      if (along == 0 || (along < 0) == farthest) f(moved(corner, start_));
      if (along == 0 || (along > 0) == farthest) f(moved(corner, end_));
    });
  }

 private:
  using Component = std::remove_cvref_t<decltype(std::declval<const Body&>().some().x)>;

  template <class Point>
  [[nodiscard]] constexpr auto moved(const Point& point, const Offset& offset) const noexcept {
    return make_vec<dimension>(
        [&](int i) { return scale_up<bits_of<Component> + Shift>(point[i], shift_) + offset[i]; });
  }

  Body body_;
  int shift_;
  Offset start_, end_;
  decltype(Offset() - Offset()) way_;
};

}  // namespace detent::detail
