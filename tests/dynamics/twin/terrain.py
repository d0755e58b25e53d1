# SPDX-License-Identifier: MIT
"""docs/contacts_of_bodies.md, "Meshes and height fields": lengths in steps of a lever."""
import hull
from fixed import ONE, cross, dot, ratio, unit
from hull import GAP, Hull, closest, clip, clipped, hull_round, hulls, on_face, over
from manifold import LEVER, NOTHING, TOLERANCE, combine, minus, placed

PARTS = 1 << 20


class Surface:
    """A shape of triangles: (index, corners in steps of the scalar)."""
    is_box = is_empty = False

    def __init__(self, triangles, is_solid):
        self.kind, self.radius_raw, self.is_solid = "surface", 0, is_solid
        self.reach = [max(abs(p[k]) for _, corners in triangles for p in corners) for k in range(3)]
        self.facets = []
        for index, corners in sorted(triangles):
            a, b, c = corners
            if index < PARTS and any(cross(minus(b, a), minus(c, a))):
                self.facets.append(Facet(index, corners))


class Facet:
    def __init__(self, index, corners):
        self.index, self.corners = index, corners
        self.box = [(min(p[k] for p in corners), max(p[k] for p in corners)) for k in range(3)]
        a, b, c = corners
        n = self.normal = unit(cross(minus(b, a), minus(c, a)))
        self.points = [[LEVER.clamp(64 * x) for x in p] for p in corners]
        ways = [minus(corners[(k + 1) % 3], corners[k]) for k in range(3)]
        sides = [unit(cross(e, n)) for e in ways]
        top = (n, [0, 1, 2], sides)
        self.hull = Hull(self.points, [top],
                         [(unit(e), k, (k + 1) % 3, 0, k + 1) for k, e in enumerate(ways)])
        self.hull.rim = [top] + [(s,) for s in sides]

    def height(self, p):
        return self.hull.height(self.hull.faces[0], p)

    def beyond(self, p):
        return [self.hull.beyond(self.hull.faces[0], k, p) for k in range(3)]

    def crossed_by(self, a, b):
        h, g = self.height(a), self.height(b)
        if min(h, g) > 0 or max(h, g) < 0:
            return False
        if h == 0 and g == 0:
            return max(self.beyond(a)) <= 0 or max(self.beyond(b)) <= 0
        return all(x * abs(g) + y * abs(h) <= 0 for x, y in zip(self.beyond(a), self.beyond(b)))

    def touch(self, shape, r, t, margin, on_top):
        """The triangle's manifold with a shape."""
        own, face = self.hull, self.hull.faces[0]
        if shape.kind == "hull" or shape.is_box:
            other = shape.hull if shape.kind == "hull" else hull.box_hull(shape.center, shape.half)
            if not on_top:
                return hulls(own, other, r, t, margin)
            points = [placed(t, p, r) for p in other.points]
            normals = [[ratio.near(x, 60) for x in combine(f[0], r)] for f in other.faces]
            return clipped(own, 0, other, points, normals, 0, margin)
        ends, radius = [placed(t, p, r) for p in shape.ends], shape.radius
        if ends[0] == ends[-1]:
            p, Z = ends[0], self.height(ends[0])
            z = GAP.near(Z, 30)
            if GAP.clamp(z - radius) > margin:
                return NOTHING
            if max(self.beyond(p)) <= TOLERANCE << 30:
                return self.normal, [(over(p, self.normal, z, radius), GAP.clamp(z - radius), 0)]
            if on_top or Z < 0:
                return NOTHING
            return closest(own, face, [p], radius, margin)[1]
        if on_top:
            z = GAP.near(min(map(self.height, ends)), 30)
            if GAP.clamp(z - radius) > margin:
                return NOTHING
            return on_face(own, face, clip(own, face, [(ends[0], 0), (ends[1], 1)]), radius, 64, margin)
        return hull_round(own, ends, radius, margin, self.crossed_by(*ends))

    def higher(self, other, n):
        """Whether the other triangle rises along n from the highest corners of this one."""
        heights = [dot(n, minus(p, self.points[0])) for p in self.points]
        top = max(heights)
        if any(top - h <= 16 << 30 and c not in other.corners for h, c in zip(heights, self.corners)):
            return False
        return any(dot(n, minus(p, self.points[0])) > top for p in other.points)


class Touch:
    """A nearby triangle and its contact."""

    def __init__(self, facet, found):
        self.facet, (self.n, self.points) = facet, found
        self.is_right = self.is_taken = False


def contacts(f, surface, shape, r, t, margin_raw, margin):
    """The nearby triangles, in order, and those with contacts among them."""
    box = []
    for k in range(3):
        e = f.bound.near(shape.radius_raw + 2 * margin_raw, f.F)
        for axis, h in zip(r, shape.reach):
            e = f.bound.near((e << 30 - 12) + abs(axis[k]) * h, f.F + 30)
        x = f.place.clamp(t[k] << 6)
        box.append((f.scalar.clamp(f.bound.clamp(x - e) >> 12),
                    f.scalar.clamp(-(-f.bound.clamp(x + e) >> 12))))
    if shape.is_empty:
        return []
    found, seen = [], set()
    for facet in surface.facets:
        if any(p[0] > q[1] or q[0] > p[1] for p, q in zip(facet.box, box)):
            continue
        if (not surface.is_solid and facet.height(t) < 0) or facet.index in seen:
            continue
        seen.add(facet.index)
        found.append(Touch(facet, facet.touch(shape, r, t, margin, False)))

    def risers(c):
        return [o for o in found if o is not c and c.facet.higher(o.facet, c.n)]
    for c in found:
        if c.points:
            c.is_right = c.n == c.facet.normal or (
                dot(c.n, c.facet.normal) >= -(1 << 50) and not risers(c))
    for c in found:
        if c.points and not c.is_right:
            c.n, c.points = NOTHING if any(o.is_right for o in risers(c)) else \
                c.facet.touch(shape, r, t, margin, True)
    for i, c in enumerate(found):
        if any(same(o, c) for o in found[:i]):
            c.points = []
    return found


def same(a, b):
    return len(a.points) == len(b.points) == 1 and all(
        abs(x - y) <= TOLERANCE for x, y in zip(a.points[0][0], b.points[0][0])) and all(
            abs(x - y) <= ONE >> 6 for x, y in zip(a.n, b.n))


def last_of(found, c, old):
    """The contact of the last tick that this one continues; `old` has those of both bodies, by
    part."""
    if c.facet.index in old:
        return old[c.facet.index]
    for part in sorted(old):
        for o in found:
            if o.facet.index == part and not o.points and not o.is_taken and o.facet.normal == c.n:
                o.is_taken = True
                return old[part]
    return None
