// SPDX-License-Identifier: MIT
#include "detent/query/contact/sphere_box.hpp"

#include "detent/query/contact.hpp"
#include "support/catch.hpp"
#include "support/random.hpp"

namespace detent::test {
namespace {

template <Scalar S, int N>
class Draw {
 public:
  Draw(Random& random, std::int64_t reach) : random_(random), reach_(reach) {}

  [[nodiscard]] S number(std::int64_t low, std::int64_t high) {
    return random_.number<S>(low, high);
  }
  [[nodiscard]] Vec<S, N> vector(std::int64_t low, std::int64_t high) {
    return make_vec<N>([&](int) { return number(low, high); });
  }
  /// One in four is flat or nearly flat.
  [[nodiscard]] Vec<S, N> extents() {
    auto extents = vector(0, reach_);
    if (random_.one_in(4)) extents[N - 1] = number(0, std::min<std::int64_t>(reach_, 20));
    return extents;
  }
  void draw(Aabb<S, N>& box) {
    const auto middle = vector(-reach_ / 2, reach_ / 2), half = extents();
    box = {nearest_to<S>(middle - half), nearest_to<S>(middle + half)};
  }
  /// Some have axes that are not perpendicular, or are those of the world.
  void draw(Obb<S, N>& box) {
    box = {vector(-reach_ / 2, reach_ / 2), extents(), {}};
    if (random_.one_in(4)) return;
    std::array<Direction<S, N>, N> axes;
    axes[0] = direction();
    const auto& x = axes[0];
    if constexpr (N == 2) {
      axes[1] = *direction_of<S>(Vec{narrow_negative(x[1]), x[0]});
    } else {
      axes[1] = direction_of<S>(cross(x, vector(-reach_, reach_))).value_or(x);
      axes[2] = direction_of<S>(cross(x, axes[1].vec())).value_or(x);
    }
    if (random_.one_in(8)) axes[1] = direction();
    box.rotation = Rotation<S, N>::from_axes(axes);
  }
  /// The corner, the middle of an edge or a face, or another point of the box at these coordinates, which
  /// are near those of its ends and its middle, rounded to the grid.
  [[nodiscard]] Vec<S, N> point_of(const Aabb<S, N>& box) {
    return make_vec<N>([&](int i) {
      const auto near = number(-1, 1);
      switch (random_.below(4)) {
        case 0:
          return nearest_to<S>(box.min[i] + near);
        case 1:
          return nearest_to<S>(box.max[i] + near);
        case 2:
          return nearest_to<S>(half(box.min[i] + box.max[i]) + near);
        default:
          return number(-reach_, reach_);
      }
    });
  }
  [[nodiscard]] Vec<S, N> point_of(const Obb<S, N>& box) {
    const auto place = make_vec<N>([&](int i) {
      const auto& extent = box.half_extents[i];
      switch (random_.below(4)) {
        case 0:
          return extent;
        case 1:
          return narrow_negative(extent);
        case 2:
          return S(0);
        default:
          return number(-reach_, reach_);
      }
    });
    return nearest_to<S>(box.center + detail::from_frame(box, place) + vector(-1, 1));
  }

 private:
  [[nodiscard]] Direction<S, N> direction() {
    return direction_of<S>(vector(-reach_, reach_)).value_or(Direction<S, N>());
  }

  Random& random_;
  std::int64_t reach_;
};

/// A capsule without length is searched for in general.
template <class Box, Scalar S, int N>
void compare(const Box& box, const Sphere<S, N>& sphere, HitRate& hits) {
  const Capsule<S, N> same{sphere.center, sphere.center, sphere.radius};
  const auto found = contact(box, sphere);
  hits.count(found.has_value());
  REQUIRE(found == contact(box, same));
  REQUIRE(contact(sphere, box) == contact(same, box));
}

template <class Box, Scalar S, int N>
void compare_many(std::int64_t reach, int count, HitRate& hits, int& direct) {
  Random random(static_cast<std::uint64_t>(reach));
  Draw<S, N> draw(random, reach);
  for (int i = 0; i < count; ++i) {
    CAPTURE(reach, i);
    Box box;
    draw.draw(box);
    direct += detail::has_solid_faces(box) ? 1 : 0;
    const auto radius = draw.number(0, random.coin() ? 2 : reach / 2);
    const auto center = random.coin() ? draw.point_of(box) : draw.vector(-reach, reach);
    compare(box, Sphere<S, N>{center, radius}, hits);
  }
}

template <Scalar S, int N>
void compare_all() {
  const auto most = std::int64_t{largest<S>.raw()};
  HitRate hits;
  int direct = 0;
  for (const std::int64_t reach : {std::int64_t{9}, std::int64_t{40}, most / 64, most}) {
    compare_many<Aabb<S, N>, S, N>(reach, 1500, hits, direct);
    compare_many<Obb<S, N>, S, N>(reach, 1500, hits, direct);
  }
  INFO(hits);
  CHECK(hits.is_balanced());
  CHECK(direct > 6000);
}

TEST_CASE("contact of a sphere and a box: the same as of a capsule without length", "[query]") {
  compare_all<q16_16, 3>();
  compare_all<q16_16, 2>();
  compare_all<q24_8, 3>();
  compare_all<q14_16, 3>();
}

TEST_CASE("contact of a sphere and a box: of equally near faces, the preferred one", "[query]") {
  using S = q16_16;
  const auto x = Direction<S, 3>::along(0);
  const Vec half{S(2), S(2), S(2)};
  const Sphere<S, 3> ball{{}, S(1)};
  const Aabb<S, 3> box{narrow_negative(half), half};
  CHECK(contact(box, ball)->normal == x);
  CHECK(contact(ball, box)->normal == x);
  CHECK(contact(ball, box)->depth == 3);
  // The push of an oriented box is chosen in its frame.
  const Obb<S, 3> same{{}, half, {}};
  CHECK(contact(same, ball)->normal == x);
  CHECK(contact(ball, same)->normal == -x);
}

}  // namespace
}  // namespace detent::test
