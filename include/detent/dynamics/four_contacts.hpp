// SPDX-License-Identifier: MIT
#pragma once

#include "detent/dynamics/contact_group.hpp"
#include "detent/dynamics/four_flight.hpp"

namespace detent::detail {

/// The input of `prepare_four`: the contacts of a group. Missing ones repeat the first.
template <Scalar S>
struct FourContacts {
  using F = Formats<S>;

  Quad<const Manifold<S, 3>*> manifold{};
  Quad<const Vec<typename F::Lever, 3>*> offset{};
  Quad<typename F::Ratio> share_a{}, share_b{};
};

DETENT_BEGIN_LONG_LANES

/// `tangents` of four unit vectors.
template <Scalar S, class L, class Normal>
[[nodiscard]] std::array<Normal, 2> tangents_of_four(const Normal& n,
                                                     FourRounder<L>& round) noexcept {
  using Ratio = typename Formats<S>::Ratio;
  using Side = Four<Ratio, L>;
  const Side zero;
  const auto negative = [&](const Side& x) { return narrow<Ratio::bits>(zero - x); };
  const auto magnitude = [&](std::size_t i) { return larger(n[i], negative(n[i])); };
  const auto x = magnitude(0), y = magnitude(1);
  const L is_y = above(x, y), is_z = above(smaller(x, y), magnitude(2));
  // Picks by the axis with the least component.
  const auto pick = [&](const Side& in_x, const Side& in_y, const Side& in_z) {
    return select(is_z, in_z, select(is_y, in_y, in_x));
  };
  const auto one = pick(n[2], n[0], n[1]), other = negative(pick(n[1], n[2], n[0]));
  const auto squared = (one * one + other * other).raw;
  const Side j(round.part_of_length(one.raw, squared)), k(round.part_of_length(other.raw, squared));
  const Normal first{pick(zero, k, j), pick(j, zero, k), pick(k, j, zero)};
  const auto about = [&](std::size_t p, std::size_t q) {
    return round.template nearest<Ratio>(n[p] * first[q] - n[q] * first[p]);
  };
  return {first, Normal{about(1, 2), about(2, 0), about(0, 1)}};
}

/// Prepares contacts of bodies without locked axes, with the result of `prepare` and then `gather`.
/// `group` has their first index and their number, `ready` their numbers of points and which bodies
/// are pushed. Returns false if some number must be clamped; the group is then not ready.
template <class L, Scalar S>
[[nodiscard]] bool prepare_four(ContactGroup<S>& group, const FourContacts<S>& from,
                                const Support<S, 3>* supports, ReadyContact<S, 3>* ready) noexcept {
  using F = Formats<S>;
  using Arm = typename F::Arm;
  using Gap = typename F::Gap;
  using Give = typename F::Give;
  using Gyration = typename F::Gyration;
  using Lever = typename F::Lever;
  using Moment = typename F::Moment;
  using Ratio = typename F::Ratio;
  using Response = typename F::Response;
  using Speed = typename F::Speed;
  using Group = ContactGroup<S>;
  using Gyrations = std::array<FourLong<Gyration, L>, 6>;
  using Moments = std::array<Four<Moment, L>, 3>;
  FourRounder<L> round;
  constexpr std::size_t lanes = long_lane_count;
  const std::size_t size = group.size;

  Quad<int> count{};
  Quad<bool> turns_a{}, turns_b{};
  group.count = 0;
  for (std::size_t k = 0; k < lanes; ++k) {
    const auto& contact = ready[k < size ? k : 0];
    group.a[k] = contact.a;
    group.b[k] = contact.b;
    count[k] = k < size ? contact.count : 0;
    group.count = (std::max)(group.count, contact.count);
    group.pushes_a[k] = k < size && contact.pushed.a;
    group.pushes_b[k] = k < size && contact.pushed.b;
    turns_a[k] = k < size && !supports[contact.a].is_fixed;
    turns_b[k] = k < size && !supports[contact.b].is_fixed;
  }
  group.rigid = group.pull = group.loss = group.grip = {};
  for (std::size_t k = 0; k < size; ++k) place_surface(group, ready[k], k);
  group.are_even = from.share_a == from.share_b;
  group.pressures = {};
  group.pressed = {};
  group.frictions = {};

  const auto mask_of = [](const auto& is_in) {
    return L(LongWords{is_in(0) ? -1 : 0, is_in(1) ? -1 : 0, is_in(2) ? -1 : 0, is_in(3) ? -1 : 0});
  };
  const auto each = [](const auto& get) {
    using T = std::remove_cvref_t<decltype(get(0))>;
    return Four<T, L>(Quad<T>{get(0), get(1), get(2), get(3)});
  };
  const auto three = [](const auto& get) { return std::array{get(0), get(1), get(2)}; };
  const auto masked = [](const auto& x, const L& mask) {
    return std::remove_cvref_t<decltype(x)>(x.raw & mask);
  };
  const L used = mask_of([&](std::size_t k) { return k < size; });
  const L mask_a = mask_of([&](std::size_t k) { return turns_a[k]; });
  const L mask_b = mask_of([&](std::size_t k) { return turns_b[k]; });

  const FourSupports<S, L> a(supports, group.a), b(supports, group.b);
  const auto out_of_a = [&](const auto& v) {
    using T = typename std::remove_cvref_t<decltype(v[0])>::Number;
    return three([&](std::size_t k) {
      return round.template nearest<T>(a.axes[0][k] * v[0] + a.axes[1][k] * v[1] +
                                       a.axes[2][k] * v[2]);
    });
  };
  const Four<Ratio, L> share_a(from.share_a), share_b(from.share_b);
  const auto share_of_spread = [&](const FourSupports<S, L>& support,
                                   const Four<Ratio, L>& share) -> Gyrations {
    const auto at = [&](std::size_t e) {
      FourLongSum<Gyration::frac + Ratio::frac, L> scaled;
      scaled.add(share, FourLong<Gyration, L>(support.spread[e]));
      return FourLong<Gyration, L>(round.template nearest<Gyration>(scaled));
    };
    return {at(0), at(1), at(2), at(3), at(4), at(5)};
  };
  const Gyrations spread_a = share_of_spread(a, share_a), spread_b = share_of_spread(b, share_b);

  const auto store = [](const auto& v, auto& to) {
    for (std::size_t i = 0; i < 3; ++i) v[i].store(to[i]);
  };
  const auto push_along = [&](const auto& n, typename Group::Push& push) {
    store(n, push.along);
    for (std::size_t i = 0; i < 3; ++i) {
      round.template nearest<Ratio>(share_a * n[i]).store(push.on_a[i]);
      round.template nearest<Ratio>(share_b * n[i]).store(push.on_b[i]);
    }
  };
  // r x u
  const auto moment = [&](const auto& r, const auto& u) -> Moments {
    const auto about = [&](std::size_t j, std::size_t k) {
      return round.template nearest<Moment>(r[j] * u[k] - r[k] * u[j]);
    };
    return {about(1, 2), about(2, 0), about(0, 1)};
  };
  // Stores the response to a moment, and returns what it gives, as `give` does.
  const auto respond = [&](const Moments& turn, const Gyrations& spread, auto& to_moment,
                           auto& to_response) {
    const auto response = three([&](std::size_t i) {
      FourLongSum<Gyration::frac + Moment::frac, L> sum;
      for (std::size_t k = 0; k < 3; ++k) {
        sum.add(turn[k], spread[entry<3>(static_cast<int>(i), static_cast<int>(k))]);
      }
      return round.template nearest<Response>(sum);
    });
    store(turn, to_moment);
    store(response, to_response);
    const auto whole = turn[0] * response[0] + turn[1] * response[1] + turn[2] * response[2];
    return larger(round.template nearest_long<Give>(whole), Four<Give, L>());
  };
  const auto complete = [&](const Moments& turn_a, const Moments& turn_b,
                            typename Group::Lever& lever, const L& mask) {
    const auto give_a = respond(turn_a, spread_a, lever.moment_a, lever.response_a);
    const auto give_b = respond(turn_b, spread_b, lever.moment_b, lever.response_b);
    masked(mass_of<Ratio>(give_a, give_b), mask).store(lever.mass);
  };

  const auto n = out_of_a(three([&](std::size_t i) {
    return masked(
        each([&](std::size_t k) { return from.manifold[k]->normal[static_cast<int>(i)]; }), used);
  }));
  push_along(n, group.normal);

  const auto offset = three([&](std::size_t i) {
    return each([&](std::size_t k) { return (*from.offset[k])[static_cast<int>(i)]; });
  });
  // The arms of a point from the center of a, for bodies that turn.
  const auto arms = [&](const auto& p, const L& mask) {
    return three([&](std::size_t i) {
      return round.template checked<Arm>(Four<Fixed<62, Arm::frac>, L>(p[i].raw & mask));
    });
  };
  const auto row_at = [&](const auto& p, const auto& u, const L& mask,
                          typename Group::Lever& lever) {
    const auto from_b = three([&](std::size_t i) { return p[i] - offset[i]; });
    complete(moment(arms(p, mask_a & mask), u), moment(arms(from_b, mask_b & mask), u), lever,
             mask);
  };
  using Levers = std::array<Four<Lever, L>, 3>;
  std::array<Levers, Group::capacity> at;
  std::array<Four<Fixed<62, Lever::frac>, L>, 3> sum{};
  for (std::size_t i = 0; i < group.count; ++i) {
    const L mask = mask_of([&](std::size_t k) { return static_cast<int>(i) < count[k]; });
    const auto point = [&](std::size_t k) -> const auto& { return from.manifold[k]->points[i]; };
    const auto p = out_of_a(three([&](std::size_t c) {
      return masked(each([&](std::size_t k) { return point(k).point[static_cast<int>(c)]; }), mask);
    }));
    at[i] = p;
    for (std::size_t c = 0; c < 3; ++c) sum[c] = sum[c] + p[c];
    row_at(p, n, mask, group.pressure[i]);
    const auto separation =
        masked(each([&](std::size_t k) { return Gap(point(k).separation); }), mask);
    const auto gap = round.template checked<Speed>(
        Four<Fixed<62, Speed::frac>, L>(separation.raw << (Speed::frac - Gap::frac)));
    gap.store(group.gap[i]);
    gap.store(group.gap_now[i]);
  }

  const L points(LongWords{(std::max)(count[0], 1), (std::max)(count[1], 1),
                           (std::max)(count[2], 1), (std::max)(count[3], 1)});
  const Levers middle = three([&](std::size_t c) {  // of points that are not used: 0
    const L q = L::near_ratio(sum[c].raw, points << 30);
    return Four<Lever, L>(nearest_to_quotient(q, sum[c].raw - L::product(q, points), points));
  });
  const auto across = tangents_of_four<S>(n, round);
  // Distances from the middle, and their ratios to the farthest. A single point is the middle.
  std::array<Four<Arm, L>, Group::capacity> distance{};
  Four<Arm, L> farthest;
  for (std::size_t i = 0; i < group.count; ++i) {
    const L mask = mask_of([&](std::size_t k) { return static_cast<int>(i) < count[k]; });
    Four<Fixed<62, 2 * Lever::frac>, L> squared;
    for (std::size_t c = 0; c < 3; ++c) {
      const auto d =
          round.template checked<Fixed<30, Lever::frac>>(masked(at[i][c] - middle[c], mask));
      squared = squared + d * d;
    }
    distance[i] =
        round.template checked<Arm>(Four<Fixed<62, Arm::frac>, L>(root_floor_of(squared.raw)));
    farthest = larger(farthest, distance[i]);
  }
  const Four<Arm, L> one(Arm::assume_raw(1));
  for (std::size_t i = 0; i < group.count; ++i) {
    Four<Ratio, L>(nearest_ratio(distance[i].raw, larger(farthest, one).raw)).store(group.reach[i]);
  }
  for (std::size_t t = 0; t < 2; ++t) {
    const auto& u = across[t];
    push_along(u, group.tangent[t]);
    row_at(middle, u, used, group.friction[t]);
  }
  const auto twist =
      three([&](std::size_t i) { return round.template nearest<Moment>(farthest * n[i]); });
  const auto twist_of = [&](const L& mask) {
    return three([&](std::size_t i) { return masked(twist[i], mask); });
  };
  complete(twist_of(mask_a), twist_of(mask_b), group.twist, used);
  if (round.is_beyond()) return false;

  group.has_rows = false;
  for (std::size_t k = 0; k < size; ++k) {
    for (std::size_t i = 0; i < static_cast<std::size_t>(count[k]); ++i) {
      ready[k].gap[i] = ready[k].gap_now[i] = group.gap[i][k];
    }
  }
  return true;
}

DETENT_END_LONG_LANES

}  // namespace detent::detail
