// SPDX-License-Identifier: MIT
//
// usage: detent-bench-meshes MODEL.ply [RAYS]
//
// Nearest hits of rays on a mesh and the time to build its tree, on one thread: detent in q16_16
// and in float from the same source, Embree in robust mode, and Bullet. The model is scaled to 200
// units; rays start on a sphere of radius 300 and aim at points of the inner box. All engines get
// the same corners and rays, alternately, and times are CPU time of the thread. The hit counts of
// detent and Embree must agree within one ray in 10,000.

#include <BulletCollision/NarrowPhaseCollision/btRaycastCallback.h>
#include <btBulletCollisionCommon.h>
#include <embree3/rtcore.h>
#include <sys/mman.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <memory>
#include <new>
#include <sstream>
#include <string>
#include <vector>

#include "detent/scene/mesh.hpp"
#include "support/random.hpp"

namespace {

using detent::q16_16;

/// This thread's CPU time in nanoseconds.
double now() {
  timespec time;
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) * 1e9 + static_cast<double>(time.tv_nsec);
}

struct Model {
  std::vector<std::array<float, 3>> vertices;
  std::vector<detent::VertexIndices> faces;
};

/// The vertices and triangles of an ASCII PLY file, scaled to 200 units around the origin on the
/// grid of q16_16.
Model load(const char* path) {
  Model model;
  std::ifstream in(path);
  std::size_t vertices = 0, faces = 0;
  for (std::string line; std::getline(in, line) && line.rfind("end_header", 0) != 0;) {
    if (line.rfind("element vertex ", 0) == 0) vertices = std::stoul(line.substr(15));
    if (line.rfind("element face ", 0) == 0) faces = std::stoul(line.substr(13));
  }
  std::array<float, 3> low{1e30F, 1e30F, 1e30F}, high{-1e30F, -1e30F, -1e30F};
  std::string line;
  while (vertices-- > 0 && std::getline(in, line)) {
    std::istringstream numbers(line);
    auto& vertex = model.vertices.emplace_back();
    for (std::size_t i = 0; i < 3; ++i) {
      numbers >> vertex[i];
      low[i] = std::min(low[i], vertex[i]);
      high[i] = std::max(high[i], vertex[i]);
    }
  }
  while (faces-- > 0 && std::getline(in, line)) {
    std::istringstream numbers(line);
    int corners = 0;
    auto& face = model.faces.emplace_back();
    numbers >> corners >> face[0] >> face[1] >> face[2];
  }
  double size = 0;
  for (std::size_t i = 0; i < 3; ++i) size = std::max<double>(size, high[i] - low[i]);
  for (auto& vertex : model.vertices) {
    for (std::size_t i = 0; i < 3; ++i) {
      const double centered = vertex[i] - (double{low[i]} + high[i]) / 2;
      vertex[i] = static_cast<float>(std::nearbyint(centered / size * 200 * 65536) / 65536);
    }
  }
  return model;
}

/// Storage as a game would provide it: in large pages, if the system has them.
template <class T>
class Storage {
 public:
  explicit Storage(std::size_t count) : count_(count) {
    constexpr std::size_t page = std::size_t{1} << 21;
    const std::size_t bytes = (count * sizeof(T) + page - 1) / page * page;
    data_ = static_cast<T*>(std::aligned_alloc(page, bytes));
    madvise(data_, bytes, MADV_HUGEPAGE);
    std::uninitialized_value_construct_n(data_, count);
  }
  Storage(const Storage&) = delete;
  Storage& operator=(const Storage&) = delete;
  ~Storage() { std::free(data_); }
  [[nodiscard]] std::span<T> all() const { return {data_, count_}; }

 private:
  T* data_;
  std::size_t count_;
};

template <class S>
S scalar(double x) {
  if constexpr (detent::is_fixed<S>) {
    return S::from_double(x);
  } else {
    return static_cast<S>(x);
  }
}

template <class S>
class Ours {
 public:
  explicit Ours(const Model& model)
      : triangles_(model.faces.size()), nodes_(detent::tree_capacity(model.faces.size())) {
    for (const auto& v : model.vertices) {
      vertices_.push_back({scalar<S>(v[0]), scalar<S>(v[1]), scalar<S>(v[2])});
    }
    build(model);
  }
  /// Builds the tree; returns the milliseconds it took.
  double build(const Model& model) {
    const double start = now();
    if (!detent::assemble_triangles<S>(vertices_, model.faces, triangles_.all())) std::abort();
    mesh_ = detent::build_mesh(triangles_.all(), nodes_.all()).value();
    return (now() - start) / 1e6;
  }
  [[nodiscard]] bool hit(const detent::Ray<S, 3>& ray) const {
    return raycast_nearest(ray, mesh_).has_value();
  }

