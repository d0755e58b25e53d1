// SPDX-License-Identifier: MIT
#pragma once

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <optional>
#include <regex>
#include <string>

#include "oracle/ray_box.hpp"
#include "oracle/ray_plane.hpp"
#include "oracle/ray_sphere.hpp"
#include "oracle/ray_triangle.hpp"
#include "verify/describe.hpp"

/// What the answers of the corpus should be, from the definitions of the queries in exact integers
/// and a hundred digits. Wherever a digest differs, this names the question that went wrong.
namespace detent::verify::judge {

using oracle::Integer;
using Real = boost::multiprecision::cpp_bin_float_100;

struct Wrong {
  std::string expected;
  std::string got;
};

// Results that the contract leaves a margin are off by so little more than half a unit that only
// what lies next to a tie has two right answers.

/// Beyond half a unit, for rotations and for normals of spheres (in thousandths).
inline const Real rotation_margin("0.5001");
inline constexpr int normal_margin = 501;

template <class T>
std::optional<Wrong> compare(const T& expected, const T& got) {
  if (expected == got) return std::nullopt;
  return Wrong{words(expected), words(got)};
}

/// An integer as a T, clamped.
template <class T>
T clamped(const Integer& raw) {
  const Integer low = static_cast<std::int64_t>(T::lowest().raw());
  const Integer high = static_cast<std::int64_t>(T::max().raw());
  const auto inside = static_cast<std::int64_t>(raw < low ? low : raw > high ? high : raw);
  return T::from_raw(static_cast<typename T::raw_type>(inside));
}

inline Integer scaled(const Integer& x, int bits) {
  return x * (Integer(1) << static_cast<unsigned>(bits));
}

/// over / under to the nearest integer, ties to even.
inline Integer nearest_quotient(const Integer& over, const Integer& under) {
  const auto t = oracle::Moment::fraction(over, under);
  const Integer down = oracle::floor_quotient(t.over, t.under);
  const Integer twice_rest = 2 * (t.over - down * t.under);
  const bool up = twice_rest > t.under || (twice_rest == t.under && down % 2 != 0);
  return up ? Integer(down + 1) : down;
}

/// The nearest integer to a number that is no tie.
inline Integer nearest(const Real& x) {
  return static_cast<Integer>(floor(x + Real(0.5)).convert_to<boost::multiprecision::cpp_int>());
}
inline Real steps(int frac) { return ldexp(Real(1), frac); }
template <int Bits, int Frac>
Real real(const Fixed<Bits, Frac>& x) {
  return Real(static_cast<std::int64_t>(x.raw())) / steps(Frac);
}
inline const Real& two_pi() {
  static const Real value = 8 * atan(Real(1));
  return value;
}
template <Scalar S>
Real radians(Angle<S> angle) {
  return Real(angle.raw()) / steps(32) * two_pi();
}
/// In (-2^31, 2^31], in units of 2^-32 turn.
template <Scalar S>
std::int64_t signed_units(Angle<S> angle) {
  const auto raw = static_cast<std::int64_t>(angle.raw());
  return raw > std::int64_t{1} << 31 ? raw - (std::int64_t{1} << 32) : raw;
}
inline std::uint32_t wrapped(const Integer& units) {
  const Integer turn = Integer(1) << 32;
  const Integer whole = oracle::floor_quotient(units, turn);
  return static_cast<std::uint32_t>(Integer(units - whole * turn));
}

template <Scalar S, int N>
oracle::Raw<N> raw_of(const Vec<S, N>& v) {
  oracle::Raw<N> raw{};
  for (int i = 0; i < N; ++i) {
    raw[static_cast<std::size_t>(i)] = static_cast<std::int64_t>(v[i].raw());
  }
  return raw;
}

// Rays.

template <Scalar S, int N, class Shape>
bool is_hidden(const RayCase<S, N, Shape>&) {
  return false;
}
template <Scalar S, int N>
bool is_hidden(const RayCase<S, N, Plane<S, N>>& c) {
  if (c.facing == Facing::both) return false;
  return oracle::dot(oracle::widen(oracle::raw(c.shape.normal)),
                     oracle::widen(oracle::raw(c.ray.direction))) >= 0;
}
template <Scalar S>
bool is_hidden(const RayCase<S, 3, Triangle<S, 3>>& c) {
  if (c.facing == Facing::both) return false;
  const auto a = oracle::raw(c.shape.a);
  const auto across = oracle::cross(oracle::difference(oracle::raw(c.shape.b), a),
                                    oracle::difference(oracle::raw(c.shape.c), a));
  return oracle::dot(across, oracle::widen(oracle::raw(c.ray.direction))) >= 0;
}

template <int N>
bool allows(const oracle::Normal<N>& normal, const oracle::Raw<N>& given) {
  if (const auto* sphere = dynamic_cast<const oracle::SphereNormal<N>*>(&normal)) {
    return sphere->within(given, normal_margin, 1000);
  }
  return normal.allows(given);
}

/// The right normal near a wrong one, for the report.
template <Scalar S, int N>
std::string normal_words(const oracle::Normal<N>& normal, const oracle::Raw<N>& given) {
  constexpr int reach = 4, side = 2 * reach + 1;
  int count = 1;
  for (int i = 0; i < N; ++i) count *= side;
  for (int code = 0; code < count; ++code) {
    auto candidate = given;
    int rest = code;
    for (auto& component : candidate) {
      component += rest % side - reach;
      rest /= side;
    }
    if (!allows(normal, candidate)) continue;
    Vec<direction_component<S>, N> v;
    for (int i = 0; i < N; ++i) {
      v[i] = clamped<direction_component<S>>(candidate[static_cast<std::size_t>(i)]);
    }
    return words(v);
  }
  return normal.text();
}

template <int Row, Scalar S, int N, class Shape, class Answer>
std::optional<Wrong> judge(const RayCase<S, N, Shape>& c, const Answer& got) {
  const auto expected = oracle::expected_raycast(c.ray, c.shape);
  if (!expected.hit || is_hidden(c)) return compare(Answer(), got);
  const auto& hit = *expected.hit;
  const S enter = clamped<S>(hit.enter);
  if constexpr (Row == 0) {
    return compare(Answer(enter), got);
  } else if constexpr (Row == 1) {
    Vec<S, N> point;
    for (int i = 0; i < N; ++i) point[i] = clamped<S>(hit.point[static_cast<std::size_t>(i)]);
    if (got && got->distance == enter && got->point == point &&
        allows(*hit.normal, oracle::raw(got->normal))) {
      return std::nullopt;
    }
    return Wrong{
        "distance " + words(enter) + ", point " + words(point) + ", normal " +
            (got ? normal_words<S>(*hit.normal, oracle::raw(got->normal)) : hit.normal->text()),
        words(got)};
  } else {
    return compare(Answer(Interval<S>{enter, clamped<S>(hit.exit)}), got);
  }
}

// Vectors.

template <int Row, Scalar S, int N, class Answer>
std::optional<Wrong> judge(const VectorCase<S, N>& c, const Answer& got) {
  const auto v = oracle::widen(raw_of(c.vector));
  const Integer squared = oracle::dot(v, v);
  if constexpr (Row == 0) {
    if (oracle::is_zero(v)) return compare(Answer(), got);
    using Component = direction_component<S>;
    const oracle::NormalizedNormal<N> exact(v, Component::frac);
    if (got && exact.allows(oracle::raw(*got))) return std::nullopt;
    Vec<Component, N> expected;
    for (int i = 0; i < N; ++i) {
      expected[i] = clamped<Component>(nearest(Real(v[static_cast<std::size_t>(i)]) /
                                               sqrt(Real(squared)) * steps(Component::frac)));
    }
    return Wrong{words(expected), words(got)};
  } else {
    return compare(clamped<S>(sqrt(squared)), got);
  }
}

/// Columns of exact numbers against the axes of a rotation.
template <Scalar S, int N>
std::optional<Wrong> judge_axes(const std::array<std::array<Real, N>, N>& exact,
                                const std::array<Direction<S, N>, N>& got) {
  using Component = direction_component<S>;
  bool right = true;
  std::array<Vec<Component, N>, N> expected;
  for (std::size_t k = 0; k < N; ++k) {
    for (int i = 0; i < N; ++i) {
      const Real in_steps = exact[k][static_cast<std::size_t>(i)] * steps(Component::frac);
      expected[k][i] = clamped<Component>(nearest(in_steps));
      const Real distance = abs(in_steps - Real(static_cast<std::int64_t>(got[k][i].raw())));
      right = right && distance <= rotation_margin;
    }
  }
  if (right) return std::nullopt;
  return Wrong{words(expected), words(got)};
}

template <int Row, Scalar S, int N, class Answer>
std::optional<Wrong> judge(const RotateCase<S, N>& c, const Answer& got) {
  constexpr int frac = direction_component<S>::frac;
  const auto v = oracle::widen(raw_of(c.vector));
  Answer expected;
  for (int i = 0; i < N; ++i) {
    oracle::Vector<N> factors;
    for (int k = 0; k < N; ++k) {
      const auto component = Row == 0 ? c.rotation.axis(k)[i] : c.rotation.axis(i)[k];
      factors[static_cast<std::size_t>(k)] = static_cast<std::int64_t>(component.raw());
    }
    expected[i] = clamped<S>(oracle::nearest_even(oracle::dot(factors, v), frac));
  }
  return compare(expected, got);
}

// Angles and rotations.

template <int Row, Scalar S, class Answer>
std::optional<Wrong> judge(const AngleCase<S, 1>& c, const Answer& got) {
  constexpr int frac = S::frac;
  const Integer number = static_cast<std::int64_t>(c.number.raw());
  const Integer whole_turn = Integer(1) << 32;
  if constexpr (Row == 0) {
    return compare(clamped<S>(nearest(sin(radians(c.angle)) * steps(frac))), got);
  } else if constexpr (Row == 1) {
    return compare(clamped<S>(nearest(cos(radians(c.angle)) * steps(frac))), got);
  } else if constexpr (Row == 2) {
    const Integer units = signed_units(c.angle);
    return compare(clamped<S>(nearest_quotient(scaled(units * 360, frac), whole_turn)), got);
  } else if constexpr (Row == 3) {
    const Real turns = Real(signed_units(c.angle)) / steps(32);
    return compare(clamped<S>(nearest(turns * two_pi() * steps(frac))), got);
  } else if constexpr (Row == 4) {
    const Integer degree = scaled(360, frac);
    return compare(wrapped(nearest_quotient(number * whole_turn, degree)), got);
  } else {
    return compare(wrapped(nearest(real(c.number) / two_pi() * steps(32))), got);
  }
}

template <int Row, Scalar S, class Answer>
std::optional<Wrong> judge(const AngleCase<S, 2>& c, const Answer& got) {
  const Real sine = sin(radians(c.angle)), cosine = cos(radians(c.angle));
  return judge_axes<S, 2>({{{cosine, sine}, {-sine, cosine}}}, got);
}

template <int Row, Scalar S, int N, class Answer>
std::optional<Wrong> judge(const PointCase<S, N>& c, const Answer& got) {
  const bool is_origin = c.y.raw() == 0 && c.x.raw() == 0;
  const Real turns = is_origin ? Real(0) : Real(atan2(real(c.y), real(c.x)) / two_pi());
  return compare(wrapped(nearest(turns * steps(32))), got);
}

template <int Row, Scalar S, int N, class Answer>
std::optional<Wrong> judge(const TurnCase<S, N>& c, const Answer& got) {
  const Real x = real(c.axis[0]), y = real(c.axis[1]), z = real(c.axis[2]);
  const Real length = sqrt(x * x + y * y + z * z);
  const std::array<Real, 3> axis{x / length, y / length, z / length};
  const Real sine = sin(radians(c.angle)), cosine = cos(radians(c.angle));
  std::array<std::array<Real, 3>, 3> exact;
  for (std::size_t k = 0; k < 3; ++k) {
    // Rodrigues: the unit vector k, turned.
    const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
    exact[k][k] = cosine + axis[k] * axis[k] * (1 - cosine);
    exact[k][i] = axis[j] * sine + axis[i] * axis[k] * (1 - cosine);
    exact[k][j] = -axis[i] * sine + axis[j] * axis[k] * (1 - cosine);
  }
  return judge_axes<S, 3>(exact, got);
}

template <int Row, Scalar S, int N, class Answer>
std::optional<Wrong> judge(const QuaternionCase<S, N>& c, const Answer& got) {
  using Component = direction_component<S>;
  const Integer x = oracle::raw(c.x), y = oracle::raw(c.y), z = oracle::raw(c.z),
                w = oracle::raw(c.w);
  const Integer xx = x * x, yy = y * y, zz = z * z, ww = w * w, norm = xx + yy + zz + ww;
  if (norm == 0) return compare(Answer(), got);
  const std::array<oracle::Vector<3>, 3> columns{
      {{ww + xx - yy - zz, 2 * (x * y + w * z), 2 * (x * z - w * y)},
       {2 * (x * y - w * z), ww - xx + yy - zz, 2 * (y * z + w * x)},
       {2 * (x * z + w * y), 2 * (y * z - w * x), ww - xx - yy + zz}}};
  bool right = got.has_value();
  std::array<Vec<Component, 3>, 3> expected;
  for (std::size_t k = 0; k < 3; ++k) {
    for (int i = 0; i < 3; ++i) {
      expected[k][i] = clamped<Component>(
          nearest_quotient(scaled(columns[k][static_cast<std::size_t>(i)], Component::frac), norm));
    }
    right = right && (*got)[k].vec() == expected[k];
  }
  if (right) return std::nullopt;
  return Wrong{words(expected), words(got)};
}

template <int Row, Scalar S, int N, class Answer>
std::optional<Wrong> judge(const EulerCase<S, N>& c, const Answer& got) {
  const Real sx = sin(radians(c.x)), cx = cos(radians(c.x));
  const Real sy = sin(radians(c.y)), cy = cos(radians(c.y));
  const Real sz = sin(radians(c.z)), cz = cos(radians(c.z));
  std::array<std::array<Real, 3>, 3> exact;
  for (std::size_t k = 0; k < 3; ++k) {
    std::array<Real, 3> v{k == 0 ? 1 : 0, k == 1 ? 1 : 0, k == 2 ? 1 : 0};
    v = {v[0], cx * v[1] - sx * v[2], sx * v[1] + cx * v[2]};
    v = {cy * v[0] + sy * v[2], v[1], cy * v[2] - sy * v[0]};
    exact[k] = {cz * v[0] - sz * v[1], sz * v[0] + cz * v[1], v[2]};
  }
  return judge_axes<S, 3>(exact, got);
}

// Numbers.

template <int Row, Scalar S, int N, class Answer>
std::optional<Wrong> judge(const RootCase<S, N>& c, const Answer& got) {
  const Integer product = oracle::raw(c.a) * oracle::raw(c.b);
  Integer x = product + static_cast<std::int64_t>(c.beside_square.raw());
  if constexpr (Row == 1) {
    x = product * product + static_cast<std::int64_t>(c.beside_fourth_power.raw());
  }
  return compare(clamped<Answer>(x < 0 ? Integer(0) : Integer(sqrt(x))), got);
}

template <int Row, Scalar S, int N, class Answer>
std::optional<Wrong> judge(const QuotientCase<S, N>& c, const Answer& got) {
  const Integer a = oracle::raw(c.a), b = oracle::raw(c.b), third = oracle::raw(c.c),
                d = oracle::raw(c.d);
  constexpr bool wide = Row % 2 == 1;
  const Integer over = wide ? Integer(a * b * third) : scaled(a, S::frac);
  const Integer under = wide ? Integer(d * (Row == 1 ? third : a)) : b;
  if (under == 0) {
    return compare(over > 0 ? S::max() : over < 0 ? S::lowest() : S(), got);
  }
  const auto t = oracle::Moment::fraction(over, under);
  return compare(
      clamped<S>(Row < 2 ? oracle::floor_quotient(t.over, t.under) : nearest_quotient(over, under)),
      got);
}

/// The number that a decimal text means, times 2^frac and rounded; nothing when it means none.
inline std::optional<Integer> meaning(const std::string& text, int frac) {
  static const std::regex decimal(R"(([+-]?)(\d*)(?:\.(\d*))?(?:[eE]([+-]?\d+))?)");
  std::smatch parts;
  if (!std::regex_match(text, parts, decimal)) return std::nullopt;
  const std::string whole = parts[2], fraction = parts[3];
  if (whole.empty() && fraction.empty()) return std::nullopt;
  Integer over = 0;
  for (const char digit : whole + fraction) over = over * 10 + (digit - '0');
  Integer under = 1;
  const int exponent =
      (parts[4].length() > 0 ? std::stoi(parts[4]) : 0) - static_cast<int>(fraction.size());
  for (int i = 0; i < exponent; ++i) over *= 10;
  for (int i = 0; i > exponent; --i) under *= 10;
  const Integer rounded = nearest_quotient(scaled(over, frac), under);
  return parts[1] == "-" ? Integer(-rounded) : rounded;
}

/// The decimal that is exactly raw / 2^frac.
inline std::string spelling(std::int64_t raw, int frac) {
  const auto magnitude = static_cast<std::uint64_t>(raw < 0 ? -raw : raw);
  const auto one = std::uint64_t{1} << frac;
  std::string text = (raw < 0 ? "-" : "") + std::to_string(magnitude / one);
  auto rest = magnitude % one;
  if (rest != 0) text += '.';
  for (; rest != 0; rest = rest * 10 % one) text += static_cast<char>('0' + rest * 10 / one);
  return text;
}

template <int Row, Scalar S, int N, class Answer>
std::optional<Wrong> judge(const TextCase<S, N>& c, const Answer& got) {
  if constexpr (Row == 0) {
    const auto value = meaning(std::string(c.text.view()), S::frac);
    const bool in_range = value && *value >= static_cast<std::int64_t>(S::lowest().raw()) &&
                          *value <= static_cast<std::int64_t>(S::max().raw());
    return compare(in_range ? Answer(clamped<S>(*value)) : Answer(), got);
  } else {
    const auto expected = spelling(static_cast<std::int64_t>(c.number.raw()), S::frac);
    if (expected == got.view()) return std::nullopt;
    return Wrong{'"' + expected + '"', words(got)};
  }
}

}  // namespace detent::verify::judge
