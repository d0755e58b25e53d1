// SPDX-License-Identifier: MIT
//
// For the page: one scene in q16_16 and in float, at the origin and far from it. The far scene is
// shifted by a whole number of units, so the results must not change.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <new>
#include <optional>

#include <detent/dynamics/dynamics.hpp>
#include <detent/query/raycast.hpp>

namespace {

using detent::BodyId;
using detent::Scalar;
using detent::Vec;

/// n / 1024, exact in both scalars.
template <Scalar S>
S of(int n) {
  if constexpr (detent::is_fixed<S>) {
    return S::from_raw(n * 64);
  } else {
    return static_cast<S>(n) / 1024;
  }
}
template <Scalar S>
double as_double(S x) {
  if constexpr (detent::is_fixed<S>) {
    return static_cast<double>(x.raw()) / 65536;
  } else {
    return x;
  }
}

constexpr std::size_t room = 40;
constexpr int ray_count = 360;

struct Thing {
  int x, y, half_x, half_y;  // in 1/1024 of a unit; half_y is 0 for a ball
};

template <Scalar S>
class Stage {
 public:
  /// A tower on the ground, and shapes for rays, `offset` units from the origin along both axes.
  void begin(int offset) {
    offset_ = offset;
    put({0, -1024, 14 * 1024, 1024}, true, 0);
    for (int storey = 0; storey < 4; ++storey) {
      const int bottom = storey * 2253;
      put({-1434, bottom + 922, 307, 922}, false, 0);
      put({1434, bottom + 922, 307, 922}, false, 0);
      put({0, bottom + 2048, 2048, 204}, false, 0);
    }
    for (int i = 0; i < 3; ++i) put({4608, 512 + 1024 * i, 512, 512}, false, 0);
  }

  void step() {
    if (tick_++ == 90) put({-9 * 1024, 3072, 512, 0}, false, 17 * 1024);
    world_.step();
  }

  /// x and y from the scene's origin, the angle as cosine and sine, half extents.
  std::size_t write(double* out) const {
    for (std::size_t i = 0; i < count_; ++i) {
      const auto place = world_.position(ids_[i]);
      const auto axis = world_.rotation(ids_[i]).axis(0).vec();
      const std::array numbers{
          as_double(place.x) - offset_, as_double(place.y) - offset_, as(axis.x), as(axis.y),
          things_[i].half_x / 1024.0,   things_[i].half_y / 1024.0};
      out = std::copy(numbers.begin(), numbers.end(), out);
    }
    return count_;
  }

