// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <optional>

#include "verify/judge/exact.hpp"

namespace detent::verify::judge {

/// The determinant of the first `Size` rows and columns, expanded along the first row.
template <int Size, std::size_t M>
Integer expansion(const std::array<std::array<Integer, M>, M>& m) {
  if constexpr (Size == 1) {
    return m[0][0];
  } else {
    Integer sum = 0;
    for (std::size_t j = 0; j < Size; ++j) {
      auto rest = m;
      for (std::size_t i = 0; i + 1 < Size; ++i) {
        for (std::size_t k = 0; k + 1 < Size; ++k) rest[i][k] = m[i + 1][k < j ? k : k + 1];
      }
      const Integer term = m[0][j] * expansion<Size - 1>(rest);
      sum += j % 2 == 0 ? term : Integer(-term);
    }
    return sum;
  }
}

template <int Row, Scalar S, int N, class Answer>
std::optional<Wrong> judge(const MatrixCase<S, N>& c, const Answer& got) {
  std::array<std::array<Integer, N>, N> m;
  for (std::size_t i = 0; i < N; ++i) {
    for (std::size_t j = 0; j < N; ++j) {
      m[i][j] = oracle::raw(c.matrix(static_cast<int>(i), static_cast<int>(j)));
    }
  }
  const Integer whole = expansion<N>(m);
  if constexpr (Row == 0) {
    return compare(clamped<Answer>(oracle::nearest_even(whole, (N - 1) * S::frac)), got);
  } else {
    if (whole == 0) return compare(Answer(), got);
    Mat<S, N, N> expected;
    for (std::size_t j = 0; j < N; ++j) {
      for (std::size_t i = 0; i < N; ++i) {
        // Cramer's rule: column i of the matrix becomes the unit vector j.
        auto replaced = m;
        for (std::size_t k = 0; k < N; ++k) replaced[k][i] = k == j ? 1 : 0;
        expected(static_cast<int>(i), static_cast<int>(j)) =
            clamped<S>(nearest_quotient(scaled(expansion<N>(replaced), 2 * S::frac), whole));
      }
    }
    return compare(Answer(expected), got);
  }
}

/// A quaternion's components in raw units, the real one first.
template <Scalar S>
std::array<Integer, 4> parts_of(const Quat<S>& q) {
  return {oracle::raw(q.w()), oracle::raw(q.x()), oracle::raw(q.y()), oracle::raw(q.z())};
}
/// source: Hamilton's i^2 = j^2 = k^2 = i j k = -1
inline std::array<Integer, 4> product(const std::array<Integer, 4>& a,
                                      const std::array<Integer, 4>& b) {
  std::array<Integer, 4> result{};
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < 4; ++j) {
      const bool cyclic = i != 0 && j != 0 && (j + 3 - i) % 3 == 1;
      const bool negative = i != 0 && j != 0 && !cyclic;
      const Integer term = a[i] * b[j];
      result[i ^ j] += negative ? Integer(-term) : term;
    }
  }
  return result;
}
/// Normalizes the real components (w, x, y, z) and returns them as x, y, z, w.
template <Scalar S>
std::array<Real, 4> unit_steps(const std::array<Real, 4>& wxyz) {
  Real square = 0;
  for (const Real& part : wxyz) square += part * part;
  const Real factor = steps(direction_component<S>::frac) / sqrt(square);
  return {wxyz[1] * factor, wxyz[2] * factor, wxyz[3] * factor, wxyz[0] * factor};
}
template <Scalar S, class Answer>
std::optional<Wrong> judge_near(const std::array<Real, 4>& exact, const Answer& got) {
  bool right = true;
  Answer expected;
  for (int i = 0; i < 4; ++i) {
    const Real& in_steps = exact[static_cast<std::size_t>(i)];
    expected[i] = clamped<direction_component<S>>(nearest(in_steps));
    const Real distance = abs(in_steps - Real(static_cast<std::int64_t>(got[i].raw())));
    right = right && distance <= rotation_margin();
  }
  if (right) return std::nullopt;
  return Wrong{words(expected), words(got)};
}

