// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "detent/math/vec.hpp"
#include "support/random.hpp"

/// The scenes of bodies that are timed in every engine, and some that test how still bodies stand.
namespace detent::bench {

/// The corners of a jittered icosahedron.
inline std::vector<Vec<double, 3>> hull_points() {
  test::Random random(12);
  const double g = (1 + std::sqrt(5.0)) / 2, length = std::sqrt(1 + g * g);
  std::vector<Vec<double, 3>> points;
  const auto add = [&](double x, double y, double z) {
    const double r = 0.6 * (1 + static_cast<double>(random.between(-120, 120)) / 1000) / length;
    points.push_back({x * r, y * r, z * r});
  };
  for (const double a : {-1.0, 1.0}) {
    for (const double b : {-g, g}) {
      add(0, a, b);
      add(a, b, 0);
      add(b, 0, a);
    }
  }
  return points;
}

enum class Kind { box, ball, capsule, hull };

struct Item {
  Kind kind;
  bool moves;
  Vec<double, 3> at;
  Vec<double, 3>
      half;  // a ball's radius, and a capsule's radius and half height along y, come first
  Vec<double, 3> axis{0, 1, 0};
  double angle = 0;
  double density = 1;
};

/// A common point of two bodies; a hinge rotates only about `axis`.
struct Link {
  std::uint32_t a, b;
  Vec<double, 3> at;
  bool is_hinge = false;
  Vec<double, 3> axis{0, 0, 1};
};

struct Plan {
  std::string name;
  std::vector<Item> items{};
  std::vector<Link> links{};
  int steps = 300;
  bool sleeps = false;
  std::vector<Vec<double, 3>> hull = hull_points();  // of all items that are hulls

