// SPDX-License-Identifier: MIT
#include "oracle/push.hpp"

#include <concepts>

#include "oracle/cores.hpp"
#include "oracle/nearest_parts.hpp"

// Each direction across two edges, where edges are all lines between corners of one shape, is tried
// as an axis for projecting the shapes.
namespace detent::oracle {
namespace {

/// The least integer whose square is at least over / under.
Integer ceil_root(const Moment& square) {
  const Integer root = sqrt(floor_quotient(square.over, square.under));
  return root * root * square.under < square.over ? Integer(root + 1) : root;
}

/// The depth of overlap of shapes whose cores are the root of `squared` apart.
template <int N>
std::optional<Push<N>> from_gap(const Vector<N>& normal, const Moment& squared,
                                const Integer& radii) {
  if (squared.over > radii * radii * squared.under) return {};
  return Push<N>{normal, radii - sqrt(floor_quotient(squared.over, squared.under))};
}

template <int N>
int sign_of(const Vector<N>& v) {
  for (const auto& component : v) {
    if (!component.is_zero()) return component.sign();
  }
  return 0;
}

/// The signed square of a component of the unit vector along the positive direction of the line of
/// `v`: it grows with the component.
template <int N>
Moment rank_of(const Vector<N>& v, std::size_t i) {
  return {v[i] * abs(v[i]) * sign_of<N>(v), dot(v, v)};
}
template <int N>
bool is_preferred(const Vector<N>& v, const Vector<N>& over) {
  for (std::size_t i = 0; i < v.size(); ++i) {
    const auto left = rank_of<N>(v, i), right = rank_of<N>(over, i);
    if (!(left == right)) return right < left;
  }
  return sign_of<N>(v) > sign_of<N>(over);
}

/// The affine span of points: its dimension, and a vector along or across it.
template <int N>
struct Span {
  std::size_t dimension = 0;
  Vector<N> along;
  Vector<3> across;

  void add(const Vector<N>& v) {
    if (is_zero(v)) return;
    if (dimension == 0) {
      along = v;
      dimension = 1;
    } else if constexpr (N == 2) {
      if (!is_zero(cross(along, v))) dimension = 2;
    } else if (dimension == 1) {
      across = cross(along, v);
      if (!is_zero(across)) dimension = 2;
    } else if (!dot(across, v).is_zero()) {
      dimension = 3;
    }
  }
};

template <int N>
class Axes {
 public:
  using Points = std::vector<Vector<N>>;

  Axes(const Points& a, const Points& b, const Integer& under) : a_(a), b_(b), under_(under) {}

  /// The least push for shapes that share a point.
  Push<N> least(const Integer& radii) {
    std::vector<Vector<N>> edges;
    Span<N> span;
    for (const auto* points : {&a_, &b_}) {
      for (const auto& p : *points) {
        for (const auto& q : *points) {
          const auto edge = difference(p, q);
          if (sign_of<N>(edge) <= 0) continue;
          edges.push_back(edge);
          span.add(edge);
        }
      }
    }
    for (std::size_t i = 0; i < edges.size(); ++i) {
      if constexpr (N == 2) {
        offer_both({edges[i][1], -edges[i][0]});
      } else {
        for (std::size_t j = 0; j < i; ++j) offer_both(cross(edges[i], edges[j]));
      }
    }
    if (!best_) {
      Vector<N> x{};
      x[0] = 1;
      if (span.dimension == 1) {
        // The x axis minus its component along the line.
        const auto& d = span.along;
        for (std::size_t i = 0; i < x.size(); ++i) x[i] = x[i] * dot(d, d) - d[0] * d[i];
        if (is_zero(x)) x[1] = 1;
      }
      return {x, radii};
    }
    return {*best_, radii + ceil_root(depth_)};
  }

 private:
  void offer_both(const Vector<N>& normal) {
    if (is_zero(normal)) return;
    offer(normal);
    offer(negated(normal));
  }

  void offer(const Vector<N>& normal) {
    Integer highest = dot(normal, a_.front()), lowest = dot(normal, b_.front());
    for (const auto& p : a_) highest = std::max(highest, dot(normal, p));
    for (const auto& q : b_) lowest = std::min(lowest, dot(normal, q));
    const Integer height = highest - lowest;
    const Moment depth{height * height, dot(normal, normal) * under_ * under_};
    if (best_ && (depth_ < depth || (depth_ == depth && !is_preferred<N>(normal, *best_)))) return;
    // Only along a face of the difference, which its extreme corners span.
    Span<N> face;
    const auto add_face = [&](const Points& points, const Integer& at) {
      std::optional<Vector<N>> first;
      for (const auto& p : points) {
        if (dot(normal, p) != at) continue;
        if (!first) first = p;
        face.add(difference(p, *first));
      }
    };
    add_face(a_, highest);
    add_face(b_, lowest);
    if (face.dimension + 1 < N) return;
    best_ = normal;
    depth_ = depth;
  }

