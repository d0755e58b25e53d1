// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>

#include "detent/cull/list.hpp"
#include "detent/number/assert.hpp"
#include "detent/scene/found.hpp"

namespace detent {

/// Which pairs of objects began, stayed and ended overlapping from one frame to the next. Write
/// `OverlapEvents`, or `BoundedOverlapEvents<64>` for one that never allocates.
///
///     const auto pairs = scene.overlaps(filter);  // after objects have moved
///     events.update(pairs);
///     for (const Overlap& pair : events.began()) ...
///
/// The events depend only on the pairs of two frames. A world that rolls back keeps its events next
/// to its scene, as a field (see `RollbackWorld`); or it keeps none and recomputes them by two
/// updates, with the pairs of the scenes before and after a frame.
///
/// result: each list sorted by first id, then by second. A pair ends when one of its objects is
///         removed, or filtered out: `ended` may hold ids that the scene no longer has. An object
///         added at a removed one's index has a new id, so its pairs begin
///         (tests/scene/events.test.cpp)
template <class Storage, std::size_t Pairs>
class BasicOverlapEvents {
 public:
  /// Advances by one frame, to the overlapping pairs that `scene.overlaps` gives: sorted, each
  /// once.
  ///
  /// domain: if there is no room for all pairs, the first are kept
  /// result: whether all were kept
  constexpr bool update(std::span<const Overlap> pairs) {
    DETENT_ASSERT(std::is_sorted(pairs.begin(), pairs.end()));
    const bool fits = pairs.size() <= Pairs;
    if (!fits) pairs = pairs.first(Pairs);
    for (auto* list : {&began_, &stayed_, &ended_}) list->clear();
    // Both lists are sorted, so the lesser of their next pairs is in only one of them.
    std::size_t i = 0, k = 0;
    while (i < now_.size() || k < pairs.size()) {
      if (k == pairs.size() || (i < now_.size() && now_[i] < pairs[k])) {
        ended_.push_back(now_[i++]);
      } else if (i == now_.size() || pairs[k] < now_[i]) {
        began_.push_back(pairs[k++]);
      } else {
        stayed_.push_back(pairs[k++]);
        ++i;
      }
    }
    now_.clear();
    for (const auto& pair : pairs) now_.push_back(pair);
    return fits;
  }

  /// The pairs that overlap in this frame and did not in the previous one.
  [[nodiscard]] constexpr std::span<const Overlap> began() const noexcept { return view(began_); }
  /// The pairs that overlap in both.
  [[nodiscard]] constexpr std::span<const Overlap> stayed() const noexcept { return view(stayed_); }
  /// The pairs that overlapped in the previous frame and no longer do.
  [[nodiscard]] constexpr std::span<const Overlap> ended() const noexcept { return view(ended_); }
  /// The pairs that overlap in this frame: those that began and those that stayed.
  [[nodiscard]] constexpr std::span<const Overlap> now() const noexcept { return view(now_); }

  /// Whether the lists are equal.
  [[nodiscard]] friend constexpr bool operator==(const BasicOverlapEvents& a,
                                                 const BasicOverlapEvents& b) noexcept {
    return same(a.began(), b.began()) && same(a.stayed(), b.stayed()) && same(a.ended(), b.ended());
  }

 private:
  using List = typename Storage::template List<Overlap, Pairs>;

  [[nodiscard]] static constexpr std::span<const Overlap> view(const List& list) noexcept {
    return {list.data(), list.size()};
  }

  // Not std::ranges::equal, which libc++ 14 lacks.
  [[nodiscard]] static constexpr bool same(std::span<const Overlap> a,
                                           std::span<const Overlap> b) noexcept {
    return std::equal(a.begin(), a.end(), b.begin(), b.end());
  }

  List now_, began_, stayed_, ended_;
};

/// The events as fields of a world.
template <class Storage, std::size_t Pairs, class F>
constexpr void for_each_field(const BasicOverlapEvents<Storage, Pairs>& events, const F& f) {
  f("began", events.began());
  f("stayed", events.stayed());
  f("ended", events.ended());
}

#if __STDC_HOSTED__
/// Events of any number of pairs, on the heap.
using OverlapEvents = BasicOverlapEvents<Growing, static_cast<std::size_t>(-1)>;
#endif

/// Events of up to `Pairs` pairs a frame, stored inside the object.
template <std::size_t Pairs>
using BoundedOverlapEvents = BasicOverlapEvents<Bounded<Pairs>, Pairs>;

}  // namespace detent
