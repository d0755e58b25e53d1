// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <new>
#include <span>
#include <type_traits>
#include <utility>

#include "c/convert.hpp"
#include "detent/dynamics/compound.hpp"
#include "detent/dynamics/hull.hpp"
#include "detent/scene/height_field.hpp"
#include "detent/scene/hull.hpp"
#include "detent/scene/mesh.hpp"

// The table of a context. A handle is a generation (15 bits), an index of the table (12) and a kind
// (5). A slot keeps the handle that was issued for it, so one comparison detects a wrong or stale
// handle. A slot whose generations are used up is never reused.
namespace detent::c {

enum class Kind : std::uint32_t {
  none,
  scene2,
  scene3,
  world2,
  world3,
  mesh,  // assets from here on
  hull2,
  hull3,
  field,
  solid2,
  solid3,
  compound2,
  compound3,
  session2,  // no assets from here on
  session3,
  replay2,
  replay3
};

class Context;

/// The game's words next to the world of a session or replay.
struct Words {
  std::uint32_t count = 0;
  std::array<std::uint32_t, DETENT_WORDS> values{};

  [[nodiscard]] std::span<const std::uint32_t> span() const noexcept {
    return {values.data(), count};
  }
};

/// The content of a slot: an object, how to destroy it, and whether it refers to an asset.
struct Slot {
  detent_handle handle = 0;  // 0: free
  std::uint16_t generation = 0;
  bool is_broken = false;
  bool is_owned = false;   // owned by a session or replay, which destroys it
  bool is_locked = false;  // read-only at present
  Words* words = nullptr;  // those of an owned world
  void* object = nullptr;
  void (*destroy)(Context&, void*) = nullptr;
  bool (*refers_to)(const void* object, const void* asset) = nullptr;
};

/// Assets of one type, at stable addresses; unused ones have the id 0.
template <class Asset>
struct Assets {
  static constexpr std::uint32_t capacity = sizeof(Asset) < 1024 ? 256 : 64;

  Asset* list = nullptr;
  std::uint32_t end = 0;  // free from here on
  detent_handle handles[capacity] = {};

  [[nodiscard]] std::span<const Asset> span() const noexcept { return {list, end}; }
  [[nodiscard]] bool has_id(std::uint32_t id) const noexcept {
    for (const auto& asset : span()) {
      if (asset.id() == id) return true;
    }
    return false;
  }
  /// 0 for an asset of another list.
  [[nodiscard]] detent_handle handle_of(const Asset* asset) const noexcept {
    for (std::uint32_t i = 0; i < end; ++i) {
      if (&list[i] == asset) return handles[i];
    }
    return 0;
  }
};

template <class T>
inline constexpr Kind asset_kind = Kind::none;
template <>
inline constexpr Kind asset_kind<MeshAsset<S>> = Kind::mesh;
template <>
inline constexpr Kind asset_kind<HullAsset<S, 2>> = Kind::hull2;
template <>
inline constexpr Kind asset_kind<HullAsset<S, 3>> = Kind::hull3;
template <>
inline constexpr Kind asset_kind<FieldAsset<S>> = Kind::field;
template <>
inline constexpr Kind asset_kind<SolidHull<S, 2>> = Kind::solid2;
template <>
inline constexpr Kind asset_kind<SolidHull<S, 3>> = Kind::solid3;
template <>
inline constexpr Kind asset_kind<SolidCompound<S, 2>> = Kind::compound2;
template <>
inline constexpr Kind asset_kind<SolidCompound<S, 3>> = Kind::compound3;

class Context {
 public:
  static constexpr std::uint32_t slot_limit = 1u << 12;
  static constexpr std::uint16_t last_generation = (1u << 15) - 1;

  explicit Context(const detent_allocator& allocator) noexcept : allocator_(allocator) {}
  Context(const Context&) = delete;
  Context& operator=(const Context&) = delete;
  ~Context();
  /// Destroys everything and frees the memory of the table itself.
  void close() noexcept;

  [[nodiscard]] void* allocate(std::size_t size) noexcept {
    return allocator_.allocate(allocator_.user, size);
  }
  void release(void* memory, std::size_t size) noexcept {
    if (memory != nullptr) allocator_.release(allocator_.user, memory, size);
  }
  template <class T>
  [[nodiscard]] T* allocate_array(std::size_t count) noexcept {
    static_assert(alignof(T) <= alignof(std::max_align_t));
    if (count > static_cast<std::size_t>(-1) / 2 / sizeof(T)) return nullptr;
    auto* const memory = static_cast<T*>(allocate(count * sizeof(T)));
    if (memory != nullptr) std::uninitialized_value_construct_n(memory, count);
    return memory;
  }

