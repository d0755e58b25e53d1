// SPDX-License-Identifier: MIT
#include "c/context.hpp"

#include <cstdlib>

#include "detent/lockstep/config.hpp"
#include "detent/version.hpp"

namespace detent::c {

namespace {

void* allocate_plainly(void*, std::size_t size) { return std::malloc(size); }
void release_plainly(void*, void* memory, std::size_t) { std::free(memory); }

}  // namespace

Context::~Context() {
  // Scenes refer to assets, which are destroyed after them.
  for (const bool assets : {false, true}) {
    for (std::uint32_t i = 0; i < end_; ++i) {
      const auto kind = static_cast<Kind>(slots_[i].handle & 31);
      const bool is_asset = kind >= Kind::mesh && kind <= Kind::compound3;
      if (slots_[i].handle != 0 && is_asset == assets) destroy(slots_[i]);
    }
  }
  release(slots_, capacity_ * sizeof(Slot));
  const auto release_list = [&]<class Asset>(Assets<Asset>& assets) {
    if (assets.list != nullptr) release(assets.list, Assets<Asset>::capacity * sizeof(Asset));
  };
  release_list(meshes_);
  release_list(hulls2_);
  release_list(hulls3_);
  release_list(fields_);
  release_list(solids2_);
  release_list(solids3_);
  release_list(compounds2_);
  release_list(compounds3_);
}

void Context::close() noexcept {
  const auto allocator = allocator_;
  this->~Context();
  allocator.release(allocator.user, this, sizeof(Context));
}

Slot* Context::reserve(Kind kind, detent_status& status) noexcept {
  std::uint32_t index = 0;
  while (index < end_ && (slots_[index].handle != 0 || slots_[index].generation == last_generation))
    ++index;
  if (index == slot_limit) {
    status = DETENT_FULL;
    return nullptr;
  }
  if (index == capacity_) {
    const auto capacity = capacity_ == 0 ? 16 : 2 * capacity_;
    auto* const slots = allocate_array<Slot>(capacity);
    if (slots == nullptr) {
      status = DETENT_NO_MEMORY;
      return nullptr;
    }
    for (std::uint32_t i = 0; i < end_; ++i) slots[i] = slots_[i];
    release(slots_, capacity_ * sizeof(Slot));
    slots_ = slots;
    capacity_ = capacity;
  }
  if (index == end_) ++end_;
  Slot& slot = slots_[index];
  slot.generation = static_cast<std::uint16_t>(slot.generation + 1);
  slot.handle =
      std::uint32_t{slot.generation} << 17 | index << 5 | static_cast<std::uint32_t>(kind);
  ++count_;
  return &slot;
}

void Context::give_back(Slot& slot) noexcept {
  const auto generation = slot.generation;
  slot = Slot();
  slot.generation = generation;
  --count_;
}

bool Context::is_used(const void* asset) const noexcept {
  for (std::uint32_t i = 0; i < end_; ++i) {
    const Slot& slot = slots_[i];
    if (slot.handle == 0 || slot.refers_to == nullptr) continue;
    if (slot.is_broken || slot.refers_to(slot.object, asset)) return true;
  }
  return false;
}

}  // namespace detent::c

using namespace detent::c;

int32_t detent_version(void) {
  return DETENT_VERSION_MAJOR * 10000 + DETENT_VERSION_MINOR * 100 + DETENT_VERSION_PATCH;
}

int32_t detent_results_version(void) { return detent::results_version; }

const char* detent_describe(detent_status status) {
  switch (status) {
    case DETENT_OK:
      return "done, or yes";
    case DETENT_NO:
      return "no, or there is none";
    case DETENT_BAD_ARGUMENT:
      return "a null pointer, an unknown kind, or a number out of range";
    case DETENT_BAD_CONTEXT:
      return "the context is null, not open, closed or a copy";
    case DETENT_BAD_HANDLE:
      return "the handle is of another type, stale, or was never given out";
    case DETENT_NOT_UNIT:
      return "the length of a direction is not 1";
    case DETENT_NO_QUERY:
      return "there is no such query for these kinds of shape";
    case DETENT_NO_MEMORY:
      return "an allocation failed";
    case DETENT_BROKEN:
      return "an allocation failed while this scene or world changed: destroy it";
    case DETENT_FULL:
      return "there is no room for more objects, handles or assets";
    case DETENT_IN_USE:
      return "an object or body refers to the asset, or its id is taken";
    case DETENT_NOT_NOW:
      return "the world of a session changes in its frames only, or no frame is open";
    case DETENT_NO_SNAPSHOT:
      return "these bytes are not a snapshot";
    case DETENT_OTHER_VERSION:
      return "the snapshot has a version that this library does not read";
    case DETENT_TRUNCATED:
      return "the snapshot is cut off";
    case DETENT_CORRUPTED:
      return "the bytes of the snapshot have been changed";
    case DETENT_OTHER_SCENE:
      return "the snapshot is of another dimension, set of shapes or settings";
    case DETENT_OTHER_FIXED_PART:
      return "fixed objects or bodies differ from those of the snapshot";
    case DETENT_NO_ROOM:
      return "the snapshot has more than a scene or world can hold";
    case DETENT_UNKNOWN_ASSET:
      return "the snapshot refers to an asset that the context does not have";
    case DETENT_OTHER_ASSET:
      return "the asset of this id has other triangles, points or heights";
    default:
      return "not a status of this library";
  }
}

detent_status detent_open(detent_context* context, const detent_allocator* allocator) {
  if (context == nullptr) return DETENT_BAD_ARGUMENT;
  if (table_of(context) != nullptr) return DETENT_BAD_CONTEXT;
  detent_allocator own{nullptr, allocate_plainly, release_plainly};
  if (allocator != nullptr) {
    if ((allocator->allocate == nullptr) != (allocator->release == nullptr)) {
      return DETENT_BAD_ARGUMENT;
    }
    if (allocator->allocate != nullptr) own = *allocator;
  }
  void* const memory = own.allocate(own.user, sizeof(Context));
  if (memory == nullptr) return DETENT_NO_MEMORY;
  const auto* const table = new (memory) Context(own);
  *context = {{mark_of(context), reinterpret_cast<std::uintptr_t>(table), 0, 0}};
  return DETENT_OK;
}

detent_status detent_close(detent_context* context) {
  Context* const table = table_of(context);
  if (table == nullptr) return DETENT_BAD_CONTEXT;
  *context = {};
  table->close();
  return DETENT_OK;
}

detent_status detent_count(const detent_context* context, uint32_t* count) {
  const Context* const table = table_of(context);
  if (table == nullptr) return DETENT_BAD_CONTEXT;
  if (count == nullptr) return DETENT_BAD_ARGUMENT;
  *count = table->count();
  return DETENT_OK;
}

detent_status detent_session_default_settings(detent_session_settings* settings) {
  if (settings == nullptr) return DETENT_BAD_ARGUMENT;
  const detent::SessionConfig own;
  *settings = {};
  settings->send_interval = own.send_interval;
  settings->silence = own.silence;
  settings->players = static_cast<std::uint32_t>(own.players);
  settings->delay = own.delay;
  settings->prediction = own.prediction;
  settings->frames_per_call = own.frames_per_call;
  settings->wants_seat = own.wants_seat ? 1 : 0;
  settings->input_size = 1;
  return DETENT_OK;
}
