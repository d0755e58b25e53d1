// SPDX-License-Identifier: MIT
//
// Scenes of the C interface in 2D, and their differences.

#include <array>
#include <string>

#include "detent/scene/difference.hpp"
#include "scene_twins.hpp"

namespace detent::test_c {
namespace {

using Twins = SceneTwins<2>;

/// The first difference of the scene from another, a line.
std::string difference(const Twins& twins, detent_handle other) {
  std::array<char, 200> text{};
  std::uint32_t size = 0;
  const auto status =
      detent_scene2_diff(&twins.context, twins.scene, other, 1, text.data(), text.size(), &size);
  REQUIRE(status == c::yes_or_no(size != 0));
  return {text.data(), size};
}

TEST_CASE("C scenes: histories give the bits of C++, in 2D") { check_history<2>(8, 12); }

TEST_CASE("C scenes: frames move what is in them, and differences are named, in 2D") {
  Twins twins;
  auto* const context = &twins.context;
  const Transform<S, 2> first{at<2>(3 * one, one), Rotation<S, 2>::from_angle(Angle<S>::turn(1, 8)),
                              S(1)};
  const auto id = check_frames(twins, first, {at<2>(0, one), {}, S(2)}).last;

  detent_handle other = 0;
  REQUIRE(detent_scene2_create(context, &other) == DETENT_OK);
  const auto saved = twins.saved();
  REQUIRE(detent_scene2_restore(context, other, saved.data(),
                                static_cast<std::uint32_t>(saved.size())) == DETENT_OK);
  CHECK(difference(twins, other).empty());
  const detent_traits changed{99, 1, DETENT_MOVING, {}};
  REQUIRE(detent_scene2_set_traits(context, other, id, &changed) == DETENT_OK);
  auto twin = twins.twin;
  REQUIRE(twin.set_user(id_of(id), 99));
  const auto named = detent::diff(twins.twin, twin);
  REQUIRE(named.has_value());
  const auto expected = std::string(named->field.view()) + "\n";
  CHECK(difference(twins, other) == expected);
  CHECK(expected.find("user") != std::string::npos);
  CHECK(detent_scene2_destroy(context, other) == DETENT_OK);
}

}  // namespace
}  // namespace detent::test_c
