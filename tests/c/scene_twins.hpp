// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "c/scenes.hpp"
#include "calls.hpp"
#include "detent/scene/mesh/owned.hpp"
#include "numbers.hpp"
#include "support/catch.hpp"
#include "support/random.hpp"

// Scenes of the C interface against scenes of C++: equal calls give equal bits.

namespace detent::test_c {

/// A point; 2D ignores z.
template <int N>
Vec<S, N> at(std::int64_t x, std::int64_t y, std::int64_t z = 0) {
  return make_vec<N>([&](int i) { return raw(i == 0 ? x : i == 1 ? y : z); });
}

/// The mesh and the height field of a scene, which only 3D has.
template <int N>
struct SurfaceTwins {
  void create(detent_context&, const std::vector<Vec<S, N>>&) {}
};
template <>
struct SurfaceTwins<3> {
  detent_handle mesh = 0, field = 0;
  std::vector<OwnedMesh<S>> triangles;
  std::vector<S> heights;
  std::vector<MeshAsset<S>> meshes;
  std::vector<FieldAsset<S>> fields;

  void create(detent_context& context, const std::vector<Vec<S, 3>>& corners) {
    constexpr std::array<VertexIndices, 4> faces{VertexIndices{0, 2, 1}, VertexIndices{0, 1, 3},
                                                 VertexIndices{0, 3, 2}, VertexIndices{1, 2, 3}};
    std::vector<detent_vec3> points;
    for (const auto& corner : corners) points.push_back(c::Output<3>::vec(corner));
    std::vector<std::uint32_t> indices;
    for (const auto& face : faces) indices.insert(indices.end(), face.begin(), face.end());
    REQUIRE(detent_mesh_create(&context, 8, points.data(), 4, indices.data(), 4, &mesh) ==
            DETENT_OK);
    triangles.push_back(*OwnedMesh<S>::from_faces(corners, faces));
    meshes.emplace_back(8, triangles[0].view());

    std::vector<std::int32_t> numbers;
    for (int i = 0; i < 9; ++i) {
      numbers.push_back(i * i * 3000);
      heights.push_back(raw(numbers.back()));
    }
    const detent_vec2 corner{-one, -one};
    REQUIRE(detent_height_field_create(&context, 9, &corner, one, 3, 3, numbers.data(), &field) ==
            DETENT_OK);
    fields.emplace_back(9, *height_field<S>({S(-1), S(-1)}, S(1), 3, 3, heights));
  }
};

/// A scene of C and one of C++ with the same assets.
template <int N>
struct SceneTwins {
  using C = Calls<N>;
  using T = c::Types<N>;
  using Out = c::Output<N>;
  using V = Vec<S, N>;

  /// How many kinds of shapes a scene has.
  static constexpr std::uint64_t kinds = N == 2 ? 7 : 9;

  detent_context context{};
  detent_handle scene = 0, hull = 0;
  std::vector<V> corners{at<N>(0, 0), at<N>(2 * one, 0), at<N>(0, 2 * one)};
  std::vector<HullAsset<S, N>> hulls;
  SurfaceTwins<N> surfaces;
  typename c::SceneOf<N>::type twin;

  SceneTwins() {
    REQUIRE(detent_open(&context, nullptr) == DETENT_OK);
    REQUIRE(C::scene_create(&context, &scene) == DETENT_OK);
    if constexpr (N == 3) corners.push_back(at<N>(0, 0, 2 * one));
    std::vector<typename T::Vec> points;
    for (const auto& corner : corners) points.push_back(Out::vec(corner));
    REQUIRE(C::hull_create(&context, 7, points.data(), N + 1, &hull) == DETENT_OK);
    hulls.push_back(*hull_asset(7, ConvexHull<S, N>{corners}));
    surfaces.create(context, corners);
  }
  SceneTwins(const SceneTwins&) = delete;
  SceneTwins& operator=(const SceneTwins&) = delete;
  ~SceneTwins() { detent_close(&context); }

