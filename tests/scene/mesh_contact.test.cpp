// SPDX-License-Identifier: MIT
#include "detent/scene/mesh/contact.hpp"

#include <algorithm>
#include <array>
#include <vector>

#include "detent/scene/height_field.hpp"
#include "detent/scene/mesh.hpp"
#include "oracle/describe.hpp"
#include "oracle/hull.hpp"
#include "query/raycast/helpers.hpp"
#include "scene/mesh_helpers.hpp"

namespace detent::test {
namespace {

template <Scalar S>
using Triangles = std::vector<Triangle<S, 3>>;

template <Scalar S, class Surface, class Shape>
std::vector<MeshContact<S>> contacts_of(const Surface& surface, const Shape& shape, Facing facing) {
  std::vector<MeshContact<S>> found(64);
  found.resize(std::min(contacts(surface, shape, std::span(found), facing), found.size()));
  return found;
}

/// Adds a sheet of 2 n^2 triangles from `corner` along u and v, n steps of each, with the front on
/// the side of u x v. Every other square is split along the other diagonal.
template <Scalar S>
void add_sheet(Triangles<S>& triangles, const std::array<int, 3>& corner,
               const std::array<int, 3>& u, const std::array<int, 3>& v, int n) {
  const auto place = [&](int i, int j) {
    return at<S, 3>(corner[0] + i * u[0] + j * v[0], corner[1] + i * u[1] + j * v[1],
                    corner[2] + i * u[2] + j * v[2]);
  };
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      const auto a = place(i, j), b = place(i + 1, j), c = place(i + 1, j + 1), d = place(i, j + 1);
      if ((i + j) % 2 == 0) {
        triangles.push_back({a, b, c});
        triangles.push_back({a, c, d});
      } else {
        triangles.push_back({a, b, d});
        triangles.push_back({b, c, d});
      }
    }
  }
}

/// Visits a ball, a capsule, boxes and a hull whose lowest points are at about `low`, small and
/// large compared with a square of the sheets.
template <Scalar S, class Visit>
void visit_sliders(const Vec<S, 3>& low, const Visit& visit) {
  for (const double size : {0.25, 1.5}) {
    const auto lifted = [&](double x, double y, double z) {
      return nearest_to<S>(low + at<S, 3>(size * x, size * y, size * z));
    };
    visit(Sphere<S, 3>{lifted(0, 1, 0), num<S>(size)});
    visit(Capsule<S, 3>{lifted(-1, 1, 0), lifted(1, 1, 0.5), num<S>(size)});
    visit(Capsule<S, 3>{lifted(0, 1, 0), lifted(0, 3, 0), num<S>(size)});
    visit(Aabb<S, 3>{lifted(-1, 0, -1), lifted(1, 2, 1)});
    visit(Obb<S, 3>{lifted(0, 1, 0), filled<S, 3>(num<S>(size)), {}});
    const std::array corners{lifted(-1, 0, -1), lifted(1, 0, -1), lifted(0, 0, 1), lifted(0, 2, 0)};
    visit(ConvexHull<S, 3>{corners});
  }
}

/// Positions of a sliding shape: over the inner squares of a sheet, along its lines and across
/// them.
template <Scalar S, class Visit>
void visit_places(const Visit& visit) {
  Random random(0x5147de);
  for (int step = 0; step < 60; ++step) {
    const double i = static_cast<double>(random.between(0, 16)) / 8;
    const double j = step % 3 == 0 ? i : static_cast<double>(random.between(0, 16)) / 8;
    visit(1 + i, 1 + j);
  }
}

TEMPLATE_TEST_CASE("mesh contacts: a tessellated plane gives only the plane's normal", "[mesh]",
                   DETENT_SLOW_SCALARS) {
  using S = TestType;
  for (const auto facing : {Facing::both, Facing::front}) {
    for (const auto& sides : {std::pair{std::array{0, 0, 2}, std::array{2, 0, 0}},
                              std::pair{std::array{0, 0, 5}, std::array{4, 3, 0}}}) {
      const auto& u = sides.first;
      const auto& v = sides.second;
      Triangles<S> triangles;
      add_sheet<S>(triangles, {-2, 0, -2}, u, v, 4);
      const auto owned = mesh_of(triangles);
      const auto mesh = owned.view();
      const auto up = normalize(at<S, 3>(-v[1], v[0], 0)).value();
      visit_places<S>([&](double i, double j) {
        const auto place = at<S, 3>(-2 + i * u[0] + j * v[0], i * u[1] + j * v[1] - 0.03125,
                                    -2 + i * u[2] + j * v[2]);
        visit_sliders(place, [&](const auto& shape) {
          const Plane<S, 3> plane{up, nearest_to<S>(dot(up, at<S, 3>(-2, 0, -2)))};
          const auto truth = contact(plane, shape);
          REQUIRE(truth);
          const auto found = contacts_of<S>(mesh, shape, facing);
          REQUIRE(!found.empty());
          S deepest = S(0);
          for (const auto& each : found) {
            CHECK(each.contact.normal == up);
            CHECK(each.contact.count > 0);
            deepest = std::max(deepest, each.contact.depth);
          }
          CHECK(deepest >= moved(truth->depth, -1));
          CHECK(deepest <= moved(truth->depth, 1));
        });
      });
    }
  }
}

