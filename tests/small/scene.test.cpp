// SPDX-License-Identifier: MIT
#include "detent/scene/scene.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <span>
#include <variant>
#include <vector>

#include "detent/scene/mesh.hpp"
#include "detent/scene/mesh/owned.hpp"
#include "scene/any_scene.hpp"
#include "small/world.hpp"

// Scenes of one, two and three objects in worlds of so few numbers that every query can be run on
// every object. The results are those of a plain loop over the queries on single shapes.

namespace detent::small {
namespace {

/// Small enough that scenes can hold every shape.
template <Scalar S, int N>
Parts<S, N> parts(const std::vector<S>& coordinates) {
  const auto unit = S::from_raw(1);
  Parts<S, N> all{points_of<N>(coordinates),
                  points_of<N>(std::vector{S(0), S::max()}),
                  {S::from_raw(-1), S(0), unit, S::max()},
                  coordinates,
                  {},
                  {Rotation<S, N>()}};
  for (const auto& way : points_of<N>(std::vector{S::from_raw(-1), S(0), unit})) {
    if (const auto direction = normalize(way)) all.directions.push_back(*direction);
  }
  for (const int degrees : {45, 30, 201}) {
    const auto angle = Angle<S>::turn(degrees, 360);
    if constexpr (N == 2) {
      all.rotations.push_back(Rotation<S, 2>::from_angle(angle));
    } else {
      all.rotations.push_back(Rotation<S, 3>::from_euler(angle, angle, angle));
    }
  }
  // Nearly as skewed as a box can be, and more.
  for (const int skew : {16, 17}) {
    std::array<typename Direction<S, N>::Raw, N> raw{};
    raw[0] = typename Direction<S, N>::Raw(1) << direction_component<S>::frac;
    raw[1] = static_cast<typename Direction<S, N>::Raw>(skew);
    std::array<Direction<S, N>, N> axes;
    for (int i = 0; i < N; ++i) axes[static_cast<std::size_t>(i)] = Direction<S, N>::along(i);
    if (const auto axis = Direction<S, N>::from_raw(raw)) axes[0] = *axis;
    all.rotations.push_back(Rotation<S, N>::from_axes(axes));
  }
  return all;
}

/// Meshes of one and two triangles, at every end of the range, and rotated out of it.
template <Scalar S>
void list(const Parts<S, 3>& parts, std::vector<PlacedMesh<S>>& out) {
  const S low = S::lowest(), zero{}, high = S::max();
  static const std::array triangles{
      Triangle<S, 3>{{low, low, low}, {high, low, zero}, {zero, high, high}},
      Triangle<S, 3>{{zero, zero, zero}, {high, high, high}, {low, high, low}}};
  static const OwnedMesh<S> one{std::span<const Triangle<S, 3>>(triangles).first(1)};
  static const OwnedMesh<S> two{std::span<const Triangle<S, 3>>(triangles)};
  static const std::array assets{MeshAsset<S>(1, one.view()), MeshAsset<S>(2, two.view())};
  for (const auto& asset : assets) {
    for (const auto& by : parts.points) {
      for (const auto& rotation : parts.rotations) {
        for (const S& scale : {S(1), S::lowest()})
          out.push_back({&asset, Transform<S, 3>{by, rotation, scale}});
      }
    }
  }
  out.push_back({});
}

/// The shapes of scenes.
template <Scalar S, int N>
struct Held {
  using Shape = test::AnyShape<S, N>;
  using Objects = test::AnyScene<S, N>;
};
template <Scalar S>
struct Held<S, 3> {
  using Shape = test::AnyShape<S, 3, PlacedMesh<S>>;
  using Objects = test::AnyScene<S, 3, PlacedMesh<S>>;
};

template <Scalar S, int N>
struct World {
  using Shape = typename Held<S, N>::Shape;
  using Objects = typename Held<S, N>::Objects;
  using Question =
      typename test::QueryShapes<S, N>::template in<std::variant, Vec<S, N>, Ray<S, N>>;

  std::vector<Shape> shapes;
  std::vector<Question> questions;

  explicit World(const Parts<S, N>& parts) {
    append_all(parts, shapes);
    append_all(parts, questions);
  }

