// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <type_traits>

#include "c/assets.hpp"
#include "c/body_shapes.hpp"
#include "c/hulls.hpp"

namespace detent::c {

namespace {

/// Returns an asset's arrays to the context and frees its slot.
template <class Asset>
void destroy_asset(Context& context, void* object) {
  auto* const holder = static_cast<Holder<Asset>*>(object);
  auto& assets = context.assets<Asset>();
  const auto place = holder->asset - assets.list;
  assets.list[place] = Asset();
  assets.handles[place] = 0;
  for (const auto& array : holder->arrays) context.release(array.memory, array.size);
  context.release(holder, sizeof(Holder<Asset>));
}

/// Stores the asset make(holder) with this `id` in the context.
template <class Asset, class Make>
detent_status add_asset(Context& context, std::uint32_t id, detent_handle* out, const Make& make) {
  *out = 0;
  auto& assets = context.assets<Asset>();
  if (id == 0) return DETENT_BAD_ARGUMENT;
  if (assets.has_id(id)) return DETENT_IN_USE;
  if (assets.list == nullptr) {
    assets.list = context.allocate_array<Asset>(Assets<Asset>::capacity);
    if (assets.list == nullptr) return DETENT_NO_MEMORY;
  }
  std::uint32_t place = 0;
  while (place < assets.end && assets.handles[place] != 0) ++place;
  if (place == Assets<Asset>::capacity) return DETENT_FULL;
  detent_handle handle = 0;
  const auto status = context.make<Holder<Asset>>(asset_kind<Asset>, &handle, nullptr);
  if (status != DETENT_OK) return status;
  Slot& slot = *context.find(asset_kind<Asset>, handle);
  auto& holder = *static_cast<Holder<Asset>*>(slot.object);
  detent_status why = DETENT_NO_MEMORY;
  const std::optional<Asset> asset = make(holder, why);
  if (!asset) {
    for (const auto& array : holder.arrays) context.release(array.memory, array.size);
    context.destroy(slot);
    return why;
  }
  if (place == assets.end) ++assets.end;
  assets.list[place] = *asset;
  assets.handles[place] = handle;
  holder.asset = &assets.list[place];
  slot.destroy = destroy_asset<Asset>;
  *out = handle;
  return DETENT_OK;
}

/// Memory for `count` elements that belongs to a holder, or nullptr.
template <class T, class Array>
void* keep_memory(Context& context, Array& array, std::size_t count) noexcept {
  constexpr std::size_t slack = alignof(T);  // nodes of trees are aligned to cache lines
  if (count == 0 || count > (static_cast<std::size_t>(-1) - slack) / sizeof(T)) return nullptr;
  auto size = count * sizeof(T) + slack;
  void* memory = context.allocate(size);
  if (memory == nullptr) return nullptr;
  array = {memory, size};
  return std::align(alignof(T), count * sizeof(T), memory, size);
}
/// The same, initialised with elements.
template <class T, class Array>
T* keep(Context& context, Array& array, std::size_t count) noexcept {
  auto* const first = static_cast<T*>(keep_memory<T>(context, array, count));
  if (first != nullptr) std::uninitialized_value_construct_n(first, count);
  return first;
}

using MeshHolder = Holder<MeshAsset<S>>;
using FieldHolder = Holder<FieldAsset<S>>;

}  // namespace

template <int N, class Asset>
detent_status PointAssets<N, Asset>::create(detent_context* context, std::uint32_t id,
                                            const typename Types<N>::Vec* points,
                                            std::uint32_t count, detent_handle* out) {
  Context* const table = table_of(context);
  if (table == nullptr) return DETENT_BAD_CONTEXT;
  if (out == nullptr || (points == nullptr && count != 0) || count > Asset::capacity) {
    return DETENT_BAD_ARGUMENT;
  }
  const auto make_asset = [&](Holder<Asset>& holder, detent_status& why) -> std::optional<Asset> {
    auto* const own = keep<Vec<S, N>>(*table, holder.arrays[0], count);
    if (own == nullptr && count != 0) return std::nullopt;
    for (std::uint32_t i = 0; i < count; ++i) own[i] = Input<N>::vec(points[i]);
    why = DETENT_BAD_ARGUMENT;
    const ConvexHull<S, N> hull{{own, count}};
    if constexpr (std::is_same_v<Asset, SolidHull<S, N>>) {
      return solid_hull(id, hull);
    } else {
      return hull_asset(id, hull);
    }
  };
  return add_asset<Asset>(*table, id, out, make_asset);
}
template struct PointAssets<2, HullAsset<S, 2>>;
template struct PointAssets<3, HullAsset<S, 3>>;
template struct PointAssets<2, SolidHull<S, 2>>;
template struct PointAssets<3, SolidHull<S, 3>>;

template <int N>
detent_status HullRoom<N>::read(const detent_context* context,
                                const typename Types<N>::Shape& shape) {
  const Context* const table = table_of(context);
  if (table == nullptr) return DETENT_BAD_CONTEXT;
  const auto* const asset = table->asset<HullAsset<S, N>>(shape.asset);
  if (asset == nullptr) return DETENT_BAD_HANDLE;
  Input<N> in;
  const auto transform = in.transform(shape.as.placed);
  if (!in.is_valid()) return DETENT_NOT_UNIT;
  const detail::HullPoints<S, N> placed(PlacedHull<S, N>{asset, transform});
  count = placed.hull().points.size();
  std::copy_n(placed.hull().points.begin(), count, points.begin());
  return DETENT_OK;
}
template struct HullRoom<2>;
template struct HullRoom<3>;

/// Whether a part of a compound refers to a hull.
template <int N>
bool has_part_of(const void* holder, const void* asset) {
  const auto* const compound = static_cast<const Holder<SolidCompound<S, N>>*>(holder)->asset;
  bool does = false;
  for (const auto& part : compound->parts()) {
    part.shape().visit([&](const auto& shape) {
      if constexpr (requires { shape.asset; }) does |= shape.asset == asset;
    });
  }
  return does;
}

template <int N>
detent_status Compounds<N>::create(detent_context* context, std::uint32_t id,
                                   const typename Types<N>::Part* parts, std::uint32_t count,
                                   detent_handle* compound) {
  using Part = BodyPart<S, N>;
  static_assert(std::is_trivially_destructible_v<Part>);
  Context* const table = table_of(context);
  if (table == nullptr) return DETENT_BAD_CONTEXT;
  if (compound == nullptr || parts == nullptr || count == 0 ||
      count > SolidCompound<S, N>::capacity) {
    return DETENT_BAD_ARGUMENT;
  }
  const auto make = [&](auto& holder, detent_status& why) -> std::optional<SolidCompound<S, N>> {
    void* const memory = keep_memory<Part>(*table, holder.arrays[0], count);
    if (memory == nullptr) return std::nullopt;
    const Part* first = nullptr;
    for (std::uint32_t i = 0; i < count; ++i) {
      const auto& given = parts[i];
      why = DETENT_BAD_ARGUMENT;
      if (given.friction < 0 || given.restitution < 0 || given.rolling_resistance < 0 ||
          given.is_sensor > 1) {
        return std::nullopt;
      }
      const PartOptions<S> own{Input<N>::number(given.density), Input<N>::number(given.friction),
                               Input<N>::number(given.restitution), given.is_sensor != 0,
                               Input<N>::number(given.rolling_resistance)};
      why = with_part_shape<N>(*table, given.shape, [&](const auto& shape) -> detent_status {
        auto* const part =
            new (static_cast<std::byte*>(memory) + i * sizeof(Part)) Part(shape, own);
        if (i == 0) first = part;
        return DETENT_OK;
      });
      if (why != DETENT_OK) return std::nullopt;
    }
    return solid_compound(id, std::span<const Part>(first, count));
  };
  const auto status = add_asset<SolidCompound<S, N>>(*table, id, compound, make);
  if (status == DETENT_OK) {
    table->find(asset_kind<SolidCompound<S, N>>, *compound)->refers_to = has_part_of<N>;
  }
  return status;
}
template detent_status Compounds<2>::create(detent_context*, std::uint32_t, const detent_part2*,
                                            std::uint32_t, detent_handle*);
template detent_status Compounds<3>::create(detent_context*, std::uint32_t, const detent_part3*,
                                            std::uint32_t, detent_handle*);

}  // namespace detent::c

