// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include "detent/draw/box.hpp"
#include "detent/draw/compound.hpp"
#include "detent/draw/flat.hpp"
#include "detent/draw/round.hpp"
#include "detent/draw/surface.hpp"
#include "detent/scene/scene.hpp"

namespace detent {

/// Colours of objects: one for moving and one for fixed objects.
struct ColourByMotion {
  Colour moving = palette_colour(0);
  Colour fixed = palette_colour(1);

  template <class Shape>
  [[nodiscard]] constexpr Colour operator()(const ObjectInfo& object, const Shape&) const noexcept {
    return object.motion == Motion::moving ? moving : fixed;
  }
};

/// Colours of objects: one for each type of shape, from the palette.
struct ColourByKind {
  template <class Shape>
  [[nodiscard]] constexpr Colour operator()(const ObjectInfo&, const Shape&) const noexcept {
    return palette_colour(detail::shape_tag<Shape>);
  }
};

/// Colours of the boxes of a tree: one for each level, starting at the root.
struct ColourByLevel {
  [[nodiscard]] constexpr Colour operator()(std::size_t level) const noexcept {
    return palette_colour(level);
  }
};

/// Draws every object of a scene, in order of id, in the colour `colours(info, shape)`; planes in
/// `region`. The scene does not change.
template <class Sink, class Storage, Scalar S, int N, class... Shapes,
          class Colours = ColourByMotion>
requires DrawSink<Sink, S, N>
constexpr void draw(Sink& sink, const BasicScene<Storage, S, N, Shapes...>& scene,
                    const Colours& colours = {}, const DrawRegion<S, N>& region = {}) {
  scene.for_each([&](const ObjectInfo& object, const auto& shape) {
    if constexpr (requires { draw(sink, shape, Colour(), region); }) {
      draw(sink, shape, colours(object, shape), region);
    } else {
      draw(sink, shape, colours(object, shape));
    }
  });
}

namespace detail {

/// A box of the grid in the world; clipped to the scalar's range where it is unbounded.
template <Scalar S, int N>
[[nodiscard]] constexpr Aabb<S, N> unquantized(const QuantizedBox<S, N>& box) noexcept {
  return {
      make_vec<N>([&](int i) { return Grid<S>::scalar(box.low[static_cast<std::size_t>(i)]); }),
      make_vec<N>([&](int i) { return Grid<S>::scalar(box.high[static_cast<std::size_t>(i)]); })};
}

template <class Sink, class Tree, class Colours>
constexpr void draw_node(Sink& sink, const Tree& tree, std::uint32_t at, std::size_t level,
                         const Colours& colours) {
  const auto& node = tree.node(at);
  for (std::size_t i = 0; i < node.count; ++i) {
    draw(sink, unquantized(node.box(i)), colours(level));
    if (node.level > 0) draw_node(sink, tree, node.child[i], level + 1, colours);
  }
}

template <class Sink, class Surface, class Part, class Colours>
constexpr void draw_part(Sink& sink, const Surface& surface, const Part& part, std::size_t level,
                         const Colours& colours) {
  visit_children(surface, part, [&](const Part& child, const auto& box) {
    draw(sink, box, colours(level));
    if (!child.is_leaf()) draw_part(sink, surface, child, level + 1, colours);
    return Walk::go_on;
  });
}

}  // namespace detail

/// Draws the boxes of the trees over a scene's objects, in the colour `colours(level)`: level 0 is
/// the root's. Boxes are rounded outward and have a margin; their arrangement depends on the
/// scene's history, and no result depends on it.
template <class Sink, class Storage, Scalar S, int N, class... Shapes,
          class Colours = ColourByLevel>
requires DrawSink<Sink, S, N>
constexpr void draw_tree(Sink& sink, const BasicScene<Storage, S, N, Shapes...>& scene,
                         const Colours& colours = {}) {
  for (const auto motion : {Motion::moving, Motion::fixed}) {
    const auto& tree = detail::SceneAccess::store(scene).tree(motion);
    if (!tree.is_empty()) detail::draw_node(sink, tree, tree.root(), 0, colours);
  }
}

/// Draws the boxes of the tree over the triangles of a mesh, or over the rectangles of a height
/// field.
template <class Sink, template <class> class Surface, Scalar S, class Colours = ColourByLevel>
requires is_surface<Surface> && DrawSink<Sink, S, 3>
constexpr void draw_tree(Sink& sink, const Surface<S>& surface, const Colours& colours = {}) {
  if (is_empty(bounding_box(surface))) return;
  const auto whole = whole_of(surface);
  if (!whole.is_leaf()) detail::draw_part(sink, surface, whole, 0, colours);
}

}  // namespace detent
