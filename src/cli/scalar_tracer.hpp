// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>

#include "exact_world.hpp"
#include "shade.hpp"
#include "tracer.hpp"

// The implementation of `Tracer`. Each scalar is compiled in its own file in tracers/: one file
// with all of them takes a compiler minutes and more than a gigabyte.

namespace detent::cli {

template <class T>
[[nodiscard]] std::string json_array(const Vec<T, 3>& v) {
  return '[' + text_of(v.x) + ", " + text_of(v.y) + ", " + text_of(v.z) + ']';
}

/// A string id in quotes; a number, counted from 0, without.
[[nodiscard]] inline std::string json_name(const std::optional<std::string>& id,
                                           std::size_t index) {
  return id ? nlohmann::json(*id).dump() : std::to_string(index);
}

template <Scalar S>
class ScalarTracer final : public Tracer {
 public:
  ScalarTracer(const Scene& scene, const Move& move)
      : scene_(scene),
        move_(move),
        world_(WorldBuilder<S>(scene, move_).world()),
        rays_(WorldBuilder<S>(scene, move_).rays()) {}

  std::string_view scalar() const override { return scalar_name<S>; }
  std::size_t ray_count() const override { return rays_.size(); }

  void aim_camera(Size size) override {
    size_ = size;
    const Camera<S> camera = WorldBuilder<S>(scene_, move_).camera();
    view_ = camera.view();
    rays_.clear();
    for (int y = 0; y < size.height; ++y) {
      for (int x = 0; x < size.width; ++x) {
        rays_.push_back(camera.ray(x, y, size.width, size.height));
      }
    }
  }

  View view() const override { return view_; }

  void cast(const Workers& workers) override {
    answers_.assign(rays_.size(), std::nullopt);
    for_each_ray(workers, [&](std::size_t i) { answers_[i] = world_.nearest(rays_[i]); });
  }

  std::vector<std::optional<Found>> found() const override {
    std::vector<std::optional<Found>> all;
    all.reserve(answers_.size());
    for (const auto& answer : answers_) {
      all.push_back(
          answer ? std::optional(Found{answer->shape, static_cast<double>(answer->hit.distance)})
                 : std::nullopt);
    }
    return all;
  }

  std::uint64_t digest() const override {
    Digest digest;
    for (const auto& answer : answers_) {
      digest.add(answer.has_value());
      if (!answer) continue;
      const auto& [distance, point, normal] = answer->hit;
      digest.add(static_cast<std::uint32_t>(answer->shape), distance, point.x, point.y, point.z,
                 normal[0], normal[1], normal[2]);
    }
    return digest.value();
  }

  std::string json_lines() const override {
    std::string lines;
    for (std::size_t i = 0; i < answers_.size(); ++i) {
      lines += "{\"ray\": " + json_name(scene_.rays[i].id, i) + ", \"hit\": ";
      if (const auto& answer = answers_[i]) {
        const auto& [distance, point, normal] = answer->hit;
        lines += json_name(scene_.shapes[answer->shape].id, answer->shape) +
                 ", \"distance\": " + text_of(distance) + ", \"point\": " + json_array(point) +
                 ", \"normal\": " + json_array(normal.vec()) + "}\n";
      } else {
        lines += "null}\n";
      }
    }
    return lines;
  }

  Image picture(const Decimal& bias, const Workers& workers) const override {
    Image image(size_.width, size_.height);
    const Shader<S> shader(world_, scene_.shapes, WorldBuilder<S>(scene_, move_).light(),
                           shadow_bias(bias));
    for_each_ray(workers, [&](std::size_t i) {
      const auto width = static_cast<std::size_t>(size_.width);
      image.at(static_cast<int>(i % width), static_cast<int>(i / width)) =
          answers_[i] ? shader.surface(*answers_[i]) : shader.sky(rays_[i]);
    });
    return image;
  }

  Verdict judge(const Workers& workers) const override {
    const auto groups = exact(world_);
    std::vector<Fault> faults(rays_.size());
    for_each_ray(workers, [&](std::size_t i) {
      faults[i] = fault_of(answers_[i], meetings(groups, exact(rays_[i])));
    });
    const auto count = [&](Fault fault) {
      return static_cast<std::size_t>(std::count(faults.begin(), faults.end(), fault));
    };
    return {count(Fault::wrong), count(Fault::off)};
  }

  void repeat(std::size_t stride) const override {
    std::size_t hits = 0;
    for (std::size_t i = 0; i < rays_.size(); i += stride) {
      hits += world_.nearest(rays_[i]) ? 1 : 0;
    }
    volatile std::size_t sink = hits;  // keeps the results in use
    (void)sink;
  }

 private:
  enum class Fault : char { none, wrong, off };

  static Fault fault_of(const std::optional<Answer<S>>& answer,
                        const std::vector<Meeting>& meetings) {
    if (!answer || meetings.empty()) {
      return answer.has_value() != meetings.empty() ? Fault::none : Fault::wrong;
    }
    const Meeting* chosen = nullptr;
    const Meeting* nearest = &meetings.front();
    for (const Meeting& meeting : meetings) {
      if (meeting.shape == answer->shape) chosen = &meeting;
      if (meeting.distance < nearest->distance) nearest = &meeting;
    }
    const auto tolerance = Integer(1) << (distance_frac - 16);
    if (!chosen || chosen->distance - nearest->distance > tolerance) return Fault::wrong;
    const auto distance = exact(answer->hit.distance).steps(distance_frac);
    return abs(distance - chosen->distance) > tolerance ? Fault::off : Fault::none;
  }

  S shadow_bias(const Decimal& bias) const {
    const auto value = bias.to<S>();
    if (!value) throw InputError("--bias: out of range for this scalar; use a smaller number");
    if constexpr (is_fixed<S>) {
      return std::max(*value, S::from_raw(1));
    } else {
      return *value;
    }
  }

  /// Splits the work into runs long enough to be worth a thread.
  template <class Work>
  void for_each_ray(const Workers& workers, const Work& work) const {
    constexpr std::size_t run = 256;
    const auto runs = static_cast<int>((rays_.size() + run - 1) / run);
    for_each_index(workers, runs, [&](int index) {
      const std::size_t begin = static_cast<std::size_t>(index) * run;
      for (std::size_t i = begin; i < std::min(begin + run, rays_.size()); ++i) work(i);
    });
  }

  const Scene& scene_;
  Move move_;
  World<S> world_;
  std::vector<Ray<S, 3>> rays_;
  std::vector<std::optional<Answer<S>>> answers_;
  Size size_{};
  View view_{};
};

template <Scalar S>
std::unique_ptr<Tracer> make_tracer(const Scene& scene, const Move& move) {
  return std::make_unique<ScalarTracer<S>>(scene, move);
}

}  // namespace detent::cli