 private:
  std::vector<detent::Vec<S, 3>> vertices_;
  Storage<detent::MeshTriangle<S>> triangles_;
  Storage<detent::MeshNode<S>> nodes_;
  detent::Mesh<S> mesh_;
};

class Embree {
 public:
  explicit Embree(const Model& model) : device_(rtcNewDevice("threads=1")) { build(model); }
  double build(const Model& model) {
    if (scene_ != nullptr) rtcReleaseScene(scene_);
    const double start = now();
    scene_ = rtcNewScene(device_);
    rtcSetSceneFlags(scene_, RTC_SCENE_FLAG_ROBUST);
    rtcSetSceneBuildQuality(scene_, RTC_BUILD_QUALITY_HIGH);
    const RTCGeometry mesh = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
    const auto copy = [&](const auto& list, RTCBufferType type, RTCFormat format) {
      std::copy_n(list.front().data(), 3 * list.size(),
                  static_cast<std::remove_cvref_t<decltype(list[0][0])>*>(rtcSetNewGeometryBuffer(
                      mesh, type, 0, format, sizeof(list[0]), list.size())));
    };
    copy(model.vertices, RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT3);
    copy(model.faces, RTC_BUFFER_TYPE_INDEX, RTC_FORMAT_UINT3);
    rtcSetGeometryBuildQuality(mesh, RTC_BUILD_QUALITY_HIGH);
    rtcCommitGeometry(mesh);
    rtcAttachGeometry(scene_, mesh);
    rtcReleaseGeometry(mesh);
    rtcCommitScene(scene_);
    return (now() - start) / 1e6;
  }
  [[nodiscard]] bool hit(const detent::Ray<float, 3>& ray) const {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    RTCRayHit query{};
    query.ray.org_x = ray.origin.x;
    query.ray.org_y = ray.origin.y;
    query.ray.org_z = ray.origin.z;
    query.ray.dir_x = ray.direction[0];
    query.ray.dir_y = ray.direction[1];
    query.ray.dir_z = ray.direction[2];
    query.ray.tfar = ray.max_distance;
    query.ray.mask = ~0U;
    query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    query.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
    rtcIntersect1(scene_, &context, &query);
    return query.hit.geomID != RTC_INVALID_GEOMETRY_ID;
  }

 private:
  RTCDevice device_;
  RTCScene scene_ = nullptr;
};

class Bullet {
 public:
  explicit Bullet(Model& model)
      : arrays_(static_cast<int>(model.faces.size()), reinterpret_cast<int*>(model.faces.data()),
                sizeof(model.faces[0]), static_cast<int>(model.vertices.size()),
                model.vertices.front().data(), sizeof(model.vertices[0])) {
    build();
  }
  double build() {
    const double start = now();
    shape_ = std::make_unique<btBvhTriangleMeshShape>(&arrays_, true, true);
    return (now() - start) / 1e6;
  }
  [[nodiscard]] bool hit(const detent::Ray<float, 3>& ray) const {
    const btVector3 from(ray.origin.x, ray.origin.y, ray.origin.z);
    const btVector3 along(ray.direction[0], ray.direction[1], ray.direction[2]);
    const btVector3 to = from + along * ray.max_distance;
    struct Nearest : btTriangleRaycastCallback {
      using btTriangleRaycastCallback::btTriangleRaycastCallback;
      bool hit = false;
      btScalar reportHit(const btVector3&, btScalar fraction, int, int) override {
        hit = true;
        return fraction;
      }
    } nearest(from, to);
    shape_->performRaycast(&nearest, from, to);
    return nearest.hit;
  }

 private:
  btTriangleIndexVertexArray arrays_;
  std::unique_ptr<btBvhTriangleMeshShape> shape_;
};

struct Rays {
  std::vector<detent::Ray<q16_16, 3>> fixed;
  std::vector<detent::Ray<float, 3>> floating;
};