template <int Row, Scalar S, int N, class Answer>
std::optional<Wrong> judge(const BlendCase<S, N>& c, const Answer& got) {
  const auto p = parts_of(c.p);
  auto q = parts_of(c.q);
  if constexpr (Row == 0) {
    const auto exact = product(p, q);
    return judge_near<S>(
        unit_steps<S>({real(exact[0]), real(exact[1]), real(exact[2]), real(exact[3])}), got);
  } else if constexpr (Row == 1) {
    Integer inner = oracle::dot(p, q);
    if (inner < 0) {
      for (Integer& part : q) part = -part;
      inner = -inner;
    }
    const auto stored = [](const std::array<Integer, 4>& parts) {
      return Answer{
          clamped<direction_component<S>>(parts[1]), clamped<direction_component<S>>(parts[2]),
          clamped<direction_component<S>>(parts[3]), clamped<direction_component<S>>(parts[0])};
    };
    const Real t = real(c.t);
    if (t <= 0) return compare(stored(p), got);
    if (t >= 1) return compare(stored(q), got);
    const Integer pp = oracle::dot(p, p), qq = oracle::dot(q, q);
    const Integer area = pp * qq - inner * inner;
    Real of_p = (1 - t), of_q = t;
    if (area != 0) {
      const Real angle = atan2(sqrt(real(area)), real(inner));
      of_p = sin((1 - t) * angle) / sqrt(real(pp));
      of_q = sin(t * angle) / sqrt(real(qq));
    }
    std::array<Real, 4> exact;
    for (std::size_t i = 0; i < 4; ++i) exact[i] = real(p[i]) * of_p + real(q[i]) * of_q;
    return judge_near<S>(unit_steps<S>(exact), got);
  } else {
    const std::array<Integer, 4> v{0, oracle::raw(c.vector[0]), oracle::raw(c.vector[1]),
                                   oracle::raw(c.vector[2])};
    const auto turned = product(product(p, v), {p[0], -p[1], -p[2], -p[3]});
    const Integer norm = oracle::dot(p, p);
    Answer expected;
    for (int i = 0; i < 3; ++i) {
      expected[i] = clamped<S>(nearest_quotient(turned[static_cast<std::size_t>(i) + 1], norm));
    }
    return compare(expected, got);
  }
}

template <int Row, Scalar S, int N, class Answer>
std::optional<Wrong> judge(const MotionCase<S, N>& c, const Answer& got) {
  constexpr int frac = direction_component<S>::frac;
  const Integer scale = oracle::raw(c.transform.scale);
  Answer expected;
  for (int i = 0; i < N; ++i) {
    Integer sum = 0;
    for (int k = 0; k < N; ++k) {
      const Integer point = oracle::raw(c.point[k]);
      if constexpr (Row == 0) {
        sum += oracle::raw(c.transform.rotation.axis(k)[i]) * point;
      } else {
        const Integer origin = oracle::raw(c.transform.translation[k]);
        sum += oracle::raw(c.transform.rotation.axis(i)[k]) * Integer(point - origin);
      }
    }
    if constexpr (Row == 0) {
      const Integer origin = scaled(oracle::raw(c.transform.translation[i]), frac + S::frac);
      expected[i] = clamped<S>(oracle::nearest_even(origin + sum * scale, frac + S::frac));
    } else if (scale == 0) {
      expected[i] = sum > 0 ? S::max() : sum < 0 ? S::lowest() : S();
    } else {
      expected[i] = clamped<S>(nearest_quotient(scaled(sum, S::frac), scaled(scale, frac)));
    }
  }
  return compare(expected, got);
}

