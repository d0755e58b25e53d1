// SPDX-License-Identifier: MIT
// Ray tests of two physics engines against single shapes, on the same inputs in the same run.
// Depending on their build they work in float or double. They compute normals as well.

#include "bench/suite.hpp"
#if DETENT_BENCH_BULLET
#include <BulletCollision/NarrowPhaseCollision/btRaycastCallback.h>
#include <btBulletCollisionCommon.h>
#endif
#if DETENT_BENCH_ODE
#include <ode/ode.h>
#endif

namespace detent::bench {

namespace {

/// `ask` returns a distance or a negative number.
template <class Q, class Question, class Ask>
void add_engine(Suite& suite, const Q& query, const std::string& engine,
                const std::vector<typename Q::template Question<double>>& drawn,
                const std::vector<Question>& questions, const Ask& ask) {
  const auto judge = [](const std::optional<q16_16>& exact, float distance) {
    const double error = exact ? std::abs(double{distance} - static_cast<double>(*exact)) : 0;
    // For a ray that starts inside, engines return the exit or nothing: their definition differs.
    return Judged{exact.has_value(), distance >= 0, error, exact != q16_16(0)};
  };
  add_other(suite, query, engine, drawn, questions, ask, judge,
            [](float distance) { return distance >= 0; });
}

#if DETENT_BENCH_BULLET

btVector3 as_bullet(const Vec<double, 3>& v) {
  return {static_cast<btScalar>(v.x), static_cast<btScalar>(v.y), static_cast<btScalar>(v.z)};
}

/// A shape and its transform, which Bullet keeps separately.
struct BulletShape {
  std::shared_ptr<btCollisionShape> shape;
  btTransform place = btTransform::getIdentity();
};

BulletShape as_bullet(const Sphere<double, 3>& sphere) {
  BulletShape result{std::make_shared<btSphereShape>(static_cast<btScalar>(sphere.radius))};
  result.place.setOrigin(as_bullet(sphere.center));
  return result;
}
BulletShape as_bullet(const Aabb<double, 3>& box) {
  BulletShape result{std::make_shared<btBoxShape>(as_bullet((box.max - box.min) * 0.5))};
  result.place.setOrigin(as_bullet((box.min + box.max) * 0.5));
  return result;
}
BulletShape as_bullet(const Obb<double, 3>& box) {
  BulletShape result{std::make_shared<btBoxShape>(as_bullet(box.half_extents))};
  result.place.setOrigin(as_bullet(box.center));
  const auto x = as_bullet(box.rotation.axis(0).vec()), y = as_bullet(box.rotation.axis(1).vec()),
             z = as_bullet(box.rotation.axis(2).vec());
  result.place.setBasis({x.x(), y.x(), z.x(), x.y(), y.y(), z.y(), x.z(), y.z(), z.z()});
  return result;
}
struct BulletQuestion {
  btTransform from = btTransform::getIdentity();
  btTransform to = btTransform::getIdentity();
  float length;
  BulletShape target;
  std::shared_ptr<btCollisionObject> object;
};

/// Convex shapes with Bullet's two casts: the fast one, which is the default, and the one by the
/// Gilbert-Johnson-Keerthi algorithm.
template <class Q>
void add_bullet(Suite& suite, const Q& query, const std::string& name, unsigned flags) {
  const auto drawn = draw_questions(query, suite.seed(), ordinary);
  std::vector<BulletQuestion> questions;
  for (const auto& [ray, shape] : drawn) {
    BulletQuestion question;
    question.from.setOrigin(as_bullet(ray.origin));
    question.to.setOrigin(as_bullet(ray.origin + ray.max_distance * ray.direction.vec()));
    question.length = static_cast<float>(ray.max_distance);
    question.target = as_bullet(shape);
    question.object = std::make_shared<btCollisionObject>();
    question.object->setCollisionShape(question.target.shape.get());
    question.object->setWorldTransform(question.target.place);
    questions.push_back(question);
  }
  add_engine(suite, query, name, drawn, questions, [flags](const BulletQuestion& question) {
    btCollisionWorld::ClosestRayResultCallback closest(question.from.getOrigin(),
                                                       question.to.getOrigin());
    closest.m_flags |= flags;
    btCollisionWorld::rayTestSingle(question.from, question.to, question.object.get(),
                                    question.target.shape.get(), question.target.place, closest);
    return closest.hasHit() ? closest.m_closestHitFraction * question.length : -1.0f;
  });
}

/// Bullet's triangles belong to meshes; as convex shapes they would have a margin of 0.04.
struct BulletTriangle {
  btVector3 from, to;
  float length;
  std::array<btVector3, 3> corners;
};

class FirstTriangle : public btTriangleRaycastCallback {
 public:
  using btTriangleRaycastCallback::btTriangleRaycastCallback;
  btScalar reportHit(const btVector3&, btScalar fraction, int, int) override { return fraction; }
};

void add_bullet_triangles(Suite& suite) {
  const auto asked = query<Ray, Triangle>("raycast/triangle", ask_raycast);
  const auto drawn = draw_questions(asked, suite.seed(), ordinary);
  std::vector<BulletTriangle> questions;
  for (const auto& [ray, triangle] : drawn) {
    questions.push_back({as_bullet(ray.origin),
                         as_bullet(ray.origin + ray.max_distance * ray.direction.vec()),
                         static_cast<float>(ray.max_distance),
                         {as_bullet(triangle.a), as_bullet(triangle.b), as_bullet(triangle.c)}});
  }
  add_engine(suite, asked, "Bullet", drawn, questions, [](BulletTriangle question) {
    FirstTriangle first(question.from, question.to);
    first.processTriangle(question.corners.data(), 0, 0);
    return first.m_hitFraction < 1 ? first.m_hitFraction * question.length : -1.0f;
  });
}

#endif

#if DETENT_BENCH_ODE

dReal as_ode(double x) { return static_cast<dReal>(x); }

void place(dGeomID geom, const Vec<double, 3>& center) {
  dGeomSetPosition(geom, as_ode(center.x), as_ode(center.y), as_ode(center.z));
}
dGeomID as_ode(const Sphere<double, 3>& sphere) {
  const auto geom = dCreateSphere(nullptr, as_ode(sphere.radius));
  place(geom, sphere.center);
  return geom;
}
dGeomID as_ode(const Aabb<double, 3>& box) {
  const auto sides = box.max - box.min;
  const auto geom = dCreateBox(nullptr, as_ode(sides.x), as_ode(sides.y), as_ode(sides.z));
  place(geom, (box.min + box.max) * 0.5);
  return geom;
}
dGeomID as_ode(const Obb<double, 3>& box) {
  const auto sides = box.half_extents * 2.0;
  const auto geom = dCreateBox(nullptr, as_ode(sides.x), as_ode(sides.y), as_ode(sides.z));
  place(geom, box.center);
  dMatrix3 matrix{};
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) matrix[4 * i + j] = as_ode(box.rotation.axis(j)[i]);
  }
  dGeomSetRotation(geom, matrix);
  return geom;
}
dGeomID as_ode(const Plane<double, 3>& plane) {
  return dCreatePlane(nullptr, as_ode(plane.normal[0]), as_ode(plane.normal[1]),
                      as_ode(plane.normal[2]), as_ode(plane.offset));
}

