// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "detent/cull/prefetch.hpp"
#include "detent/dynamics/contact_group.hpp"
#include "detent/dynamics/four_contacts.hpp"
#include "detent/dynamics/idle.hpp"
#include "detent/dynamics/threads.hpp"
#include "detent/dynamics/tick/colours.hpp"
#include "detent/dynamics/tick/ready_contacts.hpp"

namespace detent::detail {

/// What a pass does with contacts that seem idle: one that only applies impulses leaves them alone,
/// any other first checks that they stay idle.
enum class OfIdle : std::uint8_t { skipped, checked };

/// The contacts of each colour except the last in groups of four, which are solved at once. Contacts
/// that seem idle have their own groups.
template <class Types>
class ContactGroups {
  using S = typename Types::S;
  using AllReady = ReadyContacts<Types>;
  using Ready = typename AllReady::Ready;
  using Rows = typename AllReady::Rows;
  using Work = ContactWork<Types>;
  static constexpr std::size_t colour_count = Colours<Types>::count;

 public:
  /// Groups the contacts and computes their rows.
  template <class Threads>
  constexpr void prepare(const Work& work, AllReady& contacts, const Colours<Types>& colours,
                         const Threads& threads) {
    arrange(colours);
    threads.each(0, groups_.size(), groups_a_call, [&](std::size_t k) {
      auto& group = groups_[k];
      group.is_idle ? prepare_idle(work, contacts, group) : prepare_group(work, contacts, group);
    });
  }

  /// Solves the groups in order of colours: `together` solves a group, and `alone` each contact of a
  /// group that `together` refuses.
  template <OfIdle Idle, class Threads, class Together, class Alone>
  constexpr void solve_each(const Work& work, AllReady& contacts, const Threads& threads,
                            const Together& together, const Alone& alone) {
    const bool exceed_cache = groups_.size() * sizeof(groups_[0]) > groups_in_cache;
    const auto visit = [&](std::size_t g) {
      auto& group = groups_[g];
      if (exceed_cache && g + 2 < groups_.size()) prefetch(&groups_[g + 2], sizeof(group));
      if (group.is_idle) {
        if (Idle == OfIdle::skipped) return;
        if (stay_idle<FastLongLanes, S>(idle_[group.idle], work.flights.moving().data())) return;
        end_idleness(work, contacts, group);
        measure_group(work, contacts, group);
      }
      solve_group(work, contacts, group, together, alone);
    };
    std::size_t first = 0;
    if constexpr (Threads::are_many) {
      for (const auto end : group_ends_) {
        threads.each(first, end, groups_a_call, visit);
        first = end;
      }
    }
    OneThread().each(first, groups_.size(), 1, visit);
  }

  /// Writes the impulses of groups back.
  template <class Threads>
  constexpr void scatter_all(const Work& work, AllReady& contacts, const Threads& threads) {
    threads.each(0, groups_.size(), groups_a_call, [&](std::size_t k) {
      if (groups_[k].is_idle) return;
      scatter(groups_[k], &contacts[groups_[k].first], work.found.contacts.data());
    });
  }

