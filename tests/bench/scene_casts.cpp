// SPDX-License-Identifier: MIT
//
// usage: detent-bench-scene-casts
// Casts a ball and a box through scenes of random spheres and boxes, and computes the contacts of a
// box there. Compares them with Bullet's convexSweepTest and contactTest on the same shapes and
// paths, and with float from the same source. Prints a table as CSV. Fails if a q16_16 result is
// not golden.

#include <cstdio>
#include <set>
#include <vector>

#include "bench/drawn_scene.hpp"
#include "detent/query/contact.hpp"
#if DETENT_BENCH_BULLET
#include "bench/bullet_scene.hpp"
#endif

namespace detent::bench {
namespace {

struct Measured {
  double ball = 0, box = 0, contact = 0;
  std::size_t ball_hits = 0, box_hits = 0, contacts = 0;
};

/// Half the greatest extent of an object.
double half_size(const Drawn& drawn) { return 0.35 * reach / std::cbrt(drawn.items.size()); }

/// The nanoseconds per query over `ray_count`, and the sum of their hits.
template <class Hits>
double time_each(std::size_t& hits, const Hits& hits_at) {
  Timer timer;
  for (int i = 0; i < rounds / 3; ++i) {
    timer.time([&] {
      hits = 0;
      for (std::size_t k = 0; k < ray_count; ++k) hits += hits_at(k);
    });
  }
  return timer.least() * 1000 / ray_count;
}

template <Scalar S>
Measured measure(const Drawn& drawn) {
  Scene<S, 3, Sphere, Obb> scene;
  std::vector<Obb<S, 3>> boxes;
  for (const auto& item : drawn.items) {
    const auto& box = item.box;
    boxes.push_back({as<S>(box.center), as<S>(box.half_extents), as<S>(box.rotation)});
  }
  add(scene, drawn);
  scene.optimize();
  std::vector<Ray<S, 3>> rays;
  for (const auto& ray : drawn.rays) rays.push_back(as<S>(ray));
  const auto radius = as<S>(Vec<double, 3>{half_size(drawn), 0, 0}).x;
  Measured result;
  result.ball = time_each(result.ball_hits, [&](std::size_t k) {
    const auto& [origin, direction, length] = rays[k];
    return scene.nearest(Cast{Sphere<S, 3>{origin, radius}, direction, length}) ? 1u : 0u;
  });
  const auto box_at = [&](std::size_t k) {
    return Obb<S, 3>{rays[k].origin, {radius, radius, radius}, boxes[k % boxes.size()].rotation};
  };
  result.box = time_each(result.box_hits, [&](std::size_t k) {
    return scene.nearest(Cast{box_at(k), rays[k].direction, rays[k].max_distance}) ? 1u : 0u;
  });
  result.contact = time_each(result.contacts, [&](std::size_t k) {
    const auto box = box_at(k);
    std::size_t count = 0;
    for (const auto& found : scene.all(box)) {
      scene.visit(found.id, [&](const auto& shape) { count += contact(box, shape) ? 1u : 0u; });
    }
    return count;
  });
  return result;
}

#if DETENT_BENCH_BULLET

/// Which objects have contacts with one.
struct Touched : btCollisionWorld::ContactResultCallback {
  const btCollisionObject* self;
  std::set<const btCollisionObject*> objects;

  explicit Touched(const btCollisionObject* object) : self(object) {}
  btScalar addSingleResult(btManifoldPoint&, const btCollisionObjectWrapper* a, int, int,
                           const btCollisionObjectWrapper* b, int, int) override {
    objects.insert(a->getCollisionObject() == self ? b->getCollisionObject()
                                                   : a->getCollisionObject());
    return 0;
  }
};

Measured measure_bullet(const Drawn& drawn) {
  BulletWorld bullet;
  bullet.add(drawn);
  bullet.broad_phase.optimize();
  const auto radius = static_cast<btScalar>(half_size(drawn));
  const btSphereShape ball(radius);
  const btBoxShape cube(btVector3(radius, radius, radius));
  const auto sweep = [&](const btConvexShape& shape, std::size_t k, btTransform from) {
    const auto& ray = drawn.rays[k];
    from.setOrigin(as_bullet(ray.origin));
    auto to = from;
    to.setOrigin(as_bullet(ray.origin + ray.max_distance * ray.direction.vec()));
    btCollisionWorld::ClosestConvexResultCallback closest(from.getOrigin(), to.getOrigin());
    bullet.world.convexSweepTest(&shape, from, to, closest);
    return closest.hasHit() ? 1u : 0u;
  };
  Measured result;
  result.ball = time_each(
      result.ball_hits, [&](std::size_t k) { return sweep(ball, k, btTransform::getIdentity()); });
  result.box = time_each(result.box_hits, [&](std::size_t k) {
    return sweep(cube, k, as_bullet(drawn.items[k % drawn.items.size()].box));
  });
  btBoxShape box(cube);
  btCollisionObject body;
  body.setCollisionShape(&box);
  result.contact = time_each(result.contacts, [&](std::size_t k) {
    auto place = as_bullet(drawn.items[k % drawn.items.size()].box);
    place.setOrigin(as_bullet(drawn.rays[k].origin));
    body.setWorldTransform(place);
    Touched touched(&body);
    bullet.world.contactTest(&body, touched);
    return touched.objects.size();
  });
  return result;
}

#endif

void print(int count, const char* who, const Measured& m) {
  std::printf("%d,%s,%zu,%.0f,%zu,%.0f,%zu,%.0f\n", count, who, m.ball_hits, m.ball, m.box_hits,
              m.box, m.contacts, m.contact);
}

/// The hits of q16_16.
struct Golden {
  int count;
  std::size_t ball_hits, box_hits, contacts;
};
constexpr Golden golden[] = {{1000, 1977, 1994, 1034}, {10000, 1998, 2000, 1082}};

}  // namespace
}  // namespace detent::bench

int main() {
  using namespace detent::bench;
  bool is_right = true;
  std::printf(
      "objects,engine,balls that hit of 2000,ns per ball,boxes that hit,ns per box,"
      "contacts of 2000 boxes,ns per box in contact\n");
  for (const auto& [count, ball_hits, box_hits, contacts] : golden) {
    const Drawn drawn(count, 42);
    const auto fixed = print_scalars(count, [&]<class S>(S) { return measure<S>(drawn); });
#if DETENT_BENCH_BULLET
    print(count, "Bullet", measure_bullet(drawn));
#endif
    if (fixed.ball_hits != ball_hits || fixed.box_hits != box_hits || fixed.contacts != contacts) {
      is_right = false;
      std::printf("golden: {%d, %zu, %zu, %zu}\n", count, fixed.ball_hits, fixed.box_hits,
                  fixed.contacts);
    }
  }
  return is_right ? 0 : 1;
}
