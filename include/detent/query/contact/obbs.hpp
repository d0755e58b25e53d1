// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "detent/math/components.hpp"
#include "detent/query/contact/contact.hpp"
#include "detent/query/contact/manifold.hpp"
#include "detent/query/kernel/axis_filter.hpp"
#include "detent/query/kernel/least_push.hpp"
#include "detent/shape/obb.hpp"

namespace detent::detail {

/// The contact of two oriented boxes if the cosines between their axes leave one axis for the least
/// push and decide where faces cross, seen along it (docs/filters.md, lemma 35). All numbers of the
/// contact are exact: `ContactBuilder` finds the same points from any features.
///
/// The corners of a face are a ring, from the lower ends of both of its axes to the upper end of the
/// first; edge k leads from corner k to the next.
template <Scalar S>
class ObbsContact {
 public:
  constexpr ObbsContact(const Obb<S, 3>& a, const Obb<S, 3>& b,
                        const AxisFilter<S>& filter) noexcept
      : a_(a), b_(b), filter_(filter) {}

  /// Nothing if unsure.
  [[nodiscard]] constexpr std::optional<Contact<S, 3>> find() const noexcept {
    const auto axis = filter_.only_axis();
    if (!axis || filter_.sum() > most_sum || !is_thick(a_) || !is_thick(b_)) return std::nullopt;
    const int i = static_cast<int>(*axis);
    if (i >= 6) return find_edges((i - 6) / 3, i % 3);
    return i < 3 ? find_faces(true, 2 - i) : find_faces(false, 5 - i);
  }

 private:
  using Filter = AxisFilter<S>;
  using Builder = ContactBuilder<S, 3, 8>;
  using Face = typename Builder::Face;
  using Component = direction_component<S>;
  using Exact = Fixed<62, S::frac + Component::frac>;
  using Along = Fixed<62, 2 * Component::frac>;
  /// Coordinates in the plane of the reference, in half steps, and their products.
  using Flat = Fixed<31, 0>;
  using Area = Fixed<62, 0>;

  /// In half steps: two corners of boxes that touch are at most 2^28 steps apart.
  static constexpr auto most_sum = Fixed<32, 0>(1 << Filter::length_bits);
  /// Rounding the corners of thicker boxes does not turn their faces over.
  [[nodiscard]] static constexpr bool is_thick(const Obb<S, 3>& box) noexcept {
    constexpr auto least = S::from_raw(16);
    const auto& h = box.half_extents;
    return h.x >= least && h.y >= least && h.z >= least;
  }

  struct Normal {
    Vec<Along, 3> vec;  // leads from a to b
    int side = 0;       // of the cross product: 1 or -1 if it points there or back, 0 if neither
  };
  [[nodiscard]] constexpr Normal normal_across(const Direction<S, 3>& e,
                                               const Direction<S, 3>& f) const noexcept {
    const auto across = narrow_cross<Along::bits>(e.vec(), f.vec());
    const int side = filter_.side_of(across);
    return {side < 0 ? narrow_negative(across) : across, side};
  }
  /// A number for each axis; `Vec` would branch to select one at run time.
  template <Number T>
  using Each = std::array<T, 3>;
  template <Number T>
  [[nodiscard]] static constexpr const T& at(const Each<T>& each, int i) noexcept {
    return each[static_cast<std::size_t>(i)];
  }
  /// The products of a normal and the axes of a box, off by less than `least_along`.
  [[nodiscard]] static constexpr Each<Along> along(const Normal& normal,
                                                   const Obb<S, 3>& box) noexcept {
    const auto leading = make_vec<3>([&](int i) { return narrow_floor<Component>(normal.vec[i]); });
    return to_array(make_vec<3>(
        [&](int i) { return narrow_dot<Along::bits>(leading, box.rotation.axis(i).vec()); }));
  }
  static constexpr auto least_along = scale_up<Along::bits>(Along::from_raw(1), 32);

  /// From the middle of a box to an end of axis i.
  [[nodiscard]] static constexpr Vec<Exact, 3> edge(const Obb<S, 3>& box, int i,
                                                    bool is_upper) noexcept {
    const S half = with_sign(at(to_array(box.half_extents), i), !is_upper);
    const auto& axis = box.rotation.axis(i);
    return make_vec<3>([&](int k) { return narrow_product<Exact::bits>(half, axis[k]); });
  }
  [[nodiscard]] static constexpr Vec<Exact, 3> sum(const Vec<Exact, 3>& p,
                                                   const Vec<Exact, 3>& q) noexcept {
    return make_vec<3>([&](int k) { return narrow_sum<Exact::bits>(p[k], q[k]); });
  }
  [[nodiscard]] static constexpr Vec<Exact, 3> center(const Obb<S, 3>& box) noexcept {
    return make_vec<3>([&](int k) { return Exact(box.center[k]); });
  }

