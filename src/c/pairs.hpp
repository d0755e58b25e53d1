// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include "c/convert.hpp"
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
      return with_shape<N>(*b, [&](const auto& other) -> detent_status {
        if constexpr (requires { detent::contact(one, other); }) {
          const auto found = detent::contact(one, other);
          if (found && contact != nullptr) *contact = contact_of(*found);
          return yes_or_no(found.has_value());
        } else {
          return DETENT_NO_QUERY;
        }
      });
    });
  }

  static detent_status time_of_impact(const typename T::Shape* a, const typename T::Sweep* sweep_a,
                                      const typename T::Shape* b, const typename T::Sweep* sweep_b,
                                      std::int32_t target, detent_impact* impact) {
    if (a == nullptr || sweep_a == nullptr || b == nullptr) return DETENT_BAD_ARGUMENT;
    Input<N> in;
    const auto motion_a = sweep(in, *sweep_a);
    const auto motion_b = sweep_b == nullptr ? Sweep<S, N>() : sweep(in, *sweep_b);
    if (!in.is_valid()) return DETENT_NOT_UNIT;
    const auto result = [&](const auto& found) {
      if (found && impact != nullptr) {
        *impact = {found->time.raw(), found->distance.raw(), found->is_hit ? 1u : 0u};
      }
      return yes_or_no(found.has_value());
    };
    const S within = Input<N>::number(target);
    return with_shape<N>(*a, [&](const auto& one) {
      return with_shape<N>(*b, [&](const auto& other) -> detent_status {
        using A = std::remove_cvref_t<decltype(one)>;
        using B = std::remove_cvref_t<decltype(other)>;
        if constexpr (std::is_same_v<A, Segment<S, N>> || std::is_same_v<B, Segment<S, N>>) {
          return DETENT_NO_QUERY;
        } else if constexpr (requires { detent::time_of_impact(one, motion_a, other, motion_b); }) {
          return result(detent::time_of_impact(one, motion_a, other, motion_b, within));
        } else if constexpr (requires { detent::time_of_impact(one, motion_a, other, within); }) {
          if (sweep_b != nullptr) return DETENT_NO_QUERY;
          return result(detent::time_of_impact(one, motion_a, other, within));
        } else {
          return DETENT_NO_QUERY;
        }
      });
    });
  }

 private:
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