  /// The slot of a handle, or nullptr for one that is wrong or stale.
  [[nodiscard]] Slot* find(Kind kind, detent_handle handle) const noexcept {
    const auto index = handle >> 5 & (slot_limit - 1);
    if (index >= end_ || (handle & 31) != static_cast<std::uint32_t>(kind)) return nullptr;
    return slots_[index].handle == handle ? &slots_[index] : nullptr;
  }
  /// An empty slot with its handle, or nullptr: `status` says why.
  [[nodiscard]] Slot* reserve(Kind kind, detent_status& status) noexcept;
  void give_back(Slot& slot) noexcept;

  /// Makes an object in a new slot.
  template <class T, class... Arguments>
  detent_status make(Kind kind, detent_handle* out, bool (*refers_to)(const void*, const void*),
                     const Arguments&... arguments) {
    static_assert(alignof(T) <= alignof(std::max_align_t));
    *out = 0;
    detent_status status = DETENT_OK;
    Slot* const slot = reserve(kind, status);
    if (slot == nullptr) return status;
    void* const memory = allocate(sizeof(T));
    if (memory == nullptr) {
      give_back(*slot);
      return DETENT_NO_MEMORY;
    }
    slot->object = new (memory) T(arguments...);
    slot->refers_to = refers_to;
    slot->destroy = [](Context& context, void* object) {
      static_cast<T*>(object)->~T();
      context.release(object, sizeof(T));
    };
    *out = slot->handle;
    return DETENT_OK;
  }
  void destroy(Slot& slot) noexcept {
    slot.destroy(*this, slot.object);
    give_back(slot);
  }

  [[nodiscard]] bool is_used(const void* asset) const noexcept;
  [[nodiscard]] std::uint32_t count() const noexcept { return count_; }

  template <class Asset>
  [[nodiscard]] Assets<Asset>& assets() noexcept {
    return const_cast<Assets<Asset>&>(std::as_const(*this).template assets<Asset>());
  }
  template <class Asset>
  [[nodiscard]] const Assets<Asset>& assets() const noexcept {
    if constexpr (asset_kind<Asset> == Kind::mesh) {
      return meshes_;
    } else if constexpr (asset_kind<Asset> == Kind::hull2) {
      return hulls2_;
    } else if constexpr (asset_kind<Asset> == Kind::hull3) {
      return hulls3_;
    } else if constexpr (asset_kind<Asset> == Kind::solid2) {
      return solids2_;
    } else if constexpr (asset_kind<Asset> == Kind::solid3) {
      return solids3_;
    } else if constexpr (asset_kind<Asset> == Kind::compound2) {
      return compounds2_;
    } else if constexpr (asset_kind<Asset> == Kind::compound3) {
      return compounds3_;
    } else {
      return fields_;
    }
  }
  /// The asset of a handle, or nullptr.
  template <class Asset>
  [[nodiscard]] const Asset* asset(detent_handle handle) const noexcept;

