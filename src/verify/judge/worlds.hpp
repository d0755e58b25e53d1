// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "oracle/meet.hpp"
#include "verify/describe_worlds.hpp"
#include "verify/judge/exact.hpp"

// The final state of bodies depends on very many roundings. The judge checks properties of every
// correct world: bodies do not pass through each other, momentum is conserved, joints hold, and
// snapshots change nothing. The twin in tests/dynamics/twin computes every bit of the same worlds.

namespace detent::verify::judge {

template <Number T>
T halved(const T& x) {
  return T::from_raw(static_cast<typename T::raw_type>(x.raw() / 2));
}
template <Number T, int N>
Vec<T, N> halved(const Vec<T, N>& v) {
  return make_vec<N>([&](int i) { return halved(v[i]); });
}

/// A body or a part of one, half as large about its center, in `frame`.
template <Scalar S, int N>
oracle::Solid<N> core_of(const DrawnBody<S, N>& body, const HullPoints<S, N>& hull,
                         const Transform<S, N>& frame, bool is_part) {
  const auto at = is_part ? body.center : Vec<S, N>();
  const auto turn = is_part ? body.rotation : Rotation<S, N>();
  const auto half = halved(body.half);
  const auto radius = halved(body.radius);
  switch (body.form) {
    case Form::ball:
      return oracle::exact(placed(frame, Sphere<S, N>{at, radius}));
    case Form::capsule:
      return oracle::exact(placed(frame, Capsule<S, N>{nearest_to<S>(-half), half, radius}));
    case Form::hull: {
      HullPoints<S, N> points;
      points.count = hull.count;
      oracle::Raw<N> middle{};
      for (int k = 0; k < hull.count; ++k) {
        for (int i = 0; i < N; ++i) {
          middle[static_cast<std::size_t>(i)] +=
              static_cast<std::int64_t>(hull.points[static_cast<std::size_t>(k)][i].raw());
        }
      }
      const Transform<S, N> own{at, turn, S(1)};
      for (std::size_t k = 0; k < hull.count; ++k) {
        const auto point = make_vec<N>([&](int i) {
          const auto mean = middle[static_cast<std::size_t>(i)] / hull.count;
          return S::from_raw(
              static_cast<typename S::raw_type>(mean + (hull.points[k][i].raw() - mean) / 2));
        });
        points.points[k] = transform_point(frame, transform_point(own, point));
      }
      return oracle::exact(as_shape(points));
    }
    default:
      return oracle::exact(placed(frame, Obb<S, N>{at, half, turn}));
  }
}

/// Which bodies overlap deeply: where their cores meet.
template <std::size_t Count, int N>
std::string overlap_of(const std::array<std::vector<oracle::Solid<N>>, Count>& cores,
                       std::size_t fixed) {
  for (std::size_t i = 0; i < Count; ++i) {
    for (std::size_t j = std::max(i + 1, fixed); j < Count; ++j) {
      for (const auto& a : cores[i]) {
        for (const auto& b : cores[j]) {
          if (oracle::meet(a, b)) {
            return "body " + std::to_string(i) + " outside of body " + std::to_string(j);
          }
        }
      }
    }
  }
  return "";
}

/// What is wrong with bodies that fell into a pit, or nothing.
template <Scalar S, int N, std::size_t Count>
std::string fault_of(const WorldCase<S, N, Count>& c, const Played<S, N, Count>& got) {
  std::array<std::vector<oracle::Solid<N>>, Count> cores;
  for (std::size_t i = 0; i < Count; ++i) {
    const auto& frame = got.bodies[i].frame;
    cores[i] = {core_of(c.bodies[i], {}, frame, false)};
    if (c.bodies[i].options.motion == BodyMotion::fixed) continue;
    for (int k = 0; k < N; ++k) {
      const auto x = 8 * static_cast<std::int64_t>(frame.translation[k].raw()) >> S::frac;
      const bool is_inside = k == 1 ? 0 <= x && x < 128 : -20 <= x && x < 20;
      if (!is_inside) return "body " + std::to_string(i) + " in the pit";
    }
  }
  return overlap_of<Count, N>(cores, Count - Piles::falling);
}

/// What is wrong with hulls and compounds that fell onto a slope, or nothing.
template <Scalar S, int N>
std::string fault_of(const SolidsCase<S, N>& c, const Played<S, N, 6>& got) {
  std::array<std::vector<oracle::Solid<N>>, 6> cores;
  for (std::size_t i = 0; i < cores.size(); ++i) {
    const auto& body = c.bodies[i];
    const auto& frame = got.bodies[i].frame;
    if (body.form == Form::compound) {
      for (const auto& part : c.parts) {
        cores[i].push_back(core_of(part, c.hulls[0], frame, true));
      }
    } else {
      cores[i] = {core_of(body, c.hulls[body.asset], frame, false)};
    }
  }
  return overlap_of<6, N>(cores, 1);
}

/// Whether b is in the cone of a joint, or leaves it by less than a quarter of a radian.
template <Scalar S>
bool is_in_cone(const ConeJoint<S, 3>& joint, const Rotation<S, 3>& a, const Rotation<S, 3>& b) {
  const auto axis_of = [](const Rotation<S, 3>& body, const Rotation<S, 3>& frame) {
    std::array<double, 3> axis{};
    for (int i = 0; i < 3; ++i) {
      for (int k = 0; k < 3; ++k) {
        axis[static_cast<std::size_t>(k)] +=
            static_cast<double>(frame.axis(2)[i]) * static_cast<double>(body.axis(i)[k]);
      }
    }
    return axis;
  };
  if (joint.cone_angle == 0) return true;
  const auto u = axis_of(a, joint.frame_a), v = axis_of(b, joint.frame_b);
  const double cosine = u[0] * v[0] + u[1] * v[1] + u[2] * v[2];
  return cosine >= std::cos(static_cast<double>(joint.cone_angle) + 0.25);
}

/// What is wrong with joined boxes without external forces, or nothing.
template <HasJoints Case, Scalar S, int N, std::size_t Count>
std::string fault_of(const Case& c, const Played<S, N, Count>& got) {
  for (int k = 0; k < N; ++k) {
    // In raw numbers: exact masses times velocities. Velocities are rounded to the scalar's grid,
    // and roundings in the solver change them by a few more steps.
    Integer before = 0, after = 0, masses = 0;
    for (std::size_t i = 0; i < got.bodies.size(); ++i) {
      const auto& body = c.bodies[i];
      Integer mass = static_cast<std::int64_t>(body.options.density.raw());
      for (int j = 0; j < N; ++j) mass *= static_cast<std::int64_t>(body.half[j].raw());
      masses += mass;
      before += mass * static_cast<std::int64_t>(body.options.velocity[k].raw());
      after += mass * static_cast<std::int64_t>(got.bodies[i].velocity[k].raw());
    }
    if (abs(after - before) > 4 * masses) return "the momentum of the start along each axis";
  }
  std::string fault;
  std::uint32_t number = 0;
  c.for_each_joint([&]<class Joint>(const Joint& joint) {
    const auto index = number++;
    constexpr bool is_cone = requires { joint.cone_angle; };
    // Springs and sliders have no fixed distance.
    if constexpr (is_cone || std::is_same_v<Joint, HingeJoint<S, N>> ||
                  std::is_same_v<Joint, WeldJoint<S, N>>) {
      const auto at = [&](std::uint32_t body, const Vec<S, N>& anchor) {
        return oracle::raw(transform_point(got.bodies[body].frame, anchor));
      };
      const auto gap =
          oracle::difference(at(joint.a.index, joint.anchor_a), at(joint.b.index, joint.anchor_b));
      const auto most = std::int64_t{1} << (S::frac - 3);
      for (const auto& x : gap) {
        if (abs(Integer(x)) > most) fault = "joint " + std::to_string(index) + " together";
      }
    }
    if constexpr (is_cone) {
      const auto turn_of = [&](const BodyId& id) { return got.bodies[id.index].frame.rotation; };
      if (!is_in_cone(joint, turn_of(joint.a), turn_of(joint.b))) {
        fault = "the axis of joint " + std::to_string(index) + " in its cone";
      }
    }
  });
  return fault;
}

template <int Row, Scalar S, int N, std::size_t Count, class Case>
requires std::is_base_of_v<WorldCase<S, N, Count>, Case> std::optional<Wrong> judge(
    const Case& c, const Played<S, N, Count>& got) {
  const auto fault = fault_of(c, got);
  if (!fault.empty()) return Wrong{fault, words(got)};
  if (got.ended > got.began) return Wrong{"no more ends than beginnings", words(got)};
  return std::nullopt;
}
template <int Row, class Case>
std::optional<Wrong> judge(const Case&, const Replayed& got) {
  const bool is_right = static_cast<Restored>(got.restored) == Restored::yes &&
                        got.loaded == got.saved && got.again == got.later;
  if (is_right) return std::nullopt;
  return Wrong{"restored, with the digests of before", words(got)};
}

}  // namespace detent::verify::judge
