// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include "c/hulls.hpp"
#include "detent/query/contact.hpp"
#include "detent/query/time_of_impact.hpp"

// Contacts and times of impact of two shapes.
namespace detent::c {

template <int N>
struct Pairs {
  using T = Types<N>;

  static detent_status contact(const typename T::Shape* a, const typename T::Shape* b,
                               typename T::Manifold* contact) {
    if (a == nullptr || b == nullptr) return DETENT_BAD_ARGUMENT;
    return with_shape<N>(*a, [&](const auto& one) {
      return with_shape<N>(*b,
                           [&](const auto& other) { return contact_between(one, other, contact); });
    });
  }
  static detent_status contact_of_shapes(const detent_context* context, const typename T::Shape* a,
                                         const typename T::Shape* b,
                                         typename T::Manifold* contact) {
    if (a == nullptr || b == nullptr) return DETENT_BAD_ARGUMENT;
    if (a->kind != DETENT_HULL && b->kind != DETENT_HULL) return Pairs::contact(a, b, contact);
    return with_a_hull(context, *a, *b, [&](const auto& one, const auto& other) {
      return contact_between(one, other, contact);
    });
  }

  static detent_status time_of_impact(const typename T::Shape* a, const typename T::Sweep* sweep_a,
                                      const typename T::Shape* b, const typename T::Sweep* sweep_b,
                                      std::int32_t target, detent_impact* impact) {
    if (a == nullptr || sweep_a == nullptr || b == nullptr) return DETENT_BAD_ARGUMENT;
    Motion motion(*sweep_a, sweep_b, target);
    if (!motion.is_valid) return DETENT_NOT_UNIT;
    return with_shape<N>(*a, [&](const auto& one) {
      return with_shape<N>(
          *b, [&](const auto& other) { return impact_between(one, other, motion, impact); });
    });
  }
  static detent_status time_of_impact_of_shapes(const detent_context* context,
                                                const typename T::Shape* a,
                                                const typename T::Sweep* sweep_a,
                                                const typename T::Shape* b,
                                                const typename T::Sweep* sweep_b,
                                                std::int32_t target, detent_impact* impact) {
    if (a == nullptr || sweep_a == nullptr || b == nullptr) return DETENT_BAD_ARGUMENT;
    if (a->kind != DETENT_HULL && b->kind != DETENT_HULL) {
      return Pairs::time_of_impact(a, sweep_a, b, sweep_b, target, impact);
    }
    Motion motion(*sweep_a, sweep_b, target);
    if (!motion.is_valid) return DETENT_NOT_UNIT;
    return with_a_hull(context, *a, *b, [&](const auto& one, const auto& other) {
      return impact_between(one, other, motion, impact);
    });
  }

 private:
  /// The motion of both shapes, and the distance that counts as close.
  struct Motion {
    bool is_valid;
    bool moves_b;
    Sweep<S, N> a, b;
    S target;

    Motion(const typename T::Sweep& sweep_a, const typename T::Sweep* sweep_b,
           std::int32_t within) noexcept
        : moves_b(sweep_b != nullptr), target(Input<N>::number(within)) {
      Input<N> in;
      // cppcheck-suppress useInitializationList  // `in` is shared
      a = sweep(in, sweep_a);
      if (moves_b) b = sweep(in, *sweep_b);
      is_valid = in.is_valid();
    }
  };

  template <class A, class B>
  static detent_status contact_between(const A& a, const B& b, typename T::Manifold* contact) {
    if constexpr (requires { detent::contact(a, b); }) {
      const auto found = detent::contact(a, b);
      if (found && contact != nullptr) *contact = contact_of(*found);
      return yes_or_no(found.has_value());
    } else {
      return DETENT_NO_QUERY;
    }
  }
  template <class A, class B>
  static detent_status impact_between(const A& a, const B& b, const Motion& motion,
                                      detent_impact* impact) {
    const auto result = [&](const auto& found) {
      if (found && impact != nullptr) {
        *impact = {found->time.raw(), found->distance.raw(), found->is_hit ? 1u : 0u};
      }
      return yes_or_no(found.has_value());
    };
    if constexpr (std::is_same_v<A, Segment<S, N>> || std::is_same_v<B, Segment<S, N>>) {
      return DETENT_NO_QUERY;
    } else if constexpr (requires { detent::time_of_impact(a, motion.a, b, motion.b); }) {
      return result(detent::time_of_impact(a, motion.a, b, motion.b, motion.target));
      // cppcheck-suppress identicalConditionAfterEarlyExit  // false positive: different arguments
    } else if constexpr (requires { detent::time_of_impact(a, motion.a, b, motion.target); }) {
      if (motion.moves_b) return DETENT_NO_QUERY;
      return result(detent::time_of_impact(a, motion.a, b, motion.target));
    } else {
      return DETENT_NO_QUERY;
    }
  }
  /// f(a, b) for two shapes of which one or both are hulls.
  template <class F>
  static detent_status with_a_hull(const detent_context* context, const typename T::Shape& a,
                                   const typename T::Shape& b, const F& f) {
    if (a.kind != DETENT_HULL) {
      return with_shape<N>(a, [&](const auto& one) {
        return with_hull<N>(context, b, [&](const auto& other) { return f(one, other); });
      });
    }
    return with_hull<N>(context, a, [&](const auto& one) {
      const auto pair = [&](const auto& other) { return f(one, other); };
      return b.kind == DETENT_HULL ? with_hull<N>(context, b, pair) : with_shape<N>(b, pair);
    });
  }

  static typename T::Manifold contact_of(const Contact<S, N>& contact) noexcept {
    typename T::Manifold out{};
    out.normal = Output<N>::direction(contact.normal);
    out.depth = contact.depth.raw();
    out.count = static_cast<std::uint32_t>(contact.count);
    for (std::size_t i = 0; i < contact.count; ++i) {
      const auto& point = contact.points[i];
      out.points[i] = {Output<N>::vec(point.point), point.depth.raw(), point.feature};
    }
    return out;
  }
  static Sweep<S, N> sweep(Input<N>& in, const typename T::Sweep& sweep) noexcept {
    return {Input<N>::vec(sweep.start), Input<N>::vec(sweep.end), in.rotation(sweep.start_rotation),
            in.rotation(sweep.end_rotation)};
  }
};

}  // namespace detent::c