  /// The exact normal and depth, rounded, for a point of each box that is extreme along the normal.
  [[nodiscard]] static constexpr Contact<S, 3> push_of(const Normal& normal,
                                                       const Vec<Exact, 3>& on_a,
                                                       const Vec<Exact, 3>& on_b,
                                                       Length<S>& depth) noexcept {
    const auto height =
        dot(normal.vec,
            make_vec<3>([&](int k) { return narrow_difference<Exact::bits>(on_a[k], on_b[k]); }));
    const auto exact = depth_of_height<S>(S(0) + S(0), height, squared_length(normal.vec));
    depth = narrow<bits_of<Length<S>>>(exact);
    Contact<S, 3> contact;
    contact.normal = direction_of<S>(normal.vec).value_or(Direction<S, 3>());
    contact.depth = floor_to<S>(exact);
    return contact;
  }

  /// The least push across axis i of a and axis j of b.
  [[nodiscard]] constexpr std::optional<Contact<S, 3>> find_edges(int i, int j) const noexcept {
    const auto normal = normal_across(a_.rotation.axis(i), b_.rotation.axis(j));
    if (normal.side == 0) return std::nullopt;
    Face edge_a, edge_b;
    auto on_a = center(a_), on_b = center(b_);
    if (!find_edge(a_, i, along(normal, a_), true, on_a, edge_a) ||
        !find_edge(b_, j, along(normal, b_), false, on_b, edge_b))
      return std::nullopt;
    Length<S> depth;
    auto contact = push_of(normal, on_a, on_b, depth);
    Builder manifold(contact.normal, depth, S(0), S(0) + S(0));
    if (!manifold.meet_edges(edge_a, edge_b)) return std::nullopt;
    manifold.write(contact);
    return contact;
  }
  /// The edge along axis i that is extreme along a normal, and its middle; false if unsure.
  [[nodiscard]] static constexpr bool find_edge(const Obb<S, 3>& box, int i,
                                                const Each<Along>& along, bool farthest,
                                                Vec<Exact, 3>& middle, Face& face) noexcept {
    std::size_t sides = 0;
    for (const int k : {(i + 1) % 3, (i + 2) % 3}) {
      if (abs(at(along, k)) < least_along) return false;
      const bool is_upper = (at(along, k) > 0) == farthest;
      middle = sum(middle, edge(box, k, is_upper));
      sides |= std::size_t{is_upper} << k;
    }
    for (const bool is_upper : {false, true}) {
      face.set_next(nearest_to<Length<S>>(sum(middle, edge(box, i, is_upper))),
                    sides | std::size_t{is_upper} << i);
    }
    return true;
  }

  /// A face of a box: its corners in a ring.
  struct Ring {
    std::array<Corner<S, 3>, 4> corners;
    std::array<std::size_t, 4> numbers{};
  };
  [[nodiscard]] static constexpr bool is_upper_first(std::size_t k) noexcept {
    return k == 1 || k == 2;
  }
  [[nodiscard]] static constexpr bool is_upper_second(std::size_t k) noexcept { return k >= 2; }
  /// The face at an end of axis i with this middle.
  [[nodiscard]] static constexpr Ring ring_of(const Obb<S, 3>& box, int i, bool is_upper,
                                              const Vec<Exact, 3>& middle) noexcept {
    const int i1 = (i + 1) % 3, i2 = (i + 2) % 3;
    Ring ring;
    for (std::size_t k = 0; k < 4; ++k) {
      const bool upper1 = is_upper_first(k), upper2 = is_upper_second(k);
      ring.corners[k] =
          nearest_to<Length<S>>(sum(sum(middle, edge(box, i1, upper1)), edge(box, i2, upper2)));
      ring.numbers[k] =
          std::size_t{is_upper} << i | std::size_t{upper1} << i1 | std::size_t{upper2} << i2;
    }
    return ring;
  }
  /// Where the corners and edges of an outline are in a ring; an outline begins with its least corner
  /// and is counter-clockwise.
  struct Order {
    constexpr Order(const Ring& ring, bool clockwise) noexcept : is_reversed(clockwise) {
      for (std::size_t k = 1; k < 4; ++k) {
        if (is_before(ring.corners[k], ring.corners[first])) first = k;
      }
    }
    [[nodiscard]] constexpr std::size_t corner(std::size_t k) const noexcept {
      return (is_reversed ? first - k : first + k) % 4;
    }
    [[nodiscard]] constexpr std::size_t edge(std::size_t k) const noexcept {
      return corner(is_reversed ? k + 1 : k);
    }
    [[nodiscard]] constexpr Face outline(const Ring& ring) const noexcept {
      Face face;
      for (std::size_t k = 0; k < 4; ++k) {
        face.set_next(ring.corners[corner(k)], ring.numbers[corner(k)]);
      }
      return face;
    }

