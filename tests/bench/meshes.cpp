// SPDX-License-Identifier: MIT
//
// usage: detent-bench-meshes NAME [MODEL.obj|MODEL.ply]
//
// Times rays on a mesh and the construction of its tree, on one thread: detent in q16_16 and in
// float from the same source, Embree in robust mode, and Bullet. The model, or a bumpy ball of
// 204,800 triangles, is scaled to 200 units. Random rays start on a sphere of radius 300 and aim at
// points of the inner box; camera rays are the pixels of a picture of the model. All engines get
// the same corners and rays, alternating. Prints rows "question,triangles,engine,time" in CPU
// nanoseconds, each the median of a few rounds, where q16_16 is called NAME. The hit counts of
// detent and Embree must agree within one ray in 10,000. tests/bench/engines makes a table of the
// rows.

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

/// The vertices and triangles of an ASCII PLY file.
Model load_ply(std::ifstream& in) {
  Model model;
  std::size_t vertices = 0, faces = 0;
  for (std::string line; std::getline(in, line) && line.rfind("end_header", 0) != 0;) {
    if (line.rfind("element vertex ", 0) == 0) vertices = std::stoul(line.substr(15));
    if (line.rfind("element face ", 0) == 0) faces = std::stoul(line.substr(13));
  }
  std::string line;
  while (vertices-- > 0 && std::getline(in, line)) {
    std::istringstream numbers(line);
    auto& vertex = model.vertices.emplace_back();
    for (auto& x : vertex) numbers >> x;
  }
  while (faces-- > 0 && std::getline(in, line)) {
    std::istringstream numbers(line);
    int corners = 0;
    auto& face = model.faces.emplace_back();
    numbers >> corners >> face[0] >> face[1] >> face[2];
  }
  return model;
}

/// The vertices and triangles of an OBJ file, whose faces are triangles.
Model load_obj(std::ifstream& in) {
  Model model;
  for (std::string line; std::getline(in, line);) {
    std::istringstream words(line);
    std::string word;
    words >> word;
    if (word == "v") {
      auto& vertex = model.vertices.emplace_back();
      for (auto& x : vertex) words >> x;
    } else if (word == "f") {
      auto& face = model.faces.emplace_back();
      for (auto& corner : face) {
        words >> word;  // a slash and other indices may follow
        corner = static_cast<std::uint32_t>(std::stoul(word)) - 1;
      }
    }
  }
  return model;
}

/// A ball of 320 x 320 squares with a bumpy surface.
Model bumpy_ball() {
  constexpr int side = 320;
  constexpr double pi = 3.14159265358979;
  Model model;
  for (int i = 0; i <= side; ++i) {
    for (int j = 0; j <= side; ++j) {
      const double up = pi * i / side, around = 2 * pi * j / side;
      const double radius = 1 + 0.1 * std::sin(13 * up) * std::cos(9 * around) +
                            0.02 * std::sin(61 * up + 47 * around);
      model.vertices.push_back({static_cast<float>(radius * std::sin(up) * std::cos(around)),
                                static_cast<float>(radius * std::cos(up)),
                                static_cast<float>(radius * std::sin(up) * std::sin(around))});
    }
  }
  for (std::uint32_t i = 0; i < side; ++i) {
    for (std::uint32_t j = 0; j < side; ++j) {
      const std::uint32_t a = i * (side + 1) + j, b = a + side + 1;
      model.faces.push_back({a, a + 1, b});
      model.faces.push_back({a + 1, b + 1, b});
    }
  }
  return model;
}