  std::uint32_t add(const Item& item) {
    items.push_back(item);
    return static_cast<std::uint32_t>(items.size() - 1);
  }
  void ground(double half) { add({Kind::box, false, {0, -1, 0}, {half, 1, half}}); }
  void box(double x, double y) { add({Kind::box, true, {x, y, 0}, {0.5, 0.5, 0.5}}); }
};

inline Plan stack(int count) {
  Plan plan{"stack of " + std::to_string(count)};
  plan.ground(60);
  for (int i = 0; i < count; ++i) plan.box(0, 0.5 + i);
  return plan;
}

/// Boxes on each other, of these densities.
inline Plan masses(const std::vector<double>& densities) {
  Plan plan{"masses"};
  plan.ground(60);
  for (const double density : densities) {
    const double y = static_cast<double>(plan.items.size()) - 0.5;
    plan.add({Kind::box, true, {0, y, 0}, {0.5, 0.5, 0.5}, {0, 1, 0}, 0, density});
  }
  return plan;
}

/// Three storeys of cards of 1 by 0.02 that lean against each other at 25 degrees. The last item is the
/// uppermost card.
inline Plan house_of_cards() {
  Plan plan{"house of cards"};
  plan.ground(60);
  const double tall = 0.5, deep = 0.35, thin = 0.01, lean = 25 * std::numbers::pi / 180;
  const double height = 2 * (tall * std::cos(lean) + thin * std::sin(lean));
  const double half_width = tall * std::sin(lean) + thin * std::cos(lean);
  double floor = 0;
  for (int tents = 3; tents > 0; --tents) {
    for (int i = 0; i < tents; ++i) {
      const double x = (i - (tents - 1) / 2.0) * 4 * half_width;
      for (const double side : {-1.0, 1.0}) {
        plan.add({Kind::box,
                  true,
                  {x + side * half_width, floor + height / 2, 0},
                  {thin, tall, deep},
                  {0, 0, 1},
                  side * lean,
                  1 / (8 * thin * tall * deep)});
      }
    }
    floor += height;
    const double half = 2 * half_width - 0.002;
    for (int i = 0; i + 1 < tents; ++i) {
      const double x = (i - (tents - 2) / 2.0) * 4 * half_width;
      plan.add({Kind::box,
                true,
                {x, floor + thin, 0},
                {half, thin, deep},
                {0, 1, 0},
                0,
                1 / (8 * half * thin * deep)});
    }
    floor += 2 * thin;
  }
  return plan;
}

/// An arch of 9 stones between the radii 4 and 5. Item 5 is the keystone.
inline Plan arch() {
  Plan plan{"arch of 9"};
  plan.ground(60);
  plan.hull.clear();
  const double half = std::numbers::pi / 18;  // of the angle of a stone
  for (const double z : {-0.5, 0.5}) {
    for (const double r : {4.0, 5.0}) {
      for (const double t : {-half, half})
        plan.hull.push_back({r * std::cos(t), r * std::sin(t), z});
    }
  }
  for (int i = 0; i < 9; ++i) {
    plan.add({Kind::hull, true, {}, {}, {0, 0, 1}, (2 * i + 1) * half});
  }
  return plan;
}

/// A rope of 30 capsules of mass 1 that hangs down, with a ball of this mass at its end, the last item.
inline Plan rope(double mass) {
  Plan plan{"rope of 30"};
  const double length = 0.4, half = 0.15, radius = 0.04, high = 20;
  const double volume = std::numbers::pi * radius * radius * (2 * half + 4 * radius / 3);
  plan.add({Kind::ball, false, {0, high, 0}, {0.1, 0, 0}});
  for (std::uint32_t i = 0; i < 30; ++i) {
    const double y = high - i * length;
    plan.add(
        {Kind::capsule, true, {0, y - length / 2, 0}, {radius, half, 0}, {0, 1, 0}, 0, 1 / volume});
    plan.links.push_back({i, i + 1, {0, y, 0}});
  }
  plan.add({Kind::ball,
            true,
            {0, high - 30 * length - 0.5, 0},
            {0.5, 0, 0},
            {0, 1, 0},
            0,
            mass * 6 / std::numbers::pi});
  plan.links.push_back({30, 31, {0, high - 30 * length, 0}});
  return plan;
}

inline Plan pyramid(int base) {
  Plan plan{"pyramid of base " + std::to_string(base)};
  plan.ground(60);
  for (int row = 0; row < base; ++row) {
    for (int i = 0; i < base - row; ++i) plan.box((i - (base - row - 1) / 2.0) * 1.05, 0.5 + row);
  }
  return plan;
}

inline Plan heap(std::string name, Kind kind, int wide, int high, int deep) {
  Plan plan{std::move(name)};
  test::Random random(7);
  const auto number = [&](double low, double most) {
    return low + (most - low) * static_cast<double>(random.between(0, 1 << 20)) / (1 << 20);
  };
  const double h = std::max(wide, deep) * 0.75 + 0.5;
  plan.ground(h + 3);
  for (const double s : {1.0, -1.0}) {
    plan.add({Kind::box, false, {s * (h + 1), 20, 0}, {1, 20, h + 2}});
    plan.add({Kind::box, false, {0, 20, s * (h + 1)}, {h + 2, 20, 1}});
  }
  for (int j = 0; j < high; ++j) {
    for (int i = 0; i < wide; ++i) {
      for (int k = 0; k < deep; ++k) {
        const double x = (i - (wide - 1) / 2.0) * 1.5 + number(-0.1, 0.1);
        const double z = (k - (deep - 1) / 2.0) * 1.5 + number(-0.1, 0.1);
        const auto half =
            kind == Kind::capsule ? Vec<double, 3>{0.3, 0.3, 0} : Vec<double, 3>{0.5, 0.5, 0.5};
        const Vec<double, 3> axis{number(-1, 1), number(-1, 1), number(-1, 1)};
        plan.add({kind, true, {x, 1 + j * 1.5, z}, half, axis, number(-0.2, 0.2)});
      }
    }
  }
  return plan;
}

inline Plan joint_grid(std::uint32_t side) {
  Plan plan{"joint grid " + std::to_string(side) + "x" + std::to_string(side)};
  for (std::uint32_t i = 0; i < side; ++i) {
    for (std::uint32_t j = 0; j < side; ++j) {
      const bool fixed = (i == 0 || i + 1 == side) && j == 0;
      const double x = i - (side - 1) / 2.0, z = j;
      const auto b = plan.add({Kind::ball, !fixed, {x, 40, z}, {0.4, 0, 0}});
      if (i > 0) plan.links.push_back({b - side, b, {x - 0.5, 40, z}});
      if (j > 0) plan.links.push_back({b - 1, b, {x, 40, z - 0.5}});
    }
  }
  return plan;
}

/// Upright dolls of eleven capsules that fall onto each other.
inline Plan ragdolls(int count) {
  Plan plan{std::to_string(count) + " ragdolls"};
  plan.ground(60);
  for (int n = 0; n < count; ++n) {
    const double x = (n % 5 - 2) * 3.0 / (1 + n / 10), y = 2 + n * 0.15, z = (n / 5 - 1.5) * 1.5;
    const auto limb = [&](double dx, double dy, double half, double r, bool level) {
      return plan.add({Kind::capsule,
                       true,
                       {x + dx, y + dy, z},
                       {r, half, 0},
                       {0, 0, 1},
                       level ? 1.5707963 : 0});
    };
    const auto link = [&](std::uint32_t a, std::uint32_t b, double dx, double dy, bool hinge,
                          Vec<double, 3> axis) {
      plan.links.push_back({a, b, {x + dx, y + dy, z}, hinge, axis});
    };
    const auto pelvis = limb(0, 1.0, 0.10, 0.12, true), chest = limb(0, 1.35, 0.12, 0.14, false);
    const auto head = limb(0, 1.78, 0.05, 0.10, false);
    link(pelvis, chest, 0, 1.14, false, {});
    link(chest, head, 0, 1.64, false, {});
    for (const double s : {-1.0, 1.0}) {
      const auto upper = limb(s * 0.34, 1.48, 0.11, 0.05, true);
      const auto lower = limb(s * 0.64, 1.48, 0.11, 0.045, true);
      const auto thigh = limb(s * 0.12, 0.70, 0.15, 0.07, false);
      const auto shin = limb(s * 0.12, 0.26, 0.15, 0.055, false);
      link(chest, upper, s * 0.18, 1.48, false, {});
      link(pelvis, thigh, s * 0.12, 0.91, false, {});
      link(upper, lower, s * 0.49, 1.48, true, {0, 1, 0});
      link(thigh, shin, s * 0.12, 0.48, true, {1, 0, 0});
    }
  }
  return plan;
}

inline std::vector<Plan> all_plans() {
  std::vector<Plan> plans{stack(20), pyramid(20), pyramid(50)};
  plans.push_back(heap("heap of 200 boxes", Kind::box, 5, 8, 5));
  plans.push_back(heap("1000 boxes", Kind::box, 10, 10, 10));
  plans.push_back(heap("1000 balls", Kind::ball, 10, 10, 10));
  plans.push_back(heap("1000 capsules", Kind::capsule, 10, 10, 10));
  plans.push_back(heap("1000 hulls", Kind::hull, 10, 10, 10));
  plans.push_back(joint_grid(30));
  plans.push_back(ragdolls(20));
  plans.push_back(heap("10000 boxes", Kind::box, 25, 16, 25));
  plans.push_back(heap("10000 balls", Kind::ball, 25, 16, 25));
  plans.push_back(heap("10000 hulls", Kind::hull, 25, 16, 25));
  Plan asleep{"asleep"};
  asleep.ground(60);
  for (int i = 0; i < 1000; ++i) {
    asleep.add({Kind::box, true, {(i % 32 - 16) * 2.0, 0.5, (i / 32 - 16) * 2.0}, {0.5, 0.5, 0.5}});
  }
  asleep.sleeps = true;
  plans.push_back(asleep);
  return plans;
}

}  // namespace detent::bench
