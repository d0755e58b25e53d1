// SPDX-License-Identifier: MIT
//
// Counts what a frustum keeps and culls in a town, compared with the exact frustum of the camera,
// whose corners are not rounded. docs/camera.md shows these counts.

#include "detent/shape/frustum.hpp"

#include <array>
#include <cstddef>
#include <vector>

#include "detent/scene/scene.hpp"
#include "detent/shape/camera.hpp"
#include "oracle/hull.hpp"
#include "oracle/view.hpp"
#include "support/catch.hpp"
#include "support/random.hpp"

namespace detent::test {
namespace {

using S = q16_16;
using V = Vec<S, 3>;

S number(std::int64_t raw) { return S::from_raw(static_cast<std::int32_t>(raw)); }
V random_point(Random& random, std::int64_t reach) {
  return make_vec<3>([&](int) { return number(random.between(-reach, reach)); });
}

/// A camera near `away` with a random position and direction, seeing from 0.1 to 200 units.
Camera<S> random_camera(Random& random, const V& away) {
  const auto eye = nearest_to<S>(away + random_point(random, 20 << 16));
  const auto target = nearest_to<S>(away + random_point(random, 200 << 16));
  const auto pose = look_at(eye, target, V{S(0), S(1), S(0)});
  const auto lens = Lens<S>::perspective(Angle<S>::turn(1, 6), quotient_nearest<S>(16, 9),
                                         quotient_nearest<S>(1, 10), S(200));
  return {pose.value(), lens.value()};
}

// The same value in another number type, as another program would have it.
template <class F>
struct Float {
  static F of(const S& x) { return static_cast<F>(static_cast<double>(x)); }
  static Vec<F, 3> of(const V& v) { return {of(v.x), of(v.y), of(v.z)}; }
  static Aabb<F, 3> of(const Aabb<S, 3>& box) { return {of(box.min), of(box.max)}; }
  static Obb<F, 3> of(const Obb<S, 3>& box) {
    return {of(box.center), of(box.half_extents), of(box.rotation)};
  }
  static Rotation<F, 3> of(const Rotation<S, 3>& rotation) {
    std::array<Direction<F, 3>, 3> axes;
    for (int i = 0; i < 3; ++i) {
      const auto& axis = rotation.axis(i);
      axes[static_cast<std::size_t>(i)] = Direction<F, 3>::assume_unit(
          make_vec<3>([&](int j) { return static_cast<F>(static_cast<double>(axis[j])); }));
    }
    return Rotation<F, 3>::from_axes(axes);
  }
  static Camera<F> of(const Camera<S>& camera) {
    const auto lens = Lens<F>::perspective(Angle<F>::turn(1, 6), F(16) / F(9), F(0.1), F(200));
    return {{of(camera.pose.translation), of(camera.pose.rotation), F(1)}, *lens};
  }
};

/// The usual test: a box is culled if its nearest corner is behind one of six planes.
class SixPlanes {
 public:
  explicit SixPlanes(const Frustum<float>& frustum) {
    const auto& c = frustum.corners();
    const std::array<std::array<std::size_t, 3>, 6> sides{
        {{1, 5, 3}, {0, 2, 4}, {2, 3, 6}, {0, 4, 1}, {4, 6, 5}, {0, 1, 2}}};
    for (std::size_t i = 0; i < 6; ++i) {
      const auto& a = c[sides[i][0]];
      normals_[i] = cross(c[sides[i][1]] - a, c[sides[i][2]] - a);
      // Outward: away from the opposite corner.
      if (dot(normals_[i], c[7 - sides[i][0]] - a) > 0) normals_[i] = -normals_[i];
      offsets_[i] = dot(normals_[i], a);
    }
  }
  [[nodiscard]] bool keeps(const Obb<float, 3>& box) const {
    for (std::size_t i = 0; i < 6; ++i) {
      float least = dot(normals_[i], box.center);
      for (int j = 0; j < 3; ++j) {
        least -= box.half_extents[j] * std::abs(dot(normals_[i], box.rotation.axis(j).vec()));
      }
      if (least > offsets_[i]) return false;
    }
    return true;
  }