/// A model scaled to 200 units around the origin, on the grid of q16_16.
Model load(const std::string& path) {
  std::ifstream in(path);
  Model model = path.empty() ? bumpy_ball() : path.ends_with(".obj") ? load_obj(in) : load_ply(in);
  std::array<float, 3> low{1e30F, 1e30F, 1e30F}, high{-1e30F, -1e30F, -1e30F};
  for (const auto& vertex : model.vertices) {
    for (std::size_t i = 0; i < 3; ++i) {
      low[i] = std::min(low[i], vertex[i]);
      high[i] = std::max(high[i], vertex[i]);
    }
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
  /// Builds the tree. Returns the milliseconds taken.
  double build(const Model& model) {
    const double start = now();
    if (!detent::assemble_triangles<S>(vertices_, model.faces, triangles_.all())) std::abort();
    mesh_ = detent::build_mesh(triangles_.all(), nodes_.all()).value();
    return (now() - start) / 1e6;
  }
  [[nodiscard]] bool hit(const detent::Ray<S, 3>& ray) const {
    return raycast_nearest(ray, mesh_).has_value();
  }
  [[nodiscard]] bool hit_any(const detent::Ray<S, 3>& ray) const { return raycast_any(ray, mesh_); }
  /// The size of triangles and tree together.
  [[nodiscard]] double bytes_a_triangle() const {
    return static_cast<double>(mesh_.triangles.size_bytes() + mesh_.tree.nodes.size_bytes()) /
           static_cast<double>(mesh_.triangles.size());
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
  [[nodiscard]] bool hit_any(const detent::Ray<float, 3>& ray) const {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    RTCRay query{};
    query.org_x = ray.origin.x;
    query.org_y = ray.origin.y;
    query.org_z = ray.origin.z;
    query.dir_x = ray.direction[0];
    query.dir_y = ray.direction[1];
    query.dir_z = ray.direction[2];
    query.tfar = ray.max_distance;
    query.mask = ~0U;
    rtcOccluded1(scene_, &context, &query);
    return query.tfar < 0;
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

  void add(const detent::Vec<q16_16, 3>& origin, const detent::Vec<q16_16, 3>& way) {
    const auto direction = normalize(way);
    if (!direction) return;
    fixed.push_back({origin, *direction, q16_16(1000)});
    const auto as_float = [](const auto& v) {
      return detent::make_vec<3>([&](int i) { return static_cast<float>(double(v[i])); });
    };
    floating.push_back({as_float(origin), *normalize(as_float(way)), 1000});
  }
};

/// The pixels of a picture of 240 x 160, line by line.
Rays camera_rays() {
  Rays rays;
  for (int y = 0; y < 160; ++y) {
    for (int x = 0; x < 240; ++x) {
      rays.add({q16_16(40), q16_16(80), q16_16(260)},
               {q16_16::from_double((x - 120) * 0.9 - 40), q16_16::from_double((80 - y) * 0.9 - 80),
                q16_16(-260)});
    }
  }
  return rays;
}

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
    rays.add(origin, way);
  }
  return rays;
}

/// The times of a task by round, and the hits of the last round.
struct Times {
  std::vector<double> list;
  std::size_t hits = 0;

  template <class Task>
  void run(std::size_t count, const Task& task) {
    const double start = now();
    hits = task();
    list.push_back((now() - start) / static_cast<double>(count));
  }
  [[nodiscard]] double median() {
    std::sort(list.begin(), list.end());
    return list[list.size() / 2];
  }
};

/// Casts rays in every engine alternately, and prints the times. False if hits differ by too many.
bool compare(const std::string& name, const std::string& kind, const Rays& rays,
             const Ours<q16_16>& fixed, const Ours<float>& floating, const Embree& embree,
             const Bullet& bullet, std::size_t triangles) {
  const std::size_t count = rays.fixed.size();
  const auto nearest = [](const auto& engine, const auto& list, std::size_t step) {
    std::size_t hits = 0;
    for (std::size_t i = 0; i < list.size(); i += step) hits += engine.hit(list[i]) ? 1 : 0;
    return hits;
  };
  const auto any = [](const auto& engine, const auto& list) {
    std::size_t hits = 0;
    for (const auto& ray : list) hits += engine.hit_any(ray) ? 1 : 0;
    return hits;
  };
  std::array<Times, 7> times;
  for (int round = 0; round < 9; ++round) {
    times[0].run(count, [&] { return nearest(fixed, rays.fixed, 1); });
    times[1].run(count, [&] { return nearest(floating, rays.floating, 1); });
    times[2].run(count, [&] { return nearest(embree, rays.floating, 1); });
    times[3].run(count / 10, [&] { return nearest(bullet, rays.floating, 10); });
    times[4].run(count, [&] { return any(fixed, rays.fixed); });
    times[5].run(count, [&] { return any(floating, rays.floating); });
    times[6].run(count, [&] { return any(embree, rays.floating); });
  }
  const std::array engines{name.c_str(), "float", "Embree", "Bullet"};
  for (std::size_t i = 0; i < times.size(); ++i) {
    std::printf("%s %s,%zu,%s,%.1f\n", kind.c_str(), i < 4 ? "nearest" : "any", triangles,
                engines[i % 4], times[i].median());
  }
  const auto allowed = static_cast<double>(count) * 1e-4;
  return times[0].hits == times[4].hits && std::abs(static_cast<double>(times[0].hits) -
                                                    static_cast<double>(times[2].hits)) <= allowed;
}

}  // namespace

int main(int count, char** arguments) {
  if (count < 2 || arguments[1][0] == '-') {
    std::puts("usage: detent-bench-meshes NAME [MODEL.obj|MODEL.ply]");
    return 2;
  }
  const std::string name = arguments[1], path = count > 2 ? arguments[2] : "";
  Model model = load(path);
  if (model.faces.empty()) {
    std::printf("%s: no triangles; an OBJ or an ASCII PLY file is expected\n", path.c_str());
    return 2;
  }
  const std::size_t triangles = model.faces.size();
  Ours<q16_16> fixed(model);
  Ours<float> floating(model);
  Embree embree(model);
  Bullet bullet(model);
  std::array<std::vector<double>, 4> built;
  for (int round = 0; round < 7; ++round) {
    built[0].push_back(fixed.build(model));
    built[1].push_back(floating.build(model));
    built[2].push_back(embree.build(model));
    built[3].push_back(bullet.build());
  }
  const std::array engines{name.c_str(), "float", "Embree", "Bullet"};
  for (std::size_t i = 0; i < built.size(); ++i) {
    std::sort(built[i].begin(), built[i].end());
    std::printf("build,%zu,%s,%.0f\n", triangles, engines[i], 1e6 * built[i][built[i].size() / 2]);
  }
  std::printf("bytes a triangle,%zu,%s,%.1f\n", triangles, name.c_str(), fixed.bytes_a_triangle());
  const bool agree =
      compare(name, "random", draw_rays(model, 40'000), fixed, floating, embree, bullet,
              triangles) &
      compare(name, "camera", camera_rays(), fixed, floating, embree, bullet, triangles);
  if (!agree) {
    std::puts("detent and Embree disagree");
    return 1;
  }
  return 0;
}
