// SPDX-License-Identifier: MIT
#include "detent/query/overlaps/obb_obb.hpp"

#include "oracle/pair_exam.hpp"

namespace detent::oracle {
namespace {

template <Scalar S, int N>
void examine(std::uint64_t seed, long count) {
  // Frames with repeated axes, so that even all axes together may not span space.
  const auto more = [count](auto& exam, auto& draw, auto& random) {
    exam.family("flat", count * 2 / 10, 10, 70, [&] {
      auto setting = draw_setting(draw, Kind::lattice, 0);
      const auto kinds = random.between(1, N);
      const auto box = [&] {
        std::array<Direction<S, N>, N> axes;
        for (auto& axis : axes) {
          const auto kind = static_cast<std::size_t>(random.between(0, kinds - 1));
          axis = draw.stretched(setting.frame.axes[kind], setting.frame.norm);
          if (random.coin()) axis = -axis;
        }
        auto result = draw_shape<Obb<S, N>>(draw, setting);
        auto center = setting.center;
        for (std::size_t i = 0; i < draw.size; ++i) {
          const auto steps =
              random.one_in(3) || static_cast<std::int64_t>(i) < kinds ? random.between(-2, 2) : 0;
          center = draw.plus(center, setting.frame.axes[i], setting.stride * steps);
        }
        result.center = draw.vec(random.one_in(6) ? draw.near(center, 1) : center);
        result.rotation = Rotation<S, N>::from_axes(axes);
        return result;
      };
      const auto a = box(), b = box();
      return std::pair{a, b};
    });
  };
  examine_pair<Obb<S, N>, Obb<S, N>>(seed, count, Aim{}, more);
}

DETENT_ORACLE_TEST("OBB and OBB", 0x0bb0bb, pair_cases / 8, pair_cases / 8)

}  // namespace
}  // namespace detent::oracle
