// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "detent/dynamics/local.hpp"
#include "detent/dynamics/manifold/facet.hpp"
#include "detent/dynamics/manifold/pair.hpp"
#include "detent/dynamics/pairs.hpp"

namespace detent::detail {

/// A triangle of a surface near a body, and its manifold, in the frame of the surface.
template <Scalar S>
struct FacetContact {
  MeshTriangle<S> part{};
  Vec<typename Formats<S>::Ratio, 3> normal{};  // of the triangle
  Manifold<S, 3> manifold{};
  bool is_right = false;
  bool is_passed_on = false;  // a contact of the last tick, continued by another triangle
};

/// The height difference up to which two corners count as equally high: 2^4 steps of a lever.
template <Scalar S>
[[nodiscard]] constexpr auto level() noexcept {
  if constexpr (is_fixed<S>) {
    return Formats<S>::Gap::assume_raw(1 << 4);
  } else {
    return S(1) / 262144;
  }
}

/// The contacts of the triangles of a surface with one body, in order of their indices, without
/// duplicates.
///
/// A contact along its triangle's own normal is valid. So is one over an edge or a corner at which
/// no other nearby triangle rises. If triangles rise there, the valid ones replace it; if none is
/// valid, the triangle touches along its own normal. So a body that moves over a plane of many
/// triangles meets only the plane's normal.
template <class List, Scalar S>
class FacetContacts {
 public:
  using F = Formats<S>;
  using Gap = typename F::Gap;
  using Lever = typename F::Lever;
  using Ratio = typename F::Ratio;

  constexpr FacetContacts(List& list, std::size_t room) noexcept : list_(list), room_(room) {}

  /// Finds the contacts of `solid`, whose body has the pose in the frame of the surface.
  template <class Body, class Solid>
  constexpr void find(const Body& body, const Solid& solid, const RelativePose<S, 3>& pose,
                      const BodyExtent<S, 3>& reach, const S& margin, const Gap& gap) {
    list_.clear();
    if (body.asset == nullptr) return;
    if constexpr (Round<Solid>) {
      const auto core = placed_core(pose, round_core(solid));
      if (core.is_empty()) return;
      find_by(body, pose, reach, margin, [&](const Facet<S>& facet, bool on_top) {
        return facet_manifold(facet, core, on_top, gap);
      });
    } else {
      with_faces(solid, [&](const Polytope<S, 3>& shape) {
        find_by(body, pose, reach, margin, [&](const Facet<S>& facet, bool on_top) {
          return facet_manifold(facet, shape, pose, on_top, gap);
        });
      });
    }
  }

  /// The predecessor of contact `i` in the last tick, among the contacts from `first` to `end`,
  /// those of these bodies; `end` if there is none. If its own triangle had no contact, it
  /// continues the first contact of another triangle that has the same normal, is nearby but no
  /// longer touches, and is not continued by an earlier contact.
  template <class Contacts>
  constexpr std::size_t last_of(std::size_t i, const Contacts& before, std::size_t first,
                                std::size_t end) noexcept {
    for (std::size_t k = first; k < end; ++k) {
      if (before[k].part == list_[i].part.index) return k;
    }
    for (std::size_t k = first; k < end; ++k) {
      for (std::size_t j = 0; j < list_.size(); ++j) {
        auto& other = list_[j];
        if (other.part.index != before[k].part || other.manifold.count != 0 || other.is_passed_on ||
            !(other.normal == list_[i].manifold.normal)) {
          continue;
        }
        other.is_passed_on = true;
        return k;
      }
    }
    return end;
  }

 private:
  template <class Body, class Meet>
  constexpr void find_by(const Body& body, const RelativePose<S, 3>& pose,
                         const BodyExtent<S, 3>& reach, const S& margin, const Meet& meet) {
    const auto bounds =
        bounds_of<S, 3>(nearest_to<typename F::Place>(pose.translation), pose.axes, reach, margin);
    const Aabb<S, 3> box{
        make_vec<3>([&](int i) { return saturate_to<S>(floor_to<S>(bounds.least[i])); }),
        make_vec<3>([&](int i) { return saturate_to<S>(ceil_to<S>(bounds.most[i])); })};
    visit_within(surface_of(body), box, [&](std::span<const MeshTriangle<S>> parts) {
      for (const auto& part : parts) {
        if (part.index >= Body::part_limit || list_.size() == room_) continue;
        if (!overlaps(bounding_box(part), box)) continue;
        const auto facet = facet_of(part.triangle);
        if (!facet) continue;
        const auto top = facet->top();
        if (!is_solid_below<Body> && top.height(top.faces[0], pose.translation) < 0) continue;
        FacetContact<S> found;
        found.part = part;
        found.normal = facet->normal();
        found.manifold = meet(*facet, false);
        list_.push_back(found);
      }
      return Walk::go_on;
    });
    sort();
    for (std::size_t i = 0; i < list_.size(); ++i) {
      list_[i].is_right = list_[i].manifold.count != 0 && is_right(i);
    }
    for (std::size_t i = 0; i < list_.size(); ++i) {
      auto& contact = list_[i];
      if (contact.manifold.count == 0 || contact.is_right) continue;
      bool gives_way = false;
      visit_risers(i, [&](std::size_t j) { gives_way = gives_way || list_[j].is_right; });
      contact.manifold =
          gives_way ? Manifold<S, 3>() : meet(*facet_of(contact.part.triangle), true);
    }
    for (std::size_t i = 1; i < list_.size(); ++i) {
      bool again = false;
      for (std::size_t j = 0; j < i; ++j) {
        again = again || is_same(list_[j].manifold, list_[i].manifold);
      }
      if (again) list_[i].manifold.count = 0;
    }
  }