 private:
  detent_allocator allocator_;
  Slot* slots_ = nullptr;
  std::uint32_t end_ = 0;       // slots that were ever used
  std::uint32_t capacity_ = 0;  // slots that have memory
  std::uint32_t count_ = 0;     // slots in use
  Assets<MeshAsset<S>> meshes_;
  Assets<HullAsset<S, 2>> hulls2_;
  Assets<HullAsset<S, 3>> hulls3_;
  Assets<FieldAsset<S>> fields_;
  Assets<SolidHull<S, 2>> solids2_;
  Assets<SolidHull<S, 3>> solids3_;
  Assets<SolidCompound<S, 2>> compounds2_;
  Assets<SolidCompound<S, 3>> compounds3_;
};

/// An asset and the arrays that it views.
template <class Asset>
struct Holder {
  struct Array {
    void* memory = nullptr;
    std::size_t size = 0;
  };
  const Asset* asset = nullptr;
  Array arrays[2];
};

template <class Asset>
const Asset* Context::asset(detent_handle handle) const noexcept {
  const Slot* const slot = find(asset_kind<Asset>, handle);
  return slot == nullptr ? nullptr : static_cast<const Holder<Asset>*>(slot->object)->asset;
}

/// The first word of an open context: a number unique to this address.
[[nodiscard]] inline std::uint64_t mark_of(const detent_context* context) noexcept {
  return 0x9d4e'7c31'a5f2'60b9u ^ reinterpret_cast<std::uintptr_t>(context);
}
/// The table of an open context, or nullptr.
[[nodiscard]] inline Context* table_of(const detent_context* context) noexcept {
  if (context == nullptr || context->words[0] != mark_of(context)) return nullptr;
  return reinterpret_cast<Context*>(static_cast<std::uintptr_t>(context->words[1]));
}

/// Returns f(); if an allocation in it fails, the object in `slot`, if given, is marked as broken.
template <class F>
detent_status guarded(Slot* slot, const F& f) noexcept {
#if defined(__cpp_exceptions)
  try {
    return f();
  } catch (...) {
    if (slot != nullptr) slot->is_broken = true;
    return DETENT_NO_MEMORY;
  }
#else
  (void)slot;
  return f();
#endif
}

/// Returns f(table, object) for the object of a handle, which is a `T`.
template <class T, class F>
detent_status with_object(const detent_context* context, Kind kind, detent_handle handle,
                          const F& f) noexcept {
  Context* const table = table_of(context);
  if (table == nullptr) return DETENT_BAD_CONTEXT;
  Slot* const slot = table->find(kind, handle);
  if (slot == nullptr) return DETENT_BAD_HANDLE;
  if (slot->is_broken) return DETENT_BROKEN;
  if (slot->is_locked) return DETENT_NOT_NOW;
  auto& object = *static_cast<T*>(slot->object);
  return guarded(slot, [&]() -> detent_status { return f(*table, object); });
}
/// The same for calls that only read: they break nothing.
template <class T, class F>
detent_status read_object(const detent_context* context, Kind kind, detent_handle handle,
                          const F& f) noexcept {
  const Context* const table = table_of(context);
  if (table == nullptr) return DETENT_BAD_CONTEXT;
  const Slot* const slot = table->find(kind, handle);
  if (slot == nullptr) return DETENT_BAD_HANDLE;
  if (slot->is_broken) return DETENT_BROKEN;
  const auto& object = *static_cast<const T*>(slot->object);
  return guarded(nullptr, [&]() -> detent_status { return f(*table, object); });
}

/// Writes f(object) to the caller's memory.
template <class T, class Out, class F>
detent_status write_from(const detent_context* context, Kind kind, detent_handle handle, Out* out,
                         const F& f) noexcept {
  const auto write = [&](const Context&, const T& object) -> detent_status {
    if (out == nullptr) return DETENT_BAD_ARGUMENT;
    *out = static_cast<Out>(f(object));
    return DETENT_OK;
  };
  return read_object<T>(context, kind, handle, write);
}

[[nodiscard]] inline detent_status destroy_object(detent_context* context, Kind kind,
                                                  detent_handle handle) noexcept {
  Context* const table = table_of(context);
  if (table == nullptr) return DETENT_BAD_CONTEXT;
  Slot* const slot = table->find(kind, handle);
  if (slot == nullptr) return DETENT_BAD_HANDLE;
  if (slot->is_owned) return DETENT_IN_USE;
  table->destroy(*slot);
  return DETENT_OK;
}

/// Writes the results of query(room), which are `From`s as large as `To`s, to the caller's memory.
template <class From, class To, class Query, class Convert>
detent_status write_list(To* to, std::uint32_t room, std::uint32_t* count, const Query& query,
                         const Convert& convert) {
  static_assert(sizeof(From) == sizeof(To) && alignof(From) <= alignof(To));
  static_assert(std::is_trivially_copyable_v<From> && std::is_trivially_copyable_v<To>);
  if (count == nullptr || (to == nullptr && room != 0)) return DETENT_BAD_ARGUMENT;
  From* first = nullptr;
  for (std::uint32_t i = 0; i < room; ++i) {
    auto* const made = new (static_cast<void*>(to + i)) From();
    if (i == 0) first = made;
  }
  const auto found = query(std::span<From>(first, room));
  for (std::uint32_t i = 0; i < room; ++i) {
    const From from = i < found ? first[i] : From();
    new (static_cast<void*>(to + i)) To(i < found ? convert(from) : To());
  }
  *count = static_cast<std::uint32_t>(found);
  return DETENT_OK;
}

}  // namespace detent::c