 private:
  template <class... Types>
  static void append_all(const Parts<S, N>& parts, std::vector<std::variant<Types...>>& out) {
    const auto append = [&](auto all) {
      list(parts, all);
      out.insert(out.end(), all.begin(), all.end());
    };
    (append(std::vector<Types>()), ...);
  }
};

template <class T>
constexpr bool is_point = false;
template <Scalar S, int N>
constexpr bool is_point<Vec<S, N>> = true;

/// Compares scenes with loops over their objects; counts queries and results.
class Exam {
 public:
  template <class Objects, class Shape, class Question>
  void ask(const Objects& scene, std::span<const Shape> shapes, std::span<const ObjectId> ids,
           const Question& variant) {
    std::visit([&](const auto& question) { compare(scene, shapes, ids, question); }, variant);
  }

  template <class Objects, class Shape>
  void ask_for_pairs(const Objects& scene, std::span<const Shape> shapes,
                     std::span<const ObjectId> ids) {
    std::array<Overlap, 3> expected, found;
    std::size_t count = 0;
    for (std::size_t i = 0; i < shapes.size(); ++i) {
      for (std::size_t k = i + 1; k < shapes.size(); ++k) {
        const bool meet = std::visit([](const auto& a, const auto& b) { return overlaps(a, b); },
                                     shapes[i], shapes[k]);
        if (meet) expected[count++] = {ids[i], ids[k]};
      }
    }
    const bool is_right =
        scene.overlaps(found) == count &&
        std::equal(found.begin(), found.begin() + std::ptrdiff_t(count), expected.begin());
    judge(is_right, count != 0);
  }

  void finish(long cases) const {
    INFO(yes_ << " of " << cases_ << " cases found something, " << wrong_ << " wrong");
    CHECK(wrong_ == 0);
    CHECK(cases_ == cases);
    CHECK(yes_ > cases_ / 20);
    CHECK(yes_ < cases_);
  }

 private:
  void judge(bool is_right, bool is_yes) {
    ++cases_;
    wrong_ += is_right ? 0 : 1;
    yes_ += is_yes ? 1 : 0;
  }

  template <class Objects, class Shape, class Question>
  void compare(const Objects& scene, std::span<const Shape> shapes, std::span<const ObjectId> ids,
               const Question& question) {
    using S = typename decltype(scene.nearest(question))::value_type;
    std::array<S, 3> expected, found;
    std::size_t count = 0;
    std::optional<S> nearest;
    for (std::size_t i = 0; i < shapes.size(); ++i) {
      std::visit(
          [&](const auto& shape) {
            const auto distance = distance_if_met(question, shape);
            if (distance) expected[count++] = {*distance, ids[i]};
            if constexpr (is_point<Question>) {
              // `nearest` skips empty objects.
              if (detail::quantized_box(shape).is_empty()) return;
              const S here{detent::distance(shape, question), ids[i]};
              if (!nearest || here < *nearest) nearest = here;
            }
          },
          shapes[i]);
    }
    const auto end = expected.begin() + static_cast<std::ptrdiff_t>(count);
    std::sort(expected.begin(), end);
    if constexpr (!is_point<Question>) {
      if (count != 0) nearest = expected[0];
    }
    const bool is_right =
        scene.any(question) == (count != 0) && scene.all(question, std::span(found)) == count &&
        std::equal(expected.begin(), end, found.begin()) && scene.nearest(question) == nearest;
    judge(is_right, count != 0);
  }

  template <Scalar S, int N, class Shape>
  static std::optional<S> distance_if_met(const Ray<S, N>& ray, const Shape& shape) {
    return raycast(ray, shape);
  }
  template <class Question, class Shape>
  static auto distance_if_met(const Question& question, const Shape& shape) {
    const auto length = distance(shape, detail::reference(question));
    return detail::meets(question, shape) ? std::optional(length) : std::nullopt;
  }

