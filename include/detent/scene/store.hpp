// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <type_traits>

#include "detent/cull/list.hpp"
#include "detent/cull/tree.hpp"
#include "detent/number/digest.hpp"
#include "detent/scene/frames.hpp"
#include "detent/scene/object.hpp"
#include "detent/scene/one_of.hpp"
#include "detent/scene/separate.hpp"
#include "detent/scene/shape_tag.hpp"

namespace detent::detail {

/// The objects of a scene, by index, and the trees over them.
///
/// Its state: for each object its id, shape (in its frame), layers, user word and motion; for each
/// frame its id, parent and transform; and the generation of the next id. Everything else is
/// derived: shapes in the world, boxes, trees, and the lowest free index.
template <class Storage, Scalar S, int N, class... Shapes>
class Store {
 public:
  using Shape = OneOf<Shapes...>;
  using Box = QuantizedBox<S, N>;

  struct Record {
    Shape shape{};  // in the world
    std::uint64_t user = 0;
    std::uint32_t generation = 0;  // 0 for an unused index
    std::uint32_t layers = 0;
    std::uint32_t attachment = nowhere;
    Motion motion = Motion::moving;
  };

  /// For an object in a frame: its shape there, and the frame.
  struct Attachment {
    Shape local{};
    std::uint32_t object = nowhere;
    std::uint32_t frame = nowhere;
  };

  static constexpr std::size_t capacity = Storage::capacity;
  static constexpr std::uint32_t last_generation = 0xfffffffeu;

  [[nodiscard]] constexpr std::size_t size() const noexcept { return size_; }
  /// All objects have indices below this.
  [[nodiscard]] constexpr std::size_t end() const noexcept { return records_.size(); }
  [[nodiscard]] constexpr const Record& operator[](std::size_t i) const noexcept {
    return records_[i];
  }
  [[nodiscard]] constexpr bool is_object(std::size_t i) const noexcept {
    return i < records_.size() && records_[i].generation != 0;
  }
  [[nodiscard]] constexpr const Record* find(const ObjectId& id) const noexcept {
    if (!is_object(id.index) || records_[id.index].generation != id.generation) return nullptr;
    return &records_[id.index];
  }
  [[nodiscard]] constexpr std::uint32_t frame_of(const Record& record) const noexcept {
    return record.attachment == nowhere ? nowhere : attachments_[record.attachment].frame;
  }
  /// The shape in the object's frame, as given.
  [[nodiscard]] constexpr const Shape& local_shape(const Record& record) const noexcept {
    return record.attachment == nowhere ? record.shape : attachments_[record.attachment].local;
  }
  [[nodiscard]] constexpr ObjectInfo info(std::size_t i) const noexcept {
    const Record& record = records_[i];
    return {{static_cast<std::uint32_t>(i), record.generation},
            record.layers,
            record.user,
            record.motion};
  }

  /// The canonical bytes of an object, without its motion.
  template <class D>
  constexpr void describe(D& out, std::size_t i) const noexcept {
    const Record& record = records_[i];
    out.add(static_cast<std::uint32_t>(i), record.generation, record.layers, record.user,
            frame_of(record));
    local_shape(record).visit([&](const auto& shape) { separately<job::Describe>(out, shape); });
  }
  /// Identifies the set of fixed objects: the sum of their digests.
  [[nodiscard]] constexpr std::uint64_t fixed_digest() const noexcept { return fixed_digest_; }
  [[nodiscard]] constexpr std::size_t fixed_size() const noexcept { return fixed_size_; }

  /// The lowest index of a moving object from `i` on, or `end()`.
  [[nodiscard]] constexpr std::size_t next_moving(std::size_t i) const noexcept {
    return next_bit(i, end(), [&](std::size_t word) { return is_moving_[word]; });
  }

  [[nodiscard]] constexpr const auto& frames() const noexcept { return frames_; }
  /// The frames, to be replaced: every object attached to them must then be put again.
  [[nodiscard]] constexpr auto& frames() noexcept { return frames_; }
  [[nodiscard]] constexpr const auto& tree(Motion motion) const noexcept {
    return motion == Motion::moving ? moving_ : fixed_;
  }

  [[nodiscard]] constexpr std::uint32_t next_generation() const noexcept { return next_; }
  constexpr void set_next_generation(std::uint32_t next) noexcept { next_ = next; }

