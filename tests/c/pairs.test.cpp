// SPDX-License-Identifier: MIT
//
// Contacts and times of impact of the C interface give the bits of C++ for every pair of kinds, on
// the cases of `verify`.

#include <tuple>
#include <utility>

#include "calls.hpp"
#include "detent/query/contact.hpp"
#include "detent/query/time_of_impact.hpp"
#include "shapes.hpp"

namespace detent {
namespace {

using S = q16_16;
using c::Output;
using test_c::Calls;

template <int N>
Direction<S, N> direction(const typename c::Types<N>::Direction& given) {
  return c::Input<N>().direction(given);
}

template <int N, class A, class B>
void check_contact(const A& a, const B& b, Share& share) {
  const auto one = in_c<N>(a), other = in_c<N>(b);
  typename c::Types<N>::Manifold found{};
  if constexpr (requires { contact(a, b); }) {
    const auto expected = contact(a, b);
    REQUIRE(Calls<N>::contact(&one, &other, &found) == c::yes_or_no(expected.has_value()));
    REQUIRE(Calls<N>::contact(&one, &other, nullptr) == c::yes_or_no(expected.has_value()));
    share.add(expected.has_value());
    if (!expected) return;
    REQUIRE(direction<N>(found.normal) == expected->normal);
    REQUIRE(found.depth == expected->depth.raw());
    REQUIRE(found.count == expected->count);
    for (std::size_t i = 0; i < expected->points.size(); ++i) {
      const auto& point = i < expected->count ? expected->points[i] : ContactPoint<S, N>();
      REQUIRE(c::Input<N>::vec(found.points[i].point) == point.point);
      REQUIRE(found.points[i].depth == point.depth.raw());
      REQUIRE(found.points[i].feature == point.feature);
    }
  } else {
    REQUIRE(Calls<N>::contact(&one, &other, &found) == DETENT_NO_QUERY);
  }
}

template <int N, class A, class B>
void check_impact(const A& a, const B& b, const Sweep<S, N>& sweep_a, const Sweep<S, N>& sweep_b,
                  Share& share) {
  const auto one = in_c<N>(a), other = in_c<N>(b);
  const auto in_c = [](const Sweep<S, N>& sweep) {
    return typename c::Types<N>::Sweep{Output<N>::vec(sweep.start), Output<N>::vec(sweep.end),
                                       Output<N>::rotation(sweep.start_rotation),
                                       Output<N>::rotation(sweep.end_rotation)};
  };
  const auto motion_a = in_c(sweep_a), motion_b = in_c(sweep_b);
  const S target = S::from_raw(8);
  const auto check = [&](const auto& expected, const auto* motion) {
    detent_impact impact{};
    REQUIRE(Calls<N>::time_of_impact(&one, &motion_a, &other, motion, 8, &impact) ==
            c::yes_or_no(expected.has_value()));
    share.add(expected.has_value());
    if (!expected) return;
    REQUIRE(impact.time == expected->time.raw());
    REQUIRE(impact.distance == expected->distance.raw());
    REQUIRE((impact.is_hit == 1) == expected->is_hit);
  };
  constexpr bool has_segment = requires { a.start; }
  || requires { b.start; };
  if constexpr (!has_segment && requires { time_of_impact(a, sweep_a, b, sweep_b); }) {
    check(time_of_impact(a, sweep_a, b, sweep_b, target), &motion_b);
  } else {
    detent_impact impact{};
    REQUIRE(Calls<N>::time_of_impact(&one, &motion_a, &other, &motion_b, 8, &impact) ==
            DETENT_NO_QUERY);
  }
  if constexpr (!has_segment && requires { time_of_impact(a, sweep_a, b, target); }) {
    check(time_of_impact(a, sweep_a, b, target), static_cast<decltype(&motion_b)>(nullptr));
  }
}

template <int N>
void check_dimension(std::uint64_t seed, int count) {
  verify::Random random(seed);
  Share contacts, impacts;
  for (int i = 0; i < count; ++i) {
    CAPTURE(N, seed, i);
    Draw<N> draw{verify::ShapeScene<S, N>(random)};
    const auto two = draw.two_of_all();
    const auto turned = draw.scene.obb(), turned_b = draw.scene.obb();
    // Poses near the origin, because the shapes already are where they meet.
    const auto step = [&](const Vec<S, N>& v) {
      return make_vec<N>([&](int k) { return S::from_raw(v[k].raw() % (4 * 65536)); });
    };
    const Sweep<S, N> sweep_a{{}, step(turned.center), {}, turned.rotation};
    const Sweep<S, N> sweep_b{step(turned_b.center), {}, turned_b.rotation, {}};
    for_each_pair(two.first, two.second,
                  [&]<std::size_t I, std::size_t J>(const auto& a, const auto& b) {
                    CAPTURE(I, J);
                    check_contact<N>(a, b, contacts);
                    check_impact<N>(a, b, sweep_a, sweep_b, impacts);
                  });
  }
  contacts.check();
  impacts.check();
}

TEST_CASE("C pairs: the bits are those of C++, in 2D") { check_dimension<2>(21, 60); }
TEST_CASE("C pairs: the bits are those of C++, in 3D") { check_dimension<3>(31, 60); }

TEST_CASE("C pairs: wrong directions and kinds are errors") {
  detent_shape3 ball{}, plane{}, point{};
  ball.kind = DETENT_SPHERE;
  plane.kind = DETENT_PLANE;
  plane.as.plane.normal.y = 1 << 30;
  point.kind = DETENT_POINT;
  detent_direction3 down{0, -(1 << 30), 0}, none{};
  detent_manifold3 contact{};
  detent_hit3 hit{};
  detent_sweep3 still{};
  CHECK(detent_contact3(&plane, &plane, &contact) == DETENT_NO_QUERY);
  CHECK(detent_contact3(&ball, &point, &contact) == DETENT_NO_QUERY);
  CHECK(detent_contact3(nullptr, &ball, &contact) == DETENT_BAD_ARGUMENT);
  CHECK(detent_cast3(&ball, &down, 1, &plane, &hit) == DETENT_OK);
  CHECK(detent_cast3(&ball, &down, 1, &ball, nullptr) == DETENT_OK);
  CHECK(detent_cast3(&ball, &none, 1, &plane, &hit) == DETENT_NOT_UNIT);
  CHECK(detent_cast3(&plane, &down, 1, &ball, &hit) == DETENT_NO_QUERY);
  CHECK(detent_cast3(&ball, &down, 1, &point, &hit) == DETENT_NO_QUERY);
  CHECK(detent_cast3(&ball, nullptr, 1, &ball, &hit) == DETENT_BAD_ARGUMENT);
  CHECK(detent_time_of_impact3(&ball, &still, &ball, nullptr, 8, nullptr) == DETENT_NOT_UNIT);
}

}  // namespace
}  // namespace detent
