// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "image.hpp"
#include "scene.hpp"
#include "workers.hpp"
#include "world_builder.hpp"

namespace detent::cli {

/// A result that can be compared across scalars: the shape and the distance. Every scalar's
/// distance is exactly a double.
struct Found {
  std::size_t shape;
  double distance;
};

/// The number of results that exact arithmetic contradicts, by more than 1/65536.
struct Verdict {
  std::size_t wrong = 0;  // a false hit, a false miss, or not the nearest shape
  std::size_t off = 0;    // the right shape at another distance
};

struct Size {
  int width;
  int height;
};

/// A scene in one scalar, with its rays and their results.
///
/// One template implements this interface for all scalars (scalar_tracer.hpp), so the commands need
/// not know the scalar.
class Tracer {
 public:
  virtual ~Tracer() = default;

  [[nodiscard]] virtual std::string_view scalar() const = 0;
  [[nodiscard]] virtual std::size_t ray_count() const = 0;

  /// Replaces the rays of the scene by those of its camera, row by row.
  virtual void aim_camera(Size size) = 0;

  /// That camera, in doubles.
  [[nodiscard]] virtual View view() const = 0;

  /// Casts every ray. The functions below report on the results.
  virtual void cast(const Workers& workers) = 0;

  [[nodiscard]] virtual std::vector<std::optional<Found>> found() const = 0;
  [[nodiscard]] virtual std::uint64_t digest() const = 0;

  /// A line of JSON per ray.
  [[nodiscard]] virtual std::string json_lines() const = 0;

  /// The picture from the camera's rays; shadow rays start `bias` above the surface, or one step of
  /// the scalar if that is more.
  [[nodiscard]] virtual Image picture(const Decimal& bias, const Workers& workers) const = 0;

  /// Checks every result with exact arithmetic on the same inputs.
  [[nodiscard]] virtual Verdict judge(const Workers& workers) const = 0;

  /// Casts every `stride`-th ray again, for timing.
  virtual void repeat(std::size_t stride) const = 0;
};

/// Throws InputError when a number of the scene does not fit the scalar.
template <Scalar S>
[[nodiscard]] std::unique_ptr<Tracer> make_tracer(const Scene& scene, const Move& move);
[[nodiscard]] std::unique_ptr<Tracer> make_tracer(std::string_view scalar, const Scene& scene,
                                                  const Move& move = {});

/// Nanoseconds per ray for each tracer: medians over batches that alternate, so that other load on
/// the machine affects all of them.
[[nodiscard]] std::vector<double> time_per_ray(const std::vector<const Tracer*>& tracers);

}  // namespace detent::cli
