// SPDX-License-Identifier: MIT
#include "accuracy/catalogue.hpp"
#include "accuracy/pair.hpp"
#include "detent/query/raycast.hpp"

namespace detent::accuracy {
namespace {

/// The formula of most textbooks, in float. It computes the squared distance from the ray as the
/// squared distance of the center minus the square of its distance along the ray, and assumes a
/// unit direction.
///
/// source: Akenine-Moeller et al., Real-Time Rendering, 22.6.2
struct Textbook {
  static std::optional<float> raycast(const Ray<float, 3>& ray, const Sphere<float, 3>& sphere) {
    const auto l = sphere.center - ray.origin;
    const float ahead = detent::dot(l, ray.direction.vec());
    const float squared = detent::dot(l, l), radius_squared = sphere.radius * sphere.radius;
    if (squared <= radius_squared) return 0.0f;
    if (ahead < 0) return std::nullopt;
    const float beside = squared - ahead * ahead;
    if (beside > radius_squared) return std::nullopt;
    const float distance = ahead - std::sqrt(radius_squared - beside);
    if (distance > ray.max_distance) return std::nullopt;
    return distance;
  }

  template <Scalar S, class All>
  static void add(std::vector<Cell>& cells, const All& all, const Rung& rung, Inputs inputs) {
    if constexpr (std::is_same_v<S, float>) {
      Tally<float> tally(inputs, "textbook float");
      for (const auto& [question, truth] : all) {
        const Rounded<float> round{rung.frac};
        tally.count(truth, raycast(changed(round, question.ray), changed(round, question.shape)));
      }
      cells.push_back(tally.cell());
    }
  }
};

}  // namespace

void add_raycasts(std::vector<Query>& queries) {
  queries.push_back(ray_query<Raycast<kind::Sphere, Textbook>>("raycast/sphere", 1, false));
  add_raycasts_at<3>(queries, kind::AfterSphere());
}

}  // namespace detent::accuracy
