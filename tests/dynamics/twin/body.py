# SPDX-License-Identifier: MIT
"""docs/dynamics.md, "Settings" and "A body"."""
from math import isqrt

from fixed import ONE, PI, PI_BITS, cross, dot, ratio, round_div, round_shift, squared, unit
from hull import hull_of, planes, around, ends as ends_of


class Shape:
    """A shape in body space, with numbers on the scalar's grid and in the formats of manifolds."""

    def __init__(self, kind, n, radius=0, half=None, low=None, high=None, ends=None,
                 points=None):
        self.kind, self.radius_raw = kind, radius
        if kind == "hull":
            self.is_box = self.is_empty = False
            self.moments = hull_moments(points)
            content, first, _, _ = self.moments
            self.mass_center = [64 * p + round_div(64 * x, (n + 1) * content)
                                for p, x in zip(points[0], first)]
            self.hull = hull_of(points, self.mass_center)
            self.reach = [-(-max(abs(p[i]) for p in self.hull.points) // 64) for i in range(n)]
            return
        self.is_box = kind in ("box", "aligned")
        self.low, self.high = low, high
        if kind == "box":
            self.reach, center2, double = half, [0] * n, [2 * x for x in half]
        elif kind == "aligned":
            self.reach = [max(abs(x), abs(y)) for x, y in zip(low, high)]
            center2 = [x + y for x, y in zip(low, high)]
            double = [y - x for x, y in zip(low, high)]
        else:
            self.reach = [max(abs(p[i]) for p in ends) for i in range(n)]
        if self.is_box:
            self.sides = double
            self.half = [min(max(32 * x, -1 << 31), (1 << 31) - 1) for x in double]
            self.center = [32 * x for x in center2]
            self.is_empty = min(double) < 0
        else:
            self.raw_ends = ends
            self.ends = [[64 * x for x in p] for p in ends]
            self.radius = 64 * radius
            self.is_empty = radius < 0


class Body:
    pass


def no_rotation(n):
    return [ONE, 0] if n == 2 else [0, 0, 0, ONE]


def hull_moments(points):
    """Returns N! times the volume, (N + 1)! times the first moments about the first point, and the
    squared gyration as numerators and a denominator."""
    n, o = len(points[0]), points[0]

    def away(i):
        return [x - y for x, y in zip(points[i], o)]
    content, first, second = 0, [0] * n, [[0] * n for _ in range(n)]
    for members, normal in planes(points).items():
        if n == 2:
            j, k = ends_of(points, members)
            parts = [(away(j), away(k))]
        else:
            loop = around(points, members, normal)
            parts = [(away(loop[0]), away(j), away(k)) for j, k in zip(loop[1:], loop[2:])]
        for part in parts:
            m = abs(cross(*part)[0] if n == 2 else dot(part[0], cross(part[1], part[2])))
            s = [sum(x) for x in zip(*part)]
            content += m
            first = [x + m * y for x, y in zip(first, s)]
            for i in range(n):
                for j in range(n):
                    second[i][j] += m * (sum(u[i] * u[j] for u in part) + s[i] * s[j])
    # The second moments about the center over the content.
    c = content
    k, low = (12, 3) if n == 2 else (20, 4)
    den = 36 * c * c if n == 2 else 80 * c * c
    about = [[second[i][j] * c * (den // (c * c) // k) - first[i] * first[j] * (den // (c * c) // low ** 2)
              for j in range(n)] for i in range(n)]
    trace = sum(about[i][i] for i in range(n))
    if n == 2:
        return c, first, [trace], den
    K = [trace - about[i][i] for i in range(3)] + [-about[1][2], -about[0][2], -about[0][1]]
    return c, first, K, den


def mass_properties(f, n, shape, density):
    """Returns mass, squared gyration (exact numerators in square steps of the scalar) and its
    denominator."""
    if shape.kind == "hull":
        content, _, K, den = shape.moments
        return f.mass.quotient(density * content, 2 if n == 2 else 6, f.F * (n + 1)), K, den
    r = shape.radius_raw
    if shape.is_box:
        s = shape.sides
        volume, scale = 1, f.F * (n + 1)
        for x in s:
            volume *= x
        mass = f.mass.near(density * volume, scale)
        if n == 2:
            return mass, [s[0] ** 2 + s[1] ** 2], 12
        return mass, [s[(i + 1) % 3] ** 2 + s[(i + 2) % 3] ** 2 for i in range(3)] + [0, 0, 0], 12
    one = 1 << PI_BITS
    if len(shape.raw_ends) == 1 or shape.raw_ends[0] == shape.raw_ends[1]:
        if n == 2:
            mass = f.mass.near(density * PI * r * r, 3 * f.F + PI_BITS)
            return mass, [r * r], 2
        mass = f.mass.quotient(4 * density * PI * r ** 3, 3, 4 * f.F + PI_BITS)
        return mass, [2 * r * r] * 3 + [0, 0, 0], 5
    d = [y - x for x, y in zip(*shape.raw_ends)]
    fine = 24  # the length of the axis is a multiple of 2^-(F + 24)
    l = isqrt(squared(d) << 2 * fine)
    R = r << fine
    if n == 2:
        content = 2 * l * R * one + PI * R * R
        mass = f.mass.near(density * content, 3 * f.F + 2 * fine + PI_BITS)
        top = (2 * l ** 3 + 24 * R * R * l) * one + PI * (3 * R * l * l + 6 * R ** 3)
        return mass, [top], 12 * (2 * l * one + PI * R) << 2 * fine
    mass = f.mass.quotient(density * PI * R * R * (3 * l + 4 * R), 3, 4 * f.F + 3 * fine + PI_BITS)
    # The second moments are p I + q d d^T over 20 l (3 l + 4 r), the gyration their trace less them.
    p = R * R * (15 * l + 16 * R) * l
    q = 5 * (l + R) * (l + 3 * R)
    D = [x << fine for x in d]
    entry = [2 * p + q * (squared(D) - x * x) for x in D]
    entry += [-q * D[1] * D[2], -q * D[0] * D[2], -q * D[0] * D[1]]
    return mass, entry, 20 * l * (3 * l + 4 * R) << 2 * fine


ENTRIES = (0, 0), (1, 1), (2, 2), (1, 2), (2, 0), (0, 1)  # of a symmetric matrix


def rows(entries):
    """The symmetric matrix with these entries."""
    a, b, c, yz, zx, xy = entries
    return [[a, xy, zx], [xy, b, yz], [zx, yz, c]]


def properties(f, n, shape, density):
    """Mass and squared gyration, rounded; 0 and None for a massless shape."""
    if shape.kind == "surface":
        return 0, None
    if shape.kind == "compound":
        return shape.mass, shape.K
    solid = density > 0 and (shape.kind == "hull" or
                             (min(shape.sides) if shape.is_box else shape.radius_raw) > 0)
    mass, K, den = mass_properties(f, n, shape, density) if solid else (0, None, 1)
    if mass <= 0:
        return 0, None
    return mass, [f.squared_gyration.quotient(x, den, 2 * f.F) for x in K]


def set_mass(f, n, body, density):
    mass, K = properties(f, n, body.shape, density)
    body.can_move = body.motion == "dynamic" and mass > 0
    body.mass = mass
    body.inverse = [0] * (1 if n == 2 else 6)
    body.is_round = n == 2 or mass <= 0
    if mass <= 0:
        return
    one = 1 << 2 * f.F + 30
    if n == 2:
        inverse = [f.gyration.quotient(one, K[0])]
    else:
        m = rows(K)
        cofactor = [[m[(i + 1) % 3][(j + 1) % 3] * m[(i + 2) % 3][(j + 2) % 3]
                     - m[(i + 1) % 3][(j + 2) % 3] * m[(i + 2) % 3][(j + 1) % 3]
                     for j in range(3)] for i in range(3)]
        determinant = dot(m[0], cofactor[0])
        inverse = [f.gyration.quotient(cofactor[i][j] * one, determinant) if determinant > 0 else 0
                   for i, j in ENTRIES]
        body.is_round = K[0] == K[1] == K[2] and not any(K[3:])
        k = max(K[:3])
        body.share = rows([ratio.quotient(x, k) for x in K])
        body.inverse_share = rows([f.stretch.near(x * k, 96) for x in inverse])
    if body.can_move:
        body.inverse = inverse


def placed(f, shape, place, frame):
    """The position of a body whose shape is added there."""
    if shape.kind not in ("hull", "compound"):
        return [f.place.near(x, f.F) for x in place]
    return [f.place.near((x << 36) + sum(a[k] * y for a, y in zip(frame, shape.mass_center)),
                         f.F + 36) for k, x in enumerate(place)]


def bounds(f, n, x, A, shape, margin_raw):
    near, out = f.bound.near, []
    for k in range(n):
        e = near(shape.radius_raw + 2 * margin_raw, f.F)
        for axis, h in zip(A, shape.reach):
            e = near((e << 30 - 12) + abs(axis[k]) * h, f.F + 30)
        out.append((f.bound.clamp(x[k] - e), f.bound.clamp(x[k] + e)))
    return out


# Orientation

def axes(q):
    if len(q) == 2:
        c, s = q
        return [[c, s], [-s, c]]
    x, y, z, w = q
    n = squared(q)
    m = [[x * x + w * w - y * y - z * z, 2 * (x * y + z * w), 2 * (x * z - y * w)],
         [2 * (x * y - z * w), y * y + w * w - z * z - x * x, 2 * (y * z + x * w)],
         [2 * (x * z + y * w), 2 * (y * z - x * w), z * z + w * w - x * x - y * y]]
    return [[ratio.quotient(e, n) for e in row] for row in m]


def turned(q, w, part=1):
    """unit(q + u), with w in Spin; halved for part 2."""
    if len(q) == 2:
        c, s = q
        return unit([(c << 28) - w[0] * s, (s << 28) + w[0] * c])
    x, y, z, r = q
    a, b, c = w
    u = [a * r + b * z - c * y, b * r + c * x - a * z, c * r + a * y - b * x, -(a * x + b * y + c * z)]
    return unit([(e << 28 + part) + g for e, g in zip(q, u)])


def carried(f, body, w, start, end):
    """The spin that conserves angular momentum while the axes change."""
    fine = f.fine_spin
    a = [fine.near(dot(start[i], w), 58) for i in range(3)]
    m = [fine.near(dot(body.share[i], a), 74) for i in range(3)]
    s = [fine.near(sum(start[i][k] * m[i] for i in range(3)), 74) for k in range(3)]
    b = [fine.near(dot(end[i], s), 74) for i in range(3)]
    c = [fine.near(dot(body.inverse_share[i], b), 74) for i in range(3)]
    return [f.spin.near(sum(end[i][k] * c[i] for i in range(3)), 74) for k in range(3)]


def kept(d, n, F):
    """The factor 1 - near(d / n) in Ratio, for a damping of the scalar."""
    return ONE if d <= 0 else max(ONE - ratio.quotient(d, n, F), 0)


def from_rotation(A, frac=30):
    """The quaternion of a rotation matrix, in steps of 2^-frac."""
    (a, b, c), (d, e, f), (g, h, i) = A
    one = ONE
    m = [[one + a - e - i, b + d, g + c, f - h], [b + d, one - a + e - i, f + h, g - c],
         [g + c, f + h, one - a - e + i, b - d], [f - h, g - c, b - d, one + a + e + i]]
    q = unit(m[max((3, 0, 1, 2), key=lambda k: m[k][k])], frac)
    first = next((x for x in (q[3], q[0], q[1], q[2]) if x), 1)
    return [-x for x in q] if first < 0 else q
