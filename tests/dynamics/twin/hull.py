# SPDX-License-Identifier: MIT
"""docs/contacts_of_bodies.md, "Hulls": lengths are integers in steps of a lever."""
from functools import cmp_to_key
from itertools import combinations

from fixed import ONE, cross, dot, ratio, round_div, squared, unit
from manifold import LEVER, TOLERANCE, NOTHING, balls, combine, distance, feet, foot, kept, minus, \
    placed, rounded, to_foot


class Hull:
    """Corners; faces as (normal, corners, sides); edges as (direction, from, to, left, right)."""

    def __init__(self, points, faces, edges):
        self.points, self.faces, self.edges = points, faces, edges
        self.rim = faces  # the faces next to edges

    def height(self, face, p):
        return dot(face[0], minus(p, self.points[face[1][0]]))

    def beyond(self, face, i, p):
        return dot(face[2][i], minus(p, self.points[face[1][i]]))

    def covers(self, face, p):
        return all(self.beyond(face, i, p) <= 0 for i in range(len(face[1])))


# Faces

def planes(points):
    """The point sets in the planes (lines in 2D) that bound the hull, with the outward normals."""
    n = len(points[0])
    found = {}
    for some in combinations(range(len(points)), n):
        o = points[some[0]]
        if n == 2:
            d = minus(points[some[1]], o)
            normal = [d[1], -d[0]]
        else:
            normal = cross(minus(points[some[1]], o), minus(points[some[2]], o))
        if not any(normal):
            continue
        heights = [dot(normal, minus(p, o)) for p in points]
        if min(heights) < 0 < max(heights):
            continue
        if max(heights) > 0:
            normal = [-x for x in normal]
        found[tuple(i for i, h in enumerate(heights) if h == 0)] = normal
    return found


def ends(points, line):
    """The outermost two points on a line."""
    return max(combinations(line, 2), key=lambda e: squared(minus(points[e[0]], points[e[1]])))


def around(points, members, normal):
    """The corners of a 3D face, counter-clockwise."""
    drop = max(range(3), key=lambda i: abs(normal[i]))
    u, v = [(drop + 1) % 3, (drop + 2) % 3][::1 if normal[drop] > 0 else -1]
    flat = {i: (points[i][u], points[i][v]) for i in members}
    start = min(members, key=lambda i: flat[i])
    others = [i for i in members if i != start]

    def turn(i, j):
        a, b = minus(flat[i], flat[start]), minus(flat[j], flat[start])
        c = a[0] * b[1] - a[1] * b[0]
        return -c if c else squared(a) - squared(b)
    loop = [start]
    for i in sorted(others, key=cmp_to_key(turn)) + [start]:
        while len(loop) > 1:
            a, b = minus(flat[loop[-1]], flat[loop[-2]]), minus(flat[i], flat[loop[-1]])
            if a[0] * b[1] - a[1] * b[0] > 0:
                break
            loop.pop()
        loop.append(i)
    return loop[:-1]


def hull_of(raw, center):
    """The hull of points on the scalar's grid around a center of mass, in levers."""
    raw = [p for i, p in enumerate(raw) if p not in raw[:i]]
    n = len(raw[0])
    loops = []
    for members, normal in planes(raw).items():
        if n == 2:
            j, k = ends(raw, members)
            d = minus(raw[k], raw[j])
            loop = [j, k] if [d[1] * normal[0] > 0 or -d[0] * normal[1] > 0][0] else [k, j]
        else:
            loop = around(raw, members, normal)
            first = min(range(len(loop)), key=lambda i: (loop[i], loop[(i + 1) % len(loop)]))
            loop = loop[first:] + loop[:first]
        loops.append((loop, normal))
    loops.sort(key=lambda face: face[0][:2])
    number = {i: c for c, i in enumerate(sorted({i for loop, _ in loops for i in loop}))}
    points = [rounded(minus([64 * x for x in raw[i]], center), 0) for i in number]
    faces, left = [], {}
    for loop, normal in loops:
        corners = [number[i] for i in loop]
        if n == 2:
            u = unit(minus(raw[loop[1]], raw[loop[0]]))
            faces.append(([u[1], -u[0]], corners, [[-x for x in u], u]))
            continue
        normal = unit(normal)
        sides = []
        for i, j in zip(loop, loop[1:] + loop[:1]):
            sides.append(unit(cross(minus(raw[j], raw[i]), normal)))
            left[i, j] = len(faces)
        faces.append((normal, corners, sides))
    edges = [(unit(minus(raw[k], raw[j])), number[j], number[k], left[j, k], left[k, j])
             for j, k in sorted(left) if j < k]
    return Hull(points, faces, edges)


