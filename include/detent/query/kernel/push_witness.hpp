// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>

#include "detent/math/width.hpp"
#include "detent/number/filter/filtered.hpp"
#include "detent/number/filter/leading.hpp"
#include "detent/number/root.hpp"
#include "detent/query/kernel/convex_body.hpp"
#include "detent/query/kernel/expansion.hpp"
#include "detent/query/kernel/side_filter.hpp"
#include "detent/query/kernel/simplex.hpp"
#include "detent/query/kernel/vec_list.hpp"

// The least push of two polytopes by a witness: a polytope that encloses the origin, expanded from
// rounded corners, and the one facet near the origin, which is checked exactly. So a search in words
// replaces that of `Expansion` in longer numbers (docs/filters.md, lemma 26).

namespace detent::detail {

/// Up to 32 corners of a body, relative to a point and rounded.
class RoundedCorners {
 public:
  static constexpr std::size_t capacity = 32;
  using Component = Fixed<22, 0>;

  /// The corners, times 2^-dropped, rounded down.
  template <Number T, class Corners, Number From>
  constexpr void set(const T& /*holds their coordinates*/, const Corners& corners,
                     const Vec<From, 3>& from, int dropped) noexcept {
    count_ = corners.size();
    for (std::size_t k = 0; k < count_; ++k) {
      rounded_.set(
          k, make_vec<3>([&](int i) {
            const auto raw = T(corners[k][i] - from[i]).raw();
            return Component::assume_raw(integer_cast<Component::raw_type>(
                dropped < 0 ? shift_left(raw, -dropped) : shift_right_floor(raw, dropped)));
          }));
    }
  }

  [[nodiscard]] constexpr std::size_t size() const noexcept { return count_; }
  [[nodiscard]] constexpr Vec<Component, 3> operator[](std::size_t k) const noexcept {
    return rounded_[k];
  }

 private:
  VecList<Component, 3, capacity> rounded_;
  std::size_t count_ = 0;
};

/// The corners of `a` that are farthest along a normal, and those of `b` that are least far: bit k is
/// set for corner k.
struct LevelCorners {
  std::uint32_t a = 0, b = 0;
};

/// The least push of `b` out of `a`, or a proof that they are apart. `T` holds the components of
/// differences of their points.
template <Number T, class A, class B>
class PushWitness {
 public:
  using Corner = Vec<T, 3>;
  using Normal = decltype(facet_normal(Simplex<T, 3>()));
  using Height = decltype(dot(Normal(), Corner()));

  constexpr PushWitness(const A& a, const B& b) noexcept
      : corners_a_(a.corners()), corners_b_(b.corners()) {}

  enum class Outcome : std::uint8_t { unsure, apart, found };

  /// Sets `push` if found; its height is positive. `low` and `high` are the bounds of the
  /// differences a - b.
  template <Number L>
  [[nodiscard]] constexpr Outcome find(const Vec<L, 3>& low, const Vec<L, 3>& high) noexcept {
    const auto& corners_a = corners_a_;
    const auto& corners_b = corners_b_;
    if (corners_a.size() > RoundedCorners::capacity || corners_b.size() > RoundedCorners::capacity)
      return Outcome::unsure;
    const int length = (std::max)(longest_bits(low), longest_bits(high));
    if (length == 0) return Outcome::unsure;
    dropped_ = length - length_bits;
    const auto& from = corners_b[0];
    rough_a_.set(L(), corners_a, from, dropped_);
    rough_b_.set(L(), corners_b, from, dropped_);
    const auto middle = make_vec<3>([&](int i) {
      const auto sum = (low[i] + high[i]).raw();
      return Place::assume_raw(integer_cast<Place::raw_type>(
          dropped_ < -1 ? shift_left(sum, -dropped_ - 1) : shift_right_floor(sum, dropped_ + 1)));
    });
    const auto started = start(middle);
    if (started != Outcome::found) return started;
    for (;;) {
      const std::size_t i = next();
      if (i == facet_count_) return Outcome::found;
      const auto normal = normal_of(i);
      const auto pair = farthest(normal);
      const auto place = place_of(pair);
      const auto reach = narrow_dot<63>(normal, place);
      if (is_apart(normal, reach)) return Outcome::apart;
      if (!(reach.raw() > facets_[i].height)) {
        if (final_ || !certify(i)) return Outcome::unsure;
        final_ = true;
      } else if (!add(pair, place)) {
        return Outcome::unsure;
      }
    }
  }

  [[nodiscard]] constexpr const Push<Normal, Height>& push() const noexcept { return push_; }
  [[nodiscard]] constexpr const LevelCorners& level() const noexcept { return level_; }

