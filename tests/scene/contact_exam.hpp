// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <span>
#include <vector>

#include "detent/scene/mesh/contact.hpp"
#include "oracle/contact_answer.hpp"
#include "oracle/describe.hpp"
#include "oracle/hull.hpp"
#include "oracle/inner_edges.hpp"
#include "support/catch.hpp"

namespace detent::test {

/// All triangles of a surface, in the order of their indices, for the oracle.
template <template <class> class Surface, Scalar S>
std::vector<oracle::Face<3>> faces_of(const Surface<S>& surface) {
  std::map<std::uint32_t, oracle::Face<3>> sorted;
  Aabb<S, 3> all;
  for (int i = 0; i < 3; ++i) {
    all.min[i] = S::lowest();
    all.max[i] = S::max();
  }
  visit_within(surface, all, [&](std::span<const MeshTriangle<S>> parts) {
    for (const auto& [triangle, index] : parts) {
      sorted[index] = {{oracle::raw(triangle.a), oracle::raw(triangle.b), oracle::raw(triangle.c)}};
    }
    return Walk::go_on;
  });
  std::vector<oracle::Face<3>> faces;
  for (const auto& [index, face] : sorted) {
    REQUIRE(index == faces.size());
    faces.push_back(face);
  }
  return faces;
}

/// What became of the triangles that shapes touched, and how many shapes touched any.
struct ContactCounts {
  int least = 0, face = 0, deferred = 0, places = 0;
};

/// Compares the contacts of a shape with a surface, whose triangles are `faces`, with the oracle's.
template <template <class> class Surface, Scalar S, class Shape>
void examine_contacts(const Surface<S>& surface, const std::vector<oracle::Face<3>>& faces,
                      const Shape& shape, Facing facing, ContactCounts& counts) {
  using Kind = oracle::TriangleContact::Kind;
  std::vector<MeshContact<S>> found(faces.size());
  const auto count = contacts(surface, shape, std::span(found), facing);
  INFO((facing == Facing::front ? "front " : "both ") << oracle::describe(shape));
  REQUIRE(count <= faces.size());
  const auto truth = oracle::surface_contacts(faces, oracle::exact(shape), facing == Facing::front,
                                              oracle::one_of<S>());
  std::size_t next = 0;
  for (std::size_t i = 0; i < faces.size(); ++i) {
    const auto& [kind, push] = truth[i];
    const bool is_found = next < count && found[next].triangle == i;
    INFO("triangle " << i << ", expected kind " << static_cast<int>(kind));
    REQUIRE(is_found == push.has_value());
    if (is_found) {
      const auto& contact = found[next++].contact;
      REQUIRE(oracle::is_contact<S, 3>(contact, push));
      REQUIRE(contact.count > 0);
    }
    counts.least += kind == Kind::least;
    counts.face += kind == Kind::face;
    counts.deferred += kind == Kind::deferred;
  }
  REQUIRE(next == count);
  counts.places += count > 0;
}

}  // namespace detent::test
