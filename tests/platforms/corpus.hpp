// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "detent/detent.hpp"
#include "support/random.hpp"

/// A fixed corpus of queries and the digest of their answers, made with integers alone: what every
/// machine, compiler and flag must agree on. It needs no operating system and no heap.
namespace detent::platforms {

using test::Random;

/// What one line of the report says.
struct Line {
  const char* subject;
  const char* scalar;
  int dimension;
  std::uint32_t hits;   // of the questions that have a yes or no
  std::uint32_t total;  // questions asked
  std::uint64_t digest;
};

/// Answers in the order in which they were given.
class Tally {
 public:
  template <class... Values>
  constexpr void add(const Values&... values) {
    digest_.add(values...);
  }
  constexpr void count(bool hit) {
    add(hit);
    hits_ += hit ? 1 : 0;
    ++total_;
  }

  constexpr Line line(const char* subject, const char* scalar, int dimension) const {
    return {subject, scalar, dimension, hits_, total_, digest_.value()};
  }

 private:
  Digest digest_;
  std::uint32_t hits_ = 0;
  std::uint32_t total_ = 0;
};

/// Random rays and shapes: a ray aims near a shape that is about as large as the distance is far,
/// at every size the scalar can hold, and now and then everything is an extreme value.
template <Scalar S, int N>
class Corpus {
 public:
  explicit constexpr Corpus(std::uint64_t seed) : random_(seed) {}

  /// Chooses the size of the next scene and where it takes place.
  constexpr void next_scene() {
    extreme_ = random_.one_in(8);
    size_ = static_cast<int>(random_.between(3, S::bits - 1));
    middle_ = extreme_ ? Vec<S, N>{} : point_within(S::bits - 1);
    target_ = near(middle_, size_);
    ray_ = ray();
  }

  constexpr const Ray<S, N>& current_ray() const { return ray_; }

  constexpr Sphere<S, N> sphere() { return {near(target_, size_ - 1), extent()}; }

  constexpr Aabb<S, N> aabb() {
    const Vec<S, N> center = near(target_, size_ - 1);
    Aabb<S, N> box;
    for (int i = 0; i < N; ++i) {
      const S half = extent();
      box.min[i] = saturate_to<S>(center[i] - half);
      box.max[i] = saturate_to<S>(center[i] + half);
    }
    return box;
  }

  constexpr Obb<S, N> obb() {
    Obb<S, N> box;
    box.center = near(target_, size_ - 1);
    for (int i = 0; i < N; ++i) box.half_extents[i] = extent();
    box.rotation = rotation();
    return box;
  }

  constexpr Plane<S, N> plane() {
    const Direction<S, N> normal = direction();
    return {normal, saturate_to<S>(nearest_to<Fixed<S::bits + 2, S::frac>>(dot(normal, target_)))};
  }

  /// Half of them have the target for their centroid: a random one is rarely seen broadside.
  constexpr Triangle<S, N> triangle() {
    Triangle<S, N> triangle{near(target_, size_), near(target_, size_), near(target_, size_)};
    if (random_.one_in(16)) {
      triangle.c = random_.coin() ? triangle.a : triangle.b;
    } else if (random_.coin()) {
      for (int i = 0; i < N; ++i) {
        triangle.c[i] =
            saturate_to<S>(target_[i] - triangle.a[i] + target_[i] - triangle.b[i] + target_[i]);
      }
    }
    return triangle;
  }

  constexpr Direction<S, N> direction() {
    for (;;) {
      Vec<S, N> vector;
      const bool parallel = random_.one_in(6);
      for (int i = 0; i < N; ++i) {
        vector[i] = scalar(parallel ? random_.between(-1, 1) : random_.edgy(S::bits));
      }
      if (const auto unit = normalize(vector)) return *unit;
    }
  }

  constexpr Rotation<S, N> rotation() {
    if constexpr (N == 2) {
      return Rotation<S, 2>::from_angle(angle());
    } else {
      // Named first: the order in which arguments are evaluated is the compiler's choice.
      const auto axis = direction();
      const Angle<S> a = angle(), b = angle(), c = angle();
      const S x = any(), y = any(), z = any(), w = any();
      switch (random_.below(4)) {
        case 0:
          return {};
        case 1:
          return Rotation<S, 3>::from_axis_angle(axis, a);
        case 2:
          return Rotation<S, 3>::from_quaternion(x, y, z, w).value_or(Rotation<S, 3>());
        default:
          return Rotation<S, 3>::from_euler(a, b, c);
      }
    }
  }

  constexpr Angle<S> angle() {
    // A quarter of them on the multiples of 22.5 degrees, where sine and cosine are special.
    const auto bits = static_cast<std::uint32_t>(random_.next() >> 32);
    return Angle<S>::from_raw(random_.one_in(4) ? bits & 0xf0000000u : bits);
  }