def box_hull(c, h):
    """A box with its body's axes."""
    n = len(h)

    def u(i, sign):
        return [sign * ONE if k == i else 0 for k in range(n)]

    def corner(signs):
        return sum(1 << i for i, s in enumerate(signs) if s < 0)

    def signs(*pairs):
        s = [1] * n
        for i, x in pairs:
            s[i] = x
        return corner(s)
    points = [[LEVER.clamp(c[i] + (-h[i] if q >> i & 1 else h[i])) for i in range(n)]
              for q in range(1 << n)]
    faces, edges = [], []
    for i in range(n):
        j, k = (i + 1) % n, (i + 2) % n
        for s in (1, -1):
            if n == 2:
                faces.append((u(i, s), [signs((i, s), (j, 1)), signs((i, s), (j, -1))],
                              [u(j, 1), u(j, -1)]))
                continue
            around_it = ((1, 1), (-1, 1), (-1, -1), (1, -1)) if s > 0 else \
                ((1, 1), (1, -1), (-1, -1), (-1, 1))
            sides = [u(k, 1), u(j, -1), u(k, -1), u(j, 1)] if s > 0 else \
                [u(j, 1), u(k, -1), u(j, -1), u(k, 1)]
            faces.append((u(i, s), [signs((i, s), (j, x), (k, y)) for x, y in around_it], sides))
        if n == 3:
            for x, y in ((1, 1), (1, -1), (-1, 1), (-1, -1)):
                along_j, along_k = 2 * j + (x < 0), 2 * k + (y < 0)
                edges.append((u(i, 1), signs((i, -1), (j, x), (k, y)), signs((i, 1), (j, x), (k, y)),
                              *((along_j, along_k) if x == y else (along_k, along_j))))
    return Hull(points, faces, edges)


# Two hulls

GAP = LEVER


def sign(x):
    return (x > 0) - (x < 0)


def across_edges(e, f, outward):
    c = ratio.near(dot(e, f), 60)
    if c * c > (1 << 60) - (1 << 48):
        return None
    n = unit(cross(e, f))
    return [-x for x in n] if dot(n, outward) < 0 else n


def plus(a, b):
    return [x + y for x, y in zip(a, b)]


def best_face(hull, points):
    """The greatest separation over the faces, and that face's index."""
    return max(((min(hull.height(f, p) for p in points), i) for i, f in enumerate(hull.faces)),
               key=lambda x: (x[0], -x[1]))


def hulls(a, b, r, t, margin):
    n = len(t)
    in_a = [placed(t, p, r) for p in b.points]
    in_b = [[LEVER.near(dot(v, minus(p, t)), 30) for v in r] for p in a.points]
    A, of_a = best_face(a, in_a)
    B, of_b = best_face(b, in_b)
    if max(A, B) > margin << 30:
        return NOTHING
    of = B > A + (TOLERANCE << 30)
    S = GAP.near(B if of else A, 30)

    def out(v):
        return [ratio.near(x, 60) for x in combine(v, r)]
    if n == 3:
        normals = [out(f[0]) for f in b.faces]
        others = [(out(e[0]), e) for e in b.edges]
        best = None
        for i, (e, p, p2, left, right) in enumerate(a.edges):
            l, m = a.rim[left][0], a.rim[right][0]
            side = [sign(dot(e, x)) for x in normals]
            for j, (f, other) in enumerate(others):
                x = side[other[3]]
                if x == 0 or side[other[4]] != -x or sign(dot(l, f)) != x or sign(dot(m, f)) != -x:
                    continue
                normal = across_edges(e, f, plus(l, m))
                if normal is None:
                    continue
                s = GAP.near(dot(normal, minus(in_a[other[1]], a.points[p])), 30)
                if best is None or s > best[0]:
                    best = s, i, j, normal
        if best is not None and best[0] > margin:
            return NOTHING
        if best is not None and best[0] > GAP.clamp(S + TOLERANCE):
            s, i, j, normal = best
            p, _ = feet([a.points[k] for k in a.edges[i][1:3]], [in_a[k] for k in b.edges[j][1:3]])
            point = [LEVER.near((x << 23) + y * s, 31) for x, y in zip(p, normal)]
            return normal, [(point, s, (1 << 30) + 128 * i + j)]
    if not of:
        return clipped(a, of_a, b, in_a, [out(f[0]) for f in b.faces], 0, margin)
    turned = [[ratio.near(dot(f[0], v), 60) for v in r] for f in a.faces]
    normal, points = clipped(b, of_b, a, in_b, turned, 1, margin)
    if not points:
        return NOTHING
    return [-x for x in out(normal)], [(placed(t, p, r), s, f) for p, s, f in points]