TEMPLATE_TEST_CASE("mesh contacts: small cells of flat terrain give only its normal", "[mesh]",
                   DETENT_SLOW_SCALARS) {
  using S = TestType;
  constexpr std::uint32_t side = 25;  // samples
  const std::vector<S> heights(side * side, S(0));
  for (const double cell : {0.5, 0.125}) {
    const S corner = num<S>(-12 * cell);
    const auto field = height_field(Vec<S, 2>{corner, corner}, num<S>(cell), side, side,
                                    std::span<const S>(heights));
    REQUIRE(field);
    for (int i = 0; i < 16; ++i) {
      const auto place = at<S, 3>(cell * i / 16, 1 - 0.0625, cell * (i * 5 % 16) / 16);
      const auto found = contacts_of<S>(*field, Sphere<S, 3>{place, S(1)}, Facing::front);
      REQUIRE(!found.empty());
      for (const auto& each : found) CHECK(each.contact.normal == Direction<S, 3>::along(1));
    }
  }
}

/// The floor on both sides of a strip from x = 0 to `width`, with the front above.
template <Scalar S>
Triangles<S> floor_with_strip(const S& width) {
  Triangles<S> triangles;
  const auto add_strip = [&](const S& from, const S& to) {
    const S z = S(8), low = S(-8);
    triangles.push_back({{from, {}, low}, {from, {}, z}, {to, {}, low}});
    triangles.push_back({{to, {}, low}, {from, {}, z}, {to, {}, z}});
  };
  add_strip(S(-8), S(0));
  add_strip(S(0), width);
  add_strip(width, S(8));
  return triangles;
}

TEST_CASE("mesh contacts: a narrow strip in a floor gives only its normal", "[mesh]") {
  using S = q16_16;
  for (const int ulps : {256, 16, 8}) {
    const auto owned = mesh_of(floor_with_strip(S::from_raw(ulps)));
    const auto mesh = owned.view();
    for (int i = -40; i < 40; ++i) {
      const Sphere<S, 3> ball{at<S, 3>(i / 80.0, 0.9375, 0), S(1)};
      for (const auto facing : {Facing::front, Facing::both}) {
        const auto found = contacts_of<S>(mesh, ball, facing);
        REQUIRE(!found.empty());
        for (const auto& each : found) CHECK(each.contact.normal == Direction<S, 3>::along(1));
      }
    }
  }
}

TEMPLATE_TEST_CASE("mesh contacts: over a ridge the normal turns from one side to the other",
                   "[mesh]", DETENT_SLOW_SCALARS) {
  using S = TestType;
  Triangles<S> triangles;
  add_sheet<S>(triangles, {-8, -8, -4}, {0, 0, 2}, {2, 2, 0}, 4);
  add_sheet<S>(triangles, {0, 0, -4}, {0, 0, 2}, {2, -2, 0}, 4);
  const auto owned = mesh_of(triangles);
  const auto mesh = owned.view();
  auto least = num<S>(-1);
  int steps = 0;
  for (double x = -2; x <= 2; x += 0.0625, ++steps) {
    const double away = x < 0 ? -x : x;
    // Just touching: above a side, or above the ridge.
    const double y = away < 0.6875 ? 0.953125 - away * away / 2 : 1.375 - away;
    const Sphere<S, 3> ball{at<S, 3>(x, y, 0.25), num<S>(1)};
    const auto found = contacts_of<S>(mesh, ball, Facing::both);
    for (const auto& each : found) {
      const auto n = each.contact.normal;
      CHECK(n[1] >= toward<S, 3>(1, 1)[1]);
      CHECK(abs(n[2]) <= S::from_raw(16));
      CHECK(nearest_to<S>(n[0]) >= moved(least, -2));
      least = std::max(least, nearest_to<S>(n[0]));
    }
    if (x > -0.5 && x < 0.5) CHECK(!found.empty());
  }
  CHECK(least >= num<S>(0.5));
  CHECK(steps > 60);
}