 private:
  /// Groups the contacts of each colour except the last, without their rows. Contacts that seem idle
  /// have their own groups.
  constexpr void arrange(const Colours<Types>& colours) {
    const auto groups_of = [](std::uint32_t size) { return (size + 3) / 4; };
    std::uint32_t count = 0, idle_count = 0;
    for (std::size_t c = 0; c + 1 < colour_count; ++c) {
      const auto idle_groups = groups_of(colours.end(c) - colours.busy_end(c));
      count += groups_of(colours.busy_end(c) - colours.begin(c)) + idle_groups;
      idle_count += idle_groups;
      group_ends_[c] = count;
    }
    groups_.resize(count);
    idle_.resize(idle_count);
    std::size_t g = 0;
    std::uint32_t idle_group = 0;
    const auto group = [&](std::uint32_t begin, std::uint32_t end, bool are_idle) {
      for (auto i = begin; i < end; i += 4) {
        groups_[g].first = i;
        groups_[g].size = static_cast<std::uint8_t>((std::min)(end - i, std::uint32_t{4}));
        groups_[g].is_idle = are_idle;
        groups_[g++].idle = are_idle ? idle_group++ : 0;
      }
    };
    for (std::size_t c = 0; c + 1 < colour_count; ++c) {
      group(colours.begin(c), colours.busy_end(c), false);
      group(colours.busy_end(c), colours.end(c), true);
    }
  }
  /// Bounds the gaps of a group that seems idle, or prepares it if it is not.
  constexpr void prepare_idle(const Work& work, AllReady& contacts, ContactGroup<S>& group) {
    auto& bounds = idle_[group.idle];
    for (std::size_t k = 0; k < long_lane_count; ++k) {
      auto& contact = contacts[group.first + (k < group.size ? k : 0)];
      const auto& [manifold, offset] = work.found.manifolds[contact.contact];
      contact.count = 0;  // for the end of the step
      bounds.a[k] = contact.a;
      bounds.b[k] = contact.b;
      place_idle(bounds, k, manifold, work.flights.held()[contact.a],
                 work.flights.held()[contact.b], offset);
    }
    if (!stay_idle<FastLongLanes, S>(bounds, work.flights.moving().data()))
      end_idleness(work, contacts, group);
  }
  /// Prepares a group that was idle. In a step, its gaps are measured next.
  constexpr void end_idleness(const Work& work, AllReady& contacts, ContactGroup<S>& group) {
    group.is_idle = false;
    prepare_group(work, contacts, group);
  }
  /// Prepares the contacts of a group: at once, or one by one if a number must be clamped.
  constexpr void prepare_group(const Work& work, AllReady& contacts, ContactGroup<S>& group) {
    FourContacts<S> from;
    auto* ready = &contacts[group.first];
    auto* rows = &contacts.rows(group.first);
    bool is_free = true, bounces = false;
    for (std::size_t k = 0; k < long_lane_count; ++k) {
      auto& contact = ready[k < group.size ? k : 0];
      const auto& found = work.found.manifolds[contact.contact];
      from.manifold[k] = &found.manifold;
      from.offset[k] = &found.offset;
      if (k >= group.size) continue;
      const auto [share_a, share_b] =
          mass_shares<S>(work.bodies[contact.a], work.bodies[contact.b]);
      from.share_a[k] = share_a;
      from.share_b[k] = share_b;
      contact.count = static_cast<std::uint8_t>(found.manifold.count);
      contact.is_wall = share_a == 0 || share_b == 0;
      contact.pushed = {share_a != 0, share_b != 0};
      AllReady::set_surface(work, contact);
      bounces = bounces || contact.bounce != 0;
      is_free = is_free && work.flights.held()[contact.a].locked == 0 &&
                work.flights.held()[contact.b].locked == 0;
    }
    if (is_free && prepare_four<FastLongLanes, S>(group, from, work.flights.held().data(), ready)) {
      gather_impulses(group, ready, work.found.contacts.data());
      if (bounces) spread_rows(group, ready, rows);
    } else {
      for (std::size_t k = 0; k < group.size; ++k) contacts.prepare_rows(work, group.first + k);
      gather(group, ready, rows, work.found.contacts.data());
    }
    for (std::size_t k = 0; bounces && k < group.size; ++k)
      AllReady::note_closing(work, ready[k], rows[k]);
  }
  template <class Together, class Alone>
  constexpr void solve_group(const Work& work, AllReady& contacts, ContactGroup<S>& group,
                             const Together& together, const Alone& alone) {
    if (group.are_even) {
      GroupSolver<FastLongLanes, S, true> solver(group, work.flights.moving().data());
      if (together(solver)) return;
    } else {
      GroupSolver<FastLongLanes, S> solver(group, work.flights.moving().data());
      if (together(solver)) return;
    }
    auto* ready = &contacts[group.first];
    auto* rows = &contacts.rows(group.first);
    spread_rows(group, ready, rows);
    scatter(group, ready, work.found.contacts.data());
    for (std::size_t k = 0; k < group.size; ++k) alone(ready[k], rows[k]);
    gather_impulses(group, ready, work.found.contacts.data());
  }

  constexpr void measure_group(const Work& work, AllReady& contacts, ContactGroup<S>& group) {
    solve_group(
        work, contacts, group, [](auto& solver) { return solver.measure_gaps(); },
        [&](Ready& ready, const Rows& rows) { AllReady::measure_gaps(work, ready, rows); });
  }

  static constexpr std::size_t groups_a_call = 8;  // as `contacts_a_call`
  // Bytes of groups that stay in a usual second cache from pass to pass, so that a prefetch would only
  // take time.
  static constexpr std::size_t groups_in_cache = 1 << 20;

  typename Types::template List<ContactGroup<S>, 0> groups_;
  typename Types::template List<IdleGroup<S>, 0> idle_;
  std::array<std::uint32_t, colour_count - 1> group_ends_{};
};

}  // namespace detent::detail