using namespace detent;
using namespace detent::c;

detent_status detent_mesh_create(detent_context* context, uint32_t id, const detent_vec3* vertices,
                                 uint32_t vertex_count, const uint32_t* faces, uint32_t face_count,
                                 detent_handle* mesh) {
  Context* const table = table_of(context);
  if (table == nullptr) return DETENT_BAD_CONTEXT;
  if (mesh == nullptr || (vertices == nullptr && vertex_count != 0) ||
      (faces == nullptr && face_count != 0) || face_count >= 1u << 28) {
    return DETENT_BAD_ARGUMENT;
  }
  for (std::size_t i = 0; i < std::size_t{3} * face_count; ++i) {
    if (faces[i] >= vertex_count) return DETENT_BAD_ARGUMENT;
  }
  const auto make = [&](MeshHolder& holder, detent_status&) -> std::optional<MeshAsset<S>> {
    if (face_count == 0) return MeshAsset<S>(id, Mesh<S>());
    auto* const triangles = keep<MeshTriangle<S>>(*table, holder.arrays[0], face_count);
    const auto node_count = tree_capacity(face_count);
    auto* const nodes = keep<MeshNode<S>>(*table, holder.arrays[1], node_count);
    if (triangles == nullptr || nodes == nullptr) return std::nullopt;
    const auto vertex = [&](std::size_t i) { return Input<3>::vec(vertices[faces[i]]); };
    for (std::uint32_t i = 0; i < face_count; ++i) {
      const auto k = std::size_t{3} * i;
      triangles[i] = {{vertex(k), vertex(k + 1), vertex(k + 2)}, i};
    }
    const auto built =
        build_mesh<S>(std::span(triangles, face_count), std::span(nodes, node_count));
    if (!built) return std::nullopt;
    return MeshAsset<S>(id, *built);
  };
  return add_asset<MeshAsset<S>>(*table, id, mesh, make);
}

