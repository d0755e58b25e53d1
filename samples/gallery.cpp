// SPDX-License-Identifier: MIT
//
// The gallery. It includes the samples with bodies in 3D, because they share a world and compile
// faster as one source than as three. queries.cpp and flat.cpp do the same for others; a compiler
// does not have the memory for all of them at once.
#include "gallery.hpp"

#include "pyramid.cpp"
#include "ragdolls.cpp"
#include "vehicle.cpp"

namespace samples {

extern const Entry rays, character, cloth_sample, culling, rollback, replay, micro;

std::span<const Entry* const> gallery() {
  static constexpr std::array all{&rays,         &character, &pyramid,  &ragdolls, &vehicle,
                                  &cloth_sample, &culling,   &rollback, &replay,   &micro};
  return all;
}

const Entry* find(const std::string& name) {
  for (const Entry* each : gallery()) {
    if (name == each->name) return each;
  }
  return nullptr;
}

std::array<float, 16> matrix(const View& view, float aspect) {
  using Float3 = std::array<float, 3>;
  const auto minus = [](const Float3& a, const Float3& b) {
    return Float3{a[0] - b[0], a[1] - b[1], a[2] - b[2]};
  };
  const auto dot3 = [](const Float3& a, const Float3& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  };
  const auto unit = [&](const Float3& a) {
    const float size = std::sqrt(dot3(a, a));
    return Float3{a[0] / size, a[1] / size, a[2] / size};
  };
  const Float3 back = minus(view.eye, view.target), z = unit(back);
  const Float3 x = unit({z[2], 0, -z[0]});  // y is up
  const Float3 y{z[1] * x[2] - z[2] * x[1], z[2] * x[0] - z[0] * x[2], z[0] * x[1] - z[1] * x[0]};
  const float range = std::sqrt(dot3(back, back));
  // Narrow windows show more, so that the whole scene stays visible.
  const float room = aspect < 1.5f ? 1.5f / aspect : 1.0f;
  const float scale = 2 * range / (view.height * room);
  const float nearest = range / 64, farthest = range * 16;
  const float a = (farthest + nearest) / (nearest - farthest);
  const float b = 2 * farthest * nearest / (nearest - farthest);
  std::array<float, 16> m{};
  const std::array<Float3, 4> rows{
      Float3{x[0] * scale / aspect, x[1] * scale / aspect, x[2] * scale / aspect},
      Float3{y[0] * scale, y[1] * scale, y[2] * scale}, Float3{z[0] * a, z[1] * a, z[2] * a},
      Float3{-z[0], -z[1], -z[2]}};
  for (std::size_t row = 0; row < 4; ++row) {
    for (std::size_t i = 0; i < 3; ++i) m[4 * i + row] = rows[row][i];
    m[12 + row] = -dot3(rows[row], view.eye) + (row == 2 ? b : 0);
  }
  return m;
}

}  // namespace samples
