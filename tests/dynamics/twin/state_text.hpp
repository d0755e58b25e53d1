// SPDX-License-Identifier: MIT
#pragma once

#include <iostream>

#include "detent/dynamics/dynamics.hpp"

// Prints the state of a world for run.py, which compares it with its own.

namespace detent::test {

template <class List>
void print_joints(const List& joints) {
  for (std::size_t i = 0; i < joints.size(); ++i) {
    const auto& record = joints[i];
    if (record.generation == 0) continue;
    std::cout << "joint " << i << ' ' << record.bodies().a << ' ' << record.bodies().b;
    record.joint.visit([&]<class Joint>(const Joint&) {
      using Rows = detail::RowsOf<Joint>;
      for (std::size_t k = 0; k < Rows::push; ++k) std::cout << ' ' << record.push[k].raw();
      for (std::size_t k = 0; k < Rows::turn; ++k) std::cout << ' ' << record.turn[k].raw();
    });
    std::cout << '\n';
  }
}

/// The integers of every body, contact, joint and event, a line each, and an empty line.
template <Scalar S, int N, class World>
void print_state(const World& world) {
  const auto& bodies = detail::WorldAccess::bodies(world);
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const auto& body = bodies[i];
    if (body.generation == 0) continue;
    std::cout << "body " << i;
    for (int k = 0; k < N; ++k) std::cout << ' ' << body.state.place[k].raw();
    for (int k = 0; k < (N == 2 ? 2 : 4); ++k) std::cout << ' ' << body.state.orientation[k].raw();
    for (int k = 0; k < N; ++k) std::cout << ' ' << body.state.velocity[k].raw();
    for (const auto& w : body.state.spin) std::cout << ' ' << w.raw();
    for (int k = 0; k < N; ++k) std::cout << ' ' << body.drift[k].raw();
    for (int k = 0; k < (N == 2 ? 2 : 4); ++k) std::cout << ' ' << body.anchor[k].raw();
    std::cout << ' ' << int{body.quiet} << ' ' << body.sleeps << '\n';
  }
  const auto& contacts = detail::WorldAccess::contacts(world);
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    const auto& contact = contacts[k];
    std::cout << "contact " << contact.a << ' ' << contact.b << ' ' << contact.member << ' '
              << contact.part << ' ' << contact.touches << ' ' << int{contact.count};
    for (std::size_t i = 0; i < contact.count; ++i) {
      std::cout << ' ' << contact.feature[i] << ' ' << contact.pressure[i].raw();
    }
    for (const auto& impulse : contact.friction) std::cout << ' ' << impulse.raw();
    for (std::size_t i = 0; i < (N == 2 ? 1 : 3); ++i) {
      if constexpr (requires { contact.rolling; }) {
        std::cout << ' ' << contact.rolling[i].raw();
      } else {
        std::cout << " 0";
      }
    }
    std::cout << '\n';
  }
  if constexpr (World::has_joints) print_joints(detail::WorldAccess::joints(world).list);
  for (std::size_t k = 0; k < world.event_count(); ++k) {
    const auto& event = world.event(k);
    std::cout << "event " << event.a.index << ' ' << event.b.index << ' ' << event.part_a << ' '
              << event.part_b << ' ' << event.begins << '\n';
  }
  std::cout << '\n';
}

}  // namespace detent::test