detent_status detent_height_field_create(detent_context* context, uint32_t id,
                                         const detent_vec2* corner, int32_t cell, uint32_t columns,
                                         uint32_t rows, const int32_t* heights,
                                         detent_handle* field) {
  Context* const table = table_of(context);
  if (table == nullptr) return DETENT_BAD_CONTEXT;
  const auto count = std::uint64_t{columns} * rows;
  if (field == nullptr || corner == nullptr || heights == nullptr || columns < 2 || rows < 2 ||
      count >= std::uint64_t{1} << 31) {
    return DETENT_BAD_ARGUMENT;
  }
  const auto make = [&](FieldHolder& holder, detent_status& why) -> std::optional<FieldAsset<S>> {
    const auto size = static_cast<std::size_t>(count);
    auto* const own = keep<S>(*table, holder.arrays[0], size);
    if (own == nullptr) return std::nullopt;
    for (std::size_t i = 0; i < size; ++i) own[i] = Input<2>::number(heights[i]);
    const auto view = height_field<S>(Input<2>::vec(*corner), Input<2>::number(cell), columns, rows,
                                      std::span<const S>(own, size));
    why = DETENT_BAD_ARGUMENT;
    if (!view) return std::nullopt;
    return FieldAsset<S>(id, *view);
  };
  return add_asset<FieldAsset<S>>(*table, id, field, make);
}

detent_status detent_asset_destroy(detent_context* context, detent_handle asset) {
  Context* const table = table_of(context);
  if (table == nullptr) return DETENT_BAD_CONTEXT;
  const auto destroy = [&]<class Asset>(const Asset* found) -> detent_status {
    if (table->is_used(found)) return DETENT_IN_USE;
    if constexpr (requires { found->asset(); }) {  // of a scene that follows a world
      if (table->is_used(&found->asset())) return DETENT_IN_USE;
    }
    table->destroy(*table->find(asset_kind<Asset>, asset));
    return DETENT_OK;
  };
  if (const auto* const mesh = table->asset<MeshAsset<S>>(asset)) return destroy(mesh);
  if (const auto* const hull = table->asset<HullAsset<S, 2>>(asset)) return destroy(hull);
  if (const auto* const hull = table->asset<HullAsset<S, 3>>(asset)) return destroy(hull);
  if (const auto* const field = table->asset<FieldAsset<S>>(asset)) return destroy(field);
  if (const auto* const solid = table->asset<SolidHull<S, 2>>(asset)) return destroy(solid);
  if (const auto* const solid = table->asset<SolidHull<S, 3>>(asset)) return destroy(solid);
  if (const auto* const one = table->asset<SolidCompound<S, 2>>(asset)) return destroy(one);
  if (const auto* const one = table->asset<SolidCompound<S, 3>>(asset)) return destroy(one);
  return DETENT_BAD_HANDLE;
}
