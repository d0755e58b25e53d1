// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "c/convert.hpp"
#include "detent/scene/scene.hpp"

// Queries of one shape or two. The exports call the functions of the same names.
namespace detent::c {

/// The number of a kind of shape. Distances are symmetric: each pair is compiled once, in this order.
template <class Shape>
inline constexpr int kind_of = 0;
#define DETENT_C_KIND(N, KIND, Shape, name) \
  template <int N>                          \
  inline constexpr int kind_of<Shape<S, N>> = DETENT_##KIND;
DETENT_C_SHAPES(DETENT_C_KIND, N)
#undef DETENT_C_KIND

template <class Shape>
inline constexpr bool is_segment = kind_of<Shape> == DETENT_SEGMENT;

/// Reads a shape whose kind is known.
template <template <class, int> class Shape, int N>
[[nodiscard]] Shape<S, N> read(Input<N>& in, const typename Types<N>::Shape& shape) noexcept {
#define DETENT_C_READ(N, KIND, Kind, name) \
  if constexpr (kind_of<Shape<S, N>> == DETENT_##KIND) return in.name(shape);
  DETENT_C_SHAPES(DETENT_C_READ, N)
#undef DETENT_C_READ
}

/// `Ask::of<Shape>(arguments...)` for a kind of shape: separate functions, to which this jumps, so
/// that a sphere does not pay for the registers and stack that an OBB needs.
template <class Ask, class... Arguments>
[[gnu::always_inline]] inline detent_status jump(std::uint32_t kind, Arguments... arguments) {
#define DETENT_C_JUMP(N, KIND, Shape, name) \
  case DETENT_##KIND:                       \
    return Ask::template of<Shape>(arguments...);
  switch (kind) {
    DETENT_C_SHAPES(DETENT_C_JUMP, N)
    default:
      return no_query(kind);
  }
#undef DETENT_C_JUMP
}

// One function without calls, unless compiled for size: passing a ray on in memory stalls until its
// words are stored, which takes 10 ns of a raycast.
#ifdef __OPTIMIZE_SIZE__
#define DETENT_C_FLAT [[gnu::noinline]]
#else
#define DETENT_C_FLAT [[gnu::noinline, gnu::flatten]]
#endif

/// Shapes whose overlaps take a few instructions: another call would take as long.
template <class Shape>
inline constexpr bool is_plain = kind_of<Shape> <= DETENT_AABB;

template <int N>
struct Queries {
  using T = Types<N>;

  static detent_status raycast(const typename T::Ray* ray, const typename T::Shape* shape,
                               typename T::Hit* hit) {
    if (ray == nullptr || shape == nullptr) return DETENT_BAD_ARGUMENT;
    return hit == nullptr ? jump<IsHit>(shape->kind, shape, ray)
                          : jump<FirstHit>(shape->kind, shape, ray, hit);
  }

  static detent_status raycast_many(const typename T::Ray* rays, std::uint32_t count,
                                    const typename T::Shape* shape, std::int32_t* distances) {
    if (shape == nullptr || (count != 0 && (rays == nullptr || distances == nullptr))) {
      return DETENT_BAD_ARGUMENT;
    }
    return with_shape<N>(*shape, [&](const auto& target) -> detent_status {
      for (std::uint32_t i = 0; i < count; ++i) {
        Input<N> in;
        const auto ray = in.ray(rays[i]);
        if (!in.is_valid()) return DETENT_NOT_UNIT;
        const auto distance = detent::raycast(ray, target);
        distances[i] = distance ? distance->raw() : -1;
      }
      return DETENT_OK;
    });
  }

  static detent_status contains(const typename T::Shape* shape, const typename T::Vec* point) {
    if (shape == nullptr || point == nullptr) return DETENT_BAD_ARGUMENT;
    return jump<Holds>(shape->kind, shape, point);
  }

  static detent_status overlaps(const typename T::Shape* a, const typename T::Shape* b) {
    if (a == nullptr || b == nullptr) return DETENT_BAD_ARGUMENT;
    return jump<Meets>(a->kind, a, b);
  }

  static detent_status closest_point(const typename T::Shape* shape, const typename T::Vec* point,
                                     typename T::Vec* closest) {
    if (shape == nullptr || point == nullptr || closest == nullptr) return DETENT_BAD_ARGUMENT;
    return jump<Nearest>(shape->kind, shape, point, closest);
  }

  static detent_status distance_to_point(const typename T::Shape* shape,
                                         const typename T::Vec* point, std::int32_t* distance) {
    if (shape == nullptr || point == nullptr || distance == nullptr) return DETENT_BAD_ARGUMENT;
    return jump<Away>(shape->kind, shape, point, distance);
  }

  static detent_status distance(const typename T::Shape* a, const typename T::Shape* b,
                                std::int32_t* distance) {
    if (a == nullptr || b == nullptr || distance == nullptr) return DETENT_BAD_ARGUMENT;
    return with_shape<N>(*a, [&](const auto& one) {
      return with_shape<N>(*b, [&](const auto& other) -> detent_status {
        using A = std::remove_cvref_t<decltype(one)>;
        using B = std::remove_cvref_t<decltype(other)>;
        if constexpr (kind_of<A> <= kind_of<B>) {
          *distance = detent::distance(one, other).raw();
        } else {
          *distance = detent::distance(other, one).raw();
        }
        return DETENT_OK;
      });
    });
  }

 private:
  struct IsHit {
    template <template <class, int> class Shape>
    DETENT_C_FLAT static detent_status of(const typename T::Shape* shape,
                                          const typename T::Ray* ray) {
      Input<N> in;
      const auto along = in.ray(*ray);
      const auto target = read<Shape>(in, *shape);
      if (!in.is_valid()) return DETENT_NOT_UNIT;
      return yes_or_no(detent::raycast(along, target).has_value());
    }
  };
  struct FirstHit {
    template <template <class, int> class Shape>
    [[gnu::noinline]] static detent_status of(const typename T::Shape* shape,
                                              const typename T::Ray* ray, typename T::Hit* hit) {
      Input<N> in;
      const auto along = in.ray(*ray);
      const auto target = read<Shape>(in, *shape);
      if (!in.is_valid()) return DETENT_NOT_UNIT;
      const auto found = detent::raycast_hit(along, target);
      if (!found) return DETENT_NO;
      *hit = Output<N>::hit(*found);
      return DETENT_OK;
    }
  };
  struct Holds {
    template <template <class, int> class Shape>
    [[gnu::noinline]] static detent_status of(const typename T::Shape* shape,
                                              const typename T::Vec* point) {
      Input<N> in;
      const auto target = read<Shape>(in, *shape);
      if (!in.is_valid()) return DETENT_NOT_UNIT;
      const auto at = Input<N>::vec(*point);
      if constexpr (is_plain<Shape<S, N>>) return yes_or_no(detent::contains(target, at));
      return yes_or_no(detail::separately<detail::job::Contains>(target, at));
    }
  };
  struct Nearest {
    template <template <class, int> class Shape>
    [[gnu::noinline]] static detent_status of(const typename T::Shape* shape,
                                              const typename T::Vec* point,
                                              typename T::Vec* closest) {
      Input<N> in;
      const auto target = read<Shape>(in, *shape);
      if (!in.is_valid()) return DETENT_NOT_UNIT;
      *closest = Output<N>::vec(detent::closest_point(target, Input<N>::vec(*point)));
      return DETENT_OK;
    }
  };
  struct Away {
    template <template <class, int> class Shape>
    [[gnu::noinline]] static detent_status of(const typename T::Shape* shape,
                                              const typename T::Vec* point,
                                              std::int32_t* distance) {
      Input<N> in;
      const auto target = read<Shape>(in, *shape);
      if (!in.is_valid()) return DETENT_NOT_UNIT;
      const auto at = Input<N>::vec(*point);
      *distance = detail::separately<detail::job::Distance>(target, at).raw();
      return DETENT_OK;
    }
  };
  struct Meets {
    template <template <class, int> class First>
    [[gnu::noinline]] static detent_status of(const typename T::Shape* a,
                                              const typename T::Shape* b) {
      return jump<Both<First>>(b->kind, a, b);
    }
    template <template <class, int> class First>
    struct Both {
      template <template <class, int> class Second>
      [[gnu::noinline]] static detent_status of(const typename T::Shape* a,
                                                const typename T::Shape* b) {
        Input<N> in;
        const auto one = read<First>(in, *a);
        const auto other = read<Second>(in, *b);
        if (!in.is_valid()) return DETENT_NOT_UNIT;
        if constexpr (is_plain<First<S, N>> && is_plain<Second<S, N>>) {
          return yes_or_no(detent::overlaps(one, other));
        } else if constexpr (is_segment<First<S, N>>) {
          return yes_or_no(detail::separately<detail::job::Intersects>(one, other));
        } else if constexpr (is_segment<Second<S, N>>) {
          return yes_or_no(detail::separately<detail::job::Intersects>(other, one));
        } else {
          return yes_or_no(detail::separately<detail::job::Overlaps>(one, other));
        }
      }
    };
  };
};

#undef DETENT_C_FLAT

}  // namespace detent::c