 private:
  static constexpr int length_bits = 19;
  static constexpr std::size_t most_corners = 28, most_facets = 2 * most_corners - 4;
  using Place = Fixed<21, 0>;
  using Way = Fixed<43, 0>;
  using Word = Fixed<63, 0>;
  using Raw = Word::raw_type;
  using Index = std::uint8_t;
  /// Of steps of the rounded corners.
  static constexpr int key_bits = 32;
  static constexpr Raw margin = Raw{4} << key_bits;
  /// Of a key, in which the search keeps the number of a facet.
  static constexpr Raw last_bits = 63;
  static_assert(most_facets <= last_bits);

  struct Pair {
    Index a = 0, b = 0;
  };
  /// Trivial, so that an array of them is not set to 0.
  struct Facet {
    std::array<Raw, 3> normal;
    Raw height;
    Raw key;
    std::array<Index, 3> corners;
  };

  template <Number V>
  [[nodiscard]] constexpr Pair farthest(const Vec<V, 3>& v) const noexcept {
    return {extreme(rough_a_, v), extreme(rough_b_, narrow_negative(v))};
  }
  /// A corner that is farthest along v within `slack`. Its number replaces the last bits of how far it
  /// is, so that no branch depends on where the corners are.
  template <Number V>
  [[nodiscard]] static constexpr Index extreme(const RoundedCorners& corners,
                                               const Vec<V, 3>& v) noexcept {
    constexpr Raw last = RoundedCorners::capacity - 1;
    const auto numbered = [&](std::size_t k) {
      return (narrow_dot<63>(v, corners[k]).raw() & ~last) | static_cast<Raw>(k);
    };
    Raw best = numbered(0);
    for (std::size_t k = 1; k < corners.size(); ++k) best = (std::max)(best, numbered(k));
    return static_cast<Index>(best & last);
  }
  static constexpr auto slack = Word(2 * RoundedCorners::capacity);
  [[nodiscard]] constexpr Vec<Place, 3> place_of(const Pair& pair) const noexcept {
    return narrow<Place::bits>(rough_a_[pair.a] - rough_b_[pair.b]);
  }
  [[nodiscard]] static constexpr bool is_apart(const Vec<Way, 3>& v, const Word& reach) noexcept {
    const auto error = narrow_sum<45>(narrow_sum<44>(abs(v.x), abs(v.y)), abs(v.z));
    return !(narrow_sum<63>(reach, narrow_sum<46>(error, slack)) > 0);
  }

  [[nodiscard]] constexpr Vec<Way, 3> normal_of(std::size_t i) const noexcept {
    return make_vec<3>(
        [&](int k) { return Way::assume_raw(facets_[i].normal[static_cast<std::size_t>(k)]); });
  }

  /// Four corners that span the space, if possible about the origin.
  [[nodiscard]] constexpr Outcome start(const Vec<Place, 3>& middle) noexcept {
    auto along = make_vec<3>([&](int i) { return Way(narrow_negative(middle[i])); });
    if (is_zero(along)) along.x = Way(1);
    const auto first = farthest(along);
    const auto x = place_of(first);
    if (is_apart(along, narrow_dot<63>(along, x))) return Outcome::apart;
    // Across the way to the middle, from the corner towards it.
    const auto m = make_vec<3>([&](int i) { return narrow<21>(along[i]); });
    auto second_way = toward(m, x);
    if (is_zero(second_way)) second_way = across(m);
    auto second = farthest(second_way);
    if (place_of(second) == x) {
      second_way = narrow_negative(second_way);
      second = farthest(second_way);
    }
    const auto y = place_of(second);
    if (is_apart(second_way, narrow_dot<63>(second_way, y))) return Outcome::apart;
    const auto line = narrow<21>(y - x);
    if (is_zero(line)) return Outcome::unsure;
    auto third_way = toward(line, x);
    if (is_zero(third_way)) third_way = across(line);
    auto third = farthest(third_way);
    auto z = place_of(third);
    if (is_apart(third_way, narrow_dot<63>(third_way, z))) return Outcome::apart;
    auto normal = narrow_cross<43>(line, narrow<21>(z - x));
    if (is_zero(normal)) {
      third = farthest(narrow_negative(third_way));
      z = place_of(third);
      normal = narrow_cross<43>(line, narrow<21>(z - x));
      if (is_zero(normal)) return Outcome::unsure;
    }
    auto height = narrow_dot<63>(normal, x);
    if (height > 0) {
      normal = narrow_negative(normal);
      height = narrow_negative(height);
    }
    auto fourth = farthest(normal);
    auto w = place_of(fourth);
    auto reach = narrow_dot<63>(normal, w);
    if (is_apart(normal, reach)) return Outcome::apart;
    if (reach == height) {
      normal = narrow_negative(normal);
      height = narrow_negative(height);
      fourth = farthest(normal);
      w = place_of(fourth);
      reach = narrow_dot<63>(normal, w);
      if (reach == height) return Outcome::unsure;
    }
    // The fourth is beyond the normal, so that of x, y, z outward is the opposite.
    const bool is_outward = narrow_dot<63>(narrow_cross<43>(line, narrow<21>(z - x)), w) <
                            narrow_dot<63>(narrow_cross<43>(line, narrow<21>(z - x)), x);
    push_corner(is_outward ? first : second, is_outward ? x : y);
    push_corner(is_outward ? second : first, is_outward ? y : x);
    push_corner(third, z);
    push_corner(fourth, w);
    add_facet(0, 1, 2);
    add_facet(0, 3, 1);
    add_facet(1, 3, 2);
    add_facet(2, 3, 0);
    return Outcome::found;
  }
  /// The direction across `line`, from x towards the origin.
  [[nodiscard]] static constexpr Vec<Way, 3> toward(const Vec<Fixed<21, 0>, 3>& line,
                                                    const Vec<Place, 3>& x) noexcept {
    const auto normal = narrow_cross<43>(line, x);
    const auto short_normal = make_vec<3>([&](int i) {
      using Short = Fixed<31, 0>;
      return Short::assume_raw(static_cast<Short::raw_type>(normal[i].raw() >> 12));
    });
    const auto v = cross(line, short_normal);
    return make_vec<3>(
        [&](int i) { return Way::assume_raw(static_cast<Way::raw_type>(v[i].raw() >> 11)); });
  }
  [[nodiscard]] static constexpr Vec<Way, 3> across(const Vec<Fixed<21, 0>, 3>& line) noexcept {
    Vec<Fixed<21, 0>, 3> unit{};
    int least = 0;
    for (int i = 1; i < 3; ++i) {
      if (abs(line[i]) < abs(line[least])) least = i;
    }
    unit[least] = Fixed<21, 0>(1);
    return narrow_cross<43>(line, unit);
  }

