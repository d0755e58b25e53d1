// SPDX-License-Identifier: MIT
//
// Contexts and handles of the C interface: wrong, stale and null ones are errors, and memory comes
// from the caller's functions and is returned to them.

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <new>
#include <string>
#include <vector>

#include "detent.h"
#include "support/catch.hpp"

namespace {

/// The number of C++ allocations that still succeed; all if negative.
int allowed = -1;

bool may_allocate() { return allowed < 0 || allowed-- > 0; }

}  // namespace

void* operator new(std::size_t size) {
  void* const memory = may_allocate() ? std::malloc(size) : nullptr;
  if (memory == nullptr) {
    allowed = -1;  // fails only once
    throw std::bad_alloc();
  }
  return memory;
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }

namespace {

/// An allocator that counts its memory and fails after some allocations.
struct Heap {
  std::size_t bytes = 0;
  int blocks = 0, left = -1;

  detent_allocator hooks() {
    return {this,
            [](void* user, std::size_t size) -> void* {
              auto& heap = *static_cast<Heap*>(user);
              if (heap.left == 0) return nullptr;
              if (heap.left > 0) --heap.left;
              heap.bytes += size;
              ++heap.blocks;
              return std::malloc(size);
            },
            [](void* user, void* memory, std::size_t size) {
              auto& heap = *static_cast<Heap*>(user);
              heap.bytes -= size;
              --heap.blocks;
              std::free(memory);
            }};
  }
};

const detent_vec3 points[4] = {{0, 0, 0}, {65536, 0, 0}, {0, 65536, 0}, {0, 0, 65536}};
const std::uint32_t faces[6] = {0, 1, 2, 0, 2, 3};
const detent_vec2 corner{0, 0};
const std::int32_t heights[4] = {0, 1, 2, 3};

detent_shape3 ball() {
  detent_shape3 shape{};
  shape.kind = DETENT_SPHERE;
  shape.as.sphere.radius = 65536;
  return shape;
}

/// Makes one object of every type. Returns the first failure.
detent_status make_all(detent_context* context, std::vector<detent_handle>& made) {
  made.assign(10, 0);
  const detent_vec2 flat[1] = {{0, 0}};
  detent_status status = detent_scene2_create(context, &made[0]);
  if (status == DETENT_OK) status = detent_scene3_create(context, &made[1]);
  if (status == DETENT_OK) status = detent_world2_create(context, nullptr, &made[2]);
  if (status == DETENT_OK) status = detent_world3_create(context, nullptr, &made[3]);
  if (status == DETENT_OK) status = detent_mesh_create(context, 1, points, 4, faces, 2, &made[4]);
  if (status == DETENT_OK) status = detent_hull2_create(context, 1, flat, 1, &made[5]);
  if (status == DETENT_OK) status = detent_hull3_create(context, 1, points, 4, &made[6]);
  if (status == DETENT_OK) {
    status = detent_height_field_create(context, 1, &corner, 65536, 2, 2, heights, &made[7]);
  }
  detent_session_settings settings{};
  detent_session_default_settings(&settings);
  settings.replay_every = 1;
  if (status == DETENT_OK) status = detent_session2_create(context, &settings, made[2], &made[8]);
  if (status == DETENT_OK) status = detent_session3_create(context, &settings, made[3], &made[9]);
  return status;
}

/// The status of each type's function for a handle.
std::vector<detent_status> ask(detent_context* context, detent_handle handle) {
  std::uint32_t size = 0;
  std::uint64_t digest = 0;
  return {detent_scene2_size(context, handle, &size),
          detent_scene3_digest(context, handle, &digest), detent_world2_step(context, handle),
          detent_world3_size(context, handle, &size)};
}

TEST_CASE("C handles: each is valid only for its own type, and no longer once it is stale") {
  detent_context context{};
  REQUIRE(detent_open(&context, nullptr) == DETENT_OK);
  std::vector<detent_handle> made;
  REQUIRE(make_all(&context, made) == DETENT_OK);
  for (std::size_t i = 0; i < made.size(); ++i) {
    const auto answers = ask(&context, made[i]);
    for (std::size_t k = 0; k < answers.size(); ++k) {
      CAPTURE(i, k);
      CHECK(answers[k] == (i == k ? DETENT_OK : DETENT_BAD_HANDLE));
    }
  }
  for (const detent_handle wrong : {0u, 1u, 0xffffffffu, made[0] + 0x20000u, made[0] ^ 0x20u}) {
    for (const auto answer : ask(&context, wrong)) CHECK(answer == DETENT_BAD_HANDLE);
  }
  CHECK(detent_scene2_destroy(&context, made[0]) == DETENT_OK);
  CHECK(detent_scene2_destroy(&context, made[0]) == DETENT_BAD_HANDLE);
  detent_handle next = 0;
  CHECK(detent_scene2_create(&context, &next) == DETENT_OK);  // in the same slot
  CHECK(next != made[0]);
  for (const auto answer : ask(&context, made[0])) CHECK(answer == DETENT_BAD_HANDLE);
  CHECK(detent_asset_destroy(&context, made[1]) == DETENT_BAD_HANDLE);
  CHECK(detent_asset_destroy(&context, made[4]) == DETENT_IN_USE);  // a session might need it
  CHECK(detent_session2_destroy(&context, made[8]) == DETENT_OK);
  CHECK(detent_session3_destroy(&context, made[9]) == DETENT_OK);
  for (std::size_t i = 4; i < 8; ++i) {
    CHECK(detent_asset_destroy(&context, made[i]) == DETENT_OK);
    CHECK(detent_asset_destroy(&context, made[i]) == DETENT_BAD_HANDLE);
  }
  CHECK(detent_close(&context) == DETENT_OK);
}

TEST_CASE("C handles: no handle is issued twice, and a full table is reported") {
  detent_context context{};
  REQUIRE(detent_open(&context, nullptr) == DETENT_OK);
  std::vector<bool> was(1u << 15);
  detent_handle handle = 0;
  for (int i = 0; i < 35000; ++i) {  // a slot lasts for 32767 handles
    REQUIRE(detent_hull2_create(&context, 1, nullptr, 0, &handle) == DETENT_OK);
    REQUIRE(detent_asset_destroy(&context, handle) == DETENT_OK);
    if ((handle >> 5 & 0xfff) != 0) continue;
    REQUIRE(!was[handle >> 17]);
    was[handle >> 17] = true;
  }
  CHECK((handle >> 5 & 0xfff) == 1);
  detent_status status = DETENT_OK;
  int made = 0;
  for (; status == DETENT_OK; ++made) status = detent_scene2_create(&context, &handle);
  CHECK(status == DETENT_FULL);
  CHECK(made == 4096);  // the last one failed, and one slot is used up
  CHECK(handle == 0);
  CHECK(detent_close(&context) == DETENT_OK);
}

TEST_CASE("C contexts: null, closed and copied ones are errors") {
  detent_context context{};
  std::uint32_t count = 0;
  CHECK(detent_open(nullptr, nullptr) == DETENT_BAD_ARGUMENT);
  CHECK(detent_count(nullptr, &count) == DETENT_BAD_CONTEXT);
  CHECK(detent_count(&context, &count) == DETENT_BAD_CONTEXT);
  REQUIRE(detent_open(&context, nullptr) == DETENT_OK);
  CHECK(detent_open(&context, nullptr) == DETENT_BAD_CONTEXT);
  CHECK(detent_count(&context, nullptr) == DETENT_BAD_ARGUMENT);
  detent_context copy = context;
  CHECK(detent_count(&copy, &count) == DETENT_BAD_CONTEXT);
  CHECK(detent_close(&copy) == DETENT_BAD_CONTEXT);
  CHECK(detent_close(&context) == DETENT_OK);
  CHECK(detent_close(&context) == DETENT_BAD_CONTEXT);
  CHECK(detent_count(&copy, &count) == DETENT_BAD_CONTEXT);
  for (const auto answer : ask(&context, 0x10001)) CHECK(answer == DETENT_BAD_CONTEXT);
  auto half = Heap().hooks();
  half.release = nullptr;
  CHECK(detent_open(&context, &half) == DETENT_BAD_ARGUMENT);
}

TEST_CASE("C contexts: all memory is returned, and running out of it at any time is an error") {
  Heap heap;
  const auto hooks = heap.hooks();
  int failures = 0;
  for (int limit = 0;; ++limit) {
    CAPTURE(limit);
    heap.left = limit;
    detent_context context{};
    std::vector<detent_handle> made;
    detent_status status = detent_open(&context, &hooks);
    if (status == DETENT_OK) {
      status = make_all(&context, made);
      std::uint32_t count = 0;
      REQUIRE(detent_count(&context, &count) == DETENT_OK);
      std::uint32_t handles = 0;
      for (std::size_t i = 0; i < made.size(); ++i) {
        if (made[i] != 0) handles += i < 8 ? 1 : 2;  // a session has a world
      }
      CHECK(count == handles);
      CHECK(detent_close(&context) == DETENT_OK);
    }
    CHECK(heap.blocks == 0);
    CHECK(heap.bytes == 0);
    if (status == DETENT_OK) break;
    REQUIRE(status == DETENT_NO_MEMORY);
    ++failures;
  }
  CHECK(failures > 15);
}

TEST_CASE("C contexts: a scene whose lists run out of memory is broken, and no other is") {
  const auto shape = ball();
  int broken = 0;
  for (int limit = 0; limit < 12; ++limit) {
    detent_context context{};
    detent_handle scene = 0, other = 0;
    detent_id id{};
    REQUIRE(detent_open(&context, nullptr) == DETENT_OK);
    REQUIRE(detent_scene3_create(&context, &scene) == DETENT_OK);
    REQUIRE(detent_scene3_create(&context, &other) == DETENT_OK);
    allowed = limit;
    const auto status = detent_scene3_add(&context, scene, &shape, nullptr, &id);
    allowed = -1;
    if (status != DETENT_OK) {
      ++broken;
      CHECK(status == DETENT_NO_MEMORY);
      CHECK(detent_scene3_remove(&context, scene, id) == DETENT_BROKEN);
      std::uint64_t digest = 0;
      CHECK(detent_scene3_digest(&context, scene, &digest) == DETENT_BROKEN);
    }
    CHECK(detent_scene3_add(&context, other, &shape, nullptr, &id) == DETENT_OK);
    CHECK(detent_scene3_destroy(&context, scene) == DETENT_OK);
    CHECK(detent_close(&context) == DETENT_OK);
  }
  CHECK(broken > 2);
  CHECK(broken < 12);
}

TEST_CASE(
    "C sessions: running out of memory on creation leaves nothing, and later breaks the session") {
  detent_context context{};
  detent_handle world = 0, session = 0;
  detent_id id{};
  const auto shape = ball();
  REQUIRE(detent_open(&context, nullptr) == DETENT_OK);
  REQUIRE(detent_world3_create(&context, nullptr, &world) == DETENT_OK);
  REQUIRE(detent_world3_add(&context, world, &shape, nullptr, &id) == DETENT_OK);
  detent_session_settings settings{};
  REQUIRE(detent_session_default_settings(&settings) == DETENT_OK);
  settings.players = 1;
  int failures = 0;
  for (int limit = 0;; ++limit) {
    allowed = limit;
    const auto status = detent_session3_create(&context, &settings, world, &session);
    allowed = -1;
    std::uint32_t count = 0;
    CHECK(detent_count(&context, &count) == DETENT_OK);
    CHECK(count == (status == DETENT_OK ? 3u : 1u));
    CHECK((session != 0) == (status == DETENT_OK));
    if (status == DETENT_OK) break;
    REQUIRE(status == DETENT_NO_MEMORY);
    ++failures;
  }
  CHECK(failures > 20);

  detent_handle own = 0;
  detent_frame frame{};
  const std::uint8_t pad = 0;
  std::uint8_t inputs = 0;
  const auto begin = [&] {
    return detent_session3_begin_frame(&context, session, &pad, &frame, &inputs);
  };
  REQUIRE(detent_session3_world(&context, session, &own) == DETENT_OK);
  REQUIRE(begin() == DETENT_OK);
  allowed = 0;
  detent_status status = DETENT_OK;
  for (int i = 0; i < 1000 && status == DETENT_OK; ++i) {
    status = detent_world3_add(&context, own, &shape, nullptr, &id);
  }
  allowed = -1;
  CHECK(status == DETENT_NO_MEMORY);
  CHECK(detent_session3_end_frame(&context, session) == DETENT_BROKEN);
  CHECK(begin() == DETENT_BROKEN);
  CHECK(detent_session3_destroy(&context, session) == DETENT_OK);
  CHECK(detent_close(&context) == DETENT_OK);
}

TEST_CASE("C worlds: settings and options out of range are errors") {
  detent_context context{};
  REQUIRE(detent_open(&context, nullptr) == DETENT_OK);
  detent_world3_settings settings{};
  REQUIRE(detent_world3_default_settings(&settings) == DETENT_OK);
  CHECK(settings.ticks_per_second == 60);
  CHECK(settings.gravity.y == -10 * 65536);
  detent_handle world = 0;
  CHECK(detent_world3_create(&context, &settings, &world) == DETENT_OK);
  for (const std::int32_t rate : {0, -1, 32768, 16384, INT32_MAX, INT32_MIN}) {
    auto wrong = settings;
    wrong.ticks_per_second = rate;
    detent_handle none = 0;
    CHECK(detent_world3_create(&context, &wrong, &none) == DETENT_BAD_ARGUMENT);
    CHECK(none == 0);
  }
  detent_body3_options options{};
  REQUIRE(detent_body3_default_options(&options) == DETENT_OK);
  const auto shape = ball();
  detent_id id{};
  CHECK(detent_world3_add(&context, world, &shape, &options, &id) == DETENT_OK);
  auto wrong = options;
  wrong.motion = 3;
  CHECK(detent_world3_add(&context, world, &shape, &wrong, &id) == DETENT_BAD_ARGUMENT);
  wrong = options;
  wrong.friction = -1;
  CHECK(detent_world3_add(&context, world, &shape, &wrong, &id) == DETENT_BAD_ARGUMENT);
  wrong = options;
  wrong.rolling_resistance = -1;
  CHECK(detent_world3_add(&context, world, &shape, &wrong, &id) == DETENT_BAD_ARGUMENT);
  auto triangle = shape;
  triangle.kind = DETENT_TRIANGLE;
  CHECK(detent_world3_add(&context, world, &triangle, &options, &id) == DETENT_NO_QUERY);
  std::uint32_t size = 0;
  CHECK(detent_world3_size(&context, world, &size) == DETENT_OK);
  CHECK(size == 1);
  CHECK(detent_close(&context) == DETENT_OK);
}

TEST_CASE("C statuses: each has its own description") {
  std::vector<std::string> words;
  for (int status = -30; status < 3; ++status) words.emplace_back(detent_describe(status));
  std::sort(words.begin(), words.end());
  words.erase(std::unique(words.begin(), words.end()), words.end());
  CHECK(words.size() == 22);  // 21 statuses, and one for unknown numbers
}

}  // namespace
