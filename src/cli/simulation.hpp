// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "detent/draw/sink.hpp"
#include "world_builder.hpp"
#include "world_model.hpp"

namespace detent::cli {

/// A triangle of a picture.
struct Facet {
  std::array<std::array<double, 3>, 3> corners;
  Colour colour;
  bool is_fixed = false;
};

/// A world of bodies in one scalar. One template implements it for all scalars and both dimensions
/// (scalar_simulation.hpp).
class Simulation {
 public:
  virtual ~Simulation() = default;

  virtual void step() = 0;
  [[nodiscard]] virtual std::uint64_t digest() const = 0;

  [[nodiscard]] virtual std::size_t joint_count() const = 0;
  /// The number of sleeping bodies.
  [[nodiscard]] virtual std::size_t asleep() const = 0;
  /// The position of a body, without the offset that the world was made with.
  [[nodiscard]] virtual std::array<double, 3> position(std::size_t body) const = 0;
  /// A line of JSON for each body.
  [[nodiscard]] virtual std::string json_lines() const = 0;

  [[nodiscard]] virtual std::string snapshot() const = 0;
  /// Restores the world from a snapshot in `file`; throws InputError when it is not one of this
  /// world.
  virtual void restore(const std::string& file, std::string_view bytes) = 0;

  /// All bodies, without the offset, like `position`.
  [[nodiscard]] virtual std::vector<Facet> facets() const = 0;
};

/// The scalars in which worlds are simulated.
inline constexpr std::array<std::string_view, 3> simulated_scalars{"q16_16", "float", "double"};

/// A world of N dimensions, the model's dimension. Throws InputError when a number of the world
/// does not fit the scalar.
template <Scalar S, int N>
[[nodiscard]] std::unique_ptr<Simulation> make_simulation(const WorldModel& model,
                                                          const Move& move);
[[nodiscard]] std::unique_ptr<Simulation> make_simulation(std::string_view scalar,
                                                          const WorldModel& model,
                                                          const Move& move);

}  // namespace detent::cli
