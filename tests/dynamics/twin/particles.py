#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""usage: particles.py PARTICLE_STATES [SCENE...]

Particles, ropes and cloth of docs/particles.md in whole numbers of any size. Steps the scenes of
particles.txt and compares every tick with what the program PARTICLE_STATES prints. Exits with 1 at
the first difference.
"""
import os
import sys
from fractions import Fraction
from math import gcd, isqrt

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from body import axes, from_rotation
from fixed import ONE, PI, PI_BITS, Formats, dot, parse, ratio, squared, unit
from follow import fails, follow

BITS, FRAC = 31, 16
F = Formats(BITS, FRAC)
S, PLACE, SPEED, REACH = F.scalar, F.place, F.speed, F.reach
FINE = PLACE.f - FRAC  # bits of a position below the grid of S
STEP = 1 << FINE       # u, in steps of a position


def minus(a, b):
    return [x - y for x, y in zip(a, b)]


def reached(away, reach, least):
    """The distance along a ray at which `away` first is at most `reach`, rounded down, or None, given a
    function that returns the least value of `away` and where it is."""
    if away(0) <= reach:
        return 0
    nearest, at = least()
    if nearest > reach:
        return None
    low, high = 0, int(at)
    while low < high:
        middle = low + high + 1 >> 1
        low, high = (middle, high) if away(middle) >= reach else (low, middle - 1)
    return low


# Shapes. A box has a center, half extents and axes. A ball is a box without extents that is touched
# from farther away. Lengths in a frame are in steps of S over 2^30.

class Shape:
    def __init__(self, center, half, radius, axes):
        self.center, self.radius, self.axes = center, radius, axes
        self.half = [h << 30 for h in half]
        # Corners extend no farther along a world axis than this.
        self.size = sum(half) + len(half) + radius if any(half) else radius

    def local(self, v):
        return [dot(a, v) for a in self.axes]

    def is_beside(self, g, h, r):
        e = self.size + r + 1
        return any(max(a, b) < c - e or min(a, b) > c + e for a, b, c in zip(g, h, self.center))

    def least(self, p, d, half, end):
        """The least squared distance of p + t d from the half extents for t in [0, end], and that
        t."""
        cuts = {Fraction(0), Fraction(end)}
        for x, y, e in zip(p, d, half):
            if y:
                for side in (-e, e):
                    t = Fraction(side - x, y)
                    if 0 < t < end:
                        cuts.add(t)
        cuts = sorted(cuts)
        best = None
        for low, high in zip(cuts, cuts[1:] or cuts):
            a = b = c = 0
            for x, y, e in zip(p, d, half):
                middle = x + (low + high) / 2 * y
                if abs(middle) > e:
                    w = x - e if middle > 0 else x + e
                    a, b, c = a + y * y, b + 2 * w * y, c + w * w
            t = low if a == 0 else min(max(Fraction(-b, 2 * a), low), high)
            value = (a * t + b) * t + c
            if best is None or value < best[0]:
                best = value, t
        return best

    def touches(self, g, h, r):
        if r < 0 or self.is_beside(g, h, r):
            return False
        reach = self.radius + r << 30
        p, d = self.local(minus(g, self.center)), self.local(minus(h, g))
        return self.least(p, d, self.half, 1)[0] <= reach * reach

    def cast(self, g, r, d, limit):
        """The distance at which a ball first touches, rounded down, or None."""
        p = [x << 30 for x in self.local(minus(g, self.center))]
        along = self.local(d)
        half = [e << 30 for e in self.half]
        reach = (self.radius + r << 60) ** 2

        def away(t):
            return sum(max(abs(x + t * y) - e, 0) ** 2 for x, y, e in zip(p, along, half))
        return reached(away, reach, lambda: self.least(p, along, half, limit))

    def contact(self, c, r):
        """The normal, in Ratio, and the depth of a contact with a ball, or None."""
        if self.is_beside(c, c, r):
            return None
        p = self.local(minus(c, self.center))
        w = [x - max(-e, min(e, x)) for x, e in zip(p, self.half)]
        away = squared(w)
        assert away, "a particle in a shape: not in these scenes"
        if away > (self.radius + r << 30) ** 2:
            return None
        normal = unit([sum(a[k] * x for a, x in zip(self.axes, w)) for k in range(len(w))])
        return normal, self.radius + r - (isqrt(away) >> 30)


def scaled(v, k):
    return [x * k for x in v]


class Face:
    """A triangle. Whether the nearest point is on a corner, an edge or inside changes at planes, so
    along a line the squared distance is a single quadratic between its crossings of them."""

    def __init__(self, corners):
        self.corners = corners
        self.low, self.high = (list(map(f, *corners)) for f in (min, max))

    def is_beside(self, g, h, r):
        return any(max(p, q) + r < a or min(p, q) - r > b
                   for p, q, a, b in zip(g, h, self.low, self.high))

    def signs(self, p):
        """Numbers that are linear in p, and whose signs say where the nearest point is."""
        a, b, c = self.corners
        ab, ac = minus(b, a), minus(c, a)
        d = [dot(e, minus(p, q)) for q in (a, b, c) for e in (ab, ac)]
        aa, am, mm = squared(ab), dot(ab, ac), squared(ac)
        # Weights of b and c of the foot on the plane, times a positive number.
        of_b, of_c = mm * d[0] - am * d[1], aa * d[1] - am * d[0]
        of_a = aa * mm - am * am - of_b - of_c
        return d, d[3] - d[2], of_a, of_b, of_c

    def nearest(self, p):
        """The point of the triangle that is nearest to p (Ericson, 5.1.5)."""
        a, b, c = self.corners
        (d1, d2, d3, d4, d5, d6), _, of_a, of_b, of_c = self.signs(p)
        if d1 <= 0 and d2 <= 0:
            return a
        if d3 >= 0 and d4 <= d3:
            return b
        if d6 >= 0 and d5 <= d6:
            return c

        def between(q, s, n, m):
            return [x + Fraction(n * (y - x), m) for x, y in zip(q, s)]
        if of_c <= 0 and d1 >= 0 and d3 <= 0:
            return between(a, b, d1, d1 - d3)
        if of_b <= 0 and d2 >= 0 and d6 <= 0:
            return between(a, c, d2, d2 - d6)
        if of_a <= 0 and d4 >= d3 and d5 >= d6:
            return between(b, c, d4 - d3, d4 - d3 + d5 - d6)
        whole = of_a + of_b + of_c
        return [(of_a * x + of_b * y + of_c * z) * Fraction(1, whole) for x, y, z in zip(a, b, c)]

    def away(self, p):
        return squared(minus(p, self.nearest(p)))

    def least(self, p, d, end):
        """The least squared distance of p + t d over t in [0, end], and t."""
        def flat(q):
            d, _, of_a, of_b, of_c = self.signs(q)
            d1, d2, d3, d4, d5, d6 = d
            return [*d, d4 - d3, d5 - d6, of_a, of_b, of_c]
        cuts = {Fraction(0), Fraction(end)}
        for at, then in zip(flat(p), flat([x + y for x, y in zip(p, d)])):
            if then != at:
                t = Fraction(at) / (at - then)
                if 0 < t < end:
                    cuts.add(t)
        cuts = sorted(cuts)

        def value(t):
            return Fraction(self.away([x + t * y for x, y in zip(p, d)]))
        best = None
        for low, high in zip(cuts, cuts[1:]):
            u, v, w = value(low), value((low + high) / 2), value(high)
            bend, rise = 2 * (u + w - 2 * v), 4 * v - 3 * u - w  # of s in [0, 1]
            s = min(max(-rise / (2 * bend), 0), 1) if bend else Fraction(rise < 0)
            found = (bend * s + rise) * s + u, low + s * (high - low)
            if best is None or found[0] < best[0]:
                best = found
        return best

    def touches(self, g, h, r):
        if r < 0 or self.is_beside(g, h, r):
            return False
        if g == h:
            return self.away(g) <= r * r
        return self.least(g, minus(h, g), 1)[0] <= r * r

    def cast(self, g, r, d, limit):
        """The distance at which a ball first touches, rounded down, or None."""
        fine = Face([scaled(c, ONE) for c in self.corners])
        p, reach = scaled(g, ONE), (r << 30) ** 2

        def away(t):
            return fine.away([x + t * y for x, y in zip(p, d)])
        return reached(away, reach, lambda: fine.least(p, d, limit))

    def contact(self, c, r):
        """The normal, in Ratio, and the depth with a ball, or None."""
        if self.is_beside(c, c, r):
            return None
        w = [Fraction(x) for x in minus(c, self.nearest(c))]
        away = squared(w)
        if away > r * r:
            return None
        assert away, "a particle in a triangle: not in these scenes"
        common = 1
        for x in w:
            common *= x.denominator // gcd(common, x.denominator)
        return unit([int(x * common) for x in w]), r - isqrt(int(away))


def length(v, f):
    return f.clamp(isqrt(squared(v)))


class System:
    def __init__(self, n):
        self.n = n
        self.ticks, self.substeps, self.passes, self.euler = 60, 4, 1, False
        self.gravity = [0, -10 << FRAC, 0][:n]
        self.damping, self.restitution, self.bounce = 0, 0, 1 << FRAC
        self.friction = parse("0.6", FRAC)
        self.x, self.v, self.mass, self.radius, self.pinned = [], [], [], [], []
        self.ties = {}
        self.shapes = []

    def start(self):
        self.rate = n = self.ticks * self.substeps
        self.g = [SPEED.quotient(x, n * n, FRAC) for x in self.gravity]
        self.fast = SPEED.quotient(self.bounce, n, FRAC)
        lost = ratio.quotient(self.damping, n, FRAC)
        self.kept = ONE if self.damping <= 0 else max(ONE - lost, 0)
        self.rub = ratio.near(self.friction, FRAC)
        self.back = ratio.near(self.restitution, FRAC)

    def held(self, i):
        return self.pinned[i] or self.mass[i] <= 0

    def add(self, position, mass, radius, velocity, pinned):
        self.x.append([p << FINE for p in position])
        self.mass.append(mass)
        self.radius.append(radius)
        self.pinned.append(pinned)
        self.v.append([0] * self.n if self.held(len(self.mass) - 1) else
                      [SPEED.quotient(v, self.rate, FRAC) for v in velocity])

    def tie(self, a, b, rest, frequency, tether=False):
        if frequency >= 0:
            self.ties.setdefault((min(a, b), max(a, b)), (rest, frequency, tether))

    def shares(self, a, b, frequency):
        stiff = ONE
        if frequency > 0:
            w = ratio.quotient(2 * frequency * PI, self.rate, FRAC + PI_BITS)
            stiff = ratio.quotient(w * w, (ONE * ONE + w * w))
        if self.held(a) or self.held(b):
            return 0 if self.held(a) else stiff, 0 if self.held(b) else stiff
        total = self.mass[a] + self.mass[b]
        return (ratio.quotient(self.mass[b] * stiff, total, 30),
                ratio.quotient(self.mass[a] * stiff, total, 30))

    def project(self, y, a, b, rest, frequency, tether):
        d = [REACH.near(q - p, PLACE.f) for p, q in zip(y[a], y[b])]
        error = REACH.clamp(length(d, REACH) - (rest << FINE))
        if tether and error <= 0:
            return
        e = unit(d)
        of_a, of_b = (REACH.near(s * error, 30 + REACH.f) for s in self.shares(a, b, frequency))
        for k in range(self.n):
            y[a][k] = PLACE.clamp(y[a][k] + REACH.near(of_a * e[k], 30 + REACH.f))
            y[b][k] = PLACE.clamp(y[b][k] - REACH.near(of_b * e[k], 30 + REACH.f))

    def rubbed(self, v, n, limit, form):
        a = form.near(dot(n, v), 30 + form.f)
        t = [form.clamp(x - form.near(a * k, 30 + form.f)) for x, k in zip(v, n)]
        size = length(t, form)
        s = ratio.quotient(limit, size) if size > limit else ONE
        return [form.clamp(x - form.near(s * k, 30 + form.f)) for x, k in zip(v, t)]

    def move(self, x, y, r):
        """Moves a particle. Returns its position and the normals it meets."""
        g = [k >> FINE for k in x]
        normals = []
        while True:
            h = [S.clamp(k >> FINE) for k in y]
            if g == h:
                return y, normals
            met = [s for s in self.shapes if s.touches(g, h, r)]
            if not met:
                return y, normals
            d = unit(minus(h, g))
            limit = isqrt(squared(minus(h, g)) - 1) + 1
            ways = [s.cast(g, S.clamp(r + 1), d, limit) for s in met]
            ways = [limit if t is None else t for t in ways]
            t = min(ways)
            c = [S.clamp(p + S.near(t * q, 30 + FRAC)) for p, q in zip(g, d)]
            contact = met[ways.index(t)].contact(c, S.clamp(r + 4))
            if contact is None or len(normals) == 5:
                return x, normals
            n, depth = contact
            normals.append(n)
            z = [REACH.near(p - (q << FINE), PLACE.f) for p, q in zip(y, c)]
            height = REACH.near(dot(n, z), 30 + REACH.f)
            push = max(REACH.clamp((depth - 2) * STEP - height), STEP)
            y = [PLACE.clamp(p + REACH.near(push * q, 30 + REACH.f)) for p, q in zip(y, n)]
            m = [REACH.near(p - q, PLACE.f) for p, q in zip(y, x)]
            m = self.rubbed(m, n, REACH.near(self.rub * push, 30 + REACH.f), REACH)
            y = [PLACE.clamp(p + q) for p, q in zip(x, m)]

    def finish(self, i, y):
        x, before = self.x[i], self.v[i]
        y, normals = self.move(x, y, self.radius[i])
        scale = 30 + SPEED.f

        def pushed(v, n, by):
            return [SPEED.clamp(p + SPEED.near(by * q, scale)) for p, q in zip(v, n)]
        if self.euler:
            v = before
            for n in normals:
                c = SPEED.near(dot(n, v), scale)
                if c < 0:
                    v = self.rubbed(pushed(v, n, -c), n, SPEED.near(-c * self.rub, scale), SPEED)
        else:
            v = [SPEED.near(p - q, PLACE.f) for p, q in zip(y, x)]
        for n in normals:
            c = SPEED.near(dot(n, before), scale)
            if c < -self.fast and self.back > 0:
                w = SPEED.near(-self.back * c, scale)
                a = SPEED.near(dot(n, v), scale)
                if a < w:
                    v = pushed(v, n, w - a)
        self.x[i], self.v[i] = y, v

    def release(self, i):
        r = self.radius[i]
        for _ in range(4):
            g = [k >> FINE for k in self.x[i]]
            contact = next(filter(None, (s.contact(g, r) for s in self.shapes)), None)
            if contact is None:
                return
            n, depth = contact
            q = depth + 1 + (depth >> 27)
            s = [q * k >> 30 if k < 0 else -(-q * k >> 30) for k in n]
            h = [S.clamp(a + b) for a, b in zip(g, s)]
            if any(s.touches(g, h, r) and not s.touches(g, g, r) for s in self.shapes):
                return
            self.x[i] = [k << FINE for k in h]

    def step(self):
        free = [i for i in range(len(self.x)) if not self.held(i)]
        for i in free:
            self.release(i)
        for _ in range(self.substeps):
            for i in free:
                self.v[i] = [SPEED.near(SPEED.clamp(v + g) * self.kept, 30 + SPEED.f)
                             for v, g in zip(self.v[i], self.g)]
            y = [[PLACE.clamp(p + q) for p, q in zip(x, v)] for x, v in zip(self.x, self.v)]
            for _ in range(self.passes):
                for (a, b), (rest, frequency, tether) in sorted(self.ties.items()):
                    self.project(y, a, b, rest, frequency, tether)
            for i in range(len(self.x)):
                if self.held(i):
                    self.x[i] = y[i]
                else:
                    self.finish(i, y[i])
        for i in range(len(self.x)):
            if self.held(i):
                self.v[i] = [0] * self.n

    def state(self):
        for i, (x, v) in enumerate(zip(self.x, self.v)):
            yield "particle %d %s" % (i, " ".join(map(str, x + v)))


class Reader:
    """Reads the lines of one scene."""

    def __init__(self, n):
        self.n, self.system, self.events = n, System(n), {}

    def vector(self, words):
        return [parse(words.pop(0), FRAC) for _ in range(self.n)]

    def options(self, words):
        o = {"mass": 1 << FRAC, "radius": parse("0.05", FRAC), "velocity": [0] * self.n,
             "stretch": 0, "shear": 0, "bend": -1 << FRAC, "tethers": False, "pin": None}
        while words:
            key = words.pop(0)
            if key == "velocity":
                o[key] = self.vector(words)
            elif key == "tethers":
                o[key] = True
            elif key == "pin":
                o[key] = int(words.pop(0))
            else:
                o[key] = parse(words.pop(0), FRAC)
        return o

    def line(self, words):
        key = words.pop(0)
        s = self.system
        if key == "set":
            name = words.pop(0)
            if name == "integrator":
                s.euler = words == ["euler"]
            elif name == "substeps":
                s.substeps = int(words[0])
            else:
                setattr(s, name, parse(words[0], FRAC))
            return
        s.start()
        if key == "at":
            self.events.setdefault(int(words.pop(0)), []).append(words)
        elif key == "ball":
            axes = [[ONE if i == k else 0 for k in range(self.n)] for i in range(self.n)]
            center = self.vector(words)
            s.shapes.append(Shape(center, [0] * self.n, parse(words.pop(0), FRAC), axes))
        elif key == "box":
            center, half = self.vector(words), self.vector(words)
            c, d = int(words[1]), int(words[2])
            axes = [[c, d], [-d, c]] if self.n == 2 else [[c, d, 0], [-d, c, 0], [0, 0, ONE]]
            s.shapes.append(Shape(center, half, 0, axes))
        elif key in ("mesh", "field"):
            self.surface(key == "mesh", words)
        elif key == "tie":
            s.tie(int(words[0]), int(words[1]), parse(words[2], FRAC), 0)
        elif key == "particle":
            position = self.vector(words)
            o = self.options(words)
            s.add(position, o["mass"], o["radius"], o["velocity"], False)
        elif key == "rope":
            self.rope(words)
        else:
            self.cloth(words)

    def surface(self, is_mesh, words):
        """The triangles of a body that is a mesh or a height field, in the world."""
        place = self.vector(words)
        A = [[ONE, 0, 0], [0, ONE, 0], [0, 0, ONE]]
        if is_mesh:
            words.pop(0)
            c, d = int(words.pop(0)), int(words.pop(0))
            A = axes(unit(from_rotation([[c, d, 0], [-d, c, 0], [0, 0, ONE]])))
        x, z, cell = (parse(words.pop(0), FRAC) for _ in range(3))
        columns, rows = int(words.pop(0)), int(words.pop(0))
        heights = [parse(w, FRAC) for w in words]

        def corner(i, j):
            p = [x + i * cell, heights[j * columns + i], z + j * cell]
            return [S.near((place[k] << 30) + sum(a[k] * q for a, q in zip(A, p)), 30 + FRAC)
                    for k in range(3)]
        for j in range(rows - 1):
            for i in range(columns - 1):
                for face in (((i, j), (i, j + 1), (i + 1, j)),
                             ((i + 1, j), (i, j + 1), (i + 1, j + 1))):
                    self.system.shapes.append(Face([corner(*at) for at in face]))

    def rope(self, words):
        s, first = self.system, len(self.system.x)
        a, b = self.vector(words), self.vector(words)
        count = int(words.pop(0))
        o = self.options(words)
        whole = isqrt(squared(minus(b, a)))
        for i in range(count):
            at = [p + S.quotient((q - p) * i, count - 1, FRAC) for p, q in zip(a, b)]
            s.add(at, o["mass"], o["radius"], o["velocity"], o["pin"] == i)
        for i in range(1, count):
            s.tie(first + i - 1, first + i, S.quotient(whole, count - 1, FRAC), o["stretch"])
            if i > 1:
                s.tie(first + i - 2, first + i, S.quotient(2 * whole, count - 1, FRAC), o["bend"])
            if o["tethers"]:
                s.tie(first, first + i, S.quotient(i * whole, count - 1, FRAC), 0, True)

    def cloth(self, words):
        s, first = self.system, len(self.system.x)
        corner, right, down = (self.vector(words) for _ in range(3))
        columns, rows = int(words.pop(0)), int(words.pop(0))
        o = self.options(words)
        for y in range(rows):
            for x in range(columns):
                at = [c + r * x + d * y for c, r, d in zip(corner, right, down)]
                s.add(at, o["mass"], o["radius"], o["velocity"], False)
        for y in range(rows):
            for x in range(columns):
                for dx, dy, kind in ((1, 0, "stretch"), (0, 1, "stretch"), (1, 1, "shear"),
                                     (-1, 1, "shear"), (2, 0, "bend"), (0, 2, "bend")):
                    if 0 <= x + dx < columns and y + dy < rows:
                        rest = isqrt(squared([r * dx + d * dy for r, d in zip(right, down)]))
                        at = first + y * columns + x
                        s.tie(at, at + dy * columns + dx, rest, o[kind])

    def act(self, words):
        s = self.system
        what, words = words[0], words[1:]
        if what == "move":
            i = int(words.pop(0))
            to = self.vector(words)
            s.v[i] = [SPEED.quotient((t << FINE) - x, s.substeps, PLACE.f)
                      for t, x in zip(to, s.x[i])]
        elif what == "shift":
            shape = s.shapes[int(words.pop(0))]
            shape.center = [a + b for a, b in zip(shape.center, self.vector(words))]
        elif what == "cut":
            del s.ties[int(words[0]), int(words[1])]
        else:
            i = int(words[0])
            s.pinned[i] = words[1] == "1"
            s.v[i] = [0] * s.n

    def step(self, tick):
        for words in self.events.get(tick, []):
            self.act(list(words))
        self.system.step()


def read(path):
    """Reads every scene: its name, its ticks, and the reader of its lines."""
    scenes = []
    with open(path) as file:
        for line in file:
            words = line.split("#")[0].split()
            if words and words[0] == "scene":
                scenes.append((words[1], int(words[3]), Reader(int(words[2]))))
            elif words:
                scenes[-1][2].line(words)
    return scenes


def states(reader, ticks):
    for tick in range(ticks + 1):
        if tick:
            reader.step(tick)
        yield list(reader.system.state())


def difference(twin, code):
    first = next(((a, b) for a, b in zip(twin, code) if a != b), (len(twin), len(code)))
    return ":\n  twin %s\n  code %s" % first


def main(arguments):
    if not arguments:
        print(__doc__, file=sys.stderr)
        return 2
    path = os.path.join(os.path.dirname(os.path.abspath(__file__)), "particles.txt")
    failed = False
    for name, ticks, reader in read(path):
        if arguments[1:] and name not in arguments[1:]:
            continue
        failed |= fails(name, ticks, lambda: follow(
            name, [arguments[0], path, name], states(reader, ticks), difference))
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
