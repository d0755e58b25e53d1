// SPDX-License-Identifier: MIT
// Four joints side by side have the bits of four one after another, or are refused.
#include "detent/dynamics/joint/four_joints.hpp"

#include <vector>

#include "detent/dynamics/dynamics.hpp"
#include "dynamics/draw.hpp"
#include "support/catch.hpp"

namespace detent::test {
namespace {

using S = q16_16;
using F = detail::Formats<S>;
using Hinge = HingeJoint<S, 3>;
using Physics = World<S, 3, Sphere, Obb>;
using Record = detail::JointRecord<S, 3, Hinge>;
using Ready = detail::ReadyJoint<S, 3, Record::push_room, Record::turn_room>;
using Joints = detail::FourJoints<S, Record::turn_room>;
using Moving = detail::Moving<S, 3>;

Vec<S, 3> draw_point(Random& random, int bits) {
  return make_vec<3>([&](int) { return draw<S>(random, bits); });
}
Rotation<S, 3> draw_rotation(Random& random) {
  const auto axis = normalize(draw_point(random, 20)).value_or(Direction<S, 3>::along(0));
  return Rotation<S, 3>::from_axis_angle(axis, Angle<S>::from_radians(draw<S>(random, 17)));
}

/// Four hinges of eight boxes, of which some are fixed.
struct Bench {
  Physics world{};
  std::vector<detail::Support<S, 3>> supports{};
  std::vector<Moving> moving{};
  std::vector<Hinge> hinges{};
  std::vector<Ready> ready{};
  std::vector<Record> records{};
  Joints joints{};