  /// Calls f with shape `kind` at a position, as C's structure and as the library's type.
  template <class F>
  void with_shape(std::uint64_t kind, const V& place, const F& f) const {
    typename T::Shape shape{};
    const auto call = [&](const auto& own) {
      Out::shape(shape, own);
      f(shape, own);
    };
    const auto place_asset = [&](std::uint32_t of_kind, detent_handle asset) {
      shape.kind = of_kind;
      shape.asset = asset;
      const Transform<S, N> moved{place, {}, S(1)};
      shape.as.placed = Out::transform(moved);
      return moved;
    };
    const auto moved = [&](const V& by) { return nearest_to<S>(place + by); };
    switch (kind) {
      case 0:
        return call(Sphere<S, N>{place, S(1)});
      case 1:
        return call(Aabb<S, N>{place, moved(at<N>(one, one, one))});
      case 2:
        return call(Obb<S, N>{place, at<N>(one, one / 2, one), Rotation<S, N>()});
      case 3:
        return call(Plane<S, N>{Direction<S, N>::along(1), S(-20)});
      case 4:
        return call(Triangle<S, N>{place, moved(corners[1]), moved(corners[2])});
      case 5:
        return call(Capsule<S, N>{place, moved(corners[1]), raw(one / 2)});
      case 6: {
        const auto transform = place_asset(DETENT_HULL, hull);
        return f(shape, PlacedHull<S, N>{&hulls[0], transform});
      }
      default:
        break;
    }
    if constexpr (N == 3) {
      if (kind == 7) {
        const auto transform = place_asset(DETENT_MESH, surfaces.mesh);
        return f(shape, PlacedMesh<S>{&surfaces.meshes[0], transform});
      }
      shape.kind = DETENT_HEIGHT_FIELD;
      shape.asset = surfaces.field;
      shape.as.point = Out::vec(place);
      return f(shape, PlacedField<S>{&surfaces.fields[0], place});
    }
  }

