// SPDX-License-Identifier: MIT
#include "detent/scene/height_field/walk.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <vector>

#include "detent/scene/height_field.hpp"
#include "detent/scene/mesh.hpp"
#include "query/raycast/helpers.hpp"
#include "scene/mesh_helpers.hpp"
#include "scene/surface_loop.hpp"

namespace detent {

namespace test {

/// A surface that counts the triangles that its walks visit.
template <Scalar S>
struct Counted {
  const Mesh<S>* mesh = nullptr;
  const HeightField<S>* field = nullptr;
  const PlacedMesh<S>* placed = nullptr;
  std::size_t asked = 0;

  template <class Go>
  Walk walk(const Go& go) const {
    return mesh ? go(*mesh) : field ? go(*field) : go(*placed);
  }
};

}  // namespace test

template <>
inline constexpr bool is_surface<test::Counted> = true;

namespace test {

/// Wraps visit(triangles) of a walk, to count.
template <Scalar S, class Visit>
auto counting(const Counted<S>& surface, const Visit& visit) {
  return [&](auto triangles) {
    const_cast<Counted<S>&>(surface).asked += triangles.size();
    return visit(triangles);
  };
}
template <Scalar S, class Visit>
Walk visit_within(const Counted<S>& surface, const Aabb<S, 3>& box, const Visit& visit) noexcept {
  return surface.walk(
      [&](const auto& s) { return visit_within(s, box, counting(surface, visit)); });
}
template <Scalar S, class Visit>
Walk visit_crossing(const Counted<S>& surface, const Segment<S, 3>& segment,
                    const Visit& visit) noexcept {
  return surface.walk(
      [&](const auto& s) { return visit_crossing(s, segment, counting(surface, visit)); });
}

namespace {

/// A field whose borders, samples and queries use few distinct numbers, so that many coincide.
template <Scalar S>
struct Lattice {
  static constexpr std::uint32_t side = 4;
  S corner, cell;
  std::vector<S> numbers;
  std::vector<S> heights;

  Lattice(Random& random, bool is_widest) {
    const auto raw = [](std::int64_t x) {
      return S::from_raw(static_cast<typename S::raw_type>(x));
    };
    const std::int64_t least = S::lowest().raw(), most = S::max().raw();
    const auto width = is_widest ? (most - least) / (side - 1) : random.between(1, 3);
    const auto start = is_widest ? random.between(0, 1) * ((most - least) % (side - 1)) + least
                                 : random.between(-7, 0);
    corner = raw(start);
    cell = raw(width);
    for (std::int64_t i = 0; i < side; ++i) {
      for (const auto by : {-1, 0, 1}) {
        numbers.push_back(raw(std::clamp(start + i * width + by, least, most)));
      }
    }
    for (const auto x : {least, most}) {
      if (is_widest || random.one_in(8)) numbers.push_back(raw(x));
    }
    numbers.push_back(raw(start + random.between(0, (side - 1) * width)));
    const bool is_flat = random.one_in(3);
    for (std::uint32_t i = 0; i < side * side; ++i) {
      heights.push_back(is_flat && i != 6 ? numbers[1] : numbers[random.below(numbers.size())]);
    }
  }
  [[nodiscard]] HeightField<S> field() const {
    return *height_field<S>({corner, corner}, cell, side, side, heights);
  }
  [[nodiscard]] Vec<S, 3> point(Random& random) const {
    const auto number = [&] { return numbers[random.below(numbers.size())]; };
    const auto x = number(), y = number();
    return {x, y, number()};
  }
};

template <Scalar S>
TriangleLoop<S> loop_of(const HeightField<S>& field) {
  TriangleLoop<S> loop;
  for (std::uint32_t row = 0; row + 1 < field.rows; ++row) {
    for (std::uint32_t column = 0; column + 1 < field.columns; ++column) {
      for (const auto& part : cell_triangles(field, column, row)) {
        loop.triangles.push_back(part.triangle);
      }
    }
  }
  return loop;
}

/// The least index of a triangle at this distance from a point.
template <Scalar S>
std::uint32_t index_at(const TriangleLoop<S>& loop, const Vec<S, 3>& point, const S& to) {
  const auto found = std::find_if(loop.triangles.begin(), loop.triangles.end(),
                                  [&](const auto& part) { return distance(part, point) == to; });
  return static_cast<std::uint32_t>(found - loop.triangles.begin());
}

TEMPLATE_TEST_CASE(
    "height field: its traversals miss nothing along borders and at the ends of the range",
    "[height_field]", q16_16, q24_8, q8_8) {
  using S = TestType;
  Random random(0x3a1c);
  INFO("seed " << random.seed());
  HitRate segments, rays;
  for (int i = 0; i < 120; ++i) {
    const Lattice<S> lattice(random, i % 3 == 0);
    const auto field = lattice.field();
    const auto loop = loop_of(field);
    const OwnedMesh<S> owned{std::span<const Triangle<S, 3>>(loop.triangles)};
    const MeshAsset<S> asset(1, owned.view());
    for (int k = 0; k < 60; ++k) {
      Segment<S, 3> segment{lattice.point(random), lattice.point(random)};
      if (random.one_in(6)) segment.end = segment.start;
      if (random.one_in(6)) {  // vertical
        segment.end.x = segment.start.x;
        segment.end.z = segment.start.z;
      }
      CAPTURE(segment.start.x.raw(), segment.start.y.raw(), segment.start.z.raw());
      CAPTURE(segment.end.x.raw(), segment.end.y.raw(), segment.end.z.raw());
      const bool is_met = intersects(segment, loop);
      segments.count(is_met);
      REQUIRE(intersects(segment, field) == is_met);
      REQUIRE(intersects(segment, owned.view()) == is_met);
      REQUIRE(intersects(segment, PlacedMesh<S>{&asset, {}}) == is_met);

      const auto along = make_vec<3>(
          [&](int axis) { return nearest_to<S>(half(segment.end[axis] - segment.start[axis])); });
      Ray<S, 3> ray{segment.start, toward<S, 3>(0, random.coin() ? 1 : -1, 0), largest<S>};
      if (const auto direction = normalize(along)) ray.direction = *direction;
      if (random.one_in(3))
        ray.max_distance = lattice.numbers[random.below(lattice.numbers.size())];
      const auto distance_to = raycast(ray, loop);
      rays.count(distance_to.has_value());
      REQUIRE(raycast(ray, field) == distance_to);

      const auto nearest = nearest_triangle(field, segment.end);
      REQUIRE(nearest->distance == distance(loop, segment.end));
      REQUIRE(nearest->index == index_at(loop, segment.end, nearest->distance));
      REQUIRE(contains(field, segment.end) == contains(loop, segment.end));
      const Aabb box{segment.start, segment.end};
      REQUIRE(overlaps(field, box) == overlaps(loop, box));
    }
  }
  INFO(segments << ", " << rays);
  CHECK(segments.is_balanced());
  CHECK(rays.is_balanced());
}

/// Flat ground of 128 x 128 cells with a tower in the middle: a box around more than a few cells is
/// as high as the tower.
struct Plain {
  static constexpr std::uint32_t side = 129;
  std::vector<q16_16> heights = std::vector<q16_16>(side * side);
  std::optional<HeightField<q16_16>> field;