  Bench(Random& random, std::size_t size, bool has_limits, int bits) {
    for (int i = 0; i < 8; ++i) {
      BodyOptions<S, 3> options;
      if (i % 2 == 1 && random.below(4) == 0) options.motion = BodyMotion::fixed;
      const auto half = make_vec<3>([&](int) {
        return S::assume_raw(static_cast<std::int32_t>(random.between(1 << 14, 1 << 17)));
      });
      (void)world.add(Obb<S, 3>{draw_point(random, 16), half, draw_rotation(random)}, options);
    }
    const auto& bodies = detail::WorldAccess::bodies(world);
    for (std::size_t i = 0; i < 8; ++i) {
      supports.push_back(detail::support_of<S, 3>(bodies[i]));
      Moving m;
      if (bodies[i].can_move()) {
        for (int k = 0; k < 3; ++k) m.velocity[k] = draw<F::Speed>(random, bits);
        for (auto& w : m.spin) w = draw<F::Spin>(random, bits);
      }
      moving.push_back(m);
    }
    joints.size = static_cast<std::uint8_t>(size);
    for (std::size_t k = 0; k < 4; ++k) {
      const auto n = static_cast<std::uint32_t>(k < size ? k : 0);
      joints.a[k] = 2 * n;
      joints.b[k] = 2 * n + 1;
      if (k >= size) continue;
      Hinge hinge;
      hinge.anchor_a = draw_point(random, bits - 8);
      hinge.anchor_b = draw_point(random, bits - 8);
      hinge.frame_a = draw_rotation(random);
      hinge.frame_b = draw_rotation(random);
      hinge.has_limits = has_limits;
      hinge.upper = S(random.coin() ? 3 : 0);
      hinge.lower = S(random.coin() ? -3 : 0);
      Ready one;
      one.joint = one.a = joints.a[k];
      one.b = joints.b[k];
      const auto &a = bodies[one.a], &b = bodies[one.b];
      const auto [share_a, share_b] = detail::mass_shares<S>(a, b);
      one.share_a = joints.share_a[k] = share_a;
      one.share_b = joints.share_b[k] = share_b;
      joints.moves_a[k] = a.can_move();
      joints.moves_b[k] = b.can_move();
      using Body = std::remove_cvref_t<decltype(a)>;
      detail::LayOut<S, 3, Ready, Body>(one, a, b, 240)(hinge);
      REQUIRE(detail::kind_of<S>(hinge, one) != 0);
      Record record;
      for (std::size_t i = 0; i < 3; ++i) {
        record.push[i] = joints.total[i][k] = draw<F::Impulse>(random, bits);
        joints.anchor_a[i][k] = hinge.anchor_a[static_cast<int>(i)];
        joints.anchor_b[i][k] = hinge.anchor_b[static_cast<int>(i)];
      }
      detail::Aim<S, 3, Ready>(one, supports[one.a], supports[one.b])(hinge);
      for (std::size_t i = 0; i < one.turn.size(); ++i) {
        const auto& row = one.turn[i];
        auto& rows = joints.turn[i];
        rows.law = row.terms.law;
        if (rows.law == detail::Law::none) continue;
        record.turn[i] = rows.total[k] = draw<F::Turn>(random, bits);
        if (rows.law == detail::Law::limit && rows.total[k] < 0) {
          record.turn[i] = rows.total[k] = {};
        }
        rows.gap[k] = row.gap;
        for (std::size_t c = 0; c < 3; ++c) {
          rows.axis[c][k] = row.axis[c];
          rows.on_a[c][k] = row.on_a[c];
          rows.on_b[c][k] = row.on_b[c];
        }
      }
      hinges.push_back(hinge);
      ready.push_back(one);
      records.push_back(record);
    }
  }
};

/// Compares the rows of pushes and one pass. Returns whether the four were solved.
template <class L, detail::Pass pass>
bool check(Bench bench) {
  const auto start = bench.moving;
  if (!detail::aim_points<L>(bench.joints, bench.supports.data())) return false;
  for (std::size_t k = 0; k < bench.joints.size; ++k) {
    for (std::size_t i = 0; i < 3; ++i) {
      const auto& row = bench.ready[k].push[i];
      REQUIRE(bench.joints.gap[i][k] == row.gap);
      REQUIRE(bench.joints.mass[i][k] == row.row.mass);
      for (std::size_t c = 0; c < 3; ++c) {
        REQUIRE(bench.joints.response_a[i][c][k] == row.row.response_a[c]);
        REQUIRE(bench.joints.response_b[i][c][k] == row.row.response_b[c]);
      }
    }
  }
  detail::FourJointsSolver<L, S, Record::turn_room> warm(bench.joints, bench.moving.data());
  bool is_done = warm.warm_start();
  if (is_done) {
    detail::FourJointsSolver<L, S, Record::turn_room> solver(bench.joints, bench.moving.data());
    is_done = solver.template solve<pass>();
  } else {
    for (std::size_t i = 0; i < start.size(); ++i) {
      REQUIRE(bench.moving[i].velocity == start[i].velocity);
    }
  }
  if (!is_done) return false;
  auto expected = start;
  for (std::size_t k = 0; k < bench.joints.size; ++k) {
    auto& ready = bench.ready[k];
    auto& record = bench.records[k];
    auto &a = expected[ready.a], &b = expected[ready.b];
    for (std::size_t i = 0; i < record.turn.size(); ++i) {
      if (ready.turn[i].terms.law != detail::Law::none) {
        detail::apply(ready.turn[i], record.turn[i], a, b);
      }
    }
    for (std::size_t i = 0; i < 3; ++i) {
      detail::apply(ready.push[i].thrust, ready.push[i].row, record.push[i], a, b);
    }
    for (std::size_t i = 0; i < record.turn.size(); ++i) {
      if (ready.turn[i].terms.law == detail::Law::none) continue;
      detail::solve<pass>(ready.turn[i], record.turn[i], a, b);
      REQUIRE(bench.joints.turn[i].total[k] == record.turn[i]);
    }
    for (std::size_t i = 0; i < 3; ++i) {
      detail::solve<pass>(ready.push[i], record.push[i], a, b);
      REQUIRE(bench.joints.total[i][k] == record.push[i]);
    }
  }
  for (std::size_t i = 0; i < expected.size(); ++i) {
    REQUIRE(bench.moving[i].velocity == expected[i].velocity);
    REQUIRE(bench.moving[i].spin == expected[i].spin);
  }
  return true;
}

}  // namespace

TEMPLATE_TEST_CASE("joints: four at once have the bits of one after another", "",
                   detail::ArrayLongLanes, detail::FastLongLanes) {
  if (detail::may_run_vectors && !detail::runs_vectors()) return;  // compiled for AVX2
  Random random(0x101e7);
  const int rounds = DETENT_TEST_ALL ? 20'000 : 2000;
  int solved = 0;
  for (int i = 0; i < rounds; ++i) {
    const int bits = i % 2 == 0 ? 23 : static_cast<int>(random.between(24, 29));
    const Bench bench(random, 1 + random.below(4), random.coin(), bits);
    solved += check<TestType, detail::Pass::biased>(bench);
    solved += check<TestType, detail::Pass::relaxed>(bench);
  }
  CAPTURE(solved);
  CHECK(solved > 2 * rounds * 0.3);
  CHECK(solved < 2 * rounds * 0.9);
}

}  // namespace detent::test
