// SPDX-License-Identifier: MIT
#include "detent/shape/camera_filter.hpp"

#include "detent/shape/camera.hpp"
#include "math/frames.hpp"
#include "support/catch.hpp"

namespace detent::test {
namespace {

template <Scalar S>
std::optional<Camera<S>> random_view(Random& random) {
  const auto positive = [&] { return nearest_to<S>(abs(random_fixed<S>(random))); };
  const Transform<S, 3> pose{
      random_vec<S, 3>(random),
      random.one_in(4) ? random_frame<S, 3>(random) : random_rotation<S, 3>(random), S(1)};
  const auto lens =
      random.coin()
          ? Lens<S>::perspective(
                Angle<S>::from_raw(static_cast<std::uint32_t>(random.between(1 << 26, 1 << 30))),
                S(static_cast<int>(random.between(1, 2))), S::from_raw(1), largest<S>)
          : Lens<S>::orthographic(positive(), positive(), S(0), largest<S>);
  if (!lens) return std::nullopt;
  return Camera<S>{pose, *lens};
}

template <class T, class S>
bool is_same(const detail::SeenPoint<T, S>& found,
             const std::optional<ScreenPoint<T, S>>& expected) {
  if (found.is_seen == Filtered::no) return !expected;
  return expected && found.x == expected->x && found.y == expected->y &&
         found.depth == expected->depth;
}

/// The exact screen coordinates.
template <class T, Scalar S>
std::optional<ScreenPoint<T, S>> exactly(const Camera<S>& camera, const Vec<S, 3>& point) {
  return detail::exact_project<T>(
      camera, point, [](const auto& x, const auto& w, const auto& y, const auto& h) {
        return Vec<T, 2>{quotient_nearest<T>(x, w), quotient_nearest<T>(y, h)};
      });
}
template <class T, Scalar S>
detail::SeenPoint<T, S> by_filter(const Camera<S>& camera, const Vec<S, 3>& point) {
  using Size = Fixed<1, 0>;
  return detail::decide_project<T, false>(camera.pose.rotation, camera.lens,
                                          point - camera.pose.translation,
                                          Vec<Size, 2>{Size(1), Size(1)}, Vec<Size, 2>{});
}

}  // namespace

TEMPLATE_TEST_CASE("camera filters: where they are sure, they are right", "", q16_16, q24_8,
                   q14_16) {
  using S = TestType;
  Random random(0xca3f17);
  int cameras = 0, unsure = 0, wrong = 0, rays = 0, unsure_rays = 0, guesses = 0, pixels = 0;
  for (int k = 0; k < 20'000; ++k) {
    const auto camera = random_view<S>(random);
    if (!camera) continue;
    ++cameras;
    // Most points are close to what the camera looks at.
    const auto x = S::from_raw(static_cast<typename S::raw_type>(random.wide(S::frac + 1))),
               y = S::from_raw(static_cast<typename S::raw_type>(random.wide(S::frac + 1)));
    const auto point = random.one_in(4) ? random_vec<S, 3>(random)
                                        : unproject(*camera, x, y, random_fixed<S>(random));
    const auto seen = by_filter<S>(*camera, point);
    if (seen.is_seen == Filtered::unsure) {
      ++unsure;
    } else if (!is_same(seen, exactly<S>(*camera, point))) {
      ++wrong;
    }
    if (!camera->lens.has_perspective()) continue;
    ++rays;
    const auto unit =
        detail::decide_direction(camera->pose.rotation, camera->lens, x, y, detail::one<S>);
    const auto count_wrong = [&](const auto& found, const auto& at) {
      const auto exact = detail::exact_pick_ray(*camera, at);
      for (std::size_t i = 0; i < 3; ++i) {
        if (found.value[i] != exact.direction[static_cast<int>(i)]) ++wrong;
      }
    };
    const detail::OnScreen on_screen{x, y, detail::one<S>};
    const auto count_guess = [&](const S& u, const S& v) {
      const auto guess = detail::guess_direction(camera->pose.rotation, camera->lens, u, v);
      if (!guess.is_sure) return;
      ++guesses;
      count_wrong(guess, detail::OnScreen{u, v, detail::one<S>});
      if (abs(u) > 1 || abs(v) > 1) ++wrong;
    };
    count_guess(x, y);
    const auto in_image = [&] {
      const auto limit = std::int64_t{1} << S::frac;
      return S::from_raw(static_cast<typename S::raw_type>(random.between(-limit, limit)));
    };
    for (int n = 0; n < 4; ++n) count_guess(in_image(), in_image());
    if (unit.is_sure) {
      count_wrong(unit, on_screen);
    } else {
      ++unsure_rays;
    }
    const Viewport viewport{static_cast<std::int32_t>(random.between(1, 4000)),
                            static_cast<std::int32_t>(random.between(1, 4000))};
    const auto pixel = detail::on_screen<S>(
        viewport, static_cast<std::int32_t>(random.between(-9, viewport.width + 9)),
        static_cast<std::int32_t>(random.between(-9, viewport.height + 9)));
    const auto of_pixel = detail::decide_direction<true>(camera->pose.rotation, camera->lens,
                                                         pixel.x, pixel.y, pixel.unit);
    if (of_pixel.is_sure) {
      ++pixels;
      count_wrong(of_pixel, pixel);
    }
  }
  INFO(random);
  CHECK(wrong == 0);
  CHECK(cameras > 5'000);
  CHECK(unsure > cameras / 100);
  CHECK(unsure < cameras * 2 / 3);
  CHECK(unsure_rays < rays / 10);
  CHECK(guesses > rays / 20);
  CHECK(pixels > rays / 20);
}

TEST_CASE("camera filters: ties are left to the exact quotient") {
  using S = q16_16;
  using Component = direction_component<S>;
  // x is tilted towards z by 2^-15: depth = x / 2^15 - z, and the volume of the axes is 1.
  const auto tilted = Direction<S, 3>::from_raw({1 << 30, 0, 1 << 15});
  REQUIRE(tilted);
  static_assert(Component::frac == 30);
  const auto frame =
      Rotation<S, 3>::from_axes({*tilted, Direction<S, 3>::along(1), Direction<S, 3>::along(2)});
  const auto lens = Lens<S>::perspective(Angle<S>::turn(1, 4), S(1), S(1), S(100));
  REQUIRE(lens);
  const Camera<S> camera{Transform<S, 3>{Vec<S, 3>{}, frame, S(1)}, *lens};
  const auto at = [](int x, int y, int z) {
    return Vec<S, 3>{S::from_raw(x), S::from_raw(y), S::from_raw(z)};
  };
  for (int z = 1'000'000; z < 1'000'004; ++z) {
    const auto tie = at(1 << 14, 0, -z);
    CHECK(by_filter<S>(camera, tie).is_seen == Filtered::unsure);
    CHECK(project(camera, tie)->depth.raw() == z + z % 2);
    CHECK(by_filter<S>(camera, at((1 << 14) + 1, 0, -z)).is_seen == Filtered::yes);
  }
  // Half a step of x and y at a depth of 2.
  const Camera<S> plain{Transform<S, 3>{}, *lens};
  const auto close = at(1, 3, -(2 << 16));
  CHECK(by_filter<S>(plain, close).is_seen == Filtered::unsure);
  CHECK(project(plain, close)->x.raw() == 0);
  CHECK(project(plain, close)->y.raw() == 2);
  CHECK(by_filter<S>(plain, at(2, 4, -(2 << 16))).is_seen == Filtered::yes);
}

TEST_CASE("camera filters: points beside the eye, skewed axes and far points are left to them") {
  using S = q16_16;
  const auto lens = Lens<S>::perspective(Angle<S>::turn(1, 4), S(1), S(1), S(100));
  const Camera<S> plain{Transform<S, 3>{}, *lens};
  const auto seen = [&](const Camera<S>& camera, int x, int z) {
    return by_filter<S>(camera, Vec<S, 3>{S::from_raw(x), S(0), S::from_raw(z)}).is_seen;
  };
  CHECK(seen(plain, 0, 0) == Filtered::unsure);
  CHECK(seen(plain, 1, -100) == Filtered::unsure);
  CHECK(seen(plain, 1, 1) == Filtered::no);
  CHECK(seen(plain, 1, -1000) == Filtered::yes);
  CHECK(seen(plain, 1 << 30, -1000) == Filtered::unsure);
  using D = Direction<S, 3>;
  const auto skewed = [&](const D& x) {
    return Camera<S>{
        Transform<S, 3>{Vec<S, 3>{}, Rotation<S, 3>::from_axes({x, D::along(1), D::along(2)}),
                        S(1)},
        *lens};
  };
  CHECK(seen(skewed(*normalize(Vec<S, 3>{S(100), S(0), S(1)})), 1, -1000) == Filtered::unsure);
  CHECK(seen(skewed(-D::along(0)), 1, -1000) == Filtered::unsure);
  const auto aside =
      detail::decide_direction(plain.pose.rotation, plain.lens, S(5), S(0), detail::one<S>);
  CHECK_FALSE(aside.is_sure);
}

}  // namespace detent::test
