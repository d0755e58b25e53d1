// SPDX-License-Identifier: MIT
// One ray against 4096 shapes, and 4096 rays against one shape, in nanoseconds per pair.

#include "bench/suite.hpp"

namespace detent::bench {

namespace {

constexpr std::size_t probe_count = 64;

/// The rays and the shapes of a query's inputs, with their batches.
template <class S, template <class, int> class Shape>
struct Scene {
  using Rays = std::vector<Ray<S, 3>>;
  using Shapes = std::vector<Shape<S, 3>>;

  template <class Drawn>
  explicit Scene(const Drawn& drawn)
      : rays(drawn.size()),
        shapes(drawn.size()),
        ray_blocks(batch_blocks(drawn.size())),
        shape_blocks(batch_blocks(drawn.size())) {
    for (std::size_t i = 0; i < drawn.size(); ++i) {
      rays[i] = as<S>(drawn[i].first);
      shapes[i] = as<S>(drawn[i].second);
    }
  }

  [[nodiscard]] RayBatch<S, 3> ray_batch() {
    const S reach(scale_for<S>.reach * 2 - 1);
    const auto frame = Aabb{make_vec<3>([&](int) { return nearest_to<S>(-reach); }),
                            make_vec<3>([&](int) { return reach; })};
    return RayBatch<S, 3>(rays, frame, ray_blocks);
  }
  [[nodiscard]] ShapeBatch<Shape<S, 3>> shape_batch() {
    return ShapeBatch<Shape<S, 3>>(shapes, shape_blocks);
  }

  Rays rays;
  Shapes shapes;
  std::vector<typename RayBatch<S, 3>::Block> ray_blocks;
  std::vector<typename ShapeBatch<Shape<S, 3>>::Block> shape_blocks;
  std::vector<std::optional<S>> answers = std::vector<std::optional<S>>(question_count);
};

template <class S>
std::size_t count(const std::vector<std::optional<S>>& answers) {
  return static_cast<std::size_t>(
      std::count_if(answers.begin(), answers.end(), [](const auto& a) { return a.has_value(); }));
}

/// Adds `ask(k)`, which runs 4096 queries with ray or shape k.
template <class Ask>
void add(Suite& suite, const std::string& query, const std::string& scalar, const Ask& ask) {
  std::size_t k = 0;
  suite.add_turn(query, scalar, Manner::shuffled, [ask, k]() mutable {
    return take_turn([&] {
      auto answer = ask(k++ % probe_count);
      benchmark::DoNotOptimize(answer);
      benchmark::ClobberMemory();
    });
  });
}

template <template <class, int> class Shape>
void add_shape(Suite& suite, const std::string& shape_name) {
  const auto asked = query<Ray, Shape>(shape_name, ask_raycast);
  const auto large = draw_questions(asked, suite.seed(), ordinary);
  const auto little = draw_questions(asked, suite.seed(), small);
  const auto add_scalar = [&]<class S>(S) {
    const auto& drawn = scale_for<S>.reach == small.reach ? little : large;
    const auto scene = std::make_shared<Scene<S, Shape>>(drawn);
    const auto exact = std::make_shared<Scene<q16_16, Shape>>(drawn);
    const auto rays = std::make_shared<RayBatch<S, 3>>(scene->ray_batch());
    const auto shapes = std::make_shared<ShapeBatch<Shape<S, 3>>>(scene->shape_batch());
    const auto each = [scene, shapes](std::size_t k) {
      raycast_each<S, 3>(scene->rays[k], *shapes, scene->answers);
      return scene->answers[k].has_value();
    };
    const auto first = [scene, shapes](std::size_t k) {
      return raycast_first(scene->rays[k], *shapes);
    };
    const auto each_ray = [scene, rays](std::size_t k) {
      raycast_each<S, 3>(*rays, scene->shapes[k], scene->answers);
      return scene->answers[k].has_value();
    };
    const auto loop = [scene](std::size_t k) {
      for (std::size_t i = 0; i < question_count; ++i) {
        scene->answers[i] = raycast(scene->rays[k], scene->shapes[i]);
      }
      return scene->answers[k].has_value();
    };
    // Every count equals that of a loop over exact queries.
    std::size_t hits = 0, first_hits = 0, ray_hits = 0;
    std::size_t expected = 0, first_expected = 0, ray_expected = 0;
    for (std::size_t k = 0; k < probe_count; ++k) {
      std::size_t meets = 0;
      for (std::size_t i = 0; i < question_count; ++i) {
        meets += raycast(exact->rays[k], exact->shapes[i]) ? 1u : 0u;
        ray_expected += raycast(exact->rays[i], exact->shapes[k]) ? 1u : 0u;
      }
      expected += meets;
      first_expected += meets != 0 ? 1u : 0u;
      first_hits += first(k) ? 1u : 0u;
      each(k);
      hits += count(scene->answers);
      each_ray(k);
      ray_hits += count(scene->answers);
    }
    const auto record = [&](const std::string& name, std::size_t got, std::size_t wanted) {
      suite.add_record({name + shape_name, scalar_name<S>, got, wanted, is_fixed<S>, {}});
    };
    record("batch_first/", first_hits, first_expected);
    record("batch_each/", hits, expected);
    record("batch_rays/", ray_hits, ray_expected);
    add(suite, "batch_first/" + shape_name, scalar_name<S>, first);
    add(suite, "batch_each/" + shape_name, scalar_name<S>, each);
    add(suite, "batch_rays/" + shape_name, scalar_name<S>, each_ray);
    if constexpr (std::is_same_v<S, float> || std::is_same_v<S, q16_16>) {
      const auto name = scalar_name<S> + ", loop";
      suite.add_record({"batch_each/" + shape_name, name, hits, expected, false, {}});
      add(suite, "batch_each/" + shape_name, name, loop);
    }
  };
  add_scalar(float());
  add_scalar(double());
  support::for_each_scalar(support::FixedScalars(), add_scalar);
}

}  // namespace

void add_batches(Suite& suite) {
  add_shape<Sphere>(suite, "sphere");
  add_shape<Aabb>(suite, "aabb");
  add_shape<Obb>(suite, "obb");
  add_shape<Triangle>(suite, "triangle");
}

}  // namespace detent::bench