Rays draw_rays(const Model& model, std::size_t count) {
  detent::test::Random random(7);
  const auto uniform = [&] { return static_cast<double>(random.next() >> 11) * 0x1p-53; };
  std::array<double, 3> half{};
  for (const auto& vertex : model.vertices) {
    for (std::size_t i = 0; i < 3; ++i) half[i] = std::max<double>(half[i], std::abs(vertex[i]));
  }
  Rays rays;
  while (rays.fixed.size() < count) {
    const double z = 2 * uniform() - 1, angle = 2 * 3.14159265358979 * uniform();
    const double flat = std::sqrt(1 - z * z);
    const std::array from{300 * flat * std::cos(angle), 300 * flat * std::sin(angle), 300 * z};
    detent::Vec<q16_16, 3> origin, way;
    for (int i = 0; i < 3; ++i) {
      const auto k = static_cast<std::size_t>(i);
      origin[i] = q16_16::from_double(from[k]);
      way[i] = q16_16::from_double(half[k] * (uniform() - 0.5) - from[k]);  // the inner half
    }
    const auto direction = normalize(way);
    if (!direction) continue;
    rays.fixed.push_back({origin, *direction, q16_16(1000)});
    const auto as_float = [](const auto& v) {
      return detent::make_vec<3>([&](int i) { return static_cast<float>(double(v[i])); });
    };
    rays.floating.push_back({as_float(origin), *normalize(as_float(way)), 1000});
  }
  return rays;
}

/// The time and hits of one engine.
struct Tally {
  double time = 0;
  std::size_t rays = 0, hits = 0;

  template <class Engine, class Ray>
  void run(const Engine& engine, const std::vector<Ray>& list, std::size_t count) {
    const double start = now();
    for (std::size_t i = 0; i < count; ++i) hits += engine.hit(list[i]) ? 1 : 0;
    time += now() - start;
    rays += count;
  }
  [[nodiscard]] double per_ray() const { return time / static_cast<double>(rays); }
};

}  // namespace

int main(int count, char** arguments) {
  if (count < 2) {
    std::puts("usage: detent-bench-meshes MODEL.ply [RAYS]");
    return 2;
  }
  Model model = load(arguments[1]);
  if (model.faces.empty()) {
    std::printf("%s: no triangles; an ASCII PLY file is expected\n", arguments[1]);
    return 2;
  }
  const auto rays = draw_rays(model, count > 2 ? std::stoul(arguments[2]) : 40'000);
  Ours<q16_16> fixed(model);
  Ours<float> floating(model);
  Embree embree(model);
  Bullet bullet(model);
  Tally in_fixed, in_float, in_embree, in_bullet;
  std::array<double, 4> built{1e30, 1e30, 1e30, 1e30};
  for (int round = 0; round < 5; ++round) {
    built[0] = std::min(built[0], fixed.build(model));
    built[1] = std::min(built[1], floating.build(model));
    built[2] = std::min(built[2], embree.build(model));
    built[3] = std::min(built[3], bullet.build());
    in_fixed.run(fixed, rays.fixed, rays.fixed.size());
    in_float.run(floating, rays.floating, rays.floating.size());
    in_embree.run(embree, rays.floating, rays.floating.size());
    in_bullet.run(bullet, rays.floating, rays.floating.size() / 10);
  }
  std::printf("%zu triangles, %zu rays, %s\n", model.faces.size(), rays.fixed.size(), __VERSION__);
  const auto row = [&](const char* name, double build, const Tally& tally) {
    std::printf(
        "%-16s build %7.1f ms (%.2f of Embree)  nearest %7.0f ns (%.2f of Embree)  %.2f %% hit\n",
        name, build, build / built[2], tally.per_ray(), tally.per_ray() / in_embree.per_ray(),
        100 * static_cast<double>(tally.hits) / static_cast<double>(tally.rays));
  };
  row("detent q16_16", built[0], in_fixed);
  row("detent float", built[1], in_float);
  row("Embree robust", built[2], in_embree);
  row("Bullet", built[3], in_bullet);
  const auto ours = static_cast<double>(in_fixed.hits),
             theirs = static_cast<double>(in_embree.hits);
  if (std::abs(ours - theirs) > 1e-4 * static_cast<double>(in_fixed.rays)) {
    std::puts("detent and Embree disagree");
    return 1;
  }
  return 0;
}