  /// The id of the next object, or nothing when there is no room for one.
  [[nodiscard]] constexpr std::optional<ObjectId> next_id() noexcept {
    first_free_ = static_cast<std::uint32_t>(
        next_bit(first_free_, end(), [&](std::size_t word) { return ~is_used_[word]; }));
    if (first_free_ >= capacity || next_ > last_generation) return std::nullopt;
    return ObjectId{first_free_, next_};
  }

  /// Adds the object, or replaces the moving object at this index. Its frame must exist.
  constexpr void put(const ObjectId& id, const Shape& shape, const Traits& traits) {
    if (id.index >= records_.size()) {
      is_moving_.resize(id.index / 64 + std::size_t{1});
      is_used_.resize(id.index / 64 + std::size_t{1});
      records_.resize(id.index + std::size_t{1});
    }
    Record& record = records_[id.index];
    if (record.generation == 0) ++size_;
    is_used_[id.index / 64] |= bit_of(id.index);
    next_ = (std::max)(next_, id.generation + 1);
    record.user = traits.user;
    record.generation = id.generation;
    record.layers = traits.layers;
    record.motion = traits.motion;
    if (traits.motion == Motion::moving) is_moving_[id.index / 64] |= bit_of(id.index);
    if (traits.frame != FrameId{}) {
      attach(id.index, traits.frame.index);
    } else {
      detach(id.index);
    }
    assign(id.index, shape);
    count_in(id.index);
  }

  /// Between `begin_bulk` and `end_bulk`: does what `put` does, if that changes nothing but the shape
  /// of a moving object outside frames; otherwise returns false.
  constexpr bool put_shape(const ObjectId& id, const Shape& shape, const Traits& traits) {
    if (id.index >= records_.size() || traits.frame != FrameId{}) return false;
    Record& record = records_[id.index];
    if (record.generation != id.generation || record.layers != traits.layers ||
        record.user != traits.user || record.motion != Motion::moving ||
        record.attachment != nowhere) {
      return false;
    }
    if (record.shape == shape) return true;
    const Box box = box_of(shape);
    if (!moving_.set_in_bulk(id.index, box)) set_box(id.index, box);
    record.shape = shape;  // last, as in `assign`
    return true;
  }

  constexpr void remove(std::uint32_t i) {
    count_out(i);
    set_box(i, Box::none());
    detach(i);
    records_[i] = Record();
    is_moving_[i / 64] &= ~bit_of(i);
    is_used_[i / 64] &= ~bit_of(i);
    --size_;
    first_free_ = (std::min)(first_free_, i);
  }

  /// Replaces the object's shape, in its frame.
  constexpr void set_shape(std::uint32_t i, const Shape& shape) {
    count_out(i);
    assign(i, shape);
    count_in(i);
  }
  constexpr void set_layers(std::uint32_t i, std::uint32_t layers) noexcept {
    count_out(i);
    records_[i].layers = layers;
    count_in(i);
  }
  constexpr void set_user(std::uint32_t i, std::uint64_t user) noexcept {
    count_out(i);
    records_[i].user = user;
    count_in(i);
  }

  constexpr std::optional<FrameId> add_frame(const Transform<S, N>& transform,
                                             std::uint32_t parent) {
    if (next_ > last_generation) return std::nullopt;
    const auto id = frames_.next_id(next_);
    if (!id) return std::nullopt;
    ++next_;
    frames_.put(*id, transform, parent);
    return id;
  }

  constexpr void move_frame(const std::uint32_t& i, const Transform<S, N>& transform) {
    separately<job::MoveFrame>(frames_, i, transform);
    for (std::size_t k = 0; k < attachments_.size(); ++k) {
      if (frames_.has_moved(attachments_[k].frame)) {
        const auto local = attachments_[k].local;
        set_shape(attachments_[k].object, local);
      }
    }
  }
  [[nodiscard]] constexpr bool remove_frame(std::uint32_t i) noexcept {
    if (frames_.has_children(i)) return false;
    for (std::size_t k = 0; k < attachments_.size(); ++k) {
      if (attachments_[k].frame == i) return false;
    }
    frames_.remove(i);
    return true;
  }

  /// Call these around putting or removing many moving objects.
  constexpr void begin_bulk() noexcept { moving_.begin_bulk(); }
  constexpr void end_bulk() noexcept { moving_.end_bulk(); }

  constexpr void rebuild() {
    separately<job::Rebuild>(moving_);
    separately<job::Rebuild>(fixed_);
  }

