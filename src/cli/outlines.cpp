// SPDX-License-Identifier: MIT
#include "outlines.hpp"

#include <algorithm>
#include <stdexcept>

#include "detent/draw/draw.hpp"

namespace detent::cli {
namespace {

template <Scalar S>
class OutlineSink {
 public:
  explicit OutlineSink(std::vector<Outline>& lines) : lines_(lines) {}

  void line(const Vec<S, 3>& a, const Vec<S, 3>& b, const Colour& colour) {
    lines_.push_back({in_double(a), in_double(b), colour});
  }
  void triangle(const Vec<S, 3>&, const Vec<S, 3>&, const Vec<S, 3>&, const Colour&) {}

 private:
  std::vector<Outline>& lines_;
};

template <Scalar S>
std::vector<Outline> outlines(const Scene& scene, const Move& move, const DebugParts& parts) {
  const WorldBuilder<S> builder(scene, move);
  const World<S> world = builder.world();
  std::vector<Outline> lines;
  OutlineSink<S> sink(lines);
  for (const auto& shape : world.shapes()) {
    std::visit(
        [&]<class Form>(const Form& form) {
          const Colour colour = palette_colour(shape.index());
          if constexpr (std::same_as<Form, OwnedMesh<S>>) {
            if (parts.shapes) draw(sink, form.view(), colour);
            if (parts.tree) draw_tree(sink, form.view());
          } else if constexpr (std::same_as<Form, Plane<S, 3>>) {
            if (parts.shapes) draw(sink, form, colour, builder.region());
          } else {
            if (parts.shapes) draw(sink, form, colour);
          }
        },
        shape);
  }
  if (parts.tree) draw_tree(sink, world.tree());
  return lines;
}

}  // namespace

std::vector<Outline> outlines_of(std::string_view scalar, const Scene& scene, const Move& move,
                                 const DebugParts& parts) {
  using Maker = std::vector<Outline> (*)(const Scene&, const Move&, const DebugParts&);
  constexpr auto makers = []<class... S>(support::ScalarList<S...>) {
    return std::array<Maker, sizeof...(S)>{outlines<S>...};
  }(support::AllScalars());
  const auto at = std::find(scalar_names.begin(), scalar_names.end(), scalar);
  if (at == scalar_names.end()) throw std::invalid_argument("no scalar of this name");
  return makers[static_cast<std::size_t>(at - scalar_names.begin())](scene, move, parts);
}

}  // namespace detent::cli