  constexpr S any() { return scalar(random_.edgy(S::bits)); }

 private:
  static constexpr S scalar(std::int64_t raw) {
    return S::from_raw(static_cast<typename S::raw_type>(raw));
  }

  constexpr Vec<S, N> point_within(int bits) {
    Vec<S, N> point;
    const auto reach = std::int64_t{1} << bits;
    for (int i = 0; i < N; ++i) {
      point[i] = scalar(extreme_ ? random_.edgy(S::bits) : random_.between(-reach, reach - 1));
    }
    return point;
  }

  constexpr Vec<S, N> near(const Vec<S, N>& center, int bits) {
    const Vec<S, N> offset = point_within(bits);
    Vec<S, N> point;
    for (int i = 0; i < N; ++i) point[i] = saturate_to<S>(center[i] + offset[i]);
    return point;
  }

  /// A radius or half extent; sometimes nothing, sometimes negative.
  constexpr S extent() {
    if (random_.one_in(32)) return scalar(random_.between(-1, 0));
    return scalar(extreme_ ? random_.edgy(S::bits)
                           : random_.between(0, (std::int64_t{1} << size_) - 1));
  }

  constexpr Ray<S, N> ray() {
    const Vec<S, N> origin = near(middle_, size_);
    Vec<S, N> towards;
    for (int i = 0; i < N; ++i) towards[i] = saturate_to<S>(target_[i] - origin[i]);
    const auto aimed = normalize(towards);
    const S reach = scalar(random_.edgy(size_));
    return {origin, aimed && !random_.one_in(4) ? *aimed : direction(),
            random_.one_in(4) ? reach : S::max()};
  }

  Random random_;
  bool extreme_ = false;
  int size_ = 0;
  Vec<S, N> middle_{};
  Vec<S, N> target_{};
  Ray<S, N> ray_{};
};

template <Scalar S, int N, class Shape, class... Facings>
constexpr void cast(Tally& tally, const Ray<S, N>& ray, const Shape& shape, Facings... facing) {
  const auto distance = raycast(ray, shape, facing...);
  tally.count(distance.has_value());
  tally.add(distance, raycast_hit(ray, shape, facing...), raycast_interval(ray, shape, facing...));
}

template <Scalar S, int N, class Print>
constexpr void digest_queries(const char* scalar, int rounds, Print print) {
  Tally spheres, aabbs, obbs, planes, triangles, rotations;
  Corpus<S, N> corpus(static_cast<std::uint64_t>(10000 * S::bits + 100 * S::frac + N));
  for (int round = 0; round < rounds; ++round) {
    corpus.next_scene();
    const Ray<S, N>& ray = corpus.current_ray();
    cast(spheres, ray, corpus.sphere());
    cast(aabbs, ray, corpus.aabb());
    cast(obbs, ray, corpus.obb());
    const auto plane = corpus.plane();
    cast(planes, ray, plane);
    cast(planes, ray, plane, Facing::front);
    const auto triangle = corpus.triangle();
    cast(triangles, ray, triangle);
    if constexpr (N == 3) cast(triangles, ray, triangle, Facing::front);

    const auto rotation = corpus.rotation();
    for (int i = 0; i < N; ++i) rotations.add(rotation.axis(i));
    const auto angle = corpus.angle();
    rotations.add(sin(angle), cos(angle), angle.degrees(), angle.radians());
    const S y = corpus.any(), x = corpus.any();
    rotations.add(atan2(y, x).raw());
  }
  print(spheres.line("sphere", scalar, N));
  print(aabbs.line("aabb", scalar, N));
  print(obbs.line("obb", scalar, N));
  print(planes.line("plane", scalar, N));
  print(triangles.line("triangle", scalar, N));
  print(rotations.line("rotation", scalar, N));
}

/// Prints a line for each subject, scalar and dimension; returns the digest of all of them.
template <class Print>
constexpr std::uint64_t digest_corpus(int rounds, Print print) {
  Digest all;
  const auto print_and_add = [&](const Line& line) {
    print(line);
    all.add(line.digest);
  };
  digest_queries<q16_16, 2>("q16_16", rounds, print_and_add);
  digest_queries<q16_16, 3>("q16_16", rounds, print_and_add);
  digest_queries<q14_16, 2>("q14_16", rounds, print_and_add);
  digest_queries<q14_16, 3>("q14_16", rounds, print_and_add);
  digest_queries<q24_8, 2>("q24_8", rounds, print_and_add);
  digest_queries<q24_8, 3>("q24_8", rounds, print_and_add);
  digest_queries<q8_8, 2>("q8_8", rounds, print_and_add);
  digest_queries<q8_8, 3>("q8_8", rounds, print_and_add);
  return all.value();
}

}  // namespace detent::platforms
