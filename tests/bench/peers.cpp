// SPDX-License-Identifier: MIT
// Distances and contacts of two other libraries, on the same inputs in the same run. As packaged,
// they work in double, and they also return the closest points or the normal.

#include "bench/pairs.hpp"
#include "bench/suite.hpp"
#if DETENT_BENCH_FCL
#include <fcl/narrowphase/collision.h>
#include <fcl/narrowphase/distance.h>
#endif
#if DETENT_BENCH_CCD
#include <ccd/ccd.h>
#endif

namespace detent::bench {

namespace {

inline double length_of(const q16_16& distance) { return static_cast<double>(distance); }
inline double length_of(const std::optional<Contact<q16_16, 3>>& contact) {
  return contact ? static_cast<double>(contact->depth) : -1.0;
}
/// A distance is a hit if it is greater than 0, a depth if there is one.
template <class Answer>
bool is_hit_of(double length) {
  return is_fixed<Answer> ? length > 0 : length >= 0;
}

/// `ask` returns a length or a negative number.
template <class Q, class Question, class Ask>
void add_peer(Suite& suite, const Q& query, const std::string& peer,
              const std::vector<typename Q::template Question<double>>& drawn,
              const std::vector<Question>& questions, const Ask& ask) {
  const auto judge = []<class Answer>(const Answer& exact, double length) {
    const double truth = length_of(exact);
    return Judged{is_hit_of<Answer>(truth), is_hit_of<Answer>(length), std::abs(length - truth)};
  };
  add_other(suite, query, peer, drawn, questions, ask, judge,
            [](double length) { return length > 0; });
}

#if DETENT_BENCH_FCL

fcl::Vector3d as_fcl(const Vec<double, 3>& v) { return {v.x, v.y, v.z}; }

/// A shape and its pose, which FCL keeps separately.
struct FclShape {
  std::shared_ptr<fcl::CollisionGeometryd> shape;
  fcl::Transform3d pose = fcl::Transform3d::Identity();
};

FclShape as_fcl(const Sphere<double, 3>& sphere) {
  FclShape result{std::make_shared<fcl::Sphered>(sphere.radius)};
  result.pose.translation() = as_fcl(sphere.center);
  return result;
}
FclShape as_fcl(const Aabb<double, 3>& box) {
  FclShape result{std::make_shared<fcl::Boxd>(as_fcl(box.max - box.min))};
  result.pose.translation() = as_fcl((box.min + box.max) * 0.5);
  return result;
}
FclShape as_fcl(const Obb<double, 3>& box) {
  FclShape result{std::make_shared<fcl::Boxd>(as_fcl(box.half_extents * 2.0))};
  result.pose.translation() = as_fcl(box.center);
  for (int i = 0; i < 3; ++i) result.pose.linear().col(i) = as_fcl(box.rotation.axis(i).vec());
  return result;
}
/// The corners of a hull and its faces: every three points with all others behind them.
FclShape as_fcl(const Rock<double, 3>& rock) {
  const auto& points = rock.points;
  const int count = static_cast<int>(points.size());
  const auto at = [&](int i) { return points[static_cast<std::size_t>(i)]; };
  std::vector<std::array<int, 3>> triangles;
  for (int i = 0; i < count; ++i) {
    for (int j = 0; j < count; ++j) {
      for (int k = 0; k < count; ++k) {
        if (i > j || i > k || i == j || i == k || j == k) continue;
        const auto normal = cross(at(j) - at(i), at(k) - at(i));
        bool is_face = true;
        for (int l = 0; l < count && is_face; ++l) is_face = dot(normal, at(l) - at(i)) <= 0;
        if (is_face) triangles.push_back({i, j, k});
      }
    }
  }
  std::vector<int> used(points.size(), -1);
  const auto corners = std::make_shared<std::vector<fcl::Vector3d>>();
  const auto faces = std::make_shared<std::vector<int>>();
  for (const auto& triangle : triangles) {
    faces->push_back(3);
    for (const int i : triangle) {
      int& corner = used[static_cast<std::size_t>(i)];
      if (corner < 0) {
        corner = static_cast<int>(corners->size());
        corners->push_back(as_fcl(at(i)));
      }
      faces->push_back(corner);
    }
  }
  return {std::make_shared<fcl::Convexd>(corners, static_cast<int>(triangles.size()), faces)};
}

struct FclQuestion {
  FclShape a, b;
};
template <class Drawn>
std::vector<FclQuestion> as_fcl(const std::vector<Drawn>& drawn) {
  std::vector<FclQuestion> questions;
  for (const auto& [a, b] : drawn) questions.push_back({as_fcl(a), as_fcl(b)});
  return questions;
}

/// FCL's two solvers: libccd's, which is the default, and its own.
constexpr std::pair<const char*, fcl::GJKSolverType> fcl_solvers[] = {
    {"FCL", fcl::GST_LIBCCD}, {"FCL, own solver", fcl::GST_INDEP}};

/// `compute`, or -1 if FCL gives up.
template <class Compute>
double or_nothing(const Compute& compute) {
  try {
    return compute();
  } catch (const std::exception&) {
    return -1;
  }
}

template <class Q>
void add_fcl_distances(Suite& suite, const Q& query) {
  const auto drawn = draw_questions(query, suite.seed(), ordinary);
  const auto questions = as_fcl(drawn);
  for (const auto& [name, solver] : fcl_solvers) {
    const auto ask = [solver = solver](const FclQuestion& question) {
      return or_nothing([&] {
        fcl::DistanceRequestd request(true);
        request.gjk_solver_type = solver;
        fcl::DistanceResultd result;
        return fcl::distance(question.a.shape.get(), question.a.pose, question.b.shape.get(),
                             question.b.pose, request, result);
      });
    };
    add_peer(suite, query, name, drawn, questions, ask);
  }
}

template <class Q>
void add_fcl_contacts(Suite& suite, const Q& query) {
  const auto drawn = draw_questions(query, suite.seed(), ordinary);
  const auto questions = as_fcl(drawn);
  for (const auto& [name, solver] : fcl_solvers) {
    const auto ask = [solver = solver](const FclQuestion& question) {
      return or_nothing([&] {
        fcl::CollisionRequestd request(1, true);
        request.gjk_solver_type = solver;
        fcl::CollisionResultd result;
        fcl::collide(question.a.shape.get(), question.a.pose, question.b.shape.get(),
                     question.b.pose, request, result);
        return result.numContacts() > 0 ? std::abs(result.getContact(0).penetration_depth) : -1.0;
      });
    };
    add_peer(suite, query, name, drawn, questions, ask);
  }
}

#endif

#if DETENT_BENCH_CCD

ccd_vec3_t as_ccd(const Vec<double, 3>& v) { return {{v.x, v.y, v.z}}; }
Vec<double, 3> of_ccd(const ccd_vec3_t& v) { return {v.v[0], v.v[1], v.v[2]}; }

Vec<double, 3> center_of(const Aabb<double, 3>& box) { return (box.min + box.max) * 0.5; }
Vec<double, 3> center_of(const Obb<double, 3>& box) { return box.center; }
Vec<double, 3> center_of(const Sphere<double, 3>& sphere) { return sphere.center; }
Vec<double, 3> center_of(const Rock<double, 3>& rock) {
  Vec<double, 3> sum;
  for (const auto& point : rock.points) sum += point;
  return sum * (1.0 / static_cast<double>(rock.points.size()));
}

Vec<double, 3> support_of(const Aabb<double, 3>& box, const Vec<double, 3>& way) {
  return make_vec<3>([&](int i) { return way[i] > 0 ? box.max[i] : box.min[i]; });
}
Vec<double, 3> support_of(const Obb<double, 3>& box, const Vec<double, 3>& way) {
  auto corner = box.center;
  for (int i = 0; i < 3; ++i) {
    const auto axis = box.rotation.axis(i).vec();
    corner += axis * (dot(axis, way) > 0 ? box.half_extents[i] : -box.half_extents[i]);
  }
  return corner;
}
Vec<double, 3> support_of(const Sphere<double, 3>& sphere, const Vec<double, 3>& way) {
  return sphere.center + way * (sphere.radius / std::sqrt(dot(way, way)));
}
Vec<double, 3> support_of(const Rock<double, 3>& rock, const Vec<double, 3>& way) {
  std::size_t best = 0;
  double most = dot(rock.points[0], way);
  for (std::size_t i = 1; i < rock.points.size(); ++i) {
    const double height = dot(rock.points[i], way);
    if (height <= most) continue;
    best = i;
    most = height;
  }
  return rock.points[best];
}

template <class Shape>
void ccd_center(const void* shape, ccd_vec3_t* center) {
  *center = as_ccd(center_of(*static_cast<const Shape*>(shape)));
}
template <class Shape>
void ccd_support(const void* shape, const ccd_vec3_t* way, ccd_vec3_t* point) {
  *point = as_ccd(support_of(*static_cast<const Shape*>(shape), of_ccd(*way)));
}

/// With libccd's two algorithms: the expanding polytope, and portal refinement, whose depth need
/// not be the least.
template <class Q>
void add_ccd_contacts(Suite& suite, const Q& query) {
  using Question = typename Q::template Question<double>;
  using A = typename Q::template First<double>;
  using B = typename Q::template Second<double>;
  const auto drawn = draw_questions(query, suite.seed(), ordinary);
  for (const auto& [name, penetration] : {std::pair{"libccd, EPA", &ccdGJKPenetration},
                                          std::pair{"libccd, MPR", &ccdMPRPenetration}}) {
    const auto ask = [penetration = penetration](const Question& question) {
      ccd_t ccd;
      CCD_INIT(&ccd);
      ccd.support1 = ccd_support<A>;
      ccd.support2 = ccd_support<B>;
      ccd.center1 = ccd_center<A>;
      ccd.center2 = ccd_center<B>;
      ccd.max_iterations = 500;
      ccd_real_t depth = 0;
      ccd_vec3_t way{}, place{};
      const int status = penetration(&question.first, &question.second, &ccd, &depth, &way, &place);
      return status == 0 ? depth : -1.0;
    };
    add_peer(suite, query, name, drawn, drawn, ask);
  }
}

#endif

template <class Visit>
void visit_peer_distances(const Visit& visit) {
  visit(query<Sphere, Obb>("distance/sphere_obb", ask_pair_distance));
  visit(query<Aabb, Aabb>("distance/aabb_aabb", ask_pair_distance));
  visit(query<Obb, Obb>("distance/obb_obb", ask_pair_distance));
  visit(query<Rock, Rock>("distance/hull_hull", ask_pair_distance));
}
template <class Visit>
void visit_peer_contacts(const Visit& visit) {
  visit(query<Sphere, Obb>("contact/sphere_obb", ask_contact));
  visit(query<Aabb, Aabb>("contact/aabb_aabb", ask_contact));
  visit(query<Obb, Obb>("contact/obb_obb", ask_contact));
  visit(query<Rock, Rock>("contact/hull_hull", ask_contact));
}

}  // namespace

void add_peers([[maybe_unused]] Suite& suite) {
#if DETENT_BENCH_FCL
  visit_peer_distances([&](const auto& query) { add_fcl_distances(suite, query); });
  visit_peer_contacts([&](const auto& query) { add_fcl_contacts(suite, query); });
#endif
#if DETENT_BENCH_CCD
  visit_peer_contacts([&](const auto& query) { add_ccd_contacts(suite, query); });
#endif
}

}  // namespace detent::bench
