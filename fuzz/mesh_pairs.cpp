// SPDX-License-Identifier: MIT
//
// Distance and closest points of a shape and a mesh of any triangles, at any transform, are those of
// a loop over the triangles. The contacts are sorted, at most one per triangle that the shape
// touches: that of the triangle alone, or one along its normal. There is at least one if the shape
// touches any triangle.

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "detent/scene/mesh/closest_points.hpp"
#include "detent/scene/mesh/contact.hpp"
#include "detent/scene/mesh/distance.hpp"
#include "mesh_subject.hpp"
#include "spaces.hpp"

namespace detent::fuzz {
namespace {

template <Scalar S, class Shape>
void check_distance(const Subject<S>& subject, const Shape& shape) {
  const auto& triangles = subject.loop.triangles;
  S least = largest<S>;
  std::optional<std::size_t> nearest;
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const S apart = distance(triangles[i], shape);
    if (nearest && apart >= least) continue;
    nearest = i;
    least = apart;
  }
  require_same(distance(subject.mesh, shape) == least, "distance");
  require_same(distance(shape, subject.mesh) == least, "distance");
  using Points = std::pair<Vec<S, 3>, Vec<S, 3>>;
  const auto ahead = nearest ? closest_points(triangles[*nearest], shape) : Points();
  const auto back = nearest ? closest_points(shape, triangles[*nearest]) : Points();
  require_same(closest_points(subject.mesh, shape) == ahead, "closest_points");
  require_same(closest_points(shape, subject.mesh) == back, "closest_points");
}

template <Scalar S, class Shape>
void check_contacts(const Subject<S>& subject, const Shape& shape, Facing facing) {
  const auto& triangles = subject.loop.triangles;
  std::vector<MeshContact<S>> all(triangles.size());
  const auto count = contacts(subject.mesh, shape, std::span(all), facing);
  require_same(count <= all.size(), "the number of contacts");
  all.resize(count);
  std::array<MeshContact<S>, 2> first;
  require_same(contacts(subject.mesh, shape, std::span(first), facing) == count, "contacts");
  require_same(
      std::equal(first.begin(), first.begin() + std::min(count, first.size()), all.begin()),
      "the first contacts");
  if (facing == Facing::both) {
    require_same((count > 0) == overlaps(subject.loop, shape), "whether there is a contact");
  }
  for (std::size_t i = 0; i < count; ++i) {
    const auto& [found, index] = all[i];
    require_same(i == 0 || all[i - 1].triangle < index, "the order of contacts");
    const auto& triangle = triangles[index];
    const auto own = contact(triangle, shape);
    require_same(own.has_value(), "a contact");
    const auto across = cross(triangle.b - triangle.a, triangle.c - triangle.a);
    const auto front = direction_of<S>(across);
    require_same(found == *own || (front && (found.normal == *front || found.normal == -*front)),
                 "the normal of a contact");
    if (facing == Facing::front && front) {
      require_same(dot(found.normal, across) > 0, "the side of a contact");
    }
  }
}

template <Scalar S>
void check(Source& source) {
  with_one_of(support::MovingShapes<S, 3>(), source, [&]<class Shape>(std::type_identity<Shape>) {
    const auto question = source.below(4);
    Decoder<S, 3> decoder(source);
    // Before the mesh, which may use up the bytes.
    const auto shape = decoder.template shape<Shape>();
    const Subject<S> subject(source, decoder);
    if (question < 2) return check_distance(subject, shape);
    check_contacts(subject, shape, question == 2 ? Facing::both : Facing::front);
  });
}

}  // namespace

void property(Bytes input) {
  Source source(input);
  in_a_space(source, [&]<Scalar S, int N>(Space<S, N>) { check<S>(source); });
}

}  // namespace detent::fuzz
