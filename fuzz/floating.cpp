// SPDX-License-Identifier: MIT
//
// Rays, closest points and distances in `float` and in `double`, which run the same source, agree
// with those in q16_16 within the rounding of both.
//
// The fixed-point result brackets the real one: a distance is rounded down, a point to nearest (a
// hit's point from a distance rounded down), a normal within 2^-30. The error bound of the
// floating-point result is derived for each input, from its operations and the rounding of each:
// traced.hpp states and proves the rules. If a comparison is within the error of its sides, the
// floating path may differ from the real one; then the results have to agree only if the path ends,
// up to rounding, where the fixed one does. Hit or miss has to agree if every comparison is
// decided.
//
// domain: coordinates, radii, half extents, offsets and lengths of rays of at most 24 bits, which a
//         float holds exactly; directions and axes as stored, in 30 bits, so that a float starts
//         with their rounding
//
// No bound is loose: the corpus contains inputs that use more than half of each, and its replay
// checks that.

#include <array>
#include <cstdio>
#include <deque>
#include <limits>
#include <string>
#include <string_view>

#include "decode.hpp"
#include "detent/query/query.hpp"
#include "support/shapes.hpp"
#include "traced.hpp"

namespace detent::fuzz {
namespace {

enum Question { along_ray, hit_point, hit_normal, nearest_point, nearest_distance };
constexpr std::array<const char*, 5> question_names{"raycast", "hit point", "hit normal",
                                                    "closest_point", "distance"};
/// Compounds come after these.
template <int N>
using Shapes =
    typename support::SceneShapes<q16_16, N>::template and_also<ConvexHull<q16_16, N>,
                                                                Segment<q16_16, N>, Ray<q16_16, N>>;

const auto shape_names = [] {
  std::array<std::string_view, Shapes<3>::size + 1> names;
  std::size_t next = 0;
  Shapes<3>::for_each([&](const auto& shape) { names[next++] = support::name_of(shape); });
  names[next] = "compound";
  return names;
}();

/// The largest share of its bound that a result used: by dimension, shape, query and scalar.
using Shares = std::array<
    std::array<std::array<std::array<double, 2>, question_names.size()>, Shapes<3>::size + 1>, 2>;
Shares shares{};

/// A q16_16 truncated to 24 bits, or a coordinate or component of a direction in another scalar.
template <class T, class X>
T number(const X& x) {
  if constexpr (std::is_same_v<T, q16_16>) {
    const std::int32_t raw = x.raw(), step = 1 << std::max(0, bit_length(raw) - 24);
    return q16_16::from_raw(raw / step * step);
  } else if constexpr (std::is_floating_point_v<T>) {
    return static_cast<T>(static_cast<double>(x));
  } else {
    return T::input(static_cast<double>(x));
  }
}

/// Converts shapes to another number type. It owns the data that hulls and compounds refer to.
template <class T, int N>
class Converter {
 public:
  Vec<T, N> operator()(const Vec<q16_16, N>& v) const {
    return make_vec<N>([&](int i) { return number<T>(v[i]); });
  }
  Direction<T, N> operator()(const Direction<q16_16, N>& d) const {
    if constexpr (std::is_same_v<T, q16_16>) {
      return d;
    } else {
      return Direction<T, N>::assume_unit(make_vec<N>([&](int i) { return number<T>(d[i]); }));
    }
  }
  T operator()(const q16_16& x) const { return number<T>(x); }
  Rotation<T, N> operator()(const Rotation<q16_16, N>& rotation) const {
    return support::mapped_axes<T>(rotation, *this);
  }
  template <support::Mappable Shape>
  auto operator()(const Shape& shape) const {
    return support::mapped(shape, *this);
  }
  ConvexHull<T, N> operator()(const ConvexHull<q16_16, N>& x) {
    return {listed(points_, x.points)};
  }
  Compound<Sphere<T, N>, Aabb<T, N>> operator()(
      const Compound<Sphere<q16_16, N>, Aabb<q16_16, N>>& x) {
    return Compound<Sphere<T, N>, Aabb<T, N>>(listed(balls_, std::get<0>(x.parts)),
                                              listed(boxes_, std::get<1>(x.parts)));
  }