  Plain() {
    heights[side * (side / 2) + side / 2] = q16_16(100);
    field = height_field<q16_16>({q16_16(-64), q16_16(-64)}, q16_16(1), side, side, heights);
  }
};

struct Count {
  std::uint64_t strips = 0, cells = 0;
  constexpr void add(const detail::FieldCells& strip) {
    ++strips;
    cells += std::uint64_t{strip.columns} * strip.rows;
  }
};

template <Scalar S>
Count cells_along(const HeightField<S>& field, const Segment<S, 3>& segment) {
  Count count;
  const auto along = segment.end - segment.start;
  detail::FieldLine(field, segment.start, along)
      .visit_strips([](const auto& ahead, const auto& size) { return ahead > size; },
                    [&](const auto& strip, const auto&) {
                      count.add(strip);
                      return Walk::go_on;
                    });
  return count;
}

TEST_CASE("height field: a line visits only the cells below it", "[height_field]") {
  using S = q16_16;
  const Plain plain;
  const auto& field = *plain.field;
  const auto count = [&](const Vec<S, 3>& start, const Vec<S, 3>& end) {
    const auto there = cells_along(field, Segment{start, end});
    const auto back = cells_along(field, Segment{end, start});
    CHECK(there.cells == back.cells);
    return there.cells;
  };
  CHECK(count(at<S, 3>(-60.5, 20, -60.5), at<S, 3>(60.5, 20, -60.5)) == 122);
  CHECK(count(at<S, 3>(-60.5, 20, -60.5), at<S, 3>(-60.5, 20, 60.5)) == 122);
  CHECK(count(at<S, 3>(-60.5, 20, 60.5), at<S, 3>(60.5, 20, 30.25)) <= 3 * 122);
  CHECK(count(at<S, 3>(-60, 20, -60), at<S, 3>(60, 20, 60)) <= 3 * 122);  // through the corners
  CHECK(count(at<S, 3>(0.5, 20, 0.5), at<S, 3>(0.5, -20, 0.5)) == 1);
  CHECK(count(at<S, 3>(1, 20, 1), at<S, 3>(1, -20, 1)) == 4);
  CHECK(count(at<S, 3>(0.5, 20, 0.5), at<S, 3>(0.5, 20, 0.5)) == 1);
  CHECK(count(at<S, 3>(-3000, 20, 0.5), at<S, 3>(-2000, 20, 0.5)) == 0);
  CHECK(count(at<S, 3>(-3000, 20, -2999), at<S, 3>(3000, 20, 3001)) <= 3 * 128);
  CHECK(count(at<S, 3>(-3000, 3000, 0.5), at<S, 3>(3000, -3000, 0.5)) <= 3 * 101);
  CHECK(count(at<S, 3>(-60, 101, 1), at<S, 3>(60, 200, 1)) == 0);  // higher than the tower
}

TEST_CASE("height field: a tower does not slow down queries over the plain", "[height_field]") {
  using S = q16_16;
  const Plain plain;
  const auto& field = *plain.field;
  const auto loop = loop_of(field);
  const OwnedMesh<S> owned{std::span<const Triangle<S, 3>>(loop.triangles)};
  const auto mesh = owned.view();
  const MeshAsset<S> asset(1, mesh);
  Transform<S, 3> turned;
  turned.rotation = Rotation<S, 3>::from_axis_angle(toward<S, 3>(0, 1, 0),
                                                    Angle<S>::from_raw(std::uint32_t{1} << 28));
  const PlacedMesh<S> there{&asset, turned};
  const auto asked_of = [](Counted<S> surface, const Segment<S, 3>& segment) {
    (void)intersects(segment, surface);
    return surface.asked;
  };
  // Over the plain and past the tower; seen from above, its box covers half of the plain.
  const Segment over{at<S, 3>(-60, 30, -60), at<S, 3>(60, 30, 55)};
  CHECK(asked_of({.field = &field}, over) <= 8);
  CHECK(asked_of({.mesh = &mesh}, over) <= 16);
  CHECK(asked_of({.placed = &there}, over) <= 16);
  // Along the plain, half a step above it.
  const Segment along{at<S, 3>(-60, 0.0001, -60), at<S, 3>(60, 0.0001, 20)};
  CHECK(asked_of({.field = &field}, along) <= 8);
  CHECK(asked_of({.mesh = &mesh}, along) <= 8 * 128);
  CHECK(asked_of({.placed = &there}, along) <= 16 * 128);
  // Down to the ground.
  const Segment down{at<S, 3>(-60, 30, -60), at<S, 3>(60, -1, 55)};
  CHECK(intersects(down, field));
  CHECK(asked_of({.field = &field}, down) <= 40);
  CHECK(asked_of({.mesh = &mesh}, down) <= 40);
  CHECK(asked_of({.placed = &there}, down) <= 40);

  std::size_t asked = 0;
  const Ray ray{over.start, *normalize(nearest_to<S>(over.end - over.start)), largest<S>};
  visit_along(field, ray, [&](auto triangles, S&) {
    asked += triangles.size();
    return Walk::go_on;
  });
  CHECK(asked <= 8);
}

TEST_CASE("height field: the nearest triangle is not searched for beyond its upper bound",
          "[height_field]") {
  using S = q16_16;
  const Plain plain;
  const auto& field = *plain.field;
  const auto count = [&](const Vec<S, 3>& point) {
    const detail::FieldRings<S> rings(field, point);
    const auto limit = distance(field, point);
    Count sides;
    rings.visit_sides([&](const detail::FieldCells& side) {
      sides.add(side);
      return stop_if(
          !detail::HeightReach<S>(point.y, limit, rings.squared_gap(point, side)).is_any);
    });
    return sides.cells;
  };
  const auto asked = [&](const Vec<S, 3>& point) {
    std::size_t triangles_asked = 0;
    visit_around(field, point, [&](auto triangles, S& limit) {
      for (const auto& part : triangles) limit = std::min(limit, distance(part.triangle, point));
      triangles_asked += triangles.size();
      return Walk::go_on;
    });
    return triangles_asked;
  };
  CHECK(count(at<S, 3>(30.5, 0.25, 30.5)) == 9);
  CHECK(count(at<S, 3>(30.5, 2.25, 30.5)) <= 7 * 7);
  CHECK(count(at<S, 3>(3000, 1, 30.5)) <= 16);
  CHECK(count(at<S, 3>(3000, 1, 3000)) <= 16);
  // Of all cells within 30 of this point, those more than 30 below it are skipped.
  CHECK(asked(at<S, 3>(30.5, 30, 30.5)) <= 8);
  CHECK(asked(at<S, 3>(30.25, -50, -20.5)) <= 8);
}

}  // namespace
}  // namespace test
}  // namespace detent