def clipped(own, reference, other, points, normals, R, margin):
    face = own.faces[reference]
    incident = min(range(len(normals)), key=lambda i: dot(normals[i], face[0]))
    polygon = [(points[c], i) for i, c in enumerate(other.faces[incident][1])]
    polygon = clip(own, face, polygon)
    if len(face[0]) == 3:
        polygon = [(p, 64 * polygon[i - 1][1] + line) for i, (p, line) in enumerate(polygon)]
    return on_face(own, face, polygon, 0, ((R * 64 + reference) * 64 + incident) << 12, margin)


def clip(own, face, polygon):
    is_segment = len(polygon) == 2
    for i in range(len(face[1])):
        rooms = [GAP.near((TOLERANCE << 30) - own.beyond(face, i, p), 30) for p, _ in polygon]

        def between(k, l):
            (p, _), (q, _) = polygon[k], polygon[l]
            u, v = rooms[k], rooms[l]
            return [LEVER.clamp(x + LEVER.clamp(round_div((y - x) * u, u - v))) for x, y in zip(p, q)]
        result = []
        for k, (p, line) in enumerate(polygon):
            l = (k + 1) % len(polygon)
            u, v = rooms[k], rooms[l]
            if is_segment:
                if u >= 0:
                    result.append((p, line))
                elif v > 0:
                    result.append((between(l, k), 32 + i))
                continue
            if u >= 0:
                result.append((p, 32 + i if u == 0 and v < 0 else line))
            if u > 0 > v:
                result.append((between(k, l), 32 + i))
            elif u < 0 < v:
                result.append((between(l, k), line))
        polygon = result[:64]
    return polygon


def on_face(own, face, polygon, r, kind, margin):
    n = face[0]
    points = []
    for p, name in polygon:
        z = GAP.near(own.height(face, p), 30)
        s = GAP.clamp(z - r)
        if s <= margin:
            points.append((p, z, s, name))
    if len(points) > 4:
        deepest = min(range(len(points)), key=lambda i: points[i][1])
        ways = [minus(p[0], points[deepest][0]) for p in points]
        farthest = max(range(len(points)), key=lambda i: squared(ways[i]))
        areas = [dot(n, cross(ways[farthest], w)) for w in ways]
        keep = {deepest, farthest}
        keep |= {i for i in (max(range(len(areas)), key=lambda i: areas[i]),) if areas[i] > 0}
        keep |= {i for i in (min(range(len(areas)), key=lambda i: areas[i]),) if areas[i] < 0}
        points = [p for i, p in enumerate(points) if i in keep]
    return n, [(over(p, n, z, r), s, kind + name) for p, z, s, name in points]


def over(p, n, z, r):
    """p - n (z + r) / 2, rounded to levers."""
    return [LEVER.near((x << 31) - y * (z + r), 31) for x, y in zip(p, n)]


# A hull and a ball or capsule