TEMPLATE_TEST_CASE("mesh contacts: a valley gives the normals of both sides and no other", "[mesh]",
                   DETENT_SLOW_SCALARS) {
  using S = TestType;
  Triangles<S> triangles;
  add_sheet<S>(triangles, {-8, 8, -4}, {0, 0, 2}, {2, -2, 0}, 4);
  add_sheet<S>(triangles, {0, 0, -4}, {0, 0, 2}, {2, 2, 0}, 4);
  const auto owned = mesh_of(triangles);
  const auto mesh = owned.view();
  const auto right = toward<S, 3>(1, 1), left = toward<S, 3>(-1, 1);
  int both = 0;
  for (double x = -1; x <= 1; x += 0.0625) {
    visit_sliders(at<S, 3>(x, 0.375, 0.125), [&](const auto& shape) {
      bool is_right = false, is_left = false;
      for (const auto& each : contacts_of<S>(mesh, shape, Facing::front)) {
        const auto n = each.contact.normal;
        INFO(oracle::describe(shape)
             << " normal " << static_cast<double>(n[0]) << " " << static_cast<double>(n[1]) << " "
             << static_cast<double>(n[2]) << " of triangle " << each.triangle << " depth "
             << static_cast<double>(each.contact.depth));
        CHECK((n == right || n == left));
        is_right = is_right || n == right;
        is_left = is_left || n == left;
      }
      both += is_right && is_left;
    });
  }
  CHECK(both > 20);
}

TEMPLATE_TEST_CASE("mesh contacts: the walls of a box do not push what lies on its top", "[mesh]",
                   DETENT_SLOW_SCALARS) {
  using S = TestType;
  Triangles<S> triangles;
  add_sheet<S>(triangles, {-2, 0, -2}, {0, 0, 2}, {2, 0, 0}, 2);  // top
  add_sheet<S>(triangles, {2, 0, -2}, {0, 0, 2}, {0, -2, 0}, 2);  // wall at x = 2
  const auto owned = mesh_of(triangles);
  const auto mesh = owned.view();
  const auto up = toward<S, 3>(0, 1);
  for (double x = 1; x <= 2; x += 0.03125) {
    const Sphere<S, 3> ball{at<S, 3>(x, 0.9375, 0), num<S>(1)};
    const auto found = contacts_of<S>(mesh, ball, Facing::both);
    REQUIRE(!found.empty());
    for (const auto& each : found) CHECK(each.contact.normal == up);
  }
  // Beyond the edge the normal leans outward.
  const auto beyond =
      contacts_of<S>(mesh, Sphere<S, 3>{at<S, 3>(2.25, 0.5, 0), num<S>(1)}, Facing::both);
  REQUIRE(!beyond.empty());
  CHECK(beyond.front().contact.normal[0] > 0);
}

TEMPLATE_TEST_CASE("mesh contacts: a height field pushes up what is below it", "[mesh]",
                   DETENT_SLOW_SCALARS) {
  using S = TestType;
  Random random(0xf1e1d);
  std::vector<S> heights(81);
  for (auto& height : heights) height = num<S>(static_cast<double>(random.between(0, 16)) / 8);
  const auto field =
      height_field(Vec<S, 2>{num<S>(-8), num<S>(-8)}, num<S>(2), 9, 9, std::span<const S>(heights));
  REQUIRE(field);
  int met = 0;
  for (int i = 0; i < 200; ++i) {
    const auto place = at<S, 3>(static_cast<double>(random.between(-48, 48)) / 8,
                                static_cast<double>(random.between(-8, 24)) / 8,
                                static_cast<double>(random.between(-48, 48)) / 8);
    std::array<MeshContact<S>, 32> found;
    const auto count = contacts(*field, Sphere<S, 3>{place, num<S>(1)}, std::span(found));
    REQUIRE(count <= found.size());
    met += count > 0;
    for (std::size_t k = 0; k < count; ++k) CHECK(found[k].contact.normal[1] > 0);
  }
  CHECK(met > 60);
}

TEMPLATE_TEST_CASE("mesh contacts: sorted, counted, and complete where the shape touches", "[mesh]",
                   DETENT_SLOW_SCALARS) {
  using S = TestType;
  HitRate rate;
  for_meshes<S>(0xc0de, 8, [&](auto, const auto& triangles, auto, auto& draw) {
    const auto owned = mesh_of(triangles);
    const auto mesh = owned.view();
    for (int i = 0; i < 4; ++i) {
      const auto setting = oracle::draw_setting(draw, oracle::Kind::general, 70);
      const auto shape = oracle::draw_shape<Sphere<S, 3>>(draw, setting);
      std::vector<MeshContact<S>> all(triangles.size());
      const auto count = contacts(mesh, shape, std::span(all), Facing::both);
      REQUIRE(count <= all.size());
      all.resize(count);
      rate.count(count > 0);
      CHECK((count > 0) == overlaps(mesh, shape));
      for (std::size_t k = 1; k < count; ++k) CHECK(all[k - 1].triangle < all[k].triangle);
      std::array<MeshContact<S>, 2> few;
      CHECK(contacts(mesh, shape, std::span(few), Facing::both) == count);
      for (std::size_t k = 0; k < std::min<std::size_t>(count, 2); ++k) CHECK(few[k] == all[k]);
    }
  });
  INFO(rate);
  CHECK(rate.percent() >= 5);
  CHECK(rate.percent() <= 95);
}

}  // namespace
}  // namespace detent::test