 private:
  template <class List, class From>
  auto listed(List& lists, const From& from) {
    auto& list = lists.emplace_back();
    for (const auto& item : from) list.push_back((*this)(item));
    return std::span<const typename List::value_type::value_type>(list);
  }
  std::deque<std::vector<Vec<T, N>>> points_;
  std::deque<std::vector<Sphere<T, N>>> balls_;
  std::deque<std::vector<Aabb<T, N>>> boxes_;
};

/// The results for one shape in one scalar, and whether all comparisons were decided.
template <Scalar S, int N>
struct Answers {
  std::optional<S> along_ray;
  std::optional<RayHit<S, N>> hit;
  Vec<S, N> nearest_point;
  S nearest_distance{};
  std::array<bool, 5> decided{};
};

template <Scalar S, int N, class Shape>
Answers<S, N> answers(const Ray<S, N>& ray, const Vec<S, N>& point, const Shape& shape) {
  Answers<S, N> result;
  const auto ask = [&](Question question, const auto& answer) {
    if constexpr (requires { S::all_decided; }) S::all_decided = true;
    answer();
    if constexpr (requires { S::all_decided; }) {
      result.decided[question] = S::all_decided;
    }
  };
  if constexpr (!std::is_same_v<Shape, Ray<S, N>>) {
    ask(along_ray, [&] { result.along_ray = raycast(ray, shape); });
    ask(hit_point, [&] { result.hit = raycast_hit(ray, shape); });
    result.decided[hit_normal] = result.decided[hit_point];
  }
  ask(nearest_point, [&] { result.nearest_point = closest_point(shape, point); });
  ask(nearest_distance, [&] { result.nearest_distance = distance(shape, point); });
  return result;
}

constexpr long double unit = 0x1p-16L;

/// One number in three scalars: the real one is in [fixed - below, fixed + above].
template <class F, class Fixed, class Describe>
void check(double& share, const Fixed& fixed, long double below, long double above,
           const Traced<F>& traced, F plain, bool decided, const Describe& describe) {
  if (fixed == Fixed::max() || fixed == Fixed::lowest()) return;  // possibly clamped
  require(plain == traced.value || std::isnan(plain),
          [&] { return describe() + ": traced wrong"; });
  if (!std::isfinite(traced.error)) return;
  const long double low = static_cast<double>(fixed) - below;
  const long double high = static_cast<double>(fixed) + above;
  const long double slack = traced.error / 512;  // of `exact`, which is rounded too
  const bool same_path = traced.exact >= low - slack && traced.exact <= high + slack;
  if (!decided && !same_path) return;
  const bool follows = !same_path || std::abs(traced.value - traced.exact) <= traced.error + slack;
  require(follows, [&] { return describe() + ": beyond the bound"; });
  require(traced.value >= low - traced.error && traced.value <= high + traced.error, [&] {
    char numbers[160];
    std::snprintf(numbers, sizeof numbers, ": %.20g is not in [%.20Lg, %.20Lg] +- %.3Lg",
                  static_cast<double>(plain), low, high, traced.error);
    return describe() + numbers;
  });
  if (!same_path || traced.error == 0) return;
  const auto used = static_cast<double>(std::abs(traced.value - traced.exact) / traced.error);
  share = std::max(share, used);
}

std::string name_of(int n, std::size_t shape, std::size_t question, bool in_double) {
  return std::to_string(n) + "D " + std::string(shape_names[shape]) + ": " +
         question_names[question] + (in_double ? " in double" : " in float");
}

template <class F, class Shape, int N>
void compare(std::size_t kind, const Ray<q16_16, N>& ray, const Vec<q16_16, N>& point,
             const Shape& shape, const Answers<q16_16, N>& fixed, bool is_settled) {
  constexpr std::size_t scalar = std::is_same_v<F, double> ? 1 : 0;
  auto& row = shares[N - 2][kind];
  Converter<Traced<F>, N> trace;
  Converter<F, N> round;
  const auto traced = answers(trace(ray), trace(point), trace(shape));
  const auto plain = answers(round(ray), round(point), round(shape));
  const auto describe = [&](Question question) {
    return [=] { return name_of(N, kind, question, scalar == 1); };
  };
  const auto compare_number = [&](Question question, const auto& x, long double below,
                                  long double above, const Traced<F>& y, F z) {
    check(row[question][scalar], x, below, above, y, z, traced.decided[question],
          describe(question));
  };

  if (traced.decided[along_ray]) {
    require(fixed.along_ray.has_value() == traced.along_ray.has_value(), describe(along_ray));
  }
  require(traced.along_ray.has_value() == plain.along_ray.has_value(), describe(along_ray));
  if (fixed.along_ray && traced.along_ray) {
    compare_number(along_ray, *fixed.along_ray, 0, unit, *traced.along_ray, *plain.along_ray);
  }
  if (fixed.hit && traced.hit && is_settled) {
    for (int i = 0; i < N; ++i) {
      compare_number(hit_point, fixed.hit->point[i], 1.5L * unit, 1.5L * unit, traced.hit->point[i],
                     plain.hit->point[i]);
      compare_number(hit_normal, fixed.hit->normal[i], 0x1p-30L, 0x1p-30L, traced.hit->normal[i],
                     plain.hit->normal[i]);
    }
  }
  if (is_settled) {
    for (int i = 0; i < N; ++i) {
      compare_number(nearest_point, fixed.nearest_point[i], unit / 2, unit / 2,
                     traced.nearest_point[i], plain.nearest_point[i]);
    }
  }
  compare_number(nearest_distance, fixed.nearest_distance, 0, unit, traced.nearest_distance,
                 plain.nearest_distance);
}

template <class Shape, int N>
void examine(std::size_t kind, const Ray<q16_16, N>& ray, const Vec<q16_16, N>& point,
             const Shape& shape, bool is_settled = true) {
  const auto fixed = answers(ray, point, shape);
  compare<float>(kind, ray, point, shape, fixed, is_settled);
  compare<double>(kind, ray, point, shape, fixed, is_settled);
}

template <class Shape, int N>
void examine_one(std::size_t kind, Decoder<q16_16, N>& decoder) {
  Converter<q16_16, N> cut;
  const auto shape = cut(decoder.template shape<Shape>());
  const auto ray = cut(decoder.template shape<Ray<q16_16, N>>());
  examine(kind, ray, cut(decoder.point()), shape);
}

/// A ball and a box. Fixed scalars choose the nearer one by rounded distances.
template <int N>
void examine_compound(std::size_t kind, Decoder<q16_16, N>& decoder) {
  Converter<q16_16, N> cut;
  const std::array balls{cut(decoder.template shape<Sphere<q16_16, N>>())};
  const std::array boxes{cut(decoder.template shape<Aabb<q16_16, N>>())};
  const auto ray = cut(decoder.template shape<Ray<q16_16, N>>());
  const auto point = cut(decoder.point());
  const auto is_far = [](const q16_16& a, const q16_16& b) {
    return std::abs(std::int64_t{a.raw()} - b.raw()) > 2;
  };
  const auto to_ball = raycast(ray, balls[0]), to_box = raycast(ray, boxes[0]);
  const bool is_settled = is_far(distance(balls[0], point), distance(boxes[0], point)) &&
                          (!to_ball || !to_box || is_far(*to_ball, *to_box));
  examine(kind, ray, point, Compound{balls, boxes}, is_settled);
}

template <int N>
void examine_any(Source& source, std::size_t kind) {
  Decoder<q16_16, N> decoder(source);
  if (kind == Shapes<N>::size) return examine_compound<N>(kind, decoder);
  Shapes<N>::at(kind, [&]<class Shape>(const Shape&) { examine_one<Shape>(kind, decoder); });
}

/// Whether a result is rounded at all: the closest point on an axis-aligned box is not, nor are
/// stored normals in double (nor, for a ray that starts inside, its direction).
bool is_rounded(std::size_t shape, std::size_t question, bool in_double) {
  const std::string_view name = shape_names[shape];
  if (name == "ray" && question <= hit_normal) return false;
  if (name == "aabb" && question == nearest_point) return false;
  const bool has_stored_normal =
      name == "aabb" || name == "obb" || name == "plane" || name == "segment";
  return !(in_double && question == hit_normal && has_stored_normal);
}

/// Checks that more than half of every bound was used. Where long double has no more bits than
/// double, only the bounds in float are checked.
void require_tight_bounds() {
  std::string slack;
  for (int n = 2; n <= 3; ++n) {
    for (std::size_t shape = 0; shape < shape_names.size(); ++shape) {
      for (std::size_t question = 0; question < question_names.size(); ++question) {
        for (const bool in_double : {false, true}) {
          constexpr bool is_measured = std::numeric_limits<long double>::digits > 60;
          if (!is_rounded(shape, question, in_double) || (in_double && !is_measured)) continue;
          const double share = shares[static_cast<std::size_t>(n - 2)][shape][question][in_double];
          if (share > 0.5) continue;
          slack += "\n  " + name_of(n, shape, question, in_double) + " " + std::to_string(share);
        }
      }
    }
  }
  require(slack.empty(), [&] { return "bounds of which no more than half is used:" + slack; });
}
[[maybe_unused]] const bool is_set = (after_corpus = require_tight_bounds, true);

}  // namespace

/// As many cases as there are bytes for.
void property(Bytes input) {
  Source source(input);
  do {
    const auto kind = source.below(2 * shape_names.size());
    kind < shape_names.size() ? examine_any<3>(source, kind)
                              : examine_any<2>(source, kind - shape_names.size());
  } while (!source.rest().empty());
}

}  // namespace detent::fuzz
