// SPDX-License-Identifier: MIT
#include "world.hpp"

#include "support/catch.hpp"

using namespace detent;
using cli::Answer;

namespace {

/// Integers in a small cube, so that many shapes touch, coincide and are degenerate.
template <class S>
Vec<S, 3> point(test::Random& random) {
  const auto coordinate = [&] { return S(static_cast<int>(random.between(-8, 8))); };
  return {coordinate(), coordinate(), coordinate()};
}

template <class S>
typename cli::World<S>::Shape shape(test::Random& random, std::vector<Triangle<S, 3>>& triangles) {
  const auto a = point<S>(random), b = point<S>(random);
  const auto low = make_vec<3>([&](int i) { return std::min(a[i], b[i]); });
  const auto side = [&] { return S(static_cast<int>(random.between(0, 3))); };
  switch (random.between(0, 11)) {
    case 0:
      return Plane<S, 3>{Rotation<S, 3>().axis(static_cast<int>(random.between(0, 2))), a.x};
    case 1:
      triangles.clear();
      for (int i = 0; i < 60; ++i) {
        const auto corner = point<S>(random);
        const auto near_it = [&] {
          return nearest_to<S>(corner + Vec<S, 3>{side(), side(), side()});
        };
        triangles.push_back({corner, near_it(), near_it()});
      }
      return OwnedMesh<S>(triangles);
    case 2:
    case 3:
      return Obb<S, 3>{a, {side(), side(), side()}, {}};
    case 4:
    case 5:
      return Triangle<S, 3>{a, b, point<S>(random)};
    case 6:
    case 7:
      return Aabb<S, 3>{low, nearest_to<S>(low + Vec<S, 3>{side(), side(), side()})};
    default:
      return Sphere<S, 3>{a, side()};
  }
}

template <class S>
Ray<S, 3> some_ray(test::Random& random) {
  const auto origin = point<S>(random);
  const auto direction = direction_of<S>(point<S>(random) - origin);
  return {origin, direction.value_or(Direction<S, 3>()),
          S(static_cast<int>(random.between(0, 12)))};
}

/// The result of a loop over all shapes, and over all triangles of a mesh in file order.
template <class S>
std::optional<Answer<S>> nearest_of_all(const std::vector<typename cli::World<S>::Shape>& shapes,
                                        const std::vector<std::vector<Triangle<S, 3>>>& meshes,
                                        const Ray<S, 3>& ray) {
  std::optional<Answer<S>> best;
  const auto ask = [&](const auto& form, std::size_t i) {
    const auto distance = raycast(ray, form);
    if (!distance || (best && !(*distance < best->hit.distance))) return;
    best = Answer<S>{i, *raycast_hit(ray, form)};
  };
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    std::visit(
        [&]<class Form>(const Form& form) {
          if constexpr (std::same_as<Form, OwnedMesh<S>>) {
            for (const auto& triangle : meshes[i]) ask(triangle, i);
          } else {
            ask(form, i);
          }
        },
        shapes[i]);
  }
  return best;
}

}  // namespace

TEMPLATE_TEST_CASE("world: trees give the results of a loop over all shapes and triangles", "",
                   q16_16, q8_8) {
  using S = TestType;
  test::Random random(20261121);
  INFO(random);
  test::HitRate rate;
  int wrong = 0;
  for (int round = 0; round < 20; ++round) {
    std::vector<typename cli::World<S>::Shape> shapes;
    std::vector<std::vector<Triangle<S, 3>>> meshes;
    const auto count = random.between(0, 60);
    for (int i = 0; i < count; ++i) {
      std::vector<Triangle<S, 3>> triangles;
      shapes.push_back(shape<S>(random, triangles));
      meshes.push_back(triangles);
    }
    const cli::World<S> world(shapes);
    for (int i = 0; i < 200; ++i) {
      const auto ray = some_ray<S>(random);
      const auto expected = nearest_of_all<S>(shapes, meshes, ray);
      const auto found = world.nearest(ray);
      rate.count(found && found->hit.distance > 0);
      const bool is_right =
          found.has_value() == expected.has_value() &&
          (!found || (found->shape == expected->shape && found->hit == expected->hit)) &&
          world.is_blocked(ray) == expected.has_value();
      wrong += is_right ? 0 : 1;
    }
  }
  CHECK(wrong == 0);
  INFO(rate);
  CHECK(rate.is_balanced());
}
