# SPDX-License-Identifier: MIT
"""docs/dynamics.md, "A body": compounds and their parts."""
import body as bodies
from fixed import Format, dot, ratio


class Part:
    """A shape as a body in the compound's frame."""

    def __init__(self, f, n, shape, place, q, frame, density, friction, restitution,
                 rolling, is_sensor):
        self.shape, self.friction, self.restitution = shape, friction, restitution
        self.rolling, self.is_sensor = rolling, is_sensor
        self.x = bodies.placed(f, shape, place, frame)
        P = self.P = bodies.axes(q)
        self.m, K = bodies.properties(f, n, shape, density)
        fine = Format(f.bits + 6, f.F + 6)
        if shape.kind == "hull":
            self.c = [fine.near(x, f.F + 12) for x in self.x]
        elif shape.is_box:
            self.c = [64 * x + y for x, y in zip(place, shape.center)]
        else:
            first, last = shape.raw_ends[0], shape.raw_ends[-1]
            self.c = [64 * x + 32 * (a + b) for x, a, b in zip(place, first, last)]
        if self.m == 0:
            self.c = [0] * n
        self.K = K
        if n == 3 and K:
            K = bodies.rows(K)
            self.K = [f.squared_gyration.near(
                sum(P[i][r] * P[j][c] * K[i][j] for i in range(3) for j in range(3)),
                2 * f.F + 90) for r, c in bodies.ENTRIES]


class Compound:
    """The shape of a compound body."""
    kind, radius_raw, is_box, is_empty = "compound", 0, False, False

    def __init__(self, f, n, parts):
        self.parts = parts
        solid = [p for p in parts if p.m]
        total = sum(p.m for p in solid)
        fine, F = Format(f.bits + 6, f.F + 6), f.F + 6
        self.mass, self.K, self.mass_center = f.mass.clamp(total), None, [0] * n
        if total:
            c = self.mass_center = [fine.quotient(sum(p.m * p.c[k] for p in solid), total, F)
                                    for k in range(n)]
            away = [(p, [x - y for x, y in zip(p.c, c)]) for p in solid]

            def entry(k, product):
                """The mean of K_p plus a product, in square steps of c."""
                top = sum(p.m * (p.K[k] + (product(d) << 18)) for p, d in away)
                return f.squared_gyration.quotient(top, total, 2 * f.F + 30)
            if n == 2:
                self.K = [entry(0, lambda d: dot(d, d))]
            else:
                self.K = [entry(i, lambda d, i=i: dot(d, d) - d[i] ** 2) for i in range(3)]
                self.K += [entry(3 + k, lambda d, i=i, j=j: -d[i] * d[j])
                           for k, (i, j) in enumerate(bodies.ENTRIES[3:])]
        for p in parts:
            p.p = [f.lever.near(x - 64 * y, f.F + 12) for x, y in zip(p.x, self.mass_center)]
        boxes = [bodies.bounds(f, n, [64 * x for x in p.p], p.P, p.shape, 0) for p in parts]
        self.reach = [max(-(-max(map(abs, box[k])) >> 12) for box in boxes) for k in range(n)]


class Placed:
    """A part in the world, or a body of one shape."""

    def __init__(self, shape, x, axes, number=0, part=None):
        self.shape, self.x, self.axes, self.number, self.part = shape, x, axes, number, part


def part_at(f, x, A, part):
    n = len(x)
    place = [f.place.near((x[k] << 24) + sum(A[i][k] * part.p[i] for i in range(n)), f.F + 36)
             for k in range(n)]
    turn = [[ratio.near(sum(A[i][k] * axis[i] for i in range(n)), 60) for k in range(n)]
            for axis in part.P]
    return place, turn


def placed_parts(f, shape, x, A):
    if shape.kind != "compound":
        return [Placed(shape, x, A)]
    return [Placed(p.shape, *part_at(f, x, A, p), i, p) for i, p in enumerate(shape.parts)]


def out_of_part(f, part, normal, points):
    """Converts a manifold from a part's frame to its body's."""
    n, P = len(normal), part.P
    return [ratio.near(sum(P[i][k] * normal[i] for i in range(n)), 60) for k in range(n)], [
        ([f.lever.near((part.p[k] << 30) + sum(P[i][k] * q[i] for i in range(n)), f.F + 36)
          for k in range(n)], s, name) for q, s, name in points]