 private:
  std::array<Vec<float, 3>, 6> normals_;
  std::array<float, 6> offsets_;
};

struct Count {
  int culled_visible = 0;
  int kept_invisible = 0;
  void add(bool kept, bool visible) {
    culled_visible += visible && !kept ? 1 : 0;
    kept_invisible += kept && !visible ? 1 : 0;
  }
};

struct Counts {
  int visible = 0, invisible = 0;
  Count exact, in_float, six_planes;
  Count rounded;  // against the hull of the rounded corners, by a linear program
};

/// Counts boxes, each drawn for its own camera.
template <class DrawBox>
Counts count_boxes(Random& random, const V& away, int cameras, int boxes, const DrawBox& draw_box) {
  Counts counts;
  for (int c = 0; c < cameras; ++c) {
    const auto camera = random_camera(random, away);
    const auto truth = oracle::polytope(camera);
    const Frustum<S> frustum{camera};
    const Frustum<float> rough{Float<float>::of(camera)};
    const SixPlanes planes(rough);
    for (int b = 0; b < boxes; ++b) {
      const Obb<S, 3> box = draw_box(camera);
      const bool visible = oracle::meet(truth, oracle::polytope(box));
      ++(visible ? counts.visible : counts.invisible);
      const auto other = Float<float>::of(box);
      const bool kept = overlaps(frustum, box);
      counts.exact.add(kept, visible);
      if (b % 8 == 0) {
        counts.rounded.add(kept, oracle::meet(box, frustum));
      }
      counts.in_float.add(overlaps(rough, other), visible);
      counts.six_planes.add(planes.keeps(other), visible);
    }
  }
  return counts;
}

void show(const char* name, const Counts& counts) {
  const auto line = [](const Count& count) {
    return std::to_string(count.culled_visible) + " visible culled, " +
           std::to_string(count.kept_invisible) + " invisible kept";
  };
  UNSCOPED_INFO(name << ": " << counts.visible << " visible, " << counts.invisible
                     << " invisible; exact: " << line(counts.exact)
                     << "; float: " << line(counts.in_float)
                     << "; six planes in float: " << line(counts.six_planes));
}

Rotation<S, 3> any_rotation(Random& random) {
  const auto draw = [&] { return number(random.between(-65536, 65536)); };
  return Rotation<S, 3>::from_quaternion(draw(), draw(), draw(), draw()).value_or(Rotation<S, 3>());
}

}  // namespace

namespace {

/// Boxes of any size anywhere, `away` from the origin like the camera.
Counts count_town(std::uint64_t seed, const V& away) {
  Random random(seed);
  return count_boxes(random, away, 20, 1'000, [&](const Camera<S>&) {
    const auto size = random.between(1, 24) << 15;
    return Obb<S, 3>{nearest_to<S>(away + random_point(random, 220 << 16)),
                     {number(size), number(size * 4), number(size)},
                     any_rotation(random)};
  });
}

/// Boxes that touch a side of the frustum within four steps.
Counts count_border(std::uint64_t seed, const V& away) {
  Random random(seed);
  return count_boxes(random, away, 20, 1'000, [&](const Camera<S>& camera) {
    const int side = random.coin() ? 0 : 1;
    const auto across = number(random.between(-60'000, 60'000));
    const auto end = random.coin() ? S(1) : S(-1);
    const auto depth = number(random.between(2 << 16, 198 << 16));
    const auto at = unproject(camera, side == 0 ? end : across, side == 0 ? across : end, depth);
    // The side's normal: end * axis(side) + slope * axis(2).
    const auto& frame = camera.pose.rotation;
    const auto normal = direction_of<S>(end * frame.axis(side).vec() +
                                        camera.lens.slope(side) * frame.axis(2).vec())
                            .value();
    const auto size = random.between(1, 8) << 16;
    Obb<S, 3> box{{}, {number(size), number(size), number(size)}, any_rotation(random)};
    auto reach = number(random.between(-4, 4));
    for (int i = 0; i < 3; ++i) {
      reach = nearest_to<S>(reach + box.half_extents[i] * abs(dot(normal, box.rotation.axis(i))));
    }
    box.center = nearest_to<S>(at + reach * normal.vec());
    return box;
  });
}

const V here{}, far_away{S(20'000), S(-20'000), S(20'000)};

}  // namespace

TEST_CASE("frustum: in a town it culls no visible box and keeps no invisible one", "[scene]") {
  for (const auto& away : {here, far_away}) {
    const auto counts = count_town(0x70c4, away);
    show("town", counts);
    CHECK(counts.visible > 1'000);
    CHECK(counts.exact.culled_visible == 0);
    CHECK(counts.exact.kept_invisible == 0);
    // For comparison, the usual test keeps more than it should.
    CHECK(counts.six_planes.kept_invisible > counts.visible / 50);
  }
}

TEST_CASE("frustum: decides all boxes at its border that are more than a rounded corner away",
          "[scene]") {
  for (const auto& away : {here, far_away}) {
    const auto counts = count_border(0xb04de4, away);
    show("border", counts);
    CHECK(counts.visible > 6'000);
    CHECK(counts.invisible > 6'000);
    CHECK(counts.rounded.culled_visible == 0);
    CHECK(counts.rounded.kept_invisible == 0);
    // Corners, and the sides between them, are rounded by less than one step.
    CHECK(counts.exact.culled_visible < counts.visible / 20);
    CHECK(counts.exact.kept_invisible < counts.invisible / 20);
    CHECK(counts.six_planes.culled_visible > 4 * counts.exact.culled_visible);
    CHECK(counts.six_planes.kept_invisible > 4 * counts.exact.kept_invisible);
  }
}

TEST_CASE("frustum: a scene measures distances from the center of its near side", "[scene]") {
  const auto pose = look_at(V{}, V{S(0), S(0), S(-1)}, V{S(0), S(1), S(0)});
  const auto lens = Lens<S>::perspective(Angle<S>::turn(1, 4), S(2), S(3), S(100));
  const Frustum frustum{Camera<S>{pose.value(), lens.value()}};
  Scene<S, 3, Sphere> scene;
  const auto near = scene.add(Sphere{V{S(0), S(0), S(-50)}, S(1)});
  const auto beside = scene.add(Sphere{V{S(60), S(0), S(-60)}, S(1)});
  scene.add(Sphere{V{S(0), S(0), S(2)}, S(1)});
  const auto found = scene.all(frustum);
  REQUIRE(found.size() == 2);
  CHECK(found[0] == Found<S>{S(46), near.value()});
  CHECK(found[1].id == beside.value());
  CHECK(found[1].distance == distance(Sphere{V{S(60), S(0), S(-60)}, S(1)}, V{S(0), S(0), S(-3)}));
  CHECK(scene.nearest(frustum) == found[0]);
}

}  // namespace detent::test
