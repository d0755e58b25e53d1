// SPDX-License-Identifier: MIT
#pragma once

#include "c/context.hpp"
#include "detent/dynamics/terrain.hpp"

// The shapes of bodies, and of the parts of compounds.
namespace detent::c {

/// f(asset, pose) for a shape given as an asset and its pose, unscaled.
template <int N, class Asset, class F>
detent_status with_posed(const Context& table, const typename Types<N>::Shape& shape, const F& f) {
  const auto* const asset = table.asset<Asset>(shape.asset);
  if (asset == nullptr) return DETENT_BAD_HANDLE;
  if (shape.as.placed.scale != S(1).raw()) return DETENT_BAD_ARGUMENT;
  Input<N> in;
  const auto pose = in.transform(shape.as.placed);
  return in.is_valid() ? f(asset, pose) : DETENT_NOT_UNIT;
}

/// f(shape) for the shape of a part of a compound.
template <int N, class F>
detent_status with_part_shape(const Context& table, const typename Types<N>::Shape& shape,
                              const F& f) {
  if (shape.kind == DETENT_HULL) {
    return with_posed<N, SolidHull<S, N>>(table, shape, [&](const auto* asset, const auto& pose) {
      return f(BodyHull<S, N>{asset, pose.translation, pose.rotation});
    });
  }
  return with_shape<N>(shape, [&](const auto& read) -> detent_status {
    if constexpr (requires { BodyPart<S, N>(read); }) {
      return f(read);
    } else {
      return DETENT_NO_QUERY;
    }
  });
}

/// f(shape) for the shape of a body.
template <int N, class F>
detent_status with_body_shape(const Context& table, const typename Types<N>::Shape& shape,
                              const F& f) {
  if (shape.kind == DETENT_COMPOUND) {
    return with_posed<N, SolidCompound<S, N>>(
        table, shape, [&](const auto* asset, const auto& pose) {
          return f(BodyCompound<S, N>{asset, pose.translation, pose.rotation});
        });
  }
  if constexpr (N == 3) {
    if (shape.kind == DETENT_MESH) {
      return with_posed<N, MeshAsset<S>>(table, shape, [&](const auto* asset, const auto& pose) {
        return f(BodyMesh<S, N>{asset, pose.translation, pose.rotation});
      });
    }
    if (shape.kind == DETENT_HEIGHT_FIELD) {
      const auto* const asset = table.asset<FieldAsset<S>>(shape.asset);
      if (asset == nullptr) return DETENT_BAD_HANDLE;
      return f(BodyHeightField<S, N>{asset, Input<N>::vec(shape.as.point)});
    }
  }
  return with_part_shape<N>(table, shape, f);
}

}  // namespace detent::c
