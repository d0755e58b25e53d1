// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <utility>
#include <variant>

#include "casts.hpp"
#include "detent/draw/circle.hpp"
#include "detent/draw/hit.hpp"
#include "detent/draw/round.hpp"
#include "detent/query/cast.hpp"
#include "detent/query/contact.hpp"

// The implementation of `cast_throws` and `contacts_of`, compiled in a file for each scalar in
// casts/.

namespace detent::cli {

template <Scalar S>
class Caster {
 public:
  Caster(const Scene& scene, const Move& move) : shapes_(WorldBuilder<S>(scene, move).shapes()) {
    for (std::size_t i = 0; i < 3; ++i) move_[i] = move.by[i].to<double>().value();
  }

  [[nodiscard]] CastReport report(const std::vector<Throw>& throws, bool are_drawn,
                                  const Workers& workers) const {
    std::vector<std::optional<Hit>> hits(throws.size());
    for_each_index(workers, static_cast<int>(throws.size()), [&](int i) {
      const Throw& thrown = throws[static_cast<std::size_t>(i)];
      hits[static_cast<std::size_t>(i)] =
          first(capsule_of(thrown), direction_of_throw(thrown), scalar(thrown.max_distance));
    });

    CastReport result;
    Digest digest;
    for (std::size_t i = 0; i < throws.size(); ++i) {
      const auto& hit = hits[i];
      digest.add(hit.has_value());
      if (hit) digest.add(hit->distance);
      result.distances.push_back(hit ? std::optional(static_cast<double>(hit->distance))
                                     : std::nullopt);
      if (!are_drawn) continue;
      const S distance = hit ? hit->distance : scalar(throws[i].max_distance);
      const auto by = nearest_to<S>(direction_of_throw(throws[i]) * distance);
      draw_throw(result, capsule_of(throws[i]), by, hit, throws[i].colour);
    }
    result.digest = digest.value();
    return result;
  }

  [[nodiscard]] ContactReport contacts(const std::vector<Throw>& bodies, bool are_drawn,
                                       const Workers& workers) const {
    struct Found {
      std::size_t shape;
      Contact<S, 3> contact;
    };
    std::vector<std::vector<Found>> found(bodies.size());
    for_each_index(workers, static_cast<int>(bodies.size()), [&](int i) {
      const auto body = static_cast<std::size_t>(i);
      const auto capsule = capsule_of(bodies[body]);
      for (std::size_t k = 0; k < shapes_.size(); ++k) {
        const auto contact = contact_with(shapes_[k], capsule);
        if (contact) found[body].push_back({k, *contact});
      }
    });

    ContactReport result;
    Digest digest;
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      if (are_drawn) {
        MeshModel unused{};
        Sink sink{result.lines, unused, move_};
        draw(sink, capsule_of(bodies[i]), bodies[i].colour);
      }
      for (const auto& [shape, contact] : found[i]) {
        digest.add(static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(shape), contact);
        result.overlaps.push_back(
            {i, shape, static_cast<double>(contact.depth), in_double(separation(contact))});
        if (are_drawn) draw_contact(result, contact);
      }
    }
    result.digest = digest.value();
    return result;
  }

 private:
  using Hit = CastHit<S, 3>;

  /// Collects lines in the world, and triangles as a mesh that is moved back.
  struct Sink {
    std::vector<Outline>& lines;
    MeshModel& mesh;
    const std::array<double, 3>& move;

    void line(const Vec<S, 3>& a, const Vec<S, 3>& b, const Colour& colour) {
      lines.push_back({in_double(a), in_double(b), colour});
    }
    void triangle(const Vec<S, 3>& a, const Vec<S, 3>& b, const Vec<S, 3>& c, const Colour&) {
      const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
      for (const auto& point : {a, b, c}) {
        auto vertex = in_double(point);
        for (std::size_t i = 0; i < 3; ++i) vertex[i] -= move[i];
        mesh.vertices.push_back(vertex);
      }
      mesh.triangles.push_back({first, first + 1, first + 2});
    }
  };

  static S scalar(double x) {
    if constexpr (is_fixed<S>) {
      return S::from_double(x);
    } else {
      return static_cast<S>(x);
    }
  }
  static Vec<S, 3> vector(const std::array<double, 3>& v) {
    return {scalar(v[0]), scalar(v[1]), scalar(v[2])};
  }
  Vec<S, 3> position(const std::array<double, 3>& p) const {
    return vector({p[0] + move_[0], p[1] + move_[1], p[2] + move_[2]});
  }
  Capsule<S, 3> capsule_of(const Throw& thrown) const {
    return {position(thrown.a), position(thrown.b), scalar(thrown.radius)};
  }
  static Direction<S, 3> direction_of_throw(const Throw& thrown) {
    return direction_of<S>(vector(thrown.way)).value();
  }

