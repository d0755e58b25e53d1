// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "detent/query/contact/contact.hpp"
#include "detent/query/kernel/length.hpp"
#include "detent/shape/aabb.hpp"

namespace detent::detail {

/// By how much b must move along axis i, up if `positive`, to leave a.
template <Scalar S, int N>
[[nodiscard]] constexpr auto push_of_boxes(const Aabb<S, N>& a, const Aabb<S, N>& b, int i,
                                           bool positive) noexcept {
  return positive ? a.max[i] - b.min[i] : b.max[i] - a.min[i];
}

/// Whether two boxes with the same axes share no point.
template <Scalar S, int N>
[[nodiscard]] constexpr bool boxes_are_apart(const Aabb<S, N>& a, const Aabb<S, N>& b) noexcept {
  for (int i = 0; i < N; ++i) {
    if (a.max[i] < b.min[i] || b.max[i] < a.min[i]) return true;
  }
  return false;
}

/// The contact of two boxes with the same axes whose faces overlap: its points are the corners of
/// the rectangle that both faces share, which `ContactBuilder` finds in the same order.
///
/// Corners of a face count counter-clockwise seen against the positive axis, from the lower ends of
/// both others; edge k leads from corner k to the next. A corner of the rectangle is one of the
/// incident face, a crossing of two edges, or one of the reference face.
template <Scalar S>
class BoxesContact {
 public:
  constexpr BoxesContact(const Aabb<S, 3>& a, const Aabb<S, 3>& b) noexcept : a_(a), b_(b) {
    for (int i = 0; i < 3; ++i) {
      for (const bool positive : {true, false}) {
        const auto push = push_of_boxes(a, b, i, positive);
        if (i == 0 && positive ? false : !(push < depth_)) continue;
        depth_ = push;
        axis_ = i;
        is_positive_ = positive;
      }
    }
  }

  /// Nothing if the boxes do not share a rectangle of some depth.
  [[nodiscard]] constexpr std::optional<Contact<S, 3>> find() const noexcept {
    if (!(depth_ > 0)) return std::nullopt;
    for (int i = 0; i < 3; ++i) {
      if (i != axis_ && !(low_end(i) < high_end(i))) return std::nullopt;
    }
    std::array<Found, 4> found;
    std::size_t first = 0;
    for (std::size_t k = 0; k < 4; ++k) {
      found[k] = find_corner(k);
      if (found[k].rank < found[first].rank) first = k;
    }
    Contact<S, 3> contact;
    const auto along = Direction<S, 3>::along(axis_);
    contact.normal = is_positive_ ? along : -along;
    contact.depth = floor_to<S>(depth_);
    contact.count = 4;
    // The first, the one farthest from it, and those on the left and on the right.
    const std::array order{first, (first + 2) % 4, (first + 3) % 4, (first + 1) % 4};
    for (std::size_t k = 0; k < 4; ++k) {
      contact.points[k] = {point_of(order[k]), contact.depth, found[order[k]].feature};
    }
    return contact;
  }

 private:
  struct Found {
    std::uint32_t feature = 0;
    int rank = 0;
  };

  [[nodiscard]] constexpr const Aabb<S, 3>& reference() const noexcept {
    return is_positive_ ? a_ : b_;
  }
  [[nodiscard]] constexpr const Aabb<S, 3>& incident() const noexcept {
    return is_positive_ ? b_ : a_;
  }
  [[nodiscard]] constexpr S low_end(int i) const noexcept {
    return (std::max)(a_.min[i], b_.min[i]);
  }
  [[nodiscard]] constexpr S high_end(int i) const noexcept {
    return (std::min)(a_.max[i], b_.max[i]);
  }
  /// Whether corner k of a face is at the upper end of the first and of the second other axis.
  [[nodiscard]] static constexpr bool is_upper(std::size_t k, int side) noexcept {
    return side == 0 ? k == 1 || k == 2 : k >= 2;
  }
  [[nodiscard]] constexpr int side_axis(int side) const noexcept { return (axis_ + 1 + side) % 3; }

  /// The number in the box of a corner of its face; `is_upper_face` is on which end.
  [[nodiscard]] constexpr std::uint32_t number(const Aabb<S, 3>& box, std::size_t k,
                                               bool is_upper_face) const noexcept {
    std::uint32_t sides = 0;
    if (is_upper_face && box.min[axis_] < box.max[axis_]) sides |= 1u << axis_;
    for (int side = 0; side < 2; ++side) {
      if (is_upper(k, side)) sides |= 1u << side_axis(side);
    }
    return sides;
  }
  [[nodiscard]] constexpr std::uint32_t edge(const Aabb<S, 3>& box, std::size_t k, std::size_t l,
                                             bool is_upper_face) const noexcept {
    const auto p = number(box, k, is_upper_face), q = number(box, l, is_upper_face);
    return p < q ? p | q << 8 : q | p << 8;
  }

  [[nodiscard]] constexpr Found find_corner(std::size_t k) const noexcept {
    constexpr std::uint32_t face = 0xffff;
    // Where the rectangle ends, on each axis: with the incident face, with the reference, or both.
    std::array<bool, 2> is_incident{}, is_reference{};
    for (int side = 0; side < 2; ++side) {
      const int i = side_axis(side);
      const bool upper = is_upper(k, side);
      const auto& end = upper ? incident().max[i] : incident().min[i];
      const auto& other = upper ? reference().max[i] : reference().min[i];
      const auto s = static_cast<std::size_t>(side);
      is_incident[s] = upper ? end <= other : end >= other;
      is_reference[s] = upper ? other <= end : other >= end;
    }
    const auto of_incident = [&](std::size_t from, std::size_t to) {
      return edge(incident(), from, to, false);
    };
    const auto of_reference = [&](std::size_t from, std::size_t to) {
      return edge(reference(), from, to, true);
    };
    const auto both = [&](std::uint32_t of_reference_face, std::uint32_t of_incident_face) {
      return is_positive_ ? of_reference_face | of_incident_face << 16
                          : of_incident_face | of_reference_face << 16;
    };
    const int rank = static_cast<int>(k);
    if (is_incident[0] && is_incident[1]) return {both(face, of_incident(k, k)), rank};
    if (is_reference[0] && is_reference[1]) return {both(of_reference(k, k), face), 32 + rank};
    // Edges 1 and 3 are at the ends of the first axis, 0 and 2 at those of the second.
    const std::size_t first_end = is_upper(k, 0) ? 1 : 3, second_end = is_upper(k, 1) ? 2 : 0;
    const std::size_t incident_edge = is_incident[0] ? first_end : second_end;
    const std::size_t reference_edge = is_incident[0] ? second_end : first_end;
    return {both(of_reference(reference_edge, (reference_edge + 1) % 4),
                 of_incident(incident_edge, (incident_edge + 1) % 4)),
            8 + static_cast<int>(4 * incident_edge + reference_edge)};
  }
  [[nodiscard]] constexpr Vec<S, 3> point_of(std::size_t k) const noexcept {
    Vec<S, 3> point;
    point[axis_] = is_positive_ ? a_.max[axis_] : a_.min[axis_];
    for (int side = 0; side < 2; ++side) {
      const int i = side_axis(side);
      point[i] = is_upper(k, side) ? high_end(i) : low_end(i);
    }
    return point;
  }

  const Aabb<S, 3>& a_;
  const Aabb<S, 3>& b_;
  decltype(S() - S()) depth_{};
  int axis_ = 0;
  bool is_positive_ = true;
};

}  // namespace detent::detail