  /// Casts the rays from a point that circles among the bodies. Distances are negative for a miss.
  void cast(double* out) const {
    const auto at = detent::Rotation<S, 2>::from_angle(detent::Angle<S>::turn(tick_ % 600, 600));
    const auto around = at.axis(0).vec();
    const Vec<S, 2> origin = place_of(static_cast<int>(7000 * as(around.x)),
                                      5000 + static_cast<int>(3500 * as(around.y)));
    for (int i = 0; i < ray_count; ++i) {
      const auto turn = detent::Angle<S>::turn(i, ray_count);
      const detent::Ray<S, 2> ray{origin, detent::Rotation<S, 2>::from_angle(turn).axis(0),
                                  of<S>(20'480)};
      std::optional<S> nearest;
      for (std::size_t k = 0; k < count_; ++k) {
        const auto hit = cast_at(ray, k);
        if (hit && (!nearest || *hit < *nearest)) nearest = hit;
      }
      out[i] = nearest ? as_double(*nearest) : -1;
    }
    out[ray_count] = as_double(origin.x) - offset_;
    out[ray_count + 1] = as_double(origin.y) - offset_;
  }

 private:
  template <class T>
  static double as(const T& x) {
    if constexpr (detent::is_fixed<S>) {
      return static_cast<double>(x.raw()) / static_cast<double>(std::int64_t{1} << T::frac);
    } else {
      return x;
    }
  }
  Vec<S, 2> place_of(int x, int y) const {
    return {of<S>(x + 1024 * offset_), of<S>(y + 1024 * offset_)};
  }
  std::optional<S> cast_at(const detent::Ray<S, 2>& ray, std::size_t k) const {
    const Thing& thing = things_[k];
    const auto place = world_.position(ids_[k]);
    if (thing.half_y == 0) {
      return detent::raycast(ray, detent::Sphere<S, 2>{place, of<S>(thing.half_x)});
    }
    const Vec<S, 2> half{of<S>(thing.half_x), of<S>(thing.half_y)};
    return detent::raycast(ray, detent::Obb<S, 2>{place, half, world_.rotation(ids_[k])});
  }
  void put(const Thing& thing, bool is_fixed, int speed) {
    detent::BodyOptions<S, 2> options;
    if (is_fixed) options.motion = detent::BodyMotion::fixed;
    options.velocity = {of<S>(speed), of<S>(speed / 4)};
    const auto place = place_of(thing.x, thing.y);
    std::optional<BodyId> id;
    if (thing.half_y == 0) {
      options.density = of<S>(5120);
      id = world_.add(detent::Sphere<S, 2>{place, of<S>(thing.half_x)}, options);
    } else {
      id = world_.add(detent::Obb<S, 2>{place, {of<S>(thing.half_x), of<S>(thing.half_y)}, {}},
                      options);
    }
    things_[count_] = thing;
    ids_[count_++] = id.value_or(detent::no_object);
  }

  detent::BoundedWorld<detent::Bounded<room>, S, 2, detent::Sphere, detent::Obb> world_;
  std::array<Thing, room> things_{};
  std::array<BodyId, room> ids_{};
  std::size_t count_ = 0;
  int offset_ = 0, tick_ = 0;
};

/// A scene far away and its copy at the origin.
template <Scalar S>
struct Pair {
  Stage<S> away, home;
  std::array<double, 6 * room> bodies{}, bodies_at_home{};
  std::array<double, ray_count + 2> rays{}, rays_at_home{};
  std::size_t count = 0;

  void begin(int offset) {
    away.begin(offset);
    home.begin(0);
  }
  void step() {
    away.step();
    home.step();
    count = away.write(bodies.data());
    static_cast<void>(home.write(bodies_at_home.data()));
    away.cast(rays.data());
    home.cast(rays_at_home.data());
  }
  [[nodiscard]] double farthest() const {
    double most = 0;
    for (std::size_t i = 0; i < 6 * count; ++i) {
      if (i % 6 < 2) most = (std::max)(most, std::abs(bodies[i] - bodies_at_home[i]));
    }
    return most;
  }
  [[nodiscard]] int other_rays() const {
    int other = 0;
    for (std::size_t i = 0; i < ray_count; ++i) other += rays[i] != rays_at_home[i] ? 1 : 0;
    return other;
  }
};

// Constructed by `begin`: as initialised globals, the worlds' settings would be most of the file.
alignas(Pair<detent::q16_16>) std::byte exact_place[sizeof(Pair<detent::q16_16>)];
alignas(Pair<float>) std::byte floating_place[sizeof(Pair<float>)];
Pair<detent::q16_16>* exact = nullptr;
Pair<float>* floating = nullptr;

template <class F>
auto of_pair(int is_float, const F& f) {
  return is_float != 0 ? f(*floating) : f(*exact);
}

}  // namespace

#define EXPORT(name) extern "C" __attribute__((export_name(#name)))

EXPORT(begin) void begin(int offset) {
  exact = ::new (exact_place) Pair<detent::q16_16>;
  floating = ::new (floating_place) Pair<float>;
  exact->begin(offset);
  floating->begin(offset);
}
EXPORT(step) void step() {
  exact->step();
  floating->step();
}
EXPORT(body_count) std::size_t body_count() { return exact->count; }
EXPORT(bodies_at) const double* bodies_at(int is_float) {
  return of_pair(is_float, [](const auto& pair) { return pair.bodies.data(); });
}
/// The scene at the origin.
EXPORT(home_at) const double* home_at(int is_float) {
  return of_pair(is_float, [](const auto& pair) { return pair.bodies_at_home.data(); });
}
EXPORT(rays_at) const double* rays_at(int is_float) {
  return of_pair(is_float, [](const auto& pair) { return pair.rays.data(); });
}
/// The largest distance of a body from its position at the origin.
EXPORT(farthest) double farthest(int is_float) {
  return of_pair(is_float, [](const auto& pair) { return pair.farthest(); });
}
/// The number of rays, of 360, whose result differs from that at the origin.
EXPORT(other_rays) int other_rays(int is_float) {
  return of_pair(is_float, [](const auto& pair) { return pair.other_rays(); });
}