  long cases_ = 0, yes_ = 0, wrong_ = 0;
};

/// Fills a scene with these objects.
template <class Objects, class Shape>
std::vector<ObjectId> fill(Objects& scene, std::span<const Shape> shapes) {
  std::vector<ObjectId> ids;
  for (const auto& variant : shapes) {
    std::visit([&](const auto& shape) { ids.push_back(scene.add(shape).value_or(ObjectId{})); },
               variant);
  }
  return ids;
}

template <Scalar S, int N>
void examine_single(Exam& exam, const World<S, N>& world) {
  using Shape = typename World<S, N>::Shape;
  for (const auto& shape : world.shapes) {
    typename World<S, N>::Objects scene;
    const std::span<const Shape> shapes(&shape, 1);
    const auto ids = fill(scene, shapes);
    for (const auto& question : world.questions) {
      exam.ask(scene, shapes, std::span<const ObjectId>(ids), question);
    }
  }
}

/// Every two, or every three, of a sample of the shapes.
template <Scalar S, int N>
void examine_groups(Exam& exam, const World<S, N>& world, std::size_t size, std::size_t shape_step,
                    std::size_t question_step) {
  using Shape = typename World<S, N>::Shape;
  const auto one_in = [](std::size_t step, const auto& all) {
    return some((all.size() + (step - 1) / 2) / step, all);
  };
  const auto shapes = one_in(shape_step, world.shapes);
  const auto questions = one_in(question_step, world.questions);
  const auto examine = [&](const std::vector<Shape>& group) {
    typename World<S, N>::Objects scene;
    const auto ids = fill(scene, std::span<const Shape>(group));
    exam.ask_for_pairs(scene, std::span<const Shape>(group), std::span<const ObjectId>(ids));
    for (const auto& question : questions) {
      exam.ask(scene, std::span<const Shape>(group), std::span<const ObjectId>(ids), question);
    }
  };
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    for (std::size_t k = 0; k <= i; ++k) {
      if (size == 2) {
        examine({shapes[i], shapes[k]});
        continue;
      }
      for (std::size_t l = 0; l <= k; ++l) examine({shapes[i], shapes[k], shapes[l]});
    }
  }
}

// -2 to 1.5 in steps of 0.5.
using Tiny = Fixed<2, 1>;
const std::vector<Tiny> ends{Tiny::lowest(), Tiny::max()};
const std::vector<Tiny> ends_and_middle{Tiny::lowest(), Tiny(0), Tiny::max()};

}  // namespace

TEST_CASE("small scene: one object in 2D, with every query", "[scene]") {
  Exam exam;
  examine_single(exam, World<Tiny, 2>(parts<Tiny, 2>(ends_and_middle)));
  exam.finish(1'459'350);
}

TEST_CASE("small scene: two and three objects in 2D", "[scene]") {
  const World<Tiny, 2> world(parts<Tiny, 2>(ends_and_middle));
  Exam exam;
  examine_groups(exam, world, 2, 12, 24);
  examine_groups(exam, world, 3, 50, 24);
  exam.finish(482'372);
}

TEST_CASE("small scene: one object in 3D, with every query", "[scene]") {
  Exam exam;
  examine_single(exam, World<Tiny, 3>(parts<Tiny, 3>(ends)));
  exam.finish(2'448'520);
}

TEST_CASE("small scene: two and three objects in 3D", "[scene]") {
  const World<Tiny, 3> world(parts<Tiny, 3>(ends));
  Exam exam;
  examine_groups(exam, world, 2, 12, 40);
  examine_groups(exam, world, 3, 60, 40);
  exam.finish(448'350);
}

TEST_CASE("small scene: one object in 2D, with one more number", "[scene][.demand]") {
  Exam exam;
  examine_single(
      exam,
      World<Tiny, 2>(parts<Tiny, 2>({Tiny::lowest(), Tiny::from_raw(-1), Tiny(0), Tiny::max()})));
  exam.finish(14'710'272);
}

TEST_CASE("small scene: every pair of objects in 2D, and many more triples", "[scene][.demand]") {
  const World<Tiny, 2> world(parts<Tiny, 2>(ends_and_middle));
  Exam exam;
  examine_groups(exam, world, 2, 1, 400);
  examine_groups(exam, world, 3, 20, 100);
  exam.finish(4'635'060);
}

TEST_CASE("small scene: more pairs and triples in 3D", "[scene][.demand]") {
  const World<Tiny, 3> world(parts<Tiny, 3>(ends));
  Exam exam;
  examine_groups(exam, world, 2, 2, 400);
  examine_groups(exam, world, 3, 25, 100);
  exam.finish(2'036'095);
}

}  // namespace detent::small