  const Points& a_;
  const Points& b_;
  Integer under_;
  std::optional<Vector<N>> best_;
  Moment depth_;
};

/// The vector from hull to hull, any multiple of the shortest, and its square.
template <int N>
struct Gap {
  Vector<N> normal;
  Moment squared;
};
template <int N>
Gap<N> gap_between(const std::vector<Vector<N>>& a, const std::vector<Vector<N>>& b) {
  std::optional<Gap<N>> best;
  const auto offer = [&](const Vector<N>& normal, const Moment& squared) {
    if (!best || squared < best->squared) best = Gap<N>{normal, squared};
  };
  const auto from_place = [](const Place<N>& place, const Vector<N>& point, int sign) {
    Vector<N> normal;
    for (std::size_t i = 0; i < normal.size(); ++i) {
      normal[i] = (point[i] * place.under - place.over[i]) * sign;
    }
    return normal;
  };
  for (const auto& q : b) {
    const auto place = nearest_outside<N>(a, q);
    offer(from_place(place, q, 1), place.squared);
  }
  for (const auto& p : a) {
    const auto place = nearest_outside<N>(b, p);
    offer(from_place(place, p, -1), place.squared);
  }
  if constexpr (N == 3) {
    for (std::size_t i = 0; i < a.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        for (std::size_t k = 0; k < b.size(); ++k) {
          for (std::size_t l = 0; l < k; ++l) {
            const auto across = between_inner_points(Edge<3>{a[i], a[j]}, Edge<3>{b[k], b[l]});
            if (!across) continue;
            auto normal = cross(difference(a[i], a[j]), difference(b[k], b[l]));
            if (dot(normal, difference(b[k], a[i])) < 0) normal = negated(normal);
            offer(normal, *across);
          }
        }
      }
    }
  }
  return *best;
}

template <int N>
std::optional<Push<N>> push_of_hulls(const Hull<N>& a, const Hull<N>& b, const Integer& radii) {
  const Integer under = lcm(a.under, b.under);
  const auto p = points_over(a, under), q = points_over(b, under);
  if (hulls_meet(a, b)) return Axes<N>(p, q, under).least(radii);
  const auto gap = gap_between<N>(p, q);
  return from_gap<N>(gap.normal, {gap.squared.over, gap.squared.under * under * under}, radii);
}

template <int N>
std::optional<Push<N>> push_from_wall(const Wall<N>& wall, const Hull<N>& hull,
                                      const Integer& radii) {
  std::optional<Integer> low, high;
  for (const auto& point : hull.over) {
    const Integer height = dot(wall.normal, point) - wall.offset * wall.one * hull.under;
    if (!low || height < *low) low = height;
    if (!high || height > *high) high = height;
  }
  const auto squared = [&](const Integer& height) {
    return Moment{height * height, dot(wall.normal, wall.normal) * hull.under * hull.under};
  };
  const auto back = negated(wall.normal);
  if (*low > 0) return from_gap<N>(wall.normal, squared(*low), radii);
  if (*high < 0) return from_gap<N>(back, squared(*high), radii);
  const bool is_up = -*low <= *high;
  return Push<N>{is_up ? wall.normal : back, radii + ceil_root(squared(is_up ? *low : *high))};
}

template <int N>
std::optional<Push<N>> push_in_frame(const TurnedBox<N>& box, const Hull<N>& thin,
                                     const Integer& radii) {
  const auto placed = in_frame(box, thin);
  auto push = push_of_hulls(placed.box, placed.thin, radii);
  if (!push) return push;
  Vector<N> normal{};
  for (std::size_t i = 0; i < normal.size(); ++i) {
    for (std::size_t j = 0; j < normal.size(); ++j) normal[j] += push->normal[i] * box.axes[i][j];
  }
  push->normal = normal;
  return push;
}

template <int N, class A, class B>
std::optional<Push<N>> push_of_cores(const A& a, const B& b, const Integer& radii) {
  if constexpr (std::same_as<A, Wall<N>> && std::same_as<B, Wall<N>>) {
    return {};
  } else if constexpr (std::same_as<A, Wall<N>>) {
    return push_from_wall(a, hull_of(b), radii);
  } else if constexpr (std::same_as<A, TurnedBox<N>> && std::same_as<B, Edge<N>>) {
    return push_in_frame(a, hull_of(b), radii);
  } else if constexpr (std::same_as<B, Wall<N>> ||
                       (std::same_as<B, TurnedBox<N>> && std::same_as<A, Edge<N>>)) {
    auto push = push_of_cores<N>(b, a, radii);
    if (push) push->normal = negated(push->normal);
    return push;
  } else {
    return push_of_hulls(hull_of(a), hull_of(b), radii);
  }
}

template <int N>
std::optional<Push<N>> push_of(const Solid<N>& first, const Solid<N>& second) {
  const auto of = [](const auto& a, const auto& b) -> std::optional<Push<N>> {
    if (!has_points(a) || !has_points(b)) return {};
    return push_of_cores<N>(core(a), core(b), radius(a) + radius(b));
  };
  return std::visit(of, first, second);
}

}  // namespace

std::optional<Push<2>> least_push(const Solid<2>& a, const Solid<2>& b) { return push_of<2>(a, b); }
std::optional<Push<3>> least_push(const Solid<3>& a, const Solid<3>& b) { return push_of<3>(a, b); }

}  // namespace detent::oracle