template <int Row, Scalar S, int N, class Answer>
std::optional<Wrong> judge(const CameraCase<S, N>& c, const Answer& got) {
  if constexpr (Row == 0) {
    const auto eye = oracle::widen(raw_of(c.eye));
    const auto back = oracle::difference(eye, oracle::widen(raw_of(c.target)));
    const auto right = oracle::cross(oracle::widen(raw_of(c.up)), back);
    if (oracle::is_zero(right)) return compare(Answer(), got);
    const std::array<oracle::Vector<3>, 3> axes{right, oracle::cross(back, right), back};
    using Component = direction_component<S>;
    std::array<Direction<S, 3>, 3> directions;
    for (std::size_t k = 0; k < 3; ++k) {
      const Real factor = steps(Component::frac) / sqrt(real(oracle::dot(axes[k], axes[k])));
      directions[k] = Direction<S, 3>::assume_unit(make_vec<3>([&](int i) {
        return clamped<Component>(nearest(real(axes[k][static_cast<std::size_t>(i)]) * factor));
      }));
    }
    return compare(Answer({c.eye, Rotation<S, 3>::from_axes(directions), S(1)}), got);
  } else {
    std::array<Integer, N + 1> h;
    for (int i = 0; i <= N; ++i) {
      Integer sum = scaled(oracle::raw(c.matrix(i, N)), S::frac);
      for (int k = 0; k < N; ++k) sum += oracle::raw(c.matrix(i, k)) * oracle::raw(c.eye[k]);
      h[static_cast<std::size_t>(i)] = sum;
    }
    if (h[N] == 0) return compare(Answer(), got);
    return compare(Answer(make_vec<N>([&](int i) {
                     return clamped<S>(
                         nearest_quotient(scaled(h[static_cast<std::size_t>(i)], S::frac), h[N]));
                   })),
                   got);
  }
}

template <int Row, Scalar S, int N, class Answer>
std::optional<Wrong> judge(const LensCase<S, N>& c, const Answer& got) {
  const Integer aspect = oracle::raw(c.aspect), near_raw = oracle::raw(c.near_distance),
                far_raw = oracle::raw(c.far_distance);
  const bool sees = c.fov.raw() != 0 && c.fov.raw() < (std::uint32_t{1} << 31);
  if (!sees || aspect <= 0 || near_raw <= 0 || near_raw >= far_raw) return compare(Answer(), got);
  const Real half_angle = radians(c.fov) / 2;
  const Real upright = cos(half_angle) / sin(half_angle) * steps(S::frac);
  const std::array<Real, 2> focal{upright / real(c.aspect), upright};
  Mat<S, 4, 4> expected;
  for (int i = 0; i < 2; ++i) {
    const Real& exact = focal[static_cast<std::size_t>(i)];
    expected(i, i) = clamped<S>(nearest(exact));
    // Next to a tie both neighbours are correct.
    if (!got) continue;
    const Real distance = abs(exact - Real(static_cast<std::int64_t>((*got)(i, i).raw())));
    if (distance <= rotation_margin()) expected(i, i) = (*got)(i, i);
  }
  const Integer under = near_raw - far_raw;
  expected(2, 2) = clamped<S>(nearest_quotient(scaled(far_raw, S::frac), under));
  expected(2, 3) = clamped<S>(nearest_quotient(near_raw * far_raw, under));
  expected(3, 2) = clamped<S>(scaled(-1, S::frac));
  return compare(Answer(expected), got);
}

template <int Row, Scalar S, int N, class Answer>
std::optional<Wrong> judge(const VectorsCase<S, N>& c, const Answer& got) {
  const auto u = oracle::widen(raw_of(c.u)), v = oracle::widen(raw_of(c.v));
  const Integer uv = oracle::dot(u, v), uu = oracle::dot(u, u), vv = oracle::dot(v, v);
  if constexpr (Row == 0) {
    if (uu == 0 || vv == 0) return compare(std::uint32_t{0}, got);
    const Real turns = atan2(sqrt(real(uu * vv - uv * uv)), real(uv)) / two_pi();
    return compare(wrapped(nearest(turns * steps(32))), got);
  } else {
    Answer expected;
    for (int i = 0; i < N; ++i) {
      const Integer a = u[static_cast<std::size_t>(i)], b = v[static_cast<std::size_t>(i)];
      if constexpr (Row == 1) {
        expected[i] = vv == 0 ? S() : clamped<S>(nearest_quotient(uv * b, vv));
      } else if constexpr (Row == 2) {
        const auto n = oracle::widen(raw_of(c.normal.vec()));
        const Integer nn = oracle::dot(n, n), off = 2 * oracle::dot(u, n);
        expected[i] =
            clamped<S>(nearest_quotient(nn * a - off * n[static_cast<std::size_t>(i)], nn));
      } else {
        const Integer way = (b - a) * oracle::raw(c.t);
        expected[i] = clamped<S>(oracle::nearest_even(scaled(a, S::frac) + way, S::frac));
      }
    }
    return compare(expected, got);
  }
}

}  // namespace detent::verify::judge