  constexpr void push_corner(const Pair& pair, const Vec<Place, 3>& place) noexcept {
    pairs_[corner_count_] = pair;
    outgoing_[corner_count_] = 0;
    places_.set(corner_count_++, place);
  }

  constexpr void add_facet(std::size_t i, std::size_t j, std::size_t k) noexcept {
    const auto x = places_[i];
    const auto n = narrow_cross<43>(narrow<21>(places_[j] - x), narrow<21>(places_[k] - x));
    auto& facet = facets_[facet_count_++];
    facet.normal = {n.x.raw(), n.y.raw(), n.z.raw()};
    facet.height = narrow_dot<63>(n, x).raw();
    facet.key = key_of(n, facet.height);
    facet.corners = {static_cast<Index>(i), static_cast<Index>(j), static_cast<Index>(k)};
  }
  /// The distance of a plane from the origin, in steps of 2^-key_bits. It may be too small, but not too
  /// large by more than 2^-44 of it.
  [[nodiscard]] static constexpr Raw key_of(const Vec<Way, 3>& n, Raw height) noexcept {
    auto square = leading_word(squared_length(n).raw());
    square.word >>= square.exponent & 1;
    const int half = (square.exponent + 1) >> 1;
    const bool is_negative = height < 0;
    const auto whole = static_cast<std::uint64_t>(is_negative ? -height : height);
    const std::uint64_t high = multiply_words(whole, reciprocal_root(square.word)).high;
    const int scale = key_bits - 30 - half;
    const auto key = static_cast<Raw>(scale < 0 ? high >> -scale : high << scale);
    return is_negative ? -key : key;
  }

  /// The facet to examine, or `facet_count_` if all but those in the plane of the final one are
  /// farther than it.
  [[nodiscard]] constexpr std::size_t next() const noexcept {
    if (!final_) {
      // As in `extreme`.
      Raw best = facets_[0].key & ~last_bits;
      for (std::size_t i = 1; i < facet_count_; ++i) {
        best = (std::min)(best, (facets_[i].key & ~last_bits) | static_cast<Raw>(i));
      }
      return static_cast<std::size_t>(best & last_bits);
    }
    for (std::size_t i = 0; i < facet_count_; ++i) {
      if (facets_[i].key < limit_ && !is_in_plane(facets_[i])) return i;
    }
    return facet_count_;
  }
  [[nodiscard]] constexpr bool is_in_plane(const Facet& facet) const noexcept {
    bool all = true;
    for (const auto k : facet.corners) {
      const auto& pair = pairs_[k];
      all = all && (level_.a >> pair.a & level_.b >> pair.b & 1) != 0;
    }
    return all;
  }

