// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "c/worlds.hpp"
#include "calls.hpp"
#include "numbers.hpp"
#include "support/catch.hpp"
#include "support/random.hpp"

namespace detent::test_c {

/// A world of C and one of C++ that get the same calls.
template <int N>
struct WorldTwins {
  using C = Calls<N>;
  using T = c::Types<N>;
  using Out = c::Output<N>;
  using W = typename c::Worlds<N>::World;

  detent_context context{};
  detent_handle world = 0;
  W twin;
  int began = 0, of_parts = 0;  // the events so far that began, and that were of later parts

  WorldTwins() {
    REQUIRE(detent_open(&context, nullptr) == DETENT_OK);
    REQUIRE(C::world_create(&context, nullptr, &world) == DETENT_OK);
  }
  WorldTwins(const WorldTwins&) = delete;
  WorldTwins& operator=(const WorldTwins&) = delete;
  ~WorldTwins() { CHECK(detent_close(&context) == DETENT_OK); }

  static typename T::Shape placed(std::uint32_t kind, detent_handle asset, const Vec<S, N>& at,
                                  const Rotation<S, N>& rotation = {}) {
    typename T::Shape shape{};
    shape.kind = kind;
    shape.asset = asset;
    shape.as.placed = Out::transform({at, rotation, S(1)});
    return shape;
  }

  template <class Shape>
  detent_id add(const Shape& shape, const typename W::Options& own = {}) {
    typename T::Shape theirs{};
    Out::shape(theirs, shape);
    return add(theirs, shape, own);
  }
  template <class Shape>
  detent_id add(const typename T::Shape& theirs, const Shape& shape,
                const typename W::Options& own = {}) {
    typename T::BodyOptions options{};
    REQUIRE(C::body_default_options(&options) == DETENT_OK);
    options.motion = static_cast<std::uint32_t>(own.motion);
    options.restitution = own.restitution.raw();
    options.rolling_resistance = own.rolling_resistance.raw();
    options.gravity_scale = own.gravity_scale.raw();
    options.velocity = Out::vec(own.velocity);
    options.angular_velocity[0] = own.angular_velocity[0].raw();
    options.locked = own.locked;
    options.is_sensor = own.is_sensor ? 1 : 0;
    options.is_fast = own.is_fast ? 1 : 0;
    options.user = own.user;
    detent_id id{};
    REQUIRE(C::world_add(&context, world, &theirs, &options, &id) == DETENT_OK);
    REQUIRE(twin.add(shape, own) == id_of(id));
    return id;
  }

  /// Steps both and compares their digests and events.
  void step() {
    REQUIRE(C::world_step(&context, world) == DETENT_OK);
    twin.step();
    std::uint64_t sum = 0;
    REQUIRE(C::world_digest(&context, world, &sum) == DETENT_OK);
    REQUIRE(sum == digest(twin));
    std::array<detent_touch, 64> touches{};
    std::uint32_t count = 0;
    REQUIRE(C::world_events(&context, world, touches.data(), 64, &count) == DETENT_OK);
    REQUIRE(count == twin.event_count());
    for (std::size_t i = 0; i < count; ++i) {
      const auto& own = twin.event(i);
      REQUIRE(id_of(touches[i].a) == own.a);
      REQUIRE(id_of(touches[i].b) == own.b);
      REQUIRE(touches[i].part_a == own.part_a);
      REQUIRE(touches[i].part_b == own.part_b);
      REQUIRE((touches[i].begins == 1) == own.begins);
      began += own.begins ? 1 : 0;
      of_parts += own.part_a + own.part_b != 0 ? 1 : 0;
    }
  }

  [[nodiscard]] std::vector<std::byte> saved() const {
    std::uint32_t size = 0;
    REQUIRE(C::world_snapshot(&context, world, nullptr, 0, &size) == DETENT_NO);
    std::vector<std::byte> bytes(size);
    REQUIRE(C::world_snapshot(&context, world, bytes.data(), size, &size) == DETENT_OK);
    return bytes;
  }
  [[nodiscard]] detent_status restore(const std::vector<std::byte>& bytes) {
    return C::world_restore(&context, world, bytes.data(),
                            static_cast<std::uint32_t>(bytes.size()));
  }
};

}  // namespace detent::test_c