  /// Leaves the store as if nothing had ever been added.
  constexpr void clear() noexcept {
    records_.clear();
    is_moving_.clear();
    is_used_.clear();
    attachments_.clear();
    frames_.clear();
    moving_.clear();
    fixed_.clear();
    size_ = fixed_size_ = 0;
    fixed_digest_ = 0;
    first_free_ = 0;
    next_ = 1;
  }

  constexpr void reserve(std::size_t objects) {
    records_.reserve(objects);
    moving_.reserve(objects);
  }

 private:
  static constexpr std::size_t attachment_capacity = Storage::frame_capacity == 0 ? 0 : capacity;

  static constexpr std::uint64_t bit_of(std::uint32_t i) noexcept {
    return std::uint64_t{1} << (i % 64);
  }

  /// The lowest i from `first` on whose bit is set in words(i / 64), or `last`.
  template <class Words>
  [[nodiscard]] static constexpr std::size_t next_bit(std::size_t first, std::size_t last,
                                                      const Words& words) noexcept {
    if (first >= last) return last;
    auto bits = words(first / 64) & ~std::uint64_t{0} << (first % 64);
    for (std::size_t word = first / 64; true; bits = words(word)) {
      if (bits != 0) {
        return (std::min)(last, 64 * word + static_cast<std::size_t>(std::countr_zero(bits)));
      }
      if (64 * ++word >= last) return last;
    }
  }

  constexpr void set_box(const std::uint32_t& i, const Box& box) {
    separately<job::SetBox>(records_[i].motion == Motion::moving ? moving_ : fixed_, i, box);
  }

  constexpr void count_in(std::uint32_t i) noexcept {
    if (records_[i].motion == Motion::moving) return;
    fixed_digest_ += digest_of(i);
    ++fixed_size_;
  }
  constexpr void count_out(std::uint32_t i) noexcept {
    if (records_[i].motion == Motion::moving) return;
    fixed_digest_ -= digest_of(i);
    --fixed_size_;
  }
  constexpr std::uint64_t digest_of(std::uint32_t i) const noexcept {
    Digest digest;
    describe(digest, i);
    return digest.value();
  }

  constexpr void assign(std::uint32_t i, const Shape& shape) {
    Record& record = records_[i];
    if (record.attachment == nowhere) {
      // The copy comes last: it loads whole vectors, which stalls on numbers that were just stored.
      set_box(i, box_of(shape));
      record.shape = shape;
    } else {
      attachments_[record.attachment].local = shape;
      place(attachments_[record.attachment]);
      set_box(i, box_of(record.shape));
    }
  }
  static constexpr Box box_of(const Shape& shape) noexcept {
    return shape.visit([](const auto& s) -> Box { return quantized_box(s); });
  }

  constexpr void place(const Attachment& attachment) noexcept {
    const auto& world = frames_[attachment.frame].world;
    records_[attachment.object].shape = attachment.local.visit(
        [&](const auto& s) { return Shape(separately<job::Place>(world, s)); });
  }

  constexpr void attach(std::uint32_t i, std::uint32_t frame) {
    Record& record = records_[i];
    if (record.attachment == nowhere) {
      record.attachment = static_cast<std::uint32_t>(attachments_.size());
      attachments_.push_back({Shape(), i, frame});
    }
    attachments_[record.attachment].frame = frame;
  }

  constexpr void detach(std::uint32_t i) noexcept {
    auto& place = records_[i].attachment;
    if (place == nowhere) return;
    attachments_[place] = attachments_.back();
    records_[attachments_[place].object].attachment = place;
    attachments_.pop_back();
    place = nowhere;
  }

  typename Storage::template List<Record, capacity> records_;
  typename Storage::template List<std::uint64_t, capacity / 64 + 1>
      is_moving_;  // a bit for each index
  typename Storage::template List<std::uint64_t, capacity / 64 + 1> is_used_;
  typename Storage::template List<Attachment, attachment_capacity> attachments_;
  Frames<Storage, S, N> frames_;
  Tree<Storage, S, N> moving_;
  Tree<Storage, S, N> fixed_;
  std::size_t size_ = 0;
  std::size_t fixed_size_ = 0;
  std::uint64_t fixed_digest_ = 0;
  std::uint32_t first_free_ = 0;  // no lower index is free
  std::uint32_t next_ = 1;
};

}  // namespace detent::detail
