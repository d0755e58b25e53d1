// SPDX-License-Identifier: MIT
#include "detent/scene/frames.hpp"

#include <vector>

#include "detent/scene/snapshot.hpp"
#include "support/catch.hpp"
#include "support/seal.hpp"

using namespace detent;
using S = q16_16;
using Move = Transform<S, 3>;

namespace {

constexpr std::uint32_t count = 100000;
long accesses = 0;

/// A list that counts accesses to its elements.
template <class T>
class CountingList : std::vector<T> {
  using Base = std::vector<T>;

 public:
  using Base::back;
  using Base::clear;
  using Base::pop_back;
  using Base::push_back;
  using Base::reserve;
  using Base::resize;
  using Base::size;
  T& operator[](std::size_t i) { return ++accesses, Base::operator[](i); }
  const T& operator[](std::size_t i) const { return ++accesses, Base::operator[](i); }
};
struct Counting {
  static constexpr std::size_t capacity = 8;
  static constexpr std::size_t frame_capacity = count;
  template <class T, std::size_t>
  using List = CountingList<T>;
};
using Frames = detail::Frames<Counting, S, 3>;

Move by(int x) { return {.translation = {S::from_raw(x), {}, {}}}; }
S x_of(const Frames& frames, std::uint32_t i) { return frames[i].world.translation.x; }

/// Frames 0 to `count` - 1, as from a snapshot; frame `i` has the parent parent_of(i).
template <class Parent>
Frames listed(const Parent& parent_of) {
  Frames frames;
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::uint32_t parent = parent_of(i);
    frames.set({i, parent == detail::nowhere ? 1 : 2 + count - i}, by(1), parent);
  }
  frames.place_all();
  return frames;
}

/// The last frame is the root; each other one is in the next.
std::uint32_t next_one(std::uint32_t i) { return i + 1 == count ? detail::nowhere : i + 1; }
std::uint32_t last_one(std::uint32_t i) { return i + 1 == count ? detail::nowhere : count - 1; }

}  // namespace

TEST_CASE("frames: each is accessed a few times, whatever the order of their indices") {
  accesses = 0;
  Frames chain = listed(next_one);
  CHECK(accesses < 20L * count);
  CHECK(x_of(chain, 0) == S::from_raw(count));
  accesses = 0;
  chain.move(count - 1, by(-5));
  CHECK(accesses < 20L * count);
  CHECK(x_of(chain, 0) == S::from_raw(count - 6));
  chain.move(count / 2, by(3));
  CHECK(x_of(chain, 0) == S::from_raw(count - 4));
  CHECK(chain.has_moved(count / 2 - 1));
  CHECK_FALSE(chain.has_moved(count / 2 + 1));

  accesses = 0;
  Frames star = listed(last_one);
  star.move(count - 1, by(7));
  CHECK(accesses < 40L * count);
  CHECK(x_of(star, 0) == S::from_raw(8));
  star.move(17, by(2));
  CHECK(x_of(star, 17) == S::from_raw(9));
  CHECK_FALSE(star.has_moved(16));
  CHECK_FALSE(star.has_moved(count - 1));
}

TEST_CASE(
    "frames: adding many takes a few accesses each, and the lowest free index is used first") {
  Frames frames;
  accesses = 0;
  std::uint32_t generation = 1;
  const auto add = [&](std::uint32_t parent) {
    const auto id = frames.next_id(generation);
    if (id) frames.put(*id, by(1), parent), ++generation;
    return id;
  };
  for (std::uint32_t i = 0; i < count; ++i) {
    REQUIRE(add(i == 0 ? detail::nowhere : i - 1) == FrameId{i, i + 1});
  }
  CHECK(accesses < 20L * count);
  CHECK(x_of(frames, count - 1) == S::from_raw(count));
  CHECK_FALSE(add(0));
  frames.remove(count - 1);
  frames.remove(count - 3);
  CHECK(add(0) == FrameId{count - 3, count + 1});
  CHECK(add(0) == FrameId{count - 1, count + 2});
  CHECK_FALSE(add(0));
}

TEST_CASE("restore: 100,000 nested frames take a few accesses each") {
  BasicScene<Counting, S, 3, Sphere<S, 3>> scene;
  std::vector<std::byte> bytes(snapshot(scene, std::span<std::byte>()));
  snapshot(scene, std::span(bytes));
  constexpr std::size_t frame_size = detail::FrameHeader::size + detail::byte_count<Move>;
  bytes.resize(bytes.size() + count * frame_size);
  detail::Writer out{std::span(bytes).subspan(detail::SnapshotHeader::size)};
  for (std::uint32_t i = 0; i < count; ++i) out.add(i, count - i, next_one(i), by(1));
  detail::store_word(bytes.data() + 12, count + 1);  // the next generation
  detail::store_word(bytes.data() + 16, count);
  detail::store_word(bytes.data() + 36, std::uint64_t{bytes.size()});
  test::seal(bytes);

  accesses = 0;
  REQUIRE(restore(scene, bytes) == Restored::yes);
  CHECK(accesses < 20L * count);
  const FrameId first{0, count}, last{count - 1, 1};
  CHECK(scene.frame(first)->world == by(count));
  const auto ball = scene.add(Sphere<S, 3>{}, {.frame = first}).value_or(no_object);
  accesses = 0;
  CHECK(scene.move_frame(last, by(-5)));
  CHECK(accesses < 20L * count);
  CHECK(scene.frame(first)->world == by(count - 6));
  CHECK(scene.shape<Sphere<S, 3>>(ball)->center.x == S::from_raw(count - 6));
  CHECK(scene.frame(first)->parent == FrameId{1, count - 1});
}