/// Geometries live until the program ends.
struct OdeQuestion {
  dGeomID ray;
  dGeomID shape;
};

template <class Q>
void add_ode(Suite& suite, const Q& query) {
  const auto drawn = draw_questions(query, suite.seed(), ordinary);
  std::vector<OdeQuestion> questions;
  for (const auto& [ray, shape] : drawn) {
    OdeQuestion question{dCreateRay(nullptr, as_ode(ray.max_distance)), as_ode(shape)};
    dGeomRaySet(question.ray, as_ode(ray.origin.x), as_ode(ray.origin.y), as_ode(ray.origin.z),
                as_ode(ray.direction[0]), as_ode(ray.direction[1]), as_ode(ray.direction[2]));
    dGeomRaySetClosestHit(question.ray, 1);
    questions.push_back(question);
  }
  add_engine(suite, query, "ODE", drawn, questions, [](const OdeQuestion& question) {
    dContactGeom contact;
    const int count = dCollide(question.ray, question.shape, 1, &contact, sizeof contact);
    return count > 0 ? static_cast<float>(contact.depth) : -1.0f;
  });
}

#endif

}  // namespace

void add_engines([[maybe_unused]] Suite& suite) {
#if DETENT_BENCH_BULLET
  for (const auto& [name, flags] :
       {std::pair{"Bullet", 0u},
        std::pair{"Bullet, GJK", unsigned{FirstTriangle::kF_UseGjkConvexCastRaytest}}}) {
    add_bullet(suite, query<Ray, Sphere>("raycast/sphere", ask_raycast), name, flags);
    add_bullet(suite, query<Ray, Aabb>("raycast/aabb", ask_raycast), name, flags);
    add_bullet(suite, query<Ray, Obb>("raycast/obb", ask_raycast), name, flags);
  }
  add_bullet_triangles(suite);
#endif
#if DETENT_BENCH_ODE
  dInitODE2(0);
  dAllocateODEDataForThread(dAllocateMaskAll);
  add_ode(suite, query<Ray, Sphere>("raycast/sphere", ask_raycast));
  add_ode(suite, query<Ray, Aabb>("raycast/aabb", ask_raycast));
  add_ode(suite, query<Ray, Obb>("raycast/obb", ask_raycast));
  add_ode(suite, query<Ray, Plane>("raycast/plane", ask_raycast));
#endif
}

}  // namespace detent::bench