  /// The nearest hit, of equally near ones that of the first shape in the file.
  std::optional<Hit> first(const Capsule<S, 3>& capsule, const Direction<S, 3>& direction,
                           const S& reach) const {
    std::optional<Hit> best;
    for (const auto& target : shapes_) {
      std::visit(
          [&]<class Form>(const Form& form) {
            const S limit = best ? best->distance : reach;
            if constexpr (!std::same_as<Form, OwnedMesh<S>>) {
              if (!may_touch(capsule, direction, limit, form)) return;
              const auto hit = cast(capsule, direction, limit, as_target(form));
              if (hit && (!best || hit->distance < best->distance)) best = hit;
            }
          },
          target);
    }
    return best;
  }

  static std::optional<Contact<S, 3>> contact_with(const typename World<S>::Shape& target,
                                                   const Capsule<S, 3>& capsule) {
    return std::visit(
        [&]<class Form>(const Form& form) -> std::optional<Contact<S, 3>> {
          if constexpr (!std::same_as<Form, OwnedMesh<S>>) {
            if (may_touch(capsule, Direction<S, 3>::along(0), S(0), form)) {
              return contact(as_target(form), capsule);
            }
          }
          return std::nullopt;
        },
        target);
  }

  /// A sphere as a capsule, the same set of points, so balls need no code of their own.
  static Capsule<S, 3> as_target(const Sphere<S, 3>& sphere) {
    return {sphere.center, sphere.center, sphere.radius};
  }
  template <class Form>
  static const Form& as_target(const Form& form) {
    return form;
  }

  /// Whether the box around the path of a shape overlaps that of a target.
  template <class Form>
  static bool may_touch(const Capsule<S, 3>& shape, const Direction<S, 3>& direction,
                        const S& reach, const Form& form) {
    if constexpr (std::same_as<Form, Plane<S, 3>>) {
      return true;
    } else {
      const auto box = bounding_box(shape), target = bounding_box(form);
      const auto by = direction * reach;
      for (int i = 0; i < 3; ++i) {
        const auto low = floor_to<S>(by[i]), high = ceil_to<S>(by[i]);
        if (box.max[i] + high < target.min[i] && box.max[i] < target.min[i]) return false;
        if (box.min[i] + low > target.max[i] && box.min[i] > target.max[i]) return false;
      }
      return true;
    }
  }

  void draw_throw(CastReport& report, const Capsule<S, 3>& capsule, const Vec<S, 3>& by,
                  const std::optional<Hit>& hit, const Colour& colour) const {
    constexpr Colour way{255, 255, 255}, touch{255, 224, 32};
    ShapeModel body{{}, colour, {}, MeshModel{point_of("0", "0", "0"), {}, {}}};
    Sink sink{report.lines, std::get<MeshModel>(body.form), move_};
    draw(sink, capsule, way);
    // The capsules that its ends sweep.
    for (const auto& end : {capsule.a, capsule.b}) {
      draw(sink, Capsule<S, 3>{end, nearest_to<S>(end + by), capsule.radius}, way);
    }
    draw_solid(sink, translated(capsule, by), colour);
    Sink marks{report.marks, sink.mesh, move_};
    if (hit) draw(marks, *hit, touch, scalar(0.75));
    report.bodies.push_back(std::move(body));
  }

  /// At each point: a cross, how deep the body is there, and an arrow along the normal.
  static void draw_contact(ContactReport& report, const Contact<S, 3>& contact) {
    constexpr Colour surface{255, 224, 32}, inside{255, 64, 192};
    const auto u = detail::perpendicular(contact.normal);
    const auto v = detail::perpendicular(contact.normal, u);
    const auto line = [&](const Vec<S, 3>& a, const Vec<S, 3>& b, const Colour& colour) {
      report.marks.push_back({in_double(a), in_double(b), colour});
    };
    const auto moved = [](const Vec<S, 3>& point, const Direction<S, 3>& way, double length) {
      return nearest_to<S>(point + way * scalar(length));
    };
    for (std::size_t i = 0; i < contact.count; ++i) {
      const auto& point = contact.points[i].point;
      const auto deepest = nearest_to<S>(point - contact.normal * contact.points[i].depth);
      const auto neck = moved(point, contact.normal, 1.5), tip = moved(neck, contact.normal, 0.75);
      for (const auto& side : {u, -u, v, -v}) {
        // Four lines make a thick one.
        const auto beside = [&](const Vec<S, 3>& p) { return moved(p, side, 0.046875); };
        line(beside(deepest), beside(point), inside);
        line(beside(point), beside(neck), surface);
        line(point, moved(point, side, 0.375), surface);
        for (const double width : {0.0625, 0.125, 0.1875, 0.25}) {
          line(moved(neck, side, width), tip, surface);
        }
      }
    }
  }

  std::vector<typename World<S>::Shape> shapes_;
  std::array<double, 3> move_{};
};

template <Scalar S>
CastReport cast_throws(const Scene& scene, const Move& move, const std::vector<Throw>& throws,
                       bool are_drawn, const Workers& workers) {
  return Caster<S>(scene, move).report(throws, are_drawn, workers);
}

template <Scalar S>
ContactReport contacts_of(const Scene& scene, const Move& move, const std::vector<Throw>& bodies,
                          bool are_drawn, const Workers& workers) {
  return Caster<S>(scene, move).contacts(bodies, are_drawn, workers);
}

}  // namespace detent::cli