  [[nodiscard]] std::vector<std::byte> saved() const {
    std::uint32_t size = 0;
    REQUIRE(C::scene_snapshot(&context, scene, nullptr, 0, &size) == DETENT_NO);
    std::vector<std::byte> bytes(size);
    REQUIRE(C::scene_snapshot(&context, scene, bytes.data(), size, &size) == DETENT_OK);
    return bytes;
  }
  [[nodiscard]] detent_status restore(const std::vector<std::byte>& bytes) {
    return C::scene_restore(&context, scene, bytes.data(),
                            static_cast<std::uint32_t>(bytes.size()));
  }
  [[nodiscard]] Restored restore_twin(std::span<const std::byte> bytes) {
    const std::span<const HullAsset<S, N>> own_hulls(hulls);
    if constexpr (N == 3) {
      return detent::restore(twin, bytes, own_hulls, std::span<const MeshAsset<S>>(surfaces.meshes),
                             std::span<const FieldAsset<S>>(surfaces.fields));
    } else {
      return detent::restore(twin, bytes, own_hulls);
    }
  }
  void check_state() const {
    std::uint64_t sum = 0;
    REQUIRE(C::scene_digest(&context, scene, &sum) == DETENT_OK);
    REQUIRE(sum == digest(twin));
    std::uint32_t size = 0;
    REQUIRE(C::scene_size(&context, scene, &size) == DETENT_OK);
    REQUIRE(size == twin.size());
  }
};

template <class F, class G, class Same>
void check_lists(const std::vector<F>& theirs, std::uint32_t count, const std::vector<G>& own,
                 const Same& same) {
  REQUIRE(count == own.size());
  for (std::size_t i = 0; i < own.size(); ++i) REQUIRE(same(theirs[i], own[i]));
}

inline bool same_found(const detent_found& a, const Found<S>& b) {
  return a.distance == b.distance.raw() && id_of(a.id) == b.id;
}
inline bool same_pair(const detent_pair& a, const Overlap& b) {
  return id_of(a.first) == b.first && id_of(a.second) == b.second;
}
template <int N>
bool same_hit(const typename c::Types<N>::ObjectHit& a, const ObjectHit<S, N>& b) {
  return a.distance == b.distance.raw() && id_of(a.id) == b.id &&
         c::Input<N>::vec(a.point) == b.point && c::Input<N>().direction(a.normal) == b.normal &&
         (a.has_triangle == 1) == b.triangle.has_value() && a.triangle == b.triangle.value_or(0);
}

template <int N, class Question>
void check_question(const SceneTwins<N>& twins, const typename c::Types<N>::Shape& asked,
                    const Question& question) {
  using C = Calls<N>;
  const auto* const context = &twins.context;
  const auto scene = twins.scene;
  const InLayers layers{5};
  const auto all = twins.twin.all(question, layers);
  std::uint32_t count = 0, same_count = 0;
  std::vector<detent_found> found(64), two(3, detent_found{-77, {7, 7}});
  REQUIRE(C::scene_all(context, scene, &asked, 5, found.data(), 64, &count) == DETENT_OK);
  check_lists(found, count, all, same_found);
  REQUIRE(C::scene_all(context, scene, &asked, 5, two.data(), 2, &same_count) == DETENT_OK);
  REQUIRE(same_count == count);
  for (std::size_t i = 0; i < 2 && i < all.size(); ++i) REQUIRE(same_found(two[i], all[i]));
  REQUIRE(two[2].distance == -77);
  REQUIRE(C::scene_any(context, scene, &asked, 5) ==
          c::yes_or_no(twins.twin.any(question, layers)));
  const auto nearest = twins.twin.nearest(question, layers);
  detent_found first{};
  REQUIRE(C::scene_nearest(context, scene, &asked, 5, &first) == c::yes_or_no(nearest.has_value()));
  if (nearest) REQUIRE(same_found(first, *nearest));
}

/// Compares what a ray hits, and returns whether it hits anything.
template <int N>
bool check_ray(const SceneTwins<N>& twins, const Ray<S, N>& ray) {
  using C = Calls<N>;
  using Out = c::Output<N>;
  using Hit = typename c::Types<N>::ObjectHit;
  const auto* const context = &twins.context;
  const auto scene = twins.scene;
  const typename c::Types<N>::Ray asked{Out::vec(ray.origin), Out::direction(ray.direction),
                                        ray.max_distance.raw()};
  const auto all = twins.twin.all_hits(ray, InLayers{7});
  std::vector<Hit> list(64);
  std::uint32_t count = 0;
  REQUIRE(C::scene_raycast_all(context, scene, &asked, 7, list.data(), 64, &count) == DETENT_OK);
  check_lists(list, count, all, same_hit<N>);
  Hit hit{};
  const auto expected = c::yes_or_no(!all.empty());
  REQUIRE(C::scene_raycast(context, scene, &asked, 7, &hit) == expected);
  REQUIRE(C::scene_raycast_any(context, scene, &asked, 7) == expected);
  if (!all.empty()) REQUIRE(same_hit<N>(hit, all[0]));
  REQUIRE(C::scene_raycast_many(context, scene, &asked, 1, 7, &hit) == DETENT_OK);
  REQUIRE((all.empty() ? hit.distance == -1 : same_hit<N>(hit, all[0])));
  return !all.empty();
}

/// Adds, changes and removes objects in both, and asks both the same questions after each step.
/// Points are up to `reach` from the origin along each axis.
template <int N>
void check_history(std::uint64_t seed, int reach) {
  using C = Calls<N>;
  using Out = c::Output<N>;
  test::Random random(seed);
  SceneTwins<N> twins;
  auto* const context = &twins.context;
  const auto scene = twins.scene;
  std::vector<detent_id> ids;
  std::vector<std::byte> saved;
  int hits = 0, rays = 0;
  const auto place = [&] {
    return make_vec<N>([&](int) { return raw(random.between(-reach * one, reach * one)); });
  };
  for (int i = 0; i < 400; ++i) {
    CAPTURE(i, random.seed());
    const auto where = place();
    const auto choice = random.below(12);
    if (choice < 4 || ids.empty()) {
      const detent_traits traits{random.next(),
                                 static_cast<std::uint32_t>(1 + random.below(7)),
                                 random.one_in(5) && i < 100 ? 1u : 0u,
                                 {}};
      const Traits own_traits{traits.layers, traits.user, static_cast<Motion>(traits.motion), {}};
      const detent_id chosen{static_cast<std::uint32_t>(1000 + random.below(20)), 3};
      const bool is_chosen = random.one_in(4);
      twins.with_shape(random.below(twins.kinds), where, [&](const auto& theirs, const auto& own) {
        auto id = chosen;
        bool is_added = true;
        if (is_chosen) {
          is_added = twins.twin.add_as(id_of(id), own, own_traits);
          REQUIRE(C::scene_add_as(context, scene, id, &theirs, &traits) == c::yes_or_no(is_added));
        } else {
          REQUIRE(C::scene_add(context, scene, &theirs, &traits, &id) == DETENT_OK);
          REQUIRE(twins.twin.add(own, own_traits) == id_of(id));
        }
        if (is_added && traits.motion == DETENT_MOVING) ids.push_back(id);
      });
    } else {
      const auto which = random.below(ids.size());
      const detent_id id = ids[which];
      if (choice < 6) {
        twins.with_shape(random.below(twins.kinds), where,
                         [&](const auto& theirs, const auto& own) {
                           REQUIRE(C::scene_replace(context, scene, id, &theirs) ==
                                   c::yes_or_no(twins.twin.replace(id_of(id), own)));
                         });
      } else if (choice < 8) {
        const auto by = Out::vec(where);
        REQUIRE(C::scene_move(context, scene, id, &by) ==
                c::yes_or_no(twins.twin.move(id_of(id), where)));
      } else if (choice < 10) {
        const detent_traits traits{
            random.next(), static_cast<std::uint32_t>(random.below(8)), 0, {}};
        const bool is_there = twins.twin.set_layers(id_of(id), traits.layers) &&
                              twins.twin.set_user(id_of(id), traits.user);
        REQUIRE(C::scene_set_traits(context, scene, id, &traits) == c::yes_or_no(is_there));
        detent_traits read{};
        REQUIRE(C::scene_object(context, scene, id, nullptr, &read) == c::yes_or_no(is_there));
        if (is_there) REQUIRE((read.user == traits.user && read.layers == traits.layers));
      } else {
        REQUIRE(C::scene_remove(context, scene, id) == c::yes_or_no(twins.twin.remove(id_of(id))));
        if (random.coin()) ids.erase(ids.begin() + static_cast<std::ptrdiff_t>(which));
      }
    }
    if (i % 50 == 20) REQUIRE(C::scene_optimize(context, scene) == DETENT_OK);
    twins.check_state();
    if (i == 200) saved = twins.saved();

    const auto origin = place();
    if (const auto toward = normalize(place())) {
      hits += check_ray(twins, Ray<S, N>{origin, *toward, S(20)}) ? 1 : 0;
      ++rays;
    }
    typename c::Types<N>::Shape question{};
    question.kind = DETENT_POINT;
    question.as.point = Out::vec(where);
    check_question(twins, question, where);
    const auto ask = [&](const auto& shape) {
      question = {};
      Out::shape(question, shape);
      check_question(twins, question, shape);
    };
    ask(Sphere<S, N>{where, S(2)});
    ask(Obb<S, N>{where, at<N>(2 * one, one, one), Rotation<S, N>()});
    question = {};
    question.kind = DETENT_SEGMENT;
    question.as.segment = {Out::vec(where), Out::vec(origin)};
    check_question(twins, question, Segment<S, N>{where, origin});
    std::vector<detent_pair> pairs(4096);
    std::uint32_t count = 0;
    REQUIRE(C::scene_overlaps(context, scene, pairs.data(), 4096, &count) == DETENT_OK);
    check_lists(pairs, count, twins.twin.overlaps(), same_pair);
  }
  CAPTURE(hits, rays);
  CHECK(hits * 10 > 3 * rays);
  CHECK(hits * 10 < 9 * rays);
  CHECK((twins.saved() == snapshot(twins.twin)));

  REQUIRE(twins.restore(saved) == DETENT_OK);
  REQUIRE(twins.restore_twin(saved) == Restored::yes);
  twins.check_state();
  CHECK((twins.saved() == saved));
  saved[70] ^= std::byte{1};
  CHECK(twins.restore(saved) == DETENT_CORRUPTED);
  saved.resize(3);
  CHECK(twins.restore(saved) == DETENT_TRUNCATED);
}

/// The ids of two frames and of the last object in the inner one.
struct Framed {
  detent_id frame{}, child{}, last{};
};

/// Adds the frame `first` and, in it, `second` with a shape of every kind; then moves the outer one.
template <int N>
Framed check_frames(SceneTwins<N>& twins, const Transform<S, N>& first,
                    const Transform<S, N>& second) {
  using C = Calls<N>;
  auto* const context = &twins.context;
  const auto scene = twins.scene;
  auto& twin = twins.twin;
  const auto outer = c::Output<N>::transform(first), inner = c::Output<N>::transform(second);
  Framed ids;
  REQUIRE(C::scene_add_frame(context, scene, &outer, {}, &ids.frame) == DETENT_OK);
  REQUIRE(C::scene_add_frame(context, scene, &inner, ids.frame, &ids.child) == DETENT_OK);
  const auto own = *twin.add_frame(first), own_child = *twin.add_frame(second, own);
  CHECK((own.index == ids.frame.index && own.generation == ids.frame.generation));
  CHECK((own_child.index == ids.child.index && own_child.generation == ids.child.generation));
  for (std::uint64_t kind = 0; kind < twins.kinds; ++kind) {
    CAPTURE(kind);
    const detent_traits traits{kind, 1, DETENT_MOVING, ids.child};
    twins.with_shape(kind, at<N>(one, 0), [&](const auto& shape, const auto& same) {
      REQUIRE(C::scene_add(context, scene, &shape, &traits, &ids.last) == DETENT_OK);
      REQUIRE(twin.add(same, {1, kind, Motion::moving, own_child}) == id_of(ids.last));
    });
  }
  twins.check_state();
  REQUIRE(C::scene_move_frame(context, scene, ids.frame, &inner) == DETENT_OK);
  REQUIRE(twin.move_frame(own, second));
  twins.check_state();
  typename c::Types<N>::Transform local{}, world{};
  REQUIRE(C::scene_frame(context, scene, ids.child, &local, &world) == DETENT_OK);
  const auto found = *twin.frame(own_child);
  CHECK(c::Input<N>().transform(local) == found.local);
  CHECK(c::Input<N>().transform(world) == found.world);
  detent_traits with{};
  REQUIRE(C::scene_object(context, scene, ids.last, nullptr, &with) == DETENT_OK);
  CHECK((with.frame.index == ids.child.index && with.frame.generation == ids.child.generation));
  CHECK(C::scene_remove_frame(context, scene, ids.child) == DETENT_NO);
  CHECK(!twin.remove_frame(own_child));
  return ids;
}

}  // namespace detent::test_c
