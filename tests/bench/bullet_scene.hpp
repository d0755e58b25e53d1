// SPDX-License-Identifier: MIT
#pragma once

#include <btBulletCollisionCommon.h>

#include <memory>
#include <vector>

#include "bench/drawn_scene.hpp"

// Drawn scenes in Bullet.

namespace detent::bench {

inline btVector3 as_bullet(const Vec<double, 3>& v) {
  return {static_cast<btScalar>(v.x), static_cast<btScalar>(v.y), static_cast<btScalar>(v.z)};
}

inline btTransform as_bullet(const Obb<double, 3>& box) {
  btMatrix3x3 basis;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      basis[i][j] = static_cast<btScalar>(box.rotation.axis(j)[i]);
    }
  }
  return btTransform(basis, as_bullet(box.center));
}

/// Bullet's shapes and objects of a drawn scene, which its world refers to.
struct BulletObjects {
  std::vector<std::unique_ptr<btCollisionShape>> shapes;
  std::vector<std::unique_ptr<btCollisionObject>> objects;

  void add_to(btCollisionWorld& world, const Drawn& drawn) {
    for (const auto& [box, is_ball] : drawn.items) {
      if (is_ball) {
        shapes.push_back(
            std::make_unique<btSphereShape>(static_cast<btScalar>(box.half_extents.x)));
      } else {
        shapes.push_back(std::make_unique<btBoxShape>(as_bullet(box.half_extents)));
      }
      objects.push_back(std::make_unique<btCollisionObject>());
      objects.back()->setCollisionShape(shapes.back().get());
      objects.back()->setWorldTransform(as_bullet(box));
      world.addCollisionObject(objects.back().get());
    }
  }
};

/// A world of Bullet without physics, and its objects.
struct BulletWorld {
  btDefaultCollisionConfiguration configuration;
  btCollisionDispatcher dispatcher{&configuration};
  btDbvtBroadphase broad_phase;
  btCollisionWorld world{&dispatcher, &broad_phase, &configuration};
  BulletObjects objects;

  BulletWorld() = default;
  BulletWorld(const BulletWorld&) = delete;
  BulletWorld& operator=(const BulletWorld&) = delete;
  ~BulletWorld() { world.getCollisionObjectArray().clear(); }

  void add(const Drawn& drawn) { objects.add_to(world, drawn); }
};

}  // namespace detent::bench