  /// Whether no difference is beyond the exact plane of facet i; its height is positive.
  [[nodiscard]] constexpr bool certify(std::size_t i) noexcept {
    // Up to the last bits this key is the least: beyond them, all keys are positive.
    if (!(facets_[i].key > last_bits)) return false;
    constexpr int bits = bits_of<T>;
    const auto& corners_a = corners_a_;
    const auto& corners_b = corners_b_;
    const auto corner = [&](std::size_t k) {
      const auto& pair = pairs_[facets_[i].corners[k]];
      return narrow<bits>(corners_a[pair.a] - corners_b[pair.b]);
    };
    const auto x = corner(0);
    push_.normal = facet_normal(simplex_of(x, corner(1), corner(2)));
    push_.height = dot(push_.normal, x);
    if (!(push_.height > 0)) return false;
    const auto& pair = pairs_[facets_[i].corners[0]];
    const SideFilter side(push_.normal);
    const auto level = [&](const auto& corners, std::size_t at, bool is_a, std::uint32_t& mask) {
      for (std::size_t k = 0; k < corners.size(); ++k) {
        const int along = k == at ? 0 : side.sign(narrow<bits + 1>(corners[k] - corners[at]));
        if (is_a ? along > 0 : along < 0) return false;
        mask |= std::uint32_t{along == 0} << k;
      }
      return true;
    };
    if (!level(corners_a, pair.a, true, level_.a)) return false;
    if (!level(corners_b, pair.b, false, level_.b)) return false;
    // The exact distance, rounded up.
    const auto distance = over_root(
        Leading(as_integer(push_.height)),
        squared_leading(to_array(make_vec<3>([&](int k) { return as_integer(push_.normal[k]); }))));
    const int scale = distance.exponent + key_bits - dropped_;
    if (scale > -10 || scale < -63) return false;
    const auto steps = static_cast<Raw>(distance.word >> -scale);
    limit_ = steps + margin;
    return steps > margin;
  }
  template <Number X>
  [[nodiscard]] static constexpr auto as_integer(const X& x) noexcept {
    return Fixed<bits_of<X>, 0>::assume_raw(x.raw());
  }

  /// Adds a corner beyond some facet; false if there is no room.
  constexpr bool add(const Pair& pair, const Vec<Place, 3>& place) noexcept {
    if (corner_count_ == most_corners) return false;
    const auto added = corner_count_;
    push_corner(pair, place);
    std::uint64_t seen = 0;
    for (std::size_t i = 0; i < facet_count_; ++i) {
      const bool is_seen = narrow_dot<63>(normal_of(i), place).raw() > facets_[i].height;
      seen |= std::uint64_t{is_seen} << i;
    }
    std::uint32_t rim = 0;
    while (seen != 0) {
      const auto i = static_cast<std::size_t>(std::bit_width(seen)) - 1;
      seen ^= std::uint64_t{1} << i;
      const auto& c = facets_[i].corners;
      for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t from = c[k], to = c[k == 2 ? 0 : k + 1];
        const std::uint32_t is_back = outgoing_[to] >> from & 1;
        outgoing_[to] ^= is_back << from;
        outgoing_[from] |= (is_back ^ 1) << to;
        rim |= std::uint32_t{1} << from;
      }
      facets_[i] = facets_[--facet_count_];
    }
    for (; rim != 0; rim &= rim - 1) {
      const auto from = static_cast<std::size_t>(std::countr_zero(rim));
      const std::uint32_t to = outgoing_[from];
      if (to == 0) continue;
      outgoing_[from] = 0;
      if (facet_count_ == most_facets) return false;
      add_facet(from, static_cast<std::size_t>(std::countr_zero(to)), added);
    }
    return true;
  }

  std::remove_cvref_t<decltype(std::declval<const A&>().corners())> corners_a_;
  std::remove_cvref_t<decltype(std::declval<const B&>().corners())> corners_b_;
  int dropped_ = 0;
  RoundedCorners rough_a_, rough_b_;
  std::array<Pair, most_corners> pairs_;
  VecList<Place, 3, most_corners> places_;
  std::array<std::uint32_t, most_corners> outgoing_;  // per corner: the ends of edges of the rim
  std::array<Facet, most_facets> facets_;
  std::size_t corner_count_ = 0, facet_count_ = 0;
  bool final_ = false;
  LevelCorners level_;
  Raw limit_ = 0;
  Push<Normal, Height> push_;
};

/// Whether to search the least push of two bodies by such a witness.
template <class S, class A, class B>
inline constexpr bool has_push_witness =
    is_fixed<S>&& filter_pays<S>&& A::dimension == 3 && !(IsBoxBody<A> && IsBoxBody<B>);

}  // namespace detent::detail
