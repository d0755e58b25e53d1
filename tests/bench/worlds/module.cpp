// SPDX-License-Identifier: MIT
//
// The timed scenes and their worlds for node, in DETENT_BENCH_SCALAR. engines.mjs builds the same
// scenes in other engines from the plans of this module. Arrays are returned as doubles, by
// pointers that are valid until the next `load`.
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "bench/worlds/stage.hpp"

#define EXPORT(name) extern "C" __attribute__((export_name(#name)))

namespace {

using namespace detent::bench;
using S = DETENT_BENCH_SCALAR;

Plan plan;
std::unique_ptr<Stage<S>> stage;
std::vector<double> items, links, poses, points;

const std::vector<Plan>& plans() {
  static const std::vector<Plan> all = all_plans();
  return all;
}

template <class Vector>
void put(std::vector<double>& to, const Vector& v) {
  for (int i = 0; i < 3; ++i) to.push_back(static_cast<double>(v[i]));
}

}  // namespace

EXPORT(plan_count) std::size_t plan_count() { return plans().size(); }
EXPORT(plan_name) const char* plan_name(std::size_t i) { return plans()[i].name.c_str(); }

/// Builds the world of plan i in its initial state.
EXPORT(load) void load(std::size_t i) {
  plan = plans()[i];
  items.clear();
  links.clear();
  points.clear();
  for (const auto& item : plan.items) {
    items.push_back(static_cast<double>(item.kind));
    items.push_back(item.moves);
    put(items, item.at);
    put(items, item.half);
    put(items, item.axis);
    items.push_back(item.angle);
  }
  for (const auto& link : plan.links) {
    links.push_back(link.a);
    links.push_back(link.b);
    put(links, link.at);
    links.push_back(link.is_hinge);
    put(links, link.axis);
  }
  for (const auto& point : plan.hull) put(points, point);
  stage = std::make_unique<Stage<S>>(plan);
}
/// 12 numbers per item: kind, whether it moves, center, half extents, axis and angle.
EXPORT(item_data) const double* item_data() { return items.data(); }
EXPORT(item_count) std::size_t item_count() { return plan.items.size(); }
/// 9 numbers per link: two items, the point, whether it is a hinge, the axis.
EXPORT(link_data) const double* link_data() { return links.data(); }
EXPORT(link_count) std::size_t link_count() { return plan.links.size(); }
/// 3 numbers per corner of a hull.
EXPORT(point_data) const double* point_data() { return points.data(); }
EXPORT(point_count) std::size_t point_count() { return points.size() / 3; }
EXPORT(sleeps) int sleeps() { return plan.sleeps; }

EXPORT(step) void step() { stage->world.step(); }
EXPORT(digest) std::uint64_t digest() { return detent::digest(stage->world); }
/// 12 numbers per item: its position and the three columns of its rotation.
EXPORT(pose_data) const double* pose_data() {
  poses.clear();
  for (const auto& id : stage->ids) {
    const auto rotation = stage->world.rotation(id);
    put(poses, stage->world.position(id));
    for (int i = 0; i < 3; ++i) put(poses, rotation.axis(i));
  }
  return poses.data();
}
