// SPDX-License-Identifier: MIT
//
// usage: corpus_states                    prints the worlds of `detent verify` as a scene file
//        corpus_states FILE NAME TICKS    prints the states of one of them, as twin_states does
//
// For run.py --scenes -. So the twin judges rows of the corpus in which no formula says what is right.
// Needs the macro SCALAR.

#include <array>
#include <cstdlib>
#include <iostream>
#include <string>
#include <type_traits>

#include "scene_text.hpp"
#include "state_text.hpp"
#include "verify/corpus.hpp"

namespace detent::test {
namespace {

using namespace verify;
using Scalar = SCALAR;

std::string text(const Scalar& x) { return ' ' + to_string(x); }
template <int N>
std::string text(const Vec<Scalar, N>& v) {
  std::string result;
  for (int i = 0; i < N; ++i) result += text(v[i]);
  return result;
}
/// The components of the axes, in multiples of 2^-30.
template <int N>
std::string text(const Rotation<Scalar, N>& rotation) {
  constexpr int shift = 30 - direction_component<Scalar>::frac;
  std::string result;
  for (int i = 0; i < N; ++i) {
    for (int k = 0; k < N; ++k) {
      result += ' ' + std::to_string(std::int64_t{rotation.axis(i)[k].raw()} * (1 << shift));
    }
  }
  return result;
}

template <int N>
std::string shape(const DrawnBody<Scalar, N>& body) {
  const auto low = nearest_to<Scalar>(body.center - body.half);
  const auto high = nearest_to<Scalar>(body.center + body.half);
  switch (body.form) {
    case Form::ball:
      return "ball" + text(body.center) + text(body.radius);
    case Form::capsule:
      return "capsule" + text(low) + text(high) + text(body.radius);
    case Form::aligned:
      return "aligned" + text(low) + text(high);
    case Form::box:
      return "box" + text(body.center) + text(body.half) + " axes" + text(body.rotation);
    case Form::hull:
      return "hull" + text(body.center) + " hull" + std::to_string(body.asset) + " axes" +
             text(body.rotation);
    default:
      return "compound" + text(body.center) + " hammer axes" + text(body.rotation);
  }
}

template <int N>
void print_body(const DrawnBody<Scalar, N>& body) {
  const auto& options = body.options;
  std::cout << "body " << (options.motion == BodyMotion::fixed ? "fixed " : "dynamic ")
            << shape(body) << " density" << text(options.density) << " friction"
            << text(options.friction) << " restitution" << text(options.restitution) << " damping"
            << text(options.linear_damping) << " spin_damping" << text(options.angular_damping)
            << " velocity" << text(options.velocity) << " spin";
  for (const auto& w : options.angular_velocity) std::cout << text(w);
  std::cout << " gravity_scale" << text(options.gravity_scale) << " locked " << int{options.locked}
            << (options.is_fast ? " fast" : "") << '\n';
}

template <class Joint>
void print_joint(const Joint& joint) {
  constexpr std::array kinds{"", "distance", "ball", "hinge", "weld", "slider", "wheel", "cone"};
  std::cout << "joint " << kinds[detent::detail::joint_tag<Joint>] << ' ' << joint.a.index << ' '
            << joint.b.index << text(joint.anchor_a) << text(joint.anchor_b)
            << (joint.collide ? " collide" : "");
  if (joint.break_force != 0) std::cout << " break" << text(joint.break_force);
  if constexpr (requires { joint.frame_a; }) {
    std::cout << " axes_a" << text(joint.frame_a) << " axes_b" << text(joint.frame_b);
  }
  if constexpr (requires { joint.least; }) {
    std::cout << " least" << text(joint.least) << " most" << text(joint.most);
  }
  if constexpr (requires { joint.length; }) std::cout << " length" << text(joint.length);
  if constexpr (requires { joint.frequency; }) {
    std::cout << " frequency" << text(joint.frequency) << " damping" << text(joint.damping_ratio);
  }
  if constexpr (requires { joint.max_force; }) {
    std::cout << " max_force" << text(joint.max_force);
  }
  if constexpr (requires { joint.has_limits; }) {
    if (joint.has_limits) std::cout << " limits" << text(joint.lower) << text(joint.upper);
  }
  if constexpr (requires { joint.cone_angle; }) std::cout << " cone" << text(joint.cone_angle);
  if constexpr (requires { joint.motor_speed; }) {
    std::cout << " motor" << text(joint.motor_speed);
    if constexpr (requires { joint.motor_torque; }) {
      std::cout << text(joint.motor_torque);
    } else {
      std::cout << text(joint.motor_force);
    }
  }
  std::cout << '\n';
}

/// What a case has besides bodies: assets before them, joints after them.
template <class Case>
void print_assets(const Case& c) {
  if constexpr (requires { c.hulls; }) {
    for (std::size_t i = 0; i < c.hulls.size(); ++i) {
      std::cout << "points hull" << i;
      for (const auto& point : as_shape(c.hulls[i]).points) std::cout << text(point);
      std::cout << '\n';
    }
    for (const auto& part : c.parts) {
      std::cout << "part hammer " << shape(part) << " density" << text(part.options.density)
                << " friction" << text(part.options.friction) << '\n';
    }
  }
}

template <class Group, int N, class Visit>
void visit_scenes(const std::string& group, const Visit& visit) {
  int number = 0;
  visit_cases<Group, Scalar, N>(full_size, [&](const auto& c) {
    visit(group + "_" + std::to_string(N) + "d_" + std::to_string(number++), c);
  });
}

template <class Group, int N>
void print_scenes(const std::string& group) {
  visit_scenes<Group, N>(group, [](const std::string& name, const auto& c) {
    std::cout << "scene " << name << ' ' << N << "\nset scalar " << Scalar::bits << ' '
              << Scalar::frac << "\nset gravity" << text(c.settings.gravity) << "\neveryday "
              << Group::ticks << '\n';
    print_assets(c);
    for (const auto& body : c.bodies) print_body(body);
    if constexpr (HasJoints<std::remove_cvref_t<decltype(c)>>) {
      c.for_each_joint([](const auto& joint) { print_joint(joint); });
    }
  });
}

template <class Group, int N>
void play(const std::string& group, const std::string& wanted, int ticks) {
  visit_scenes<Group, N>(group, [&](const std::string& name, const auto& c) {
    if (name != wanted) return;
    typename Group::template Living<Scalar, N> living(c);
    print_state<Scalar, N>(living.world);
    for (int i = 0; i < ticks; ++i) {
      living.world.step();
      print_state<Scalar, N>(living.world);
    }
  });
}

}  // namespace
}  // namespace detent::test

int main(int count, char** arguments) {
  using namespace detent::test;
  std::ios::sync_with_stdio(false);
  const auto visit = [](const auto& f) {
    f(Piles(), "pile");
    f(Linkages(), "joints");
    f(Cones(), "cones");
    f(Solids(), "solids");
  };
  if (count == 1) {
    visit([]<class Group>(Group, const char* group) {
      if constexpr (Group::template asks<2>) print_scenes<Group, 2>(group);
      print_scenes<Group, 3>(group);
    });
  } else if (count == 4) {
    const int ticks = std::atoi(arguments[3]);
    visit([&]<class Group>(Group, const char* group) {
      if constexpr (Group::template asks<2>) play<Group, 2>(group, arguments[2], ticks);
      play<Group, 3>(group, arguments[2], ticks);
    });
  } else {
    fail("usage: corpus_states [FILE NAME TICKS]");
  }
  return 0;
}