  /// By index. Of triangles with equal indices only the first by their corners remains.
  constexpr void sort() {
    if (list_.size() == 0) return;
    const auto corners = [](const MeshTriangle<S>& part) {
      const auto& [a, b, c] = part.triangle;
      return std::array{a.x, a.y, a.z, b.x, b.y, b.z, c.x, c.y, c.z};
    };
    std::sort(&list_[0], &list_[0] + list_.size(), [&](const auto& p, const auto& q) {
      if (p.part.index != q.part.index) return p.part.index < q.part.index;
      const auto first = corners(p.part), second = corners(q.part);
      return std::lexicographical_compare(first.begin(), first.end(), second.begin(), second.end());
    });
    std::size_t kept = 1;
    for (std::size_t i = 1; i < list_.size(); ++i) {
      if (list_[i].part.index != list_[kept - 1].part.index) list_[kept++] = list_[i];
    }
    list_.resize(kept);
  }

  [[nodiscard]] constexpr bool is_right(std::size_t i) const noexcept {
    const auto& contact = list_[i];
    const auto& n = contact.manifold.normal;
    if (n == contact.normal) return true;
    const auto least = quotient_nearest<Ratio>(Ratio(-1), as_operand<Ratio>(1024));
    if (narrow_dot<62>(n, contact.normal) < least) return false;
    bool rises = false;
    visit_risers(i, [&](std::size_t) { rises = true; });
    return !rises;
  }

  /// Calls visit(j) for the other triangles that have all corners of triangle i that are highest
  /// along its contact's normal, and a corner that is higher.
  template <class Visit>
  constexpr void visit_risers(std::size_t i, const Visit& visit) const noexcept {
    const auto& n = list_[i].manifold.normal;
    const auto own = corners_of(list_[i].part);
    const auto height = [&](const Vec<S, 3>& p) {
      return Polytope<S, 3>::along(n, nearest_to<Lever>(p), nearest_to<Lever>(own[0]));
    };
    const std::array heights{height(own[0]), height(own[1]), height(own[2])};
    const auto highest = (max)((max)(heights[0], heights[1]), heights[2]);
    for (std::size_t j = 0; j < list_.size(); ++j) {
      if (j == i) continue;
      const auto others = corners_of(list_[j].part);
      bool joins = true, rises = false;
      for (std::size_t k = 0; k < 3; ++k) {
        joins = joins && (highest - heights[k] > level<S>() ||
                          std::find(others.begin(), others.end(), own[k]) != others.end());
        rises = rises || height(others[k]) > highest;
      }
      if (joins && rises) visit(j);
    }
  }
  [[nodiscard]] static constexpr std::array<Vec<S, 3>, 3> corners_of(
      const MeshTriangle<S>& part) noexcept {
    return {part.triangle.a, part.triangle.b, part.triangle.c};
  }

  /// Whether both have one point, the same within the tolerance, and nearly the same normal.
  [[nodiscard]] static constexpr bool is_same(const Manifold<S, 3>& a,
                                              const Manifold<S, 3>& b) noexcept {
    if (a.count != 1 || b.count != 1) return false;
    const auto turn = quotient_nearest<Ratio>(Ratio(1), as_operand<Ratio>(64));
    for (int k = 0; k < 3; ++k) {
      if (abs(a.points[0].point[k] - b.points[0].point[k]) > ContactFormats<S>::tolerance) {
        return false;
      }
      if (abs(a.normal[k] - b.normal[k]) > turn) return false;
    }
    return true;
  }

  List& list_;
  std::size_t room_;
};

}  // namespace detent::detail