    std::size_t first = 0;
    bool is_reversed;
  };

  /// For each corner of a ring, the edges of the other ring that it is outside of, a bit each.
  using Outside = std::array<std::uint32_t, 4>;
  /// The same for a point at (u, v) and a ring with u in [-h1, h1] and v in [-h2, h2].
  template <Number T, Number Margin>
  [[nodiscard]] static constexpr std::uint32_t outside(const T& u, const T& v, const T& h1,
                                                       const T& h2, const Margin& margin,
                                                       bool& is_sure) noexcept {
    const auto beyond_u = abs(u) - h1, beyond_v = abs(v) - h2;
    const bool u_is_sure = abs(beyond_u) > margin, v_is_sure = abs(beyond_v) > margin;
    is_sure = is_sure & u_is_sure & v_is_sure;  // one branch, which is predictable
    return std::uint32_t{beyond_v > 0} << (v < 0 ? 0 : 2) | std::uint32_t{beyond_u > 0}
                                                                << (u < 0 ? 3 : 1);
  }

  /// Two faces, seen along the axis of the reference: by the corners of each, what they are outside
  /// of. The incident ring is clockwise where that of the reference is counter-clockwise if it is
  /// reversed.
  struct Crossing {
    Outside incident{}, reference{};
    bool is_reversed = false;
  };
  /// The reference is the face across axis i of its box, the incident one at an end of axis j of the
  /// other; nothing if unsure.
  [[nodiscard]] constexpr std::optional<Crossing> cross_faces(bool a_is_reference, int i, int j,
                                                              bool is_upper) const noexcept {
    const auto extents_of = [](const Obb<S, 3>& box) {
      return to_array(make_vec<3>(
          [&](int k) { return narrow<29>(as_steps(box.half_extents[k] + box.half_extents[k])); }));
    };
    const auto h = extents_of(a_is_reference ? a_ : b_), g = extents_of(a_is_reference ? b_ : a_);
    const int i1 = (i + 1) % 3, i2 = (i + 2) % 3, j1 = (j + 1) % 3, j2 = (j + 2) % 3;
    const auto part = [&](int k, int m) {
      const auto& cosine = a_is_reference ? at(filter_.cosines()[static_cast<std::size_t>(k)], m)
                                          : at(filter_.cosines()[static_cast<std::size_t>(m)], k);
      return narrow_floor<Flat>(at(g, m) * cosine);
    };
    const auto middle = [&](int k) {
      const Flat place(at(a_is_reference ? filter_.along_a() : filter_.along_b(), k));
      return narrow_sum<Flat::bits>(with_sign(place, !a_is_reference),
                                    with_sign(part(k, j), !is_upper));
    };
    const auto u = middle(i1), u1 = part(i1, j1), u2 = part(i1, j2);
    const auto v = middle(i2), v1 = part(i2, j1), v2 = part(i2, j2);
    const auto product = [](const Flat& x, const Flat& y) {
      return narrow_product<Area::bits>(x, y);
    };
    const auto determinant = [&](const Flat& x1, const Flat& y2, const Flat& y1, const Flat& x2) {
      return narrow_difference<Area::bits>(product(x1, y2), product(y1, x2));
    };
    const auto margin = narrow<31>(scale_down<31>(filter_.sum(), 22) + Flat(16));
    const auto area_margin = scale_up<Area::bits>(filter_.sum(), 5);
    Crossing crossing;
    const Area area = determinant(u1, v2, v1, u2);
    crossing.is_reversed = area < 0;
    const Area whole = crossing.is_reversed ? narrow_negative(area) : area;
    bool is_sure = whole > area_margin;
    const auto signed_by = [](bool positive, const auto& x) {
      return positive ? x : narrow_negative(x);
    };
    for (std::size_t k = 0; k < 4; ++k) {
      const bool first = is_upper_first(k), second = is_upper_second(k);
      const auto corner = [&](const Flat& x, const Flat& x1, const Flat& x2) {
        return narrow<31>(x + signed_by(first, x1) + signed_by(second, x2));
      };
      crossing.incident[k] = outside(corner(u, u1, u2), corner(v, v1, v2), Flat(at(h, i1)),
                                     Flat(at(h, i2)), margin, is_sure);
      const auto du = narrow<31>(signed_by(first, Flat(at(h, i1))) - u);
      const auto dv = narrow<31>(signed_by(second, Flat(at(h, i2))) - v);
      const Area x = determinant(du, v2, dv, u2), y = determinant(u1, dv, v1, du);
      crossing.reference[k] =
          outside(signed_by(!crossing.is_reversed, x), signed_by(!crossing.is_reversed, y), whole,
                  whole, area_margin, is_sure);
    }
    return is_sure ? std::optional(crossing) : std::nullopt;
  }
  template <Number T>
  [[nodiscard]] static constexpr auto as_steps(const T& x) noexcept {
    return Fixed<bits_of<T>, 0>::assume_raw(x.raw());
  }

