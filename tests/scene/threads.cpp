// SPDX-License-Identifier: MIT
//
// usage: threads [--plant]
// Four threads run the same queries on a scene, a mesh, a height field and batches at once, and
// must get the results of a single thread. Built with the thread sanitizer, which reports any
// unsynchronised access. With --plant one thread moves an object meanwhile, which must be reported.

#include <array>
#include <cstdio>
#include <cstring>
#include <optional>
#include <thread>
#include <vector>

#include "detent/query/batch.hpp"
#include "detent/scene/height_field.hpp"
#include "detent/scene/mesh.hpp"
#include "detent/scene/mesh/owned.hpp"
#include "detent/scene/snapshot.hpp"
#include "support/random.hpp"

namespace {

using namespace detent;
using S = q16_16;
using V = Vec<S, 3>;

/// The data that the threads share and only read.
class Shared {
 public:
  Shared() : random_(0x7443ad), soup_(draw_triangles()), rock_(std::span(soup_)) {
    meshes_.push_back({7, rock_.view()});
    for (auto& height : heights_) height = number(3);
    const auto place = scene_.add_frame({.translation = point(4)});
    for (int i = 0; i < 300; ++i) {
      const Traits traits{.layers = random_.coin() ? 1u : 2u,
                          .motion = random_.one_in(3) ? Motion::fixed : Motion::moving};
      if (random_.coin()) {
        scene_.add(Sphere<S, 3>{point(60), S(3)}, traits);
      } else {
        scene_.add(Obb<S, 3>{point(60), V{S(2), S(3), S(1)}, {}}, traits);
      }
    }
    scene_.add(PlacedMesh<S>{&meshes_[0], {.translation = point(20)}});
    scene_.add(Sphere<S, 3>{point(9), S(2)}, {.frame = place.value_or(no_frame)});
    last_ = scene_.add(Sphere<S, 3>{V(), S(2)}).value_or(no_object);
    for (int i = 0; i < 40; ++i) {
      const auto direction = normalize(point(50));
      rays_.push_back({point(90), direction ? *direction : Direction<S, 3>::along(0)});
    }
    for (int i = 0; i < 200; ++i) balls_.push_back({point(60), S(2)});
    ray_blocks_.resize(batch_blocks(rays_.size()));
    ball_blocks_.resize(batch_blocks(balls_.size()));
    field_ = *height_field<S>({S(-32), S(-32)}, S(8), 9, 9, heights_);
    batch_of_rays_.emplace(rays_, Aabb<S, 3>{V{S(-90), S(-90), S(-90)}, V{S(90), S(90), S(90)}},
                           ray_blocks_);
    batch_of_balls_.emplace(balls_, ball_blocks_);
  }

  /// Runs every kind of query; returns a digest of the results.
  [[nodiscard]] std::uint64_t ask() const {
    Digest digest;
    const auto mesh = rock_.view();
    const auto list = [&](const auto& found) {
      for (const auto& [distance, id] : found) digest.add(distance, id.index);
    };
    for (const auto& ray : rays_) {
      const auto first = scene_.nearest_hit(ray);
      digest.add(first.has_value(), scene_.any(ray, InLayers{2}));
      if (first) digest.add(first->distance, first->id.index, first->point, first->normal.vec());
      list(scene_.all(ray));
      const Sphere<S, 3> ball{ray.origin, S(20)};
      list(scene_.all(ball));
      list(scene_.all(Capsule<S, 3>{ray.origin, V(), S(4)}));
      digest.add(scene_.any(bounding_box(ball)), scene_.any(Segment<S, 3>{ray.origin, V()}));
      if (const auto nearest = scene_.nearest(ray.origin)) digest.add(nearest->distance);
      if (const auto far =
              scene_.nearest(Cast{Sphere<S, 3>{ray.origin, S(1)}, ray.direction, S(99)})) {
        digest.add(far->distance);
      }
      digest.add(raycast_nearest(ray, mesh));
      digest.add(nearest_triangle(mesh, ray.origin));
      digest.add(raycast_any(ray, mesh), overlaps(mesh, ball), distance(mesh, ball));
      digest.add(raycast_nearest(ray, field_));
      digest.add(nearest_triangle(field_, ray.origin));
      digest.add(overlaps(field_, ball), raycast_any(ray, *batch_of_balls_));
    }
    for (const auto& [a, b] : scene_.overlaps()) digest.add(a.index, b.index);
    std::vector<std::optional<S>> distances(rays_.size());
    raycast_each<S, 3>(*batch_of_rays_, balls_[0], distances);
    for (const auto& distance : distances) digest.add(distance);
    digest.add(detent::digest(scene_), static_cast<std::uint64_t>(snapshot(scene_).size()));
    return digest.value();
  }

  /// What no thread may do while others query.
  [[nodiscard]] bool disturb(int i) { return scene_.move(last_, V{S(i % 2), S(0), S(0)}); }

 private:
  S number(int limit) { return S(random_.between(-limit, limit)); }
  V point(int limit) {
    const S x = number(limit), y = number(limit);
    return {x, y, number(limit)};
  }
  std::vector<Triangle<S, 3>> draw_triangles() {
    std::vector<Triangle<S, 3>> list(200);
    for (auto& triangle : list) {
      const V corner = point(30);
      const auto near = [&] { return nearest_to<S>(corner + point(8)); };
      const V second = near();
      triangle = {corner, second, near()};
    }
    return list;
  }
  test::Random random_;
  std::vector<Triangle<S, 3>> soup_;
  OwnedMesh<S> rock_;
  std::vector<MeshAsset<S>> meshes_;
  std::array<S, 81> heights_{};
  HeightField<S> field_;
  Scene<S, 3, Sphere, Obb, MeshInstance> scene_;
  ObjectId last_;
  std::vector<Ray<S, 3>> rays_;
  std::vector<Sphere<S, 3>> balls_;
  std::vector<RayBatch<S, 3>::Block> ray_blocks_;
  std::vector<ShapeBatch<Sphere<S, 3>>::Block> ball_blocks_;
  std::optional<RayBatch<S, 3>> batch_of_rays_;
  std::optional<ShapeBatch<Sphere<S, 3>>> batch_of_balls_;
};

}  // namespace

int main(int count, char** arguments) {
  const bool plants = count > 1 && std::strcmp(arguments[1], "--plant") == 0;
  Shared shared;
  const std::uint64_t expected = shared.ask();
  std::array<std::uint64_t, 4> answers{};
  std::vector<std::thread> threads;
  for (auto& answer : answers) {
    threads.emplace_back([&] { answer = shared.ask(); });
  }
  // Often: the sanitizer remembers only the last accesses to each word.
  for (int i = 0; plants && i < 1000; ++i) {
    if (!shared.disturb(i)) return 1;
  }
  for (auto& thread : threads) thread.join();
  for (const auto answer : answers) {
    if (answer == expected || plants) continue;
    std::puts("a thread got other answers");
    return 1;
  }
  return 0;
}
