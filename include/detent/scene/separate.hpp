// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <type_traits>

#include "detent/cull/prefetch.hpp"
#include "detent/cull/search.hpp"
#include "detent/query/cast/pair.hpp"
#include "detent/query/raycast/hit.hpp"
#include "detent/scene/shape_tag.hpp"
#include "detent/shape/moved.hpp"
#include "detent/shape/segment.hpp"

// Functions that scenes call through separate, non-inline, non-constexpr symbols. Programs that
// link `detent::detent` take them from it, for the types that scene/instantiations.hpp lists;
// elsewhere they are ordinary templates.

namespace detent::detail {

/// A call of the stateless function object `Job`.
template <class Job, class Result, class... Args>
Result call_separate(Args&... args) noexcept(noexcept(Job()(args...))) {
  return Job()(args...);
}

/// `Job()(args...)`, also in constant expressions.
template <class Job, class... Args>
constexpr auto separately(Args&... args) noexcept(noexcept(Job()(args...)))
    -> decltype(Job()(args...)) {
  // Compilers do not compile the branch of the builtin that is never taken; with
  // std::is_constant_evaluated() GCC still processes half of it.
  if (__builtin_is_constant_evaluated()) return Job()(args...);
  return call_separate<Job, decltype(Job()(args...))>(args...);
}

/// A reference to a function object, so that a traversal is compiled once for all of them.
template <class Result, class... Args>
class FunctionRef {
 public:
  template <class F>
  explicit constexpr FunctionRef(const F& f) noexcept
      : object_(&f), call_([](const void* object, Args... args) -> Result {
          return (*static_cast<const F*>(object))(args...);
        }) {}
  Result operator()(Args... args) const { return call_(object_, args...); }

 private:
  const void* object_;
  Result (*call_)(const void*, Args...);
};
/// Visits objects and prefetches their records: those of a large scene are not in cache.
class ObjectVisitor : public FunctionRef<Walk, std::uint32_t> {
 public:
  template <class F, class Record>
  constexpr ObjectVisitor(const F& f, const Record* records) noexcept
      : FunctionRef(f), records_(records), size_(sizeof(Record)) {}

  constexpr void ahead([[maybe_unused]] std::uint32_t object) const noexcept {
    prefetch(static_cast<const char*>(records_) + object * size_, size_);
  }

 private:
  const void* records_;
  std::size_t size_;
};
using ObjectsVisitor = FunctionRef<Walk, std::span<const std::uint32_t>>;
using PairVisitor = FunctionRef<void, CandidatePairs>;

/// The distance that a moving shape travels before it touches a target. Specialised for targets
/// that are not a single convex shape.
template <class Target>
struct CastAt {
  template <class Moving>
  [[nodiscard]] static constexpr auto distance(const Cast<Moving>& moving,
                                               const Target& target) noexcept {
    return cast_distance(moving.shape, moving.direction, moving.max_distance, target);
  }
};

/// Function objects, in their own namespace because kernels use the same names.
namespace job {

struct Raycast {
  template <Scalar S, int N, class Shape>
  [[nodiscard]] constexpr std::optional<S> operator()(const Ray<S, N>& ray,
                                                      const Shape& shape) const noexcept {
    return raycast(ray, shape);
  }
};
struct RaycastHit {
  template <Scalar S, int N, class Shape>
  [[nodiscard]] constexpr std::optional<RayHit<S, N>> operator()(
      const Ray<S, N>& ray, const Shape& shape) const noexcept {
    return raycast_hit(ray, shape);
  }
};
/// The distance that a moving shape travels: `moving` is a `detent::Cast`.
struct CastDistance {
  template <class Moving, class Target>
  [[nodiscard]] constexpr auto operator()(const Moving& moving,
                                          const Target& target) const noexcept {
    return CastAt<Target>::distance(moving, target);
  }
};
struct CastHit {
  template <class Moving, class Shape>
  [[nodiscard]] constexpr auto operator()(const Moving& moving, const Shape& shape) const noexcept {
    return cast(moving.shape, moving.direction, moving.max_distance, shape);
  }
};
struct Distance {
  template <Scalar S, int N, class Shape>
  [[nodiscard]] constexpr S operator()(const Shape& shape, const Vec<S, N>& point) const noexcept {
    return distance(shape, point);
  }
};
struct Contains {
  template <Scalar S, int N, class Shape>
  [[nodiscard]] constexpr bool operator()(const Shape& shape,
                                          const Vec<S, N>& point) const noexcept {
    return contains(shape, point);
  }
};
struct Intersects {
  template <Scalar S, int N, class Shape>
  [[nodiscard]] constexpr bool operator()(const Segment<S, N>& segment,
                                          const Shape& shape) const noexcept {
    return intersects(segment, shape);
  }
};
struct Overlaps {
  template <class A, class B>
  [[nodiscard]] constexpr bool operator()(const A& a, const B& b) const noexcept {
    return overlaps(a, b);
  }
};
struct Place {
  template <Scalar S, int N, class Shape>
  [[nodiscard]] constexpr Shape operator()(const Transform<S, N>& transform,
                                           const Shape& shape) const noexcept {
    return placed(transform, shape);
  }
};

/// Adds a shape's type and numbers to a digest or a snapshot.
struct Describe {
  template <class D, class Shape>
  constexpr void operator()(D& out, const Shape& shape) const noexcept {
    out.add(shape_tag<Shape>, shape);
  }
};
struct SetBox {
  template <class Tree>
  constexpr void operator()(Tree& tree, const std::uint32_t& object,
                            const typename Tree::Box& box) const {
    tree.set(object, box);
  }
};
struct Rebuild {
  template <class Tree>
  constexpr void operator()(Tree& tree) const {
    tree.rebuild();
  }
};
struct MoveFrame {
  template <class Frames, class Transform>
  constexpr void operator()(Frames& frames, const std::uint32_t& frame,
                            const Transform& transform) const noexcept {
    frames.move(frame, transform);
  }
};
struct PlaceFrames {
  template <class Frames>
  constexpr void operator()(Frames& frames) const noexcept {
    frames.place_all();
  }
};
struct VisitNearest {
  template <class Tree, class Probe, class Visit>
  constexpr Walk operator()(const Tree& tree, Probe& probe, const Visit& visit) const {
    return visit_nearest(tree, probe, visit);
  }
};
struct VisitMeeting {
  template <class Tree, class Visit>
  constexpr Walk operator()(const Tree& tree, const typename Tree::Box& box,
                            const std::size_t& most, const Visit& visit) const {
    return visit_meeting(tree, box, most, visit);
  }
};
/// Pairs of objects of a tree, and pairs of its objects and another tree's.
struct VisitPairs {
  template <class Tree, class Visit>
  constexpr void operator()(const Tree& tree, const Tree& other, const Visit& visit) const {
    if (tree.is_empty()) return;
    PairQueue queue(visit);
    add_pairs(tree, tree.root(), queue);
    if (!other.is_empty()) {
      using Boxed = BoxedNode<Tree>;
      add_pairs_below(tree, Boxed::root(tree), other, Boxed::root(other), queue);
    }
    queue.flush();
  }
};

}  // namespace job

}  // namespace detent::detail