  [[nodiscard]] static constexpr Overlay<8> overlay_of(const Crossing& crossing,
                                                       const Order& reference,
                                                       const Order& incident) noexcept {
    Overlay<8> overlay;
    // Per edge of the reference: the incident edges whose lines it crosses.
    std::array<std::uint32_t, 4> crossing_lines{};
    for (std::size_t i = 0; i < 4; ++i) {
      const auto outside = crossing.reference[reference.corner(i)];
      overlay.under |= std::uint32_t{outside == 0} << i;
      crossing_lines[i] = outside ^ crossing.reference[reference.corner(i + 1)];
    }
    for (std::size_t k = 0; k < 4; ++k) {
      const auto outside = crossing.incident[incident.corner(k)];
      overlay.over |= std::uint32_t{outside == 0} << k;
      const auto crossed_lines = outside ^ crossing.incident[incident.corner(k + 1)];
      for (std::size_t i = 0; i < 4; ++i) {
        overlay.crossed[k] |=
            (crossed_lines >> reference.edge(i) & crossing_lines[i] >> incident.edge(k) & 1) << i;
      }
    }
    return overlay;
  }

  /// The least push along axis i of the reference.
  [[nodiscard]] constexpr std::optional<Contact<S, 3>> find_faces(bool a_is_reference,
                                                                  int i) const noexcept {
    const auto& reference = a_is_reference ? a_ : b_;
    const auto& incident = a_is_reference ? b_ : a_;
    const auto normal =
        normal_across(reference.rotation.axis((i + 1) % 3), reference.rotation.axis((i + 2) % 3));
    if (normal.side == 0) return std::nullopt;
    const bool is_upper = (at(along(normal, reference), i) > 0) == a_is_reference;
    const auto on_reference = sum(center(reference), edge(reference, i, is_upper));
    const auto toward = along(normal, incident);
    const int j = longest_axis(from_array(toward));
    const int j1 = (j + 1) % 3, j2 = (j + 2) % 3;
    const auto length = [&](int k) { return abs(at(toward, k)); };
    const auto is_deepest = [&](int k) { return (at(toward, k) < 0) == a_is_reference; };
    constexpr auto least_gap = scale_up<Along::bits>(Along::from_raw(1), 36);
    if (length(j) - length(j1) < least_gap || length(j) - length(j2) < least_gap ||
        length(j1) < least_along || length(j2) < least_along)
      return std::nullopt;
    const auto crossing = cross_faces(a_is_reference, i, j, is_deepest(j));
    if (!crossing) return std::nullopt;
    const auto on_incident = sum(center(incident), edge(incident, j, is_deepest(j)));
    const auto deepest = sum(sum(on_incident, edge(incident, j1, is_deepest(j1))),
                             edge(incident, j2, is_deepest(j2)));
    Length<S> depth;
    auto contact = a_is_reference ? push_of(normal, on_reference, deepest, depth)
                                  : push_of(normal, deepest, on_reference, depth);
    Builder manifold(contact.normal, depth, S(0), S(0) + S(0));
    const auto ring = ring_of(reference, i, is_upper, on_reference);
    const auto incident_ring = ring_of(incident, j, is_deepest(j), on_incident);
    const bool is_clockwise = (normal.side > 0) != (manifold.seen() == contact.normal);
    const Order order(ring, is_clockwise);
    const Order incident_order(incident_ring, is_clockwise != crossing->is_reversed);
    if (!manifold.meet_faces(a_is_reference, order.outline(ring),
                             incident_order.outline(incident_ring), nearest_to<Length<S>>(deepest),
                             overlay_of(*crossing, order, incident_order)))
      return std::nullopt;
    manifold.write(contact);
    return contact;
  }

  const Obb<S, 3>& a_;
  const Obb<S, 3>& b_;
  const AxisFilter<S>& filter_;
};

}  // namespace detent::detail