def closest(hull, F, ends, r, margin):
    """The least distance and its manifold."""
    best = None
    for p in ends:
        for face in hull.faces:
            z = hull.height(face, p)
            if z > 0 and hull.covers(face, p):
                z = GAP.near(z, 30)
                if best is None or z < best[0]:
                    best = z, face, p, None
    if len(ends[0]) == 3:
        lines = [[hull.points[e[1]], hull.points[e[2]]] for e in hull.edges]
        if len(ends) == 1:
            q = to_foot(ends[0])
            pairs = [(foot(q, *line), q) for line in lines]
        else:
            pairs = [feet(line, ends) for line in lines]
    else:
        pairs = [(to_foot(p), foot(to_foot(p), *ends) if len(ends) == 2 else to_foot(ends[0]))
                 for p in hull.points]
    for p, q in pairs:
        D = distance(p, q)
        if best is None or D < best[0]:
            best = D, None, p, q
    D, face, p, q = best
    if face is not None:
        return D, (face[0], kept([(over(p, face[0], D, r), GAP.clamp(D - r), 0)], margin))
    n, points = balls(p, 0, q, r, margin)
    return D, (n if D > 0 else F[0], points)


def hull_round(hull, ends, r, margin, meets=None):
    n = len(ends[0])
    if len(ends) == 2 and ends[0] == ends[1]:
        ends = ends[:1]
    Z, number = best_face(hull, ends)
    F, z = hull.faces[number], GAP.near(Z, 30)
    if GAP.clamp(z - r) > margin:
        return NOTHING
    if len(ends) == 1:
        if Z <= 0:
            return F[0], kept([(over(ends[0], F[0], z, r), GAP.clamp(z - r), 0)], margin)
        return closest(hull, F, ends, r, margin)[1]
    a, a2 = ends

    def on_F():
        return on_face(hull, F, clip(hull, F, [(a, 0), (a2, 1)]), r, 64 * (number + 1), margin)
    u = unit(minus(a2, a))
    best = None
    if n == 3:
        for i, (e, p, _, left, right) in enumerate(hull.edges):
            l, m = hull.rim[left][0], hull.rim[right][0]
            if sign(dot(u, l)) * sign(dot(u, m)) >= 0:
                continue
            normal = across_edges(e, u, plus(l, m))
            if normal is None:
                continue
            E = GAP.near(dot(normal, minus(a, hull.points[p])), 30)
            if best is None or E > best[0]:
                best = E, normal, i
    else:
        for s in (1, -1):
            normal = [s * u[1], -s * u[0]]
            heights = [dot(normal, minus(a, p)) for p in hull.points]
            E = GAP.near(min(heights), 30)
            if best is None or E > best[0]:
                best = E, normal, heights.index(min(heights))
    if meets is None:
        meets = Z <= 0 and (best is None or best[0] <= 0)
    if meets:
        if best is None or best[0] <= z + TOLERANCE:
            return on_F()
        E, normal, i = best
        if n == 3:
            _, q = feet([hull.points[k] for k in hull.edges[i][1:3]], ends)
        else:
            q = foot(to_foot(hull.points[i]), a, a2)
        point = [LEVER.near((x << 23) - y * (E + r), 31) for x, y in zip(q, normal)]
        return normal, kept([(point, GAP.clamp(E - r), (1 << 30) + i)], margin)
    D, single = closest(hull, F, ends, r, margin)
    if not single[1] or D > z + TOLERANCE:
        return single
    both = on_F()
    return both if both[1] else single


def manifold(a, b, r, t, margin):
    """The manifold of two shapes of which at least one is a hull."""
    n = len(t)

    def faces(s):
        return s.hull if s.kind == "hull" else box_hull(s.center, s.half)
    if not a.is_box and a.kind != "hull":
        ends = [[LEVER.near(dot(r[j], minus(q, t)), 30) for j in range(n)] for q in a.ends]
        normal, points = hull_round(faces(b), ends, a.radius, margin)
        if not points:
            return NOTHING
        return ([ratio.near(-x, 60) for x in combine(normal, r)],
                [(placed(t, p, r), s, f) for p, s, f in points])
    if not b.is_box and b.kind != "hull":
        return hull_round(faces(a), [placed(t, p, r) for p in b.ends], b.radius, margin)
    return hulls(faces(a), faces(b), r, t, margin)
