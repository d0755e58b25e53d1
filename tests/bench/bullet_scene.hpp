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

/// Bullet's shapes and objects of a drawn scene; its world refers to them.
struct BulletObjects {
  std::vector<std::unique_ptr<btCollisionShape>> shapes;
  std::vector<std::unique_ptr<btCollisionObject>> objects;

  void add_to(btCollisionWorld& world, const Drawn& drawn) {
    for (const auto& [box, is_ball] : drawn.items) {
      btTransform place = btTransform::getIdentity();
      place.setOrigin(as_bullet(box.center));
      if (is_ball) {
        shapes.push_back(
            std::make_unique<btSphereShape>(static_cast<btScalar>(box.half_extents.x)));
      } else {
        shapes.push_back(std::make_unique<btBoxShape>(as_bullet(box.half_extents)));
        btMatrix3x3 basis;
        for (int i = 0; i < 3; ++i) {
          for (int j = 0; j < 3; ++j) {
            basis[i][j] = static_cast<btScalar>(box.rotation.axis(j)[i]);
          }
        }
        place.setBasis(basis);
      }
      objects.push_back(std::make_unique<btCollisionObject>());
      objects.back()->setCollisionShape(shapes.back().get());
      objects.back()->setWorldTransform(place);
      world.addCollisionObject(objects.back().get());
    }
  }
};

}  // namespace detent::bench
